/*
 * csr.h - sparse matrices by compressed rows, for methods that are read.
 *
 *     | 4 . 7 |     start  = 0 2 3 5
 *     | . 5 . |     index  = 0 2 1 0 2       the entries of row i are those
 *     | 7 . 6 |     value  = 4 7 5 7 6       from start[i] to start[i + 1]
 *
 * Of a symmetric matrix both triangles are kept; the columns of a row ascend.
 */
#ifndef COMMON_CSR_H
#define COMMON_CSR_H

#include "base/status.h"

struct csr {
    int n;         /* order */
    int *start;    /* [n + 1] */
    int *index;    /* [start[n]] columns */
    double *value; /* [start[n]] */
};

/* Return no entries yet, and room for so many; start is all 0.  The caller
 * frees. */
struct csr *csr_alloc(int n, int room);
void csr_free(struct csr *A);

/* y := A x. */
void csr_multiply(const struct csr *A, const double x[], double y[]);

/* Return |b - A x| / |b|, Euclidean norms; NaN if an entry is one. */
double csr_residual(const struct csr *A, const double x[], const double b[]);

/* L of K = L L^T by compressed columns: column j is row[p] and value[p],
 * start[j] <= p < end[j]; rows ascend, the diagonal entry is first. */
struct factor {
    int n;
    int *start, *end; /* [n + 1], [n] */
    int *row;         /* [start[n]] */
    double *value;    /* [start[n]] */
};

/* Return room for count[j] entries in column j.  The caller frees it. */
struct factor *csr_factor_alloc(int n, const int count[]);
void csr_factor_free(struct factor *L);

/* b := L^-T L^-1 b. */
void csr_factor_solve(const struct factor *L, double b[]);

#endif
