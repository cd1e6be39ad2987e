/*
 * elements.h - a linear system that is put together from elements of any kind,
 * on the vertices of a mesh.
 *
 * K has all vertices, component i of vertex a at 2a + i, in a band: whoever has
 * an element adds it.  What is held is held when the system is solved
 * [eq:dirichlet-correction].
 */
#ifndef COMMON_ELEMENTS_H
#define COMMON_ELEMENTS_H

#include "linear/matrix.h"
#include "plane/mesh.h"

struct elements {
    const struct mesh *mesh; /* borrowed */
    struct matrix *K;
    double *f; /* [2 n_vertex] nodal forces (N), for the caller to fill */
};

/* Both 0.  reach: over so many columns and rows goes an element, at most. */
struct elements *elements_alloc(const struct mesh *mesh, int reach);
void elements_free(struct elements *elements);

/* K += E, the matrix of an element of so many nodes: E[2 count (2a + i) + 2b +
 * j] of component i of node[a] and component j of node[b]. */
void elements_add(struct elements *elements, int count, const int node[],
                  const double E[]);

/* K += that of a linear triangle at rest, linear elasticity
 * [eq:element-tangent].  Returns its area (m^2). */
double elements_linear(struct elements *elements, const int vertex[3],
                       double mu, double lambda);

/* u := K^-1 f, 0 where held[a] != 0; K is factored, f used up.  Statuses as
 * matrix_factor(), u is then not set. */
enum status elements_solve(struct elements *elements, const int held[],
                           double u[]);

#endif
