/*
 * 04_neumann_compatibility.c - what a right treatment of two flux ends
 * satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     4a   n, x          7 and 3 unequal, from 0 and from elsewhere; 2 to 47 in
 *                        runs
 *     4a   beta, v       wavy, linear; any values, a line, a hat, a constant
 *     4b   N, b          8 any, 5 to 65; of all sizes, 0, a NaN, both signs
 *     4c   N, b          8 any, of size 1 and 1e-9, 2; 3 to 48 in the runs
 *     4d   A             n = 7 unequal, 4 equal, 2 to 48; -A, which is NOT_SPD
 *     4d   b             compatible, of two loads, and not
 */
#include "program.h"

#include "judge.h"

#include "../oracle/poisson.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <math.h>

/* A scene with high entropy: unequal elements, beta neither 1 nor constant, a
 * load of changing sign, fluxes at both ends that nothing balances. */
enum { n_elem = 7, N_node = 8 };
static const double nodes[] = {0.0,   0.131, 0.2385, 0.471,
                               0.553, 0.829, 0.9714, 1.2385};
static const double values[] = {2.385,  -0.731, 3.714, 0.613,
                                -1.247, 0.512,  2.071, -3.137};
static const double flux_a = 0.3714, flux_b = -1.613;

static double wavy_beta(double x)
{
    return 2.385 + sin(3.714 * x);
}
static double linear_beta(double x)
{
    return 2.385 + 3.714 * x;
}
static double wavy_load(double x)
{
    return 3.714 * cos(5.0 * x) - 0.613;
}
static double constant_load(double x)
{
    (void)x;
    return 3.714;
}

/* Round-off of a direct solve with condition number below 1e3. */
static const double ROUND_OFF = 1e-12;
/* Round-off of a sum of ten numbers of like size. */
static const double SUM = 1e-14;

struct scene {
    struct matrix *A;
    double *b, *u;
};

/* A and b of a load and two fluxes [eq:poisson-b]. */
static void with_fluxes(field *f, double qa, double qb, struct matrix *A,
                        double b[])
{
    poisson_assemble(n_elem, nodes, wavy_beta, f, &MIDPOINT, A, b);
    b[0] += qa;
    b[n_elem] += qb;
}

/* The scene under a load; b made compatible without the program's help. */
static struct scene compatible_scene(field *load)
{
    const struct scene s = {matrix_alloc(BANDED, N_node, 1),
                            guarded_alloc(N_node), guarded_alloc(N_node)};
    double sum = 0.0;
    with_fluxes(load, flux_a, flux_b, s.A, s.b);
    for (int i = 0; i < N_node; i++) sum += s.b[i];
    for (int i = 0; i < N_node; i++) s.b[i] -= sum / N_node;
    return s;
}

static struct scene solved_scene(field *load)
{
    const struct scene s = compatible_scene(load);
    const enum status status = solve_neumann(s.A, s.b, s.u);
    expect(status == OK, "solve_neumann says %s of a system that is solvable",
           status_name(status));
    return s;
}

static void quadratic_form_is_vAv(void)
{
    const struct scene s = compatible_scene(wavy_load);
    const double *x = guarded_copy(N_node, nodes);
    double Av[N_node], want = 0.0;
    matrix_multiply(s.A, values, Av);
    for (int i = 0; i < N_node; i++) want += values[i] * Av[i];
    expect_close(quadratic_form(n_elem, x, wavy_beta,
                                guarded_copy(N_node, values)),
                 want, ROUND_OFF, want,
                 "v'Av, unequal elements, beta not constant");

    /* the same body elsewhere: constant beta does not feel it */
    double *moved = guarded_alloc(N_node);
    for (int i = 0; i < N_node; i++) moved[i] = nodes[i] + 0.613;
    expect_close(quadratic_form(n_elem, moved, field_one, values),
                 quadratic_form(n_elem, x, field_one, values), ROUND_OFF, want,
                 "v'Av, beta = 1, of a body that begins at 0.613, against one "
                 "that begins at 0");

    /* only element 1 sees node 0, only element n sees node n */
    for (int end = 0; end <= n_elem; end += n_elem) {
        double hat[N_node] = {0};
        hat[end] = 1.0;
        expect_close(quadratic_form(n_elem, x, wavy_beta, hat),
                     matrix_get(s.A, end, end), ROUND_OFF, 1.0 / 0.131 * 3.4,
                     "v'Av of the hat at node %d", end);
    }
}

/* The midpoint rule is exact for linear beta, u_h for linear v. */
static void quadratic_form_of_linear_v_is_exact(void)
{
    const double slope = -0.731;
    double v[N_node];
    for (int n = n_elem; n > 0; n -= 4) {
        const double L = nodes[n];
        const double want = slope * slope * (2.385 * L + 0.5 * 3.714 * L * L);
        for (int i = 0; i <= n; i++) v[i] = 2.385 + slope * nodes[i];
        expect_close(quadratic_form(n, nodes, linear_beta, v), want, ROUND_OFF,
                     want, "v'Av for v = 2.385 - 0.731 x on %d elements, "
                     "against int beta v'^2", n);
    }
    for (int i = 0; i < N_node; i++) v[i] = 2.385;
    expect_close(quadratic_form(n_elem, nodes, linear_beta, v), 0.0, SUM, 10.0,
                 "v'Av for the constant 2.385");
}

/* Sums of small integers and of `defect` eps: exact in any order.  Sum |b_i| is
 * 22, so that 176 eps is the limit. */
static void judge_defect(double defect, double unit)
{
    const double integers[N_node] = {3, -1, 2, -4, 1, -2, 5, -4};
    double *b = guarded_copy(N_node, integers), found;
    b[n_elem] += defect * DBL_EPSILON;
    for (int i = 0; i < N_node; i++) b[i] *= unit;
    const enum status status = compatibility(N_node, b, &found);
    expect((status == OK) == (fabs(defect) < 176.0),
           "N = 8, sum |b| = %g, sum b = %.3g: N eps sum |b| is %.3g, but the "
           "status is %s", 22.0 * unit, defect * DBL_EPSILON * unit,
           176.0 * DBL_EPSILON * unit, status_name(status));
}

static void defect_is_the_sum_of_b(void)
{
    struct matrix *A = matrix_alloc(BANDED, N_node, 1);
    double *b = guarded_alloc(N_node), defect = -1.0, scale = 0.0;
    const double balance = -3.714 * nodes[n_elem] - flux_a;

    /* a constant load is integrated exactly: sum b = int f + q_a + q_b */
    with_fluxes(constant_load, flux_a, flux_b, A, b);
    const double want = 3.714 * nodes[n_elem] + flux_a + flux_b;
    expect(compatibility(N_node, b, &defect) == INCOMPATIBLE,
           "sum b = %.4g is taken for 0", want);
    expect_close(defect, want, SUM, 10.0, "defect for a constant load");
    for (int i = 0; i < N_node; i++) b[i] = -b[i];
    compatibility(N_node, b, &defect);
    expect_close(defect, -want, SUM, 10.0,
                 "defect for a constant load that pulls the other way");
    for (int i = 0; i < N_node; i++) b[i] = -b[i];
    for (int i = 0; i < N_node; i++) scale += fabs(b[i]);

    /* the scale of the problem and the sign of the defect do not matter */
    for (int k = -9; k <= 9; k += 9)
        for (int sign = -1; sign <= 1; sign++) {
            const double unit = pow(10.0, k);
            with_fluxes(constant_load, flux_a, balance, A, b);
            b[3] += sign * 1e-9 * scale;
            for (int i = 0; i < N_node; i++) b[i] *= unit;
            const enum status status = compatibility(N_node, b, &defect);
            expect((status == OK) == (sign == 0),
                   "loads of size 1e%d with sum %.1e times that: said %s", k,
                   sign * 1e-9 * scale, status_name(status));
        }
    for (int k = -20; k <= 20; k += 20) {
        for (int sign = -1; sign <= 1; sign += 2) {
            judge_defect(sign * 168.0, ldexp(1.0, k));
            judge_defect(sign * 184.0, ldexp(1.0, k));
        }
    }
    const double two[] = {1.0, -1.0 + 8.0 * DBL_EPSILON};
    expect(compatibility(2, guarded_copy(2, two), &defect) == INCOMPATIBLE,
           "N = 2, sum |b| = 2, sum b = 8 eps: N eps sum |b| is 4 eps");
    for (int i = 0; i < N_node; i++) b[i] = 0.0;
    expect(compatibility(N_node, b, &defect) == OK && defect == 0.0,
           "without any load the sum of b is 0: that is compatible");
    b[3] = NAN;
    expect(compatibility(N_node, b, &defect) == INCOMPATIBLE,
           "loads with a NaN among them are taken for compatible");
    matrix_free(A);
}

static void projection_is_orthogonal(void)
{
    double *b = guarded_alloc(N_node), sum = 0.0, mean = 0.0, defect;
    for (int i = 0; i < N_node; i++) {
        b[i] = values[i];
        mean += values[i] / N_node;
    }
    project(N_node, b);
    for (int i = 0; i < N_node; i++) sum += b[i];
    expect_close(sum, 0.0, SUM, 10.0, "sum of the projected b");
    for (int i = 0; i < N_node; i++)
        expect_close(values[i] - b[i], mean, SUM, 10.0,
                     "what b[%d] lost: the same everywhere, the mean of b", i);
    expect(compatibility(N_node, b, &defect) == OK,
           "compatibility() refuses a projected b");
    project(N_node, b);
    for (int i = 0; i < N_node; i++)
        expect_close(b[i], values[i] - mean, SUM, 10.0,
                     "b[%d] after a second projection, which changes nothing",
                     i);
    for (int i = 0; i < N_node; i++) b[i] = 1e-9 * values[i];
    project(N_node, b);
    for (int i = 0; i < N_node; i++)
        expect_close(b[i], 1e-9 * (values[i] - mean), SUM, 1e-8,
                     "b[%d] after the projection of a b of size 1e-9", i);
    b[0] = 3.714;
    b[1] = b[2] = b[3] = 0.613;
    project(2, b);
    expect(b[2] == 0.613 && b[3] == 0.613, "project() of two numbers changes "
           "those behind them");
    expect_close(b[0], 0.5 * (3.714 - 0.613), SUM, 10.0,
                 "b[0] of two, after the projection");
}

/* All N of them, the equation of a pinned node too. */
static void every_equation_holds(void)
{
    double x[5], b[5], *u = guarded_alloc(5), Au[5];
    struct matrix *A = matrix_alloc(BANDED, 5, 1);
    const double load[] = {0.5, -1.25, 3.0, -0.75, -1.5};
    poisson_grid(0.0, 1.0, 4, 1.0, x);
    poisson_assemble(4, x, field_one, field_one, &MIDPOINT, A, b);
    expect(solve_neumann(A, guarded_copy(5, load), u) == OK,
           "solve_neumann fails for n = 4 equal elements");
    matrix_multiply(A, u, Au);
    for (int i = 0; i < 5; i++)
        expect_close(Au[i], load[i], ROUND_OFF, 10.0,
                     "(A u)[%d], 4 equal elements", i);
    matrix_free(A);

    const struct scene s = solved_scene(wavy_load);
    double product[N_node];
    matrix_multiply(s.A, s.u, product);
    for (int i = 0; i < N_node; i++)
        expect_close(product[i], s.b[i], ROUND_OFF, 40.0,
                     "(A u)[%d], unequal elements, beta not constant", i);
}

/* Of the nodal values: on unequal elements that is not int u dx = 0. */
static void nodal_mean_is_zero(void)
{
    const struct scene s = solved_scene(wavy_load);
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < N_node; i++) {
        sum += s.u[i];
        largest = fmax(largest, fabs(s.u[i]));
    }
    expect_close(sum, 0.0, ROUND_OFF, largest,
                 "sum of the nodal values of the solution of least norm");
}

/* u = sum_k w_k (w_k . b) / lambda_k over the eigenvalues that are not 0. */
static void same_as_pseudo_inverse(void)
{
    const struct scene s = solved_scene(constant_load);
    gsl_matrix *M = gsl_matrix_alloc(N_node, N_node);
    gsl_matrix *w = gsl_matrix_alloc(N_node, N_node);
    gsl_vector *lambda = gsl_vector_alloc(N_node);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(N_node);
    double want[N_node] = {0};

    for (size_t i = 0; i < N_node; i++)
        for (size_t j = 0; j < N_node; j++)
            gsl_matrix_set(M, i, j, matrix_get(s.A, (int)i, (int)j));
    gsl_eigen_symmv(M, lambda, w, work);
    gsl_eigen_symmv_sort(lambda, w, GSL_EIGEN_SORT_VAL_ASC);
    for (size_t k = 1; k < N_node; k++) {
        double product = 0.0;
        for (size_t i = 0; i < N_node; i++)
            product += gsl_matrix_get(w, i, k) * s.b[i];
        for (size_t i = 0; i < N_node; i++)
            want[i] += gsl_matrix_get(w, i, k) * product /
                       gsl_vector_get(lambda, k);
    }
    for (int i = 0; i < N_node; i++)
        expect_close(s.u[i], want[i], ROUND_OFF, 1.0,
                     "u[%d], against the pseudo-inverse of A", i);
    gsl_eigen_symmv_free(work);
    gsl_vector_free(lambda);
    gsl_matrix_free(w);
    gsl_matrix_free(M);
}

static void incompatible_systems_are_refused(void)
{
    const struct scene s = compatible_scene(wavy_load);
    for (int sign = -1; sign <= 1; sign += 2) {
        for (int i = 0; i < N_node; i++) s.u[i] = values[i];
        s.b[2] += sign * 1e-6;
        const enum status status = solve_neumann(s.A, s.b, s.u);
        for (int i = 0; i < N_node; i++)
            expect(s.u[i] == values[i], "sum b = %g: u[%d] was %g and is %g; u "
                   "stays as it is where there is no solution", sign * 1e-6, i,
                   values[i], s.u[i]);
        expect(status == INCOMPATIBLE,
               "sum b = %g: solve_neumann must say INCOMPATIBLE, not %s",
               sign * 1e-6, status_name(status));
        s.b[2] -= sign * 1e-6;
    }
    struct matrix *minus = matrix_alloc(BANDED, N_node, 1);
    matrix_combine(minus, -1.0, s.A, minus);
    const enum status negative = solve_neumann(minus, s.b, s.u);
    expect(negative == NOT_SPD, "-A, whose eigenvalues are negative: "
           "solve_neumann must say NOT_SPD, not %s", status_name(negative));
    matrix_free(minus);
    struct output *output = run_unsolved("--project no", "INCOMPATIBLE");
    expect(has_table(output, "load") && !has_table(output, "nodes"),
           "--project no: the loads are due, and no nodal values");
    expect_refusal("--project no", 1, "-0.00446"); /* and by how much */
    expect_refusal("--n 57 --grading 2.385 --project no", 1, "INCOMPATIBLE");
    expect_refusal("--excess 0.2385", 1, "INCOMPATIBLE");
    expect_refusal("--excess -1e-6 --n 64", 1, "INCOMPATIBLE");
}

static void numbers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_neumann); k++) {
        const int n = oracle_neumann[k].N;
        struct output *output = run(n == 4 ? "" : "--n 16");
        int rows;
        const double *b = column(output, "load", "b", &rows);
        double sum = 0.0;
        expect(rows == n + 1, "table `load` has %d rows, not %d", rows, n + 1);
        for (int i = 0; i < rows; i++) sum += b[i];
        expect_close(sum, oracle_neumann[k].sum_b, SUM, 10.0,
                     "sum b for n = %d", n);
        for (int i = 0; n == 4 && i < COUNT(oracle_neumann_u4); i++)
            expect_close(cell(output, "nodes", "u", i), oracle_neumann_u4[i],
                         ROUND_OFF, 1.0, "u[%d] of least norm for n = 4", i);
    }
}

/* sum b is the error of the rule for int e^x dx: with E = e - 1 it is
 * -E h^2 / 24 (midpoint), E h^2 / 12 (trapezoid), -E h^4 / 4320 (two Gauss
 * points), up to terms that are h^2 / 30 relative or less. */
static void defect_is_the_quadrature_error(void)
{
    const struct quadrature *const rule[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    const double E = expm1(1.0);
    for (int n = 4; n <= 64; n *= 2) {
        const double h2 = 1.0 / n / n, first_term = h2 / 30.0 + 1e-3 * h2;
        const double want[] = {-E * h2 / 24.0, E * h2 / 12.0,
                               -E * h2 * h2 / 4320.0};
        struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
        double x[65], b[65], defect;
        poisson_grid(0.0, 1.0, n, 1.0, x);
        for (int r = 0; r < COUNT(rule); r++) {
            poisson_assemble(n, x, wavy_beta, exp, rule[r], A, b);
            b[n] -= E;
            expect(compatibility(n + 1, b, &defect) == INCOMPATIBLE,
                   "n = %d, rule %d: sum b = %g is taken for 0", n, r + 1,
                   want[r]);
            /* and 1e-14 of round-off */
            expect_close(defect, want[r], first_term * fabs(want[r]) + 1e-14,
                         1.0, "defect of e^x, n = %d, against the first term "
                         "of the error of the %s", n,
                         r == 0   ? "midpoint rule"
                         : r == 1 ? "trapezoidal rule"
                                  : "Gauss rule");
        }
        matrix_free(A);
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    const double four = cell(run(""), "compatibility", "sum_b", 0);
    const double eight = cell(run("--n 8"), "compatibility", "sum_b", 0);
    const char *gauss[] = {"--rule gauss2", "--rule gauss2 --n 8"};
    measured("1", four);
    measured("2a", four / eight);
    measured("2b", cell(run(gauss[0]), "compatibility", "sum_b", 0) /
                       cell(run(gauss[1]), "compatibility", "sum_b", 0));
}

static const struct claim claims[] = {
    {"quadratic_form_is_vAv", quadratic_form_is_vAv, "4a"},
    {"quadratic_form_of_linear_v_is_exact", quadratic_form_of_linear_v_is_exact,
     "4a"},
    {"defect_is_the_sum_of_b", defect_is_the_sum_of_b, "4b"},
    {"projection_is_orthogonal", projection_is_orthogonal, "4c"},
    {"every_equation_holds", every_equation_holds, "4d"},
    {"nodal_mean_is_zero", nodal_mean_is_zero, "4d"},
    {"same_as_pseudo_inverse", same_as_pseudo_inverse, "4d"},
    {"incompatible_systems_are_refused", incompatible_systems_are_refused,
     "4d"},
    {"numbers_are_the_oracles", numbers_are_the_oracles, "4d"},
    {"defect_is_the_quadrature_error", defect_is_the_quadrature_error, "4b"},
};

static const char *const runs[] = {
    "",
    "--n 7 --grading 3.714",
    "--n 2 --grading 0.613",
    "--n 12 --grading 0.2385",
    "--n 33 --rule trapezoid",
    "--n 47 --rule gauss2 --grading 2.385",
};

#define SOLVE "direct solve, condition number below 1e5"
#define ADDED "round-off of a sum of N loads"
static const struct column_rule rules[] = {
    {"quadratic_form", "v", 0, "a word", 0},
    {"quadratic_form", "*", 1e-12, "a sum of n squares", 0},
    {"load", "i", 0, "a count", 0},
    {"load", "*", 1e-13, ADDED, 0},
    {"compatibility", "sum_b", 1e-13, ADDED, 3.4},
    {"compatibility", "*", 0, "a word", 0},
    {"nodes", "x", 1e-14, "a node", 0},
    {"nodes", "*", 1e-10, SOLVE, 0},
};

static const struct lesson lesson = {
    "04_neumann_compatibility", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "The boundary value problem has solutions and its linear system has none: "
    "sum b is the error of the quadrature (figures/04_neumann_compatibility/"
    "compatibility.svg), so it falls like h^2 and a better rule makes it "
    "smaller, but only round-off makes it 0. Removing that defect is "
    "legitimate; removing one of the problem is not.",
    "Run with --rule gauss2 --project no and find the smallest n that is not "
    "refused. Why is there one?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
