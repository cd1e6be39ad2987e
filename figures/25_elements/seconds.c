/*
 * seconds.c - how many times faster than linear triangles does another element
 * solve one system here, for the same error?
 *
 * Weight and column of trial.h, on the meshes of gains.c: besides the flops of
 * a system the milliseconds, the best of 41 runs, in which it is assembled at
 * rest, factored by dissection and solved.  What both are at a wanted error is
 * interpolated as in gains.c.
 *
 * Tables: all meshes; and for each wanted error flops and milliseconds, and how
 * many times less of them than even linear triangles need.
 */
#include "trial.h"

#include "base/clock.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum { RUNS = 41, TARGETS = 2 };
static const double target[TARGETS] = {0.01, 0.003};

/* The best time of one system (ms). */
static double milliseconds(enum trial_scene scene, enum element element, int n,
                           double m)
{
    struct scene *s = trial_alloc(scene, element, n, m);
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    struct times times = {0};
    for (int r = 0; r < RUNS; r++) {
        const double start = clock_seconds();
        enum status status =
            body_assemble(s->body, at_rest(s->f), s->u, EXACT, q);
        if (status == OK) status = body_increment(s->body, s->body->K, q, s->v);
        times_record(&times, clock_seconds() - start, status == OK);
    }
    free(q);
    scene_free(s);
    return 1e3 * times_best(&times);
}

struct cost {
    double flops[TARGETS], ms[TARGETS];
};

/* Rows of all meshes of an element; what it costs at the targets. */
static struct cost run(enum trial_scene scene, const struct work *limit,
                       const struct trial_kind *kind)
{
    const int count = trial_meshes(scene, kind->element);
    double error[TRIAL_MESHES], flops[TRIAL_MESHES], ms[TRIAL_MESHES];
    struct cost cost;
    for (int j = 0; j < count; j++) {
        const int n = trial_coarsest(scene) << j;
        const struct trial trial = trial_of(scene, kind->element, n, kind->m);
        error[j] = trial_apart(&trial.end, limit);
        flops[j] = trial.end.flops;
        ms[j] = milliseconds(scene, kind->element, n, kind->m);
        table_row(trial_name(scene), kind->name, kind->m, n, error[j], flops[j],
                  ms[j]);
    }
    for (int t = 0; t < TARGETS; t++) {
        cost.flops[t] = trial_at(target[t], count, error, flops);
        cost.ms[t] = trial_at(target[t], count, error, ms);
    }
    return cost;
}

int main(void)
{
    static const enum trial_scene scenes[] = {TRIAL_WEIGHT, TRIAL_COLUMN};
    struct cost cost[2][TRIAL_KINDS];

    study_machine();
    table_begin("meshes", "scene element m n error flops ms");
    for (int s = 0; s < 2; s++) {
        double floor;
        const struct work limit = trial_limit(scenes[s], &floor);
        for (int k = 0; k < TRIAL_KINDS; k++)
            cost[s][k] = run(scenes[s], &limit, &trial_kinds[k]);
    }
    table_end();
    table_begin("elements", "scene error element m flops ms fewer faster");
    for (int s = 0; s < 2; s++)
        for (int t = 0; t < TARGETS; t++)
            for (int k = 0; k < TRIAL_KINDS; k++) {
                const struct cost *even = &cost[s][TRIAL_EVEN];
                const struct cost *of = &cost[s][k];
                table_row(trial_name(scenes[s]), target[t], trial_kinds[k].name,
                          trial_kinds[k].m, of->flops[t], of->ms[t],
                          even->flops[t] / of->flops[t],
                          even->ms[t] / of->ms[t]);
            }
    table_end();
    return table_finish();
}
