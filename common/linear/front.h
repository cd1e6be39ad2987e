/*
 * front.h - the fronts of sparse.h: dense columns of some pivots with all their
 * rows, and u, which they subtract from rows and columns of the rest.
 *
 *      pivots  rest       pivots, and the rest, fill up whole blocks of V rows
 *     | l         |       (vec.h) with zeros; blocks of a panel of V columns
 *     | l l       |       lie in memory one after another, each by columns, so
 *     | l l   u   |       that factoring and solving read it from end to end.
 *     | l l   u u |       The last panel of pivots is as wide as it must be.
 *
 * What is kept of it is L, but for the triangle at the diagonal of each panel,
 * which is inverted and transposed: a solve then has no number in it that waits
 * for the one before.  It is kept in double precision, where l is, or rounded
 * to single precision, elsewhere.
 */
#ifndef COMMON_FRONT_H
#define COMMON_FRONT_H

#include "base/status.h"

#include <stddef.h>

struct front {
    int pivots, rest; /* numbers of unknowns, even */
    double *l, *u;    /* [front_size()], [front_size(front_row(rest, 0), 0)] */
    float *rounded;   /* the kept numbers, [front_size()]; NULL: l */
    double *sign;     /* S of the pivots in A = L S L^T, or NULL: A = L L^T */
};

/* Return how many numbers l holds, and in which row unknown k of the rest is;
 * that of a pivot is its number. */
size_t front_size(int pivots, int rest);
int front_row(int pivots, int k);

/* Return where in l entry (i, j) is, i >= j, j a pivot. */
int front_place(int pivots, int rest, int i, int j);

/* l := n 2x2 blocks, each by columns, block k at place[k]. */
void front_fill(const struct front *front, int n, const int place[],
                const double block[]);

/* Add u of a child to its parent; row[k] is where unknowns 2 k and 2 k + 1 of
 * the child's rest are.  To l, before the parent is factored; or (after) to u,
 * when that has given it numbers. */
void front_extend(const struct front *child, const int row[],
                  const struct front *parent, int after);

/* Keep L of a front, and u := -L L^T (-L S L^T) of its rest.  Statuses as
 * matrix_factor(), with the order n of the matrix and the diagonal entries of
 * it at the pivots; with signs NOT_SPD is that of matrix_solve_indefinite(). */
enum status front_factor(const struct front *front, int n,
                         const double diagonal[]);

/* The pivots' part of x := L^-1 x, which subtracts from the rest; and of
 * x := L^-T x.  x is [front_row(pivots, rest)] and on to the end of a block. */
void front_forward(const struct front *front, double x[]);
void front_backward(const struct front *front, double x[]);

#endif
