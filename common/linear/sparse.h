/*
 * sparse.h - Cholesky factorisation in the order of nested dissection.
 *
 * Each piece of dissection.h is a front of front.h: its vertices are the
 * pivots; its rest are the later vertices next to what has been numbered inside
 * it [eq:fill].
 *
 * The analysis knows the mesh and what is held.  It is made once, and any
 * number of matrices may use it.  Their entries are 2x2 blocks, of a vertex and
 * one of its neighbours, by columns: for each vertex, in the order of
 * elimination, its own block and then those of its later neighbours:
 *
 *     a[4 b] a[4 b + 2]      block b, start[v] <= b < start[v+1], is that of
 *     a[4 b + 1] a[4 b + 3]  row row[b] and column v (above the diagonal: 0)
 *
 * Source: Davis, Direct Methods for Sparse Linear Systems, chapter 4; Liu, SIAM
 *         Review 34 (1992) 82 (the multifrontal method).
 */
#ifndef COMMON_SPARSE_H
#define COMMON_SPARSE_H

#include "linear/dissection.h"
#include "base/status.h"

#include <stddef.h>

/* So many vertices are not cut any further; measured, then fixed. */
enum { SPARSE_LEAF = 16 };

struct sparse_front;

struct sparse {
    struct dissection *order;
    int n_vertex;           /* of it, and so are these: */
    const int *place;       /* unknowns are 2 place and 2 place + 1 */
    const int *start, *row; /* the blocks */
    struct sparse_front *front; /* [order->n_piece] */
    int *local;             /* where a block is in the front of its column */
    int *rest, *up;         /* of all fronts: places; rows in the parent */
    size_t factor, room;    /* numbers of L, and of room to work */
    size_t vector, l;       /* where in the room a vector, a front begin */
    double numbers;         /* entries of L, those of the fronts */
    double flops, solve;    /* as those of matrix_cost() of matrix.h */
};

/* Dissect as dissection_alloc(), with a leaf of SPARSE_LEAF unless it is
 * measured. */
struct sparse *sparse_alloc(int columns, int rows, int n_triangle,
                            const int triangle[], const int held[], int leaf);
void sparse_free(struct sparse *s);

/* Return the numbers of the memory below: room to work, and L, as it is or
 * rounded. */
size_t sparse_size(const struct sparse *s, int single);

/* Factor a, in double precision; keep L in single precision, or as it is.  The
 * memory starts at a line of the cache.  Statuses as matrix_factor().  And, b
 * not NULL, b := A^{-1} b, to the digit as sparse_solve(): its first half goes
 * with the factorisation, which has each front in the cache. */
enum status sparse_factor(const struct sparse *s, const double a[], int single,
                          double memory[], double b[]);

/* b := A^{-1} b, for L as it is kept. */
void sparse_solve(const struct sparse *s, int single, double memory[],
                  double b[]);

#endif
