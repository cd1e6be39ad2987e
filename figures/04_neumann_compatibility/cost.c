/*
 * cost.c - which accuracy do more samples of the load, or a projection, buy?
 *
 * The scene, -u'' = e^x with two fluxes, on n elements.  Table: samples of f,
 * flops of the tridiagonal solve and of the pseudo-inverse (about 9 N^3 for its
 * eigenvectors), and the error in the energy norm, relative to the
 * solution's: b by the midpoint rule or by two Gauss points, projected; by the
 * midpoint rule, not projected, a node pinned; and with a flux of 0.1 too much.
 *
 * Source of 9 N^3: Golub & Van Loan, Matrix Computations, 4th ed., sec. 8.3.
 */
#include "bar/poisson.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

static const struct way {
    const char *name;
    const struct quadrature *rule;
    int project;
    double excess; /* flux that no load balances */
} WAY[] = {{"midpoint", &MIDPOINT, 1, 0.0},
           {"gauss2", &GAUSS2, 1, 0.0},
           {"pinned", &MIDPOINT, 0, 0.0},
           {"excess", &MIDPOINT, 0, 0.1}};

static double exact(double x)
{
    return x - exp(x);
}
static double exact_dx(double x)
{
    return 1.0 - exp(x);
}

/* The energy error with node 0 pinned, which changes u by a constant only. */
static double error_of(const struct way *way, int n)
{
    const int node = 0;
    const double zero = 0.0;
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *u = allocate((size_t)n + 1, sizeof *u);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, field_one, exp, way->rule, A, u);
    u[n] += way->excess - expm1(1.0);
    double defect = 0.0;
    for (int i = 0; i <= n; i++) defect += u[i];
    const double shift = way->project ? defect / (n + 1) : 0.0;
    for (int i = 0; i <= n; i++) u[i] -= shift;
    matrix_dirichlet(A, u, 1, &node, &zero, KEEP_DIAGONAL);
    if (matrix_factor(A) != OK) die("the pinned matrix is not SPD");
    matrix_solve(A, u);
    const double error =
        poisson_errors(n, x, u, field_one, exact, exact_dx).energy;
    matrix_free(A);
    free(x);
    free(u);
    /* int (1 - e^x)^2 = 1 - 2 (e - 1) + (e^2 - 1) / 2 */
    return error / sqrt(1.0 - 2.0 * expm1(1.0) + 0.5 * expm1(2.0));
}

int main(void)
{
    enum { MID, GAUSS, PINNED, EXCESS };
    double error[4] = {0.0}, least = INFINITY, apart = 0.0;

    table_begin("cost", "way n samples flops pseudo_inverse error");
    for (int k = 0; k < COUNT(WAY); k++)
        for (int n = 4; n <= 1024; n *= 4) {
            const struct matrix_cost cost = matrix_cost(BANDED, n + 1, 1);
            error[k] = error_of(&WAY[k], n);
            table_row(WAY[k].name, n, n * WAY[k].rule->n,
                      cost.flops + cost.solve, 9.0 * gsl_pow_3(n + 1.0),
                      cell_rounded(6, error[k]));
            if (k == EXCESS) least = fmin(least, error[k]);
            const double plain = error_of(&WAY[MID], n);
            if (k == GAUSS) apart = fmax(apart, fabs(error[k] / plain - 1.0));
        }
    table_end();
    claim(apart < 1e-2 && fabs(error[PINNED] / error[MID] - 1.0) < 1e-2,
          "neither Gauss points nor the projection change the energy error "
          "(by %g)", apart);
    claim(least > 0.1, "a flux that nothing balances is an error that no mesh "
          "mends (%g)", least);
    return table_finish();
}
