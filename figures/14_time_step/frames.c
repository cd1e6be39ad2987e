/*
 * frames.c - what does each frame of the loop take?
 *
 * The scripted user of user.h moves the right side of the square about, n = 32,
 * log law, one step of backward Euler per frame [alg:frame].  What a frame
 * takes is the time between the user's input and the new u.
 */
#include "base/clock.h"
#include "motion/integrate.h"
#include "../study/study.h"
#include "base/table.h"
#include "motion/user.h"

enum { N = 32 };

int main(void)
{
    struct user *user = user_alloc(N, LOG, 1.0);
    struct state now = state_make(user->n_dof);
    int lost = 0, robust = 0, cut = 0, misses = 0;
    int iterations = 0, factorisations = 0, easy = 0;
    double least = 1.0;
    struct times times = {0};

    study_machine();
    table_begin("script", "motion until u1 u2 tremble held");
    for (int m = 0; m < USER_MOTIONS; m++) {
        const struct user_motion *motion = &USER_SCRIPT[m];
        table_row(motion->word, motion->until, motion->to[0], motion->to[1],
                  motion->tremble, motion->held ? "yes" : "no");
    }
    table_end();
    table_begin("frames", "k t motion status first attempts substeps "
                          "iterations factorisations u1 u2 min_J seconds");
    while (user_next(user)) {
        const double start = clock_seconds();
        const struct frame frame =
            integrate_frame(user->body, user->dt, user->g, &now);
        const double took = clock_seconds() - start;
        const double min_J = body_min_J(user->body, now.u);
        table_row(user->k, user->t, user->motion, status_name(frame.status),
                  status_name(frame.first), frame.attempts, frame.substeps,
                  frame.iterations, frame.factorisations, now.u[user->side],
                  now.u[user->side + 1], min_J, took);
        times_record(&times, took, 1);
        lost += frame.status != OK;
        robust += frame.attempts > 1;
        cut += frame.substeps > 1;
        misses += took > user->dt;
        easy += frame.attempts == 1 && frame.iterations <= 6;
        iterations += frame.iterations;
        factorisations += frame.factorisations;
        if (min_J < least) least = min_J;
    }
    table_end();
    table_begin("loop", "n frames lost robust cut iterations factorisations "
                        "misses p50 p99 worst");
    table_row(N, user->frames, lost, robust, cut, iterations, factorisations,
              misses, times_median(&times), times_quantile(&times, 0.99),
              times_quantile(&times, 1.0));
    table_end();
    claim(lost == 0 && least > 0.0, "no frame is lost and no triangle turned "
          "over (%d, least det F %g)", lost, least);
    claim(2 * easy > user->frames && robust > 0 && 3 * robust < user->frames,
          "most frames take FAST six Newton steps at most, some need ROBUST "
          "(%d and %d of %d)", easy, robust, user->frames);
    state_free(&now);
    user_free(user);
    return table_finish();
}
