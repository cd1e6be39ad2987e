/*
 * integrate.h - steps in time of the models of model.h: four methods, and the
 * frame of a loop that has to go on whatever happens.
 *
 * Each implicit method contains one step of backward Euler, of length d, from
 * some state (a, b) [eq:one-solve]: u* = solve(d, a, b), v* = (u* - a) / d.
 *
 *     BACKWARD_EULER     a = u0, b = v0, d = dt;  u+ = u*, v+ = v*
 *     IMPLICIT_MIDPOINT  a = u0, b = v0, d = dt/2, boundary values half-way;
 *                        u+ = 2 u* - u0, v+ = 2 v* - v0
 *     BDF2               a = (4 u0 - u_before) / 3, b = (4 v0 - v_before) / 3,
 *                        d = 2 dt / 3;  u+ = u*, v+ = v*; its first step, which
 *                        has nothing before it, is one of IMPLICIT_MIDPOINT
 *
 * SYMPLECTIC_EULER solves no system but that of a consistent mass
 * [eq:symplectic-euler]:
 *
 *     v+ = v + dt M^-1 (f - dPsi/du(u)),   u+ = u + dt v+
 *
 * Names: method_, state_.
 */
#ifndef COMMON_INTEGRATE_H
#define COMMON_INTEGRATE_H

#include "motion/model.h"

enum method {
    SYMPLECTIC_EULER, BACKWARD_EULER, IMPLICIT_MIDPOINT, BDF2, N_METHOD
};
const char *method_name(enum method method); /* "symplectic", "backward",
                                              * "midpoint", "bdf2" */

/* Displacement (m) and velocity (m/s), now and one step before. */
struct state {
    int n, steps; /* entries of each vector; steps made */
    double *u, *v, *u_before, *v_before;
};

/* A state at rest. */
struct state state_make(int n);

/* Return a state at rest, u with all modes at once, so small that a body is
 * linear (1e-7 m); 0 where prescribed. */
struct state state_ripple(const struct model *model);

void state_copy(const struct state *from, struct state *to);
void state_free(struct state *s);

/* The next step ends at u, v: s takes them over, and what it was becomes the
 * step before.  NONFINITE: an entry is not finite; s stays as it was. */
enum status state_accept(struct state *s, const double u[], const double v[]);

/*
 * q := M (u - u0 - dt v0) + dt^2 (dPsi/du(u) - f) [eq:time-residual], 0 at the
 * end u of a step of backward Euler from (u0, v0); statuses of model_force().
 */
enum status integrate_residual(const struct model *model, double dt,
                               const double u0[], const double v0[],
                               const double u[], double q[]);

/* integrate_residual(), or another function that computes the same. */
typedef enum status residual_function(const struct model *model, double dt,
                                      const double u0[], const double v0[],
                                      const double u[], double q[]);

/*
 * u := the end of a step d of backward Euler from the state (a, b), with the
 * boundary values g (NULL: linear model).  Linear: q is linear in u, so one
 * Newton step from 0 is exact, u = -(M + d^2 A)^-1 q(0), and q(0) is asked of
 * `residual`.  The body: Newton's method of step.h, which has a residual of its
 * own, from a + d b with the jump of the boundary values spread.
 */
struct step_report integrate_solve(struct model *model,
                                   residual_function *residual, double d,
                                   const double a[], const double b[],
                                   const double g[], double u[]);

/* u, v := those after a step of SYMPLECTIC_EULER; of no use when not OK. */
typedef enum status explicit_function(const struct model *model, double dt,
                                      double u[], double v[]);

/* u, v := the end of the step of an implicit method that begins with s; g are
 * the boundary values at its end (NULL: linear model). */
typedef struct step_report implicit_function(struct model *model,
                                             enum method method, double dt,
                                             const double g[],
                                             const struct state *s, double u[],
                                             double v[]);

/* Make one step of any method by two such functions; s stays as it was when the
 * status is not OK. */
struct step_report integrate_by(explicit_function *explicit,
                                implicit_function *implicit,
                                struct model *model, enum method method,
                                double dt, const double g[], struct state *s);

/* The same by those of this library. */
struct step_report integrate_step(struct model *model, enum method method,
                                  double dt, const double g[],
                                  struct state *s);

/* Newton's method of implicit steps of the body. */
extern const struct step_control INTEGRATE_NEWTON;

/* ---- a frame ------------------------------------------------------------- */

/* The fast attempt comes first, then one that goes downhill from a state that
 * exists, because after a sudden stop the velocity points the wrong way. */
extern const struct step_control FAST, ROBUST;
enum { MOST_SUBSTEPS = 8 };

struct frame {
    enum status status; /* of the last attempt; not OK: the frame is lost */
    enum status first;  /* of the fast attempt: why there were others */
    int substeps;       /* 1, or into how many the frame was cut */
    int attempts;
    int iterations, factorisations; /* of all attempts together */
};

/*
 * Make one frame: u and v advance by dt to the boundary values g [alg:frame].
 * Backward Euler of step.h, tried with FAST, then with ROBUST, then ROBUST in
 * 2, 4, ... MOST_SUBSTEPS sub-steps, the prescribed values going in a straight
 * line to g.
 *
 * now  in/out  u, v and v_before; exactly as it was when the frame is lost
 */
struct frame integrate_frame(struct body *body, double dt, const double g[],
                             struct state *now);

#endif
