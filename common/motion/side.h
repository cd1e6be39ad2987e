/*
 * side.h - the square in your hand, whose right side you drag.
 *
 * Its left side is held.  So is the right one while the pointer holds it: it
 * goes along as it is.  Let go, it is free.  Nothing here moves the rest.
 */
#ifndef COMMON_SIDE_H
#define COMMON_SIDE_H

#include "motion/view.h"
#include "plane/scene.h"

enum { SIDE_FRAMES = 150 };

struct side {
    struct scene *scene[2]; /* right side free, held; owned, as all of it */
    struct scene *now;      /* one of them; it has the state */
    double *x, *J, *start;  /* drawn; u when the side was grabbed (m) */
    double from[2];         /* where it was grabbed (m) */
    double min_J;
    int lost; /* frames, for the scene to count */
    int n_curve;
    double curve[2 * SIDE_FRAMES]; /* side_energy() */
};

/* Return the square of scene.h, or, slender > 1, a strip, at rest without a
 * load. */
struct side *side_alloc(enum law law, int n, int slender);
void side_free(struct side *side);

/* Return whether the right side is held now. */
int side_held(const struct side *side);

/* Grab, move or let go as the pointer says: the scene of this frame,
 * with its prescribed values in g; `r` takes it to rest, `l` to the other law,
 * LOG or CUBIC. */
struct scene *side_next(struct side *side, const struct pointer *pointer);

/* The state as a picture; value is J, and min_J the least. */
struct view_picture side_picture(struct side *side);

/* Return kinetic + elastic energy (J), added to the curve of the last
 * SIDE_FRAMES frames in the picture, a decade 0.25 m high; INFINITY is left
 * out. */
double side_energy(struct side *side, struct view_picture *picture);

#endif
