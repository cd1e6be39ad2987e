/*
 * notes_example.c - which time steps does the notes' example survive?
 *
 * u(0, t) = sin t on a bar of length 1, free at the other end, each step of
 * Newton's method started from the state of the step before, until t >= 6.3:
 * only the first of n elements starts away from F = 1, at 1 - dg / h.
 */
#include "element.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum { N_SCENE = 10 };

int main(void)
{
    static const struct { int n; double dt; } scene[N_SCENE] = {
        {10, 0.001}, {10, 0.01}, {10, 0.1}, {10, 0.2}, {10, 0.5},
        {100, 0.001}, {100, 0.01}, {100, 0.05}, {100, 0.1}, {100, 0.5}};
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct material law[] = {material_notes(LOG), material_notes(CUBIC)};
    const double pull = exp(0.5 + law[0].mu / law[0].lambda) - 1.0;
    int as_predicted = 1, cubic_fails = 0;

    table_begin_note("example", "n dt last push pull log_iterations "
                     "log_fails cubic_iterations cubic_fails",
                     "last: the time of the last step; push, pull: the largest "
                     "and the least dg / h; fails: the time of the "
                     "first failure");
    for (int k = 0; k < N_SCENE; k++) {
        const double dt = scene[k].dt;
        double last = 0.0, push = 0.0, pulled = 0.0, fails[2] = {0.0, 0.0};
        int most[2] = {0, 0}, too_far = 0;
        for (int i = 1; last < 6.3 - 1e-9; i++) {
            last = i * dt;
            const double jump = (sin(last) - sin(last - dt)) * scene[k].n;
            push = fmax(push, jump);
            pulled = fmin(pulled, jump);
            too_far |= jump >= 1.0 || jump <= -pull;
            for (int l = 0; l < 2; l++) {
                if (fails[l] > 0.0) continue;
                const struct element_report end =
                    element_newton(&law[l], 0.0, 1.0 - jump, &control);
                if (end.iterations > most[l]) most[l] = end.iterations;
                if (end.status != OK) fails[l] = last;
            }
        }
        table_row(scene[k].n, dt, last, push, pulled,
                  cell_if(fails[0] == 0.0, most[0]),
                  cell_if(fails[0] > 0.0, fails[0]),
                  cell_if(fails[1] == 0.0, most[1]),
                  cell_if(fails[1] > 0.0, fails[1]));
        as_predicted &= too_far == (fails[0] > 0.0);
        cubic_fails |= fails[1] > 0.0;
    }
    table_end();

    claim(as_predicted, "the log law fails where a step is beyond the limits "
          "1 and %g, and only there", -pull);
    claim(!cubic_fails, "the cubic law survives every time step");
    return table_finish();
}
