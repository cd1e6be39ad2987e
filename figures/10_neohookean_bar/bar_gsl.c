/* bar_gsl.c - see bar_gsl.h. */
#include "bar_gsl.h"

#include <assert.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

/* -q at the free nodes 1..n, diagonal and off-diagonal of K. */
static void assemble(const struct bar *bar, const double u[], double r[],
                     double d[], double e[])
{
    const double mu = bar->material.mu, lambda = bar->material.lambda;
    for (int i = 0; i < bar->n; i++) r[i] = bar->b[i + 1];
    for (int i = 0; i < bar->n; i++) { /* the element left of node i + 1 */
        const double H = (u[i + 1] - u[i]) / bar->h, dv = 1.0 - H + H * H;
        const double v = H - H * H / 2.0 + H * H * H / 3.0;
        const double G = lambda * v - mu, P = mu * (1.0 + H) + G * dv;
        const double k =
            (mu + lambda * dv * dv + G * (2.0 * H - 1.0)) / bar->h;
        r[i] -= P;
        d[i] = k;
        if (i == 0) continue;
        r[i - 1] += P;
        d[i - 1] += k;
        e[i - 1] = -k;
    }
}

static double max_abs(int n, const double v[])
{
    double largest = 0.0;
    for (int i = 0; i < n; i++)
        if (!(fabs(v[i]) <= largest)) largest = fabs(v[i]);
    return largest;
}

struct newton_report bar_gsl_newton(const struct bar *bar,
                                    const struct newton_control *control,
                                    double u[])
{
    assert(bar->material.law == CUBIC && bar->held[0] && !bar->held[1]);
    assert(bar->n > 1 && !control->line_search && !control->definite);
    const int n = bar->n;
    const size_t size = (size_t)n;
    const double force = control->tolerance * material_modulus(&bar->material);
    const double length = control->tolerance * n * bar->h;
    double *d = allocate(size, sizeof *d), *e = allocate(size, sizeof *e);
    double *r = allocate(size, sizeof *r), *du = allocate(size, sizeof *du);
    gsl_vector_view diagonal = gsl_vector_view_array(d, size);
    gsl_vector_view off = gsl_vector_view_array(e, size - 1);
    gsl_vector_view minus_q = gsl_vector_view_array(r, size);
    gsl_vector_view x = gsl_vector_view_array(du, size);
    struct newton_report report = {OK, 0, 0.0, 0.0};
    gsl_error_handler_t *old = gsl_set_error_handler_off();

    for (;;) {
        assemble(bar, u, r, d, e);
        report.residual = max_abs(n, r);
        report.status = NONFINITE;
        if (!isfinite(report.residual) || !isfinite(report.increment)) break;
        report.status = OK;
        if (report.residual <= force &&
            (report.iterations > 0 ? report.increment <= length
                                   : report.residual == 0.0))
            break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == control->max_iterations) break;
        report.status = NOT_SPD;
        if (gsl_linalg_solve_symm_tridiag(&diagonal.vector, &off.vector,
                                          &minus_q.vector, &x.vector))
            break;
        for (int i = 0; i < n; i++) u[i + 1] += du[i];
        report.increment = max_abs(n, du);
        report.iterations++;
    }
    gsl_set_error_handler(old);
    free(d);
    free(e);
    free(r);
    free(du);
    return report;
}
