/*
 * many.c - the square dealt out to many processes, by PETSc and MPI.
 *
 * A step of backward Euler is that of step.c (lift, chord rule, stop), from the
 * parabola through the last three states.  PETSc deals out the vertices (DMDA),
 * sends what neighbours need, and has Newton's method (SNES), conjugate
 * gradients (KSP) and their preconditioner (PC).
 *
 * Run: sh tests/tools/mpirun.sh 4 build/figures/many/many --n 128
 *      PETSC_OPTIONS=... has more for PETSc, -log_view for example.
 * Per step 2.6 linear systems, per system 4 iterations, whatever n is.
 */
#include "account.h"
#include "base/options.h"

#include <stdio.h>

enum method { GEOMETRIC, ALGEBRAIC, RIGID_MODES, CHOLESKY };
static const struct {
    const char *name, *options;
} method_list[] = {
    {"geometric", "-pc_type mg -pc_mg_galerkin both -mg_levels_pc_type sor "
                  "-mg_levels_pc_sor_local_symmetric -mg_levels_ksp_max_it 1 "
                  "-mg_levels_ksp_type richardson"},
    {"algebraic", "-pc_type gamg"},
    {"rigid_modes", "-pc_type gamg"},
    {"cholesky", "-pc_type cholesky -pc_factor_mat_solver_type mumps"}};
static const char *const always =
    "-snes_linesearch_type basic -snes_max_it 40 -ksp_type cg "
    "-ksp_norm_type unpreconditioned -ksp_rtol 1e-4 -ksp_atol 0";

/* A zero K that MatSetValuesCOO can fill.  An entry with index -1 is left out:
 * rows of others, and what couples a prescribed vertex to something else. */
static PetscErrorCode matrix_make(struct piece *p, enum method method, Mat *K)
{
    PetscInt *row = allocate(p->entries, sizeof *row);
    PetscInt *column = allocate(p->entries, sizeof *column);
    for (size_t k = 0; k < p->entries; k++) {
        const struct element_entry entry = element_entry(p->body, k);
        const int a = entry.row / 2, b = entry.column / 2;
        const int both_free = !prescribed(p, a) && !prescribed(p, b);
        const int used = own(p, a) && (both_free || entry.i == entry.j);
        row[k] = used ? entry.row : -1;
        column[k] = used ? entry.column : -1;
    }
    PetscCall(DMSetMatrixPreallocateSkip(p->grid, PETSC_TRUE));
    PetscCall(DMCreateMatrix(p->grid, K));
    PetscCall(MatSetPreallocationCOOLocal(*K, (PetscCount)p->entries, row,
                                        column));
    PetscCall(MatSetOption(*K, MAT_SPD, PETSC_TRUE));
    free(row);
    free(column);
    if (method != RIGID_MODES) return 0;
    Vec x;
    MatNullSpace modes;
    PetscCall(DMGetCoordinates(p->grid, &x));
    PetscCall(MatNullSpaceCreateRigidBody(x, &modes));
    PetscCall(MatSetNearNullSpace(*K, modes));
    return MatNullSpaceDestroy(&modes);
}

/* q and, unless NO_TANGENT, body->K at the displacements U; a NaN in q tells
 * SNES of a status that is not OK. */
static PetscErrorCode assemble(struct piece *p, Vec U, enum tangent tangent)
{
    double *q = p->q.at;
    PetscCall(DMGlobalToLocal(p->grid, U, INSERT_VALUES, p->u.vec));
    const struct incremental Phi = {p->set.dt, p->w.at, NULL};
    const enum status status =
        body_assemble(p->body, Phi, p->u.at, tangent, q);
    for (int a = 0; a < p->mesh->n_vertex; a++) {
        const double g[2] = {p->end * X1(p, a), 0.0};
        for (int i = 0; i < 2; i++) {
            const int r = 2 * a + i;
            if (prescribed(p, a))
                q[r] = p->diagonal.at[r] * (p->u.at[r] - g[i]);
            if (status != OK) q[r] = (double)NAN;
        }
    }
    return 0;
}

static PetscErrorCode residual(SNES snes, Vec U, Vec Q, void *context)
{
    struct piece *p = context;
    (void)snes;
    PetscCall(assemble(p, U, NO_TANGENT));
    return DMLocalToGlobal(p->grid, p->q.vec, INSERT_VALUES, Q);
}

static PetscErrorCode jacobian(SNES snes, Vec U, Mat A, Mat K, void *context)
{
    struct piece *p = context;
    (void)snes, (void)A;
    PetscCall(assemble(p, U, EXACT));
    elements_values(p->body, p->value);
    PetscCall(MatSetValuesCOO(K, p->value, INSERT_VALUES));
    PetscCall(MatGetDiagonal(K, p->some));
    PetscCall(VecNorm(p->some, NORM_INFINITY, &p->largest));
    return DMGlobalToLocal(p->grid, p->some, INSERT_VALUES, p->diagonal.vec);
}

/* Stop, and keep K or not, as step.c does [alg:chord]. */
static PetscErrorCode stop(SNES snes, PetscInt iteration, PetscReal x,
                           PetscReal du_norm, PetscReal q_norm,
                           SNESConvergedReason *reason, void *context)
{
    struct piece *p = context;
    const double before = p->increment, tolerance = 1e-10;
    double scaled;
    Vec du, q;
    (void)x, (void)du_norm, (void)q_norm;
    *reason = SNES_CONVERGED_ITERATING;
    if (iteration == 0) return 0;
    PetscCall(SNESGetSolutionUpdate(snes, &du));
    PetscCall(VecNorm(du, NORM_INFINITY, &p->increment));
    PetscCall(SNESGetFunction(snes, &q, NULL, NULL));
    PetscCall(VecNorm(q, NORM_INFINITY, &scaled));
    scaled /= p->largest;
    if (!isfinite(p->increment + scaled)) *reason = SNES_DIVERGED_FNORM_NAN;
    if (p->increment <= tolerance && scaled <= tolerance)
        *reason = SNES_CONVERGED_FNORM_ABS;
    return SNESSetLagJacobian(snes, p->increment > 0.3 * before ? -2 : -1);
}

static PetscErrorCode solver_make(struct piece *p, enum method method,
                                  SNES *snes)
{
    Mat K;
    char levels[40];
#ifndef PETSC_HAVE_MUMPS
    if (method == CHOLESKY) die("this PETSc has no MUMPS");
#endif
    snprintf(levels, sizeof levels, "-pc_mg_levels %d", p->levels);
    PetscCall(PetscOptionsInsertString(NULL, always));
    PetscCall(PetscOptionsInsertString(NULL, method_list[method].options));
    if (method == GEOMETRIC) PetscCall(PetscOptionsInsertString(NULL, levels));
    PetscCall(PetscOptionsInsertString(NULL, getenv("PETSC_OPTIONS")));
    PetscCall(matrix_make(p, method, &K));
    PetscCall(SNESCreate(PETSC_COMM_WORLD, snes));
    PetscCall(SNESSetDM(*snes, p->grid));
    PetscCall(SNESSetFunction(*snes, NULL, residual, p));
    PetscCall(SNESSetJacobian(*snes, K, K, jacobian, p));
    PetscCall(SNESSetConvergenceTest(*snes, stop, p, NULL));
    return SNESSetFromOptions(*snes);
}

/* Where the right end is after k steps; at rest until the start. */
static double end_at(const struct piece *p, int k)
{
    return k > 0 ? p->set.reach * sin(k * p->set.dt) : 0.0;
}

/*
 * Step k.  past: the last three displacements, the newest first, u0, u1, u2.
 * With v0 = (u0 - u1) / dt and so on w = u0 + dt v0 is 2 u0 - u1, and the guess
 * u0 + dt (2 v0 - v1) is 3 u0 - 3 u1 + u2.
 */
static PetscErrorCode step(struct piece *p, SNES snes, int k, Vec past[3])
{
    const Vec next = past[2];
    PetscCall(VecAXPBYPCZ(p->some, 2.0, -1.0, 0.0, past[0], past[1]));
    PetscCall(DMGlobalToLocal(p->grid, p->some, INSERT_VALUES, p->w.vec));
    PetscCall(VecAXPBYPCZ(next, 3.0, -3.0, 1.0, past[0], past[1]));
    p->end = end_at(p, k);
    PetscCall(VecAXPY(next, p->end - 3.0 * end_at(p, k - 1) +
                                3.0 * end_at(p, k - 2) - end_at(p, k - 3),
                      p->across)); /* the jump of the ends, lifted */
    p->increment = INFINITY;
    PetscCall(SNESSetLagJacobian(snes, -2)); /* K once, and then keep it */
    PetscCall(SNESSolve(snes, NULL, next));
    past[2] = past[1], past[1] = past[0], past[0] = next;
    return 0;
}

static PetscErrorCode run(const struct scene_setting *set, enum method method,
                          int steps, int serial)
{
    struct piece p = {.set = *set};
    struct account start, first = {0}, last;
    struct tally tally = {.method = method_list[method].name, .steps = steps,
                          .error = (double)NAN};
    SNES snes;
    Vec past[3];
    int rank;
    PetscCall(account_now(&start));
    PetscCall(piece_make(&p));
    PetscCall(solver_make(&p, method, &snes));
    for (int k = 0; k < 3; k++) PetscCall(VecDuplicate(p.some, &past[k]));
    for (int k = 1; k <= steps; k++) {
        SNESConvergedReason reason;
        int systems, iterations;
        PetscCall(step(&p, snes, k, past));
        PetscCall(SNESGetConvergedReason(snes, &reason));
        if (reason < 0) die("step %d: %s", k, SNESConvergedReasons[reason]);
        PetscCall(SNESGetIterationNumber(snes, &systems));
        PetscCall(SNESGetLinearSolveIterations(snes, &iterations));
        tally.systems += systems;
        tally.iterations += iterations;
        tally.most = systems > tally.most ? systems : tally.most;
        if (k > 1) continue;
        tally.first_systems = systems;
        tally.first_iterations = iterations;
        PetscCall(account_now(&first));
    }
    PetscCall(account_now(&last));
    if (serial)
        PetscCall(account_compare(set, steps, p.grid, past[0], &tally));
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    if (rank == 0) account_print(&tally, &p, &start, &first, &last);
    return 0;
}

int main(int argc, char *argv[])
{
    int n = 16, steps = 10, method = GEOMETRIC, serial = 1;
    const struct option table[] = {
        {"n", .integer = &n, .min = 2, .max = 32766, .help = "cells per row",
         .why = "the unknowns have 32-bit numbers"},
        {"steps", .integer = &steps, .min = 2, .max = 100000,
         .help = "time steps, of which the first is in no count per step"},
        {"method", .choice = &method,
         .choices = "geometric algebraic rigid_modes cholesky",
         .help = "preconditioner, or the direct solver MUMPS"},
        {"serial", .choice = &serial, .choices = "no yes",
         .help = "compare with common/plane/step.c"},
    };
    options_parse("many", table, COUNT(table), argc, argv);
    PetscCall(PetscInitialize(NULL, NULL, NULL, NULL));
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    set.reach = 0.5; /* that of figures/speed */
    PetscCall(run(&set, (enum method)method, steps, serial));
    PetscCall(PetscFinalize());
    return table_finish();
}
