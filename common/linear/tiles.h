/*
 * tiles.h - Cholesky factorisation of a wide band or a front, when seconds
 * count.
 *
 * The lower triangle by columns, every column with room to spare:
 *
 *     a[j*stride + d] = A[j+d][j], 0 <= d <= p,   stride >= tiles_stride(p)
 *
 * which is LAPACK's lower band with ldab = stride.  The room, p < d < stride,
 * and what lies below the last row hold zeros; they stay zeros.  Memory that
 * starts at a line of the cache (64 bytes) is a little faster.
 */
#ifndef COMMON_TILES_H
#define COMMON_TILES_H

#include "linear/front.h"
#include "base/status.h"

#include <stddef.h>

/* From this half bandwidth on the routines below may be used. */
enum { TILES_WIDE = 15 };

/* Numbers a column: one more than an odd multiple of 8.  A row then keeps its
 * place in a line of the cache from column to column, columns do not compete
 * for one place in the cache, and no tile reaches into the next column. */
size_t tiles_stride(int p);

/* A = L L^T in place [eq:cholesky]; statuses as matrix_factor() of matrix.h. */
enum status tiles_factor(int n, int p, size_t stride, double a[]);

/* b := A^{-1} b, for L from tiles_factor(). */
void tiles_solve(int n, int p, size_t stride, const double l[], double b[]);

/* Keep L of a front, and u := -L L^T of its rest.  Statuses as matrix_factor(),
 * with the order n of the matrix and the diagonal entries of it at the pivots.
 */
enum status tiles_front(const struct front *front, int n,
                         const double diagonal[]);

#endif
