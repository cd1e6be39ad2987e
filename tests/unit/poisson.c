/* poisson.c - laws of common/bar/poisson.h and of what lessons 07 and 08 make
 * of it; GSL's quadrature is the judge. */
#include "figures/07_poisson_bvp/fitted.h"
#include "figures/08_element_assembly/exercise.h"
#include "bar/poisson.h"

#include "unit.h"

#include "../oracle/poisson.h"

#include <gsl/gsl_integration.h>
#include <math.h>

static double smooth(double x)
{
    return exp(-2.385 * x) + 0.3;
}
/* Exercise (5) with the given grid and rule; u[0..n]. */
static void solve_exercise(int n, const double x[],
                           const struct quadrature *rule, double u[])
{
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    poisson_assemble(n, x, bvp_beta, bvp_f, rule, A, u);
    exercise_boundary(n, A, u);
    ck_assert_int_eq(matrix_factor(A), OK);
    matrix_solve(A, u);
    matrix_free(A);
}

static void grid_is_geometric_and_meets_its_ends(void)
{
    double x[12];
    poisson_grid(-0.7, 2.385, 11, 5.5, x);
    ck_assert(x[0] == -0.7 && x[11] == 2.385);
    for (int j = 1; j < 11; j++)
        close_to((x[j + 1] - x[j]) / (x[j] - x[j - 1]), pow(5.5, 0.1), 1e-13);
    close_to((x[11] - x[10]) / (x[1] - x[0]), 5.5, 1e-12);
    poisson_grid(0.0, 1.0, 4, 1.0, x);
    for (int j = 0; j <= 4; j++) ck_assert(x[j] == 0.25 * j);
    poisson_grid(0.0, 1.0, 2, 7.0, x);
    ck_assert(x[0] == 0.0 && x[2] == 1.0);
    close_to(x[1], 1.0 / 8.0, 1e-15);
    poisson_grid(0.0, 1.0, 1, 7.0, x);
    ck_assert(x[0] == 0.0 && x[1] == 1.0);
}

static double degree_of_exactness(const struct quadrature *rule)
{
    for (int degree = 0;; degree++) {
        double sum = 0.0;
        for (int k = 0; k < rule->n; k++)
            sum += rule->w[k] * pow(rule->s[k], degree);
        if (fabs(sum - 1.0 / (degree + 1)) > 1e-14) return degree - 1;
    }
}

static void rules_have_their_degree(void)
{
    ck_assert(degree_of_exactness(&MIDPOINT) == 1);
    ck_assert(degree_of_exactness(&TRAPEZOID) == 1);
    ck_assert(degree_of_exactness(&GAUSS2) == 3);
}

static void exercise_5_equals_the_oracle(void)
{
    double x[5], b[5];
    struct matrix *A = matrix_alloc(DENSE, 5, 1);
    poisson_grid(0.0, 1.0, 4, 1.0, x);
    poisson_assemble(4, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
    b[4] -= 0.5;
    for (int i = 0; i < 5; i++) {
        close_to(b[i], oracle_bvp_b4_midpoint[i], 1e-15);
        for (int j = 0; j < 5; j++)
            close_to(matrix_get(A, i, j), oracle_bvp_A4[5 * i + j], 1e-13);
    }
    solve_exercise(4, x, &MIDPOINT, b);
    for (int i = 0; i < 5; i++)
        close_to(b[i], oracle_bvp_u4_midpoint[i], 1e-14);
    matrix_free(A);
    A = exercise_system(BANDED, 4, x, b); /* all of it at once */
    ck_assert_int_eq(matrix_factor(A), OK);
    matrix_solve(A, b);
    for (int i = 0; i < 5; i++)
        close_to(b[i], oracle_bvp_u4_midpoint[i], 1e-14);
    matrix_free(A);
}

static void errors_equal_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_bvp_midpoint); k++) {
        const struct oracle_bvp *want = &oracle_bvp_midpoint[k];
        double x[65], u[65];
        poisson_grid(0.0, 1.0, want->N, 1.0, x);
        solve_exercise(want->N, x, &MIDPOINT, u);
        const struct poisson_error got =
            poisson_errors(want->N, x, u, field_one, bvp_exact, bvp_exact_dx);
        close_to(got.nodal, want->nodal, 1e-13);     /* of u = 1 */
        close_to(got.L2, want->L2, 1e-7 * want->L2); /* Gauss 5 of u - u_h */
        close_to(got.energy, want->H1, 1e-7 * want->H1);
    }
}

/* u = x, u_h = 0: the energy error is (int beta)^(1/2) exactly. */
static double identity(double x)
{
    return x;
}
static void energy_is_weighted_with_beta(void)
{
    const double x[] = {0.0, 0.4, 1.0}, u[] = {0.0, 0.0, 0.0};
    const struct poisson_error error =
        poisson_errors(2, x, u, bvp_beta, identity, field_one);
    close_to(error.energy, sqrt(1.5), 1e-15);
    close_to(error.L2, sqrt(1.0 / 3.0), 1e-15);
    close_to(error.nodal, 1.0, 1e-15);
}

static double moment(double x, void *params)
{
    const double *end = params; /* x0, x1: f e_1 on the element */
    return smooth(x) * (x - end[0]) / (end[1] - end[0]);
}

static void element_load_converges_to_gsl(void)
{
    double ends[2] = {0.31, 0.34}, K[2][2], r[2], want, error;
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(100);
    gsl_function integrand = {moment, ends};
    gsl_integration_qag(&integrand, ends[0], ends[1], 0.0, 1e-12, 100,
                        GSL_INTEG_GAUSS21, work, &want, &error);
    gsl_integration_workspace_free(work);
    poisson_element(ends[0], ends[1], bvp_beta, smooth, &GAUSS2, K, r);
    close_to(r[1], want, 1e-8); /* h^5 / 4320 (f e_1)'''' is 5e-9 */
    close_to(K[0][0], 1.325 / 0.03, 1e-12);
    ck_assert(K[0][0] == -K[0][1] && K[0][1] == K[1][0]);
}

/* u' is the derivative of u and -(beta u')' is f, by central differences. */
static void given_problems_solve_their_equation(void)
{
    static field *const problem[][4] = {
        {bvp_beta, bvp_f, bvp_exact, bvp_exact_dx},
        {smooth_beta, smooth_f, smooth_exact, smooth_exact_dx}};
    const double h = 1e-5;
    for (int k = 0; k < COUNT(problem); k++) {
        field *beta = problem[k][0], *f = problem[k][1];
        field *u = problem[k][2], *dx = problem[k][3];
        for (double x = 0.0371; x < 1.0; x += 0.2385) {
            const double l = x - h, r = x + h;
            close_to((u(r) - u(l)) / (2.0 * h), dx(x), 1e-8);
            close_to(-(beta(r) * dx(r) - beta(l) * dx(l)) / (2.0 * h), f(x),
                     1e-7);
        }
    }
}

static void a_nan_is_not_swallowed(void)
{
    double x[3] = {0.0, 0.5, 1.0}, u[3] = {1.0, NAN, 0.8};
    const struct poisson_error error =
        poisson_errors(2, x, u, field_one, bvp_exact, bvp_exact_dx);
    ck_assert(isnan(error.nodal) && isnan(error.L2) && isnan(error.energy));
}

/* Whatever was in A and b before. */
static void assembly_starts_from_zero(void)
{
    const double x[] = {0.1, 0.4, 0.7371};
    for (int fitted = 0; fitted <= 1; fitted++) {
        struct matrix *A = matrix_alloc(BANDED, 3, 1), *first = NULL;
        double b[2][3];
        for (int k = 0; k < 2; k++) {
            if (fitted)
                fitted_assemble(2, x, A, b[k]);
            else
                poisson_assemble(2, x, smooth, bvp_f, &GAUSS2, A, b[k]);
            if (!first) first = matrix_copy(A);
        }
        for (int i = 0; i < 3; i++) {
            ck_assert(b[0][i] == b[1][i] && b[0][i] > 0.0);
            for (int j = 0; j < 3; j++)
                ck_assert(matrix_get(A, i, j) == matrix_get(first, i, j));
        }
        matrix_free(first);
        matrix_free(A);
    }
    ck_assert(field_one(2.385) == 1.0 && field_zero(2.385) == 0.0);
}

/* The load against GSL's adaptive quadrature; the fitted test functions are
 * straight lines in ln(1 + x). */
struct tested {
    double x0, x1;
    int a, fitted;
};

static double tested_load(double x, void *context)
{
    const struct tested *t = context;
    const double s = t->fitted ? log((1.0 + x) / (1.0 + t->x0)) /
                                     log((1.0 + t->x1) / (1.0 + t->x0))
                               : (x - t->x0) / (t->x1 - t->x0);
    return bvp_f(x) * (t->a ? s : 1.0 - s);
}

static void loads_in_closed_form_equal_gsl(void)
{
    gsl_integration_cquad_workspace *work =
        gsl_integration_cquad_workspace_alloc(100);
    struct matrix *A = matrix_alloc(DENSE, 2, 1);
    for (int fitted = 0; fitted <= 1; fitted++)
        for (double h = 0.5; h > 1e-3; h *= 0.2385) {
            const double x[] = {0.3714, 0.3714 + h};
            double b[2];
            bvp_exact_load(1, x, b);
            if (fitted) fitted_assemble(1, x, A, b);
            for (int a = 0; a < 2; a++) {
                struct tested t = {x[0], x[1], a, fitted};
                gsl_function function = {tested_load, &t};
                double want, error;
                size_t calls;
                gsl_integration_cquad(&function, x[0], x[1], 0.0, 1e-12, work,
                                      &want, &error, &calls);
                close_to(b[a], want, 1e-11 * want);
            }
            if (!fitted) continue;
            close_to(matrix_get(A, 0, 0) * log((1.0 + x[1]) / (1.0 + x[0])),
                     1.0, 1e-12);
            close_to(matrix_get(A, 0, 0) + matrix_get(A, 0, 1), 0.0, 1e-12);
        }
    matrix_free(A);
    gsl_integration_cquad_workspace_free(work);
}

static void the_fitted_system_is_exact_at_the_nodes(void)
{
    enum { n = 7 };
    double x[n + 1], u[n + 1];
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    poisson_grid(0.0, 1.0, n, 2.385, x);
    fitted_assemble(n, x, A, u);
    exercise_boundary(n, A, u);
    ck_assert_int_eq(matrix_factor(A), OK);
    matrix_solve(A, u);
    for (int j = 0; j <= n; j++) close_to(u[j], bvp_exact(x[j]), 1e-14);
    matrix_free(A);
}

UNIT_MAIN("poisson",
    LAW(grid_is_geometric_and_meets_its_ends),
    LAW(rules_have_their_degree),
    LAW(exercise_5_equals_the_oracle),
    LAW(errors_equal_the_oracles),
    LAW(energy_is_weighted_with_beta),
    LAW(element_load_converges_to_gsl),
    LAW(loads_in_closed_form_equal_gsl),
    LAW(the_fitted_system_is_exact_at_the_nodes),
    LAW(given_problems_solve_their_equation),
    LAW(assembly_starts_from_zero),
    LAW(a_nan_is_not_swallowed))
