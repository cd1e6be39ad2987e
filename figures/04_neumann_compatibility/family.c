/*
 * family.c - how do the solutions of a compatible system differ, and how not?
 *
 * -u'' = e^x with flux 0 at x = 0 and -(e - 1) at x = 1, four elements,
 * midpoint rule; b is projected and one node pinned.  Tables: three members of
 * the family u + c [eq:neumann-family] and the exact x - e^x + C of the same
 * nodal mean; their energy v^T A v [eq:quadratic-form], norm and integral.
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { n = 4, N = n + 1 };
static const double shift[] = {-0.3, 0.0, 0.3};

/* v[i] -= the mean of v. */
static void subtract_mean(double v[N])
{
    double mean = 0.0;
    for (int i = 0; i < N; i++) mean += v[i] / N;
    for (int i = 0; i < N; i++) v[i] -= mean;
}

int main(void)
{
    const int node[] = {0};
    const double zero[] = {0.0};
    double x[N], u[N], exact[N], norm[3], energy[3];
    struct matrix *A = matrix_alloc(BANDED, N, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, field_one, exp, &MIDPOINT, A, u);
    u[n] -= expm1(1.0);
    subtract_mean(u); /* b, made compatible */
    struct matrix *L = matrix_copy(A);
    matrix_dirichlet(L, u, 1, node, zero, KEEP_DIAGONAL);
    if (matrix_factor(L) != OK) die("the pinned matrix is not SPD");
    matrix_solve(L, u);
    subtract_mean(u); /* the solution of least norm */
    for (int i = 0; i < N; i++) exact[i] = x[i] - exp(x[i]);
    subtract_mean(exact);

    table_begin_note("family", "x below minimum_norm above exact",
                     "below, above: c = %g, %g", shift[0], shift[2]);
    for (int i = 0; i < N; i++)
        table_row(x[i], u[i] + shift[0], u[i], u[i] + shift[2], exact[i]);
    table_end();

    table_begin("norms", "c energy nodal_norm integral_mean");
    for (int k = 0; k < 3; k++) {
        double w[N], Aw[N], squares = 0.0, mean = 0.0;
        for (int i = 0; i < N; i++) {
            w[i] = u[i] + shift[k];
            squares += w[i] * w[i];
            if (i > 0) mean += 0.5 * (x[i] - x[i - 1]) * (w[i - 1] + w[i]);
        }
        matrix_multiply(A, w, Aw);
        energy[k] = 0.0;
        for (int i = 0; i < N; i++) energy[k] += w[i] * Aw[i];
        norm[k] = sqrt(squares);
        table_row(shift[k], energy[k], norm[k], mean);
    }
    table_end();
    matrix_free(A);
    matrix_free(L);

    claim(fabs(energy[0] - energy[1]) + fabs(energy[2] - energy[1]) <
              1e-12 * energy[1],
          "all members have one energy (%g, %g, %g)", energy[0], energy[1],
          energy[2]);
    /* |u + c|^2 = |u|^2 + N c^2 when sum_i u_i = 0 */
    for (int k = 0; k < 3; k++)
        claim(fabs(norm[k] - hypot(norm[1], sqrt(N) * shift[k])) <
                  1e-12 * norm[1],
              "the member with nodal mean 0 has the smallest norm (c = %g)",
              shift[k]);
    return table_finish();
}
