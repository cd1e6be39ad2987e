/*
 * step_map.c - how far may the boundary move at once?
 *
 * A bar of length 1, n elements of the log law, free at the other end: the
 * boundary is pushed or pulled by dg in one step.  Only the first element feels
 * it (from the last state), or all of them share it (from the linear lift).
 * Predicted [eq:first-step]: the element's stretch may change by less than 1
 * when pushed, by less than exp(1/2 + mu / lambda) - 1 when pulled.
 */
#include "element.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { GRID = 60, PUSH = 0, PULL = 1 };

int main(void)
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct material m = material_notes(LOG);
    const double limit[] = {1.0, exp(0.5 + m.mu / m.lambda) - 1.0};
    int wrong = 0, failed = 0;

    table_begin("step_map", "dg n push push_iterations pull pull_iterations "
                            "push_lift pull_lift cubic_push cubic_pull");
    for (int i = 0; i < GRID; i++)
        for (int k = 1; k <= 14; k++) {
            const int n = (int)lround(pow(2.0, 0.5 * k));
            const double dg = pow(10.0, -2.486 + 3.477 * i / (GRID - 1));
            struct element_report plain[2], lift[2], cubic[2];
            for (int s = PUSH; s <= PULL; s++) {
                const double jump = (s == PULL ? -1.0 : 1.0) * dg * n;
                plain[s] = element_cured(CURE_PLAIN, m, 0.0, jump, n, control);
                lift[s] = element_cured(CURE_START, m, 0.0, jump, n, control);
                cubic[s] = element_cured(CURE_CUBIC, m, 0.0, jump, n, control);
                wrong += (plain[s].status == OK) != (dg * n < limit[s]);
                wrong += (lift[s].status == OK) != (dg < limit[s]);
                failed += cubic[s].status != OK;
            }
            table_row(dg, n, status_name(plain[PUSH].status),
                      plain[PUSH].iterations, status_name(plain[PULL].status),
                      plain[PULL].iterations, status_name(lift[PUSH].status),
                      status_name(lift[PULL].status),
                      status_name(cubic[PUSH].status),
                      status_name(cubic[PULL].status));
        }
    table_end();
    table_begin("predicted", "push pull");
    table_row(limit[PUSH], limit[PULL]);
    table_end();

    claim(wrong == 0, "the log law converges below the predicted steps and "
          "nowhere else (%d exceptions)", wrong);
    claim(failed == 0, "the cubic law converges for every step (%d times it "
          "does not)", failed);
    return table_finish();
}
