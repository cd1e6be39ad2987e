/*
 * mesh.h - the square (-1,1)^2 cut into triangles.
 *
 *     6---7---8      vertex a = j (n + 1) + i at X = (-1 + 2i/n, -1 + 2j/n);
 *     | / | / |      each of the n x n squares is cut from its lower left to
 *     3---4---5      its upper right corner: the triangle below the cut, then
 *     | / | / |      the one above it, both counter-clockwise
 *     0---1---2
 */
#ifndef COMMON_MESH_H
#define COMMON_MESH_H

struct mesh {
    int n; /* squares a side */
    int n_vertex, n_triangle;
    double *X;     /* [2 n_vertex] (m): vertex a at X[2a], X[2a+1]; owned */
    int *triangle; /* [3 n_triangle] vertices; owned */
};

struct mesh *mesh_square(int n);
void mesh_free(struct mesh *mesh);

/* The first triangle whose area is not > 0 (clockwise or flat), or -1. */
int mesh_clockwise(const struct mesh *mesh);

/*
 * Area (m^2) and shape-function gradients (1/m) of triangle e:
 * gradient[2a + j] = dN_a / dX_j for its vertices a = 0, 1, 2
 * [eq:shape-gradient].
 */
double mesh_gradients(const struct mesh *mesh, int e, double gradient[6]);

#endif
