/* exercise.c - see exercise.h. */
#include "exercise.h"

#include "bar/poisson.h"

struct matrix *exercise_system(enum storage storage, int n, double x[],
                               double b[])
{
    struct matrix *A = matrix_alloc(storage, n + 1, 1);
    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
    bvp_boundary(n, A, b);
    return A;
}
