/*
 * rest_states.c - which state of rest does Newton's method find, and for which
 * nu is there more than one?
 *
 * One element of the cubic law without load, from 71 starts; for small nu its
 * stress returns to 0 far beyond the limit load (limit.h).  Tables: the nu
 * below which there are a limit load and another state of rest, and above which
 * the log law has a limit load; where the runs end.
 */
#include "limit.h"
#include "element.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static const double E = 1000.0;

static double least_slope(double nu, void *law)
{
    struct material m = material_make(*(enum law *)law, E, nu);
    return limit_least_slope(&m);
}

static double least_stress(double nu, void *law)
{
    struct material m = material_make(*(enum law *)law, E, nu);
    return limit_least_stress(&m);
}

int main(void)
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    enum law cubic = CUBIC, log_law = LOG;
    const double tangent = study_root(least_slope, &cubic, 0.04, 0.2);
    const double rest = study_root(least_stress, &cubic, 0.01, 0.06);
    const double log_tangent = study_root(least_slope, &log_law, 0.45, 0.495);
    double above = -INFINITY; /* the largest F found where nu > rest */

    table_begin("critical", "cubic_tangent cubic_rest log_tangent");
    table_row(tangent, rest, log_tangent);
    table_end();
    table_begin("rest_map", "nu start reason iterations F");
    for (int i = 0; i <= 20; i++)
        for (int j = -20; j <= 120; j += 2) {
            const double nu = 0.005 * i, start = j / 20.0;
            const struct material m = material_make(CUBIC, E, nu);
            const struct element_report end =
                element_newton(&m, 0.0, start, &control);
            table_row(nu, start, status_name(end.status), end.iterations,
                      cell_if(end.status == OK, end.F));
            if (nu > rest) above = fmax(above, end.F);
        }
    table_end();

    claim(fabs(tangent - 0.0712) < 5e-5 && fabs(rest - 0.0284) < 5e-5 &&
              fabs(log_tangent - 0.4884) < 5e-5,
          "the critical nu are 0.0712, 0.0284, 0.4884 (%g, %g, %g)", tangent,
          rest, log_tangent);
    claim(above < 1.0 + 1e-8, "other states of rest are found below nu = %g "
          "only (F = %g)", rest, above);
    return table_finish();
}
