/*
 * front.c - for a wanted error, which setting is the cheapest?
 *
 * All settings of trials.h in six scenes: error against counted flops.  Table
 * front: those that no other of at most their cost is as good as (asked 0), and
 * the same among even linear triangles (-1).  Table cheapest: the first for a
 * few errors.  Table luck: what is good in the column because parts cancel.
 */
#include "trials.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

/* The front of the first `count` settings; how many of its corners have an
 * error below what is known of the truth. */
static int print_front(const struct trials *s, int count, double asked)
{
    double last = 0.0;
    int below = 0;
    for (int i = trials_cheapest(s, count, 10.0); i >= 0;
         i = trials_cheapest(s, count, s->error[i] * (1.0 - 1e-9))) {
        trials_row(s, i, asked);
        claim(s->work[i].flops > last, "%s: no two corners of the front cost "
              "the same (%g, %g)", work_scene_name(s->scene), last,
              s->work[i].flops);
        last = s->work[i].flops;
        below += s->error[i] < s->floor;
    }
    return below;
}

/* In the mean of all pairs: what the loose tolerance takes of the sharp one. */
static void compare_tolerances(struct trials *const s[])
{
    double systems = 0.0, flops = 0.0, change = 0.0;
    int pairs = 0;
    for (int k = 0; k < JOLTED_PULL; k++)
        for (int i = 1; i < s[k]->count; i++) {
            const struct work *loose = &s[k]->work[i - 1], *sharp = loose + 1;
            if (s[k]->set[i - 1].tolerance <= s[k]->set[i].tolerance) continue;
            pairs++;
            systems += (double)loose->systems / sharp->systems;
            flops += loose->flops / sharp->flops;
            change = fmax(change,
                          fabs(s[k]->error[i - 1] / s[k]->error[i] - 1.0));
        }
    claim(fabs(systems / pairs - 0.5) < 0.05 &&
              fabs(flops / pairs - 0.75) < 0.05 && change < 0.25,
          "a loose tolerance saves half of the systems, a quarter of the flops "
          "(%g, %g, %g)", systems / pairs, flops / pairs, change);
}

/* For a few errors; the only graded one, in the column, is good by luck. */
static void print_cheapest(struct trials *const s[])
{
    static const double wanted[] = {0.3, 0.1, 0.03, 0.01, 0.003, 0.001};
    int rows = 0, graded = 0, lucky = 0, unsure = 0;
    table_begin("cheapest", TRIALS_COLUMNS);
    for (int k = 0; k < JOLTED_PULL; k++)
        for (int i = 0; i < COUNT(wanted); i++) {
            const int best = trials_cheapest(s[k], s[k]->all, wanted[i]);
            if (best < 0 || wanted[i] <= s[k]->floor) continue;
            trials_row(s[k], best, wanted[i]);
            rows++;
            graded += s[k]->set[best].grade > 1.0;
            lucky += k == BUCKLE && s[k]->set[best].grade > 1.0;
            unsure += s[k]->error[best] + s[k]->floor > wanted[i];
        }
    table_end();
    claim(graded == 1 && lucky == 1 && unsure == 5, "of the cheapest only one "
          "in the column is graded, five are not sure (%d, %d, %d of %d)",
          graded, lucky, unsure, rows);
}

/* The linear law in the slow pull: the finer the mesh, the less of the part of
 * the model is cancelled by that of space. */
static void compare_meshes(const struct trials *s)
{
    double error[3] = {0.0};
    int found = 0;
    for (int i = 0; i < s->count && found < 3; i++)
        if (s->set[i].law == LINEAR && !s->set[i].dynamic)
            error[found++] = s->error[i];
    claim(error[0] > 0.0 && error[1] > 1.08 * error[0] &&
              error[2] > 1.15 * error[1], "in the slow pull the linear law is "
          "worse on finer meshes (%g, %g, %g)", error[0], error[1], error[2]);
}

/* Quadratic triangles and the midpoint rule in the column: what is so good with
 * eight steps is worse with twice as many. */
static void print_luck(const struct trials *s)
{
    table_begin("luck", "n eight sixteen");
    for (int i = 0; i < 3; i++) {
        double error[2];
        for (int k = 0; k < 2; k++) {
            const struct work_setting set = {
                BUCKLE, LOG, 1, 16 << i, 8 << k, IMPLICIT_MIDPOINT, 1e-5,
                QUADRATIC_TRIANGLE, 1.0};
            const struct work run = work_run(&set);
            error[k] = work_distance(&run, &s->limit) / s->size;
        }
        table_row(16 << i, cell_rounded(4, error[0]),
                  cell_rounded(4, error[1]));
        claim(error[1] > 4.0 * error[0] && error[1] < 23.0 * error[0],
              "n = %d: good by luck, with twice the steps worse (%g, %g)",
              16 << i, error[0], error[1]);
    }
    table_end();
}

int main(void)
{
    struct trials *s[JOLTED_PULL];
    int failed = 0, explicit = 0, squeezed = 0, below = 0, pushed = 0;

    for (int k = 0; k < JOLTED_PULL; k++)
        s[k] = trials_alloc((enum work_scene)k, 1);
    table_begin("settings", TRIALS_COLUMNS);
    for (int k = 0; k < JOLTED_PULL; k++)
        for (int i = 0; i < s[k]->all; i++) {
            trials_row(s[k], i, 0.0);
            if (s[k]->work[i].status == OK) continue;
            if (s[k]->set[i].method == SYMPLECTIC_EULER) {
                explicit++;
                continue;
            }
            failed++;
            squeezed += k == PUSH && i >= s[k]->count;
        }
    table_end();
    table_begin("front", TRIALS_COLUMNS);
    for (int k = 0; k < JOLTED_PULL; k++) {
        const int few = print_front(s[k], s[k]->all, 0.0);
        below += few + print_front(s[k], s[k]->count, -1.0);
        if (k == PUSH) pushed = few;
    }
    table_end();
    table_begin("failed", "runs explicit");
    table_row(failed + explicit, explicit);
    table_end();
    print_cheapest(s);
    print_luck(s[BUCKLE]);
    compare_tolerances(s);
    compare_meshes(s[SLOW_PULL]);
    for (int k = 0; k < JOLTED_PULL; k++) trials_free(s[k]);
    claim(below == 2 && pushed == 2, "only the last two corners of the push "
          "are below what is known of the truth (%d, %d)", below, pushed);
    claim(failed == squeezed, "only symplectic Euler fails, and other "
          "elements whose corner is squeezed (%d, %d)", failed, squeezed);
    return table_finish();
}
