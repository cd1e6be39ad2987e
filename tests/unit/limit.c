/* limit.c - laws of figures/11_newton_failure/limit.h. */
#include "figures/11_newton_failure/limit.h"

#include "unit.h"

#include <math.h>

/* Both are there, or neither, and not farther apart than two points. */
static void agree(double got, double scanned, double step)
{
    ck_assert_msg(isnan(got) ? isnan(scanned)
                             : fabs(got - scanned) <= 1.01 * step,
                  "F = %g, by the scan %g", got, scanned);
}

/* P and P' of both laws at 7000 points between F = 1 and 8. */
static void limits_are_those_of_a_scan(void)
{
    const double step = 1e-3;
    int limits = 0, rests = 0;
    for (int k = 0; k < 34; k++) {
        const double nu = 0.029 * (k / 2);
        struct material m = material_make(k % 2 ? LOG : CUBIC, 1000.0, nu);
        const double modulus = material_modulus(&m);
        double top = NAN, rest = NAN, slope = INFINITY, stress = 0.0;
        for (int i = 1; i <= 7000; i++) {
            const double F = 1.0 + i * step;
            const double P = material1_pk1(&m, F), dP = material1_dpk1(&m, F);
            if (isnan(top) && dP < 0.0) top = F;
            if (isnan(rest) && P < 0.0) rest = F;
            slope = fmin(slope, dP);
            stress = isnan(top) ? P : fmin(stress, P);
        }
        agree(limit_point(&m), top, step);
        agree(limit_rest(&m), rest, step);
        close_to(limit_least_slope(&m), slope, 1e-5 * modulus);
        close_to(limit_least_stress(&m), stress, 1e-3 * modulus);
        struct material soft = material_make(m.law, 1e-6, nu);
        agree(limit_point(&soft), limit_point(&m), 1e-9); /* of any unit */
        agree(limit_rest(&soft), limit_rest(&m), 1e-9);
        limits += !isnan(top);
        rests += !isnan(rest);
    }
    ck_assert_int_gt(rests, 0);
    ck_assert_int_gt(limits, rests);
    ck_assert_int_lt(limits, 34);
}

UNIT_MAIN("limit",
    LAW(limits_are_those_of_a_scan))
