/*
 * 05_stiffness_matrix.c - the entries, the structure, the eigenvalues and the
 * price of the stiffness matrix.
 *
 * Notes: Lecture 2, section 1.1, exercise (3).
 *
 * Problem.  beta = 1, linear elements on nodes x_0 < ... < x_n, no boundary
 * condition yet.  Write A by vertices [eq:stiffness-row]; look at what it is
 * made of; compare its eigenvalues on equal elements with a formula, with no,
 * one or both ends fixed [eq:stiffness-eigenvalues]; and find what it costs to
 * keep and to factor it, dense and banded [eq:band-cost].
 *
 *     | l0 -l0   .   .  |      l_j = 1 / h_{j+1}, one for each element:
 *     |-l0 l0+l1 -l1  .  |     3n + 1 numbers are not zero, each row and
 *     |  .  -l1 l1+l2 -l2|     each column adds up to 0, and only 2n + 1
 *     |  .   .  -l2  l2  |     numbers are kept by symmetry
 *
 * Run       make lesson-05, or with options: -h lists them
 * Expect    condition number 103.087 (both ends fixed) and 437.698 (one) for
 *           n = 16; bytes grow like N^2 and N, seconds like N^3 and N
 * Plot: eigenvalues_none k exact
 */
#include "clock.h"
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sort_vector.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum ends { NONE_FIXED, ONE_FIXED, BOTH_FIXED };

/*
 * A of n elements with beta = 1 and no boundary condition, row by row
 * [eq:stiffness-row].
 *
 * x      in   nodes, x[0..n], increasing, in general not equally spaced
 * A      out  order n + 1, half bandwidth >= 1; dense or banded
 */
static void stiffness_matrix(int n, const double x[], struct matrix *A)
{
    matrix_zero(A);
    /* SLOT 5a(n, x, A): for each node j add the entries of row j with
     * matrix_add(A, j, ., .); node 0 and node n have one element only
     * [eq:stiffness-row]. */
    for (int j = 0; j <= n; j++) {
        const double left = j > 0 ? 1.0 / (x[j] - x[j - 1]) : 0.0;
        const double right = j < n ? 1.0 / (x[j + 1] - x[j]) : 0.0;
        matrix_add(A, j, j, left + right);
        if (j > 0) matrix_add(A, j, j - 1, -left);
        if (j < n) matrix_add(A, j, j + 1, -right);
    }
    /* END 5a */
}

/*
 * The k-th smallest eigenvalue, k = 1, 2, ..., of the stiffness matrix of n
 * elements of length h, rows and columns of fixed ends struck out: its order
 * is n + 1, n or n - 1 [eq:stiffness-eigenvalues].
 */
static double eigenvalue_exact(enum ends ends, int n, double h, int k)
{
    /* SLOT 5b(ends, n, h, k): return lambda = (2 / h) (1 - cos(theta)) with
     * the theta of this k; with no end fixed the smallest, k = 1, is 0
     * [eq:stiffness-eigenvalues]. */
    double theta = k * M_PI / n;
    if (ends == NONE_FIXED) theta = (k - 1) * M_PI / (n + 1);
    if (ends == ONE_FIXED) theta = (2 * k - 1) * M_PI / (2 * n + 1);
    /* 1 - cos t = 2 sin(t/2)^2, which does not cancel for small t */
    return 4.0 / h * gsl_pow_2(sin(0.5 * theta));
    /* END 5b */
}

/* What a symmetric matrix costs; real numbers, for N^3 exceeds any int. */
struct cost {
    double numbers; /* kept in storage */
    double flops;   /* of its Cholesky factorisation */
};

/*
 * Cost of order N and half bandwidth p, 0 <= p < N [eq:band-cost]; p is not
 * looked at when dense.  Numbers: what struct matrix keeps.  Flops: each
 * + - * / and square root counts one in the textbook loop
 *
 *     for k = 0 .. N-1:                           m = rows below k in the band
 *         L_kk = sqrt(A_kk)                       1 flop
 *         L_ik = A_ik / L_kk, i below k           m flops
 *         A_ij -= L_ik L_jk, i >= j below k       2 m (m + 1) / 2 flops
 */
static struct cost cholesky_cost(enum storage storage, int N, int p)
{
    struct cost cost = {0.0, 0.0};
    /* SLOT 5c(storage, N, p, cost.numbers): set cost.numbers and cost.flops,
     * exactly and not only to leading order; a real N keeps N * N from
     * overflowing [eq:band-cost]. */
    const double order = N;
    const double q = storage == DENSE ? order - 1.0 : p;
    cost.numbers = order * (q + 1.0);
    cost.flops = (order - q) * (q + 1.0) * (q + 1.0) +
                 q * (q + 1.0) * (2.0 * q + 1.0) / 6.0;
    /* END 5c */
    return cost;
}

/*
 * Eigenvalues by GSL, ascending: lambda[0..order-1] of A on n elements of
 * (0, 1), h_n / h_1 = grading, without the rows and columns of the fixed ends
 * (the left one, when one).  Returns the order, which may be 0.
 */
static int eigenvalues_gsl(enum ends ends, int n, double grading,
                           double lambda[])
{
    const int first = ends == NONE_FIXED ? 0 : 1;
    const int order = n + 1 - (int)ends;
    if (order == 0) return 0;
    const size_t size = (size_t)order;
    double *x = allocate((size_t)n + 1, sizeof *x);
    struct matrix *A = matrix_alloc(DENSE, n + 1, 0);
    gsl_matrix *free_part = gsl_matrix_alloc(size, size);
    gsl_vector_view result = gsl_vector_view_array(lambda, size);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(size);

    grid_make(0.0, 1.0, n, grading, x);
    stiffness_matrix(n, x, A);
    for (int i = 0; i < order; i++)
        for (int j = 0; j < order; j++)
            gsl_matrix_set(free_part, (size_t)i, (size_t)j,
                           matrix_get(A, first + i, first + j));
    gsl_eigen_symm(free_part, &result.vector, work);
    gsl_sort_vector(&result.vector);
    gsl_eigen_symm_free(work);
    gsl_matrix_free(free_part);
    matrix_free(A);
    free(x);
    return order;
}

/* ---- entries and structure ---------------------------------------------- */

/* The rows of A as a vertex sees them: left neighbour, itself, right one. */
static void print_rows(const char *name, int n, double grading)
{
    const int N = n + 1;
    double *x = allocate((size_t)N, sizeof *x);
    struct matrix *A = matrix_alloc(BANDED, N, 1);

    grid_make(0.0, 1.0, n, grading, x);
    stiffness_matrix(n, x, A);
    table_begin(name, "j x left diagonal right sum");
    for (int j = 0; j < N; j++) {
        const double left = j > 0 ? matrix_get(A, j, j - 1) : 0.0;
        const double right = j < n ? matrix_get(A, j, j + 1) : 0.0;
        const double diagonal = matrix_get(A, j, j);
        table_row(j, x[j], left, diagonal, right, left + diagonal + right);
    }
    table_end();
    matrix_free(A);
    free(x);
}

/* Counted in the full array, so that nothing is taken for granted. */
static void print_structure(double grading)
{
    table_begin_note("structure",
                     "n entries nonzeros half_bandwidth asymmetry row_sum",
                     "asymmetry and row_sum: of the largest entry");
    for (int n = 1; n <= 256; n *= 2) {
        const int N = n + 1;
        double *x = allocate((size_t)N, sizeof *x);
        struct matrix *A = matrix_alloc(DENSE, N, 0);
        int nonzeros = 0, half_bandwidth = 0;
        double largest = 0.0, asymmetry = 0.0, row_sum = 0.0;

        grid_make(0.0, 1.0, n, grading, x);
        stiffness_matrix(n, x, A);
        for (int i = 0; i < N; i++) {
            double sum = 0.0;
            for (int j = 0; j < N; j++) {
                const double a = matrix_get(A, i, j);
                sum += a;
                largest = fmax(largest, fabs(a));
                asymmetry = fmax(asymmetry, fabs(a - matrix_get(A, j, i)));
                if (a == 0.0) continue;
                nonzeros++;
                if (abs(i - j) > half_bandwidth) half_bandwidth = abs(i - j);
            }
            row_sum = fmax(row_sum, fabs(sum));
        }
        if (largest == 0.0) largest = 1.0; /* A is all zeros */
        table_row(n, (double)N * N, nonzeros, half_bandwidth,
                  asymmetry / largest, row_sum / largest);
        matrix_free(A);
        free(x);
    }
    table_end();
}

/* ---- eigenvalues -------------------------------------------------------- */

/*
 * Formula and GSL on n equal elements.  A / h is the second difference, so h
 * times the eigenvalues of -u'' with the same ends is what the low ones are
 * near to: (k pi)^2 where both are fixed.
 */
static void print_eigenvalues(const char *name, enum ends ends, int n)
{
    const double h = 1.0 / n;
    const double shift = 0.5 * (int)ends - 1.0; /* -1, -1/2, 0 */
    double *lambda = allocate((size_t)n + 1, sizeof *lambda);
    const int order = eigenvalues_gsl(ends, n, 1.0, lambda);

    table_begin_note(name, "k exact gsl continuum",
                     "continuum: h times the eigenvalue of -u''");
    for (int k = 1; k <= order; k++)
        table_row(k, eigenvalue_exact(ends, n, h, k), lambda[k - 1],
                  h * gsl_pow_2((k + shift) * M_PI));
    table_end();
    free(lambda);
}

/* Condition number [eq:condition-number] of n elements. */
static double condition_number(enum ends ends, int n, double grading)
{
    double *lambda = allocate((size_t)n + 1, sizeof *lambda);
    const int order = eigenvalues_gsl(ends, n, grading, lambda);
    const double result = lambda[order - 1] / lambda[0];
    free(lambda);
    return result;
}

/* By GSL; the leading terms are 4 n^2 / pi^2 and 16 n^2 / pi^2. */
static void print_condition(double grading)
{
    table_begin_note("condition",
                     "n both both_leading one one_leading both_graded "
                     "one_graded",
                     "graded: h_n / h_1 = %g", grading);
    for (int n = 4; n <= 64; n *= 2) {
        const double leading = 4.0 * n * n / (M_PI * M_PI);
        table_row(n, condition_number(BOTH_FIXED, n, 1.0), leading,
                  condition_number(ONE_FIXED, n, 1.0), 4.0 * leading,
                  condition_number(BOTH_FIXED, n, grading),
                  condition_number(ONE_FIXED, n, grading));
    }
    table_end();
}

/* ---- what it costs ------------------------------------------------------ */

/* The exponent p of y ~ N^p between two sizes. */
static double growth(double N1, double y1, double N2, double y2)
{
    return log(y2 / y1) / log(N2 / N1);
}

/*
 * Counts, the same on every machine, and their exponents over the last factor
 * 4.  p = 1, the line, is our matrix; p = sqrt(N) is what a square grid of N
 * nodes in the plane has.
 */
static void print_costs(void)
{
    const char *const names = "N dense_bytes line_bytes plane_bytes "
                              "dense_flops line_flops plane_flops";
    double row[7] = {0}, before[7] = {0};

    table_begin_note("costs", names, "line: p = 1; plane: p = sqrt(N)");
    for (int N = 16, side = 4; side <= 512; N *= 4, side *= 2) {
        const struct cost cost[] = {cholesky_cost(DENSE, N, 0),
                                    cholesky_cost(BANDED, N, 1),
                                    cholesky_cost(BANDED, N, side)};
        memcpy(before, row, sizeof before);
        row[0] = N;
        for (int c = 0; c < 3; c++) {
            row[1 + c] = sizeof(double) * cost[c].numbers;
            row[4 + c] = cost[c].flops;
        }
        table_row_of(7, row);
    }
    table_end();

    table_begin_note("growth", names, "exponents; due: 1 2 1 1.5 3 1 2");
    for (int c = 6; c >= 0; c--)
        row[c] = growth(before[0], before[c], row[0], row[c]);
    table_row_of(7, row);
    table_end();
}

struct timing {
    enum status status; /* OK, NOT_SPD, or NONFINITE: no valid answer */
    double N, bytes, flops;
    double seconds;  /* factor and solve, the best of the repeats */
    double residual; /* backward error |b - A u| / (|A| |u|), in eps */
    double error;    /* max_j |u_j - u(x_j)|; exact but for round-off */
};

/*
 * -u'' = 1, u = 0 at both ends, on N nodes: the same problem in either
 * storage.  A time belongs to a valid answer only: a backward error of at
 * most 16 eps, however large the condition number.
 */
static struct timing time_solve(enum storage storage, int N)
{
    const int n = N - 1, ends[] = {0, n};
    const double zero[] = {0.0, 0.0};
    struct timing t = {OK, N, 0.0, cholesky_cost(storage, N, 1).flops,
                       HUGE_VAL, 0.0, 0.0};
    struct matrix *A = matrix_alloc(storage, N, 1);
    double *x = allocate((size_t)N, sizeof *x);
    double *b = allocate((size_t)N, sizeof *b);
    double *u = allocate((size_t)N, sizeof *u);

    grid_make(0.0, 1.0, n, 1.0, x);
    stiffness_matrix(n, x, A);
    for (int j = 0; j < N; j++) b[j] = 1.0 / n;
    matrix_dirichlet(A, b, 2, ends, zero, KEEP_DIAGONAL);
    t.bytes = (double)matrix_bytes(A);

    const double begin = clock_seconds();
    for (int repeat = 0;
         t.status == OK && (repeat < 3 || (repeat < 100 &&
                                           clock_seconds() - begin < 1e-3));
         repeat++) {
        struct matrix *L = matrix_copy(A);
        for (int j = 0; j < N; j++) u[j] = b[j];
        const double start = clock_seconds();
        t.status = matrix_factor(L);
        if (t.status == OK) matrix_solve(L, u);
        t.seconds = fmin(t.seconds, clock_seconds() - start);
        matrix_free(L);
    }
    for (int j = 0; j < N; j++)
        t.error = fmax(t.error, fabs(u[j] - 0.5 * x[j] * (1.0 - x[j])));
    t.residual = matrix_residual(A, u, b) / (4.0 * n * 0.125) / DBL_EPSILON;
    if (t.status == OK && !(t.residual <= 16.0)) t.status = NONFINITE;
    matrix_free(A);
    free(x);
    free(b);
    free(u);
    return t;
}

enum { MAX_TIMES = 20 };

/* N = 16, 32, ... while the next is likely to end within the budget; at least
 * three.  Returns how many have a time. */
static int time_series(enum storage storage, double budget,
                       struct timing t[MAX_TIMES])
{
    const double factor = storage == DENSE ? 8.0 : 2.0;
    const int largest = storage == DENSE ? 4096 : 1 << 20;
    const double begin = clock_seconds();
    double last = 0.0;
    int m = 0;

    for (int N = 16; N <= largest; N *= 2) {
        const double start = clock_seconds();
        if (m >= 3 && start - begin + factor * last > budget) break;
        t[m] = time_solve(storage, N);
        if (t[m].status != OK) break;
        m++;
        last = clock_seconds() - start;
    }
    return m;
}

/* Seconds, this machine's.  Returns the exponent over the last factor 4. */
static double print_times(const char *name, enum storage storage,
                          double budget)
{
    struct timing t[MAX_TIMES];
    char machine[256];
    const int m = time_series(storage, budget, t);

    clock_machine(sizeof machine, machine);
    table_begin_note(name, "N bytes flops seconds residual error",
                     "machine: %s", machine);
    for (int i = 0; i < m; i++)
        table_row(t[i].N, t[i].bytes, t[i].flops, t[i].seconds, t[i].residual,
                  t[i].error);
    table_end();
    return m < 3 ? 0.0
                 : growth(t[m - 3].N, t[m - 3].seconds, t[m - 1].N,
                          t[m - 1].seconds);
}

int main(int argc, char *argv[])
{
    int n = 12;
    double grading = 4.0, budget = 0.6;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 200, .help = "elements"},
        {"grading", .real = &grading, .min = 1e-3, .max = 1e3,
         .help = "length of the last element over the first"},
        {"budget", .real = &budget, .min = 1e-3, .max = 60, .unit = "s",
         .help = "time for the tables of seconds"},
    };
    options_parse("05_stiffness_matrix", options, COUNT(options), argc, argv);

    print_rows("rows_equal", n, 1.0);
    print_rows("rows_graded", n, grading);
    print_structure(grading);
    print_eigenvalues("eigenvalues_none", NONE_FIXED, n);
    print_eigenvalues("eigenvalues_one", ONE_FIXED, n);
    if (n > 1) print_eigenvalues("eigenvalues_both", BOTH_FIXED, n);
    print_condition(grading);
    print_costs();
    const double dense = print_times("times_dense", DENSE, 0.6 * budget);
    const double banded = print_times("times_banded", BANDED, 0.4 * budget);
    table_begin_note("growth_seconds", "dense banded",
                     "exponents of N; due: 3 1");
    table_row(dense, banded);
    table_end();
    return table_finish();
}
