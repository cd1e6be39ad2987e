/*
 * strip.h - a strip of tissue, 10 cm by 3 cm, with a cut from above in its
 * middle; the left end is held, and a hand pulls at the right one.
 *
 *     o--o--o  o--o--o    n cells along and 3 n / 10 across.  Column n / 2 of
 *     |  |  |  |  |  |    vertices is there twice, as n / 2 + 1, for the two
 *     o--o--o  o--o--o    lips; up to row `tip` both are the first, and the
 *     |  |   \/   |  |    second, which no triangle has, is held.  With the tip
 *     o--o----o---o--o    on top the strip is whole.
 *
 * The notes' material under LOG, quasistatic, a depth of 1 cm.
 *
 * Names: strip_.
 */
#ifndef FIGURES_STRIP_H
#define FIGURES_STRIP_H

#include "plane/mesh.h"

struct strip {
    int n, rows, tip;
    struct mesh *mesh; /* owned, and so are these */
    struct body *body;
    double *u, *g, *q; /* [2 n_vertex] state, hand, forces */
    double force;      /* in the hand, along the strip (N) */
    double energy;     /* (J) */
    double opening;    /* between the lips on top (m) */
};

/* The caller frees it. */
struct strip strip_alloc(int n, int tip);
void strip_free(struct strip *s);

/* On to the pull d (m), from the elastic lift of the state before; dies where
 * there is no stable balance. */
void strip_pull(struct strip *s, double d);

/* Cut the whole strip as it is pulled, with both lips where the column was, and
 * let s find its balance from there.  Returns the linear systems. */
int strip_cut(const struct strip *whole, struct strip *s);

#endif
