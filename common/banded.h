/*
 * banded.h - Cholesky factorisation of a wide band or a front, when seconds
 * count.
 *
 * The lower triangle by columns, every column with room to spare:
 *
 *     a[j*stride + d] = A[j+d][j], 0 <= d <= p,   stride >= band_stride(p)
 *
 * which is LAPACK's lower band with ldab = stride.  The room, p < d < stride,
 * and what lies below the last row hold zeros; they stay zeros.  Memory that
 * starts at a line of the cache (64 bytes) is a little faster.
 */
#ifndef COMMON_BANDED_H
#define COMMON_BANDED_H

#include "status.h"

#include <stddef.h>

/* From this half bandwidth on the routines below may be used. */
enum { BAND_WIDE = 15 };

/* Numbers a column: one more than an odd multiple of 8.  A row then keeps its
 * place in a line of the cache from column to column, columns do not compete
 * for one place in the cache, and no tile reaches into the next column. */
size_t band_stride(int p);

/* A = L L^T in place [eq:cholesky]; statuses as matrix_factor() of matrix.h. */
enum status band_factor(int n, int p, size_t stride, double a[]);

/* b := A^{-1} b, for L from band_factor(). */
void band_solve(int n, int p, size_t stride, const double l[], double b[]);

/*
 * A front of sparse.h: the dense columns of some pivots with all their rows,
 * and u, which is what they subtract from the rows and columns of the rest.
 *
 *      pivots  rest       pivots, and the rest, fill up whole blocks of V rows
 *     | l         |       with zeros; blocks of a panel of V columns lie in
 *     | l l       |       memory one after the other, each by columns, so that
 *     | l l   u   |       factoring and solving read it from end to end.  The
 *     | l l   u u |       last panel of pivots is as wide as it must be.
 */
struct front {
    int pivots, rest; /* numbers of unknowns, even */
    double *l, *u;    /* [front_size()], [front_size(front_row(rest, 0), 0)] */
    int fresh;        /* u counts as zero, whatever it holds */
};

/* How many numbers l holds, and in which row unknown k of the rest is; that of
 * a pivot is its number. */
size_t front_size(int pivots, int rest);
int front_row(int pivots, int k);

/* Entry (i, j) of l or u, for rows i >= j. */
double *front_entry(const struct front *front, int i, int j);

/* Add u of a child to its parent; row[k] is where unknowns 2 k and 2 k + 1 of
 * the child's rest are. */
void front_extend(const struct front *child, const int row[],
                  const struct front *parent);

/* l := L, u := u - L L^T of the rest.  Statuses as matrix_factor(), with the
 * order n of the matrix and the diagonal entries that it has at the pivots. */
enum status front_factor(const struct front *front, int n,
                         const double diagonal[]);

/* The pivots' part of x := L^-1 x, which subtracts from the rest; and of
 * x := L^-T x.  x is [front_row(pivots, rest)] and on to the end of a block. */
void front_forward(const struct front *front, double x[]);
void front_backward(const struct front *front, double x[]);

#endif
