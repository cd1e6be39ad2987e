/*
 * 04_neumann_compatibility.c - two flux ends: when the singular system is
 * solvable, and how to solve it.
 *
 * Notes: Lecture 2, section 1.1, exercise (2).
 *
 * Problem.  -u'' = e^x on (0, 1) with flux u' n = 0 at x = 0 and -(e - 1) at
 * x = 1 has solutions.  But A is singular, and with b from a quadrature rule
 * A u = b has none [eq:neumann-compatibility].  Measure that defect, remove it,
 * solve for the member of least norm of the family [eq:neumann-family], and
 * refuse a problem that has no solution.
 *
 *     |  k -k  .  . |
 *     | -k 2k -k  . |   every row adds up to 0: A (1,1,1,1)^T = 0.  What does
 *     |  . -k 2k -k |   that say about b?
 *     |  .  . -k  k |
 *
 * Run       make lesson-04; make lesson-04 ARGS=-h lists its options
 * PREDICT 1 defect with 4 elements, midpoint rule: ...
 * PREDICT 2a with 8 elements it is smaller by the factor: ...
 * PREDICT 2b and by two-point Gauss: ...
 * Plot: nodes x u
 */
#include "base/options.h"
#include "bar/poisson.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/*
 * v^T A v without A, with beta from the middle of each element, as in the
 * midpoint rule.
 *
 * x, v   in   nodes and nodal values, 0..n
 */
static double quadratic_form(int n, const double x[], field *beta,
                             const double v[])
{
    double sum = 0.0;
    /* SLOT 4a(n, x, beta, v, sum): given the nodes, beta and v, add up the
     * elements; element j joins nodes j - 1 and j, and its h_j is its own. */
    todo("4a", n, x, beta, v, sum);
    /* END 4a */
    return sum;
}

/*
 * Is A u = b solvable?  *defect := the number that is 0 if it is.
 *
 * OK            |defect| <= N eps scale: no more than the round-off of a sum;
 *               scale is the same sum of absolute values
 * INCOMPATIBLE  otherwise (a NaN as well)
 */
static enum status compatibility(int N, const double b[], double *defect)
{
    double scale = 0.0;
    *defect = 0.0;
    /* SLOT 4b(N, b, defect, scale): given b, set *defect and scale, and return
     * the status; eps is DBL_EPSILON. */
    todo("4b", N, b, defect, scale);
    /* END 4b */
}

/*
 * b := the nearest right-hand side for which A u = b is solvable: its
 * orthogonal projection onto the range of A.
 */
static void project(int N, double b[])
{
    /* SLOT 4c(N, b): given b, replace it by its projection. */
    todo("4c", N, b);
    /* END 4c */
}

/* Solve A u = b with equation k replaced by u_k = 0 (lesson 03). */
static enum status solve_pinned(const struct matrix *A, const double b[],
                                int k, double u[])
{
    struct matrix *L = matrix_copy(A);
    const double zero = 0.0;

    for (int i = 0; i < A->n; i++) u[i] = b[i];
    matrix_dirichlet(L, u, 1, &k, &zero, KEEP_DIAGONAL);
    const enum status status = matrix_factor(L);
    if (status == OK) matrix_solve(L, u);
    matrix_free(L);
    return status;
}

/*
 * The solution of A u = b that has the smallest sum_i u_i^2.  A, of order
 * N = A->n, is the matrix of two flux ends and is left alone.
 *
 * OK            u is the solution
 * INCOMPATIBLE  b is not in the range of A; u stays as it is
 * NOT_SPD       even with one node pinned A is not positive definite
 */
static enum status solve_neumann(const struct matrix *A, const double b[],
                                 double u[])
{
    const int N = A->n;
    /* SLOT 4d(N, A, b, u, solve_pinned): given A and b, refuse what has no
     * solution; find some solution with a pinned node; then move along the
     * family. */
    todo("4d", N, A, b, u, solve_pinned);
    /* END 4d */
}

/* u and the exact solution x - e^x + c that has nodal mean 0, too. */
static void print_nodes(int n, const double x[], const double u[])
{
    double mean = 0.0;
    for (int i = 0; i <= n; i++) mean += (x[i] - exp(x[i])) / (n + 1);
    table_begin("nodes", "x u exact");
    for (int i = 0; i <= n; i++)
        table_row(x[i], u[i], x[i] - exp(x[i]) - mean);
    table_end();
}

/* v^T A v of four v, from the differences and from A, for beta = 1 + x. */
static void print_quadratic_form(int n, const double x[])
{
    const char *const name[] = {"constant", "linear", "alternating", "end_hat"};
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    double *v = allocate((size_t)n + 1, sizeof *v);
    double *Av = allocate((size_t)n + 1, sizeof *Av);

    poisson_assemble(n, x, bvp_beta, field_one, &MIDPOINT, A, Av);
    table_begin_note("quadratic_form", "v differences matrix",
                     "v_i = 1, x_i, (-1)^i, 1 at node 0 only; beta = 1 + x");
    for (int k = 0; k < COUNT(name); k++) {
        double product = 0.0;
        for (int i = 0; i <= n; i++) {
            const double value[] = {1.0, x[i], i % 2 ? -1.0 : 1.0, i == 0};
            v[i] = value[k];
        }
        matrix_multiply(A, v, Av);
        for (int i = 0; i <= n; i++) product += v[i] * Av[i];
        table_row(name[k], quadratic_form(n, x, bvp_beta, v), product);
    }
    table_end();
    matrix_free(A);
    free(v);
    free(Av);
}

/* b as assembled and c as used, and whether they are compatible. */
static void print_loads(int N, const double b[], const double c[])
{
    double defect;
    table_begin("load", "i b projected");
    for (int i = 0; i < N; i++) table_row(i, b[i], c[i]);
    table_end();
    table_begin("compatibility", "load sum_b status");
    enum status status = compatibility(N, b, &defect);
    table_row("assembled", defect, status_name(status));
    status = compatibility(N, c, &defect);
    table_row("used", defect, status_name(status));
    table_end();
}

/* The solution of A u = c, or the reason why there is none. */
static void print_solution(const struct matrix *A, const double c[],
                           int projecting, const double x[])
{
    double *u = allocate((size_t)A->n, sizeof *u), defect;
    const enum status status = solve_neumann(A, c, u);
    compatibility(A->n, c, &defect);
    if (status == INCOMPATIBLE)
        die("the linear system is INCOMPATIBLE: sum_i b_i is %.6g, not 0%s",
            defect, projecting ? "" : "; --project yes would remove it");
    if (status != OK) die("the pinned matrix is %s", status_name(status));
    print_nodes(A->n - 1, x, u);
    free(u);
}

int main(int argc, char *argv[])
{
    int n = 4, rule = 0, projecting = 1;
    const struct quadrature *const rules[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    double grading = 1.0, excess = 0.0;
    const struct option options[] = {
        {"n", .integer = &n, .min = 2, .max = 300, .help = "elements"},
        {"grading", .real = &grading, .min = 1e-3, .max = 1e3,
         .help = "length of the last element over that of the first"},
        {"rule", .choice = &rule, .choices = "midpoint trapezoid gauss2",
         .help = "quadrature for the load"},
        {"project", .choice = &projecting, .choices = "no yes",
         .help = "make b compatible before solving"},
        {"excess", .real = &excess, .min = -1e6, .max = 1e6,
         .help = "added to the flux at x = 1"},
    };
    options_parse("04_neumann_compatibility", options, COUNT(options), argc,
                  argv);

    /* int f dx and the flux at x = 1; the flux at x = 0 is 0 */
    const double load = expm1(1.0), flux = -load + excess;
    const int N = n + 1;
    struct matrix *A = matrix_alloc(BANDED, N, 1);
    double *x = allocate((size_t)N, sizeof *x);
    double *b = allocate((size_t)N, sizeof *b);
    double *c = allocate((size_t)N, sizeof *c);

    poisson_grid(0.0, 1.0, n, grading, x);
    poisson_assemble(n, x, field_one, exp, rules[rule], A, b);
    b[n] += flux;
    print_quadratic_form(n, x);
    for (int i = 0; i < N; i++) c[i] = b[i];
    if (projecting) project(N, c);
    print_loads(N, b, c);

    if (!(fabs(load + flux) <= 1e-10 * load))
        die("the problem is INCOMPATIBLE: int f dx + q_a + q_b is %.6g, not 0; "
            "no mesh can cure that", load + flux);
    print_solution(A, c, projecting, x);
    matrix_free(A);
    free(x);
    free(b);
    free(c);
    return table_finish();
}
