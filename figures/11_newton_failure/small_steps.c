/*
 * small_steps.c - are small steps a sign of convergence?
 *
 * An element of the log law and of length 0.1 is squashed to F0 and let go.
 * Newton's first step is always a little less than F0, below any tolerance,
 * while the residual is enormous; tested on both, the iteration carries on.
 */
#include "element.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

int main(void)
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct material m = material_notes(LOG);
    double increment = 0.0, residual = 0.0, farthest = 0.0;

    table_begin("false", "start step_over_start increment residual reason "
                         "iterations F");
    for (int k = 1; k <= 3; k++) {
        const double F = pow(10.0, -4.0 * k);
        const double step = -material1_pk1(&m, F) / material1_dpk1(&m, F);
        const struct element_report end = element_newton(&m, 0.0, F, &control);
        increment = 0.1 * step;
        residual = material1_pk1(&m, F);
        farthest = fmax(farthest, fabs(end.F - 1.0));
        table_row(F, step / F, increment, residual, status_name(end.status),
                  end.iterations, end.F);
    }
    table_end();

    claim(increment < 1e-12 && residual < -1e12 * material_modulus(&m),
          "the first increment is %g while the residual is %g", increment,
          residual);
    claim(farthest <= control.tolerance,
          "tested on both, the iteration arrives at F = 1 from every start "
          "(it is off by %g)", farthest);
    return table_finish();
}
