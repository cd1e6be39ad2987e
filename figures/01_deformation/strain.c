/*
 * strain.c - which strain notices a motion that deforms nothing?
 *
 * The linear, the Green and the left strain [eq:linear-strain]
 * [eq:green-strain] [eq:left-strain] of the rigid motions that the notes
 * mention, of a body that turns, and of a body that is stretched by 1.3 along x
 * and then turns; and the angles at which the linear strain of a rotation
 * passes 1, 5 and 10 per cent.
 */
#include "material/material.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

struct strains {
    mat2 linear, green, left;
};

static struct strains strains_of(mat2 F)
{
    const mat2 I = mat2_identity(), T = mat2_transpose(F);
    return (struct strains){
        mat2_subtract(mat2_scale(0.5, mat2_add(F, T)), I),
        mat2_scale(0.5, mat2_subtract(mat2_multiply(T, F), I)),
        mat2_scale(0.5, mat2_subtract(mat2_multiply(F, T), I))};
}

static mat2 rotation(double degrees)
{
    return mat2_rotation(degrees * M_PI / 180.0);
}

/* W is skew, of size 30 degrees.  All the tensors are multiples of I. */
static void print_rigid(void)
{
    const struct material law = material_notes(LINEAR);
    const double w = M_PI / 6.0;
    const mat2 I = mat2_identity(), W = {{{0.0, -w}, {w, 0.0}}};
    const struct {
        const char *motion;
        mat2 F;
    } at[] = {{"translation", I},
              {"$F=W$", W},
              {"$F=I+W$", mat2_add(I, W)},
              {"$F=0$", mat2_scale(0.0, I)},
              {"rotation", rotation(30.0)}};

    table_begin_note("rigid", "motion J linear green left stress energy",
                     "entry 11; stress and energy by the linear law");
    for (int k = 0; k < COUNT(at); k++) {
        const struct strains s = strains_of(at[k].F);
        table_row(at[k].motion, mat2_det(at[k].F), s.linear.m[0][0],
                  s.green.m[0][0], s.left.m[0][0],
                  material2_pk1(&law, at[k].F).m[0][0],
                  material2_psi(&law, at[k].F));
    }
    table_end();
}

static double max_change(mat2 A, mat2 B)
{
    double largest = 0.0;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            largest = fmax(largest, fabs(A.m[i][k] - B.m[i][k]));
    return largest;
}

/* Linear strain of a rotation against a level. */
static double excess(double degrees, void *level)
{
    return -strains_of(rotation(degrees)).linear.m[0][0] - *(double *)level;
}

int main(void)
{
    const double stretch = 1.3;
    const mat2 U = {{{stretch, 0.0}, {0.0, 1.0}}};
    const struct strains rest = strains_of(U);
    double level[] = {0.01, 0.05, 0.1}, green = 0.0, left = 0.0, off = 0.0;

    print_rigid();
    table_begin("angles", "degrees linear green left linear_change "
                          "green_change left_change");
    for (int degrees = 0; degrees <= 180; degrees += 2) {
        const mat2 R = rotation(degrees);
        const struct strains s = strains_of(R);
        const struct strains turned = strains_of(mat2_multiply(R, U));
        const double change[] = {max_change(turned.linear, rest.linear),
                                 max_change(turned.green, rest.green),
                                 max_change(turned.left, rest.left)};
        table_row(degrees, s.linear.m[0][0], s.green.m[0][0], s.left.m[0][0],
                  change[0], change[1], change[2]);
        green = fmax(green, fmax(change[1], fabs(s.green.m[0][0])));
        left = fmax(left, change[2]);
    }
    table_end();
    table_begin("thresholds", "level degrees");
    for (int k = 0; k < COUNT(level); k++) {
        const double degrees = study_root(excess, &level[k], 0.0, 90.0);
        table_row(level[k], degrees);
        off = fmax(off, fabs(cos(degrees * M_PI / 180.0) - 1.0 + level[k]));
    }
    table_end();

    claim(off < 1e-14, "the linear strain of a rotation is cos(angle) - 1 (%g)",
          off);
    claim(green < 1e-14, "no rotation changes the Green strain (%g)", green);
    claim(fabs(left - 0.5 * (stretch * stretch - 1.0)) < 1e-14,
          "the left strain changes by up to (1.3^2 - 1) / 2 (%g)", left);
    return table_finish();
}
