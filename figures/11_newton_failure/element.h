/*
 * element.h - Newton's method on one element: the stretch F with P(F) = p.
 *
 * In a bar with a free end every element carries a known stress p, and Newton
 * on the bar [alg:newton] is, for each element by itself,
 *
 *     F := F + (p - P(F)) / P'(F)   until P(F) = p.
 *
 * With it come the cures for its failure [eq:first-step]: load stepping
 * [alg:load-stepping], the line search [alg:line-search] on the energy
 * w(F) = psi(F) - p (F - 1), a better start, and another law.
 *
 * Source: J. Teran's lecture notes, Lecture 2, 2.5.5 and 2.5.6; Nocedal &
 * Wright, Numerical Optimization, 2nd ed., sec. 3.1 for the line search.
 */
#ifndef FIGURES_ELEMENT_H
#define FIGURES_ELEMENT_H

#include "bar/bar.h"

struct element_report {
    enum status status; /* OK, INVERTED, NONFINITE, NOT_SPD, STALLED,
                         * MAX_ITERATIONS */
    int iterations;     /* linear systems solved */
    double F;           /* the last state */
};

/*
 * Newton from F, which needs no equilibrium and may be inverted.  It stops when
 * |P - p| <= tolerance (2 mu + lambda) and the increment is <= tolerance.
 *
 * INVERTED   the log law is not defined at an iterate (without line search)
 * NONFINITE  no finite step: P' = 0
 * NOT_SPD    with line search: the step leads uphill, P' < 0
 * STALLED    the increment is at round-off while the residual is not small, or
 *            no length of the step decreases the energy
 */
struct element_report element_newton(const struct material *material, double p,
                                     double F,
                                     const struct newton_control *control);

/*
 * From rest, F = 1, to the stress p, while the boundary moves by jump (in units
 * of the element's length, pushing is positive), in steps that halve when they
 * fail and double when they converge.  One attempt may take 25 iterations, all
 * together control->max_iterations.  F is the last equilibrium.
 *
 * STALLED    a step of less than 2^-10 of the way would be needed
 */
struct element_report element_stepping(const struct material *material,
                                       double p, double jump,
                                       const struct newton_control *control);

enum cure {
    CURE_PLAIN, CURE_STEPPING, CURE_SEARCH, CURE_START, CURE_CUBIC, N_CURE
};
#define CURES "plain stepping search start cubic" /* as words, in this order */

/*
 * From rest to the stress p with the boundary moved by jump, one cure at a
 * time.  CURE_PLAIN starts at F = 1 - jump; CURE_START at
 * exp(p / (2 mu + lambda)) or, for p = 0, at the linear lift, where n elements
 * share the jump.
 */
struct element_report element_cured(enum cure cure, struct material material,
                                    double p, double jump, int n,
                                    struct newton_control control);

#endif
