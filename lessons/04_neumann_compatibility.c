/*
 * 04_neumann_compatibility.c - the singular system of a problem with two flux
 * conditions: when it is solvable, and how to solve it.
 *
 * Notes: Lecture 2, section 1.1, exercise (2).
 *
 * Problem.  With u given at an end, A is positive definite and A u = b has one
 * solution [eq:quadratic-form].  With a flux at both ends A is singular: only
 * for sum_i b_i = 0 is there a solution [eq:neumann-compatibility], and then
 * a whole family of them [eq:neumann-family].
 *
 *     -u'' = e^x on (0, 1),  u' n = 0 at x = 0 and -(e - 1) at x = 1
 *
 * is compatible, int f dx + q_a + q_b = 0, but with b from the midpoint rule
 * its linear system is not.  Measure that defect, remove it, solve for the
 * member of minimum norm; refuse a problem that has no solution.
 *
 *     |  k -k  .  . |
 *     | -k 2k -k  . |   every row adds up to 0: A (1,1,1,1)^T = 0, and so
 *     |  . -k 2k -k |   sum_i b_i = (1,1,1,1) A u = 0 for every u
 *     |  .  . -k  k |
 *
 * Run       make lesson-04, or with options: -h lists them
 * Expect    n = 4: rank 4 of 5, sum b = -0.0044665, u(0) = 0.2577505; the
 *           defect tends to 0 like -(e - 1) h^2 / 24
 * Plot: family x minimum_norm
 */
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

/* The scene.  n elements make N = n + 1 nodes and equations. */
static double one(double x)
{
    (void)x;
    return 1.0;
}
static double one_plus_x(double x)
{
    return 1.0 + x;
}
static double exact(double x) /* and every exact(x) + c */
{
    return x - exp(x);
}
static double exact_dx(double x)
{
    return 1.0 - exp(x);
}
static double flux_at_1(void)
{
    return -expm1(1.0); /* -(e - 1) */
}

/* A and b of -(beta u')' = f with fluxes q_a and q_b [eq:poisson-b]. */
static void assemble(int n, const double x[], field *beta, field *f, double qa,
                     double qb, const struct quadrature *rule,
                     struct matrix *A, double b[])
{
    poisson_assemble(n, x, beta, f, rule, A, b);
    b[0] += qa;
    b[n] += qb;
}

/*
 * v^T A v = sum_j beta_j (v_j - v_{j-1})^2 / h_j without A [eq:quadratic-form];
 * beta_j is beta at the middle of element j, as the midpoint rule has it.
 *
 * x, v   in   nodes and nodal values, 0..n
 */
static double quadratic_form(int n, const double x[], field *beta,
                             const double v[])
{
    double sum = 0.0;
    /* SLOT 4a(n, x, beta, v, sum): add up the elements; element j joins nodes
     * j - 1 and j, and its h_j is its own. */
    todo("4a", n, x, beta, v, sum);
    /* END 4a */
    return sum;
}

/*
 * Is A u = b solvable [eq:neumann-compatibility]?  *defect := sum_i b_i.
 *
 * OK            |defect| <= N eps sum_i |b_i|: round-off of the sum, no more
 * INCOMPATIBLE  otherwise (a NaN as well)
 */
static enum status compatibility(int N, const double b[], double *defect)
{
    double scale = 0.0;
    *defect = 0.0;
    /* SLOT 4b(N, b, defect, scale): add up b in *defect and |b| in scale, and
     * return the status; eps is DBL_EPSILON. */
    todo("4b", N, b, defect, scale);
    /* END 4b */
}

/*
 * b := the nearest right-hand side for which A u = b is solvable: its
 * orthogonal projection onto the range of A, b - (e.b / e.e) e, e = (1,..,1)^T.
 */
static void project(int N, double b[])
{
    /* SLOT 4c(N, b): take the same number from every b[i]. */
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
 * The solution of A u = b that has the smallest sum_i u_i^2, which is the one
 * with sum_i u_i = 0 [eq:neumann-family].  A, of order N = A->n, is the matrix
 * of two flux ends and is left alone.
 *
 * OK            u is the solution
 * INCOMPATIBLE  b is not in the range of A; u is not set
 * NOT_SPD       even with one node pinned A is not positive definite
 */
static enum status solve_neumann(const struct matrix *A, const double b[],
                                 double u[])
{
    const int N = A->n;
    /* SLOT 4d(N, A, b, u): refuse what has no solution; find some solution
     * with a pinned node; then move along the family. */
    todo("4d", N, A, b, u);
    /* END 4d */
}

static double call_field(double x, void *f)
{
    return (*(field **)f)(x);
}

/*
 * The defect of the problem itself, *defect := int_0^1 f dx + q_a + q_b, which
 * no mesh can cure: INCOMPATIBLE above 1e-10 of |int f dx| + |q_a| + |q_b|.
 */
static enum status continuous_compatibility(field *f, double qa, double qb,
                                            double *defect)
{
    gsl_function g = {call_field, &f};
    double load, error;
    size_t n_call;

    gsl_integration_qng(&g, 0.0, 1.0, 0.0, 1e-12, &load, &error, &n_call);
    *defect = load + qa + qb;
    return fabs(*defect) <= 1e-10 * (fabs(load) + fabs(qa) + fabs(qb))
               ? OK
               : INCOMPATIBLE;
}

struct spectrum {
    double min, max; /* eigenvalues; min is 0 where it is round-off */
    int rank;        /* how many are above N eps max */
};

/*
 * Eigenvalues of the block first..last of A, and the eigenvector of the
 * smallest one, scaled to mean 1 (vector may be NULL).
 */
static struct spectrum spectrum(const struct matrix *A, int first, int last,
                                double vector[])
{
    const size_t N = (size_t)(last - first + 1);
    gsl_matrix *M = gsl_matrix_alloc(N, N), *v = gsl_matrix_alloc(N, N);
    gsl_vector *lambda = gsl_vector_alloc(N);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(N);
    double mean = 0.0;

    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < N; j++)
            gsl_matrix_set(M, i, j,
                           matrix_get(A, first + (int)i, first + (int)j));
    gsl_eigen_symmv(M, lambda, v, work);
    gsl_eigen_symmv_sort(lambda, v, GSL_EIGEN_SORT_VAL_ASC);

    struct spectrum s = {.max = gsl_vector_get(lambda, N - 1)};
    for (size_t k = 0; k < N; k++)
        s.rank += gsl_vector_get(lambda, k) > (double)N * DBL_EPSILON * s.max;
    s.min = s.rank == (int)N ? gsl_vector_get(lambda, 0) : 0.0;
    for (size_t i = 0; i < N; i++) mean += gsl_matrix_get(v, i, 0) / (double)N;
    for (size_t i = 0; vector && i < N; i++)
        vector[i] = gsl_matrix_get(v, i, 0) / mean;
    gsl_eigen_symmv_free(work);
    gsl_vector_free(lambda);
    gsl_matrix_free(v);
    gsl_matrix_free(M);
    return s;
}

/* v^T A v of a few v, from the differences and from A, for beta = 1 + x. */
static void print_quadratic_form(int n, const double x[])
{
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    double *v = allocate((size_t)n + 1, sizeof *v);
    double *Av = allocate((size_t)n + 1, sizeof *Av);

    assemble(n, x, one_plus_x, one, 0.0, 0.0, &MIDPOINT, A, Av);
    table_begin_note("quadratic_form", "v differences matrix",
                     "v_i = 0: 1, 1: x_i, 2: (-1)^i, 3: 1 at node 0, else 0; "
                     "beta = 1 + x");
    for (int k = 0; k < 4; k++) {
        double product = 0.0;
        for (int i = 0; i <= n; i++)
            v[i] = k == 0   ? 1.0
                   : k == 1 ? x[i]
                   : k == 2 ? (i % 2 ? -1.0 : 1.0)
                            : (i == 0);
        matrix_multiply(A, v, Av);
        for (int i = 0; i <= n; i++) product += v[i] * Av[i];
        table_row(k, quadratic_form(n, x, one_plus_x, v), product);
    }
    table_end();
    matrix_free(A);
    free(v);
    free(Av);
}

/* No end, one and both ends prescribed: eigenvalues of what is left of A, and
 * what Cholesky says of the corrected matrix.  Then the null vector. */
static void print_definiteness(int n, const double x[], const struct matrix *A)
{
    const int node[] = {0, n};
    const double zero[] = {0.0, 0.0};
    double *rhs = allocate((size_t)n + 1, sizeof *rhs);
    double *null = allocate((size_t)n + 1, sizeof *null);

    table_begin_note("definiteness",
                     "fixed order lambda_min lambda_max rank not_spd",
                     "an eigenvalue below N eps lambda_max counts as 0");
    for (int fixed = 0; fixed <= 2; fixed++) {
        struct matrix *L = matrix_copy(A);
        matrix_dirichlet(L, rhs, fixed, node, zero, KEEP_DIAGONAL);
        const enum status status = matrix_factor(L);
        const struct spectrum s =
            spectrum(A, fixed > 0, n - (fixed > 1), fixed ? NULL : null);
        table_row(fixed, n + 1 - fixed, s.min, s.max, s.rank,
                  status == NOT_SPD);
        matrix_free(L);
    }
    table_end();

    table_begin("null_vector", "x value");
    for (int i = 0; i <= n; i++) table_row(x[i], null[i]);
    table_end();
    free(rhs);
    free(null);
}

/* Three members of the family, and the exact one with the same nodal mean. */
static void print_family(int n, const double x[], const double u[])
{
    const double c = 0.3, shift[] = {-c, 0.0, c};
    double *w = allocate((size_t)n + 1, sizeof *w);
    double exact_mean = 0.0;

    for (int i = 0; i <= n; i++) exact_mean += exact(x[i]) / (n + 1);
    table_begin_note("family", "x below minimum_norm above exact",
                     "below, above: c = -%g, %g", c, c);
    for (int i = 0; i <= n; i++)
        table_row(x[i], u[i] - c, u[i], u[i] + c, exact(x[i]) - exact_mean);
    table_end();

    table_begin("norms", "c energy nodal_norm integral_mean");
    for (int k = 0; k < COUNT(shift); k++) {
        double squares = 0.0, mean = 0.0;
        for (int i = 0; i <= n; i++) {
            w[i] = u[i] + shift[k];
            squares += w[i] * w[i];
            if (i > 0) mean += 0.5 * (x[i] - x[i - 1]) * (w[i - 1] + w[i]);
        }
        table_row(shift[k], quadratic_form(n, x, one, w), sqrt(squares), mean);
    }
    table_end();
    free(w);
}

struct defect {
    double sum_b;
    double leading; /* first term of the midpoint rule's error */
    enum status status;
};

/*
 * sum_i b_i on n elements, before any projection.  For the midpoint rule it is
 * about -sum_j h_j^2 (f'(x_j) - f'(x_{j-1})) / 24: -(e - 1) h^2 / 24, equal h.
 */
static struct defect defect_of(int n, double grading,
                               const struct quadrature *rule)
{
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *b = allocate((size_t)n + 1, sizeof *b);
    struct defect d = {0};

    grid_make(0.0, 1.0, n, grading, x);
    assemble(n, x, one, exp, 0.0, flux_at_1(), rule, A, b);
    d.status = compatibility(n + 1, b, &d.sum_b);
    for (int j = 1; j <= n; j++) {
        const double h = x[j] - x[j - 1];
        d.leading -= h * h * (exp(x[j]) - exp(x[j - 1])) / 24.0;
    }
    matrix_free(A);
    free(x);
    free(b);
    return d;
}

/* The defect is the error of the quadrature, so it has the order of the rule;
 * the order in a row is from half as many elements [eq:order]. */
static void print_compatibility(double grading)
{
    table_begin_note("compatibility",
                     "n h sum_b leading ratio order incompatible",
                     "midpoint rule; h = 1 / n, the mean length");
    for (int n = 4; n <= 256; n *= 2) {
        const struct defect d = defect_of(n, grading, &MIDPOINT);
        const double halved =
            defect_of(n / 2, grading, &MIDPOINT).sum_b / d.sum_b;
        table_row(n, 1.0 / n, d.sum_b, d.leading, d.sum_b / d.leading,
                  halved > 0.0 ? log2(halved) : 0.0,
                  d.status == INCOMPATIBLE);
    }
    table_end();

    table_begin("rules", "h midpoint trapezoid gauss2");
    for (int n = 4; n <= 64; n *= 2)
        table_row(1.0 / n, defect_of(n, grading, &MIDPOINT).sum_b,
                  defect_of(n, grading, &TRAPEZOID).sum_b,
                  defect_of(n, grading, &GAUSS2).sum_b);
    table_end();
}

enum { PINNED_ROWS = 6, PINNED_COLUMNS = 6 };

/*
 * What pinning a node does to a system without a solution: nothing is noticed,
 * the equation that was thrown away takes the whole defect, and u depends on
 * the node.  row[k]: excess, node, x, reaction at the node, and two energy
 * norms relative to that of u, the solution of minimum norm: of the
 * difference from u and of the error.
 */
static enum status pin(int n, const double x[], const struct matrix *A,
                       const double b[], const double u[],
                       double row[PINNED_ROWS][PINNED_COLUMNS])
{
    const int node[] = {0, n / 2, n};
    const double excess[] = {0.0, 0.1}; /* flux that no load balances */
    const size_t N = (size_t)n + 1;
    const double size = sqrt(quadratic_form(n, x, one, u));
    double *c = allocate(N, sizeof *c), *v = allocate(N, sizeof *v);
    double *Av = allocate(N, sizeof *Av);
    enum status status = OK;

    for (int k = 0; k < PINNED_ROWS && status == OK; k++) {
        const int at = node[k % 3];
        for (int i = 0; i <= n; i++) c[i] = b[i];
        c[n] += excess[k / 3];
        status = solve_pinned(A, c, at, v);
        matrix_multiply(A, v, Av);
        row[k][0] = excess[k / 3];
        row[k][1] = at;
        row[k][2] = x[at];
        row[k][3] = Av[at] - c[at];
        row[k][5] =
            poisson_errors(n, x, v, one, exact, exact_dx).energy / size;
        for (int i = 0; i <= n; i++) v[i] -= u[i];
        row[k][4] = sqrt(quadratic_form(n, x, one, v)) / size;
    }
    free(c);
    free(v);
    free(Av);
    return status;
}

int main(int argc, char *argv[])
{
    enum { NO, YES };
    int n = 4, rule = 0, projecting = YES;
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

    const int N = n + 1;
    const double qa = 0.0, qb = flux_at_1() + excess;
    double defect;
    if (continuous_compatibility(exp, qa, qb, &defect) != OK)
        die("the problem is INCOMPATIBLE: int f dx + q_a + q_b is %.6g, not 0; "
            "no mesh can cure that", defect);

    struct matrix *A = matrix_alloc(BANDED, N, 1);
    double *x = allocate((size_t)N, sizeof *x);
    double *b = allocate((size_t)N, sizeof *b);
    double *b_used = allocate((size_t)N, sizeof *b);
    double *u = allocate((size_t)N, sizeof *u);

    grid_make(0.0, 1.0, n, grading, x);
    assemble(n, x, one, exp, qa, qb, rules[rule], A, b);
    for (int i = 0; i < N; i++) b_used[i] = b[i];
    if (projecting) project(N, b_used);
    enum status status = solve_neumann(A, b_used, u);
    if (status == INCOMPATIBLE) {
        compatibility(N, b_used, &defect);
        die("the linear system is INCOMPATIBLE: sum_i b_i is %.6g, not 0%s",
            defect, projecting ? "" : "; --project yes would remove it");
    }
    double row[PINNED_ROWS][PINNED_COLUMNS];
    if (status == OK) status = pin(n, x, A, b, u, row);
    if (status != OK) die("the pinned matrix is %s", status_name(status));

    print_quadratic_form(n, x);
    print_definiteness(n, x, A);
    table_begin("load", "i b projected");
    for (int i = 0; i < N; i++) table_row(i, b[i], b_used[i]);
    table_end();
    print_family(n, x, u);
    print_compatibility(grading);
    table_begin_note("pinned", "excess node x reaction difference error",
                     "b is not projected; excess is added to the flux at 1");
    for (int k = 0; k < PINNED_ROWS; k++) table_row_of(PINNED_COLUMNS, row[k]);
    table_end();

    matrix_free(A);
    free(x);
    free(b);
    free(b_used);
    free(u);
    return table_finish();
}
