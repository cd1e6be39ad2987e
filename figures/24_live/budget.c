/*
 * budget.c - a budget of systems against the fallback of lesson 14.
 *
 * The script `hard`, n = 16, a patch in the hand, backward Euler, the same
 * bounded hand.  One body takes live_frame(), the other live_frame_in_parts(),
 * with more and more sub-steps.  Table: systems per frame at the median, at the
 * 99th percentile and at most; frames unfinished, and lost.
 */
#include "motion/live.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <string.h>

struct count {
    double p50, p99, most;
    int unfinished, lost;
};

static struct count play(enum law law, int substeps)
{
    const struct live_setting set = {16, law, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    struct pointers hard = pointers_hard();
    struct count count = {0};
    struct times systems = {0};
    for (int k = 0; k < hard.n; k++) {
        double to[2];
        live_input(live, &hard.frame[k]);
        live_hand(live->hand, &hard.frame[k], to);
        live_carry(live, to);
        const struct live_report report =
            substeps ? live_frame_in_parts(live, to) : live_frame(live, to);
        times_record(&systems, report.systems, 1);
        const int lost = strcmp(report.rung, "lost") == 0;
        count.lost += lost;
        count.unfinished += !lost && report.status != OK;
    }
    count.p50 = times_median(&systems);
    count.p99 = times_quantile(&systems, 0.99);
    count.most = times_quantile(&systems, 1.0);
    table_row(material_law(law), substeps ? "lesson 14" : "budget", count.p50,
              count.p99, count.most, count.unfinished, count.lost);
    pointers_free(&hard);
    live_free(live);
    return count;
}

int main(void)
{
    struct count count[2][2];
    gsl_set_error_handler_off();
    table_begin("systems", "law fallback p50 p99 most unfinished lost");
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
    claim(count[0][1].lost > 20, "with sub-steps LOG loses frames (%d)",
          count[0][1].lost);
    return table_finish();
}
