/*
 * 03_dirichlet_correction.c - put prescribed values into A u = b and keep A
 * symmetric.
 *
 * Notes: Lecture 2, section 1.1, exercise (1).
 *
 * Problem.  Linear elements for -beta u'' = f on (0, 1), n equal elements,
 * assembled with no thought of boundary conditions: A u = b is singular.  The
 * values of u at some nodes are given.  Correct A and b afterwards
 * [eq:dirichlet-correction], solve, and find from the A and b of before what
 * force holds each prescribed node in place [eq:reaction].
 *
 *     | a00 a01  .  . | u0 |   | b0 |      | a00  0   .   . | u0 |   a00 g
 *     | a10 a11 a12 . | u1 | = | b1 |  ->  |  0  a11 a12  . | u1 | = b1 - a10 g
 *     |  .  a21  .  . | .. |   | .. |      |  .  a21  .   . | .. |   ...
 *
 * Run       make lesson-03, or with options: -h lists them
 * Expect    reactions and loads add up to 0; with the left end fixed, n = 16
 *           and beta = 1346.15: condition number 437.7 with the diagonal kept,
 *           85375 with ones on it
 * Plot: nodes x u
 */
#include "matrix.h"
#include "options.h"
#include "table.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

/* Here A is a full N x N array, A_ij = A[i * N + j], so that both triangles
 * can be seen; N = n + 1 is the number of nodes. */

/* A and b of n equal elements, constant beta and f [eq:poisson-A]. */
static void assemble(int n, double beta, double f, double A[], double b[])
{
    const int N = n + 1;
    const double h = 1.0 / n;

    for (int ij = 0; ij < N * N; ij++) A[ij] = 0.0;
    for (int i = 0; i < N; i++) b[i] = 0.0;
    for (int e = 0; e < n; e++) {
        A[e * N + e] += beta / h;
        A[e * N + e + 1] -= beta / h;
        A[(e + 1) * N + e] -= beta / h;
        A[(e + 1) * N + e + 1] += beta / h;
        b[e] += 0.5 * h * f;
        b[e + 1] += 0.5 * h * f;
    }
}

/*
 * First half of the correction: bring the known part of every equation to the
 * right-hand side, b_i -= sum_k A_ik g_k [eq:dirichlet-correction].
 *
 * A      in      N x N, not corrected yet
 * b      in/out  N
 * node   in      the n_fixed prescribed nodes k, in any order
 * g      in      their values
 */
static void move_known_values(int N, const double A[], double b[], int n_fixed,
                              const int node[], const double g[])
{
    /* SLOT 3a(N, A, b, n_fixed, node, g): subtract from every b[i] what the
     * prescribed nodes contribute to row i of A u. */
    todo("3a", N, A, b, n_fixed, node, g);
    /* END 3a */
}

/*
 * Second half: replace equation k by d u_k = d g_k, with its column cleared as
 * well, so that A stays symmetric [eq:dirichlet-correction].  The diagonal
 * entry d is the old A_kk (KEEP_DIAGONAL) or 1 (UNIT_DIAGONAL).
 */
static void replace_equations(int N, double A[], double b[], int n_fixed,
                              const int node[], const double g[],
                              enum diagonal diagonal)
{
    /* SLOT 3b(N, A, b, n_fixed, node, g, diagonal): for each prescribed node
     * clear its row and its column, then set its diagonal entry and its b. */
    todo("3b", N, A, b, n_fixed, node, g, diagonal);
    /* END 3b */
}

/*
 * r := A u - b with the A and b of *before* the correction [eq:reaction].
 * r_k is the force that holds prescribed node k; it is zero at the others.
 */
static void reactions(int N, const double A[], const double b[],
                      const double u[], double r[])
{
    /* SLOT 3c(N, A, b, u, r): fill r[0..N-1]. */
    todo("3c", N, A, b, u, r);
    /* END 3c */
}

/* u := A^{-1} b by Cholesky, which looks at the lower triangle only. */
static enum status solve(int N, const double A[], const double b[], double u[])
{
    struct matrix *L = matrix_alloc(DENSE, N, 0);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) matrix_add(L, i, j, A[i * N + j]);
        u[i] = b[i];
    }
    const enum status status = matrix_factor(L);
    if (status == OK) matrix_solve(L, u);
    matrix_free(L);
    return status;
}

/* A u = b with n_fixed prescribed nodes; A and b are corrected in place. */
static enum status solve_prescribed(int N, double A[], double b[], int n_fixed,
                                    const int node[], const double g[],
                                    enum diagonal diagonal, double u[])
{
    move_known_values(N, A, b, n_fixed, node, g);
    replace_equations(N, A, b, n_fixed, node, g, diagonal);
    return solve(N, A, b, u);
}

/* Condition number of a symmetric positive definite A [eq:condition-number]. */
static double condition_number(int N, const double A[])
{
    gsl_matrix *copy = gsl_matrix_alloc((size_t)N, (size_t)N);
    gsl_vector *eigenvalue = gsl_vector_alloc((size_t)N);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc((size_t)N);

    for (int ij = 0; ij < N * N; ij++) copy->data[ij] = A[ij];
    gsl_eigen_symm(copy, eigenvalue, work);
    const double result =
        gsl_vector_max(eigenvalue) / gsl_vector_min(eigenvalue);
    gsl_eigen_symm_free(work);
    gsl_vector_free(eigenvalue);
    gsl_matrix_free(copy);
    return result;
}

/* What the new diagonal entry does to the conditioning: left end fixed. */
static void print_condition(double beta)
{
    table_begin("condition", "n kept one");
    for (int n = 4; n <= 64; n *= 2) {
        const int N = n + 1, node[] = {0};
        const double g[] = {2.385};
        double *A = allocate((size_t)(N * N), sizeof *A);
        double *b = allocate((size_t)N, sizeof *b);
        double condition[2];

        for (int d = KEEP_DIAGONAL; d <= UNIT_DIAGONAL; d++) {
            assemble(n, beta, 0.0, A, b);
            move_known_values(N, A, b, 1, node, g);
            replace_equations(N, A, b, 1, node, g, (enum diagonal)d);
            condition[d] = condition_number(N, A);
        }
        table_row(n, condition[KEEP_DIAGONAL], condition[UNIT_DIAGONAL]);
        free(A);
        free(b);
    }
    table_end();
}

/* max_ij |A_ij - A_ji| */
static double asymmetry(int N, const double A[])
{
    double largest = 0.0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < i; j++)
            largest = fmax(largest, fabs(A[i * N + j] - A[j * N + i]));
    return largest;
}

static double max_difference(int N, const double u[], const double v[])
{
    double largest = 0.0;
    for (int i = 0; i < N; i++) largest = fmax(largest, fabs(u[i] - v[i]));
    return largest;
}

/*
 * The tempting half-way house: clear the rows, leave the columns.  The system
 * is right (LU solves it), but not symmetric, and Cholesky, which reads the
 * lower triangle only, fails or solves another problem without a word.
 */
static void print_row_only(int n, double beta, double f, int n_fixed,
                           const int node[], const double g[],
                           const double u[])
{
    const int N = n + 1;
    const size_t size = (size_t)N;
    double *A = allocate(size * size, sizeof *A);
    double *b = allocate(size, sizeof *b);
    double *v = allocate(size, sizeof *v);

    table_begin_note("row_only", "unit_diagonal asymmetry not_spd chol_error",
                     "chol_error is 0 where Cholesky fails");
    for (int unit = 0; unit <= 1; unit++) {
        assemble(n, beta, f, A, b);
        for (int k = 0; k < n_fixed; k++) {
            const double d = unit ? 1.0 : A[node[k] * N + node[k]];
            for (int j = 0; j < N; j++) A[node[k] * N + j] = 0.0;
            A[node[k] * N + node[k]] = d;
            b[node[k]] = d * g[k];
        }
        const enum status status = solve(N, A, b, v);
        table_row(unit, asymmetry(N, A), status == NOT_SPD,
                  status == OK ? max_difference(N, u, v) : 0.0);
    }
    table_end();
    free(A);
    free(b);
    free(v);
}

static void print_matrix(const char *name, int N, const double A[])
{
    table_begin(name, "i j value");
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) table_row(i, j, A[i * N + j]);
    table_end();
}

int main(int argc, char *argv[])
{
    enum { LEFT, RIGHT, BOTH, THREE };
    int n = 6, fix = THREE, diagonal = KEEP_DIAGONAL;
    double beta = 1346.153846153846; /* 2 mu + lambda for E = 1000, nu = 0.3 */
    double f = 238.5, left = 0.2385, inner = -0.137, right = 0.512;
    const struct option options[] = {
        {"n", .integer = &n, .min = 2, .max = 200, .help = "elements"},
        {"fix", .choice = &fix, .choices = "left right both three",
         .help = "prescribed nodes; three: both ends and node 2n/3"},
        {"diagonal", .choice = &diagonal, .choices = "keep one",
         .help = "diagonal entry of a replaced equation"},
        {"beta", .real = &beta, .min = 1e-6, .max = 1e9,
         .help = "coefficient"},
        {"f", .real = &f, .min = -1e9, .max = 1e9, .help = "load"},
        {"left", .real = &left, .min = -1e6, .max = 1e6, .help = "u(0)"},
        {"inner", .real = &inner, .min = -1e6, .max = 1e6,
         .help = "u at node 2n/3"},
        {"right", .real = &right, .min = -1e6, .max = 1e6, .help = "u(1)"},
    };
    options_parse("03_dirichlet_correction", options, COUNT(options), argc,
                  argv);

    const int N = n + 1;
    const int all_nodes[] = {0, 2 * n / 3, n};
    const double all_values[] = {left, inner, right};
    int n_fixed = 0, node[3];
    double g[3];
    for (int k = 0; k < 3; k++)
        if (fix == THREE || (k == 0 && fix != RIGHT) ||
            (k == 2 && fix != LEFT)) {
            node[n_fixed] = all_nodes[k];
            g[n_fixed++] = all_values[k];
        }

    const size_t size = (size_t)N;
    double *A = allocate(size * size, sizeof *A);
    double *b = allocate(size, sizeof *b);
    double *A_corrected = allocate(size * size, sizeof *A);
    double *b_corrected = allocate(size, sizeof *b);
    double *u = allocate(size, sizeof *u);
    double *r = allocate(size, sizeof *r);

    assemble(n, beta, f, A, b);
    assemble(n, beta, f, A_corrected, b_corrected);
    const enum status status =
        solve_prescribed(N, A_corrected, b_corrected, n_fixed, node, g,
                         (enum diagonal)diagonal, u);
    if (status != OK) die("the corrected matrix is %s", status_name(status));
    reactions(N, A, b, u, r);

    if (n <= 12) {
        print_matrix("A", N, A);
        print_matrix("A_corrected", N, A_corrected);
    }
    table_vector("b", N, b);
    table_vector("b_corrected", N, b_corrected);
    table_begin("nodes", "x u reaction");
    for (int i = 0; i < N; i++) table_row((double)i / n, u[i], r[i]);
    table_end();
    print_condition(beta);
    print_row_only(n, beta, f, n_fixed, node, g, u);

    free(A);
    free(b);
    free(A_corrected);
    free(b_corrected);
    free(u);
    free(r);
    return table_finish();
}
