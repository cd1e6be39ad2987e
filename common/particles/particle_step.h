/*
 * particle_step.h - one step of the material point method: the nodes of the
 * grid move by u, implicitly, and take the particles along.
 *
 *     w = u / dt - v                     what a node gains in velocity
 *     E(u) = w.M w / 2 + Psi(u) - sum_a m_a g.u_a       [eq:particle-potential]
 *     r = dE/du = M w / dt - f(u) - m g                 [eq:particle-residual]
 *
 * r = 0 is backward Euler; A = K + M / dt^2 is the tangent of r.  An endless
 * step, 1 / dt = 0, is the static problem: no inertia is left.  M is lumped,
 * m_a on the diagonal, or consistent, sum_p m_p N_a N_b.
 *
 * Source: Jiang, Schroeder, Teran, Stomakhin & Selle, The material point method
 * for simulating continuum materials, SIGGRAPH 2016 Courses, sec. 10.
 *
 * Names: unknowns_, wall_, potential_.
 */
#ifndef COMMON_PARTICLE_STEP_H
#define COMMON_PARTICLE_STEP_H

#include "particles/particle_force.h"

/* What keeps the body at x_1 = 0: nothing; nodes at x_1 <= 0 do not move; or
 * they move as a mirror has it, u(-x_1) = -u(x_1) [eq:mirror]. */
enum wall { NO_WALL, HELD, MIRROR };
#define WALLS "none held mirror" /* as words, in this order */
const char *wall_name(enum wall wall);

struct particle_step {
    double rate; /* 1 / dt (1/s), or 0 */
    double g[2]; /* (m/s^2) */
    int consistent;
    enum wall wall;
    enum transfer transfer;
};

/*
 * The unknowns y that the nodes move by: u_r = sign_r y_(equation r), and 0
 * where equation_r < 0.  The nodes with mass have unknowns; those of a bar move
 * along its axis only.
 */
struct unknowns {
    int n, n_dof;
    int *equation; /* [n_dof]; owned, both */
    double *sign;
};
struct unknowns *unknowns_alloc(const struct grid *grid); /* none yet */
void unknowns_free(struct unknowns *map);
void unknowns_number(const struct grid *grid, enum wall wall,
                     struct unknowns *map);

/* y := T^T r and u := T y, for u = T y. */
void unknowns_gather(const struct unknowns *map, const double r[], double y[]);
void unknowns_scatter(const struct unknowns *map, const double y[], double u[]);

/* Return max|y|; NaN if an entry is. */
double unknowns_largest(const struct unknowns *map, const double y[]);

/* Return a zero matrix for them, as wide as the particles need. */
struct matrix *unknowns_matrix(const struct particle_body *body,
                               const struct unknowns *map);

/* out := M w; grid->mass is that of P2G. */
enum status particle_mass(const struct particle_body *body, int consistent,
                          const double w[], double out[]);

/* A += scale T^T M T. */
enum status particle_mass_matrix(const struct particle_body *body,
                                 int consistent, double scale,
                                 const struct unknowns *map, struct matrix *A);

struct potential {
    double inertia, elastic, load; /* the three terms of E (J) */
};
double potential_sum(struct potential E);

/* Return whether E at `there` is less than at `here`, or not more than by 1e-12
 * of its parts: so close to the minimum E is round-off, and du needs no
 * guard. */
int potential_falls(struct potential here, struct potential there);

/* Set E and r at u; statuses of particle_force(). */
enum status particle_potential(const struct particle_body *body,
                               const struct particle_step *step,
                               const double u[], struct potential *E,
                               double r[]);

/* How a step went: the linear systems solved (particle_newton() does not count
 * one that stalled), and those factored again because A had to be projected;
 * max|r| of the unknowns (N) before iteration k, max|du| (m) of it, and the
 * part of du that was taken. */
enum { STEP_CAP = 50 };
struct particle_report {
    enum status status;
    int iterations, projections;
    struct potential E; /* of the last u */
    double residual[STEP_CAP + 1], increment[STEP_CAP + 1], part[STEP_CAP + 1];
};

/* material2_dpk1() without its negative modes [eq:projection]; the LINEAR law
 * has none. */
mat2 particle_projected(const struct material *material, mat2 F, mat2 dF);

/*
 * Solve r = 0 by Newton's method from u = 0, where nothing is inverted, with
 * halving until potential_falls() [alg:particle-newton].  Where A is not
 * positive definite, it is assembled again with particle_projected().  Done:
 * max|du| <= tolerance h, then max|r| <= tolerance h max A_ii.  NOT_SPD:
 * neither A is positive definite, as where nothing holds a node; STALLED: no
 * part of du makes E fall; MAX_ITERATIONS; OUTSIDE; NONFINITE.
 */
struct particle_report particle_newton(const struct particle_body *body,
                                       const struct particle_step *step,
                                       double tolerance, double u[]);

#endif
