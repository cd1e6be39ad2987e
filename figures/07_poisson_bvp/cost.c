/*
 * cost.c - what does an error of 1e-4 cost, in each quantity of the exercise?
 *
 * Midpoint rule, so that n elements take n samples of f, and 10 n flops for the
 * band.  Table errors: the error in the energy norm, on equal elements and on
 * elements that each have the same share of it; in L2; at the worst node; of
 * the flux at x = 0 from the first slope and from the reaction [eq:reaction].
 * Table needed: the least number of elements with an error of at most 1e-4,
 * sought near what order and constant of the two finest grids predict.
 */
#include "bar/poisson.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

enum { ENERGY, GRADED, L2, NODAL, SLOPE, REACTION, QUANTITIES };
static const char *const NAME[QUANTITIES] = {"energy", "graded", "L2",
                                             "nodal",  "slope",  "reaction"};

/* |u''| sqrt(beta) to the power 2/3, to which short elements are due. */
static double density(double x)
{
    return pow((1.0 - x) * pow(1.0 + x, -2.5), 2.0 / 3.0);
}

/* Nodes between which the integral of the density is equal. */
static void graded_grid(int n, double x[])
{
    enum { FINE = 4000 };
    double sum[FINE + 1] = {0.0};
    for (int i = 0; i < FINE; i++)
        sum[i + 1] = sum[i] + density((i + 0.5) / FINE);
    for (int j = 0, i = 0; j <= n; j++) {
        const double wanted = sum[FINE] * j / n;
        while (i < FINE - 1 && sum[i + 1] < wanted) i++;
        x[j] = (i + (wanted - sum[i]) / (sum[i + 1] - sum[i])) / FINE;
    }
    x[n] = 1.0;
}

static void measure(int n, int graded, double error[QUANTITIES])
{
    const int left[] = {0};
    const double one = 1.0;
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *b = allocate((size_t)n + 1, sizeof *b);
    double *u = allocate((size_t)n + 1, sizeof *u);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    if (graded) graded_grid(n, x);
    poisson_assemble(n, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
    b[n] -= 0.5;
    for (int i = 0; i <= n; i++) u[i] = b[i];
    struct matrix *L = matrix_copy(A);
    matrix_dirichlet(L, u, 1, left, &one, KEEP_DIAGONAL);
    if (matrix_factor(L) != OK) die("A is not positive definite");
    matrix_solve(L, u);
    const struct poisson_error found =
        poisson_errors(n, x, u, bvp_beta, bvp_exact, bvp_exact_dx);
    error[graded ? GRADED : ENERGY] = found.energy;
    if (!graded) {
        error[L2] = found.L2;
        error[NODAL] = found.nodal;
        error[SLOPE] = fabs((u[1] - u[0]) / x[1]); /* beta(0) = 1 */
        error[REACTION] = fabs(matrix_get(A, 0, 0) * u[0] +
                               matrix_get(A, 0, 1) * u[1] - b[0]);
    }
    matrix_free(A);
    matrix_free(L);
    free(x);
    free(b);
    free(u);
}

static double error_of(int quantity, int n)
{
    double error[QUANTITIES];
    measure(n, quantity == GRADED, error);
    return error[quantity];
}

/* The least n whose error is at most 1e-4, sought from `near` on. */
static int least(int near, int quantity)
{
    int n = near;
    while (error_of(quantity, n) > 1e-4) n++;
    while (error_of(quantity, n - 1) <= 1e-4) n--;
    return n;
}

int main(void)
{
    double error[QUANTITIES], before[QUANTITIES] = {0.0}, order[QUANTITIES];
    int needed[QUANTITIES];
    const int last = 1024;

    table_begin("errors", "n flops energy graded L2 nodal slope reaction");
    for (int n = 4; n <= last; n *= 2) {
        const struct matrix_cost cost = matrix_cost(BANDED, n + 1, 1);
        measure(n, 0, error);
        measure(n, 1, error);
        table_row(n, cost.flops + cost.solve, error[ENERGY], error[GRADED],
                  error[L2], error[NODAL], error[SLOPE],
                  cell_rounded(4, error[REACTION]));
        for (int k = 0; k < QUANTITIES; k++) {
            order[k] = study_order(before[k], error[k], 2.0);
            before[k] = error[k];
        }
    }
    table_end();
    table_begin("needed", "quantity order elements");
    for (int k = 0; k < QUANTITIES; k++) {
        const double near = last * pow(error[k] / 1e-4, 1.0 / order[k]);
        needed[k] = least((int)ceil(near), k);
        table_row(NAME[k], cell_rounded(3, order[k]), needed[k]);
        claim(fabs(order[k] - (k == ENERGY || k == GRADED || k == SLOPE
                                   ? 1.0 : 2.0)) < 0.01,
              "%s has order 1 or 2 (%g)", NAME[k], order[k]);
    }
    table_end();
    claim(needed[SLOPE] > 150 * needed[REACTION], "the reaction needs 150 "
          "times fewer elements than the slope (%d, %d)", needed[REACTION],
          needed[SLOPE]);
    claim(error[GRADED] < 0.8 * error[ENERGY], "elements where they are due "
          "are a fifth better (%g, %g)", error[GRADED], error[ENERGY]);
    return table_finish();
}
