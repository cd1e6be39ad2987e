/*
 * orders.c - are the exponents of the curves those that were predicted?
 *
 * In time: u at the end on the coarsest mesh, log law, over steps, against the
 * midpoint rule with the most steps, extrapolated; the exponent of the last
 * doubling.  Predicted: 1 for backward Euler, 2 for midpoint and bdf2; for
 * symplectic Euler 2 from rest without a force, where its first velocity is
 * right to the second order, and 1 in the swing, which is let go under forces.
 * A wave is damped by exp(-omega^2 T dt / 2): where waves are all that there
 * is, in the slow scenes, that has to be near 1, with some 10^4 steps.
 *
 * In space: static, differences of meshes.  Predicted: 2 for the log law; for
 * the linear one, n = 64 to 256, twice the power of r that u has at the corner
 * between a held and a free side [eq:corner].
 */
#include "work.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

struct count {
    int curves, within; /* within 0.2 */
};

static void print(enum work_scene scene, const char *knob, const char *what,
                  double predicted, double order, double error,
                  struct count *count)
{
    const int within = fabs(order - predicted) <= 0.2;
    table_row(work_scene_name(scene), knob, what, predicted,
              cell_rounded(4, order), cell_rounded(4, error),
              within ? "yes" : "no");
    count->curves++;
    count->within += within;
}

static void in_time(enum work_scene scene, struct count *count)
{
    const int slow = scene == SLOW_PULL || scene == BUCKLE;
    const int most = scene == BUCKLE ? 16384 : slow ? 4096 : 1024;
    struct work_setting set = {scene, LOG, 1, work_coarsest(scene), 0,
                               IMPLICIT_MIDPOINT, 1e-11, LINEAR_TRIANGLE, 1.0};
    struct work run[2], end;
    for (int k = 0; k < 2; k++) {
        set.steps = most << k;
        run[k] = work_run(&set);
    }
    end = run[1];
    work_correct(&end, 1.0 / 3.0, &run[1], &run[0]);
    const double size = work_distance(&end, NULL);
    for (int m = 0; m < N_METHOD; m++) {
        const int first = m == BACKWARD_EULER ||
                          (m == SYMPLECTIC_EULER && scene == SWING);
        const int last = slow && m == BACKWARD_EULER ? 16384 : most / 2;
        double error[2];
        set.method = (enum method)m;
        for (int k = 0; k < 2; k++) {
            set.steps = k ? last : last / 2;
            const struct work at = work_run(&set);
            error[k] = work_distance(&at, &end) / size;
        }
        print(scene, "time", method_name(set.method), first ? 1.0 : 2.0,
              study_order(error[0], error[1], 2.0), error[1], count);
    }
}

static void in_space(enum work_scene scene, enum law law, struct count *count)
{
    struct work_setting set = {scene, law, 0, 0, law == LOG ? 4 : 1,
                               BACKWARD_EULER, 1e-9, LINEAR_TRIANGLE, 1.0};
    struct work run[3];
    const struct material notes = material_notes(law);
    for (int k = 0; k < 3; k++) {
        set.n = law == LINEAR ? 64 << k : work_coarsest(scene) * (4 << k);
        run[k] = work_run(&set);
    }
    const double fine = work_distance(&run[1], &run[2]);
    const double predicted =
        law == LINEAR ? 2.0 * material_corner(&notes) : 2.0;
    print(scene, "space", material_law(law), predicted,
          study_order(work_distance(&run[0], &run[1]), fine, 2.0),
          fine / work_distance(&run[2], NULL), count);
}

int main(void)
{
    static const enum work_scene held[] = {SLOW_PULL, FAST_PULL, BUCKLE, PUSH};
    struct count count = {0};
    table_begin("orders", "scene knob curve predicted measured error within");
    for (int k = 0; k < JOLTED_PULL; k++) in_time((enum work_scene)k, &count);
    const struct count time = count;
    for (int k = 0; k < 4; k++) in_space(held[k], LOG, &count);
    in_space(SLOW_PULL, LINEAR, &count); /* the pulls and the push are one */
    in_space(BUCKLE, LINEAR, &count);
    table_end();
    table_begin("within", "knob curves within");
    table_row("time", time.curves, time.within);
    table_row("space", count.curves - time.curves, count.within - time.within);
    table_row("all", count.curves, count.within);
    table_end();
    claim(time.within == time.curves, "every exponent in time is the predicted "
          "one (%d of %d)", time.within, time.curves);
    claim(10 * count.within >= 9 * count.curves, "so are nine tenths of all "
          "(%d of %d)", count.within, count.curves);
    return table_finish();
}
