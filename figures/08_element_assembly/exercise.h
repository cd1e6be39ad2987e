/*
 * exercise.h - the system of the exercise of poisson.h on n equal elements.
 */
#ifndef FIGURES_EXERCISE_H
#define FIGURES_EXERCISE_H

#include "linear/matrix.h"

/* The boundary conditions of [eq:poisson-bvp] in A and b of n elements: the
 * flux at x = 1, then u(0) = 1 [eq:dirichlet-correction]. */
void exercise_boundary(int n, struct matrix *A, double b[]);

/* Set the nodes x[0..n], b[0..n] by the midpoint rule, and A, for the caller to
 * free; with the boundary conditions. */
struct matrix *exercise_system(enum storage storage, int n, double x[],
                               double b[]);

#endif
