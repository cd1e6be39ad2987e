/*
 * poisson.c - how far may the ends jump in the first step, as Poisson's ratio
 * comes near 1/2?
 *
 * Both ends of the square at rest are shifted at once (rigid) or pulled apart
 * (stretch), n = 16, and the notes' method makes one step.  Table: the jumps,
 * in units of h and in steps of 0.01 h, at which it first fails; an empty cell
 * says that none does below 2 h.  Between these steps a jump may fail earlier.
 */
#include "first_step.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { RATIOS = 11 };

static double limit(enum reading reading, enum law law, double nu)
{
    struct scene_setting set = scene_notes(reading, law, 16);
    set.nu = nu;
    struct scene *s = scene_alloc(&set);
    int k = 10;
    while (k < 200 && first_converges(s, asin(0.01 * k * 2.0 / 16))) k++;
    scene_free(s);
    return k < 200 ? 0.01 * k : INFINITY;
}

int main(void)
{
    static const double ratio[RATIOS] = {0.0, 0.05, 0.1, 0.15, 0.2, 0.25,
                                         0.3, 0.35, 0.4, 0.45, 0.49};
    double cubic[RATIOS], log[RATIOS], pulled[RATIOS], log_pulled[RATIOS];

    table_begin("poisson", "nu cubic log pulled log_pulled");
    for (int k = 0; k < RATIOS; k++) {
        cubic[k] = limit(RIGID, CUBIC, ratio[k]);
        log[k] = limit(RIGID, LOG, ratio[k]);
        pulled[k] = limit(STRETCH, CUBIC, ratio[k]);
        log_pulled[k] = limit(STRETCH, LOG, ratio[k]);
        table_row(ratio[k], cubic[k], log[k],
                  cell_if(isfinite(pulled[k]), pulled[k]),
                  cell_if(isfinite(log_pulled[k]), log_pulled[k]));
    }
    table_end();

    for (int k = 7; k < RATIOS; k++)
        claim(cubic[k] < cubic[k - 1] && log[k] < log[k - 1] &&
                  pulled[k] < pulled[k - 1],
              "from nu = 0.3 on all fail earlier (%g)", ratio[k]);
    claim(fabs(cubic[6] - 0.93) < 0.01 && fabs(cubic[9] - 0.55) < 0.01 &&
              fabs(cubic[10] - 0.24) < 0.01,
          "shifted, at %g, %g and %g h (cubic law; nu = 0.3, 0.45, 0.49)",
          cubic[6], cubic[9], cubic[10]);
    claim(fabs(log[9] - cubic[9]) < 0.03 && fabs(log[10] - cubic[10]) < 0.01 &&
              log[6] < cubic[6] - 0.1 && log[0] > cubic[0] + 0.2,
          "near 1/2 both laws fail alike, at 0 the log law later (%g, %g)",
          log[0], cubic[0]);
    claim(!isfinite(log_pulled[6]) && log_pulled[9] < pulled[9] &&
              fabs(log_pulled[10] - pulled[10]) < 0.03,
          "pulled outward, the log law bears 2 h at 0.3, but near 1/2 no more "
          "than the cubic law (%g, %g)", log_pulled[9], log_pulled[10]);
    claim(fabs(pulled[9] - 1.01) < 0.01 && fabs(pulled[10] - 0.31) < 0.01,
          "pulled outward, at %g and %g h (nu = 0.45, 0.49)", pulled[9],
          pulled[10]);
    return table_finish();
}
