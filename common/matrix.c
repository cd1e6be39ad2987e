/* matrix.c - see matrix.h.  GSL does the factoring and the solving. */
#include "matrix.h"

#include <assert.h>
#include <float.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t row_length(const struct matrix *A)
{
    return A->storage == DENSE ? (size_t)A->n : (size_t)A->p + 1;
}

/* Where entry (i, j) lives; banded storage holds i >= j only. */
static double *entry(const struct matrix *A, int i, int j)
{
    const size_t row = (size_t)(A->storage == DENSE ? i : j);
    const size_t at = (size_t)(A->storage == DENSE ? j : i - j);
    return &A->a[row * row_length(A) + at];
}

struct matrix *matrix_alloc(enum storage storage, int n, int p)
{
    assert(n > 0);
    struct matrix *A = allocate(1, sizeof *A);
    A->storage = storage;
    A->n = n;
    A->p = storage == DENSE || p >= n ? n - 1 : p;
    A->a = allocate((size_t)n * row_length(A), sizeof *A->a);
    return A;
}

struct matrix *matrix_copy(const struct matrix *A)
{
    struct matrix *copy = matrix_alloc(A->storage, A->n, A->p);
    memcpy(copy->a, A->a, matrix_bytes(A));
    return copy;
}

void matrix_free(struct matrix *A)
{
    if (!A) return;
    free(A->a);
    free(A);
}

void matrix_zero(struct matrix *A)
{
    memset(A->a, 0, matrix_bytes(A));
}

void matrix_add(struct matrix *A, int i, int j, double value)
{
    assert(0 <= i && i < A->n && 0 <= j && j < A->n && abs(i - j) <= A->p);
    if (A->storage == DENSE || i >= j) *entry(A, i, j) += value;
}

double matrix_get(const struct matrix *A, int i, int j)
{
    assert(0 <= i && i < A->n && 0 <= j && j < A->n);
    if (abs(i - j) > A->p) return 0.0;
    if (A->storage == BANDED && i < j) return *entry(A, j, i);
    return *entry(A, i, j);
}

static void set(struct matrix *A, int i, int j, double value)
{
    if (A->storage == DENSE || i >= j) *entry(A, i, j) = value;
}

void matrix_dirichlet(struct matrix *A, double b[], int n_fixed,
                      const int node[], const double value[],
                      enum diagonal diagonal)
{
    for (int f = 0; f < n_fixed; f++) {
        const int k = node[f];
        const int first = k - A->p > 0 ? k - A->p : 0;
        const int last = k + A->p < A->n - 1 ? k + A->p : A->n - 1;
        const double d = diagonal == KEEP_DIAGONAL ? matrix_get(A, k, k) : 1.0;

        for (int i = first; i <= last; i++) {
            b[i] -= matrix_get(A, i, k) * value[f];
            set(A, i, k, 0.0);
            set(A, k, i, 0.0);
        }
        set(A, k, k, d);
        b[k] = d * value[f];
    }
}

static gsl_matrix_view gsl_view(const struct matrix *A)
{
    return gsl_matrix_view_array(A->a, (size_t)A->n, row_length(A));
}

/* (A_kk - pivot) was summed from squares of row k of L: A_kk = sum_j L_kj^2. */
static int pivot_is_positive(const struct matrix *L, int k)
{
    const double pivot = *entry(L, k, k) * *entry(L, k, k);
    double A_kk = 0.0;
    for (int j = k - L->p > 0 ? k - L->p : 0; j <= k; j++)
        A_kk += *entry(L, k, j) * *entry(L, k, j);
    return pivot > L->n * DBL_EPSILON * A_kk; /* false for NaN */
}

enum status matrix_factor(struct matrix *A)
{
    gsl_error_handler_t *old = gsl_set_error_handler_off();
    gsl_matrix_view view = gsl_view(A);
    const int failed = A->storage == DENSE
                           ? gsl_linalg_cholesky_decomp1(&view.matrix)
                           : gsl_linalg_cholesky_band_decomp(&view.matrix);
    gsl_set_error_handler(old);
    if (failed) return NOT_SPD;
    for (int k = 0; k < A->n; k++)
        if (!pivot_is_positive(A, k)) return NOT_SPD;
    return OK;
}

void matrix_solve(const struct matrix *L, double b[])
{
    gsl_matrix_view view = gsl_view(L);
    gsl_vector_view x = gsl_vector_view_array(b, (size_t)L->n);
    if (L->storage == DENSE)
        gsl_linalg_cholesky_svx(&view.matrix, &x.vector);
    else
        gsl_linalg_cholesky_band_svx(&view.matrix, &x.vector);
}

void matrix_multiply(const struct matrix *A, const double x[], double y[])
{
    for (int i = 0; i < A->n; i++) {
        const int first = i - A->p > 0 ? i - A->p : 0;
        const int last = i + A->p < A->n - 1 ? i + A->p : A->n - 1;
        y[i] = 0.0;
        for (int j = first; j <= last; j++) y[i] += matrix_get(A, i, j) * x[j];
    }
}

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

size_t matrix_bytes(const struct matrix *A)
{
    return (size_t)A->n * row_length(A) * sizeof *A->a;
}
