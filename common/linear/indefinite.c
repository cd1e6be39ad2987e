/* indefinite.c - see indefinite.h. */
#include "linear/indefinite.h"

#include <float.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum status indefinite_solve(int n, int p, size_t stride, const double a[],
                             double b[], int *negative)
{
    /* GSL wants rows of p + 1 numbers, without room behind them */
    const size_t rows = (size_t)n, row = (size_t)p + 1;
    double *copy = allocate(rows * row, sizeof *copy);
    gsl_matrix_view view = gsl_matrix_view_array(copy, rows, row);
    gsl_vector_view x = gsl_vector_view_array(b, rows);
    for (size_t j = 0; j < rows; j++)
        memcpy(&copy[j * row], &a[j * stride], row * sizeof *copy);
    gsl_error_handler_t *old = gsl_set_error_handler_off();
    int failed = gsl_linalg_ldlt_band_decomp(&view.matrix) ||
                 gsl_linalg_ldlt_band_svx(&view.matrix, &x.vector);
    gsl_set_error_handler(old);
    if (negative) *negative = 0;
    for (size_t j = 0; j < rows; j++) {
        const double D_jj = copy[j * row], A_jj = a[j * stride];
        if (!(fabs(D_jj) > DBL_EPSILON * fabs(A_jj))) failed = 1;
        if (negative) *negative += D_jj < 0.0;
    }
    free(copy);
    return failed ? NOT_SPD : OK;
}
