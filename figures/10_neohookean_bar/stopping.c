/*
 * stopping.c - two loops that stop at the wrong place.
 *
 * The notes print the loop as "do ... while max|du| < tol": it makes one step
 * where there is something to do, and never ends where there is nothing (here
 * it is cut off at 1000 steps).  With "until" it is the usual test on the
 * increment alone.  Start the log law with its first element pressed to F0:
 * P' is enormous there, the step is tiny, and the loop calls that a solution.
 * Each beside bar_newton(), which looks at the residual as well [alg:newton].
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum loop { WHILE_SMALL, UNTIL_SMALL };

/* The loop on the increment alone, tolerance 1e-8, at most 1000 steps; returns
 * the steps made, *du is the last max|du|. */
static int loop_on_increment(enum loop loop, struct bar_state *s, double *du)
{
    const struct newton_control once = {.max_iterations = 1};
    for (int k = 1; k <= 1000; k++) {
        s->report = bar_newton(&s->bar, &once, s->u, NULL);
        *du = s->report.increment;
        if (s->report.status != MAX_ITERATIONS && s->report.status != OK)
            return k;
        const int small = *du < 1e-8;
        if (loop == WHILE_SMALL ? !small : small) return k;
    }
    return 1000;
}

/* The notes' example: the left end jumps to sin t at once. */
static void print_printed_loop(void)
{
    static const double times[] = {0.0, 0.1, 0.5};
    struct bar_scene scene = bar_scene_notes(CUBIC, 10);
    table_begin_note("printed_loop", "t steps error steps_right error_right",
                     "do ... while max|du| < tol, at most 1000 steps");
    for (int k = 0; k < COUNT(times); k++) {
        double du, error = 0.0, error_right = 0.0;
        scene.g[0] = sin(times[k]);
        struct bar_state *s = bar_state_alloc(&scene);
        struct bar_state *right = bar_scene_solve(&scene, NULL);
        const int steps = loop_on_increment(WHILE_SMALL, s, &du);
        for (int i = 0; i <= 10; i++) {
            error = fmax(error, fabs(s->u[i] - scene.g[0]));
            error_right = fmax(error_right, fabs(right->u[i] - scene.g[0]));
        }
        table_row(times[k], steps, error, right->report.iterations,
                  error_right);
        bar_state_free(s);
        bar_state_free(right);
        claim(error_right <= 1e-12, "t = %g: the right loop finds sin t "
              "(error %g)", times[k], error_right);
        claim(k == 0 ? steps == 1000 : steps == 1 && error > 0.5 * scene.g[0],
              "as printed the loop never ends at t = 0, and after one step at "
              "t = 0.1 and 0.5, with more than half of sin t as error (t = %g: "
              "%d steps, error %g)", times[k], steps, error);
    }
    table_end();
}

int main(void)
{
    struct bar_scene scene = bar_scene_notes(LOG, 10);

    print_printed_loop();
    table_begin_note("increment_loop",
                     "F0 P0 steps du F P steps_right F_right",
                     "log law, element 1 compressed to F0; do ... until "
                     "max|du| < 1e-8");
    for (double F0 = 1e-4; F0 > 1e-13; F0 *= 1e-4) {
        double du;
        scene.g[0] = 0.1 * (1.0 - F0);
        struct bar_state *s = bar_state_alloc(&scene);
        struct bar_state *right = bar_scene_solve(&scene, NULL);
        const int steps = loop_on_increment(UNTIL_SMALL, s, &du);
        const double F = bar_stretch(&s->bar, s->u, 1);
        const double F_right = bar_stretch(&right->bar, right->u, 1);
        table_row(F0, material1_pk1(&scene.material, F0), steps, du, F,
                  material1_pk1(&scene.material, F), right->report.iterations,
                  F_right);
        claim(F0 > 1e-6 || (steps == 1 && F < 3.0 * F0),
              "F0 = %g: the increment alone stops after one step, close to "
              "the start (%d steps, F = %g)", F0, steps, F);
        claim(right->report.status == OK && fabs(F_right - 1.0) < 1e-12,
              "F0 = %g: residual and increment together find F = 1 (%s, %g)",
              F0, status_name(right->report.status), F_right);
        bar_state_free(s);
        bar_state_free(right);
    }
    table_end();
    return table_finish();
}
