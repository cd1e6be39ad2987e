/* frequency.c - see frequency.h. */
#include "frequency.h"

#include <math.h>
#include <stdlib.h>

/* Return whether M - A / s is positive definite; T is for the difference. */
static int above(const struct matrix *M, const struct matrix *A, double s,
                 struct matrix *T)
{
    matrix_combine(M, -1.0 / s, A, T);
    return matrix_factor(T) == OK;
}

static double largest_frequency(const struct matrix *M, const struct matrix *A)
{
    struct matrix *T = matrix_copy(M);
    double low = 0.0, high = 1.0;
    while (!above(M, A, high, T) && isfinite(high)) {
        low = high;
        high *= 4.0;
    }
    for (int k = 0; k < 150 && high - low > 1e-14 * high; k++) {
        const double s = 0.5 * (low + high);
        if (above(M, A, s, T))
            high = s;
        else
            low = s;
    }
    matrix_free(T);
    return sqrt(high);
}

double frequency_largest(const struct model *model)
{
    if (!model->body) return largest_frequency(model->M, model->A);
    struct matrix *M = body_matrix(model->body);
    struct matrix *A = body_matrix(model->body);
    double *rest = allocate((size_t)model->n_dof, sizeof *rest);
    body_mass_matrix(model->body, M);
    body_stiffness(model->body, rest, EXACT, A);
    const double omega = largest_frequency(M, A);
    free(rest);
    matrix_free(M);
    matrix_free(A);
    return omega;
}
