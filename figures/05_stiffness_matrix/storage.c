/*
 * storage.c - what do dense and banded storage cost, in numbers kept, in flops,
 * and in seconds?
 *
 * -u'' = 1 with u = 0 at both ends on N nodes; matrix_cost() [eq:band-cost].
 * p = 1, the line, is our matrix; a square grid of N nodes in the plane has p =
 * sqrt(N).  Tables: counts, the same on every machine; seconds of this machine,
 * the best of several runs, of answers with a backward error of at most 16 eps;
 * and the exponents of the counts over the last factor 4.
 */
#include "base/clock.h"
#include "bar/poisson.h"
#include "linear/residual.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tables costs and growth, which holds the exponents. */
static void print_costs(double growth[7])
{
    const char *const names = "N dense_bytes line_bytes plane_bytes "
                              "dense_flops line_flops plane_flops";
    double before[7] = {0.0};

    table_begin_note("costs", names, "line: p = 1; plane: p = sqrt(N)");
    for (int N = 16, side = 4; side <= 512; N *= 4, side *= 2) {
        const struct matrix_cost dense = matrix_cost(DENSE, N, 0);
        const struct matrix_cost line = matrix_cost(BANDED, N, 1);
        const struct matrix_cost plane = matrix_cost(BANDED, N, side);
        const double row[] = {N, 8.0 * dense.numbers, 8.0 * line.numbers,
                              8.0 * plane.numbers, dense.flops, line.flops,
                              plane.flops};
        table_row_of(7, row);
        for (int c = 0; c < 7; c++)
            growth[c] = study_order(row[c], before[c], 4.0);
        memcpy(before, row, sizeof before);
    }
    table_end();
    table_begin_note("growth", names, "exponents; due: 1 2 1 1.5 3 1 2");
    table_row_of(7, growth);
    table_end();
}

/* One row: factor and solve on N nodes. */
static void time_solve(enum storage storage, int N)
{
    const int n = N - 1, ends[] = {0, n};
    const double zero[] = {0.0, 0.0};
    double *x = allocate((size_t)N, sizeof *x);
    double *b = allocate((size_t)N, sizeof *b);
    double *u = allocate((size_t)N, sizeof *u);
    struct matrix *A = matrix_alloc(storage, N, 1);
    struct times t = {0};
    double error = 0.0;

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, field_one, field_one, &MIDPOINT, A, b);
    matrix_dirichlet(A, b, 2, ends, zero, KEEP_DIAGONAL);
    const double begin = clock_seconds();
    while (t.runs < 3 || (t.runs < 100 && clock_seconds() - begin < 1e-3)) {
        struct matrix *L = matrix_copy(A);
        for (int j = 0; j < N; j++) u[j] = b[j];
        const double start = clock_seconds();
        if (matrix_factor(L) != OK) die("the matrix is not SPD");
        matrix_solve(L, u);
        times_record(&t, clock_seconds() - start, 1);
        matrix_free(L);
    }
    for (int j = 0; j < N; j++)
        error = fmax(error, fabs(u[j] - 0.5 * x[j] * (1.0 - x[j])));
    /* |b - A u| / (|A| |u|), in eps */
    const double residual =
        matrix_residual(A, u, b) / (4.0 * n * 0.125) / DBL_EPSILON;
    claim(residual <= 16.0, "the backward error is at most 16 eps (it is %g, "
          "N = %d)", residual, N);
    table_row(N, (double)matrix_bytes(A), matrix_cost(storage, N, 1).flops,
              times_best(&t), residual, error);
    matrix_free(A);
    free(x);
    free(b);
    free(u);
}

/* Table `name`: N = 16, 32, ..., largest. */
static void print_times(const char *name, enum storage kind, int largest)
{
    table_begin(name, "N bytes flops seconds residual error");
    for (int N = 16; N <= largest; N *= 2) time_solve(kind, N);
    table_end();
}

int main(void)
{
    const double due[7] = {1.0, 2.0, 1.0, 1.5, 3.0, 1.0, 2.0};
    double growth[7] = {0.0};

    study_machine();
    print_costs(growth);
    print_times("times_dense", DENSE, 512);
    print_times("times_banded", BANDED, 1 << 17);
    for (int c = 0; c < 7; c++)
        claim(fabs(growth[c] - due[c]) < 0.01,
              "the count in column %d grows like N^%g (it is N^%g)", c + 1,
              due[c], growth[c]);
    return table_finish();
}
