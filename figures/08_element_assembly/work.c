/*
 * work.c - what does the same answer cost with dense and with banded storage?
 *
 * The exercise on n equal elements, by both: flops of factorisation and solves
 * [eq:cholesky-flops], numbers that are kept, and the L2 error [eq:norm-L2].
 * No machine changes this part of the chart.
 */
#include "poisson.h"
#include "study.h"
#include "table.h"

#include <math.h>
#include <stdlib.h>

/* A and b of n equal elements, u(0) = 1 and the flux -1/2 at x = 1. */
static struct matrix *system_of(enum storage storage, int n, double x[],
                                double b[])
{
    const int left[] = {0};
    const double one[] = {1.0};
    struct matrix *A = matrix_alloc(storage, n + 1, 1);
    grid_make(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
    b[n] -= 0.5;
    matrix_dirichlet(A, b, 1, left, one, KEEP_DIAGONAL);
    return A;
}

/* Flops of the two triangular solves: 2 (2 m + 1) for a column of L with m
 * entries below the diagonal, p N - p (p + 1) / 2 of them in all. */
static double solve_flops(double N, double p)
{
    return 4.0 * (N * p - p * (p + 1.0) / 2.0) + 2.0 * N;
}

int main(void)
{
    double flops[2] = {0.0, 0.0}, entries[2], L2[2] = {0.0, 0.0}, apart = 0.0;

    table_begin("work", "n flops_dense flops_banded entries_dense "
                        "entries_banded L2_dense L2_banded");
    for (int n = 4; n <= 256; n *= 2) {
        for (int storage = DENSE; storage <= BANDED; storage++) {
            double *x = allocate(2 * ((size_t)n + 1), sizeof *x);
            double *u = x + n + 1;
            struct matrix *A = system_of((enum storage)storage, n, x, u);
            const struct matrix_cost cost =
                matrix_cost(A->storage, n + 1, A->p);
            flops[storage] = cost.flops + solve_flops(n + 1, A->p);
            entries[storage] = cost.numbers;
            if (matrix_factor(A) != OK) die("A is not positive definite");
            matrix_solve(A, u);
            L2[storage] = poisson_errors(n, x, u, bvp_beta, bvp_exact,
                                         bvp_exact_dx).L2;
            matrix_free(A);
            free(x);
        }
        apart = fmax(apart, fabs(L2[0] / L2[1] - 1.0));
        table_row(n, flops[0], flops[1], entries[0], entries[1], L2[0], L2[1]);
    }
    table_end();
    /* round-off: condition number 1e5 times eps, over an error of 5e-7 */
    claim(apart < 1e-5, "both storages give one error (relative difference %g)",
          apart);
    claim(flops[0] > 2000.0 * flops[1], "with 256 elements dense pays 2000 "
          "times the flops (%g)", flops[0] / flops[1]);
    return table_finish();
}
