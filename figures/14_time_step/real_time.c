/*
 * real_time.c - which is the finest mesh whose loop keeps up with 30 frames per
 * second on this machine?
 *
 * The scripted user of user.h, log law.  A mesh is in real time when at most
 * one frame in a hundred is late; then its 99 % quantile is within a frame.  n
 * is doubled, then bisected over a list, until it is found or BUDGET is over; a
 * longer search needs a larger BUDGET here.  real_time is `-` when the time was
 * over before one could say.
 */
#include "base/clock.h"
#include "motion/integrate.h"
#include "base/study.h"
#include "base/table.h"
#include "motion/user.h"

static const double BUDGET = 0.5; /* (s) */

/* Beyond n = CLAIMED it may be round-off that loses a frame. */
enum { MESHES = 18, CLAIMED = 32 };
static const int mesh[MESHES] = {4,  6,  8,  10, 12, 14, 16, 20, 24,
                                 28, 32, 40, 48, 56, 64, 72, 80, 96};

struct loop {
    int misses, lost;
    int late, ended; /* too many misses; the script was gone through */
    struct times times;
};

/* Leaves the loop when it is late, and when the clock passes `deadline`. */
static void run_loop(int n, double deadline, struct loop *loop)
{
    struct user *user = user_alloc(n, LOG, 1.0);
    struct state now = state_make(user->n_dof);
    *loop = (struct loop){0};
    while (!loop->late && clock_seconds() < deadline && user_next(user)) {
        const double start = clock_seconds();
        const struct frame frame =
            integrate_frame(user->body, user->dt, user->g, NULL, &now);
        const double took = clock_seconds() - start;
        times_record(&loop->times, took, 1);
        loop->lost += frame.status != OK;
        loop->misses += took > user->dt;
        loop->late = loop->misses * 100 > user->frames;
    }
    loop->ended = user->k == user->frames;
    state_free(&now);
    user_free(user);
}

int main(void)
{
    const double deadline = clock_seconds() + BUDGET;
    int yes = -1, no = MESHES, next = 0, lost = 0;
    struct loop loop;

    study_machine();
    table_begin("realtime", "n real_time frames p50 p99 worst misses");
    while (no - yes > 1 && clock_seconds() < deadline) {
        run_loop(mesh[next], deadline, &loop);
        const struct times *t = &loop.times;
        table_row(mesh[next], loop.late    ? "no"
                              : loop.ended ? "yes"
                                           : MISSING,
                  t->runs, times_median(t), times_quantile(t, 0.99),
                  times_quantile(t, 1.0), loop.misses);
        if (!loop.ended && !loop.late) break;
        if (loop.late)
            no = next;
        else
            yes = next;
        if (!loop.late && mesh[next] <= CLAIMED) lost += loop.lost;
        if (no < MESHES)
            next = (yes + no) / 2;
        else
            while (next < no - 1 && mesh[next] < 2 * mesh[yes]) next++;
    }
    table_end();
    table_begin("largest", "n found");
    table_row(cell_if(yes >= 0, yes >= 0 ? mesh[yes] : 0),
              no - yes <= 1 ? "yes" : "no");
    table_end();
    claim(lost == 0, "on meshes up to n = %d that are in real time no frame is "
          "lost (%d are)", CLAIMED, lost);
    return table_finish();
}
