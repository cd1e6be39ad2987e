/*
 * banded.h - Cholesky factorisation in a band: the banded solver of the notes.
 *
 * Number the nodes along the bar and A[i][j] = 0 whenever |i - j| > p.  L has
 * the same band, so nothing outside of it is ever touched [eq:band-cost].  The
 * lower triangle is kept by columns:
 *
 *     A = | a0 b0 c0  . |     a[j*(p+1) + d] = A[j+d][j],  0 <= d <= p
 *         | b0 a1 b1 c1 |
 *         | c0 b1 a2 b2 |     a0 b0 c0 | a1 b1 c1 | a2 b2 * | a3 * *
 *         |  . c1 b2 a3 |
 *
 * which is GSL's symmetric band format, and LAPACK's lower band with
 * ldab = p + 1.  The entries * beyond the last row are 0 and stay it.  These
 * are the textbook's loops, for any p; tiles.h does wide bands faster.
 *
 * Source: Golub & Van Loan, Matrix Computations, 4th ed., sec. 4.1.2,
 *         4.3.6.
 */
#ifndef COMMON_BANDED_H
#define COMMON_BANDED_H

#include "base/status.h"

/*
 * A = L L^T in place [eq:cholesky], column after column:
 *
 *     L_jj = sqrt(A_jj - sum_k L_jk^2),
 *     L_ij = (A_ij - sum_k L_ik L_jk) / L_jj,  j < i <= j + p,
 *
 * sums over the earlier columns k within the band; a tridiagonal A, p = 1, as
 * L D L^T with ones on the diagonal of L, which takes no square root (Thomas).
 * NOT_SPD as matrix_factor() of matrix.h has it; a is then partly overwritten.
 */
enum status banded_factor(int n, int p, double a[]);

/* b := A^{-1} b, for what banded_factor() has made of A. */
void banded_solve(int n, int p, const double l[], double b[]);

#endif
