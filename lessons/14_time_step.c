/*
 * 14_time_step.c - time: four integrators, what each loses, and the loop that
 * has a thirtieth of a second for a frame.
 *
 * Notes: Lecture 1, "Time stepping"; Lecture 2, introduction of section 3.
 *
 * Problem.  M u'' = f - dPsi/du, with u given at some vertices at every time.
 * Three systems, one code (model.h): a single mode u'' = -w^2 u, a linear bar
 * fixed at one end, and the nonlinear square.
 *
 *     frame     0         1         2         3       each implicit method
 *     time      |----+----|----+----|----+----|--     contains one step d of
 *               u0  u_m   u+                          backward Euler, from
 *                                                     some state (a, b)
 *
 * Run       make lesson-14; make lesson-14 ARGS=-h lists its options
 * PREDICT 1a fraction of a 9.17 Hz mode after a backward step of 1/30 s: ...
 * PREDICT 1b fraction of a mode with w dt = 0.5 after 40 such steps: ...
 * Plot: mode k backward_u
 */
#include "motion/integrate.h"
#include "base/options.h"
#include "base/table.h"
#include "motion/user.h"

#include <math.h>
#include <stdlib.h>

/*
 * Given the state (u0, v0) at the beginning of a step of backward Euler and a
 * candidate u for its end, return the residual q (2.18), in kg m; q = 0 for the
 * right one.  f is model->f.  Status of model_force().
 */
static enum status residual(const struct model *model, double dt,
                            const double u0[], const double v0[],
                            const double u[], double q[])
{
    const int n = model->n_dof;
    double *move = allocate((size_t)n, sizeof *move);
    double *force = allocate((size_t)n, sizeof *force);
    enum status status = OK;
    /* SLOT 14a(model, dt, u0, v0, u, q, n, move, force, &status): q[0..n-1],
     * by model_mass() and model_force(). */
    todo("14a", model, dt, u0, v0, u, q, n, move, force, &status);
    /* END 14a */
    free(force);
    free(move);
    return status;
}

/* Given u and v, advance them by a step of symplectic Euler.
 * u, v  in/out  state, of no use unless the status, model_force()'s, is OK */
static enum status symplectic_euler(const struct model *model, double dt,
                                    double u[], double v[])
{
    const int n = model->n_dof;
    double *a = allocate((size_t)n, sizeof *a);
    enum status status = OK;
    /* SLOT 14b(model, dt, u, v, n, a, &status): a[0..n-1] is for the
     * acceleration; model_force(), model_accelerate(). */
    todo("14b", model, dt, u, v, n, a, &status);
    /* END 14b */
    free(a);
    return status;
}

/*
 * Given a method and a state, return the next by one solve: u* is the end of a
 * step d of backward Euler from a state (a, b), and v* = (u* - a) / d.  For
 * BACKWARD_EULER a = u0, b = v0, d = dt, u+ = u*, v+ = v*; IMPLICIT_MIDPOINT
 * has the boundary values half-way; the first step of BDF2, when s->steps is 0,
 * is one of IMPLICIT_MIDPOINT.
 *
 * s     in   state at the beginning
 * g     in   boundary values at the end of the step (NULL: linear model)
 * u, v  out  state at the end, if the status of the report is OK
 */
static struct step_report implicit_step(
    struct model *model, enum method method, double dt, const double g[],
    const struct state *s, double u[], double v[])
{
    const int n = s->n;
    double *a = allocate((size_t)n, sizeof *a);
    double *b = allocate((size_t)n, sizeof *b);
    double *g_mid = allocate((size_t)n, sizeof *g_mid);
    struct step_report report = {.status = OK};
    /* SLOT 14c(model, method, dt, g, s, u, v, n, a, b, g_mid, &report):
     * a, b, d of the method; integrate_solve() with your residual(); u, v from
     * u*, v*. */
    todo("14c", model, method, dt, g, s, u, v, n, a, b, g_mid, &report);
    /* END 14c */
    free(g_mid);
    free(b);
    free(a);
    return report;
}

/*
 * One frame: u, v, v_before of now advance by dt to the boundary values g under
 * the forces f (NULL: none), by backward Euler of step.h [alg:frame]: with
 * FAST, then with ROBUST, then with ROBUST in 2, 4, ... MOST_SUBSTEPS parts,
 * the prescribed values going in a straight line to g.  Of a frame that is
 * lost, now is exactly as it was.  FAST, ROBUST, struct frame: integrate.h.
 */
static struct frame frame_step(struct body *body, double dt, const double g[],
                               const double f[], struct state *now)
{
    struct state start = state_make(now->n);
    double *g_part = allocate((size_t)now->n, sizeof *g_part);
    struct frame frame = {.status = MAX_ITERATIONS};
    /* SLOT 14d(body, dt, g, f, now, &start, g_part, &frame): attempts, one
     * after the other, until one is OK; count in frame what each has cost. */
    todo("14d", body, dt, g, f, now, &start, g_part, &frame);
    /* END 14d */
    state_free(&start);
    free(g_part);
    return frame;
}

/* A loaded bar: q, and the velocity after a step of symplectic Euler. */
static void print_stages(void)
{
    struct model *model = model_bar(4, CONSISTENT);
    struct state s = state_ripple(model);
    for (int i = 0; i < s.n; i++) model->f[i] = 10.0 + i;
    residual(model, 0.01, s.u_before, s.v, s.u, s.v_before);
    table_vector("residual", s.n, s.v_before);
    symplectic_euler(model, 0.01, s.u, s.v);
    table_vector("velocity", s.n, s.v);
    state_free(&s);
    model_free(model);
}

/* A mode, step by step, from u = 1, v = 0; velocities in units of w. */
static void print_mode(double w_dt)
{
    struct model *model = model_mode(1.0);
    struct state s[N_METHOD];
    for (int m = 0; m < N_METHOD; m++) {
        s[m] = state_make(1);
        s[m].u[0] = 1.0;
    }
    table_begin("mode", "k exact symplectic_u symplectic_v backward_u "
                        "backward_v midpoint_u midpoint_v bdf2_u bdf2_v");
    for (int k = 0; k <= 40; k++) {
        table_row(k, cos(k * w_dt), s[0].u[0], s[0].v[0], s[1].u[0], s[1].v[0],
                  s[2].u[0], s[2].v[0], s[3].u[0], s[3].v[0]);
        for (int m = 0; m < N_METHOD; m++)
            integrate_by(symplectic_euler, implicit_step, model,
                         (enum method)m, w_dt, NULL, &s[m]);
    }
    table_end();
    for (int m = 0; m < N_METHOD; m++) state_free(&s[m]);
    model_free(model);
}

/* What each frame of the scripted user takes; u of the middle of the side. */
static void print_frames(int n, enum law law, double reach)
{
    struct user *user = user_alloc(n, law, reach);
    struct state now = state_make(user->n_dof);
    table_begin("frames", "k t motion status first attempts substeps "
                          "iterations factorisations u1 u2 min_J");
    while (user_next(user)) {
        const struct frame frame =
            frame_step(user->body, user->dt, user->g, NULL, &now);
        table_row(user->k, user->t, user->motion, status_name(frame.status),
                  status_name(frame.first), frame.attempts, frame.substeps,
                  frame.iterations, frame.factorisations, now.u[user->side],
                  now.u[user->side + 1], body_min_J(user->body, now.u));
        user_keep(user, now.u);
    }
    table_end();
    user_table(user);
    state_free(&now);
    user_free(user);
}

int main(int argc, char *argv[])
{
    int n = 8, law = 0;
    double w_dt = 0.5, reach = 1.0;
    const struct option options[] = {
        {"wdt", .real = &w_dt, .min = 0.01, .max = 20, .help = "omega dt"},
        {"n", .integer = &n, .min = 2, .max = 32, .help = "squares per side"},
        {"law", .choice = &law, .choices = "log cubic", .help = "material"},
        {"reach", .real = &reach, .max = 1.8, .help = "how far the user goes"},
    };
    options_parse("14_time_step", options, COUNT(options), argc, argv);
    print_stages();
    print_mode(w_dt);
    print_frames(n, law ? CUBIC : LOG, reach);
    return table_finish();
}
