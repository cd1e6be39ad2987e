/*
 * account.h - what a run cost: messages and bytes, memory, seconds; and the
 * same steps by common/plane/step.c on one thread, to compare with.
 */
#ifndef MANY_ACCOUNT_H
#define MANY_ACCOUNT_H

#include "piece.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <petscsnes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* Of all processes together, but for the seconds.  PETSc counts messages, and
 * its own floating-point operations: those of our loop over the elements are
 * not in it, and they grow exactly like the triangles. */
struct account {
    double messages, bytes;             /* sent */
    double flops;
    double memory;                      /* resident (bytes) */
    double cpu, seconds;                /* of the processors; on the wall */
};

static inline PetscErrorCode account_now(struct account *now)
{
    PetscLogDouble memory, flops;
    PetscCall(PetscMemoryGetCurrentUsage(&memory));
    PetscCall(PetscGetFlops(&flops));
    double mine[] = {petsc_isend_ct + petsc_send_ct,
                     petsc_isend_len + petsc_send_len, flops, memory,
                     (double)clock() / CLOCKS_PER_SEC};
    double all[5];
    if (MPI_Allreduce(mine, all, 5, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD))
        die("MPI: no sum over the processes");
    *now = (struct account){all[0], all[1], all[2], all[3], all[4],
                            MPI_Wtime()};
    return 0;
}

/* What the steps took; the first sets up and is not in the account. */
struct tally {
    const char *method;
    int steps, systems, most; /* linear systems in all; in one step */
    int iterations;           /* of conjugate gradients */
    int first_systems, first_iterations; /* of them in the first step */
    double error;   /* largest difference from step.c (m), NAN: not known */
    double seconds[2]; /* of step.c per step, from the second on: with the
                          factors of dissection, of a band */
};

/* The same steps by step.c, on process 0, with either storage of K. */
static inline PetscErrorCode account_compare(const struct scene_setting *set,
                                             int steps, DM grid, Vec U,
                                             struct tally *tally)
{
    const struct step_control control = {
        .tolerance = 1e-10, .max_iterations = 40, .guess = EXTRAPOLATED,
        .lift = 1, .chord = 1};
    Vec natural, whole;
    VecScatter to_zero;
    PetscInt n;
    const double *u;
    PetscCall(DMDACreateNaturalVector(grid, &natural));
    PetscCall(DMDAGlobalToNaturalBegin(grid, U, INSERT_VALUES, natural));
    PetscCall(DMDAGlobalToNaturalEnd(grid, U, INSERT_VALUES, natural));
    PetscCall(VecScatterCreateToZero(natural, &to_zero, &whole));
    PetscCall(VecScatterBegin(to_zero, natural, whole, INSERT_VALUES,
                              SCATTER_FORWARD));
    PetscCall(VecScatterEnd(to_zero, natural, whole, INSERT_VALUES,
                            SCATTER_FORWARD));
    PetscCall(VecGetLocalSize(whole, &n));
    PetscCall(VecGetArrayRead(whole, &u));
    tally->error = 0.0;
    for (int s = 0; s < 2; s++) {
        if (n <= 0) break; /* another process has them */
        struct scene *scene = scene_alloc(set);
        double start = 0.0;
        body_store(scene->body, s == 0 ? SPARSE : BANDED);
        for (int k = 0; k < steps; k++) {
            if (k == 1) start = MPI_Wtime();
            if (scene_step(scene, &control).status != OK)
                die("step.c does not solve step %d", k + 1);
        }
        tally->seconds[s] = (MPI_Wtime() - start) / (steps - 1);
        for (int r = 0; r < n; r++)
            if (!(fabs(scene->u[r] - u[r]) <= tally->error))
                tally->error = fabs(scene->u[r] - u[r]); /* a NaN as well */
        scene_free(scene);
    }
    PetscCall(VecRestoreArrayRead(whole, &u));
    PetscCall(VecScatterDestroy(&to_zero));
    PetscCall(VecDestroy(&whole));
    return VecDestroy(&natural);
}

/*
 * On paper [README.md]: messages and bytes of all processes for these many
 * iterations of conjugate gradients with a V-cycle each, and residuals.
 *
 * An exchange is one message to each neighbour, and along a common side two
 * numbers per vertex.  An iteration has one for K p; on every level but the
 * coarsest two (residual, second sweep) and two that go one way only
 * (restriction, interpolation), with half as many vertices.  The coarsest
 * right-hand side goes from everyone to everyone.
 */
static inline struct account account_predict(const struct piece *p,
                                             double iterations,
                                             double residuals)
{
    const double n = p->set.n, processes = p->wide * p->high;
    const double sides = (p->wide - 1) * (n + 1) + (p->high - 1) * (n + 1);
    const double pairs = (p->wide - 1) * p->high + p->wide * (p->high - 1) +
                         2 * (p->wide - 1) * (p->high - 1);
    const double coarse = pow(n / pow(2, p->levels - 1) + 1, 2);
    double exchanges = 1, length = 1; /* of the finest, in an iteration */
    for (int l = 1; l < p->levels; l++) {
        exchanges += 2 + 2 * 0.5;
        length += (2 + 2 * 0.5 * 0.5) * pow(0.5, l - 1);
    }
    return (struct account){
        .messages = 2 * pairs * (iterations * exchanges + residuals) +
                    iterations * processes * (processes - 1),
        .bytes = 16 * (2 * sides * (iterations * length + residuals) +
                       iterations * coarse * (processes - 1))};
}

static inline void account_print(const struct tally *t, const struct piece *p,
                                 const struct account *start,
                                 const struct account *first,
                                 const struct account *last)
{
    const int processes = p->wide * p->high, compared = !isnan(t->error);
    const double per = 1.0 / (processes * (t->steps - 1.0));
    const double unknowns = 2.0 * (p->set.n + 1.0) * (p->set.n + 1.0);
    const double memory = (last->memory - start->memory) / unknowns; /* bytes */
    const double wall = last->seconds - first->seconds;
    const double share = (last->cpu - first->cpu) / (processes * wall);
    const int iterations = t->iterations - t->first_iterations;
    const int systems = t->systems - t->first_systems;
    const struct account paper =
        account_predict(p, iterations, systems + t->steps - 1);
    const int predicted = processes > 1 && strcmp(t->method, "geometric") == 0;
    /* for MUMPS, PETSc counts the whole elimination with every solution */
    const int counted = strcmp(t->method, "cholesky") != 0;

    /* flops: per unknown and step, from the second step on */
    table_begin("runs", "n processes method steps systems per_step most "
                        "iterations agrees bytes flops");
    table_row(p->set.n, processes, t->method, t->steps, t->systems,
              (double)t->systems / t->steps, t->most,
              (double)t->iterations / t->systems,
              !compared ? MISSING : t->error <= 1e-12 ? "yes" : "no",
              cell_if(p->set.n >= 256, 10.0 * round(0.1 * memory)),
              cell_if(counted, round((last->flops - first->flops) /
                                     (unknowns * (t->steps - 1.0)))));
    table_end();
    table_begin("messages", "n processes method levels iterations messages "
                            "predicted kilobyte predicted_kilobyte");
    table_row(p->set.n, processes, t->method, p->levels,
              iterations / (t->steps - 1.0),
              (last->messages - first->messages) * per,
              cell_if(predicted, paper.messages * per),
              (last->bytes - first->bytes) * per / 1e3,
              cell_if(predicted, paper.bytes * per / 1e3));
    table_end();
    if (share < 0.95) {
        fprintf(stderr, "The machine was busy, each process had %.0f %% of a "
                "processor: no seconds.\n", 100.0 * share);
    } else {
        table_begin("seconds", "n processes method per_step dissection band");
        table_row(p->set.n, processes, t->method, wall / (t->steps - 1),
                  cell_if(compared, t->seconds[0]),
                  cell_if(compared, t->seconds[1]));
        table_end();
    }
    if (!compared) return;
    fprintf(stderr, "Largest difference from step.c: %.3g m\n", t->error);
    claim(t->error <= 1e-12, "the displacements are not those of step.c");
}

#endif
