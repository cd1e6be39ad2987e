/* tensor.c - see tensor.h. */
#include "material/tensor.h"

#include <math.h>

mat2 mat2_rotation(double angle)
{
    const double c = cos(angle), s = sin(angle);
    return (mat2){{{c, -s}, {s, c}}};
}

double mat2_norm(mat2 A)
{
    return sqrt(mat2_dot(A, A));
}
