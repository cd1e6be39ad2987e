/*
 * cost.c - what does a better model cost than the linear bar?
 *
 * A bar of 16 elements that hangs or stands under its own weight, c in units
 * of E: the free end of the linear bar (one linear solve), of Newton's method
 * with the cubic and the log law, and its error after k solves, all against the
 * converged log law.  The first solve from rest is the linear bar [alg:newton].
 */
#include "bar/bar_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum { N = 16, STEPS = 7, LOADS = 5, CAP = 60 };

/* u at the free end after at most `cap` steps of Newton's method from rest, or
 * converged if cap is CAP; *solves linear systems. */
static double newton_end(enum law law, double c, int cap, int *solves)
{
    const struct newton_control control = {1e-12, cap, 0, 0};
    struct bar_scene scene = bar_scene_notes(law, N);
    scene.c = c;
    struct bar_state *state = bar_scene_solve(&scene, &control);
    const struct newton_report report = state->report;
    const double u = state->u[N];
    bar_state_free(state);
    if (report.status != OK && !(report.status == MAX_ITERATIONS && cap < CAP))
        die("%s: nonlinear bar under %g, residual %g",
            status_name(report.status), c, report.residual);
    *solves = report.iterations;
    return u;
}

int main(void)
{
    const double load[LOADS] = {10.0, 100.0, 500.0, -100.0, -500.0};
    double linear_error[LOADS], cubic_error[LOADS], error[STEPS][LOADS];
    double first = 0.0, most = 0.0;

    table_begin("cost", "c linear_u linear_error cubic_solves cubic_error "
                        "log_solves log_u");
    for (int l = 0; l < LOADS; l++) {
        const double c = load[l];
        int solves, cubic_solves, unused;
        const double exact = newton_end(LOG, c, CAP, &solves);
        const double linear = newton_end(LINEAR, c, 1, &unused);
        const double cubic = newton_end(CUBIC, c, CAP, &cubic_solves);
        linear_error[l] = fabs(linear / exact - 1.0);
        cubic_error[l] = fabs(cubic / exact - 1.0);
        table_row(c, linear, linear_error[l], cubic_solves, cubic_error[l],
                  solves, exact);
        for (int k = 0; k < STEPS; k++)
            error[k][l] =
                fabs(newton_end(LOG, c, k + 1, &unused) / exact - 1.0);
        first = fmax(first, fabs(error[0][l] - linear_error[l]));
        most = fmax(most, abs(cubic_solves - solves));
    }
    table_end();
    table_begin_note("newton", "solves c1 c2 c3 c4 c5",
                     "c1 to c5: the loads of table cost, in its order");
    for (int k = 0; k < STEPS; k++)
        table_row(k + 1, error[k][0], error[k][1], error[k][2], error[k][3],
                  error[k][4]);
    table_end();

    claim(first < 1e-12, "Newton's first solve is the linear bar (off by %g)",
          first);
    claim(linear_error[0] < 0.005 && linear_error[1] > 0.01 &&
              error[1][1] < 2e-4,
          "the linear bar is wrong by less than 1 %% at c = 10 and by more at "
          "100, where a second solve leaves less than 0.02 %% (%g, %g, %g)",
          linear_error[0], linear_error[1], error[1][1]);
    claim(most == 0.0 && cubic_error[2] > 0.01, "the cubic law needs as many "
          "solves as the log law, and is wrong by %g at 500", cubic_error[2]);
    return table_finish();
}
