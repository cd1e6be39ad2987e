/*
 * compatibility.c - how far is b from compatible, and what decides it?
 *
 * -u'' = e^x with flux 0 at x = 0 and -(e - 1) at x = 1 is compatible, and the
 * sum of the b_i is the error of the quadrature [eq:neumann-compatibility].
 * Tables: the defect of the midpoint rule against its first term,
 * -(e - 1) h^2 / 24; the defects of three rules.  An order is from half as many
 * elements [eq:order].
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* sum_i b_i on n equal elements; *status says whether it is more than the
 * round-off of that sum. */
static double defect(int n, const struct quadrature *rule, enum status *status)
{
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *b = allocate((size_t)n + 1, sizeof *b);
    double sum = 0.0, scale = 0.0;

    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, field_one, exp, rule, A, b);
    b[n] -= expm1(1.0);
    for (int i = 0; i <= n; i++) {
        sum += b[i];
        scale += fabs(b[i]);
    }
    if (status)
        *status = fabs(sum) <= (n + 1) * DBL_EPSILON * scale ? OK
                                                             : INCOMPATIBLE;
    matrix_free(A);
    free(x);
    free(b);
    return sum;
}

int main(void)
{
    const double E = expm1(1.0);
    double order = 0.0, ratio = 0.0, off = 0.0;
    int refused = 0, rows = 0;

    table_begin("compatibility", "n h sum_b leading ratio order status");
    for (int n = 4; n <= 256; n *= 2) {
        const double h = 1.0 / n, leading = -E * h * h / 24.0;
        enum status status;
        const double sum = defect(n, &MIDPOINT, &status);
        order = study_order(-defect(n / 2, &MIDPOINT, NULL), -sum, 2.0);
        ratio = sum / leading;
        table_row(n, h, sum, leading, ratio, order, status_name(status));
        refused += status == INCOMPATIBLE;
        rows++;
    }
    table_end();

    table_begin("rules", "h midpoint trapezoid gauss2");
    for (int n = 4; n <= 64; n *= 2) {
        const double h = 1.0 / n, trapezoid = defect(n, &TRAPEZOID, NULL);
        const double gauss2 = defect(n, &GAUSS2, NULL);
        table_row(h, defect(n, &MIDPOINT, NULL), trapezoid, gauss2);
        if (n < 16) continue; /* what is left of a first term is h^2 / 30 */
        off = fmax(off, fabs(trapezoid / (E * h * h / 12.0) - 1.0));
        off = fmax(off, fabs(gauss2 / (-E * h * h * h * h / 4320.0) - 1.0));
    }
    table_end();

    claim(fabs(order - 2.0) < 1e-4 && fabs(ratio - 1.0) < 1e-5,
          "the midpoint rule's defect has order 2 and, at n = 256, the "
          "constant of its first term (order %g, ratio %g)", order, ratio);
    claim(off < 1e-3, "the other defects are (e-1)h^2/12 and -(e-1)h^4/4320 to "
          "0.1 %% from n = 16 on (off by %g)", off);
    claim(refused == rows, "every one of these systems is refused");
    return table_finish();
}
