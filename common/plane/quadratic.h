/*
 * quadratic.h - a body of quadratic triangles, on the vertices of a mesh of
 * linear ones.
 *
 * mesh.h with an even number of cells and of rows: two by two of its cells are
 * a square, cut from its lower left to its upper right corner into two
 * triangles of six nodes; so held[], u, and the places where solutions are
 * compared are those of the linear triangles:
 *
 *         2            nodes 0 1 2: the vertices, counter-clockwise;
 *         | \          3 4 5: the middles of the edges opposite to them, where
 *         4   3        quadratic_straighten() puts them
 *         |     \
 *         0---5---1    l_0 l_1 l_2: barycentric coordinates, which add up to 1
 *
 *     N_a = l_a (2 l_a - 1) at a vertex, 4 l_b l_c in the middle of an edge
 *                                                       [eq:quadratic-shape]
 *
 * grad u is linear on a triangle, so that the energy is summed up at three
 * points, a third of the area each [eq:three-points].  The mass is diagonal: of
 * a triangle 3/57 at each vertex and 16/57 at each middle [eq:scaled-mass].
 *
 * The body of such triangles is that of body.h.
 *
 * Source: Hinton, Rock and Zienkiewicz, Earthquake Engineering and Structural
 *         Dynamics 4 (1976) 245 (the mass).
 */
#ifndef COMMON_QUADRATIC_H
#define COMMON_QUADRATIC_H

#include "plane/mesh.h"

enum { QUADRATIC_NODES = 6, QUADRATIC_POINTS = 3 };

/* The six functions at l, and their gradients (1/m), by those of l:
 * gradient[2 a + j] = dN_a / dX_j, of_l[2 v + j] = dl_v / dX_j. */
void quadratic_shape(const double l[3], const double of_l[6], double N[6],
                     double gradient[12]);

/* The six nodes of triangle e, 0 <= e < n rows / 2: by squares, row by row, the
 * one below the cut first. */
void quadratic_nodes(const struct mesh *mesh, int e, int node[6]);

/* Put each vertex between two corners of the triangles into the middle of its
 * edge: after mesh_grade(), or whatever else has moved vertices. */
void quadratic_straighten(struct mesh *mesh);

/* Return the gradients (1/m) of the six functions of triangle e at the three
 * points: gradient[p][2 a + j] = dN_a / dX_j.  Returns its area (m^2); straight
 * edges are asserted. */
double quadratic_gradients(const struct mesh *mesh, int e,
                           double gradient[QUADRATIC_POINTS]
                                          [2 * QUADRATIC_NODES]);

/* area[a] := the area whose mass vertex a has (m^2) [eq:scaled-mass]. */
void quadratic_shares(const struct mesh *mesh, double area[]);

/* f += the nodal forces of a constant body force (N/m^2): of a triangle
 * nothing at its vertices, and a third of it in each middle. */
void quadratic_load(const struct mesh *mesh, const double density[2],
                    double f[]);

/* List for sparse_alloc() that any two nodes of a triangle are neighbours:
 * *n_list triangles of three vertices each, in which every pair of the six
 * occurs.  The caller frees it. */
int *quadratic_pairs(const struct mesh *mesh, int *n_list);

#endif
