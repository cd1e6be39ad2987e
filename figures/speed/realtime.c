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
#include "base/clock.h"
#include "plane/scene.h"
#include "base/study.h"
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
    s->body->exact = k < SINGLE;
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

struct swing {
    struct times t;
    int systems, unfinished; /* of the worst step; steps that were stopped */
    double residual;         /* of those, at most (m) */
};

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

/* The whole swing; it ends with the first late step when `hurry`. */
static struct swing swing(int n, int most, int single, int hurry)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    struct step_control control = step_method("all");
    struct swing swing = {.t = {0}};
    set.reach = 0.5;
    control.chord = 1;
    control.max_iterations = most;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, SPARSE);
    s->body->exact = !single;
    advance(s, &control); /* memory is touched */
    scene_rest(s);
    double worst = 0.0;
    while (s->steps < SWING && !(hurry && worst > set.dt)) {
        const double before = clock_seconds();
        s->body->kept.usable = 0;
        const struct step_report report = advance(s, &control);
        const double seconds = clock_seconds() - before;
        if (report.status != OK && report.status != MAX_ITERATIONS)
            die("n = %d fails: %s", n, status_name(report.status));
        times_record(&swing.t, seconds, 1);
        if (seconds > worst) swing.systems = report.iterations;
        worst = fmax(worst, seconds);
        if (report.status == OK) continue;
        swing.unfinished++;
        swing.residual = fmax(swing.residual, report.residual);
    }
    scene_free(s);
    return swing;
}

/* The worst frame in seconds. */
static double worst_frame(const struct swing *s)
{
    return times_quantile(&s->t, 1.0);
}

static void print_swing(const char *word, int n, const struct swing *s)
{
    table_row(word, n, 1e3 * times_quantile(&s->t, 0.99),
              1e3 * worst_frame(s), s->systems, s->unfinished,
              cell_if(s->unfinished > 0, s->residual));
}

/* Of some runs the one whose worst frame is the shortest. */
static void time_swing(const char *word, int n, int most)
{
    struct swing s = swing(n, most, 0, 0);
    for (int run = 1; run < RUNS; run++) {
        const struct swing again = swing(n, most, 0, 0);
        if (worst_frame(&again) < worst_frame(&s)) s = again;
    }
    print_swing(word, n, &s);
}

/* The largest n in time: of the swing, capped, or (k < SOLVERS) of k; *seconds
 * := its p99, and *timed := its swing, when that was found. */
static int largest(int k, int single, double *seconds, struct swing *timed)
{
    struct swing s = {.t = {0}};
    int n = LEAST, late = MOST;
    while (late - n > STEP) {
        const int middle = (n + late) / (2 * STEP) * STEP;
        double t = INFINITY;
        for (int run = 0; run < RUNS && !(t <= 1.0 / 30.0); run++) {
            if (k < SOLVERS) {
                t = slowest(k, middle);
            } else {
                s = swing(middle, CAP, single, 1);
                t = worst_frame(&s);
            }
        }
        if (t > 1.0 / 30.0) {
            late = middle;
            continue;
        }
        n = middle;
        *seconds = t;
        *timed = s;
    }
    return n;
}

int main(void)
{
    int n[SOLVERS];
    double p99[SOLVERS] = {NAN, NAN, NAN, NAN}, unused;
    struct swing timed = {.t = {0}};
    study_machine();
    for (int k = 0; k < SOLVERS; k++) n[k] = largest(k, 0, &p99[k], &timed);
    table_begin("realtime", "solver n p99_ms over_band");
    for (int k = 0; k < SOLVERS; k++)
        table_row(name[k], n[k], 1e3 * p99[k], (double)n[k] / n[BAND]);
    table_end();
    table_begin_note("swing", "systems n p99_ms worst_ms worst_systems "
                     "unfinished residual", "capped: at most %d", CAP);
    for (int k = 0; k < SIZES; k++) time_swing("all", sizes[k], 300);
    for (int k = 0; k < SIZES; k++) time_swing("capped", sizes[k], CAP);
    print_swing("capped_most", largest(SOLVERS, 0, &unused, &timed), &timed);
    print_swing("single_most", largest(SOLVERS, 1, &unused, &timed), &timed);
    table_end();
    return table_finish();
}
