/* cg.c - see cg.h. */
#include "linear/cg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void cg_jacobi(const void *csr, const double r[], double z[])
{
    const struct csr *K = csr;
    for (int i = 0; i < K->n; i++)
        for (int k = K->start[i]; k < K->start[i + 1]; k++)
            if (K->index[k] == i) z[i] = r[i] / K->value[k];
}

void cg_incomplete(const void *factor, const double r[], double z[])
{
    const struct factor *L = factor;
    memcpy(z, r, (size_t)L->n * sizeof *z);
    csr_factor_solve(L, z);
}

/* Return K's lower triangle by columns, which have the length of the rows. */
static struct factor *lower_triangle(const struct csr *K)
{
    int *count = allocate((size_t)K->n, sizeof *count);
    for (int j = 0; j < K->n; j++)
        for (int k = K->start[j]; k < K->start[j + 1]; k++)
            count[j] += K->index[k] >= j;
    struct factor *L = csr_factor_alloc(K->n, count);
    for (int j = 0; j < K->n; j++)
        for (int k = K->start[j]; k < K->start[j + 1]; k++)
            if (K->index[k] >= j) {
                L->row[L->end[j]] = K->index[k];
                L->value[L->end[j]++] = K->value[k];
            }
    free(count);
    return L;
}

/* Column by column; an update that would fall beside the pattern is dropped. */
struct factor *cg_factor(const struct csr *K)
{
    struct factor *L = lower_triangle(K);
    int *spot = allocate((size_t)K->n, sizeof *spot), j; /* in l, or 0 */
    for (j = 0; j < K->n; j++) {
        double *l = &L->value[L->start[j]];
        const int *row = &L->row[L->start[j]], m = L->end[j] - L->start[j];
        if (!(l[0] > 0.0)) break;
        l[0] = sqrt(l[0]); /* L_jj */
        for (int a = 1; a < m; a++) {
            l[a] /= l[0];
            spot[row[a]] = a;
        }
        /* columns k = row[a] > j: A_ik -= L_ij L_kj */
        for (int a = 1; a < m; a++)
            for (int q = L->start[row[a]]; q < L->end[row[a]]; q++)
                if (spot[L->row[q]]) L->value[q] -= l[a] * l[spot[L->row[q]]];
        for (int a = 1; a < m; a++) spot[row[a]] = 0;
    }
    free(spot);
    if (j == K->n) return L;
    csr_factor_free(L);
    return NULL;
}
