/*
 * pinned.c - what does a pinned node do to a system that has no solution?
 *
 * -u'' = e^x with flux 0 at x = 0 and -(e - 1) plus an excess at x = 1, four
 * elements, midpoint rule: b is not compatible [eq:neumann-compatibility], with
 * the excess the problem is not either.  The equation of node k is replaced by
 * u_k = 0.  Table: the point load at the node that this amounts to; how far the
 * answer is from the u of least norm of the projected system, and from the
 * exact solution, both in the energy norm and relative to that of u.
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { n = 4, N = n + 1 };

static double exact(double x)
{
    return x - exp(x);
}
static double exact_dx(double x)
{
    return 1.0 - exp(x);
}

/* A v = b with equation k replaced by v_k = 0. */
static void solve_pinned(const struct matrix *A, const double b[N], int k,
                         double v[N])
{
    const double zero = 0.0;
    struct matrix *L = matrix_copy(A);
    for (int i = 0; i < N; i++) v[i] = b[i];
    matrix_dirichlet(L, v, 1, &k, &zero, KEEP_DIAGONAL);
    if (matrix_factor(L) != OK) die("the pinned matrix is not SPD");
    matrix_solve(L, v);
    matrix_free(L);
}

static double energy_norm(const struct matrix *A, const double v[N])
{
    double Av[N], sum = 0.0;
    matrix_multiply(A, v, Av);
    for (int i = 0; i < N; i++) sum += v[i] * Av[i];
    return sqrt(sum);
}

int main(void)
{
    const int nodes[] = {0, n / 2, n};
    const double excess[] = {0.0, 0.1}; /* flux that no load balances */
    double x[N], b[N], c[N], u[N], v[N], Av[N];
    double sum = 0.0, off = 0.0, difference[2][3];
    struct matrix *A = matrix_alloc(BANDED, N, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, field_one, exp, &MIDPOINT, A, b);
    b[n] -= expm1(1.0);
    for (int i = 0; i < N; i++) sum += b[i];
    for (int i = 0; i < N; i++) c[i] = b[i] - sum / N;
    solve_pinned(A, c, 0, u); /* the constant in u has no energy */
    const double size = energy_norm(A, u);

    table_begin_note("pinned", "excess node x reaction difference error",
                     "b is not projected; excess is added to the flux at 1");
    for (int e = 0; e < 2; e++)
        for (int k = 0; k < 3; k++) {
            const int node = nodes[k];
            for (int i = 0; i < N; i++) c[i] = b[i];
            c[n] += excess[e];
            solve_pinned(A, c, node, v);
            matrix_multiply(A, v, Av);
            const double reaction = Av[node] - c[node];
            const double error =
                poisson_errors(n, x, v, field_one, exact, exact_dx).energy /
                size;
            for (int i = 0; i < N; i++) v[i] -= u[i];
            difference[e][k] = energy_norm(A, v) / size;
            table_row(excess[e], node, x[node], reaction, difference[e][k],
                      error);
            off = fmax(off, fabs(reaction + sum + excess[e]));
        }
    table_end();
    matrix_free(A);

    claim(off < 1e-12, "the reaction is minus the whole defect (off by %g)",
          off);
    claim(difference[1][0] > 30.0 * difference[1][2] &&
              fabs(difference[1][2] - difference[0][2]) < 1e-9,
          "with excess flux the answer depends on the pinned node, and pinned "
          "at x = 1 it looks as if there were none (%g, %g, %g)",
          difference[1][0], difference[1][1], difference[1][2]);
    return table_finish();
}
