/* without.c - see without.h. */
#include "without.h"

#include "base/study.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *without_word(enum without without)
{
    static const char *const word[] = {
        "nothing", "first rung", "elastic lift", "second rung",
        "projection of lift", "line search", "acceptance if unfinished",
        "stop if unfinished", "halved moves", "bounded hand", "bound on leaps",
        "memory of trouble"};
    return word[without];
}

/* ---- a lift -------------------------------------------------------------- */

static enum status leap(struct body *body, struct incremental Phi,
                        const double u0[], const double g[],
                        enum tangent tangent, double u[])
{
    return live_lift_within(body, Phi, u0, g, tangent, DBL_MAX, u);
}

/* ---- second rungs -------------------------------------------------------- */

static enum status unprojected(struct live *live, double u[], double v[],
                               struct live_report *report)
{
    const struct live_way way = {live_lift, EXACT, LIVE_TRIES, &LIVE_DOWNHILL};
    return live_downhill_by(live, way, u, v, report);
}

static enum status unsearched(struct live *live, double u[], double v[],
                              struct live_report *report)
{
    struct step_control control = LIVE_DOWNHILL;
    control.line_search = 0;
    const struct live_way way = {live_lift, PROJECTED, LIVE_TRIES, &control};
    return live_downhill_by(live, way, u, v, report);
}

static enum status unhalved(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    const struct live_way way = {live_lift, PROJECTED, 1, &LIVE_DOWNHILL};
    return live_downhill_by(live, way, u, v, report);
}

static enum status leaping(struct live *live, double u[], double v[],
                           struct live_report *report)
{
    const struct live_way way = {leap, PROJECTED, LIVE_TRIES, &LIVE_DOWNHILL};
    return live_downhill_by(live, way, u, v, report);
}

static enum status unaccepted(struct live *live, double u[], double v[],
                              struct live_report *report)
{
    const enum status status = live_downhill(live, u, v, report);
    if (status != OK) u[0] = NAN;
    return status;
}

static enum status unstopped(struct live *live, double u[], double v[],
                             struct live_report *report)
{
    const enum status status = live_downhill(live, u, v, report);
    for (int r = 0; r < live->n_dof; r++)
        v[r] = (u[r] - live->now.u[r]) / live->dt;
    return status;
}

/* ---- all frames ---------------------------------------------------------- */

struct without_result without_play(enum without without, int n, enum law law,
                                   enum method method,
                                   const struct pointers *script)
{
    static live_rung *const second[N_WITHOUT] = {
        [PROJECTION] = unprojected, [SEARCH] = unsearched,
        [ACCEPTING] = unaccepted,   [STOPPING] = unstopped,
        [HALVING] = unhalved,       [LEAPING] = leaping};
    live_rung *const rung = second[without] ? second[without] : live_downhill;
    live_lifter *const lift = without == LEAPING ? leap : live_lift;
    const struct live_setting set = {n, law, method, PATCH,
                                     without == LIFT ? LAST_STATE : ELASTIC,
                                     without != SECOND_RUNG, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    struct without_result sum = {0};
    struct times systems = {0};
    int frozen = 0;
    for (int k = 0; k < script->n; k++) {
        const struct pointer *pointer = &script->frame[k];
        double to[2] = {pointer->x, pointer->y};
        live_input(live, pointer);
        if (without != BOUND) live_hand(live->hand, pointer, to);
        live_carry(live, to);
        if (without == FIRST_RUNG) live->trouble = 1;
        if (without == TROUBLE) live->trouble = 0;
        const struct live_report report = live_frame_by(live, lift, rung, to);
        const int lost = strcmp(report.rung, "lost") == 0;
        sum.lost += lost;
        frozen = lost ? frozen + 1 : 0;
        if (frozen > sum.freeze) sum.freeze = frozen;
        sum.stands += live->holding && report.part == 0.0;
        sum.unfinished += !lost && report.status != OK;
        times_record(&systems, report.systems, 1);
        sum.energy = fmax(sum.energy, live_energy(live));
        sum.last = 0.0;
        for (int r = 0; r < live->n_dof; r++) {
            sum.speed = fmax(sum.speed, fabs(live->now.v[r]));
            sum.last = fmax(sum.last, fabs(live->now.u[r]));
        }
    }
    sum.p50 = times_median(&systems);
    sum.p99 = times_quantile(&systems, 0.99);
    sum.most = times_quantile(&systems, 1.0);
    live_free(live);
    return sum;
}
