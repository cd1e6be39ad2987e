/*
 * tissue.h - a body that a knife may cut: its lasting and its passing parts.
 *
 * The triangles stay what they are when a body is cut along edges of its mesh,
 * but neighbours no longer share their vertices.  So all that lasts is said of
 * corners and edges: corner c = 3e + k is vertex k of triangle e, and edge c is
 * the edge of e that lies opposite to it.
 */
#ifndef COMMON_TISSUE_H
#define COMMON_TISSUE_H

#include "plane/body.h"

/* The part that no cut changes. */
struct tissue_whole {
    const struct mesh *mesh; /* before any cut; borrowed */
    int *across; /* [3 n_triangle] the triangle beyond edge c; e: none */
    int *pulled; /* [3 n_triangle] does the traction act on edge c? */
    double traction[2]; /* (N/m) */
    double rho;         /* density (kg/m^2) */
};

/* A body as it is, whole or cut.  To body.h its mesh is one row of vertices,
 * n = n_vertex - 1 and rows = 0, and they are numbered as they come. */
struct tissue {
    struct mesh *mesh; /* owned, and so are these */
    int *held;         /* [n_vertex] 1: u is prescribed, 0 */
    double *u, *v;     /* [2 n_vertex] state (m), (m/s) */
    double *mass;      /* [n_vertex] lumped (kg) */
    double *f;         /* [2 n_vertex] nodal forces (N) */
};

/* On a mesh, which it takes over; all arrays are 0.  The caller frees it. */
struct tissue tissue_alloc(struct mesh *mesh);
void tissue_free(struct tissue tissue);

/* The square, not yet a body: held where X1 = -1, and pulled where X1 = 1 by
 * (pull, 0) N/m; density 1.  The caller frees across and pulled. */
struct tissue_whole tissue_hold(const struct tissue *square, double pull);

/* A section of so many cells, its middle at 0 (m); vertices and cells are
 * numbered downwards, column by column: a band as narrow as the section is
 * high.  The caller frees it. */
struct mesh *tissue_section(int wide, int high, double width, double height);

/* A strip of soft tissue, 10 cm by 3 cm, as soft as brain, as heavy as water;
 * not yet a body: bone holds its lower side, and nothing pulls.  The notes'
 * material has the density 1 instead of 1000 kg/m^2, so the strip is sqrt(1000)
 * times as large: then sound takes as long from end to end, and the motion is
 * the same in the same time. */
struct tissue tissue_strip(void);
struct tissue_whole tissue_on_bone(const struct tissue *strip);

/* The vertex nearest to x, the first of them. */
int tissue_nearest(const struct mesh *mesh, const double x[2]);

/* cut[c] := 1 for each edge c, seen from either side, that two neighbours in
 * chain[0..n-1] are the ends of; other marks stay. */
void tissue_mark(const struct mesh *mesh, int n, const int chain[], int cut[]);

/* part[a] := the first vertex of the part that vertex a hangs together with. */
void tissue_label(const struct mesh *mesh, int part[]);

/* How many parts hang together; *loose of them are not held, for which two of
 * its vertices have to be. */
int tissue_parts(const struct tissue *tissue, int *loose);

/* The largest distance at u of two vertices that have one X (m); they follow
 * each other. */
double tissue_opening(const struct mesh *mesh, const double u[]);

/*
 * K of a body that is cut, in the unknowns y of before and the jumps d: a
 * vertex that has been there, and its copies, have u = y and u = y + d.
 *
 *     old[i], jump[i]    unknown i of the cut body is y[old[i]], or with
 *                        jump[i] >= 0 y[old[i]] + d[jump[i]]; so is its row
 *                        added to that of y, and of d             [eq:jumps]
 */
struct tissue_border {
    int *old, *jump;  /* [n + k], owned, and so are these: */
    double *B;        /* [n k] by columns, of y and d */
    struct matrix *C; /* dense, of order k: of d */
};

/* Of body[1]->K, before it is factored; body[1] was body[0], whose vertices
 * have become more; corners are the same, and n < n + k unknowns. */
struct tissue_border tissue_border_alloc(struct body *const body[2]);
void tissue_border_free(struct tissue_border border);

#endif
