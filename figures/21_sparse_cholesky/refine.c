/* refine.c - see refine.h. */
#include "refine.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double largest(int n, const double v[])
{
    double bound = 0.0;
    for (int i = 0; i < n; i++)
        if (!(fabs(v[i]) <= bound)) bound = fabs(v[i]); /* NaN as well */
    return bound;
}

enum status refine_solve(const struct matrix *A, double tolerance, double b[],
                         int *solves)
{
    const size_t n = (size_t)A->n;
    double *x = allocate(n, sizeof *x), *r = allocate(n, sizeof *r);
    double *Ax = allocate(n, sizeof *Ax);
    const double b_size = largest(A->n, b), scale = matrix_max_diagonal(A);
    double size = b_size, goal = 0.0, before = INFINITY;
    enum status status = OK;
    int turn = 0;
    assert(A->storage == SPARSE); /* the others have lost A */
    memcpy(r, b, n * sizeof *r);
    for (; !(size <= goal) && status == OK; turn++, before = size) {
        matrix_solve(A, r);
        for (size_t i = 0; i < n; i++) x[i] += r[i];
        matrix_multiply(A, x, Ax);
        for (size_t i = 0; i < n; i++) r[i] = b[i] - Ax[i];
        size = largest(A->n, r);
        goal = tolerance * (scale * largest(A->n, x) + b_size);
        if (!isfinite(size)) status = NONFINITE;
        else if (size > goal && size > 0.5 * before) status = STALLED;
    }
    memcpy(b, x, n * sizeof *b);
    if (solves) *solves = turn;
    free(x);
    free(r);
    free(Ax);
    return status;
}
