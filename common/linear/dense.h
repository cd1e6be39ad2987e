/*
 * dense.h - what GSL does for matrix.h with a full matrix: its Cholesky
 * factorisation, its eigenvalues.
 */
#ifndef COMMON_DENSE_H
#define COMMON_DENSE_H

#include "base/status.h"

/* a[i*n + j] = A_ij := L, in both triangles; statuses as matrix_factor(). */
enum status dense_factor(int n, double a[]);

/* b := A^{-1} b, for L from dense_factor(). */
void dense_solve(int n, double l[], double b[]);

/* value[0..n-1] := the eigenvalues of a, in ascending order; a is overwritten.
 * NONFINITE: an entry of a is not finite. */
enum status dense_eigenvalues(int n, double a[], double value[]);

#endif
