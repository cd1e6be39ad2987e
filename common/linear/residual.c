/* residual.c - see residual.h. */
#include "linear/residual.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

double matrix_residual(const struct matrix *A, const double x[],
                       const double b[])
{
    double *r = allocate((size_t)A->n, sizeof *r);
    double largest = 0.0;
    matrix_multiply(A, x, r);
    for (int i = 0; i < A->n; i++) {
        const double size = fabs(b[i] - r[i]);
        if (isnan(size) || size > largest) largest = size; /* NaN stays */
    }
    free(r);
    return largest;
}

double matrix_backward_error(const struct matrix *A, const double u[],
                             const double b[])
{
    double norm_A = 0.0, norm_u = 0.0, norm_b = 0.0;
    for (int i = 0; i < A->n; i++) {
        const int last = i + A->p < A->n ? i + A->p : A->n - 1;
        double sum = 0.0;
        for (int j = i > A->p ? i - A->p : 0; j <= last; j++)
            sum += fabs(matrix_get(A, i, j));
        norm_A = fmax(norm_A, sum); /* largest row sum of |A_ij| */
        norm_u = fmax(norm_u, fabs(u[i]));
        norm_b = fmax(norm_b, fabs(b[i]));
    }
    return matrix_residual(A, u, b) /
           (DBL_EPSILON * (norm_A * norm_u + norm_b));
}
