/*
 * peer.c - how many times faster than an established package is a step, and
 * how much of that is the method, how much the program?
 *
 * The stretch of figures/speed/step.c on one thread, after the jolt of the
 * start.  PETSc has K (MatSetValuesCOO) and CHOLMOD factors and solves; their
 * element is ours.  `notes` starts from the last u and factors for each system,
 * `method` has the guess, the lift and the kept factors of step.c.  `ours` is
 * step.c with the storage that body_alloc() chooses, `kept` keeps factors
 * across steps, in single precision where they are sparse.
 *
 * They take turns, of ten steps in a row after one that does not count;
 * medians.  An answer off that of `ours` has no time.
 */
#include "elements.h"

#include "base/clock.h"
#include "base/study.h"
#include "base/table.h"
#include "plane/scene.h"

#include <math.h>
#include <petscksp.h>
#include <string.h>

/* The processor that OpenBLAS, if it is the BLAS, takes this one for. */
extern char *openblas_get_corename(void) __attribute__((weak));

enum method { NOTES, METHOD, OURS, KEPT, METHODS };
static const char *const name[] = {"notes", "method", "ours", "kept"};
enum { START = 9, ROUNDS = 2, IN_A_ROW = 10 };

/* What PETSc has of a scene. */
struct peer {
    struct body *body; /* for its element matrices */
    double *value;
    Mat K;
    Vec q, du;
    KSP solver;
    double *w, *next, *pull; /* [n_dof] */
    int systems;
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

/* The next step, with the method of the notes or that of step.c. */
static PetscErrorCode peer_step(struct peer *p, struct scene *s, int notes)
{
    const double dt = s->set.dt;
    const struct incremental Phi = {dt, p->w, NULL};
    double size = INFINITY, before = INFINITY;
    for (int r = 0; r < s->n_dof; r++) {
        p->w[r] = s->u[r] + dt * s->v[r];
        p->next[r] =
            notes ? s->u[r] : p->w[r] + dt * (s->v[r] - s->v_before[r]);
    }
    scene_hold(s, ++s->steps * dt);
    step_boundary(s->body, s->g, !notes, p->next);
    for (int k = 0; !(size <= 1e-10); k++) {
        const int fresh = notes || k == 0 || size > 0.3 * before;
        const enum status status = body_assemble(
            p->body, Phi, p->next, fresh ? EXACT : NO_TANGENT, p->pull);
        if (status != OK || k == 40) die("PETSc: no answer");
        before = size;
        PetscCall(peer_solve(p, s, fresh, &size));
        p->systems++;
    }
    for (int r = 0; r < s->n_dof; r++) {
        s->v_before[r] = s->v[r];
        s->v[r] = (p->next[r] - s->u[r]) / dt;
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

static PetscErrorCode measure(int n, double ms[METHODS])
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct step_control control[METHODS];
    struct scene *s[METHODS];
    struct peer peer[OURS] = {{0}};
    struct times t[METHODS] = {{0}};
    set.reach = 0.5;
    for (int k = 0; k < METHODS; k++) {
        control[k] = step_method("lift");
        control[k].chord = 1;
        s[k] = scene_alloc(&set);
        for (int step = 0; step < START; step++)
            if (scene_step(s[k], &control[k]).status != OK) die("n = %d", n);
        s[k]->body->exact = k != KEPT;
        if (k < OURS) PetscCall(peer_make(s[k], &peer[k]));
    }
    for (int turn = 0; turn < (n < 128 ? ROUNDS : 1); turn++)
        for (int k = 0; k < METHODS; k++)
            for (int step = 0; step <= IN_A_ROW; step++) {
                const double before = clock_seconds();
                enum status status = OK;
                if (k == OURS) s[k]->body->kept.usable = 0;
                if (k < OURS)
                    PetscCall(peer_step(&peer[k], s[k], k == NOTES));
                else
                    status = scene_step(s[k], &control[k]).status;
                const double seconds = clock_seconds() - before;
                if (step > 0) times_record(&t[k], seconds, status == OK);
            }
    for (int k = 0; k < METHODS; k++) {
        for (int r = 0; r < s[k]->n_dof; r++)
            if (!(fabs(s[k]->u[r] - s[OURS]->u[r]) <= 1e-9))
                t[k].second[0] = NAN;
        ms[k] = 1e3 * times_median(&t[k]);
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
    table_begin_note("peer", "method n step_ms over_ours over_kept",
                     "PETSc %d.%d with CHOLMOD on %s%s", PETSC_VERSION_MAJOR,
                     PETSC_VERSION_MINOR,
                     openblas_get_corename ? "OpenBLAS for " : "another BLAS",
                     openblas_get_corename ? openblas_get_corename() : "");
    for (int n = 8; n <= 128; n *= 2) {
        double ms[METHODS];
        PetscCall(measure(n, ms));
        for (int k = 0; k < METHODS; k++) {
            claim(ms[k] > 0.0, "%s finds the same u, n = %d", name[k], n);
            table_row(name[k], n, ms[k], ms[k] / ms[OURS], ms[k] / ms[KEPT]);
        }
    }
    table_end();
    PetscCall(PetscFinalize());
    return table_finish();
}
