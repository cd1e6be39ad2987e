/*
 * trial.h - one scene, solved with one element on one mesh, and what a linear
 * system of it costs.
 *
 *     weight   left end held, its weight; linear elasticity, at rest
 *     pull     both ends apart, 0.42 m each; log law, at rest
 *     column   8 times as long as thick, its ends 0.1 m inwards each, and
 *              turned a little: it has buckled; log law, at rest
 *     shake    left end 0.3 m up and down again in 0.4 s; log law, in 32 steps
 *              of the midpoint rule
 *     swing    a hump in the middle is let go, both ends held; at 0.03 s, in 32
 *              steps of the midpoint rule
 *     explicit the same by leapfrog, in steps of 3/4 of the longest stable one
 *     push     right end 0.6 m inwards within 0.08 s, the other one held; log
 *              law, in 32 steps of the midpoint rule
 *
 * Meshes of n x n squares, (-1, 1)^2; the column has n x n/8.  Graded towards
 * the ends that are held, and towards the bottom and the top.  The notes'
 * material; lumped mass, of quadratic triangles the scaled one.  The implicit
 * motions have the same steps on all meshes, so that nothing but the error in
 * space makes two of them differ.
 */
#ifndef FIGURES_TRIAL_H
#define FIGURES_TRIAL_H

#include "plane/body.h"

enum trial_scene {
    WEIGHT, PULL, COLUMN, SHAKE, SWING, EXPLICIT, PUSH, TRIAL_SCENES
};
const char *trial_name(enum trial_scene scene);

/* The coarsest n of a scene, others are multiples of it. */
int trial_coarsest(enum trial_scene scene);

enum { TRIAL_SHARED = 25 };
struct trial {
    enum status status; /* INVERTED: also where min_J is not > 0 */
    int unknowns, systems, steps;
    int n_shared;                /* entries of u */
    double u[2 * TRIAL_SHARED];  /* (m), at the vertices of the coarsest mesh */
    double min_J;  /* of all triangles, and of all steps of a motion */
    double flops; /* of a linear system; of the whole motion, EXPLICIT */
};

/*
 * A system costs what sparse.h counts, the factor in the order of nested
 * dissection and two triangular solves, and its elements: 250 flops of a linear
 * triangle with its tangent, 1700 of a quadratic one; 100 and 400 without
 * [eq:roofline].
 */
struct trial trial_of(enum trial_scene scene, enum element element, int n,
                      double m);

/* The longest stable step (s) of an explicit method at rest, both ends held:
 * 2 / omega of the largest frequency [eq:critical-step]. */
double trial_longest_step(enum element element, int n, double m);

/* |a - b| over the shared vertices, of |b|; INFINITY if a run is not OK. */
double trial_apart(const struct trial *a, const struct trial *b);

#endif
