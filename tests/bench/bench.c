/* bench.c - see bench.h.  Compiled with the flags of common/banded.c. */
#include "bench.h"

#include "clock.h"
#include "status.h"
#include "table.h"

#include <gsl/gsl_cblas.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef NATIVE_FLAGS
#define NATIVE_FLAGS ""
#endif

void times_record(struct times *t, double seconds, int valid)
{
    if (t->runs < SAMPLES) t->second[t->runs++] = valid ? seconds : (double)NAN;
}

double times_quantile(const struct times *t, double fraction)
{
    double sorted[SAMPLES];
    if (t->runs == 0) return (double)NAN;
    for (int i = 0; i < t->runs; i++)
        if (isnan(t->second[i])) return (double)NAN;
    memcpy(sorted, t->second, sizeof sorted);
    gsl_sort(sorted, 1, (size_t)t->runs);
    return gsl_stats_quantile_from_sorted_data(sorted, 1, (size_t)t->runs,
                                               fraction);
}

double times_median(const struct times *t)
{
    return times_quantile(t, 0.5);
}

double times_spread(const struct times *t)
{
    return (times_quantile(t, 1.0) - times_quantile(t, 0.0)) / times_median(t);
}

void row_of(int n, double value[])
{
    for (int i = 0; i < n; i++)
        if (isnan(value[i])) value[i] = 0.0;
    table_row_of(n, value);
}

void bench_header(void)
{
    char machine[512];
    clock_machine(sizeof machine, machine);
    printf("# machine: %s\n# banded.c, and body.c but for the last, with: %s\n"
           "# LAPACK: %s\n\n\n",
           machine, *NATIVE_FLAGS ? NATIVE_FLAGS : "nothing",
#ifdef LAPACK
           LAPACK
#else
           "none found"
#endif
    );
}

/*
 * 96 independent chains: enough to fill the pipelines of any machine.
 *
 * Their sum keeps the compiler from leaving the loop out, and is a call that
 * keeps GSL with the CBLAS of its own: a linker that drops libraries nobody
 * calls would drop -lgslcblas, and GSL would find OpenBLAS, which is here as
 * LAPACK, instead.
 */
double bench_peak_gigaflop(void)
{
    enum { CHAINS = 96, TIMES = 1000000 };
    const double x = 1.0 - 1e-9, y = 1e-9;
    double least = INFINITY, t[CHAINS];
    for (int run = 0; run < 7; run++) {
        for (int c = 0; c < CHAINS; c++) t[c] = 0.01 * c;
        const double start = clock_seconds();
        for (int k = 0; k < TIMES; k++)
#pragma GCC unroll 96
            for (int c = 0; c < CHAINS; c++) t[c] = t[c] * x + y;
        least = fmin(least, clock_seconds() - start);
        if (isnan(cblas_dasum(CHAINS, t, 1))) least = (double)NAN;
    }
    return 1e-9 * 2.0 * CHAINS * TIMES / least;
}

double bench_read_gigabyte(size_t bytes)
{
    enum { LANES = 64 };
    const size_t n = bytes / sizeof(double) / LANES * LANES;
    const size_t repeats = 1 + 100000000 / bytes;
    double *a = allocate(n, sizeof *a), least = INFINITY;
    for (size_t i = 0; i < n; i++) a[i] = 1.0; /* or no memory is behind it */
    for (int run = 0; run < 5; run++) {
        double sum[LANES] = {0.0};
        const double start = clock_seconds();
        for (size_t k = 0; k < repeats; k++) {
            for (size_t i = 0; i < n; i += LANES)
                for (int l = 0; l < LANES; l++) sum[l] += a[i + (size_t)l];
            a[k % n] += sum[k % LANES]; /* or one reading would be enough */
        }
        least = fmin(least, clock_seconds() - start);
    }
    free(a);
    return 1e-9 * (double)(repeats * n) * sizeof(double) / least;
}
