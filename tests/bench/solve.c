/*
 * solve.c - how fast the linear solvers are, on the machine at hand.
 *
 * Two dimensions: one factorisation and one solve of an SPD band as linear
 * triangles on n x n squares give it, two unknowns a node and the nodes of two
 * opposite sides prescribed: order 2 (n - 1) (n + 1), half bandwidth 2 n - 1
 * when they are numbered along a line between these sides.  The band is full of
 * random numbers: a band solver does not look at them.  One dimension: ns an
 * unknown for tridiagonal systems and for whole Newton steps of the bar.
 *
 * Every solver gets its matrix as assembly leaves it, just written: copied into
 * the same memory right before the clock starts.  Ours and LAPACK's have room
 * behind the columns (banded.h), which GSL's band does not allow.
 *
 * The solvers take turns; medians, and spread = (largest - smallest) / median.
 * An answer whose residual is not small has no time, and neither has what was
 * not run: NAN inside this program, 0 in its tables.  Nothing is asserted:
 * times are not what a test can hold.
 */
#include "bar_fast.h"
#include "bench.h"
#include "clock.h"
#include "matrix.h"
#include "options.h"
#include "table.h"

#include <gsl/gsl_cblas.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS = 31 };

/* ---- the band ------------------------------------------------------------ */

enum solver { OURS, GSL_BAND, LAPACK_BAND, GSL_DENSE, SOLVERS };
static const char *const solver_name[] = {"ours", "gsl_banded", "lapack_dpbtrf",
                                          "gsl_dense"};

static struct matrix *random_band(int n, int p)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_taus2);
    struct matrix *A = matrix_alloc(BANDED, n, p);
    for (int j = 0; j < n; j++) {
        matrix_add(A, j, j, 2.385 + 0.5 * p);
        for (int i = j + 1; i < n && i <= j + p; i++)
            matrix_add(A, i, j, gsl_rng_uniform(rng) - 0.5);
    }
    gsl_rng_free(rng);
    return A;
}

/* A in rows of p + 1 (banded) or n (dense) numbers, as GSL wants it. */
static double *plain_copy(const struct matrix *A, enum storage storage)
{
    const size_t n = (size_t)A->n;
    const size_t row = storage == DENSE ? n : (size_t)A->p + 1;
    double *a = allocate(n * row, sizeof *a);
    for (int j = 0; j < A->n; j++)
        for (int d = 0; d <= A->p && j + d < A->n; d++) {
            const double value = matrix_get(A, j + d, j);
            if (storage == BANDED)
                a[(size_t)j * row + (size_t)d] = value;
            else
                a[(size_t)(j + d) * n + (size_t)j] =
                    a[(size_t)j * n + (size_t)(j + d)] = value;
        }
    return a;
}

/* Factor A, which is in a as the solver wants it, and overwrite x by A^{-1} x.
 * The seconds to factor are NAN where there is no such solver. */
struct seconds {
    double factor, all;
};
static struct seconds solve(enum solver solver, const struct matrix *A,
                            double a[], double x[])
{
    const size_t n = (size_t)A->n, row = (size_t)A->p + 1;
    gsl_vector_view v = gsl_vector_view_array(x, n);
    gsl_matrix_view view =
        gsl_matrix_view_array(a, n, solver == GSL_DENSE ? n : row);
    struct matrix L = *A;
    L.a = a;
    double factored = (double)NAN;

    const double start = clock_seconds();
    if (solver == OURS) {
        const enum status status = matrix_factor(&L);
        factored = clock_seconds();
        if (status == OK) matrix_solve(&L, x);
    } else if (solver == GSL_BAND) {
        gsl_linalg_cholesky_band_decomp(&view.matrix);
        factored = clock_seconds();
        gsl_linalg_cholesky_band_svx(&view.matrix, &v.vector);
    } else if (solver == GSL_DENSE) {
        gsl_linalg_cholesky_decomp1(&view.matrix);
        factored = clock_seconds();
        gsl_linalg_cholesky_svx(&view.matrix, &v.vector);
    } else {
#ifdef LAPACK
        const int lda = (int)A->stride, one = 1;
        int info;
        dpbtrf_("L", &A->n, &A->p, a, &lda, &info, 1);
        factored = clock_seconds();
        if (info == 0)
            dpbtrs_("L", &A->n, &A->p, &one, a, &lda, x, &A->n, &info, 1);
#endif
    }
    return (struct seconds){factored - start, clock_seconds() - start};
}

enum { SIZES = 4 };
static const int size[SIZES] = {16, 32, 64, 128};
static const int runs_at[SIZES] = {31, 21, 11, 5};
static int order_of(int n)
{
    return 2 * (n - 1) * (n + 1);
}
static int band_of(int n)
{
    return 2 * n - 1;
}

/* Multiplications and additions, to leading order [eq:band-cost]. */
static double factor_flops(enum solver solver, int n)
{
    const double N = order_of(n), p = band_of(n);
    return solver == GSL_DENSE ? N * N * N / 3.0 : N * (p + 1) * (p + 1);
}

static double flops(enum solver solver, int n)
{
    const double N = order_of(n), p = band_of(n);
    return factor_flops(solver, n) +
           (solver == GSL_DENSE ? 2.0 * N * N : 4.0 * N * (p + 1));
}

static int takes_part(enum solver solver, int s, int run)
{
    return solver != GSL_DENSE || s == 0 || (s == 1 && run < 3);
}

struct band_times {
    struct times factor[SOLVERS], all[SOLVERS], peak;
    double difference; /* of our answer and GSL's */
};

static void measure_band(int s, struct band_times *t)
{
    const int N = order_of(size[s]);
    const size_t bytes = (size_t)N * sizeof(double);
    struct matrix *A = random_band(N, band_of(size[s]));
    struct matrix *copy = matrix_copy(A); /* wide enough for a plain band */
    double *band = plain_copy(A, BANDED);
    double *dense = s < 2 ? plain_copy(A, DENSE) : NULL;
    double *dense_copy = allocate(s < 2 ? (size_t)N * bytes : 1, 1);
    double *b = allocate(bytes, 1), *x = allocate(bytes, 1);
    double *ours = allocate(bytes, 1);
    for (int i = 0; i < N; i++) b[i] = sin(2.385 * i + 0.7);
    for (int run = 0; run < runs_at[s]; run++) {
        times_record(&t->peak, bench_peak_gigaflop(), 1);
        for (int k = 0; k < SOLVERS; k++) {
            if (!takes_part((enum solver)k, s, run)) continue;
            memcpy(x, b, bytes);
            if (k == GSL_DENSE)
                memcpy(dense_copy, dense, (size_t)N * bytes);
            else if (k == GSL_BAND)
                memcpy(copy->a, band, ((size_t)A->p + 1) * bytes);
            else
                memcpy(copy->a, A->a, matrix_bytes(A));
            const struct seconds seconds = solve(
                (enum solver)k, A, k == GSL_DENSE ? dense_copy : copy->a, x);
            if (isnan(seconds.factor)) continue;
            const int valid = matrix_residual(A, x, b) <= 1e-12;
            times_record(&t->factor[k], seconds.factor, valid);
            times_record(&t->all[k], seconds.all, valid);
            /* This call makes the linker put the CBLAS of GSL before the one
             * that LAPACK's library may have: GSL is to run on its own. */
            const double largest = fabs(x[cblas_idamax(N, x, 1)]);
            if (k == OURS) memcpy(ours, x, bytes);
            if (k != GSL_BAND) continue;
            cblas_daxpy(N, -1.0, ours, 1, x, 1);
            t->difference = fabs(x[cblas_idamax(N, x, 1)]) / largest;
        }
    }
    matrix_free(A);
    matrix_free(copy);
    free(band);
    free(dense);
    free(dense_copy);
    free(b);
    free(x);
    free(ours);
}

static void print_band(const struct band_times t[SIZES])
{
    table_begin_note("ratios",
                     "n order p gsl_banded lapack_dpbtrf gsl_dense "
                     "difference_from_gsl",
                     "their seconds over ours, factor and one solve");
    for (int s = 0; s < SIZES; s++) {
        const double ours = times_median(&t[s].all[OURS]);
        row(size[s], order_of(size[s]), band_of(size[s]),
            times_median(&t[s].all[GSL_BAND]) / ours,
            times_median(&t[s].all[LAPACK_BAND]) / ours,
            times_median(&t[s].all[GSL_DENSE]) / ours, t[s].difference);
    }
    table_end();
    table_begin_note("peak",
                     "n peak_gigaflop spread ours gsl_banded "
                     "lapack_dpbtrf gsl_dense",
                     "multiply-adds of one core, 1e9 operations a second; the "
                     "percentage of it that a factorisation reaches");
    for (int s = 0; s < SIZES; s++) {
        double percent[SOLVERS];
        for (int k = 0; k < SOLVERS; k++)
            percent[k] = 1e-7 * factor_flops((enum solver)k, size[s]) /
                         times_median(&t[s].factor[k]) /
                         times_median(&t[s].peak);
        row(size[s], times_median(&t[s].peak), times_spread(&t[s].peak),
            percent[OURS], percent[GSL_BAND], percent[LAPACK_BAND],
            percent[GSL_DENSE]);
    }
    table_end();
    for (int k = 0; k < SOLVERS; k++) {
        if (t[0].all[k].runs == 0) continue;
        table_begin(solver_name[k],
                    "n runs milliseconds spread factor_milliseconds megaflop "
                    "gigaflop_a_second");
        for (int s = 0; s < SIZES && t[s].all[k].runs > 0; s++) {
            const double work = flops((enum solver)k, size[s]);
            const struct times *all = &t[s].all[k];
            row(size[s], all->runs, 1e3 * times_median(all), times_spread(all),
                1e3 * times_median(&t[s].factor[k]), 1e-6 * work,
                1e-9 * work / times_median(all));
        }
        table_end();
    }
    table_begin_note("growth",
                     "n ours gsl_banded lapack_dpbtrf gsl_dense band_flops "
                     "dense_flops",
                     "exponent of n in seconds and in flops, from n to 2 n; "
                     "4 and 6 in the limit");
    for (int s = 0; s + 1 < SIZES; s++) {
        double power[SOLVERS];
        for (int k = 0; k < SOLVERS; k++)
            power[k] = log2(times_median(&t[s + 1].all[k]) /
                            times_median(&t[s].all[k]));
        row(size[s], power[OURS], power[GSL_BAND], power[LAPACK_BAND],
            power[GSL_DENSE],
            log2(flops(OURS, 2 * size[s]) / flops(OURS, size[s])),
            log2(flops(GSL_DENSE, 2 * size[s]) / flops(GSL_DENSE, size[s])));
    }
    table_end();
}

/* ---- the bar ------------------------------------------------------------- */

enum line {
    FUSED_BOTH,
    FUSED_LEFT,
    NEWTON,
    GSL_NEWTON,
    TRIDIAGONAL,
    GSL_TRIDIAGONAL,
    GSL_BAND_1,
    LINES
};

/* A tridiagonal system, the stiffness of a bar held by weak springs. */
static void solve_line(enum line line, int n, struct times *t)
{
    const size_t size_n = (size_t)n;
    struct matrix *A = matrix_alloc(BANDED, n, 1);
    double *b = allocate(size_n, sizeof *b), *x = allocate(size_n, sizeof *x);
    for (int i = 0; i < n; i++) {
        b[i] = x[i] = sin(2.385 * i + 0.7);
        matrix_add(A, i, i, 2.0 + 1e-2);
        if (i > 0) matrix_add(A, i, i - 1, -1.0);
    }
    struct matrix *L = matrix_copy(A);
    gsl_vector *d = gsl_vector_alloc(size_n), *e = gsl_vector_alloc(size_n - 1);
    gsl_vector *out = gsl_vector_calloc(size_n); /* touched before the clock */
    gsl_vector_view v = gsl_vector_view_array(x, size_n);
    gsl_matrix_view view = gsl_matrix_view_array(L->a, size_n, 2);
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
    times_record(t, seconds / n,
                 matrix_residual(A, line == GSL_TRIDIAGONAL ? out->data : x,
                                 b) <= 1e-12);
    gsl_vector_free(d);
    gsl_vector_free(e);
    gsl_vector_free(out);
    matrix_free(A);
    matrix_free(L);
    free(b);
    free(x);
}

/* Newton's method for the cubic law, left end held: the entries into arrays,
 * then GSL's solver. */
static void gsl_newton(const struct bar *bar, int iterations, double u[])
{
    const size_t n = (size_t)bar->n;
    const double mu = bar->material.mu, lambda = bar->material.lambda;
    gsl_vector *d = gsl_vector_alloc(n), *e = gsl_vector_alloc(n - 1);
    gsl_vector *r = gsl_vector_alloc(n), *du = gsl_vector_alloc(n);
    for (int k = 0; k < iterations; k++) {
        for (size_t i = 0; i < n; i++) r->data[i] = bar->b[i + 1];
        for (size_t i = 0; i < n; i++) { /* the element left of node i + 1 */
            const double H = (u[i + 1] - u[i]) / bar->h;
            const double dv = 1.0 - H + H * H;
            const double G =
                lambda * (H - H * H / 2.0 + H * H * H / 3.0) - mu;
            const double P = mu * (1.0 + H) + G * dv;
            const double K =
                (mu + lambda * dv * dv + G * (2.0 * H - 1.0)) / bar->h;
            r->data[i] -= P;
            d->data[i] = K;
            if (i == 0) continue;
            r->data[i - 1] += P;
            d->data[i - 1] += K;
            e->data[i - 1] = -K;
        }
        gsl_linalg_solve_symm_tridiag(d, e, r, du);
        for (size_t i = 0; i < n; i++) u[i + 1] += du->data[i];
    }
    gsl_vector_free(d);
    gsl_vector_free(e);
    gsl_vector_free(r);
    gsl_vector_free(du);
}

/* Seconds of some iterations from rest, held at the left, pulled at the right;
 * u is where they end. */
static double iterate(enum line line, const struct bar *bar, int iterations,
                      double u[])
{
    const struct newton_control control = {0.0, iterations, 0, 0};
    memset(u, 0, ((size_t)bar->n + 1) * sizeof *u);
    const double start = clock_seconds();
    if (line == GSL_NEWTON)
        gsl_newton(bar, iterations, u);
    else if (line == NEWTON)
        bar_newton(bar, &control, u, NULL);
    else
        bar_fast_newton(bar, &control,
                        line == FUSED_LEFT ? FROM_LEFT : FROM_BOTH_ENDS, u);
    return clock_seconds() - start;
}

/* Seconds an unknown an iteration: four iterations less one, so that memory
 * and the last residual do not count.  The bar ends up stretched evenly, which
 * is the answer: F at the left and at the right are compared. */
static void newton_line(enum line line, int n, struct times *t)
{
    const size_t size_n = (size_t)n + 1;
    double *b = allocate(size_n, sizeof *b), *u = allocate(size_n, sizeof *u);
    const struct bar bar = {
        n, 1.0 / n, {1, 0}, b, material_make(CUBIC, 1000.0, 0.3)};
    b[n] = 238.5;
    const double one = iterate(line, &bar, 1, u);
    const double four = iterate(line, &bar, 4, u);
    const double P = material1_pk1(&bar.material, 1.0 + u[n]);
    times_record(t, (four - one) / 3.0 / n,
                 fabs(P - b[n]) < 1e-6 && fabs(u[n / 2] - u[n] * (n / 2) / n) <
                                              1e-9);
    free(b);
    free(u);
}

static void bench_bar(void)
{
    const int sizes[] = {1000, 1000000};
    table_begin_note("bar",
                     "unknowns gsl_newton_over_fused_both "
                     "gsl_tridiagonal_over_tridiagonal_p1 "
                     "gsl_banded_over_tridiagonal_p1 fused_both fused_left "
                     "newton gsl_newton tridiagonal_p1 gsl_tridiagonal "
                     "gsl_banded spread_fused_both spread_gsl_newton",
                     "ns an unknown; fused, newton, gsl_newton: a whole "
                     "iteration, the others: a linear solve without assembly");
    for (int s = 0; s < COUNT(sizes); s++) {
        struct times t[LINES] = {{0, {0.0}}};
        double ns[LINES];
        for (int run = 0; run < (s == 0 ? RUNS : 9); run++)
            for (int k = 0; k < LINES; k++)
                if (k <= GSL_NEWTON)
                    newton_line((enum line)k, sizes[s], &t[k]);
                else
                    solve_line((enum line)k, sizes[s], &t[k]);
        for (int k = 0; k < LINES; k++) ns[k] = 1e9 * times_median(&t[k]);
        row(sizes[s], ns[GSL_NEWTON] / ns[FUSED_BOTH],
            ns[GSL_TRIDIAGONAL] / ns[TRIDIAGONAL],
            ns[GSL_BAND_1] / ns[TRIDIAGONAL], ns[FUSED_BOTH], ns[FUSED_LEFT],
            ns[NEWTON], ns[GSL_NEWTON], ns[TRIDIAGONAL], ns[GSL_TRIDIAGONAL],
            ns[GSL_BAND_1], times_spread(&t[FUSED_BOTH]),
            times_spread(&t[GSL_NEWTON]));
    }
    table_end();
}

int main(int argc, char *argv[])
{
    static struct band_times t[SIZES];

    options_parse("bench", NULL, 0, argc, argv);
    gsl_set_error_handler_off();
    bench_header();
    for (int s = 0; s < SIZES; s++) measure_band(s, &t[s]);
    print_band(t);
    bench_bar();
    return table_finish();
}
