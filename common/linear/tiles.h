/*
 * tiles.h - Cholesky factorisation of a wide band, when seconds count.
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

#include "base/status.h"
#include "linear/vec.h"

/* From this half bandwidth on the routines below may be used. */
enum { TILES_WIDE = 15 };

/* Return the numbers in a column: one more than an odd multiple of 8.  A row
 * then keeps its place in a line of the cache from column to column, columns do
 * not compete for one place in the cache, and no tile reaches into the next. */
size_t tiles_stride(int p);

/* A = L L^T in place [eq:cholesky]; statuses as matrix_factor() of matrix.h. */
enum status tiles_factor(int n, int p, size_t stride, double a[]);

/* b := A^{-1} b, for L from tiles_factor(). */
void tiles_solve(int n, int p, size_t stride, const double l[], double b[]);

/* Factor the triangle at the diagonal of a panel of w columns, of a band or a
 * front.  t[c] is column c of it, after the columns before the panel have been
 * subtracted; it becomes L_cc times column c of L.  For the tiles below it,
 * l[c][b] := L_bc / L_cc and inverse[c] := 1 / L_cc.  A_cc is
 * diagonal[c * apart]; statuses as tiles_factor().
 *
 * With sign, not NULL, A = L S L^T: sign[c] := 1 or -1, that of the pivot; t[c]
 * becomes S_c L_cc times column c of L, and inverse[c] := S_c / L_cc.  NOT_SPD
 * then says that a pivot is 0 to round-off. */
enum status tiles_triangle(int n, int w, const double diagonal[],
                           ptrdiff_t apart, double sign[], vec t[W], vec l[W],
                           double inverse[W]);

#endif
