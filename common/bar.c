/* bar.c - see bar.h. */
#include "bar.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static double stretch(const struct bar *bar, const double u[], int e)
{
    return 1.0 + (u[e] - u[e - 1]) / bar->h;
}

enum status bar_energy(const struct bar *bar, const double u[], double *energy)
{
    *energy = 0.0;
    for (int i = 0; i <= bar->n; i++) *energy -= bar->b[i] * u[i];
    for (int e = 1; e <= bar->n; e++) {
        const double F = stretch(bar, u, e);
        if (!material_defined(&bar->material, F)) return INVERTED;
        *energy += bar->h * material1_psi(&bar->material, F);
    }
    return isfinite(*energy) ? OK : NONFINITE;
}

enum status bar_residual(const struct bar *bar, const double u[], double q[])
{
    for (int i = 0; i <= bar->n; i++) q[i] = -bar->b[i];
    for (int e = 1; e <= bar->n; e++) {
        const double F = stretch(bar, u, e);
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double P = material1_pk1(&bar->material, F);
        q[e - 1] -= P;
        q[e] += P;
    }
    for (int i = 0; i <= bar->n; i++)
        if (!isfinite(q[i])) return NONFINITE;
    return OK;
}

enum status bar_tangent(const struct bar *bar, const double u[],
                        struct matrix *K)
{
    matrix_zero(K);
    for (int e = 1; e <= bar->n; e++) {
        const double F = stretch(bar, u, e);
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double k = material1_dpk1(&bar->material, F) / bar->h;
        if (!isfinite(k)) return NONFINITE;
        matrix_add(K, e - 1, e - 1, k);
        matrix_add(K, e - 1, e, -k);
        matrix_add(K, e, e - 1, -k);
        matrix_add(K, e, e, k);
    }
    return OK;
}

static double max_free(const struct bar *bar, const double v[])
{
    double largest = 0.0;
    for (int i = bar->fixed[0]; i <= bar->n - bar->fixed[1]; i++)
        if (fabs(v[i]) > largest) largest = fabs(v[i]);
    return largest;
}

/*
 * Solve K du = -q for the free nodes by a tridiagonal L D L^T sweep; du = 0 at
 * the prescribed ones.  K may be indefinite (P' < 0 somewhere): *positive says
 * whether all pivots were > 0.  NOT_SPD only when a pivot is 0 to round-off.
 */
static enum status solve_tridiagonal(const struct bar *bar,
                                     const struct matrix *K, const double q[],
                                     double d[], double du[], int *positive)
{
    const int first = bar->fixed[0], last = bar->n - bar->fixed[1];

    *positive = 1;
    du[0] = du[bar->n] = 0.0;
    for (int i = first; i <= last; i++) {
        const double K_ii = matrix_get(K, i, i);
        d[i] = K_ii;
        du[i] = -q[i];
        if (i > first) {
            const double l = matrix_get(K, i, i - 1) / d[i - 1];
            d[i] -= l * matrix_get(K, i, i - 1);
            du[i] -= l * du[i - 1];
        }
        if (!(fabs(d[i]) > DBL_EPSILON * fabs(K_ii))) return NOT_SPD;
        if (d[i] < 0.0) *positive = 0;
    }
    for (int i = last; i >= first; i--) {
        du[i] /= d[i];
        if (i < last) du[i] -= matrix_get(K, i + 1, i) / d[i] * du[i + 1];
        if (!isfinite(du[i])) return NONFINITE;
    }
    return OK;
}

/* u := u + length du with the first length 1, 1/2, 1/4, ... at which the
 * energy is defined and decreases (Armijo, 1e-4 of the slope q.du). */
static enum status line_search(const struct bar *bar, const double q[],
                               const double du[], double energy, double u[],
                               double trial[], double *length)
{
    double slope = 0.0;
    for (int i = 0; i <= bar->n; i++) slope += q[i] * du[i];
    if (!(slope < 0.0)) return slope == 0.0 ? OK : NOT_SPD;

    /* close to the minimum the energy has no digits left to compare */
    const double noise = 16.0 * DBL_EPSILON * fabs(energy);
    for (*length = 1.0; *length > 1e-12; *length *= 0.5) {
        double candidate;
        for (int i = 0; i <= bar->n; i++) trial[i] = u[i] + *length * du[i];
        if (bar_energy(bar, trial, &candidate) == OK &&
            candidate <= energy + 1e-4 * *length * slope + noise) {
            for (int i = 0; i <= bar->n; i++) u[i] = trial[i];
            return OK;
        }
    }
    return STALLED;
}

static void describe(const struct bar *bar, const double u[],
                     struct newton_step *step)
{
    step->min_F = step->min_dP = INFINITY;
    for (int e = 1; e <= bar->n; e++) {
        const double F = stretch(bar, u, e);
        step->min_F = fmin(step->min_F, F);
        step->min_dP = fmin(step->min_dP, material1_dpk1(&bar->material, F));
    }
}

struct newton_report bar_newton(const struct bar *bar,
                                const struct newton_control *control,
                                double u[], struct newton_step history[])
{
    const size_t size = (size_t)bar->n + 1;
    struct newton_report report = {MAX_ITERATIONS, 0, 0.0, 0.0};
    struct matrix *K = matrix_alloc(BANDED, bar->n + 1, 1);
    double *q = allocate(size, sizeof *q), *du = allocate(size, sizeof *du);
    double *d = allocate(size, sizeof *d), *trial = allocate(size, sizeof *d);
    const double force = control->tolerance * material_modulus(&bar->material);
    const double length = control->tolerance * bar->n * bar->h;

    for (int k = 0;; k++) {
        struct newton_step step = {.length = 1.0};
        int positive;

        report.status = bar_residual(bar, u, q);
        if (report.status == OK)
            report.status = bar_energy(bar, u, &step.energy);
        if (report.status != OK) break;
        if (bar->fixed[0]) q[0] = 0.0;
        if (bar->fixed[1]) q[bar->n] = 0.0;
        report.residual = step.residual = max_free(bar, q);
        describe(bar, u, &step);
        if (history) history[k] = step;
        if (step.residual <= force && (k > 0 ? report.increment <= length
                                             : step.residual == 0.0))
            break;
        /* |du| cannot change u any more, and still q is not small */
        if (k > 0 && report.increment <= DBL_EPSILON * bar->n * bar->h) {
            report.status = STALLED;
            break;
        }
        report.status = MAX_ITERATIONS;
        if (k == control->max_iterations) break;

        report.status = bar_tangent(bar, u, K);
        if (report.status == OK)
            report.status = solve_tridiagonal(bar, K, q, d, du, &positive);
        if (report.status != OK) break;
        report.iterations = k + 1;
        report.increment = step.increment = max_free(bar, du);
        if (control->line_search)
            report.status = positive ? line_search(bar, q, du, step.energy, u,
                                                   trial, &step.length)
                                     : NOT_SPD;
        else
            for (int i = 0; i <= bar->n; i++) u[i] += du[i];
        if (history) history[k] = step;
        if (report.status != OK) break;
    }
    free(q);
    free(du);
    free(d);
    free(trial);
    matrix_free(K);
    return report;
}
