/*
 * film.h - the live square as triangles, for a moving picture.
 *
 *     table_begin("motion", FILM);
 *     for each frame k
 *         film_frame(live, 3, k, pointer);      of every third frame
 *     table_end();
 */
#ifndef COMMON_FILM_H
#define COMMON_FILM_H

#include "motion/live.h"

#define FILM "k J x0 y0 x1 y1 x2 y2 pointer_x pointer_y down"

/* Print, where k is a multiple of `every`, a row for each triangle: its J and
 * corners now, and the pointer. */
void film_frame(const struct live *live, int every, int k,
                const struct pointer *pointer);

#endif
