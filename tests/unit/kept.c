/* kept.c - laws of step.h, of what one step leaves to the next: factors, and
 * what the guess knows of the velocities before. */
#include "plane/scene.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 12 };
static const enum reading scenes[] = {STRETCH, RIGID, TRACTION, SPIN};

static struct scene *scene_of(enum reading reading, enum law law)
{
    struct scene_setting set = scene_notes(reading, law, CELLS);
    if (reading == STRETCH) set.reach = 0.5;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, SPARSE);
    return s;
}

static struct step_control across(void)
{
    struct step_control control = step_method("lift");
    control.chord = 1;
    return control;
}

static void copy_state(const struct scene *from, struct scene *to)
{
    const size_t bytes = (size_t)from->n_dof * sizeof(double);
    memcpy(to->u, from->u, bytes);
    memcpy(to->v, from->v, bytes);
    memcpy(to->v_before, from->v_before, bytes);
    to->steps = from->steps;
}

static double apart(int n, const double a[], const double b[])
{
    double most = 0.0;
    for (int r = 0; r < n; r++) most = fmax(most, fabs(a[r] - b[r]));
    return most;
}

/* What each step leaves does not add up: ninety are as right as one. */
static void a_long_way_ends_where_new_factors_do(void)
{
    const struct step_control newton = step_method("lift"), kept = across();
    for (int k = 0; k < COUNT(scenes); k++) {
        struct scene *s = scene_of(scenes[k], CUBIC);
        struct scene *other = scene_of(scenes[k], CUBIC);
        for (int step = 0; step < 90; step++)
            scene_step(s, &kept), scene_step(other, &newton);
        ck_assert(s->steps == 90 && apart(s->n_dof, s->u, other->u) <= 1e-10);
        scene_free(s);
        scene_free(other);
    }
}

/* New factors in the first step, and after one that took more than four systems
 * and two more than the shortest with these factors; that an increment is more
 * than 0.3 of the last does not happen here. */
static void factors_are_new_when_the_last_step_was_long(void)
{
    const struct step_control kept = across();
    for (int spin = 0; spin < 2; spin++) {
        struct scene *s = scene_of(spin ? SPIN : STRETCH, CUBIC);
        int last = 99, least = 99, new = 0, five = 0;
        /* in the first step of a spin an increment does not fall */
        if (spin) scene_step(s, &kept);
        if (spin) s->body->kept.usable = 0;
        for (int step = 0; step < 60; step++) {
            const int too_long = last > 4 && last > least + 1;
            const struct step_report r = scene_step(s, &kept);
            ck_assert_int_eq(r.status, OK);
            ck_assert_int_eq(r.factorisations, step == 0 || too_long);
            if (r.factorisations) least = 99;
            if (r.iterations < least) least = r.iterations;
            five += !r.factorisations && last > 4;
            last = r.iterations;
            new += r.factorisations;
        }
        ck_assert(spin ? new <= 5 && five >= 5 : new >= 3 && new <= 20);
        scene_free(s);
    }
}

/* Inside of a step the rule is that of [alg:chord]. */
static void an_increment_that_does_not_fall_has_new_factors(void)
{
    struct scene *s = scene_of(STRETCH, CUBIC);
    const struct step_control kept = across();
    for (int step = 0; step < 8; step++) {
        struct step_report r = scene_step(s, &kept);
        ck_assert_int_eq(r.status, OK);
        if (r.iterations > KEPT_SYSTEMS) continue;
        /* stiffer by six tenths: the old factors turn the error of what is
         * stiff into -0.6 of it */
        s->body->material = material_make(CUBIC, 1600.0, 0.3);
        r = scene_step(s, &kept);
        ck_assert_int_eq(r.status, OK);
        ck_assert_int_ge(r.factorisations, 1);
        ck_assert_int_le(r.iterations, 12);
        scene_free(s);
        return;
    }
    ck_abort_msg("no step with at most four systems");
}

/* A body that is turned, moved and stretched along its axes is turned by as
 * much as it is turned. */
static void a_body_knows_how_far_it_is_turned(void)
{
    struct mesh *mesh = mesh_rectangle(6, 3, 1.0, 0.5);
    for (int r = 0; r < 2 * mesh->n_vertex; r++) /* its middle is not 0 */
        mesh->X[r] += r % 2 ? 0.7 : -2.0;
    int *held = calloc((size_t)mesh->n_vertex, sizeof *held);
    struct body *body = body_alloc(
        mesh, material_make(CUBIC, 1000.0, 0.3), 1.0, CONSISTENT, held);
    double *u = calloc(2 * (size_t)mesh->n_vertex, sizeof *u), by[2];
    for (double angle = -3.1; angle < 3.2; angle += 0.2385)
        for (double stretch = 0.5; stretch < 2.1; stretch *= 2.0) {
            const double c = cos(angle), s = sin(angle);
            for (int r = 0; r < 2 * mesh->n_vertex; r += 2) {
                const double x = stretch * mesh->X[r], y = mesh->X[r + 1];
                u[r] = c * x - s * y + 0.3 - mesh->X[r];
                u[r + 1] = s * x + c * y - 0.1 - mesh->X[r + 1];
            }
            body_turned(body, u, by);
            close_to(by[0], c, 1e-13);
            close_to(by[1], s, 1e-13);
        }
    /* to a point: every rotation is as close */
    for (int r = 0; r < 2 * mesh->n_vertex; r++)
        u[r] = (r % 2 ? 0.5 : -1.0) - mesh->X[r];
    for (int r = 0; r < 2 * mesh->n_vertex; r++)
        if (fabs(mesh->X[r] + u[r] - (r % 2 ? 0.5 : -1.0)) > 0.0) u[r] = 0.0;
    body_turned(body, u, by);
    close_to(by[0] * by[0] + by[1] * by[1], 1.0, 1e-13);
    free(u);
    free(held);
    body_free(body);
    mesh_free(mesh);
}

/* v := R v + move (R X - X), all vertices. */
static void rotate(const struct mesh *mesh, double angle, int move, double v[])
{
    const double c = cos(angle), s = sin(angle);
    for (int r = 0; r < 2 * mesh->n_vertex; r += 2) {
        const double X1 = mesh->X[r], X2 = mesh->X[r + 1];
        const double x = v[r] + move * X1, y = v[r + 1] + move * X2;
        v[r] = c * x - s * y - move * X1;
        v[r + 1] = s * x + c * y - move * X2;
    }
}

/* What a free body does with old factors does not depend on how far it has
 * turned since they were made: one system, and everything is turned. */
static void old_factors_turn_with_the_body(void)
{
    for (double angle = 0.3; angle < 6.0; angle += 1.1) {
        struct scene *s = scene_of(SPIN, CUBIC);
        struct step_control kept = across();
        const size_t n = (size_t)s->n_dof;
        double *w = calloc(n, sizeof *w), *u[2], moved = 0.0;
        ck_assert_int_eq(scene_step(s, &kept).status, OK); /* K is factored */
        kept.max_iterations = 1;
        for (int k = 0; k < 2; k++) { /* as it is, and turned */
            struct kept before = s->body->kept;
            u[k] = calloc(n, sizeof **u);
            for (size_t r = 0; r < n; r++) {
                u[k][r] = s->u[r];
                w[r] = s->u[r] + 0.01 * sin(2.385 * (double)r);
            }
            if (k) {
                rotate(s->mesh, angle, 1, u[1]);
                rotate(s->mesh, angle, 1, w);
            }
            const struct incremental Phi = {s->set.dt, w, NULL};
            before.systems = 1;
            before.usable = 1;
            s->body->kept = before;
            const struct step_report r =
                step_solve(s->body, &kept, Phi, u[k]);
            ck_assert_int_eq(r.factorisations, 0);
            ck_assert_int_eq(r.iterations, 1);
        }
        moved = apart(s->n_dof, u[0], s->u);
        rotate(s->mesh, -angle, 1, u[1]);
        ck_assert(moved > 1e-4);
        ck_assert(apart(s->n_dof, u[0], u[1]) <= 1e-12);
        for (int k = 0; k < 2; k++) free(u[k]);
        free(w);
        scene_free(s);
    }
}

enum event {
    NOTHING, STORED, ASSEMBLED, OTHER_STEP, NO_INERTIA, UNROUNDED, BAND,
    FAILED, N_EVENT
};

/* Factors of another matrix, of another step, or of none are not used. */
static void factors_are_forgotten(void)
{
    for (int event = NOTHING; event < N_EVENT; event++) {
        struct scene *s = scene_of(RIGID, CUBIC);
        struct step_control kept = across();
        struct step_report r = {.iterations = 9};
        if (event == BAND) body_store(s->body, BANDED);
        for (int k = 0; k < 20 && r.iterations > KEPT_SYSTEMS; k++)
            r = scene_step(s, &kept);
        ck_assert_int_eq(r.status, OK);
        ck_assert_int_le(r.iterations, KEPT_SYSTEMS);
        const size_t n = (size_t)s->n_dof;
        double *q = calloc(n, sizeof *q), *w = calloc(n, sizeof *w);
        struct incremental Phi = {s->set.dt, w, NULL};
        memcpy(w, s->u, n * sizeof *w);
        if (event == STORED) {
            body_store(s->body, SPARSE);
            ck_assert(!s->body->kept.usable);
        }
        if (event == ASSEMBLED) body_assemble(s->body, Phi, s->u, EXACT, q);
        if (event == OTHER_STEP) Phi.dt *= 2.0;
        if (event == NO_INERTIA) Phi.w = NULL;
        if (event == UNROUNDED) { /* by a step with new factors each time */
            struct step_control newton = kept;
            newton.chord = 0;
            ck_assert_int_eq(scene_step(s, &newton).status, OK);
        }
        if (event == FAILED) {
            struct step_control hasty = kept;
            hasty.max_iterations = 0;
            ck_assert_int_ne(scene_step(s, &hasty).status, OK);
        }
        r = step_solve(s->body, &kept, Phi, s->u);
        ck_assert_int_eq(r.status, OK);
        ck_assert_int_eq(r.factorisations, event != NOTHING);
        free(q);
        free(w);
        scene_free(s);
    }
}

/* The factors of a body that was a hundred times softer send it where it has no
 * energy; then the step begins again, and ends as if there had been none. */
static void what_old_factors_spoil_is_done_again(void)
{
    struct scene *s[2];
    struct step_report r[2];
    const struct step_control kept = across();
    for (int k = 0; k < 2; k++) {
        s[k] = scene_of(STRETCH, LOG);
        s[k]->body->material = material_make(LOG, 10.0, 0.3);
        r[k] = (struct step_report){.iterations = 9};
        for (int i = 0; i < 20 && r[k].iterations > KEPT_SYSTEMS; i++)
            r[k] = scene_step(s[k], &kept);
        ck_assert_int_le(r[k].iterations, KEPT_SYSTEMS);
        s[k]->body->material = material_make(LOG, 1e5, 0.3);
        if (k) s[k]->body->kept.usable = 0;
        r[k] = scene_step(s[k], &kept);
        ck_assert_int_eq(r[k].status, OK);
    }
    ck_assert_int_gt(r[0].iterations, r[1].iterations);
    ck_assert_int_eq(r[0].factorisations, r[1].factorisations);
    ck_assert(apart(s[0]->n_dof, s[0]->u, s[1]->u) <= 1e-13);
    for (int k = 0; k < 2; k++) scene_free(s[k]);
}

/* A load of 1e10 N on a body of 1e-300 N/m^2: K is positive definite, and its
 * increment no number; u stays as it is. */
static void an_infinite_increment_is_not_taken(void)
{
    struct scene *s = scene_of(GRAVITY, CUBIC);
    const struct step_control kept = across();
    double *f = calloc((size_t)s->n_dof, sizeof *f);
    s->body->material = material_make(CUBIC, 1e-300, 0.3);
    f[s->n_dof - 1] = 1e10;
    const struct step_report r =
        step_solve(s->body, &kept, at_rest(f), s->u);
    ck_assert_int_eq(r.status, NONFINITE);
    ck_assert_int_eq(r.iterations, 0);
    for (int k = 0; k < s->n_dof; k++) ck_assert(!(fabs(s->u[k]) > 0.0));
    free(f);
    scene_free(s);
}

/* The first step from rest is that of a new scene, digit by digit. */
static void a_scene_at_rest_has_no_factors(void)
{
    const struct step_control kept = across();
    struct scene *s = scene_of(RIGID, CUBIC), *other = scene_of(RIGID, CUBIC);
    for (int step = 0; step < 5; step++) scene_step(s, &kept);
    scene_rest(s);
    const struct step_report r = scene_step(s, &kept);
    ck_assert_int_eq(r.status, OK);
    ck_assert_int_eq(r.factorisations,
                     scene_step(other, &kept).factorisations);
    ck_assert_mem_eq(s->u, other->u, (size_t)s->n_dof * sizeof *s->u);
    scene_free(s);
    scene_free(other);
}

/* One step from the parabola through the last three states. */
static struct step_report parabola(struct scene *s)
{
    const struct step_control control = step_method("lift");
    const size_t n = (size_t)s->n_dof;
    double *w = calloc(n, sizeof *w), *u = calloc(n, sizeof *u);
    const double dt = s->set.dt;
    for (size_t r = 0; r < n; r++) {
        w[r] = s->u[r] + dt * s->v[r];
        u[r] = w[r] + dt * (s->v[r] - s->v_before[r]);
    }
    step_boundary(s->body, s->g, 1, u);
    const struct step_report report = step_solve(
        s->body, &control, (struct incremental){dt, w, s->f}, u);
    for (size_t r = 0; r < n; r++) {
        s->v_before[r] = s->v[r];
        s->v[r] = (u[r] - s->u[r]) / dt;
        s->u[r] = u[r];
    }
    free(w);
    free(u);
    return report;
}

/* In smooth motion the guess is closer than the parabola; when both ends jump
 * to and fro, from which nothing follows, it is never far from it. */
static void the_guess_is_as_good_as_the_parabola_or_better(void)
{
    const struct step_control lift = step_method("lift");
    for (int k = 0; k <= COUNT(scenes); k++) {
        const int jolted = k == COUNT(scenes);
        struct scene *s[2];
        int systems[2] = {0, 0};
        for (int way = 0; way < 2; way++) {
            struct scene *q = scene_of(jolted ? STRETCH : scenes[k], CUBIC);
            s[way] = q;
            for (int step = 1; step <= 60; step++) {
                const double t = step / 30.0;
                scene_hold(q, !jolted ? t : step % 16 < 8 ? 0.0 : 0.5);
                const struct step_report r =
                    way ? parabola(q)
                        : step_backward_euler(q->body, &lift, q->set.dt, q->g,
                                              q->f, q->u, q->v, q->v_before);
                ck_assert_int_eq(r.status, OK);
                systems[way] += r.iterations;
            }
        }
        ck_assert(apart(s[0]->n_dof, s[0]->u, s[1]->u) <= 1e-9);
        ck_assert_int_le(20 * systems[0], (jolted ? 20 : 18) * systems[1]);
        for (int way = 0; way < 2; way++) scene_free(s[way]);
    }
}

/* After steps of another state or length the guess is the parabola again, and
 * every digit is that of a body that has made none. */
static void the_guess_knows_whose_velocities_they_were(void)
{
    for (int event = 0; event < 3; event++) {
        const struct step_control lift = step_method("lift");
        struct scene *s = scene_of(SPIN, CUBIC), *other = scene_of(SPIN, CUBIC);
        for (int step = 0; step < 20; step++) scene_step(s, &lift);
        if (event == 1) s->v[7] += 1e-3;
        if (event == 2) s->set.dt = other->set.dt = 1.0 / 25.0;
        copy_state(s, other);
        const struct step_report r = scene_step(s, &lift);
        const struct step_report q = scene_step(other, &lift);
        ck_assert_int_le(r.iterations, event ? q.iterations : q.iterations - 1);
        if (event)
            ck_assert_mem_eq(s->u, other->u, (size_t)s->n_dof * sizeof *s->u);
        scene_free(s);
        scene_free(other);
    }
}

UNIT_MAIN("kept",
    LAW(the_guess_is_as_good_as_the_parabola_or_better),
    LAW(the_guess_knows_whose_velocities_they_were),
    LAW(a_long_way_ends_where_new_factors_do),
    LAW(factors_are_new_when_the_last_step_was_long),
    LAW(an_increment_that_does_not_fall_has_new_factors),
    LAW(a_body_knows_how_far_it_is_turned),
    LAW(old_factors_turn_with_the_body),
    LAW(factors_are_forgotten),
    LAW(a_scene_at_rest_has_no_factors),
    LAW(what_old_factors_spoil_is_done_again),
    LAW(an_infinite_increment_is_not_taken))
