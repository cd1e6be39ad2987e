/*
 * loads.c - where does plain Newton from rest end under a load?
 *
 * One element of the log and of the cubic law, either side of the load
 * -(2 mu + lambda) at which the first step inverts the log law [eq:first-step],
 * of -(3 mu + 11/2 lambda), at which the cubic law has F = 0, and far beyond.
 */
#include "element.h"
#include "base/study.h"
#include "base/table.h"

int main(void)
{
    static const double load[] = {1000.0,  -100.0,  -1346.0,  -1347.0, -4000.0,
                                  -4326.0, -4327.0, -10000.0, -100000.0};
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct material log_law = material_notes(LOG);
    const struct material cubic = material_notes(CUBIC);
    const double modulus = material_modulus(&log_law);
    const double collapse = -(3.0 * cubic.mu + 5.5 * cubic.lambda);
    int log_as_predicted = 1, cubic_as_predicted = 1;

    table_begin("loads", "p reason_log iterations_log F_log reason_cubic "
                         "iterations_cubic F_cubic F_linear");
    for (int k = 0; k < (int)(sizeof load / sizeof load[0]); k++) {
        const double p = load[k];
        const struct element_report a =
            element_newton(&log_law, p, 1.0, &control);
        const struct element_report b =
            element_newton(&cubic, p, 1.0, &control);
        table_row(p, status_name(a.status), a.iterations,
                  cell_if(a.status == OK, a.F), status_name(b.status),
                  b.iterations, cell_if(b.status == OK, b.F),
                  1.0 + p / modulus);
        log_as_predicted &= a.status == (p <= -modulus ? INVERTED : OK);
        cubic_as_predicted &= b.status == OK && (b.F < 0.0) == (p < collapse);
    }
    table_end();

    claim(log_as_predicted, "the log law is INVERTED at and below p = "
          "-(2 mu + lambda) = %g, and converges above", -modulus);
    claim(cubic_as_predicted, "the cubic law converges under every load, and "
          "ends with F < 0 below %g", collapse);
    return table_finish();
}
