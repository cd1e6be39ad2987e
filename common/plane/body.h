/*
 * body.h - a two-dimensional elastic body: energy, residual, tangent, fast.
 *
 * Triangles on a rectangle of mesh.h, linear ones, or the quadratic ones of
 * quadratic.h; u and v are flat, component i of vertex a at [2a + i].  With f
 * the nodal forces (body force and tractions integrated against N_a), rho the
 * density, F_p = I + sum_a u_a (x) grad N_a at a point p, of which a linear
 * triangle has one and a quadratic one three, with its part of the area:
 *
 *     Psi(u) = sum_p area_p psi(F_p)        [eq:body-energy] [eq:three-points]
 *     M_ab   = int rho N_a N_b (CONSISTENT), or its row sums on the diagonal
 *              (LUMPED) [eq:mass]; of quadratic triangles, whose row sums are 0
 *              at the vertices, always the diagonal of [eq:scaled-mass]
 *     Phi(u) = 1/2 (u - w).M(u - w) + dt^2 (Psi(u) - f.u)
 *                                                  [eq:incremental-potential]
 *     q      = dPhi/du = M (u - w) + dt^2 (dPsi/du - f)          [eq:body-q]
 *     K      = dq/du                                        [eq:body-tangent]
 *
 * q(u) = 0 with w = u0 + dt v0 is a step of backward Euler; at_rest(f) is
 * quasistatics: Phi = Psi(u) - f.u alone.
 *
 * Only free vertices have equations, numbering.h.
 *
 * Closed form at a point.  With g_a = grad N_a, c_a = cof(F) g_a and
 * dpsi = mu (F:dF) + G' (cof F:dF), G', G'' of
 * material_volume()
 *
 *     dPsi/du_a = area (mu F g_a + G' c_a)                  [eq:element-force]
 *     K_ab      = area ((mu g_a.g_b) I + G'' c_a c_b^T
 *                       + G' (g_a x g_b) (0 1; -1 0))     [eq:element-tangent]
 *
 * Names: at_rest.
 */
#ifndef COMMON_BODY_H
#define COMMON_BODY_H

#include "material/material.h"
#include "linear/matrix.h"
#include "plane/mesh.h"

enum element { LINEAR_TRIANGLE, QUADRATIC_TRIANGLE };
enum mass { CONSISTENT, LUMPED };
enum tangent { NO_TANGENT, EXACT, PROJECTED };

/* The potential Phi of a step; its vectors go over all vertices. */
struct incremental {
    double dt;       /* time step (s) */
    const double *w; /* where u would be without forces; NULL: nothing moves,
                      * there is no inertia, not in q and not in K */
    const double *f; /* nodal forces (N); NULL: none */
};

/* Phi = Psi(u) - f.u, whatever the density is; f NULL: no forces. */
struct incremental at_rest(const double f[]);

/*
 * An addition to a body besides its material, as fibres (fibre.h), adds its
 * energy to *energy, or (energy NULL) dt^2 times its gradient to q and, unless
 * NO_TANGENT, dt^2 times its tangent of the free unknowns to body->K.  Only
 * linear triangles take one (asserted).
 */
struct body;
typedef void body_addition(const struct body *body, double dt,
                           const double u[], enum tangent tangent,
                           double *energy, double q[]);

/*
 * What step.h knows of the factors in K, which may serve later steps, too
 * [alg:kept].  Whoever writes K forgets them: body_assemble() with a tangent,
 * and body_store().  Whoever changes material, density or mass must as well.
 */
struct kept {
    int usable;       /* 0: K has no factors, or not those of a step */
    int moving;       /* they have inertia */
    double dt, scale; /* of their step (s); max K_ii */
    double turned[2]; /* body_turned() at their u */
    double by[2];     /* how far this step has turned it since then */
    int systems, least; /* of the last step that they served, of the shortest */
};

/*
 * The last velocity of the steps that guess by extrapolation, its backward
 * differences d2, d3, ... (d1 is the caller's), and how many of them would have
 * met the last step best [alg:extrapolated].  step.h looks whether they belong
 * to the state that it is given.
 */
enum { PAST_ORDER = 6 };
struct past {
    double dt; /* of these steps (s); 0: none */
    int order; /* of the next guess, 2 .. PAST_ORDER */
    double *v, *d[PAST_ORDER + 1]; /* [2 n_vertex] (m/s), d from 2 on */
};

struct body {
    const struct mesh *mesh;  /* borrowed */
    struct material material; /* not LINEAR */
    double rho;               /* density (kg/m^2) */
    enum mass mass;
    enum element element;
    int n_element;            /* triangles: those of the mesh, or a fourth */
    int nodes, points;        /* of a triangle: 3 and 1, or 6 and 3 */
    int n_equation;
    int *equation;    /* [2 n_vertex] number of the unknown, -1: prescribed */
    int *vertex;      /* [nodes n_element] of a triangle, by equation */
    double *area;     /* [n_element] of a point (m^2): the triangle's, or a
                       * third of it */
    double total_area; /* of all triangles (m^2) */
    double *gradient; /* [2 nodes n_element] dN_a / dX_j of these vertices, of a
                       * linear triangle at [6 e + 2 a + j]; of a quadratic one
                       * for each of its points p at [36 e + 12 p + 2 a + j] */
    int *place;       /* scatter map of numbering.h, for each triangle */
    double *lanes;    /* gradients and areas of linear triangles for lanes.h */
    double *diagonal; /* [n_vertex] of quadratic triangles: the area whose mass
                       * a vertex has (m^2); NULL: linear triangles */
    struct sparse *pattern; /* of K when it is sparse, NULL when banded */
    struct matrix *K; /* tangent of the free unknowns */
    struct kept kept; /* the state of its factors */
    struct past past; /* in room, behind what step.h works in */
    double *room; /* [BODY_ROOM 2 n_vertex] in which step.h works, made once:
                   * of a small body's step new zeros are two per cent */
    body_addition *add; /* NULL, from body_alloc(): nothing besides */
    const void *added;  /* what add needs; borrowed */
};

/* From so many cells across the shorter side on, body_alloc() makes K sparse,
 * body_alloc_of() that of quadratic triangles, whose band is wider: new factors
 * take as long by dissection as in a band, and those that serve later steps
 * [alg:kept] take half as long.  Measured, then fixed. */
enum { BODY_SPARSE_FROM = 24, BODY_QUADRATIC_SPARSE_FROM = 16 };
enum { BODY_ROOM = 8 + PAST_ORDER }; /* vectors over all vertices */

/*
 * Return a body of linear triangles.  held[a] != 0: both components of vertex a
 * are prescribed; not all may be.  Every triangle must be counter-clockwise
 * (asserted: see mesh_clockwise()).
 */
struct body *body_alloc(const struct mesh *mesh, struct material material,
                        double rho, enum mass mass, const int held[]);

/* Return the same of this element.  Quadratic triangles: the mesh has an even
 * number of cells and of rows, and its edges are straight
 * (quadratic_straighten()). */
struct body *body_alloc_of(enum element element, const struct mesh *mesh,
                           struct material material, double rho,
                           enum mass mass, const int held[]);
void body_free(struct body *body);

/* Number the equations anew, for a zero K in this storage: not DENSE.
 * Matrices of body_matrix() that were made before are of no use any more. */
void body_store(struct body *body, enum storage storage);

/* *energy := Psi(u).  INVERTED: LOG and some J <= 0; NONFINITE: u is not
 * finite. */
enum status body_energy(const struct body *body, const double u[],
                        double *energy);

/* Return int N_a N_b / area of a linear triangle, or its row sums [eq:mass]:
 * of a vertex with itself (own), or with another one. */
double body_mass_share(enum mass mass, int own);

/* out := M v, for all vertices, the prescribed ones as well. */
void body_mass(const struct body *body, const double v[], double out[]);

/* Return F of triangle e of the mesh, of which a quadratic triangle has four: F
 * is then that of its corners alone.  The least det F of all points. */
mat2 body_deformation(const struct body *body, const double u[], int e);
double body_min_J(const struct body *body, const double u[]);

/* by := cosine and sine of the angle by which u turns the body as a whole: the
 * rotation about its middle that is closest to X -> X + u in the mean square,
 * all vertices alike [alg:kept].  1 and 0 where none is the closest. */
void body_turned(const struct body *body, const double u[], double by[2]);

/* q := dPsi/du at all vertices (N) [eq:element-force]; statuses as
 * body_energy(), q is then incomplete. */
enum status body_force(const struct body *body, const double u[], double q[]);

/*
 * Make matrices of the free unknowns, numbered by body->equation: a zero one
 * for the caller to free; K := d2Psi/du2 at u [eq:element-tangent], EXACT or
 * PROJECTED, statuses as body_energy(); M := the mass matrix [eq:mass].
 */
struct matrix *body_matrix(const struct body *body);
enum status body_stiffness(const struct body *body, const double u[],
                           enum tangent tangent, struct matrix *K);
void body_mass_matrix(const struct body *body, struct matrix *M);

/* Copy between vectors over all vertices and over the free unknowns: some :=
 * the free entries of all; all := some, and 0 where a vertex is held. */
void body_gather(const struct body *body, const double all[], double some[]);
void body_scatter(const struct body *body, const double some[], double all[]);

/* Return max|v| of the free unknowns; INFINITY where one is not finite. */
double body_max_free(const struct body *body, const double v[]);

/*
 * The increment of Newton's method [eq:newton]: A du = -q for the free
 * unknowns, du = 0 at the held vertices.  A is of body_matrix() and is factored
 * in place; q and du are over all vertices.  NOT_SPD: du is not set.
 */
enum status body_increment(const struct body *body, struct matrix *A,
                           const double q[], double du[]);

/*
 * Assemble q of Phi at u, of all vertices (at prescribed ones it is what holds
 * them), and K of the free ones into body->K unless NO_TANGENT.  PROJECTED
 * clamps the negative eigenvalues of every dP/dF to 0 [eq:projection]; K is
 * then positive definite where M is.  Statuses as body_energy(); q and K are
 * incomplete after them.
 */
enum status body_assemble(struct body *body, struct incremental Phi,
                          const double u[], enum tangent tangent, double q[]);

#endif
