/*
 * numbers.h - a scene in numbers without dimension, and the model they name.
 *
 * Of the linear answer at rest on the coarsest mesh, its largest strain e and
 * what a linear stress lacks of it, what the geometry leaves out
 * [eq:left-geometry], and 1 / (omega T) [eq:left-inertia]; by the beam's
 * formulas alone, the share of bending [eq:left-dimension], and the axial force
 * over the one that buckles.
 */
#ifndef FIGURES_NUMBERS_H
#define FIGURES_NUMBERS_H

#include "choice/estimate.h"

struct numbers {
    double strain, geometry, bends;
    double strained; /* e (1 + nu) / (2 (1 - nu)) */
    double force;  /* over the one that buckles a beam, > 0 where it presses */
    double moves;  /* 0: the load stands */
    double turned; /* the larger of geometry and of what the axial force makes
                    * of the bending, |force| of it; times 1 + 2 moves, but
                    * after a rise at most 2, for so far may a body go */
};
struct numbers numbers_of(const struct ladder_scene *scene);

/* BAR, LINEAR_PLANE where it bends by more than the tolerance or moves,
 * CUBIC_PLANE where it is turned or strained by more than that. */
enum rung numbers_rung(struct numbers numbers, double tolerance);

/* Does it take time steps?  After a load has risen in T, a mode swings about
 * its new place by up to 2 / (omega T) of it. */
int numbers_moving(struct numbers numbers, double tolerance);

#endif
