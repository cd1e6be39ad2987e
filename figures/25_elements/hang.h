/*
 * hang.h - the square that hangs from its left side, by every element of
 * lesson 25.
 *
 * Linear elasticity, 1 N per square metre, E = 1000; n x n squares, whose
 * corners are the vertices of linear triangles, and some of those of quadratic
 * and of criss-cross ones, four linear triangles around the middle of a square;
 * graded towards the held side, the bottom and the top.
 */
#ifndef FIGURES_HANG_H
#define FIGURES_HANG_H

#include "plane/mesh.h"

enum hang_element { HANG_LINEAR, HANG_AVERAGED, HANG_CROSSED, HANG_QUADRATIC };
#define HANG_WORDS {"linear", "averaged", "criss-cross", "quadratic"}

enum { HANG_SHARED = 25 }; /* the vertices of 4 x 4 squares are all meshes' */

struct hang {
    double u[2 * HANG_SHARED]; /* (m), row by row */
    double sag;                /* u_y of (1, 0) */
    double div; /* root of the mean of (div u)^2 over the triangles, or over
                 * the three points of the quadratic ones */
};

/* n is a multiple of 4. */
struct hang hang_of(enum hang_element element, int n, double m, double nu);

/* The same, and where it hangs: *u at the vertices of *mesh, for the caller to
 * free. */
struct hang hang_whole(enum hang_element element, int n, double m, double nu,
                       struct mesh **mesh, double **u);

/* Two by two cells of the mesh are a square: its four triangles around the
 * middle.  Returns the list of all, [3 n_triangle / 2], for the caller to
 * free. */
int *hang_cross(const struct mesh *mesh);

/* Of three meshes of graded quadratic triangles, the finest with n = 128, as
 * each halving of h leaves the same fraction; at nu = 0.4999 div falls more
 * slowly each time, so that what is extrapolated is some 1 % too large. */
struct hang hang_limit(double nu);

/* |a - b| over the shared vertices, of |b|. */
double hang_apart(const struct hang *a, const struct hang *b);

#endif
