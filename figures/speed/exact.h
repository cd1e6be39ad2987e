/*
 * exact.h - dissection whose factors stay in double precision, where step.h
 * keeps them rounded: what rounding gains is measured against it.
 */
#ifndef FIGURES_EXACT_H
#define FIGURES_EXACT_H

#include "linear/sparse.h"
#include "plane/body.h"

static inline size_t exact_size(const struct sparse *s, int single)
{
    (void)single;
    return sparse_size(s, 0);
}

static inline enum status exact_factor(const struct sparse *s, const double a[],
                                       int single, double memory[], double b[])
{
    (void)single;
    return sparse_factor(s, a, 0, memory, b);
}

static inline void exact_solve(const struct sparse *s, int single,
                               double memory[], double b[])
{
    (void)single;
    sparse_solve(s, 0, memory, b);
}

/* From now on K of the body, where it is sparse, is factored so. */
static inline void exact_factors(struct body *body)
{
    static struct matrix_sparse methods;
    if (body->K->storage != SPARSE) return;
    methods = *body->K->sparse;
    methods.size = exact_size;
    methods.factor = exact_factor;
    methods.solve = exact_solve;
    matrix_keep_single(body->K, 0); /* and the room of L is made anew */
    body->K->sparse = &methods;
    body->kept.usable = 0;
}

#endif
