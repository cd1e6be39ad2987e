/*
 * 03_dirichlet_correction.c - put prescribed values into A u = b and keep A
 * symmetric.
 *
 * Notes: Lecture 2, section 1.1, exercise (1).
 *
 * Problem.  Linear elements for -beta u'' = f on (0, 1), n equal elements,
 * assembled without boundary conditions: A u = b is singular.  The values of u
 * at some nodes are given.  Correct A and b [alg:prescribed], solve,
 * and find what force holds each prescribed node in place [eq:reaction].
 *
 *     | a00 a01  .  . | u0 |   | b0 |      what becomes of both where u0 = g
 *     | a10 a11 a12 . | u1 | = | b1 |      is given, and A has to stay
 *     |  .  a21  .  . | .. |   | .. |      symmetric?
 *
 * Run       make lesson-03; make lesson-03 ARGS=-h lists its options
 * PREDICT 1 sum of the reactions under a load of 238.5: ...
 * PREDICT 2a condition number, 64 elements, left end, diagonal kept: ...
 * PREDICT 2b and with 1 on the diagonal: ...
 * Plot: nodes x u
 */
#include "bar/poisson.h"
#include "base/options.h"
#include "base/table.h"

#include <stdlib.h>

/* A and b of n equal elements, constant beta and f [eq:poisson-A].  Here A is a
 * full N x N array, A_ij = A[i * N + j], N = n + 1, to show both triangles. */
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
 * First half of the correction: change b to that of the equations that are
 * left, in which the prescribed values are known.
 *
 * A        in      N x N, not corrected yet
 * b        in/out  N
 * node, g  in      the n_fixed prescribed nodes, in any order; their values
 */
static void move_known_values(int N, const double A[], double b[], int n_fixed,
                              const int node[], const double g[])
{
    /* SLOT 3a(N, A, b, n_fixed, node, g): given A and g, change b; what becomes
     * of it at the prescribed nodes themselves does not matter. */
    /* b := b - sum_k g_k (column k of A) */
    for (int k = 0; k < n_fixed; k++)
        for (int i = 0; i < N; i++) b[i] -= A[i * N + node[k]] * g[k];
    /* END 3a */
}

/*
 * Second half: replace equation k by d u_k = d g_k so that A stays symmetric,
 * where d is the old A_kk (KEEP_DIAGONAL) or 1 (UNIT_DIAGONAL).
 */
static void replace_equations(int N, double A[], double b[], int n_fixed,
                              const int node[], const double g[],
                              enum diagonal diagonal)
{
    /* SLOT 3b(N, A, b, n_fixed, node, g, diagonal): given A and b as 3a left
     * them, change A, and b at the prescribed nodes. */
    for (int f = 0; f < n_fixed; f++) {
        const int k = node[f];
        /* A_kk is read before its row and its column are cleared */
        const double d = diagonal == KEEP_DIAGONAL ? A[k * N + k] : 1.0;
        for (int i = 0; i < N; i++) A[i * N + k] = A[k * N + i] = 0.0;
        A[k * N + k] = d;
        b[k] = d * g[f];
    }
    /* END 3b */
}

/*
 * Given the solution u, and A and b from before the correction, r_k := the
 * force that holds prescribed node k [eq:reaction], and the same expression at
 * the other nodes.
 */
static void reactions(int N, const double A[], const double b[],
                      const double u[], double r[])
{
    /* SLOT 3c(N, A, b, u, r): given A, b and u, fill r[0..N-1]. */
    /* r = A u - b, which is 0 in each equation that u solves */
    for (int i = 0; i < N; i++) {
        r[i] = -b[i];
        for (int j = 0; j < N; j++) r[i] += A[i * N + j] * u[j];
    }
    /* END 3c */
}

/* A u = b with n_fixed prescribed nodes; A and b are corrected in place.
 * Cholesky looks at A's lower triangle only.  Parameters: as in 3b, and u. */
static enum status solve_prescribed(int N, double A[], double b[], int n_fixed,
                                    const int node[], const double g[],
                                    enum diagonal diagonal, double u[])
{
    move_known_values(N, A, b, n_fixed, node, g);
    replace_equations(N, A, b, n_fixed, node, g, diagonal);

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

static void print_matrix(const char *name, int N, const double A[])
{
    table_begin(name, "i j value");
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) table_row(i, j, A[i * N + j]);
    table_end();
}

/* u and the reactions; A and b are those before the correction. */
static void print_nodes(int N, const double A[], const double b[],
                        const double u[])
{
    double *r = allocate((size_t)N, sizeof *r);
    reactions(N, A, b, u, r);
    table_begin("nodes", "x u reaction");
    for (int i = 0; i < N; i++) table_row((double)i / (N - 1), u[i], r[i]);
    table_end();
    free(r);
}

enum { LEFT, RIGHT, BOTH, THREE };

/* Of the nodes 0, 2n/3 and n and their values g, keep those that --fix names;
 * returns how many they are. */
static int prescribe(int fix, int node[3], double g[3])
{
    const int wanted[3] = {fix != RIGHT, fix == THREE, fix != LEFT};
    int n_fixed = 0;
    for (int k = 0; k < 3; k++) {
        if (!wanted[k]) continue;
        node[n_fixed] = node[k];
        g[n_fixed++] = g[k];
    }
    return n_fixed;
}

int main(int argc, char *argv[])
{
    int n = 6, fix = THREE, diagonal = KEEP_DIAGONAL;
    double beta = 1346.153846153846; /* 2 mu + lambda for E = 1000, nu = 0.3 */
    struct poisson_held held = POISSON_HELD;
    const struct option options[] = {
        {"n", .integer = &n, .min = 2, .max = 200, .help = "elements"},
        {"fix", .choice = &fix, .choices = "left right both three",
         .help = "prescribed nodes; three: both ends and node 2n/3"},
        {"diagonal", .choice = &diagonal, .choices = "keep one",
         .help = "diagonal entry of a replaced equation"},
        {"beta", .real = &beta, .min = 1e-6, .max = 1e9, .help = "coefficient"},
        {"f", .real = &held.f, .min = -1e9, .max = 1e9, .help = "load"},
        {"left", .real = &held.g[0], .min = -1e6, .max = 1e6, .help = "u(0)"},
        {"inner", .real = &held.g[1], .min = -1e6, .max = 1e6,
         .help = "u at node 2n/3"},
        {"right", .real = &held.g[2], .min = -1e6, .max = 1e6, .help = "u(1)"},
    };
    options_parse("03_dirichlet_correction", options, COUNT(options), argc,
                  argv);

    int node[3] = {0, 2 * n / 3, n};
    const int n_fixed = prescribe(fix, node, held.g), N = n + 1;
    const size_t size = (size_t)N;
    double *A = allocate(size * size, sizeof *A);
    double *b = allocate(size, sizeof *b);
    double *corrected = allocate(size * size, sizeof *corrected);
    double *b_corrected = allocate(size, sizeof *b_corrected);
    double *u = allocate(size, sizeof *u);

    assemble(n, beta, held.f, A, b);
    assemble(n, beta, held.f, corrected, b_corrected);
    if (n <= 12) print_matrix("A", N, A);
    table_vector("b", N, b);
    const enum status status =
        solve_prescribed(N, corrected, b_corrected, n_fixed, node, held.g,
                         (enum diagonal)diagonal, u);
    if (n <= 12) print_matrix("A_corrected", N, corrected);
    table_vector("b_corrected", N, b_corrected);
    if (status != OK) die("the corrected matrix is %s", status_name(status));
    print_nodes(N, A, b, u);
    free(A);
    free(b);
    free(corrected);
    free(b_corrected);
    free(u);
    return table_finish();
}
