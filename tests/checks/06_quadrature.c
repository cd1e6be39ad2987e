/*
 * 06_quadrature.c - what right quadrature of A and b satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     6a   rule            all three
 *     6b   x0, x1, g       one element away from 0 here, many in 6c and 6d
 *     6b   shape, rule     all three of each, NaN behind the rule's points
 *     6c   j, n            all rows; 7 unequal, 4, 2, and 1 to 11 in the runs
 *     6c   x, mean         unequal grids, one that begins at 0.32; three beta
 *     6d   f, rule         loads of the exercises, a kink, none; three rules
 *     6d   qa, qb          both, one, none
 */
#include "program.h"

#include "judge.h"

#include "../oracle/poisson.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

/* An unequal grid without symmetry, and fluxes at both ends. */
enum { n_elem = 7 };
static const double grid[n_elem + 1] = {0.0,   0.113, 0.2385, 0.3714,
                                        0.613, 0.731, 0.8247, 1.0};
static const double flux_a = 2.385, flux_b = -3.714;

/* Sums of a few products of size one. */
static const double ROUND_OFF = 1e-14;

/* The rules of common/ with NaN behind their last point. */
static const struct quadrature *common_rule(int r)
{
    static struct quadrature rule[3];
    const struct quadrature *const all[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    rule[r] = *all[r];
    for (int k = rule[r].n; k < COUNT(rule[r].s); k++)
        rule[r].s[k] = rule[r].w[k] = (double)NAN;
    return &rule[r];
}
static const char *const rule_name[] = {"midpoint", "trapezoid", "gauss2"};

static double kink(double x)
{
    return fabs(x - 1.0 / 3.0);
}
static double power_0(double x)
{
    return 1.0 + 0.0 * x;
}
static double power_1(double x)
{
    return x;
}
static double power_2(double x)
{
    return x * x;
}
static double power_3(double x)
{
    return x * x * x;
}
static double power_4(double x)
{
    return x * x * x * x;
}
static field *const power[] = {power_0, power_1, power_2, power_3, power_4};

/* A, dense, and b as the program's vertices give them. */
struct system {
    double A[n_elem + 1][n_elem + 1], b[n_elem + 1];
};

static void assembled(int n, const double x[], field *beta, field *f,
                      const struct quadrature *rule, double qa, double qb,
                      struct system *out)
{
    double *mean = guarded_alloc(n + 1);
    *out = (struct system){0};
    x = guarded_copy(n + 1, x);
    element_means(n, x, beta, rule, mean);
    for (int j = 0; j <= n; j++) {
        double *row = guarded_alloc(3);
        stiffness_row(j, n, x, mean, row);
        for (int k = 0; k < 3; k++) {
            if (j + k >= 1 && j + k <= n + 1)
                out->A[j][j + k - 1] = row[k];
            else
                expect_close(row[k], 0.0, 0.0, 1.0,
                             "row %d: the entry of a neighbour that is not "
                             "there",
                             j);
        }
        out->b[j] = load_entry(j, n, x, f, rule, qa, qb);
    }
}

static void rules_have_their_degree_of_exactness(void)
{
    static const int degree[] = {1, 1, 3};
    static const double next[] = {1.0 / 12.0, -1.0 / 6.0, 1.0 / 180.0};
    for (int r = 0; r < N_RULE; r++) {
        const struct quadrature rule = quadrature_rule((enum rule)r);
        expect(rule.n >= 1 && rule.n <= 3, "the %s rule has %d points",
               rule_name[r], rule.n);
        for (int d = 0; d <= degree[r] + 1; d++) {
            double error = 1.0 / (d + 1);
            for (int k = 0; k < rule.n; k++)
                error -= rule.w[k] * pow(rule.s[k], d);
            expect_close(error, d <= degree[r] ? 0.0 : next[r], 1e-15, 1.0,
                         "%s rule: int of s^%d over (0, 1), less the rule",
                         rule_name[r], d);
        }
    }
}

/* On (x0, x0 + h), g times the shape of degree one less than exact. */
static void element_integrals_of_polynomials_are_exact(void)
{
    const double x0 = 0.613, x1 = 2.385, h = x1 - x0;
    for (int r = 0; r < N_RULE; r++)
        for (int d = 0; d <= (r == GAUSS2_RULE ? 3 : 1); d++) {
            const struct quadrature *rule = common_rule(r);
            /* int x^d, and int x^d s = (int x^(d+1) - x0 int x^d) / h */
            const double I = (pow(x1, d + 1) - pow(x0, d + 1)) / (d + 1);
            const double J = (pow(x1, d + 2) - pow(x0, d + 2)) / (d + 2);
            const double rising = (J - x0 * I) / h;
            expect_close(element_integral(x0, x1, power[d], ONE, rule), I,
                         ROUND_OFF, I, "int of x^%d over (%g, %g), %s", d, x0,
                         x1, rule_name[r]);
            if (d == (r == GAUSS2_RULE ? 3 : 1)) continue;
            expect_close(element_integral(x0, x1, power[d], RISING, rule),
                         rising, ROUND_OFF, I,
                         "int of x^%d s over (%g, %g), %s", d, x0, x1,
                         rule_name[r]);
            expect_close(element_integral(x0, x1, power[d], FALLING, rule),
                         I - rising, ROUND_OFF, I,
                         "int of x^%d (1 - s) over (%g, %g), %s", d, x0, x1,
                         rule_name[r]);
        }
}

/* Beyond the degree: h^3/24 g'', -h^3/12 g'', h^5/4320 g''''. */
static void element_errors_have_their_constants(void)
{
    const double x0 = 0.613, x1 = 2.385, h = x1 - x0;
    const double I2 = (pow(x1, 3) - pow(x0, 3)) / 3.0;
    const double I4 = (pow(x1, 5) - pow(x0, 5)) / 5.0;
    const double error[] = {
        I2 - element_integral(x0, x1, power_2, ONE, &MIDPOINT),
        I2 - element_integral(x0, x1, power_2, ONE, &TRAPEZOID),
        I4 - element_integral(x0, x1, power_4, ONE, &GAUSS2)};
    const double want[] = {pow(h, 3) / 12.0, -pow(h, 3) / 6.0,
                           pow(h, 5) / 180.0};
    for (int r = 0; r < N_RULE; r++)
        expect_close(error[r], want[r], 1e-12, want[r] < 0 ? -want[r] : want[r],
                     "error of the %s rule for x^%d over (%g, %g)",
                     rule_name[r], r == GAUSS2_RULE ? 4 : 2, x0, x1);
}

static void rows_of_A_add_up_to_zero(void)
{
    for (int r = 0; r < N_RULE; r++) {
        struct system s;
        assembled(n_elem, grid, smooth_beta, smooth_f, common_rule(r), 0.0, 0.0,
                  &s);
        for (int i = 0; i <= n_elem; i++) {
            double sum = 0.0;
            for (int j = 0; j <= n_elem; j++) sum += s.A[i][j];
            expect_close(sum, 0.0, ROUND_OFF, 30.0,
                         "sum of row %d of A (u = 1 has no stress), %s", i,
                         rule_name[r]);
            for (int j = 0; j < i; j++)
                expect_close(s.A[i][j], s.A[j][i], ROUND_OFF, 30.0,
                             "A[%d][%d] against A[%d][%d], %s", i, j, j, i,
                             rule_name[r]);
        }
    }
}

/* beta = 1 + x is linear: every rule has the exact A of exercise (5). */
static void linear_beta_gives_the_oracles_matrix(void)
{
    const double x[] = {0.0, 0.25, 0.5, 0.75, 1.0};
    for (int r = 0; r < N_RULE; r++) {
        struct system s;
        assembled(4, x, bvp_beta, bvp_f, common_rule(r), 0.0, -0.5, &s);
        for (int i = 0; i < 5; i++)
            for (int j = 0; j < 5; j++)
                expect_close(s.A[i][j], oracle_bvp_A4[5 * i + j], ROUND_OFF,
                             14.0, "A[%d][%d] of exercise (5), N = 4, %s", i, j,
                             rule_name[r]);
    }
}

static void load_is_the_oracles(void)
{
    const double x[] = {0.0, 0.25, 0.5, 0.75, 1.0};
    struct system s;
    assembled(4, x, bvp_beta, bvp_f, &MIDPOINT, 0.0, -0.5, &s);
    for (int i = 0; i < 5; i++)
        expect_close(s.b[i], oracle_bvp_b4_midpoint[i], ROUND_OFF, 1.0,
                     "b[%d] of exercise (5), N = 4, midpoint rule", i);
}

/* Of one element each vertex has a neighbour on one side only. */
static void one_element_has_both_ends(void)
{
    const double mean[] = {NAN, 2.385}, x[] = {0.25, 0.75};
    for (int j = 0; j < 2; j++) {
        double *row = guarded_alloc(3);
        stiffness_row(j, 1, guarded_copy(2, x), guarded_copy(2, mean), row);
        for (int k = 0; k < 3; k++)
            expect_close(row[k], k == 1 ? 4.77 : k == 2 - 2 * j ? -4.77 : 0.0,
                         ROUND_OFF, 4.77, "one element, row[%d] of vertex %d",
                         k, j);
    }
}

/* The hats add up to 1, so sum_j b_j is the rule applied to f, plus q. */
static void loads_add_up_to_force_and_fluxes(void)
{
    for (int r = 0; r < N_RULE; r++) {
        const struct quadrature *rule = common_rule(r);
        const double *x = guarded_copy(n_elem + 1, grid);
        double total = flux_a + flux_b, sum = 0.0;
        for (int j = 0; j <= n_elem; j++)
            sum += load_entry(j, n_elem, x, smooth_f, rule, flux_a, flux_b);
        for (int e = 0; e < n_elem; e++) {
            const double h = grid[e + 1] - grid[e];
            for (int k = 0; k < rule->n; k++)
                total += rule->w[k] * h * smooth_f(grid[e] + rule->s[k] * h);
        }
        expect_close(sum, total, ROUND_OFF, 10.0,
                     "sum of b, against the %s rule for int f dx, plus the two "
                     "fluxes",
                     rule_name[r]);
    }
    for (int end = 0; end <= 1; end++)
        expect_close(load_entry(end, 1, grid, field_zero, &MIDPOINT, flux_a,
                                flux_b),
                     end ? flux_b : flux_a, ROUND_OFF, 1.0,
                     "one element, b[%d] without f: the flux at that end", end);
    for (int end = 0; end <= n_elem; end += n_elem)
        expect_close(load_entry(end, n_elem, grid, field_zero, &MIDPOINT,
                                flux_a, flux_b),
                     end ? flux_b : flux_a, ROUND_OFF, 1.0,
                     "b[%d] without f: the flux at that end", end);
}

static void same_as_element_assembly(void)
{
    struct matrix *A = matrix_alloc(DENSE, n_elem + 1, 0);
    for (int r = 0; r < N_RULE; r++) {
        double b[n_elem + 1];
        struct system s;
        const struct quadrature rule = quadrature_rule((enum rule)r);
        poisson_assemble(n_elem, grid, smooth_beta, smooth_f, common_rule(r), A,
                         b);
        b[0] += flux_a;
        b[n_elem] += flux_b;
        assembled(n_elem, grid, smooth_beta, smooth_f, &rule, flux_a, flux_b,
                  &s);
        for (int i = 0; i <= n_elem; i++) {
            expect_close(s.b[i], b[i], ROUND_OFF, 10.0,
                         "b[%d], %s, against the element assembly of common/",
                         i, rule_name[r]);
            for (int j = 0; j <= n_elem; j++)
                expect_close(s.A[i][j], matrix_get(A, i, j), ROUND_OFF, 60.0,
                             "A[%d][%d], %s, against the element assembly of "
                             "common/",
                             i, j, rule_name[r]);
        }
    }
    matrix_free(A);
}

/* The product of a given function with the left half of a hat, for GSL. */
struct against {
    field *g;
    double at, slope;
};
static double against_value(double x, void *params)
{
    const struct against *a = params;
    return a->g(x) * (a->slope == 0.0 ? 1.0 : a->slope * (x - a->at));
}
static double judged(double x0, double x1, field *g, double at, double slope)
{
    struct against a = {g, at, slope};
    gsl_function function = {against_value, &a};
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(100);
    double result, estimate;
    expect(gsl_integration_qag(&function, x0, x1, 1e-12, 0.0, 100,
                               GSL_INTEG_GAUSS21, work, &result,
                               &estimate) == GSL_SUCCESS,
           "GSL's quadrature failed: is the integrand finite?");
    gsl_integration_workspace_free(work);
    return result;
}

/*
 * Errors of A and b at an inner vertex with two equal elements, halved twice:
 * h^2 beta''/24 times 1, -2 or nearly 0 for A_{j,j-1} h, and for b_j it is
 * h^3 f''(x_j) times -1/24, 1/12 or nearly 0.
 */
static void gsl_agrees_to_the_order_of_the_rule(void)
{
    const double at = 0.3714;
    for (int r = 0; r < N_RULE; r++) {
        double A_error[2], b_error[2];
        for (int fine = 0; fine < 2; fine++) {
            const double h = fine ? 0.025 : 0.05;
            const double x[] = {at - h, at, at + h};
            struct system s;
            assembled(2, x, smooth_beta, smooth_f, common_rule(r), 0.0, 0.0,
                      &s);
            A_error[fine] =
                s.A[1][0] + judged(x[0], at, smooth_beta, 0.0, 0.0) / (h * h);
            b_error[fine] = judged(x[0], at, smooth_f, x[0], 1.0 / h) +
                            judged(at, x[2], smooth_f, x[2], -1.0 / h) - s.b[1];
        }
        /* next terms of the expansions: 10 % of the order at these h */
        const double A_order = log(A_error[0] / A_error[1]) / log(2.0);
        const double b_order = log(b_error[0] / b_error[1]) / log(2.0);
        const double A_want = r == GAUSS2_RULE ? 3.0 : 1.0;
        const double b_want = r == GAUSS2_RULE ? 5.0 : 3.0;
        expect_close(A_order, A_want, 0.1, 1.0,
                     "order of A_{j,j-1} against GSL, %s", rule_name[r]);
        expect_close(b_order, b_want, 0.1, 1.0,
                     "order of an inner b_j against GSL, %s", rule_name[r]);
    }
}

/* int f dx - sum_j b_j on n equal elements. */
static double load_error(int n, field *f, double integral, int r)
{
    const struct quadrature rule = quadrature_rule((enum rule)r);
    double x[65];
    poisson_grid(0.0, 1.0, n, 1.0, x);
    for (int j = 0; j <= n; j++)
        integral -= load_entry(j, n, x, f, &rule, 0.0, 0.0);
    return integral;
}

/* Euler-Maclaurin; the next term is below 1e-3 of it at h = 1/32. */
static void total_loads_have_their_constants(void)
{
    const int n = 32;
    const double h = 1.0 / n, e = exp(1.0);
    const double f1[] = {6.0, 2.0 * e * (3.0 * cos(2.0) + 4.0 * sin(2.0))};
    const double f3[] = {14.0, 2.0 * e * (7.0 * cos(2.0) - 24.0 * sin(2.0))};
    const double want[] = {(f1[1] - f1[0]) * h * h / 24.0,
                           -(f1[1] - f1[0]) * h * h / 12.0,
                           (f3[1] - f3[0]) * pow(h, 4) / 4320.0};
    const double of_kink[] = {1.0 / 9.0, -2.0 / 9.0,
                              5.0 / 18.0 - sqrt(3.0) / 6.0};
    for (int r = 0; r < N_RULE; r++) {
        expect_close(load_error(n, smooth_f, 2.0 - 2.0 * e * cos(2.0), r),
                     want[r], 2e-3, fabs(want[r]),
                     "error of the total load, %s, h = %g", rule_name[r], h);
        expect_close(load_error(n, kink, 5.0 / 18.0, r), of_kink[r] * h * h,
                     1e-9, fabs(of_kink[r] * h * h),
                     "error of the total load, f = |x - 1/3|, %s, h = %g",
                     rule_name[r], h);
    }
}

/* sum over element midpoints of a fine grid */
static double sum_fine(double g(double x, double w), const double w[], int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += g((i + 0.5) / n, w[i]) / n;
    return sum;
}
static double energy_density(double x, double w)
{
    (void)w; /* beta u''^2 / 12 */
    return exp(x) * 16.0 * gsl_pow_2(sin(2.0 * x)) / 12.0;
}
static double L2_density(double x, double w)
{
    const double u2 = -4.0 * sin(2.0 * x); /* u''^2/120 + u''w/6 + w^2 */
    return u2 * u2 / 120.0 + u2 * w / 6.0 + w * w;
}

/* u[0..n] of the smooth problem with the program's own rule number r. */
static void solve_smooth(int n, const double x[], int r, double u[])
{
    const struct quadrature rule = quadrature_rule((enum rule)r);
    double *mean = allocate((size_t)n + 1, sizeof *mean);
    element_means(n, x, smooth_beta, &rule, mean);
    for (int j = 0; j <= n; j++)
        u[j] = load_entry(j, n, x, smooth_f, &rule, -2.0, 0.0);
    const enum status status = solve(n, x, mean, n, u);
    expect(status == OK, "with the %s rule the matrix is %s", rule_name[r],
           status_name(status));
    free(mean);
}

/*
 * u_h = u + h^2 w at the nodes with 24 beta w' = 2 beta' u'' + m (u' beta'' +
 * sigma'' + sigma''(0)), w(1) = 0, m = 1, -2, 0 for the three rules and sigma =
 * beta u'; then the norms of u - u_h, to leading order.  The next order is
 * below 1e-3 of it at h = 1/64.
 */
static void solution_has_the_orders_and_constants(void)
{
    enum { FINE = 4000 };
    static double w[FINE];
    const int n = 64;
    const double h = 1.0 / n;
    const double weight[] = {1.0, -2.0, 0.0};
    const double energy = h * sqrt(sum_fine(energy_density, w, FINE));
    for (int r = 0; r < N_RULE; r++) {
        double node[65], u[65], sum = 0.0;
        for (int i = FINE - 1; i >= 0; i--) {
            const double x = (i + 0.5) / FINE, beta = exp(x);
            const double u1 = 2.0 * cos(2.0 * x), u2 = -4.0 * sin(2.0 * x);
            /* sigma = 2 e^x cos 2x: sigma'' = 2 e^x (-3 cos 2x - 4 sin 2x) */
            const double sigma2 =
                -2.0 * beta * (3.0 * cos(2.0 * x) + 4.0 * sin(2.0 * x));
            const double slope =
                (2.0 * beta * u2 + weight[r] * (u1 * beta + sigma2 - 6.0)) /
                (24.0 * beta);
            w[i] = sum - 0.5 * slope / FINE;
            sum -= slope / FINE;
        }
        const double L2 = h * h * sqrt(sum_fine(L2_density, w, FINE));
        poisson_grid(0.0, 1.0, n, 1.0, node);
        solve_smooth(n, node, r, u);
        const struct poisson_error error = poisson_errors(
            n, node, u, smooth_beta, smooth_exact, smooth_exact_dx);
        expect_close(error.L2, L2, 2e-3, L2,
                     "L2 error of the smooth problem, %s, h = %g", rule_name[r],
                     h);
        expect_close(error.energy, energy, 2e-3, energy,
                     "energy error of the smooth problem, %s, h = %g",
                     rule_name[r], h);
    }
}

/*
 * The three errors are h^2 w with a w that is linear in the rule's own error:
 * (2 midpoint + trapezoid) / 3 = Gauss at the nodes up to O(h^4), 16 times less
 * at half the h; 5 % for the next term at h = 1/16.
 */
static void midpoint_and_trapezoid_make_gauss(void)
{
    double largest[2] = {0.0, 0.0};
    for (int fine = 0; fine < 2; fine++) {
        enum { MOST = 32 };
        const int n = fine ? MOST : MOST / 2;
        double x[MOST + 1], u[3][MOST + 1];
        poisson_grid(0.0, 1.0, n, 1.0, x);
        for (int r = 0; r < N_RULE; r++) solve_smooth(n, x, r, u[r]);
        for (int j = 0; j <= n; j++) {
            const double off =
                fabs((2.0 * u[0][j] + u[1][j]) / 3.0 - u[2][j]);
            if (!(off <= largest[fine])) largest[fine] = off;
        }
    }
    expect_close(largest[0] / largest[1], 16.0, 0.05, 16.0,
                 "(2 midpoint + trapezoid) / 3 against Gauss: ratio of the "
                 "largest difference at h = 1/16 to that at h = 1/32");
}

/* The L2 error on n elements, unit flux and no load, where beta jumps from 1 to
 * 4 at 1/3 and the element there has the exact mean. */
static double jump_error(int n)
{
    enum { FINE = 12000 };
    const struct quadrature rule = quadrature_rule((enum rule)0);
    double x[129], mean[129], u[129], sum = 0.0;
    poisson_grid(0.0, 1.0, n, 1.0, x);
    for (int j = 1; j <= n; j++)
        mean[j] = fmin(4.0, fmax(1.0, 4.0 - 3.0 * (n / 3.0 - (j - 1))));
    for (int j = 0; j <= n; j++)
        u[j] = load_entry(j, n, x, field_zero, &rule, 0.0, 1.0);
    if (solve(n, x, mean, 0, u) != OK) return (double)NAN;
    for (int i = 0; i < FINE; i++) {
        const double at = (i + 0.5) / FINE, s = at * n - (int)(at * n);
        const double chord =
            (1.0 - s) * u[(int)(at * n)] + s * u[(int)(at * n) + 1];
        const double exact = at < 1.0 / 3.0 ? at : 0.25 + 0.25 * at;
        sum += (chord - exact) * (chord - exact) / FINE;
    }
    return sqrt(sum);
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    double x[129], u[129], L2[3];
    measured("1a", cell(output, "exactness", "midpoint", 2));
    measured("1b", cell(output, "exactness", "trapezoid", 2));
    poisson_grid(0.0, 1.0, 128, 1.0, x);
    for (int r = 0; r < 3; r++) {
        solve_smooth(128, x, r, u);
        L2[r] = poisson_errors(128, x, u, smooth_beta, smooth_exact,
                               smooth_exact_dx).L2;
    }
    measured("2", L2[1] / L2[2]);
    measured("3", log2(jump_error(32) / jump_error(128)) / 2.0);
}

static const struct claim claims[] = {
    {"rules_have_their_degree_of_exactness",
     rules_have_their_degree_of_exactness, "6a"},
    {"element_integrals_of_polynomials_are_exact",
     element_integrals_of_polynomials_are_exact, "6b"},
    {"element_errors_have_their_constants", element_errors_have_their_constants,
     "6b"},
    {"rows_of_A_add_up_to_zero", rows_of_A_add_up_to_zero, "6c"},
    {"linear_beta_gives_the_oracles_matrix",
     linear_beta_gives_the_oracles_matrix, "6c"},
    {"one_element_has_both_ends", one_element_has_both_ends, "6c"},
    {"load_is_the_oracles", load_is_the_oracles, "6d"},
    {"loads_add_up_to_force_and_fluxes", loads_add_up_to_force_and_fluxes,
     "6d"},
    {"same_as_element_assembly", same_as_element_assembly, "6d"},
    {"gsl_agrees_to_the_order_of_the_rule", gsl_agrees_to_the_order_of_the_rule,
     "6d"},
    {"total_loads_have_their_constants", total_loads_have_their_constants,
     "6d"},
    {"solution_has_the_orders_and_constants",
     solution_has_the_orders_and_constants, "6d"},
    {"midpoint_and_trapezoid_make_gauss", midpoint_and_trapezoid_make_gauss,
     "6b"},
};

static const char *const runs[] = {
    "",
    "--rule gauss2 --n 7 --grading 0.3714",
    "--rule trapezoid --n 11 --grading 3.714",
    "--n 5 --held left",
    "--n 1",
    "--n 2 --grading 2.385 --rule gauss2",
};

#define SUMS "sums of a few products"
#define SOLVE "direct solve, condition number below 1e6"
static const struct column_rule rules[] = {
    {"A", "j", 0, "a count", 0},
    {"A", "*", 1e-13, SUMS, 0},
    {"b", "j", 0, "a count", 0},
    {"b", "*", 1e-13, SUMS, 0},
    {"nodes", "*", 1e-9, SOLVE, 1.0},
    {"exactness", "degree", 0, "a count", 0},
    {"exactness", "*", 1e-14, SUMS, 1.0},
};

static const struct lesson lesson = {
    "06_quadrature",
    claims,
    COUNT(claims),
    runs,
    COUNT(runs),
    rules,
    COUNT(rules),
    "All three rules give L2 order 2 and energy order 1, and from h = 1/32 on "
    "their energy errors agree to 0.1 % (study kink, table `solution`): with "
    "linear elements the interpolation error is the larger one by far, so that "
    "one sample per element is enough.",
    "Let beta jump inside an element (study kink, table `jump`): integrating "
    "beta exactly is no better than sampling it, both have L2 order 1. The "
    "harmonic mean has 1.5. Why is 1/beta the function to average?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
