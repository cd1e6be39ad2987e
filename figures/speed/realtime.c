/*
 * realtime.c - up to which n is a step ready for the next picture?
 *
 * The stretch of step.c, on one thread.  Table realtime: its first ninety
 * steps, while it is stretched, with the jolt of the start; an n is in time
 * when the 99 % quantile of their times is at most 1/30 s, so that at most one
 * of the ninety is late; `single` is dissection in single precision, `kept` the
 * same with factors kept across steps [alg:kept].  Table swing: 190 steps, in
 * which it is pressed from t = pi on and let go again (dissection); in time
 * when all are.  There a step takes up to hundreds of systems, so that `capped`
 * stops at 8 and goes on from what the line search has reached
 * [alg:line-search], which has less Phi than the guess.  The largest n is found
 * by halving an interval.  What is late is run again, as others may run too.
 */
#include "exact.h"
#include "base/clock.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum solver { BAND, DISSECTION, SINGLE, KEPT, SOLVERS };
static const char *const name[] = {"band", "dissection", "single", "kept"};
static const int sizes[] = {16, 24, 32, 48, 64};
enum { SIZES = sizeof sizes / sizeof *sizes, RUNS = 2 };
enum { FRAMES = 90, SWING = 190, STEP = 2, LEAST = 16, MOST = 400, CAP = 8 };

/* The 99 % quantile of the seconds of a step; INFINITY as soon as two are late,
 * since it is late then. */
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
    if (k < SINGLE) exact_factors(s->body);
    scene_step(s, &control); /* memory is touched */
    scene_rest(s);
    for (int step = 0; step < FRAMES && late < 2; step++) {
        if (k != KEPT) s->body->kept.usable = 0;
        const double before = clock_seconds();
        if (scene_step(s, &control).status != OK) die("n = %d fails", n);
        times_record(&t, clock_seconds() - before, 1);
        late += t.second[step] > set.dt;
    }
    scene_free(s);
    return late < 2 ? times_quantile(&t, 0.99) : (double)INFINITY;
}

/* The next step, finished or not. */
static struct step_report advance(struct scene *s,
                                  const struct step_control *control)
{
    const double dt = s->set.dt;
    double *w = allocate((size_t)s->n_dof, sizeof *w);
    double *u = allocate((size_t)s->n_dof, sizeof *u);
    scene_hold(s, ++s->steps * dt);
    for (int r = 0; r < s->n_dof; r++) {
        w[r] = s->u[r] + dt * s->v[r];
        u[r] = w[r] + dt * (s->v[r] - s->v_before[r]);
    }
    step_boundary(s->body, s->g, 1, u);
    const struct step_report report = step_solve(
        s->body, control, (struct incremental){dt, w, NULL}, u);
    for (int r = 0; r < s->n_dof; r++) {
        const double v = (u[r] - s->u[r]) / dt;
        /* what was stopped says nothing of how v changes */
        s->v_before[r] = report.status == OK ? s->v[r] : v;
        s->v[r] = v;
        s->u[r] = u[r];
    }
    free(w);
    free(u);
    return report;
}

/* The worst frame of the swing in seconds; with the first late one it ends when
 * `hurry`. */
static double swing(int n, int most, int hurry)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct step_control control = step_method("all");
    set.reach = 0.5;
    control.chord = 1;
    control.max_iterations = most;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, SPARSE);
    advance(s, &control); /* memory is touched */
    scene_rest(s);
    double worst = 0.0;
    while (s->steps < SWING && !(hurry && worst > set.dt)) {
        const double before = clock_seconds();
        s->body->kept.usable = 0;
        const struct step_report report = advance(s, &control);
        if (report.status != OK && report.status != MAX_ITERATIONS)
            die("n = %d fails: %s", n, status_name(report.status));
        worst = fmax(worst, clock_seconds() - before);
    }
    scene_free(s);
    return worst;
}

/* Of some runs the one whose worst frame is the shortest. */
static void time_swing(const char *word, int n, int most)
{
    double worst = INFINITY;
    for (int run = 0; run < RUNS; run++)
        worst = fmin(worst, swing(n, most, 0));
    table_row(word, n, 1e3 * worst);
}

/* The largest n in time: of the swing, capped, or (k < SOLVERS) of k; *seconds
 * := its p99 or worst frame. */
static int largest(int k, double *seconds)
{
    int n = LEAST, late = MOST;
    while (late - n > STEP) {
        const int middle = (n + late) / (2 * STEP) * STEP;
        double t = INFINITY;
        for (int run = 0; run < RUNS && !(t <= 1.0 / 30.0); run++)
            t = k < SOLVERS ? slowest(k, middle) : swing(middle, CAP, 1);
        if (t > 1.0 / 30.0) {
            late = middle;
        } else {
            n = middle;
            *seconds = t;
        }
    }
    return n;
}

int main(void)
{
    study_machine();
    table_begin("realtime", "solver n p99_ms");
    for (int k = 0; k < SOLVERS; k++) {
        double p99 = NAN;
        const int n = largest(k, &p99);
        table_row(name[k], n, 1e3 * p99);
    }
    table_end();
    table_begin_note("swing", "systems n worst_ms", "capped: at most %d", CAP);
    for (int k = 0; k < SIZES; k++) time_swing("all", sizes[k], 300);
    for (int k = 0; k < SIZES; k++) time_swing("capped", sizes[k], CAP);
    double worst = NAN;
    const int most = largest(SOLVERS, &worst);
    table_row("capped_most", most, 1e3 * worst);
    table_end();
    return table_finish();
}
