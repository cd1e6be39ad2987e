/*
 * numbering.h - which equation an unknown has, and where its entries stand.
 *
 * equation[2a + i] of component i of vertex a; -1 where u is prescribed.  In a
 * band the vertices are numbered row by row from right to left, so that the
 * diagonals of the mesh do not widen the band: half bandwidth 2 n - 1 of linear
 * triangles with both ends prescribed.  Where the rows are longer than the
 * columns it is by columns from the top down: 2 rows + 3.  In sparse storage
 * they are numbered as sparse.h eliminates them.
 *
 * The vertices of an element are sorted by equation: then block (a, b) of its
 * matrix, a >= b, belongs to the lower triangle of K.
 */
#ifndef COMMON_NUMBERING_H
#define COMMON_NUMBERING_H

#include "linear/matrix.h"
#include "plane/mesh.h"

struct sparse;

/* Elements of so many vertices each, vertex[nodes e + a]. */
struct numbering {
    int n_element, nodes;
    const int *vertex, *equation; /* borrowed; vertex in numbering_order() */
};

/* Number all entries that are not -1, as the pattern has it, or (NULL) along
 * the lines of the mesh.  Returns how many. */
int numbering_lines(const struct mesh *mesh, const struct sparse *pattern,
                    int equation[]);

/* order := 0, 1, ... nodes - 1 in the order of these vertices' equations;
 * those that are prescribed first, as they stand. */
void numbering_order(int nodes, const int vertex[], const int equation[],
                     int order[]);

/* Return for K the largest difference of two equations of one element. */
int numbering_half_bandwidth(struct numbering elements);

/* place := for each element where in K->a its 2x2 blocks (0,0) (1,0) (1,1)
 * (2,0) ... begin; -1: a vertex is prescribed. */
void numbering_places(struct numbering elements, const struct matrix *K,
                      int place[]);

#endif
