/* integrate.c - see integrate.h. */
#include "motion/integrate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct step_control INTEGRATE_NEWTON = {
    .tolerance = 1e-10, .max_iterations = 30, .guess = FROM_VELOCITY,
    .lift = 1, .chord = 1};
const struct step_control FAST = {
    .tolerance = 1e-8, .max_iterations = 12, .guess = EXTRAPOLATED,
    .lift = 1, .chord = 1};
const struct step_control ROBUST = {
    .tolerance = 1e-8, .max_iterations = 40, .guess = FROM_LAST,
    .lift = 1, .line_search = 1, .projection = ON_DEMAND};

const char *method_name(enum method method)
{
    static const char *const name[] = {"symplectic", "backward", "midpoint",
                                       "bdf2"};
    return name[method];
}

struct state state_make(int n)
{
    const size_t size = (size_t)n;
    return (struct state){n, 0, allocate(size, sizeof(double)),
                          allocate(size, sizeof(double)),
                          allocate(size, sizeof(double)),
                          allocate(size, sizeof(double))};
}

struct state state_ripple(const struct model *model)
{
    struct state s = state_make(model->n_dof);
    for (int i = 0; i < s.n; i++)
        if (!model->body || model->body->equation[i] >= 0)
            s.u[i] = 1e-7 * sin(2.385 * (i + 1) + 0.02 * i * i);
    return s;
}

void state_copy(const struct state *from, struct state *to)
{
    const size_t size = (size_t)from->n * sizeof *to->u;
    to->steps = from->steps;
    memcpy(to->u, from->u, size);
    memcpy(to->v, from->v, size);
    memcpy(to->u_before, from->u_before, size);
    memcpy(to->v_before, from->v_before, size);
}

void state_free(struct state *s)
{
    free(s->u);
    free(s->v);
    free(s->u_before);
    free(s->v_before);
}

enum status state_accept(struct state *s, const double u[], const double v[])
{
    const size_t size = (size_t)s->n * sizeof *u;
    for (int i = 0; i < s->n; i++)
        if (!isfinite(u[i]) || !isfinite(v[i])) return NONFINITE;
    memcpy(s->u_before, s->u, size);
    memcpy(s->v_before, s->v, size);
    memcpy(s->u, u, size);
    memcpy(s->v, v, size);
    s->steps++;
    return OK;
}

enum status integrate_residual(const struct model *model, double dt,
                               const double u0[], const double v0[],
                               const double u[], double q[])
{
    const int n = model->n_dof;
    double *move = allocate((size_t)n, sizeof *move);
    double *force = allocate((size_t)n, sizeof *force);
    for (int i = 0; i < n; i++) move[i] = u[i] - (u0[i] + dt * v0[i]);
    model_mass(model, move, q); /* M (u - u0 - dt v0) */
    const enum status status = model_force(model, u, force);
    for (int i = 0; i < n; i++) q[i] += dt * dt * (force[i] - model->f[i]);
    free(move);
    free(force);
    return status;
}

/* Compute u, v of the next step of SYMPLECTIC_EULER; prescribed entries keep
 * their velocity.  Statuses of model_force(), the state is then of no use. */
static enum status symplectic_euler(const struct model *model, double dt,
                                    double u[], double v[])
{
    const int n = model->n_dof;
    double *a = allocate((size_t)n, sizeof *a);
    const enum status status = model_force(model, u, a);
    for (int i = 0; i < n; i++) a[i] = model->f[i] - a[i];
    model_accelerate(model, a); /* M^-1, 0 where prescribed */
    for (int i = 0; i < n; i++) {
        v[i] += dt * a[i];
        u[i] += dt * v[i]; /* of the new v */
    }
    free(a);
    return status;
}

struct step_report integrate_solve(struct model *model,
                                   residual_function *residual, double d,
                                   const double a[], const double b[],
                                   const double g[], double u[])
{
    if (model->solve) return model->solve(model, d, a, b, g, u);
    const size_t n = (size_t)model->n_dof;
    double *room = allocate(n, sizeof *room);
    struct step_report report = {.status = OK};
    if (model->body) {
        memcpy(u, a, n * sizeof *u);
        memcpy(room, b, n * sizeof *u); /* a copy: the step changes v */
        report = step_backward_euler(model->body, &INTEGRATE_NEWTON, d, g,
                                     model->f, u, room, NULL);
    } else { /* room is 0 */
        report.status = residual(model, d, a, b, room, u);
        if (report.status == OK) report = model_newton(model, d, u);
    }
    free(room);
    return report;
}

/* u, v := the end of the next step from s by an implicit method; g are the
 * boundary values at its end (NULL: linear model). */
static struct step_report implicit_step(struct model *model,
                                        enum method method, double dt,
                                        const double g[],
                                        const struct state *s, double u[],
                                        double v[])
{
    const int n = s->n, first = s->steps == 0;
    const int midpoint =
        method == IMPLICIT_MIDPOINT || (method == BDF2 && first);
    const int bdf2 = method == BDF2 && !first;
    const double d = midpoint ? 0.5 * dt : bdf2 ? 2.0 * dt / 3.0 : dt;
    double *a = allocate((size_t)n, sizeof *a);
    double *b = allocate((size_t)n, sizeof *b);
    double *g_mid = allocate((size_t)n, sizeof *g_mid);

    for (int i = 0; i < n; i++) {
        /* backward Euler goes from (a, b) by d */
        a[i] = bdf2 ? (4.0 * s->u[i] - s->u_before[i]) / 3.0 : s->u[i];
        b[i] = bdf2 ? (4.0 * s->v[i] - s->v_before[i]) / 3.0 : s->v[i];
        if (g) g_mid[i] = 0.5 * (s->u[i] + g[i]);
    }
    const struct step_report report = integrate_solve(
        model, integrate_residual, d, a, b, g && midpoint ? g_mid : g, u);
    for (int i = 0; i < n; i++) {
        v[i] = (u[i] - a[i]) / d;
        if (midpoint) { /* u* and v* are half-way */
            u[i] = 2.0 * u[i] - s->u[i];
            v[i] = 2.0 * v[i] - s->v[i];
        }
    }
    free(a);
    free(b);
    free(g_mid);
    return report;
}

struct step_report integrate_by(explicit_function *explicit,
                                implicit_function *implicit,
                                struct model *model, enum method method,
                                double dt, const double g[], struct state *s)
{
    struct state next = state_make(s->n);
    struct step_report report = {.status = OK};
    state_copy(s, &next);
    if (method == SYMPLECTIC_EULER)
        report.status = explicit(model, dt, next.u, next.v);
    else
        report = implicit(model, method, dt, g, s, next.u, next.v);
    if (report.status == OK) report.status = state_accept(s, next.u, next.v);
    state_free(&next);
    return report;
}

struct step_report integrate_step(struct model *model, enum method method,
                                  double dt, const double g[],
                                  struct state *s)
{
    return integrate_by(symplectic_euler, implicit_step, model, method, dt, g,
                        s);
}

/* Go from `start` to g in `parts` steps of backward Euler; false when one of
 * them has failed.  Eight parameters: those of a frame, and how it is tried. */
static int attempt(struct body *body, const struct step_control *control,
                   int parts, double dt, const double g[],
                   const struct state *start, struct state *now,
                   struct frame *frame)
{
    double *g_part = allocate((size_t)now->n, sizeof *g_part);
    frame->substeps = parts;
    frame->attempts++;
    for (int k = 1; k <= parts; k++) {
        for (int i = 0; i < now->n; i++)
            /* u0 + k / parts (g - u0), and at the end g without round-off */
            g_part[i] = k == parts ? g[i]
                                   : start->u[i] + (double)k / parts *
                                                       (g[i] - start->u[i]);
        const struct step_report report =
            step_backward_euler(body, control, dt / parts, g_part, NULL, now->u,
                                now->v, now->v_before);
        frame->status = report.status;
        frame->iterations += report.iterations;
        frame->factorisations += report.factorisations;
        if (report.status != OK) break;
    }
    free(g_part);
    if (frame->status != OK) state_copy(start, now);
    return frame->status == OK;
}

struct frame integrate_frame(struct body *body, double dt, const double g[],
                             struct state *now)
{
    struct state start = state_make(now->n);
    struct frame frame = {.status = OK};
    state_copy(now, &start);
    int done = attempt(body, &FAST, 1, dt, g, &start, now, &frame);
    frame.first = frame.status;
    for (int parts = 1; !done && parts <= MOST_SUBSTEPS; parts *= 2)
        done = attempt(body, &ROBUST, parts, dt, g, &start, now, &frame);
    state_free(&start);
    return frame;
}
