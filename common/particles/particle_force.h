/*
 * particle_force.h - what elastic particles do to the nodes of their grid.
 *
 * Node a moves by u_a and takes the particles along.  Each has then
 *
 *     F     = (I + sum_a u_a (x) grad N_a(x_p)) F_p = F_p + sum_a u_a (x) q_a,
 *     q_a   = F_p^T grad N_a(x_p)                               [eq:pull-back]
 *     Psi   = sum_p V_p psi(F)                             [eq:particle-energy]
 *     f_a   = -dPsi/du_a = -sum_p V_p P(F) q_a              [eq:particle-force]
 *     (K w)_a = sum_p V_p dP(F; sum_b w_b (x) q_b) q_a    [eq:particle-tangent]
 *
 * V_p is the undeformed volume and q_a the gradient of N_a with respect to the
 * undeformed place, so that these are finite elements once more, with particles
 * for Gauss points.  x_p and F_p are those of the particles and do not move.
 *
 * Vectors over the nodes are flat, component k of node a at [2a + k].  Where
 * the second components of u are 0 on a bar, those of its forces are 0 too.
 *
 * Source: Jiang, Schroeder, Teran, Stomakhin & Selle, The material point method
 * for simulating continuum materials, SIGGRAPH 2016 Courses.
 *
 * Names: grid_, support_.
 */
#ifndef COMMON_PARTICLE_FORCE_H
#define COMMON_PARTICLE_FORCE_H

#include "material/material.h"
#include "linear/matrix.h"
#include "particles/particles.h"

/* material2_dpk1(), or a change of it, as one without negative eigenvalues. */
typedef mat2 dpk1_function(const struct material *material, mat2 F, mat2 dF);

/* Particles of one material and their grid; both are borrowed. */
struct particle_body {
    const struct grid *grid;
    const struct particles *particles;
    struct material material;
    dpk1_function *dpk1; /* NULL: material2_dpk1 */
};

/* gradient[i] := F^T gradient[i] [eq:pull-back]. */
void support_pull_back(struct support *s, mat2 F);

/*
 * All of them: statuses of grid_support(); INVERTED, LOG and some det F <= 0;
 * NONFINITE, u (or w, or a result) is not finite.  Results are then incomplete.
 */
enum status particle_energy(const struct particle_body *body, const double u[],
                            double *energy);

/* Set f_a (N). */
enum status particle_force(const struct particle_body *body, const double u[],
                           double f[]);

/* The same forces from sigma = P F^T / J and the gradients of the nodes where
 * they are now: -sum_p J V_p sigma F_hat^-T grad N_a. */
enum status particle_cauchy_force(const struct particle_body *body,
                                  const double u[], double f[]);

/* Compute it by central differences of the energy, u_r + step and u_r -
 * step. */
enum status particle_difference_force(const struct particle_body *body,
                                      const double u[], double step,
                                      double f[]);

/* Sum, and torque about 0, of forces f that act at the nodes x + u; u may be
 * NULL: at x. */
struct balance {
    double force[2], torque;
};
struct balance grid_balance(const struct grid *grid, const double u[],
                            const double f[]);

/*
 * Is f the force at u, and Kw its tangent times w?  Then the errors of Taylor's
 * series at u + t w fall like t^2: |Psi(u + t w) - Psi(u) + t f.w| and
 * max|f(u + t w) - f + t Kw|, with energies and forces of this module.
 */
struct taylor {
    double energy, force;
};
enum status particle_taylor(const struct particle_body *body, const double u[],
                            const double w[], double t, const double f[],
                            const double Kw[], struct taylor *error);

/*
 * K += the matrix of the unknowns y that the nodes move by: u_r = sign[r]
 * y_(equation[r]), 0 where equation[r] < 0; sign NULL: all 1.  Two nodes may
 * share an unknown, as at a mirror.  K is banded, not factored, and of at least
 * the half bandwidth that particle_band() tells (INT_MAX if a particle is
 * OUTSIDE).
 */
int particle_band(const struct particle_body *body, const int equation[]);
enum status particle_stiffness(const struct particle_body *body,
                               const double u[], const int equation[],
                               const double sign[], struct matrix *K);

#endif
