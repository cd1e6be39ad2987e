/*
 * pairs.h - L-BFGS on the factors of an older K.
 *
 * A system whose increment is s, after which q has changed by y, says that
 * K s = y for a K on the way.  The old K^-1 is corrected so that K^-1 y = s for
 * the last pairs, by the two loops of Nocedal.
 *
 * Source: Liu, Bouaziz & Kavan, ACM Trans. Graph. 36 (2017) 23; Nocedal &
 *         Wright, Numerical Optimization, 2nd ed., sec. 7.2.
 *
 * Names: pairs_.
 */
#ifndef FIGURES_PAIRS_H
#define FIGURES_PAIRS_H

#include "linear/matrix.h"

enum { MOST_PAIRS = 5, PAIRS_ROOM }; /* room for one that is not learnt yet */
struct pairs {
    int n, count;   /* unknowns; pairs so far, of which the last are there */
    double *before; /* the last right-hand side; owned, and so are: */
    double *s[PAIRS_ROOM], *y[PAIRS_ROOM];
    double dot[PAIRS_ROOM]; /* s.y */
};
struct pairs pairs_make(int n);
void pairs_free(struct pairs *p);

/* The last increment of pairs_solve() and b make a pair: b is q after it. */
void pairs_learn(struct pairs *p, const double b[]);

/* b := K^-1 b by the factors in K and the last pairs, at most `most`; -b is the
 * increment.  Returns the flops of the pairs. */
double pairs_solve(struct pairs *p, int most, const struct matrix *K,
                   double b[]);

#endif
