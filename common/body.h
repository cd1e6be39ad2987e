/*
 * body.h - implicit time steps of a two-dimensional body, when seconds count.
 *
 * Linear triangles on the square of mesh.h; u and v are flat, component i of
 * vertex a at [2a + i].  With f the nodal forces (body force and tractions
 * integrated against N_a), rho the density and F_e = I + sum_a u_a (x) grad N_a
 *
 *     Psi(u) = sum_e area_e psi(F_e)                          [eq:body-energy]
 *     M_ab   = int rho N_a N_b (CONSISTENT), or its row sums on the diagonal
 *              (LUMPED)                                              [eq:mass]
 *     Phi(u) = 1/2 (u - w).M(u - w) + dt^2 (Psi(u) - f.u)
 *                                                  [eq:incremental-potential]
 *     q      = dPhi/du = M (u - w) + dt^2 (dPsi/du - f)          [eq:body-q]
 *     K      = dq/du                                        [eq:body-tangent]
 *
 * A step of backward Euler is q(u) = 0 with w = u0 + dt v0, then
 * v = (u - u0) / dt [eq:backward-euler]; dt = 1 and rho = 0 is quasistatics.
 *
 * Only free vertices have equations.  They are numbered row by row from right
 * to left, so that the diagonals of the mesh do not widen the band: half
 * bandwidth 2 n - 1 with both ends prescribed.
 */
#ifndef COMMON_BODY_H
#define COMMON_BODY_H

#include "material.h"
#include "matrix.h"
#include "mesh.h"

enum mass { CONSISTENT, LUMPED };

struct body {
    const struct mesh *mesh; /* borrowed */
    struct material material; /* LOG or CUBIC */
    double rho;               /* density (kg/m^2) */
    enum mass mass;
    int n_equation;
    int *equation;    /* [2 n_vertex] number of the unknown, -1: prescribed */
    double *area;     /* [n_triangle] */
    double *gradient; /* [6 n_triangle], see mesh_gradients() */
    int *place;       /* [21 n_triangle] scatter map: where in K->a the lower
                       * triangle of an element's 6x6 matrix goes, by rows */
    double *q;        /* [2 n_vertex] work */
    struct matrix *K; /* tangent of the free unknowns, one spare number behind */
};

/*
 * fixed[a] != 0: both components of vertex a are prescribed; not all may be.
 * Every triangle must be counter-clockwise (asserted: see mesh_clockwise()).
 */
struct body *body_alloc(const struct mesh *mesh, struct material material,
                        double rho, enum mass mass, const int fixed[]);
void body_free(struct body *body);

/* Psi(u).  INVERTED: LOG and some J <= 0; NONFINITE: u is not finite. */
enum status body_energy(const struct body *body, const double u[],
                        double *energy);

/* out := M v, for all vertices, the prescribed ones as well. */
void body_mass(const struct body *body, const double v[], double out[]);

/* The least det F of all triangles. */
double body_min_J(const struct body *body, const double u[]);

enum tangent { NO_TANGENT, EXACT, PROJECTED };

/*
 * q at u, of all vertices (at prescribed ones: dt^2 times minus the reaction),
 * and K of the free ones into body->K unless NO_TANGENT.  PROJECTED clamps the
 * negative eigenvalues of every dP/dF to 0 [eq:projection]; K is then positive
 * definite where M is.  f may be NULL: no forces.  Statuses as body_energy().
 */
enum status body_assemble(struct body *body, double dt, const double w[],
                          const double f[], const double u[],
                          enum tangent tangent, double q[]);

enum guess {
    FROM_LAST,     /* u0, as the notes have it */
    FROM_VELOCITY, /* u0 + dt v0 */
    EXTRAPOLATED   /* u0 + dt (2 v0 - v_before) */
};
enum projection { NEVER, ON_DEMAND, ALWAYS };

struct step_control {
    double tolerance;   /* of max|du| (m), and of max|q| / max K_ii (m) */
    int max_iterations; /* cap on linear systems solved */
    enum guess guess;
    int lift;        /* spread the jump of the boundary values, see below */
    int chord;       /* keep the factors while max|du| falls below 0.3 times
                      * the one before */
    int line_search; /* halve the increment until Phi decreases */
    enum projection projection; /* NEVER: indefinite K are solved as they are;
                                 * ON_DEMAND: PROJECTED when K is not SPD */
};

struct step_report {
    enum status status;  /* OK, NOT_SPD, INVERTED, NONFINITE, STALLED,
                          * MAX_ITERATIONS */
    int iterations;      /* linear systems solved */
    int factorisations;  /* of them with new factors */
    int projections;     /* of them with a projected K */
    int halvings;        /* by the line search */
    double residual;     /* the last max|q| / max K_ii of free unknowns (m) */
    double increment;    /* the last max|du| (m) */
};

/*
 * Newton's method for q(u) = 0 from u, whose prescribed vertices have their
 * values [alg:body-newton]; guess and lift of control are not looked at.  u is
 * the solution, or the last state reached when the status is not OK.
 */
struct step_report body_solve(struct body *body,
                              const struct step_control *control, double dt,
                              const double w[], const double f[], double u[]);

/*
 * Write the boundary values g (read at prescribed vertices only) into the guess
 * u.  With lift the jump g - u is carried on into the body, linearly in X1
 * between the prescribed ends of each row, constant beyond them [eq:lift-2d]:
 * without it the triangles at the boundary take all of it.
 */
void body_boundary(const struct body *body, const double g[], int lift,
                   double u[]);

/*
 * One step of backward Euler: guess, boundary values, body_solve(), velocity.
 *
 * u, v       in/out  state; unchanged when the status is not OK
 * v_before   in/out  velocity of the step before, for EXTRAPOLATED; else NULL
 */
struct step_report body_step(struct body *body,
                             const struct step_control *control, double dt,
                             const double g[], const double f[], double u[],
                             double v[], double v_before[]);

#endif
