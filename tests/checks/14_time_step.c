/*
 * 14_time_step.c - what right time steps satisfy.
 *
 * Arguments: slot, argument: varied by
 *   14a  model     one_frame_of_a_mode_is_right, residual_is_that_of_the_body
 *                  (laws, loads), table `residual` (a bar)
 *        dt        one_frame_of_a_mode_is_right
 *        u0, v0, u both
 *   14b  model     symplectic_euler_keeps_its_invariant (mode, bars, loads,
 *                  also a body inside out), methods_agree_with_common (body,
 *                  loads)
 *        dt, u, v  symplectic_euler_keeps_its_invariant
 *   14c  model     backward_euler_loses_what_it_must (mode),
 *                  midpoint_keeps_the_energy (bar), methods_agree_with_common
 *                  (body, loads)
 *        method    free_flight_is_exact, methods_agree_with_common
 *        dt        backward_euler_loses_what_it_must
 *        g         methods_agree_with_common (moves, too far), NULL in others
 *        s         all; s->steps 0 to 3: methods_agree_with_common
 *   14d  body, f   frames_fall_back_or_keep_the_state (laws; NULL, loads)
 *        dt, g     the same (1/30 and less; both ends move)
 *        now       the same (v_before, held vertices that have moved), lost or
 *                  not
 */
#include "program.h"

#include "judge.h"

#include "../oracle/time_step.h"

/* A few dozen operations on numbers of size 1. */
static const double ROUND_OFF = 1e-12;
/* Newton's tolerance on the body, 1e-10 m, with the condition of K. */
static const double SOLVED = 1e-8;

static struct step_report advance(struct model *model, enum method method,
                                  double dt, const double g[], struct state *s)
{
    return integrate_by(symplectic_euler, implicit_step, model, method, dt, g,
                        s);
}

/* A square of n x n, its left side held, or (held is 2) both. */
static struct scene *square(int n, enum law law, int held)
{
    struct scene_setting set =
        scene_notes(held == 2 ? STRETCH : GRAVITY, law, n);
    set.force = 0.0;
    return scene_alloc(&set);
}

/* The same of 4 x 4 as a model, or one with no stiffness at all; the scene is
 * not freed, a check is a process of its own. */
static struct model *a_square(int stiff, int held)
{
    struct body *body = square(4, CUBIC, held)->body;
    if (!stiff) body->material.mu = body->material.lambda = 0.0;
    return model_body(body);
}

/* A state with high entropy; prescribed vertices are at rest at 0. */
static struct state a_state(const struct model *model, double size)
{
    struct state s = state_make(model->n_dof);
    for (int i = 0; i < model->n_dof; i++) {
        if (model->body && model->body->equation[i] < 0) continue;
        s.u[i] = size * sin(2.385 * i + 0.3);
        s.v[i] = 20.0 * size * cos(3.714 * i);
    }
    return s;
}

/* One frame of a mode with K = 100, and loads: the fixed point of any dt. */
static void one_frame_of_a_mode_is_right(void)
{
    const double dt = 1.0 / 30.0, u0[] = {1.0}, v0[] = {0.0};
    double q[1];
    struct model *model = model_mode(10.0);
    const double u[] = {oracle_right};
    expect(residual(model, dt, u0, v0, u, q) == OK, "residual() of a mode");
    expect_close(q[0], 0.0, ROUND_OFF, 1.0,
                 "q at u = 0.9, the right end of a frame from u0 = 1, v0 = 0 "
                 "with M = 1, K = 100");
    const double zero[] = {oracle_printed};
    residual(model, dt, u0, v0, zero, q);
    expect_close(q[0], -1.0, ROUND_OFF, 1.0,
                 "q at u = 0 is -M u0 = -1: inertia remembers where it was");

    /* f = K u: at rest for ever, whatever dt */
    model->f[0] = 238.5;
    const double rest[] = {2.385};
    for (double step = dt; step > 1e-3; step /= 2.385) {
        residual(model, step, rest, v0, rest, q);
        expect_close(q[0], 0.0, ROUND_OFF, 2.385,
                     "q in equilibrium with a load, K u = f, dt = %g", step);
    }
    const double away[] = {1.247}, moving[] = {-37.14};
    residual(model, dt, rest, moving, away, q);
    expect_close(q[0],
                 1.247 - 2.385 + 37.14 * dt + dt * dt * (124.7 - 238.5),
                 ROUND_OFF, 1.0, "q from u0 = 2.385, v0 = -37.14 at u = 1.247");
    model_free(model);
}

/* The residual of which step_solve() is Newton's method, and integrate.h's. */
static void residual_is_that_of_the_body(void)
{
    struct model *model = a_square(1, 1);
    struct state s = a_state(model, 0.06), t = a_state(model, 0.05);
    const double dt = 0.0213;
    double *q = guarded_alloc(s.n), *want = t.v_before, *w = s.u_before;
    double scale = 0.0;
    for (int i = 0; i < s.n; i++) {
        w[i] = s.u[i] + dt * s.v[i];
        model->f[i] = 31.0 * cos(0.613 * i);
    }
    expect(residual(model, dt, s.u, s.v, t.u, q) == OK,
           "residual() of a good state of the body");
    for (int common = 0; common <= 1; common++) {
        if (common)
            integrate_residual(model, dt, s.u, s.v, t.u, want);
        else
            body_assemble(model->body, (struct incremental){dt, w, model->f},
                          t.u, NO_TANGENT, want);
        for (int i = 0; i < s.n; i++) scale = fmax(scale, fabs(want[i]));
        for (int i = 0; i < s.n; i++)
            expect_close(q[i], want[i], ROUND_OFF, scale,
                         "q[%d] of the square, against %s()", i,
                         common ? "integrate_residual" : "body_assemble");
    }

    /* a body of the log law turned inside out has no q */
    struct scene *scene = square(4, LOG, 1);
    struct model *other = model_body(scene->body);
    for (int a = 0; a < scene->mesh->n_vertex; a++)
        t.u[2 * a] = -1.5 * scene->mesh->X[2 * a];
    expect(residual(other, dt, s.u, s.v, t.u, q) == INVERTED,
           "the log law inside out: the status must be INVERTED");
    state_free(&s);
    state_free(&t);
    model_free(model);
    model_free(other);
}

/* P = 0 and no load: u = u0 + t v0 for every method. */
static void free_flight_is_exact(void)
{
    for (int k = 0; k < 2; k++)
        for (int m = 0; m < N_METHOD; m++) {
            struct model *model = k ? a_square(0, 1) : model_mode(0.0);
            struct state s = a_state(model, 0.1), start = a_state(model, 0.1);
            const double dt = 0.02385;
            double *g = allocate((size_t)s.n, sizeof *g);
            for (int j = 1; j <= 4; j++) {
                const struct step_report report =
                    advance(model, (enum method)m, dt, k ? g : NULL,
                            &s);
                expect(report.status == OK, "%s of a free %s: %s",
                       method_name((enum method)m), k ? "body" : "mass",
                       status_name(report.status));
                for (int i = 0; i < s.n; i++) {
                    expect_close(s.u[i], start.u[i] + j * dt * start.v[i],
                                 ROUND_OFF, 1.0,
                                 "no force, %s, u[%d] after %d steps",
                                 method_name((enum method)m), i, j);
                    expect_close(s.v[i], start.v[i], ROUND_OFF, 2.0,
                                 "no force, %s, v[%d] after %d steps",
                                 method_name((enum method)m), i, j);
                }
            }
            free(g);
            state_free(&s);
            state_free(&start);
            model_free(model);
        }
}

/*
 * v+ = v - z u, u+ = u + z v+ (z = w dt, v in units of w u) leaves
 * u^2 + v^2 - z u v as it is, to round-off; neither explicit Euler nor the
 * other order of the two lines does.
 */
static void symplectic_euler_keeps_its_invariant(void)
{
    static const double z[] = {0.2385, 1.247, 1.9};
    for (int k = 0; k < 3; k++) {
        struct model *model = model_mode(z[k]);
        double u = 1.0, v = 0.0, before = 1.0;
        for (int j = 1; j <= 60; j++) {
            expect(symplectic_euler(model, 1.0, &u, &v) == OK,
                   "symplectic_euler() of a mode");
            const double s = v / z[k], now = u * u + s * s - z[k] * u * s;
            expect_close(now, before, ROUND_OFF, 1.0,
                         "u^2 + v^2 - z u v of symplectic Euler, z = w dt = "
                         "%g, step %d", z[k], j);
            before = now;
        }
        model_free(model);
    }
    for (int mass = CONSISTENT; mass <= LUMPED; mass++) {
        struct model *model = model_bar(7, (enum mass)mass);
        struct state s = state_make(7);
        const double dt = 3e-4;
        double force[7], Ma[7], v0[7], u0[7];
        for (int i = 0; i < 7; i++) {
            u0[i] = s.u[i] = 0.1 * sin(2.385 * i);
            v0[i] = s.v[i] = cos(3.714 * i);
            model->f[i] = 31.0 * cos(0.613 * i);
        }
        expect(symplectic_euler(model, dt, s.u, s.v) == OK,
               "symplectic_euler() of a bar");
        model_force(model, u0, force);
        for (int i = 0; i < 7; i++) s.u_before[i] = (s.v[i] - v0[i]) / dt;
        model_mass(model, s.u_before, Ma);
        for (int i = 0; i < 7; i++) {
            expect_close(Ma[i], model->f[i] - force[i], 1e-10, 2e3,
                         "%s mass: M (v+ - v) / dt at node %d, against "
                         "f - dPsi/du(u)", mass ? "lumped" : "consistent", i);
            expect_close(s.u[i], u0[i] + dt * s.v[i], ROUND_OFF, 1.0,
                         "u+ at node %d, against u + dt v+", i);
        }
        state_free(&s);
        model_free(model);
    }
    /* a body inside out has no force */
    struct scene *scene = square(4, LOG, 1);
    struct model *model = model_body(scene->body);
    struct state s = state_make(model->n_dof);
    for (int a = 0; a < scene->mesh->n_vertex; a++)
        s.u[2 * a] = -1.5 * scene->mesh->X[2 * a];
    const enum status status = symplectic_euler(model, 1e-3, s.u, s.v);
    expect(status == INVERTED, "the log law inside out: the status must be "
           "INVERTED, not %s", status_name(status));
    state_free(&s);
    model_free(model);
}

/* Energy by 1/(1 + z^2) and nothing else, whatever the phase. */
static void backward_euler_loses_what_it_must(void)
{
    struct model *unit = model_mode(1.0);
    struct state s = state_make(1);
    s.u[0] = 1.0;
    for (int k = 0; k < COUNT(oracle_sequence); k++) {
        expect_close(s.u[0], oracle_sequence[k][0], ROUND_OFF, 1.0,
                     "backward Euler, w dt = 1, u after %d steps", k);
        expect_close(s.v[0], oracle_sequence[k][1], ROUND_OFF, 1.0,
                     "backward Euler, w dt = 1, v / w after %d steps", k);
        advance(unit, BACKWARD_EULER, 1.0, NULL, &s);
    }
    for (int k = 0; k < COUNT(oracle_step); k++) {
        const double z = oracle_step[k].w_dt;
        for (double phase = 0.1; phase < 3.0; phase += 0.613) {
            s.steps = 0;
            s.u[0] = cos(phase);
            s.v[0] = sin(phase);
            advance(unit, BACKWARD_EULER, z, NULL, &s);
            expect_close(s.u[0] * s.u[0] + s.v[0] * s.v[0],
                         oracle_step[k].energy, ROUND_OFF, 1.0,
                         "energy after one step of backward Euler, w dt = %g",
                         z);
        }
    }
    state_free(&s);
    model_free(unit);
}

/* Quadratic energy: to round-off, with any step. */
static void midpoint_keeps_the_energy(void)
{
    struct model *model = model_bar(9, CONSISTENT);
    struct state s = a_state(model, 0.1);
    const double start = model_energy(model, s.u, s.v);
    for (int k = 1; k <= 100; k++) {
        advance(model, IMPLICIT_MIDPOINT, 0.02385, NULL, &s);
        expect_close(model_energy(model, s.u, s.v), start, 1e-10, start,
                     "energy of a linear bar after %d steps of the midpoint "
                     "rule, dt = 0.02385", k);
    }
    state_free(&s);
    model_free(model);
}

/* What a frame that is OK did, done by hand. */
static void same_by_hand(struct body *body, struct frame frame, double dt,
                         const double g[], const double f[],
                         const struct state *start, const struct state *end)
{
    struct state s = state_make(start->n);
    int iterations = 0;
    double *part = allocate((size_t)s.n, sizeof *part);
    state_copy(start, &s);
    for (int k = 1; k <= frame.substeps; k++) {
        for (int i = 0; i < s.n; i++)
            part[i] = start->u[i] +
                      (double)k / frame.substeps * (g[i] - start->u[i]);
        const struct step_report report = step_backward_euler(
            body, frame.attempts == 1 ? &FAST : &ROBUST,
            dt / frame.substeps, part, f, s.u, s.v, s.v_before);
        expect(report.status == OK,
               "a frame said to be OK after attempt %d: by hand, part %d of %d "
               "is %s", frame.attempts, k, frame.substeps,
               status_name(report.status));
        iterations += report.iterations;
    }
    expect(frame.attempts > 1 || frame.iterations == iterations,
           "an easy frame: %d iterations; FAST alone does it in %d",
           frame.iterations, iterations);
    for (int i = 0; i < s.n; i++) {
        expect_close(end->u[i], s.u[i], 1e-5, 1.0,
                     "u[%d] after attempt %d, %d parts, against the same by "
                     "hand", i, frame.attempts, frame.substeps);
        expect_close(end->v[i], s.v[i], 1e-4, 100.0,
                     "v[%d] after attempt %d, %d parts, against the same by "
                     "hand", i, frame.attempts, frame.substeps);
        expect_close(end->v_before[i], s.v_before[i], 1e-4, 100.0,
                     "v_before[%d] after attempt %d, %d parts, against v at "
                     "the beginning of the last of them", i, frame.attempts,
                     frame.substeps);
    }
    free(part);
    state_free(&s);
}

/* Loads on a square both of whose ends have moved, and go on. */
static double *falling(int n, struct state *start, double g[])
{
    double *f = allocate((size_t)start->n, sizeof *f);
    for (int i = 0; i < start->n; i++) f[i] = 31.0 * cos(0.613 * i);
    for (int a = 0; a < start->n / 2; a++)
        if (a % (n + 1) % n == 0) {
            start->u[2 * a] = 0.013;
            g[2 * a] = 0.027;
        }
    return f;
}

/* The side is struck: some frames need ROBUST, some parts, some are lost.  Of
 * the body that falls, in a shorter frame, both ends have moved before. */
static void frames_fall_back_or_keep_the_state(void)
{
    int easy = 0, robust = 0, cut = 0, lost = 0;
    for (int law = LOG; law <= CUBIC; law++) {
        const int n = law == LOG ? 8 : 6;
        const double dt = law == LOG ? 1.0 / 30.0 : 0.02385;
        struct model *model = model_body(square(n, (enum law)law, 2)->body);
        struct state start = a_state(model, 0.01), s = state_make(start.n);
        double *g = allocate((size_t)s.n, sizeof *g), *f = NULL;
        for (int i = 0; i < s.n; i++) start.v_before[i] = 0.9 * start.v[i];
        if (law == CUBIC) f = falling(n, &start, g);
        for (double jump = -0.0548; jump > -2.1; jump -= 0.0613) {
            state_copy(&start, &s);
            for (int a = n; a < s.n / 2; a += n + 1) {
                g[2 * a] = jump;
                g[2 * a + 1] = law == LOG ? 0.3 : 1.0;
            }
            const struct frame hard =
                frame_step(model->body, dt, g, f, &s);
            expect(hard.attempts >= 1 && hard.attempts <= 5 &&
                       (hard.attempts == 1) == (hard.first == OK) &&
                       hard.substeps ==
                           (hard.attempts < 3 ? 1 : 1 << (hard.attempts - 2)),
                   "side moved by %g m: %d attempts, the first %s, the last in "
                   "%d parts; 1: FAST, 2: ROBUST, 3 to 5: 2, 4, 8 parts", jump,
                   hard.attempts, status_name(hard.first), hard.substeps);
            expect(s.steps == start.steps, "side moved by %g m: frame_step() "
                   "has changed now->steps from %d to %d; u, v and v_before "
                   "are all that it advances", jump, start.steps, s.steps);
            if (hard.status == OK) {
                same_by_hand(model->body, hard, dt, g, f, &start, &s);
                easy += hard.attempts == 1;
                robust += hard.attempts == 2;
                cut += hard.substeps > 1;
                continue;
            }
            lost++;
            expect(hard.attempts == 5, "a frame given up after %d attempts",
                   hard.attempts);
            for (int i = 0; i < s.n; i++)
                expect(s.u[i] == start.u[i] && s.v[i] == start.v[i] &&
                           s.v_before[i] == start.v_before[i],
                       "a lost frame (side moved by %g m) changed u, v or "
                       "v_before at %d: it must keep the state", jump, i);
        }
        free(g);
        free(f);
        state_free(&s);
        state_free(&start);
        model_free(model);
    }
    expect(easy > 0 && robust > 0 && cut > 0 && lost > 0,
           "striking the side: %d frames were easy, %d saved by ROBUST, %d by "
           "parts, %d lost; each must occur", easy, robust, cut, lost);
}

/* The functions of integrate.h, which the studies stand on, on a nonlinear body
 * whose right side moves. */
static void methods_agree_with_common(void)
{
    struct model *model = a_square(1, 2);
    double *g = allocate((size_t)model->n_dof, sizeof *g);
    for (int i = 0; i < model->n_dof; i++)
        model->f[i] = 31.0 * cos(0.613 * i);
    for (int m = 0; m < N_METHOD; m++) {
        struct state mine = a_state(model, 0.01), due = a_state(model, 0.01);
        const char *name = method_name((enum method)m);
        for (int j = 1; j <= 3; j++) {
            for (int a = 4; a < 25; a += 5) g[2 * a] = 0.02 * j;
            const struct step_report report =
                advance(model, (enum method)m, 0.00247, g, &mine);
            expect(report.status == OK, "%s, step %d: %s", name, j,
                   status_name(report.status));
            integrate_step(model, (enum method)m, 0.00247, g, &due);
            for (int i = 0; i < model->n_dof; i++) {
                expect_close(mine.u[i], due.u[i], SOLVED, 1.0,
                             "%s, u[%d] after %d steps, against integrate.h",
                             name, i, j);
                expect_close(mine.v[i], due.v[i], SOLVED, 400.0,
                             "%s, v[%d] after %d steps, against integrate.h",
                             name, i, j);
            }
        }
        state_free(&mine);
        state_free(&due);
    }
    model_free(model);
    /* a side is pushed through the other, half-way too */
    model = model_body(square(4, LOG, 2)->body);
    for (int a = 4; a < 25; a += 5) g[2 * a] = -5.0;
    for (int m = BACKWARD_EULER; m <= BDF2; m++) {
        struct state mine = state_make(model->n_dof);
        const enum status status =
            advance(model, (enum method)m, 0.00247, g, &mine).status;
        expect(status == INVERTED, "%s, log law, a side that moves by -5 m: "
               "the status must be INVERTED, not %s",
               method_name((enum method)m), status_name(status));
        state_free(&mine);
    }
    free(g);
    model_free(model);
}

/* What a frame has cost, FAST alone or FAST in vain and ROBUST.  In programs
 * that round differently the last test of Newton's method falls either way: one
 * system in each attempt. */
static void frames_agree_with_common(void)
{
    struct model *model = model_body(square(8, CUBIC, 2)->body);
    double *g = allocate((size_t)model->n_dof, sizeof *g);
    for (int k = 0; k < 8; k++) {
        const double jump = -0.2 * (k / 2 + 1);
        struct state mine = a_state(model, 0.01), due = a_state(model, 0.01);
        for (int a = 8; a < 81; a += 9) {
            g[2 * a] = k % 2 ? jump : 0.1 * jump;
            g[2 * a + 1] = k % 2;
        }
        const struct frame frame =
            frame_step(model->body, 1.0 / 30.0, g, NULL, &mine);
        const struct frame want =
            integrate_frame(model->body, 1.0 / 30.0, g, &due);
        expect(want.attempts == 1 + k % 2, "the frames that this check needs: "
               "%d attempts", want.attempts);
        expect(frame.attempts == want.attempts && frame.status == want.status &&
                   frame.first == want.first,
               "side moved by (%g, %g) m: %d attempts, the first %s, the last "
               "%s; integrate_frame() has %d, %s, %s", g[16], g[17],
               frame.attempts, status_name(frame.first),
               status_name(frame.status), want.attempts,
               status_name(want.first), status_name(want.status));
        expect_close(frame.iterations, want.iterations, 1.0, want.attempts,
                     "side moved by (%g, %g) m, %d attempts: iterations of all",
                     g[16], g[17], frame.attempts);
        expect_close(frame.factorisations, want.factorisations, 1.0,
                     want.attempts, "side moved by (%g, %g) m, %d attempts: "
                     "factorisations of all", g[16], g[17], frame.attempts);
        state_free(&mine);
        state_free(&due);
    }
    free(g);
    model_free(model);
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *slowest = run("--wdt 1.9211"), *output = run("");
    const char *const key[] = {"1a", "1b"};
    for (int k = 0; k < 2; k++) {
        const int row = k ? 40 : 1; /* 9.1725 Hz turn by 1.9211 in 1/30 s */
        measured(key[k], hypot(cell(k ? output : slowest, "mode", "backward_u",
                                    row),
                               cell(k ? output : slowest, "mode", "backward_v",
                                    row)));
    }
}

static const struct claim claims[] = {
    {"one_frame_of_a_mode_is_right", one_frame_of_a_mode_is_right, "14a"},
    {"residual_is_that_of_the_body", residual_is_that_of_the_body, "14a"},
    {"symplectic_euler_keeps_its_invariant",
     symplectic_euler_keeps_its_invariant, "14b"},
    {"backward_euler_loses_what_it_must", backward_euler_loses_what_it_must,
     "14c"},
    {"midpoint_keeps_the_energy", midpoint_keeps_the_energy, "14c"},
    {"free_flight_is_exact", free_flight_is_exact, "14c"},
    {"frames_fall_back_or_keep_the_state", frames_fall_back_or_keep_the_state,
     "14d"},
    {"methods_agree_with_common", methods_agree_with_common, "14c"},
    {"frames_agree_with_common", frames_agree_with_common, "14d"},
};

static const char *const runs[] = {
    "",
    "--n 6 --wdt 1.9211 --reach 1.4",
    "--n 9 --wdt 17.3 --reach 1.5",
    "--n 4 --wdt 0.2385 --law cubic",
};

#define NEWTON_FRAME "Newton's tolerance, 1e-8 m, and the motion after it"
static const struct column_rule rules[] = {
    {"residual", "*", 1e-11, "sums of element entries", 0},
    {"velocity", "*", 1e-11, "a linear system of a few unknowns", 0},
    {"mode", "*", 1e-10, "one unknown, 40 steps", 0},
    {"frames", "iterations", 0.2, "a last step more or less", 0},
    {"frames", "factorisations", 0.2, "a last step more or less", 0},
    {"frames", "min_J", 1e-3, "Newton's tolerance, 1e-8 m, over the mesh", 0},
    {"frames", "u1", 1e-4, NEWTON_FRAME, 0},
    {"frames", "u2", 1e-4, NEWTON_FRAME, 0},
    {"frames", "*", 1e-12, "counts and words", 0},
    {"square", "u_x", 1e-4, NEWTON_FRAME, 1},
    {"square", "u_y", 1e-4, NEWTON_FRAME, 1},
    {"square", "*", 1e-14, "given", 1},
};

static const struct lesson lesson = {
    "14_time_step", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "At 30 frames per second backward Euler leaves 46 % of the amplitude of "
    "the bar's first mode after one frame "
    "(figures/14_time_step/amplification.svg): what looks like a calm material "
    "is the integrator. The midpoint rule keeps all of it, and so keeps the "
    "ripples as well.",
    "In slot 14d replace ROBUST by a copy of it with the guess FROM_VELOCITY "
    "and run with --n 32 --reach 1.2: after the slam more than forty frames "
    "are lost. Why one after the other? Then --law cubic: no inversion stops "
    "it. What does min_J say?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
