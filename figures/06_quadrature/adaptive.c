/*
 * adaptive.c - what do samples buy, in a solution and in an integral with a
 * kink?
 *
 * The L2 error of the smooth problem on n elements, by three rules
 * [eq:quadrature].  int |x - 1/3| dx over (0, 1) by rules on equal elements and
 * by GSL's adaptive quadrature, qag, which is not told where the kink is, and
 * qagp, which is.  Tables: both errors on n elements, where the midpoint rule
 * takes n samples, the trapezoidal rule n + 1 and Gauss 2 n; GSL's evaluations
 * and errors for a given number of digits.
 */
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>

enum { FINEST = 256 };
static const double c = 1.0 / 3.0, exact = 5.0 / 18.0;

static double kink(double x, void *evaluations)
{
    ++*(int *)evaluations;
    return fabs(x - c);
}

/* To an absolute tolerance, with a break at the kink or without one. */
static double adaptive_integral(double tolerance, int split, int *evaluations)
{
    enum { INTERVALS = 100 };
    gsl_function function = {kink, evaluations};
    gsl_integration_workspace *work =
        gsl_integration_workspace_alloc(INTERVALS);
    double breaks[] = {0.0, c, 1.0}, result, estimate;

    *evaluations = 0;
    const int status =
        split ? gsl_integration_qagp(&function, breaks, 3, tolerance, 0.0,
                                     INTERVALS, work, &result, &estimate)
              : gsl_integration_qag(&function, 0.0, 1.0, tolerance, 0.0,
                                    INTERVALS, GSL_INTEG_GAUSS21, work, &result,
                                    &estimate);
    gsl_integration_workspace_free(work);
    if (status != GSL_SUCCESS) die("quadrature: %s", gsl_strerror(status));
    return result;
}

/* Its error on n equal elements. */
static double rule_error(int n, const struct quadrature *rule)
{
    double error = exact;
    int evaluations = 0;
    for (int e = 0; e < n; e++)
        for (int k = 0; k < rule->n; k++)
            error -= rule->w[k] / n * kink((e + rule->s[k]) / n, &evaluations);
    return error;
}

/* u - u_h of -(e^x u')' = f, u = sin 2x, in L2, on n equal elements. */
static double solution_error(int n, const struct quadrature *rule)
{
    double x[FINEST + 1], u[FINEST + 1];
    const double end = smooth_exact(1.0);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, smooth_beta, smooth_f, rule, A, u);
    u[0] -= smooth_exact_dx(0.0); /* the flux, and beta = 1 there */
    matrix_dirichlet(A, u, 1, &n, &end, KEEP_DIAGONAL);
    if (matrix_factor(A) != OK) die("the matrix is not SPD");
    matrix_solve(A, u);
    matrix_free(A);
    return poisson_errors(n, x, u, smooth_beta, smooth_exact, smooth_exact_dx)
        .L2;
}

int main(void)
{
    double gauss2 = 0.0, coarse = 0.0, worst = 0.0;
    int blind = 0, split = 0, within = 1;

    gsl_set_error_handler_off();
    table_begin("solution", "n midpoint trapezoid gauss2");
    for (int n = 4; n <= FINEST; n *= 2)
        table_row(n, solution_error(n, &MIDPOINT),
                  solution_error(n, &TRAPEZOID), solution_error(n, &GAUSS2));
    table_end();
    table_begin("load_kink", "n midpoint gauss2");
    for (int n = 4; n <= 128; n *= 2) {
        coarse = gauss2;
        gauss2 = rule_error(n, &GAUSS2);
        table_row(n, rule_error(n, &MIDPOINT), gauss2);
    }
    table_end();

    table_begin_note("adaptive",
                     "digits evaluations error evaluations_split error_split",
                     "an error below 1e-13 is round-off and printed as 1e-13");
    for (int digits = 2; digits <= 8; digits++) {
        const double tolerance = pow(10.0, -digits);
        const double error =
            fabs(adaptive_integral(tolerance, 0, &blind) - exact);
        const double error_split =
            fabs(adaptive_integral(tolerance, 1, &split) - exact);
        within &= error < tolerance;
        worst = fmax(worst, error_split);
        table_row(digits, blind, fmax(error, 1e-13), split,
                  fmax(error_split, 1e-13));
    }
    table_end();

    claim(within && worst < 1e-14,
          "GSL keeps its tolerance, and with a break at the kink nothing is "
          "left but round-off (%g)", worst);
    claim(split * 10 < blind, "told where the kink is, GSL needs less than a "
          "tenth of the evaluations for eight digits (%d of %d)", split, blind);
    for (int n = 8; n <= FINEST; n *= 2)
        claim(solution_error(n, &MIDPOINT) < solution_error(n / 2, &GAUSS2) &&
                  solution_error(n, &MIDPOINT) < solution_error(n, &TRAPEZOID),
              "for the same samples the midpoint rule is the best");
    const double order = study_order(fabs(coarse), fabs(gauss2), 2.0);
    const double due = 2.0 * 128.0 * sqrt(fabs(gauss2) / 1e-8);
    claim(fabs(order - 2.0) < 0.01 && blind < 0.5 * due,
          "equal elements have order 2 (%g) and would need %g evaluations for "
          "eight digits, halving the interval %d", order, due, blind);
    return table_finish();
}
