/* conjugate.c - see conjugate.h. */
#include "conjugate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double dot(int n, const double x[], const double y[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += x[i] * y[i];
    return sum;
}

struct cg_report cg_solve(const struct csr *K, preconditioner *precondition,
                          const void *context, double tolerance, int cap,
                          const double b[], double x[])
{
    const int n = K->n;
    struct cg_report report = {.status = MAX_ITERATIONS};
    double *r = allocate((size_t)n, sizeof *r);
    double *z = allocate((size_t)n, sizeof *z);
    double *p = allocate((size_t)n, sizeof *p);
    double *Kp = allocate((size_t)n, sizeof *Kp), before = 1.0;
    const double size = sqrt(dot(n, b, b));

    memcpy(r, b, (size_t)n * sizeof *r);
    memset(x, 0, (size_t)n * sizeof *x);
    for (;;) {
        report.residual = size == 0.0 ? 0.0 : sqrt(dot(n, r, r)) / size;
        report.status = NONFINITE;
        if (!isfinite(report.residual)) break;
        report.status = OK;
        if (report.residual <= tolerance) break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == cap) break;

        precondition(context, r, z);
        const double rz = dot(n, r, z), beta = rz / before;
        for (int i = 0; i < n; i++) p[i] = z[i] + beta * p[i];
        csr_multiply(K, p, Kp);
        const double pKp = dot(n, p, Kp), alpha = rz / pKp;
        report.status = NONFINITE;
        if (!isfinite(rz) || !isfinite(pKp)) break;
        report.status = NOT_SPD;
        if (rz <= 0.0 || pKp <= 0.0) break;
        for (int i = 0; i < n; i++) {
            x[i] += alpha * p[i];
            r[i] -= alpha * Kp[i];
        }
        before = rz;
        report.iterations++;
    }
    free(r);
    free(z);
    free(p);
    free(Kp);
    return report;
}
