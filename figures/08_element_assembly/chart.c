/*
 * chart.c - what does an accuracy cost?
 *
 * The exercise on n equal elements, factor + solve, with dense and with banded
 * storage: L2 error [eq:norm-L2] against seconds and against flops
 * [eq:cholesky-flops].  The rules of a chart: a run that is not valid has no
 * time; one problem and one knob (n) per curve; work is counted beside the
 * seconds; machine and flags are named; the best of several repeats counts.
 */
#include "exercise.h"
#include "base/clock.h"
#include "bar/poisson.h"
#include "linear/residual.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 5, DENSE_TO = 512, BANDED_TO = 1 << 17 };

struct point {
    double seconds, backward, L2; /* NAN where there is none */
    int valid;
};

/* Valid: factored, backward error at most 20 eps, and L2 at most 0.1 / n^2 (the
 * midpoint rule has 0.032) plus round-off N^2 eps. */
static struct point measured(enum storage storage, int n)
{
    const double N = n + 1.0;
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *b = allocate((size_t)n + 1, sizeof *b);
    double *u = allocate((size_t)n + 1, sizeof *u);
    struct matrix *A = exercise_system(storage, n, x, b);
    struct point point = {(double)NAN, (double)NAN, (double)NAN, 1};
    static struct times t;

    t.runs = 0;
    for (int k = 0; k < REPEATS && point.valid; k++) {
        struct matrix *L = matrix_copy(A);
        memcpy(u, b, (size_t)A->n * sizeof *u);
        const double start = clock_seconds();
        point.valid = matrix_factor(L) == OK;
        if (point.valid) matrix_solve(L, u);
        times_record(&t, clock_seconds() - start, point.valid);
        matrix_free(L);
    }
    if (point.valid) {
        point.backward = matrix_backward_error(A, u, b);
        point.L2 =
            poisson_errors(n, x, u, bvp_beta, bvp_exact, bvp_exact_dx).L2;
        point.valid = point.backward <= 20.0 &&
                      point.L2 <= 0.1 / n / n + N * N * DBL_EPSILON;
    }
    if (point.valid) point.seconds = times_best(&t);
    matrix_free(A);
    free(x);
    free(b);
    free(u);
    return point;
}

/* n doubles as far as seconds allow, most of all the dense ones.  roundoff: a
 * doubling of n no longer halves the error. */
static void print_curve(enum storage storage)
{
    double before = INFINITY;
    int roundoff = 0;
    table_begin(storage == DENSE ? "chart_dense" : "chart_banded",
                "n flops seconds L2 backward_eps valid roundoff");
    for (int n = 8; n <= (storage == DENSE ? DENSE_TO : BANDED_TO); n *= 2) {
        const struct point point = measured(storage, n);
        const struct matrix_cost cost = matrix_cost(storage, n + 1, 1);
        if (point.valid && point.L2 > 0.5 * before) roundoff = 1;
        if (point.valid) before = point.L2;
        table_row(n, cost.flops + cost.solve,
                  cell_if(point.valid, point.seconds),
                  cell_if(point.valid, point.L2),
                  cell_if(point.valid, point.backward),
                  point.valid ? "yes" : "no", roundoff ? "yes" : "no");
        /* free of round-off on any machine */
        claim(n > 1024 || fabs(point.L2 * n * n / 0.0318 - 1.0) < 0.02,
              "n = %d: L2 is 0.0318 / n^2 to 2 %%", n);
    }
    table_end();
}

int main(void)
{
    study_machine();
    print_curve(DENSE);
    print_curve(BANDED);
    return table_finish();
}
