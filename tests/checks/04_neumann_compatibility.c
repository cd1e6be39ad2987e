/* 04_neumann_compatibility.c - what a right treatment of two flux ends
 * satisfies. */
#include "judge.h"

#define main program_main
#include PROGRAM
#undef main

#include "../oracle/poisson.h"

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
    double b[N_node], u[N_node];
};

/* A and b of the scene; b made compatible without the program's help. */
static struct scene compatible_scene(void)
{
    struct scene s = {.A = matrix_alloc(BANDED, N_node, 1)};
    double sum = 0.0;
    poisson_assemble(n_elem, nodes, wavy_beta, wavy_load, &MIDPOINT, s.A, s.b);
    s.b[0] += flux_a;
    s.b[n_elem] += flux_b;
    for (int i = 0; i < N_node; i++) sum += s.b[i];
    for (int i = 0; i < N_node; i++) s.b[i] -= sum / N_node;
    return s;
}

static struct scene solved_scene(void)
{
    struct scene s = compatible_scene();
    const enum status status = solve_neumann(s.A, s.b, s.u);
    expect(status == OK, "solve_neumann says %s of a system that is solvable",
           status_name(status));
    return s;
}

static void quadratic_form_is_vAv(void)
{
    const struct scene s = compatible_scene();
    double Av[N_node], want = 0.0;
    matrix_multiply(s.A, values, Av);
    for (int i = 0; i < N_node; i++) want += values[i] * Av[i];
    expect_close(quadratic_form(n_elem, nodes, wavy_beta, values), want,
                 ROUND_OFF, want, "v'Av, unequal elements, beta not constant");

    /* only element 1 sees node 0, only element n sees node n */
    for (int end = 0; end <= n_elem; end += n_elem) {
        double hat[N_node] = {0};
        hat[end] = 1.0;
        expect_close(quadratic_form(n_elem, nodes, wavy_beta, hat),
                     matrix_get(s.A, end, end), ROUND_OFF, 1.0 / 0.131 * 3.4,
                     "v'Av of the hat at node %d", end);
    }
}

/* The midpoint rule is exact for linear beta, u_h for linear v. */
static void quadratic_form_of_linear_v_is_exact(void)
{
    const double slope = -0.731, L = nodes[n_elem];
    const double want = slope * slope * (2.385 * L + 0.5 * 3.714 * L * L);
    double v[N_node];
    for (int i = 0; i < N_node; i++) v[i] = 2.385 + slope * nodes[i];
    expect_close(quadratic_form(n_elem, nodes, linear_beta, v), want, ROUND_OFF,
                 want, "v'Av for v = 2.385 - 0.731 x, against int beta v'^2");
    for (int i = 0; i < N_node; i++) v[i] = 2.385;
    expect_close(quadratic_form(n_elem, nodes, linear_beta, v), 0.0, SUM, want,
                 "v'Av for the constant 2.385");
}

static void defect_is_the_sum_of_b(void)
{
    struct matrix *A = matrix_alloc(BANDED, N_node, 1);
    double b[N_node], defect = -1.0, scale = 0.0;
    const double balance = -3.714 * nodes[n_elem] - flux_a;

    /* a constant load is integrated exactly: sum b = int f + q_a + q_b */
    assemble(n_elem, nodes, wavy_beta, constant_load, flux_a, flux_b, &MIDPOINT,
             A, b);
    const double want = 3.714 * nodes[n_elem] + flux_a + flux_b;
    expect(compatibility(N_node, b, &defect) == INCOMPATIBLE,
           "sum b = %.4g is taken for 0", want);
    expect_close(defect, want, SUM, 10.0, "defect for a constant load");
    for (int i = 0; i < N_node; i++) scale += fabs(b[i]);

    /* the scale of the problem and the sign of the defect do not matter */
    for (int k = -9; k <= 9; k += 9)
        for (int sign = -1; sign <= 1; sign++) {
            const double unit = pow(10.0, k);
            assemble(n_elem, nodes, wavy_beta, constant_load, flux_a, balance,
                     &MIDPOINT, A, b);
            b[3] += sign * 1e-9 * scale;
            for (int i = 0; i < N_node; i++) b[i] *= unit;
            const enum status status = compatibility(N_node, b, &defect);
            expect((status == OK) == (sign == 0),
                   "loads of size 1e%d with sum %.1e times that: said %s", k,
                   sign * 1e-9 * scale, status_name(status));
        }
    b[3] = NAN;
    expect(compatibility(N_node, b, &defect) == INCOMPATIBLE,
           "loads with a NaN among them are taken for compatible");
    matrix_free(A);
}

static void projection_is_orthogonal(void)
{
    double b[N_node], sum = 0.0, mean = 0.0, defect;
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
}

/* All N of them, the equation of a pinned node too. */
static void every_equation_holds(void)
{
    double x[5], b[5], u[5], Au[5];
    struct matrix *A = matrix_alloc(BANDED, 5, 1);
    const double load[] = {0.5, -1.25, 3.0, -0.75, -1.5};
    grid_make(0.0, 1.0, 4, 1.0, x);
    poisson_assemble(4, x, one, one, &MIDPOINT, A, b);
    expect(solve_neumann(A, load, u) == OK,
           "solve_neumann fails for n = 4 equal elements");
    matrix_multiply(A, u, Au);
    for (int i = 0; i < 5; i++)
        expect_close(Au[i], load[i], ROUND_OFF, 10.0,
                     "(A u)[%d], 4 equal elements", i);
    matrix_free(A);

    const struct scene s = solved_scene();
    double product[N_node];
    matrix_multiply(s.A, s.u, product);
    for (int i = 0; i < N_node; i++)
        expect_close(product[i], s.b[i], ROUND_OFF, 40.0,
                     "(A u)[%d], unequal elements, beta not constant", i);
}

/* Of the nodal values: on unequal elements that is not int u dx = 0. */
static void nodal_mean_is_zero(void)
{
    const struct scene s = solved_scene();
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < N_node; i++) {
        sum += s.u[i];
        largest = fmax(largest, fabs(s.u[i]));
    }
    expect_close(sum, 0.0, ROUND_OFF, largest,
                 "sum of the nodal values of the solution of minimum norm");
}

/* u = sum_k w_k (w_k . b) / lambda_k over the eigenvalues that are not 0. */
static void same_as_pseudo_inverse(void)
{
    const struct scene s = solved_scene();
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
    struct scene s = compatible_scene();
    for (int sign = -1; sign <= 1; sign += 2) {
        s.b[2] += sign * 1e-6;
        const enum status status = solve_neumann(s.A, s.b, s.u);
        expect(status == INCOMPATIBLE,
               "sum b = %g: solve_neumann must say INCOMPATIBLE, not %s",
               sign * 1e-6, status_name(status));
        s.b[2] -= sign * 1e-6;
    }
    expect_refusal("--project no", 1, "INCOMPATIBLE");
    expect_refusal("--project no", 1, "-0.00446"); /* and by how much */
    expect_refusal("--n 57 --grading 2.385 --project no", 1, "INCOMPATIBLE");
    expect_refusal("--excess 0.2385", 1, "INCOMPATIBLE");
    expect_refusal("--excess -1e-6 --n 64", 1, "INCOMPATIBLE");
}

static void numbers_are_the_oracles(void)
{
    struct output *output = run("");
    for (int k = 0; k < COUNT(oracle_neumann); k++) {
        const int row = k == 0 ? 0 : 2; /* n = 4, 16 */
        expect(lround(cell(output, "compatibility", "n", row)) ==
                   oracle_neumann[k].N,
               "row %d of table `compatibility` must be N = %d", row + 1,
               oracle_neumann[k].N);
        expect_close(cell(output, "compatibility", "sum_b", row),
                     oracle_neumann[k].sum_b, SUM, 10.0, "sum b for N = %d",
                     oracle_neumann[k].N);
    }
    for (int i = 0; i < COUNT(oracle_neumann_u4); i++)
        expect_close(cell(output, "family", "minimum_norm", i),
                     oracle_neumann_u4[i], ROUND_OFF, 1.0,
                     "u[%d] of minimum norm for n = 4", i);
    expect(lround(cell(output, "definiteness", "rank", 0)) == 4,
           "the matrix of two flux ends, order 5, has rank 4");
}

/* sum b is the error of the rule for int e^x dx: with E = e - 1 it is
 * -E h^2 / 24 (midpoint), E h^2 / 12 (trapezoid), -E h^4 / 4320 (two Gauss
 * points), up to terms that are h^2 / 30 relative or less. */
static void defect_is_the_quadrature_error(void)
{
    struct output *output = run("");
    const double E = expm1(1.0);
    int n;
    const double *h = column(output, "rules", "h", &n);
    const double *midpoint = column(output, "rules", "midpoint", NULL);
    const double *trapezoid = column(output, "rules", "trapezoid", NULL);
    const double *gauss2 = column(output, "rules", "gauss2", NULL);
    for (int k = 0; k < n; k++) {
        const double h2 = h[k] * h[k], first_term = h2 / 30.0 + 1e-3 * h2;
        expect_close(midpoint[k], -E * h2 / 24.0, first_term, E * h2 / 24.0,
                     "midpoint defect at h = %g, against -(e-1)h^2/24", h[k]);
        expect_close(trapezoid[k], E * h2 / 12.0, first_term, E * h2 / 12.0,
                     "trapezoid defect at h = %g, against (e-1)h^2/12", h[k]);
        /* and 1e-14 of round-off */
        expect_close(gauss2[k], -E * h2 * h2 / 4320.0,
                     first_term * E * h2 * h2 / 4320.0 + 1e-14, 1.0,
                     "Gauss defect at h = %g, against -(e-1)h^4/4320", h[k]);
    }
    expect_close(cell(output, "compatibility", "order", -1), 2.0, 1e-5, 1.0,
                 "order of the midpoint rule's defect");
}

static void reaction_takes_the_whole_defect(void)
{
    struct output *output = run("--n 11 --grading 2.385");
    int n, n_load;
    const double *excess = column(output, "pinned", "excess", &n);
    const double *reaction = column(output, "pinned", "reaction", NULL);
    const double *b = column(output, "load", "b", &n_load);
    double sum = 0.0;
    for (int i = 0; i < n_load; i++) sum += b[i];
    for (int k = 0; k < n; k++)
        expect_close(reaction[k], -(sum + excess[k]), ROUND_OFF, 1.0,
                     "table `pinned`, row %d: reaction, against -(sum b + "
                     "excess)", k + 1);
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
    {"reaction_takes_the_whole_defect", reaction_takes_the_whole_defect, NULL},
};

static const char *const runs[] = {
    "",
    "--n 7 --grading 3.714",
    "--n 2 --grading 0.613",
    "--n 12 --grading 0.2385",
    "--n 33 --rule trapezoid",
};

#define SOLVE "direct solve, condition number below 1e5"
#define ADDED "round-off of a sum of N loads"
static const struct column_rule rules[] = {
    {"quadratic_form", "v", 0, "a number of the list above", 0},
    {"quadratic_form", "*", 1e-12, "a sum of n squares", 0},
    {"definiteness", "lambda_min", 1e-9, "eigenvalues to eps lambda_max", 0},
    {"definiteness", "lambda_max", 1e-9, "eigenvalues to eps lambda_max", 0},
    {"definiteness", "not_spd", NOT_COMPARED,
     "on graded meshes round-off decides what the last pivot is", 0},
    {"definiteness", "*", 0, "a count", 0},
    {"null_vector", "x", 1e-14, "a node", 0},
    {"null_vector", "*", 1e-9, "eigenvector to eps times the condition", 0},
    {"load", "i", 0, "a count", 0},
    {"load", "*", 1e-13, ADDED, 0},
    {"family", "x", 1e-14, "a node", 0},
    {"family", "*", 1e-10, SOLVE, 0},
    {"norms", "c", 1e-15, "given", 0},
    {"norms", "*", 1e-10, SOLVE, 0},
    {"compatibility", "n", 0, "a count", 0},
    {"compatibility", "h", 1e-15, "1 / N", 0},
    {"compatibility", "sum_b", 1e-13, ADDED, 3.4},
    {"compatibility", "leading", 1e-12, "a sum of N terms", 0},
    {"compatibility", "ratio", 1e-6, "round-off over the smallest sum b", 0},
    {"compatibility", "order", 1e-6, "round-off over the smallest sum b", 0},
    {"compatibility", "incompatible", 0, "0 or 1", 0},
    {"rules", "h", 1e-15, "1 / N", 0},
    {"rules", "*", 1e-13, ADDED, 3.4},
    {"pinned", "excess", 1e-15, "given", 0},
    {"pinned", "node", 0, "a count", 0},
    {"pinned", "x", 1e-14, "a node", 0},
    {"pinned", "reaction", 1e-10, SOLVE, 0},
    {"pinned", "*", 1e-9, SOLVE, 0},
};

static const struct lesson lesson = {
    "04_neumann_compatibility", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "The boundary value problem has solutions and its linear system has none: "
    "sum b is the error of the quadrature (table `rules`), so it falls like "
    "h^2 and a better rule makes it smaller, but only round-off makes it 0. "
    "Removing that defect is legitimate; removing one of the problem is not.",
    "Table `pinned`, rows with excess 0.1: each pinned node gives another "
    "answer and none a warning. Then run with --rule gauss2 --project no and "
    "find the smallest n that is not refused. Why is there one?"};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
