/*
 * mesh.h - a rectangle, most often the square (-1,1)^2, cut into triangles.
 *
 *     6---7---8      n cells per row, so many rows: vertex a = j (n + 1) + i at
 *     | / | / |      X = (-1 + 2i/n, -1 + 2j/n) in the square, where rows = n;
 *     3---4---5      each cell is cut from its lower left to its upper right
 *     | / | / |      corner: the triangle below the cut, then the one above it,
 *     0---1---2      both counter-clockwise
 */
#ifndef COMMON_MESH_H
#define COMMON_MESH_H

struct mesh {
    int n;    /* cells per row, along X1 */
    int rows; /* of cells, along X2 */
    int n_vertex, n_triangle;
    int graded;    /* by mesh_grade(): the cells are not all alike */
    double *X;     /* [2 n_vertex] (m): vertex a at X[2a], X[2a+1]; owned */
    int *triangle; /* [3 n_triangle] vertices; owned */
};

struct mesh *mesh_square(int n); /* (-1, 1) x (-1, 1), n rows */

/* Mesh (-a, a) x (-b, b); Lecture 3's column: 80 cells by 8, a = 1, b = 0.1. */
struct mesh *mesh_rectangle(int n, int rows, double a, double b);
/* Return one triangle, its corners at (X[0], X[1]), (X[2], X[3]), (X[4], X[5]),
 * counter-clockwise. */
struct mesh *mesh_triangle(const double X[6]);
void mesh_free(struct mesh *mesh);

/*
 * Grade a rectangle around 0 towards some of its sides: what is nearer to one
 * than L, a quarter of the way across, goes from the distance d to
 * L (d / L)^m [eq:graded].  So the sides stay, and the lines at 1/4 and 3/4
 * and all between them.
 *
 * Source: Strang and Fix, An Analysis of the Finite Element Method, chapter 8.
 */
enum mesh_side { MESH_LEFT = 1, MESH_RIGHT = 2, MESH_BOTTOM = 4, MESH_TOP = 8 };
void mesh_grade(struct mesh *mesh, double m, int sides);

/* Return the first triangle whose area is not > 0 (clockwise, flat), or -1. */
int mesh_clockwise(const struct mesh *mesh);

/* angle[a] := the angles added up that the triangles have at vertex a, which is
 * at X + u (NULL: at X), each between -pi and pi, those of an inverted triangle
 * negative [eq:winding]. */
void mesh_angles(const struct mesh *mesh, const double u[], double angle[]);

/*
 * Return the area (m^2) and shape-function gradients (1/m) of triangle e:
 * gradient[2a + j] = dN_a / dX_j for its vertices a = 0, 1, 2
 * [eq:shape-gradient].
 */
double mesh_gradients(const struct mesh *mesh, int e, double gradient[6]);
/* Return the same of a triangle with these vertices, of the mesh or not. */
double mesh_gradients_of(const struct mesh *mesh, const int vertex[3],
                         double gradient[6]);

/* Return [3 n_triangle] for the caller to free: the triangle beyond the edge of
 * e that lies opposite to its vertex k at [3 e + k], or e itself at the
 * boundary.  At most eight triangles meet in a vertex (asserted). */
int *mesh_across(const struct mesh *mesh);

#endif
