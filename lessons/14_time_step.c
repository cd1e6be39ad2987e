/*
 * 13_time_step.c - time: four integrators, what each loses, and the loop that
 * has a thirtieth of a second for a frame.
 *
 * Notes: Lecture 1, "Time stepping" (the backward Euler residual and the loop);
 * Lecture 2, introduction of section 3.
 *
 * Problem.  M u'' = f - dPsi/du, with u given at some vertices at every time.
 * Three systems, one code: a single mode u'' = -w^2 u, a linear bar fixed at
 * one end, and the nonlinear square of body.h.
 *
 *     frame     0         1         2         3       all implicit methods are
 *     time      |----+----|----+----|----+----|--     one: backward Euler from
 *               u0  u_m   u+                          some state (a, b), by
 *               BDF2: from (4 u0 - u_1) / 3, by 2/3   some step [eq:one-solve]
 *
 * Measured: growth a step, energy, the largest stable step, orders with their
 * constants, error against seconds, and the frames of a scripted user.
 *
 * Run       make lesson-13, or with options: -h lists them
 * Expect    mode 1 of the bar keeps 46.2 % of its amplitude a frame under
 *           backward Euler; symplectic Euler of the square, n = 8: stable up to
 *           4.880e-3 s lumped, 2.804e-3 s consistent
 * Plot: mode k backward_u
 */
#include "body.h"
#include "clock.h"
#include "options.h"
#include "step.h"
#include "table.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- what moves --------------------------------------------------------- */

/* One of three systems.  Vectors over all its numbers have n_dof entries. */
struct model {
    int n_dof;
    struct body *body;       /* NULL: linear, Psi = u.A u / 2; owned */
    struct mesh *mesh;       /* of the body; owned */
    struct matrix *M, *A;    /* mass, and stiffness at rest, of what is free */
    struct matrix *M_factor; /* Cholesky factors of M */
    struct matrix *K;        /* linear: factors of M + K_step^2 A, or NULL */
    double K_step;
    double *f;               /* nodal forces (N), 0 unless set; owned */
    struct step_control control;
};

/* Displacement (m) and velocity (m/s), now and one step before. */
struct state {
    int n, steps; /* steps made */
    double *u, *v, *u_before, *v_before;
};

enum method { SYMPLECTIC, BACKWARD, MIDPOINT, BDF2, N_METHOD };

static struct state state_make(int n)
{
    double *memory = allocate(4 * (size_t)n, sizeof *memory);
    return (struct state){n, 0, memory, memory + n, memory + 2 * n,
                          memory + 3 * n};
}

static void state_copy(const struct state *from, struct state *to)
{
    to->steps = from->steps;
    memcpy(to->u, from->u, 4 * (size_t)from->n * sizeof *to->u);
}

static void state_free(struct state *s)
{
    free(s->u);
}

/* out := M v */
static void mass_times(const struct model *model, const double v[],
                       double out[])
{
    if (model->body)
        body_mass(model->body, v, out);
    else
        matrix_multiply(model->M, v, out);
}

/* out := dPsi/du, without f; the body's status when it has none there. */
static enum status elastic_force(const struct model *model, const double u[],
                                 double out[])
{
    if (model->body) /* with w = u there is no inertia in q */
        return body_assemble(model->body, 1.0, u, NULL, u, NO_TANGENT, out);
    matrix_multiply(model->A, u, out);
    return OK;
}

/* r := M^-1 r of what is free, 0 at what is prescribed. */
static void accelerate(const struct model *model, double r[])
{
    if (!model->body) {
        matrix_solve(model->M_factor, r);
        return;
    }
    double *b = allocate((size_t)model->M->n, sizeof *b);
    const int *equation = model->body->equation;
    for (int i = 0; i < model->n_dof; i++)
        if (equation[i] >= 0) b[equation[i]] = r[i];
    matrix_solve(model->M_factor, b);
    for (int i = 0; i < model->n_dof; i++)
        r[i] = equation[i] >= 0 ? b[equation[i]] : 0.0;
    free(b);
}

/* v.M v / 2 + Psi(u) - f.u; infinite where Psi is not defined. */
static double total_energy(const struct model *model, const double u[],
                           const double v[])
{
    double *out = allocate((size_t)model->n_dof, sizeof *out), energy = 0.0;
    if (model->body) {
        if (body_energy(model->body, u, &energy) != OK) energy = INFINITY;
    } else {
        matrix_multiply(model->A, u, out);
        for (int i = 0; i < model->n_dof; i++) energy += 0.5 * u[i] * out[i];
    }
    mass_times(model, v, out);
    for (int i = 0; i < model->n_dof; i++)
        energy += 0.5 * v[i] * out[i] - model->f[i] * u[i];
    free(out);
    return energy;
}

/* ---- one step ----------------------------------------------------------- */

/*
 * The residual of a step of backward Euler [eq:time-residual]:
 *
 *     q = M (u - u0 - dt v0) + dt^2 (dPsi/du(u) - f)
 *
 * u0, v0  in   state at the beginning of the step
 * u       in   a candidate for the end of the step
 * q       out  0 for the right one; f is model->f
 *
 * Status of elastic_force(); q is then incomplete.
 */
static enum status residual(const struct model *model, double dt,
                            const double u0[], const double v0[],
                            const double u[], double q[])
{
    const int n = model->n_dof;
    double *move = allocate((size_t)n, sizeof *move);
    double *force = allocate((size_t)n, sizeof *force);
    enum status status = OK;
    /* SLOT 13a(model, dt, u0, v0, u, q, n, move, force, &status): q[0..n-1],
     * by mass_times() and elastic_force() [eq:time-residual]. */
    todo("13a", model, dt, u0, v0, u, q, n, move, force, &status);
    /* END 13a */
    free(move);
    free(force);
    return status;
}

/*
 * u := the end of a step dt of backward Euler from the state (u0, v0), with the
 * boundary values g [eq:one-solve]; g is not looked at by linear models.
 *
 * The body: Newton's method from u0 + dt v0, the jump of the boundary values
 * spread (step.h).  Linear: q is linear in u, so one Newton step from 0 is
 * exact, u = -(M + dt^2 A)^-1 q(0), and the factors last as long as dt does.
 */
static struct step_report solve(struct model *model, double dt,
                                const double u0[], const double v0[],
                                const double g[], double u[])
{
    struct step_report report = {.status = OK, .iterations = 1};
    const size_t n = (size_t)model->n_dof;

    if (model->body) {
        double *w = allocate(n, sizeof *w);
        for (size_t i = 0; i < n; i++) u[i] = w[i] = u0[i] + dt * v0[i];
        step_boundary(model->body, g, model->control.lift, u);
        report = step_solve(model->body, &model->control, dt, w, model->f, u);
        free(w);
        return report;
    }
    if (!model->K || model->K_step != dt) {
        matrix_free(model->K);
        model->K = matrix_copy(model->M);
        model->K_step = dt;
        for (size_t i = 0; i < n * model->K->stride; i++)
            model->K->a[i] += dt * dt * model->A->a[i];
        report.status = matrix_factor(model->K);
        report.factorisations = 1;
    }
    double *zero = allocate(n, sizeof *zero);
    if (report.status == OK)
        report.status = residual(model, dt, u0, v0, zero, u);
    if (report.status == OK) matrix_solve(model->K, u);
    for (size_t i = 0; i < n; i++) u[i] = -u[i];
    free(zero);
    return report;
}

/*
 * Symplectic Euler, nothing to be solved [eq:symplectic-euler]:
 *
 *     v+ = v + dt M^-1 (f - dPsi/du(u)),   u+ = u + dt v+
 *
 * u, v  in/out  state; what is prescribed keeps its velocity
 *
 * Status of elastic_force(), the state then being of no use.
 */
static enum status symplectic_euler(const struct model *model, double dt,
                                    double u[], double v[])
{
    const int n = model->n_dof;
    double *a = allocate((size_t)n, sizeof *a);
    enum status status = OK;
    /* SLOT 13b(model, dt, u, v, n, a, &status, accelerate): a[0..n-1] is for
     * the acceleration; elastic_force(), accelerate() [eq:symplectic-euler]. */
    todo("13b", model, dt, u, v, n, a, &status, accelerate);
    /* END 13b */
    free(a);
    return status;
}

/*
 * The three implicit methods as one solve [eq:one-solve]: from a state (a, b)
 * by a step d, u* = solve(d, a, b) and v* = (u* - a) / d.
 *
 *     BACKWARD  a = u0, b = v0, d = dt;  u+ = u*, v+ = v*
 *     MIDPOINT  a = u0, b = v0, d = dt/2, boundary values half-way;
 *               u+ = 2 u* - u0, v+ = 2 v* - v0
 *     BDF2      a = (4 u0 - u_before) / 3, b = (4 v0 - v_before) / 3,
 *               d = 2 dt / 3;  u+ = u*, v+ = v*; its first step, which has
 *               nothing before it, is one of MIDPOINT
 *
 * s     in   state at the beginning; s->steps == 0: no step was made yet
 * g     in   boundary values at the end of the step (NULL: linear model)
 * u, v  out  state at the end, if the status of the report is OK
 */
static struct step_report implicit_step(struct model *model,
                                        enum method method, double dt,
                                        const double g[],
                                        const struct state *s, double u[],
                                        double v[])
{
    const int n = s->n;
    double *a = allocate(3 * (size_t)n, sizeof *a);
    double *b = a + n, *g_mid = b + n;
    struct step_report report = {.status = OK};
    /* SLOT 13c(model, method, dt, g, s, u, v, n, a, b, g_mid, &report, solve):
     * a, b, d of the method; solve(); u, v from u*, v* [eq:one-solve]. */
    todo("13c", model, method, dt, g, s, u, v, n, a, b, g_mid, &report, solve);
    /* END 13c */
    free(a);
    return report;
}

/* One step of any method; the state stays as it was when it is not OK. */
static struct step_report advance(struct model *model, enum method method,
                                  double dt, const double g[],
                                  struct state *s)
{
    const size_t size = (size_t)s->n * sizeof(double);
    double *u = allocate(2 * (size_t)s->n, sizeof *u), *v = u + s->n;
    struct step_report report = {.status = OK};

    if (method == SYMPLECTIC) {
        memcpy(u, s->u, size);
        memcpy(v, s->v, size);
        report.status = symplectic_euler(model, dt, u, v);
    } else {
        report = implicit_step(model, method, dt, g, s, u, v);
    }
    for (int i = 0; i < s->n && report.status == OK; i++)
        if (!isfinite(u[i]) || !isfinite(v[i])) report.status = NONFINITE;
    if (report.status == OK) {
        memcpy(s->u_before, s->u, size);
        memcpy(s->v_before, s->v, size);
        memcpy(s->u, u, size);
        memcpy(s->v, v, size);
        s->steps++;
    }
    free(u);
    return report;
}

/* ---- a frame of the loop ------------------------------------------------ */

/* First what is fast; then what goes downhill from a state that exists: after a
 * sudden stop the velocity points the wrong way. */
static const struct step_control FAST = {1e-8, 12, EXTRAPOLATED, 1, 1, 0,
                                         NEVER};
static const struct step_control ROBUST = {1e-8, 40, FROM_LAST, 1, 0, 1,
                                           ON_DEMAND};
enum { MOST_SUBSTEPS = 8 };

struct frame {
    enum status status; /* of the last attempt; not OK: the frame is lost */
    enum status first;  /* of the fast attempt: why there were others */
    int substeps;       /* 1, or into how many the frame was cut */
    int attempts;
    int iterations, factorisations; /* of all attempts together */
};

/*
 * One frame: u and v advance by dt to the boundary values g [alg:frame].
 * Backward Euler of step.h, tried with FAST, then with ROBUST, then ROBUST in
 * 2, 4, ... MOST_SUBSTEPS sub-steps, the prescribed values going in a straight
 * line to g.
 *
 * now  in/out  u, v and v_before; exactly as it was when the frame is lost
 */
static struct frame frame_step(struct body *body, double dt, const double g[],
                               const double f[], struct state *now)
{
    struct state start = state_make(now->n);
    double *g_part = allocate((size_t)now->n, sizeof *g_part);
    struct frame frame = {.status = MAX_ITERATIONS};
    /* SLOT 13d(body, dt, g, f, now, &start, g_part, &frame): attempts, one
     * after the other, until one is OK; count in frame what each has cost. */
    todo("13d", body, dt, g, f, now, &start, g_part, &frame);
    /* END 13d */
    state_free(&start);
    free(g_part);
    return frame;
}

/* ---- the three systems -------------------------------------------------- */

static struct material notes_material(enum law law)
{
    return material_make(law, 1000.0, 0.3);
}

static void factor_mass(struct model *model)
{
    model->M_factor = matrix_copy(model->M);
    const enum status status = matrix_factor(model->M_factor);
    if (status != OK) die("the mass matrix is %s", status_name(status));
}

static void model_free(struct model *model)
{
    body_free(model->body);
    mesh_free(model->mesh);
    matrix_free(model->M);
    matrix_free(model->A);
    matrix_free(model->M_factor);
    matrix_free(model->K);
    free(model->f);
}

/* u'' = -omega^2 u: unit mass, one number. */
static struct model mode_make(double omega)
{
    struct model model = {.n_dof = 1, .f = allocate(1, sizeof(double))};
    model.M = matrix_alloc(BANDED, 1, 0);
    model.A = matrix_alloc(BANDED, 1, 0);
    matrix_add(model.M, 0, 0, 1.0);
    matrix_add(model.A, 0, 0, omega * omega);
    factor_mass(&model);
    return model;
}

/* Linear bar 0 < X < 1, u(0) = 0: the unknowns are nodes 1..n [eq:mass]. */
static struct model bar_make(int n, enum mass mass)
{
    const struct material material = notes_material(LINEAR);
    const double h = 1.0 / n, k = material_modulus(&material) / h;
    const double same = mass == LUMPED ? h / 2.0 : h / 3.0;
    struct model model = {.n_dof = n};

    model.f = allocate((size_t)n, sizeof(double));
    model.M = matrix_alloc(BANDED, n, n > 1);
    model.A = matrix_alloc(BANDED, n, n > 1);
    for (int e = 0; e < n; e++)
        for (int a = 0; a < 2; a++)
            for (int b = 0; b < 2; b++) {
                const int i = e - 1 + a, j = e - 1 + b;
                if (i < 0 || j < 0) continue;
                matrix_add(model.A, i, j, a == b ? k : -k);
                matrix_add(model.M, i, j, a == b ? same : h / 2.0 - same);
            }
    factor_mass(&model);
    return model;
}

/* Mass and stiffness at rest of the free unknowns, as the body numbers them,
 * from K = M + dt^2 A at dt = 0 and 1; symplectic_euler() needs them. */
static void square_matrices(struct model *model)
{
    double *rest = allocate(2 * (size_t)model->n_dof, sizeof *rest);
    double *q = rest + model->n_dof;
    struct matrix *K = model->body->K;
    body_assemble(model->body, 0.0, rest, NULL, rest, EXACT, q);
    model->M = matrix_copy(K);
    body_assemble(model->body, 1.0, rest, NULL, rest, EXACT, q);
    model->A = matrix_copy(K);
    for (size_t i = 0; i < (size_t)K->n * K->stride; i++)
        model->A->a[i] -= model->M->a[i];
    factor_mass(model);
    free(rest);
}

/* The square, sides X1 = -1 and (held == 2) X1 = 1 prescribed, density 1;
 * without the matrices of square_matrices(). */
static struct model square_make(int n, struct material material,
                                enum mass mass, int held)
{
    struct model model = {.mesh = mesh_square(n),
                          .control = {1e-10, 30, FROM_VELOCITY, 1, 1, 0,
                                      NEVER}};
    int *fixed = allocate((size_t)model.mesh->n_vertex, sizeof *fixed);
    model.n_dof = 2 * model.mesh->n_vertex;
    model.f = allocate((size_t)model.n_dof, sizeof(double));
    for (int a = 0; a < model.mesh->n_vertex; a++)
        fixed[a] = a % (n + 1) == 0 || (held == 2 && a % (n + 1) == n);
    model.body = body_alloc(model.mesh, material, 1.0, mass, fixed);
    free(fixed);
    return model;
}

/* ---- a mode: what one step does ----------------------------------------- */

/*
 * The spectral radius of one step of u'' = -u, dt = w_dt: the largest modulus
 * of an eigenvalue of the 4x4 matrix that maps (u, v, u_before, v_before) of
 * one time to those of the next [eq:amplification].
 */
static double spectral_radius(enum method method, double w_dt)
{
    struct model model = mode_make(1.0);
    struct state s = state_make(1);
    gsl_matrix *G = gsl_matrix_alloc(4, 4);
    gsl_vector_complex *value = gsl_vector_complex_alloc(4);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(4);
    double radius = 0.0;

    for (size_t c = 0; c < 4; c++) {
        for (size_t r = 0; r < 4; r++) s.u[r] = r == c;
        s.steps = 1;
        const struct step_report report =
            advance(&model, method, w_dt, NULL, &s);
        if (report.status != OK)
            die("a step of a mode is %s", status_name(report.status));
        for (size_t r = 0; r < 4; r++) gsl_matrix_set(G, r, c, s.u[r]);
    }
    gsl_eigen_nonsymm(G, value, work);
    for (size_t c = 0; c < 4; c++)
        radius = fmax(radius,
                      hypot(value->data[2 * c], value->data[2 * c + 1]));
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(value);
    gsl_matrix_free(G);
    state_free(&s);
    model_free(&model);
    return radius;
}

static void print_amplification(void)
{
    table_begin("amplification", "w_dt symplectic backward midpoint bdf2");
    for (int k = 0; k <= 96; k++) {
        const double w_dt = pow(10.0, -2.0 + k / 24.0);
        table_row(w_dt, spectral_radius(SYMPLECTIC, w_dt),
                  spectral_radius(BACKWARD, w_dt),
                  spectral_radius(MIDPOINT, w_dt),
                  spectral_radius(BDF2, w_dt));
    }
    table_end();
}

/* A mode, step by step, from u = 1, v = 0; velocities in units of w. */
static void print_mode(double w_dt)
{
    struct model model = mode_make(1.0);
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
            advance(&model, (enum method)m, w_dt, NULL, &s[m]);
    }
    table_end();
    for (int m = 0; m < N_METHOD; m++) state_free(&s[m]);
    model_free(&model);
}

/* Error after w T = 2.385 in the norm (u^2 + v^2 / w^2)^(1/2), and the leading
 * coefficient of (w dt)^p that it should have [eq:mode-constants]. */
static void print_orders(void)
{
    static const int order_due[] = {1, 1, 2, 2};
    const double T = 2.385;
    const double due[] = {sin(T) / 2.0, T / 2.0, T / 12.0, T / 3.0};

    table_begin("orders", "method steps w_dt error order constant predicted");
    for (int m = 0; m < N_METHOD; m++) {
        double previous = 0.0;
        for (int n = 4; n <= 1024; n *= 2) {
            const double dt = T / n;
            struct model model = mode_make(1.0);
            struct state s = state_make(1);
            s.u[0] = 1.0;
            for (int k = 0; k < n; k++)
                advance(&model, (enum method)m, dt, NULL, &s);
            const double error = hypot(s.u[0] - cos(T), s.v[0] + sin(T));
            table_row(m, n, dt, error,
                      n > 4 && error > 0.0 ? log2(previous / error) : 0.0,
                      error / pow(dt, order_due[m]), due[m]);
            previous = error;
            state_free(&s);
            model_free(&model);
        }
    }
    table_end();
}

/* Backward Euler, v = 0: what a push f leaves in the first frame. */
static void print_one_frame(void)
{
    static const double stiffness[] = {0.0, 100.0, 2385.0};
    const double dt = 1.0 / 30.0;
    table_begin_note("one_frame", "k_over_m f u v", "M = 1, u = 1, v = 0");
    for (int k = 0; k < 6; k++) {
        struct model model = mode_make(sqrt(stiffness[k % 3]));
        struct state s = state_make(1);
        s.u[0] = 1.0;
        model.f[0] = k < 3 ? 0.0 : 371.4;
        const struct step_report report =
            advance(&model, BACKWARD, dt, NULL, &s);
        if (report.status != OK)
            die("a step of a mode is %s", status_name(report.status));
        table_row(stiffness[k % 3], model.f[0], s.u[0], s.v[0]);
        state_free(&s);
        model_free(&model);
    }
    table_end();
}

/* ---- the bar: what damping costs ---------------------------------------- */

/* (amplitude after a period, at w dt = z) - 0.99; a period of the computed
 * motion has 2 pi / atan z steps. */
static double loss_excess(double z, void *unused)
{
    (void)unused;
    return pow(1.0 + z * z, -M_PI / atan(z)) - 0.99;
}

/* The w dt at which backward Euler takes 1 % of the amplitude a period. */
static double one_percent_step(void)
{
    gsl_function f = {loss_excess, NULL};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &f, 1e-4, 1e-1);
    for (int k = 0; k < 100; k++) {
        gsl_root_fsolver_iterate(solver);
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver),
                                   gsl_root_fsolver_x_upper(solver), 0.0,
                                   1e-15) == GSL_SUCCESS)
            break;
    }
    const double z = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return z;
}

/* Modes 1, 3, 5 of the continuous bar, omega = (2k - 1) pi c / 2; amplitudes
 * that a frame leaves, and the step that is fine enough. */
static void print_bar_modes(void)
{
    const struct material material = notes_material(LINEAR);
    const double c = sqrt(material_modulus(&material));
    const double one_percent = one_percent_step();
    table_begin("bar_modes", "mode omega hertz backward bdf2 midpoint "
                             "backward_1s dt_1percent");
    for (int k = 1; k <= 5; k += 2) {
        const double omega = (2 * k - 1) * M_PI_2 * c, z = omega / 30.0;
        const double left = spectral_radius(BACKWARD, z);
        table_row(k, omega, omega / (2.0 * M_PI), left,
                  spectral_radius(BDF2, z), spectral_radius(MIDPOINT, z),
                  pow(left, 30.0), one_percent / omega);
    }
    table_end();
}

/* Energy of a linear bar of 16 elements in its first mode, frame by frame; the
 * number behind a method is its steps a frame. */
static void print_damping(void)
{
    enum { N_RUN = 7, n = 16 };
    static const struct {
        enum method method;
        int steps;
    } kind[N_RUN] = {{BACKWARD, 1}, {BACKWARD, 16}, {BACKWARD, 256},
                     {BDF2, 1},     {BDF2, 16},     {MIDPOINT, 1},
                     {SYMPLECTIC, 64}};
    struct model model[N_RUN];
    struct state s[N_RUN];
    double start = 0.0;

    for (int r = 0; r < N_RUN; r++) {
        model[r] = bar_make(n, CONSISTENT);
        s[r] = state_make(n);
        for (int i = 0; i < n; i++) s[r].u[i] = sin(M_PI_2 * (i + 1) / n);
        start = total_energy(&model[r], s[r].u, s[r].v);
    }
    table_begin("damping", "t backward_1 backward_16 backward_256 bdf2_1 "
                           "bdf2_16 midpoint_1 symplectic_64");
    for (int k = 0; k <= 20; k++) {
        double E[N_RUN];
        for (int r = 0; r < N_RUN; r++) {
            E[r] = total_energy(&model[r], s[r].u, s[r].v) / start;
            for (int j = 0; j < kind[r].steps; j++)
                advance(&model[r], kind[r].method, 1.0 / 30.0 / kind[r].steps,
                        NULL, &s[r]);
        }
        table_row(k / 30.0, E[0], E[1], E[2], E[3], E[4], E[5], E[6]);
    }
    table_end();
    for (int r = 0; r < N_RUN; r++) {
        state_free(&s[r]);
        model_free(&model[r]);
    }
}

/* ---- the cliff of symplectic Euler -------------------------------------- */

/* The largest frequency at rest: s M - A is positive definite if and only if
 * s > omega^2; bisection by Cholesky [eq:critical-step]. */
static double largest_frequency(const struct model *model)
{
    const size_t n = (size_t)model->M->n * model->M->stride;
    double low = 0.0, high = 1.0;
    for (int k = 0, closed = 0; k < 150 && high - low > 1e-14 * high; k++) {
        const double s = closed ? 0.5 * (low + high) : high;
        struct matrix *T = matrix_copy(model->M);
        for (size_t i = 0; i < n; i++)
            T->a[i] = s * model->M->a[i] - model->A->a[i];
        if (matrix_factor(T) == OK) {
            high = s;
            closed = 1;
        } else {
            low = s;
            if (!closed) high = 4.0 * s;
        }
        matrix_free(T);
    }
    return sqrt(high);
}

/* All modes at once, so small that the square is linear; ends at rest. */
static struct state ripple(const struct model *model)
{
    struct state s = state_make(model->n_dof);
    for (int i = 0; i < model->n_dof; i++)
        if (!model->body || model->body->equation[i] >= 0)
            s.u[i] = 1e-7 * sin(2.385 * (i + 1) + 0.02 * i * i);
    return s;
}

/* Does the energy stay below 1e4 of what it was? */
static int bounded(struct model *model, double dt, int steps)
{
    struct state s = ripple(model);
    const double limit = 1e4 * total_energy(model, s.u, s.v);
    int result = 1;
    for (int k = 0; k < steps && result; k++) {
        result = advance(model, SYMPLECTIC, dt, NULL, &s).status == OK;
        if (k % 16 == 15 && result)
            result = total_energy(model, s.u, s.v) <= limit;
    }
    state_free(&s);
    return result;
}

/* The largest step with a bounded run, by bisection; 0 < it < longest. */
static double measured_step(struct model *model, double longest, int steps)
{
    double low = 0.0, high = longest;
    for (int k = 0; k < 14; k++) {
        const double dt = 0.5 * (low + high);
        if (bounded(model, dt, steps))
            low = dt;
        else
            high = dt;
    }
    return low;
}

static void print_critical(int n_square)
{
    static const int bar_n[] = {4, 10, 32};
    const struct material material = notes_material(CUBIC);
    const double c = sqrt(material_modulus(&material));

    table_begin("critical_bar", "n lumped bound predicted measured a_frame");
    for (int k = 0; k < 6; k++) {
        const int n = bar_n[k / 2];
        const enum mass mass = k % 2 ? CONSISTENT : LUMPED;
        const double bound = 1.0 / (n * c) / (mass == LUMPED ? 1.0 : sqrt(3.0));
        struct model model = bar_make(n, mass);
        const double predicted = 2.0 / largest_frequency(&model);
        table_row(n, mass == LUMPED, bound, predicted,
                  measured_step(&model, 2.0 / (n * c), 600),
                  ceil(1.0 / 30.0 / predicted));
        model_free(&model);
    }
    table_end();

    table_begin("critical_square", "n lumped omega predicted measured a_frame");
    for (int k = 0; k < 2; k++) {
        const enum mass mass = k % 2 ? CONSISTENT : LUMPED;
        struct model model = square_make(n_square, material, mass, 2);
        square_matrices(&model);
        const double omega = largest_frequency(&model);
        table_row(n_square, mass == LUMPED, omega, 2.0 / omega,
                  measured_step(&model, 4.0 / (n_square * c), 300),
                  ceil(omega / 60.0));
        model_free(&model);
    }
    table_end();

    /* the speed of sound in a bar that has the stretch F already */
    static const double stretch[] = {0.1, 0.25, 0.5, 0.75, 1.0, 2.0, 3.0};
    const struct material log_ = notes_material(LOG);
    table_begin("stretched", "F cubic log");
    for (int k = 0; k < COUNT(stretch); k++)
        table_row(stretch[k],
                  c / sqrt(material1_dpk1(&material, stretch[k])),
                  c / sqrt(material1_dpk1(&log_, stretch[k])));
    table_end();
}

/* Energy over that of the start at 0.99 and 1.01 of the critical step; the
 * table ends when it is above 1e8.  growth is what 1.01 has a step for its
 * fastest mode [eq:amplification]. */
static void print_cliff(int n, double side, const char *name)
{
    struct model model = square_make(n, notes_material(CUBIC), LUMPED, 2);
    square_matrices(&model);
    const double dt = side * 2.0 / largest_frequency(&model);
    const double half_trace = 2.0 * side * side - 1.0;
    const double growth = side > 1.0 ? exp(2.0 * acosh(half_trace)) : 1.0;
    struct state s = ripple(&model);
    const double start = total_energy(&model, s.u, s.v);

    table_begin(name, "k t energy growth");
    for (int k = 0; k <= 300; k++) {
        const double E = total_energy(&model, s.u, s.v) / start;
        if (!(E < 1e8)) break;
        table_row(k, k * dt, E, growth);
        if (advance(&model, SYMPLECTIC, dt, NULL, &s).status != OK) break;
    }
    table_end();
    state_free(&s);
    model_free(&model);
}

/* ---- error against seconds: the square ---------------------------------- */

enum { MAX_LEVEL = 10 };

/* A large smooth swing, released from rest; ends fixed. */
static struct state swing_start(const struct model *model, double swing)
{
    struct state s = state_make(model->n_dof);
    for (int a = 0; a < model->mesh->n_vertex; a++) {
        const double X = model->mesh->X[2 * a];
        if (model->body->equation[2 * a] < 0) continue;
        s.u[2 * a] = 0.4 * swing * sin(M_PI * X);
        s.u[2 * a + 1] = swing * cos(M_PI_2 * X);
    }
    return s;
}

/* A run over three frames, 0.1 s. */
struct run {
    struct step_report total; /* status, and the sums of all steps */
    int steps;                /* made: fewer than due when not OK */
    double seconds, energy, error;
    double *u; /* [n_dof] at the end; owned */
};

static struct run run_swing(struct model *model, double swing,
                            enum method method, int per_frame)
{
    struct state s = swing_start(model, swing);
    struct run run = {.total = {.status = OK}};
    double *g = allocate((size_t)s.n, sizeof *g); /* ends at rest: 0 */
    const double E = total_energy(model, s.u, s.v);
    const double start = clock_seconds();

    while (run.steps < 3 * per_frame && run.total.status == OK) {
        const struct step_report report =
            advance(model, method, 1.0 / 30.0 / per_frame, g, &s);
        run.total.status = report.status;
        run.total.iterations += report.iterations;
        run.total.factorisations += report.factorisations;
        run.steps += report.status == OK;
        /* explicit: what has gained this much energy has no end */
        if (method == SYMPLECTIC && report.status == OK &&
            run.steps % 8 == 0 && !(total_energy(model, s.u, s.v) < 1e2 * E))
            run.total.status = NONFINITE;
    }
    run.seconds = clock_seconds() - start;
    run.energy = total_energy(model, s.u, s.v) / E;
    run.u = allocate((size_t)s.n, sizeof *run.u);
    memcpy(run.u, s.u, (size_t)s.n * sizeof *run.u);
    if (method == SYMPLECTIC && !(run.energy < 1e2))
        run.total.status = NONFINITE;
    state_free(&s);
    free(g);
    return run;
}

/* (u - w).M(u - w) to the 1/2, over the same of the start */
static double distance(const struct model *model, double swing,
                       const double u[], const double w[])
{
    struct state s = swing_start(model, swing);
    double *d = s.v, *Md = s.u_before, sum = 0.0, scale = 0.0;
    mass_times(model, s.u, Md);
    for (int i = 0; i < s.n; i++) scale += s.u[i] * Md[i];
    for (int i = 0; i < s.n; i++) d[i] = u[i] - w[i];
    mass_times(model, d, Md);
    for (int i = 0; i < s.n; i++) sum += d[i] * Md[i];
    state_free(&s);
    return sqrt(sum / scale);
}

struct chart {
    int levels; /* steps a frame: 1, 2, 4, ... 2^(levels - 1) */
    struct run run[N_METHOD][MAX_LEVEL];
    double *reference, reference_error, critical;
};

/*
 * The reference is the midpoint rule with 2 and 4 times the finest steps (64 a
 * frame at least) and Richardson's extrapolation (4 u_4 - u_2) / 3, whose error
 * is O(dt^4); its distance from the extrapolation one level below bounds that
 * error.
 */
static struct chart chart_make(int n, double swing, int levels)
{
    struct model model = square_make(n, notes_material(CUBIC), LUMPED, 2);
    struct chart chart = {.levels = levels};
    const int finest = levels > 7 ? 1 << (levels - 1) : 64, N = model.n_dof;
    struct run fine[3];
    double *coarse = allocate((size_t)N, sizeof *coarse);

    square_matrices(&model);
    chart.critical = 2.0 / largest_frequency(&model);
    for (int k = 0; k < 3; k++) {
        fine[k] = run_swing(&model, swing, MIDPOINT, finest << k);
        if (fine[k].total.status != OK)
            die("the reference with %d steps a frame is %s", finest << k,
                status_name(fine[k].total.status));
    }
    chart.reference = allocate((size_t)N, sizeof *chart.reference);
    for (int i = 0; i < N; i++) {
        chart.reference[i] = (4.0 * fine[2].u[i] - fine[1].u[i]) / 3.0;
        coarse[i] = (4.0 * fine[1].u[i] - fine[0].u[i]) / 3.0;
    }
    chart.reference_error = distance(&model, swing, chart.reference, coarse);
    for (int m = 0; m < N_METHOD; m++)
        for (int k = 0; k < levels; k++) {
            struct run *run = &chart.run[m][k];
            *run = run_swing(&model, swing, (enum method)m, 1 << k);
            if (run->total.status == OK)
                run->error =
                    distance(&model, swing, run->u, chart.reference);
            for (int j = 0; j < 3 && run->seconds < 3e-2; j++) {
                struct run again =
                    run_swing(&model, swing, (enum method)m, 1 << k);
                run->seconds = fmin(run->seconds, again.seconds);
                free(again.u);
            }
        }
    for (int k = 0; k < 3; k++) free(fine[k].u);
    free(coarse);
    model_free(&model);
    return chart;
}

static void print_chart(struct chart *chart)
{
    char machine[256];
    clock_machine(sizeof machine, machine);
    table_begin("reference", "levels error critical");
    table_row(chart->levels, chart->reference_error, chart->critical);
    table_end();
    table_begin_note("chart",
                     "method per_frame dt status steps error energy "
                     "iterations factorisations seconds",
                     "machine: %s", machine);
    for (int m = 0; m < N_METHOD; m++)
        for (int k = 0; k < chart->levels; k++) {
            const struct run *run = &chart->run[m][k];
            const int ok = run->total.status == OK;
            table_row(m, 1 << k, 1.0 / 30.0 / (1 << k), run->total.status,
                      run->steps, ok ? run->error : 0.0,
                      ok ? run->energy : 0.0, run->total.iterations / 3.0,
                      run->total.factorisations / 3.0, run->seconds / 3.0);
            free(run->u);
        }
    table_end();
    free(chart->reference);
}

/* ---- the loop ----------------------------------------------------------- */

/* One frame from rest, the right side struck inwards by `moved` and up by 0.3:
 * what it takes, the middle of the square and its speed after it. */
static void print_strike(void)
{
    enum { n = 8, middle = n / 2 * (n + 1) + n / 2 };
    static const double moved[] = {0.3, 0.6, 0.9, 1.2, 1.5, 2.1};
    table_begin("strike", "law moved status first attempts substeps iterations "
                          "factorisations u1 u2 speed min_J");
    for (int law = LOG; law <= CUBIC; law++)
        for (int k = 0; k < COUNT(moved); k++) {
            /* struck harder, it turns triangles over on its way, and the
             * reason that FAST ends with is round-off */
            if (law == CUBIC && moved[k] > 1.2) break;
            struct model model =
                square_make(n, notes_material((enum law)law), CONSISTENT, 2);
            struct state s = state_make(model.n_dof);
            double *g = allocate((size_t)s.n, sizeof *g);
            for (int a = n; a < model.mesh->n_vertex; a += n + 1) {
                g[2 * a] = -moved[k];
                g[2 * a + 1] = 0.3;
            }
            const struct frame frame =
                frame_step(model.body, 1.0 / 30.0, g, NULL, &s);
            table_row(law, moved[k], frame.status, frame.first, frame.attempts,
                      frame.substeps, frame.iterations, frame.factorisations,
                      s.u[2 * middle], s.u[2 * middle + 1],
                      hypot(s.v[2 * middle], s.v[2 * middle + 1]),
                      body_min_J(model.body, s.u));
            free(g);
            state_free(&s);
            model_free(&model);
        }
    table_end();
}

/* What the user does with the right side: until a time it goes smoothly to a
 * place (m), trembles about it, or is let go. */
static const struct motion {
    const char *name;
    double until, to[2], tremble;
    int held;
} SCRIPT[] = {
    {"grab", 0.2, {0.0, 0.0}, 0.0, 1},   {"pull", 0.7, {0.9, 0.0}, 0.0, 1},
    {"hold", 1.0, {0.9, 0.0}, 0.0, 1},   {"shake", 1.8, {0.9, 0.0}, 0.4, 1},
    {"slam", 1.9, {-0.9, 0.0}, 0.0, 1},  {"push", 2.4, {-1.1, 0.2}, 0.0, 1},
    {"hold", 2.7, {-1.1, 0.2}, 0.0, 1},  {"let go", 3.4, {0.0, 0.0}, 0.0, 0},
};

static int script_frames(void)
{
    return (int)lround(30.0 * SCRIPT[COUNT(SCRIPT) - 1].until);
}

/* The motion that holds at time t > 0, and the place of the right side; all
 * places are multiplied by reach. */
static int script_at(double t, double reach, double place[2])
{
    int m = 0;
    while (m < COUNT(SCRIPT) - 1 && t > SCRIPT[m].until + 1e-9) m++;
    const double begin = m ? SCRIPT[m - 1].until : 0.0;
    const double s = fmin((t - begin) / (SCRIPT[m].until - begin), 1.0);
    for (int i = 0; i < 2; i++) {
        const double from = m ? SCRIPT[m - 1].to[i] : 0.0;
        place[i] = from + s * s * (3.0 - 2.0 * s) * (SCRIPT[m].to[i] - from);
    }
    place[1] += SCRIPT[m].tremble * sin(6.0 * M_PI * (t - begin));
    for (int i = 0; i < 2; i++) place[i] *= reach;
    return m;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* What is known when the loop is over, or was left because it is hopeless. */
struct loop {
    int frames, misses, lost, robust, cut; /* numbers of frames */
    int iterations, factorisations;
    double p50, p99, worst, seconds, end[2];
};

/*
 * The script from beginning to end, with `budget` seconds for a frame.  What a
 * frame takes is between the user's input and the new u.  With print a row a
 * frame; without, the loop is left when more than one frame in a hundred is
 * late, and when the clock passes `deadline`.
 */
static struct loop run_loop(int n, enum law law, double reach, double budget,
                            double deadline, int print)
{
    const double dt = 1.0 / 30.0;
    const int frames = script_frames();
    struct model held = square_make(n, notes_material(law), CONSISTENT, 2);
    struct model free_ = square_make(n, notes_material(law), CONSISTENT, 1);
    struct state now = state_make(held.n_dof);
    double *g = allocate((size_t)now.n, sizeof *g);
    double *seconds = allocate((size_t)frames, sizeof *seconds);
    struct loop loop = {0};

    for (int k = 1; k <= frames; k++) {
        double place[2];
        const int m = script_at(k * dt, reach, place);
        struct model *model = SCRIPT[m].held ? &held : &free_;
        const double start = clock_seconds();
        for (int a = n; a < held.mesh->n_vertex; a += n + 1)
            for (int i = 0; i < 2; i++) g[2 * a + i] = place[i];
        const struct frame frame =
            frame_step(model->body, dt, g, NULL, &now);
        const double took = clock_seconds() - start;
        const int end = 2 * ((n / 2) * (n + 1) + n); /* middle of the side */

        seconds[loop.frames++] = took;
        loop.misses += took > budget;
        loop.lost += frame.status != OK;
        loop.robust += frame.attempts > 1;
        loop.cut += frame.substeps > 1;
        loop.iterations += frame.iterations;
        loop.factorisations += frame.factorisations;
        loop.end[0] = now.u[end];
        loop.end[1] = now.u[end + 1];
        if (print)
            table_row(k, k * dt, m, frame.status, frame.first, frame.attempts,
                      frame.substeps, frame.iterations, frame.factorisations,
                      now.u[end], now.u[end + 1],
                      body_min_J(model->body, now.u), took);
        if (print) continue;
        if (loop.misses * 100 > frames || clock_seconds() > deadline) break;
    }
    qsort(seconds, (size_t)loop.frames, sizeof *seconds, ascending);
    loop.p50 = seconds[(loop.frames - 1) / 2];
    loop.p99 = seconds[(99 * loop.frames + 99) / 100 - 1];
    loop.worst = seconds[loop.frames - 1];
    for (int k = 0; k < loop.frames; k++) loop.seconds += seconds[k];
    free(seconds);
    free(g);
    state_free(&now);
    model_free(&held);
    model_free(&free_);
    return loop;
}

static void print_loop(int n, enum law law, double reach)
{
    char machine[256];
    clock_machine(sizeof machine, machine);
    table_begin("script", "motion until u1 u2 tremble held");
    for (int m = 0; m < COUNT(SCRIPT); m++)
        table_row(m, SCRIPT[m].until, reach * SCRIPT[m].to[0],
                  reach * SCRIPT[m].to[1], reach * SCRIPT[m].tremble,
                  SCRIPT[m].held);
    table_end();
    table_begin_note("frames",
                     "k t motion status first attempts substeps iterations "
                     "factorisations u1 u2 min_J seconds",
                     "machine: %s", machine);
    const struct loop loop = run_loop(n, law, reach, 1.0 / 30.0, 0.0, 1);
    table_end();
    table_begin("loop", "n frames lost robust cut iterations factorisations "
                        "misses p50 p99 worst");
    table_row(n, loop.frames, loop.lost, loop.robust, loop.cut,
              loop.iterations, loop.factorisations, loop.misses, loop.p50,
              loop.p99, loop.worst);
    table_end();
}

/*
 * The finest mesh whose p99 is within a frame: doubling, then bisection, over
 * a list of n, until it is found or `budget` seconds are over.  real_time is 1
 * (yes), 0 (no) or -1 (time was over before one could say).
 */
static void print_realtime(enum law law, double reach, double budget)
{
    static const int mesh[] = {4,  6,  8,  10, 12, 14, 16, 20, 24,
                               28, 32, 40, 48, 56, 64, 72, 80, 96};
    const double deadline = clock_seconds() + budget;
    int yes = -1, no = COUNT(mesh), next = 0, last = 0;
    char machine[256];

    clock_machine(sizeof machine, machine);
    table_begin_note("realtime", "n real_time frames p50 p99 worst misses",
                     "machine: %s", machine);
    while (no - yes > 1 && clock_seconds() < deadline) {
        const struct loop loop =
            run_loop(mesh[next], law, reach, 1.0 / 30.0, deadline, 0);
        const int late = loop.misses * 100 > script_frames();
        const int ended = loop.frames == script_frames();
        table_row(mesh[next], ended || late ? !late : -1, loop.frames,
                  loop.p50, loop.p99, loop.worst, loop.misses);
        if (!ended && !late) break;
        if (late) {
            no = next;
        } else {
            yes = next;
            last = mesh[next];
        }
        if (no < COUNT(mesh))
            next = (yes + no) / 2;
        else
            while (next < no - 1 && mesh[next] < 2 * last) next++;
    }
    table_end();
    table_begin_note("largest", "n found",
                     "n 0: none yet; found 0: the time was over before");
    table_row(last, no - yes <= 1);
    table_end();
}

/* ---- the stages, and main ----------------------------------------------- */

/* q at a state that hides nothing, with a load. */
static void print_residual(int n)
{
    struct model model = square_make(n, notes_material(CUBIC), CONSISTENT, 2);
    struct state s = state_make(model.n_dof);
    double *q = allocate((size_t)s.n, sizeof *q);
    for (int i = 0; i < s.n; i++) {
        s.u[i] = 0.2 / n * sin(2.385 * i);
        s.u_before[i] = 0.2 / n * sin(3.714 * i + 1.0);
        s.v[i] = cos(1.247 * i);
        model.f[i] = 10.0 * sin(0.613 * i);
    }
    const enum status status =
        residual(&model, 1.0 / 30.0, s.u_before, s.v, s.u, q);
    if (status != OK) die("the residual is %s", status_name(status));
    table_vector("residual", s.n, q);
    free(q);
    state_free(&s);
    model_free(&model);
}

int main(int argc, char *argv[])
{
    int n = 8, levels = 9, loop_n = 32, law = 0;
    double w_dt = 0.5, swing = 0.3, reach = 1.0, budget = 0.2;
    const struct option options[] = {
        {"n", .integer = &n, .min = 2, .max = 10,
         .help = "squares a side, all but the loop"},
        {"wdt", .real = &w_dt, .min = 0.01, .max = 1.9,
         .help = "omega dt of table mode",
         .why = "symplectic Euler has no bound beyond 2"},
        {"swing", .real = &swing, .min = 0.01, .max = 0.5, .unit = "m",
         .help = "amplitude of the swing of the chart"},
        {"levels", .integer = &levels, .min = 2, .max = MAX_LEVEL,
         .help = "of the chart: 1, 2, 4, ... steps a frame"},
        {"loop", .integer = &loop_n, .min = 2, .max = 32,
         .help = "squares a side, loop"},
        {"law", .choice = &law, .choices = "log cubic",
         .help = "material of the loop"},
        {"reach", .real = &reach, .min = 0.0, .max = 1.8,
         .help = "how far the user of the loop goes"},
        {"budget", .real = &budget, .min = 0.0, .max = 600.0, .unit = "s",
         .help = "to look for the finest mesh in real time"},
    };
    options_parse("13_time_step", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    const enum law material = law ? CUBIC : LOG;
    struct chart chart = chart_make(n, swing, levels);

    print_residual(2);
    print_one_frame();
    print_mode(w_dt);
    print_amplification();
    print_orders();
    print_bar_modes();
    print_damping();
    print_critical(n);
    print_cliff(n, 0.99, "cliff_below");
    print_cliff(n, 1.01, "cliff_above");
    print_chart(&chart);
    print_strike();
    print_loop(loop_n, material, reach);
    print_realtime(material, reach, budget);
    return table_finish();
}
