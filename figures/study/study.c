/* study.c - see study.h. */
#include "study.h"

#include "base/clock.h"
#include "base/status.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double study_root(study_function *f, void *context, double low, double high)
{
    if (low > high) return study_root(f, context, high, low);
    const double f_low = f(low, context), f_high = f(high, context);
    if (f_low == 0.0) return low;
    if (f_high == 0.0) return high;
    if (!(f_low < 0.0 && f_high > 0.0) && !(f_low > 0.0 && f_high < 0.0))
        die("no change of sign between %g and %g: %g, %g", low, high, f_low,
            f_high);
    gsl_function function = {f, context};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (!solver) die("out of memory");
    gsl_error_handler_t *old = gsl_set_error_handler_off();
    gsl_root_fsolver_set(solver, &function, low, high);
    for (int k = 0; k < 200; k++) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS)
            die("no root between %g and %g: the function is not finite", low,
                high);
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver),
                                   gsl_root_fsolver_x_upper(solver), 0.0,
                                   1e-15) == GSL_SUCCESS)
            break;
    }
    gsl_set_error_handler(old);
    const double root = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return root;
}

double study_order(double coarse, double fine, double ratio)
{
    if (!(coarse > 0.0) || !(fine > 0.0)) return (double)NAN;
    return log(coarse / fine) / log(ratio);
}

void study_claim_failed(const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    die("the claim is false: %s", text);
}

double rate_error(int hits, int runs)
{
    const double p = (hits + 1.0) / (runs + 2.0);
    return sqrt(p * (1.0 - p) / (runs + 3.0));
}

double rate_apart(int hits, int runs, int other_hits, int other_runs)
{
    return (1.0 * hits / runs - 1.0 * other_hits / other_runs) /
           hypot(rate_error(hits, runs), rate_error(other_hits, other_runs));
}

void times_record(struct times *t, double seconds, int valid)
{
    if (t->runs < STUDY_SAMPLES)
        t->second[t->runs++] = valid ? seconds : (double)NAN;
}

double times_quantile(const struct times *t, double fraction)
{
    double sorted[STUDY_SAMPLES];
    if (t->runs == 0) return (double)NAN;
    for (int i = 0; i < t->runs; i++)
        if (isnan(t->second[i])) return (double)NAN;
    memcpy(sorted, t->second, sizeof sorted);
    gsl_sort(sorted, 1, (size_t)t->runs);
    return gsl_stats_quantile_from_sorted_data(sorted, 1, (size_t)t->runs,
                                               fraction);
}

double times_best(const struct times *t)
{
    return times_quantile(t, 0.0);
}

double times_median(const struct times *t)
{
    return times_quantile(t, 0.5);
}

void study_machine(void)
{
    char machine[512];
    clock_machine(sizeof machine, machine);
    printf("# machine: %s\n\n\n", machine);
}
