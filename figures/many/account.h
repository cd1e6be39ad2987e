/*
 * account.h - what a run cost: messages and bytes, memory, seconds; and the
 * same steps by common/step.c on one thread, to compare with.
 */
#ifndef MANY_ACCOUNT_H
#define MANY_ACCOUNT_H

#include "piece.h"
#include "table.h"

#include <math.h>
#include <petscsnes.h>
#include <time.h>

/* Of all processes together, but for the seconds; PETSc counts messages. */
struct account {
    double messages, bytes, reductions; /* sent; a reduction: by everyone */
    double memory;                      /* resident (bytes) */
    double cpu, seconds;                /* of the processors; on the wall */
};

static inline PetscErrorCode account_now(struct account *now)
{
    PetscLogDouble memory;
    PetscCall(PetscMemoryGetCurrentUsage(&memory));
    double mine[] = {petsc_isend_ct + petsc_send_ct,
                     petsc_isend_len + petsc_send_len,
                     petsc_allreduce_ct, memory,
                     (double)clock() / CLOCKS_PER_SEC};
    double all[5];
    if (MPI_Allreduce(mine, all, 5, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD))
        die("MPI: no sum over the processes");
    *now = (struct account){all[0], all[1], all[2], all[3], all[4],
                            MPI_Wtime()};
    return 0;
}

/* What all steps took. */
struct tally {
    const char *method;
    int steps;
    int systems, most, iterations; /* of Newton; in one step; of CG */
    int compared;
    double error;   /* largest difference from step.c (m) */
    double seconds; /* of step.c per step, from the second on */
};

/* The same steps by step.c, on process 0. */
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
    tally->compared = 1;
    struct scene *scene = n > 0 ? scene_alloc(set) : NULL;
    for (int k = 0; scene && k < steps; k++) {
        if (k == 1) tally->seconds = -MPI_Wtime();
        if (scene_step(scene, &control).status != OK)
            die("step.c does not solve step %d", k + 1);
    }
    tally->seconds = (tally->seconds + MPI_Wtime()) / (steps - 1);
    for (int r = 0; scene && r < n; r++)
        if (!(fabs(scene->u[r] - u[r]) <= tally->error))
            tally->error = fabs(scene->u[r] - u[r]); /* a NaN as well */
    scene_free(scene);
    PetscCall(VecRestoreArrayRead(whole, &u));
    PetscCall(VecScatterDestroy(&to_zero));
    PetscCall(VecDestroy(&whole));
    return VecDestroy(&natural);
}

static inline void account_print(const struct tally *t, const struct piece *p,
                                 const struct account *start,
                                 const struct account *first,
                                 const struct account *last)
{
    int processes, rank;
    MPI_Comm_size(PETSC_COMM_WORLD, &processes);
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    if (rank > 0) return;
    const double all = processes * (t->steps - 1.0);
    const double unknowns = 2.0 * (p->set.n + 1.0) * (p->set.n + 1.0);
    const double wall = last->seconds - first->seconds;
    const double busy = (last->cpu - first->cpu) / (processes * wall);
    table_begin("run", "n processes method steps levels systems most iterations error");
    table_row(p->set.n, processes, t->method, t->steps, p->levels,
              t->systems, t->most, (double)t->iterations / t->systems,
              cell_if(t->compared, t->error));
    table_end();
    table_begin("log", "messages bytes reductions");
    table_row((last->messages - first->messages) / all,
              (last->bytes - first->bytes) / (last->messages - first->messages),
              (last->reductions - first->reductions) / all);
    table_end();
    table_begin("memory", "kilobyte busy seconds serial");
    table_row((last->memory - start->memory) / unknowns / 1e3, busy,
              wall / (t->steps - 1), cell_if(t->compared, t->seconds));
    table_end();
}

#endif
