/*
 * machine.h - what the studies of speed ask the machine at hand: the limits of
 * one core, and LAPACK and CHOLMOD, where there are any.
 *
 * All in this header, because it is to be compiled with the flags of the study
 * that includes it: NATIVE_FLAGS names those for this machine, and LAPACK, when
 * defined, the library that was found.
 */
#ifndef FIGURES_MACHINE_H
#define FIGURES_MACHINE_H

#include "base/clock.h"
#include "linear/matrix.h"
#include "linear/sparse.h"

#include <gsl/gsl_cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef CHOLMOD
#include <cholmod.h>
#endif

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

/* ---- CHOLMOD, where there is one: MACHINE_RIVAL is not empty -------------
 *
 * For a sparse K, in its order, supernodal; analysed by rival_alloc().  False
 * when K is not positive definite.
 */
#ifdef CHOLMOD
/* The lower triangle of a sparse K by columns, and its factor. */
struct rival {
    cholmod_common common;
    cholmod_sparse *A;
    cholmod_factor *L;
};

/* Values of A (and with them its pattern, which does not change). */
static inline void rival_fill(struct rival *c, const struct matrix *K)
{
    const struct sparse *s = K->pattern;
    int *start = c->A->p, *row = c->A->i, k = 0;
    double *value = c->A->x;
    for (int v = 0; v < s->n_vertex; v++)
        for (int j = 0; j < 2; j++) {
            start[2 * v + j] = k;
            for (int b = s->start[v]; b < s->start[v + 1]; b++)
                for (int i = 0; i < 2; i++) {
                    if (2 * s->row[b] + i < 2 * v + j) continue;
                    row[k] = 2 * s->row[b] + i;
                    value[k++] = K->a[4 * b + 2 * j + i];
                }
        }
    start[K->n] = k;
}

static inline struct rival *rival_alloc(const struct matrix *K)
{
    struct rival *c = allocate(1, sizeof *c);
    const size_t n = (size_t)K->n;
    cholmod_start(&c->common);
    c->common.nmethods = 1;
    c->common.method[0].ordering = CHOLMOD_NATURAL;
    c->common.supernodal = CHOLMOD_SUPERNODAL;
    c->A = cholmod_allocate_sparse(n, n, K->size, 0, 1, -1, CHOLMOD_REAL,
                                   &c->common);
    rival_fill(c, K);
    c->L = cholmod_analyze(c->A, &c->common);
    return c;
}

static inline int rival_factor(struct rival *c, const struct matrix *K)
{
    rival_fill(c, K);
    cholmod_factorize(c->A, c->L, &c->common);
    return c->common.status == CHOLMOD_OK;
}

static inline void rival_solve(struct rival *c, double b[])
{
    const size_t n = c->A->nrow;
    cholmod_dense B = {.nrow = n, .ncol = 1, .nzmax = n, .d = n, .x = b,
                       .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE};
    cholmod_dense *x = cholmod_solve(CHOLMOD_A, c->L, &B, &c->common);
    memcpy(b, x->x, n * sizeof *b);
    cholmod_free_dense(&x, &c->common);
}

static inline void rival_free(struct rival *c)
{
    cholmod_free_factor(&c->L, &c->common);
    cholmod_free_sparse(&c->A, &c->common);
    cholmod_finish(&c->common);
    free(c);
}
#define MACHINE_RIVAL "cholmod"
#else
struct rival;
#define rival_alloc(K) ((void)(K), (struct rival *)NULL)
#define rival_factor(c, K) ((void)(c), (void)(K), 0)
#define rival_solve(c, b) ((void)(c), (void)(b))
#define rival_free(c) ((void)(c))
#define MACHINE_RIVAL ""
#endif

#endif
