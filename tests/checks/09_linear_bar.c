/* 09_linear_bar.c - what a right linear bar satisfies. */
#include "judge.h"

#define main program_main
#include PROGRAM
#undef main

#include "../oracle/09_linear_bar.h"

/* Round-off of a few products, and of a solve with condition below 1e3. */
static const double PRODUCTS = 1e-14, ROUND_OFF = 1e-12;

enum { n_elem = 7 };

/* A scene with high entropy; each check sets the ends that it is about. */
static struct scene scene_of(enum end_kind left, double at_left,
                             enum end_kind right, double at_right)
{
    return (struct scene){.n = n_elem, .L = 2.385, .modulus = 371.4,
                          .c = 53.7, .left = {left, at_left},
                          .right = {right, at_right}};
}

static void lame_parameters_and_back(void)
{
    const double nu[] = {0.0, 0.2385, 0.3, 1.0 / 3.0, 0.4714, 0.4999};
    for (int k = 0; k < COUNT(nu); k++) {
        const struct elastic m = elastic_make(371.4, nu[k]);
        const struct material common = material_make(LINEAR, 371.4, nu[k]);
        double E, nu_back;
        expect_close(m.mu, common.mu, PRODUCTS, common.mu, "mu at nu = %g",
                     nu[k]);
        /* 1 - 2 nu has no round-off of its own near 1/2 */
        expect_close(m.lambda, common.lambda, PRODUCTS, common.lambda + 371.4,
                     "lambda at nu = %g", nu[k]);
        engineering_constants(&m, &E, &nu_back);
        expect_close(E, 371.4, 1e-11, 371.4, "E from mu and lambda, nu = %g",
                     nu[k]);
        expect_close(nu_back, nu[k], 1e-13, 1.0,
                     "nu from mu and lambda, nu = %g", nu[k]);
    }
}

/* The linear law is the tangent of every other one at rest. */
static void modulus_is_the_slope_at_rest(void)
{
    const struct material log_law = material_make(LOG, 1000.0, 0.3);
    expect_close(elastic_make(1000.0, 0.3).modulus, 1346.1538461538462,
                 PRODUCTS, 1346.0, "modulus for E = 1000, nu = 0.3");
    expect_close(elastic_make(1000.0, 0.3).modulus,
                 material1_dpk1(&log_law, 1.0), PRODUCTS, 1346.0,
                 "modulus, against dP/dF of the log law at F = 1");
    expect_close(elastic_make(1000.0, 0.0).modulus, 1000.0, PRODUCTS, 1000.0,
                 "modulus at nu = 0, where nothing is held back sideways: E");
    for (double nu = 0.0; nu < 0.5; nu += 0.0714)
        expect(elastic_make(2.385, nu).modulus >= 2.385 * (1.0 - PRODUCTS),
               "modulus %g at nu = %g is below E = 2.385: holding a bar "
               "sideways cannot make it softer",
               elastic_make(2.385, nu).modulus, nu);
}

static double stiffness_of_scene(double x) { return 371.4 + 0.0 * x; }
static double uniform_of_scene(double x) { return 53.7 + 0.0 * x; }
static double cosine_of_scene(double x)
{
    return 53.7 * cos(M_PI_2 * x / 2.385);
}

/* Elasticity in one dimension is Poisson's equation with beta = modulus. */
static void same_system_as_the_poisson_solver(void)
{
    enum { N = n_elem + 1 };
    double x[N], b[N], b_poisson[N], u[N], zero = 0.0;
    const int first = 0;
    grid_make(0.0, 2.385, n_elem, 1.0, x);
    for (int shape = UNIFORM; shape <= COSINE; shape++) {
        struct scene s = scene_of(FIXED, 0.0, FREE, 0.0);
        s.shape = (enum shape)shape;
        struct matrix *K = matrix_alloc(BANDED, N, 1);
        struct matrix *A = matrix_alloc(BANDED, N, 1);
        assemble(&s, K, b);
        poisson_assemble(n_elem, x, stiffness_of_scene,
                         shape == UNIFORM ? uniform_of_scene : cosine_of_scene,
                         &MIDPOINT, A, b_poisson);
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++)
                expect_close(matrix_get(K, i, j), matrix_get(A, i, j),
                             1e-13, 371.4, "K[%d][%d], against beta = 371.4 "
                             "in the Poisson solver", i, j);
            expect_close(b[i], b_poisson[i], 1e-13, 53.7,
                         "b[%d], against the Poisson solver", i);
        }
        expect(solve(&s, K, b, u) == OK, "solve: %s with the left end fixed",
               status_name(solve(&s, K, b, u)));
        matrix_dirichlet(A, b_poisson, 1, &first, &zero, KEEP_DIAGONAL);
        expect(matrix_factor(A) == OK, "reference matrix");
        matrix_solve(A, b_poisson);
        for (int i = 0; i < N; i++)
            expect_close(u[i], b_poisson[i], ROUND_OFF, 1.0,
                         "u[%d], against the Poisson solver", i);
        matrix_free(K);
        matrix_free(A);
    }
}

/* h = P n enters with a plus at either end: L = 1, modulus 1346.15, +100. */
static void end_loads_push_their_own_way(void)
{
    for (int end = 0; end <= 1; end++) {
        double b[n_elem + 1], u[n_elem + 1];
        struct matrix *K = matrix_alloc(BANDED, n_elem + 1, 1);
        struct scene s = {.n = n_elem, .L = 1.0, .modulus = 1346.1538461538462,
                          .left = {FIXED, 0.0}, .right = {FIXED, 0.0}};
        *(end ? &s.right : &s.left) = (struct end){FREE, 100.0};
        const int node = end ? n_elem : 0;
        assemble(&s, K, b);
        expect_close(b[node], 100.0, PRODUCTS, 100.0,
                     "b at the %s end, whose traction h = P n is +100",
                     end ? "right" : "left");
        expect_close(b[n_elem - node], 0.0, PRODUCTS, 100.0,
                     "b at the %s end, which is fixed and has no traction",
                     end ? "left" : "right");
        expect(solve(&s, K, b, u) == OK, "solve with one end fixed");
        expect_close(u[node], 0.07428571428571429, ROUND_OFF, 0.0743,
                     "displacement of the %s end under +100",
                     end ? "right" : "left");
        matrix_free(K);
    }
}

static void loads_add_up_to_the_whole(void)
{
    double b[n_elem + 1], sum = 0.0;
    struct matrix *K = matrix_alloc(BANDED, n_elem + 1, 1);
    const struct scene s = scene_of(FREE, -12.3, FREE, 71.9);
    assemble(&s, K, b);
    matrix_free(K);
    for (int i = 0; i <= n_elem; i++) sum += b[i];
    expect_close(sum, 53.7 * 2.385 - 12.3 + 71.9, 1e-13, 128.0,
                 "sum of b, against c L + h(0) + h(L)");
}

/* Pure traction ends: solvable exactly when the loads balance. */
static void free_bar_needs_balanced_loads(void)
{
    const double body = 53.7 * 2.385;
    const struct {
        enum end_kind left, right;
        double at_right, modulus;
        enum status status;
    } cases[] = {{FIXED, FREE, 71.9, 371.4, OK},
                 {FREE, FIXED, 0.1, 371.4, OK},
                 {FIXED, FIXED, 0.1, 371.4, OK},
                 {FREE, FREE, 71.9, 371.4, INCOMPATIBLE},
                 {FREE, FREE, 12.3 - body + 1e-6, 371.4, INCOMPATIBLE},
                 {FREE, FREE, 12.3 - body, 371.4, OK},
                 {FIXED, FREE, 71.9, -714.0, NOT_SPD},
                 {FIXED, FREE, 71.9, 0.0, NOT_SPD}};
    for (int k = 0; k < COUNT(cases); k++) {
        double b[n_elem + 1], u[n_elem + 1] = {0};
        struct matrix *K = matrix_alloc(BANDED, n_elem + 1, 1);
        struct scene s = scene_of(cases[k].left, -12.3, cases[k].right,
                                  cases[k].at_right);
        s.modulus = cases[k].modulus;
        assemble(&s, K, b);
        const enum status status = solve(&s, K, b, u);
        for (int i = 0; i <= n_elem && status == OK; i++)
            expect_close(u[i], 0.0, 1e3, 1.0, /* any number of this size */
                         "u[%d] with %s left end and %s right end", i,
                         s.left.kind ? "fixed" : "free",
                         s.right.kind ? "fixed" : "free");
        expect(status == cases[k].status,
               "left end %s, right end %s, modulus %g: %s, not %s",
               s.left.kind ? "fixed" : "free", s.right.kind ? "fixed" : "free",
               s.modulus, status_name(status), status_name(cases[k].status));
        if (status == OK && s.left.kind == FREE && s.right.kind == FREE)
            expect_close(u[0], 0.0, ROUND_OFF, 1.0,
                         "u_0 of the solution with two free ends");
        matrix_free(K);
    }
    expect_refusal("--left free --right free", 1, "INCOMPATIBLE");
    expect_refusal("--modulus printed --nu 0.4", 1, "NOT_SPD");
    expect_refusal("--nu 0.5", 2, "incompressible");
}

/* Constant modulus and an exactly integrated load: exact at the nodes. */
static void nodal_values_are_exact(void)
{
    const double body = 53.7 * 2.385;
    const struct scene scenes[] = {scene_of(FIXED, 0.613, FREE, 71.9),
                                   scene_of(FREE, -31.7, FIXED, -0.2385),
                                   scene_of(FIXED, 0.137, FIXED, -0.2385),
                                   scene_of(FREE, -12.3, FREE, 12.3 - body)};
    for (int k = 0; k < COUNT(scenes); k++) {
        const struct scene *s = &scenes[k];
        double b[n_elem + 1], b_before[n_elem + 1], u[n_elem + 1];
        struct matrix *K = matrix_alloc(BANDED, n_elem + 1, 1);
        assemble(s, K, b);
        for (int i = 0; i <= n_elem; i++) b_before[i] = b[i];
        expect(solve(s, K, b, u) == OK, "solve: scene %d has a solution", k);
        /* u0 and P0 of u = u0 + (P0 X - c X^2 / 2) / M, by hand */
        const double L = 2.385, M = 371.4, c = 53.7;
        const double P0 = k == 0   ? 71.9 + body
                          : k == 1 ? 31.7
                          : k == 2 ? M * (-0.2385 - 0.137) / L + c * L / 2
                                   : 12.3;
        const double u0 = k == 0   ? 0.613
                          : k == 1 ? -0.2385 - (P0 * L - c * L * L / 2) / M
                          : k == 2 ? 0.137
                                   : 0.0;
        for (int i = 0; i <= n_elem; i++) {
            const double X = L * i / n_elem;
            expect_close(u[i], u0 + (P0 * X - c * X * X / 2) / M, ROUND_OFF,
                         1.0, "u[%d], %s left end, %s right end", i,
                         s->left.kind ? "fixed" : "free",
                         s->right.kind ? "fixed" : "free");
            expect(b[i] == b_before[i],
                   "solve changed b[%d]: the reactions need it as it was", i);
        }
        matrix_free(K);
    }
}

/* The whole solution path, in the oracle's units. */
static void hanging_bar_is_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_hanging); k++) {
        const struct scene s = {.n = 3 + k, .L = 1.0, .c = oracle_hanging[k].c,
                                .modulus = elastic_make(1000.0, 0.3).modulus,
                                .left = {FIXED, 0.0}, .right = {FREE, 0.0}};
        double u[16];
        expect(displacements(&s, u) == OK, "hanging bar: no solution");
        expect_close(u[s.n], oracle_hanging[k].linear, ROUND_OFF,
                     fabs(oracle_hanging[k].linear),
                     "u(1) under its own weight %g", s.c);
    }
}

static void stresses_and_reactions_balance(void)
{
    const struct scene scenes[] = {scene_of(FIXED, 0.613, FREE, 71.9),
                                   scene_of(FREE, -31.7, FIXED, -0.2385),
                                   scene_of(FIXED, 0.137, FIXED, -0.2385)};
    for (int k = 0; k < COUNT(scenes); k++) {
        const struct scene *s = &scenes[k];
        double b[n_elem + 1], u[n_elem + 1], P[n_elem], r[2], sum = 0.0;
        struct matrix *K = matrix_alloc(BANDED, n_elem + 1, 1);
        assemble(s, K, b);
        expect(solve(s, K, b, u) == OK, "solve: scene %d has a solution", k);
        matrix_free(K);
        stress_and_reactions(s, b, u, P, r);
        for (int i = 0; i <= n_elem; i++) sum += b[i];
        for (int e = 1; e < n_elem; e++)
            expect_close(P[e - 1] - P[e], b[e], 1e-11, 371.4,
                         "P of element %d less P of element %d, against b[%d]",
                         e, e + 1, e);
        expect_close(P[0], 371.4 * (u[1] - u[0]) * n_elem / 2.385, 1e-11,
                     371.4, "P of element 1");
        if (s->left.kind == FREE)
            expect_close(r[0], 0.0, 1e-11, 371.4,
                         "reaction at the free left end");
        if (s->right.kind == FREE)
            expect_close(r[1], 0.0, 1e-11, 371.4,
                         "reaction at the free right end");
        expect_close(r[0] + r[1], -sum, 1e-11, 371.4,
                     "sum of the reactions, against minus sum b");
    }
}

/* Orders and constants: -(1 + pi/2) h^2/24 at the end for the midpoint rule;
 * |u''| h / sqrt(12) with |u''| = sqrt(1/2) in energy. */
static void cosine_load_has_its_orders(void)
{
    struct output *output = run("--n 2");
    const double h = cell(output, "orders", "h", -1);
    expect_close(cell(output, "orders", "midpoint", -1) / (h * h),
                 (1.0 + M_PI_2) / 24.0, 1e-3, 0.107,
                 "nodal error / h^2, midpoint rule");
    expect_close(cell(output, "orders", "energy", -1) / h, sqrt(1.0 / 24.0),
                 1e-3, 0.204, "energy error / h");
    const double want[] = {2.0, 4.0, 2.0, 1.0};
    const char *const name[] = {"midpoint", "gauss", "L2", "energy"};
    for (int k = 0; k < 4; k++) /* Gauss's last error is near round-off */
        expect_close(cell(output, "orders_of", name[k], 0), want[k], 0.02, 1.0,
                     "order of the error, column %s", name[k]);
    for (int k = 0; k < 6; k++) /* condition number 4 n^2 / pi^2 */
        expect_close(cell(output, "orders", "exact", k), 0.0, 1e-12, 1.0,
                     "nodal error with an exactly integrated load");
}

static void model_error_is_the_oracles(void)
{
    struct output *output = run("--n 2");
    const char *const name[] = {"strain_t", "strain_c", "load_t", "load_c"};
    for (int k = 0; k < 6; k++) {
        const double *want = &oracle_model_error[k / 3][k % 3].strain_t;
        for (int c = 0; c < 4; c++)
            expect_close(cell(output, "thresholds", name[c], k), want[c], 1e-9,
                         fabs(want[c]), "row %d of table thresholds, column %s",
                         k + 1, name[c]);
    }
    /* the next term is about 0.9 e of it */
    expect_close(cell(output, "model_error", "stress_t", 0) / 0.001,
                 oracle_leading, 2e-3, 1.0, "model error / strain, small");
}

/* The linear bar is what Newton's method finds with its first solve. */
static void linear_bar_is_newtons_first_step(void)
{
    enum { n = 16 };
    const struct material m = material_make(LOG, 1000.0, 0.3);
    const struct material linear = material_make(LINEAR, 1000.0, 0.3);
    const struct newton_control one_step = {1e-12, 1, 0, 0};
    const struct newton_control full = {1e-12, 60, 0, 0};
    for (int k = 0; k < COUNT(oracle_hanging); k++) {
        const double c = oracle_hanging[k].c;
        double b[n + 1], u[n + 1], v[n + 1] = {0}, w[n + 1] = {0};
        const struct scene s = {.n = n, .L = 1.0, .c = c,
                                .modulus = elastic_make(1000.0, 0.3).modulus,
                                .left = {FIXED, 0.0}, .right = {FREE, 0.0}};
        struct matrix *K = matrix_alloc(BANDED, n + 1, 1);
        assemble(&s, K, b);
        expect(solve(&s, K, b, u) == OK, "hanging bar: no solution");
        matrix_free(K);
        const struct bar log_bar = {n, 1.0 / n, {1, 0}, b, m};
        const struct bar linear_bar = {n, 1.0 / n, {1, 0}, b, linear};
        bar_newton(&log_bar, &one_step, v, NULL);
        bar_newton(&linear_bar, &full, w, NULL);
        for (int i = 0; i <= n; i++) {
            expect_close(v[i], u[i], ROUND_OFF, 1.0,
                         "Newton's first u[%d] with the log law, against the "
                         "linear bar, c = %g", i, c);
            expect_close(w[i], u[i], ROUND_OFF, 1.0,
                         "Newton's u[%d] with the linear law, against the "
                         "linear bar, c = %g", i, c);
        }
    }
    struct output *output = run("--n 2");
    const int rows[][2] = {{0, 0}, {2, 1}, {4, 4}}; /* c = 10, 500, -500 */
    for (int k = 0; k < 3; k++) {
        const int row = rows[k][0], o = rows[k][1];
        expect_close(cell(output, "cost", "log_u", row),
                     oracle_hanging[o].log16, 1e-11, 1.0,
                     "u(1) of the log law, c = %g", oracle_hanging[o].c);
        expect_close(cell(output, "cost", "linear_error", row),
                     fabs(oracle_hanging[o].linear / oracle_hanging[o].log16 -
                          1.0), 1e-9, 1.0,
                     "model error of u(1), c = %g", oracle_hanging[o].c);
    }
}

static const struct claim claims[] = {
    {"lame_parameters_and_back", lame_parameters_and_back, "9a"},
    {"modulus_is_the_slope_at_rest", modulus_is_the_slope_at_rest, "9a"},
    {"end_loads_push_their_own_way", end_loads_push_their_own_way, "9b"},
    {"same_system_as_the_poisson_solver", same_system_as_the_poisson_solver,
     "9b"},
    {"loads_add_up_to_the_whole", loads_add_up_to_the_whole, "9b"},
    {"free_bar_needs_balanced_loads", free_bar_needs_balanced_loads, "9c"},
    {"nodal_values_are_exact", nodal_values_are_exact, "9c"},
    {"hanging_bar_is_the_oracles", hanging_bar_is_the_oracles, "9c"},
    {"stresses_and_reactions_balance", stresses_and_reactions_balance, "9d"},
    {"cosine_load_has_its_orders", cosine_load_has_its_orders, "9b"},
    {"model_error_is_the_oracles", model_error_is_the_oracles, NULL},
    {"linear_bar_is_newtons_first_step", linear_bar_is_newtons_first_step,
     "9a"},
};

static const char *const runs[] = {
    "",
    "--n 7 --left free --at_left -37.14 --right fixed --at_right 0.2385",
    "--n 5 --right fixed --at_left 0.613 --at_right -0.137 --length 2.385",
    "--n 11 --E 371.4 --nu 0.2385 --body cosine --c -53.7",
    "--left free --right free --c 100 --at_left -37.5 --at_right -62.5",
    "--n 1 --nu 0 --at_right -23.85 --c 0",
};

#define SOLVE "direct solve, condition number below 1e4"
#define FORCES "differences of u, times modulus / h"
static const struct column_rule rules[] = {
    {"nodes", "X", 1e-14, "i L / n", 0},
    {"nodes", "b", 1e-13, "sums of two element loads", 0},
    {"nodes", "*", 1e-11, SOLVE, 0},
    {"elements", "X", 1e-14, "(e - 1/2) L / n", 0},
    {"elements", "*", 1e-10, FORCES, 0},
    {"balance", "loads", 1e-12, "a sum that may vanish", 100},
    {"balance", "*", 1e-10, FORCES ", may vanish", 100},
    {"moduli", "E_back", 1e-11, "lambda + mu, then back", 0},
    {"moduli", "*", 1e-13, "a few products", 0},
    {"printed_modulus", "not_spd", 0, "yes or no", 0},
    {"printed_modulus", "*", 1e-11, SOLVE, 0},
    {"end_loads", "end", 0, "0 left, 1 right", 0},
    {"end_loads", "*", 1e-11, SOLVE, 0},
    {"end_conditions", "loads", 1e-12, "a sum that may vanish", 100},
    {"end_conditions", "*", 0, "counts and given numbers", 0},
    {"orders", "n", 0, "a count", 0},
    {"orders", "h", 1e-14, "1 / n", 0},
    {"orders", "gauss", 1e-6, "errors near round-off", 0},
    {"orders", "exact", 1e-12, "round-off of u", 1},
    {"orders", "*", 1e-9, "errors, to the round-off of u", 0},
    {"orders_of", "gauss", 0.02, "its finest error is near round-off", 0},
    {"orders_of", "*", 1e-6, "quotients of errors", 0},
    {"model_error", "*", 1e-9, "a difference from 1", 0},
    {"thresholds", "*", 1e-8, "a root to round-off of the error", 0},
    {"cost", "cubic_solves", 0, "a count", 0},
    {"cost", "log_solves", 0, "a count", 0},
    {"cost", "*", 1e-10, SOLVE ", then Newton to 1e-12", 0},
    {"newton", "solves", 0, "a count", 0},
    {"newton", "*", 1e-11, "differences from 1, may be round-off", 1},
};

static const struct lesson lesson = {
    "09_linear_bar", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Table `newton`: its first row is the linear bar. One more linear solve "
    "turns 4.6 % into 0.01 % at load 100; at load 10 the linear bar is wrong "
    "by 0.46 % and few scenes notice.",
    "Run with --modulus printed --nu 0.3, then with --nu 0.34: the bar is 7 "
    "times too soft, then it has no positive definite matrix at all. What "
    "would a solver that does not look at its pivots have printed?"};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
