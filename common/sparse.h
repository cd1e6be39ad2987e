/*
 * sparse.h - Cholesky factorisation in the order of nested dissection.
 *
 * A line of vertices cuts the square of mesh.h in two that have no edge in
 * common.  They are numbered first, each cut in its turn, and the line last
 * [alg:dissection]:
 *
 *     1 1 1 7 4 4 4       the lines fill, and little else does: n^2 log n
 *     1 1 1 7 4 4 4       numbers and n^3 flops, where a band takes n^3 and n^4
 *     3 3 3 7 6 6 6
 *     2 2 2 7 5 5 5       Each number is a front of banded.h: its vertices are
 *     2 2 2 7 5 5 5       the pivots; its rest are the later vertices next to
 *                         what has been numbered inside it.
 *
 * The analysis knows the mesh and what is held.  It is made once, and any number
 * of matrices may use it.  Their entries are 2x2 blocks by columns, a vertex and
 * one of its neighbours; for each vertex, in the order of elimination, its own
 * block and then those of its later neighbours:
 *
 *     a[4 b] a[4 b + 2]      block b, start[v] <= b < start[v+1], is that of
 *     a[4 b + 1] a[4 b + 3]  row row[b] and column v (above the diagonal: 0)
 *
 * Source: George, SIAM J. Numer. Anal. 10 (1973); Davis, Direct Methods for
 *         Sparse Linear Systems, chapters 4 (Cholesky) and 7 (orderings).
 */
#ifndef COMMON_SPARSE_H
#define COMMON_SPARSE_H

#include "banded.h"
#include "mesh.h"

/* So many vertices are not cut any further; measured, then fixed. */
enum { SPARSE_LEAF = 16 };

struct sparse_front;

struct sparse {
    int n_vertex;  /* free ones; their places in the order are what counts */
    int *place;    /* [vertices of the mesh] place of a vertex, -1: held */
    int *start;    /* [n_vertex + 1] */
    int *row;      /* [start[n_vertex]] */
    int *local;    /* [start[n_vertex]] row of a block in the front */
    int n_front;
    struct sparse_front *front; /* in the order of elimination */
    int *rest, *up;             /* of all fronts: places; rows in the parent */
    size_t factor, work;        /* numbers that sparse_factor() needs */
    size_t vector;              /* where in the work a vector begins */
    double numbers;             /* entries of L, those of the fronts */
    double flops, solve;        /* as those of matrix_cost() of matrix.h */
};

/* held[a] != 0: vertex a is left out; not all may be.  leaf >= 1: as
 * SPARSE_LEAF.  The caller frees it. */
struct sparse *sparse_alloc(const struct mesh *mesh, const int held[],
                            int leaf);
void sparse_free(struct sparse *s);

/* The block of places i >= j, -1: it is zero. */
int sparse_block(const struct sparse *s, int i, int j);

/* l := the factor of a; l is [s->factor], work [s->work].  Both start at a line
 * of the cache.  Statuses as matrix_factor() of matrix.h. */
enum status sparse_factor(const struct sparse *s, const double a[], double l[],
                          double work[]);

/* b := A^{-1} b. */
void sparse_solve(const struct sparse *s, double l[], double work[],
                  double b[]);

#endif
