/*
 * prices.h - what every model of a scene costs, and what choosing one costs.
 *
 * A model is charged its solve; whoever does not know beforehand which model
 * will do pays for the climb of [alg:least-model] as well: solve, estimates and
 * certificate of each rung.  The certificate of a bar is the bound of
 * compression.h and, where that does not do, K factored.
 */
#ifndef FIGURES_PRICES_H
#define FIGURES_PRICES_H

#include "choice/estimate.h"

enum { PRICES_LEVELS = 4 };
struct price {
    double error, estimate;       /* relative */
    double flops;                 /* of the solve */
    double estimates;             /* of what the model leaves out */
    double certificate, cholesky; /* with the bound of a bar; without it */
    int stable;
    enum part add;
};
struct prices {
    const struct ladder_scene *scene; /* borrowed */
    /* [rung][moving][level] */
    struct price of[LOG_PLANE + 1][2][PRICES_LEVELS];
    struct ladder_model richest;
    double dense; /* the richest with dense factors, over that with a band */
};

/* Every model of the scene, solved, estimated and measured against the truth;
 * a bound that passes an unstable K is a false claim. */
void prices_find(const struct ladder_scene *scene, struct prices *prices);

const struct price *prices_at(const struct prices *prices,
                              struct ladder_model model);

/* The model with the fewest flops of those that meet the tolerance; *none:
 * there is no such one, and the richest is returned. */
struct ladder_model prices_cheapest(const struct prices *prices,
                                    double tolerance, int *none);

/* Climb from the bar, and add up what it costs, with the bound and without it.
 * false: no rung is enough, *chosen is the last. */
int prices_climb(const struct prices *prices, double tolerance,
                 struct ladder_model *chosen, double *cost, double *cholesky);

#endif
