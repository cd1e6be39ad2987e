/*
 * 10_neohookean_bar.c - a bar that may be stretched as far as one likes: five
 * steps to a Newton method.
 *
 * Notes: Lecture 2, sections 2.1 to 2.5; Problem Session III.
 *
 * Problem.  A bar 0 < X < 1 of Neo-Hookean material, each end held (u given) or
 * free (force given), under a body force: find u with
 *
 *     P(F)' + f = 0,   F = 1 + u',   P = mu F + (lambda r(F) - mu) r'(F),
 *
 * r = ln F or its cubic expansion [eq:pk1-neohookean] [eq:r-cubic].  Linear
 * elements turn it into q(u) = 0, n + 1 equations that are not linear.
 *
 *     node      0     1     2           n         element e joins the nodes
 *               o-----o-----o--- ... ---o         e - 1 and e and has
 *     element      1     2           n            F_e = 1 + (u_e - u_{e-1}) / h
 *
 * Then the experiments: the notes' example, two stopping tests that fail, bars
 * under their own weight, and a million elements.
 *
 * Run       make lesson-10, or with options: -h lists them
 * Expect    notes' example: u = sin t to 1e-12; bar under its weight: order 2
 *           with the constant of [eq:bar-weight]; each step squares the error
 * Plot: nodes X u
 */
#include "bar.h"
#include "bar_fast.h"
#include "clock.h"
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* struct bar, the bar of bar.h: n, h, held[2] (is u given at node 0, at node
 * n?), b, material; struct newton_control and newton_report are there too. */

/*
 * b_i = int f N_i dX + (the force on node i, if it is an end) [eq:bar-b], by
 * the midpoint rule.
 *
 * f_mid  in   f at the middle of element e: f_mid[e - 1], 1 <= e <= n
 * pull   in   force on node 0, on node n, positive to the right
 * b      out  b[0..n]
 */
static void load_vector(int n, double h, const double f_mid[],
                        const double pull[2], double b[])
{
    /* SLOT 10a(n, h, f_mid, pull, b): element by element, then the ends. */
    for (int i = 0; i <= n; i++) b[i] = 0.0;
    for (int e = 1; e <= n; e++) {
        b[e - 1] += 0.5 * h * f_mid[e - 1];
        b[e] += 0.5 * h * f_mid[e - 1];
    }
    b[0] += pull[0];
    b[n] += pull[1];
    /* END 10a */
}

/*
 * q_i = P(F_i) - P(F_{i+1}) - b_i, no P where there is no element [eq:bar-q]:
 * minus the force that is left over at node i; all n + 1, no end is special.
 * INVERTED where the material is not defined; q is then incomplete.
 */
static enum status residual(const struct bar *bar, const double u[],
                            double q[])
{
    /* SLOT 10b(bar, u, q): material_defined() and material1_pk1() of
     * material.h take bar->material and F. */
    for (int i = 0; i <= bar->n; i++) q[i] = -bar->b[i];
    for (int e = 1; e <= bar->n; e++) {
        const double F = 1.0 + (u[e] - u[e - 1]) / bar->h;
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double P = material1_pk1(&bar->material, F);
        q[e - 1] -= P;
        q[e] += P;
    }
    /* END 10b */
    return OK;
}

/*
 * K = dq/du, before any end is held [eq:bar-tangent]: the stiffness matrix of
 * -(beta du')' with beta = P'(F).  K is banded or dense; what it held is
 * forgotten.  INVERTED as in residual().
 */
static enum status tangent(const struct bar *bar, const double u[],
                           struct matrix *K)
{
    /* SLOT 10c(bar, u, K): material1_dpk1() is P'(F); matrix_zero() and
     * matrix_add() of matrix.h; add all four entries of an element. */
    matrix_zero(K);
    for (int e = 1; e <= bar->n; e++) {
        const double F = 1.0 + (u[e] - u[e - 1]) / bar->h;
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double k = material1_dpk1(&bar->material, F) / bar->h;
        matrix_add(K, e - 1, e - 1, k);
        matrix_add(K, e - 1, e, -k);
        matrix_add(K, e, e - 1, -k);
        matrix_add(K, e, e, k);
    }
    /* END 10c */
    return OK;
}

/*
 * The Newton increment: K du = -q at the free nodes, du = 0 at the held ones
 * [eq:newton] [eq:dirichlet-correction].
 *
 * K   in/out  from tangent(); it may be overwritten
 * q   in      from residual(); what it has at a held node is a reaction
 * du  out     du[0..n]
 *
 * NOT_SPD: some direction lowers the energy without resistance, u is near no
 * stable equilibrium, or nothing is held.  du is then meaningless.
 */
static enum status increment(const struct bar *bar, struct matrix *K,
                             const double q[], double du[])
{
    enum status status = OK;
    /* SLOT 10d(bar, K, q, du, &status): let du solve the corrected system, by
     * matrix_dirichlet(), matrix_factor() and matrix_solve() of matrix.h. */
    const int last = bar->n, ends[2] = {0, last};
    const double zero[2] = {0.0, 0.0};
    const int first = bar->held[0] ? 0 : 1;
    const int n_held = bar->held[0] + bar->held[1];

    for (int i = 0; i <= last; i++) du[i] = -q[i];
    matrix_dirichlet(K, du, n_held, &ends[first], zero, UNIT_DIAGONAL);
    status = matrix_factor(K);
    if (status == OK) matrix_solve(K, du);
    /* END 10d */
    return status;
}

/* max |v_i| over i = first..last; not finite if any v_i is not. */
static double max_abs(int first, int last, const double v[])
{
    double largest = 0.0;
    for (int i = first; i <= last; i++) {
        if (!isfinite(v[i])) return INFINITY;
        if (fabs(v[i]) > largest) largest = fabs(v[i]);
    }
    return largest;
}

/*
 * Newton's method from u, which has the given values at its held ends
 * [alg:newton].  It is done when nothing is left over and nothing moves:
 *
 *     max |q_i| <= tolerance (2 mu + lambda)  over the nodes that are free, and
 *     max |du|  <= tolerance n h              in the step before
 *
 * (no step is needed where q is 0 to begin with).  NONFINITE when one of the
 * two is not finite; MAX_ITERATIONS after control->max_iterations steps;
 * residual and increment in the report are those of the last u.
 */
static struct newton_report newton(const struct bar *bar,
                                   const struct newton_control *control,
                                   double u[])
{
    const size_t size = (size_t)bar->n + 1;
    const int first = bar->held[0], last = bar->n - bar->held[1];
    struct newton_report report = {MAX_ITERATIONS, 0, 0.0, 0.0};
    struct matrix *K = matrix_alloc(BANDED, bar->n + 1, 1);
    double *q = allocate(size, sizeof *q), *du = allocate(size, sizeof *du);
    /* SLOT 10e(bar, control, u, first, last, &report, K, q, du): the loop, with
     * report filled on the way; first..last are the free nodes. */
    const double force = control->tolerance * material_modulus(&bar->material);
    const double length = control->tolerance * bar->n * bar->h;

    for (;;) {
        report.status = residual(bar, u, q);
        if (report.status != OK) break;
        report.residual = max_abs(first, last, q);
        report.status = NONFINITE;
        if (!isfinite(report.residual) || !isfinite(report.increment)) break;
        report.status = OK;
        if (report.residual == 0.0 && report.iterations == 0) break;
        if (report.residual <= force && report.iterations > 0 &&
            report.increment <= length)
            break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == control->max_iterations) break;

        report.status = tangent(bar, u, K);
        if (report.status == OK) report.status = increment(bar, K, q, du);
        if (report.status != OK) break;
        for (int i = 0; i <= bar->n; i++) u[i] += du[i];
        report.increment = max_abs(0, bar->n, du);
        report.iterations++;
    }
    /* END 10e */
    matrix_free(K);
    free(q);
    free(du);
    return report;
}

/* ---- scenes ------------------------------------------------------------- */

enum shape { UNIFORM, COSINE };
struct scene {
    int n;
    struct material material;
    int held[2];    /* is u given at 0, at 1? */
    enum shape shape;
    double c;        /* body force c or c cos(pi X / 2) (N/m) */
    double g[2];     /* displacement of a held end (m) */
    double pull[2];  /* force on a free end (N), positive to the right */
};

/* A bar, what holds it, its nodal values; the pointers are owned. */
struct state {
    struct bar bar;
    double *b, *u;
    struct newton_report report;
};

/* q has the rounding of F in it, eps |u| / h: the tolerance may not be less,
 * and |u| grows with the load. */
static struct newton_control control_for(const struct scene *scene)
{
    const double load = fabs(scene->c) + fabs(scene->pull[0]) +
                        fabs(scene->pull[1]);
    const double size = 1.0 + load / material_modulus(&scene->material) +
                        fabs(scene->g[0]) + fabs(scene->g[1]);
    return (struct newton_control){
        size * fmax(1e-12, 8.0 * scene->n * DBL_EPSILON), 100, 0, 0};
}

/* The notes' E = 1000 and nu = 0.3. */
static struct material notes_material(enum law law)
{
    return material_make(law, 1000.0, 0.3);
}

/* The bar at rest but for its held ends, which jump to their places. */
static struct state state_make(const struct scene *scene)
{
    const int n = scene->n;
    const double h = 1.0 / n;
    double *f_mid = allocate((size_t)n, sizeof *f_mid);
    double *b = allocate((size_t)n + 1, sizeof *b);
    double *u = allocate((size_t)n + 1, sizeof *u);

    for (int e = 0; e < n; e++)
        f_mid[e] = scene->c * (scene->shape == COSINE
                                   ? cos(M_PI_2 * (e + 0.5) * h) : 1.0);
    load_vector(n, h, f_mid, scene->pull, b);
    free(f_mid);
    if (scene->held[0]) u[0] = scene->g[0];
    if (scene->held[1]) u[n] = scene->g[1];
    return (struct state){{n, h, {scene->held[0], scene->held[1]}, b,
                           scene->material}, b, u, {OK, 0, 0.0, 0.0}};
}

static void state_free(struct state *s)
{
    free(s->b);
    free(s->u);
}

static struct state solved(const struct scene *scene)
{
    struct state s = state_make(scene);
    const struct newton_control control = control_for(scene);
    s.report = newton(&s.bar, &control, s.u);
    return s;
}

/* F of element e = 1..n. */
static double stretch(const struct state *s, int e)
{
    return 1.0 + (s->u[e] - s->u[e - 1]) / s->bar.h;
}

/* The force that holds the left end; 0 without a solution. */
static double reaction(const struct state *s)
{
    if (s->report.status != OK) return 0.0;
    return -s->b[0] - material1_pk1(&s->bar.material, stretch(s, 1));
}

/* u at the right end, or 0 without a solution. */
static double end_value(const struct state *s)
{
    return s->report.status == OK ? s->u[s->bar.n] : 0.0;
}

/* ---- the stages, one table each ----------------------------------------- */

/* b, then q, K and du at a state that hides nothing, u_i = h/2 sin(2.385 i);
 * du is 0 where there is none (NOT_SPD). */
static void print_stages(const struct scene *scene)
{
    struct state s = state_make(scene);
    const int N = s.bar.n + 1;
    struct matrix *K = matrix_alloc(N <= 13 ? DENSE : BANDED, N, 1);
    double *q = allocate((size_t)N, sizeof *q);
    double *du = allocate((size_t)N, sizeof *du);

    for (int i = 0; i < N; i++) s.u[i] = 0.5 * s.bar.h * sin(2.385 * i);
    if (residual(&s.bar, s.u, q) != OK || tangent(&s.bar, s.u, K) != OK)
        die("the probe state is inverted");
    table_vector("b", N, s.b);
    table_vector("q", N, q);
    if (N <= 13) table_matrix("K", K);
    if (increment(&s.bar, K, q, du) != OK)
        for (int i = 0; i < N; i++) du[i] = 0.0;
    table_vector("du", N, du);
    matrix_free(K);
    free(q);
    free(du);
    state_free(&s);
}

static double second_difference(const struct material *m, double F)
{
    const double d = 1e-5;
    return (material1_dpk1(m, F + d) - material1_dpk1(m, F - d)) / (2.0 * d);
}

/*
 * Step by step: what Newton sees (residual, increment, energy) and what it does
 * not, error = max_e |F_e - its limit|.  ratio is error over the square of the
 * error before; a bar with a free end tends to predicted = |P'' / 2 P'| in the
 * element with the largest error.  Both are 0 where round-off governs, and the
 * table ends there.
 */
static void print_newton(const struct scene *scene, const struct state *limit)
{
    struct newton_control control = control_for(scene);
    double previous = 0.0;

    table_begin("newton", "k residual increment energy error ratio predicted");
    for (int k = 0; k <= limit->report.iterations; k++) {
        struct state s = state_make(scene);
        double energy = 0.0, error = 0.0, predicted = 0.0;
        control.max_iterations = k;
        s.report = newton(&s.bar, &control, s.u);
        if (bar_energy(&s.bar, s.u, &energy) != OK) energy = 0.0;
        for (int e = 1; e <= s.bar.n; e++) {
            const double F = stretch(limit, e), off = fabs(stretch(&s, e) - F);
            if (!(off <= error)) {
                error = off;
                predicted = fabs(0.5 *
                                 second_difference(&s.bar.material, F) /
                                 material1_dpk1(&s.bar.material, F));
            }
        }
        const int clean = k > 0 && error > 1e-10;
        table_row(k, s.report.residual, s.report.increment, energy, error,
                  clean ? error / (previous * previous) : 0.0,
                  clean && !(s.bar.held[0] && s.bar.held[1]) ? predicted
                                                               : 0.0);
        previous = error;
        state_free(&s);
        if (error <= 1e-10) break;
    }
    table_end();
}

/* ---- the notes' example, and when to stop ------------------------------- */

/* u(0, t) = sin t, the right end free: start from the last u. */
struct follow {
    enum status status;
    int most_iterations;
    double worst; /* max over t and X of |u - sin t| */
};
static struct follow follow_example(enum law law, int n, double dt, int print)
{
    const struct scene scene = {n, notes_material(law), {1, 0}, UNIFORM, 0.0,
                                {0.0, 0.0}, {0.0, 0.0}};
    const struct newton_control control = {1e-12, 100, 0, 0};
    struct state s = state_make(&scene);
    struct follow follow = {OK, 0, 0.0};

    for (int m = 0; m * dt <= 6.3 + 0.5 * dt; m++) {
        double error = 0.0;
        s.u[0] = sin(m * dt);
        s.report = newton(&s.bar, &control, s.u);
        follow.status = s.report.status;
        if (follow.status != OK) break;
        for (int i = 0; i <= n; i++)
            error = fmax(error, fabs(s.u[i] - sin(m * dt)));
        if (print)
            table_row(m * dt, s.u[0], s.u[n], error, s.report.iterations);
        follow.worst = fmax(follow.worst, error);
        if (s.report.iterations > follow.most_iterations)
            follow.most_iterations = s.report.iterations;
    }
    state_free(&s);
    return follow;
}

static void print_example(void)
{
    table_begin("example", "t u_left u_right error iterations");
    follow_example(CUBIC, 10, 0.1, 1);
    table_end();
    table_begin("example_steps", "n dt cubic_status cubic_iterations "
                                 "cubic_error log_status log_iterations "
                                 "log_error");
    for (int n = 10; n <= 100; n *= 10)
        for (int k = 0; k < 3; k++) {
            const double dt = k == 0 ? 0.01 : k == 1 ? 0.1 : 0.5;
            const struct follow a = follow_example(CUBIC, n, dt, 0);
            const struct follow b = follow_example(LOG, n, dt, 0);
            table_row(n, dt, a.status, a.most_iterations, a.worst, b.status,
                      b.most_iterations, b.worst);
        }
    table_end();
}

/* The loop on the increment alone; again says for which max |du| it goes on.
 * Returns the steps made, at most cap; *du is the last max |du|. */
static int loop_on_increment(const struct bar *bar, int (*again)(double du),
                             int cap, double u[], double *du)
{
    for (int k = 0; k < cap;) {
        const struct newton_control once = {0.0, 1, 0, 0};
        const struct newton_report report = newton(bar, &once, u);
        k += 1;
        *du = report.increment;
        if (report.status != MAX_ITERATIONS && report.status != OK) return k;
        if (!again(report.increment)) return k;
    }
    return cap;
}
static int as_printed(double du)
{
    return du < 1e-8; /* do ... while max|du| < tol */
}
static int as_meant(double du)
{
    return !(du < 1e-8); /* do ... until max|du| < tol */
}

/* Two stopping tests against that of newton(). */
static void print_stopping(void)
{
    struct scene scene = {10, notes_material(CUBIC), {1, 0}, UNIFORM, 0.0,
                          {0.0, 0.0}, {0.0, 0.0}};
    double du = 0.0;

    table_begin_note("printed_loop", "t steps error steps_right error_right",
                     "do ... while max|du| < tol, at most 1000 steps");
    for (int k = 0; k < 3; k++) {
        scene.g[0] = sin(k == 0 ? 0.0 : k == 1 ? 0.1 : 0.5);
        struct state s = state_make(&scene), right = solved(&scene);
        const int steps =
            loop_on_increment(&s.bar, as_printed, 1000, s.u, &du);
        double error = 0.0, error_right = 0.0;
        for (int i = 0; i <= 10; i++) {
            error = fmax(error, fabs(s.u[i] - scene.g[0]));
            error_right = fmax(error_right, fabs(right.u[i] - scene.g[0]));
        }
        table_row(k == 0 ? 0.0 : k == 1 ? 0.1 : 0.5, steps, error,
                  right.report.iterations, error_right);
        state_free(&s);
        state_free(&right);
    }
    table_end();

    scene.material = notes_material(LOG);
    table_begin_note("increment_loop",
                     "F0 P0 steps du F P steps_right F_right",
                     "log law, element 1 compressed to F0; do ... until "
                     "max|du| < 1e-8");
    for (double F0 = 1e-4; F0 > 1e-13; F0 *= 1e-4) {
        scene.g[0] = 0.1 * (1.0 - F0);
        struct state s = state_make(&scene), right = solved(&scene);
        const int steps = loop_on_increment(&s.bar, as_meant, 1000, s.u, &du);
        table_row(F0, material1_pk1(&s.bar.material, F0), steps, du,
                  stretch(&s, 1),
                  material1_pk1(&s.bar.material, stretch(&s, 1)),
                  right.report.iterations, stretch(&right, 1));
        state_free(&s);
        state_free(&right);
    }
    table_end();
}

/* ---- a bar under its own weight ----------------------------------------- */

struct target {
    const struct material *material;
    double P;
};
static double stress_excess(double F, void *target)
{
    const struct target *t = target;
    return material1_pk1(t->material, F) - t->P;
}

/* The F with P(F) = P, where P' > 0 [-3, 6] (LOG: from 0.02 on): GSL. */
static double stretch_under(const struct material *material, double P)
{
    struct target target = {material, P};
    gsl_function f = {stress_excess, &target};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    double F = 1.0;

    gsl_root_fsolver_set(solver, &f, material->law == LOG ? 0.02 : -3.0, 6.0);
    for (int k = 0; k < 200; k++) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS) break;
        F = gsl_root_fsolver_root(solver);
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver),
                                   gsl_root_fsolver_x_upper(solver), 0.0,
                                   4.0 * DBL_EPSILON) == GSL_SUCCESS)
            break;
    }
    gsl_root_fsolver_free(solver);
    return F;
}

/* u(1) of the continuum and the constant of the error h^2 C of linear elements
 * with midpoint load [eq:bar-weight]; F_c is the stretch at the held end. */
static double weight_exact(const struct material *m, double c, double *F_c,
                           double *C)
{
    *F_c = stretch_under(m, c);
    *C = c / 24.0 *
         (1.0 / material1_dpk1(m, 1.0) - 1.0 / material1_dpk1(m, *F_c));
    return *F_c - (material1_psi(m, *F_c) - material1_psi(m, 1.0)) / c - 1.0;
}

static struct scene weight_scene(enum law law, int n, double c)
{
    return (struct scene){n, notes_material(law), {1, 0}, UNIFORM, c,
                          {0.0, 0.0}, {0.0, 0.0}};
}

/* Hanging (c > 0) and standing (c < 0), 16 elements. */
static void print_weight(void)
{
    static const double load[] = {10.0,  500.0,  2000.0,  -10.0,
                                  -500.0, -1300.0, -4000.0};
    table_begin("weight", "c linear cubic_u1 cubic_exact cubic_F_base "
                          "cubic_iterations log_status log_u1 log_exact "
                          "log_F_base log_iterations");
    for (int k = 0; k < COUNT(load); k++) {
        const struct scene a = weight_scene(CUBIC, 16, load[k]);
        const struct scene b = weight_scene(LOG, 16, load[k]);
        struct state s = solved(&a), t = solved(&b);
        double F_a, F_b, C;
        const double u_a = weight_exact(&a.material, load[k], &F_a, &C);
        const double u_b = weight_exact(&b.material, load[k], &F_b, &C);
        table_row(load[k], 0.5 * load[k] / material_modulus(&a.material),
                  end_value(&s), u_a, F_a, s.report.iterations,
                  t.report.status, end_value(&t), u_b, F_b,
                  t.report.iterations);
        state_free(&s);
        state_free(&t);
    }
    table_end();
}

/* The closed form alone, for the curve. */
static void print_weight_curve(void)
{
    const struct material cubic = notes_material(CUBIC);
    const struct material log_ = notes_material(LOG);
    double F, C;
    table_begin("weight_curve", "c linear cubic log");
    for (int k = -16; k <= 8; k++) {
        const double c = k == 0 ? 1e-3 : 250.0 * k; /* 0/0 at 0 */
        table_row(c, 0.5 * c / material_modulus(&cubic),
                  weight_exact(&cubic, c, &F, &C),
                  weight_exact(&log_, c, &F, &C));
    }
    table_end();
}

/* error = u_h(1) - u(1) under refinement; constant = error / h^2. */
static void print_order(void)
{
    static const double load[] = {500.0, -500.0};
    table_begin("order", "c law n h error order constant predicted");
    for (int k = 0; k < 4; k++) {
        const enum law law = k % 2 ? CUBIC : LOG;
        const double c = load[k / 2];
        double previous = 0.0;
        for (int n = 4; n <= 256; n *= 2) {
            const struct scene scene = weight_scene(law, n, c);
            struct state s = solved(&scene);
            double F, C, h = 1.0 / n;
            const double exact = weight_exact(&scene.material, c, &F, &C);
            const double error = end_value(&s) - exact;
            table_row(c, law, n, h, error,
                      n > 4 ? log2(fabs(previous / error)) : 0.0,
                      error / (h * h), C);
            previous = error;
            state_free(&s);
        }
    }
    table_end();
}

/* ---- other loads, other materials --------------------------------------- */

static void print_loads(void)
{
    table_begin("cosine", "n cubic_u1 log_u1 cubic_u1_neg log_u1_neg");
    for (int n = 16; n <= 64; n *= 2) {
        double u1[4];
        for (int k = 0; k < 4; k++) {
            struct scene scene =
                weight_scene(k % 2 ? LOG : CUBIC, n, k < 2 ? 1e3 : -1e3);
            scene.shape = COSINE;
            struct state s = solved(&scene);
            u1[k] = end_value(&s);
            state_free(&s);
        }
        table_row(n, u1[0], u1[1], u1[2], u1[3]);
    }
    table_end();

    table_begin("both_fixed", "c n reaction u_half F_first F_last iterations");
    for (int k = 0; k < 6; k++) {
        struct scene scene =
            weight_scene(CUBIC, 16 << k % 3, k < 3 ? 1e3 : 4e3);
        scene.held[1] = 1;
        struct state s = solved(&scene);
        const int ok = s.report.status == OK, n = scene.n;
        table_row(scene.c, n, -reaction(&s), ok ? s.u[n / 2] : 0.0,
                  ok ? stretch(&s, 1) : 0.0, ok ? stretch(&s, n) : 0.0,
                  s.report.iterations);
        state_free(&s);
    }
    table_end();

    static const double pull[] = {1000.0,  100.0,   -100.0,
                                  -1346.0, -4000.0, -1e5};
    table_begin("end_load", "p cubic_iterations cubic_F log_status "
                            "log_iterations log_F");
    for (int k = 0; k < COUNT(pull); k++) {
        struct scene a = weight_scene(CUBIC, 16, 0.0);
        a.pull[1] = pull[k];
        struct state s = solved(&a);
        a.material.law = LOG;
        struct state t = solved(&a);
        table_row(pull[k], s.report.iterations, 1.0 + end_value(&s),
                  t.report.status, t.report.iterations,
                  t.report.status == OK ? 1.0 + end_value(&t) : 0.0);
        state_free(&s);
        state_free(&t);
    }
    table_end();
}

/* The hanging bar, c = 540, over Poisson's ratio. */
static void print_nu(void)
{
    static const double nus[] = {0.0, 0.02, 0.05, 0.07,  0.1, 0.2,
                                 0.3, 0.4,  0.45, 0.49, 0.499};
    table_begin("nu_sweep", "nu modulus cubic_status cubic_iterations cubic_u1 "
                            "log_status log_iterations log_u1");
    for (int k = 0; k < COUNT(nus); k++) {
        struct scene scene = weight_scene(CUBIC, 16, 540.0);
        scene.material = material_make(CUBIC, 1000.0, nus[k]);
        struct state s = solved(&scene);
        scene.material.law = LOG;
        struct state t = solved(&scene);
        table_row(nus[k], material_modulus(&scene.material), s.report.status,
                  s.report.iterations, end_value(&s), t.report.status,
                  t.report.iterations, end_value(&t));
        state_free(&s);
        state_free(&t);
    }
    table_end();

    /* bar_newton(): its elimination takes negative pivots, Cholesky does not */
    table_begin("localised", "nu pulled status F_min F_max");
    for (int k = 0; k < 3; k++) {
        struct scene scene = weight_scene(CUBIC, 10, 0.0);
        scene.material = material_make(CUBIC, 1000.0, k == 0 ? 0.3 : 0.05);
        scene.held[1] = 1;
        scene.g[1] = k == 2 ? 2.5 : 1.0;
        struct state s = state_make(&scene);
        const struct newton_control control = control_for(&scene);
        double low = INFINITY, high = -INFINITY;
        s.report = bar_newton(&s.bar, &control, s.u, NULL);
        for (int e = 1; e <= 10; e++) {
            low = fmin(low, stretch(&s, e));
            high = fmax(high, stretch(&s, e));
        }
        table_row(k == 0 ? 0.3 : 0.05, scene.g[1], s.report.status, low, high);
        state_free(&s);
    }
    table_end();
}

/* Energy along the way, full steps and with the line search of bar_newton(). */
static void print_energy(void)
{
    enum { CAP = 40 };
    const struct scene scene = weight_scene(CUBIC, 16, -4000.0);
    struct newton_control control = control_for(&scene);
    struct newton_step full[CAP + 1], search[CAP + 1];
    struct newton_report report[2];

    control.max_iterations = CAP;
    for (int line_search = 0; line_search < 2; line_search++) {
        struct state s = state_make(&scene);
        control.line_search = line_search;
        report[line_search] = bar_newton(&s.bar, &control, s.u,
                                         line_search ? search : full);
        state_free(&s);
    }
    table_begin("energy", "line_search k energy length min_F");
    for (int l = 0; l < 2; l++)
        for (int k = 0; k <= report[l].iterations; k++) {
            const struct newton_step *step = l ? &search[k] : &full[k];
            table_row(l, k, step->energy, step->length, step->min_F);
        }
    table_end();
}

/* ---- a million elements ------------------------------------------------- */

enum solver { READABLE, GSL_TRIDIAGONAL, FUSED, FUSED_BOTH_ENDS, N_SOLVER };
static const char *const chart_name[N_SOLVER] = {
    "chart_readable", "chart_gsl", "chart_fused", "chart_both"};

/* Cubic law, left end held, right end free, n > 1: the same loop with arrays
 * for the entries and the library's solver. */
static struct newton_report newton_gsl(const struct bar *bar,
                                       const struct newton_control *control,
                                       double u[])
{
    const int n = bar->n;
    const double mu = bar->material.mu, lambda = bar->material.lambda;
    gsl_vector *diagonal = gsl_vector_alloc((size_t)n);
    gsl_vector *off = gsl_vector_alloc((size_t)n - 1);
    gsl_vector *minus_q = gsl_vector_alloc((size_t)n);
    gsl_vector *du = gsl_vector_alloc((size_t)n);
    double *const a = diagonal->data, *const r = minus_q->data;
    struct newton_report report = {MAX_ITERATIONS, 0, 0.0, 0.0};

    for (;;) {
        for (int i = 0; i < n; i++) r[i] = bar->b[i + 1];
        for (int i = 0; i < n; i++) { /* the element on the left of node i+1 */
            const double e = (u[i + 1] - u[i]) / bar->h;
            const double v = e - e * e / 2.0 + e * e * e / 3.0;
            const double dv = 1.0 - e + e * e, g = lambda * v - mu;
            const double k =
                (mu + lambda * dv * dv + g * (2.0 * e - 1.0)) / bar->h;
            r[i] -= mu * (1.0 + e) + g * dv;
            a[i] = k;
            if (i == 0) continue;
            r[i - 1] += mu * (1.0 + e) + g * dv;
            a[i - 1] += k;
            off->data[i - 1] = -k;
        }
        report.residual = max_abs(0, n - 1, r);
        report.status = OK;
        if (report.residual <=
                control->tolerance * material_modulus(&bar->material) &&
            report.iterations > 0 &&
            report.increment <= control->tolerance * n * bar->h)
            break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == control->max_iterations) break;
        report.status = NOT_SPD;
        if (gsl_linalg_solve_symm_tridiag(diagonal, off, minus_q, du)) break;
        for (int i = 0; i < n; i++) u[i + 1] += du->data[i];
        report.increment = max_abs(0, n - 1, du->data);
        report.iterations++;
    }
    gsl_vector_free(diagonal);
    gsl_vector_free(off);
    gsl_vector_free(minus_q);
    gsl_vector_free(du);
    return report;
}

/* Solve with one of the four; the seconds of the best of the repeats. */
static double timed(struct state *s, const struct newton_control *control,
                    enum solver solver, int repeats)
{
    double best = INFINITY;
    for (int r = 0; r < repeats; r++) {
        memset(s->u, 0, ((size_t)s->bar.n + 1) * sizeof *s->u);
        const double start = clock_seconds();
        s->report = solver == READABLE ? newton(&s->bar, control, s->u)
                    : solver == GSL_TRIDIAGONAL
                        ? newton_gsl(&s->bar, control, s->u)
                        : bar_fast_newton(&s->bar, control,
                                          solver == FUSED ? FROM_LEFT
                                                          : FROM_BOTH_ENDS,
                                          s->u);
        best = fmin(best, clock_seconds() - start);
    }
    return best;
}

/*
 * One Newton step on `large` elements.  Its seconds are (the time of m steps
 * less that of 1) / (m - 1), so that allocation and the last residual drop out;
 * difference is max |du - du'| / max |du'| of the first step, du' being that of
 * the sweep from both ends.
 */
static void print_large(int large, int repeats)
{
    const struct scene scene = weight_scene(CUBIC, large, 500.0);
    struct newton_control control = control_for(&scene);
    struct state s = state_make(&scene);
    const size_t size = (size_t)large + 1;
    double *du = allocate(size, sizeof *du);
    char machine[300];

    clock_machine(sizeof machine, machine);
    table_begin_note("large", "solver n ns_an_unknown difference",
                     "machine: %s\n# solver 0 readable, 1 GSL tridiagonal, 2 "
                     "fused, 3 fused from both ends; best of %d", machine,
                     repeats);
    control.max_iterations = 1;
    timed(&s, &control, FUSED_BOTH_ENDS, 1);
    memcpy(du, s.u, size * sizeof *du);
    for (int k = 0; k < N_SOLVER; k++) {
        const int fast = k >= FUSED, times = fast ? repeats : 2;
        const int m = fast ? 5 : 2;
        double difference = 0.0;
        control.max_iterations = 1;
        const double one = timed(&s, &control, (enum solver)k, times);
        for (int i = 0; i <= large; i++)
            difference = fmax(difference, fabs(s.u[i] - du[i]));
        control.max_iterations = m;
        const double many = timed(&s, &control, (enum solver)k, times);
        const double step = many > one ? (many - one) / (m - 1) : many / m;
        table_row(k, large, 1e9 * step / large,
                  difference / max_abs(0, large, du));
    }
    table_end();
    free(du);
    state_free(&s);
}

/*
 * Error of u(1), relative, against the seconds of the whole solve: the hanging
 * bar, c = 500, n times 4 a point, until the next point would not fit into the
 * budget (at least three points).  A run that is not valid has no time.
 */
static void print_chart(enum solver solver, double budget, int repeats)
{
    const double start = clock_seconds();
    double took = 0.0;
    char machine[300];

    clock_machine(sizeof machine, machine);
    table_begin_note(chart_name[solver],
                     "n iterations error valid seconds ns_an_unknown",
                     "machine: %s\n# whole solve, best of %d", machine,
                     repeats);
    for (int n = 16; n <= 1 << 20; n *= 4) {
        const double now = clock_seconds();
        if (n > 256 && now - start + 4.0 * took > budget) break;
        const struct scene scene = weight_scene(CUBIC, n, 500.0);
        const struct newton_control control = control_for(&scene);
        struct state s = state_make(&scene);
        double F, C;
        const double seconds = timed(&s, &control, solver, repeats);
        const double exact = weight_exact(&scene.material, 500.0, &F, &C);
        const int valid = s.report.status == OK;
        took = clock_seconds() - now;
        table_row(n, s.report.iterations,
                  valid ? fabs(end_value(&s) - exact) / exact : 0.0, valid,
                  valid ? seconds : 0.0,
                  valid ? 1e9 * seconds / n / s.report.iterations : 0.0);
        state_free(&s);
    }
    table_end();
}

/* ---- the scene of the options ------------------------------------------- */

_Noreturn static void refuse(const char *what)
{
    fprintf(stderr, "10_neohookean_bar: %s\n", what);
    exit(2);
}

/* What no range can say. */
static void check_scene(const struct scene *scene)
{
    if (scene->pull[0] != 0.0 && scene->held[0])
        refuse("--pull_left: the left end is held; --fixed right frees it");
    if (scene->pull[1] != 0.0 && scene->held[1])
        refuse("--pull_right: the right end is held; --fixed left frees it");
    struct state s = state_make(scene);
    for (int e = 1; e <= s.bar.n; e++)
        if (!material_defined(&scene->material, stretch(&s, e)))
            refuse("the log law would start inverted: the element at the held "
                   "end has F <= 0; move the end less, or use --law cubic");
    state_free(&s);
}

static void print_solution(const struct state *s)
{
    table_begin_note("nodes", "X u", "left end is held by the force %.17g N",
                     s->bar.held[0] ? reaction(s) : 0.0);
    for (int i = 0; i <= s->bar.n; i++) table_row(i * s->bar.h, s->u[i]);
    table_end();
    table_begin("elements", "X F P");
    for (int e = 1; e <= s->bar.n; e++)
        table_row((e - 0.5) * s->bar.h, stretch(s, e),
                  material1_pk1(&s->bar.material, stretch(s, e)));
    table_end();
}

int main(int argc, char *argv[])
{
    enum { LEFT, RIGHT, BOTH };
    int law = 0, fixed = LEFT, shape = UNIFORM, solve = 2;
    int large = 1000000, repeats = 3;
    double E = 1000.0, nu = 0.3, budget = 0.25;
    struct scene scene = {.n = 12, .c = -1300.0};
    const char *const why_nu =
        "at nu = 1/2 the material is incompressible, lambda is infinite, and "
        "beyond it lambda is negative";
    const struct option options[] = {
        {"n", .integer = &scene.n, .min = 1, .max = 2000, .help = "elements"},
        {"law", .choice = &law, .choices = "cubic log", .help = "r(J)"},
        {"E", .real = &E, .min = 1e-6, .max = 1e9, .unit = "N/m^2",
         .help = "Young's modulus"},
        {"nu", .real = &nu, .min = 0.0, .max = 0.4999,
         .help = "Poisson's ratio", .why = why_nu},
        {"fixed", .choice = &fixed, .choices = "left right both",
         .help = "ends that are held"},
        {"shape", .choice = &shape, .choices = "uniform cosine",
         .help = "body force c or c cos(pi X / 2)"},
        {"c", .real = &scene.c, .min = -1e4, .max = 1e4, .unit = "N/m",
         .help = "body force; < 0 presses towards the left end"},
        {"g_left", .real = &scene.g[0], .min = -10.0, .max = 10.0,
         .unit = "m", .help = "displacement of a held left end"},
        {"g_right", .real = &scene.g[1], .min = -10.0, .max = 10.0,
         .unit = "m", .help = "displacement of a held right end"},
        {"pull_left", .real = &scene.pull[0], .min = -1e4, .max = 1e4,
         .unit = "N", .help = "force on a free left end, > 0 to the right"},
        {"pull_right", .real = &scene.pull[1], .min = -1e4, .max = 1e4,
         .unit = "N", .help = "force on a free right end, > 0 to the right"},
        {"solve", .choice = &solve, .choices = "no scene all",
         .help = "no: b, q and K only; all: the experiments too"},
        {"large", .integer = &large, .min = 1000, .max = 2000000,
         .help = "elements of table large"},
        {"budget", .real = &budget, .min = 1e-4, .max = 5.0, .unit = "s",
         .help = "time of each curve of the chart; below 0.1, large is 1000"},
        {"repeats", .integer = &repeats, .min = 1, .max = 10,
         .help = "runs of which the best counts"},
    };
    options_parse("10_neohookean_bar", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    scene.material = material_make(law == 0 ? CUBIC : LOG, E, nu);
    scene.held[0] = fixed != RIGHT;
    scene.held[1] = fixed != LEFT;
    scene.shape = (enum shape)shape;
    check_scene(&scene);

    struct state s = state_make(&scene);
    if (solve) {
        state_free(&s);
        s = solved(&scene);
    }
    if (s.report.status != OK)
        die("no solution: %s after %d steps, residual %g N",
            status_name(s.report.status), s.report.iterations,
            s.report.residual);

    print_stages(&scene);
    if (solve) {
        print_solution(&s);
        print_newton(&scene, &s);
    }
    if (solve == 2) {
        print_example();
        print_stopping();
        print_weight();
        print_weight_curve();
        print_order();
        print_loads();
        print_nu();
        print_energy();
        print_large(budget < 0.1 ? 1000 : large, repeats);
        for (int k = 0; k < N_SOLVER; k++)
            print_chart((enum solver)k, budget, repeats);
    }
    state_free(&s);
    return table_finish();
}
