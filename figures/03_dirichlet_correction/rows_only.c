/*
 * rows_only.c - what if only the rows of the prescribed nodes are cleared?
 *
 * The scene of the lesson (n = 6, nodes 0, 4, 6 prescribed).  The system is
 * right, and LU solves it, but A is not symmetric: Cholesky, which reads the
 * lower triangle only, fails or solves another problem without a word.
 */
#include "material/material.h"
#include "linear/matrix.h"
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { N = 7, FIXED = 3 };
static const int node[FIXED] = {0, 4, 6};
static const double *const given = POISSON_HELD.g;

static double modulus(double x)
{
    const struct material material = material_notes(LINEAR);
    (void)x;
    return material_modulus(&material);
}

static double load(double x)
{
    (void)x;
    return POISSON_HELD.f;
}

/* Both triangles of the uncorrected A, and b. */
static void assemble(struct matrix *A, double b[])
{
    double x[N];
    poisson_grid(0.0, 1.0, N - 1, 1.0, x);
    poisson_assemble(N - 1, x, modulus, load, &MIDPOINT, A, b);
}

int main(void)
{
    double u[N], wrong[2] = {0.0, 0.0}, asymmetry[2] = {0.0, 0.0};
    enum status status[2];
    struct matrix *A = matrix_alloc(DENSE, N, 0);

    assemble(A, u);
    matrix_dirichlet(A, u, FIXED, node, given, KEEP_DIAGONAL);
    if (matrix_factor(A) != OK) die("the corrected matrix is not SPD");
    matrix_solve(A, u);

    table_begin("row_only", "diagonal asymmetry cholesky error");
    for (int unit = 0; unit <= 1; unit++) {
        double v[N];
        assemble(A, v);
        for (int k = 0; k < FIXED; k++) {
            double *row = &A->a[node[k] * N];
            const double d = unit ? 1.0 : row[node[k]];
            for (int j = 0; j < N; j++) row[j] = j == node[k] ? d : 0.0;
            v[node[k]] = d * given[k];
        }
        for (int i = 0; i < N; i++)
            for (int j = 0; j < i; j++)
                asymmetry[unit] =
                    fmax(asymmetry[unit],
                         fabs(matrix_get(A, i, j) - matrix_get(A, j, i)));
        status[unit] = matrix_factor(A);
        if (status[unit] == OK) {
            matrix_solve(A, v);
            for (int i = 0; i < N; i++)
                wrong[unit] = fmax(wrong[unit], fabs(u[i] - v[i]));
        }
        table_row(unit ? "one" : "kept", asymmetry[unit],
                  status_name(status[unit]),
                  cell_if(status[unit] == OK, wrong[unit]));
    }
    table_end();
    matrix_free(A);

    claim(status[0] == OK && wrong[0] > 0.512,
          "with the diagonal kept Cholesky ends with an answer that is wrong "
          "by more than the largest prescribed value (it is wrong by %g)",
          wrong[0]);
    claim(status[1] == NOT_SPD, "with 1 on the diagonal Cholesky says NOT_SPD");
    return table_finish();
}
