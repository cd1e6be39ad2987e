/*
 * quadrangles.c - what do the four modes of dP/dF do to a square?
 *
 * A square under a pressed F, and moved from there along each mode by half a
 * length to both sides.  The factor of the mode is the curvature of psi along
 * it.  Tables: stretches; factors, and the curvature by differences; corners.
 */
#include "material/modes.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static const char *const names[] = {"twist", "flip", "scale_low", "scale_high"};

int main(void)
{
    const struct material cubic = material_notes(CUBIC);
    const mat2 F = {{{0.72, 0.2}, {-0.12, 0.95}}};
    const struct modes modes = modes_at(&cubic, F);
    /* s1 + s2 and s1 - s2 */
    const double sum = hypot(F.m[0][0] + F.m[1][1], F.m[0][1] - F.m[1][0]);
    const double difference =
        hypot(F.m[0][0] - F.m[1][1], F.m[0][1] + F.m[1][0]);
    const double corner[5][2] = {
        {-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}};
    double worst = 0.0;
    table_begin("stretches", "s1 s2");
    table_row((sum + difference) / 2.0, (sum - difference) / 2.0);
    table_end();
    table_begin("factors", "mode factor curvature");
    for (int m = 0; m < 4; m++) {
        const mat2 D = modes.direction[m];
        double best = INFINITY, curvature = 0.0;
        for (double h = 0.1; h > 1e-4; h *= 0.5) {
            const double c =
                (material2_psi(&cubic, mat2_add(F, mat2_scale(h, D))) -
                 2.0 * material2_psi(&cubic, F) +
                 material2_psi(&cubic, mat2_subtract(F, mat2_scale(h, D)))) /
                (h * h);
            const double off = fabs(c - modes.value[m]);
            if (off < best) best = off, curvature = c;
        }
        worst = fmax(worst, best / modes.value[MODE_HIGH]);
        table_row(names[m], modes.value[m], curvature);
    }
    table_end();
    for (int m = 0; m < 4; m++) {
        table_begin(names[m], "x y x_plus y_plus x_minus y_minus");
        for (int c = 0; c < 5; c++) {
            double x[3][2];
            for (int k = 0; k < 3; k++) {
                const mat2 G = mat2_add(
                    F, mat2_scale(0.5 * (k - 1), modes.direction[m]));
                for (int i = 0; i < 2; i++)
                    x[k][i] = G.m[i][0] * corner[c][0] +
                              G.m[i][1] * corner[c][1];
            }
            table_row(x[1][0], x[1][1], x[2][0], x[2][1], x[0][0], x[0][1]);
        }
        table_end();
    }
    claim(worst < 1e-7, "the factors are the curvatures of psi along the modes "
          "(off by %g of the largest)", worst);
    claim(modes.value[MODE_TWIST] < 0.0 && modes.value[MODE_FLIP] > 0.0 &&
              modes.value[MODE_LOW] > 0.0,
          "of the four only the twist is negative (%g)",
          modes.value[MODE_TWIST]);
    return table_finish();
}
