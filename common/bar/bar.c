/* bar.c - see bar.h. */
#include "bar/bar.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

double bar_stretch(const struct bar *bar, const double u[], int e)
{
    return 1.0 + (u[e] - u[e - 1]) / bar->h;
}

double bar_min_stretch(const struct bar *bar, const double u[])
{
    double least = INFINITY;
    for (int e = 1; e <= bar->n; e++)
        least = fmin(least, bar_stretch(bar, u, e));
    return least;
}

enum status bar_energy(const struct bar *bar, const double u[], double *energy)
{
    *energy = 0.0;
    for (int i = 0; i <= bar->n; i++) *energy -= bar->b[i] * u[i]; /* -b.u */
    for (int e = 1; e <= bar->n; e++) {
        const double F = bar_stretch(bar, u, e);
        if (!material_defined(&bar->material, F)) return INVERTED;
        *energy += bar->h * material1_psi(&bar->material, F); /* h psi(F_e) */
    }
    return isfinite(*energy) ? OK : NONFINITE;
}

enum status bar_residual(const struct bar *bar, const double u[], double q[])
{
    for (int i = 0; i <= bar->n; i++) q[i] = -bar->b[i];
    for (int e = 1; e <= bar->n; e++) {
        const double F = bar_stretch(bar, u, e);
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double P = material1_pk1(&bar->material, F);
        q[e - 1] -= P; /* h P dF_e/du: the slopes of F_e are -+1/h */
        q[e] += P;
    }
    for (int i = 0; i <= bar->n; i++)
        if (!isfinite(q[i])) return NONFINITE;
    return OK;
}

enum status bar_tangent(const struct bar *bar, const double u[],
                        struct matrix *K)
{
    const int next = matrix_place(K, 1, 1), below = matrix_place(K, 1, 0);
    double *a = K->a; /* entry (e - 1, e - 1) */
    matrix_zero(K);
    for (int e = 1; e <= bar->n; e++, a += next) {
        const double F = bar_stretch(bar, u, e);
        if (!material_defined(&bar->material, F)) return INVERTED;
        const double k = material1_dpk1(&bar->material, F) / bar->h; /* P'/h */
        if (!isfinite(k)) return NONFINITE;
        a[0] += k; /* k [1 -1; -1 1] in rows and columns e - 1 and e */
        a[below] -= k;
        a[next] += k;
        if (K->storage == DENSE) a[1] -= k;
    }
    return OK;
}

double bar_max_free(const struct bar *bar, const double v[])
{
    double largest = 0.0;
    for (int i = bar->held[0]; i <= bar->n - bar->held[1]; i++) {
        if (!isfinite(v[i])) return INFINITY;
        if (fabs(v[i]) > largest) largest = fabs(v[i]);
    }
    return largest;
}

/*
 * Solve K du = -q for the free nodes, du = 0 at the held ones, which K loses.
 * K may be indefinite (P' < 0 somewhere), in *negative directions.
 */
static enum status increment(const struct bar *bar, struct matrix *K,
                             const double q[], double du[], int *negative)
{
    const int ends[2] = {0, bar->n}, n_held = bar->held[0] + bar->held[1];
    const double zero[2] = {0.0, 0.0};

    for (int i = 0; i <= bar->n; i++) du[i] = -q[i];
    matrix_dirichlet(K, du, n_held, &ends[!bar->held[0]], zero,
                     UNIT_DIAGONAL);
    if (matrix_solve_indefinite(K, du, negative) != OK) return NOT_SPD;
    return isfinite(bar_max_free(bar, du)) ? OK : NONFINITE;
}

/* u := u + length du with the first length 1, 1/2, 1/4, ... at which the
 * energy is defined and decreases (Armijo, 1e-4 of the slope q.du). */
static enum status line_search(const struct bar *bar, const double q[],
                               const double du[], double energy, double u[],
                               double trial[], double *length)
{
    double slope = 0.0;
    for (int i = 0; i <= bar->n; i++) slope += q[i] * du[i]; /* dE/dlength */

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

struct newton_report bar_newton(const struct bar *bar,
                                const struct newton_control *control,
                                double u[], struct newton_step history[])
{
    const size_t size = (size_t)bar->n + 1;
    struct newton_report report = {MAX_ITERATIONS, 0, 0.0, 0.0};
    struct matrix *K = matrix_alloc(BANDED, bar->n + 1, 1);
    double *q = allocate(size, sizeof *q), *du = allocate(size, sizeof *du);
    double *trial = allocate(size, sizeof *trial);
    /* the limits of |q| and |du|: tolerance times modulus, times length */
    const double force = control->tolerance * material_modulus(&bar->material);
    const double length = control->tolerance * bar->n * bar->h;

    for (int k = 0;; k++) {
        struct newton_step step = {.residual = (double)NAN, .length = 1.0};
        int negative;

        report.status = bar_residual(bar, u, q);
        if (report.status == OK)
            report.status = bar_energy(bar, u, &step.energy);
        if (report.status == OK)
            report.residual = step.residual = bar_max_free(bar, q);
        if (history) {
            if (report.status != OK) step.energy = (double)NAN;
            step.min_F = bar_min_stretch(bar, u);
            history[k] = step;
        }
        if (report.status != OK) break;
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
            report.status = increment(bar, K, q, du, &negative);
        if (report.status == OK && negative > 0 &&
            (control->line_search || control->definite))
            report.status = NOT_SPD;
        if (report.status != OK) break;
        report.iterations = k + 1;
        report.increment = step.increment = bar_max_free(bar, du);
        if (control->line_search)
            report.status = line_search(bar, q, du, step.energy, u, trial,
                                        &step.length);
        else
            for (int i = 0; i <= bar->n; i++) u[i] += du[i];
        if (history) history[k] = step;
        if (report.status != OK) break;
    }
    free(q);
    free(du);
    free(trial);
    matrix_free(K);
    return report;
}
