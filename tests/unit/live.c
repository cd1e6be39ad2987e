/* live.c - laws of common/motion/live.h and pointer.h. */
#define _DARWIN_C_SOURCE /* mkdtemp, on macOS */
#include "figures/24_live/in_parts.h"
#include "motion/live.h"

#include "unit.h"

#include <fcntl.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static struct live *live_of(int n, enum law law, enum method method)
{
    gsl_set_error_handler_off();
    return live_alloc(
        &(struct live_setting){n, law, method, PATCH, ELASTIC, 1,
                               LINEAR_TRIANGLE});
}

/* A frame begins: what is held, live->g and the hand's `to`. */
static void begin_frame(struct live *live, const struct pointer *pointer,
                        double to[2])
{
    live_input(live, pointer);
    live_hand(live->hand, pointer, to);
    live_carry(live, to);
}

/* A frame of input. */
static struct live_report play(struct live *live, struct pointer pointer)
{
    double to[2];
    begin_frame(live, &pointer, to);
    return live_frame(live, to);
}

/* The first k frames of a script. */
static void play_all(struct live *live, struct pointers script, int k)
{
    for (int j = 0; j < k && j < script.n; j++) play(live, script.frame[j]);
    pointers_free(&script);
}

/* q of a frame of length dt at u; its largest entry of a free unknown. */
static double residual(struct live *live, const double w[], const double u[])
{
    double *q = allocate((size_t)live->n_dof, sizeof *q);
    const struct incremental Phi = {live->dt, w, NULL};
    ck_assert_int_eq(body_assemble(live->body, Phi, u, NO_TANGENT, q), OK);
    const double largest = body_max_free(live->body, q);
    free(q);
    return largest;
}

/* Newton's method has stopped here: max|q| / max K_ii is within its tolerance,
 * but for what K has changed by since the last factors. */
static int solved(struct live *live, const double w[], const double u[])
{
    double *q = allocate((size_t)live->n_dof, sizeof *q);
    const struct incremental Phi = {live->dt, w, NULL};
    ck_assert_int_eq(body_assemble(live->body, Phi, u, EXACT, q), OK);
    const double scaled =
        body_max_free(live->body, q) / matrix_max_diagonal(live->body->K);
    free(q);
    return scaled <= 1.5 * LIVE_TOLERANCE;
}

/* ---- the hand ------------------------------------------------------------ */

static void a_hand_is_bounded(void)
{
    const double from[2] = {9.0, -2.0};
    double to[2];
    live_hand(from, &(struct pointer){9.03, -1.96, 1, '.'}, to);
    close_to(to[0], 9.03, 1e-15);
    close_to(to[1], -1.96, 1e-15);
    live_hand(from, &(struct pointer){6.0, 2.0, 1, '.'}, to);
    close_to(to[0], 9.0 - 0.6 * LIVE_REACH, 1e-14);
    close_to(to[1], -2.0 + 0.8 * LIVE_REACH, 1e-14);
    live_hand(from, &(struct pointer){1e300, -2.0, 1, '.'}, to);
    close_to(to[0], 9.0 + LIVE_REACH, 1e-14);
    double at[2] = {9.9, -9.9};
    live_hand(at, &(struct pointer){1e300, -1e300, 1, '.'}, at);
    close_to(at[0], LIVE_FAR, 1e-14);
    close_to(at[1], -LIVE_FAR, 1e-14);
}

/* A hand that takes something takes what is near and nothing else, and where
 * it stands still nothing is prescribed to move. */
static void a_hand_takes_what_is_near(void)
{
    struct live *live = live_of(8, CUBIC, BACKWARD_EULER);
    play_all(live, pointers_hard(), 15);
    play(live, (struct pointer){0.0, 0.0, 0, '.'});
    const struct pointer here = {0.6, 0.4, 1, '.'};
    double *u = allocate((size_t)live->n_dof, sizeof *u);
    memcpy(u, live->now.u, (size_t)live->n_dof * sizeof *u);
    ck_assert(!live->holding);
    live_input(live, &here);
    ck_assert(live->holding && live->hand[0] == 0.6 && live->hand[1] == 0.4);
    ck_assert_mem_eq(u, live->now.u, (size_t)live->n_dof * sizeof *u);
    live_carry(live, live->hand);
    int taken = 0;
    for (int a = 0; a < live->mesh->n_vertex; a++) {
        const double *X = &live->mesh->X[2 * a];
        const int left = X[0] == -1.0;
        const int near = !left && hypot(X[0] + u[2 * a] - 0.6,
                                        X[1] + u[2 * a + 1] - 0.4) <= 0.3;
        taken += near;
        for (int r = 2 * a; r < 2 * a + 2; r++) {
            ck_assert_int_eq(live->body->equation[r] < 0, left || near);
            close_to(live->g[r], near ? u[r] : 0.0, 1e-14);
        }
    }
    ck_assert_int_ge(taken, 3);

    const double to[2] = {0.7, 0.1};
    live_carry(live, to);
    for (int r = 0; r < live->n_dof; r++)
        if (live->body->equation[r] < 0 && live->mesh->X[r / 2 * 2] > -1.0)
            close_to(live->g[r], u[r] + (r % 2 ? -0.3 : 0.1), 1e-14);
    play(live, here);
    live_input(live, &(struct pointer){0.6, 0.4, 0, '.'});
    ck_assert(!live->holding);
    for (int r = 0; r < live->n_dof; r++)
        ck_assert_int_eq(live->body->equation[r] < 0,
                         live->mesh->X[r / 2 * 2] == -1.0);
    live_input(live, &(struct pointer){7.0, 7.0, 1, '.'});
    ck_assert(!live->holding); /* there is nothing */
    live_free(live);
    live = live_of(4, LOG, BACKWARD_EULER);
    live_input(live, &(struct pointer){-1.1, 0.0, 1, '.'});
    ck_assert(!live->holding); /* what is held already */
    free(u);
    live_free(live);
}

/* The side can be taken from anywhere, and the hand is then no farther than
 * LIVE_FAR. */
static void a_hand_takes_a_side(void)
{
    struct live *live = live_of(5, LOG, BACKWARD_EULER);
    play(live, (struct pointer){1.0, 0.0, 1, '.'});
    play(live, (struct pointer){1.0, 0.0, 1, 'g'});
    ck_assert(live->set.grab == SIDE && live->holding);
    for (int r = 0; r < live->n_dof; r++)
        ck_assert_int_eq(live->body->equation[r] < 0,
                         fabs(live->mesh->X[r / 2 * 2]) == 1.0);
    play(live, (struct pointer){1.0, 0.0, 0, '.'});
    play(live, (struct pointer){1e5, -1e5, 1, '.'});
    ck_assert(live->holding && live->hand[0] == LIVE_FAR &&
              live->hand[1] == -LIVE_FAR);
    live_free(live);
}

static void press(struct live *live, const char *keys)
{
    for (; *keys; keys++)
        live_input(live, &(struct pointer){0.0, 0.0, 0, *keys});
}

static void keys_do_what_the_window_says(void)
{
    struct live *live = live_of(4, LOG, BACKWARD_EULER);
    const struct live_setting *set = &live->set;
    press(live, "lisp");
    ck_assert(set->law == CUBIC && live->body->material.law == CUBIC);
    ck_assert(set->method == IMPLICIT_MIDPOINT && set->start == ROWS);
    ck_assert(!set->fallback && set->grab == PATCH && set->n == 4);
    press(live, "s");
    ck_assert(set->start == LAST_STATE);
    press(live, "lisp");
    ck_assert(set->law == LOG && live->body->material.law == LOG);
    ck_assert(set->method == BACKWARD_EULER && set->start == ELASTIC);
    ck_assert(set->fallback);
    press(live, "gg.");
    ck_assert(set->grab == PATCH);

    const int n[] = {4, 8, 16, 32, 64, 64, 32, 16, 8, 4, 2, 2};
    for (int k = 1; k < COUNT(n); k++) {
        live->now.u[live->n_dof - 1] = 0.01;
        press(live, k < 6 ? "+" : "-");
        ck_assert_int_eq(set->n, n[k]);
        ck_assert_int_eq(live->mesh->n, n[k]);
        ck_assert(n[k] == n[k - 1] || live->now.u[live->n_dof - 1] == 0.0);
    }
    play_all(live, pointers_pull(1.0), 9);
    ck_assert(live->holding && fabs(live->now.u[live->n_dof - 2]) > 0.1);
    play(live, (struct pointer){1.9, 0.0, 1, 'r'}); /* there is nothing now */
    ck_assert(!live->holding && set->n == 2);
    for (int r = 0; r < live->n_dof; r++)
        ck_assert(live->now.u[r] == 0.0 && live->now.v[r] == 0.0);
    live_free(live);
}

/* The law without inverted triangles cannot take over a body that has some. */
static void a_plain_body_has_plain_successors(void)
{
    struct live *live = live_of(8, LOG, BACKWARD_EULER);
    ck_assert_int_eq(live->body->K->storage, BANDED);
    body_store(live->body, PLAIN);
    for (const char *key = ".lr+-."; *key; key++) {
        const struct pointer pointer = {1.0, 1.0, key[1] != '\0', *key};
        live_input(live, &pointer);
        ck_assert_int_eq(live->body->K->storage, PLAIN);
        struct matrix *K = body_matrix(live->body);
        ck_assert_int_eq(K->storage, PLAIN);
        ck_assert_uint_eq(K->size, live->body->K->size);
        matrix_free(K);
    }
    live_free(live);
}

static void a_law_is_not_given_what_it_cannot_have(void)
{
    struct live *live = live_of(4, CUBIC, BACKWARD_EULER);
    const int n = live->mesh->n_vertex;
    for (int a = 0; a < n; a++)
        live->now.u[2 * a] = -1.5 * live->mesh->X[2 * a];
    press(live, "l");
    ck_assert(live->set.law == CUBIC && live->body->material.law == CUBIC);
    press(live, "rl");
    ck_assert(live->set.law == LOG);
    live_free(live);
}

/* ---- a frame ------------------------------------------------------------- */

/* The lift by the exact K leaves a q of second order in the jump; where
 * nothing jumps it is a step of Newton's method. */
static void a_lift_solves_the_linear_problem(void)
{
    struct live *live = live_of(6, CUBIC, BACKWARD_EULER);
    const int n = live->n_dof;
    double *u = allocate(5 * (size_t)n, sizeof *u), *w = u + n, *u0 = w + n;
    double *g = u0 + n, *q = g + n, left[2];
    play_all(live, pointers_hard(), 9);
    memcpy(u0, live->now.u, (size_t)n * sizeof *u0);
    const struct step_control newton = step_method("demand+search");
    const struct incremental Phi = {live->dt, w, NULL};
    ck_assert_int_eq(step_solve(live->body, &newton, Phi, u0).status, OK);
    for (int k = 0; k < 2; k++) {
        const double jump = 0.01 / (1 + k);
        for (int r = 0; r < n; r++)
            g[r] = live->body->equation[r] >= 0 ? NAN
                   : live->mesh->X[r / 2 * 2] > -1.0
                       ? u0[r] + (r % 2 ? -0.3 : 1.0) * jump
                       : 0.0;
        ck_assert_int_eq(live_lift(live->body, Phi, u0, g, EXACT, u), OK);
        for (int r = 0; r < n; r++)
            if (live->body->equation[r] < 0) close_to(u[r], g[r], 1e-14);
        left[k] = residual(live, w, u);
    }
    close_to(left[0] / left[1], 4.0, 0.15);

    for (int r = 0; r < n; r++) w[r] = u0[r] + 0.1 * sin(2.385 * r);
    for (int kind = EXACT; kind <= PROJECTED; kind++) {
        const enum tangent tangent = (enum tangent)kind;
        body_assemble(live->body, Phi, u0, tangent, q);
        ck_assert_int_eq(body_increment(live->body, live->body->K, q, g), OK);
        ck_assert_int_eq(live_lift(live->body, Phi, u0, u0, tangent, u), OK);
        for (int r = 0; r < n; r++) close_to(u[r], u0[r] + g[r], 1e-9);
    }
    free(u);
    live_free(live);
}

static void a_lift_refuses_what_cannot_be(void)
{
    struct live *live = live_of(4, LOG, BACKWARD_EULER);
    const int n = live->n_dof;
    double *u = allocate(3 * (size_t)n, sizeof *u), *w = u + n, *u0 = w + n;
    for (int r = 0; r < n; r++) w[r] = 5.0;
    struct incremental Phi = {live->dt, w, NULL};
    ck_assert_int_eq(live_lift(live->body, Phi, u0, u0, EXACT, u),
                     NONFINITE); /* farther than LIVE_LEAP */
    Phi.w = u0;
    for (int r = 0; r < n; r += 2) u0[r] = -1.5 * live->mesh->X[r];
    ck_assert_int_eq(live_lift(live->body, Phi, u0, u0, EXACT, u),
                     INVERTED);
    live->body->material = material_notes(CUBIC);
    for (int r = 0; r < n; r++) u0[r] = 0.9 * sin(2.385 * r * r);
    ck_assert_int_eq(live_lift(live->body, Phi, u0, u0, EXACT, u),
                     NOT_SPD);
    ck_assert_int_ne(live_lift(live->body, Phi, u0, u0, PROJECTED, u),
                     NOT_SPD);
    free(u);
    live_free(live);
}

/* Phi of the next frame, without its constant. */
static double phi(const struct live *live, const double u[])
{
    const int n = live->n_dof;
    double *move = allocate(2 * (size_t)n, sizeof *move), *p = move + n;
    double sum = 0.0, energy = NAN;
    for (int r = 0; r < n; r++)
        move[r] = u[r] - live->now.u[r] - live->dt * live->now.v[r];
    body_mass(live->body, move, p);
    for (int r = 0; r < n; r++) sum += 0.5 * move[r] * p[r];
    ck_assert_int_eq(body_energy(live->body, u, &energy), OK);
    free(move);
    return sum + live->dt * live->dt * energy;
}

/* By lesson 14's fallback some frames of `hard` are lost, and then the hand and
 * the state stay; else both arrive. */
static void in_parts_the_hand_waits(void)
{
    struct live *live = live_of(8, LOG, BACKWARD_EULER);
    struct pointers hard = pointers_hard();
    int lost = 0;
    for (int k = 0; k < hard.n; k++) {
        double to[2], before[2];
        begin_frame(live, &hard.frame[k], to);
        memcpy(before, live->hand, sizeof before);
        const double was = live_energy(live);
        const struct live_report report = live_frame_in_parts(live, to);
        const int failed = strcmp(report.rung, "lost") == 0;
        ck_assert_int_eq(failed, report.status != OK);
        ck_assert_mem_eq(live->hand, failed ? before : to, sizeof to);
        if (failed) ck_assert(live_energy(live) == was && report.part == 0.0);
        for (int r = 0; r < live->n_dof && !failed; r++)
            if (live->body->equation[r] < 0)
                close_to(live->now.u[r], live->g[r], 1e-13);
        ck_assert_int_gt(report.systems, 0);
        lost += failed;
    }
    ck_assert(lost > 0 && lost < hard.n);
    pointers_free(&hard);
    live_free(live);
}

/* A lift is a start where Phi is not above that of leaving the body where it
 * is, or where that is not to be had. */
static void a_start_is_better_than_none(void)
{
    int taken = 0, refused = 0, undefined = 0, alone = 0;
    for (int law = LOG; law <= CUBIC; law++) {
        struct live *live = live_of(8, (enum law)law, BACKWARD_EULER);
        struct pointers hard = pointers_hard();
        const int n = live->n_dof;
        double *u = allocate(4 * (size_t)n, sizeof *u), *lift = u + n;
        double *left = lift + n, *w = left + n;
        const struct incremental Phi = {live->dt, w, NULL};
        for (int k = 0; k < 100; k++) {
            double to[2], energy;
            begin_frame(live, &hard.frame[k], to);
            for (int r = 0; r < n; r++) {
                w[r] = live->now.u[r] + live->dt * live->now.v[r];
                left[r] = live->body->equation[r] < 0 ? live->g[r]
                                                      : live->now.u[r];
            }
            if (live_lift(live->body, Phi, live->now.u, live->g, PROJECTED,
                          lift) != OK) continue;
            for (int far = 1; far <= 16; far *= 4) { /* too far, or not */
                for (int r = 0; r < n; r++)
                    u[r] = left[r] + far * (lift[r] - left[r]);
                const enum status status = live_start(live, Phi, live->g, u);
                if (body_energy(live->body, u, &energy) != OK) {
                    ck_assert_int_eq(status, INVERTED);
                    undefined++;
                } else if (body_energy(live->body, left, &energy) != OK) {
                    ck_assert_int_eq(status, OK);
                    alone++;
                } else {
                    const int worse = phi(live, u) > phi(live, left);
                    ck_assert_int_eq(status, worse ? STALLED : OK);
                    refused += worse;
                    taken += !worse;
                }
            }
            live_frame(live, to);
        }
        pointers_free(&hard);
        free(u);
        live_free(live);
    }
    ck_assert(taken > 0 && refused > 0 && undefined > 0 && alone > 0);

    /* a body that flies: going along strains it, and yet Phi is less */
    struct live *live = live_of(2, CUBIC, BACKWARD_EULER);
    double u[18] = {0.0}, g[18] = {0.0}, w[18] = {0.0}, energy;
    for (int r = 0; r < live->n_dof; r += 2) {
        const int free_to_go = live->body->equation[r] >= 0;
        live->now.v[r] = free_to_go;
        w[r] = free_to_go * live->dt;
        u[r] = 0.5 * w[r];
    }
    ck_assert(body_energy(live->body, u, &energy) == OK && energy > 0.0);
    const struct incremental Phi = {live->dt, w, NULL};
    ck_assert_int_eq(live_start(live, Phi, g, u), OK);
    live_free(live);
}

/* Every frame of `hard` by the second rung: it ends where it says. */
static void downhill_goes_down(void)
{
    int whole = 0, back = 0, stopped = 0, unfinished = 0;
    for (int law = LOG; law <= CUBIC; law++) {
        struct live *live = live_of(8, (enum law)law, BACKWARD_EULER);
        struct pointers hard = pointers_hard();
        const int n = live->n_dof;
        double *u = allocate(3 * (size_t)n, sizeof *u), *v = u + n, *w = v + n;
        for (int k = 0; k < hard.n; k++) {
            const int used = k % FRAME_SYSTEMS; /* by the rung before */
            struct live_report report = {.systems = used};
            double to[2];
            begin_frame(live, &hard.frame[k], to);
            for (int r = 0; r < n && k % 2; r++)
                if (live->body->equation[r] >= 0)
                    live->now.v[r] += 2.0 * sin(2.385 * r);
            const enum status status = live_downhill(live, u, v, &report);
            const double part = report.part;
            if (used == FRAME_SYSTEMS - 1) ck_assert(part == 0.0); /* no lift */
            ck_assert_int_gt(report.systems, used);
            ck_assert_int_le(report.systems, FRAME_SYSTEMS);
            if (status == MAX_ITERATIONS)
                ck_assert_int_eq(report.systems, FRAME_SYSTEMS);
            ck_assert(status == OK || status == MAX_ITERATIONS ||
                      status == STALLED);
            for (int r = 0; r < n; r++) {
                w[r] = live->now.u[r] + live->dt * live->now.v[r];
                close_to(v[r], status == OK && part == 1.0
                                   ? (u[r] - live->now.u[r]) / live->dt
                                   : 0.0, 1e-300);
                if (live->body->equation[r] < 0)
                    close_to(u[r], live->now.u[r] +
                                       part * (live->g[r] - live->now.u[r]),
                             1e-13);
            }
            if (status == OK) ck_assert(solved(live, w, u));
            if (part == 0.0) ck_assert(phi(live, u) <= phi(live, live->now.u));
            whole += part == 1.0;
            back += part > 0.0 && part < 1.0;
            stopped += part == 0.0;
            unfinished += status == MAX_ITERATIONS;
            live_frame(live, to);
        }
        pointers_free(&hard);
        free(u);
        live_free(live);
    }
    ck_assert(whole > 0 && back > 0 && stopped > 0 && unfinished > 0);
}

static enum status no_lift(struct body *body, struct incremental Phi,
                           const double u0[], const double g[],
                           enum tangent tangent, double u[])
{
    (void)body, (void)Phi, (void)u0, (void)g, (void)tangent, (void)u;
    return STALLED;
}

static enum status no_rung(struct live *live, double u[], double v[],
                           struct live_report *report)
{
    for (int r = 0; r < live->n_dof; r++) u[r] = v[r] = NAN;
    report->part = 0.0;
    return NONFINITE;
}

/* Backward Euler, the midpoint rule and the fallback are what they are said to
 * be. */
static void a_frame_goes_down_the_rungs(void)
{
    struct live *live = live_of(4, LOG, BACKWARD_EULER);
    const int n = live->n_dof;
    const size_t size = (size_t)n * sizeof(double);
    double *u = allocate(3 * (size_t)n, sizeof *u), *v = u + n, *w = v + n;
    const double to[2] = {1.2, 0.2};
    play(live, (struct pointer){1.0, 0.0, 1, '.'});
    for (int midpoint = 0; midpoint < 2; midpoint++) {
        const double d = midpoint ? 0.5 * live->dt : live->dt;
        memcpy(u, live->now.u, size);
        memcpy(v, live->now.v, size);
        const struct live_report report =
            play(live, (struct pointer){1.1, 0.1 + 0.05 * midpoint, 1, '.'});
        ck_assert_int_eq(report.status, OK);
        ck_assert_str_eq(report.first, "OK");
        ck_assert_str_eq(report.rung, "fast");
        ck_assert_int_ge(report.systems, 1 + (live->set.start == ELASTIC));
        ck_assert_int_le(report.systems, FAST_SYSTEMS);
        double end[50], star;
        for (int r = 0; r < n; r++) {
            star = midpoint ? 0.5 * (u[r] + live->now.u[r]) : live->now.u[r];
            w[r] = u[r] + d * v[r];
            end[r] = star;
            if (live->body->equation[r] < 0)
                close_to(live->now.u[r], live->g[r], 1e-13);
            close_to(live->now.v[r], midpoint
                         ? 2.0 * (star - u[r]) / d - v[r] : (star - u[r]) / d,
                     1e-9);
        }
        live->dt = d;
        ck_assert(solved(live, w, end));
        live->dt = 1.0 / 30.0;
        live->set.method = IMPLICIT_MIDPOINT;
    }
    memcpy(u, live->now.u, size);
    memcpy(v, live->now.v, size);
    const double from[2] = {live->hand[0], live->hand[1]};
    struct live_report report = live_frame_by(live, no_lift, no_rung, to);
    ck_assert_str_eq(report.rung, "lost");
    ck_assert_str_eq(report.first, "STALLED");
    ck_assert_int_eq(report.status, NONFINITE);
    ck_assert_mem_eq(u, live->now.u, size);
    ck_assert_mem_eq(v, live->now.v, size);
    ck_assert(live->hand[0] == from[0] && live->hand[1] == from[1]);
    report = live_frame_by(live, no_lift, live_downhill, to);
    ck_assert_str_eq(report.rung, "downhill");
    ck_assert_str_eq(report.first, "STALLED");
    ck_assert_int_eq(report.status, OK);
    live->set.fallback = 0;
    report = live_frame_by(live, no_lift, live_downhill, to);
    ck_assert_str_eq(report.rung, "lost");
    free(u);
    live_free(live);
}

/* After a frame downhill that took more than CALM_SYSTEMS the next begins
 * downhill, with all of the budget; in calm, and without a fallback, with
 * `fast`. */
static void trouble_lasts(void)
{
    struct live *live = live_of(8, CUBIC, BACKWARD_EULER);
    struct pointers hard = pointers_hard();
    int trouble = 0, times = 0, ends = 0;
    for (int k = 0; k < hard.n; k++) {
        const struct live_report report = play(live, hard.frame[k]);
        const int untried = strcmp(report.first, "untried") == 0;
        ck_assert_int_eq(untried, trouble);
        if (untried) ck_assert_str_eq(report.rung, "downhill");
        times += untried;
        trouble = strcmp(report.rung, "downhill") == 0 &&
                  report.systems > CALM_SYSTEMS;
        ends += untried && !trouble;
    }
    ck_assert(times > ends && ends > 0);
    live->trouble = 1;
    live->set.fallback = 0;
    struct live_report report = play(live, hard.frame[hard.n - 1]);
    ck_assert_str_eq(report.rung, "fast");
    live->set.fallback = 1;
    report = play(live, hard.frame[hard.n - 1]);
    ck_assert_str_eq(report.first, "untried");
    live->trouble = 1;
    report = play(live, (struct pointer){0.0, 0.0, 0, 'r'});
    ck_assert_str_eq(report.rung, "fast");
    pointers_free(&hard);
    live_free(live);
}

/* A doubled state that LOG does not have is not accepted. */
static void midpoint_is_asked_for_its_J(void)
{
    for (double speed = 5.0; speed < 80.0; speed += 5.0) {
        struct live *live = live_of(2, LOG, IMPLICIT_MIDPOINT);
        live->set.start = LAST_STATE;
        live->set.fallback = 0;
        for (int r = 0; r < live->n_dof; r += 2)
            live->now.v[r] = -speed * (1.0 + live->mesh->X[r]);
        for (int k = 0; k < 20; k++) {
            play(live, (struct pointer){0.0, 0.0, 0, '.'});
            ck_assert(body_min_J(live->body, live->now.u) > 0.0);
        }
        live_free(live);
    }
}

/* ---- what is looked at --------------------------------------------------- */

static void knots_are_seen(void)
{
    struct mesh *mesh = mesh_square(4);
    double u[50] = {0.0};
    int knot[25];
    ck_assert_int_eq(live_knots(mesh, u, knot), 0);
    /* the angle z about the middle becomes f(z), which goes round twice */
    const double z[] = {0.0, 0.25, 0.5, 1.0, 1.25, 1.5, 2.0};
    for (int a = 0; a < 25; a++) {
        const double *X = &mesh->X[2 * a];
        const double far = fmax(fabs(X[0]), fabs(X[1]));
        double angle = atan2(X[1], X[0]) / M_PI;
        if (angle < 0.0) angle += 2.0;
        int k = 0;
        while (angle >= z[k + 1]) k++;
        const double f = 2.0 * M_PI / 3.0 *
                         (k + (angle - z[k]) / (z[k + 1] - z[k]));
        u[2 * a] = far * cos(f) - X[0];
        u[2 * a + 1] = far * sin(f) - X[1];
    }
    ck_assert_int_eq(live_knots(mesh, u, knot), 1);
    for (int a = 0; a < 25; a++) ck_assert_int_eq(knot[a], a == 12);
    for (int a = 0; a < 25; a++) { /* a mirror */
        u[2 * a] = 0.0;
        u[2 * a + 1] = -2.0 * mesh->X[2 * a + 1];
    }
    ck_assert_int_eq(live_knots(mesh, u, knot), 9);
    mesh_free(mesh);
}

static void energy_is_motion_and_strain(void)
{
    struct live *live = live_of(4, LOG, BACKWARD_EULER);
    double psi;
    close_to(live_energy(live), 0.0, 1e-12);
    for (int r = 0; r < live->n_dof; r += 2) live->now.v[r] = 3.0;
    close_to(live_energy(live), 0.5 * 4.0 * 9.0, 1e-11);
    for (int r = 0; r < live->n_dof; r += 2)
        live->now.u[r] = 0.1 * (1.0 + live->mesh->X[r]);
    body_energy(live->body, live->now.u, &psi);
    close_to(live_energy(live), 18.0 + psi, 1e-10);
    for (int r = 0; r < live->n_dof; r += 2)
        live->now.u[r] = -1.5 * live->mesh->X[r];
    ck_assert(isnan(live_energy(live)));
    live_free(live);
}

/* ---- pointer.h ----------------------------------------------------------- */

static void scripts_are_what_they_are_called(void)
{
    struct pointers pull = pointers_pull(-3.0), hard = pointers_hard();
    struct pointers mad_one = pointers_mad(7, 500), again, other;
    ck_assert_int_eq(pull.n, 60);
    close_to(pull.frame[0].x, 1.0, 1e-15);
    for (int k = 0; k < pull.n; k++) {
        ck_assert(pull.frame[k].y == 0.0 && pull.frame[k].down == 1);
        ck_assert_int_eq(pull.frame[k].key, '.');
    }
    close_to(pull.frame[31].x - pull.frame[30].x, -0.1, 1e-12);
    close_to(pull.frame[59].x, -3.0, 1e-12);
    ck_assert_int_eq(hard.n, 300);
    for (int k = 0; k < hard.n; k++)
        ck_assert_int_eq(hard.frame[k].down, k < 180);
    close_to(hard.frame[10].x, 1.6, 1e-12);
    close_to(hard.frame[115].x, -1.8 + 3.4 * 5.0 / 6.0, 1e-12);
    again = pointers_mad(7, 500);
    other = pointers_mad(8, 500);
    ck_assert_int_eq(mad_one.n, 620);
    int down = 0, different = 0;
    double most = 0.0;
    for (int k = 0; k < mad_one.n; k++) {
        const struct pointer *p = &mad_one.frame[k], *q = &again.frame[k];
        ck_assert(p->x == q->x && p->y == q->y && p->down == q->down &&
                  p->key == q->key);
        down += p->down;
        different += p->x != other.frame[k].x;
        if (k > 0) most = fmax(most, fabs(p->x - p[-1].x));
        ck_assert(k < 500 || !p->down);
    }
    ck_assert(down > 100 && different > 400 && most > 1.0);
    pointers_free(&pull);
    pointers_free(&hard);
    pointers_free(&mad_one);
    pointers_free(&again);
    pointers_free(&other);
    ck_assert(other.n == 0 && !other.frame);
}

/* Nine in ten wait where the body's end is, until they want to be elsewhere. */
static void mad_hands_begin_at_the_end_of_the_body(void)
{
    int waiting = 0;
    for (int seed = 1; seed <= 20; seed++) {
        struct pointers mad_one = pointers_mad(seed, 1);
        const struct pointer *p = &mad_one.frame[0];
        waiting += p->x == 1.0 && p->y == 0.0;
        pointers_free(&mad_one);
    }
    ck_assert_int_ge(waiting, 15);
}

static char path[64];

/* What is written and read again is the same, and so are all states. */
static void a_replay_is_the_same(void)
{
    struct live *live[2];
    struct pointers input[2] = {pointers_mad(3, 150), {0, NULL}};
    snprintf(path, sizeof path, "/tmp/live.%ld", (long)getpid());
    for (int k = 0; k < 8; k++)
        input[0].frame[9 + 20 * k].key = POINTER_KEYS[1 + k];
    pointers_write(&input[0], path);
    input[1] = pointers_named(path, 0.0, 0);
    remove(path);
    ck_assert_int_eq(input[0].n, input[1].n);
    for (int i = 0; i < 2; i++) live[i] = live_of(6, CUBIC, BACKWARD_EULER);
    for (int k = 0; k < input[0].n; k++) {
        for (int i = 0; i < 2; i++) play(live[i], input[i].frame[k]);
        const size_t size = (size_t)live[0]->n_dof * sizeof(double);
        ck_assert_int_eq(live[0]->n_dof, live[1]->n_dof);
        ck_assert_mem_eq(live[0]->now.u, live[1]->now.u, size);
        ck_assert_mem_eq(live[0]->now.v, live[1]->now.v, size);
    }
    for (int i = 0; i < 2; i++) {
        live_free(live[i]);
        pointers_free(&input[i]);
    }
}

static void read_it(void)
{
    struct pointers all = pointers_named(path, 0.0, 0);
    printf("%d", all.n);
    pointers_free(&all);
}

static void bad_lines_are_named(void)
{
    char text[400], want[200], name[40] = "", far[300];
    memset(far, '1', sizeof far);
    far[sizeof far - 1] = '\0';
    static const char *const bad[] = {
        "0 0 1",   "0 0 1 x",   "0 0 2 .", "0 0 -1 .", "nan 0 1 .", "a 0 1 .",
        "0 inf 1 .", "0 0 1 . 4", "",      "0 0 4294967297 .", "0 0 1 .."};
    snprintf(name, sizeof name, "/tmp/live.%ld", (long)getpid());
    for (int k = 0; k < COUNT(bad) + 3; k++) {
        snprintf(text, sizeof text, "0.5 -0.25 1 l\n%s\n0 0 0 .\n",
                 k < COUNT(bad) ? bad[k] : far);
        FILE *file = fopen(name, "w");
        if (k == COUNT(bad) + 1)
            snprintf(text, sizeof text, "%s", "");
        ck_assert(file && fputs(text, file) >= 0 && fclose(file) == 0);
        snprintf(path, sizeof path, "%s%s", name,
                 k == COUNT(bad) + 2 ? ".no" : "");
        const struct outcome end = outcome_of(read_it);
        snprintf(want, sizeof want, "error: %s: %s", path,
                 k < COUNT(bad)        ? "line 2 must be: x y down key"
                 : k == COUNT(bad)     ? "line 2 is longer than 126 characters"
                 : k == COUNT(bad) + 1 ? "has no line"
                                       : "No such file");
        ck_assert_msg(end.status == 2, "%d: status %d", k, end.status);
        ck_assert_msg(strncmp(end.err, want, strlen(want)) == 0, "%d: %s", k,
                      end.err);
        ck_assert(strchr(end.err, '\n') == end.err + strlen(end.err) - 1);
        ck_assert_str_eq(end.out, "");
    }
    FILE *file = fopen(name, "w"); /* the last newline may be missing */
    ck_assert(file && fputs("0 0 1 .\n1e1\t.5 0 +", file) >= 0 &&
              fclose(file) == 0);
    snprintf(path, sizeof path, "%s", name);
    ck_assert_str_eq(outcome_of(read_it).out, "2");
    remove(name);
    snprintf(path, sizeof path, "a\nb");
    ck_assert_str_eq(outcome_of(read_it).err,
                     "error: a?b: No such file or directory\n");
}

static void write_pull(void)
{
    struct pointers pull = pointers_named("pull", 1.0, 1);
    pointers_write(&pull, path);
    pointers_free(&pull);
}

static void write_without_an_input(void)
{
    close(STDIN_FILENO); /* the file will be number 0 */
    write_pull();
}

static void write_within_a_limit(void)
{
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){500, 500});
    write_pull();
}

/* In a folder of its own: a file that is there keeps its permissions, what is
 * called like it is not touched, a pipe and a link stay what they are. */
static void only_a_file_is_replaced(void)
{
    char folder[] = "/tmp/live.XXXXXX", text[99] = "";
    const char *const name[] = {"new", "new.part", "old", "link", "pipe"};
    const mode_t mask = umask(027);
    struct stat is;
    ck_assert(mkdtemp(folder) && chdir(folder) == 0);
    for (int k = 1; k < 3; k++) {
        FILE *file = fopen(name[k], "w");
        ck_assert(file && fputs("kept\n", file) >= 0 && fclose(file) == 0);
    }
    ck_assert(chmod("old", 0604) == 0 && symlink("old", "link") == 0 &&
              mkfifo("pipe", 0600) == 0);
    const int reader = open("pipe", O_RDONLY | O_NONBLOCK);
    for (int k = 0; k < 5; k++) {
        if (k == 1) continue;
        snprintf(path, sizeof path, "%s", name[k]);
        ck_assert_int_eq(
            outcome_of(k ? write_pull : write_without_an_input).status, 0);
        ck_assert_int_eq(lstat(path, &is), 0);
        ck_assert_msg(k == 3   ? S_ISLNK(is.st_mode)
                      : k == 4 ? S_ISFIFO(is.st_mode)
                               : (is.st_mode & 0777) == (k ? 0604 : 0640),
                      "%s: mode %o", path, (unsigned)is.st_mode);
    }
    ck_assert(read(reader, text, 8) == 8 && strcmp(text, "1 0 1 .\n") == 0);
    close(reader);
    snprintf(path, sizeof path, "old");
    ck_assert_str_eq(outcome_of(read_it).out, "60");
    FILE *file = fopen("new.part", "r");
    ck_assert(file && fgets(text, sizeof text, file) && fclose(file) == 0);
    ck_assert_str_eq(text, "kept\n");
    for (int k = 0; k < 5; k++) remove(name[k]);
    umask(mask);
    ck_assert(chdir("/") == 0);
    ck_assert_msg(rmdir(folder) == 0, "%s has other files", folder);
}

static void a_record_beyond_a_limit_leaves_nothing(void)
{
    char folder[] = "/tmp/live.XXXXXX";
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a\nb", folder);
    const struct outcome end = outcome_of(write_within_a_limit);
    ck_assert_int_eq(end.status, 1);
    ck_assert_ptr_nonnull(strstr(end.err, "/a?b cannot be written: "));
    ck_assert(strchr(end.err, '\n') == end.err + strlen(end.err) - 1);
    ck_assert_msg(rmdir(folder) == 0, "%s has a file", folder);
}

static void what_cannot_be_written_is_said(void)
{
    snprintf(path, sizeof path, "/there/is/none");
    const struct outcome end = outcome_of(write_pull);
    ck_assert_int_eq(end.status, 1);
    ck_assert_str_eq(end.err, "error: /there/is/none cannot be written: "
                              "No such file or directory\n");
    for (int k = 0; k < 2; k++) {
        struct pointers some = pointers_named(k ? "mad" : "hard", 1.0, 1);
        ck_assert_int_eq(some.n, k ? 720 : 300);
        pointers_free(&some);
    }
}

UNIT_MAIN("live",
    LAW(a_hand_is_bounded),
    LAW(a_hand_takes_what_is_near),
    LAW(a_hand_takes_a_side),
    LAW(keys_do_what_the_window_says),
    LAW(a_plain_body_has_plain_successors),
    LAW(a_law_is_not_given_what_it_cannot_have),
    LAW(a_lift_solves_the_linear_problem),
    LAW(a_lift_refuses_what_cannot_be),
    LAW(a_start_is_better_than_none),
    LAW(downhill_goes_down),
    LAW(a_frame_goes_down_the_rungs),
    LAW(trouble_lasts),
    LAW(midpoint_is_asked_for_its_J),
    LAW(knots_are_seen),
    LAW(energy_is_motion_and_strain),
    LAW(scripts_are_what_they_are_called),
    LAW(in_parts_the_hand_waits),
    LAW(mad_hands_begin_at_the_end_of_the_body),
    LAW(a_replay_is_the_same),
    LAW(bad_lines_are_named),
    LAW(what_cannot_be_written_is_said),
    LAW(only_a_file_is_replaced),
    LAW(a_record_beyond_a_limit_leaves_nothing))
