/*
 * load_map.c - where does plain Newton end, over the load and the start?
 *
 * One element, 60 loads p by 60 starts F0, log and cubic law; and the boundary
 * p = P(F0) - F0 P'(F0) at which the tangent at F0 meets the level p in F = 0
 * [eq:first-step].
 */
#include "element.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { GRID = 60 };

/* The stress at or below which the first step from F leaves F > 0. */
static double boundary(const struct material *m, double F)
{
    return material1_pk1(m, F) - F * material1_dpk1(m, F);
}

int main(void)
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct material log_law = material_notes(LOG);
    const struct material cubic = material_notes(CUBIC);
    const double modulus = material_modulus(&log_law);
    int wrong = 0, failed = 0;

    table_begin_note("load_map", "load start reason_log iterations_log "
                     "reason_cubic iterations_cubic",
                     "load in units of 2 mu + lambda");
    for (int i = 0; i < GRID; i++)
        for (int j = 0; j < GRID; j++) {
            const double load = -3.983 + 5.977 * i / (GRID - 1);
            const double start = -0.977 + 5.9431 * j / (GRID - 1);
            const double p = load * modulus;
            const struct element_report a =
                element_newton(&log_law, p, start, &control);
            const struct element_report b =
                element_newton(&cubic, p, start, &control);
            table_row(load, start, status_name(a.status), a.iterations,
                      status_name(b.status), b.iterations);
            const int inverts = start <= 0.0 || p <= boundary(&log_law, start);
            wrong += a.status != (inverts ? INVERTED : OK);
            failed += b.status != OK;
        }
    table_end();

    table_begin_note("boundary", "start load relative",
                     "relative: load / (2 mu + lambda)");
    for (int k = 1; k <= 150; k++) {
        const double F = k / 30.0, load = boundary(&log_law, F);
        table_row(F, load, load / modulus);
    }
    table_end();

    claim(wrong == 0, "no point of the map contradicts the boundary (%d of %d "
          "do)", wrong, GRID * GRID);
    claim(failed == 0, "the cubic law converges everywhere on the map (at %d "
          "points it does not)", failed);
    return table_finish();
}
