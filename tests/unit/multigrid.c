/* multigrid.c - laws of common/linear/cg.h and common/linear/multigrid.h. */
#include "figures/22_multigrid/conjugate.h"
#include "linear/multigrid.h"
#include "plane/system.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The system of n squares per side, its grids, and room for four vectors. */
struct bench {
    struct system *s;
    struct csr *K;
    struct multigrid *m;
    double *b, *x, *y, *z;
};

static void fill(int n, double v[], double phase)
{
    for (int i = 0; i < n; i++)
        v[i] = sin(2.385 * i + phase) * cos(0.3714 * i * i + 0.2385);
}

static struct bench bench_alloc(int n)
{
    struct bench t = {.s = system_alloc(n)};
    t.K = system_matrix(t.s, NULL);
    t.m = multigrid_alloc(t.K, n);
    t.b = allocate(4 * (size_t)t.K->n, sizeof *t.b);
    t.x = t.b + t.K->n;
    t.y = t.x + t.K->n;
    t.z = t.y + t.K->n;
    system_right_side(t.s, NULL, t.b);
    return t;
}

static void bench_free(struct bench t)
{
    multigrid_free(t.m);
    csr_free(t.K);
    system_free(t.s);
    free(t.b);
}

static double dot(int n, const double x[], const double y[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += x[i] * y[i];
    return sum;
}

static void same_size(const void *K, const double r[], double z[])
{
    memcpy(z, r, (size_t)((const struct csr *)K)->n * sizeof *z);
}

static void reversed(const void *K, const double r[], double z[])
{
    for (int i = 0; i < ((const struct csr *)K)->n; i++) z[i] = -r[i];
}

/* A system on a diagonal of three numbers. */
static struct cg_report diagonal(const double entry[3], preconditioner *with,
                                 double tolerance, int cap,
                                 const double b[3], double x[3])
{
    struct csr *D = csr_alloc(3, 3);
    for (int i = 0; i < 3; i++) {
        D->start[i + 1] = i + 1;
        D->index[i] = i;
        D->value[i] = entry[i];
    }
    const struct cg_report report =
        cg_solve(D, with, D, tolerance, cap, b, x);
    csr_free(D);
    return report;
}

static void cg_takes_as_many_steps_as_eigenvalues(void)
{
    const double entry[] = {2.385, 0.3714, 2.385}, b[] = {1.0, -3.1, 0.7};
    double x[3] = {7.0, 7.0, 7.0};
    struct cg_report r = diagonal(entry, same_size, 1e-12, 9, b, x);
    ck_assert_int_eq(r.status, OK);
    ck_assert_int_eq(r.iterations, 2);
    for (int i = 0; i < 3; i++) close_to(x[i], b[i] / entry[i], 1e-13);
    r = diagonal(entry, cg_jacobi, 1e-12, 9, b, x);
    ck_assert_int_eq(r.iterations, 1);
    for (int i = 0; i < 3; i++) close_to(x[i], b[i] / entry[i], 1e-14);
}

static void cg_names_its_end(void)
{
    const double good[] = {2.385, 0.3714, 1.1}, bad[] = {2.385, 0.3714, -1.1};
    const double flat[] = {0.0, 1.0, 1.0}, b[] = {1.0, -3.1, 0.7};
    const double none[] = {0.0, 0.0, 0.0}, nan[] = {1.0, NAN, 0.0};
    const double one[] = {1.0, 0.0, 0.0};
    double x[3] = {7.0, 7.0, 7.0};
    struct cg_report r = diagonal(good, same_size, 1e-12, 2, b, x);
    ck_assert_int_eq(r.status, MAX_ITERATIONS);
    ck_assert_int_eq(r.iterations, 2);
    ck_assert_int_eq(diagonal(bad, same_size, 1e-12, 9, b, x).status, NOT_SPD);
    ck_assert_int_eq(diagonal(flat, same_size, 1e-12, 9, one, x).status,
                     NOT_SPD);
    ck_assert_int_eq(diagonal(good, reversed, 1e-12, 9, b, x).status, NOT_SPD);
    ck_assert_int_eq(diagonal(good, same_size, 1e-12, 9, nan, x).status,
                     NONFINITE);
    ck_assert_int_eq(diagonal(nan, same_size, 1e-12, 9, b, x).status,
                     NONFINITE);
    r = diagonal(good, same_size, 1e-12, 9, none, x);
    ck_assert_int_eq(r.status, OK);
    ck_assert_int_eq(r.iterations, 0);
    ck_assert(x[0] == 0.0 && r.residual == 0.0);
}

static void cg_reports_the_residual_of_x(void)
{
    struct bench t = bench_alloc(8);
    const struct cg_report r =
        cg_solve(t.K, cg_jacobi, t.K, 1e-5, 200, t.b, t.x);
    ck_assert_int_eq(r.status, OK);
    ck_assert_double_le(r.residual, 1e-5);
    close_to(r.residual / csr_residual(t.K, t.x, t.b), 1.0, 1e-8);
    struct cg_report before = cg_solve(t.K, cg_jacobi, t.K, 1e-5,
                                       r.iterations - 1, t.b, t.x);
    ck_assert_int_eq(before.status, MAX_ITERATIONS);
    ck_assert_double_ge(before.residual, 1e-5);
    bench_free(t);
}

/* L L^T e_j at every row where K has an entry, whatever is beside it. */
static void incomplete_factor_has_the_entries_of_K(void)
{
    struct bench t = bench_alloc(6);
    struct factor *L = cg_factor(t.K);
    ck_assert_ptr_nonnull(L);
    ck_assert_int_eq(2 * L->start[L->n] - L->n, t.K->start[t.K->n]);
    for (int i = 0; i < t.K->n; i++) {
        memset(t.x, 0, (size_t)t.K->n * sizeof *t.x);
        for (int j = 0; j <= i; j++) { /* x := L (row i of L)^T */
            double l = 0.0;
            for (int p = L->start[j]; p < L->end[j]; p++)
                if (L->row[p] == i) l = L->value[p];
            for (int p = L->start[j]; p < L->end[j]; p++)
                t.x[L->row[p]] += L->value[p] * l;
        }
        for (int k = t.K->start[i]; k < t.K->start[i + 1]; k++)
            if (t.K->index[k] >= i)
                close_to(t.x[t.K->index[k]], t.K->value[k], 1e-13);
    }
    fill(t.K->n, t.x, 0.7);
    memcpy(t.y, t.x, (size_t)t.K->n * sizeof *t.x);
    csr_factor_solve(L, t.y);
    cg_incomplete(L, t.x, t.z);
    for (int i = 0; i < t.K->n; i++) ck_assert(t.z[i] == t.y[i]);
    csr_factor_free(L);
    t.K->value[0] = -1.0;
    ck_assert_ptr_null(cg_factor(t.K));
    bench_free(t);
}

static void coarse_matrix_is_that_of_the_product(void)
{
    const int n[] = {8, 12, 20};
    for (int k = 0; k < COUNT(n); k++) {
        struct bench t = bench_alloc(n[k]);
        struct csr *A = multigrid_coarse(t.K, n[k]);
        ck_assert_int_eq(A->n, 2 * (n[k] / 2 - 1) * (n[k] / 2 + 1));
        for (int i = 0; i < A->n; i++)
            for (int q = A->start[i] + 1; q < A->start[i + 1]; q++)
                ck_assert_int_lt(A->index[q - 1], A->index[q]);
        fill(A->n, t.x, 0.7);
        multigrid_prolong(n[k], t.x, t.y); /* y is 0 */
        csr_multiply(t.K, t.y, t.z);
        double *want = allocate(2 * (size_t)A->n, sizeof *want);
        double *got = want + A->n;
        multigrid_restrict(n[k], t.z, want);
        csr_multiply(A, t.x, got);
        for (int i = 0; i < A->n; i++) close_to(got[i], want[i], 1e-13);
        free(want);
        csr_free(A);
        bench_free(t);
    }
}

static void grids_are_halved_down_to_four(void)
{
    const int want[][5] = {{4, 0}, {7, 0}, {8, 4, 0}, {20, 10, 5, 0},
                           {32, 16, 8, 4, 0}};
    for (int k = 0; k < COUNT(want); k++) {
        struct bench t = bench_alloc(want[k][0]);
        int g = 0;
        for (; g < t.m->grids; g++) {
            ck_assert_int_eq(t.m->n[g], want[k][g]);
            ck_assert_int_eq(t.m->K[g]->n, 2 * (want[k][g] - 1) *
                                               (want[k][g] + 1));
        }
        ck_assert_int_eq(want[k][g], 0);
        ck_assert_int_eq(t.m->status, OK);
        bench_free(t);
    }
    struct bench t = bench_alloc(8);
    for (int k = 0; k < t.K->start[t.K->n]; k++) t.K->value[k] *= -1.0;
    struct multigrid *m = multigrid_alloc(t.K, 8);
    ck_assert_int_eq(m->status, NOT_SPD);
    multigrid_free(m);
    multigrid_free(NULL);
    bench_free(t);
}

static void a_cycle_is_symmetric_and_exact_on_the_coarsest_grid(void)
{
    struct bench t = bench_alloc(16);
    double *r = allocate(2 * (size_t)t.K->n, sizeof *r), *s = r + t.K->n;
    fill(t.K->n, r, 0.7);
    fill(t.K->n, s, 1.9);
    multigrid_cycle(t.m, r, t.x);
    multigrid_cycle(t.m, s, t.y);
    close_to(dot(t.K->n, r, t.y) / dot(t.K->n, s, t.x), 1.0, 1e-11);
    ck_assert_double_ge(dot(t.K->n, r, t.x), 0.0);
    multigrid_cycle(t.m, r, t.z); /* nothing is left of the one before */
    for (int i = 0; i < t.K->n; i++) ck_assert(t.z[i] == t.x[i]);
    free(r);
    bench_free(t);
    t = bench_alloc(6);
    multigrid_cycle(t.m, t.b, t.x);
    ck_assert_double_le(csr_residual(t.K, t.x, t.b), 1e-14);
    bench_free(t);
}

UNIT_MAIN("multigrid",
    LAW(cg_takes_as_many_steps_as_eigenvalues),
    LAW(cg_names_its_end),
    LAW(cg_reports_the_residual_of_x),
    LAW(incomplete_factor_has_the_entries_of_K),
    LAW(coarse_matrix_is_that_of_the_product),
    LAW(grids_are_halved_down_to_four),
    LAW(a_cycle_is_symmetric_and_exact_on_the_coarsest_grid))
