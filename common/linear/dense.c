/* dense.c - see dense.h. */
#include "linear/dense.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_sort_vector.h>
#include <math.h>

enum status dense_factor(int n, double a[])
{
    gsl_matrix_view view = gsl_matrix_view_array(a, (size_t)n, (size_t)n);
    gsl_error_handler_t *old = gsl_set_error_handler_off();
    const int failed = gsl_linalg_cholesky_decomp1(&view.matrix);
    gsl_set_error_handler(old);
    if (failed) return NOT_SPD;
    for (int k = 0; k < n; k++) { /* A_kk = sum_j L_kj^2 */
        const double *row = &a[(size_t)k * (size_t)n];
        const double pivot = row[k] * row[k];
        double A_kk = 0.0;
        for (int j = 0; j <= k; j++) A_kk += row[j] * row[j];
        if (!(pivot > n * DBL_EPSILON * A_kk)) return NOT_SPD; /* NaN too */
    }
    return OK;
}

void dense_solve(int n, double l[], double b[])
{
    gsl_matrix_view view = gsl_matrix_view_array(l, (size_t)n, (size_t)n);
    gsl_vector_view x = gsl_vector_view_array(b, (size_t)n);
    gsl_linalg_cholesky_svx(&view.matrix, &x.vector);
}

enum status dense_eigenvalues(int n, double a[], double value[])
{
    gsl_matrix_view view = gsl_matrix_view_array(a, (size_t)n, (size_t)n);
    gsl_vector_view values = gsl_vector_view_array(value, (size_t)n);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc((size_t)n);
    if (!work) die("out of memory");
    enum status status = OK;
    for (int k = 0; k < n * n; k++)
        if (!isfinite(a[k])) status = NONFINITE; /* GSL would not end */
    if (status == OK) {
        gsl_eigen_symm(&view.matrix, &values.vector, work);
        gsl_sort_vector(&values.vector);
    }
    gsl_eigen_symm_free(work);
    return status;
}
