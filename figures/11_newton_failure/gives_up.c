/*
 * gives_up.c - what does the cubic law give up for never failing?
 *
 * For small nu its stress has a maximum in tension, the limit load, and even
 * returns to 0 (limit.h).  Tables: where, for some nu; the stresses; and the
 * stretches of ten held elements, the end of which is moved by 1 at once.
 */
#include "limit.h"
#include "bar/bar.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { N = 10, N_NU = 8, E = 1000 };

/* The stretches of a bar of N elements between held ends, moved apart by 1. */
static void pull(double nu, double F[N])
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    double u[N + 1] = {[N] = 1.0}, no_load[N + 1] = {0.0};
    const struct bar bar = {N, 1.0 / N, {1, 1}, no_load,
                            material_make(CUBIC, E, nu)};
    if (bar_newton(&bar, &control, u, NULL).status != OK)
        die("nu = %g: no equilibrium", nu);
    for (int e = 0; e < N; e++) F[e] = 1.0 + (u[e + 1] - u[e]) * N;
}

static void print_stress(const struct material cubic[N_NU])
{
    const struct material log_law = material_notes(LOG);
    table_begin_note("stress", "F nu0 nu2 nu5 nu7 nu30 log30", "stress / E");
    for (int k = -20; k <= 220; k++) {
        const double F = k / 40.0;
        table_row(F, material1_pk1(&cubic[0], F) / E,
                  material1_pk1(&cubic[1], F) / E,
                  material1_pk1(&cubic[3], F) / E,
                  material1_pk1(&cubic[4], F) / E,
                  material1_pk1(&cubic[7], F) / E,
                  material1_pk1(&log_law, fmax(F, 0.05)) / E);
    }
    table_end();
}

int main(void)
{
    const double nu[N_NU] = {0.0, 0.02, 0.03, 0.05, 0.07, 0.0713, 0.1, 0.3};
    struct material cubic[N_NU];
    double F30[N], F5[N], least = INFINITY, largest = 0.0;

    table_begin("giveup", "nu F_limit P_limit F_rest");
    for (int k = 0; k < N_NU; k++) {
        cubic[k] = material_make(CUBIC, E, nu[k]);
        const double F = limit_point(&cubic[k]), rest = limit_rest(&cubic[k]);
        const int limited = !isnan(F);
        table_row(nu[k], cell_if(limited, F),
                  cell_if(limited, material1_pk1(&cubic[k], limited ? F : 1.0)),
                  cell_if(!isnan(rest), rest));
        if (limited) least = fmin(least, F);
    }
    table_end();
    print_stress(cubic);

    pull(0.3, F30);
    pull(0.05, F5);
    table_begin("localised", "X nu30 nu5");
    for (int e = 0; e < N; e++) {
        table_row((e + 0.5) / N, F30[e], F5[e]);
        largest = fmax(largest, F5[e]);
    }
    table_end();

    claim(least > 1.5, "a limit load is reached beyond F = 1.5 (%g)", least);
    claim(largest > 3.4, "one element of ten is stretched to F > 3.4 (%g)",
          largest);
    return table_finish();
}
