/*
 * particle_bodies.h - bodies that step, and their exact answers.
 *
 *     hanging    the bar 0 < X < 1 at rest, held at 0, pulled along its axis
 *     strained   a free bar of ten particles, irregular, strained and moving
 *     block      4 x 4 particles in the plane, strained and turning
 *
 * All of them have density 1 (or nearly) and a grid with room for their motion.
 *
 * Names: cloud_, hanging_.
 */
#ifndef COMMON_PARTICLE_BODIES_H
#define COMMON_PARTICLE_BODIES_H

#include "particles/particle_scene.h"

#include "particles/particle_step.h"

/* Put ppc particles into each of the cells of 1 / cells; from -2 h to 1.75. */
struct cloud cloud_hanging(int order, int cells, int ppc);

/*
 * Return where X is, and its stretch in *F, when the static bar carries the
 * body force c > 0 (N/m): P(F) = c (1 - X), x = [F P - psi] / c, between X and
 * 0 [eq:hanging-bar].
 */
double hanging_place(const struct material *material, double c, double X,
                     double *F);

/* max_p |x_p - x(X_p)|, and max_p |P(F_p) - c (1 - X_p)|, of a hanging bar with
 * particles from the middles of equal parts. */
struct hanging_error {
    double place, stress;
};
struct hanging_error hanging_error(const struct particles *p,
                                   const struct material *material, double c);

struct cloud cloud_strained(int order); /* h = 1/8 */
struct cloud cloud_block(int order);    /* h = 1/4 */

/* One of three bodies and what pulls at it (m/s^2): the hanging bar of 8 cells
 * with two particles each, 9.81; the strained one, -9.81; the block, 0. */
enum stepping { HANGING, STRAINED, BLOCK };
#define STEPPING "bar strained block" /* as words, in this order */
struct cloud cloud_stepping(enum stepping which, int order, double g[2]);

/* Return sum_p V_p psi(F_p) */
double particles_elastic(const struct particles *p,
                         const struct material *material);

/* A row of the table that table_begin("energies", CLOUD_ENERGIES) began: after
 * the step of the report, at time t. */
#define CLOUD_ENERGIES                                               \
    "t iterations elastic kinetic grid_before grid_after potential " \
    "momentum_x momentum_y angular"
void cloud_energies(struct cloud c, const struct material *material, double t,
                    const struct particle_report *report);

/* Print three tables: `newton`, the iterations of the report; `step`, the nodes
 * with mass and their velocities before and after; `particles`. */
void cloud_tables(struct cloud c, const struct particle_report *report);

#endif
