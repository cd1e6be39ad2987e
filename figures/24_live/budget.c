/*
 * budget.c - a budget of systems against the fallback of lesson 14.
 *
 * The script `hard`, n = 16, a patch in the hand, backward Euler, the same
 * bounded hand.  One body takes live_frame(), the other live_frame_in_parts(),
 * with more and more sub-steps.  Table: systems per frame at the median, at the
 * 99th percentile and at most; frames unfinished, and lost; how far an
 * unfinished frame is (largest distance of a vertex, m) from where it ends
 * without a budget.
 */
#include "motion/live.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct count {
    double p50, p99, most;
    int unfinished, lost;
    double off_median, off_most; /* of unfinished frames (m) */
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

static struct count play(enum law law, int substeps)
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
        const struct live_report report =
            substeps ? live_frame_in_parts(live, to) : live_frame(live, to);
        times_record(&systems, report.systems, 1);
        const int lost = strcmp(report.rung, "lost") == 0;
        count.lost += lost;
        if (lost || report.status == OK) continue;
        count.unfinished++;
        times_record(&off, distance(live, w), 1);
    }
    count.p50 = times_median(&systems);
    count.p99 = times_quantile(&systems, 0.99);
    count.most = times_quantile(&systems, 1.0);
    count.off_median = times_median(&off);
    count.off_most = times_quantile(&off, 1.0);
    table_row(material_law(law), substeps ? "lesson 14" : "budget", count.p50,
              count.p99, count.most, count.unfinished, count.lost,
              count.unfinished ? cell_rounded(2, count.off_median)
                               : cell_word(MISSING),
              count.unfinished ? cell_rounded(2, count.off_most)
                               : cell_word(MISSING));
    free(w);
    pointers_free(&hard);
    live_free(live);
    return count;
}

int main(void)
{
    struct count count[2][2];
    gsl_set_error_handler_off();
    table_begin("systems", "law fallback p50 p99 most unfinished lost "
                "off_median off_most");
    for (int l = 0; l < 2; l++)
        for (int substeps = 0; substeps < 2; substeps++)
            count[l][substeps] = play(l ? CUBIC : LOG, substeps);
    table_end();
    for (int l = 0; l < 2; l++) {
        const struct count *budget = &count[l][0], *parts = &count[l][1];
        claim(budget->lost == 0 && budget->most <= FRAME_SYSTEMS,
              "no frame is lost (%d), at most %d systems (%g)", budget->lost,
              FRAME_SYSTEMS, budget->most);
        claim(parts->p99 >= 2.0 * budget->p99 &&
                  parts->most >= 4.0 * budget->most,
              "sub-steps cost twice as much at p99 (%g, %g), and four times as "
              "much in the worst frame (%g, %g)", parts->p99, budget->p99,
              parts->most, budget->most);
    }
    claim(count[0][0].off_most < 2.0 / 16, "LOG: an unfinished frame is less "
          "than h off (%g m)", count[0][0].off_most);
    claim(count[0][1].lost > 20, "with sub-steps LOG loses frames (%d)",
          count[0][1].lost);
    return table_finish();
}
