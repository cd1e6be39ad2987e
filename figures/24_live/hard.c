/*
 * hard.c - what each rung of the ladder is for: one is taken away at a time.
 *
 * The script `hard` on the square, n = 8, a patch in the hand, backward Euler.
 * Table: of 300 frames lost, longest freeze, systems at p99, largest energy and
 * |u|, |u| at the end; the same in words, which do not hang on round-off.
 */
#include "live.h"
#include "study.h"
#include "table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum without {
    NOTHING, DOWNHILL, SEARCH, HALVING, PROJECTION, BOUND, STOPPING, N_WITHOUT
};
static const char *const WITHOUT[] = {
    "nothing",            "second rung",  "line search",       "halved ways",
    "projection of lift", "bounded hand", "stop if unfinished"};
static enum without without; /* the rung that is not there */
static enum status downhill(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    const double dt = live->dt, *u0 = live->now.u;
    const int n = live->n_dof;
    double *w = allocate(2 * (size_t)n, sizeof *w), *g = w + n, unused;
    enum status status = INVERTED;
    for (int r = 0; r < n; r++) w[r] = u0[r] + dt * live->now.v[r];
    report->part = 1.0;
    const int tries = without == HALVING ? 1 : LIVE_HALVINGS;
    for (int k = 0; status != OK && k < tries; k++) {
        if (k > 0) report->part *= 0.5;
        for (int r = 0; r < n; r++)
            g[r] = u0[r] + report->part * (live->g[r] - u0[r]);
        report->systems++;
        status = live_lift(live->body, dt, w, u0, g,
                           without == PROJECTION ? EXACT : PROJECTED, u);
        if (status == OK) status = body_energy(live->body, u, &unused);
    }
    if (status != OK) report->part = 0.0, memcpy(u, u0, (size_t)n * sizeof *u);
    struct step_control control = LIVE_DOWNHILL;
    if (without == SEARCH) control.line_search = 0;
    const struct step_report newton =
        step_solve(live->body, &control, dt, w, NULL, u);
    report->systems += newton.iterations;
    const int whole = (newton.status == OK && report->part == 1.0) ||
                      without == STOPPING;
    for (int r = 0; r < n; r++) v[r] = whole ? (u[r] - u0[r]) / dt : 0.0;
    free(w);
    return newton.status;
}

struct result {
    int lost, frozen, freeze;
    double p99, farthest;
};

/* All of `hard`; its row. */
static struct result play(enum law law)
{
    const struct live_setting set = {8, law, BACKWARD_EULER, PATCH, ELASTIC,
                                     without != DOWNHILL};
    struct live *live = live_alloc(&set);
    struct pointers hard = pointers_hard();
    struct result sum = {0};
    struct times systems = {0};
    double energy = 0.0, far = 0.0;
    for (int k = 0; k < hard.n; k++) {
        double to[2] = {hard.frame[k].x, hard.frame[k].y};
        live_input(live, &hard.frame[k]);
        if (without != BOUND) live_hand(live->hand, &hard.frame[k], to);
        live_carry(live, to);
        const struct live_report report =
            live_frame_by(live, live_lift, downhill, to);
        const int lost = strcmp(report.rung, "lost") == 0;
        sum.lost += lost;
        sum.frozen = lost ? sum.frozen + 1 : 0;
        if (sum.frozen > sum.freeze) sum.freeze = sum.frozen;
        times_record(&systems, report.systems, 1);
        energy = fmax(energy, live_energy(live));
        far = 0.0;
        for (int r = 0; r < live->n_dof; r++)
            far = fmax(far, fabs(live->now.u[r]));
        sum.farthest = fmax(sum.farthest, far);
    }
    sum.p99 = times_quantile(&systems, 0.99);
    table_row(material_law(law), WITHOUT[without], sum.lost, sum.freeze,
              sum.p99, energy, sum.farthest, far,
              sum.lost == 0 ? "none" : sum.lost < 20 ? "few" : "many",
              far < 1e-2 ? "at rest" : far < 10.0 ? "frozen" : "exploded");
    pointers_free(&hard);
    live_free(live);
    return sum;
}

int main(void)
{
    struct result hard[2][N_WITHOUT];
    gsl_set_error_handler_off();
    table_begin("rungs", "law without lost freeze p99 energy farthest last "
                         "losses end");
    for (int l = 0; l < 2; l++)
        for (int w = 0; w < N_WITHOUT; w++) {
            without = (enum without)w;
            hard[l][w] = play(l ? CUBIC : LOG);
        }
    table_end();
    for (int l = 0; l < 2; l++)
        claim(hard[l][NOTHING].lost == 0 && hard[l][DOWNHILL].freeze >= 40,
              "the whole ladder loses no frame (%d); without the second rung "
              "the picture freezes for 40 frames or more (%d)",
              hard[l][NOTHING].lost, hard[l][DOWNHILL].freeze);
    claim(hard[0][SEARCH].lost > 0 && hard[1][SEARCH].farthest > 1e3,
          "without a line search LOG loses frames (%d), and the cubic body "
          "explodes (%g m)", hard[0][SEARCH].lost, hard[1][SEARCH].farthest);
    return table_finish();
}
