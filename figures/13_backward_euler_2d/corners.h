/*
 * corners.h - a triangle of a scene, where it has moved to.
 */
#ifndef FIGURES_CORNERS_H
#define FIGURES_CORNERS_H

#include "plane/scene.h"

/* Set the corners of triangle e at u, x0 y0 x1 y1 x2 y2 (m).  Return its J. */
double corners_of(const struct scene *scene, int e, double x[6]);

#endif
