/*
 * newton_1d.c - what does one Newton iteration of the bar cost, per unknown?
 *
 * Whole iterations, cubic law, held at the left and pulled at the right: the
 * fused sweeps of bar_fast.h from both ends and from the left, bar_newton(),
 * and the same loop with GSL's tridiagonal solver (bar_gsl.h).  Beside them one
 * tridiagonal system without assembly, by matrix.h with half bandwidth 1 and by
 * GSL's tridiagonal and banded solvers.
 *
 * They take turns; medians.  Free memory stays with the process, so that no
 * line waits for pages of the system in each call.  A wrong answer ends it.
 */
#include "bar/bar_fast.h"
#include "bar/bar_gsl.h"
#include "base/clock.h"
#include "linear/matrix.h"
#include "linear/residual.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <limits.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum line {
    FUSED_BOTH, FUSED_LEFT, NEWTON, GSL_NEWTON, /* whole iterations */
    TRIDIAGONAL, GSL_TRIDIAGONAL, GSL_BAND, LINES
};
static const char *const name[] = {"fused_both", "fused_left", "newton",
                                   "gsl_newton", "tridiagonal_p1",
                                   "gsl_tridiagonal", "gsl_banded"};

/* A tridiagonal system, the stiffness of a bar held by weak springs. */
static double solve_line(int line, int n)
{
    const size_t size = (size_t)n;
    struct matrix *A = matrix_alloc(BANDED, n, 1);
    double *b = allocate(size, sizeof *b), *x = allocate(size, sizeof *x);
    for (int i = 0; i < n; i++) {
        b[i] = x[i] = sin(2.385 * i + 0.7);
        matrix_add(A, i, i, 2.0 + 1e-2);
        if (i > 0) matrix_add(A, i, i - 1, -1.0);
    }
    struct matrix *L = matrix_copy(A);
    gsl_vector *d = gsl_vector_alloc(size), *e = gsl_vector_alloc(size - 1);
    gsl_vector *out = gsl_vector_calloc(size); /* touched before the clock */
    gsl_vector_view v = gsl_vector_view_array(x, size);
    gsl_matrix_view view = gsl_matrix_view_array(L->a, size, 2);
    gsl_vector_set_all(d, 2.0 + 1e-2);
    gsl_vector_set_all(e, -1.0);

    const double start = clock_seconds();
    if (line == TRIDIAGONAL) {
        if (matrix_factor(L) == OK) matrix_solve(L, x);
    } else if (line == GSL_TRIDIAGONAL) {
        gsl_linalg_solve_symm_tridiag(d, e, &v.vector, out);
    } else {
        gsl_linalg_cholesky_band_decomp(&view.matrix);
        gsl_linalg_cholesky_band_svx(&view.matrix, &v.vector);
    }
    const double seconds = clock_seconds() - start;
    const double *answer = line == GSL_TRIDIAGONAL ? out->data : x;
    claim(matrix_residual(A, answer, b) <= 1e-12, "%s solves n = %d",
          name[line], n);
    gsl_vector_free(d);
    gsl_vector_free(e);
    gsl_vector_free(out);
    matrix_free(A);
    matrix_free(L);
    free(b);
    free(x);
    return seconds / n;
}

/* Seconds of some iterations from rest; u is where they end. */
static double iterate(int line, const struct bar *bar, int iterations,
                      double u[])
{
    const struct newton_control control = {.max_iterations = iterations};
    memset(u, 0, ((size_t)bar->n + 1) * sizeof *u);
    const double start = clock_seconds();
    if (line == GSL_NEWTON)
        bar_gsl_newton(bar, &control, u);
    else if (line == NEWTON)
        bar_newton(bar, &control, u, NULL);
    else
        bar_fast_newton(bar, &control,
                        line == FUSED_LEFT ? FROM_LEFT : FROM_BOTH_ENDS, u);
    return clock_seconds() - start;
}

/* Four iterations less one, so that memory and the last residual do not count.
 * The answer: the bar is stretched evenly, by the force at its end. */
static double newton_line(int line, int n)
{
    double *b = allocate((size_t)n + 1, sizeof *b);
    double *u = allocate((size_t)n + 1, sizeof *u);
    const struct bar bar = {
        n, 1.0 / n, {1, 0}, b, material_make(CUBIC, 1000.0, 0.3)};
    b[n] = 238.5;
    const double one = iterate(line, &bar, 1, u);
    const double four = iterate(line, &bar, 4, u);
    const double P = material1_pk1(&bar.material, 1.0 + u[n]);
    claim(fabs(P - b[n]) < 1e-6 &&
              fabs(u[n / 2] - u[n] * (n / 2) / n) < 1e-9,
          "%s solves n = %d", name[line], n);
    free(b);
    free(u);
    return (four - one) / 3.0 / n;
}

int main(void)
{
    gsl_set_error_handler_off();
#ifdef __GLIBC__ /* a solver that allocates in each call gets its pages back */
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
    study_machine();
    table_begin_note("bar", "unknowns line runs ns_per_unknown spread "
                     "over_fused_both over_tridiagonal_p1",
                     "per iteration, or per system from tridiagonal_p1 on");
    for (int n = 1000; n <= 1000000; n *= 1000) {
        static struct times t[LINES];
        const int runs = n == 1000 ? 31 : 5;
        memset(t, 0, sizeof t);
        for (int run = 0; run < runs; run++)
            for (int k = 0; k < LINES; k++)
                times_record(&t[k], k <= GSL_NEWTON ? newton_line(k, n)
                                                    : solve_line(k, n), 1);
        for (int k = 0; k < LINES; k++) {
            const double seconds = times_median(&t[k]);
            const double fused = times_median(&t[FUSED_BOTH]);
            const double plain = times_median(&t[TRIDIAGONAL]);
            table_row(n, name[k], runs, 1e9 * seconds, times_spread(&t[k]),
                      cell_if(k <= GSL_NEWTON, seconds / fused),
                      cell_if(k > GSL_NEWTON, seconds / plain));
        }
    }
    table_end();
    return table_finish();
}
