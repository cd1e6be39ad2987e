/*
 * 10_neohookean_bar.c - a bar that may be stretched as far as one likes: five
 * steps to a Newton method.
 *
 * Notes: Lecture 2, sections 2.1 to 2.5; Problem Session III.
 *
 * Problem.  A Neo-Hookean bar 0 < X < 1, each end held (u given) or free (force
 * given), under a body force f: find u with P(F)' + f = 0, F = 1 + u',
 *
 *     P = mu F + (lambda r(F) - mu) r'(F),   r = ln F or its cubic expansion
 *
 * [eq:pk1-neohookean] [eq:r-cubic].  Linear elements turn it into q(u) = 0:
 *
 *     node      0     1     2           n         element e joins the nodes
 *               o-----o-----o--- ... ---o         e - 1 and e and has
 *     element      1     2           n            F_e = 1 + (u_e - u_{e-1}) / h
 *
 * Run       make lesson-10; make lesson-10 ARGS=-h lists its options
 * PREDICT 1 largest error of F after 5 steps; after 3 it is 0.014: ...
 * PREDICT 2 first step of a log element, 0.1 m, pressed to F = 1e-8 (m): ...
 * Plot: nodes X u
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

/* struct bar of bar.h has n, h, held[2] (is u given at node 0, at node n?), b,
 * material; struct newton_control and newton_report are there too. */

/*
 * Given the body force and the forces on the ends, return b (2.12b) by the
 * midpoint rule: f_mid[e - 1] is f at the middle of element e, 1 <= e <= n, and
 * pull[0], pull[1] are the forces on node 0 and n, positive to the right.
 */
static void load_vector(int n, double h, const double f_mid[],
                        const double pull[2], double b[])
{
    /* SLOT 10a(n, h, f_mid, pull, b): given f_mid and pull, fill b. */
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
 * Given u, return q (2.12a): q_i is minus the force left over at node i, of the
 * stresses beside it and of b_i; all n + 1, no end is special.
 * INVERTED where the material is not defined; q is then incomplete.
 */
static enum status residual(const struct bar *bar, const double u[],
                            double q[])
{
    /* SLOT 10b(bar, u, q): given u, set q; material_defined() and
     * material1_pk1() of material.h take bar->material and F. */
    for (int i = 0; i <= bar->n; i++) q[i] = -bar->b[i];
    for (int e = 1; e <= bar->n; e++) {
        const double F = 1.0 + (u[e] - u[e - 1]) / bar->h;
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double P = material1_pk1(&bar->material, F);
        /* int P N' dX with N' = -1/h and 1/h: h cancels */
        q[e - 1] -= P;
        q[e] += P;
    }
    /* END 10b */
    return OK;
}

/*
 * Given u, return K = dq/du (2.5.3), before any end is held.  K is banded or
 * dense; what it held is forgotten.  INVERTED as in residual().
 */
static enum status tangent(const struct bar *bar, const double u[],
                           struct matrix *K)
{
    /* SLOT 10c(bar, u, K): given u, set K: material1_dpk1() is P'(F);
     * matrix_zero(); matrix_add() for all four entries of an element. */
    matrix_zero(K);
    for (int e = 1; e <= bar->n; e++) {
        const double F = 1.0 + (u[e] - u[e - 1]) / bar->h;
        if (!material_defined(&bar->material, F)) return INVERTED;
        /* dF = du / h, and q has no h left */
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
 * Given K and q, return du: K du = -q at the free nodes, du = 0 at held ones
 * [eq:newton] [eq:dirichlet-correction].  K is from tangent() and may be
 * overwritten; what q has at a held node is a reaction.
 *
 * NOT_SPD: some direction lowers the energy without resistance, u is near no
 * stable equilibrium, or nothing is held.  du is then meaningless.
 */
static enum status increment(const struct bar *bar, struct matrix *K,
                             const double q[], double du[])
{
    enum status status = OK;
    /* SLOT 10d(bar, K, q, du, &status): given K and q, let du solve the
     * corrected system: matrix_dirichlet(), matrix_factor(), matrix_solve(). */
    const int last = bar->n, ends[2] = {0, last};
    const double zero[2] = {0.0, 0.0};
    const int first = bar->held[0] ? 0 : 1;
    const int n_held = bar->held[0] + bar->held[1];

    for (int i = 0; i <= last; i++) du[i] = -q[i];
    /* a held node has its value in u already: it does not move */
    matrix_dirichlet(K, du, n_held, &ends[first], zero, UNIT_DIAGONAL);
    status = matrix_factor(K);
    if (status == OK) matrix_solve(K, du);
    /* END 10d */
    return status;
}

/*
 * Newton's method from u, which has the given values at its held ends
 * [alg:newton].  It is done when nothing is left over and nothing moves:
 *
 *     max |q_i| <= tolerance (2 mu + lambda)  over the nodes that are free, and
 *     max |du|  <= tolerance n h              in the step before
 *
 * Where q is 0 to begin with no step is made, and the increment is 0; elsewhere
 * there is at least one, a full one.  NONFINITE when one of the two is not
 * finite; MAX_ITERATIONS after control->max_iterations steps; residual and
 * increment in the report are those of the last u.
 */
static struct newton_report newton(const struct bar *bar,
                                   const struct newton_control *control,
                                   double u[])
{
    struct newton_report report = {MAX_ITERATIONS, 0, 0.0, 0.0};
    struct matrix *K = matrix_alloc(BANDED, bar->n + 1, 1);
    double *q = allocate((size_t)K->n, sizeof *q);
    double *du = allocate((size_t)K->n, sizeof *du);
    /* SLOT 10e(bar, control, u, &report, K, q, du, residual, tangent,
     * increment): given the first u, iterate and fill report; bar_max_free() of
     * bar.h is max |v_i| of free nodes.  This is the course's first loop of
     * Newton's method; each later one changes something in it. */
    const double force = control->tolerance * material_modulus(&bar->material);
    const double length = control->tolerance * bar->n * bar->h;

    for (;;) {
        report.status = residual(bar, u, q);
        if (report.status != OK) break;
        report.residual = bar_max_free(bar, q);
        /* the status comes first, then the break that it is the reason of */
        report.status = NONFINITE;
        if (!isfinite(report.residual) || !isfinite(report.increment)) break;
        report.status = OK;
        if (report.residual == 0.0 && report.iterations == 0) break;
        /* increment is of the step that led to this u */
        if (report.residual <= force && report.iterations > 0 &&
            report.increment <= length)
            break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == control->max_iterations) break;

        /* u := u - K(u)^-1 q(u) */
        report.status = tangent(bar, u, K);
        if (report.status == OK) report.status = increment(bar, K, q, du);
        if (report.status != OK) break;
        for (int i = 0; i <= bar->n; i++) u[i] += du[i];
        report.increment = bar_max_free(bar, du);
        report.iterations++;
    }
    /* END 10e */
    matrix_free(K);
    free(q);
    free(du);
    return report;
}

static void scene_of_options(int argc, char *argv[], struct bar_scene *scene)
{
    int law = 0, held = 0;
    double nu = 0.3, end[2] = {0.0, 0.0};
    const struct option options[] = {
        {"n", .integer = &scene->n, .min = 1, .max = 2000, .help = "elements"},
        {"law", .choice = &law, .choices = "cubic log", .help = "r(J)"},
        {"nu", .real = &nu, .min = 0.0, .max = 0.4999, .help = "Poisson's"},
        {"held", .choice = &held, .choices = "left right both", .help = "ends"},
        {"c", .real = &scene->c, .min = -1e4, .max = 1e4, .unit = "N/m^3",
         .help = "body force; < 0 presses towards the left end"},
        {"left", .real = &end[0], .min = -1e4, .max = 1e4,
         .help = "u (m) of a held left end, force (N) on a free one"},
        {"right", .real = &end[1], .min = -1e4, .max = 1e4,
         .help = "the same at the right end; > 0 points to the right"},
    };
    options_parse("10_neohookean_bar", options, COUNT(options), argc, argv);
    scene->material = material_make(law ? LOG : CUBIC, 1000.0, nu);
    bar_scene_ends(scene, held != 1, held != 0, end);
}

/* b, then q, K and du at a state that hides nothing, u_i = h/2 sin(2.385 i);
 * there is no du where K is not positive definite. */
static void print_stages(const struct bar_scene *scene)
{
    struct bar_state *s = bar_state_by(load_vector, scene);
    const int N = scene->n + 1;
    struct matrix *K = matrix_alloc(BANDED, N, 1);
    double *q = allocate((size_t)N, sizeof *q);
    double *du = allocate((size_t)N, sizeof *du);

    for (int i = 0; i < N; i++) s->u[i] = 0.5 * s->bar.h * sin(2.385 * i);
    table_vector("b", N, s->b);
    if (residual(&s->bar, s->u, q) == OK) table_vector("q", N, q);
    if (tangent(&s->bar, s->u, K) == OK) matrix_table("K", K);
    if (increment(&s->bar, K, q, du) == OK) table_vector("du", N, du);
    matrix_free(K);
    free(q);
    free(du);
    bar_state_free(s);
}

int main(int argc, char *argv[])
{
    struct bar_scene scene = bar_scene_notes(CUBIC, 12);
    scene.c = -1300.0;
    scene_of_options(argc, argv, &scene);
    print_stages(&scene);

    struct newton_control control = bar_scene_control(&scene);
    struct newton_report report = {.status = MAX_ITERATIONS};
    struct bar_state *s = NULL;
    const int cap = control.max_iterations;
    table_begin("history", "k residual increment min_F");
    for (int k = 0; k <= cap && report.status == MAX_ITERATIONS; k++) {
        control.max_iterations = k;
        bar_state_free(s);
        s = bar_state_by(load_vector, &scene);
        report = newton(&s->bar, &control, s->u);
        if (report.iterations == k)
            table_row(k, cell_if(report.status != INVERTED, report.residual),
                      cell_if(k > 0, report.increment),
                      bar_min_stretch(&s->bar, s->u));
    }
    table_end();
    if (report.status != OK)
        die("Newton's method with full steps: %s after step %d",
            status_name(report.status), report.iterations);
    table_begin("nodes", "X u");
    for (int i = 0; i <= scene.n; i++) table_row(i * s->bar.h, s->u[i]);
    table_end();
    bar_state_free(s);
    return table_finish();
}
