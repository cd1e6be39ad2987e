/*
 * fitted.h - the exercise of poisson.h with test functions phi_i that are made
 * for it: they have the values of the hats e_i at the nodes, and constant flux
 * beta phi_i' on each element.
 */
#ifndef FIGURES_FITTED_H
#define FIGURES_FITTED_H

#include "linear/matrix.h"

/* As poisson_assemble(): A_ij = int beta e_i' phi_j' dx, b_i = int f phi_i dx.
 * The nodal values are then exact. */
void fitted_assemble(int n, const double x[], struct matrix *A, double b[]);

#endif
