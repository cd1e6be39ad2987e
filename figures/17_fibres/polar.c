/*
 * polar.c - how stiff is a sheet with cords in it, and where does it go when it
 * is pulled?
 *
 * Plane strain, E = 1000, nu = 0.3, cords of stiffness k = 2000.  Near rest:
 * uniaxial stress at an angle to the cords, modulus and shear per strain, from
 * a 3x3 system.  Far from rest: a square of the cubic material, cords at 20
 * degrees, F = (l, gamma; 0, w) with P12 = P22 = 0, by Newton's method.
 * Tables: polar, idle (the pull
 * that does not stretch the cords), pulled.
 */
#include "plane/fibre.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>

static const struct fibre cord = {CORD, 2000.0, 0.0, 0.5, 0.0};

/* dP of material and cords. */
static mat2 change(double degrees, mat2 F, mat2 dF)
{
    const struct material material = material_notes(CUBIC);
    const double angle = degrees * M_PI / 180.0;
    const double g[2] = {cos(angle), sin(angle)};
    return mat2_add(material2_dpk1(&material, F, dF),
                    fibre_dpk1(&cord, g, F, dF, EXACT));
}

/* The modulus of a pull along X1; *shear: 2 e12 per e11. */
static double modulus(double degrees, double *shear)
{
    const mat2 strain[3] = {{{{1.0, 0.0}, {0.0, 0.0}}},
                            {{{0.0, 0.0}, {0.0, 1.0}}},
                            {{{0.0, 0.5}, {0.5, 0.0}}}};
    double e[3] = {1.0, 0.0, 0.0}; /* stresses, then e11, e22, 2 e12 */
    struct matrix *C = matrix_alloc(DENSE, 3, 0);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            matrix_add(C, i, j,
                       mat2_dot(strain[i], change(degrees, mat2_identity(),
                                                  strain[j])));
    if (matrix_factor(C) != OK) die("no stiffness at %g degrees", degrees);
    matrix_solve(C, e);
    matrix_free(C);
    *shear = e[2] / e[0];
    return 1.0 / e[0];
}

/* F of the square pulled to l. */
static mat2 pulled(double degrees, double l)
{
    const struct material material = material_notes(CUBIC);
    const double angle = degrees * M_PI / 180.0;
    const double g[2] = {cos(angle), sin(angle)};
    const mat2 d[2] = {{{{0.0, 1.0}, {0.0, 0.0}}}, {{{0.0, 0.0}, {0.0, 1.0}}}};
    mat2 F = {{{l, 0.0}, {0.0, 1.0}}};
    for (int k = 0; k < 30; k++) {
        const mat2 P = mat2_add(material2_pk1(&material, F),
                                fibre_pk1(&cord, g, F));
        if (fabs(P.m[0][1]) + fabs(P.m[1][1]) < 1e-10) return F;
        const mat2 a = change(degrees, F, d[0]), b = change(degrees, F, d[1]);
        const mat2 A = {{{a.m[0][1], b.m[0][1]}, {a.m[1][1], b.m[1][1]}}};
        const double det = mat2_det(A);
        F.m[0][1] -= (A.m[1][1] * P.m[0][1] - A.m[0][1] * P.m[1][1]) / det;
        F.m[1][1] -= (A.m[0][0] * P.m[1][1] - A.m[1][0] * P.m[0][1]) / det;
    }
    die("the square pulled to %g has no solution", l);
}

int main(void)
{
    const double stretch[] = {1.0001, 1.05, 1.1, 1.2, 1.3};
    /* strain along the cords: cos^2 - nu / (1 - nu) sin^2 */
    const double idle = atan(sqrt(0.7 / 0.3)) * 180.0 / M_PI;
    double shear, least = INFINITY, where = 0.0;
    table_begin("polar", "degrees modulus shear isotropic");
    for (int degrees = 0; degrees <= 360; degrees += 2) {
        const double E = modulus(degrees, &shear);
        if (degrees <= 90 && E < least) {
            least = E;
            where = degrees;
        }
        table_row(degrees, E, shear, 1000.0 / (1.0 - 0.09));
    }
    table_end();
    table_begin("idle", "degrees modulus");
    table_row(idle, modulus(idle, &shear));
    table_end();
    modulus(20.0, &shear);
    const double small = pulled(20.0, stretch[0]).m[0][1] / (stretch[0] - 1.0);
    table_begin("pulled", "degrees l gamma w cord");
    for (int c = 0; c < COUNT(stretch); c++)
        for (int turned = 0; turned < 2; turned++) {
            const double degrees = turned ? 20.0 : 0.0, l = stretch[c];
            const mat2 F = pulled(degrees, l);
            const double t = degrees * M_PI / 180.0;
            table_row(degrees, l, F.m[0][1], F.m[1][1],
                      hypot(F.m[0][0] * cos(t) + F.m[0][1] * sin(t),
                            F.m[1][1] * sin(t)));
        }
    table_end();
    claim(fabs(modulus(0.0, &least) - 1000.0 / 0.91 - 2000.0) < 1e-9,
          "along the cords the modulus is that of the sheet plus k");
    claim(fabs(modulus(idle, &least) - 1000.0 / 0.91) < 1e-9,
          "at %.2f degrees, where the sheet does not stretch along the cords, "
          "they add nothing (%g)", idle, modulus(idle, &least));
    claim(fabs(shear + 0.8937402501817817) < 1e-9 &&
              fabs(small - shear) < 1e-3,
          "pulled at 20 degrees the sheet shears by 0.894 of its strain (%g; "
          "%g at 1.0001)", shear, small);
    claim(fabs(where - idle) < 2.0, "that is the softest direction, and not "
          "the one across the cords (%g degrees)", where);
    return table_finish();
}
