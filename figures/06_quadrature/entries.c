/*
 * entries.c - how far are the entries of A and b from the exact integrals?
 *
 * beta = e^x, u = sin 2x, six elements of lengths up to 2.385 : 1, flux -2 at 0
 * [eq:quadrature-A] [eq:quadrature-b].  GSL's adaptive quadrature is the judge.
 * Tables: the diagonal of A and b by the midpoint rule, and by GSL.
 */
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_integration.h>
#include <math.h>

enum { n = 6, N = n + 1 };

/* g times 1, s or 1 - s, where s runs from 0 at x0 to 1 at x1. */
struct integrand {
    double x0, x1;
    field *g;
    enum { ONE, RISING, FALLING } shape;
};

static double integrand_value(double x, void *params)
{
    const struct integrand *f = params;
    const double s = (x - f->x0) / (f->x1 - f->x0);
    return f->g(x) * (f->shape == ONE ? 1.0 : f->shape == RISING ? s : 1.0 - s);
}

static double adaptive_integral(struct integrand f)
{
    gsl_function function = {integrand_value, &f};
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(100);
    double result, estimate;
    gsl_integration_qag(&function, f.x0, f.x1, 1e-12, 0.0, 100,
                        GSL_INTEG_GAUSS21, work, &result, &estimate);
    gsl_integration_workspace_free(work);
    return result;
}

int main(void)
{
    const struct quadrature *const rule[] = {&GAUSS2, &TRAPEZOID, &MIDPOINT};
    double x[N], diagonal[N] = {0}, load[N] = {-2.0}, b[N];
    double off_A[3] = {0}, off_b[3] = {0}; /* of the rules */
    struct matrix *A = matrix_alloc(BANDED, N, 1);

    poisson_grid(0.0, 1.0, n, 2.385, x);
    for (int j = 1; j <= n; j++) {
        struct integrand f = {x[j - 1], x[j], smooth_beta, ONE};
        const double h = x[j] - x[j - 1], k = adaptive_integral(f) / (h * h);
        diagonal[j - 1] += k;
        diagonal[j] += k;
        f.g = smooth_f;
        f.shape = FALLING;
        load[j - 1] += adaptive_integral(f);
        f.shape = RISING;
        load[j] += adaptive_integral(f);
    }
    for (int r = 0; r < 3; r++) { /* the midpoint rule's are left */
        poisson_assemble(n, x, smooth_beta, smooth_f, rule[r], A, b);
        b[0] -= 2.0;
        for (int j = 0; j <= n; j++) {
            const double d = matrix_get(A, j, j) - diagonal[j];
            off_A[r] = fmax(off_A[r], fabs(d / diagonal[j]));
            off_b[r] = fmax(off_b[r], fabs(b[j] - load[j]));
        }
    }
    table_begin("A", "j diagonal diagonal_gsl");
    for (int j = 0; j <= n; j++)
        table_row(j, matrix_get(A, j, j), diagonal[j]);
    table_end();
    table_begin("b", "j b b_gsl");
    for (int j = 0; j <= n; j++) table_row(j, b[j], load[j]);
    table_end();
    matrix_free(A);

    /* (e^x)'' h^2 / 24 of e^x is h^2 / 24, h at most 1/4; twice that */
    claim(off_A[2] < 1.0 / 16 / 24 && off_A[1] < 1.0 / 16 / 12,
          "the diagonal is right to h^2/24 by the midpoint rule and to h^2/12 "
          "by the trapezoidal rule (%g, %g)", off_A[2], off_A[1]);
    claim(off_A[0] < 1e-2 * off_A[2] && off_b[0] < 3e-2 * off_b[2],
          "two Gauss points are far closer than the midpoint (%g of %g, %g of "
          "%g)", off_A[0], off_A[2], off_b[0], off_b[2]);
    return table_finish();
}
