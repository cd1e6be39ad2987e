/*
 * realtime.c - up to which n is a step ready for the next picture?
 *
 * The stretch of step.c: ninety steps of 1/30 s from rest, with the jolt of
 * the start.  An n is in time when 99 of 100 steps take at most 1/30 s.  The
 * largest is found by halving an interval, for the band and for dissection with
 * factors in double and in single precision, on one thread.
 */
#include "base/clock.h"
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum solver { BAND, DISSECTION, SINGLE, SOLVERS };
static const char *const name[] = {"band", "dissection", "single"};
enum { FRAMES = 90, STEP = 2, LEAST = 16, MOST = 400 };

/* Seconds that 99 of 100 steps do not exceed; INFINITY as soon as two of them
 * are late. */
static double slowest(int k, int n)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct step_control control = step_method("lift");
    struct times t = {0};
    int late = 0;
    set.reach = 0.5;
    control.chord = 1;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, k == BAND ? BANDED : SPARSE);
    if (k == SINGLE) matrix_keep_single(s->body->K, 1);
    scene_step(s, &control); /* memory is touched */
    scene_rest(s);
    for (int step = 0; step < FRAMES && late < 2; step++) {
        const double before = clock_seconds();
        if (scene_step(s, &control).status != OK) die("n = %d fails", n);
        times_record(&t, clock_seconds() - before, 1);
        late += t.second[step] > set.dt;
    }
    scene_free(s);
    return late < 2 ? times_quantile(&t, 0.99) : (double)INFINITY;
}

int main(void)
{
    int n[SOLVERS];
    double p99[SOLVERS];
    study_machine();
    for (int k = 0; k < SOLVERS; k++) {
        int late = MOST;
        n[k] = LEAST, p99[k] = slowest(k, LEAST);
        while (late - n[k] > STEP) {
            const int middle = (n[k] + late) / (2 * STEP) * STEP;
            const double t = slowest(k, middle);
            if (t <= 1.0 / 30.0) n[k] = middle, p99[k] = t;
            else late = middle;
        }
    }
    table_begin("realtime", "solver n p99_ms over_band");
    for (int k = 0; k < SOLVERS; k++)
        table_row(name[k], n[k], 1e3 * p99[k], (double)n[k] / n[BAND]);
    table_end();
    return table_finish();
}
