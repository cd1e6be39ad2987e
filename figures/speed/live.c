/*
 * live.c - how long does a frame take in the hand, by what is done when
 * Newton's method fails?
 *
 * The square of live.h, a patch in the hand, backward Euler.  A frame's time is
 * from its input to the new state.  Table systems: linear systems per frame and
 * milliseconds by the fallback of live.h, by that of lesson 14 and by the
 * second rung of live.h alone, for the same input and the same bounded hand,
 * which waits when a frame is lost; of `mad` several seeds.
 */
#include "../24_live/in_parts.h"
#include "base/clock.h"
#include "motion/live.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_FRAMES = 8000 };
enum way { BOTH_RUNGS, IN_PARTS, SECOND_ALONE };

/* Of all frames. */
struct count {
    double systems[MOST_FRAMES], ms[MOST_FRAMES];
    int frames, lost;
};

/* The whole script. */
static void play(int n, enum law law, struct pointers script, enum way way,
                 struct count *count)
{
    const struct live_setting set = {n, law, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    for (int k = 0; k < script.n && count->frames < MOST_FRAMES; k++) {
        double to[2];
        const double start = clock_seconds();
        live_input(live, &script.frame[k]);
        live_hand(live->hand, &script.frame[k], to);
        live_carry(live, to);
        live->trouble |= way == SECOND_ALONE;
        const struct live_report report =
            way == IN_PARTS ? live_frame_in_parts(live, to)
                            : live_frame(live, to);
        count->systems[count->frames] = report.systems;
        count->ms[count->frames++] = 1e3 * (clock_seconds() - start);
        count->lost += strcmp(report.rung, "lost") == 0;
    }
    pointers_free(&script);
    live_free(live);
}

/* p := the median, the 99th percentile, the largest; value is put in order. */
static void quantiles(double value[], int n, double p[3])
{
    static const double fraction[] = {0.5, 0.99, 1.0};
    gsl_sort(value, 1, (size_t)n);
    for (int k = 0; k < 3; k++)
        p[k] = gsl_stats_quantile_from_sorted_data(value, 1, (size_t)n,
                                                   fraction[k]);
}

/* seeds: of mad; 0: hard. */
static void compare(int n, enum law law, int seeds)
{
    static const char *const word[] = {"budget", "lesson 14", "second rung"};
    double all[3][3];
    for (enum way way = BOTH_RUNGS; way <= SECOND_ALONE; way++) {
        struct count *c = allocate(1, sizeof *c);
        double *systems = all[way], ms[3];
        if (!seeds) play(n, law, pointers_hard(), way, c);
        for (int seed = 1; seed <= seeds; seed++)
            play(n, law, pointers_mad(seed, 600), way, c);
        quantiles(c->systems, c->frames, systems);
        quantiles(c->ms, c->frames, ms);
        table_row(n, seeds ? "mad" : "hard", material_law(law),
                  word[way], c->frames, c->lost, systems[0], systems[1],
                  systems[2], ms[0], ms[1], ms[2]);
        free(c);
    }
    claim(all[1][1] >= 2.0 * all[0][1] && all[1][2] >= 4.0 * all[0][2],
          "n = %d, %s: sub-steps take twice as many systems at p99 (%g, %g), "
          "and four times as many in the worst frame (%g, %g)", n,
          material_law(law), all[1][1], all[0][1], all[1][2], all[0][2]);
}

int main(void)
{
    gsl_set_error_handler_off();
    study_machine();
    table_begin("systems", "n input law fallback frames lost p50 p99 most "
                           "p50_ms p99_ms most_ms");
    for (int l = 0; l < 2; l++)
        for (int n = 16; n <= 32; n *= 2) {
            compare(n, l ? CUBIC : LOG, 0);
            compare(n, l ? CUBIC : LOG, n == 16 ? 3 : 1);
        }
    table_end();
    return table_finish();
}
