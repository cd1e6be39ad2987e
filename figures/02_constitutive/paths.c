/*
 * paths.c - how do the three laws answer along four ways through the plane?
 *
 * Both axes stretched, one, a simple shear, a rotation; plane strain.  A table
 * for each path and law: s is the stretch, the shear or the angle in degrees,
 * P is P12 in shear and P11 elsewhere; rows only where the law is defined.
 */
#include "material/material.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

enum path { EQUIBIAXIAL, UNIAXIAL, SHEAR, ROTATION, N_PATH };
static const struct {
    const char *name;
    double from, to;
} path_of[N_PATH] = {{"equibiaxial", -1.5, 2.5},
                     {"uniaxial", -1.0, 3.0},
                     {"shear", 0.0, 2.0},
                     {"rotation", 0.0, 180.0}};

static mat2 state(enum path path, double s)
{
    switch (path) {
    case EQUIBIAXIAL: return (mat2){{{s, 0.0}, {0.0, s}}};
    case UNIAXIAL: return (mat2){{{s, 0.0}, {0.0, 1.0}}};
    case SHEAR: return (mat2){{{1.0, s}, {0.0, 1.0}}};
    default: return mat2_rotation(s * M_PI / 180.0);
    }
}

static double stress(enum path path, enum law law, double s)
{
    const struct material m = material_notes(law);
    const mat2 P = material2_pk1(&m, state(path, s));
    return P.m[0][path == SHEAR];
}

static void print_path(enum path path, enum law law)
{
    enum { POINTS = 160 };
    const struct material m = material_notes(law);
    char name[40];
    snprintf(name, sizeof name, "%s_%s", path_of[path].name,
             material_law(law));
    table_begin(name, "s J psi P");
    for (int i = 0; i <= POINTS; i++) {
        const double s = (path_of[path].from * (POINTS - i) +
                          path_of[path].to * i) / POINTS;
        const mat2 F = state(path, s);
        if (material_defined(&m, mat2_det(F)))
            table_row(s, mat2_det(F), material2_psi(&m, F),
                      stress(path, law, s));
    }
    table_end();
}

int main(void)
{
    for (int path = 0; path < N_PATH; path++)
        for (int law = LINEAR; law <= CUBIC; law++)
            print_path((enum path)path, (enum law)law);

    const double mu = material_notes(LINEAR).mu;
    for (int law = LINEAR; law <= CUBIC; law++) {
        const double P12 = stress(SHEAR, (enum law)law, 1.613);
        claim(fabs(P12 / (1.613 * mu) - 1.0) < 1e-12,
              "in shear P12 = mu s for the %s law (%g, mu = %g)",
              material_law((enum law)law), P12, mu);
    }
    for (int law = LOG; law <= CUBIC; law++)
        claim(fabs(stress(ROTATION, (enum law)law, 71.0)) < 1e-12 * mu &&
                  fabs(stress(EQUIBIAXIAL, (enum law)law, -1.0)) < 1e-12 * mu,
              "a rotation gives no stress, and s = -1 is one: %s law",
              material_law((enum law)law));
    claim(stress(ROTATION, LINEAR, 71.0) < -mu,
          "the linear law takes a rotation for a compression");
    claim(stress(EQUIBIAXIAL, CUBIC, 0.0) == 0.0,
          "the cubic law has no stress in an area crushed to a point");
    return table_finish();
}
