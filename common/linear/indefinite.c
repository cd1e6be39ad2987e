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

/* A block of a sparse matrix, by columns, whose first entry is (i, j) of the
 * band. */
static void add_block(const double block[4], int i, int j, size_t stride,
                      double band[])
{
    for (int column = j; column < j + 2; column++)
        for (int row = i; row < i + 2; row++, block++) {
            const int low = row > column ? row : column;
            const size_t high = (size_t)(row + column - low);
            if (*block != 0.0)
                band[high * stride + (size_t)low - high] += *block;
        }
}

enum status indefinite_solve_sparse(const struct sparse *s, const double a[],
                                    double b[], int *negative)
{
    const int n = 2 * s->n_vertex;
    int *rank = allocate((size_t)s->n_vertex, sizeof *rank), next = 0, p = 1;
    for (int v = 0; next < s->n_vertex; v++)
        if (s->place[v] >= 0) rank[s->place[v]] = next++;
    for (int v = 0; v < s->n_vertex; v++)
        for (int k = s->start[v]; k < s->start[v + 1]; k++)
            if (2 * abs(rank[s->row[k]] - rank[v]) + 1 > p)
                p = 2 * abs(rank[s->row[k]] - rank[v]) + 1;
    const size_t row = (size_t)p + 1;
    double *band = allocate((size_t)n * row, sizeof *band);
    double *x = allocate((size_t)n, sizeof *x);
    for (int v = 0; v < s->n_vertex; v++)
        for (int k = s->start[v]; k < s->start[v + 1]; k++)
            add_block(&a[4 * k], 2 * rank[s->row[k]], 2 * rank[v], row, band);
    for (int v = 0; v < s->n_vertex; v++)
        memcpy(&x[2 * rank[v]], &b[2 * v], 2 * sizeof *b);
    const enum status status = indefinite_solve(n, p, row, band, x, negative);
    for (int v = 0; v < s->n_vertex; v++)
        memcpy(&b[2 * v], &x[2 * rank[v]], 2 * sizeof *b);
    free(band);
    free(rank);
    free(x);
    return status;
}
