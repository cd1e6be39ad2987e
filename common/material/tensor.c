/* tensor.c - see tensor.h. */
#include "material/tensor.h"

#include <math.h>

mat2 mat2_identity(void)
{
    return (mat2){{{1.0, 0.0}, {0.0, 1.0}}};
}

mat2 mat2_rotation(double angle)
{
    const double c = cos(angle), s = sin(angle);
    return (mat2){{{c, -s}, {s, c}}};
}

mat2 mat2_add(mat2 A, mat2 B)
{
    for (int i = 0; i < 2; i++)
        for (int J = 0; J < 2; J++) A.m[i][J] += B.m[i][J];
    return A;
}

mat2 mat2_subtract(mat2 A, mat2 B)
{
    return mat2_add(A, mat2_scale(-1.0, B));
}

mat2 mat2_scale(double s, mat2 A)
{
    for (int i = 0; i < 2; i++)
        for (int J = 0; J < 2; J++) A.m[i][J] *= s;
    return A;
}

mat2 mat2_multiply(mat2 A, mat2 B)
{
    mat2 C;
    for (int i = 0; i < 2; i++)
        for (int J = 0; J < 2; J++)
            C.m[i][J] = A.m[i][0] * B.m[0][J] + A.m[i][1] * B.m[1][J];
    return C;
}

mat2 mat2_transpose(mat2 A)
{
    return (mat2){{{A.m[0][0], A.m[1][0]}, {A.m[0][1], A.m[1][1]}}};
}

mat2 mat2_cofactor(mat2 A)
{
    return (mat2){{{A.m[1][1], -A.m[1][0]}, {-A.m[0][1], A.m[0][0]}}};
}

double mat2_det(mat2 A)
{
    return A.m[0][0] * A.m[1][1] - A.m[0][1] * A.m[1][0];
}

double mat2_trace(mat2 A)
{
    return A.m[0][0] + A.m[1][1];
}

double mat2_dot(mat2 A, mat2 B)
{
    return A.m[0][0] * B.m[0][0] + A.m[0][1] * B.m[0][1] +
           A.m[1][0] * B.m[1][0] + A.m[1][1] * B.m[1][1];
}

double mat2_norm(mat2 A)
{
    return sqrt(mat2_dot(A, A));
}
