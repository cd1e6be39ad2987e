/* without.c - see without.h. */
#include "without.h"

#include "study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *without_word(enum without without)
{
    static const char *const word[] = {
        "nothing", "first rung", "elastic lift", "second rung",
        "projection of lift", "line search", "acceptance if unfinished",
        "stop if unfinished", "halved ways", "bounded hand", "bound on leaps"};
    return word[without];
}

/* ---- lifts --------------------------------------------------------------- */

static enum status no_lift(struct body *body, double dt, const double w[],
                           const double u0[], const double g[],
                           enum tangent tangent, double u[])
{
    (void)body, (void)dt, (void)w, (void)u0, (void)g, (void)tangent, (void)u;
    return STALLED;
}

/* live_lift() that may go any finite way, K_fh (g - u0) by a one-sided
 * difference. */
static enum status leap(struct body *body, double dt, const double w[],
                        const double u0[], const double g[],
                        enum tangent tangent, double u[])
{
    const int n = 2 * body->mesh->n_vertex;
    const double e = 1e-6;
    double *q = allocate(2 * (size_t)n, sizeof *q), *ahead = q + n;
    for (int r = 0; r < n; r++)
        u[r] = u0[r] + (body->equation[r] < 0 ? e * (g[r] - u0[r]) : 0.0);
    enum status status =
        body_assemble(body, dt, w, NULL, u, NO_TANGENT, ahead);
    if (status == OK)
        status = body_assemble(body, dt, w, NULL, u0, tangent, q);
    for (int r = 0; r < n; r++) q[r] += (ahead[r] - q[r]) / e;
    if (status == OK) status = body_increment(body, body->K, q, u);
    for (int r = 0; r < n; r++)
        u[r] = body->equation[r] < 0 ? g[r] : u0[r] + u[r];
    free(q);
    return status;
}

/* ---- second rungs -------------------------------------------------------- */

/* live_downhill(), with a lift by this K, so many tries, or another control. */
static enum status downhill(struct live *live, live_lifter *lift,
                            enum tangent tangent, int tries, int search,
                            double u[], double v[], struct live_report *report)
{
    const double dt = live->dt, *u0 = live->now.u;
    const int n = live->n_dof;
    double *w = allocate(2 * (size_t)n, sizeof *w), *g = w + n, unused;
    struct step_control control = LIVE_DOWNHILL;
    enum status status = INVERTED;
    control.line_search = search;
    for (int r = 0; r < n; r++) w[r] = u0[r] + dt * live->now.v[r];
    report->part = 1.0;
    for (int k = 0; status != OK && k < tries; k++) {
        if (k > 0) report->part *= 0.5;
        for (int r = 0; r < n; r++)
            g[r] = u0[r] + report->part * (live->g[r] - u0[r]);
        report->systems++;
        status = lift(live->body, dt, w, u0, g, tangent, u);
        if (status == OK) status = body_energy(live->body, u, &unused);
    }
    if (status != OK) {
        report->part = 0.0;
        memcpy(u, u0, (size_t)n * sizeof *u);
    }
    const struct step_report newton =
        step_solve(live->body, &control, dt, w, NULL, u);
    report->systems += newton.iterations;
    const int whole = newton.status == OK && report->part == 1.0;
    for (int r = 0; r < n; r++) v[r] = whole ? (u[r] - u0[r]) / dt : 0.0;
    free(w);
    return newton.status;
}

static enum status unprojected(struct live *live, double u[], double v[],
                               struct live_report *report)
{
    return downhill(live, live_lift, EXACT, LIVE_HALVINGS, 1, u, v, report);
}

static enum status unsearched(struct live *live, double u[], double v[],
                              struct live_report *report)
{
    return downhill(live, live_lift, PROJECTED, LIVE_HALVINGS, 0, u, v,
                    report);
}

static enum status unhalved(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    return downhill(live, live_lift, PROJECTED, 1, 1, u, v, report);
}

static enum status leaping(struct live *live, double u[], double v[],
                           struct live_report *report)
{
    return downhill(live, leap, PROJECTED, LIVE_HALVINGS, 1, u, v, report);
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

/* The first rung's lift was counted, and it was none. */
static enum status alone(struct live *live, double u[], double v[],
                         struct live_report *report)
{
    report->systems = 0;
    return live_downhill(live, u, v, report);
}

/* ---- all frames ---------------------------------------------------------- */

struct without_result without_play(enum without without, int n, enum law law,
                                   enum method method,
                                   const struct pointers *script)
{
    static live_rung *const second[N_WITHOUT] = {
        [FIRST_RUNG] = alone,      [PROJECTION] = unprojected,
        [SEARCH] = unsearched,     [ACCEPTING] = unaccepted,
        [STOPPING] = unstopped,    [HALVING] = unhalved,
        [LEAPING] = leaping};
    live_rung *const rung = second[without] ? second[without] : live_downhill;
    live_lifter *const lift = without == FIRST_RUNG ? no_lift
                              : without == LEAPING  ? leap : live_lift;
    const struct live_setting set = {n, law, method, PATCH,
                                     without == LIFT ? LAST_STATE : ELASTIC,
                                     without != SECOND_RUNG};
    struct live *live = live_alloc(&set);
    struct without_result sum = {0};
    struct times systems = {0};
    int frozen = 0;
    for (int k = 0; k < script->n; k++) {
        const struct pointer *pointer = &script->frame[k];
        double to[2] = {pointer->x, pointer->y};
        live_input(live, pointer);
        if (without != BOUND) live_hand(live->hand, pointer, to);
        live_carry(live, to);
        const struct live_report report = live_frame_by(live, lift, rung, to);
        const int lost = strcmp(report.rung, "lost") == 0;
        sum.lost += lost;
        frozen = lost ? frozen + 1 : 0;
        if (frozen > sum.freeze) sum.freeze = frozen;
        sum.stands += live->holding && report.part == 0.0;
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
