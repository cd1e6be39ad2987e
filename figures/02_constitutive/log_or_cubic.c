/*
 * log_or_cubic.c - what does the cubic r change of the log law, and where?
 *
 * The numbers of Figure 6 of the notes (energy.gp, stress.gp, r.gp).  Tables:
 * how far the stresses of the cubic (nu = 0.3, 0.45) and of the linear law are
 * from the log law's in one dimension, and over nu at which F they first are so
 * by 1 and 10 per cent; of energy, stress and r the cubic law's value at F = 0,
 * where the log law has none, and where they first differ by 1 per cent.
 */
#include "material/material.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum quantity { ENERGY, STRESS, R, N_QUANTITY };

/* In one dimension, where J = F; the linear law has no r. */
static double value(enum quantity quantity, enum law law, double nu, double F)
{
    const struct material m = material_make(law, 1000.0, nu);
    switch (quantity) {
    case ENERGY: return material1_psi(&m, F);
    case STRESS: return material1_pk1(&m, F);
    default: return material_r(&m, F).r;
    }
}

/* Return the value over the log law's, less 1, for F > 0 and not 1. */
static double difference(enum quantity quantity, enum law law, double nu,
                         double F)
{
    return value(quantity, law, nu, F) / value(quantity, LOG, nu, F) - 1.0;
}

struct level {
    enum quantity quantity;
    enum law law;
    double nu, percent;
};

static double excess(double F, void *context)
{
    const struct level *level = context;
    return 100.0 * fabs(difference(level->quantity, level->law, level->nu,
                                   F)) - level->percent;
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
 * ... 2.  With nu = 0.3 one passes 0 near F = 1.68. */
static void print_difference(void)
{
    enum { CLOSE = 640 };
    table_begin_note("difference", "F cubic tissue linear",
                     "100 (P / P_log - 1); tissue: cubic, nu = 0.45");
    for (int i = -CLOSE; i <= CLOSE; i++) {
        const double d = 2.0 * pow(2000.0, abs(i) / (double)CLOSE - 1.0);
        const double F = i < 0 ? 1.0 - d : 1.0 + d;
        if (i != 0 && F > 0.0)
            table_row(F, 100.0 * difference(STRESS, CUBIC, 0.3, F),
                      100.0 * difference(STRESS, CUBIC, 0.45, F),
                      100.0 * difference(STRESS, LINEAR, 0.3, F));
    }
    table_end();
}

/* Print at which F the stresses differ by 1 and 10 per cent.  Return how many
 * times closer to rest the linear law does, at least; of all nu the narrowest
 * interval where the cubic law differs by less than 1 per cent. */
static double print_passes(double narrowest[2])
{
    static const double ratio[] = {0.0, 0.3, 0.45, 0.49};
    double least = INFINITY;
    table_begin("passes", "nu percent cubic_compression cubic_tension "
                          "linear_compression linear_tension");
    for (int i = 0; i < COUNT(ratio); i++)
        for (double percent = 1.0; percent <= 10.0; percent += 9.0) {
            const struct level cubic = {STRESS, CUBIC, ratio[i], percent};
            const struct level linear = {STRESS, LINEAR, ratio[i], percent};
            const double F[] = {first_passing(cubic, COMPRESSION),
                                first_passing(cubic, TENSION),
                                first_passing(linear, COMPRESSION),
                                first_passing(linear, TENSION)};
            table_row(ratio[i], percent, F[0], F[1], F[2], F[3]);
            least = fmin(least, fmin((1.0 - F[0]) / (1.0 - F[2]),
                                     (F[1] - 1.0) / (F[3] - 1.0)));
            narrowest[0] = fmax(narrowest[0], percent < 10.0 ? F[0] : 0.0);
            narrowest[1] = fmin(narrowest[1], F[1]);
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
    double narrowest[2] = {0.0, INFINITY};

    print_difference();
    const double least = print_passes(narrowest);
    table_begin_note("apart", "quantity at_0 compression tension",
                     "the cubic law at F = 0; off the log law's by 1 per cent");
    for (int k = 0; k < N_QUANTITY; k++) {
        const struct level level = {(enum quantity)k, CUBIC, 0.3, 1.0};
        at_0[k] = value(level.quantity, CUBIC, 0.3, 0.0);
        low[k] = first_passing(level, COMPRESSION);
        high[k] = first_passing(level, TENSION);
        table_row(name[k], at_0[k], low[k], high[k]);
    }
    table_end();

    const double order = study_order(
        fabs(value(R, CUBIC, 0.3, 0.98) - value(R, LOG, 0.3, 0.98)),
        fabs(value(R, CUBIC, 0.3, 0.99) - value(R, LOG, 0.3, 0.99)), 2);
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
    claim(narrowest[0] < 0.87 && narrowest[1] > 1.14,
          "for every nu the cubic law's stress differs by less than 1 per cent "
          "for 0.87 < F < 1.14 (%g, %g)", narrowest[0], narrowest[1]);
    claim(fabs(difference(STRESS, CUBIC, 0.3, 1.8)) < 0.03 &&
              difference(STRESS, CUBIC, 0.45, 1.8) > 0.4 &&
              difference(STRESS, CUBIC, 0.0, 1.8) < -0.2,
          "at F = 1.8 by 3, 40 and -20 per cent (nu = 0.3, 0.45, 0)");
    claim(least > 2.0, "the linear law passes each level at least twice as "
          "close to rest as the cubic law (%g times)", least);
    claim(difference(STRESS, CUBIC, 0.3, 3.0) >
              difference(STRESS, LINEAR, 0.3, 3.0),
          "at F = 3 the cubic law is further off than the linear one");
    return table_finish();
}
