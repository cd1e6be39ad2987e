/*
 * climb.h - up the ladder of ladder.h: solve, estimate what was left out, add
 * the largest part, until it is enough [alg:least-model].
 */
#ifndef COMMON_CLIMB_H
#define COMMON_CLIMB_H

#include "choice/estimate.h"

/* A model that was tried, its estimates, and the next addition. */
struct climb_rung {
    struct ladder_model model;
    double part[N_PART], estimate;
    enum part add;
    enum doubt doubt;
};

/* Set the rung of a model that is solved, OK.  Return whether it is enough. */
int climb_judge(const struct ladder_state *state, double tolerance,
                struct climb_rung *rung);

/*
 * Climb from the first rung until a model is enough or no other one may be:
 * nothing is left to add, the steps are too long, or a model has no state.  At
 * rest, where no finer mesh is left, the geometry is still added: another
 * element may do with the law.  Return the last; *n rungs are in tried[], of
 * one that is not OK only its model.
 */
enum { CLIMB_MOST = 16 }; /* each adds a rung, motion or a level */
struct ladder_state *climb_ladder(const struct ladder_scene *scene,
                                  double tolerance,
                                  struct climb_rung tried[CLIMB_MOST], int *n);

#endif
