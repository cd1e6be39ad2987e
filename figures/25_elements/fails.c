/*
 * fails.c - where does a graded mesh make things worse?
 *
 * Tables: the error of quadratic triangles against m, n = 8 and 32, nu = 0.3
 * and (tissue) 0.45; the longest stable step of an explicit method, whose
 * smallest cells shrink like n^-m; and the push of trial.h by linear triangles,
 * log law: the least J of its motion.  The midpoint rule solves for the middle
 * u* of a step, where the log law holds its own, and goes on to 2 u* - u, which
 * may be inside out all the same.
 */
#include "hang.h"
#include "trial.h"

#include "base/options.h"
#include "../study/study.h"
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
    const struct hang limit[] = {hang_limit(0.3), hang_limit(0.45)};
    double error[COUNT(grading)][4], step[3][3], order[3];
    struct work pushed[COUNT(push)];

    table_begin("error", "m n8 n32 tissue_n8 tissue_n32");
    for (int k = 0; k < COUNT(grading); k++) {
        for (int i = 0; i < 4; i++) {
            const struct hang hang = hang_of(HANG_QUADRATIC, i % 2 ? 32 : 8,
                                             grading[k], i < 2 ? 0.3 : 0.45);
            error[k][i] = hang_apart(&hang, &limit[i / 2]);
        }
        table_row(grading[k], cell_rounded(3, error[k][0]),
                  cell_rounded(3, error[k][1]), cell_rounded(3, error[k][2]),
                  cell_rounded(3, error[k][3]));
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
    for (int i = 0; i < 4; i += 2)
        for (int k = 0; k < COUNT(grading); k++)
            claim(error[2][i] <= error[k][i] &&
                      (k < 3 || error[3][i + 1] < 0.75 * error[2][i + 1]),
                  "n = 8: m = 2 errs least (%g, not %g), n = 32: 2.5 errs less "
                  "(%g, %g)", error[2][i], error[k][i], error[3][i + 1],
                  error[2][i + 1]);
    claim(error[5][0] > error[0][0], "n = 8: m = 4 is worse than no grading");
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
