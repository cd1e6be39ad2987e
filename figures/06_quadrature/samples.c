/*
 * samples.c - what do samples buy in a solution?
 *
 * The L2 error of the smooth problem on n elements, by three rules
 * [eq:quadrature]: the midpoint rule takes n samples, the trapezoidal rule
 * n + 1 and Gauss 2 n.
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

enum { FINEST = 256 };

/* u - u_h of -(e^x u')' = f, u = sin 2x, in L2, on n equal elements. */
static double solution_error(int n, const struct quadrature *rule)
{
    double x[FINEST + 1], u[FINEST + 1];
    const double end = smooth_exact(1.0);
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, smooth_beta, smooth_f, rule, A, u);
    u[0] -= smooth_exact_dx(0.0); /* the flux, and beta = 1 there */
    matrix_dirichlet(A, u, 1, &n, &end, KEEP_DIAGONAL);
    if (matrix_factor(A) != OK) die("the matrix is not SPD");
    matrix_solve(A, u);
    matrix_free(A);
    return poisson_errors(n, x, u, smooth_beta, smooth_exact, smooth_exact_dx)
        .L2;
}

int main(void)
{
    table_begin("solution", "n midpoint trapezoid gauss2");
    for (int n = 4; n <= FINEST; n *= 2)
        table_row(n, solution_error(n, &MIDPOINT),
                  solution_error(n, &TRAPEZOID), solution_error(n, &GAUSS2));
    table_end();
    for (int n = 8; n <= FINEST; n *= 2)
        claim(solution_error(n, &MIDPOINT) < solution_error(n / 2, &GAUSS2) &&
                  solution_error(n, &MIDPOINT) < solution_error(n, &TRAPEZOID),
              "for the same samples the midpoint rule is the best");
    return table_finish();
}
