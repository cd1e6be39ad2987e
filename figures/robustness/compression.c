/*
 * compression.c - how far can the body be squeezed, and by which method?
 *
 * The ends are pushed together by sin t each (compress), 60 steps; they meet at
 * t = pi / 2.  A run ends with the first step that fails; by the log law also
 * when a triangle is flat, J < 0.001: then round-off decides.  "halved" is all
 * cures, and a step that fails is tried again in halves, these in quarters, to
 * dt / 16.  Tables: what the runs reached, with and without the steps that end
 * at a saddle, and the steps of four with n = 8.
 */
#include "reason.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <string.h>

enum { NOTES, LIFT, SEARCH, EVERY, DEMAND, ALL, HALVED, METHODS, FRAMES = 60 };
static const char *const method[] = {"notes", "lift", "lift+search",
    "always+search", "demand+search", "all", "halved"};
enum { SIZES = 3 };
static const int size[SIZES] = {4, 8, 16};

struct run {
    const char *reason;
    double t, pressed;             /* reached (s); the largest sin t */
    double least_J, min_J[FRAMES]; /* of all states; after each step */
    int frames, steps;             /* succeeded; the parts of halved ones */
    int iterations;                /* of those */
    int saddles, silent;           /* ending at one; those not reported */
    double certified;              /* the largest sin t that is no saddle */
    int cost[FRAMES];              /* iterations of a step and its parts */
};

/* A step of dt, or with halve > 0 its halves; the status of the last one. */
static enum status advance(struct scene *s, const struct step_control *control,
                           int halve, double dt, struct run *run)
{
    scene_hold(s, run->t + dt);
    const struct step_report report =
        step_backward_euler(s->body, control, dt, s->g, s->f, s->u, s->v,
                            s->v_before);
    run->cost[run->frames] += report.iterations;
    if (report.status != OK && halve > 0) {
        const enum status half = advance(s, control, halve - 1, dt / 2, run);
        return half == OK ? advance(s, control, halve - 1, dt / 2, run) : half;
    }
    if (report.status != OK) return report.status;
    run->t += dt;
    run->steps++;
    run->iterations += report.iterations;
    run->pressed = fmax(run->pressed, sin(run->t));
    const struct incremental Phi = {dt, s->u, NULL}; /* any w has its K */
    const int saddle = step_certify(s->body, Phi, s->u) != OK;
    run->saddles += saddle;
    run->silent += saddle && report.indefinite + report.projections == 0;
    if (!saddle) run->certified = fmax(run->certified, sin(run->t));
    run->least_J = fmin(run->least_J, body_min_J(s->body, s->u));
    return OK;
}

static struct run press(enum law law, int n, int m)
{
    const struct scene_setting set = scene_notes(COMPRESS, law, n);
    const int halve = strcmp(method[m], "halved") == 0 ? 4 : 0;
    const struct step_control control = step_method(halve ? "all" : method[m]);
    struct scene *s = scene_alloc(&set);
    struct run run = {.reason = "OK", .least_J = 1.0};

    body_store(s->body, PLAIN); /* a body that buckles is chaotic */
    for (; run.frames < FRAMES; run.frames++) {
        const int flat = law == LOG && run.least_J < 1e-3;
        const enum status status =
            flat ? OK : advance(s, &control, halve, set.dt, &run);
        run.reason = flat ? "flat" : reason_of(&control, status);
        run.min_J[run.frames] = body_min_J(s->body, s->u);
        if (strcmp(run.reason, "OK") != 0) break;
    }
    scene_free(s);
    return run;
}

/* The steps of a run; of the one that failed only how. */
static void print_path(const char *name, int m, const struct run *run)
{
    table_begin_note(name, "t pressed iterations min_J reason", "n = 8, %s",
                     method[m]);
    for (int k = 0; k < FRAMES && k <= run->frames; k++) {
        const double t = (k + 1) / 30.0;
        const int ok = k < run->frames;
        table_row(t, sin(t), cell_if(ok, run->cost[k]), run->min_J[k],
                  ok ? "OK" : run->reason);
    }
    table_end();
}

static void print_runs(const char *name, enum law law,
                       struct run run[SIZES][METHODS])
{
    table_begin_note(name, "n method pressed reason steps iterations least_J "
                     "per_step saddles certified", "of steps that are OK");
    for (int i = 0; i < SIZES; i++)
        for (int m = 0; m < METHODS; m++) {
            struct run *r = &run[i][m];
            if (m == HALVED && run[i][ALL].frames == FRAMES)
                *r = run[i][ALL]; /* no step failed: nothing to halve */
            else
                *r = press(law, size[i], m);
            table_row(size[i], method[m], r->pressed, r->reason, r->steps,
                      r->iterations, r->least_J,
                      (double)r->iterations / r->steps, r->saddles,
                      r->certified);
        }
    table_end();
}

int main(void)
{
    static struct run of_cubic[SIZES][METHODS], of_log[SIZES][METHODS];
    const struct run *cubic = of_cubic[1], *logarithm = of_log[1]; /* n = 8 */

    print_runs("press_cubic", CUBIC, of_cubic);
    print_runs("press_log", LOG, of_log);
    print_path("path_notes", NOTES, &cubic[NOTES]);
    print_path("path_always", EVERY, &cubic[EVERY]);
    print_path("path_demand", DEMAND, &cubic[DEMAND]);
    print_path("path_log_halved", HALVED, &logarithm[HALVED]);

    for (int i = 0; i < SIZES; i++)
        for (int m = 0; m < METHODS; m++) {
            const struct run *run = &of_cubic[i][m], *by_log = &of_log[i][m];
            claim((run->frames == FRAMES) == (m >= EVERY) &&
                      by_log->frames < FRAMES,
                  "with the cubic law what projects reaches the end, with the "
                  "log law nothing does (n = %d, %s)", size[i], method[m]);
            claim(m >= EVERY || run->certified == of_cubic[i][SEARCH].pressed,
                  "without saddles what does not project gets equally far");
            claim(run->silent == 0 && by_log->saddles == 0,
                  "the report of each saddle counts indefinite or projected "
                  "systems (n = %d, %s)", size[i], method[m]);
        }
    claim(of_cubic[0][NOTES].pressed < 0.9 && cubic[NOTES].pressed < 0.7 &&
              of_cubic[2][NOTES].pressed < 0.6,
          "a finer mesh buckles earlier");
    claim(cubic[EVERY].iterations > 9 * cubic[DEMAND].iterations &&
              fabs(cubic[EVERY].least_J - cubic[DEMAND].least_J) < 1e-8,
          "projecting always finds the same states nine times as slowly");
    claim(logarithm[HALVED].pressed > 0.999 &&
              of_log[2][HALVED].pressed < 0.95,
          "halved steps end just before the ends meet, at n = 16 earlier");
    return table_finish();
}
