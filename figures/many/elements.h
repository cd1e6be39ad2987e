/*
 * elements.h - a body that keeps its element matrices one by one.
 *
 * PETSc adds up what triangles share, so K is here a row of 2x2 blocks, six for
 * each triangle, in the order and the form in which triangles.c makes them:
 *
 *     k = 6 e + (0: (0,0)  1: (1,0)  2: (1,1)  3: (2,0)  4: (2,1)  5: (2,2))
 *     K->a[4 k ...] = m00 m10 m01 m11, where a block (a, a) leaves m01 out
 *
 * In the terms of matrix.h this is a band whose columns have three numbers: the
 * second column of a block begins two numbers behind the first.
 */
#ifndef MANY_ELEMENTS_H
#define MANY_ELEMENTS_H

#include "plane/body.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

enum { ELEMENT_KEPT = 24, ELEMENT_ENTRIES = 36 }; /* in K->a; of a 6x6 matrix */

/* A body whose K is for body_assemble() and elements_values() only.  One free
 * vertex will do: the equations are somebody else's. */
static inline struct body *elements_alloc(const struct mesh *mesh,
                                          struct material material, double rho,
                                          enum mass mass)
{
    assert(mesh->n_triangle < INT_MAX / ELEMENT_KEPT); /* place is an int */
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int a = 1; a < mesh->n_vertex; a++) held[a] = 1;
    struct body *body = body_alloc(mesh, material, rho, mass, held);
    free(held);
    matrix_free(body->K);
    body->K = matrix_alloc(BANDED, mesh->n_triangle * ELEMENT_KEPT / 3, 2);
    for (int k = 0; k < 6 * mesh->n_triangle; k++) body->place[k] = 4 * k;
    return body;
}

/* Entry k of all entries, ELEMENT_ENTRIES per triangle, row by row: its row and
 * column among those of its triangle, 0 to 5, and their displacements. */
struct element_entry {
    int i, j;        /* in the element matrix */
    int row, column; /* 2 vertex + component */
};

static inline struct element_entry element_entry(const struct body *body,
                                                 size_t k)
{
    const int *vertex = &body->vertex[k / ELEMENT_ENTRIES * 3];
    const int i = (int)(k % ELEMENT_ENTRIES) / 6, j = (int)(k % 6);
    return (struct element_entry){i, j, 2 * vertex[i / 2] + i % 2,
                                  2 * vertex[j / 2] + j % 2};
}

/* value[ELEMENT_ENTRIES n_triangle] := all entries, from body->K. */
static inline void elements_values(const struct body *body, double value[])
{
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const double *kept = &body->K->a[(size_t)e * ELEMENT_KEPT];
        for (int row = 0; row < 6; row++)
            for (int column = 0; column < 6; column++) {
                const int i = row > column ? row : column;
                const int j = row + column - i, a = i / 2, b = j / 2;
                const int block = a * (a + 1) / 2 + b;
                *value++ = kept[4 * block + i % 2 + j % 2 * 2];
            }
    }
}

#endif
