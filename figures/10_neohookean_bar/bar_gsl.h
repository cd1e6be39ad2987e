/*
 * bar_gsl.h - Newton's method for the bar of bar.h with GSL's tridiagonal
 * solver: what bar_fast.h is measured against.
 *
 * The entries of residual and tangent go straight into the arrays that
 * gsl_linalg_solve_symm_tridiag() wants.
 *
 * Source: GSL manual, "Linear Algebra", "Tridiagonal Systems".
 */
#ifndef BAR_GSL_H
#define BAR_GSL_H

#include "bar/bar.h"

/*
 * bar_newton() for the law CUBIC, the left end held and the right end free,
 * n > 1, neither line_search nor definite (asserted): the same iterates to the
 * round-off of its pivots.
 *
 * NOT_SPD    the solver met a pivot that is 0, before the last, at which GSL
 *            does not look
 * NONFINITE  a NaN or an infinity came out
 */
struct newton_report bar_gsl_newton(const struct bar *bar,
                                    const struct newton_control *control,
                                    double u[]);

#endif
