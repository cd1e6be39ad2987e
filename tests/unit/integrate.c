/* integrate.c - laws of common/motion/model.h, integrate.h and user.h. */
#include "figures/14_time_step/frequency.h"
#include "figures/14_time_step/swing.h"
#include "motion/integrate.h"
#include "motion/user.h"

#include "unit.h"

#include "../oracle/time_step.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers without a pattern, in (-1, 1). */
static double entropy(int i) { return sin(2.385 * i * i + 3.714 * i + 0.7); }

/* The square, left side held or (ends is 2) both; for forget(). */
static struct model *square(int n, enum law law, enum mass mass, int ends)
{
    struct mesh *mesh = mesh_square(n);
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = a % (n + 1) == 0 || (ends == 2 && a % (n + 1) == n);
    struct body *body = body_alloc(mesh, material_notes(law), 1.0, mass, held);
    free(held);
    return model_body(body);
}

static void forget(struct model *model)
{
    struct body *body = model->body;
    struct mesh *mesh = body ? (struct mesh *)body->mesh : NULL;
    model_free(model);
    body_free(body);
    if (mesh) mesh_free(mesh);
}

/* A state of the free vertices, u of this size. */
static struct state a_state(const struct model *model, double size)
{
    struct state s = state_make(model->n_dof);
    for (int i = 0; i < s.n; i++) {
        if (model->body && model->body->equation[i] < 0) continue;
        s.u[i] = size * entropy(i);
        s.v[i] = 20.0 * size * entropy(i + 100);
    }
    return s;
}

/* ---- model.h ------------------------------------------------------------- */

static void fastest_frequencies_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_bar); k++)
        for (int mass = CONSISTENT; mass <= LUMPED; mass++) {
            struct model *model = model_bar(oracle_bar[k].n, (enum mass)mass);
            const double dt = 2.0 / frequency_largest(model);
            close_to(dt / oracle_bar[k].dt[mass], 1.0, 1e-9);
            ck_assert(dt >= oracle_bar[k].bound[mass]);
            ck_assert(!mass || ceil(1.0 / 30.0 / dt) == oracle_bar[k].a_frame);
            forget(model);
        }
    for (int k = 0; k < COUNT(oracle_square); k++)
        for (int mass = CONSISTENT; mass <= LUMPED; mass++) {
            struct model *model =
                square(oracle_square[k].n, CUBIC, (enum mass)mass, 2);
            const double omega = frequency_largest(model);
            close_to(omega / oracle_square[k].omega[mass], 1.0, 1e-9);
            close_to(2.0 / omega / oracle_square[k].dt[mass], 1.0, 1e-9);
            ck_assert(!mass ||
                      ceil(omega / 60.0) == oracle_square[k].a_frame);
            forget(model);
        }
    struct model *mode = model_mode(2.385);
    close_to(frequency_largest(mode), 2.385, 1e-12);
    model_free(mode);
}

static struct model *some_model(int kind)
{
    if (kind == 0) return model_mode(2.385);
    if (kind == 1) return model_bar(7, CONSISTENT);
    return square(3, CUBIC, CONSISTENT, kind - 1);
}

/* dPsi/du - f is the slope of the energy; v.M v / 2 its other part. */
static void forces_are_the_slope_of_the_energy(void)
{
    for (int kind = 0; kind < 4; kind++) {
        struct model *model = some_model(kind);
        struct state s = a_state(model, 0.05);
        double *force = s.u_before;
        for (int i = 0; i < s.n; i++) model->f[i] = 31.0 * entropy(i + 7);
        ck_assert_int_eq(model_force(model, s.u, force), OK);
        for (int i = 0; i < s.n; i++) {
            const double step = 1e-4, u = s.u[i];
            s.u[i] = u + step;
            const double up = model_energy(model, s.u, s.v);
            s.u[i] = u - step;
            const double down = model_energy(model, s.u, s.v);
            s.u[i] = u; /* third derivatives of 1e5, and round-off */
            close_to((up - down) / (2.0 * step), force[i] - model->f[i], 1e-3);
        }
        memset(model->f, 0, (size_t)s.n * sizeof *model->f);
        memset(s.u, 0, (size_t)s.n * sizeof *s.u);
        close_to(model_energy(model, s.u, s.v),
                 0.5 * pow(swing_norm(model, s.v), 2.0), 1e-12);
        state_free(&s);
        forget(model);
    }
}

static void acceleration_is_the_force_over_the_mass(void)
{
    for (int kind = 0; kind < 4; kind++) {
        struct model *model = some_model(kind);
        struct state s = a_state(model, 1.0);
        model_mass(model, s.u, s.v);
        model_accelerate(model, s.v); /* M^-1 M u, u 0 where it is held */
        for (int i = 0; i < s.n; i++) close_to(s.v[i], s.u[i], 1e-12);
        state_free(&s);
        forget(model);
    }
}

/* (M + dt^2 A) x = -q, when dt changes as well. */
static void newton_is_exact_at_every_step(void)
{
    struct model *model = model_bar(7, CONSISTENT);
    const double dt[] = {0.01, 0.01, 0.02385, 0.01};
    for (int k = 0; k < COUNT(dt); k++) {
        double q[7], x[7], Mx[7], Ax[7];
        for (int i = 0; i < 7; i++) q[i] = x[i] = entropy(i + k);
        const struct step_report report = model_newton(model, dt[k], x);
        ck_assert(report.status == OK && report.iterations == 1);
        ck_assert_int_eq(report.factorisations, k != 1);
        model_mass(model, x, Mx);
        model_force(model, x, Ax);
        for (int i = 0; i < 7; i++)
            close_to(Mx[i] + dt[k] * dt[k] * Ax[i], -q[i], 1e-12);
    }
    forget(model);
}

/* A bar of negative stiffness: M - dt^2 A is definite for small dt alone, and
 * what failed is no factor for the next step. */
static void newton_names_what_is_not_definite(void)
{
    struct model *model = model_bar(7, CONSISTENT);
    struct matrix *A = matrix_copy(model->A);
    double q[7], x[7], Mx[7], Ax[7];
    matrix_combine(model->A, -2.0, model->A, A);
    matrix_free(model->A);
    model->A = A;
    for (int k = 0; k < 4; k++) {
        const double dt = k % 2 ? 1e-3 : 10.0;
        for (int i = 0; i < 7; i++) q[i] = x[i] = entropy(i);
        ck_assert_int_eq(model_newton(model, dt, x).status,
                         k % 2 ? OK : NOT_SPD);
        if (k % 2 == 0) continue;
        model_mass(model, x, Mx);
        model_force(model, x, Ax);
        for (int i = 0; i < 7; i++)
            close_to(Mx[i] + dt * dt * Ax[i], -q[i], 1e-12);
    }
    forget(model);
}

/* ---- integrate.h: a mode ------------------------------------------------- */

static void modes_lose_what_the_oracle_says(void)
{
    struct model *unit = model_mode(1.0);
    struct state s = state_make(1);
    s.u[0] = 1.0;
    for (int k = 0; k < COUNT(oracle_sequence); k++) {
        close_to(s.u[0], oracle_sequence[k][0], 1e-14);
        close_to(s.v[0], oracle_sequence[k][1], 1e-14);
        integrate_step(unit, BACKWARD_EULER, 1.0, NULL, &s);
    }
    ck_assert_int_eq(s.steps, COUNT(oracle_sequence));
    for (int k = 0; k < COUNT(oracle_step); k++) {
        s.u[0] = cos(0.7);
        s.v[0] = sin(0.7);
        integrate_step(unit, BACKWARD_EULER, oracle_step[k].w_dt, NULL, &s);
        close_to(hypot(s.u[0], s.v[0]), oracle_step[k].amplitude, 1e-14);
        close_to(oracle_step[k].energy, pow(oracle_step[k].amplitude, 2.0),
                 1e-14);
    }
    /* the bar's modes at 30 steps per second, and 1 % per period */
    for (int k = 0; k < COUNT(oracle_mode); k++) {
        struct model *mode = model_mode(oracle_mode[k].omega);
        const double dt = oracle_mode[k].dt_one_percent;
        s.u[0] = 1.0;
        s.v[0] = 0.0;
        integrate_step(mode, BACKWARD_EULER, 1.0 / 30.0, NULL, &s);
        const double left = hypot(s.u[0], s.v[0] / oracle_mode[k].omega);
        close_to(left, oracle_mode[k].a_frame, 1e-12);
        close_to(pow(left, 30.0) / oracle_mode[k].a_second, 1.0, 1e-10);
        close_to(oracle_mode[k].omega / (2.0 * M_PI), oracle_mode[k].hertz,
                 1e-12);
        s.u[0] = 1.0;
        s.v[0] = 0.0;
        integrate_step(mode, BACKWARD_EULER, dt, NULL, &s);
        const double one = hypot(s.u[0], s.v[0] / oracle_mode[k].omega);
        const double period = 2.0 * M_PI / atan(oracle_mode[k].omega * dt);
        close_to(pow(one, period), 0.99, 1e-9);
        model_free(mode);
    }
    /* q = 0 at the right end, -M u0 at the one as the notes print it */
    struct model *mode = model_mode(10.0);
    const double u0[] = {1.0}, v0[] = {0.0}, right[] = {oracle_right};
    const double printed[] = {oracle_printed};
    double q[1];
    integrate_residual(mode, 1.0 / 30.0, u0, v0, right, q);
    close_to(q[0], 0.0, 1e-15);
    integrate_residual(mode, 1.0 / 30.0, u0, v0, printed, q);
    close_to(q[0], -1.0, 1e-15);
    state_free(&s);
    model_free(unit);
    model_free(mode);
}

/* ---- integrate.h: the body ----------------------------------------------- */

/*
 * Defects in units of momentum, of a nonlinear body whose right side moves:
 *
 *     M (v+ - v0) + dt (dPsi/du(u*) - f)   u* = u+, u0 or half-way, BDF2's
 *                                          difference for v+ - v0
 */
static void steps_satisfy_their_formulas(void)
{
    struct model *model = square(4, CUBIC, CONSISTENT, 2);
    const double dt = 0.00247;
    const int n = model->n_dof;
    double *memory = allocate(4 * (size_t)n, sizeof *memory);
    double *g = memory, *d = g + n, *Md = d + n, *force = Md + n;
    for (int i = 0; i < n; i++) model->f[i] = 31.0 * entropy(i + 7);
    for (int m = 0; m < N_METHOD; m++) {
        struct state s = a_state(model, 0.02), old = state_make(n);
        for (int j = 1; j <= 3; j++) {
            const int two = m == BDF2 && j > 1;
            const int half = m == IMPLICIT_MIDPOINT || (m == BDF2 && j == 1);
            double *at = d; /* of the force */
            state_copy(&s, &old);
            ck_assert_int_eq(old.steps, j - 1);
            for (int a = 4; a < 25; a += 5) g[2 * a] = 0.02 * j;
            ck_assert_int_eq(
                integrate_step(model, (enum method)m, dt, g, &s).status, OK);
            for (int i = 0; i < n; i++) {
                const double u = s.u[i], u0 = old.u[i], v = s.v[i];
                const double du =
                    two ? (3.0 * u - 4.0 * u0 + old.u_before[i]) / 2.0 : u - u0;
                at[i] = half ? 0.5 * (u + u0) : m == SYMPLECTIC_EULER ? u0 : u;
                close_to(du, dt * (half ? 0.5 * (v + old.v[i]) : v), 1e-13);
                if (m != SYMPLECTIC_EULER && model->body->equation[i] < 0)
                    close_to(u, g[i], 1e-13);
            }
            model_force(model, at, force);
            for (int i = 0; i < n; i++)
                d[i] = two ? (3.0 * s.v[i] - 4.0 * old.v[i] +
                              old.v_before[i]) / 2.0
                           : s.v[i] - old.v[i];
            model_mass(model, d, Md);
            for (int i = 0; i < n; i++)
                if (model->body->equation[i] >= 0)
                    close_to(Md[i] + dt * (force[i] - model->f[i]), 0.0, 1e-7);
        }
        state_free(&s);
        state_free(&old);
    }
    free(memory);
    forget(model);
}

/* A step that does not exist, and a state that is not finite. */
static void a_failed_step_leaves_the_state(void)
{
    struct model *model = square(4, LOG, CONSISTENT, 2);
    struct state s = a_state(model, 0.01), start = a_state(model, 0.01);
    double *g = allocate(2 * (size_t)s.n, sizeof *g), *bad = g + s.n;
    for (int a = 4; a < 25; a += 5) g[2 * a] = -6.0;
    for (int m = BACKWARD_EULER; m < N_METHOD; m++)
        ck_assert_int_ne(
            integrate_step(model, (enum method)m, 1.0 / 30.0, g, &s).status,
            OK);
    for (int i = 0; i < s.n; i++) {
        bad[i] = i % 2 ? NAN : INFINITY;
        ck_assert_int_eq(state_accept(&s, g, bad), NONFINITE);
        ck_assert_int_eq(state_accept(&s, bad, g), NONFINITE);
        bad[i] = 0.0;
    }
    ck_assert_int_eq(s.steps, 0);
    for (int i = 0; i < s.n; i++)
        ck_assert(s.u[i] == start.u[i] && s.v[i] == start.v[i] &&
                  s.u_before[i] == 0.0 && s.v_before[i] == 0.0);
    double *longer = allocate((size_t)s.n + 1, sizeof *longer);
    longer[s.n] = NAN; /* which is no one's */
    ck_assert_int_eq(state_accept(&s, longer, longer), OK);
    free(longer);
    free(g);
    state_free(&s);
    state_free(&start);
    forget(model);
}

static void starts_are_at_rest_where_it_is_held(void)
{
    struct model *model = square(4, CUBIC, LUMPED, 2);
    struct body *body = model->body;
    struct state start[] = {state_ripple(model), swing_start(body, 0.3)};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < start[k].n; i++) {
            ck_assert(start[k].v[i] == 0.0);
            if (body->equation[i] < 0) ck_assert(start[k].u[i] == 0.0);
            if (body->equation[i] >= 0 && (k == 0 || i % 2))
                ck_assert(start[k].u[i] != 0.0);
        }
    close_to(start[1].u[2 * 12 + 1], 0.3, 1e-15);   /* the middle */
    close_to(start[1].u[2 * 13], 0.4 * 0.3, 1e-15); /* X1 = 1/2 */
    for (int k = 0; k < 2; k++) state_free(&start[k]);
    forget(model);
}

/* ---- a frame ------------------------------------------------------------- */

/* A frame that is OK does what it says, done by hand. */
static void same_by_hand(struct body *body, struct frame frame,
                         const double g[], const struct state *start,
                         const struct state *end)
{
    struct state s = state_make(start->n);
    double *part = allocate((size_t)s.n, sizeof *part);
    state_copy(start, &s);
    for (int k = 1; k <= frame.substeps; k++) {
        for (int i = 0; i < s.n; i++)
            part[i] = start->u[i] +
                      (double)k / frame.substeps * (g[i] - start->u[i]);
        const struct step_report report = step_backward_euler(
            body, frame.attempts == 1 ? &FAST : &ROBUST,
            1.0 / 30.0 / frame.substeps, part, NULL, s.u, s.v, s.v_before);
        ck_assert_int_eq(report.status, OK);
        if (frame.attempts == 1) {
            ck_assert_int_eq(report.iterations, frame.iterations);
            ck_assert_int_eq(report.factorisations, frame.factorisations);
        }
    }
    for (int i = 0; i < s.n; i++) {
        close_to(end->u[i], s.u[i], 1e-5);
        close_to(end->v[i], s.v[i], 1e-2);
    }
    free(part);
    state_free(&s);
}

/* The side is struck: some frames need ROBUST, some parts, some are lost. */
static void frames_fall_back_or_keep_the_state(void)
{
    struct model *model = square(8, LOG, CONSISTENT, 2);
    struct body *body = model->body;
    struct state start = a_state(model, 0.01), s = state_make(start.n);
    double *g = allocate((size_t)s.n, sizeof *g);
    int by[6] = {0}, lost = 0, cut = 0;
    for (double jump = -0.05; jump > -2.1; jump -= 0.0613) {
        state_copy(&start, &s);
        for (int a = 8; a < 81; a += 9) {
            g[2 * a] = jump;
            g[2 * a + 1] = 0.3;
        }
        const struct frame frame = integrate_frame(body, 1.0 / 30.0, g, &s);
        ck_assert((frame.attempts == 1) == (frame.first == OK));
        ck_assert_int_eq(frame.substeps, frame.attempts < 3
                                             ? 1
                                             : 1 << (frame.attempts - 2));
        ck_assert(frame.substeps <= MOST_SUBSTEPS);
        by[frame.attempts]++;
        lost += frame.status != OK;
        cut += frame.status == OK && frame.substeps > 1;
        if (frame.status == OK) {
            same_by_hand(body, frame, g, &start, &s);
            continue;
        }
        ck_assert_int_eq(frame.substeps, MOST_SUBSTEPS);
        const size_t size = (size_t)s.n * sizeof *s.u;
        ck_assert(memcmp(s.u, start.u, size) == 0 &&
                  memcmp(s.v, start.v, size) == 0 &&
                  memcmp(s.u_before, start.u_before, size) == 0 &&
                  memcmp(s.v_before, start.v_before, size) == 0);
    }
    ck_assert(by[1] > 0 && by[2] > 0 && cut > 0 && lost > 0);
    free(g);
    state_free(&s);
    state_free(&start);
    forget(model);
}

/* ---- user.h -------------------------------------------------------------- */

static void the_script_is_gone_through(void)
{
    struct user *user = user_alloc(3, LOG, 1.3);
    int motion = 0;
    const double *X = user->scene[0]->mesh->X;
    ck_assert_int_eq(user->frames, 102);
    close_to(X[user->side], 1.0, 1e-15); /* n is odd: the middle but half an */
    close_to(X[user->side + 1], 0.0, 1.0 / 3.0 + 1e-15);         /* edge */
    for (int k = 1; k <= 102; k++) {
        ck_assert(user_next(user));
        ck_assert_int_eq(user->k, k);
        close_to(user->t, k / 30.0, 1e-12);
        while (user->t > USER_SCRIPT[motion].until + 1e-9) motion++;
        const struct user_motion *now = &USER_SCRIPT[motion];
        ck_assert_str_eq(user->motion, now->word);
        ck_assert_int_eq(user->body->equation[user->side] < 0, now->held);
        ck_assert(user->body->equation[0] < 0);
        for (int r = 0; r < user->n_dof; r++)
            if (X[r / 2 * 2] < 1.0) ck_assert(user->g[r] == 0.0);
        if (fabs(user->t - now->until) > 1e-9) continue;
        const double since = now->until - (motion ? now[-1].until : 0.0);
        close_to(user->g[user->side], 1.3 * now->to[0], 1e-12);
        close_to(user->g[user->side + 1],
                 1.3 * (now->to[1] + now->tremble * sin(6.0 * M_PI * since)),
                 1e-12);
        ck_assert(user->g[2 * 3] == user->g[user->side]); /* a corner */
    }
    ck_assert_int_eq(motion, USER_MOTIONS - 1);
    ck_assert(!user_next(user));
    /* smoothly: half-way at half the time */
    struct user *other = user_alloc(2, CUBIC, 1.0);
    ck_assert(other->scene[0]->mesh->X[other->side + 1] == 0.0);
    while (other->t < 0.45 - 1e-9) user_next(other);
    const double s = (other->t - 0.2) / 0.5;
    close_to(other->g[other->side], 0.9 * s * s * (3.0 - 2.0 * s), 1e-12);
    user_free(user);
    user_free(other);
}

/* States that say of which frame and unknown they are. */
static void the_end_of_each_motion_is_kept(void)
{
    struct user *user = user_alloc(2, LOG, 1.0);
    double *u = allocate((size_t)user->n_dof, sizeof *u);
    while (user_next(user)) {
        for (int r = 0; r < user->n_dof; r++) u[r] = user->k + 1e-3 * r;
        user_keep(user, u);
    }
    ck_assert_int_eq(user->n_kept, USER_MOTIONS);
    for (int m = 0; m < USER_MOTIONS; m++)
        for (int r = 0; r < user->n_dof; r++)
            close_to(user->kept[m * user->n_dof + r],
                     30.0 * USER_SCRIPT[m].until + 1e-3 * r, 1e-9);
    free(u);
    user_free(user);
}

UNIT_MAIN("integrate",
    LAW(fastest_frequencies_are_the_oracles),
    LAW(forces_are_the_slope_of_the_energy),
    LAW(acceleration_is_the_force_over_the_mass),
    LAW(newton_is_exact_at_every_step),
    LAW(newton_names_what_is_not_definite),
    LAW(modes_lose_what_the_oracle_says),
    LAW(steps_satisfy_their_formulas),
    LAW(a_failed_step_leaves_the_state),
    LAW(starts_are_at_rest_where_it_is_held),
    LAW(frames_fall_back_or_keep_the_state),
    LAW(the_script_is_gone_through),
    LAW(the_end_of_each_motion_is_kept))
