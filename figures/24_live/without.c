/* without.c - see without.h. */
#include "without.h"

#include "../study/study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *without_word(enum without without)
{
    static const char *const word[] = {
        "nothing", "first rung", "elastic lift", "second rung",
        "projection of lift", "projection on demand", "line search",
        "acceptance if unfinished", "stop if unfinished", "halved moves",
        "bounded hand", "bound on leaps", "memory of trouble",
        "nothing yet", "elastic lift", "projection", "line search",
        "8 systems at most", "acceptance if unfinished"};
    return word[without];
}

/* A lift that is finite will do, although it leads beyond LIVE_LEAP. */
static enum status leap(struct body *body, struct incremental Phi,
                        const double u0[], const double g[],
                        enum tangent tangent, double u[])
{
    const enum status status = live_lift(body, Phi, u0, g, tangent, u);
    int beyond = 0;
    if (status != NONFINITE) return status;
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++) {
        if (!isfinite(u[r])) return NONFINITE;
        beyond |= fabs(u[r] - u0[r]) > LIVE_LEAP;
    }
    return beyond ? OK : NONFINITE;
}

static double kinetic(const struct live *live)
{
    double *momentum = allocate((size_t)live->n_dof, sizeof *momentum);
    double energy = 0.0;
    body_mass(live->body, live->now.v, momentum);
    for (int r = 0; r < live->n_dof; r++)
        energy += 0.5 * live->now.v[r] * momentum[r];
    free(momentum);
    return energy;
}

/* The way of the second rung, and what its velocity of 0 has taken away. */
static struct {
    live_lifter *lift;
    enum tangent tangent; /* of the lift */
    int tries;
    struct step_control control;
} way;
static struct without_stop stop;

/* live_downhill() on that way. */
static enum status downhill(struct live *live, double u[], double v[],
                            struct live_report *report)
{
    const struct state *now = &live->now;
    const int n = live->n_dof;
    double *w = allocate((size_t)n, sizeof *w);
    double *g = allocate((size_t)n, sizeof *g);
    const struct incremental Phi = {live->dt, w, NULL};
    enum status status = INVERTED;
    for (int r = 0; r < n; r++) w[r] = now->u[r] + live->dt * now->v[r];
    report->part = 1.0;
    for (int k = 0; k < way.tries && status != OK; k++) {
        if (report->systems == FRAME_SYSTEMS - 1) break;
        if (k > 0) report->part *= 0.5;
        for (int r = 0; r < n; r++)
            g[r] = now->u[r] + report->part * (live->g[r] - now->u[r]);
        report->systems++;
        status = way.lift(live->body, Phi, now->u, g, way.tangent, u);
        if (status == OK) status = live_start(live, Phi, g, u);
    }
    if (status != OK) {
        report->part = 0.0;
        memcpy(u, now->u, (size_t)n * sizeof *u);
    }
    way.control.max_iterations = FRAME_SYSTEMS - report->systems;
    const struct step_report newton =
        step_solve(live->body, &way.control, Phi, u);
    report->systems += newton.iterations;
    const int whole = newton.status == OK && report->part == 1.0;
    for (int r = 0; r < n; r++)
        v[r] = whole ? (u[r] - now->u[r]) / live->dt : 0.0;
    free(w);
    free(g);
    return newton.status;
}

static enum status by_way(struct live *live, double u[], double v[],
                          struct live_report *report)
{
    const double energy = kinetic(live);
    const enum status status = downhill(live, u, v, report);
    if (status == OK && report->part == 1.0) return status;
    stop.frames++;
    stop.energy = fmax(stop.energy, energy);
    return status;
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

/* The second rung alone, with ALONE_SYSTEMS before there is a budget. */
static enum without built;
static enum status simple(struct live *live, double u[], double v[],
                          struct live_report *report)
{
    const int more = built < HURRIED ? ALONE_SYSTEMS - FRAME_SYSTEMS : 0;
    report->systems -= more;
    const enum status status = downhill(live, u, v, report);
    report->systems += more;
    if (status != OK && built < SIMPLE) u[0] = NAN;
    return status;
}

/* ---- all frames ---------------------------------------------------------- */

struct without_result without_play(enum without without, int n, enum law law,
                                   enum method method,
                                   const struct pointers *script)
{
    const int whole = without < LOOP; /* the whole frame, less one thing */
    live_rung *const rung = !whole                ? simple
                            : without == ACCEPTING  ? unaccepted
                            : without == STOPPING ? unstopped
                                                  : by_way;
    live_lifter *const lift = without == LEAPING ? leap : live_lift;
    way.lift = lift;
    way.tangent = without == PROJECTION ? EXACT : PROJECTED;
    way.tries = without == HALVING || !whole ? 1 : LIVE_TRIES;
    way.control = LIVE_DOWNHILL;
    if (without == DEMAND) way.control.projection = NEVER;
    if (without == SEARCH || without == DESCENDING) way.control.line_search = 0;
    const struct live_setting set = {n, law, method, PATCH,
                                     without == LIFT || without == LOOP
                                         ? LAST_STATE : ELASTIC,
                                     without != SECOND_RUNG &&
                                         without != LOOP && without != LIFTED,
                                     LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    body_store(live->body, PLAIN); /* trouble is chaotic */
    stop = (struct without_stop){0};
    built = without;
    struct without_result sum = {0};
    struct times systems = {0};
    int frozen = 0;
    for (int k = 0; k < script->n; k++) {
        const struct pointer *pointer = &script->frame[k];
        double to[2] = {pointer->x, pointer->y};
        live_input(live, pointer);
        if (without != BOUND) live_hand(live->hand, pointer, to);
        live_carry(live, to);
        if (without == FIRST_RUNG || !whole) live->trouble = 1;
        if (without == TROUBLE) live->trouble = 0;
        const struct live_report report = live_frame_by(live, lift, rung, to);
        const int lost = strcmp(report.rung, "lost") == 0;
        sum.lost += lost;
        if (sum.lost == 1 && lost) sum.first = k + 1;
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
    sum.stop = stop;
    sum.p50 = times_median(&systems);
    sum.p99 = times_quantile(&systems, 0.99);
    sum.most = times_quantile(&systems, 1.0);
    live_free(live);
    return sum;
}
