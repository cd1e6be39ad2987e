/*
 * peer.c - how many times faster than an established package is a step, and
 * how much of that is the method, how much the program?
 *
 * The stretch of figures/speed/step.c on one thread, after the jolt of the
 * start.  PETSc has K (MatSetValuesCOO) and CHOLMOD factors and solves; their
 * element is ours.  `notes` starts from the last u and factors for each system;
 * `method` has all of step.c's strategy, guess, lift and kept factors, and so
 * needs as many systems.  `ours` is step.c with the storage that body_alloc()
 * chooses.
 *
 * They take turns, of ten steps in a row after one that does not count; medians
 * of the processor's seconds, in which no other program's are.  An answer off
 * that of `ours` has no time.
 */
#include "elements.h"

#include "base/clock.h"
#include "../study/study.h"
#include "../speed/one_thread.h"
#include "base/table.h"
#include "plane/scene.h"

#include <limits.h>
#include <math.h>
#include <petscksp.h>

/* The processor that OpenBLAS, if it is the BLAS, takes this one for. */
extern char *openblas_get_corename(void) __attribute__((weak));

enum method { NOTES, METHOD, OURS, METHODS };
static const char *const name[] = {"notes", "method", "ours"};
enum { START = 9, ROUNDS = 2, IN_A_ROW = 10 };

/* What PETSc has of a scene. */
struct peer {
    struct body *body; /* for its element matrices */
    double *value;
    Mat K;
    Vec q, du;
    KSP solver;
    double *w, *next, *pull; /* [n_dof] */
};

static PetscErrorCode peer_make(const struct scene *s, struct peer *p)
{
    const size_t entries = ELEMENT_ENTRIES * (size_t)s->mesh->n_triangle;
    const size_t n = (size_t)s->n_dof;
    const PetscInt free_ones = s->body->K->n;
    PetscInt *row = allocate(entries, sizeof *row);
    PetscInt *column = allocate(entries, sizeof *column);
    PC pc;
    p->body = elements_alloc(s->mesh, s->body->material, s->set.rho,
                             s->set.mass);
    p->value = allocate(entries, sizeof *p->value);
    p->w = allocate(n, sizeof *p->w);
    p->next = allocate(n, sizeof *p->next);
    p->pull = allocate(n, sizeof *p->pull);
    for (size_t k = 0; k < entries; k++) {
        const struct element_entry entry = element_entry(p->body, k);
        row[k] = s->body->equation[entry.row]; /* -1: left out */
        column[k] = s->body->equation[entry.column];
    }
    PetscCall(MatCreate(PETSC_COMM_SELF, &p->K));
    PetscCall(MatSetSizes(p->K, free_ones, free_ones, free_ones, free_ones));
    PetscCall(MatSetType(p->K, MATSEQAIJ));
    PetscCall(MatSetPreallocationCOO(p->K, (PetscCount)entries, row, column));
    PetscCall(MatSetOption(p->K, MAT_SPD, PETSC_TRUE));
    PetscCall(MatCreateVecs(p->K, &p->q, &p->du));
    PetscCall(KSPCreate(PETSC_COMM_SELF, &p->solver));
    PetscCall(KSPSetOperators(p->solver, p->K, p->K));
    PetscCall(KSPSetType(p->solver, KSPPREONLY));
    PetscCall(KSPGetPC(p->solver, &pc));
    PetscCall(PCSetType(pc, PCCHOLESKY));
    PetscCall(PCFactorSetMatSolverType(pc, MATSOLVERCHOLMOD));
    free(row);
    free(column);
    return 0;
}

/* next -= K^-1 q at the free vertices; K as it is, or factored before. */
static PetscErrorCode peer_solve(struct peer *p, const struct scene *s,
                                 int fresh, double *largest)
{
    const int *equation = s->body->equation;
    const PetscScalar *du;
    PetscScalar *q;
    if (fresh) {
        elements_values(p->body, p->value);
        PetscCall(MatSetValuesCOO(p->K, p->value, INSERT_VALUES));
    }
    PetscCall(VecGetArray(p->q, &q));
    for (int r = 0; r < s->n_dof; r++)
        if (equation[r] >= 0) q[equation[r]] = p->pull[r];
    PetscCall(VecRestoreArray(p->q, &q));
    PetscCall(KSPSetReusePreconditioner(p->solver, !fresh));
    PetscCall(KSPSolve(p->solver, p->q, p->du));
    PetscCall(VecGetArrayRead(p->du, &du));
    *largest = 0.0;
    for (int r = 0; r < s->n_dof; r++) {
        if (equation[r] < 0) continue;
        const double size = fabs(du[equation[r]]);
        p->next[r] -= du[equation[r]];
        if (!(size <= *largest)) *largest = size;
    }
    PetscCall(VecRestoreArrayRead(p->du, &du));
    return 0;
}

/* next := where the velocities lead that the body of the scene remembers, as
 * step.c guesses [alg:extrapolated]. */
static void peer_guess(const struct scene *s, const double w[], double next[])
{
    const struct past *past = &s->body->past;
    for (int r = 0; r < s->n_dof; r++) {
        double sum = s->v[r] - s->v_before[r];
        for (int j = 2; j < past->order; j++) sum += past->d[j][r];
        next[r] = w[r] + s->set.dt * sum;
    }
}

/* The step from v has ended with the velocity `end`. */
static void peer_remember(const struct scene *s, const double end[])
{
    struct past *past = &s->body->past;
    double error[PAST_ORDER + 1] = {0.0};
    for (int r = 0; r < s->n_dof; r++) {
        double old = s->v[r] - s->v_before[r], new = end[r] - s->v[r];
        for (int j = 2; j <= PAST_ORDER; j++) {
            new -= old;
            old = past->d[j][r];
            past->d[j][r] = new;
            error[j] += new * new;
        }
    }
    past->order = 2;
    for (int j = 3; j <= PAST_ORDER; j++)
        if (error[j] < 0.25 * error[past->order]) past->order = j;
}

/*
 * The next step, with the method of the notes or that of step.c, whose factors
 * serve later steps where K is sparse [alg:kept]; the stretch does not turn the
 * body.  *systems counts.
 */
static PetscErrorCode peer_step(struct peer *p, struct scene *s, int notes,
                                int *systems)
{
    const double dt = s->set.dt;
    const struct incremental Phi = {dt, p->w, NULL};
    struct kept *kept = &s->body->kept;
    double size = INFINITY, before;
    int fresh = !kept->usable || (kept->systems > KEPT_SYSTEMS &&
                                  kept->systems > kept->least + 1);
    for (int r = 0; r < s->n_dof; r++) {
        p->w[r] = s->u[r] + dt * s->v[r];
        p->next[r] = s->u[r];
    }
    if (!notes) peer_guess(s, p->w, p->next);
    scene_hold(s, ++s->steps * dt);
    step_boundary(s->body, s->g, !notes, p->next);
    for (kept->systems = 0; !(size <= 1e-10); kept->systems++) {
        const enum status status = body_assemble(
            p->body, Phi, p->next, fresh ? EXACT : NO_TANGENT, p->pull);
        if (status != OK || kept->systems == 40) die("PETSc: no answer");
        before = size;
        PetscCall(peer_solve(p, s, fresh, &size));
        if (fresh) kept->least = INT_MAX - 1;
        fresh = notes || size > 0.3 * before;
    }
    *systems += kept->systems;
    kept->usable = !notes && s->body->K->storage == SPARSE;
    if (kept->systems < kept->least) kept->least = kept->systems;
    for (int r = 0; r < s->n_dof; r++) p->w[r] = (p->next[r] - s->u[r]) / dt;
    if (!notes) peer_remember(s, p->w);
    for (int r = 0; r < s->n_dof; r++) {
        s->v_before[r] = s->v[r];
        s->v[r] = p->w[r];
        s->u[r] = p->next[r];
    }
    return 0;
}

static PetscErrorCode peer_end(struct peer *p)
{
    PetscCall(MatDestroy(&p->K));
    PetscCall(VecDestroy(&p->q));
    PetscCall(VecDestroy(&p->du));
    PetscCall(KSPDestroy(&p->solver));
    body_free(p->body);
    free(p->value);
    free(p->w);
    free(p->next);
    free(p->pull);
    return 0;
}

/* Of each method a step: milliseconds, and linear systems in the mean. */
static PetscErrorCode measure(int n, double ms[METHODS],
                              double systems[METHODS])
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct step_control control = step_method("lift");
    struct scene *s[METHODS];
    struct peer peer[OURS] = {{0}};
    struct times t[METHODS] = {{0}};
    int count[METHODS] = {0};
    set.reach = 0.5;
    control.chord = 1;
    for (int k = 0; k < METHODS; k++) {
        s[k] = scene_alloc(&set);
        for (int step = 0; step < START; step++)
            if (scene_step(s[k], &control).status != OK) die("n = %d", n);
        s[k]->body->kept.usable = 0;
        if (k < OURS) PetscCall(peer_make(s[k], &peer[k]));
    }
    for (int turn = 0; turn < (n < 128 ? ROUNDS : 1); turn++)
        for (int k = 0; k < METHODS; k++)
            for (int step = 0; step <= IN_A_ROW; step++) {
                const double before = clock_processor();
                struct step_report report = {.status = OK};
                if (k < OURS)
                    PetscCall(peer_step(&peer[k], s[k], k == NOTES,
                                        &report.iterations));
                else
                    report = scene_step(s[k], &control);
                const double seconds = clock_processor() - before;
                count[k] += report.iterations;
                if (step > 0) times_record(&t[k], seconds, report.status == OK);
            }
    for (int k = 0; k < METHODS; k++) {
        for (int r = 0; r < s[k]->n_dof; r++)
            if (!(fabs(s[k]->u[r] - s[OURS]->u[r]) <= 1e-9))
                t[k].second[0] = NAN;
        ms[k] = 1e3 * times_median(&t[k]);
        systems[k] = (double)count[k] / (s[k]->steps - START);
        if (k < OURS) PetscCall(peer_end(&peer[k]));
    }
    for (int k = 0; k < METHODS; k++) scene_free(s[k]);
    return 0;
}

int main(int argc, char **argv)
{
    PetscFunctionBeginUser;
    PetscCall(PetscInitialize(&argc, &argv, NULL, NULL));
    study_machine();
    table_begin_note("peer", "method n step_ms over_ours systems",
                     "PETSc %d.%d with CHOLMOD on %s%s", PETSC_VERSION_MAJOR,
                     PETSC_VERSION_MINOR,
                     openblas_get_corename ? "OpenBLAS for " : "another BLAS",
                     openblas_get_corename ? openblas_get_corename() : "");
    for (int n = 8; n <= 128; n *= 2) {
        double ms[METHODS], systems[METHODS];
        PetscCall(measure(n, ms, systems));
        for (int k = 0; k < METHODS; k++) {
            claim(ms[k] > 0.0, "%s finds the same u, n = %d", name[k], n);
            table_row(name[k], n, ms[k], ms[k] / ms[OURS], systems[k]);
        }
        claim(fabs(systems[METHOD] - systems[OURS]) < 1e-9,
              "with the same method as many systems, n = %d", n);
    }
    table_end();
    PetscCall(PetscFinalize());
    return table_finish();
}
