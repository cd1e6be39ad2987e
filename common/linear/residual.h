/*
 * residual.h - how well a system has been solved.
 *
 * Names: matrix_.
 */
#ifndef COMMON_RESIDUAL_H
#define COMMON_RESIDUAL_H

#include "linear/matrix.h"

/* max_i |b - A x|_i for an A that is not factored; NaN if any entry is. */
double matrix_residual(const struct matrix *A, const double x[],
                       const double b[]);

/*
 * Return |b - A u| / (|A| |u| + |b|) in units of eps, maximum norms, for an A
 * that is not factored: how far the system that u solves exactly is from A u =
 * b.  NaN if an entry is.  Source: Higham, Accuracy and Stability of Numerical
 * Algorithms, 2nd ed., theorem 7.1.
 */
double matrix_backward_error(const struct matrix *A, const double u[],
                             const double b[]);

#endif
