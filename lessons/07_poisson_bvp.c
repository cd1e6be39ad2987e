/*
 * 07_poisson_bvp.c - solve a boundary value problem and measure its error.
 *
 * Notes: Lecture 2, section 1.1, exercise (5).
 *
 * Problem.  Linear elements for [eq:poisson-bvp]
 *
 *     -((1+x) u')' = (1+x)^-2 in (0, 1),   u(0) = 1,   2 u'(1) = -1/2,
 *
 * whose solution is u = 2 - 1/(1+x) - ln(1+x).  How large is the error, where,
 * and how does it fall with h [eq:order]?  At the nodes, between them
 * [eq:norm-L2], in the slope [eq:norm-energy], and in the reaction at x = 0
 * [eq:reaction].  The nodes are the wrong place to look: the companion problem
 *
 *     -u'' = (1+x)^-2 in (0, 1),   u(0) = 1,   u'(1) = -1/2,
 *
 * with solution u = 1 + ln(1+x) - x, has the nodal error of the quadrature
 * [eq:quadrature-b] and of nothing else: order 2, order 4, or none at all.
 *
 * Run       make lesson-07, or with options: -h lists them
 * Expect    orders 2 (nodal), 2 (L2), 1 (energy) with constants
 *           1/144 + ln(2)/96 = 0.01416, 0.03176 and sqrt(7)/24 = 0.1102;
 *           in table `trap`, companion, nodal error at n = 64: 1.0e-5 by the
 *           midpoint rule, 2.4e-10 by two-point Gauss, round-off by exact
 *           integrals, and the same L2 error each time
 * Plot: nodes x u
 */
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_log.h>
#include <math.h>
#include <stdlib.h>

/* -(beta u')' = f in (0, 1), u(0) = g, beta u' = q at x = 1. */
struct problem {
    field *beta, *f;
    double g, q;
    field *exact, *exact_dx;
    /* r[a] := int f phi_a dx on one element, where phi_a has the end values of
     * e_a and beta phi_a' is constant; returns int dx/beta */
    double (*fitted)(double x0, double x1, double r[2]);
};

/* How the integrals are computed. */
enum load { BY_MIDPOINT, BY_TRAPEZOID, BY_GAUSS2, EXACT_LOAD, FITTED };

static double one(double x)
{
    (void)x;
    return 1.0;
}

static double one_plus_x(double x)
{
    return 1.0 + x;
}

static double load_density(double x)
{
    return 1.0 / ((1.0 + x) * (1.0 + x));
}

static double exercise_exact(double x)
{
    return 2.0 - 1.0 / (1.0 + x) - log1p(x);
}

static double exercise_exact_dx(double x)
{
    return -x / ((1.0 + x) * (1.0 + x));
}

static double companion_exact(double x)
{
    return 1.0 + log1p(x) - x;
}

static double companion_exact_dx(double x)
{
    return -x / (1.0 + x);
}

/*
 * r[a] := int (1+x)^-2 e_a dx on (x0, x1), in closed form.  With t = 1 + x,
 * r[1] = (ln(t1/t0) - h/t1)/h: two numbers that agree in all but O(h^2), so
 * the difference is taken by a function made for it, y -> ln(1+y) - y.
 */
static void hat_load(double x0, double x1, double r[2])
{
    const double h = x1 - x0;
    r[0] = -gsl_sf_log_1plusx_mx(h / (1.0 + x0)) / h;
    r[1] = -gsl_sf_log_1plusx_mx(-h / (1.0 + x1)) / h;
}

/* beta = 1 + x: phi_1 = ln(t/t0) / ln(t1/t0), phi_0 = 1 - phi_1. */
static double exercise_fitted(double x0, double x1, double r[2])
{
    const double t0 = 1.0 + x0, t1 = 1.0 + x1, h = x1 - x0;
    const double L = log1p(h / t0);
    r[0] = -gsl_sf_log_1plusx_mx(-h / t1) / (t0 * L);
    r[1] = -gsl_sf_log_1plusx_mx(h / t0) / (t1 * L);
    return L;
}

/* beta = 1: phi_a is the hat function itself. */
static double companion_fitted(double x0, double x1, double r[2])
{
    hat_load(x0, x1, r);
    return x1 - x0;
}

static const struct problem EXERCISE = {.beta = one_plus_x,
                                        .f = load_density,
                                        .g = 1.0,
                                        .q = -0.5,
                                        .exact = exercise_exact,
                                        .exact_dx = exercise_exact_dx,
                                        .fitted = exercise_fitted};
static const struct problem COMPANION = {.beta = one,
                                         .f = load_density,
                                         .g = 1.0,
                                         .q = -0.5,
                                         .exact = companion_exact,
                                         .exact_dx = companion_exact_dx,
                                         .fitted = companion_fitted};

/*
 * A (order n + 1, half bandwidth 1) and b[0..n] without any boundary condition
 * [eq:poisson-A] [eq:poisson-b].  A is exact for every rule, beta being linear;
 * the rule matters to b.  FITTED tests with phi_a instead of e_a.
 */
static void assemble(const struct problem *problem, enum load load, int n,
                     const double x[], struct matrix *A, double b[])
{
    const struct quadrature *const rule[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2,
                                             &MIDPOINT, &MIDPOINT};

    poisson_assemble(n, x, problem->beta, problem->f, rule[load], A, b);
    if (load != EXACT_LOAD && load != FITTED) return;
    for (int i = 0; i <= n; i++) b[i] = 0.0;
    if (load == FITTED) matrix_zero(A);
    for (int e = 0; e < n; e++) {
        double r[2];
        if (load == EXACT_LOAD) {
            hat_load(x[e], x[e + 1], r);
        } else {
            const double k = 1.0 / problem->fitted(x[e], x[e + 1], r);
            matrix_add(A, e, e, k);
            matrix_add(A, e + 1, e, -k);
            matrix_add(A, e + 1, e + 1, k);
        }
        b[e] += r[0];
        b[e + 1] += r[1];
    }
}

/*
 * Solve the boundary value problem on the nodes x[0..n].
 *
 * A, b   out  the system with the flux q in it, but before the correction for
 *             u(0) = g: the reaction needs it [eq:reaction]
 * u      out  nodal values u[0..n]
 *
 * OK, or NOT_SPD when the corrected matrix is not positive definite; u is then
 * of no use.
 */
static enum status solve_bvp(const struct problem *problem, enum load load,
                             int n, const double x[], struct matrix *A,
                             double b[], double u[])
{
    /* SLOT 7a(problem, load, n, x, A, b, u, assemble): assemble A and b; add
     * the flux q to the load of the right node [eq:poisson-b]; correct a copy
     * of the system for u(0) = g [eq:dirichlet-correction]; factor the copy;
     * solve into u.  Return what matrix_factor() says. */
    todo("7a", problem, load, n, x, A, b, u, assemble);
    /* END 7a */
}

/*
 * The errors of u_h = sum_j u[j] e_j.  Between two nodes u_h is the straight
 * line, with slope u_h' = (u[e+1] - u[e]) / h.
 */
static struct poisson_error measure(const struct problem *problem, int n,
                                    const double x[], const double u[])
{
    enum { POINTS = 5 }; /* exact for degree 9: far better than u_h is */
    gsl_integration_glfixed_table *gauss =
        gsl_integration_glfixed_table_alloc(POINTS);
    struct poisson_error error = {0};

    for (int j = 0; j <= n; j++)
        error.nodal = fmax(error.nodal, fabs(problem->exact(x[j]) - u[j]));

    /* SLOT 7b(problem, n, x, u, error, gauss): error.L2 [eq:norm-L2] and
     * error.energy [eq:norm-energy] by Gauss quadrature on each element;
     * gsl_integration_glfixed_point(x0, x1, k, &at, &w, gauss) gives point and
     * weight k of POINTS on (x0, x1). */
    todo("7b", problem, n, x, u, error, gauss);
    /* END 7b */
    gsl_integration_glfixed_table_free(gauss);
    return error;
}

struct order {
    double order, constant; /* p and C of err = C h^p */
};

/*
 * Order and constant through two measurements [eq:order].
 *
 * Both are 0 where there is nothing to measure: a length that is not positive,
 * equal lengths, or an error that is not above `floor`, the size of round-off.
 * (The first row of a table has no row before it: h1 = err1 = 0.)
 */
static struct order observed_order(double h1, double err1, double h2,
                                   double err2, double floor)
{
    struct order found = {0.0, 0.0};

    /* SLOT 7c(h1, err1, h2, err2, floor, found): fill found.order and
     * found.constant, unless there is nothing to measure. */
    todo("7c", h1, err1, h2, err2, floor, found);
    /* END 7c */
    return found;
}

struct solution {
    int n;
    double *x, *u, *b; /* [n + 1]; owned */
    struct matrix *A;  /* before the Dirichlet correction; owned */
    struct poisson_error error;
    double reaction; /* (A u - b)_0 = -beta u' at x = 0 [eq:reaction] */
    double slope;    /* the same from the first element's slope */
};

static struct solution solution_of(const struct problem *problem,
                                   enum load load, int n, double grading)
{
    const size_t N = (size_t)n + 1;
    struct solution s = {.n = n,
                         .x = allocate(N, sizeof(double)),
                         .u = allocate(N, sizeof(double)),
                         .b = allocate(N, sizeof(double)),
                         .A = matrix_alloc(BANDED, n + 1, 1)};

    grid_make(0.0, 1.0, n, grading, s.x);
    const enum status status = solve_bvp(problem, load, n, s.x, s.A, s.b, s.u);
    if (status != OK)
        die("%d elements: the matrix is %s", n, status_name(status));
    s.error = measure(problem, n, s.x, s.u);
    s.reaction = matrix_get(s.A, 0, 0) * s.u[0] +
                 matrix_get(s.A, 0, 1) * s.u[1] - s.b[0];
    s.slope = -problem->beta(0.0) * (s.u[1] - s.u[0]) / (s.x[1] - s.x[0]);
    return s;
}

static void solution_free(struct solution *s)
{
    free(s->x);
    free(s->u);
    free(s->b);
    matrix_free(s->A);
}

/* What is kept of a sequence of grids: n, and the size of every error. */
enum { NODAL, L2, ENERGY, REACTION, SLOPE, TRAP_MIDPOINT, TRAP_GAUSS2,
       TRAP_EXACT, TRAP_L2, TRAP_EXERCISE, TRAP_FITTED, TRAP_FITTED_L2,
       N_ERROR };
struct row {
    int n;
    double error[N_ERROR];
};

static double nodal_error(const struct problem *problem, enum load load, int n)
{
    struct solution s = solution_of(problem, load, n, 1.0);
    solution_free(&s);
    return s.error.nodal;
}

static struct row row_of(const struct problem *problem, enum load load, int n,
                         double grading)
{
    struct solution s = solution_of(problem, load, n, grading);
    struct solution t = solution_of(&COMPANION, EXACT_LOAD, n, 1.0);
    struct solution v = solution_of(&EXERCISE, FITTED, n, 1.0);
    solution_free(&s);
    solution_free(&t);
    solution_free(&v);
    return (struct row){
        n,
        {[NODAL] = s.error.nodal,
         [L2] = s.error.L2,
         [ENERGY] = s.error.energy,
         [REACTION] = fabs(s.reaction),
         [SLOPE] = fabs(s.slope),
         [TRAP_MIDPOINT] = nodal_error(&COMPANION, BY_MIDPOINT, n),
         [TRAP_GAUSS2] = nodal_error(&COMPANION, BY_GAUSS2, n),
         [TRAP_EXACT] = t.error.nodal,
         [TRAP_L2] = t.error.L2,
         [TRAP_EXERCISE] = nodal_error(&EXERCISE, EXACT_LOAD, n),
         [TRAP_FITTED] = v.error.nodal,
         [TRAP_FITTED_L2] = v.error.L2}};
}

/* The piecewise linear function on element e, 0 <= t <= 1. */
static double along(const double v[], int e, double t)
{
    return v[e] + t * (v[e + 1] - v[e]);
}

static void print_solution(const struct problem *problem,
                           const struct solution *s,
                           const struct solution *fitted)
{
    enum { STEPS = 16 }; /* an element, to look between the nodes */

    if (s->n <= 12) table_matrix("A", s->A);
    table_vector("b", s->n + 1, s->b);
    table_begin("nodes", "x u exact");
    for (int j = 0; j <= s->n; j++)
        table_row(s->x[j], s->u[j], problem->exact(s->x[j]));
    table_end();

    table_begin("curve", "x uh exact error fitted_error");
    for (int k = 0; k <= STEPS * s->n; k++) {
        const int e = k < STEPS * s->n ? k / STEPS : s->n - 1;
        const double t = (double)(k - STEPS * e) / STEPS;
        const double x = along(s->x, e, t), uh = along(s->u, e, t);
        const double exact = problem->exact(x);
        table_row(x, uh, exact, exact - uh, exact - along(fitted->u, e, t));
    }
    table_end();
}

/*
 * The errors first..last of row[0..n_row-1], each with its order and constant
 * between this row and the one before; both are 0 in the first row.
 */
static void print_errors(const char *name, const char *columns, int n_row,
                         const struct row row[], int first, int last)
{
    const double round_off = 4e-12; /* above n eps, u being of size 1 */

    table_begin(name, columns);
    for (int i = 0; i < n_row; i++) {
        const double h1 = i > 0 ? 1.0 / row[i - 1].n : 0.0;
        double value[1 + 3 * N_ERROR] = {row[i].n};
        int m = 1;
        for (int k = first; k <= last; k++) {
            const struct order found =
                observed_order(h1, i > 0 ? row[i - 1].error[k] : 0.0,
                               1.0 / row[i].n, row[i].error[k], round_off);
            value[m++] = row[i].error[k];
            value[m++] = found.order;
            value[m++] = found.constant;
        }
        table_row_of(m, value);
    }
    table_end();
}

int main(int argc, char *argv[])
{
    enum { MAX_GRIDS = 8 };
    int n = 4, load = BY_MIDPOINT, companion = 0, finest = 512;
    double grading = 1.0;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 1000,
         .help = "elements of the printed solution"},
        {"load", .choice = &load,
         .choices = "midpoint trapezoid gauss2 exact fitted",
         .help = "how the load is integrated; fitted: nodally exact"},
        {"problem", .choice = &companion, .choices = "exercise companion",
         .help = "beta = 1 + x, or 1"},
        {"grading", .real = &grading, .min = 0.05, .max = 20.0,
         .help = "length of the last element over that of the first"},
        {"finest", .integer = &finest, .min = 4, .max = 512,
         .help = "largest n of the tables orders, flux and trap"},
    };
    options_parse("07_poisson_bvp", options, COUNT(options), argc, argv);

    const struct problem *problem = companion ? &COMPANION : &EXERCISE;
    struct row row[MAX_GRIDS];
    int n_row = 0;

    struct solution s = solution_of(problem, (enum load)load, n, grading);
    struct solution fitted = solution_of(problem, FITTED, n, grading);
    for (int m = 4; m <= finest; m *= 2)
        row[n_row++] = row_of(problem, (enum load)load, m, grading);

    print_solution(problem, &s, &fitted);
    print_errors("orders",
                 "n nodal nodal_order nodal_constant "
                 "L2 L2_order L2_constant "
                 "energy energy_order energy_constant",
                 n_row, row, NODAL, ENERGY);
    print_errors("flux",
                 "n reaction reaction_order reaction_constant "
                 "slope slope_order slope_constant",
                 n_row, row, REACTION, SLOPE);
    print_errors("trap",
                 "n midpoint midpoint_order midpoint_constant "
                 "gauss2 gauss2_order gauss2_constant "
                 "exact exact_order exact_constant L2 L2_order L2_constant "
                 "exercise exercise_order exercise_constant "
                 "fitted fitted_order fitted_constant "
                 "fitted_L2 fitted_L2_order fitted_L2_constant",
                 n_row, row, TRAP_MIDPOINT, TRAP_FITTED_L2);
    solution_free(&s);
    solution_free(&fitted);
    return table_finish();
}
