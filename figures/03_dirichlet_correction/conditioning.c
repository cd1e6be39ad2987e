/*
 * conditioning.c - what does the new diagonal entry of a replaced equation do
 * to the condition number?
 *
 * Linear elements on (0, 1), beta = 2 mu + lambda = 1346.15, corrected by
 * matrix_dirichlet() [eq:dirichlet-correction] with the old diagonal entry kept
 * or with 1 in its place.  Tables: the matrix of the picture before and after;
 * condition numbers with the left end prescribed [eq:condition-number].
 */
#include "material/material.h"
#include "linear/matrix.h"
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

static double modulus(double x)
{
    const struct material material = material_notes(LINEAR);
    (void)x;
    return material_modulus(&material);
}

/* A of n equal elements; nodes[0..k-1] are prescribed (k = 0: none). */
static struct matrix *corrected(int n, int k, const int nodes[],
                                enum diagonal diagonal)
{
    const double value[3] = {0.0, 0.0, 0.0};
    struct matrix *A = matrix_alloc(DENSE, n + 1, 1);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *b = allocate((size_t)n + 1, sizeof *b);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, modulus, field_zero, &MIDPOINT, A, b);
    matrix_dirichlet(A, b, k, nodes, value, diagonal);
    free(x);
    free(b);
    return A;
}

static double condition_number(int n, enum diagonal diagonal)
{
    const int left[] = {0};
    struct matrix *A = corrected(n, 1, left, diagonal);
    double *value = allocate((size_t)A->n, sizeof *value);
    if (matrix_eigenvalues(A, value) != OK) die("A is not finite");
    const double condition = value[n] / value[0];
    free(value);
    matrix_free(A);
    return condition;
}

int main(void)
{
    const int nodes[] = {0, 4, 6};
    struct matrix *before = corrected(6, 0, nodes, KEEP_DIAGONAL);
    struct matrix *after = corrected(6, 3, nodes, KEEP_DIAGONAL);
    double kept = 0.0, one = 0.0, least = INFINITY, growth = 0.0;

    matrix_table("A", before);
    matrix_table("A_corrected", after);
    table_begin("condition", "n kept one");
    for (int n = 4; n <= 64; n *= 2) {
        growth = kept > 0.0 ? condition_number(n, KEEP_DIAGONAL) / kept : 0.0;
        kept = condition_number(n, KEEP_DIAGONAL);
        one = condition_number(n, UNIT_DIAGONAL);
        least = fmin(least, one / kept);
        table_row(n, kept, one);
    }
    table_end();
    matrix_free(before);
    matrix_free(after);

    claim(fabs(growth - 4.0) < 0.1 &&
              fabs(kept / (16.0 * 64 * 64 / (M_PI * M_PI)) - 1.0) < 0.02,
          "with the diagonal kept the condition number is 16 n^2 / pi^2 to "
          "2 %% at n = 64 (it is %g)", kept);
    claim(least > 50.0, "a 1 on the diagonal makes it more than 50 times "
          "larger (%g times)", least);
    return table_finish();
}
