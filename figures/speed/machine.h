/*
 * machine.h - what the studies of speed ask the machine at hand: the limits of
 * one core, and LAPACK, where there is one.
 *
 * All in this header, because it is to be compiled with the flags of the study
 * that includes it: NATIVE_FLAGS names those for this machine, and LAPACK, when
 * defined, the library that was found.
 */
#ifndef FIGURES_MACHINE_H
#define FIGURES_MACHINE_H

#include "base/clock.h"
#include "linear/matrix.h"

#include <gsl/gsl_cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifndef NATIVE_FLAGS
#define NATIVE_FLAGS ""
#endif
#ifdef LAPACK
#define MACHINE_LAPACK LAPACK
/* Up to ten parameters: LAPACK's own. */
void dpbtrf_(const char *uplo, const int *n, const int *p, double a[],
             const int *lda, int *info, size_t length);
void dpbtrs_(const char *uplo, const int *n, const int *p, const int *columns,
             const double a[], const int *lda, double b[], const int *ldb,
             int *info, size_t length);
#else
#define MACHINE_LAPACK ""
#endif

/* matrix_factor() and matrix_solve() by LAPACK; false when K is not positive
 * definite, or when there is no LAPACK. */
static inline int lapack_factor(struct matrix *K)
{
    int info = 1;
#ifdef LAPACK
    const int lda = (int)K->stride;
    dpbtrf_("L", &K->n, &K->p, K->a, &lda, &info, 1);
#else
    (void)K;
#endif
    return info == 0;
}

static inline void lapack_solve(const struct matrix *L, double b[])
{
#ifdef LAPACK
    const int lda = (int)L->stride, one = 1;
    int info;
    dpbtrs_("L", &L->n, &L->p, &one, L->a, &lda, b, &L->n, &info, 1);
#else
    (void)L, (void)b;
#endif
}

/*
 * Multiply-adds in registers: 1e9 flops per second of one core, at its best.
 * 96 independent chains are enough to fill the pipelines of any machine.
 *
 * Their sum keeps the compiler from leaving the loop out, and is a call that
 * keeps GSL with the CBLAS of its own: a linker that drops libraries nobody
 * calls would drop -lgslcblas, and GSL would find OpenBLAS, which is here as
 * LAPACK, instead.
 */
static inline double machine_peak_gigaflop(void)
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

/* Reading `bytes` again and again, in order: 1e9 bytes per second of one
 * core. */
static inline double machine_read_gigabyte(size_t bytes)
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

#endif
