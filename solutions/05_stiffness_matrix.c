/*
 * 05_stiffness_matrix.c - the entries, the eigenvalues and the price of the
 * stiffness matrix.
 *
 * Notes: Lecture 2, section 1.1, exercise (3).
 *
 * Problem.  beta = 1, linear elements on nodes x_0 < ... < x_n, no boundary
 * condition yet.  Write A by vertices [eq:stiffness-row]; compare its
 * eigenvalues on equal elements with a formula, with no, one or both ends fixed
 * [eq:stiffness-eigenvalues]; and count what a matrix costs to keep and to
 * factor, dense and banded [eq:band-cost].
 *
 *           h_1          h_2            h_n
 *     x_0 -------- x_1 ------ x_2 - ... ---- x_n      row j of A: vertex j
 *
 * Run       make lesson-05; make lesson-05 ARGS=-h lists its options
 * PREDICT 1 numbers that a dense matrix of order 65536 keeps: ...
 * PREDICT 2a condition number of 64 elements, both ends fixed: ...
 * PREDICT 2b and one end fixed: ...
 * PREDICT 3 times the flops, p = sqrt N, for four times the unknowns: ...
 * Plot: eigenvalues_none k exact
 */
#include "base/options.h"
#include "bar/poisson.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

enum ends { NONE_FIXED, ONE_FIXED, BOTH_FIXED };

/*
 * A of n elements with beta = 1 and no boundary condition, row by row.
 *
 * x      in   nodes, x[0..n], increasing, in general not equally spaced
 * A      out  order n + 1, half bandwidth >= 1; dense or banded
 */
static void stiffness_matrix(int n, const double x[], struct matrix *A)
{
    matrix_zero(A);
    /* SLOT 5a(n, x, A): given the nodes, add the entries of row j with
     * matrix_add(A, j, ., .), for each node j; node 0 and node n have one
     * element only. */
    for (int j = 0; j <= n; j++) {
        const double left = j > 0 ? 1.0 / (x[j] - x[j - 1]) : 0.0;
        const double right = j < n ? 1.0 / (x[j + 1] - x[j]) : 0.0;
        /* each row adds up to 0: A maps a constant, which has no slope, to 0 */
        matrix_add(A, j, j, left + right);
        if (j > 0) matrix_add(A, j, j - 1, -left);
        if (j < n) matrix_add(A, j, j + 1, -right);
    }
    /* END 5a */
}

/*
 * The k-th smallest eigenvalue, k = 1, 2, ..., of the stiffness matrix of n
 * elements of length h, rows and columns of fixed ends struck out: its order
 * is n + 1, n or n - 1.
 */
static double eigenvalue_exact(enum ends ends, int n, double h, int k)
{
    /* SLOT 5b(ends, n, h, k): given which ends are fixed, n and h, return the
     * eigenvalue of this k; with no end fixed the smallest, k = 1, is 0. */
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
 * Cost of order N and half bandwidth p, 0 <= p < N, which is not looked at when
 * dense.  Numbers: what struct matrix keeps.  Flops: each
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
    /* SLOT 5c(storage, N, p, cost.numbers): given N and p, set cost.numbers and
     * cost.flops, exactly and not only to leading order; a real N keeps N * N
     * from overflowing. */
    const double order = N;
    const double q = storage == DENSE ? order - 1.0 : p;
    cost.numbers = order * (q + 1.0);
    /* a column costs 1 + m + m (m + 1) = (m + 1)^2: order - q of them
     * with m = q, and then m = q - 1, ..., 0 */
    cost.flops = (order - q) * (q + 1.0) * (q + 1.0) +
                 q * (q + 1.0) * (2.0 * q + 1.0) / 6.0;
    /* END 5c */
    return cost;
}

/* The rows of A as a vertex sees them: left neighbour, itself, right one. */
static void print_rows(const char *name, int n, double grading)
{
    const int N = n + 1;
    double *x = allocate((size_t)N, sizeof *x);
    struct matrix *A = matrix_alloc(BANDED, N, 1);

    poisson_grid(0.0, 1.0, n, grading, x);
    stiffness_matrix(n, x, A);
    table_begin(name, "j x left diagonal right sum");
    for (int j = 0; j < N; j++) {
        const double left = j > 0 ? matrix_get(A, j, j - 1) : 0.0;
        const double right = j < n ? matrix_get(A, j, j + 1) : 0.0;
        const double diagonal = matrix_get(A, j, j);
        table_row(j, x[j], cell_if(j > 0, left), diagonal,
                  cell_if(j < n, right), left + diagonal + right);
    }
    table_end();
    matrix_free(A);
    free(x);
}

/*
 * Formula and GSL on n equal elements, rows and columns of the fixed ends (the
 * left one, when one) struck out.  A / h is the second difference, so the low
 * ones are near h times the eigenvalues of -u'' with the same ends, which are
 * (k pi)^2 where both are fixed.
 */
static void print_eigenvalues(const char *name, enum ends ends, int n)
{
    const int order = n + 1 - (int)ends;
    const double h = 1.0 / n;
    const double shift = 0.5 * (int)ends - 1.0; /* -1, -1/2, 0 */
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *lambda = allocate((size_t)n + 1, sizeof *lambda);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    stiffness_matrix(n, x, A);
    struct matrix *free_part = matrix_block(A, ends != NONE_FIXED, order);
    const enum status status = matrix_eigenvalues(free_part, lambda);
    if (status != OK) die("the eigenvalues are %s", status_name(status));
    table_begin_note(name, "k exact gsl continuum",
                     "continuum: h times the eigenvalue of -u''");
    for (int k = 1; k <= order; k++)
        table_row(k, eigenvalue_exact(ends, n, h, k), lambda[k - 1],
                  h * gsl_pow_2((k + shift) * M_PI));
    table_end();
    matrix_free(free_part);
    matrix_free(A);
    free(lambda);
    free(x);
}

int main(int argc, char *argv[])
{
    int n = 12, unknowns = 65536;
    double grading = 4.0;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 200, .help = "elements"},
        {"grading", .real = &grading, .min = 1e-3, .max = 1e3,
         .help = "length of the last element over the first"},
        {"unknowns", .integer = &unknowns, .min = 4, .max = 1e9,
         .help = "order of the matrices in table cost"},
    };
    options_parse("05_stiffness_matrix", options, COUNT(options), argc, argv);

    print_rows("rows_equal", n, 1.0);
    print_rows("rows_graded", n, grading);
    print_eigenvalues("eigenvalues_none", NONE_FIXED, n);
    print_eigenvalues("eigenvalues_one", ONE_FIXED, n);
    if (n > 1) print_eigenvalues("eigenvalues_both", BOTH_FIXED, n);

    const int side = (int)sqrt(unknowns);
    const struct cost dense = cholesky_cost(DENSE, unknowns, 0);
    const struct cost line = cholesky_cost(BANDED, unknowns, 1);
    const struct cost plane = cholesky_cost(BANDED, unknowns, side);
    table_begin_note("cost", "matrix half_bandwidth numbers flops",
                     "order %d; plane: a square grid of so many nodes",
                     unknowns);
    table_row("dense", MISSING, dense.numbers, dense.flops);
    table_row("line", 1, line.numbers, line.flops);
    table_row("plane", side, plane.numbers, plane.flops);
    table_end();
    return table_finish();
}
