/*
 * budget.c - a budget of systems against the fallback of lesson 14.
 *
 * The script `hard`, n = 16, a patch in the hand, backward Euler, the same
 * bounded hand, for both rungs, live_frame_in_parts(), the second rung alone.
 * Tables: systems (per frame; frames unfinished, lost, and in which the hand
 * waits; how far (m) unfinished ones are from their end without it), sizes.
 */
#include "in_parts.h"
#include "motion/live.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct count {
    double p50, p99, most, off_median, off_most; /* off: the unfinished (m) */
    int unfinished, lost, waits; /* the hand */
};

/* How far the state is from what its frame, which began where a body without
 * forces would be at w, converges to; NAN if it does not. */
static double distance(struct live *live, const double w[])
{
    const struct incremental Phi = {live->dt, w, NULL};
    struct step_control whole = LIVE_DOWNHILL;
    double *u = allocate((size_t)live->n_dof, sizeof *u), largest = 0.0;
    memcpy(u, live->now.u, (size_t)live->n_dof * sizeof *u);
    whole.max_iterations = 500;
    const enum status status = step_solve(live->body, &whole, Phi, u).status;
    for (int r = 0; r < live->n_dof; r++)
        largest = fmax(largest, fabs(u[r] - live->now.u[r]));
    free(u);
    return status == OK ? largest : NAN;
}

/* Of the second rung, as if FRAME_SYSTEMS - budget of its systems were gone. */
static int budget = FRAME_SYSTEMS;

static enum status budgeted(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    report->systems += FRAME_SYSTEMS - budget;
    const enum status status = live_downhill(live, u, v, report);
    report->systems -= FRAME_SYSTEMS - budget;
    return status;
}

enum way { BOTH_RUNGS, IN_PARTS, SECOND_ALONE };
static struct count play(enum law law, enum way way)
{
    const struct live_setting set = {16, law, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    struct pointers hard = pointers_hard();
    struct count count = {0};
    struct times systems = {0}, off = {0};
    double *w = allocate((size_t)live->n_dof, sizeof *w);
    for (int k = 0; k < hard.n; k++) {
        double to[2];
        live_input(live, &hard.frame[k]);
        live_hand(live->hand, &hard.frame[k], to);
        live_carry(live, to);
        for (int r = 0; r < live->n_dof; r++)
            w[r] = live->now.u[r] + live->dt * live->now.v[r];
        live->trouble |= way == SECOND_ALONE;
        const struct live_report report =
            way == IN_PARTS ? live_frame_in_parts(live, to)
                            : live_frame_by(live, live_lift, budgeted, to);
        times_record(&systems, report.systems, 1);
        const int lost = strcmp(report.rung, "lost") == 0;
        count.lost += lost;
        count.waits += live->holding && report.part == 0.0;
        if (lost || report.status == OK) continue;
        count.unfinished++;
        times_record(&off, distance(live, w), 1);
    }
    count.p50 = times_median(&systems);
    count.p99 = times_quantile(&systems, 0.99);
    count.most = times_quantile(&systems, 1.0);
    count.off_median = times_median(&off);
    count.off_most = times_quantile(&off, 1.0);
    free(w);
    pointers_free(&hard);
    live_free(live);
    return count;
}

/* How far unfinished frames are off. */
static struct cell off(const struct count *count, double distance)
{
    return count->unfinished ? cell_rounded(2, distance) : cell_word(MISSING);
}

static void print_systems(struct count count[2][3])
{
    static const char *const word[] = {"budget", "lesson 14", "second rung"};
    table_begin("systems", "law fallback p50 p99 most unfinished lost "
                "waits off_median off_most");
    for (int l = 0; l < 2; l++)
        for (enum way way = BOTH_RUNGS; way <= SECOND_ALONE; way++) {
            struct count *c = &count[l][way];
            *c = play(l ? CUBIC : LOG, way);
            table_row(material_law(l ? CUBIC : LOG), word[way], c->p50, c->p99,
                      c->most, c->unfinished, c->lost, c->waits,
                      off(c, c->off_median), off(c, c->off_most));
        }
    table_end();
}

static void print_sizes(void)
{
    struct count c[2] = {{.unfinished = 301}, {.unfinished = 301}};
    table_begin("sizes", "budget log_late log_off log_most cubic_late "
                         "cubic_off cubic_most");
    for (budget = 2; budget <= 32; budget *= 2) {
        for (int l = 0; l < 2; l++) {
            const struct count a = play(l ? CUBIC : LOG, SECOND_ALONE);
            claim(a.lost == 0 && a.most <= budget &&
                      a.unfinished < c[l].unfinished &&
                      (budget == 32) == (a.unfinished == 0),
                  "%d systems at most (%g): none lost (%d), fewer unfinished "
                  "than with less (%d, %d), with 32 none", budget, a.most,
                  a.lost, a.unfinished, c[l].unfinished);
            c[l] = a;
        }
        table_row(budget, c[0].unfinished, off(&c[0], c[0].off_most),
                  c[0].most, c[1].unfinished, off(&c[1], c[1].off_most),
                  c[1].most);
    }
    table_end();
}

int main(void)
{
    struct count count[2][3];
    gsl_set_error_handler_off();
    print_systems(count);
    print_sizes();
    for (int l = 0; l < 2; l++) {
        const struct count *two = &count[l][0], *parts = &count[l][1];
        claim(two->lost == 0 && two->most <= 8.0 &&
                  parts->p99 >= 2 * two->p99 && parts->most >= 4 * two->most,
              "no frame is lost (%d), at most 8 systems (%g); sub-steps cost "
              "twice as much at p99, four times in the worst frame (%g, %g)",
              two->lost, two->most, parts->p99, parts->most);
    }
    const struct count *log = count[0], *cubic = count[1];
    claim(log[2].unfinished < log->unfinished && log[2].off_median < 2e-5 &&
              log->off_median > 9e-3 && cubic[2].unfinished > cubic->unfinished,
          "LOG: the second rung alone leaves fewer and nearer ones; here more");
    claim(log->off_most < 2.0 / 16 && cubic->off_most > 0.3,
          "off by less than h under LOG, by half a metre under CUBIC");
    claim(log[1].lost == 41 && log->waits == 37 && cubic->waits == 0,
          "LOG: sub-steps lose 41 frames; in 37 the hand of the budget waits");
    return table_finish();
}
