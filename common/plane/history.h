/*
 * history.h - what lessons in the plane print: Newton's method system by
 * system, and the vertices of a scene.
 *
 *     # newton                               # nodes
 *     k  residual  increment  status         X  Y  u_x  u_y  q_x  q_y  held
 *     0  0.044     0.026      -              ...
 *     1  0.0025    -          NOT_SPD
 */
#ifndef COMMON_HISTORY_H
#define COMMON_HISTORY_H

#include "plane/scene.h"
#include "base/table.h"

enum { HISTORY_CAP = 40 };

/* How Newton's method went. */
struct history {
    enum status status; /* OK, INVERTED, NOT_SPD, NONFINITE, MAX_ITERATIONS */
    int iterations;     /* linear systems solved, at most HISTORY_CAP */
    double residual[HISTORY_CAP + 1];  /* max|q| before system k */
    double increment[HISTORY_CAP + 1]; /* max|du| of system k (m) */
};

/* A row for each linear system, and one for what was not solved, with the
 * reason.  Its residual is left out where there is none (INVERTED, NONFINITE),
 * and where it is round-off (OK). */
void history_table(const char *name, const struct history *history);

/* The vertices: where they rest, u, the components of w, which the columns
 * call name_x and name_y, and whether they are held. */
void history_nodes(const struct scene *scene, const char *name,
                   const double w[]);

#endif
