/*
 * orders.c - with which order do the loads of the three rules converge, and
 * what do a kink or a jump of f inside an element do to it?
 *
 * Equal elements; f is smooth, |x - c| or a step at c = 1/3, which is at 1/3 or
 * 2/3 of an element of every mesh.  Tables: int f dx - sum_j b_j of the three
 * rules [eq:quadrature-b]; the orders between the finest mesh and one four
 * times coarser [eq:order].
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdio.h>

enum { COARSEST = 4, LEVELS = 6, FINEST = COARSEST << (LEVELS - 1) };
static const double c = 1.0 / 3.0;

static double kink(double x)
{
    return fabs(x - c);
}
static double step(double x)
{
    return x < c ? 0.0 : 1.0;
}

/* sum_j b_j on n equal elements. */
static double total_load(int n, field *f, const struct quadrature *rule)
{
    double x[FINEST + 1], b[FINEST + 1], sum = 0.0;
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);
    poisson_grid(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, field_one, f, rule, A, b);
    for (int j = 0; j <= n; j++) sum += b[j];
    matrix_free(A);
    return sum;
}

/* Tables `name` and name_orders; order[r] of the three rules. */
static void print(const char *name, field *f, double integral, double order[3])
{
    const struct quadrature *const rule[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    double error[LEVELS][3];
    char text[32];

    table_begin(name, "n h midpoint trapezoid gauss2");
    for (int level = 0; level < LEVELS; level++) {
        const int n = COARSEST << level;
        for (int r = 0; r < 3; r++)
            error[level][r] = integral - total_load(n, f, rule[r]);
        table_row(n, 1.0 / n, error[level][0], error[level][1],
                  error[level][2]);
    }
    table_end();
    for (int r = 0; r < 3; r++)
        order[r] = study_order(fabs(error[LEVELS - 3][r]),
                            fabs(error[LEVELS - 1][r]), 4.0);
    snprintf(text, sizeof text, "%s_orders", name);
    table_begin(text, "midpoint trapezoid gauss2");
    table_row_of(3, order);
    table_end();
}

int main(void)
{
    const double due[3][3] = {{2, 2, 4}, {2, 2, 2}, {1, 1, 1}};
    double order[3][3];

    /* f = -(beta u')', so int f is the difference of beta u' = 2 e^x cos 2x */
    print("load_smooth", smooth_f, 2.0 - 2.0 * exp(1.0) * cos(2.0), order[0]);
    print("load_kink", kink, 0.5 * (c * c + (1.0 - c) * (1.0 - c)), order[1]);
    print("load_step", step, 1.0 - c, order[2]);
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < 3; r++)
            claim(fabs(order[k][r] - due[k][r]) < 0.01,
                  "the orders are 2, 2, 4 (smooth), 2, 2, 2 (kink) and 1, 1, 1 "
                  "(jump), but one is %g, not %g", order[k][r], due[k][r]);
    return table_finish();
}
