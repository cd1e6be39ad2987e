/*
 * chart.c - what does a method cost for a given error?
 *
 * The square, n = 8 or 16, both ends held, lumped mass, is let go from a large
 * smooth swing and followed for three frames (0.1 s) of 1, 2, 4, ... steps.
 * The reference is the midpoint rule with 512 and 1024 steps per frame and
 * Richardson's extrapolation (4 u_4 - u_2) / 3, whose error is O(dt^4); its
 * distance from the extrapolation one level below bounds that error.
 */
#include "frequency.h"
#include "swing.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { LEVELS = 9, FINEST = 1 << (LEVELS - 1) };

struct result {
    double bound, critical; /* of the reference's error; step (s) */
    double ratio, last;     /* of the midpoint rule's errors; BDF2's last */
    int arrived;            /* methods, one step per frame, plain Newton */
    int enough[N_METHOD];   /* steps per frame, the fewest below 1 %, or 0 */
};

static struct result chart(int n, const char *table)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    set.mass = LUMPED;
    struct scene *scene = scene_alloc(&set);
    struct model *model = model_body(scene->body);
    double *reference = scene->u, *below = scene->v, error[LEVELS];
    struct result result = {0};
    struct swing_run run;

    swing_limit(model, scene->g, 2 * FINEST, reference);
    swing_limit(model, scene->g, FINEST, below);
    result.bound = swing_distance(model, below, reference);
    result.critical = 2.0 / frequency_largest(model);
    table_begin(table, "method per_frame dt status steps error energy "
                       "iterations factorisations seconds");
    for (int m = 0; m < N_METHOD; m++)
        for (int k = 0; k < LEVELS; k++) {
            struct times times = {0};
            for (int j = 0; j < 4 && !(times_best(&times) >= 3e-2); j++) {
                if (j > 0) state_free(&run.end);
                run = swing_run(model, scene->g, (enum method)m, 1 << k);
                times_record(&times, run.seconds, 1);
            }
            const int ok = run.total.status == OK;
            error[k] = swing_distance(model, run.end.u, reference);
            table_row(method_name((enum method)m), 1 << k, set.dt / (1 << k),
                      status_name(run.total.status), run.steps,
                      cell_if(ok, error[k]), cell_if(ok, run.energy),
                      cell_if(ok, run.total.iterations / 3.0),
                      cell_if(ok, run.total.factorisations / 3.0),
                      times_best(&times) / 3.0);
            result.arrived += k == 0 && ok;
            claim(n == 8 || m != SYMPLECTIC_EULER || k != 4 ||
                      (!ok && set.dt / 16.0 < result.critical),
                  "a step fails that is below the limit at rest");
            if (!result.enough[m] && ok && error[k] < 0.01)
                result.enough[m] = 1 << k;
            if (m == IMPLICIT_MIDPOINT)
                result.ratio = error[k ? k - 1 : 0] / error[k];
            state_free(&run.end);
        }
    table_end();
    result.last = error[LEVELS - 1];
    const int due = n == 8 ? 30 : 45;
    for (int k = 0; k < 2; k++) {
        run = swing_run(model, scene->g, IMPLICIT_MIDPOINT, due - k);
        claim((swing_distance(model, run.end.u, reference) < 0.01) == (k == 0),
              "the midpoint rule needs %d steps for 1 %%", due);
        state_free(&run.end);
    }
    model_free(model);
    scene_free(scene);
    return result;
}

int main(void)
{
    study_machine();
    const struct result coarse = chart(8, "chart");
    const struct result fine = chart(16, "chart_16");
    const struct result *const both[] = {&coarse, &fine};

    for (int i = 0; i < 2; i++) {
        const struct result *r = both[i];
        claim(fabs(r->ratio - 4.0) < 0.05 && r->bound < 1e-3 * r->last,
              "half a step of the midpoint rule is a quarter of its error, "
              "and the reference is good enough to see it (%g, %g)", r->ratio,
              r->bound);
        claim(r->arrived == 1,
              "with one step per frame plain Newton solves one method (%d)",
              r->arrived);
        claim(r->enough[SYMPLECTIC_EULER] == 64,
              "1 %% takes symplectic Euler 64 steps per frame on either mesh");
    }
    claim(coarse.enough[IMPLICIT_MIDPOINT] == 32 &&
              fine.enough[IMPLICIT_MIDPOINT] == 64,
          "1 %% takes the midpoint rule 32 steps per frame, or 64 (n = 16)");
    return table_finish();
}
