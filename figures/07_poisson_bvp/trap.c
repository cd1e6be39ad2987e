/*
 * trap.c - what do nodal errors measure?
 *
 * The exercise, beta = 1 + x, and its companion with beta = 1, whose solution
 * is 1 + ln(1+x) - x: the nodal error is that of the quadrature of the load
 * [eq:quadrature-b] and of nothing else, order 2, order 4 or none, while the L2
 * error has order 2 whatever one does.  `fitted` tests with functions of
 * constant flux (fitted.h) and makes the exercise exact at its nodes, too.
 */
#include "fitted.h"
#include "../08_element_assembly/exercise.h"
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

static double companion_exact(double x)
{
    return 1.0 + log1p(x) - x;
}

static double companion_exact_dx(double x)
{
    return -x / (1.0 + x);
}

enum load { MIDPOINT_RULE, GAUSS2_RULE, EXACT_LOAD, FITTED };

static struct poisson_error errors_of(int companion, enum load load, int n)
{
    field *beta = companion ? field_one : bvp_beta;
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *u = allocate((size_t)n + 1, sizeof *u);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, beta, bvp_f,
                     load == GAUSS2_RULE ? &GAUSS2 : &MIDPOINT, A, u);
    if (load == EXACT_LOAD) bvp_exact_load(n, x, u);
    if (load == FITTED) fitted_assemble(n, x, A, u);
    exercise_boundary(n, A, u);
    if (matrix_factor(A) != OK) die("A is not positive definite");
    matrix_solve(A, u);
    const struct poisson_error error =
        poisson_errors(n, x, u, beta, companion ? companion_exact : bvp_exact,
                       companion ? companion_exact_dx : bvp_exact_dx);
    matrix_free(A);
    free(x);
    free(u);
    return error;
}

int main(void)
{
    enum { MIDPOINT_, GAUSS2_, EXACT, L2, EXERCISE, FIT, FIT_L2, COLUMNS };
    const double round_off = 4e-12; /* above n eps, u being of size 1 */
    double error[8][COLUMNS], order[8][COLUMNS], noise = 0.0;

    table_begin("trap", "n midpoint midpoint_order midpoint_constant gauss2 "
                "gauss2_order gauss2_constant exact exact_order exact_constant "
                "L2 L2_order L2_constant exercise exercise_order "
                "exercise_constant fitted fitted_order fitted_constant "
                "fitted_L2 fitted_L2_order fitted_L2_constant");
    for (int i = 0; i < 8; i++) {
        const int n = 4 << i;
        const struct poisson_error exact = errors_of(1, EXACT_LOAD, n);
        const struct poisson_error fitted = errors_of(0, FITTED, n);
        const double all[COLUMNS] = {errors_of(1, MIDPOINT_RULE, n).nodal,
                                     errors_of(1, GAUSS2_RULE, n).nodal,
                                     exact.nodal, exact.L2,
                                     errors_of(0, EXACT_LOAD, n).nodal,
                                     fitted.nodal, fitted.L2};
        struct cell row[1 + 3 * COLUMNS] = {cell_number(n)};
        for (int k = 0; k < COLUMNS; k++) {
            error[i][k] = all[k];
            order[i][k] =
                i > 0 ? study_order(error[i - 1][k], all[k], 2.0) : 0.0;
            const int measured = i > 0 && all[k] > round_off &&
                                 error[i - 1][k] > round_off;
            row[1 + 3 * k] = cell_number(all[k]);
            row[2 + 3 * k] = cell_if(measured, order[i][k]);
            row[3 + 3 * k] = cell_if(measured, all[k] * pow(n, order[i][k]));
        }
        noise = fmax(noise, fmax(all[EXACT], all[FIT]));
        table_row_of(1 + 3 * COLUMNS, row);
    }
    table_end();

    /* at n = 64 the next term of an order is 1e-3 or less */
    const int two[] = {MIDPOINT_, L2, EXERCISE, FIT_L2};
    for (int k = 0; k < 4; k++)
        claim(fabs(order[4][two[k]] - 2.0) < 2e-3, "an order that should be "
              "2 is %g", order[4][two[k]]);
    claim(fabs(order[3][GAUSS2_] - 4.0) < 2e-2, "two-point Gauss: order 4 (%g)",
          order[3][GAUSS2_]);
    claim(noise < round_off, "exact integrals: round-off at the nodes (%g)",
          noise);
    return table_finish();
}
