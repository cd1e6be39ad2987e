/* live.c - see live.h. */
#include "motion/live.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int on_left_side(const struct mesh *mesh, int a)
{
    return mesh->X[2 * a] == -1.0;
}

/* A new body, in which the left side is held, and all that `take` names; in
 * PLAIN storage when the one before was. */
static void hold(struct live *live, const int take[])
{
    const struct mesh *mesh = live->mesh;
    const int plain = live->body && live->body->K->storage == PLAIN;
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = on_left_side(mesh, a) || (take && take[a]);
    body_free(live->body);
    live->body = body_alloc_of(live->set.element, mesh,
                               material_notes(live->set.law), 1.0, CONSISTENT,
                               held);
    if (plain) body_store(live->body, PLAIN);
    free(held);
}

/* The same vertices are held by another element. */
static void change_element(struct live *live)
{
    const int n_vertex = live->mesh->n_vertex;
    int *take = allocate((size_t)n_vertex, sizeof *take);
    for (int a = 0; a < n_vertex; a++)
        take[a] = live->body->equation[2 * a] < 0;
    hold(live, take);
    free(take);
}

static void make_even(struct live_setting *set)
{
    if (set->element == QUADRATIC_TRIANGLE) set->n += set->n % 2;
}

static void begin(struct live *live)
{
    live->mesh = mesh_square(live->set.n);
    live->n_dof = 2 * live->mesh->n_vertex;
    live->now = state_make(live->n_dof);
    live->grip = allocate((size_t)live->n_dof, sizeof *live->grip);
    live->g = allocate((size_t)live->n_dof, sizeof *live->g);
    live->trouble = live->holding = 0;
    hold(live, NULL);
}

/* Free all but the body, whose storage the next one takes over. */
static void end(struct live *live)
{
    mesh_free(live->mesh);
    state_free(&live->now);
    free(live->grip);
    free(live->g);
}

struct live *live_alloc(const struct live_setting *set)
{
    struct live *live = allocate(1, sizeof *live);
    live->set = *set;
    make_even(&live->set);
    live->dt = 1.0 / 30.0;
    begin(live);
    return live;
}

void live_free(struct live *live)
{
    if (!live) return;
    end(live);
    body_free(live->body);
    free(live);
}

/* Set `place` to the pointer, kept within LIVE_FAR. */
static void within_reach(const struct pointer *pointer, double place[2])
{
    place[0] = fmax(-LIVE_FAR, fmin(LIVE_FAR, pointer->x));
    place[1] = fmax(-LIVE_FAR, fmin(LIVE_FAR, pointer->y));
}

/* Take the vertex near the pointer into the hand; false: there is none. */
static int grab(struct live *live, const struct pointer *pointer)
{
    const struct mesh *mesh = live->mesh;
    int *take = allocate((size_t)mesh->n_vertex, sizeof *take), taken = 0;
    within_reach(pointer, live->hand);
    for (int a = 0; a < mesh->n_vertex; a++) {
        for (int r = 2 * a; r < 2 * a + 2; r++)
            live->grip[r] = mesh->X[r] + live->now.u[r] - live->hand[r % 2];
        const int near = live->set.grab == SIDE
                             ? mesh->X[2 * a] == 1.0
                             : hypot(live->grip[2 * a],
                                     live->grip[2 * a + 1]) <= LIVE_RADIUS;
        take[a] = near && !on_left_side(mesh, a);
        taken += take[a];
    }
    if (taken) hold(live, take);
    free(take);
    return taken > 0;
}

void live_input(struct live *live, const struct pointer *pointer)
{
    struct live_setting *set = &live->set;
    const struct live_setting before = *set;
    switch (pointer->key) {
    case 'l': set->law = set->law == LOG ? CUBIC : LOG; break;
    case 'i':
        set->method = set->method == BACKWARD_EULER ? IMPLICIT_MIDPOINT
                                                    : BACKWARD_EULER;
        break;
    case 's':
        set->start = set->start == LAST_STATE ? ELASTIC
                                              : (enum start)(set->start + 1);
        break;
    case 'p': set->fallback = !set->fallback; break;
    case 'g': set->grab = set->grab == PATCH ? SIDE : PATCH; break;
    case 'e':
        set->element = set->element == LINEAR_TRIANGLE ? QUADRATIC_TRIANGLE
                                                       : LINEAR_TRIANGLE;
        break;
    case '+': set->n = set->n <= 32 ? 2 * set->n : 64; break;
    case '-': set->n = set->n >= 4 ? set->n / 2 : 2; break;
    default: break;
    }
    make_even(set);
    if (set->element != before.element && set->n == before.n)
        change_element(live);
    if (set->law == LOG && body_min_J(live->body, live->now.u) <= 0.0)
        set->law = CUBIC; /* LOG cannot take over what is inverted */
    live->body->material = material_notes(set->law);
    if (set->n != before.n || pointer->key == 'r') {
        end(live);
        begin(live);
    }
    if (live->holding && (!pointer->down || set->grab != before.grab)) {
        live->holding = 0;
        hold(live, NULL);
    }
    if (!live->holding && pointer->down) live->holding = grab(live, pointer);
}

void live_hand(const double from[2], const struct pointer *pointer,
               double to[2])
{
    double target[2];
    within_reach(pointer, target);
    const double way = hypot(target[0] - from[0], target[1] - from[1]);
    const double s = way > LIVE_REACH ? LIVE_REACH / way : 1.0;
    for (int i = 0; i < 2; i++) to[i] = from[i] + s * (target[i] - from[i]);
}

void live_carry(struct live *live, const double to[2])
{
    const double *X = live->mesh->X;
    for (int a = 0; a < live->mesh->n_vertex; a++)
        for (int i = 0; i < 2; i++) {
            const int r = 2 * a + i;
            /* u = x - X, x = grip + to */
            live->g[r] = live->body->equation[r] >= 0 ||
                                 on_left_side(live->mesh, a)
                             ? 0.0
                             : live->grip[r] + to[i] - X[r];
        }
}

/* ---- a frame ------------------------------------------------------------- */

/* The jump by which K_fh (g - u0) is a difference quotient (m): the error of
 * the quotient and its round-off are then both about 1e-11 of it. */
static const double PROBE = 1e-6;

enum status live_lift(struct body *body, struct incremental Phi,
                      const double u0[], const double g[],
                      enum tangent tangent, double u[])
{
    const int n = 2 * body->mesh->n_vertex;
    double *move = allocate((size_t)n, sizeof *move), size = 0.0;
    double *q = allocate((size_t)n, sizeof *q);
    double *ahead = allocate((size_t)n, sizeof *ahead);
    double *behind = allocate((size_t)n, sizeof *behind);
    enum status status;
    for (int r = 0; r < n; r++) {
        move[r] = body->equation[r] < 0 ? g[r] - u0[r] : 0.0;
        size = fmax(size, fabs(move[r]));
    }
    const double e = size > 0.0 ? PROBE / size : 0.0; /* e |move| = PROBE */
    for (int r = 0; r < n; r++) u[r] = u0[r] + e * move[r];
    status = body_assemble(body, Phi, u, NO_TANGENT, ahead);
    for (int r = 0; r < n; r++) u[r] = u0[r] - e * move[r];
    if (status == OK)
        status = body_assemble(body, Phi, u, NO_TANGENT, behind);
    if (status == OK) status = body_assemble(body, Phi, u0, tangent, q);
    /* q + K_fh (g - u0), by a central difference along the jump */
    if (status == OK && e > 0.0)
        for (int r = 0; r < n; r++)
            q[r] += (ahead[r] - behind[r]) / (2.0 * e);
    if (status == OK) status = body_increment(body, body->K, q, u); /* du */
    const int solved = status == OK;
    for (int r = 0; r < n && solved; r++) {
        u[r] += move[r];
        if (!(fabs(u[r]) <= LIVE_LEAP)) status = NONFINITE; /* NaN too */
        u[r] += u0[r];
    }
    free(move);
    free(q);
    free(ahead);
    free(behind);
    return status;
}

static const struct step_control LIVE_FAST = {
    .tolerance = LIVE_TOLERANCE, .max_iterations = FAST_SYSTEMS - 1,
    .chord = 1};
/* `fast` where no rung comes after it: then it may take its time. */
static const struct step_control LIVE_ALONE = {
    .tolerance = LIVE_TOLERANCE, .max_iterations = ALONE_SYSTEMS,
    .chord = 1};
const struct step_control LIVE_DOWNHILL = {
    .tolerance = LIVE_TOLERANCE, .max_iterations = FRAME_SYSTEMS,
    .line_search = 1, .projection = ON_DEMAND};

/* u, v := the end of the frame by the method of the setting, if the status is
 * OK. */
static enum status fast(struct live *live, live_lifter *lift, double u[],
                        double v[], struct live_report *report)
{
    const struct state *now = &live->now;
    const int n = live->n_dof;
    const int midpoint = live->set.method == IMPLICIT_MIDPOINT;
    const double d = midpoint ? 0.5 * live->dt : live->dt;
    double *w = allocate((size_t)n, sizeof *w);
    double *g = allocate((size_t)n, sizeof *g);
    const struct incremental Phi = {d, w, NULL};
    enum status status = OK;
    for (int r = 0; r < n; r++) {
        w[r] = now->u[r] + d * now->v[r];
        u[r] = now->u[r];
        g[r] = midpoint ? 0.5 * (now->u[r] + live->g[r]) : live->g[r];
    }
    if (live->set.start == ELASTIC) {
        report->systems++;
        status = lift(live->body, Phi, now->u, g, EXACT, u);
    } else {
        step_boundary(live->body, g, live->set.start == ROWS, u);
    }
    if (status == OK) {
        const struct step_report newton =
            step_solve(live->body,
                       live->set.fallback ? &LIVE_FAST : &LIVE_ALONE, Phi, u);
        report->systems += newton.iterations;
        status = newton.indefinite ? NOT_SPD : newton.status;
    }
    for (int r = 0; r < n; r++) {
        v[r] = (u[r] - now->u[r]) / d;
        if (midpoint) { /* u* and v* are half-way */
            u[r] = 2.0 * u[r] - now->u[r];
            v[r] = 2.0 * v[r] - now->v[r];
        }
    }
    free(w);
    free(g);
    double unused; /* the doubled state may be one that there is not */
    if (status == OK) status = body_energy(live->body, u, &unused);
    return status;
}

enum status live_start(const struct live *live, struct incremental Phi,
                       const double g[], const double u[])
{
    const struct body *body = live->body;
    const int n = live->n_dof;
    double *left = allocate((size_t)n, sizeof *left);
    double *room = allocate(2 * (size_t)n, sizeof *room);
    double lifted, phi, noise, noise_left;
    for (int r = 0; r < n; r++)
        left[r] = body->equation[r] < 0 ? g[r] : live->now.u[r];
    enum status status = step_potential(body, Phi, u, room, &lifted, &noise);
    /* Phi of the lift is larger, beyond round-off */
    if (status == OK &&
        step_potential(body, Phi, left, room, &phi, &noise_left) == OK &&
        lifted > phi + 16.0 * DBL_EPSILON * fmax(noise, noise_left))
        status = STALLED;
    free(left);
    free(room);
    return status;
}

enum status live_downhill(struct live *live, double u[], double v[],
                          struct live_report *report)
{
    const struct state *now = &live->now;
    const int n = live->n_dof;
    double *w = allocate((size_t)n, sizeof *w);
    double *g = allocate((size_t)n, sizeof *g);
    const struct incremental Phi = {live->dt, w, NULL}; /* backward Euler */
    struct step_control rest = LIVE_DOWNHILL;
    enum status status = INVERTED; /* or anything but OK */
    for (int r = 0; r < n; r++) w[r] = now->u[r] + live->dt * now->v[r];
    report->part = 1.0;
    for (int k = 0; k < LIVE_TRIES && status != OK; k++) {
        if (report->systems == FRAME_SYSTEMS - 1) break;
        if (k > 0) report->part *= 0.5;
        for (int r = 0; r < n; r++)
            g[r] = now->u[r] + report->part * (live->g[r] - now->u[r]);
        report->systems++;
        status = live_lift(live->body, Phi, now->u, g, PROJECTED, u);
        if (status == OK) status = live_start(live, Phi, g, u);
    }
    if (status != OK) {
        report->part = 0.0;
        memcpy(u, now->u, (size_t)n * sizeof *u);
    }
    rest.max_iterations = FRAME_SYSTEMS - report->systems;
    const struct step_report newton = step_solve(live->body, &rest, Phi, u);
    report->systems += newton.iterations;
    const int whole = newton.status == OK && report->part == 1.0;
    for (int r = 0; r < n; r++)
        v[r] = whole ? (u[r] - now->u[r]) / live->dt : 0.0;
    free(w);
    free(g);
    return newton.status;
}

struct live_report live_frame_by(struct live *live, live_lifter *lift,
                                 live_rung *downhill, const double to[2])
{
    struct live_report report = {.rung = "fast", .first = "untried",
                                 .part = 1.0};
    double *u = allocate((size_t)live->n_dof, sizeof *u);
    double *v = allocate((size_t)live->n_dof, sizeof *v), unused;
    enum status accept = NOT_SPD; /* or anything but OK: untried */
    if (!(live->trouble && live->set.fallback)) {
        accept = report.status = fast(live, lift, u, v, &report);
        report.first = status_name(accept);
    }
    if (accept != OK && live->set.fallback) {
        report.rung = "downhill";
        report.status = downhill(live, u, v, &report);
        accept = body_energy(live->body, u, &unused);
        live->trouble = report.systems > CALM_SYSTEMS;
    }
    if (accept == OK) accept = state_accept(&live->now, u, v);
    if (accept != OK) report.rung = "lost"; /* and the hand goes on */
    for (int i = 0; i < 2; i++)
        live->hand[i] += report.part * (to[i] - live->hand[i]);
    free(u);
    free(v);
    return report;
}

struct live_report live_frame(struct live *live, const double to[2])
{
    return live_frame_by(live, live_lift, live_downhill, to);
}

/* ---- measures ----------------------------------------------------------- */

int live_knots(const struct mesh *mesh, const double u[], int knot[])
{
    const size_t n = (size_t)mesh->n_vertex;
    double *rest = allocate(n, sizeof *rest);
    double *angle = allocate(n, sizeof *angle);
    int knots = 0;
    mesh_angles(mesh, NULL, rest);
    mesh_angles(mesh, u, angle);
    for (size_t a = 0; a < n; a++) {
        /* inside: 2 pi at rest; else whole turns more or less, so > pi off */
        const int is_one = fabs(rest[a] - 2.0 * M_PI) < 1e-6 &&
                           fabs(angle[a] - 2.0 * M_PI) > M_PI;
        if (knot) knot[a] = is_one;
        knots += is_one;
    }
    free(rest);
    free(angle);
    return knots;
}

double live_energy(const struct live *live)
{
    double *momentum = allocate((size_t)live->n_dof, sizeof *momentum);
    double energy = NAN;
    if (body_energy(live->body, live->now.u, &energy) != OK) energy = NAN;
    body_mass(live->body, live->now.v, momentum); /* M v */
    for (int r = 0; r < live->n_dof; r++)
        energy += 0.5 * live->now.v[r] * momentum[r];
    free(momentum);
    return energy;
}
