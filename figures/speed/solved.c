/* solved.c - see solved.h. */
#include "solved.h"

#include <math.h>

double solved_error(const struct csr *A, const double x[], const double b[])
{
    double r = 0.0, norm_A = 0.0, norm_x = 0.0, norm_b = 0.0;
    for (int i = 0; i < A->n; i++) {
        double rest = b[i], row = 0.0;
        for (int k = A->start[i]; k < A->start[i + 1]; k++) {
            rest -= A->value[k] * x[A->index[k]];
            row += fabs(A->value[k]);
        }
        if (!(fabs(rest) <= r)) r = fabs(rest); /* NaN stays */
        norm_A = fmax(norm_A, row);
        norm_x = fmax(norm_x, fabs(x[i]));
        norm_b = fmax(norm_b, fabs(b[i]));
        if (isnan(r)) return r;
    }
    return r / (norm_A * norm_x + norm_b);
}
