/*
 * strip.h - a strip of tissue, 10 cm by 3 cm, cut from above in its middle by
 * the knife of lesson 26; the left end is held, and a hand pulls at the right.
 *
 * It is a section of tissue.h, n cells wide and 3 n / 10 high.
 *
 * The notes' material under LOG, quasistatic, a depth of 1 cm.
 *
 * Names: strip_.
 */
#ifndef FIGURES_STRIP_H
#define FIGURES_STRIP_H

#include "plane/tissue.h"

struct strip {
    int n, rows;
    struct tissue uncut, s; /* owned, and so are these; its state is in s */
    struct body *body;
    double *g, *q;     /* [2 n_vertex] hand, forces */
    double force;      /* in the hand, along the strip (N) */
    double energy;     /* (J) */
    double opening;    /* between the lips, at most (m) */
};

/* Return the section, cut by the knife of lesson 26 from (blade[0], blade[1])
 * to (blade[2], blade[3]); nothing pulls at it.  The caller frees it. */
struct tissue strip_knife(const struct tissue *section, const double blade[4]);

/* The cut goes through so many cells; the caller frees it. */
struct strip strip_alloc(int n, int cells);
void strip_free(struct strip *s);

/* On to the pull d (m), from the elastic lift of the state before; dies where
 * there is no stable balance. */
void strip_pull(struct strip *s, double d);

/* Cut the whole strip as it is pulled, with both lips where the column was, and
 * let s find its balance from there.  Returns the linear systems. */
int strip_cut(const struct strip *whole, struct strip *s);

#endif
