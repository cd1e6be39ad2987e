/*
 * kept.c - does a pull lose its frames by the law, or by the kept factors?
 *
 * The first rung alone, with 40 systems, from the last state, as in pull.c:
 * with factors that are kept within a frame, with new ones for every system,
 * and with those of the frame before, too, which is what it has from n = 24 on.
 * LOG, a side in the hand: 8 pulls of three frames, at 0.5 to 7.5 m/s, and one
 * of 10 at 7.5 m/s.  Tables: cubic (the least speed, in steps of 0.1 m/s, that
 * loses one of the first three frames; that with the factors of the frame
 * before, too, in m/s and as a jump in h), patch (a patch in the hand: frames
 * lost of 40).
 */
#include "motion/live.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The first rung in place of the second one, which live_frame_by() lets one
 * choose; a frame in which it fails is made one that cannot be accepted. */
static enum status alone(struct live *live, int chord, int across, double u[],
                         double v[], struct live_report *report)
{
    const struct step_control control = {
        .tolerance = LIVE_TOLERANCE, .max_iterations = ALONE_SYSTEMS,
        .chord = chord};
    if (!across) live->body->kept.usable = 0;
    const struct state *now = &live->now;
    const size_t n = (size_t)live->n_dof;
    double *w = allocate(n, sizeof *w);
    const struct incremental Phi = {live->dt, w, NULL};
    for (size_t r = 0; r < n; r++) w[r] = now->u[r] + live->dt * now->v[r];
    memcpy(u, now->u, n * sizeof *u);
    step_boundary(live->body, live->g, 0, u);
    const struct step_report newton =
        step_solve(live->body, &control, Phi, u);
    for (size_t r = 0; r < n; r++) v[r] = (u[r] - now->u[r]) / live->dt;
    report->systems += newton.iterations;
    const enum status status = newton.indefinite ? NOT_SPD : newton.status;
    if (status != OK) u[0] = NAN;
    free(w);
    return status;
}

static enum status with_kept(struct live *live, double u[], double v[],
                             struct live_report *report)
{
    return alone(live, 1, 0, u, v, report);
}

static enum status with_new(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    return alone(live, 0, 0, u, v, report);
}

static enum status across_frames(struct live *live, double u[], double v[],
                                 struct live_report *report)
{
    return alone(live, 1, 1, u, v, report);
}

struct pulled {
    int lost;    /* frames */
    int systems; /* of frame 1, the first in which the hand moves */
};

static struct pulled pull(int n, enum law law, enum grab grab, live_rung *rung,
                          double speed, int frames)
{
    const struct live_setting set = {n, law, BACKWARD_EULER, grab, LAST_STATE,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    struct pointers script = pointers_pull(speed);
    struct pulled sum = {0, 0};
    for (int k = 0; k <= frames; k++) { /* the hand grabs in frame 0 */
        double to[2];
        live_input(live, &script.frame[k]);
        live_hand(live->hand, &script.frame[k], to);
        live_carry(live, to);
        live->trouble = 1; /* so that the frame begins with `rung` */
        const struct live_report report =
            live_frame_by(live, live_lift, rung, to);
        sum.lost += strcmp(report.rung, "lost") == 0;
        if (k == 1) sum.systems = report.systems;
    }
    pointers_free(&script);
    live_free(live);
    return sum;
}

static void claim_log(void)
{
    static const int n[] = {40, 42, 44, 64};
    for (int k = 0; k < COUNT(n); k++) {
        int kept = 0, fresh = 0, most = 0, across = 0;
        for (double speed = 0.5; speed <= 7.5; speed += 1.0) {
            const struct pulled one = pull(n[k], LOG, SIDE, with_new, speed, 3);
            kept += pull(n[k], LOG, SIDE, with_kept, speed, 3).lost > 0;
            across += pull(n[k], LOG, SIDE, across_frames, speed, 3).lost;
            fresh += one.lost > 0;
            if (one.systems > most) most = one.systems;
        }
        const int kept_10 = pull(n[k], LOG, SIDE, with_kept, 7.5, 10).lost;
        const int new_10 = pull(n[k], LOG, SIDE, with_new, 7.5, 10).lost;
        across += pull(n[k], LOG, SIDE, across_frames, 7.5, 10).lost;
        claim(across == 0, "LOG: those of the frame before lose none");
        claim(fresh == 0 && new_10 == 0 && most <= 8 &&
                  (kept > 0) == (n[k] > 40) && kept_10 == (n[k] > 42 ? 10 : 0),
              "LOG: kept factors lose frames from n = 42 on, new ones none "
              "(n = %d: %d and %d of 8 pulls, %d and %d of 10 frames), in %d "
              "systems at most", n[k], kept, fresh, kept_10, new_10, most);
    }
}

/* The least speed that loses one of the first three frames (m/s). */
static double limit(int n, live_rung *rung)
{
    int speed = 10;
    while (speed < 75 && !pull(n, CUBIC, SIDE, rung, 0.1 * speed, 3).lost)
        speed++;
    return 0.1 * speed;
}

int main(void)
{
    static const int n[] = {16, 24, 32, 40};
    gsl_set_error_handler_off();
    claim_log();

    table_begin("cubic", "n kept new across across_h");
    for (int k = 0; k < COUNT(n); k++) {
        const double kept = limit(n[k], with_kept);
        const double fresh = limit(n[k], with_new);
        const double across = limit(n[k], across_frames);
        const double jump = across / 30.0 * n[k] / 2.0; /* in cells */
        table_row(n[k], kept, fresh, across, jump);
        claim(n[k] < BODY_SPARSE_FROM ? across == kept : jump < 1.65,
              "cubic law: factors of the frame before lose a pull sooner (n = "
              "%d: %g h)", n[k], jump);
        claim(n[k] == 40 || (fresh < 1.05 * kept && fresh > 1.01 * kept),
              "cubic law: new factors raise the limit by less than 5 %% (n = "
              "%d: %g to %g m/s)", n[k], kept, fresh);
    }
    table_end();

    table_begin("patch", "law n speed kept new");
    const int cubic[2] = {pull(24, CUBIC, PATCH, with_kept, 2.5, 40).lost,
                          pull(24, CUBIC, PATCH, with_new, 2.5, 40).lost};
    const int of_log[2] = {pull(32, LOG, PATCH, with_kept, 7.5, 40).lost,
                           pull(32, LOG, PATCH, with_new, 7.5, 40).lost};
    table_row(material_law(CUBIC), 24, 2.5, cubic[0], cubic[1]);
    table_row(material_law(LOG), 32, 7.5, of_log[0], of_log[1]);
    table_end();
    claim(of_log[0] > 0 && of_log[1] == 0 && cubic[1] > 15,
          "with a patch, too, LOG loses frames by kept factors alone (%d and "
          "%d), the cubic law by itself (%d and %d)", of_log[0], of_log[1],
          cubic[0], cubic[1]);
    return table_finish();
}
