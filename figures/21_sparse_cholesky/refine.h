/*
 * refine.h - iterative refinement: the digits that rounded factors have lost.
 *
 *     x := 0;   r := b - A x, in double precision;   x := x + (L L^T)^-1 r
 *                                                                 [eq:refine]
 * until |r| <= tolerance (max A_ii |x| + |b|), maximum norms: then x solves a
 * system exactly that is as close to A x = b.  Where the factors are off by
 * delta |A|, each turn divides the error by some 1 / (delta cond(A)); those in
 * single precision give seven digits at first, and twelve after a turn more.
 *
 * Source: Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed.,
 *         chapter 12.
 */
#ifndef FIGURES_REFINE_H
#define FIGURES_REFINE_H

#include "linear/matrix.h"

/*
 * b := A^-1 b for a sparse A that matrix_factor() has factored, in *solves
 * (which may be NULL) solves.  STALLED: a turn has not halved the residual;
 * NONFINITE: a NaN or an infinity.  b is then x as far as it is known.
 */
enum status refine_solve(const struct matrix *A, double tolerance, double b[],
                         int *solves);

#endif
