/*
 * orders.c - are the exponents of the curves those that were predicted?
 *
 * In time: u at the end on the coarsest mesh, log law, over steps, against the
 * midpoint rule with the most steps, extrapolated; the exponent of the last
 * doubling.  Predicted: 1 for backward Euler, 2 for midpoint and bdf2; for
 * symplectic Euler 2 from rest without a force, where its first velocity is
 * right to the second order, and 1 in the swing, which is let go under forces.
 * In space: static, differences of meshes from 4 to 16 times the coarsest;
 * predicted: 2.
 */
#include "study.h"
#include "table.h"
#include "work.h"

#include <math.h>

struct count {
    int curves, within;     /* within 0.2 */
    int smooth, smooth_within; /* in time, of scenes whose waves matter */
};

static void print(enum work_scene scene, const char *knob, const char *what,
                  double predicted, double order, double error,
                  struct count *count)
{
    const int within = fabs(order - predicted) <= 0.2;
    table_row(work_scene_name(scene), knob, what, predicted, order, error,
              within ? "yes" : "no");
    count->curves++;
    count->within += within;
}

static void in_time(enum work_scene scene, struct count *count)
{
    const int slow = scene == SLOW_PULL || scene == BUCKLE;
    const int most = scene == BUCKLE ? 16384 : slow ? 4096 : 1024;
    struct work_setting set = {scene, LOG, 1, work_coarsest(scene), 0,
                               IMPLICIT_MIDPOINT, 1e-11};
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
        const int before = count->within;
        double error[2];
        set.method = (enum method)m;
        for (int k = 0; k < 2; k++) {
            set.steps = most >> (2 - k);
            const struct work at = work_run(&set);
            error[k] = work_distance(&at, &end) / size;
        }
        print(scene, "time", method_name(set.method), first ? 1.0 : 2.0,
              order_of(error[0], error[1], 2.0), error[1], count);
        count->smooth += !slow;
        count->smooth_within += !slow && count->within > before;
    }
}

static void in_space(enum work_scene scene, enum law law, struct count *count)
{
    struct work_setting set = {scene, law, 0, 0, law == LOG ? 16 : 1,
                               BACKWARD_EULER, 1e-9};
    struct work run[3];
    for (int k = 0; k < 3; k++) {
        set.n = work_coarsest(scene) * (4 << k);
        run[k] = work_run(&set);
    }
    const double fine = work_distance(&run[1], &run[2]);
    print(scene, "space", material_law(law), 2.0,
          order_of(work_distance(&run[0], &run[1]), fine, 2.0),
          fine / work_distance(&run[2], NULL), count);
}

int main(void)
{
    static const enum work_scene held[] = {SLOW_PULL, FAST_PULL, BUCKLE, PUSH};
    struct count count = {0};
    table_begin("orders", "scene knob curve predicted measured error within");
    for (int k = 0; k < FLAGSHIP; k++) in_time((enum work_scene)k, &count);
    const struct count time = count;
    for (int k = 0; k < 4; k++) in_space(held[k], LOG, &count);
    in_space(SLOW_PULL, LINEAR, &count); /* the pulls and the push are one */
    in_space(BUCKLE, LINEAR, &count);
    table_end();
    table_begin("within", "knob curves within smooth smooth_within");
    table_row("time", time.curves, time.within, time.smooth,
              time.smooth_within);
    table_row("space", count.curves - time.curves, count.within - time.within,
              MISSING, MISSING);
    table_row("all", count.curves, count.within, MISSING, MISSING);
    table_end();
    claim(count.smooth == count.smooth_within, "where waves matter, every "
          "exponent in time is the predicted one (%d of %d)",
          count.smooth_within, count.smooth);
    claim(10 * time.within >= 9 * time.curves && 2 * (count.within -
              time.within) >= count.curves - time.curves,
          "so are 9 of 10 in time and half in space (%d of %d in all)",
          count.within, count.curves);
    return table_finish();
}
