/*
 * step.h - implicit time steps of the body of body.h: Newton's method.
 *
 * A step of backward Euler minimises Phi over u with w = u0 + dt v0, then sets
 * v = (u - u0) / dt [eq:backward-euler].  Other integrators use step_solve()
 * with a dt and a w of their own.
 */
#ifndef COMMON_STEP_H
#define COMMON_STEP_H

#include "plane/body.h"

enum guess {
    FROM_LAST,     /* u0, as the notes have it */
    FROM_VELOCITY, /* u0 + dt v0 */
    EXTRAPOLATED   /* u0 + dt (2 v0 - v_before), or on through up to seven
                    * states when that met the last step better: step.c has
                    * their velocities in the body [alg:extrapolated] */
};
enum projection { NEVER, ON_DEMAND, ALWAYS };
/* Factors serve later steps, too, unless the last one took more systems than
 * this and two more than the shortest with them [alg:kept]. */
enum { KEPT_SYSTEMS = 4 };

struct step_control {
    double tolerance;   /* of max|du| (m), and of max|q| / max K_ii (m) */
    int max_iterations; /* cap on linear systems solved */
    enum guess guess;
    int lift;        /* spread the jump of the boundary values: step_boundary */
    int chord;       /* 0: new factors for every system.  1: they are kept while
                      * max|du| falls below 0.3 times the one before
                      * [alg:chord]; a sparse K also from step to step, rounded
                      * to single precision [alg:kept], and a step that fails
                      * with those of an earlier one begins again with new ones
                      * */
    int line_search; /* halve the increment until Phi decreases */
    enum projection projection; /* NEVER: an indefinite K is solved as it
                                 * is, or NOT_SPD with line_search;
                                 * ON_DEMAND: PROJECTED when K is not SPD */
};

/*
 * The methods that lessons, studies and tests compare, by the word that their
 * tables print; tolerance 1e-10 m, new factors in each iteration.
 *
 *     notes          as the notes have it: from the last u, K solved as it is,
 *                    positive definite or not, and no line search
 *     search         ... with a line search
 *     demand         ... projected on demand
 *     demand+search  ... with both
 *     always+search  ... always projected, with a line search
 *     lift           notes, but the guess extrapolated, and the jump lifted
 *     lift+search    ... with a line search
 *     all            ... and projected on demand
 *
 * The caps: a method without projection converges within 40 systems or hardly
 * ever does; projections need more, most when they start far away.
 */
struct step_control step_method(const char *name);

struct step_report {
    enum status status; /* OK, NOT_SPD, INVERTED, NONFINITE, STALLED,
                         * MAX_ITERATIONS */
    int iterations;     /* linear systems solved */
    int factorisations; /* of them with new factors */
    int projections;    /* of them with a projected K */
    int indefinite;     /* of them with a K that was not SPD, as it was */
    double residual;    /* the last max|q| / max K_ii of free unknowns (m) */
    double increment;   /* the last max|du| (m) */
};

/*
 * Solve q(u) = 0 of Phi by Newton's method, from u, whose prescribed vertices
 * have their values [alg:body-newton]; guess and lift of control are not looked
 * at. u is the solution, or the last state reached when the status is not OK.
 */
struct step_report step_solve(struct body *body,
                              const struct step_control *control,
                              struct incremental Phi, double u[]);

/*
 * *phi := Phi(u) [eq:incremental-potential], *noise := the size of its terms,
 * on which its round-off depends.  room: [4 n_vertex].  OK; the
 * status of body_energy() where u has no energy; NONFINITE.
 */
enum status step_potential(const struct body *body, struct incremental Phi,
                           const double u[], double room[], double *phi,
                           double *noise);

/* u := u + length du, the length by the line search that step_solve() has, for
 * q at u and du = 0 at prescribed vertices [alg:line-search].  NOT_SPD: du
 * goes uphill; STALLED: no length decreases Phi.  After both u is unchanged. */
enum status step_search(const struct body *body, struct incremental Phi,
                        const double q[], const double du[], double u[]);

/*
 * Certify: converged is not stable.  At the u that step_solve() ends in, K is
 * factored once more [alg:certify]: OK when it is positive definite, so that
 * Phi has a minimum there, else SADDLE; statuses of body_energy() where u has
 * no K.
 */
enum status step_certify(struct body *body, struct incremental Phi,
                         const double u[]);

/*
 * Write the boundary values g (read at prescribed vertices only) into the guess
 * u.  With lift the jump g - u is carried on into the body, linearly in X1
 * between the prescribed ends of each row, constant beyond one [eq:lift-2d]:
 * without it the triangles at the boundary take all of it.
 */
void step_boundary(const struct body *body, const double g[], int lift,
                   double u[]);

/*
 * Make one step of backward Euler: guess, boundary values, step_solve(),
 * velocity.
 *
 * u, v       in/out  state; unchanged when the status is not OK
 * v_before   in/out  velocity of the step before, which EXTRAPOLATED reads; a
 *                    step that is OK, whatever its guess, leaves the v of its
 *                    beginning there.  NULL: nobody keeps it
 *
 * Eight parameters: the data of a step, and the three vectors that it moves on.
 */
struct step_report step_backward_euler(struct body *body,
                                       const struct step_control *control,
                                       double dt, const double g[],
                                       const double f[], double u[],
                                       double v[], double v_before[]);

#endif
