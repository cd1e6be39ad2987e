/*
 * limit_load.c - how do the cures fail beyond a limit load?
 *
 * One element of the cubic law from rest, at nu = 0, where no equilibrium has
 * more than P = mu = 500, and at nu = 0.05, where beyond 527.25 the next
 * equilibrium is far away: plain Newton, load stepping, line search.
 */
#include "element.h"
#include "base/study.h"
#include "base/table.h"

int main(void)
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct newton_control searched = {1e-10, 1000, 1, 0};
    int differ = 1, jumped = 1;
    double last = 0.0;

    table_begin_note("limit_load", "nu p reason_plain iterations_plain F_plain "
                     "reason_stepping iterations_stepping F_stepping "
                     "reason_search iterations_search",
                     "F_stepping is its last state");
    for (int i = 0; i < 2; i++)
        for (int k = 0; k <= 3; k++) {
            const struct material m = material_make(CUBIC, 1000.0, 0.05 * i);
            const double p = (0.4637 + 0.0478 * k) * 1000.0;
            const struct element_report a =
                element_newton(&m, p, 1.0, &control);
            const struct element_report b =
                element_stepping(&m, p, 0.0, &control);
            const struct element_report c =
                element_newton(&m, p, 1.0, &searched);
            table_row(0.05 * i, p, status_name(a.status), a.iterations,
                      cell_if(a.status == OK, a.F), status_name(b.status),
                      b.iterations, b.F, status_name(c.status), c.iterations);
            if (i == 0 && k > 0) {
                differ &= a.status == MAX_ITERATIONS && b.status == STALLED &&
                          c.status == NOT_SPD;
                last = b.F;
            }
            if (i == 1 && k > 1)
                jumped &= a.status == OK && a.F > 3.0 && b.status == OK &&
                          b.F > 3.0;
        }
    table_end();

    claim(differ, "beyond the limit load of nu = 0 plain Newton wanders, load "
          "stepping stalls and the line search finds P' < 0");
    claim(last > 1.9 && last < 2.0, "load stepping stops just before the "
          "limit point F = 2 (at %g)", last);
    claim(jumped, "at nu = 0.05 plain Newton and load stepping jump beyond "
          "F = 3 without a word");
    return table_finish();
}
