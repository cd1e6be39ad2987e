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
 * points, a third of the area each [eq:three-points].  Phi, q and K are those
 * of body.h, but for the mass, which is diagonal: of a triangle 3/57 at each
 * vertex and 16/57 at each middle [eq:scaled-mass].
 *
 * Source: Hinton, Rock and Zienkiewicz, Earthquake Engineering and Structural
 *         Dynamics 4 (1976) 245 (the mass).
 */
#ifndef COMMON_QUADRATIC_H
#define COMMON_QUADRATIC_H

#include "plane/body.h"

struct quadratic {
    const struct mesh *mesh;  /* borrowed */
    struct material material; /* not LINEAR */
    int n_element;
    int *node;        /* [6 n_element] of a triangle, by equation */
    double *weight;   /* [n_element] a third of the area (m^2) */
    double *gradient; /* [36 n_element] dN_a / dX_j of these nodes at point k:
                       * [12 k + 2 a + j] */
    double *mass;     /* [n_vertex] (kg) */
    int n_equation;
    int *equation;    /* [2 n_vertex] as in body.h */
    int *place;       /* [21 n_element] as in body.h, blocks (a, b), a >= b */
    struct sparse *pattern; /* of K when it is sparse, NULL when banded */
    struct matrix *K; /* tangent of the free unknowns */
};

/* The six functions at l, and their gradients (1/m), by those of l:
 * gradient[2 a + j] = dN_a / dX_j, of_l[2 v + j] = dl_v / dX_j. */
void quadratic_shape(const double l[3], const double of_l[6], double N[6],
                     double gradient[12]);

/* The six nodes of triangle e, 0 <= e < n rows / 2: by squares, row by row, the
 * one below the cut first. */
void quadratic_nodes(const struct mesh *mesh, int e, int node[6]);

/* Put what lies between the corners of the triangles into the middle of its
 * edge: after mesh_grade(), or whatever else has moved vertices. */
void quadratic_straighten(struct mesh *mesh);

/* As body_alloc(), straight edges asserted; K BANDED or SPARSE. */
struct quadratic *quadratic_alloc(const struct mesh *mesh,
                                  struct material material, double rho,
                                  const int held[], enum storage storage);
void quadratic_free(struct quadratic *body);

/* f += the nodal forces of a constant body force (N/m^2): of a triangle
 * nothing at its vertices, and a third of it in each middle. */
void quadratic_load(const struct quadratic *body, const double density[2],
                    double f[]);

/* As body_energy(), body_min_J() (the least of all points), body_assemble()
 * (EXACT or NO_TANGENT), and body_increment() with K. */
enum status quadratic_energy(const struct quadratic *body, const double u[],
                             double *energy);
double quadratic_min_J(const struct quadratic *body, const double u[]);
enum status quadratic_assemble(struct quadratic *body, struct incremental Phi,
                               const double u[], enum tangent tangent,
                               double q[]);
enum status quadratic_increment(struct quadratic *body, const double q[],
                                double du[]);

#endif
