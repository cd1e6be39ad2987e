/*
 * fronts.c - for a wanted error, which setting is the fastest here?
 *
 * The settings of trials.h in six scenes once more, error against milliseconds
 * to the answer, the best of four runs.  A run that is not OK has no time.
 */
#include "../study/study.h"
#include "trials.h"
#include "base/table.h"

#include <math.h>

enum { RUNS = 4 };

static void print_run(const struct trials *s, int k, double seconds)
{
    const struct work_setting *set = &s->set[k];
    const int ok = s->work[k].status == OK;
    table_row(work_scene_name(s->scene), material_law(set->law),
              set->dynamic ? method_name(set->method) : "static", set->n,
              set->steps, set->tolerance, cell_if(ok, s->error[k]),
              cell_if(ok, 1e3 * seconds), s->work[k].flops,
              status_name(s->work[k].status));
}

/* The fastest with an error below `error`, or -1. */
static int fastest(const struct trials *s, const double ms[], double error)
{
    int best = -1;
    for (int k = 0; k < s->count; k++)
        if (s->error[k] < error && (best < 0 || ms[k] < ms[best])) best = k;
    return best;
}

int main(void)
{
    static double seconds[JOLTED_PULL][TRIALS_MOST], ms[TRIALS_MOST];
    struct trials *s[JOLTED_PULL];
    for (int scene = 0; scene < JOLTED_PULL; scene++) {
        s[scene] = trials_alloc((enum work_scene)scene, 0);
        for (int k = 0; k < s[scene]->count; k++) {
            seconds[scene][k] = s[scene]->work[k].seconds;
            for (int turn = 1; turn < RUNS; turn++)
                seconds[scene][k] = fmin(seconds[scene][k],
                                         work_run(&s[scene]->set[k]).seconds);
        }
    }
    study_machine();
    table_begin("settings", "scene law method n steps tolerance error ms flops "
                            "reason");
    for (int scene = 0; scene < JOLTED_PULL; scene++)
        for (int k = 0; k < s[scene]->count; k++)
            print_run(s[scene], k, seconds[scene][k]);
    table_end();
    table_begin("scenes", "scene floor");
    for (int scene = 0; scene < JOLTED_PULL; scene++)
        table_row(work_scene_name((enum work_scene)scene), s[scene]->floor);
    table_end();
    table_begin("front", "scene law method n steps tolerance error ms flops "
                         "reason");
    for (int scene = 0; scene < JOLTED_PULL; scene++) {
        for (int k = 0; k < s[scene]->count; k++)
            ms[k] = 1e3 * seconds[scene][k];
        for (int k = fastest(s[scene], ms, 10.0); k >= 0;
             k = fastest(s[scene], ms, s[scene]->error[k]))
            print_run(s[scene], k, seconds[scene][k]);
    }
    table_end();
    for (int scene = 0; scene < JOLTED_PULL; scene++) trials_free(s[scene]);
    return table_finish();
}
