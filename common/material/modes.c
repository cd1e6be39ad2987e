/* modes.c - see modes.h. */
#include "material/modes.h"

#include <gsl/gsl_math.h>
#include <math.h>

/*
 * For U = R(y), V = R(z) it is F = p R(y - z) + q R(y + z) diag(1, -1) with
 * p = (s1 + s2)/2 and q = (s1 - s2)/2: a rotation and a reflection, stretched.
 * Their entries, p (cos, sin) and q (cos, sin), are sums and differences of
 * F's.
 */
struct svd modes_svd(mat2 F)
{
    const double sum = F.m[0][0] + F.m[1][1], skew = F.m[1][0] - F.m[0][1];
    const double gap = F.m[0][0] - F.m[1][1], shear = F.m[1][0] + F.m[0][1];
    const double turn = atan2(skew, sum), axes = atan2(shear, gap);
    const double s1 = (hypot(sum, skew) + hypot(gap, shear)) / 2.0;
    return (struct svd){
        mat2_rotation((axes + turn) / 2.0), mat2_rotation((axes - turn) / 2.0),
        s1, s1 > 0.0 ? mat2_det(F) / s1 : 0.0}; /* no difference */
}

struct modes modes_of(mat2 F, double mu, double dG, double ddG)
{
    const struct svd svd = modes_svd(F);
    const double a = mu + ddG * svd.s2 * svd.s2, b = ddG * svd.s1 * svd.s2 + dG;
    const double c = mu + ddG * svd.s1 * svd.s1;
    /* [a b; b c] has eigenvalues (a + c) / 2 -+ root, vectors turned by z */
    const double root = hypot((a - c) / 2.0, b);
    const double z = 0.5 * atan2(2.0 * b, a - c);
    const mat2 E[4] = {{{{0.0, -M_SQRT1_2}, {M_SQRT1_2, 0.0}}},
                       {{{0.0, M_SQRT1_2}, {M_SQRT1_2, 0.0}}},
                       {{{-sin(z), 0.0}, {0.0, cos(z)}}},
                       {{{cos(z), 0.0}, {0.0, sin(z)}}}};
    const mat2 Vt = mat2_transpose(svd.V);
    struct modes modes = {.value = {mu + dG, mu - dG, (a + c) / 2.0 - root,
                                    (a + c) / 2.0 + root}};
    for (int m = 0; m < 4; m++)
        modes.direction[m] = mat2_multiply(svd.U, mat2_multiply(E[m], Vt));
    return modes;
}

struct modes modes_at(const struct material *material, mat2 F)
{
    const struct volume v = material_volume(material, mat2_det(F));
    return modes_of(F, material->mu, v.dG, v.ddG);
}

mat2 modes_dpk1(const struct modes *modes, mat2 dF)
{
    mat2 dP = {0};
    for (int m = 0; m < 4; m++) {
        const mat2 D = modes->direction[m];
        dP = mat2_add(dP, mat2_scale(fmax(modes->value[m], 0.0) *
                                         mat2_dot(D, dF), D));
    }
    return dP;
}
