/*
 * cells.h - which triangles, and how many: a model of ladder.h at rest under
 * its full load, with linear and with quadratic triangles, on even meshes and
 * on such that are graded towards the corners of what is held.
 *
 * No estimate says what a quadratic triangle leaves out, so it is computed:
 * the best mesh, quadratic, graded and the finest of all, is where the others
 * are measured from.  Its own error is that of the one before it over
 * 2^1.42 - 1, 1.42 being the order that a held corner leaves [eq:corner], and
 * is added to that of each.
 */
#ifndef CHOOSE_CELLS_H
#define CHOOSE_CELLS_H

#include "choice/ladder.h"

enum { CELLS_LEVELS = 3, CELLS_KINDS = 4, CELLS = 12 }; /* in all */
struct cells {
    enum element element;
    double grade;  /* 1, or the 2 of mesh_grade() */
    int level;     /* as in ladder_model, of half edges where quadratic */
    int solved;    /* 0: it has no stable state, and nothing below is known */
    double error;  /* of the scene's quantity, relative, for the mesh alone */
    double flops;  /* of the solve at rest */
};

/* Try each kind on each level.  false: the best one has no stable state, and no
 * error is known. */
int cells_compare(const struct ladder_scene *scene, enum rung rung,
                  struct cells cells[CELLS]);

/* Return the one with the fewest flops whose error is at most `room`, or
 * NULL. */
const struct cells *cells_cheapest(
    const struct cells cells[CELLS], double room);

/* Return "linear" or "quadratic". */
const char *cells_name(enum element element);

#endif
