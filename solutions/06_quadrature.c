/*
 * 06_quadrature.c - A and b for any beta, f and q, by a rule on each element.
 *
 * Notes: Lecture 2, section 1.1, exercise (4).
 *
 * Problem.  -(e^x u')' = f on (0, 1) with the solution u = sin 2x, given at one
 * end, and the flux at the other.  Linear elements on an unequal grid; each row
 * of A and b belongs to one vertex, and its integrals are taken by the midpoint
 * rule, the trapezoidal rule or two-point Gauss on each element.
 *
 *     hat e_j of vertex j:    RISING /|\ FALLING
 *                                   / | \
 *                                  /  |  \            element j joins the
 *       -----+--------------------+---+---+-----      vertices j - 1 and j
 *           ...               j - 1   j   j + 1
 *
 * Run       make lesson-06; make lesson-06 ARGS=-h lists its options
 * PREDICT 1a integral of s^2 over (0, 1) less the midpoint rule: ...
 * PREDICT 1b and less the trapezoidal rule: ...
 * PREDICT 2 L2 error of the worst rule over that of the best: ...
 * PREDICT 3 order in L2, beta jumps and is integrated exactly: ...
 * Plot: nodes x u
 */
#include "base/options.h"
#include "bar/poisson.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

enum end { LEFT, RIGHT };
enum rule { MIDPOINT_RULE, TRAPEZOID_RULE, GAUSS2_RULE, N_RULE };

/* What multiplies g in an integral over an element; s runs from 0 to 1. */
enum shape { ONE, RISING, FALLING }; /* 1, s, 1 - s */

/* The points s and weights w on (0, 1) [eq:quadrature]. */
static struct quadrature quadrature_rule(enum rule rule)
{
    struct quadrature points = {0};
    /* SLOT 6a(rule): given one of the three rules, fill points.n, points.s and
     * points.w; the interval is (0, 1), so the weights add up to 1. */
    switch (rule) {
    case MIDPOINT_RULE:
        points = (struct quadrature){1, {0.5}, {1.0}};
        break;
    case TRAPEZOID_RULE:
        points = (struct quadrature){2, {0.0, 1.0}, {0.5, 0.5}};
        break;
    default: {
        /* Gauss: -+ 1/sqrt(3) on (-1, 1), which is twice as long */
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
    /* SLOT 6b(x0, x1, g, shape, rule): given g, let sum be the integral: each
     * point of the rule adds its weight times g there times the shape. */
    const double h = x1 - x0;
    for (int k = 0; k < rule->n; k++) {
        const double s = rule->s[k];
        const double phi = shape == ONE ? 1.0 : shape == RISING ? s : 1.0 - s;
        /* dx = h ds */
        sum += h * rule->w[k] * g(x0 + s * h) * phi;
    }
    /* END 6b */
    return sum;
}

/* row[0..2] := A_{j,j-1}, A_jj, A_{j,j+1} before any boundary condition, 0
 * where there is no such neighbour; mean[j] is that of beta on element j. */
static void stiffness_row(int j, int n, const double x[], const double mean[],
                          double row[3])
{
    row[0] = row[1] = row[2] = 0.0;
    /* SLOT 6c(j, n, x, mean, row): given the means, fill row: the element on
     * the left of vertex j, then that on its right, if there is one. */
    /* e_{j-1}' = -1/h, e_j' = 1/h: mean h (1/h)(1/h) = mean / h */
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

/* b_j, with the fluxes qa and qb prescribed at the ends. */
static double load_entry(int j, int n, const double x[], field *f,
                         const struct quadrature *rule, double qa, double qb)
{
    double b = 0.0;
    /* SLOT 6d(j, n, x, f, rule, qa, qb): given f and fluxes, let b be f against
     * the two halves of the hat e_j, or one half with its flux at an end. */
    /* e_j rises on the element on its left and falls on the other */
    if (j > 0) b += element_integral(x[j - 1], x[j], f, RISING, rule);
    if (j < n) b += element_integral(x[j], x[j + 1], f, FALLING, rule);
    if (j == 0) b += qa;
    if (j == n) b += qb;
    /* END 6d */
    return b;
}

/* mean[j], j = 1..n, is the mean of beta over element j; mean[0] is 0. */
static void element_means(int n, const double x[], field *beta,
                          const struct quadrature *rule, double mean[])
{
    mean[0] = 0.0;
    for (int j = 1; j <= n; j++)
        mean[j] = element_integral(x[j - 1], x[j], beta, ONE, rule) /
                  (x[j] - x[j - 1]);
}

/* u := A^{-1} b, b in u; at node `held` u is given as sin 2x. */
static enum status solve(int n, const double x[], const double mean[], int held,
                         double u[])
{
    const double given = smooth_exact(x[held]);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    for (int j = 0; j <= n; j++) {
        double row[3];
        stiffness_row(j, n, x, mean, row);
        for (int k = 0; k < 3; k++)
            if (j + k >= 1 && j + k <= n + 1)
                matrix_add(A, j, j + k - 1, row[k]);
    }
    matrix_dirichlet(A, u, 1, &held, &given, KEEP_DIAGONAL);
    const enum status status = matrix_factor(A);
    if (status == OK) matrix_solve(A, u);
    matrix_free(A);
    return status;
}

/* The error of each rule on the monomials: int s^degree ds less the rule. */
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

static void print_A(int n, const double x[], const double mean[])
{
    table_begin("A", "j lower diagonal upper");
    for (int j = 0; j <= n; j++) {
        double row[3];
        stiffness_row(j, n, x, mean, row);
        table_row(j, cell_if(j > 0, row[0]), row[1], cell_if(j < n, row[2]));
    }
    table_end();
}

int main(int argc, char *argv[])
{
    int n = 6, kind = MIDPOINT_RULE, held = RIGHT;
    double grading = 2.385;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 5000, .help = "elements"},
        {"grading", .real = &grading, .min = 1e-3, .max = 1e3,
         .help = "length of the last element over that of the first"},
        {"rule", .choice = &kind, .choices = "midpoint trapezoid gauss2",
         .help = "quadrature"},
        {"held", .choice = &held, .choices = "left right",
         .help = "the end where u is given; the other has the flux"},
    };
    options_parse("06_quadrature", options, COUNT(options), argc, argv);

    const struct quadrature rule = quadrature_rule((enum rule)kind);
    const double qa = held == LEFT ? 0.0 : -2.0; /* beta u' n */
    const double qb = held == LEFT ? 2.0 * exp(1.0) * cos(2.0) : 0.0;
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *mean = allocate((size_t)n + 1, sizeof *mean);
    double *u = allocate((size_t)n + 1, sizeof *u);
    poisson_grid(0.0, 1.0, n, grading, x);
    element_means(n, x, smooth_beta, &rule, mean);

    print_exactness();
    print_A(n, x, mean);
    table_begin("b", "j b");
    for (int j = 0; j <= n; j++) {
        u[j] = load_entry(j, n, x, smooth_f, &rule, qa, qb);
        table_row(j, u[j]);
    }
    table_end();
    const enum status status = solve(n, x, mean, held == LEFT ? 0 : n, u);
    if (status != OK) die("the matrix is %s", status_name(status));
    table_begin("nodes", "x u exact");
    for (int j = 0; j <= n; j++) table_row(x[j], u[j], smooth_exact(x[j]));
    table_end();
    free(x);
    free(mean);
    free(u);
    return table_finish();
}
