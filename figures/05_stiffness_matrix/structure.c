/*
 * structure.c - where are the numbers of A that are not zero?
 *
 * beta = 1, n elements with h_n / h_1 = 4 [eq:stiffness-row].  Counted in the
 * full array, so that nothing is taken for granted.
 */
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

int main(void)
{
    int as_due = 1;
    double worst = 0.0;

    table_begin_note("structure",
                     "n entries nonzeros half_bandwidth asymmetry row_sum",
                     "asymmetry and row_sum: of the largest entry");
    for (int n = 1; n <= 256; n *= 2) {
        const int N = n + 1;
        double *x = allocate((size_t)N, sizeof *x);
        double *b = allocate((size_t)N, sizeof *b);
        struct matrix *A = matrix_alloc(DENSE, N, 0);
        int nonzeros = 0, half_bandwidth = 0;
        double largest = 0.0, asymmetry = 0.0, row_sum = 0.0;

        poisson_grid(0.0, 1.0, n, 4.0, x);
        poisson_assemble(n, x, field_one, field_one, &MIDPOINT, A, b);
        for (int i = 0; i < N; i++) {
            double sum = 0.0;
            for (int j = 0; j < N; j++) {
                const double a = matrix_get(A, i, j);
                sum += a;
                largest = fmax(largest, fabs(a));
                asymmetry = fmax(asymmetry, fabs(a - matrix_get(A, j, i)));
                if (a == 0.0) continue;
                nonzeros++;
                if (abs(i - j) > half_bandwidth) half_bandwidth = abs(i - j);
            }
            row_sum = fmax(row_sum, fabs(sum));
        }
        table_row(n, (double)N * N, nonzeros, half_bandwidth,
                  asymmetry / largest, row_sum / largest);
        as_due &= nonzeros == 3 * n + 1 && half_bandwidth == 1;
        worst = fmax(worst, fmax(asymmetry, row_sum) / largest);
        matrix_free(A);
        free(x);
        free(b);
    }
    table_end();

    claim(as_due, "3 n + 1 numbers are not 0, on the diagonal or next to it");
    claim(worst < 1e-14, "A is symmetric and its rows add up to 0 (off by %g)",
          worst);
    return table_finish();
}
