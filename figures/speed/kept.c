/*
 * kept.c - how many times faster is a step whose factors serve later steps?
 *
 * Four scenes of scene.h, cubic law, n = 128, forty steps of 1/30 s by
 * dissection: factors kept within a step and across steps [alg:kept] in double
 * precision, and across in single.  They take turns, of ten steps in a row, and
 * begin five times: a step is the same each time, so that its seconds are the
 * least of five, and the worst step is no other program's.  An answer that is
 * off has no time.
 */
#include "exact.h"
#include "plane/scene.h"

#include "base/clock.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <string.h>

enum { CELLS = 128, STEPS = 40, IN_A_ROW = 10, SCENES_HERE = 4, WAYS = 3 };
enum { RUNS = 5 };
static const enum reading reading[SCENES_HERE] = {STRETCH, RIGID, TRACTION,
                                                  SPIN};
static const struct {
    const char *name;
    int across, single;
} way[WAYS] = {{"within", 0, 0}, {"across", 1, 0}, {"across_single", 1, 1}};

/* Ten steps of a scene; of each step the least seconds so far. */
static void steps_in_a_row(struct scene *s, int k, struct times *t)
{
    struct step_control control = step_method("lift");
    control.chord = 1;
    for (int step = 0; step < IN_A_ROW; step++) {
        double *least = &t->second[s->steps];
        const double before = clock_seconds();
        if (!way[k].across) s->body->kept.usable = 0;
        const enum status status = scene_step(s, &control).status;
        const double seconds = clock_seconds() - before;
        if (s->steps > t->runs)
            times_record(t, seconds, status == OK);
        else if (seconds < *least)
            *least = seconds;
    }
}

static void measure(enum reading scene, struct times t[WAYS])
{
    struct scene_setting set = scene_notes(scene, CUBIC, CELLS);
    struct scene *s[WAYS], *begin = scene_alloc(&set);
    const size_t bytes = (size_t)begin->n_dof * sizeof *begin->v;
    if (scene == STRETCH) set.reach = 0.5;
    for (int k = 0; k < WAYS; k++) {
        struct step_control control = step_method("lift");
        s[k] = scene_alloc(&set);
        if (!way[k].single) exact_factors(s[k]->body);
        scene_step(s[k], &control); /* memory is touched */
    }
    for (int run = 0; run < RUNS; run++) {
        for (int k = 0; k < WAYS; k++) {
            scene_rest(s[k]);
            memcpy(s[k]->v, begin->v, bytes); /* what spins */
        }
        for (int turn = 0; turn < STEPS / IN_A_ROW; turn++)
            for (int k = 0; k < WAYS; k++) steps_in_a_row(s[k], k, &t[k]);
    }
    for (int k = 0; k < WAYS; k++)
        for (int r = 0; r < s[0]->n_dof; r++)
            if (!(fabs(s[k]->u[r] - s[0]->u[r]) <= 1e-8))
                t[k].second[0] = NAN;
    for (int k = 0; k < WAYS; k++) scene_free(s[k]);
    scene_free(begin);
}

int main(void)
{
    study_machine();
    table_begin_note("kept", "scene factors median_ms p99_ms worst_ms faster "
                     "worst_faster", "n = %d; faster: than `within`", CELLS);
    for (int scene = 0; scene < SCENES_HERE; scene++) {
        struct times t[WAYS] = {{0}};
        measure(reading[scene], t);
        for (int k = 0; k < WAYS; k++) {
            const struct times *today = &t[0];
            table_row(scene_name(reading[scene]), way[k].name,
                      1e3 * times_median(&t[k]),
                      1e3 * times_quantile(&t[k], 0.99),
                      1e3 * times_quantile(&t[k], 1.0),
                      times_median(today) / times_median(&t[k]),
                      times_quantile(today, 1.0) / times_quantile(&t[k], 1.0));
        }
    }
    table_end();
    return table_finish();
}
