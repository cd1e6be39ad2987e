/*
 * live.c - how fine a square can a hand take, thirty times a second?
 *
 * The square of live.h, a patch in the hand, backward Euler.  A frame's time is
 * from its input to the new state.  Tables: systems (linear systems per frame
 * and milliseconds by the ladder of live.h and by that of lesson 14, for the
 * same input and the same bounded hand, which waits when a frame is lost),
 * frames (milliseconds of live_frame() on `hard`, log law, by the storage of
 * K), reached (the largest n for which, and for all smaller ones, the median
 * or the 99th percentile is below 1/30 s).
 */
#include "clock.h"
#include "live.h"
#include "study.h"
#include "table.h"

#include <gsl/gsl_errno.h>
#include <string.h>

struct count {
    struct times systems, seconds;
    int lost;
};

enum { AS_CHOSEN = -1 };

/* The whole script; storage: BANDED, SPARSE, or that of body_alloc(). */
static struct count play(int n, enum law law, struct pointers script,
                         int storage, int substeps)
{
    const struct live_setting set = {n, law, BACKWARD_EULER, PATCH, ELASTIC, 1};
    struct live *live = live_alloc(&set);
    struct count count = {{0}, {0}, 0};
    for (int k = 0; k < script.n; k++) {
        double to[2];
        const double start = clock_seconds();
        live_input(live, &script.frame[k]);
        if (storage != AS_CHOSEN &&
            live->body->K->storage != (enum storage)storage)
            body_store(live->body, (enum storage)storage);
        live_hand(live->hand, &script.frame[k], to);
        live_carry(live, to);
        int systems, lost;
        if (substeps) {
            const struct frame frame = integrate_frame(
                live->body, live->dt, live->g, NULL, &live->now);
            systems = frame.iterations;
            lost = frame.status != OK;
            if (!lost) memcpy(live->hand, to, sizeof to);
        } else {
            const struct live_report report = live_frame(live, to);
            systems = report.systems;
            lost = strcmp(report.rung, "lost") == 0;
        }
        times_record(&count.seconds, clock_seconds() - start, 1);
        times_record(&count.systems, systems, 1);
        count.lost += lost;
    }
    pointers_free(&script);
    live_free(live);
    return count;
}

static void compare(int n, enum law law, int mad)
{
    for (int substeps = 0; substeps < 2; substeps++) {
        const struct count c =
            play(n, law, mad ? pointers_mad(1, 600) : pointers_hard(),
                 AS_CHOSEN, substeps);
        table_row(n, mad ? "mad" : "hard", material_law(law),
                  substeps ? "lesson 14" : "budget", times_median(&c.systems),
                  times_quantile(&c.systems, 0.99),
                  times_quantile(&c.systems, 1.0), c.lost,
                  1e3 * times_median(&c.seconds),
                  1e3 * times_quantile(&c.seconds, 0.99),
                  1e3 * times_quantile(&c.seconds, 1.0));
    }
}

int main(void)
{
    const enum storage storage[] = {BANDED, SPARSE};
    int reached[2][2] = {{0}};
    gsl_set_error_handler_off();
    study_machine();
    table_begin("systems", "n input law ladder p50 p99 most lost p50_ms p99_ms "
                           "most_ms");
    for (int n = 16; n <= 64; n *= 2)
        for (int l = 0; l < 2; l++)
            for (int mad = 0; mad < (n < 64 ? 2 : 1); mad++)
                compare(n, l ? CUBIC : LOG, mad);
    table_end();

    table_begin("frames", "n storage p50_ms p99_ms most_ms");
    for (int s = 0; s < 2; s++) {
        int below[2] = {1, 1};
        for (int n = 8; n <= 96 && below[0]; n += 8) {
            const struct count c =
                play(n, LOG, pointers_hard(), (int)storage[s], 0);
            const double took[2] = {times_median(&c.seconds),
                                    times_quantile(&c.seconds, 0.99)};
            table_row(n, storage[s] == SPARSE ? "sparse" : "band",
                      1e3 * took[0], 1e3 * took[1],
                      1e3 * times_quantile(&c.seconds, 1.0));
            for (int q = 0; q < 2; q++) {
                below[q] = below[q] && took[q] < 1.0 / 30.0;
                if (below[q]) reached[s][q] = n;
            }
        }
    }
    table_end();
    table_begin("reached", "storage n_p50 n_p99");
    for (int s = 0; s < 2; s++)
        table_row(storage[s] == SPARSE ? "sparse" : "band", reached[s][0],
                  reached[s][1]);
    table_end();
    return table_finish();
}
