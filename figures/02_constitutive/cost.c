/*
 * cost.c - how many linear solves is a law worth?
 *
 * One element in uniaxial strain is pressed with the stress p that shortens it
 * by 5 per cent under the log law, and by 20.  Each solve takes the tangent
 * where the last one ended: F := F - (P(F) - p) / (dP/dF) (Newton's method).
 * The first is the same under all laws, and it is the answer of the linear one.
 * Table: the error of F - 1 after each solve, relative to the log law's.
 */
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static double newton(const struct material *m, double p, double F)
{
    return F - (material1_pk1(m, F) - p) / material1_dpk1(m, F);
}

int main(void)
{
    enum { SOLVES = 6 };
    const struct material log_law = material_notes(LOG);
    const double target[] = {0.95, 0.8}, floor = 1e-12; /* below: round-off */
    double first[2][2], last[2] = {0.0}, second[2], third[2];

    table_begin("cost", "F law solves error");
    for (int k = 0; k < 2; k++)
        for (int law = LOG; law <= CUBIC; law++) {
            const struct material m = material_notes((enum law)law);
            const double p = material1_pk1(&log_law, target[k]);
            double F = 1.0, error = 0.0;
            for (int solve = 1; solve <= SOLVES; solve++) {
                F = newton(&m, p, F);
                error = fabs((F - target[k]) / (target[k] - 1.0));
                table_row(target[k], material_law(m.law), solve,
                          error > floor ? cell_rounded(4, error)
                                        : cell_word(MISSING));
                if (solve == 1) first[k][law - LOG] = error;
                if (solve == 2 && law == LOG) second[k] = error;
                if (solve == 3 && law == LOG) third[k] = error;
            }
            if (law == CUBIC) last[k] = error;
        }
    table_end();
    for (int k = 0; k < 2; k++) {
        /* P_cubic - P_log = -mu e^3, to leading order, of (2 mu + lambda) e */
        const double e = target[k] - 1.0;
        const double off =
            log_law.mu * e * e / material_modulus(&log_law) / last[k];
        claim(third[k] < second[k] * second[k] && fabs(off - 1.0) < -e,
              "F = %g: the log law's error is squared (%g, %g), the cubic "
              "law's ends at mu e^2 / (2 mu + lambda) (%g of it)", target[k],
              second[k], third[k], off);
        claim(fabs(first[k][0] - first[k][1]) < 1e-12 && third[k] < last[k],
              "F = %g: the first solve is that of the linear law (%g), and "
              "three solves of the log law (%g) are better than the cubic law "
              "ever is (%g)", target[k], first[k][0], third[k], last[k]);
    }
    return table_finish();
}
