/*
 * bench.h - what the speed programs share: samples of seconds, rows of tables,
 * and two limits of the machine at hand.
 *
 * A time that does not count (a wrong answer, a method that failed or did not
 * take part) is NAN inside these programs and 0 in their tables.
 */
#ifndef BENCH_H
#define BENCH_H

#include <stddef.h>

enum { SAMPLES = 1024 };
struct times {
    int runs;
    double second[SAMPLES];
};

/* One more sample, as long as there is room. */
void times_record(struct times *t, double seconds, int valid);

/* Of the samples, all of which must be valid; NAN if one is not, or none. */
double times_median(const struct times *t);
double times_quantile(const struct times *t, double fraction);
double times_spread(const struct times *t); /* (largest - smallest) / median */

/* A row of a table: row(n, seconds); */
#define row(...)                                                   \
    row_of((int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)), \
           (double[]){__VA_ARGS__})
void row_of(int n, double value[]);

/* The line "# machine: ..." and the flags, once at the top of the output. */
void bench_header(void);

/* Multiply-adds in registers: 1e9 flops a second of one core, at its best. */
double bench_peak_gigaflop(void);

/* LAPACK's banded Cholesky, where there is one: a[j*lda + d] = A[j+d][j]. */
#ifdef LAPACK
void dpbtrf_(const char *uplo, const int *n, const int *p, double a[],
             const int *lda, int *info, size_t length);
void dpbtrs_(const char *uplo, const int *n, const int *p, const int *columns,
             const double a[], const int *lda, double b[], const int *ldb,
             int *info, size_t length);
#endif

/* Reading `bytes` again and again, in order: GB/s of one core. */
double bench_read_gigabyte(size_t bytes);

#endif
