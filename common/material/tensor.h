/*
 * tensor.h - 2x2 tensors as values, so that P = pk1(F) reads as mathematics.
 *
 * m[i][J]: row i (space), column J (material).  No GSL matrix for a 2x2, and no
 * call for a few operations: they stand here.
 *
 * Names: mat2_.
 */
#ifndef COMMON_TENSOR_H
#define COMMON_TENSOR_H

typedef struct {
    double m[2][2];
} mat2;

mat2 mat2_rotation(double angle); /* radians, counter-clockwise */
double mat2_norm(mat2 A);         /* (A : A)^(1/2) */

static inline mat2 mat2_identity(void)
{
    return (mat2){{{1.0, 0.0}, {0.0, 1.0}}};
}

static inline mat2 mat2_add(mat2 A, mat2 B)
{
    for (int i = 0; i < 2; i++)
        for (int J = 0; J < 2; J++) A.m[i][J] += B.m[i][J];
    return A;
}

static inline mat2 mat2_scale(double s, mat2 A)
{
    for (int i = 0; i < 2; i++)
        for (int J = 0; J < 2; J++) A.m[i][J] *= s;
    return A;
}

static inline mat2 mat2_subtract(mat2 A, mat2 B)
{
    return mat2_add(A, mat2_scale(-1.0, B));
}

/* Return A B */
static inline mat2 mat2_multiply(mat2 A, mat2 B)
{
    mat2 C;
    for (int i = 0; i < 2; i++)
        for (int J = 0; J < 2; J++)
            C.m[i][J] = A.m[i][0] * B.m[0][J] + A.m[i][1] * B.m[1][J];
    return C;
}

static inline mat2 mat2_transpose(mat2 A)
{
    return (mat2){{{A.m[0][0], A.m[1][0]}, {A.m[0][1], A.m[1][1]}}};
}

/* Return d(det A)/dA = det(A) A^{-T} */
static inline mat2 mat2_cofactor(mat2 A)
{
    return (mat2){{{A.m[1][1], -A.m[1][0]}, {-A.m[0][1], A.m[0][0]}}};
}

static inline double mat2_det(mat2 A)
{
    return A.m[0][0] * A.m[1][1] - A.m[0][1] * A.m[1][0];
}

static inline double mat2_trace(mat2 A)
{
    return A.m[0][0] + A.m[1][1];
}

/* Return A : B = sum_iJ A_iJ B_iJ */
static inline double mat2_dot(mat2 A, mat2 B)
{
    return A.m[0][0] * B.m[0][0] + A.m[0][1] * B.m[0][1] +
           A.m[1][0] * B.m[1][0] + A.m[1][1] * B.m[1][1];
}

#endif
