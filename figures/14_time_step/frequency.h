/* frequency.h - how fast a model can swing. */
#ifndef FIGURES_FREQUENCY_H
#define FIGURES_FREQUENCY_H

#include "motion/model.h"

/*
 * Return the largest frequency omega at rest (1/s): M - A / s is positive
 * definite if and only if s > omega^2.  Bisection, in which Cholesky decides
 * [eq:critical-step].
 */
double frequency_largest(const struct model *model);

#endif
