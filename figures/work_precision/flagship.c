/*
 * flagship.c - do smaller steps help the scene of the speed chapter?
 *
 * The ends apart by sin t / 2 from rest, cubic law, n = 8, backward Euler in 30
 * to 1920 steps of a second: how far u at t = 1 is from that of half as many
 * steps, and from the static answer.  In the note what half of h changes.  The
 * ends jump to their velocity at t = 0; beside it the pull with a soft start.
 */
#include "base/study.h"
#include "base/table.h"
#include "motion/work.h"

int main(void)
{
    struct work_setting set = {JOLTED_PULL, CUBIC, 0, 16, 4, BACKWARD_EULER,
                               1e-10, LINEAR_TRIANGLE, 1.0};
    double change[7], away[7], soft[7];
    struct work before, rest, run;
    const struct work half = work_run(&set);
    set.n = 8;
    before = rest = work_run(&set);
    const double space = work_distance(&rest, &half);

    set.dynamic = 1;
    for (int k = 0; k < 7; k++) {
        set.steps = 30 << k;
        run = work_run(&set);
        change[k] = work_distance(&run, &before);
        away[k] = work_distance(&run, &rest);
        before = run;
    }
    set = (struct work_setting){SLOW_PULL, CUBIC, 0, 8, 4, BACKWARD_EULER,
                                1e-10, LINEAR_TRIANGLE, 1.0};
    rest = work_run(&set);
    set.dynamic = 1;
    for (int k = 0; k < 7; k++) {
        set.steps = 30 << k;
        run = work_run(&set);
        soft[k] = work_distance(&run, &rest);
    }
    table_begin_note("flagship", "steps change from_static soft_start",
                     "half of h changes %g m", space);
    for (int k = 0; k < 7; k++)
        table_row(30 << k, cell_if(k > 0, change[k]), away[k], soft[k]);
    table_end();
    table_begin("space", "change");
    table_row(space);
    table_end();

    claim(space > 5000.0 * change[1],
          "half of h changes thousands of times as much as half of dt = 1/30 "
          "(%g, %g)", space, change[1]);
    claim(away[3] < 1.1 * away[0] && away[6] > 10.0 * away[0],
          "1920 steps are ten times as far from the static answer as 30 (%g, "
          "%g)", away[6], away[0]);
    claim(soft[6] < 2.0 * soft[0] && soft[6] < 0.1 * away[6],
          "with a soft start they are not (%g, %g)", soft[6], soft[0]);
    return table_finish();
}
