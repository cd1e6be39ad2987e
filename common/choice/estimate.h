/*
 * estimate.h - what a model of ladder.h leaves out, estimated from what it
 * gives, and what to add to it.
 *
 * Each part is relative to the displacement and costs less than the solve:
 *
 *     geometry   max |H^T H| / 2 over max |H|               [eq:left-geometry]
 *     law        |P_cubic - P_log| over |P_log| at the extreme J
 *                                                           [eq:left-law]
 *     dimension  the bending, and the held end that stays wide
 *                                                           [eq:left-dimension]
 *     inertia    1 / (omega T), omega of Rayleigh's quotient
 *                                                           [eq:left-inertia]
 *     mesh       what P - P_recovered would move, and in motion its delay
 *                                               [eq:left-mesh] [eq:left-phase]
 *     stress     what stress that turns with the body moves  [eq:left-stress]
 *
 * Source: Zienkiewicz & Zhu, Int. J. Numer. Meth. Eng. 24 (1987), for the
 * recovery; G. R. Liu, T. Nguyen-Thoi & K. Y. Lam, J. Sound Vib. 320 (2009),
 * for means over edges, and over vertices for the part with lambda; Timoshenko
 * & Gere, Theory of Elastic Stability, 2nd ed., sec. 1.11, for pressed beams.
 */
#ifndef COMMON_ESTIMATE_H
#define COMMON_ESTIMATE_H

#include "choice/relax.h"
#include "choice/rung.h"

/* Return max |H^T H| / 2 / max |H|, H = F - I, Frobenius norm; 0 for u = 0. */
double estimate_geometry(const struct ladder_state *state);

/* Return the larger |P_cubic - P_log| / |P_log| in uniaxial strain at the least
 * and at the largest J, at most 1; 1 where relax_law() is. */
double estimate_law(const struct ladder_state *state);

/* Return the part of the error for which a bar of this length and height has no
 * unknowns, under f; the bending times 1 / (1 - P / P_cr) where it is pressed
 * by P, less where it is pulled; 1 from the load P_cr on at which it buckles, 0
 * for f that neither pulls nor bends. */
double estimate_dimension(const struct ladder_state *state);

/* Return omega (1/s), omega^2 = |f.u| / u.M u for the density 1; 0 for u = 0.
 * And min(1, 1 / (omega T)), 1 for u = 0, which says nothing of how fast it
 * is. */
double estimate_frequency(const struct ladder_state *state);
double estimate_inertia(const struct ladder_state *state);

/*
 * The forces that the mesh leaves out, int (P - recovered) grad N.  Over an
 * edge the mean of P of its two triangles, by area, is recovered, at a vertex
 * that of all around it; of a triangle it is the mean of its three edges, but
 * for p, of which it is that of its three vertices: where nu is near 1/2
 * triangles lock in p, and the edges with them.  And the forces that a linear
 * model leaves out, -int H sigma grad N, for the stress sigma turns with the
 * body.  Their parts: relax_mesh(), relax_part().
 */
relax_forces estimate_mesh, estimate_stress;

/* Estimate all of them. */
void estimate_parts(const struct ladder_state *state, double part[N_PART]);

/* Return max |G|, G the Green strain. */
double estimate_strain(const struct ladder_state *state);

/*
 * What no part sees, and what nobody may rely on.  A strain beyond 4: of the
 * cubic law a body that is torn so far may rest in more than one place.
 * Steps of omega dt > 1: what swings so fast is not followed.  K that is not
 * positive definite, at the peak of a motion as well; from half of the load
 * on that ladder_pressed() names this is asked of quadratic triangles on the
 * finest mesh as well, which hardly lock.  From the whole of it on a slender
 * body BUCKLES if it is taken to stay straight: its model is linear, or
 * nothing says to which side it goes; so does a short one if those triangles
 * go aside.  TOO_STIFF is an answer from which they differ by more than half.
 * From GIVES_WAY on the parts mean nothing.
 */
#define ESTIMATE_STRAIN 4.0
#define ESTIMATE_ANGLE 1.0 /* omega dt */
#define ESTIMATE_BEAM 3.0  /* length over height */
enum doubt { NO_DOUBT, TORN, LONG_STEPS, GIVES_WAY, BUCKLES, TOO_STIFF };
enum doubt estimate_doubt(const struct ladder_state *state);

/*
 * Return the verdict [alg:least-model]: parts that the model does not leave out
 * become 0, *estimate is the root of the sum of the squares of the others, for
 * their signs have nothing in common; *add is the largest, of equal ones the
 * first; where the model is linear and not sure, GEOMETRY.  true: the model is
 * enough, *estimate <= tolerance, and sure, which is NO_DOUBT.
 */
int estimate_verdict(struct ladder_model model, enum ladder_time time, int sure,
                     double tolerance, double part[N_PART], double *estimate,
                     enum part *add);

#endif
