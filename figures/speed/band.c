/*
 * band.c - how fast is the banded Cholesky of common/?
 *
 * One factorisation and one solve of an SPD band as linear triangles on n x n
 * squares give it, two opposite sides held: order 2 (n-1)(n+1), half bandwidth
 * 2 n - 1, full of random numbers, which a band solver does not look at.  Every
 * solver gets its matrix as assembly leaves it, just written, into the same
 * memory; ours and LAPACK's have room behind the columns (tiles.h).
 *
 * The solvers take turns; medians.  An answer whose residual is not small, or
 * that is not ours, has no seconds.
 */
#include "base/clock.h"
#include "machine.h"
#include "linear/residual.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <string.h>

enum solver { OURS, GSL_BAND, LAPACK_BAND, GSL_DENSE, SOLVERS, SIZES = 4 };
static const char *const solver_name[] = {"ours", "gsl_banded", "lapack_dpbtrf",
                                          "gsl_dense"};
static const int size[SIZES] = {16, 32, 64, 128}, runs[SIZES] = {31, 21, 11, 5};

static int takes_part(int solver, int s, int run)
{
    if (solver == LAPACK_BAND) return *MACHINE_LAPACK != '\0';
    return solver != GSL_DENSE || s == 0 || (s == 1 && run < 3);
}

static struct matrix *random_band(int n)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_taus2);
    const int N = 2 * (n - 1) * (n + 1), p = 2 * n - 1;
    struct matrix *A = matrix_alloc(BANDED, N, p);
    for (int j = 0; j < N; j++) {
        matrix_add(A, j, j, 2.385 + 0.5 * p);
        for (int i = j + 1; i < N && i <= j + p; i++)
            matrix_add(A, i, j, gsl_rng_uniform(rng) - 0.5);
    }
    gsl_rng_free(rng);
    return A;
}

/* As GSL wants it: rows of n numbers, or columns of p + 1. */
static void plain_copy(const struct matrix *A, enum storage storage, double a[])
{
    const size_t row = (size_t)(storage == DENSE ? A->n : A->p + 1);
    memset(a, 0, (size_t)A->n * row * sizeof *a);
    for (int j = 0; j < A->n; j++)
        for (int d = 0; d <= A->p && j + d < A->n; d++) {
            const double value = matrix_get(A, j + d, j);
            const size_t i = (size_t)(j + d), k = (size_t)j;
            if (storage == BANDED) a[k * row + (size_t)d] = value;
            else a[i * row + k] = a[k * row + i] = value;
        }
}

/* x := A^{-1} x; a holds A as the solver wants it.  Return the seconds. */
static double solve(int solver, const struct matrix *A, double a[], double x[])
{
    const size_t n = (size_t)A->n;
    gsl_vector_view v = gsl_vector_view_array(x, n);
    gsl_matrix_view view = gsl_matrix_view_array(
        a, n, solver == GSL_DENSE ? n : (size_t)A->p + 1);
    struct matrix L = *A;
    L.a = a;
    gsl_matrix *G = &view.matrix;
    const double start = clock_seconds();
    if (solver == OURS) matrix_factor(&L);
    if (solver == GSL_BAND) gsl_linalg_cholesky_band_decomp(G);
    if (solver == LAPACK_BAND) lapack_factor(&L);
    if (solver == GSL_DENSE) gsl_linalg_cholesky_decomp1(G);
    if (solver == OURS) matrix_solve(&L, x);
    if (solver == GSL_BAND) gsl_linalg_cholesky_band_svx(G, &v.vector);
    if (solver == LAPACK_BAND) lapack_solve(&L, x);
    if (solver == GSL_DENSE) gsl_linalg_cholesky_svx(G, &v.vector);
    return clock_seconds() - start;
}

struct measured {
    struct times all[SOLVERS], peak;
    int wrong; /* answers */
};

static void measure(int s, struct measured *t)
{
    struct matrix *A = random_band(size[s]);
    const size_t n = (size_t)A->n, bytes = n * sizeof(double);
    struct matrix *copy = matrix_copy(A); /* wide enough for a plain band */
    double *dense = allocate(s < 2 ? n * bytes : 1, 1);
    double *b = allocate(bytes, 1), *x = allocate(bytes, 1);
    double *ours = allocate(bytes, 1);
    for (size_t i = 0; i < n; i++) b[i] = sin(2.385 * (double)i + 0.7);
    for (int run = 0; run < runs[s]; run++) {
        times_record(&t->peak, machine_peak_gigaflop(), 1);
        for (int k = 0; k < SOLVERS; k++) {
            double *a = k == GSL_DENSE ? dense : copy->a, apart = 0.0;
            if (!takes_part(k, s, run)) continue;
            memcpy(x, b, bytes);
            if (k == GSL_BAND || k == GSL_DENSE)
                plain_copy(A, k == GSL_DENSE ? DENSE : BANDED, a);
            else
                memcpy(a, A->a, matrix_bytes(A));
            const double all = solve(k, A, a, x);
            if (k == OURS) memcpy(ours, x, bytes);
            for (size_t i = 0; i < n; i++)
                apart = fmax(apart, fabs(x[i] - ours[i]));
            const int valid = matrix_residual(A, x, b) <= 1e-12 &&
                              apart <= 1e-12 * cblas_dnrm2(A->n, x, 1);
            t->wrong += !valid;
            times_record(&t->all[k], all, valid);
        }
    }
    matrix_free(A);
    matrix_free(copy);
    free(dense);
    free(b);
    free(x);
    free(ours);
}

/* Of all measurements: what another program takes away is not missing there. */
static double best_peak(const struct measured t[SIZES])
{
    double best = 0.0;
    for (int s = 0; s < SIZES; s++)
        best = fmax(best, times_quantile(&t[s].peak, 1.0));
    return best;
}

/* Multiplications and additions to leading order [eq:band-cost]. */
static void print_solver(int k, const struct measured t[SIZES])
{
    for (int s = 0; s < SIZES && t[s].all[k].runs > 0; s++) {
        const int n = size[s];
        const double N = 2.0 * (n - 1) * (n + 1), q = 2.0 * n;
        const double factor = k == GSL_DENSE ? N * N * N / 3.0 : N * q * q;
        const double back = k == GSL_DENSE ? 2.0 * N * N : 4.0 * N * q;
        const double seconds = times_median(&t[s].all[k]);
        const int valid = !isnan(seconds);
        table_row(solver_name[k], n, cell_if(valid, 1e3 * seconds),
                  cell_if(valid, 1e-9 * (factor + back) / seconds),
                  cell_if(valid, seconds / times_median(&t[s].all[OURS])));
    }
}

int main(void)
{
    static struct measured t[SIZES];
    gsl_set_error_handler_off();
    study_machine();
    for (int s = 0; s < SIZES; s++) measure(s, &t[s]);
    table_begin_note("band", "solver n milliseconds gigaflop_per_second "
                     "over_ours", "tiles.c with: %s; LAPACK: %s",
                     NATIVE_FLAGS, MACHINE_LAPACK);
    for (int k = 0; k < SOLVERS; k++) print_solver(k, t);
    table_end();
    table_begin_note("peak", "n gigaflop_per_second",
                     "multiply-adds of one core, the best of the run");
    for (int s = 0; s < SIZES; s++)
        table_row(size[s], best_peak(t));
    table_end();
    for (int s = 0; s < SIZES; s++)
        claim(t[s].wrong == 0, "all solvers give the same answer");
    return table_finish();
}
