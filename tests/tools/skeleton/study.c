/*
 * order.c - TODO: the question that this study asks, and what varies.
 *
 * The example: how fast does the error of the trapezium rule for x^2 on (0, 1)
 * fall with the number of pieces?
 */
#include "../study/study.h"
#include "base/table.h"

static double error_of(int n)
{
    double sum = 0.5;
    for (int i = 1; i < n; i++) sum += (double)i * i / ((double)n * n);
    return sum / n - 1.0 / 3.0;
}

int main(void)
{
    double order = 0.0, before = error_of(2);

    table_begin("error", "n error order");
    table_row(2, before, MISSING);
    for (int n = 4; n <= 64; n *= 2) {
        const double error = error_of(n);
        order = study_order(before, error, 2.0);
        table_row(n, error, order);
        before = error;
    }
    table_end();
    claim(order > 1.99 && order < 2.01,
          "TODO: what the picture says (the order is %g)", order);
    return table_finish();
}
