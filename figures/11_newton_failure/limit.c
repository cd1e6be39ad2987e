/* limit.c - see limit.h. */
#include "limit.h"
#include "../study/study.h"

#include <math.h>

static const double far = 8.0; /* nothing happens beyond */

static double P(double F, void *m) { return material1_pk1(m, F); }
static double dP(double F, void *m) { return material1_dpk1(m, F); }
static double ddP(double F, void *context)
{
    const struct material *m = context;
    const struct volumetric v = material_r(m, F);
    const double dddr = m->law == LOG ? 2.0 / (F * F * F) : 2.0;
    return 3.0 * m->lambda * v.dr * v.ddr + (m->lambda * v.r - m->mu) * dddr;
}

/* The root of f between a and b, NAN where there is none. */
static double zero(study_function *f, void *m, double a, double b)
{
    return a < b && f(a, m) * f(b, m) < 0.0 ? study_root(f, m, a, b)
                                            : (double)NAN;
}

/* Where P' is smallest, and where P is. */
static double bend(void *m)
{
    return fmin(far, zero(ddP, m, 1.0, far));
}
static double lowest(void *m)
{
    return fmin(far, zero(dP, m, bend(m), far));
}

double limit_point(struct material *m)
{
    return zero(dP, m, 1.0, bend(m));
}

double limit_rest(struct material *m)
{
    return zero(P, m, limit_point(m), lowest(m));
}

double limit_least_slope(struct material *m)
{
    return dP(bend(m), m);
}

double limit_least_stress(struct material *m)
{
    return P(lowest(m), m);
}
