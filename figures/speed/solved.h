/*
 * solved.h - how well a solver that is measured has solved its system.
 */
#ifndef FIGURES_SOLVED_H
#define FIGURES_SOLVED_H

#include "linear/csr.h"

/* Return max|b - A x| / (|A| max|x| + max|b|), |A| the largest sum of a row:
 * how far the system is that x solves, as matrix_backward_error(), not in
 * eps; NaN if an entry is one. */
double solved_error(const struct csr *A, const double x[], const double b[]);

#endif
