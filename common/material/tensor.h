/*
 * tensor.h - 2x2 tensors as values, so that P = pk1(F) reads as mathematics.
 *
 * m[i][J]: row i (space), column J (material).  No GSL matrix for a 2x2.
 *
 * Names: mat2_.
 */
#ifndef COMMON_TENSOR_H
#define COMMON_TENSOR_H

typedef struct {
    double m[2][2];
} mat2;

mat2 mat2_identity(void);
mat2 mat2_rotation(double angle); /* radians, counter-clockwise */
mat2 mat2_add(mat2 A, mat2 B);
mat2 mat2_subtract(mat2 A, mat2 B);
mat2 mat2_scale(double s, mat2 A);
mat2 mat2_multiply(mat2 A, mat2 B); /* A B */
mat2 mat2_transpose(mat2 A);
mat2 mat2_cofactor(mat2 A);           /* d(det A)/dA = det(A) A^{-T} */
double mat2_det(mat2 A);
double mat2_trace(mat2 A);
double mat2_dot(mat2 A, mat2 B); /* A : B = sum_iJ A_iJ B_iJ */
double mat2_norm(mat2 A);        /* (A : A)^(1/2) */

#endif
