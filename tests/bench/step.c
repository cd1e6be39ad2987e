/*
 * step.c - what a whole time step costs, on the machine at hand.
 *
 * The scene: (-1,1)^2, n x n squares, E = 1000, nu = 0.3, cubic r, consistent
 * mass, backward Euler, dt = 1/30, u = (X1/2 sin t, 0) on X1 = +-1, Newton to
 * max|du| <= 1e-10 m.  One thread.  The methods:
 *
 *     notes    the readable program: element loop with dP/dF, all vertices as
 *              they are numbered, prescribed rows and columns corrected, full
 *              Newton from the last state, GSL's banded Cholesky
 *     lapack   closed-form assembly, the same Newton, dpbtrf and dpbtrs
 *     blocked  the same with common/banded.c
 *     best     guess extrapolated and lifted, factors kept [alg:chord]
 *
 * They take turns, run by run.  A run whose displacements are not those of
 * `best` to 1e-9 m has no time.  Medians; nothing is asserted.
 */
#include "bench.h"
#include "clock.h"
#include "options.h"
#include "step.h"
#include "table.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double dt = 1.0 / 30.0, tolerance = 1e-10, agreement = 1e-9;
enum { STEPS = 30, FRAMES = 90, MOST_ITERATIONS = 50 };

/* ---- the scene ----------------------------------------------------------- */

struct scene {
    int n_dof;
    struct mesh *mesh;
    struct body *body;
    double *g; /* boundary values of the step */
};

static struct scene scene_make(int n)
{
    struct scene s = {.mesh = mesh_square(n)};
    int *fixed = allocate((size_t)s.mesh->n_vertex, sizeof *fixed);
    for (int a = 0; a < s.mesh->n_vertex; a++)
        fixed[a] = a % (n + 1) == 0 || a % (n + 1) == n;
    s.n_dof = 2 * s.mesh->n_vertex;
    s.body = body_alloc(s.mesh, material_make(CUBIC, 1000.0, 0.3), 1.0,
                        CONSISTENT, fixed);
    s.g = allocate((size_t)s.n_dof, sizeof *s.g);
    free(fixed);
    return s;
}

static void scene_free(struct scene s)
{
    free(s.g);
    body_free(s.body);
    mesh_free(s.mesh);
}

static void boundary_values(struct scene s, int step)
{
    for (int r = 0; r < s.n_dof; r += 2)
        s.g[r] = 0.5 * s.mesh->X[r] * sin(step * dt);
}

/* ---- the readable program ------------------------------------------------ */

/* A band of all unknowns as they are numbered, GSL's: A[j+d][j] at
 * a[j * width + d]. */
struct band {
    int width; /* p + 1 */
    double *a;
};

static void band_add(struct band K, int i, int j, double value)
{
    if (i >= j) K.a[(size_t)j * (size_t)K.width + (size_t)(i - j)] += value;
}

static double mass_of(double area, int a, int b)
{
    return area / (a == b ? 6.0 : 12.0);
}

/* q and K of element e [eq:body-q] [eq:body-tangent]: every column of K is the
 * change of force when one unknown moves. */
static void add_element(struct scene s, int e, const double w[],
                        const double u[], double q[], struct band K)
{
    const int *node = &s.mesh->triangle[3 * e];
    const struct material *material = &s.body->material;
    double G[6];
    const double area = mesh_gradients(s.mesh, e, G);
    mat2 F = mat2_identity();
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++)
            for (int J = 0; J < 2; J++)
                F.m[i][J] += u[2 * node[a] + i] * G[2 * a + J];
    const mat2 P = material2_pk1(material, F);
    for (int b = 0; b < 3; b++)
        for (int k = 0; k < 2; k++) {
            const int column = 2 * node[b] + k;
            mat2 dF = {{{0.0, 0.0}, {0.0, 0.0}}};
            dF.m[k][0] = G[2 * b];
            dF.m[k][1] = G[2 * b + 1];
            const mat2 dP = material2_dpk1(material, F, dF);
            q[column] += dt * dt * area *
                         (P.m[k][0] * G[2 * b] + P.m[k][1] * G[2 * b + 1]);
            for (int a = 0; a < 3; a++) {
                const double m = s.body->rho * mass_of(area, a, b);
                q[2 * node[a] + k] += m * (u[column] - w[column]);
                for (int i = 0; i < 2; i++)
                    band_add(K, 2 * node[a] + i, column,
                             dt * dt * area * (dP.m[i][0] * G[2 * a] +
                                               dP.m[i][1] * G[2 * a + 1]) +
                                 (i == k ? m : 0.0));
            }
        }
}

static void readable_assemble(struct scene s, const double w[],
                              const double u[], double q[], struct band K)
{
    memset(K.a, 0, (size_t)s.n_dof * (size_t)K.width * sizeof *K.a);
    memset(q, 0, (size_t)s.n_dof * sizeof *q);
    for (int e = 0; e < s.mesh->n_triangle; e++) add_element(s, e, w, u, q, K);
}

/* Row and column of every prescribed unknown: those of the identity, du = 0. */
static void correct(struct scene s, double q[], struct band K)
{
    const size_t width = (size_t)K.width;
    for (size_t r = 0; r < (size_t)s.n_dof; r++) {
        if (s.body->equation[r] >= 0) continue;
        for (size_t d = 1; d < width; d++) {
            K.a[r * width + d] = 0.0;
            if (d <= r) K.a[(r - d) * width + d] = 0.0;
        }
        K.a[r * width] = 1.0;
        q[r] = 0.0;
    }
}

/* du := -K^{-1} q; not 0: not SPD. */
static int gsl_increment(struct scene s, const double w[], const double u[],
                         double q[], struct band K, double du[])
{
    readable_assemble(s, w, u, q, K);
    correct(s, q, K);
    for (int r = 0; r < s.n_dof; r++) du[r] = -q[r];
    gsl_matrix_view matrix = gsl_matrix_view_array(K.a, (size_t)s.n_dof,
                                                   (size_t)K.width);
    gsl_vector_view x = gsl_vector_view_array(du, (size_t)s.n_dof);
    return gsl_linalg_cholesky_band_decomp(&matrix.matrix) ||
           gsl_linalg_cholesky_band_svx(&matrix.matrix, &x.vector);
}

/* ---- LAPACK on the band of common/ --------------------------------------- */

static int lapack_increment(struct scene s, const double w[], const double u[],
                            double q[], double b[], double du[])
{
    int info = 1;
    if (body_assemble(s.body, dt, w, NULL, u, EXACT, q) != OK) return info;
    for (int r = 0; r < s.n_dof; r++)
        if (s.body->equation[r] >= 0) b[s.body->equation[r]] = -q[r];
#ifdef LAPACK
    struct matrix *K = s.body->K;
    const int lda = (int)K->stride, one = 1;
    dpbtrf_("L", &K->n, &K->p, K->a, &lda, &info, 1);
    if (info == 0)
        dpbtrs_("L", &K->n, &K->p, &one, K->a, &lda, b, &K->n, &info, 1);
#endif
    for (int r = 0; r < s.n_dof; r++)
        du[r] = s.body->equation[r] >= 0 ? b[s.body->equation[r]] : 0.0;
    return info;
}

/* ---- the methods --------------------------------------------------------- */

enum method { NOTES, LAPACK_BAND, BLOCKED, BEST, METHODS };
static const char *const method_name[] = {"notes", "lapack", "blocked", "best"};

static int exists(enum method method)
{
#ifdef LAPACK
    return method < METHODS;
#else
    return method != LAPACK_BAND;
#endif
}

static const struct step_control plain = {1e-10, MOST_ITERATIONS, FROM_LAST,
                                          0,     0,               0,
                                          NEVER};
static const struct step_control best = {1e-10, MOST_ITERATIONS, EXTRAPOLATED,
                                         1,     1,               0,
                                         NEVER};

/* Full Newton from the last state, by NOTES or LAPACK_BAND [alg:body-newton];
 * iterations, 0 when it failed. */
static int full_newton(enum method method, struct scene s, struct band K,
                       double u[], double v[])
{
    const size_t n_dof = (size_t)s.n_dof;
    double *w = allocate(5 * n_dof, sizeof *w), *next = w + n_dof;
    double *q = w + 2 * n_dof, *du = w + 3 * n_dof, *b = w + 4 * n_dof;
    double largest = INFINITY;
    int iterations = 0, failed = 0;
    for (int r = 0; r < s.n_dof; r++) {
        w[r] = u[r] + dt * v[r];
        next[r] = s.body->equation[r] < 0 ? s.g[r] : u[r];
    }
    while (!failed && largest > tolerance && iterations < MOST_ITERATIONS) {
        failed = method == NOTES ? gsl_increment(s, w, next, q, K, du)
                                 : lapack_increment(s, w, next, q, b, du);
        largest = 0.0;
        for (int r = 0; r < s.n_dof; r++) {
            next[r] += du[r];
            if (!(fabs(du[r]) <= largest)) largest = fabs(du[r]);
        }
        iterations++;
    }
    for (int r = 0; r < s.n_dof; r++) {
        v[r] = (next[r] - u[r]) / dt;
        u[r] = next[r];
    }
    free(w);
    return !failed && largest <= tolerance ? iterations : 0;
}

/* What the steps of a run were. */
struct tally {
    int steps, iterations, most, factorisations;
    double difference; /* from the path given, max (m); INFINITY: failed */
};

static void count(struct tally *tally, struct step_report report)
{
    tally->steps++;
    tally->iterations += report.iterations;
    tally->factorisations += report.factorisations;
    if (report.iterations > tally->most) tally->most = report.iterations;
    if (report.status != OK) tally->difference = INFINITY;
}

/*
 * Steps first .. last by a method; control is looked at by BLOCKED and BEST.
 *
 * path: displacements [n_dof] at steps 0, 1, ...; a run starts on it, and is
 * compared with it, or (record) writes it on.  second: [steps], or NULL.
 */
static struct tally run(enum method method, const struct step_control *control,
                        struct scene s, int first, int last, double path[],
                        int record, double second[])
{
    const size_t n_dof = (size_t)s.n_dof;
    struct tally tally = {0};
    double *u = allocate(3 * n_dof, sizeof *u);
    double *v = u + n_dof, *v_before = u + 2 * n_dof;
    const struct band K = {
        2 * s.mesh->n + 6,
        method == NOTES ? allocate(n_dof * (size_t)(2 * s.mesh->n + 6),
                                   sizeof(double))
                        : NULL};
    const double *start = &path[(size_t)(first - 1) * n_dof];
    memcpy(u, start, n_dof * sizeof *u);
    for (size_t r = 0; r < n_dof; r++) {
        if (first > 1) v[r] = (start[r] - start[r - n_dof]) / dt;
        if (first > 2)
            v_before[r] = (start[r - n_dof] - start[r - 2 * n_dof]) / dt;
    }
    for (int step = first; step <= last; step++) {
        double *at = &path[(size_t)step * n_dof];
        struct step_report report = {.status = OK};
        boundary_values(s, step);
        const double before = clock_seconds();
        if (method >= BLOCKED) {
            report = step_backward_euler(s.body, control, dt, s.g, NULL, u, v,
                                         v_before);
        } else {
            report.iterations = full_newton(method, s, K, u, v);
            report.factorisations = report.iterations;
            if (report.iterations == 0) report.status = MAX_ITERATIONS;
        }
        if (second) second[step - first] = clock_seconds() - before;
        count(&tally, report);
        for (size_t r = 0; r < n_dof; r++) {
            if (record) at[r] = u[r];
            tally.difference = fmax(tally.difference, fabs(u[r] - at[r]));
        }
    }
    free(u);
    free(K.a);
    return tally;
}

static const struct step_control *control_of(enum method method)
{
    return method == BEST ? &best : &plain;
}

static double *path_alloc(struct scene s, int steps)
{
    return allocate((size_t)(steps + 1) * (size_t)s.n_dof, sizeof(double));
}

/* ---- Newton: where it starts, and how often it factors ------------------- */

enum { GUESSES = 4 };
static const struct {
    const char *name;
    enum guess guess;
    int lift;
} start[GUESSES] = {{"newton_last", FROM_LAST, 0},
                    {"newton_velocity", FROM_VELOCITY, 0},
                    {"newton_velocity_lift", FROM_VELOCITY, 1},
                    {"newton_extrapolated_lift", EXTRAPOLATED, 1}};

static void bench_newton(void)
{
    const int sizes[] = {8, 16, 32, 64, 96};
    struct tally tally[COUNT(sizes)][GUESSES][2];
    for (int k = 0; k < COUNT(sizes); k++) {
        struct scene s = scene_make(sizes[k]);
        double *path = path_alloc(s, STEPS);
        for (int g = GUESSES - 1; g >= 0; g--)
            for (int chord = 0; chord < 2; chord++) {
                struct step_control control = plain;
                control.guess = start[g].guess;
                control.lift = start[g].lift;
                control.chord = chord;
                tally[k][g][chord] =
                    run(BLOCKED, &control, s, 1, STEPS, path,
                        g == GUESSES - 1 && chord == 0, NULL);
            }
        free(path);
        scene_free(s);
    }
    for (int g = 0; g < GUESSES; g++) {
        table_begin_note(start[g].name,
                         "n full_mean full_max chord_mean chord_max "
                         "chord_factorisations difference",
                         "iterations (linear systems) a step; chord: factors "
                         "kept while max|du| falls below 0.3 of the one "
                         "before; difference: of the answers (m)");
        for (int k = 0; k < COUNT(sizes); k++) {
            const struct tally full = tally[k][g][0], chord = tally[k][g][1];
            const double difference = fmax(full.difference, chord.difference);
            row(sizes[k], (double)full.iterations / full.steps, full.most,
                (double)chord.iterations / chord.steps, chord.most,
                (double)chord.factorisations / chord.steps,
                isfinite(difference) ? difference : (double)NAN);
        }
        table_end();
    }
}

/* ---- whole steps --------------------------------------------------------- */

enum { SIZES = 7 };
static const int size[SIZES] = {8, 16, 32, 64, 88, 96, 128};
/* runs, and steps of a run: the slow ones take a few steps in the middle */
static const int runs_at[SIZES] = {20, 15, 7, 3, 2, 2, 1};
static int steps_at(enum method method, int n)
{
    if (method == BEST || n <= 32) return STEPS;
    return method == NOTES && n > 64 ? 2 : 8;
}

struct limits { /* of the machine, and what a step is at them [eq:roofline] */
    double factor, read, assembly; /* ms */
};

struct measured {
    struct times t[METHODS];
    struct tally tally[METHODS]; /* of the last run */
    struct limits limits;
    struct distance {
        double rms, max; /* (m) */
    } to_next;           /* the solution at 2n, t = 1 */
};

/* Flops of an element's residual and tangent in closed form, about. */
static const double element_flops = 250.0;

static struct limits roofline(const struct body *body, double iterations,
                              double peak)
{
    const struct matrix *K = body->K;
    const double stored = (double)K->n * (K->p + 1) * sizeof(double);
    return (struct limits){
        1e-6 * K->n * (K->p + 1.0) * (K->p + 1.0) / peak,
        1e-6 * 2.0 * iterations * stored / bench_read_gigabyte((size_t)stored),
        1e-6 * body->mesh->n_triangle * element_flops / peak};
}

static void measure_size(int k, double peak, struct measured *m,
                         double answer[])
{
    struct scene s = scene_make(size[k]);
    double *path = path_alloc(s, STEPS), second[STEPS];
    const size_t bytes = (size_t)s.n_dof * sizeof(double);
    run(BEST, &best, s, 1, STEPS, path, 1, NULL); /* and memory is touched */
    for (int r = 0; r < runs_at[k]; r++)
        for (int method = 0; method < METHODS; method++) {
            if (!exists((enum method)method)) continue;
            const int steps = steps_at((enum method)method, size[k]);
            const int first = (STEPS - steps) / 2 + 1;
            m->tally[method] =
                run((enum method)method, control_of((enum method)method), s,
                    first, first + steps - 1, path, 0, second);
            for (int i = 0; i < steps; i++)
                times_record(&m->t[method], second[i],
                             m->tally[method].difference <= agreement);
        }
    m->limits = roofline(s.body,
                         (double)m->tally[BEST].iterations / STEPS, peak);
    memcpy(answer, path + (size_t)STEPS * (size_t)s.n_dof, bytes);
    free(path);
    scene_free(s);
}

/* |u_n - u_2n| at the vertices that both meshes have. */
static struct distance distance(int n, const double coarse[],
                                const double fine[])
{
    struct distance d = {0.0, 0.0};
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n; i++) {
            const double *u = &coarse[2 * (j * (n + 1) + i)];
            const double *v = &fine[4 * (j * (2 * n + 1) + i)];
            const double apart = hypot(u[0] - v[0], u[1] - v[1]);
            d.rms += apart * apart / (n + 1) / (n + 1);
            d.max = fmax(d.max, apart);
        }
    d.rms = sqrt(d.rms);
    return d;
}

static void print_ratios(const struct measured m[SIZES])
{
    table_begin_note("ratios",
                     "n notes_over_best lapack_over_best blocked_over_best "
                     "best_iterations best_factorisations",
                     "their median step over that of the best; its iterations "
                     "and factorisations a step");
    for (int k = 0; k < SIZES; k++) {
        const double least = times_median(&m[k].t[BEST]);
        row(size[k], times_median(&m[k].t[NOTES]) / least,
            times_median(&m[k].t[LAPACK_BAND]) / least,
            times_median(&m[k].t[BLOCKED]) / least,
            (double)m[k].tally[BEST].iterations / STEPS,
            (double)m[k].tally[BEST].factorisations / STEPS);
    }
    table_end();
}

static void print_steps(const struct measured m[SIZES])
{
    for (int method = 0; method < METHODS; method++) {
        if (!exists((enum method)method)) continue;
        table_begin_note(method_name[method],
                         "n unknowns steps runs median_ms p99_ms worst_ms "
                         "iterations difference",
                         "milliseconds a step; steps: of a run, from the "
                         "middle of the %d when fewer; difference from best "
                         "(m)", STEPS);
        for (int k = 0; k < SIZES; k++) {
            const struct tally tally = m[k].tally[method];
            const struct times *t = &m[k].t[method];
            row(size[k], 2 * (size[k] + 1) * (size[k] - 1), tally.steps,
                runs_at[k], 1e3 * times_median(t),
                1e3 * times_quantile(t, 0.99), 1e3 * times_quantile(t, 1.0),
                (double)tally.iterations / tally.steps,
                isfinite(tally.difference) ? tally.difference : (double)NAN);
        }
        table_end();
    }
}

static double predicted(struct limits limits)
{
    return limits.factor + limits.read + limits.assembly;
}

static void print_roofline(const struct measured m[SIZES], double peak)
{
    table_begin_note("roofline",
                     "n peak_gigaflop factor_ms read_ms assembly_ms "
                     "predicted_ms measured_ms measured_over_predicted",
                     "a step at the limits of one core: one factorisation and "
                     "one assembly at the peak of multiply-adds, L read twice "
                     "an iteration at the bandwidth of its size");
    for (int k = 0; k < SIZES; k++) {
        const struct limits limits = m[k].limits;
        const double ms = 1e3 * times_median(&m[k].t[BEST]);
        row(size[k], peak, limits.factor, limits.read, limits.assembly,
            predicted(limits), ms, ms / predicted(limits));
    }
    table_end();
}

static void print_growth(const struct measured m[SIZES])
{
    table_begin_note("growth", "n notes lapack blocked best roofline",
                     "exponent of n in the median step from n to 2 n; in the "
                     "limit 4 (factor); 3: solve, 2: assembly");
    for (int k = 0; k < SIZES; k++)
        for (int l = k + 1; l < SIZES; l++) {
            double power[METHODS];
            if (size[l] != 2 * size[k]) continue;
            for (int method = 0; method < METHODS; method++)
                power[method] = log2(times_median(&m[l].t[method]) /
                                     times_median(&m[k].t[method]));
            row(size[k], power[NOTES], power[LAPACK_BAND], power[BLOCKED],
                power[BEST],
                log2(predicted(m[l].limits) / predicted(m[k].limits)));
        }
    table_end();
}

static void print_accuracy(const struct measured m[SIZES])
{
    struct distance before = {(double)NAN, (double)NAN};
    table_begin_note("accuracy",
                     "n rms order max max_order notes_ms lapack_ms blocked_ms "
                     "best_ms",
                     "|u_n - u_2n| (m) at t = 1 over the vertices, what "
                     "halving the elements still changes; median ms a step");
    for (int k = 0; k < SIZES; k++) {
        const struct distance d = m[k].to_next;
        if (!(d.rms > 0.0)) continue;
        row(size[k], d.rms, log2(before.rms / d.rms), d.max,
            log2(before.max / d.max), 1e3 * times_median(&m[k].t[NOTES]),
            1e3 * times_median(&m[k].t[LAPACK_BAND]),
            1e3 * times_median(&m[k].t[BLOCKED]),
            1e3 * times_median(&m[k].t[BEST]));
        before = d;
    }
    table_end();
}

static void bench_steps(void)
{
    static struct measured m[SIZES];
    const double peak = bench_peak_gigaflop();
    double *answer[SIZES];
    for (int k = 0; k < SIZES; k++) {
        const size_t vertices = (size_t)(size[k] + 1) * (size_t)(size[k] + 1);
        answer[k] = allocate(2 * vertices, sizeof(double));
        measure_size(k, peak, &m[k], answer[k]);
    }
    for (int k = 0; k < SIZES; k++)
        for (int l = k; l < SIZES; l++)
            if (size[l] == 2 * size[k])
                m[k].to_next = distance(size[k], answer[k], answer[l]);
    print_ratios(m);
    print_steps(m);
    print_roofline(m, peak);
    print_growth(m);
    print_accuracy(m);
    for (int k = 0; k < SIZES; k++) free(answer[k]);
}

/* ---- assembly ------------------------------------------------------------ */

enum assembly { READABLE, RESIDUAL, BOTH, CLAMPED, CLEAR, ASSEMBLIES };

static double assembly_seconds(enum assembly kind, struct scene s,
                               const double w[], const double u[], double q[],
                               struct band K)
{
    const double start_at = clock_seconds();
    if (kind == READABLE)
        readable_assemble(s, w, u, q, K);
    else if (kind == CLEAR)
        matrix_zero(s.body->K);
    else
        body_assemble(s.body, dt, w, NULL, u,
                      kind == RESIDUAL ? NO_TANGENT
                      : kind == BOTH   ? EXACT
                                       : PROJECTED,
                      q);
    return clock_seconds() - start_at;
}

static void bench_assembly(void)
{
    const int sizes[] = {16, 32, 64};
    table_begin_note("assembly",
                     "n readable_over_both readable residual both projected "
                     "clear spread_both",
                     "ns an element: residual and tangent readable, closed "
                     "form (both), with clamped eigenvalues (projected; "
                     "about half of the elements have some); residual alone; "
                     "clear: of it, zeros into the band");
    for (int k = 0; k < COUNT(sizes); k++) {
        struct scene s = scene_make(sizes[k]);
        const int width = 2 * sizes[k] + 6;
        double *w = allocate(3 * (size_t)s.n_dof, sizeof *w);
        double *u = w + s.n_dof, *q = w + 2 * s.n_dof, ns[ASSEMBLIES];
        struct band K = {width, allocate((size_t)s.n_dof * (size_t)width,
                                         sizeof(double))};
        static struct times t[ASSEMBLIES];
        memset(t, 0, sizeof t);
        for (int r = 0; r < s.n_dof; r++)
            u[r] = 0.238 / sizes[k] * sin(2.385 * r);
        for (int i = 0; i < 4096 / sizes[k] / sizes[k] * 30 + 30; i++)
            for (int kind = 0; kind < ASSEMBLIES; kind++) {
                double seconds = 0.0;
                for (int warm = 0; warm < 2; warm++) /* the second counts */
                    seconds = assembly_seconds((enum assembly)kind, s, w, u, q,
                                               K);
                times_record(&t[kind], 1e9 * seconds / s.mesh->n_triangle, 1);
            }
        for (int kind = 0; kind < ASSEMBLIES; kind++)
            ns[kind] = times_median(&t[kind]);
        row(sizes[k], ns[READABLE] / ns[BOTH], ns[READABLE], ns[RESIDUAL],
            ns[BOTH], ns[CLAMPED], ns[CLEAR], times_spread(&t[BOTH]));
        free(w);
        free(K.a);
        scene_free(s);
    }
    table_end();
}

/* ---- real time ----------------------------------------------------------- */

static void bench_realtime(void)
{
    static const int sizes[] = {8,  16, 24, 32,  40,  48,  56,  64,
                                72, 80, 88, 96, 104, 112, 120, 128};
    static struct times t[COUNT(sizes)][METHODS];
    int missed[METHODS] = {0}, largest[METHODS] = {0};
    double second[FRAMES];
    for (int k = 0; k < COUNT(sizes) && missed[BEST] < 2; k++) {
        struct scene s = scene_make(sizes[k]);
        double *path = path_alloc(s, FRAMES);
        for (int method = METHODS - 1; method >= 0; method--) {
            if (!exists((enum method)method) || missed[method] == 2) continue;
            const struct tally tally =
                run((enum method)method, control_of((enum method)method), s, 1,
                    FRAMES, path, method == BEST, second);
            for (int i = 0; i < FRAMES; i++)
                times_record(&t[k][method], second[i],
                             tally.difference <= agreement);
            if (times_quantile(&t[k][method], 0.99) <= dt)
                largest[method] = sizes[k];
            else
                missed[method]++;
        }
        free(path);
        scene_free(s);
    }
    table_begin_note("realtime", "notes lapack blocked best",
                     "the largest n whose 99th percentile of %d frames is "
                     "below 1/30 s", FRAMES);
    row(largest[NOTES], largest[LAPACK_BAND], largest[BLOCKED], largest[BEST]);
    table_end();
    for (int method = 0; method < METHODS; method++) {
        char name[64];
        if (!exists((enum method)method)) continue;
        snprintf(name, sizeof name, "realtime_%s", method_name[method]);
        table_begin(name, "n p50_ms p99_ms worst_ms");
        for (int k = 0; k < COUNT(sizes) && t[k][method].runs > 0; k++)
            row(sizes[k], 1e3 * times_median(&t[k][method]),
                1e3 * times_quantile(&t[k][method], 0.99),
                1e3 * times_quantile(&t[k][method], 1.0));
        table_end();
    }
}

int main(int argc, char *argv[])
{
    options_parse("bench", NULL, 0, argc, argv);
    gsl_set_error_handler_off();
    bench_header();
    bench_newton();
    bench_steps();
    bench_assembly();
    bench_realtime();
    return table_finish();
}
