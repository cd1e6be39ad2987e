/* step.c - see step.h. */
#include "plane/step.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct step_control step_method(const char *name)
{
    static const struct {
        const char *name;
        struct step_control control;
    } method[] = {
        {"notes", {1e-10, 40, FROM_LAST, 0, 0, 0, NEVER}},
        {"search", {1e-10, 40, FROM_LAST, 0, 0, 1, NEVER}},
        {"demand", {1e-10, 100, FROM_LAST, 0, 0, 0, ON_DEMAND}},
        {"demand+search", {1e-10, 2000, FROM_LAST, 0, 0, 1, ON_DEMAND}},
        {"always+search", {1e-10, 2000, FROM_LAST, 0, 0, 1, ALWAYS}},
        {"lift", {1e-10, 40, EXTRAPOLATED, 1, 0, 0, NEVER}},
        {"lift+search", {1e-10, 40, EXTRAPOLATED, 1, 0, 1, NEVER}},
        {"all", {1e-10, 300, EXTRAPOLATED, 1, 0, 1, ON_DEMAND}},
    };
    for (size_t k = 0; k < sizeof method / sizeof *method; k++)
        if (strcmp(name, method[k].name) == 0) return method[k].control;
    die("there is no method %s", name);
}

enum status step_potential(const struct body *body, struct incremental Phi,
                           const double u[], double room[], double *phi,
                           double *noise)
{
    const int n_dof = 2 * body->mesh->n_vertex;
    double *move = room, *momentum = room + n_dof, kinetic = 0.0, power = 0.0;
    const double dt = Phi.dt;
    double elastic;
    const enum status status = body_energy(body, u, &elastic);
    if (status != OK) return status;
    for (int r = 0; r < n_dof; r++) {
        move[r] = Phi.w ? u[r] - Phi.w[r] : 0.0;
        if (Phi.f) power += Phi.f[r] * u[r];
    }
    body_mass(body, move, momentum);
    /* (u - w).M (u - w) / 2 */
    for (int r = 0; r < n_dof; r++) kinetic += 0.5 * move[r] * momentum[r];
    *phi = kinetic + dt * dt * (elastic - power);
    *noise = kinetic + dt * dt * (fabs(elastic) + fabs(power));
    return isfinite(*phi) ? OK : NONFINITE;
}

/* The memory of one solve, in vectors over all vertices. */
struct room {
    double *q, *du, *trial, *twice; /* twice: [4 n_vertex] */
};

/* u := u + length du with the first length 1, 1/2, 1/4, ... at which Phi is
 * defined and decreases (Armijo, 1e-4 of the slope q.du) [alg:line-search];
 * *halved says whether it is not 1.  Near the minimum Phi, which is a small sum
 * of large terms where the body has turned, has no digits left to compare. */
static enum status line_search(const struct body *body, struct incremental Phi,
                               struct room room, double u[], int *halved)
{
    const int n_dof = 2 * body->mesh->n_vertex;
    const double terms = Phi.dt * Phi.dt * body->total_area *
                         material_modulus(&body->material);
    double slope = 0.0, longest = 0.0, start, noise, phi, unused;
    for (int r = 0; r < n_dof; r++) {
        slope += room.q[r] * room.du[r];
        longest = fmax(longest, fabs(room.du[r]));
    }
    if (slope > 0.0) return NOT_SPD; /* uphill */
    *halved = 0;
    /* so short that Phi decreases by less than the round-off of its terms */
    if (-slope <= 16.0 * DBL_EPSILON * terms &&
        longest * longest <= 1e-12 * body->total_area) {
        for (int r = 0; r < n_dof; r++) u[r] += room.du[r];
        return OK;
    }
    enum status status =
        step_potential(body, Phi, u, room.twice, &start, &noise);
    if (status != OK) return status;
    for (double length = 1.0; length > 1e-12; length *= 0.5) {
        for (int r = 0; r < n_dof; r++)
            room.trial[r] = u[r] + length * room.du[r];
        *halved = length < 1.0;
        status =
            step_potential(body, Phi, room.trial, room.twice, &phi, &unused);
        if (status == OK && phi <= start + 1e-4 * length * slope +
                                       16.0 * DBL_EPSILON * noise) {
            memcpy(u, room.trial, (size_t)n_dof * sizeof *u);
            return OK;
        }
    }
    return STALLED;
}

enum status step_search(const struct body *body, struct incremental Phi,
                        const double q[], const double du[], double u[])
{
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    /* one block: the room of one solve, made and freed as one */
    double *memory = allocate(5 * n_dof, sizeof *memory);
    const struct room room = {memory, memory + n_dof, memory + 2 * n_dof,
                              memory + 3 * n_dof};
    int halved;
    memcpy(room.q, q, n_dof * sizeof *q);
    memcpy(room.du, du, n_dof * sizeof *du);
    const enum status status = line_search(body, Phi, room, u, &halved);
    free(memory);
    return status;
}

/* Return whether the factors in K are still good for Phi [alg:kept]. */
static int is_usable(const struct body *body, struct incremental Phi)
{
    const struct kept *kept = &body->kept;
    return kept->usable && body->K->storage == SPARSE &&
           (kept->systems <= KEPT_SYSTEMS ||
            kept->systems <= kept->least + 1) &&
           kept->dt == Phi.dt && kept->moving == (Phi.w != NULL);
}

/* Remember that K, assembled at u, has been factored. */
static void keep(struct body *body, struct incremental Phi, const double u[])
{
    body->kept.usable = 1;
    body->kept.moving = Phi.w != NULL;
    body->kept.dt = Phi.dt;
    body->kept.least = INT_MAX - 1;
    body_turned(body, u, body->kept.turned);
}

/* Set the angle by which u has turned the body since K was factored. */
static void turn(struct body *body, const double u[])
{
    struct kept *kept = &body->kept;
    double now[2];
    body_turned(body, u, now);
    /* cosine and sine of the difference of two angles */
    kept->by[0] = now[0] * kept->turned[0] + now[1] * kept->turned[1];
    kept->by[1] = now[1] * kept->turned[0] - now[0] * kept->turned[1];
}

/* b := -R^T q of the free unknowns, R = (c -s; s c) at all vertices. */
static void right_side(const struct body *body, const double q[], double b[])
{
    const double c = body->kept.by[0], s = body->kept.by[1];
    for (int r = 0; r < 2 * body->mesh->n_vertex; r += 2) {
        const int k = body->equation[r];
        if (k < 0) continue;
        b[k] = -(c * q[r] + s * q[r + 1]);
        b[k + 1] = -(c * q[r + 1] - s * q[r]);
    }
}

/*
 * Factor K, which has been assembled at u, and b := -K^-1 q.  When it is not
 * SPD: project it, or solve without factors that could be kept, or give up.
 */
static enum status factor(struct body *body, const struct step_control *control,
                          struct incremental Phi, const double u[], double q[],
                          struct step_report *report, double b[])
{
    const int on_demand = control->projection == ON_DEMAND;
    body->kept.by[0] = 1.0, body->kept.by[1] = 0.0;
    report->factorisations++;
    report->projections += control->projection == ALWAYS;
    right_side(body, q, b);
    enum status status = matrix_factor_solve(body->K, b);
    if (status != OK && on_demand) {
        report->factorisations++;
        report->projections++;
        body_assemble(body, Phi, u, PROJECTED, q);
        right_side(body, q, b);
        status = matrix_factor_solve(body->K, b);
    }
    if (status == OK && control->chord) keep(body, Phi, u);
    if (status == OK || control->projection != NEVER || control->line_search)
        return status;
    report->indefinite++;
    body_assemble(body, Phi, u, EXACT, q);
    right_side(body, q, b);
    return matrix_solve_indefinite(body->K, b, NULL);
}

/* du := R b, 0 at prescribed vertices.  Returns the largest |du|, INFINITY
 * where du is not finite. */
static double increment(const struct body *body, const double b[], double du[])
{
    const int n_dof = 2 * body->mesh->n_vertex;
    const double c = body->kept.by[0], s = body->kept.by[1];
    for (int r = 0; r < n_dof; r += 2) {
        const int k = body->equation[r];
        du[r] = k >= 0 ? c * b[k] - s * b[k + 1] : 0.0;
        du[r + 1] = k >= 0 ? s * b[k] + c * b[k + 1] : 0.0;
    }
    return body_max_free(body, du);
}

/* Solve as step_solve(), the first system with new factors if `fresh`, else
 * with those that there are; report goes on. */
static void newton(struct body *body, const struct step_control *control,
                   struct incremental Phi, struct room room, int fresh,
                   double u[], struct step_report *report)
{
    const int n_dof = 2 * body->mesh->n_vertex;
    const enum tangent kind = control->projection == ALWAYS ? PROJECTED : EXACT;
    double *scale = &body->kept.scale, *q = room.q, *b = room.trial;
    int halved = 0;

    report->increment = INFINITY;
    if (!fresh) turn(body, u);
    for (;;) {
        const double before = report->increment;
        const int small = before <= control->tolerance;
        report->status = body_assemble(body, Phi, u,
                                       fresh && !small ? kind : NO_TANGENT, q);
        if (report->status != OK) return;
        if (fresh && !small) *scale = matrix_max_diagonal(body->K);
        report->residual = body_max_free(body, q) / *scale;
        if (small && report->residual <= control->tolerance) return;
        /* |du| cannot change u any more, and still q is not small */
        report->status = STALLED;
        if (before <= DBL_EPSILON) return;
        report->status = MAX_ITERATIONS;
        if (report->iterations == control->max_iterations) return;

        report->status = OK;
        if (fresh && small) body_assemble(body, Phi, u, kind, q);
        if (fresh) {
            report->status = factor(body, control, Phi, u, q, report, b);
        } else {
            right_side(body, q, b);
            matrix_solve(body->K, b);
        }
        if (report->status != OK) return;
        const double size = increment(body, b, room.du);
        report->status = isinf(size) ? NONFINITE : OK;
        if (report->status != OK) return;
        report->iterations++;
        report->increment = size;
        if (control->line_search)
            report->status = line_search(body, Phi, room, u, &halved);
        else
            for (int r = 0; r < n_dof; r++) u[r] += room.du[r];
        if (report->status != OK) return;
        fresh = !body->kept.usable || halved || size > 0.3 * before;
    }
}

struct step_report step_solve(struct body *body,
                              const struct step_control *control,
                              struct incremental Phi, double u[])
{
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    double *memory = body->room, *start = memory + 5 * n_dof;
    const struct room room = {memory, memory + n_dof, memory + 2 * n_dof,
                              memory + 3 * n_dof};
    struct kept *kept = &body->kept;
    struct step_report report = {.status = OK};
    if (body->K->storage == SPARSE)
        matrix_keep_single(body->K, control->chord);
    const int old = control->chord && is_usable(body, Phi);
    kept->usable = old;
    memcpy(start, u, n_dof * sizeof *u);
    newton(body, control, Phi, room, !old, u, &report);
    kept->systems = report.iterations;
    /* it may be the old factors' fault */
    if (old && report.status != OK &&
        report.iterations < control->max_iterations) {
        memcpy(u, start, n_dof * sizeof *u);
        kept->usable = 0;
        newton(body, control, Phi, room, 1, u, &report);
        kept->systems = report.iterations - kept->systems;
    }
    if (report.status != OK) kept->usable = 0;
    if (kept->systems < kept->least) kept->least = kept->systems;
    return report;
}

enum status step_certify(struct body *body, struct incremental Phi,
                         const double u[])
{
    double *q = allocate(2 * (size_t)body->mesh->n_vertex, sizeof *q);
    enum status status = body_assemble(body, Phi, u, EXACT, q);
    if (status == OK && matrix_factor(body->K) != OK) status = SADDLE;
    free(q);
    return status;
}

void step_boundary(const struct body *body, const double g[], int lift,
                   double u[])
{
    const double *X = body->mesh->X;
    const int n = body->mesh->n;
    const double width = X[2 * n] - X[0];
    for (int j = 0; j <= body->mesh->rows; j++)
        for (int k = 0; k < 2; k++) {
            const int left = 2 * j * (n + 1) + k, right = left + 2 * n;
            const int held[2] = {body->equation[left] < 0,
                                 body->equation[right] < 0};
            const double jump[2] = {held[0] ? g[left] - u[left] : 0.0,
                                    held[1] ? g[right] - u[right] : 0.0};
            for (int i = 0; i <= n; i++) {
                const int r = left + 2 * i;
                const double fraction = body->mesh->graded
                                          ? (X[r - k] - X[0]) / width
                                          : (double)i / n;
                /* constant beyond the only end that is held */
                const double s = held[0] && held[1] ? fraction : held[1];
                if (body->equation[r] < 0)
                    u[r] = g[r];
                else if (lift)
                    u[r] += (1.0 - s) * jump[0] + s * jump[1];
            }
        }
}

/* next := where the velocities so far lead, w + dt (d1 + ... + d(order - 1)):
 * dj are their backward differences, d1 the caller's, the others the body's, 0
 * where v is not what its last step left [alg:extrapolated]. */
static void extrapolate(struct body *body, double dt, const double v[],
                        const double v_before[], const double w[],
                        double next[])
{
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    struct past *past = &body->past;
    if (past->dt != dt || memcmp(past->v, v, n_dof * sizeof *v) != 0) {
        for (int j = 2; j <= PAST_ORDER; j++)
            memset(past->d[j], 0, n_dof * sizeof *v);
        past->order = 2;
    }
    for (size_t r = 0; r < n_dof; r++) {
        double sum = v[r] - v_before[r];
        for (int j = 2; j < past->order; j++) sum += past->d[j][r];
        next[r] = w[r] + dt * sum;
    }
}

/* The step from v has ended with the velocity `end`, whose d(k) is the error of
 * the guess of order k (over dt).  The order goes up from 2 to each that would
 * have been at least twice as close. */
static void remember(struct body *body, double dt, const double v[],
                     const double v_before[], const double end[])
{
    const int n_dof = 2 * body->mesh->n_vertex;
    struct past *past = &body->past;
    double error[PAST_ORDER + 1] = {0.0};
    for (int r = 0; r < n_dof; r++) {
        double old = v[r] - v_before[r], new = end[r] - v[r];
        for (int j = 2; j <= PAST_ORDER; j++) {
            new -= old; /* dj = d(j-1) now - d(j-1) before */
            old = past->d[j][r];
            past->d[j][r] = new;
            error[j] += new * new;
        }
        past->v[r] = end[r];
    }
    past->dt = dt;
    past->order = 2;
    for (int j = 3; j <= PAST_ORDER; j++) /* of squares: 0.25 is (1/2)^2 */
        if (error[j] < 0.25 * error[past->order]) past->order = j;
}

struct step_report step_backward_euler(struct body *body,
                                       const struct step_control *control,
                                       double dt, const double g[],
                                       const double f[], double u[],
                                       double v[], double v_before[])
{
    const int n_dof = 2 * body->mesh->n_vertex;
    const enum guess guess = control->guess;
    double *w = body->room + 6 * n_dof; /* behind what step_solve() takes */
    double *next = w + n_dof;
    for (int r = 0; r < n_dof; r++) {
        w[r] = u[r] + dt * v[r];
        next[r] = guess == FROM_LAST ? u[r] : w[r];
    }
    if (guess == EXTRAPOLATED) extrapolate(body, dt, v, v_before, w, next);
    step_boundary(body, g, control->lift, next);
    const struct step_report report = step_solve(
        body, control, (struct incremental){dt, w, f}, next);
    if (report.status != OK) return report;
    for (int r = 0; r < n_dof; r++) w[r] = (next[r] - u[r]) / dt;
    if (guess == EXTRAPOLATED) remember(body, dt, v, v_before, w);
    for (int r = 0; r < n_dof; r++) {
        if (v_before) v_before[r] = v[r];
        v[r] = w[r];
        u[r] = next[r];
    }
    return report;
}
