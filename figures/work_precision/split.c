/*
 * split.c - of what does the error of a setting consist?
 *
 * A chain from the setting to the limit, one knob per link [eq:error-parts]:
 * tolerance (to 1e-9 m), time (midpoint rule, 64 and 128 steps, extrapolated),
 * space (the limit of the same model), model (the limit of log, dynamic), with
 * limits by the same elements as in trials.h.  Each link is measured with the
 * other errors driven below a tenth of it: `others` is what is left of them,
 * over the part, for the largest part of a setting.
 */
#include "../study/study.h"
#include "trials.h"
#include "base/table.h"

#include <math.h>

static const char *const part_name[] = {"model", "space", "time", "solver"};

struct bar {
    const char *name;
    struct work_setting set;
    enum part due; /* the largest part */
};
static const struct bar bars[] = {
    {"slow pull: linear, static, n = 16",
     {SLOW_PULL, LINEAR, 0, 16, 1, BACKWARD_EULER, 1e-5,
      LINEAR_TRIANGLE, 1.0}, MODEL},
    {"slow pull: log, static, n = 4",
     {SLOW_PULL, LOG, 0, 4, 1, BACKWARD_EULER, 1e-5,
      LINEAR_TRIANGLE, 1.0}, SPACE},
    {"slow pull: log, static, n = 16, one Newton step",
     {SLOW_PULL, LOG, 0, 16, 1, BACKWARD_EULER, 1.0,
      LINEAR_TRIANGLE, 1.0}, SOLVER},
    {"fast pull: log, static, n = 16",
     {FAST_PULL, LOG, 0, 16, 1, BACKWARD_EULER, 1e-5,
      LINEAR_TRIANGLE, 1.0}, MODEL},
    {"fast pull: log, backward Euler, n = 16, 16 steps",
     {FAST_PULL, LOG, 1, 16, 16, BACKWARD_EULER, 1e-5,
      LINEAR_TRIANGLE, 1.0}, TIME},
    {"shake: log, midpoint, n = 8, 16 steps",
     {SHAKE, LOG, 1, 8, 16, IMPLICIT_MIDPOINT, 1e-2,
      LINEAR_TRIANGLE, 1.0}, SPACE},
    {"swing: log, backward Euler, n = 16, 16 steps",
     {SWING, LOG, 1, 16, 16, BACKWARD_EULER, 1e-5,
      LINEAR_TRIANGLE, 1.0}, TIME},
    {"buckle: linear, static, n = 32",
     {BUCKLE, LINEAR, 0, 32, 1, BACKWARD_EULER, 1e-5,
      LINEAR_TRIANGLE, 1.0}, MODEL},
    {"buckle: log, midpoint, n = 16, 64 steps",
     {BUCKLE, LOG, 1, 16, 64, IMPLICIT_MIDPOINT, 1e-5,
      LINEAR_TRIANGLE, 1.0}, SPACE},
    {"push: log, backward Euler, n = 8, 8 steps",
     {PUSH, LOG, 1, 8, 8, BACKWARD_EULER, 1e-2,
      LINEAR_TRIANGLE, 1.0}, TIME},
};
enum { BARS = sizeof bars / sizeof *bars };

/* The same mesh without an error in time; *left: what is left of it. */
static struct work without_time(struct work_setting set, double *left)
{
    struct work run[2];
    *left = 0.0;
    if (!set.dynamic) return work_run(&set);
    set.method = IMPLICIT_MIDPOINT;
    for (int k = 0; k < 2; k++) {
        set.steps = 64 << k;
        run[k] = work_run(&set);
    }
    *left = work_distance(&run[0], &run[1]) / 3.0; /* if not extrapolated */
    work_correct(&run[1], 1.0 / 3.0, &run[1], &run[0]);
    return run[1];
}

/* A row; which part is the largest; *mostly counts those where it is more than
 * 80 % of the sum of the sizes. */
static int print_bar(const struct bar *bar, const struct work *truth,
                     double truth_floor, const struct work *limit,
                     double limit_floor, int *mostly)
{
    struct work_setting set = bar->set;
    const double size = work_distance(truth, NULL);
    double left, part[N_PART], others[N_PART];
    int largest = 0;
    const struct work whole = work_run(&set);
    set.tolerance = 1e-9;
    const struct work solved = work_run(&set);
    const struct work timeless = without_time(set, &left);
    part[MODEL] = work_distance(limit, truth);
    part[SPACE] = work_distance(&timeless, limit);
    part[TIME] = work_distance(&solved, &timeless);
    part[SOLVER] = work_distance(&whole, &solved);
    others[MODEL] = hypot(truth_floor, limit_floor);
    others[SPACE] = hypot(left, limit_floor);
    others[TIME] = left;
    others[SOLVER] = 1e-9;
    for (int k = 1; k < N_PART; k++)
        if (part[k] > part[largest]) largest = k;
    *mostly += part[largest] > 0.8 * (part[MODEL] + part[SPACE] + part[TIME] +
                                      part[SOLVER]);
    table_row(bar->name, cell_rounded(4, work_distance(&whole, truth) / size),
              cell_rounded(4, part[MODEL] / size), cell_rounded(4, part[SPACE] /
              size), cell_rounded(4, part[TIME] / size), cell_rounded(2,
              part[SOLVER] / size), part_name[largest], cell_rounded(4,
              others[largest] / part[largest]));
    claim(largest == (int)bar->due && others[largest] < 0.1 * part[largest],
          "%s: mostly %s, the others below a tenth of it (%s, %g)", bar->name,
          part_name[bar->due], part_name[largest],
          others[largest] / part[largest]);
    return largest;
}

int main(void)
{
    int dominant[N_PART] = {0};
    struct work truth = {.status = OK}, limit = truth;
    double truth_floor = 0.0, limit_floor = 0.0;
    int mostly = 0;
    table_begin("split", "setting error model space time solver largest "
                         "others");
    for (int k = 0; k < BARS; k++) {
        struct work_setting model = bars[k].set;
        const int richest = model.law == LOG && model.dynamic;
        model.element = work_limit_element(model.scene);
        if (!richest) limit = work_limit(&model, &limit_floor);
        model.law = LOG, model.dynamic = 1;
        if (k == 0 || bars[k - 1].set.scene != model.scene)
            truth = work_limit(&model, &truth_floor);
        if (richest) limit = truth, limit_floor = truth_floor;
        dominant[print_bar(&bars[k], &truth, truth_floor, &limit,
                           limit_floor, &mostly)]++;
    }
    table_end();
    for (int k = 0; k < N_PART; k++)
        claim(dominant[k] > 0, "%s is once the largest part", part_name[k]);
    claim(mostly == 9, "in nine of the ten one part is more than 80 %% of the "
          "sum (%d)", mostly);
    return table_finish();
}
