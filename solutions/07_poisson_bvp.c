/*
 * 07_poisson_bvp.c - solve a boundary value problem and measure its error.
 *
 * Notes: Lecture 2, section 1.1, exercise (5).
 *
 * Problem.  Linear elements for [eq:poisson-bvp]
 *
 *     -((1+x) u')' = (1+x)^-2 in (0, 1),   u(0) = 1,   2 u'(1) = -1/2,
 *
 * How large is the error, where, and how does it fall with h [eq:order]?  At
 * the nodes, between them [eq:norm-L2], in the slope [eq:norm-energy], and in
 * the reaction at x = 0 [eq:reaction].
 *
 * Run       make lesson-07; make lesson-07 ARGS=-h lists its options
 * PREDICT 1a times the elements, for one digit more in the energy norm: ...
 * PREDICT 1b and in the L2 norm: ...
 * PREDICT 3 flux error, slope with 64 elements over reaction with 4: ...
 * Plot: nodes x u
 */
#include "base/options.h"
#include "bar/poisson.h"
#include "base/table.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

/* -(beta u')' = f in (0, 1), u(0) = g, beta u' = q at x = 1. */
struct problem {
    field *beta, *f;
    double g, q;
    field *exact, *exact_dx;
};

static const struct problem EXERCISE = {bvp_beta, bvp_f,     1.0,
                                        -0.5,     bvp_exact, bvp_exact_dx};

/* How the load is integrated; beta being linear, A is exact for every rule. */
enum load { BY_MIDPOINT, BY_TRAPEZOID, BY_GAUSS2, EXACT_LOAD };

/* A (order n + 1, half bandwidth 1) and b[0..n] without any boundary condition
 * [eq:poisson-A] [eq:poisson-b]. */
static void assemble(const struct problem *problem, enum load load, int n,
                     const double x[], struct matrix *A, double b[])
{
    const struct quadrature *const rule[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2,
                                             &MIDPOINT};
    poisson_assemble(n, x, problem->beta, problem->f, rule[load], A, b);
    if (load == EXACT_LOAD) bvp_exact_load(n, x, b);
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
    /* SLOT 7a(problem, load, n, x, A, b, u, assemble): given the problem,
     * assemble A and b, and bring the flux q into b; correct a copy of the
     * system for u(0) = g [eq:dirichlet-correction]; factor the copy; solve
     * into u.  Free the copy, and return what matrix_factor() says. */
    const int node[] = {0};

    assemble(problem, load, n, x, A, b);
    /* the boundary term of the integration by parts: e_n(1) = 1 */
    b[n] += problem->q;

    /* A and b stay as they are for the reaction */
    struct matrix *L = matrix_copy(A);
    for (int i = 0; i <= n; i++) u[i] = b[i];
    matrix_dirichlet(L, u, 1, node, &problem->g, KEEP_DIAGONAL);
    const enum status status = matrix_factor(L);
    if (status == OK) matrix_solve(L, u);
    matrix_free(L);
    return status;
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

    /* SLOT 7b(problem, n, x, u, error, gauss): given u, set error.L2
     * [eq:norm-L2] and error.energy [eq:norm-energy] by Gauss quadrature on
     * each element; gsl_integration_glfixed_point(x0, x1, k, &at, &w, gauss)
     * gives point and weight k of POINTS on (x0, x1). */
    for (int e = 0; e < n; e++) {
        const double slope = (u[e + 1] - u[e]) / (x[e + 1] - x[e]);
        for (size_t k = 0; k < POINTS; k++) {
            double at, w;
            gsl_integration_glfixed_point(x[e], x[e + 1], k, &at, &w, gauss);
            const double d = problem->exact(at) - (u[e] + slope * (at - x[e]));
            const double d_dx = problem->exact_dx(at) - slope;
            error.L2 += w * d * d;
            /* int beta v'^2 dx, which is v^T A v where v is made of hats */
            error.energy += w * problem->beta(at) * d_dx * d_dx;
        }
    }
    error.L2 = sqrt(error.L2);
    error.energy = sqrt(error.energy);
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
 */
static struct order observed_order(double h1, double err1, double h2,
                                   double err2, double floor)
{
    struct order found = {0.0, 0.0};

    /* SLOT 7c(h1, err1, h2, err2, floor, found): given two lengths and errors,
     * fill found.order and found.constant, if there is anything to measure. */
    if (h1 > 0.0 && h2 > 0.0 && h1 != h2 && err1 > floor && err2 > floor) {
        /* err1 / err2 = (h1 / h2)^p */
        found.order = log(err1 / err2) / log(h1 / h2);
        found.constant = err2 / pow(h2, found.order);
    }
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

static void print_solution(const struct solution *s)
{
    if (s->n <= 12) matrix_table("A", s->A);
    table_vector("b", s->n + 1, s->b);
    table_begin("nodes", "x u exact");
    for (int j = 0; j <= s->n; j++)
        table_row(s->x[j], s->u[j], bvp_exact(s->x[j]));
    table_end();
}

static void solution_free(struct solution *s)
{
    free(s->x);
    free(s->u);
    free(s->b);
    matrix_free(s->A);
}

static struct solution solution_of(const struct problem *problem,
                                   enum load load, int n, double grading)
{
    const size_t N = (size_t)n + 1;
    struct solution s = {.n = n, .x = allocate(N, sizeof(double)),
                         .u = allocate(N, sizeof(double)),
                         .b = allocate(N, sizeof(double)),
                         .A = matrix_alloc(BANDED, n + 1, 1)};

    poisson_grid(0.0, 1.0, n, grading, s.x);
    const enum status status = solve_bvp(problem, load, n, s.x, s.A, s.b, s.u);
    if (status != OK) die("n = %d: A is %s", n, status_name(status));
    s.error = measure(problem, n, s.x, s.u);
    s.reaction = matrix_get(s.A, 0, 0) * s.u[0] +
                 matrix_get(s.A, 0, 1) * s.u[1] - s.b[0];
    s.slope = -problem->beta(0.0) * (s.u[1] - s.u[0]) / (s.x[1] - s.x[0]);
    return s;
}

/* Errors first..last of the grids n = 4, 8, ..., each with its order and
 * constant between this grid and the one before. */
enum { NODAL, L2, ENERGY, REACTION, SLOPE, N_ERROR };
static void print_errors(const char *name, const char *columns, int n_grid,
                         double error[][N_ERROR], int first, int last)
{
    const double round_off = 4e-12; /* above n eps, u being of size 1 */
    table_begin(name, columns);
    for (int i = 0; i < n_grid; i++) {
        const double h = 0.25 / (1 << i), h_before = i > 0 ? 2.0 * h : 0.0;
        struct cell row[1 + 3 * N_ERROR] = {cell_number(1.0 / h)};
        int m = 1;
        for (int k = first; k <= last; k++) {
            const double before = i > 0 ? error[i - 1][k] : 0.0;
            const struct order found =
                observed_order(h_before, before, h, error[i][k], round_off);
            row[m++] = cell_number(error[i][k]);
            row[m++] = cell_if(found.constant != 0.0, found.order);
            row[m++] = cell_if(found.constant != 0.0, found.constant);
        }
        table_row_of(m, row);
    }
    table_end();
}

int main(int argc, char *argv[])
{
    int n = 4, load = BY_MIDPOINT, finest = 512, grids = 0;
    double grading = 1.0, error[8][N_ERROR];
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 1000,
         .help = "elements of the printed solution"},
        {"load", .choice = &load, .choices = "midpoint trapezoid gauss2 exact",
         .help = "how the load is integrated"},
        {"grading", .real = &grading, .min = 0.05, .max = 20.0,
         .help = "length of the last element over that of the first"},
        {"finest", .integer = &finest, .min = 4, .max = 512,
         .help = "largest n of the tables orders and flux"},
    };
    options_parse("07_poisson_bvp", options, COUNT(options), argc, argv);

    struct solution s = solution_of(&EXERCISE, (enum load)load, n, grading);
    print_solution(&s);
    solution_free(&s);
    for (int m = 4; m <= finest; m *= 2, grids++) {
        s = solution_of(&EXERCISE, (enum load)load, m, grading);
        const double all[N_ERROR] = {s.error.nodal, s.error.L2, s.error.energy,
                                     fabs(s.reaction), fabs(s.slope)};
        for (int k = 0; k < N_ERROR; k++) error[grids][k] = all[k];
        solution_free(&s);
    }
    print_errors("orders", "n nodal nodal_order nodal_constant L2 L2_order "
                 "L2_constant energy energy_order energy_constant", grids,
                 error, NODAL, ENERGY);
    print_errors("flux", "n reaction reaction_order reaction_constant slope "
                 "slope_order slope_constant", grids, error, REACTION, SLOPE);
    return table_finish();
}
