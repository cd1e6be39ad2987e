/* pairs.c - see pairs.h. */
#include "pairs.h"

#include <gsl/gsl_cblas.h>
#include <stdlib.h>
#include <string.h>

struct pairs pairs_make(int n)
{
    const size_t size = (size_t)n;
    struct pairs p = {.n = n, .before = allocate(size, sizeof *p.before)};
    for (int k = 0; k < PAIRS_ROOM; k++) {
        p.s[k] = allocate(size, sizeof **p.s);
        p.y[k] = allocate(size, sizeof **p.y);
    }
    return p;
}

void pairs_free(struct pairs *p)
{
    free(p->before);
    for (int k = 0; k < PAIRS_ROOM; k++) {
        free(p->s[k]);
        free(p->y[k]);
    }
}

void pairs_learn(struct pairs *p, const double b[])
{
    const int k = p->count % PAIRS_ROOM;
    for (int i = 0; i < p->n; i++) p->y[k][i] = b[i] - p->before[i];
    p->dot[k] = cblas_ddot(p->n, p->s[k], 1, p->y[k], 1);
    p->count += p->dot[k] > 0.0;
}

double pairs_solve(struct pairs *p, int most, const struct matrix *K,
                   double b[])
{
    const int n = K->n, first = p->count > most ? p->count - most : 0;
    double part[PAIRS_ROOM];
    memcpy(p->before, b, (size_t)n * sizeof *b);
    for (int i = p->count - 1; i >= first; i--) {
        const int k = i % PAIRS_ROOM;
        part[k] = cblas_ddot(n, p->s[k], 1, b, 1) / p->dot[k];
        cblas_daxpy(n, -part[k], p->y[k], 1, b, 1);
    }
    matrix_solve(K, b);
    for (int i = first; i < p->count; i++) {
        const int k = i % PAIRS_ROOM;
        const double back = cblas_ddot(n, p->y[k], 1, b, 1) / p->dot[k];
        cblas_daxpy(n, part[k] - back, p->s[k], 1, b, 1);
    }
    for (int i = 0; i < n; i++) p->s[p->count % PAIRS_ROOM][i] = -b[i];
    return 8.0 * n * (p->count - first);
}
