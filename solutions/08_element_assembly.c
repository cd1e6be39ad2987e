/*
 * 08_element_assembly.c - assemble A u = b element by element, and chart what
 * accuracy costs with dense and with banded storage.
 *
 * Notes: Lecture 2, section 1.1, exercise (6).
 *
 * Problem.  The boundary value problem of lesson 07 [eq:poisson-bvp], but A and
 * b are filled by a loop over elements [alg:element-assembly].  Element e joins
 * nodes e and e + 1 and adds four numbers to A and two to b, whatever its
 * place: no entry is special at the ends, and any order of elements will do.
 *
 *     | K00 K01  .   . |   element 0     | r0     |
 *     | K10 K11+K00 K01|   elements 0, 1 | r1+r0  |   (superscripts left out:
 *     |  .  K10 K11+.. |   ...           | r1+..  |    each from its element)
 *
 * Then the first speed-accuracy chart.  Its rules: a run that is not valid has
 * no time; one problem, one knob (n) a curve; work counted beside the seconds;
 * machine and flags named; the best of several repeats.
 *
 * Run       make lesson-08, or with options: -h lists them
 * Expect    the matrix of the vertex loop to 4 eps, in every order; with
 *           n = 256 the same error 4.85e-7 for 5.82 million flops (dense) or
 *           2563 flops (banded)
 * Plot: nodes x u
 */
#include "clock.h"
#include "matrix.h"
#include "options.h"
#include "poisson.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* [eq:poisson-bvp]: beta, f, the solution and its derivative; u(0) = 1 and
 * the flux beta u' at x = 1. */
static double bvp_beta(double x)
{
    return 1.0 + x;
}
static double bvp_f(double x)
{
    return 1.0 / ((1.0 + x) * (1.0 + x));
}
static double bvp_u(double x)
{
    return 2.0 - 1.0 / (1.0 + x) - log1p(x);
}
static double bvp_u_dx(double x)
{
    return -x / ((1.0 + x) * (1.0 + x));
}
static const double U_LEFT = 1.0, FLUX_RIGHT = -0.5;

/* A run is valid when its u solves a system that differs from A u = b by this
 * many eps (Cholesky without fill does, whatever the condition number) ... */
static const double BACKWARD_EPS = 20.0;
/* ... and its L2 error is at most this over n^2, plus round-off N^2 eps (the
 * midpoint rule has 0.032, Gauss 0.041, the trapezoidal rule 0.079). */
static const double ERROR_CONSTANT = 0.1;

/*
 * Stiffness and load of the element (x0, x1), its nodes 0 and 1, by a
 * quadrature rule [eq:poisson-local] [eq:quadrature]:
 *
 *     K[a][c] = int beta e_a' e_c' dx,   r[a] = int f e_a dx,   a, c = 0, 1.
 *
 * At x0 + s h the hats are e_0 = 1 - s and e_1 = s; their slopes are -+ 1/h.
 *
 * rule   in   n points s[k] and weights w[k] on (0, 1)
 * K, r   out  all entries are set
 */
static void element(double x0, double x1, field *beta, field *f,
                    const struct quadrature *rule, double K[2][2],
                    double r[2])
{
    /* SLOT 8a(x0, x1, beta, f, rule, K, r): set the four entries of K and the
     * two of r [eq:poisson-local]; all integrals are over this element. */
    const double h = x1 - x0;
    double beta_mean = 0.0;

    r[0] = r[1] = 0.0;
    for (int k = 0; k < rule->n; k++) {
        const double s = rule->s[k];
        const double load = h * rule->w[k] * f(x0 + s * h);
        beta_mean += rule->w[k] * beta(x0 + s * h);
        r[0] += load * (1.0 - s);
        r[1] += load * s;
    }
    K[0][0] = K[1][1] = beta_mean / h;
    K[0][1] = K[1][0] = -beta_mean / h;
    /* END 8a */
}

/*
 * A and b of all elements, no boundary condition yet [alg:element-assembly].
 *
 * x      in   nodes x[0..n]
 * order  in   the elements 0..n-1 in the order in which to visit them
 * A      out  order n + 1, dense or banded; whatever it held is forgotten
 * b      out  b[0..n]
 */
static void assemble(int n, const double x[], field *beta, field *f,
                     const struct quadrature *rule, const int order[],
                     struct matrix *A, double b[])
{
    /* SLOT 8b(n, x, beta, f, rule, order, A, b): start from zero; visit the
     * elements in the given order and add what each contributes to A (with
     * matrix_add) and to b. */
    matrix_zero(A);
    for (int i = 0; i <= n; i++) b[i] = 0.0;

    for (int k = 0; k < n; k++) {
        const int e = order[k];
        double K[2][2], r[2];
        element(x[e], x[e + 1], beta, f, rule, K, r);
        for (int a = 0; a < 2; a++) {
            b[e + a] += r[a];
            for (int c = 0; c < 2; c++) matrix_add(A, e + a, e + c, K[a][c]);
        }
    }
    /* END 8b */
}

/*
 * The same A and b node by node, as in lessons 05 to 07: each entry is written
 * once, from the one or two elements at its node [eq:quadrature-A]
 * [eq:quadrature-b].  This is what the element loop is compared with.
 */
static void assemble_by_vertex(int n, const double x[], field *beta, field *f,
                               const struct quadrature *rule,
                               struct matrix *A, double b[])
{
    matrix_zero(A);
    for (int i = 0; i <= n; i++) {
        double diagonal = 0.0, right = 0.0, load = 0.0;
        for (int k = 0; k < rule->n; k++) {
            const double s = rule->s[k], w = rule->w[k];
            if (i > 0) { /* the element on the left of node i */
                const double h = x[i] - x[i - 1], at = x[i - 1] + s * h;
                diagonal += w * beta(at) / h;
                load += w * s * h * f(at);
            }
            if (i < n) { /* the one on its right */
                const double h = x[i + 1] - x[i], at = x[i] + s * h;
                diagonal += w * beta(at) / h;
                right -= w * beta(at) / h;
                load += w * (1.0 - s) * h * f(at);
            }
        }
        b[i] = load;
        matrix_add(A, i, i, diagonal);
        if (i < n) {
            matrix_add(A, i, i + 1, right);
            matrix_add(A, i + 1, i, right);
        }
    }
}

/*
 * Flops (additions, multiplications, divisions, square roots, one each) of the
 * textbook factorisation A = L L^T and the two triangular solves
 * [eq:cholesky-flops], order N, half bandwidth p; dense is p = N - 1.  A double
 * holds these integers exactly (they stay below 2^53).
 */
static double cholesky_flops(int N, int p)
{
    /* SLOT 8c(N, p): add up, column by column of L; m entries of column k lie
     * below the diagonal [eq:cholesky-flops].  Exact, not to leading order. */
    double flops = 0.0;
    for (int k = 0; k < N; k++) {
        const double m = N - 1 - k < p ? N - 1 - k : p;
        flops += (m + 1.0) * (m + 1.0); /* root, m divisions, m (m + 1) */
        flops += 2.0 * (2.0 * m + 1.0); /* column k in both solves */
    }
    return flops;
    /* END 8c */
}

/*
 * |b - A u| / (|A| |u| + |b|) in units of eps, maximum norms: how far the
 * system that u solves exactly is from A u = b.  NaN if an entry is.
 */
static double backward_error(const struct matrix *A, const double u[],
                             const double b[])
{
    double norm_A = 0.0, norm_u = 0.0, norm_b = 0.0;
    for (int i = 0; i < A->n; i++) {
        const int last = i + A->p < A->n ? i + A->p : A->n - 1;
        double sum = 0.0;
        for (int j = i > A->p ? i - A->p : 0; j <= last; j++)
            sum += fabs(matrix_get(A, i, j));
        norm_A = fmax(norm_A, sum);
        norm_u = fmax(norm_u, fabs(u[i]));
        norm_b = fmax(norm_b, fabs(b[i]));
    }
    return matrix_residual(A, u, b) /
           (DBL_EPSILON * (norm_A * norm_u + norm_b));
}

/* One run of factor + solve, a point of the chart. */
struct point {
    enum status status; /* of the factorisation */
    int valid;          /* 1, or 0: then there is no time */
    double seconds;     /* factor + solve, the best of the repeats; or 0 */
    double backward;    /* backward error in eps; or 0 */
    double flops, entries, L2; /* set by chart_point() */
};

/*
 * u := A^{-1} b, timed [eq:cholesky].  Valid: factored, and a backward error
 * of at most BACKWARD_EPS.  A and b are left alone.
 */
static struct point measure(const struct matrix *A, const double b[],
                            int repeats, double u[])
{
    struct point point = {.status = OK};
    /* SLOT 8d(A, b, repeats, u, &point, backward_error): factor a copy and
     * solve, `repeats` times, with the clock around these two calls only; keep
     * the shortest time.  Then judge: not valid, no time (NaN included). */
    for (int k = 0; k < repeats && point.status == OK; k++) {
        struct matrix *L = matrix_copy(A);
        memcpy(u, b, (size_t)A->n * sizeof *u);

        const double start = clock_seconds();
        point.status = matrix_factor(L);
        if (point.status == OK) matrix_solve(L, u);
        const double seconds = clock_seconds() - start;

        if (k == 0 || seconds < point.seconds) point.seconds = seconds;
        matrix_free(L);
    }
    if (point.status == OK) {
        point.backward = backward_error(A, u, b);
        point.valid = point.backward <= BACKWARD_EPS; /* false for NaN */
    }
    if (!point.valid) point.seconds = point.backward = 0.0;
    /* END 8d */
    return point;
}

enum order { NATURAL, REVERSED, RANDOM };

/* The elements 0..n-1 in natural, reversed or (seeded) random order. */
static void make_order(int n, enum order kind, int seed, int order[])
{
    for (int k = 0; k < n; k++) order[k] = kind == REVERSED ? n - 1 - k : k;
    if (kind != RANDOM) return;
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, (unsigned long)seed);
    gsl_ran_shuffle(rng, order, (size_t)n, sizeof *order);
    gsl_rng_free(rng);
}

/* A system on a grid; every pointer is owned. */
struct scene {
    int n, *order;
    double *x, *b, *u;
    struct matrix *A;
};

/* n elements on (0, 1), A and b assembled, the flux at x = 1 in b. */
static struct scene scene_make(enum storage storage, int n, double grading,
                               enum order kind, int seed,
                               const struct quadrature *rule)
{
    const size_t N = (size_t)n + 1;
    const struct scene s = {
        n, allocate(N, sizeof *s.order), allocate(N, sizeof *s.x),
        allocate(N, sizeof *s.b), allocate(N, sizeof *s.u),
        matrix_alloc(storage, n + 1, 1)};
    grid_make(0.0, 1.0, n, grading, s.x);
    make_order(n, kind, seed, s.order);
    assemble(n, s.x, bvp_beta, bvp_f, rule, s.order, s.A, s.b);
    s.b[n] += FLUX_RIGHT;
    return s;
}

static void scene_free(struct scene *s)
{
    free(s->order);
    free(s->x);
    free(s->b);
    free(s->u);
    matrix_free(s->A);
}

/* u(0) = U_LEFT [eq:dirichlet-correction] */
static void fix_left(struct scene *s)
{
    const int left[] = {0};
    matrix_dirichlet(s->A, s->b, 1, left, &U_LEFT, KEEP_DIAGONAL);
}

static struct poisson_error errors(const struct scene *s)
{
    return poisson_errors(s->n, s->x, s->u, bvp_beta, bvp_u, bvp_u_dx);
}

/* One point of the chart: n equal elements, the one knob that turns. */
static struct point chart_point(enum storage storage, int n, int repeats,
                                const struct quadrature *rule)
{
    struct scene s = scene_make(storage, n, 1.0, NATURAL, 1, rule);
    const double N = n + 1.0;

    fix_left(&s);
    struct point point = measure(s.A, s.b, repeats, s.u);
    if (point.valid) point.L2 = errors(&s).L2;
    if (!(point.L2 <= ERROR_CONSTANT / n / n + N * N * DBL_EPSILON))
        point = (struct point){.status = point.status};
    point.flops = cholesky_flops(s.A->n, s.A->p);
    point.entries = (double)(matrix_bytes(s.A) / sizeof *s.A->a);
    scene_free(&s);
    return point;
}

/*
 * A curve of the chart: n doubles until the next point would take longer than
 * what is left of the budget (at least three points).  roundoff is 1 from
 * where a doubling of n no longer halves the error.
 */
static void print_chart(const char *name, enum storage storage, double budget,
                        int repeats, const struct quadrature *rule)
{
    const int last_n = storage == DENSE ? 1 << 12 : 1 << 20;
    const double growth = storage == DENSE ? 8.0 : 2.0; /* n^3 and n, n -> 2n */
    const double start = clock_seconds();
    double took = 0.0, previous = 0.0;
    int roundoff = 0;
    char machine[300];

    clock_machine(sizeof machine, machine);
    table_begin_note(name, "n flops seconds L2 backward_eps valid roundoff",
                     "machine: %s\n# factor + solve, best of %d; a run that is "
                     "not valid has no time", machine, repeats);
    for (int n = 8; n <= last_n; n *= 2) {
        const double now = clock_seconds();
        if (n > 32 && now - start + growth * took > budget) break;
        const struct point p = chart_point(storage, n, repeats, rule);
        took = clock_seconds() - now;
        if (p.valid && n > 8 && p.L2 > 0.5 * previous) roundoff = 1;
        if (p.valid) previous = p.L2;
        table_row(n, p.flops, p.seconds, p.L2, p.backward, p.valid, roundoff);
    }
    table_end();
}

/* The part of the chart that no machine changes: work, storage, error. */
static void print_work(const struct quadrature *rule)
{
    table_begin("work", "n flops_dense flops_banded entries_dense "
                        "entries_banded L2_dense L2_banded");
    for (int n = 4; n <= 256; n *= 2) {
        const struct point d = chart_point(DENSE, n, 1, rule);
        const struct point b = chart_point(BANDED, n, 1, rule);
        table_row(n, d.flops, b.flops, d.entries, b.entries, d.L2, b.L2);
    }
    table_end();
}

/*
 * Valid before fast: four systems on 64 elements, and what measure() makes of
 * them.  wrong_by is max |u - exact| where there is a u.
 */
static void print_validity(const struct quadrature *rule)
{
    enum { AS_IT_MUST_BE, NOTHING_FIXED, ROW_ONLY, NAN_IN_LOAD, TRIALS };
    table_begin_note("validity", "trial factored valid wrong_by",
                     "0 right, 1 no node fixed, 2 right end fixed by its row "
                     "only, 3 a NaN in the load");
    for (int trial = AS_IT_MUST_BE; trial < TRIALS; trial++) {
        struct scene s = scene_make(DENSE, 64, 1.0, NATURAL, 1, rule);
        const int n = s.n;
        if (trial == NAN_IN_LOAD) s.b[n / 2] = NAN;
        if (trial == ROW_ONLY) { /* the column stays, nothing moves into b */
            matrix_add(s.A, n, n - 1, -matrix_get(s.A, n, n - 1));
            s.b[n] = matrix_get(s.A, n, n) * bvp_u(1.0);
        } else if (trial != NOTHING_FIXED) {
            fix_left(&s);
        }
        const struct point p = measure(s.A, s.b, 1, s.u);
        const double off = errors(&s).nodal;
        table_row(trial, p.status == OK, p.valid,
                  p.status == OK && isfinite(off) ? off : 0.0);
        scene_free(&s);
    }
    table_end();
}

/* Each element's own numbers, one row an element. */
static void print_local(const struct scene *s, const struct quadrature *rule)
{
    table_begin("K_local", "e x0 x1 K00 K01 K10 K11 r0 r1");
    for (int e = 0; e < s->n; e++) {
        double K[2][2], r[2];
        element(s->x[e], s->x[e + 1], bvp_beta, bvp_f, rule, K, r);
        table_row(e, s->x[e], s->x[e + 1], K[0][0], K[0][1], K[1][0], K[1][1],
                  r[0], r[1]);
    }
    table_end();
}

/* max_k |v_k - w_k| / max_k |w_k| in units of eps. */
static double difference_eps(int n, const double v[], const double w[])
{
    double largest = 0.0, scale = 0.0;
    for (int k = 0; k < n; k++) {
        const double size = fabs(v[k] - w[k]);
        if (isnan(size) || size > largest) largest = size; /* NaN stays */
        scale = fmax(scale, fabs(w[k]));
    }
    return largest / (DBL_EPSILON * scale);
}

/* The element loop in each order against the vertex loop, in eps.  A is dense,
 * so that both triangles are seen, and serves all three. */
static void print_assembly(const struct scene *s, int seed,
                           const struct quadrature *rule)
{
    const int N = s->n + 1;
    struct scene t = scene_make(DENSE, s->n, 1.0, NATURAL, seed, rule);
    struct matrix *V = matrix_alloc(DENSE, N, 0);

    assemble_by_vertex(s->n, s->x, bvp_beta, bvp_f, rule, V, t.u);
    table_begin("assembly", "order A_eps b_eps");
    for (int kind = NATURAL; kind <= RANDOM; kind++) {
        make_order(s->n, (enum order)kind, seed, t.order);
        assemble(s->n, s->x, bvp_beta, bvp_f, rule, t.order, t.A, t.b);
        table_row(kind, difference_eps(N * N, t.A->a, V->a),
                  difference_eps(N, t.b, t.u));
    }
    table_end();
    matrix_free(V);
    scene_free(&t);
}

/* Solve the scene; its A and b are corrected, its u is set. */
static void solve_scene(struct scene *s)
{
    fix_left(s);
    const struct point point = measure(s->A, s->b, 1, s->u);
    if (point.status != OK) die("the matrix is %s", status_name(point.status));
    if (!point.valid) die("the solution does not solve A u = b");
}

int main(int argc, char *argv[])
{
    int n = 5, order = NATURAL, seed = 2385, rule = 0, solve = 1, repeats = 5;
    double grading = 3.0, budget = 0.3;
    const struct quadrature *const rules[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 1000,
         .help = "elements of the scene (A is printed up to 12)"},
        {"grading", .real = &grading, .min = 0.01, .max = 100.0,
         .help = "last element length over first, in the scene"},
        {"order", .choice = &order, .choices = "natural reversed random",
         .help = "order of the elements"},
        {"seed", .integer = &seed, .min = 1, .max = 1000000000,
         .help = "of the random order"},
        {"rule", .choice = &rule, .choices = "midpoint trapezoid gauss",
         .help = "quadrature rule"},
        {"solve", .choice = &solve, .choices = "no yes",
         .help = "no: assemble only, to look at a matrix that fails"},
        {"budget", .real = &budget, .min = 1e-4, .max = 20.0, .unit = "s",
         .help = "time of each curve of the chart"},
        {"repeats", .integer = &repeats, .min = 1, .max = 100,
         .help = "runs of which the best counts"},
    };
    options_parse("08_element_assembly", options, COUNT(options), argc, argv);

    struct scene s = scene_make(DENSE, n, grading, (enum order)order, seed,
                                rules[rule]);
    struct scene t = scene_make(DENSE, n, grading, (enum order)order, seed,
                                rules[rule]); /* corrected and solved */
    if (solve) solve_scene(&t);

    print_local(&s, rules[rule]);
    if (n <= 12) table_matrix("A", s.A);
    table_vector("b", n + 1, s.b);
    print_assembly(&s, seed, rules[rule]);
    if (solve) {
        table_begin("nodes", "x u exact");
        for (int i = 0; i <= n; i++) table_row(s.x[i], t.u[i], bvp_u(s.x[i]));
        table_end();
        print_validity(rules[rule]);
        print_work(rules[rule]);
        print_chart("chart_dense", DENSE, budget, repeats, rules[rule]);
        print_chart("chart_banded", BANDED, budget, repeats, rules[rule]);
    }
    scene_free(&s);
    scene_free(&t);
    return table_finish();
}
