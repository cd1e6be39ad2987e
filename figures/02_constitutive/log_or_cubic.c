/*
 * log_or_cubic.c - what does the cubic r change of the log law, and where?
 *
 * Figure 6 of the notes and what it does not show.  Tables: energy, stress and
 * tangent of the three laws in one dimension, and r(J) itself [eq:r-cubic]; how
 * far the stresses of the cubic and of the linear law are from the log
 * law's, and at which F they first are so by 1, 5 and 10 per cent.
 */
#include "material/material.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

/* The points of all curves, F or J = -1 ... 3; and those of the differences,
 * one of which passes 0 near F = 1.67, on either side of 1. */
enum { POINTS = 160, CLOSE = 640 };
static double point(int i)
{
    return (4.0 * i - POINTS) / POINTS;
}

static double r_of(enum law law, double J)
{
    const struct material material = material_notes(law);
    return material_r(&material, J).r;
}

/* The linear law has no r. */
static void print_curve(enum law law)
{
    const struct material m = material_notes(law);
    static const char *const name[] = {"curve_linear", "curve_log",
                                       "curve_cubic"};
    table_begin_note(name[law], "F psi P dP r",
                     "where the law is defined; r(J) at J = F");
    for (int i = 0; i <= POINTS; i++) {
        const double F = point(i);
        if (!material_defined(&m, F)) continue;
        const double r = law == LINEAR ? 0.0 : r_of(law, F);
        table_row(F, material1_psi(&m, F), material1_pk1(&m, F),
                  material1_dpk1(&m, F), cell_if(law != LINEAR, r));
    }
    table_end();
}

/* P / P_log - 1, for F > 0 and not 1. */
static double difference(enum law law, double F)
{
    const struct material m = material_notes(law), log = material_notes(LOG);
    return material1_pk1(&m, F) / material1_pk1(&log, F) - 1.0;
}

struct level {
    enum law law;
    double percent;
};

static double excess(double F, void *context)
{
    const struct level *level = context;
    return 100.0 * fabs(difference(level->law, F)) - level->percent;
}

/* The first F where the difference reaches the level, going out from 1 by
 * factors, of 1.001 or of 1 / 1.001. */
static double first_passing(enum law law, double percent, double factor)
{
    struct level level = {law, percent};
    double F = factor;
    while (excess(F * factor, &level) < 0.0) F *= factor;
    return study_root(excess, &level, F, F * factor);
}

int main(void)
{
    const struct material cubic = material_notes(CUBIC);
    const double percent[] = {1.0, 5.0, 10.0};
    double least = INFINITY;

    for (int law = LINEAR; law <= CUBIC; law++) print_curve((enum law)law);
    table_begin_note("difference", "F cubic linear", "100 (P / P_log - 1)");
    for (int i = -CLOSE; i <= CLOSE; i++) { /* |F - 1| = 0.001 ... 2 */
        const double d = 2.0 * pow(2000.0, abs(i) / (double)CLOSE - 1.0);
        const double F = i < 0 ? 1.0 - d : 1.0 + d;
        if (i != 0 && F > 0.0)
            table_row(F, 100.0 * difference(CUBIC, F),
                      100.0 * difference(LINEAR, F));
    }
    table_end();
    table_begin("passes", "percent cubic_tension cubic_compression "
                          "linear_tension linear_compression");
    for (int i = 0; i < 3; i++) {
        double cubic_F[2], linear_F[2]; /* tension, compression */
        for (int k = 0; k < 2; k++) {
            const double factor = k == 0 ? 1.001 : 1.0 / 1.001;
            cubic_F[k] = first_passing(CUBIC, percent[i], factor);
            linear_F[k] = first_passing(LINEAR, percent[i], factor);
            least = fmin(least, fabs((cubic_F[k] - 1.0) / (linear_F[k] - 1.0)));
        }
        table_row(percent[i], cubic_F[0], cubic_F[1], linear_F[0], linear_F[1]);
    }
    table_end();

    const double order = study_order(fabs(r_of(CUBIC, 0.98) - r_of(LOG, 0.98)),
                                  fabs(r_of(CUBIC, 0.99) - r_of(LOG, 0.99)), 2);
    claim(fabs(order - 4.0) < 0.05, "both r are equal up to the third "
          "derivative: their difference is of order 4 in J - 1 (%g)", order);
    claim(fabs(material1_pk1(&cubic, 0.0) /
               -(5.5 * cubic.lambda + 3.0 * cubic.mu) - 1.0) < 1e-12,
          "at collapse the cubic law has P = -(11/2 lambda + 3 mu)");
    claim(least > 3.0, "the linear law passes each level at least 3 times "
          "closer to rest than the cubic law (%g times)", least);
    claim(difference(CUBIC, 3.0) > difference(LINEAR, 3.0),
          "at F = 3 the cubic law is further off than the linear one");
    return table_finish();
}
