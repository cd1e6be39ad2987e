/*
 * swing.h - a large swing of the square, and the norm in which it is measured.
 */
#ifndef FIGURES_SWING_H
#define FIGURES_SWING_H

#include "motion/integrate.h"

/* Return, at rest, a large smooth swing of the square, 0 at both ends and at
 * what is prescribed: u = size (0.4 sin(pi X1), cos(pi X1 / 2)). */
struct state swing_start(const struct body *body, double size);

/* Return (v.M v)^(1/2) */
double swing_norm(const struct model *model, const double v[]);

#endif
