/* exercise.c - see exercise.h. */
#include "exercise.h"

#include "bar/poisson.h"

void exercise_boundary(int n, struct matrix *A, double b[])
{
    const int left[] = {0};
    const double value[] = {1.0};
    b[n] -= 0.5;
    matrix_dirichlet(A, b, 1, left, value, KEEP_DIAGONAL);
}

struct matrix *exercise_system(enum storage storage, int n, double x[],
                               double b[])
{
    struct matrix *A = matrix_alloc(storage, n + 1, 1);
    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
    exercise_boundary(n, A, b);
    return A;
}
