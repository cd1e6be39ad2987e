/*
 * tangent.c - where is dP/dF negative, and for which Poisson's ratio?
 *
 * One dimension.  dP/dF falls at F = 1 and has one minimum, in tension: for
 * the cubic law it is, with x = F - 1, the convex polynomial
 *
 *     2 mu (1 - x) + lambda (1 - 3 x + 11/2 x^2 - 10/3 x^3 + 5/3 x^4),
 *
 * and for the log law F^2 dP/dF = mu (F^2 + 1) + lambda (1 - ln F), the least
 * value of which is lambda (3/2 + m + ln(2 m) / 2) with m = mu / lambda.  The
 * place of the minimum is a root of the derivative, by central differences;
 * the nu at which the least dP/dF is 0 is a root as well.
 */
#include "material/material.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static double dpk1(double F, void *material)
{
    return material1_dpk1(material, F);
}

static double change_of_dpk1(double F, void *material)
{
    const double h = 1e-5;
    return dpk1(F + h, material) - dpk1(F - h, material);
}

/* Where dP/dF is least, for 0 < nu < 1/2. */
static const double F_END = 100.0;
static double place_of_least(struct material *material)
{
    return study_root(change_of_dpk1, material, 1.0, F_END);
}

/* The least dP/dF as a function of nu, for the law *context and E = 1. */
static double least_at(double nu, void *context)
{
    struct material m = material_make(*(const enum law *)context, 1.0, nu);
    return dpk1(place_of_least(&m), &m);
}

/* dP/dF < 0 from F_from to F_to, for some nu on both sides of the critical
 * one.  Returns the smallest F_from. */
static double print_negative(void)
{
    const struct {
        enum law law;
        double nu;
    } at[] = {{CUBIC, 0.02}, {CUBIC, 0.03}, {CUBIC, 0.07}, {CUBIC, 0.0713},
              {CUBIC, 0.3},  {LOG, 0.3},    {LOG, 0.488},  {LOG, 0.49},
              {LOG, 0.499}};
    double first = F_END;
    table_begin("negative", "law nu F_least dP_least F_from F_to");
    for (int i = 0; i < COUNT(at); i++) {
        struct material m = material_make(at[i].law, 1000.0, at[i].nu);
        const double F = place_of_least(&m), least = dpk1(F, &m);
        double from = 0.0, to = 0.0;
        if (least < 0.0) {
            from = study_root(dpk1, &m, 1.0, F);
            to = study_root(dpk1, &m, F, F_END);
            first = fmin(first, from);
        }
        table_row(material_law(at[i].law), at[i].nu, F, least,
                  cell_if(least < 0.0, from), cell_if(least < 0.0, to));
    }
    table_end();
    return first;
}

/* dP/dF over 2 mu + lambda, for four nu. */
static void print_tangent(enum law law, const double nu[4])
{
    enum { POINTS = 160 };
    table_begin(law == LOG ? "tangent_log" : "tangent_cubic",
                law == LOG ? "F nu_03 nu_045 nu_critical nu_0499"
                           : "F nu_03 nu_01 nu_critical nu_002");
    for (int i = 0; i <= POINTS; i++) {
        double row[5] = {law == LOG ? exp(3.5 * i / POINTS)
                                    : -1.0 + 7.0 * i / POINTS};
        for (int k = 0; k < 4; k++) {
            const struct material m = material_make(law, 1.0, nu[k]);
            row[1 + k] = material1_dpk1(&m, row[0]) / material_modulus(&m);
        }
        table_row_of(5, row);
    }
    table_end();
}

int main(void)
{
    struct material cubic = material_notes(CUBIC), lg = material_notes(LOG);
    const double nu_cubic = study_root(least_at, &cubic.law, 0.01, 0.3);
    const double nu_log = study_root(least_at, &lg.law, 0.3, 0.499);
    cubic = material_make(CUBIC, 1.0, nu_cubic);
    lg = material_make(LOG, 1.0, nu_log);
    const double F_cubic = place_of_least(&cubic), F_log = place_of_least(&lg);

    const double first = print_negative();
    table_begin_note("thresholds", "nu_cubic F_cubic nu_log F_log",
                     "dP/dF > 0 for every F: cubic above, log below");
    table_row(nu_cubic, F_cubic, nu_log, F_log);
    table_end();
    print_tangent(LOG, (const double[]){0.3, 0.45, nu_log, 0.499});
    print_tangent(CUBIC, (const double[]){0.3, 0.1, nu_cubic, 0.02});

    const double x = F_cubic - 1.0, m = lg.mu / lg.lambda;
    const double q = 1.0 + x * (-3.0 + x * (5.5 + 5.0 * x * (x - 2.0) / 3.0));
    claim(fabs(cubic.lambda * q + 2.0 * cubic.mu * (1.0 - x)) < 1e-9 * cubic.mu,
          "at nu = %.7f the least dP/dF of the cubic law is 0", nu_cubic);
    claim(fabs(1.5 + m + 0.5 * log(2.0 * m)) < 1e-9,
          "at nu = %.7f the least dP/dF of the log law is 0", nu_log);
    claim(first > 2.0, "both soften in tension, beyond F = 2 (%g)", first);
    return table_finish();
}
