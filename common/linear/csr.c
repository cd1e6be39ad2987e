/* csr.c - see csr.h. */
#include "linear/csr.h"

#include <math.h>
#include <stdlib.h>

struct csr *csr_alloc(int n, int room)
{
    struct csr *A = allocate(1, sizeof *A);
    A->n = n;
    A->start = allocate((size_t)n + 1, sizeof *A->start);
    A->index = allocate((size_t)room, sizeof *A->index);
    A->value = allocate((size_t)room, sizeof *A->value);
    return A;
}

void csr_free(struct csr *A)
{
    if (!A) return;
    free(A->start);
    free(A->index);
    free(A->value);
    free(A);
}

void csr_multiply(const struct csr *A, const double x[], double y[])
{
    for (int i = 0; i < A->n; i++) {
        double sum = 0.0;
        for (int k = A->start[i]; k < A->start[i + 1]; k++)
            sum += A->value[k] * x[A->index[k]];
        y[i] = sum;
    }
}

double csr_residual(const struct csr *A, const double x[], const double b[])
{
    double *y = allocate((size_t)A->n, sizeof *y), r = 0.0, size = 0.0;
    csr_multiply(A, x, y);
    for (int i = 0; i < A->n; i++) {
        r += (b[i] - y[i]) * (b[i] - y[i]);
        size += b[i] * b[i];
    }
    free(y);
    return sqrt(r / size);
}

struct factor *csr_factor_alloc(int n, const int count[])
{
    struct factor *L = allocate(1, sizeof *L);
    L->n = n;
    L->start = allocate((size_t)n + 1, sizeof *L->start);
    L->end = allocate((size_t)n, sizeof *L->end);
    for (int j = 0; j < n; j++) {
        L->end[j] = L->start[j];
        L->start[j + 1] = L->start[j] + count[j];
    }
    L->row = allocate((size_t)L->start[n], sizeof *L->row);
    L->value = allocate((size_t)L->start[n], sizeof *L->value);
    return L;
}

void csr_factor_free(struct factor *L)
{
    if (!L) return;
    free(L->start);
    free(L->end);
    free(L->row);
    free(L->value);
    free(L);
}

void csr_factor_solve(const struct factor *L, double b[])
{
    for (int j = 0; j < L->n; j++) {
        b[j] /= L->value[L->start[j]];
        for (int p = L->start[j] + 1; p < L->end[j]; p++)
            b[L->row[p]] -= L->value[p] * b[j]; /* L y = b, by columns */
    }
    for (int j = L->n - 1; j >= 0; j--) {
        for (int p = L->start[j] + 1; p < L->end[j]; p++)
            b[j] -= L->value[p] * b[L->row[p]]; /* L^T x = y, by rows of L^T */
        b[j] /= L->value[L->start[j]];
    }
}
