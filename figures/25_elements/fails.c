/*
 * fails.c - where does a graded mesh make things worse?
 *
 * Tables: the error of quadratic triangles against m, n = 8; the longest stable
 * step of an explicit method, whose smallest cells shrink like n^-m; and the
 * push of trial.h by linear triangles, log law: the least J of its motion.  The
 * midpoint rule solves for the middle u* of a step, where the log law holds its
 * own, and goes on to 2 u* - u, which may be inside out all the same.
 */
#include "hang.h"
#include "trial.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

int main(void)
{
    static const double grading[] = {1.0, 1.5, 2.0, 2.5, 3.0, 4.0};
    static const struct {
        int n;
        double m;
    } push[] = {{16, 1.0}, {16, 2.0}, {16, 3.0},
                {32, 1.0}, {32, 1.5}, {32, 2.0}};
    const struct hang limit = hang_limit(0.3);
    double error[COUNT(grading)], step[3][3], order[3];
    struct work pushed[COUNT(push)];

    table_begin("error", "m error");
    for (int k = 0; k < COUNT(grading); k++) {
        const struct hang hang = hang_of(HANG_QUADRATIC, 8, grading[k], 0.3);
        error[k] = hang_apart(&hang, &limit);
        table_row(grading[k], cell_rounded(4, error[k]));
    }
    table_end();
    table_begin("step", "m step_8 step_16 step_32 order");
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 3; j++)
            step[k][j] =
                trial_longest_step(QUADRATIC_TRIANGLE, 8 << j, grading[k]);
        order[k] = study_order(step[k][1], step[k][2], 2.0);
        table_row(grading[k], cell_rounded(3, step[k][0]),
                  cell_rounded(3, step[k][1]), cell_rounded(3, step[k][2]),
                  cell_rounded(2, order[k]));
    }
    table_end();
    table_begin("push", "n m ends min_J");
    for (int k = 0; k < COUNT(push); k++) {
        pushed[k] = trial_of(TRIAL_PUSH, LINEAR_TRIANGLE, push[k].n, push[k].m)
                        .end;
        table_row(push[k].n, push[k].m, status_name(pushed[k].status),
                  pushed[k].status == OK ? cell_rounded(2, pushed[k].min_J)
                                         : cell_word(MISSING));
    }
    table_end();
    claim(error[2] < error[0] && error[5] > error[0], "n = 8: m = 2 helps (%g "
          "after %g), and m = 4 is worse than no grading (%g)", error[2],
          error[0], error[5]);
    for (int k = 0; k < 3; k++)
        claim(fabs(order[k] - grading[k]) < 0.1, "the longest step falls like "
              "n^-m: m = %g, order %g", grading[k], order[k]);
    claim(pushed[2].status == OK && pushed[2].min_J < 0.5 * pushed[0].min_J,
          "pushed, n = 16: with m = 3 the worst triangle keeps less than half "
          "of what it keeps on an even mesh (%g, %g)", pushed[2].min_J,
          pushed[0].min_J);
    claim(pushed[3].status == OK && pushed[4].status == INVERTED &&
          pushed[5].status == INVERTED, "pushed, n = 32: the graded meshes are "
          "turned inside out, the even one is not (%s, %s, %s)",
          status_name(pushed[3].status), status_name(pushed[4].status),
          status_name(pushed[5].status));
    return table_finish();
}
