/*
 * gives_up.c - what does the cubic law give up for never failing?
 *
 * For small nu its stress has a maximum in tension, the limit load, and even
 * returns to 0, another state of rest: where, below which nu, which one Newton
 * finds; and what happens to ten held elements when one end moves at once.
 */
#include "stretch.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

enum { N = 10, N_NU = 8, E = 1000, FAR = 8 };
static const struct newton_control control = {1e-10, 1000, 0, 0};

static double P(double F, void *m) { return material1_pk1(m, F); }
static double dP(double F, void *m) { return material1_dpk1(m, F); }
static double ddP(double F, void *context)
{
    const struct material *m = context;
    const struct volumetric v = material_r(m, F);
    const double dddr = m->law == LOG ? 2.0 / (F * F * F) : 2.0;
    return 3.0 * m->lambda * v.dr * v.ddr + (m->lambda * v.r - m->mu) * dddr;
}

/* The root of f between a and b, NAN where there is none. */
static double zero(study_function *f, void *m, double a, double b)
{
    return a < b && f(a, m) * f(b, m) < 0.0 ? root_of(f, m, a, b) : (double)NAN;
}
static struct cell some(double x) { return cell_if(!isnan(x), x); }

/* Where P' is smallest (P'' = 0 is met once at most), and where P is. */
static double bend(void *m) { return fmin(FAR, zero(ddP, m, 1.0, FAR)); }
static double lowest(void *m) { return fmin(FAR, zero(dP, m, bend(m), FAR)); }

/* The smallest P' and P: 0 where limit load, other rest state disappear. */
static double least_slope(double nu, void *law)
{
    struct material m = material_make(*(enum law *)law, E, nu);
    return dP(bend(&m), &m);
}
static double least_stress(double nu, void *law)
{
    struct material m = material_make(*(enum law *)law, E, nu);
    return P(lowest(&m), &m);
}

/* Returns the largest F at nu = 0.05, the end moved by 1. */
static double localisation(void)
{
    static const double nu[] = {0.3, 0.05, 0.05}, end[] = {1.0, 1.0, 2.5};
    double F[3][N], b[N + 1] = {0.0};
    table_begin("localisation", "nu end reason iterations F_min F_max");
    for (int k = 0; k < 3; k++) {
        const struct material m = material_make(CUBIC, E, nu[k]);
        const struct bar bar = {N, 1.0 / N, {1, 1}, b, m};
        double u[N + 1] = {[N] = end[k]};
        const struct newton_report r = bar_newton(&bar, &control, u, NULL);
        for (int e = 0; e < N; e++) F[k][e] = 1.0 + (u[e + 1] - u[e]) * N;
        table_row(nu[k], end[k], status_name(r.status), r.iterations,
                  gsl_stats_min(F[k], 1, N), gsl_stats_max(F[k], 1, N));
    }
    table_end();
    table_begin("localised", "X nu30 nu5");
    for (int e = 0; e < N; e++) table_row((e + 0.5) / N, F[0][e], F[1][e]);
    table_end();
    return gsl_stats_max(F[1], 1, N);
}

int main(void)
{
    const double nu[N_NU] = {0.0, 0.02, 0.03, 0.05, 0.07, 0.0713, 0.1, 0.3};
    enum law law[] = {CUBIC, LOG};
    struct material m[N_NU], log_law = material_notes(LOG);

    table_begin("giveup", "nu F_limit P_limit F_rest");
    for (int k = 0; k < N_NU; k++) {
        m[k] = material_make(CUBIC, E, nu[k]);
        const double F = zero(dP, &m[k], 1.0, bend(&m[k]));
        const double rest = zero(P, &m[k], F, lowest(&m[k]));
        table_row(nu[k], some(F), some(isnan(F) ? F : P(F, &m[k])), some(rest));
    }
    table_end();
    const double tangent = root_of(least_slope, &law[0], 0.04, 0.2);
    const double rest = root_of(least_stress, &law[0], 0.01, 0.06);
    const double log_tangent = root_of(least_slope, &law[1], 0.45, 0.495);
    table_begin("critical", "cubic_tangent cubic_rest log_tangent");
    table_row(tangent, rest, log_tangent);
    table_end();
    table_begin_note("stress", "F nu0 nu2 nu5 nu7 nu30 log30", "stress / E");
    for (int k = -20; k <= 220; k++) {
        const double F = k / 40.0;
        table_row(F, P(F, &m[0]) / E, P(F, &m[1]) / E, P(F, &m[3]) / E,
                  P(F, &m[4]) / E, P(F, &m[7]) / E,
                  P(fmax(F, 0.05), &log_law) / E);
    }
    table_end();
    double above = -INFINITY; /* the largest F found where nu > rest */
    table_begin("rest_map", "nu start reason iterations F");
    for (int i = 0; i <= 20; i++)
        for (int j = -20; j <= 120; j += 2) {
            const struct material at = material_make(CUBIC, E, 0.005 * i);
            const struct stretch_report end =
                stretch_newton(&at, 0.0, j / 20.0, &control);
            table_row(0.005 * i, j / 20.0, status_name(end.status),
                      end.iterations, cell_if(end.status == OK, end.F));
            if (0.005 * i > rest) above = fmax(above, end.F);
        }
    table_end();
    claim(localisation() > 3.4, "one element of ten is stretched to F > 3.4");
    claim(fabs(tangent - 0.0712) < 5e-5 && fabs(rest - 0.0284) < 5e-5 &&
          fabs(log_tangent - 0.4884) < 5e-5, "the critical nu are 0.0712, "
          "0.0284, 0.4884 (%g, %g, %g)", tangent, rest, log_tangent);
    claim(above < 1.0 + 1e-8, "other states of rest are found below nu = %g "
          "only (F = %g)", rest, above);
    return table_finish();
}
