/*
 * log_or_cubic.c - what does the cubic r change of the log law, and where?
 *
 * The numbers of Figure 6 of the notes (energy.gp, stress.gp, r.gp).  Tables:
 * how far the stresses of the cubic and of the linear law are from the log
 * law's in one dimension, and at which F they first are so by 1, 5 and 10 per
 * cent; of energy, stress and r the cubic law's value at F = 0, where the log
 * law has none, and where they first differ by 1 per cent.
 */
#include "material/material.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum quantity { ENERGY, STRESS, R, N_QUANTITY };

/* In one dimension, where J = F; the linear law has no r. */
static double value(enum quantity quantity, enum law law, double F)
{
    const struct material m = material_notes(law);
    switch (quantity) {
    case ENERGY: return material1_psi(&m, F);
    case STRESS: return material1_pk1(&m, F);
    default: return material_r(&m, F).r;
    }
}

/* Return the value over the log law's, less 1, for F > 0 and not 1. */
static double difference(enum quantity quantity, enum law law, double F)
{
    return value(quantity, law, F) / value(quantity, LOG, F) - 1.0;
}

struct level {
    enum quantity quantity;
    enum law law;
    double percent;
};

static double excess(double F, void *context)
{
    const struct level *level = context;
    return 100.0 * fabs(difference(level->quantity, level->law, F)) -
           level->percent;
}

/* Return the first F where the difference reaches the level, going out from 1
 * by factors, of 1.001 or of 1 / 1.001. */
static const double TENSION = 1.001, COMPRESSION = 1.0 / 1.001;
static double first_passing(struct level level, double factor)
{
    double F = factor;
    while (excess(F * factor, &level) < 0.0) F *= factor;
    return study_root(excess, &level, F, F * factor);
}

/* Print how far the stresses are from the log law's, over F: |F - 1| = 0.001
 * ... 2.  One difference passes 0 near F = 1.68. */
static void print_difference(void)
{
    enum { CLOSE = 640 };
    table_begin_note("difference", "F cubic linear", "100 (P / P_log - 1)");
    for (int i = -CLOSE; i <= CLOSE; i++) {
        const double d = 2.0 * pow(2000.0, abs(i) / (double)CLOSE - 1.0);
        const double F = i < 0 ? 1.0 - d : 1.0 + d;
        if (i != 0 && F > 0.0)
            table_row(F, 100.0 * difference(STRESS, CUBIC, F),
                      100.0 * difference(STRESS, LINEAR, F));
    }
    table_end();
}

/* Print at which F the stresses differ by so many per cent.  Return how many
 * times closer to rest the linear law does, at least. */
static double print_passes(void)
{
    const double percent[] = {1.0, 5.0, 10.0};
    double least = INFINITY;
    table_begin("passes", "percent cubic_tension cubic_compression "
                          "linear_tension linear_compression");
    for (int i = 0; i < 3; i++) {
        double cubic_F[2], linear_F[2]; /* tension, compression */
        for (int k = 0; k < 2; k++) {
            const double factor = k == 0 ? TENSION : COMPRESSION;
            cubic_F[k] = first_passing(
                (struct level){STRESS, CUBIC, percent[i]}, factor);
            linear_F[k] = first_passing(
                (struct level){STRESS, LINEAR, percent[i]}, factor);
            least = fmin(least, fabs((cubic_F[k] - 1.0) / (linear_F[k] - 1.0)));
        }
        table_row(percent[i], cubic_F[0], cubic_F[1], linear_F[0], linear_F[1]);
    }
    table_end();
    return least;
}

int main(void)
{
    static const char *const name[] = {"energy", "stress", "r"};
    const struct material cubic = material_notes(CUBIC);
    const double mu = cubic.mu, lambda = cubic.lambda;
    double at_0[N_QUANTITY], low[N_QUANTITY], high[N_QUANTITY];

    print_difference();
    const double least = print_passes();
    table_begin_note("apart", "quantity at_0 compression tension",
                     "the cubic law at F = 0; off the log law's by 1 per cent");
    for (int k = 0; k < N_QUANTITY; k++) {
        const struct level level = {(enum quantity)k, CUBIC, 1.0};
        at_0[k] = value(level.quantity, CUBIC, 0.0);
        low[k] = first_passing(level, COMPRESSION);
        high[k] = first_passing(level, TENSION);
        table_row(name[k], at_0[k], low[k], high[k]);
    }
    table_end();

    const double order = study_order(
        fabs(value(R, CUBIC, 0.98) - value(R, LOG, 0.98)),
        fabs(value(R, CUBIC, 0.99) - value(R, LOG, 0.99)), 2);
    claim(fabs(order - 4.0) < 0.05, "both r are equal up to the third "
          "derivative: their difference is of order 4 in J - 1 (%g)", order);
    claim(fabs(at_0[ENERGY] / (4.0 / 3.0 * mu + 121.0 / 72.0 * lambda) - 1.0) <
                  1e-12 &&
              fabs(at_0[STRESS] / -(5.5 * lambda + 3.0 * mu) - 1.0) < 1e-12 &&
              fabs(at_0[R] / (-11.0 / 6.0) - 1.0) < 1e-12,
          "at F = 0 the cubic law has psi = 4/3 mu + 121/72 lambda (%g), "
          "P = -(11/2 lambda + 3 mu) (%g) and r = -11/6 (%g)",
          at_0[ENERGY], at_0[STRESS], at_0[R]);
    for (int k = 0; k < N_QUANTITY; k++)
        claim(low[k] <= low[STRESS] && high[k] >= high[STRESS],
              "nothing differs by 1 per cent before the stress does (%s: "
              "F = %g, %g)", name[k], low[k], high[k]);
    claim(least > 3.0, "the linear law passes each level at least 3 times "
          "closer to rest than the cubic law (%g times)", least);
    claim(difference(STRESS, CUBIC, 3.0) > difference(STRESS, LINEAR, 3.0),
          "at F = 3 the cubic law is further off than the linear one");
    return table_finish();
}
