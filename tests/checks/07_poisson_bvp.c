/*
 * 07_poisson_bvp.c - what a right solution and a right error satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *     7a   problem       three with beta, f, g, q of their own; -beta
 *     7a   load          Gauss here, the midpoint and the exact load with the
 *                        oracles, the trapezoid in the runs
 *     7a   n, x          7 unequal; 4 to 128 equal; 1 to 12 graded in the runs
 *     7b   problem, u    beta 1, 1 + x and another; exact parabola and others
 *     7b   n, x          7 graded both ways; 4 to 128 equal
 *     7c   h1, err1, h2, err2, floor  all in order_and_constant_are_recovered:
 *                        errors that fall and that grow, finer and coarser
 * x[0] = 0 and x[n] = 1 are the problem's.
 */
#include "program.h"

#include "judge.h"

#include "../oracle/poisson.h"

#include <gsl/gsl_math.h>
#include <stdio.h>

/* A problem of high entropy on unequal elements; `exact` is any function. */
enum { n_elem = 7, N_node = 8 };
static const double g0 = 2.385, q1 = -0.731, slope0 = 3.714;

static double beta_(double x)
{
    return 1.3 + sin(2.0 * x);
}

static double minus_beta(double x)
{
    return -beta_(x);
}

static double f_(double x)
{
    return 3.714 * exp(-1.7 * x);
}

static double no_load(double x)
{
    return 0.0 * x;
}

/* The companion problem: beta = 1 instead of 1 + x. */
static double companion_exact(double x)
{
    return 1.0 + log1p(x) - x;
}

static double companion_exact_dx(double x)
{
    return -x / (1.0 + x);
}

static const struct problem companion = {
    field_one, bvp_f, 1.0, -0.5, companion_exact, companion_exact_dx};

static double wave(double x)
{
    return cos(2.385 * x);
}

static double wave_dx(double x)
{
    return -2.385 * sin(2.385 * x);
}

static double square(double x)
{
    return slope0 * x * x;
}

static double square_dx(double x)
{
    return 2.0 * slope0 * x;
}

static const struct problem scene = {.beta = beta_,
                                     .f = f_,
                                     .g = 2.385,
                                     .q = -0.731,
                                     .exact = wave,
                                     .exact_dx = wave_dx};

/* Round-off of a direct solve with condition number below 1e3. */
static const double ROUND_OFF = 1e-12;

/* `problem` solved on the unequal grid, and A0, b0 as assembled. */
struct solved {
    double *x, *u, *b, *b0;
    struct matrix *A, *A0;
    enum status status;
};

static struct solved solve_scene(const struct problem *problem)
{
    struct solved s = {.x = guarded_alloc(N_node), .u = guarded_alloc(N_node),
                       .b = guarded_alloc(N_node), .b0 = guarded_alloc(N_node),
                       .A = matrix_alloc(BANDED, N_node, 1),
                       .A0 = matrix_alloc(BANDED, N_node, 1)};
    poisson_grid(0.0, 1.0, n_elem, 2.385, s.x);
    poisson_assemble(n_elem, s.x, problem->beta, problem->f, &GAUSS2, s.A0,
                     s.b0);
    s.status = solve_bvp(problem, BY_GAUSS2, n_elem, s.x, s.A, s.b, s.u);
    return s;
}

static struct solved solved_scene(const struct problem *problem)
{
    const struct solved s = solve_scene(problem);
    expect(s.status == OK, "the corrected matrix is %s; it must be OK",
           status_name(s.status));
    return s;
}

/* A and b leave as assembled, but for q: the reaction needs them so. */
static void system_is_the_assembled_one_plus_flux(void)
{
    const struct solved s = solved_scene(&scene);
    for (int i = 0; i < N_node; i++)
        expect_close(s.b[i] - s.b0[i], i == n_elem ? q1 : 0.0, 1e-14, slope0,
                     "what solve_bvp() adds to the assembled b[%d] (q is %g)",
                     i, q1);
    for (int i = 0; i < N_node; i++)
        for (int j = 0; j < N_node; j++)
            expect_close(matrix_get(s.A, i, j), matrix_get(s.A0, i, j), 1e-14,
                         matrix_get(s.A0, i, i),
                         "A[%d][%d], which must leave as it was before the "
                         "Dirichlet correction",
                         i, j);
}

/* Every equation but the one of the held node; and that one by balance. */
static void equations_and_balance_hold(void)
{
    const struct solved s = solved_scene(&scene);
    double r[N_node], total = 0.0;

    expect_close(s.u[0], g0, ROUND_OFF, g0, "u[0], which is given");
    matrix_multiply(s.A0, s.u, r);
    for (int i = 1; i < N_node; i++) {
        const double b = s.b0[i] + (i == n_elem ? q1 : 0.0);
        expect_close(r[i] - b, 0.0, ROUND_OFF, 10.0 * slope0,
                     "equation %d, (A u - b)[%d]", i, i);
        total += b;
    }
    expect_close(r[0], -total, ROUND_OFF, 10.0 * slope0,
                 "force at the held node, against the loads of the others");
}

static void straight_line_is_exact(void)
{
    struct problem problem = scene;
    problem.beta = field_one;
    problem.f = no_load;
    const struct solved s = solved_scene(&problem);
    for (int j = 0; j < N_node; j++)
        expect_close(s.u[j], g0 + q1 * s.x[j], ROUND_OFF, g0,
                     "u at node %d; no load, beta = 1: u = g + q x", j);
}

enum { MANY = 300 };
static void solve_once(void)
{
    static double x[MANY + 1], b[MANY + 1], u[MANY + 1];
    struct matrix *A = matrix_alloc(BANDED, MANY + 1, 1);
    poisson_grid(0.0, 1.0, MANY, 2.385, x);
    solve_bvp(&scene, BY_GAUSS2, MANY, x, A, b, u);
    matrix_free(A);
}

static void indefinite_matrix_is_reported(void)
{
    expect_no_leak(solve_once, MANY * sizeof(double), "solve_bvp()");
    struct problem problem = scene;
    problem.beta = minus_beta;
    const enum status status = solve_scene(&problem).status;
    expect(status == NOT_SPD,
           "with a negative beta solve_bvp() must return NOT_SPD, the status "
           "that matrix_factor() gives; it returns %s",
           status_name(status));
}

/* For u = c x^2 and its interpolant, u - u_h = -c h^2 s (1 - s) on an element:
 * the integrals are c^2 h^5 / 30 and beta c^2 h^3 / 3. */
static void errors_of_a_parabola(void)
{
    struct problem problem = scene;
    double *x = guarded_alloc(N_node), *u = guarded_alloc(N_node);
    double L2_ = 0.0, energy = 0.0;

    problem.beta = field_one;
    problem.exact = square;
    problem.exact_dx = square_dx;
    poisson_grid(0.0, 1.0, n_elem, 2.385, x);
    for (int j = 0; j < N_node; j++) u[j] = square(x[j]);
    for (int e = 0; e < n_elem; e++) {
        const double h = x[e + 1] - x[e];
        L2_ += slope0 * slope0 * pow(h, 5) / 30.0;
        energy += slope0 * slope0 * pow(h, 3) / 3.0;
    }
    const struct poisson_error error = measure(&problem, n_elem, x, u);
    expect(error.L2 > 0.0,
           "a parabola minus its interpolant is 0 at the nodes and not "
           "between them; your L2 error is %g: it does not look between them",
           error.L2);
    expect_close(error.L2, sqrt(L2_), ROUND_OFF, sqrt(L2_),
                 "L2 error of a parabola's interpolant");
    expect_close(error.energy, sqrt(energy), ROUND_OFF, sqrt(energy),
                 "energy error of a parabola's interpolant, beta = 1");
}

/* 1e-9: five Gauss points and more of them agree to that on this scene. */
static void errors_agree_with_the_library(void)
{
    double *x = guarded_alloc(N_node), *u = guarded_alloc(N_node);
    poisson_grid(0.0, 1.0, n_elem, 0.2385, x);
    for (int j = 0; j < N_node; j++) u[j] = wave(x[j]) + 0.0613 * sin(5.0 * j);

    const struct poisson_error want =
        poisson_errors(n_elem, x, u, beta_, wave, wave_dx);
    const struct poisson_error got = measure(&scene, n_elem, x, u);
    expect_close(got.nodal, want.nodal, 1e-14, 1.0, "nodal error");
    expect_close(got.L2, want.L2, 1e-9, want.L2,
                 "L2 error, against poisson_errors() of common/");
    expect_close(got.energy, want.energy, 1e-9, want.energy,
                 "energy error, against poisson_errors() of common/");
}

/* err = C h^p is given back; 1e-13: two logarithms and a power. */
static void order_and_constant_are_recovered(void)
{
    const double p = 1.385, C = 3.714, h[] = {0.2385, 0.0713};
    const double e[] = {C * pow(h[0], p), C * pow(h[1], p)};
    const double none[][4] = {{0.0, 0.0, h[1], e[1]},
                              {0.0, e[0], h[1], e[1]},
                              {h[0], e[0], 0.0, e[1]},
                              {-h[0], e[0], -h[1], e[1]},
                              {h[0], 0.0, h[1], 0.0},
                              {h[0], e[0], h[1], 0.0},
                              {h[0], 1e-13, h[1], 2e-14},
                              {h[0], 1e-13, h[1], e[1]},
                              {h[0], e[0], h[1], 1e-13},
                              {h[0], 1e-12, h[1], e[1]},
                              {h[0], e[0], h[1], 1e-12},
                              {NAN, e[0], h[1], e[1]},
                              {h[0], e[0], NAN, e[1]},
                              {h[0], NAN, h[1], e[1]},
                              {h[0], e[0], h[1], NAN},
                              {h[0], e[0], h[0], e[0]}};

    for (int grows = 0; grows < 2; grows++)
        for (int k = 0; k < 2; k++) { /* refined, and made coarser */
            const double s = grows ? -0.613 : p, h1 = h[k], h2 = h[1 - k];
            const struct order found = observed_order(h1, C * pow(h1, s), h2,
                                                      C * pow(h2, s), 1e-12);
            expect_close(found.order, s, 1e-13, p,
                         "order of err = %g h^%g, measured at h1 = %g and h2 = "
                         "%g", C, s, h1, h2);
            expect_close(found.constant, C, 1e-12, C,
                         "constant of err = %g h^%g, measured at h1 = %g and "
                         "h2 = %g", C, s, h1, h2);
        }
    /* lengths that differ by a thousandth: the digits of err count as many */
    const double near = 1.001 * h[0];
    const double e_near = C * pow(near, p);
    expect_close(observed_order(h[0], e[0], near, e_near, 1e-12).order, p,
                 1e-11, p, "order from two lengths 0.1 %% apart");
    for (int k = 0; k < COUNT(none); k++) {
        const struct order zero = observed_order(none[k][0], none[k][1],
                                                 none[k][2], none[k][3], 1e-12);
        expect_close(zero.order, 0.0, 0.0, 1.0,
                     "order from h1 = %g, err1 = %g, h2 = %g, err2 = %g, floor "
                     "1e-12 (nothing to measure)",
                     none[k][0], none[k][1], none[k][2], none[k][3]);
        expect_close(zero.constant, 0.0, 0.0, 1.0,
                     "constant from h1 = %g, err1 = %g, h2 = %g, err2 = %g, "
                     "floor 1e-12 (nothing to measure)",
                     none[k][0], none[k][1], none[k][2], none[k][3]);
    }
    const struct order loose =
        observed_order(h[0], e[0], h[1], e[1], 0.5 * (e[0] + e[1]));
    expect(loose.order == 0.0 && loose.constant == 0.0,
           "err2 = %g is below a floor of %g, but the order is %g and the "
           "constant %g, not 0", e[1], 0.5 * (e[0] + e[1]), loose.order,
           loose.constant);
    expect_close(observed_order(h[0], e[0] * 1e-14, h[1], e[1] * 1e-14,
                                0.0).order, p, 1e-13, p,
                 "order of errors of 1e-14, with a floor of 0");
}

/* H1 of the oracle is the energy norm with beta = 1. */
static void agrees_with(enum load load, const struct oracle_bvp *oracle,
                        int n_oracle)
{
    struct problem flat = EXERCISE;
    flat.beta = field_one;
    for (int k = 0; k < n_oracle; k++) {
        const struct oracle_bvp *o = &oracle[k];
        struct solution s = solution_of(&EXERCISE, load, o->N, 1.0);
        const double H1 = measure(&flat, o->N, s.x, s.u).energy;
        /* nodal values to round-off; 1e-6: five-point Gauss at n = 4 */
        expect_close(s.error.nodal, o->nodal, ROUND_OFF, 1.0,
                     "nodal error, %d elements", o->N);
        expect_close(s.error.L2, o->L2, 1e-6, o->L2, "L2 error, %d elements",
                     o->N);
        expect_close(H1, o->H1, 1e-6, o->H1,
                     "L2 error of the slope (energy error with beta = 1), %d "
                     "elements",
                     o->N);
        expect_close(s.reaction, o->reaction, ROUND_OFF, 100.0,
                     "reaction at x = 0, %d elements", o->N);
        solution_free(&s);
    }
}

static void agrees_with_the_oracles(void)
{
    struct output *output = run("--finest 4");
    int n;
    const double *u = column(output, "nodes", "u", &n);
    expect(n == 5, "table `nodes` must have 5 rows for 4 elements, not %d", n);
    for (int i = 0; i < 5; i++) {
        expect_close(cell(output, "b", "value", i), oracle_bvp_b4_midpoint[i],
                     1e-14, 1.0, "b[%d], 4 elements, midpoint rule", i);
        expect_close(u[i], oracle_bvp_u4_midpoint[i], ROUND_OFF, 1.0,
                     "u[%d], 4 elements, midpoint rule", i);
    }
    agrees_with(BY_MIDPOINT, oracle_bvp_midpoint, COUNT(oracle_bvp_midpoint));
    agrees_with(EXACT_LOAD, oracle_bvp_exact_load,
                COUNT(oracle_bvp_exact_load));
}

/* Order and constant in a table's last row. */
static void expect_order(struct output *output, const char *table,
                         const char *what, double p, double C)
{
    char name[64];
    snprintf(name, sizeof name, "%s_order", what);
    /* the next term of the error is O(h^2) smaller: 6e-5 at n = 128; the
     * constant feels the order's error times ln n as well */
    expect_close(cell(output, table, name, -1), p, 1e-3, p,
                 "observed order of `%s` in table `%s`", what, table);
    snprintf(name, sizeof name, "%s_constant", what);
    expect_close(cell(output, table, name, -1), C, 5e-3, C,
                 "constant of `%s` in table `%s`", what, table);
}

/* The constants are derived in the workbook's answer. */
static void orders_and_constants_are_the_theory(void)
{
    struct output *output = run("--finest 128");
    const double L2_2 =
        M_LN2 / 13824.0 + M_LN2 * M_LN2 / 4608.0 + 443.0 / 518400.0;
    expect_order(output, "orders", "nodal", 2.0, 1.0 / 144.0 + M_LN2 / 96.0);
    expect_order(output, "orders", "L2", 2.0, sqrt(L2_2));
    expect_order(output, "orders", "energy", 1.0, sqrt(7.0) / 24.0);
    expect_order(output, "flux", "reaction", 2.0, 7.0 / 96.0);
}

static struct poisson_error errors_of(const struct problem *problem,
                                      enum load load, int n)
{
    struct solution s = solution_of(problem, load, n, 1.0);
    solution_free(&s);
    return s.error;
}

/* Order p and constant C of the error between n and 2 n elements; tolerances
 * as in expect_order(). */
static void expect_pair(int n, double coarse, double fine, double p, double C,
                        double tolerance, const char *what)
{
    const double order = log2(coarse / fine);
    expect_close(order, p, tolerance, p, "observed order of %s", what);
    expect_close(fine * pow(2.0 * n, order), C, 5.0 * tolerance, C,
                 "constant of %s", what);
}

static void nodal_error_is_the_quadratures(void)
{
    for (int n = 4; n <= 128; n *= 2)
        expect_close(errors_of(&companion, EXACT_LOAD, n).nodal, 0.0,
                     ROUND_OFF, 1.0,
                     "companion problem, exact load, %d elements: nodal error",
                     n);
    expect_pair(64, errors_of(&companion, BY_MIDPOINT, 64).nodal,
                errors_of(&companion, BY_MIDPOINT, 128).nodal, 2.0, 1.0 / 24.0,
                1e-3, "the companion's nodal error, midpoint rule");
    expect_pair(64, errors_of(&companion, EXACT_LOAD, 64).L2,
                errors_of(&companion, EXACT_LOAD, 128).L2, 2.0,
                sqrt(7.0 / 2880.0), 1e-3, "the companion's L2 error");
    expect_pair(64, errors_of(&EXERCISE, EXACT_LOAD, 64).nodal,
                errors_of(&EXERCISE, EXACT_LOAD, 128).nodal, 2.0, 5.0 / 288.0,
                1e-3, "the exercise's nodal error, exact load");
    /* order 4 reaches round-off soon */
    expect_pair(16, errors_of(&companion, BY_GAUSS2, 16).nodal,
                errors_of(&companion, BY_GAUSS2, 32).nodal, 4.0,
                47.0 / 11520.0, 5e-3,
                "the companion's nodal error, two-point Gauss");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    measured("1a", pow(10.0, 1.0 / cell(output, "orders", "energy_order", -1)));
    measured("1b", pow(10.0, 1.0 / cell(output, "orders", "L2_order", -1)));
    measured("3", cell(output, "flux", "slope", 4) /
                      cell(output, "flux", "reaction", 0));
}

static const struct claim claims[] = {
    {"system_is_the_assembled_one_plus_flux",
     system_is_the_assembled_one_plus_flux, "7a"},
    {"equations_and_balance_hold", equations_and_balance_hold, "7a"},
    {"straight_line_is_exact", straight_line_is_exact, "7a"},
    {"indefinite_matrix_is_reported", indefinite_matrix_is_reported, "7a"},
    {"errors_of_a_parabola", errors_of_a_parabola, "7b"},
    {"errors_agree_with_the_library", errors_agree_with_the_library, "7b"},
    {"order_and_constant_are_recovered", order_and_constant_are_recovered,
     "7c"},
    {"agrees_with_the_oracles", agrees_with_the_oracles, "7a"},
    {"orders_and_constants_are_the_theory", orders_and_constants_are_the_theory,
     "7c"},
    {"nodal_error_is_the_quadratures", nodal_error_is_the_quadratures, "7a"},
};

static const char *const runs[] = {
    "--finest 64",
    "--n 7 --grading 3.714 --load exact --finest 32",
    "--n 5 --load trapezoid --finest 16",
    "--n 1 --load gauss2 --grading 0.2385 --finest 64",
    "--n 12 --load exact --finest 4",
};

#define SOLVE "direct solve, condition number below 1e6"
#define SUMS "sums of two element entries"
#define ERRORS "integrals of the error: five Gauss points at n = 4"
#define NOISE "round-off of the solve, u being of size 1"
#define ORDERS "logarithms; what the errors are allowed comes on top"
static const struct column_rule rules[] = {
    {"A", "*", 1e-13, SUMS, 0},
    {"b", "*", 1e-13, SUMS, 0},
    {"nodes", "*", 1e-11, SOLVE, 0},
    {"orders", "n", 0, "a count", 0},
    {"orders", "nodal", 1e-12, NOISE, 1.0},
    {"orders", "L2", 1e-6, ERRORS, 0},
    {"orders", "energy", 1e-6, ERRORS, 0},
    {"orders", "*", 1e-12, ORDERS, 0},
    {"flux", "n", 0, "a count", 0},
    {"flux", "reaction", 1e-12, NOISE, 1.0},
    {"flux", "slope", 1e-10, "a difference of u over h", 1.0},
    {"flux", "*", 1e-12, ORDERS, 0},
};

static const struct lesson lesson = {
    "07_poisson_bvp",
    claims,
    COUNT(claims),
    runs,
    COUNT(runs),
    rules,
    COUNT(rules),
    "With beta = 1 the nodal error has order 2, order 4 or none, by the choice "
    "of quadrature alone (figures/07_poisson_bvp/trap.svg); the L2 error has "
    "order 2 whatever you do. Which of them is the error of the method?",
    "Measure the energy error at the midpoints only (one Gauss point per "
    "element), and you find order 2 instead of 1. Where is the slope of u_h "
    "that good?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
