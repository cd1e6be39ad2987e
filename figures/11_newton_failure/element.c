/* element.c - see element.h. */
#include "element.h"

#include <float.h>
#include <math.h>

/* MAX_ITERATIONS: go on with *step. */
static enum status next_step(const struct material *material, double p,
                             double F, double increment, double tolerance,
                             double *step)
{
    if (!material_defined(material, F)) return INVERTED;
    const double residual = material1_pk1(material, F) - p;
    const double small = tolerance * material_modulus(material);
    *step = -residual / material1_dpk1(material, F);
    if (residual == 0.0) return OK;
    if (!isfinite(residual) || !isfinite(*step)) return NONFINITE;
    if (fabs(residual) <= small && increment <= tolerance) return OK;
    return increment <= DBL_EPSILON ? STALLED : MAX_ITERATIONS;
}

/* The first length 1, 1/2, 1/4, ... with Armijo's decrease, 1e-4 of the slope;
 * close to the minimum the energy has no digits left to compare. */
static enum status search_length(const struct material *material, double p,
                                 double F, double step, double *length)
{
    const double w = material1_psi(material, F) - p * (F - 1.0);
    const double slope = (material1_pk1(material, F) - p) * step;
    const double noise = 16.0 * DBL_EPSILON * fabs(w);

    if (!(slope < 0.0)) return NOT_SPD;
    for (*length = 1.0; *length > 1e-12; *length *= 0.5) {
        const double trial = F + *length * step;
        if (!material_defined(material, trial)) continue;
        if (material1_psi(material, trial) - p * (trial - 1.0) <=
            w + 1e-4 * *length * slope + noise)
            return OK;
    }
    return STALLED;
}

struct element_report element_newton(const struct material *material, double p,
                                     double F,
                                     const struct newton_control *control)
{
    struct element_report report = {MAX_ITERATIONS, 0, F};
    double increment = INFINITY;
    for (;;) {
        double step, length = 1.0;
        report.status = next_step(material, p, report.F, increment,
                                  control->tolerance, &step);
        if (report.status != MAX_ITERATIONS) return report;
        if (report.iterations >= control->max_iterations) return report;
        report.iterations++;
        if (control->line_search) {
            report.status = search_length(material, p, report.F, step, &length);
            if (report.status != OK) return report;
        }
        report.F += length * step;
        increment = fabs(step);
    }
}

struct element_report element_stepping(const struct material *material,
                                       double p, double jump,
                                       const struct newton_control *control)
{
    struct newton_control attempt = *control;
    struct element_report report = {OK, 0, 1.0};
    double s = 0.0, ds = 1.0;

    while (s < 1.0 && report.status == OK) {
        const int left = control->max_iterations - report.iterations;
        attempt.max_iterations = left < 25 ? left : 25;
        ds = fmin(ds, 1.0 - s);
        const struct element_report trial = element_newton(
            material, (s + ds) * p, report.F - ds * jump, &attempt);
        report.iterations += trial.iterations;
        if (trial.status == OK) {
            report.F = trial.F;
            s += ds;
            ds *= 2.0;
        } else {
            ds *= 0.5;
            if (ds < ldexp(1.0, -10)) report.status = STALLED;
            if (report.iterations >= control->max_iterations)
                report.status = MAX_ITERATIONS;
        }
    }
    return report;
}

struct element_report element_cured(enum cure cure, struct material material,
                                    double p, double jump, int n,
                                    struct newton_control control)
{
    double F = 1.0 - jump;
    if (cure == CURE_STEPPING)
        return element_stepping(&material, p, jump, &control);
    if (cure == CURE_SEARCH) control.line_search = 1;
    if (cure == CURE_CUBIC) material.law = CUBIC;
    if (cure == CURE_START)
        F = p == 0.0 ? 1.0 - jump / n : exp(p / material_modulus(&material));
    return element_newton(&material, p, F, &control);
}
