/*
 * 06_quadrature.c - A and b for any beta, f and q, by a rule on each element.
 *
 * Notes: Lecture 2, section 1.1, exercise (4).
 *
 * Problem.  -(beta u')' = f on (0, 1) with fluxes q at the ends, linear
 * elements on an unequal grid.  The integrals of beta and of f e_j are taken
 * by the midpoint rule, the trapezoidal rule or two-point Gauss on every
 * element [eq:quadrature], vertex by vertex [eq:quadrature-A]
 * [eq:quadrature-b].  GSL's adaptive quadrature is the judge.
 *
 *     hat e_j of vertex j:    RISING /|\ FALLING
 *                                   / | \
 *                                  /  |  \            element j joins the
 *       -----+--------------------+---+---+-----      vertices j - 1 and j
 *           ...               j - 1   j   j + 1
 *
 * Then two things that no rule likes: a load at a point c inside an element,
 * and a beta that jumps there.
 *
 * Run       make lesson-06, or with options: -h lists them
 * Expect    load: orders 2, 2, 4 (smooth f), 2, 2, 2 (kink), 1, 1, 1 (jump);
 *           solution: L2 order 2, energy order 1 whatever the rule; point
 *           load 1.5 and 0.5; jump of beta 1 and 0.5, harmonic mean 1.5
 * Plot: nodes x u
 */
#include "matrix.h"
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum rule { MIDPOINT_RULE, TRAPEZOID_RULE, GAUSS2_RULE, N_RULE };

/* What multiplies g in an integral over an element; s runs from 0 to 1. */
enum shape { ONE, RISING, FALLING }; /* 1, s, 1 - s */

/* The points s and weights w on (0, 1) [eq:quadrature]. */
static struct quadrature quadrature_rule(enum rule rule)
{
    struct quadrature points = {0};
    /* SLOT 6a(rule): fill points.n, points.s and points.w for each of the
     * three rules; the interval is (0, 1), so the weights add up to 1. */
    switch (rule) {
    case MIDPOINT_RULE:
        points = (struct quadrature){1, {0.5}, {1.0}};
        break;
    case TRAPEZOID_RULE:
        points = (struct quadrature){2, {0.0, 1.0}, {0.5, 0.5}};
        break;
    default: {
        const double d = 0.5 / sqrt(3.0);
        points = (struct quadrature){2, {0.5 - d, 0.5 + d}, {0.5, 0.5}};
    }
    }
    /* END 6a */
    return points;
}

/* The integral of g times a shape over (x0, x1) [eq:quadrature]. */
static double element_integral(double x0, double x1, field *g,
                               enum shape shape, const struct quadrature *rule)
{
    double sum = 0.0;
    /* SLOT 6b(x0, x1, g, shape, rule): let sum be the integral: for every
     * point of the rule, its weight times g there times the shape. */
    const double h = x1 - x0;
    for (int k = 0; k < rule->n; k++) {
        const double s = rule->s[k];
        const double phi = shape == ONE ? 1.0 : shape == RISING ? s : 1.0 - s;
        sum += h * rule->w[k] * g(x0 + s * h) * phi;
    }
    /* END 6b */
    return sum;
}

/* beta_j, the mean of beta over element j: mean[1..n]; mean[0] is 0. */
static void element_means(int n, const double x[], field *beta,
                          const struct quadrature *rule, double mean[])
{
    mean[0] = 0.0;
    for (int j = 1; j <= n; j++)
        mean[j] = element_integral(x[j - 1], x[j], beta, ONE, rule) /
                  (x[j] - x[j - 1]);
}

/*
 * Row j of A, before any boundary condition [eq:quadrature-A]:
 *
 *     row[0], row[1], row[2] = A_{j,j-1}, A_jj, A_{j,j+1},
 *
 * 0 where there is no such neighbour.  mean[1..n] from element_means().
 */
static void stiffness_row(int j, int n, const double x[], const double mean[],
                          double row[3])
{
    row[0] = row[1] = row[2] = 0.0;
    /* SLOT 6c(j, n, x, mean, row): the element on the left of vertex j, if
     * there is one, then the element on its right, if there is one. */
    if (j > 0) {
        const double k = mean[j] / (x[j] - x[j - 1]);
        row[0] -= k;
        row[1] += k;
    }
    if (j < n) {
        const double k = mean[j + 1] / (x[j + 1] - x[j]);
        row[1] += k;
        row[2] -= k;
    }
    /* END 6c */
}

/* b_j, with the fluxes qa and qb prescribed at the ends [eq:quadrature-b]. */
static double load_entry(int j, int n, const double x[], field *f,
                         const struct quadrature *rule, double qa, double qb)
{
    double b = 0.0;
    /* SLOT 6d(j, n, x, f, rule, qa, qb): let b be f against the two halves of
     * the hat e_j, one half only at an end, where its flux is added. */
    if (j > 0) b += element_integral(x[j - 1], x[j], f, RISING, rule);
    if (j < n) b += element_integral(x[j], x[j + 1], f, FALLING, rule);
    if (j == 0) b += qa;
    if (j == n) b += qb;
    /* END 6d */
    return b;
}

/* The judge: the same integral by GSL's adaptive quadrature. */
struct integrand {
    double x0, x1;
    field *g;
    enum shape shape;
    int evaluations; /* counted */
};

static double integrand_value(double x, void *params)
{
    struct integrand *f = params;
    const double s = (x - f->x0) / (f->x1 - f->x0);
    f->evaluations++;
    return f->g(x) * (f->shape == ONE ? 1.0 : f->shape == RISING ? s : 1.0 - s);
}

/* To an absolute tolerance; qagp with a break at *kink, qag if kink is NULL. */
static double adaptive_integral(struct integrand *f, double tolerance,
                                const double *kink)
{
    enum { INTERVALS = 100 };
    gsl_function function = {integrand_value, f};
    gsl_integration_workspace *work =
        gsl_integration_workspace_alloc(INTERVALS);
    double breaks[] = {f->x0, kink ? *kink : f->x0, f->x1}, result, estimate;

    const int status =
        kink ? gsl_integration_qagp(&function, breaks, 3, tolerance, 0.0,
                                    INTERVALS, work, &result, &estimate)
             : gsl_integration_qag(&function, f->x0, f->x1, tolerance, 0.0,
                                   INTERVALS, GSL_INTEG_GAUSS21, work, &result,
                                   &estimate);
    gsl_integration_workspace_free(work);
    if (status != GSL_SUCCESS || !isfinite(result))
        die("adaptive quadrature: %s", gsl_strerror(status));
    return result;
}

/* Where loads and coefficients have their kinks: never a node of 2^k equal
 * elements, but at 1/3 and at 2/3 of an element by turns. */
static const double c_kink = 1.0 / 3.0;

static double smooth_beta(double x) { return exp(x); }
static double smooth_u(double x) { return sin(2.0 * x); }
static double smooth_u_dx(double x) { return 2.0 * cos(2.0 * x); }
static double smooth_f(double x)
{
    return 2.0 * exp(x) * (2.0 * sin(2.0 * x) - cos(2.0 * x));
}

static double kink_f(double x) { return fabs(x - c_kink); }
static double step_f(double x) { return x < c_kink ? 0.0 : 1.0; }
static double zero(double x) { return 0.0 * x; }
static double one(double x) { return 1.0 + 0.0 * x; }

/* Unit load at c, beta = 1, both ends held: Green's function. */
static double tent_u(double x)
{
    return x < c_kink ? x * (1.0 - c_kink) : c_kink * (1.0 - x);
}
static double tent_u_dx(double x)
{
    return x < c_kink ? 1.0 - c_kink : -c_kink;
}

/* Unit flux through two materials: u' = 1 / beta. */
static double jump_beta(double x) { return x < c_kink ? 1.0 : 4.0; }
static double jump_u_dx(double x) { return 1.0 / jump_beta(x); }
static double jump_u(double x)
{
    return x < c_kink ? x : c_kink + (x - c_kink) / 4.0;
}

struct problem {
    field *beta, *f; /* f NULL: the unit load at c */
    double qa, qb;   /* fluxes */
    int fix_left, fix_right;
    field *exact, *exact_dx;
};
static const struct problem SMOOTH = {
    .beta = smooth_beta, .f = smooth_f, .qa = -2.0, .fix_right = 1,
    .exact = smooth_u, .exact_dx = smooth_u_dx};
static const struct problem POINT_LOAD = {
    .beta = one, .fix_left = 1, .fix_right = 1,
    .exact = tent_u, .exact_dx = tent_u_dx};
static const struct problem JUMP = {
    .beta = jump_beta, .f = zero, .qb = 1.0, .fix_left = 1,
    .exact = jump_u, .exact_dx = jump_u_dx};

/* e_j(c): the load that a unit force at c puts on vertex j. */
static double point_load(int j, int n, const double x[], double c)
{
    if (j > 0 && c > x[j - 1] && c <= x[j])
        return (c - x[j - 1]) / (x[j] - x[j - 1]);
    if (j < n && c > x[j] && c < x[j + 1])
        return (x[j + 1] - c) / (x[j + 1] - x[j]);
    return 0.0;
}

/* u[0..n] for the coefficients mean[1..n], with loads by the rule. */
static enum status solve(const struct problem *p, int n, const double x[],
                         const double mean[], const struct quadrature *rule,
                         double u[])
{
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    for (int j = 0; j <= n; j++) {
        double row[3];
        stiffness_row(j, n, x, mean, row);
        for (int k = 0; k < 3; k++)
            if (j + k >= 1 && j + k <= n + 1)
                matrix_add(A, j, j + k - 1, row[k]);
        u[j] = p->f ? load_entry(j, n, x, p->f, rule, p->qa, p->qb)
                    : point_load(j, n, x, c_kink);
    }
    const int node[] = {0, n};
    const double g[] = {p->exact(x[0]), p->exact(x[n])};
    if (p->fix_left) matrix_dirichlet(A, u, 1, node, g, KEEP_DIAGONAL);
    if (p->fix_right) matrix_dirichlet(A, u, 1, node + 1, g + 1, KEEP_DIAGONAL);
    const enum status status = matrix_factor(A);
    if (status == OK) matrix_solve(A, u);
    matrix_free(A);
    return status;
}

/* Errors of u; the norms on a mesh with c as one more node, so that neither
 * u nor beta has a kink inside an element there. */
static struct poisson_error errors(const struct problem *p, int n,
                                   const double x[], const double u[])
{
    double *X = allocate((size_t)n + 2, sizeof *X);
    double *U = allocate((size_t)n + 2, sizeof *U);
    double nodal = 0.0;
    int m = 0;

    for (int j = 0; j <= n; j++) {
        if (j > 0 && x[j - 1] < c_kink && c_kink < x[j]) {
            const double s = (c_kink - x[j - 1]) / (x[j] - x[j - 1]);
            X[m] = c_kink;
            U[m++] = (1.0 - s) * u[j - 1] + s * u[j];
        }
        X[m] = x[j];
        U[m++] = u[j];
        nodal = fmax(nodal, fabs(p->exact(x[j]) - u[j]));
    }
    struct poisson_error error =
        poisson_errors(m - 1, X, U, p->beta, p->exact, p->exact_dx);
    error.nodal = nodal;
    free(X);
    free(U);
    return error;
}

/* What stands for beta on the element where it jumps: the rule's mean, the
 * exact mean, or the harmonic one, h / int dx/beta. */
enum mean { SAMPLED, EXACT, HARMONIC };

/* Solve on n equal elements and measure. */
static struct poisson_error study(const struct problem *p, int n,
                                  enum rule kind, enum mean how)
{
    const struct quadrature rule = quadrature_rule(kind);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *u = allocate((size_t)n + 1, sizeof *u);
    double *mean = allocate((size_t)n + 1, sizeof *mean);

    grid_make(0.0, 1.0, n, 1.0, x);
    element_means(n, x, p->beta, &rule, mean);
    for (int j = 1; j <= n && how != SAMPLED; j++)
        if (x[j - 1] < c_kink && c_kink < x[j]) {
            struct integrand f = {x[j - 1], x[j], p->beta, ONE, 0};
            if (how == HARMONIC) f.g = jump_u_dx;
            mean[j] = adaptive_integral(&f, 1e-12, &c_kink) / (f.x1 - f.x0);
            if (how == HARMONIC) mean[j] = 1.0 / mean[j];
        }
    const enum status status = solve(p, n, x, mean, &rule, u);
    if (status != OK) die("the matrix of a study is %s", status_name(status));
    const struct poisson_error error = errors(p, n, x, u);
    free(x);
    free(u);
    free(mean);
    return error;
}

/* int f dx - sum_j b_j on n equal elements, for the three rules. */
static void load_errors(int n, field *f, double error[])
{
    struct integrand whole = {0.0, 1.0, f, ONE, 0};
    double *x = allocate((size_t)n + 1, sizeof *x);
    grid_make(0.0, 1.0, n, 1.0, x);
    for (int r = 0; r < N_RULE; r++) {
        const struct quadrature rule = quadrature_rule((enum rule)r);
        error[r] = adaptive_integral(&whole, 1e-12, &c_kink);
        for (int j = 0; j <= n; j++)
            error[r] -= load_entry(j, n, x, f, &rule, 0.0, 0.0);
    }
    free(x);
}

enum scene { LOAD_SMOOTH, LOAD_KINK, LOAD_STEP, SOLUTION, POINT, JUMPING };

/* The errors on n equal elements in the columns of the scene's table. */
static void measure(enum scene scene, int n, enum rule rule, double error[])
{
    if (scene == LOAD_SMOOTH) load_errors(n, smooth_f, error);
    if (scene == LOAD_KINK) load_errors(n, kink_f, error);
    if (scene == LOAD_STEP) load_errors(n, step_f, error);
    if (scene <= LOAD_STEP) return;

    const int n_case = scene == POINT ? 1 : 3; /* three rules, three means */
    for (int k = 0; k < n_case; k++) {
        const struct poisson_error e =
            scene == SOLUTION ? study(&SMOOTH, n, (enum rule)k, SAMPLED)
            : scene == POINT  ? study(&POINT_LOAD, n, rule, SAMPLED)
                              : study(&JUMP, n, rule, (enum mean)k);
        error[k] = e.nodal;
        error[n_case + k] = e.L2;
        error[2 * n_case + k] = e.energy;
    }
}

/* Table `name`, and name_orders: the orders between the finest mesh and one
 * four times coarser [eq:order]; 0 where the error is round-off. */
static void print_study(const char *name, enum scene scene, enum rule rule,
                        int n_column, const char *columns)
{
    enum { LEVELS = 6 }; /* n = 4, 8, ..., 128 */
    double value[LEVELS][11], order[9];
    char text[200];

    snprintf(text, sizeof text, "n h %s", columns);
    table_begin(name, text);
    for (int level = 0; level < LEVELS; level++) {
        const int n = 4 << level;
        value[level][0] = n;
        value[level][1] = 1.0 / n;
        measure(scene, n, rule, value[level] + 2);
        table_row_of(2 + n_column, value[level]);
    }
    table_end();

    snprintf(text, sizeof text, "%s_orders", name);
    table_begin(text, columns);
    for (int c = 0; c < n_column; c++) {
        const double fine = fabs(value[LEVELS - 1][2 + c]);
        const double coarse = fabs(value[LEVELS - 3][2 + c]);
        order[c] = fine > 1e-12 ? log(coarse / fine) / log(4.0) : 0.0;
    }
    table_row_of(n_column, order);
    table_end();
}

/* What each rule makes of the monomials: int s^degree ds less the rule. */
static void print_exactness(void)
{
    table_begin("exactness", "degree midpoint trapezoid gauss2");
    for (int degree = 0; degree <= 5; degree++) {
        double error[N_RULE];
        for (int r = 0; r < N_RULE; r++) {
            const struct quadrature rule = quadrature_rule((enum rule)r);
            error[r] = 1.0 / (degree + 1);
            for (int k = 0; k < rule.n; k++)
                error[r] -= rule.w[k] * gsl_pow_int(rule.s[k], degree);
        }
        table_row(degree, error[0], error[1], error[2]);
    }
    table_end();
}

/* What GSL pays for int |x - c| dx, not knowing c and knowing it. */
static void print_adaptive(void)
{
    const double exact = (gsl_pow_2(c_kink) + gsl_pow_2(1.0 - c_kink)) / 2.0;
    table_begin_note("adaptive",
                     "digits evaluations error evaluations_split error_split",
                     "an error below 1e-15 is round-off and printed as 1e-15");
    for (int digits = 2; digits <= 8; digits++) {
        struct integrand f[] = {{0.0, 1.0, kink_f, ONE, 0},
                                {0.0, 1.0, kink_f, ONE, 0}};
        const double tolerance = pow(10.0, -digits);
        const double blind = adaptive_integral(&f[0], tolerance, NULL);
        const double split = adaptive_integral(&f[1], tolerance, &c_kink);
        table_row(digits, f[0].evaluations, fmax(fabs(blind - exact), 1e-15),
                  f[1].evaluations, fmax(fabs(split - exact), 1e-15));
    }
    table_end();
}

/* The smooth problem on an unequal grid: A and b with GSL's, and u. */
static void print_scene(int n, double grading, const struct quadrature *rule)
{
    const size_t N = (size_t)n + 1;
    double *x = allocate(N, sizeof *x), *u = allocate(N, sizeof *u);
    double *mean = allocate(N, sizeof *mean), *gsl = allocate(N, sizeof *gsl);
    double *b_gsl = allocate(N, sizeof *b_gsl), row[3], row_gsl[3];

    grid_make(0.0, 1.0, n, grading, x);
    element_means(n, x, smooth_beta, rule, mean);
    b_gsl[0] += SMOOTH.qa;
    b_gsl[n] += SMOOTH.qb;
    for (int j = 1; j <= n; j++) {
        struct integrand f = {x[j - 1], x[j], smooth_beta, ONE, 0};
        gsl[j] = adaptive_integral(&f, 1e-12, NULL) / (f.x1 - f.x0);
        f.g = smooth_f;
        f.shape = FALLING;
        b_gsl[j - 1] += adaptive_integral(&f, 1e-12, NULL);
        f.shape = RISING;
        b_gsl[j] += adaptive_integral(&f, 1e-12, NULL);
    }
    const enum status status = solve(&SMOOTH, n, x, mean, rule, u);
    if (status != OK) die("the matrix is %s", status_name(status));

    table_begin("A", "j lower diagonal upper diagonal_gsl");
    for (int j = 0; j <= n; j++) {
        stiffness_row(j, n, x, mean, row);
        stiffness_row(j, n, x, gsl, row_gsl);
        table_row(j, row[0], row[1], row[2], row_gsl[1]);
    }
    table_end();
    table_begin("b", "j b b_gsl");
    for (int j = 0; j <= n; j++)
        table_row(j, load_entry(j, n, x, smooth_f, rule, SMOOTH.qa, SMOOTH.qb),
                  b_gsl[j]);
    table_end();
    table_begin("nodes", "x u exact");
    for (int j = 0; j <= n; j++) table_row(x[j], u[j], smooth_u(x[j]));
    table_end();
    free(x);
    free(u);
    free(mean);
    free(gsl);
    free(b_gsl);
}

int main(int argc, char *argv[])
{
    int n = 6, kind = MIDPOINT_RULE;
    double grading = 2.385;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 5000,
         .help = "elements of the smooth problem"},
        {"grading", .real = &grading, .min = 1e-3, .max = 1e3,
         .help = "length of its last element over that of its first"},
        {"rule", .choice = &kind, .choices = "midpoint trapezoid gauss2",
         .help = "rule of the smooth problem and of the jump"},
    };
    options_parse("06_quadrature", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();

    const enum rule rule = (enum rule)kind;
    const struct quadrature points = quadrature_rule(rule);
    print_scene(n, grading, &points);
    print_exactness();
    print_adaptive();
    const char *three = "midpoint trapezoid gauss2";
    print_study("load_smooth", LOAD_SMOOTH, rule, 3, three);
    print_study("load_kink", LOAD_KINK, rule, 3, three);
    print_study("load_step", LOAD_STEP, rule, 3, three);
    print_study("solution", SOLUTION, rule, 9,
                "nodal_midpoint nodal_trapezoid nodal_gauss2 "
                "L2_midpoint L2_trapezoid L2_gauss2 "
                "energy_midpoint energy_trapezoid energy_gauss2");
    print_study("point_load", POINT, rule, 3, "nodal L2 energy");
    print_study("jump", JUMPING, rule, 9,
                "nodal_sampled nodal_exact nodal_harmonic L2_sampled L2_exact "
                "L2_harmonic energy_sampled energy_exact energy_harmonic");
    return table_finish();
}
