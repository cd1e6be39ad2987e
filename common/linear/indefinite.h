/*
 * indefinite.h - what need not be positive definite, for matrix.h: A = L D L^T
 * in a band, by GSL; in one of half bandwidth 1 by two short loops, which are
 * five times as fast.
 */
#ifndef COMMON_INDEFINITE_H
#define COMMON_INDEFINITE_H

#include "base/status.h"

#include <stddef.h>

/* Solve as matrix_solve_indefinite(), in the band a[j*stride + d] = A_j+d,j of
 * half bandwidth p; room: [n (p + 1)]. */
enum status indefinite_solve(int n, int p, size_t stride, const double a[],
                             double room[], double b[], int *negative);

#endif
