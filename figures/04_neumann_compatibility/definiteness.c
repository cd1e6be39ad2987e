/*
 * definiteness.c - what does each prescribed end do to the eigenvalues of A,
 * and does Cholesky notice that A is singular without one?
 *
 * Four equal elements, beta = 1.  The rows and columns of no, one and both ends
 * are struck out; Cholesky gets the matrix with those ends prescribed
 * [eq:dirichlet-correction].  Tables: eigenvalues and ranks; the eigenvector of
 * the eigenvalue 0, scaled to mean 1 [eq:quadratic-form].
 */
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <float.h>
#include <gsl/gsl_eigen.h>
#include <math.h>

enum { n = 4, N = n + 1 };
static const double grading = 1.0;

/* The eigenvector of the smallest eigenvalue of A, scaled to mean 1. */
static void lowest_eigenvector(const struct matrix *A, double v[N])
{
    gsl_matrix *copy = gsl_matrix_alloc(N, N);
    gsl_matrix *vectors = gsl_matrix_alloc(N, N);
    gsl_vector *values = gsl_vector_alloc(N);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(N);
    double mean = 0.0;

    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < N; j++)
            gsl_matrix_set(copy, i, j, matrix_get(A, (int)i, (int)j));
    gsl_eigen_symmv(copy, values, vectors, work);
    gsl_eigen_symmv_sort(values, vectors, GSL_EIGEN_SORT_VAL_ASC);
    for (size_t i = 0; i < N; i++) mean += gsl_matrix_get(vectors, i, 0) / N;
    for (size_t i = 0; i < N; i++) v[i] = gsl_matrix_get(vectors, i, 0) / mean;
    gsl_eigen_symmv_free(work);
    gsl_vector_free(values);
    gsl_matrix_free(vectors);
    gsl_matrix_free(copy);
}

int main(void)
{
    const char *const ends[] = {"none", "one", "both"};
    const int node[] = {0, n};
    const double zero[] = {0.0, 0.0};
    double x[N], b[N], null[N], rank_lost[3], unequal = 0.0;
    enum status status[3];
    struct matrix *A = matrix_alloc(BANDED, N, 1);

    poisson_grid(0.0, 1.0, n, grading, x);
    poisson_assemble(n, x, field_one, field_one, &MIDPOINT, A, b);
    table_begin_note("definiteness",
                     "fixed order lambda_min lambda_max rank cholesky",
                     "an eigenvalue below N eps lambda_max counts as 0");
    for (int fixed = 0; fixed <= 2; fixed++) {
        const int order = N - fixed;
        struct matrix *left = matrix_block(A, fixed > 0, order);
        struct matrix *L = matrix_copy(A);
        double lambda[N];
        int rank = 0;
        if (matrix_eigenvalues(left, lambda) != OK) die("A is not finite");
        for (int k = 0; k < order; k++)
            rank += lambda[k] > order * DBL_EPSILON * lambda[order - 1];
        matrix_dirichlet(L, b, fixed, node, zero, KEEP_DIAGONAL);
        status[fixed] = matrix_factor(L);
        rank_lost[fixed] = order - rank;
        table_row(ends[fixed], order, rank == order ? lambda[0] : 0.0,
                  lambda[order - 1], rank, status_name(status[fixed]));
        matrix_free(left);
        matrix_free(L);
    }
    table_end();

    lowest_eigenvector(A, null);
    table_begin("null_vector", "x value");
    for (int i = 0; i <= n; i++) {
        table_row(x[i], null[i]);
        unequal = fmax(unequal, fabs(null[i] - 1.0));
    }
    table_end();
    matrix_free(A);

    claim(rank_lost[0] == 1 && status[0] == NOT_SPD,
          "without a prescribed end the rank is one less than the order, and "
          "Cholesky says NOT_SPD (%g less; %s)", rank_lost[0],
          status_name(status[0]));
    claim(rank_lost[1] == 0 && status[1] == OK && rank_lost[2] == 0 &&
              status[2] == OK, "one prescribed end makes A positive definite");
    claim(unequal < 1e-12, "the null space is spanned by (1, ..., 1) (off by "
          "%g)", unequal);
    return table_finish();
}
