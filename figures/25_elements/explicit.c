/*
 * explicit.c - why do quadratic triangles gain nothing with explicit steps?
 *
 * Table: the error of the explicit swing of trial.h against its step, as a
 * fraction of the longest, of both elements on the vertices of n = 32.
 */
#include "trial.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

int main(void)
{
    static const double fraction[] = {0.9, 0.75, 0.5, 0.25, 0.1};
    enum { FRACTIONS = COUNT(fraction) };
    double linear[FRACTIONS], quadratic[FRACTIONS], floor;
    const struct work limit = trial_limit(TRIAL_EXPLICIT, &floor);

    table_begin("explicit", "fraction linear quadratic");
    for (int k = 0; k < FRACTIONS; k++) {
        const struct work degree_1 =
            trial_explicit(LINEAR_TRIANGLE, 32, fraction[k]).end;
        const struct work degree_2 =
            trial_explicit(QUADRATIC_TRIANGLE, 16, fraction[k]).end;
        linear[k] = trial_apart(&degree_1, &limit);
        quadratic[k] = trial_apart(&degree_2, &limit);
        table_row(fraction[k], cell_rounded(2, linear[k]),
                  cell_rounded(2, quadratic[k]));
    }
    table_end();
    for (int k = 1; k < FRACTIONS; k++)
        claim(linear[k] > linear[k - 1], "explicit swing: the error of linear "
              "triangles grows as the steps shrink from %g to %g of the "
              "longest (%g, %g)", fraction[k - 1], fraction[k], linear[k - 1],
              linear[k]);
    claim(linear[FRACTIONS - 1] - linear[0] > 2.0 * floor, "what long steps "
          "hide of it is more than twice what is not known of the limit "
          "(%g, %g)", linear[FRACTIONS - 1] - linear[0], floor);
    claim(quadratic[0] > 1.3 * linear[0] &&
              fabs(quadratic[FRACTIONS - 1] - linear[FRACTIONS - 1]) < floor,
          "quadratic triangles err more near the longest step, and alike in a "
          "tenth of it (%g, %g; %g, %g)", linear[0], quadratic[0],
          linear[FRACTIONS - 1], quadratic[FRACTIONS - 1]);
    const double longest = trial_longest_step(LINEAR_TRIANGLE, 16, 1.0);
    const double shorter = trial_longest_step(QUADRATIC_TRIANGLE, 8, 1.0);
    claim(longest > 1.15 * shorter && longest < 1.25 * shorter,
          "linear triangles have 1.2 times the longest step of quadratic ones "
          "with the same vertices (%g, %g)", longest, shorter);
    return table_finish();
}
