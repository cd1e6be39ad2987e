/*
 * rung.h - how each rung of ladder.h is solved: a sum along the bar, one linear
 * system, Newton's method, and for a motion implicit midpoint with either.
 *
 * Names: ladder_.
 */
#ifndef COMMON_RUNG_H
#define COMMON_RUNG_H

#include "choice/ladder.h"

/* Set u, and of a motion v, t, fastest, rival and apart; adds to flops what it
 * counts. OK, or how it was not solved: u is then of no use. */
enum status rung_solve(struct ladder_state *state);

/* Return what ladder_alloc() and ladder_alloc_of() do, solved. */
struct ladder_state *ladder_solve(const struct ladder_scene *scene,
                                  struct ladder_model model);
struct ladder_state *ladder_solve_of(enum element element, double grade,
                                     const struct ladder_scene *scene,
                                     struct ladder_model model);

#endif
