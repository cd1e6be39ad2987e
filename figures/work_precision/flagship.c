/*
 * flagship.c - do smaller steps help the scene of the speed chapter?
 *
 * The ends apart by sin t / 2 from rest, cubic law, n = 8, backward Euler in 30
 * to 1920 steps of a second: how far u at t = 1 is from that of half as many
 * steps, and from the static answer.  In the note what half of h changes.  The
 * ends jump to their velocity at t = 0; beside it the pull with a soft start.
 * The other parts: how far 30 steps are from tiny ones of the midpoint rule,
 * and what the log law changes in the static answer.  Half of h and the log law
 * once more in the motion with tiny steps, whose waves the static answer lacks.
 */
#include "work.h"
#include "../study/study.h"
#include "base/table.h"

/* away[k] := how far the soft pull in 30 2^k steps is from the static answer */
static void soft_start(double away[7])
{
    struct work_setting set = {SLOW_PULL, CUBIC, 0, 8, 4, BACKWARD_EULER,
                               1e-10, LINEAR_TRIANGLE, 1.0};
    const struct work rest = work_run(&set);
    set.dynamic = 1;
    for (int k = 0; k < 7; k++) {
        set.steps = 30 << k;
        const struct work run = work_run(&set);
        away[k] = work_distance(&run, &rest);
    }
}

/* How far 960 and 1920 steps of the midpoint rule are from `coarse`, and what
 * half of h and the log law change in the motion with 1920. */
static void tiny_steps(const struct work *coarse, double waves[2],
                       double *space, double *law)
{
    struct work_setting set = {JOLTED_PULL, CUBIC, 1, 8, 0, IMPLICIT_MIDPOINT,
                               1e-10, LINEAR_TRIANGLE, 1.0};
    struct work run;
    for (int k = 0; k < 2; k++) {
        set.steps = 960 << k;
        run = work_run(&set);
        waves[k] = work_distance(&run, coarse);
    }
    set.n = 16;
    const struct work half = work_run(&set);
    set.n = 8;
    set.law = LOG;
    const struct work log_law = work_run(&set);
    *space = work_distance(&run, &half);
    *law = work_distance(&run, &log_law);
}

/* A row per n = 8, 16, 32: what half of h changes in the static answer, and how
 * far 30 steps are from 960 of the midpoint rule.  Four digits: the ninth
 * depends on where Newton's method stops, and so on the compiler. */
static void finer_meshes(void)
{
    double space[3], waves[3];
    struct work_setting set = {JOLTED_PULL, CUBIC, 0, 8, 4, BACKWARD_EULER,
                               1e-10, LINEAR_TRIANGLE, 1.0};
    struct work rest = work_run(&set);
    table_begin("meshes", "n space time");
    for (int k = 0; k < 3; k++) {
        set.n = 16 << k;
        const struct work half = work_run(&set);
        space[k] = work_distance(&rest, &half);
        rest = half;
        set.n = 8 << k;
        set.dynamic = 1;
        set.steps = 30;
        const struct work coarse = work_run(&set);
        set.method = IMPLICIT_MIDPOINT;
        set.steps = 960;
        const struct work fine = work_run(&set);
        waves[k] = work_distance(&fine, &coarse);
        table_row(set.n, cell_rounded(4, space[k]), cell_rounded(4, waves[k]));
        set.dynamic = 0;
        set.method = BACKWARD_EULER;
        set.steps = 4;
    }
    table_end();
    claim(fabs(space[1] / space[0] - 0.275) < 0.001 &&
              fabs(space[2] / space[1] - 0.275) < 0.01,
          "each half of h changes about 0.275 times as much as the last (%g, "
          "%g)", space[1] / space[0], space[2] / space[1]);
    claim(space[0] > 0.9 * waves[0] && space[1] < 0.3 * waves[1] &&
              space[2] < 0.1 * waves[2] &&
              fmin(waves[1], waves[2]) > 0.9 * waves[0],
          "a finer mesh does not bring the waves back: from n = 16 on half of "
          "h changes less (%g, %g) than they do (%g, %g)", space[1], space[2],
          waves[1], waves[2]);
}

int main(void)
{
    struct work_setting set = {JOLTED_PULL, CUBIC, 0, 16, 4, BACKWARD_EULER,
                               1e-10, LINEAR_TRIANGLE, 1.0};
    double change[7], away[7], soft[7], waves[2], moving_space, moving_law;
    struct work before, rest, run;
    const struct work half = work_run(&set);
    set.n = 8;
    set.law = LOG;
    run = work_run(&set);
    set.law = CUBIC;
    before = rest = work_run(&set);
    const double space = work_distance(&rest, &half);
    const double law = work_distance(&rest, &run);

    set.dynamic = 1;
    set.steps = 30;
    const struct work coarse = work_run(&set);
    tiny_steps(&coarse, waves, &moving_space, &moving_law);
    for (int k = 0; k < 7; k++) {
        set.steps = 30 << k;
        run = work_run(&set);
        change[k] = work_distance(&run, &before);
        away[k] = work_distance(&run, &rest);
        before = run;
    }
    soft_start(soft);
    table_begin_note("flagship", "steps change from_static soft_start",
                     "half of h changes %g m", space);
    for (int k = 0; k < 7; k++)
        table_row(30 << k, cell_if(k > 0, change[k]), away[k], soft[k]);
    table_end();
    table_begin("space", "change law time_960 time moving moving_law");
    table_row(space, law, waves[0], waves[1], cell_rounded(4, moving_space),
              cell_rounded(4, moving_law));
    table_end();
    finer_meshes();

    claim(space > 5000.0 * change[1],
          "half of h changes thousands of times as much as half of dt = 1/30 "
          "(%g, %g)", space, change[1]);
    claim(waves[1] > 5000.0 * change[1] && waves[1] > law &&
              fabs(waves[0] - waves[1]) < 0.05 * waves[1],
          "but the waves that 30 steps leave out change more than the law, and "
          "are resolved (%g, %g, %g)", waves[0], waves[1], law);
    claim(away[0] < 0.03 * law && moving_space > waves[1] &&
              waves[1] > moving_law && fabs(moving_space - 2.46e-3) < 5e-5 &&
              fabs(moving_law - 1.11e-3) < 5e-5,
          "30 steps are near the static answer (%g), and in the motion space "
          "(%g) is larger than time, and time than law (%g), too", away[0],
          moving_space, moving_law);
    claim(away[3] < 1.1 * away[0] && away[6] > 10.0 * away[0],
          "1920 steps are ten times as far from the static answer as 30 (%g, "
          "%g)", away[6], away[0]);
    claim(soft[6] < 0.2 * soft[0] && soft[6] < 0.1 * away[6],
          "with a soft start they are much nearer to it than 30 (%g, %g), "
          "whose distance is their error", soft[6], soft[0]);
    return table_finish();
}
