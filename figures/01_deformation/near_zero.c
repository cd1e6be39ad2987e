/*
 * near_zero.c - what does the log law make of the map X^2 near X = 0?
 *
 * F = 2 X of the notes' Figure 4 vanishes there, so no element is inverted, and
 * still the stress of a law with a logarithm (lesson 02) has no limit.
 */
#include "material/material.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>

int main(void)
{
    const struct material log_law = material_notes(LOG);
    double before = 0.0;
    int steep = 1;

    table_begin("near_zero", "X F log_stress");
    for (int k = 1; k <= 3; k++) {
        const double X = gsl_pow_int(10.0, -k);
        const double stress = material1_pk1(&log_law, 2.0 * X);
        table_row(X, 2.0 * X, stress);
        if (k > 1) steep &= stress < 10.0 * before;
        before = stress;
    }
    table_end();

    claim(steep, "with each tenth of X the log law's compression grows by more "
          "than 10");
    return table_finish();
}
