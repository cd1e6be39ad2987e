/*
 * price.h - how long a processor of this machine works for a model of ladder.h.
 *
 * Nothing of the scene is timed.  A body four times as long as high, bent by
 * its weight, is solved by a model of the same rung, at rest or in motion, on
 * the same level of the mesh: its half bandwidth is that of all bodies that are
 * longer than high, so that seconds are in proportion to the columns of cells
 * and to the linear systems, of which the scene's own run knows the number.
 */
#ifndef CHOOSE_PRICE_H
#define CHOOSE_PRICE_H

#include "choice/ladder.h"

struct price {
    double begin, system; /* seconds of a column of cells: once, and for each
                           * linear system */
};

/* Return the fastest of the runs that fit into 0.1 s, with the triangles of
 * ladder_alloc_of(). */
struct price price_calibrate(enum element element, double grade,
                             struct ladder_model model);

/* Return the seconds of the solve, without those of ladder_alloc(). */
double price_seconds(const struct ladder_state *state, struct price price);

/* Return the seconds of a frame: a step of a motion, or the solve at rest. */
double price_frames(const struct ladder_state *state);

/* Return the columns of cells that fit into so many seconds per frame, with as
 * many systems: between the prices of n levels, the first of level 0, a power
 * of the columns, and beyond them the power of the last two. */
int price_columns(const struct ladder_state *state, const struct price price[],
                  int n, double seconds);

#endif
