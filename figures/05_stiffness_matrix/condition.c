/*
 * condition.c - how does the condition number grow with n, and what does one
 * short element do to it?
 *
 * beta = 1, both ends or the left one fixed; the largest eigenvalue over the
 * smallest [eq:condition-number], on equal elements next to the leading terms
 * 4 n^2 / pi^2 and 16 n^2 / pi^2 [eq:stiffness-eigenvalues], and on elements
 * with h_n / h_1 = grading.
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { FINEST = 64 };
static const double grading = 4.0;

static double condition_number(int n, int fixed, double ratio)
{
    double x[FINEST + 1], lambda[FINEST + 1];
    const int order = n + 1 - fixed;
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, ratio, x);
    poisson_assemble(n, x, field_one, field_one, &MIDPOINT, A, lambda);
    struct matrix *free_part = matrix_block(A, 1, order);
    if (matrix_eigenvalues(free_part, lambda) != OK) die("A is not finite");
    matrix_free(free_part);
    matrix_free(A);
    return lambda[order - 1] / lambda[0];
}

int main(void)
{
    double both = 0.0, one_fixed = 0.0, leading = 0.0, graded[2] = {0.0, 0.0};

    table_begin_note("condition",
                     "n both both_leading one one_leading both_graded "
                     "one_graded",
                     "graded: h_n / h_1 = %g", grading);
    for (int n = 4; n <= FINEST; n *= 2) {
        leading = 4.0 * n * n / (M_PI * M_PI);
        both = condition_number(n, 2, 1.0);
        one_fixed = condition_number(n, 1, 1.0);
        graded[0] = condition_number(n, 2, grading);
        graded[1] = condition_number(n, 1, grading);
        table_row(n, both, leading, one_fixed, 4.0 * leading, graded[0],
                  graded[1]);
    }
    table_end();

    /* what is left is 2/3, and 1 / n of the leading term */
    claim(fabs(leading - both - 2.0 / 3.0) < 1e-3,
          "with both ends fixed the condition number is 4 n^2 / pi^2 - 2/3 (it "
          "is %g)", both);
    claim(fabs(one_fixed / (4.0 * leading) - 1.0 - 1.0 / FINEST) < 1e-3,
          "with one end fixed it is (16 n^2 / pi^2) (1 + 1 / n) (it is %g)",
          one_fixed);
    claim(graded[0] > 1.4 * both && graded[1] > 1.4 * one_fixed,
          "grading raises both (to %g and %g)", graded[0], graded[1]);
    return table_finish();
}
