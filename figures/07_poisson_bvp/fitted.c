/* fitted.c - see fitted.h. */
#include "fitted.h"

#include <gsl/gsl_sf_log.h>
#include <math.h>

/* On an element phi_1 = ln(t/t0) / ln(t1/t0), phi_0 = 1 - phi_1, and its
 * stiffness is 1 / int dx/beta. */
void fitted_assemble(int n, const double x[], struct matrix *A, double b[])
{
    matrix_zero(A);
    for (int i = 0; i <= n; i++) b[i] = 0.0;
    for (int e = 0; e < n; e++) {
        const double t0 = 1.0 + x[e], t1 = 1.0 + x[e + 1], h = t1 - t0;
        const double L = log1p(h / t0);
        matrix_add(A, e, e, 1.0 / L);
        matrix_add(A, e, e + 1, -1.0 / L);
        matrix_add(A, e + 1, e, -1.0 / L);
        matrix_add(A, e + 1, e + 1, 1.0 / L);
        b[e] -= gsl_sf_log_1plusx_mx(-h / t1) / (t0 * L);
        b[e + 1] -= gsl_sf_log_1plusx_mx(h / t0) / (t1 * L);
    }
}
