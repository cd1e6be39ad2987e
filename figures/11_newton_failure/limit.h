/*
 * limit.h - the limit load of one element in tension, and what lies beyond it.
 *
 * For a small nu the stress P(F) of the cubic law, and for a large one that of
 * the log law, has a largest value at some F > 1, the limit load; farther out
 * it may return to 0, another state of rest.  P'' vanishes at most once there.
 */
#ifndef FIGURES_LIMIT_H
#define FIGURES_LIMIT_H

#include "material/material.h"

/* The F > 1 of the limit load, and that of the other state of rest; NAN where
 * there is none. */
double limit_point(struct material *m);
double limit_rest(struct material *m);

/* The smallest P' beyond F = 1, and the smallest P beyond the limit load, or P
 * far away where there is none: 0 where the limit load, and where the other
 * state of rest, disappear. */
double limit_least_slope(struct material *m);
double limit_least_stress(struct material *m);

#endif
