/*
 * rival.h - other solvers in the place of sparse.h: CHOLMOD, supernodal, in the
 * order of nested dissection, and LAPACK's band, row by row, where there are
 * any.  K is assembled as ever, and step.h does not know who factors it, so
 * that guess, lift, kept factors and stop are the same.
 */
#ifndef FIGURES_RIVAL_H
#define FIGURES_RIVAL_H

#include "machine.h"
#include "linear/sparse.h"
#include "plane/body.h"
#ifdef CHOLMOD
#include "one_thread.h"

#include <cholmod.h>
#endif

struct rival {
    int lapack; /* 0: CHOLMOD */
    struct matrix_sparse methods;
#ifdef CHOLMOD
    cholmod_common common; /* the lower triangle by columns, and its factor */
    cholmod_sparse *A;
    cholmod_factor *L;
#endif
    struct matrix *band;
    int *number; /* [n_vertex] of a place in the band */
    double *x;
};

/* Who factors now: set by whoever takes a turn. */
static struct rival *rival_now;

#ifdef CHOLMOD
/* Values of A (and with them its pattern, which does not change). */
static inline void cholmod_fill(struct rival *c, const struct sparse *s,
                                const double a[])
{
    int *start = c->A->p, *row = c->A->i, k = 0;
    double *value = c->A->x;
    for (int v = 0; v < s->n_vertex; v++)
        for (int j = 0; j < 2; j++) {
            start[2 * v + j] = k;
            for (int b = s->start[v]; b < s->start[v + 1]; b++)
                for (int i = 0; i < 2; i++) {
                    if (2 * s->row[b] + i < 2 * v + j) continue;
                    row[k] = 2 * s->row[b] + i;
                    value[k++] = a[4 * b + 2 * j + i];
                }
        }
    start[2 * s->n_vertex] = k;
}

static inline void cholmod_make(struct rival *c, const struct matrix *K)
{
    const size_t n = (size_t)K->n;
    cholmod_start(&c->common);
    c->common.nmethods = 1;
    c->common.method[0].ordering = CHOLMOD_NATURAL;
    c->common.supernodal = CHOLMOD_SUPERNODAL;
    c->A = cholmod_allocate_sparse(n, n, K->size, 0, 1, -1, CHOLMOD_REAL,
                                   &c->common);
    cholmod_fill(c, K->pattern, K->a);
    c->L = cholmod_analyze(c->A, &c->common);
}

static inline void cholmod_answer(struct rival *c, double b[])
{
    const size_t n = c->A->nrow;
    cholmod_dense B = {.nrow = n, .ncol = 1, .nzmax = n, .d = n, .x = b,
                       .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE};
    cholmod_dense *x = cholmod_solve(CHOLMOD_A, c->L, &B, &c->common);
    memcpy(b, x->x, n * sizeof *b);
    cholmod_free_dense(&x, &c->common);
}
#define MACHINE_CHOLMOD "cholmod"
#else
#define MACHINE_CHOLMOD ""
#endif

/* The band of K, whatever the body holds. */
static inline void band_make(struct rival *c, const struct body *body)
{
    const struct sparse *s = body->pattern;
    const int *place = s->place, n = body->mesh->n;
    int next = 0, p = 1;
    c->number = allocate((size_t)s->n_vertex, sizeof *c->number);
    c->x = allocate((size_t)body->K->n, sizeof *c->x);
    for (int v = 0; v < body->mesh->n_vertex; v++) { /* rows from the right */
        const int at = place[v + n - 2 * (v % (n + 1))];
        if (at >= 0) c->number[at] = next++;
    }
    for (int v = 0; v < s->n_vertex; v++)
        for (int b = s->start[v]; b < s->start[v + 1]; b++) {
            const int apart = 2 * abs(c->number[s->row[b]] - c->number[v]) + 1;
            if (apart > p) p = apart;
        }
    c->band = matrix_alloc(BANDED, body->K->n, p);
}

static inline void band_fill(struct rival *c, const struct sparse *s,
                             const double a[])
{
    matrix_zero(c->band);
    for (int v = 0; v < s->n_vertex; v++)
        for (int b = s->start[v]; b < s->start[v + 1]; b++)
            for (int k = 0; k < 4; k++) {
                const int i = 2 * c->number[s->row[b]] + k % 2;
                const int j = 2 * c->number[v] + k / 2;
                if (i >= j) matrix_add(c->band, i, j, a[4 * b + k]);
                else matrix_add(c->band, j, i, a[4 * b + k]); /* or zero */
            }
}

static inline void rival_solve(const struct sparse *s, int single,
                               double memory[], double b[])
{
    struct rival *c = rival_now;
    (void)single, (void)memory;
#ifdef CHOLMOD
    if (!c->lapack) {
        cholmod_answer(c, b);
        return;
    }
#endif
    for (int v = 0; v < s->n_vertex; v++)
        memcpy(&c->x[2 * c->number[v]], &b[2 * v], 2 * sizeof *b);
    lapack_solve(c->band, c->x);
    for (int v = 0; v < s->n_vertex; v++)
        memcpy(&b[2 * v], &c->x[2 * c->number[v]], 2 * sizeof *b);
}

static inline enum status rival_factor(const struct sparse *s, const double a[],
                                       int single, double memory[], double b[])
{
    struct rival *c = rival_now;
    int fine = 0;
    if (c->lapack) {
        band_fill(c, s, a);
        fine = lapack_factor(c->band);
    }
#ifdef CHOLMOD
    if (!c->lapack) {
        cholmod_fill(c, s, a);
        cholmod_factorize(c->A, c->L, &c->common);
        fine = c->common.status == CHOLMOD_OK;
    }
#endif
    if (fine && b) rival_solve(s, single, memory, b);
    return fine ? OK : NOT_SPD;
}

/* From now on K of the body, which is sparse, is its. */
static inline struct rival *rival_alloc(int lapack, struct body *body)
{
    struct rival *c = allocate(1, sizeof *c);
    struct matrix *K = body->K;
    c->lapack = lapack;
    c->methods = *K->sparse;
    c->methods.factor = rival_factor;
    c->methods.solve = rival_solve;
    if (lapack) band_make(c, body);
#ifdef CHOLMOD
    if (!lapack) cholmod_make(c, K);
#endif
    K->sparse = &c->methods;
    return c;
}

static inline void rival_free(struct rival *c)
{
    if (!c) return;
#ifdef CHOLMOD
    if (!c->lapack) {
        cholmod_free_factor(&c->L, &c->common);
        cholmod_free_sparse(&c->A, &c->common);
        cholmod_finish(&c->common);
    }
#endif
    matrix_free(c->band);
    free(c->number);
    free(c->x);
    free(c);
}

#endif
