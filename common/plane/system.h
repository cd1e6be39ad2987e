/*
 * system.h - the linear system on which solvers are compared.
 *
 * The stretch of scene.h, cubic law, and the first iteration of Newton's method
 * in a step that begins at rest, with itself for a guess, with
 *
 *     u = 1/20 (X1, -1/2 (1 - X1^2) X2):
 *
 * K du = -q, positive definite.  No number of it comes from a factorisation or
 * from libm, so that all of its digits are the same on every machine: what an
 * iteration makes of them is, too.  Its free vertices are the columns i = 0 to
 * n - 2 between the held ends and the rows j = 0, ..., n:
 *
 *     |  9 10 11 |     vertex j (n - 1) + i; with place[] some order of them,
 *     |  6  7  8 |     unknown 2 place + k is component k
 *     |  3  4  5 |
 *     |  0  1  2 |     n = 4, but for its upper row
 */
#ifndef COMMON_SYSTEM_H
#define COMMON_SYSTEM_H

#include "linear/csr.h"
#include "plane/scene.h"

struct system {
    struct scene *scene; /* owned; at rest in u, K of its body assembled */
    int n_vertex;        /* free ones, (n - 1) (n + 1) */
    int *vertex;         /* [n_vertex] which one of the mesh; owned */
    double *b;           /* -q of all vertices of the mesh; owned */
};

/* Make n >= 2 squares per side.  The caller frees it. */
struct system *system_alloc(int n);

/* Store K in this storage, BANDED or SPARSE, assembled anew. */
void system_store(struct system *system, enum storage storage);
void system_free(struct system *system);

/* Assemble K, in the storage that it has, of the body that is pressed evenly, u
 * = (-squeeze X1, 0), squeeze < 1; b stays. */
void system_press(struct system *system, double squeeze);

/* Return K in an order, NULL: that of the vertices.  The caller frees it. */
struct csr *system_matrix(const struct system *system, const int place[]);

/* Copy b, [2 n_vertex], in that order; and x, of that order, back into the
 * order of the vertices. */
void system_right_side(const struct system *system, const int place[],
                       double b[]);
void system_back(const struct system *system, const int place[],
                 const double x[], double du[]);

#endif
