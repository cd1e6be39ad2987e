/*
 * 08_element_assembly.c - what a right element assembly and a fair chart
 * satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *     8a   x0, x1       seven unequal elements, one over 0
 *     8a   beta, f      those of the scene; those of exercise (5)
 *     8a   rule         three, with NaN behind their points
 *     8b   n, x         7 unequal; 4 to 256 equal; graded in the runs
 *     8b   order        natural, reversed, mixed, twelve random ones
 *     8b   A, b         dense and banded, not 0 before
 *     8c   N, p         flops_are_those_of_the_loops
 *     8d   A, b         good, singular, not symmetric, NaN; dense and banded
 *     8d   repeats      1 to 4, and 64 in the_best_time_is_kept
 */
#include "program.h"

#include "judge.h"
#include "linear/residual.h"

#include "../oracle/poisson.h"

#include <float.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

/* A scene with high entropy: no two elements alike. */
enum { n_elem = 7, N_node = 8 };
static const double grid[N_node] = {-0.2385, 0.1, 0.613, 0.7, 1.247,
                                    1.3714,  2.0, 2.385};

static double beta_(double x)
{
    return 2.385 + x + 0.3714 * x * x;
}

static double load_(double x)
{
    return 3.714 - exp(0.613 * x);
}

/* An entry is a sum of two terms, each a handful of roundings: a few eps. */
static const double ROUND_OFF = 16 * DBL_EPSILON;
/* The largest entry of A and of b in this scene, to scale with. */
static const double SIZE_A = 200.0, SIZE_B = 3.0;

/* The rules with NaN behind their last point. */
static const struct quadrature *rule_of(int k)
{
    static struct quadrature rule[3];
    const struct quadrature *const all[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    rule[k] = *all[k];
    for (int i = rule[k].n; i < COUNT(rule[k].s); i++)
        rule[k].s[i] = rule[k].w[i] = (double)NAN;
    return &rule[k];
}
static const char *const rule_names[] = {"midpoint", "trapezoid", "Gauss"};

struct local {
    double K[2][2], r[2];
};

static struct local local_system(int e, const struct quadrature *rule)
{
    struct local local = {{{7.0, 7.0}, {7.0, 7.0}}, {7.0, 7.0}};
    element(grid[e], grid[e + 1], beta_, load_, rule, local.K, local.r);
    return local;
}

/* A and b of the scene by the program, into memory that is not zero. */
static struct matrix *assembled(enum storage storage,
                                const struct quadrature *rule,
                                const int order[], double b[])
{
    struct matrix *A = matrix_alloc(storage, N_node, 1);
    double *sums = guarded_alloc(N_node);
    for (int i = 0; i < N_node; i++) matrix_add(A, i, i, 1.247);
    assemble(n_elem, guarded_copy(N_node, grid), beta_, load_, rule,
             guarded_indices(n_elem, order), A, sums);
    memcpy(b, sums, N_node * sizeof *b);
    return A;
}

static const int natural[] = {0, 1, 2, 3, 4, 5, 6};
static const int mixed[] = {4, 0, 6, 2, 5, 1, 3};

/* The slopes of the two hats add up to 0, and e_0' e_1' = e_1' e_0'. */
static void local_matrix_has_row_sums_0(void)
{
    for (int e = 0; e < n_elem; e++)
        for (int k = 0; k < COUNT(rule_names); k++) {
            const struct local l = local_system(e, rule_of(k));
            for (int a = 0; a < 2; a++)
                expect_close(l.K[a][0] + l.K[a][1], 0.0, ROUND_OFF, l.K[a][a],
                             "sum of row %d of K (%s rule), element %d", a,
                             rule_names[k], e);
            expect_close(l.K[0][1], l.K[1][0], ROUND_OFF, l.K[0][0],
                         "K[0][1] against K[1][0] (%s rule), element %d",
                         rule_names[k], e);
            expect(l.K[0][0] > 0.0, "K[0][0] of element %d must be positive",
                   e);
        }
}

/* e_0 + e_1 = 1 on the element: r_0 + r_1 is the load on it, by the rule. */
static void local_load_is_a_partition(void)
{
    for (int e = 0; e < n_elem; e++) {
        const struct local l = local_system(e, &MIDPOINT);
        const double h = grid[e + 1] - grid[e];
        const double whole = h * load_(0.5 * (grid[e] + grid[e + 1]));
        expect_close(l.r[0] + l.r[1], whole, ROUND_OFF, SIZE_B,
                     "r[0] + r[1], against h f(midpoint), element %d", e);
        expect_close(l.r[0], l.r[1], ROUND_OFF, SIZE_B,
                     "r[0] against r[1] by the midpoint rule, element %d", e);
    }
}

static void element_agrees_with_common(void)
{
    for (int e = 0; e < n_elem; e++)
        for (int k = 0; k < COUNT(rule_names); k++) {
            const struct local l = local_system(e, rule_of(k));
            double K[2][2], r[2];
            poisson_element(grid[e], grid[e + 1], beta_, load_, rule_of(k),
                            K, r);
            for (int a = 0; a < 2; a++) {
                expect_close(l.r[a], r[a], ROUND_OFF, SIZE_B,
                             "r[%d] by the %s rule, element %d", a,
                             rule_names[k], e);
                for (int c = 0; c < 2; c++)
                    expect_close(l.K[a][c], K[a][c], ROUND_OFF, SIZE_A,
                                 "K[%d][%d] by the %s rule, element %d", a, c,
                                 rule_names[k], e);
            }
        }
}

/*
 * Entry by entry from the definition, midpoint rule: only element j (from node
 * j - 1 to node j) knows A[j-1][j]; elements j and j + 1 meet in A[j][j].
 */
static void assembly_agrees_with_vertex_sums(void)
{
    double b[N_node];
    struct matrix *A = assembled(DENSE, &MIDPOINT, natural, b);
    double k[N_node + 1] = {0}, r[N_node + 1] = {0}; /* of element j */
    for (int j = 1; j <= n_elem; j++) {
        const double h = grid[j] - grid[j - 1];
        k[j] = beta_(0.5 * (grid[j] + grid[j - 1])) / h;
        r[j] = 0.5 * h * load_(0.5 * (grid[j] + grid[j - 1]));
    }
    for (int j = 0; j < N_node; j++) {
        expect_close(matrix_get(A, j, j), k[j] + k[j + 1], ROUND_OFF, SIZE_A,
                     "A[%d][%d] of unequal elements", j, j);
        expect_close(b[j], r[j] + r[j + 1], ROUND_OFF, SIZE_B, "b[%d]", j);
        for (int i = 0; i < j; i++) {
            const double want = j == i + 1 ? -k[j] : 0.0;
            expect_close(matrix_get(A, i, j), want, ROUND_OFF, SIZE_A,
                         "A[%d][%d] of unequal elements", i, j);
            expect_close(matrix_get(A, j, i), want, ROUND_OFF, SIZE_A,
                         "A[%d][%d] of unequal elements", j, i);
        }
    }
    matrix_free(A);
}

/* The elements in a random order that the seed gives. */
static void shuffle(int seed, int order[n_elem])
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, (unsigned long)seed);
    for (int k = 0; k < n_elem; k++) order[k] = k;
    gsl_ran_shuffle(rng, order, n_elem, sizeof *order);
    gsl_rng_free(rng);
}

/* Also against common/, which visits the elements in the natural order. */
static void order_of_elements_is_irrelevant(void)
{
    int order[n_elem];
    double b[N_node], b_common[N_node];
    struct matrix *C = matrix_alloc(BANDED, N_node, 1);

    poisson_assemble(n_elem, grid, beta_, load_, &GAUSS2, C, b_common);
    for (int trial = 0; trial < 12; trial++) {
        shuffle(2385 + trial, order);
        struct matrix *A = assembled(BANDED, &GAUSS2,
                                     trial == 1 ? mixed : order, b);
        for (int i = 0; i < N_node; i++) {
            expect_close(b[i], b_common[i], ROUND_OFF, SIZE_B,
                         "b[%d], elements in another order", i);
            for (int j = 0; j < N_node; j++)
                expect_close(matrix_get(A, i, j), matrix_get(C, i, j),
                             ROUND_OFF, SIZE_A,
                             "A[%d][%d], elements in another order", i, j);
        }
        matrix_free(A);
    }
    matrix_free(C);
}

static void assembling_twice_changes_nothing(void)
{
    double b[N_node], b_again[N_node];
    struct matrix *A = assembled(BANDED, &MIDPOINT, mixed, b);
    struct matrix *B = assembled(BANDED, &MIDPOINT, mixed, b_again);
    assemble(n_elem, grid, beta_, load_, &MIDPOINT, mixed, B, b_again);
    for (int i = 0; i < N_node; i++) {
        expect_close(b_again[i], b[i], ROUND_OFF, SIZE_B,
                     "b[%d] after assembling a second time", i);
        expect_close(matrix_get(B, i, i), matrix_get(A, i, i), ROUND_OFF,
                     SIZE_A, "A[%d][%d] after assembling a second time", i, i);
    }
    matrix_free(A);
    matrix_free(B);
}

static void dense_and_banded_agree(void)
{
    double b[N_node], b_band[N_node];
    struct matrix *A = assembled(DENSE, &GAUSS2, mixed, b);
    struct matrix *B = assembled(BANDED, &GAUSS2, mixed, b_band);
    for (int i = 0; i < N_node; i++) {
        expect_close(b[i], b_band[i], ROUND_OFF, SIZE_B,
                     "b[%d], dense against banded", i);
        for (int j = 0; j < N_node; j++)
            expect_close(matrix_get(A, i, j), matrix_get(B, i, j), ROUND_OFF,
                         SIZE_A, "A[%d][%d], dense against banded", i, j);
    }
    matrix_free(A);
    matrix_free(B);
}

/* L2 error of exercise (5) on n equal elements; the run must be valid. */
static double L2_of(enum storage storage, int n)
{
    struct system s = system_make(storage, n, 1.0, &MIDPOINT, 0);
    const struct point point = system_solve(&s);
    const char *name = storage == DENSE ? "dense" : "banded";
    expect(point.valid, "exercise (5), n = %d, %s: not valid", n, name);
    expect(point.seconds >= 0.0 && (n < 32 || point.seconds > 0.0),
           "exercise (5), n = %d, %s: valid, but without a time", n, name);
    const double L2 =
        poisson_errors(n, s.x, s.u, bvp_beta, bvp_exact, bvp_exact_dx).L2;
    system_free(&s);
    return L2;
}

/* The oracle's entries are exact here; its L2 errors are integrals, and ours
 * come from five-point Gauss: 5e-8 of them at n = 4, less on finer grids. */
static void exercise_5_is_reproduced(void)
{
    struct output *output =
        run("--n 4 --grading 1 --order reversed");
    for (int i = 0; i < 5; i++) {
        for (int j = 0; j < 5; j++)
            expect_close(cell(output, "A", "value", 5 * i + j),
                         oracle_bvp_A4[5 * i + j], 1e-15, 14.0,
                         "A[%d][%d] of exercise (5), n = 4", i, j);
        expect_close(cell(output, "b", "value", i), oracle_bvp_b4_midpoint[i],
                     1e-15, 1.0, "b[%d] of exercise (5), n = 4", i);
        expect_close(cell(output, "nodes", "u", i), oracle_bvp_u4_midpoint[i],
                     1e-13, 1.0, "u at node %d of exercise (5), n = 4", i);
    }
    for (int k = 0; k < COUNT(oracle_bvp_midpoint); k++)
        for (int storage = DENSE; storage <= BANDED; storage++)
            expect_close(L2_of((enum storage)storage, oracle_bvp_midpoint[k].N),
                         oracle_bvp_midpoint[k].L2, 1e-6,
                         oracle_bvp_midpoint[k].L2,
                         "L2 error of exercise (5), n = %d, %s",
                         oracle_bvp_midpoint[k].N,
                         storage == DENSE ? "dense" : "banded");
}

/* The textbook loops on a band, counting what they do. */
static double counted_flops(int N, int p)
{
    long count = 0;
    for (int j = 0; j < N; j++)
        for (int i = j; i <= j + p && i < N; i++) {
            for (int k = i > p ? i - p : 0; k < j; k++)
                count += 2;   /* L_ij -= L_ik L_jk */
            count++;          /* a root when i = j, else a division */
        }
    for (int i = 0; i < N; i++) { /* L y = b */
        for (int k = i > p ? i - p : 0; k < i; k++) count += 2;
        count++;
    }
    for (int i = N - 1; i >= 0; i--) { /* L^T x = y */
        for (int k = i + 1; k <= i + p && k < N; k++) count += 2;
        count++;
    }
    return (double)count;
}

static void flops_are_those_of_the_loops(void)
{
    const int cases[][2] = {{1, 0}, {2, 1}, {5, 4},   {8, 1},
                            {9, 3}, {40, 7}, {33, 32}, {200, 1}};
    for (int k = 0; k < COUNT(cases); k++) {
        const int N = cases[k][0], p = cases[k][1];
        expect_close(cholesky_flops(N, p), counted_flops(N, p), 0.0, 1.0,
                     "flops of order %d, half bandwidth %d, against the "
                     "textbook loops with a counter in them", N, p);
    }
    /* large orders: the integers still fit */
    expect_close(cholesky_flops(4097, 4096),
                 4097.0 * 4098.0 * 8195.0 / 6.0 + 2.0 * 4097.0 * 4097.0, 1e-14,
                 2.3e10, "flops of order 4097, dense");
}

/* A dense system of 64 elements; the left end fixed unless `singular`. */
static struct matrix *trial_system(int singular, double b[65])
{
    double x[65];
    const int left[] = {0};
    const double value[] = {1.247};
    struct matrix *A = matrix_alloc(DENSE, 65, 0);
    poisson_grid(-0.2385, 2.385, 64, 3.714, x);
    poisson_assemble(64, x, beta_, load_, &GAUSS2, A, b);
    if (!singular) matrix_dirichlet(A, b, 1, left, value, KEEP_DIAGONAL);
    return A;
}

static void expect_refused(const struct matrix *A, const double b[],
                           const char *what)
{
    double *u = guarded_alloc(65);
    const struct point p = measure(A, guarded_copy(65, b), 3, u);
    expect(!p.valid, "%s: counted as valid", what);
    expect(p.seconds == 0.0, "%s: not valid, but it has a time, %g s", what,
           p.seconds);
    expect(p.backward == 0.0, "%s: not valid, but its backward error is %g, "
           "not 0", what, p.backward);
}

/* Right but for one entry above the diagonal, which Cholesky does not read: the
 * backward error is `eps`, of which 3 may be round-off.  The limit is 20. */
static void judge_backward_error_of(double eps, int valid)
{
    double b[65], *u = guarded_alloc(65);
    struct matrix *A = trial_system(0, b);
    for (int i = 0; i < 65; i++) b[i] *= 1e6;
    const struct point exact = measure(A, b, 1, u);
    const double step = 1e3 * DBL_EPSILON * matrix_get(A, 30, 30);
    matrix_add(A, 30, 31, step);
    const double per_step = matrix_backward_error(A, u, b);
    matrix_add(A, 30, 31, (eps / per_step - 1.0) * step);
    const struct point p = measure(A, b, 1, u);
    expect(exact.status == OK && p.status == OK && !p.valid == !valid,
           "u solves a system that differs from A u = b by %g eps, %s the "
           "limit of BACKWARD_EPS = %g: valid must be %d, not %d", eps,
           valid ? "below" : "above", BACKWARD_EPS, valid, p.valid);
    matrix_free(A);
}

/* The best of the times is at most their mean, and all of them together at most
 * what the call has taken. */
static void the_best_time_is_kept(void)
{
    enum { repeats = 64 };
    double b[65], *u = guarded_alloc(65);
    struct matrix *A = trial_system(0, b);
    const double start = clock_seconds();
    const struct point p = measure(A, b, repeats, u);
    const double mean = (clock_seconds() - start) / repeats;
    expect(p.seconds <= mean + 1e-9, "%d repeats took %.3g s each, and the "
           "shortest of them is said to be %.3g s", repeats, mean, p.seconds);
    matrix_free(A);
}

static void measure_once(void)
{
    double b[65], u[65];
    struct matrix *A = trial_system(0, b);
    measure(A, b, 1, u);
    matrix_free(A);
}

static void no_time_without_a_valid_answer(void)
{
    the_best_time_is_kept();
    expect_no_leak(measure_once, 65 * 65 * sizeof(double), "measure()");
    judge_backward_error_of(0.5 * BACKWARD_EPS, 1);
    judge_backward_error_of(2.0 * BACKWARD_EPS, 0);
    double b[65], b_before[65], *u = guarded_alloc(65);
    struct matrix *A = trial_system(0, b);
    struct matrix *before = matrix_copy(A);
    for (int i = 0; i < 65; i++) b_before[i] = b[i];

    for (int repeats = 1; repeats <= 4; repeats++) {
        const struct point p = measure(A, b, repeats, u);
        for (int i = 0; i < 65; i++) {
            expect_close(b[i], b_before[i], 0.0, 1.0, "b[%d] after measure()",
                         i);
            expect_close(matrix_get(A, i, i), matrix_get(before, i, i), 0.0,
                         1.0, "A[%d][%d] after measure(), which factors a "
                         "copy", i, i);
        }
        expect(p.status == OK && p.valid,
               "a good system, %d repeats: status %s, valid = %d, backward "
               "error %g eps", repeats, status_name(p.status), p.valid,
               p.backward);
        const double backward = matrix_backward_error(A, u, b);
        expect_close(p.backward, backward, 1e-6, backward,
                     "backward of a good system, in eps");
        expect(p.seconds > 0.0 && p.seconds < 5.0,
               "a good system took %g s", p.seconds);
        expect_close(u[0], 1.247, 1e-12, 1.0, "u at the fixed node");
    }

    struct matrix *S = trial_system(1, b);
    expect_refused(S, b, "no node fixed, singular matrix");
    matrix_free(S);

    /* right end fixed by its row only: Cholesky, which reads the lower
     * triangle, solves another system without a word */
    S = trial_system(1, b);
    matrix_add(S, 64, 63, -matrix_get(S, 64, 63));
    b[64] = 0.613 * matrix_get(S, 64, 64);
    expect_refused(S, b, "not symmetric: fast, and wrong");
    matrix_free(S);

    b_before[31] = NAN;
    expect_refused(A, b_before, "NaN in the load");
    b_before[31] = 0.0;
    matrix_add(A, 40, 40, NAN);
    expect_refused(A, b_before, "NaN in the matrix");
    matrix_free(A);
    matrix_free(before);
}

/* 4 per doubling, to 2 % from n = 8 on (the next term of the error is O(h^2)
 * smaller); L2 n^2 tends to 0.0318.  These errors are free of round-off on any
 * machine. */
static void answers_are_second_order(void)
{
    for (int storage = DENSE; storage <= BANDED; storage++) {
        double before = 0.0;
        for (int n = 8; n <= 256; n *= 2) {
            const double L2 = L2_of((enum storage)storage, n);
            expect_close(L2 * n * n, 0.0318, 0.02, 0.0318,
                         "L2 error times n^2, n = %d", n);
            if (n > 8)
                expect_close(before / L2, 4.0, 0.02, 4.0,
                             "error ratio of a doubling to n = %d", n);
            before = L2;
        }
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *in_order = run(""), *reversed = run("--order reversed");
    struct output *long_ = run("--n 256");
    int n;
    const double *A = column(in_order, "A", "value", &n);
    const double *B = column(reversed, "A", "value", NULL);
    double off = 0.0, largest = 0.0;
    for (int i = 0; i < n; i++) {
        off = fmax(off, fabs(A[i] - B[i]));
        largest = fmax(largest, fabs(A[i]));
    }
    measured("1", off / (DBL_EPSILON * largest));
    measured("2a", cell(long_, "runs", "dense_flops", 0));
    measured("2b", cell(long_, "runs", "banded_flops", 0));
}

static const struct claim claims[] = {
    {"local_matrix_has_row_sums_0", local_matrix_has_row_sums_0, "8a"},
    {"local_load_is_a_partition", local_load_is_a_partition, "8a"},
    {"element_agrees_with_common", element_agrees_with_common, "8a"},
    {"assembly_agrees_with_vertex_sums", assembly_agrees_with_vertex_sums,
     "8b"},
    {"dense_and_banded_agree", dense_and_banded_agree, "8b"},
    {"order_of_elements_is_irrelevant", order_of_elements_is_irrelevant, "8b"},
    {"assembling_twice_changes_nothing", assembling_twice_changes_nothing,
     "8b"},
    {"flops_are_those_of_the_loops", flops_are_those_of_the_loops, "8c"},
    {"no_time_without_a_valid_answer", no_time_without_a_valid_answer, "8d"},
    {"exercise_5_is_reproduced", exercise_5_is_reproduced, "8b"},
    {"answers_are_second_order", answers_are_second_order, "8d"},
};

static const char *const runs[] = {
    "",
    "--n 4 --grading 1 --order reversed",
    "--n 9 --grading 0.2385 --order reversed --rule gauss2",
    "--n 12 --grading 3.714 --order reversed --rule gauss2",
    "--n 1 --order reversed --rule trapezoid",
};

static const struct column_rule rules[] = {
    {"A", "*", 1e-14, "sums of two element entries", 0},
    {"b", "*", 1e-14, "sums of two element loads", 0},
    {"nodes", "*", 1e-11, "direct solve, condition number below 1e3", 0},
    {"runs", "*", 0, "words and exact integers", 0},
};

static const struct lesson lesson = {
    "08_element_assembly", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Both storages give one error, but with 256 elements dense storage takes "
    "2272 times the flops. Ten times the accuracy costs 3 times the work with "
    "a band and 32 times without (figures/08_element_assembly/chart.svg). And "
    "from some n on more work makes the answer worse.",
    "Fix the right end by its row only, leave the column, and let measure() "
    "judge by the status alone: the run that is wrong by 0.8 then has a fine "
    "time (figures/08_element_assembly/system.c). Which other rule of a "
    "chart would still stop it?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
