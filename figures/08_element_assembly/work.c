/*
 * work.c - what does the same answer cost with dense and with banded storage?
 *
 * The exercise on n equal elements, by both: flops of factorisation and solves
 * [eq:cholesky-flops], numbers that are kept, and the L2 error [eq:norm-L2].
 * No machine changes this part of the chart.
 */
#include "exercise.h"
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

int main(void)
{
    double flops[2] = {0.0, 0.0}, entries[2], L2[2] = {0.0, 0.0}, apart = 0.0;

    table_begin("work", "n flops_dense flops_banded entries_dense "
                        "entries_banded L2_dense L2_banded");
    for (int n = 4; n <= 256; n *= 2) {
        for (int storage = DENSE; storage <= BANDED; storage++) {
            double *x = allocate((size_t)n + 1, sizeof *x);
            double *u = allocate((size_t)n + 1, sizeof *u);
            struct matrix *A = exercise_system((enum storage)storage, n, x, u);
            const struct matrix_cost cost =
                matrix_cost(A->storage, n + 1, A->p);
            flops[storage] = cost.flops + cost.solve;
            entries[storage] = cost.numbers;
            if (matrix_factor(A) != OK) die("A is not positive definite");
            matrix_solve(A, u);
            L2[storage] = poisson_errors(n, x, u, bvp_beta, bvp_exact,
                                         bvp_exact_dx).L2;
            matrix_free(A);
            free(x);
            free(u);
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
