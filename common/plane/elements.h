/*
 * elements.h - a linear system that is put together from elements of any kind,
 * on the vertices of a mesh.
 *
 * K has all vertices, component i of vertex a at 2a + i, in a band: whoever has
 * an element adds it, and says which vertices are held.  They are held when the
 * system is solved [eq:dirichlet-correction].
 */
#ifndef COMMON_ELEMENTS_H
#define COMMON_ELEMENTS_H

#include "linear/matrix.h"
#include "plane/mesh.h"

struct elements {
    const struct mesh *mesh; /* borrowed */
    struct matrix *K;
    double *f; /* [2 n_vertex] nodal forces (N), for the caller to fill */
    int *held; /* [n_vertex] are both components 0?  For the caller, too */
};

/* Make them all 0.  reach: an element goes over so many columns and rows, at
 * most; the band is as wide as that. */
struct elements *elements_alloc(const struct mesh *mesh, int reach);
void elements_free(struct elements *elements); /* not NULL */

/* The corners of a cell, 0 <= cell < n rows, row by row: counter-clockwise from
 * its lower left one, so that its triangles have 0 1 2 and 0 2 3. */
void elements_cell(const struct mesh *mesh, int cell, int corner[4]);

/* Put the vertices of a mesh on a lattice: (x[i], y[j]) in column i, row j. */
void elements_lattice(struct mesh *mesh, const double x[], const double y[]);

/* K += E, the matrix of an element of so many nodes: E[2 count (2a + i) + 2b +
 * j] of component i of node[a] and component j of node[b]. */
void elements_add(struct elements *elements, int count, const int node[],
                  const double E[]);

/* K += that of a linear triangle at rest, linear elasticity
 * [eq:element-tangent].  Returns its area (m^2). */
double elements_linear(struct elements *elements, const int vertex[3],
                       double mu, double lambda);

/* u := K^-1 f, 0 where a vertex is held; K is factored, f used up.  Statuses as
 * matrix_factor(), u is then not set. */
enum status elements_solve(struct elements *elements, double u[]);

#endif
