/*
 * solution.c - where is the error, at the nodes or between them?
 *
 * The exercise on four elements: u_h and u - u_h at 32 points per element, the
 * load by the midpoint rule, or fitted (fitted.h), which is exact at the nodes
 * and not between them.
 */
#include "fitted.h"
#include "../08_element_assembly/exercise.h"
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { N = 4, STEPS = 32 };

static void solve(int fitted, const double x[], double u[])
{
    struct matrix *A = matrix_alloc(BANDED, N + 1, 1);
    if (fitted)
        fitted_assemble(N, x, A, u);
    else
        poisson_assemble(N, x, bvp_beta, bvp_f, &MIDPOINT, A, u);
    exercise_boundary(N, A, u);
    if (matrix_factor(A) != OK) die("A is not positive definite");
    matrix_solve(A, u);
    matrix_free(A);
}

/* The piecewise linear function on element e, 0 <= t <= 1. */
static double along(const double v[], int e, double t)
{
    return v[e] + t * (v[e + 1] - v[e]);
}

int main(void)
{
    double x[N + 1], u[N + 1], v[N + 1], at_nodes[2] = {0.0, 0.0};
    double between = 0.0;

    poisson_grid(0.0, 1.0, N, 1.0, x);
    solve(0, x, u);
    solve(1, x, v);
    table_begin("nodes", "x u exact");
    for (int j = 0; j <= N; j++) {
        table_row(x[j], u[j], bvp_exact(x[j]));
        at_nodes[0] = fmax(at_nodes[0], fabs(bvp_exact(x[j]) - u[j]));
        at_nodes[1] = fmax(at_nodes[1], fabs(bvp_exact(x[j]) - v[j]));
    }
    table_end();
    table_begin("curve", "x uh exact error fitted_error");
    for (int e = 0; e < N; e++) {
        const int last = e < N - 1 ? STEPS - 1 : STEPS; /* x = 1 as well */
        for (int k = 0; k <= last; k++) {
            const double t = (double)k / STEPS;
            const double at = along(x, e, t), uh = along(u, e, t);
            const double exact = bvp_exact(at);
            table_row(at, uh, exact, exact - uh, exact - along(v, e, t));
            between = fmax(between, fabs(exact - along(v, e, t)));
        }
    }
    table_end();

    claim(at_nodes[0] > 8e-4, "the midpoint rule is seen at the nodes (%g)",
          at_nodes[0]);
    claim(at_nodes[1] < 1e-14 && between > 1e-3,
          "fitted: exact at every node (%g), not between them (%g)",
          at_nodes[1], between);
    return table_finish();
}
