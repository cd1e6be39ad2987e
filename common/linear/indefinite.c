/* indefinite.c - see indefinite.h. */
#include "linear/indefinite.h"

#include <float.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

/* The same of half bandwidth 1: a bar's system for each of Newton's steps. */
static enum status tridiagonal(int n, size_t stride, const double a[],
                               double d[], double b[], int *negative)
{
    int failed = 0;
    if (negative) *negative = 0;
    for (int j = 0; j < n; j++) { /* D_jj, and L y = b */
        const double A_jj = a[(size_t)j * stride];
        d[j] = A_jj;
        if (j > 0) {
            const double below = a[(size_t)(j - 1) * stride + 1];
            const double l = below / d[j - 1]; /* L_j,j-1 */
            d[j] -= l * below; /* L_j,j-1^2 D_j-1,j-1 */
            b[j] -= l * b[j - 1];
        }
        if (!(fabs(d[j]) > DBL_EPSILON * fabs(A_jj))) failed = 1;
        if (negative) *negative += d[j] < 0.0;
    }
    b[n - 1] /= d[n - 1];
    for (int j = n - 2; j >= 0; j--) /* D L^T x = y */
        b[j] = (b[j] - a[(size_t)j * stride + 1] * b[j + 1]) / d[j];
    return failed ? NOT_SPD : OK;
}

enum status indefinite_solve(int n, int p, size_t stride, const double a[],
                             double room[], double b[], int *negative)
{
    if (p == 1) return tridiagonal(n, stride, a, room, b, negative);
    /* GSL wants rows of p + 1 numbers, without room behind them */
    const size_t rows = (size_t)n, row = (size_t)p + 1;
    gsl_matrix_view view = gsl_matrix_view_array(room, rows, row);
    gsl_vector_view x = gsl_vector_view_array(b, rows);
    for (size_t j = 0; j < rows; j++)
        memcpy(&room[j * row], &a[j * stride], row * sizeof *room);
    gsl_error_handler_t *old = gsl_set_error_handler_off();
    int failed = gsl_linalg_ldlt_band_decomp(&view.matrix) ||
                 gsl_linalg_ldlt_band_svx(&view.matrix, &x.vector);
    gsl_set_error_handler(old);
    if (negative) *negative = 0;
    for (size_t j = 0; j < rows; j++) {
        const double D_jj = room[j * row], A_jj = a[j * stride];
        if (!(fabs(D_jj) > DBL_EPSILON * fabs(A_jj))) failed = 1;
        if (negative) *negative += D_jj < 0.0;
    }
    return failed ? NOT_SPD : OK;
}
