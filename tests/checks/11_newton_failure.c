/*
 * 11_newton_failure.c - what Newton on one element satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *     11a   material, p, F   three laws; any stress; rest, squashed, inverted
 *     11a   increment        INFINITY, large, at both limits and beside them
 *     11a   tolerance        1e-10; 2^-10 and 2^-20 in limits_are_included
 *     11b   mu, lambda, F    limits_...: nu 0.05 to 0.42 and 0.3; F 0.05 to 4
 *     11c   material, p, F, step   line_search_...: all three laws
 *     11d   material, p, jump      load_stepping_...; also against common/
 *     11d   attempt          budget 1000, 150, 0 to 137 in a run; both searches
 */
#include "program.h"

#include "judge.h"

#include "../oracle/11_newton_failure.h"
#include "figures/11_newton_failure/element.c"

#include <float.h>
#include <stdlib.h>

#define ROUND_OFF 1e-12   /* closed forms */
#define CONVERGED 1e-9    /* quadratic: beyond the tolerance 1e-10 */
#define SHIFT 2           /* stopping tests and round-off move the count */

static const struct newton_control plain = {1e-10, 1000, 0, 0};

static struct material of(enum law law, double nu)
{
    return material_make(law, 1000.0, nu);
}

/* nu = 0, F = 2: P' of the cubic law is exactly 0. */
static void flat_tangent_is_not_finite(void)
{
    const struct material m = of(CUBIC, 0.0);
    const struct outcome out = solve(&m, 0.0, 2.0, &plain);
    if (out.status == OK)
        expect_close(out.F, 1.0, CONVERGED, 1.0,
                     "F that is reported as converged from P' = 0");
    expect(out.status == NONFINITE,
           "P' = 0 gives the step 500 / 0: the reason is NONFINITE, not %s",
           status_name(out.status));
    double step;
    const enum status at_once = newton_step(&m, 0.0, 2.0, 0.1, 1e-10, &step);
    expect(at_once == NONFINITE && step == 0.0,
           "P' = 0 gives the step 500 / 0: newton_step() says %s with the step "
           "%g, not NONFINITE with 0", status_name(at_once), step);
}

static void reason(enum law law, double p, double F, double increment,
                   enum status want, const char *why)
{
    const struct material m = of(law, 0.3);
    double step;
    const enum status got = newton_step(&m, p, F, increment, 1e-10, &step);
    expect(got == want, "p = %g, F = %g, last increment %g: got %s, want %s "
           "(%s)", p, F, increment, status_name(got), status_name(want), why);
    expect(want == MAX_ITERATIONS || step == 0.0, "F = %g, %s: the step is %g; "
           "there is none, so it is 0", F, status_name(got), step);
    if (want == MAX_ITERATIONS)
        expect_close(step, (p - material1_pk1(&m, F)) / material1_dpk1(&m, F),
                     ROUND_OFF, fabs(F), "step from F = %g", F);
}

/* Powers of 2, so that residual and limit are the same number; one digit more
 * is too much. */
static void limits_are_included(void)
{
    const struct material m = {LINEAR, 256.0, 512.0}; /* modulus 1024 */
    for (int c = 0; c < 8; c++) {
        const double tolerance = c % 2 ? 0x1p-10 : 0x1p-20;
        const double limit = tolerance * 1024.0;
        const double p = c / 4 ? nextafter(limit, 1e9) : limit;
        const enum status want = c / 4 ? MAX_ITERATIONS : OK;
        double step;
        const enum status got = newton_step(&m, c / 2 % 2 ? -p : p, 1.0,
                                            tolerance, tolerance, &step);
        expect(got == want, "modulus 1024, tolerance %g, increment the same: a "
               "residual that is %s tolerance times modulus: got %s, want "
               "%s",
               tolerance, c / 4 ? "one digit above" : "exactly",
               status_name(got), status_name(want));
    }
}

static void newton_step_names_the_reason(void)
{
    limits_are_included();
    const struct material m = of(LOG, 0.3);
    const double at_rest = material1_pk1(&m, 0.6137);
    flat_tangent_is_not_finite();
    reason(LOG, 0.0, -0.2385, INFINITY, INVERTED, "no logarithm");
    reason(LOG, 0.0, 0.0, 0.1, INVERTED, "no logarithm");
    reason(CUBIC, 0.0, -9.0, INFINITY, MAX_ITERATIONS,
           "the cubic law is defined there");
    reason(LOG, -238.5, 1.0, INFINITY, MAX_ITERATIONS, "the first step");
    reason(CUBIC, 371.4, 2.385, 0.5, MAX_ITERATIONS, "not there yet");
    reason(LOG, NAN, 0.6137, 0.1, NONFINITE, "the residual is a NaN");
    reason(LOG, at_rest, 0.6137, 1e-12, OK, "residual and increment small");
    reason(LOG, at_rest, 0.6137 + 1e-14, 1e-3, MAX_ITERATIONS,
           "the increment is not small yet");
    /* on both sides of the tolerances, and at them */
    const double small = 1e-10 * material_modulus(&m);
    reason(LOG, at_rest + 0.5 * small, 0.6137, 1e-12, OK,
           "the residual is half of tolerance times modulus");
    reason(LOG, at_rest + 2.0 * small, 0.6137, 1e-12, MAX_ITERATIONS,
           "the residual is twice tolerance times modulus");
    reason(LOG, at_rest + 0.5 * small, 0.6137, 1e-10, OK,
           "the increment is the tolerance");
    reason(LOG, at_rest + 0.5 * small, 0.6137, 2e-10, MAX_ITERATIONS,
           "the increment is twice the tolerance");
    reason(LOG, 0.0, 0.6137, DBL_EPSILON, STALLED,
           "the increment is DBL_EPSILON, the residual is large");
    reason(LOG, 0.0, 0.6137, 2.0 * DBL_EPSILON, MAX_ITERATIONS,
           "the increment is twice DBL_EPSILON");
    reason(LOG, 0.0, 1e-12, 1e-12, MAX_ITERATIONS,
           "the increment is small, the residual 1e16");
    reason(LOG, at_rest + 0.5 * small, 0.6137, NAN, MAX_ITERATIONS,
           "the residual is half of tolerance times modulus, the increment "
           "NaN");
    reason(LOG, 0.0, 0.6137, 1e-17, STALLED,
           "the increment cannot change F, the residual is large");
}

/* Another material, and the tangent's meeting with F = 0 in place of algebra */
static void limits_are_where_the_tangent_meets_zero(void)
{
    for (double nu = 0.05; nu < 0.5; nu += 0.1237) {
        const struct material m = material_make(LOG, 2.385, nu);
        const struct material c = material_make(CUBIC, 2.385, nu);
        for (double F = 0.137; F < 4.0; F += 0.6137) {
            const struct limits l = predict(m.mu, m.lambda, F);
            const double P = material1_pk1(&m, F), dP = material1_dpk1(&m, F);
            expect_close(l.load, P - F * dP, 1e-11, fabs(P) + fabs(F * dP),
                         "limit load, nu = %g, F = %g", nu, F);
            expect_close(l.step, F * dP, 1e-11, fabs(P) + fabs(F * dP),
                         "largest load step, nu = %g, F = %g", nu, F);
        }
        const struct limits l = predict(m.mu, m.lambda, 1.0);
        /* at the largest start the tangent passes through the origin */
        expect_close(material1_pk1(&m, l.start) / l.start,
                     material1_dpk1(&m, l.start), 1e-11, m.mu,
                     "P / F against P' at the largest start, nu = %g", nu);
        expect_close(l.pull, 1.0 - l.start, ROUND_OFF, l.start,
                     "pull, nu = %g", nu);
        expect_close(l.collapse, material1_pk1(&c, 0.0), ROUND_OFF,
                     fabs(l.collapse), "P(0) of the cubic law, nu = %g", nu);
    }
}

static void limits_are_the_oracles(void)
{
    const struct material m = of(LOG, 0.3);
    for (int k = 0; k < COUNT(oracle_step); k++) {
        const struct limits l = predict(m.mu, m.lambda, oracle_step[k].F);
        expect_close(l.step, oracle_step[k].step, ROUND_OFF, l.step,
                     "largest load step from F = %g", oracle_step[k].F);
        expect_close(l.load, oracle_step[k].p - oracle_step[k].step, ROUND_OFF,
                     -l.load, "limit load from F = %g", oracle_step[k].F);
    }
    const struct limits l = predict(m.mu, m.lambda, 1.0);
    expect_close(l.load, oracle_load, ROUND_OFF, -oracle_load,
                 "limit load from rest, -(2 mu + lambda)");
    expect_close(l.start, oracle_start, ROUND_OFF, 3.0, "largest start");
    expect_close(l.push, 1.0, ROUND_OFF, 1.0, "push, dg / h");
    expect_close(l.pull, oracle_pull, ROUND_OFF, 3.0, "pull, dg / h");
    expect_close(l.collapse, oracle_collapse, ROUND_OFF, -oracle_collapse,
                 "stress at which the cubic law has F = 0");
    limits_are_where_the_tangent_meets_zero();
}

static double energy(const struct material *m, double p, double F)
{
    return material1_psi(m, F) - p * (F - 1.0);
}

/* Is this length acceptable?  slack > 0 makes it harder. */
static int armijo(const struct material *m, double p, double F, double step,
                  double length, double slack)
{
    const double slope = (material1_pk1(m, F) - p) * step;
    return material_defined(m, F + length * step) &&
           energy(m, p, F + length * step) <=
               energy(m, p, F) + 1e-4 * length * slope -
                   slack * fabs(energy(m, p, F));
}

static void line_search_refuses_to_climb(void)
{
    const struct material m = of(CUBIC, 0.02);
    double length;
    const double step = -material1_pk1(&m, 3.0) / material1_dpk1(&m, 3.0);
    const enum status status = line_search(&m, 0.0, 3.0, step, &length);
    expect(status == NOT_SPD,
           "nu = 0.02, F = 3: P' < 0 and the step leads uphill: NOT_SPD, not "
           "%s", status_name(status));
    const enum status flat = line_search(&m, 0.0, 3.0, 0.0, &length);
    expect(flat == NOT_SPD, "a step of length 0 does not lead downhill: "
           "NOT_SPD, not %s", status_name(flat));
}

static void expect_length(const struct material *m, double p, double F,
                          double step, double want, const char *why)
{
    double length;
    const enum status status = line_search(m, p, F, step, &length);
    if (want > 0.0)
        expect(status == OK && length == want, "p = %g, F = %g, step %g: got "
               "%s, length %g, want OK with length %g (%s)", p, F, step,
               status_name(status), length, want, why);
    else
        expect(status == STALLED, "p = %g, F = %g, step %g: got %s, length %g, "
               "want STALLED (%s)", p, F, step, status_name(status), length,
               why);
}

/* The linear law's energy is a parabola: it decreases with a step of t times
 * Newton's where t < 2, and enough for Armijo where t <= 2 (1 - 1e-4). */
static void line_search_asks_for_enough(void)
{
    const struct material m = of(LINEAR, 0.3);
    const double newton = -0.5; /* from F = 1.5 to rest */
    expect_length(&m, 0.0, 1.5, 2.0 * (1.0 - 1.5e-4) * newton, 1.0,
                  "the energy decreases by 1.5e-4 of the slope");
    expect_length(&m, 0.0, 1.5, 2.0 * (1.0 - 0.7e-4) * newton, 0.5,
                  "at length 1 it decreases by 0.7e-4 of the slope only");
    expect_length(&m, 0.0, 1.5, 2.0 * (1.0 + 0.5e-4) * newton, 0.5,
                  "at length 1 it increases");
}

/* Only from this length on is F + length step positive. */
static void line_search_goes_down_to_its_limit(void)
{
    const struct material m = of(LOG, 0.3);
    expect_length(&m, -1e5, 1.0, -0.9 * ldexp(1.0, 39), ldexp(1.0, -39),
                  "2^-39 = 1.8e-12 is tried");
    expect_length(&m, -1e5, 1.0, -0.9 * ldexp(1.0, 40), 0.0,
                  "2^-40 = 0.9e-12 is not");
    const struct material c = of(CUBIC, 0.3);
    expect_length(&c, 0.0, 0.5, 1e200, 0.0,
                  "F^6 overflows: no energy there is a number");
}

/* From one side of the minimum to twice as far on the other: the energy w grows
 * by as many eps |w| as wanted, of which 3 may be round-off. */
static void line_search_allows_for_noise(double eps, double want)
{
    const struct material m = of(LOG, 0.3);
    const double p = -1000.0, least = solve(&m, p, 1.0, &plain).F;
    const double w = energy(&m, p, least), dP = material1_dpk1(&m, least);
    double off = sqrt(eps * DBL_EPSILON * fabs(w) / (1.5 * dP)), best = NAN;
    for (int k = -200; k <= 200; k++) { /* where it does in these digits */
        const double d = off * (1.0 + 1e-4 * k);
        const double grown = (energy(&m, p, least + 2.0 * d) -
                              energy(&m, p, least - d)) /
                             (DBL_EPSILON * fabs(w));
        if (fabs(grown - eps) < 0.5) best = d;
    }
    expect(isfinite(best), "no such state"); /* never with this material */
    expect_length(&m, p, least - best, 3.0 * best, want,
                  want == 1.0 ? "the energy grows by 12 eps, noise is 16"
                              : "at length 1 it grows by 24 eps, noise is 16");
}

static void line_search_takes_the_first_length_that_descends(void)
{
    line_search_asks_for_enough();
    line_search_goes_down_to_its_limit();
    line_search_allows_for_noise(12.0, 1.0);
    line_search_allows_for_noise(24.0, 0.5);
    static const struct { enum law law; double nu, p, F; } scene[] = {
        {LOG, 0.3, -100.0, 1.0},   {LOG, 0.3, -1340.0, 1.0},
        {LOG, 0.3, -2385.0, 1.0},  {LOG, 0.3, -37140.0, 1.0},
        {LOG, 0.3, 0.0, 2.985},    {LOG, 0.3, 0.0, 3.714},
        {CUBIC, 0.3, -23850, 1.0}, {LOG, 0.42, 238.5, 0.0137}};
    for (int k = 0; k < COUNT(scene); k++) {
        const struct material m = of(scene[k].law, scene[k].nu);
        const double p = scene[k].p, F = scene[k].F;
        const double step =
            (p - material1_pk1(&m, F)) / material1_dpk1(&m, F);
        double length;
        const enum status status = line_search(&m, p, F, step, &length);
        expect(status == OK, "p = %g from F = %g: %s, but P' > 0 and a short "
               "step descends", p, F, status_name(status));
        expect(length > 0.0 && log2(length) == floor(log2(length)),
               "length %g is not one of 1, 1/2, 1/4, ...", length);
        expect(armijo(&m, p, F, step, length, -1e-12),
               "p = %g from F = %g: length %g leads to F = %g, where the "
               "energy has not decreased", p, F, length, F + length * step);
        expect(length == 1.0 || !armijo(&m, p, F, step, 2.0 * length, 1e-12),
               "p = %g from F = %g: length %g, but %g would do", p, F, length,
               2.0 * length);
    }
    line_search_refuses_to_climb();
}

static void load_stepping_arrives(void)
{
    const struct material m = of(LOG, 0.3);
    static const double p[] = {-1000.0, -2385.0, -37140.0, -1e5, 714.0};
    for (int k = 0; k < COUNT(p); k++) {
        const struct outcome out = load_stepping(&m, p[k], 0.0, &plain);
        expect(out.status == OK, "p = %g: got %s with F = %g, want OK; after a "
               "failed step go back to the last equilibrium and halve", p[k],
               status_name(out.status), out.F);
        expect_close(material1_pk1(&m, out.F), p[k], CONVERGED,
                     fabs(p[k]) + 1000.0, "P(F) at the end of the way");
    }
    const struct outcome one = solve(&m, -1000.0, 1.0, &plain);
    const struct outcome same = load_stepping(&m, -1000.0, 0.0, &plain);
    expect(one.iterations == same.iterations,
           "p = -1000 needs no stepping: %d iterations, not %d (the first "
           "attempt is the whole way)", one.iterations, same.iterations);
    static const double jump[] = {3.714, 12.385, -6.137};
    for (int k = 0; k < COUNT(jump); k++) {
        const struct outcome out = load_stepping(&m, 0.0, jump[k], &plain);
        expect(out.status == OK, "boundary moved by %g h: %s", jump[k],
               status_name(out.status));
        expect_close(out.F, 1.0, CONVERGED, 1.0,
                     "F of the unloaded element after dg = %g h", jump[k]);
    }
}

/* Attempts that fail beyond the limit load take 25 each; from rest to 37140 the
 * way ends in a step that is cut to what is left. */
static void load_stepping_counts_every_iteration(void)
{
    for (int c = 0; c < 2; c++) {
        const struct material m = c ? of(LOG, 0.02) : of(CUBIC, 0.0);
        const double p = c ? -37140.0 : 613.7;
        const int got = load_stepping(&m, p, 0.0, &plain).iterations;
        const int want = element_stepping(&m, p, 0.0, &plain).iterations;
        expect(abs(got - want) <= SHIFT, "%s law, p = %g: %d iterations in "
               "all, the studies' element.h needs %d", material_law(m.law), p,
               got, want);
    }
}

/* The cubic law at nu = 0 carries no more than mu = E / 2. */
static void load_stepping_stops_at_the_limit_load(void)
{
    const struct material m = of(CUBIC, 0.0);
    const struct outcome out = load_stepping(&m, 613.7, 0.0, &plain);
    expect(out.status == STALLED,
           "nu = 0: P never exceeds 500, p = 613.7 has no answer: STALLED, not "
           "%s", status_name(out.status));
    expect_close(material1_pk1(&m, out.F), 500.0, 2e-3, 500.0,
                 "load of the last equilibrium, 613.7 / 1024 below the limit");
    expect(out.F < 2.0, "the last equilibrium, F = %g, is before the limit "
           "point F = 2", out.F);
    /* 500 / p is 853.7 / 1024: with steps of 2^-10 the way ends at 853 of them,
     * with 2^-9 at 852 and with 2^-11 at 853.5 */
    const double p = 500.0 * 1024.0 / 853.7;
    expect_close(material1_pk1(&m, load_stepping(&m, p, 0.0, &plain).F),
                 p * 853.0 / 1024.0, 1e-6, 500.0,
                 "nu = 0, p = %g, the limit load 500 at 853.7 / 1024 of it: "
                 "load of the last equilibrium when steps end at 2^-10", p);
    load_stepping_counts_every_iteration();
}

static void runs_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_newton); k++) {
        const struct material m = of(oracle_newton[k].cubic ? CUBIC : LOG, 0.3);
        const double p = oracle_newton[k].p, start = oracle_newton[k].start;
        const struct outcome out = solve(&m, p, start, &plain);
        const enum status want =
            oracle_newton[k].iterations < 0 ? INVERTED : OK;
        expect(out.status == want, "%s law, p = %g from F = %g: %s, not %s",
               oracle_newton[k].cubic ? "cubic" : "log", p, start,
               status_name(want), status_name(out.status));
        if (want != OK) continue;
        expect_close(out.F, oracle_newton[k].F, CONVERGED, 1.0,
                     "F at p = %g from %g", p, start);
        expect_close(out.iterations, oracle_newton[k].iterations, SHIFT, 1.0,
                     "iterations at p = %g from %g", p, start);
    }
    for (int k = 0; k < COUNT(oracle_rest); k++) {
        const struct material m = of(CUBIC, oracle_rest[k].nu);
        expect_close(solve(&m, 0.0, oracle_rest[k].start, &plain).F,
                     oracle_rest[k].F, CONVERGED, 1.0,
                     "rest state from F0 = %g, nu = %g", oracle_rest[k].start,
                     oracle_rest[k].nu);
    }
}

/* The first step of a squashed start is small, its residual is enormous. */
static void small_steps_are_no_convergence(void)
{
    const struct material m = of(LOG, 0.3);
    for (int k = 0; k < COUNT(oracle_false); k++) {
        const double F = oracle_false[k].start;
        double step;
        newton_step(&m, 0.0, F, INFINITY, 1e-10, &step);
        expect_close(step / F, oracle_false[k].step_over_start, 1e-10, 1.0,
                     "first step / F0 for F0 = %g", F);
        expect_close(material1_pk1(&m, F), oracle_false[k].residual, 1e-10,
                     fabs(oracle_false[k].residual), "residual at F0 = %g", F);
        expect_close(solve(&m, 0.0, F, &plain).F, 1.0, CONVERGED, 1.0,
                     "F from F0 = %g: small increments are no convergence", F);
    }
}

/* Outside the closed forms nothing fails, inside nothing converges. */
static void map_and_prediction_agree(void)
{
    const struct material m = of(LOG, 0.237), c = of(CUBIC, 0.237);
    const double pull = predict(m.mu, m.lambda, 1.0).pull;
    for (double load = -3.983; load < 2.0; load += 0.2599)
        for (double F = -0.977; F < 5.0; F += 0.2584) {
            const double p = load * material_modulus(&m);
            const int fails = F <= 0.0 || p <= predict(m.mu, m.lambda, F).load;
            const enum status got = solve(&m, p, F, &plain).status;
            expect(got == (fails ? INVERTED : OK),
                   "log law, p = %g from F = %g: %s", p, F, status_name(got));
            expect(solve(&c, p, F, &plain).status == OK,
                   "cubic law, p = %g from F = %g does not converge", p, F);
        }
    for (double dg = -5.037; dg < 3.0; dg += 0.2385) {
        const enum status got = solve(&m, 0.0, 1.0 - dg, &plain).status;
        expect((got == OK) == (pull < dg && dg < 1.0),
               "boundary moved by %g h: %s", dg, status_name(got));
    }
}

/* The studies' element.h, which is bar_newton() on one element. */
static void same_as_common_stretch(void)
{
    static const double p[] = {-37140.0, -1347.0, -100.0, 0.0, 613.7};
    static const double start[] = {-6.137, 0.2385, 1.0, 2.985, 3.714};
    for (int law = LINEAR; law <= CUBIC; law++)
        for (int k = 0; k < 2 * COUNT(p) * COUNT(start); k++) {
            const struct material m = of((enum law)law, law == CUBIC ? 0 : 0.3);
            const struct newton_control control = {1e-10, 150, k % 2, 0};
            const double load = p[k / 2 % COUNT(p)];
            const double F = start[k / 2 / COUNT(p)];
            const struct outcome got[] = {
                solve(&m, load, F, &control),
                load_stepping(&m, load, 1.0 - F, &control)};
            const struct element_report want[] = {
                element_newton(&m, load, F, &control),
                element_stepping(&m, load, 1.0 - F, &control)};
            for (int w = 0; w < 2; w++) {
                expect(got[w].status == want[w].status,
                       "%s law, p = %g, F0 = %g, %s: %s, the studies' "
                       "element.h says %s", material_law(m.law), load, F,
                       w ? "load stepping" : "solve",
                       status_name(got[w].status), status_name(want[w].status));
                if (got[w].status != OK) continue;
                expect_close(got[w].F, want[w].F, CONVERGED, 1.0 + fabs(F),
                             "F at p = %g from %g", load, F);
            }
        }
}

/* What is solved ends with a residual of 0 to round-off, and what is not ends
 * with its reason after the history up to the failure. */
static void history_goes_as_far_as_the_run(void)
{
    struct output *output = run_unsolved("--p -1347", "INVERTED");
    expect(row_count(output, "history") == 2,
           "--p -1347: the history has %d rows and not 2, the start and the "
           "state that is inverted", row_count(output, "history"));
    expect(cell(output, "history", "F", 1) < 0.0 &&
               is_missing(output, "history", "residual", 1),
           "--p -1347: the last row of the history is the inverted state, "
           "which has no residual");
    output = run_unsolved("--law cubic --nu 0 --p 613.7 --stepping on",
                          "STALLED");
    expect_close(cell(output, "history", "F", -1), 1.98, 0.02, 1.0,
                 "F of the last equilibrium before the limit load");
    output = run("--p -37140 --search on");
    expect_close(cell(output, "history", "residual", -1), 0.0, CONVERGED,
                 37140.0, "residual in the last row of the history");
}

static void failures_are_refused_with_their_reason(void)
{
    expect_refusal("--law cubic --nu 0 --start 2 --p 0", 1, "NONFINITE");
    expect_refusal("--law cubic --nu 0 --p 613.7", 1, "MAX_ITERATIONS");
    expect_refusal("--law cubic --nu 0.02 --start 3 --p 0 --search on", 1,
                   "NOT_SPD");
    expect_refusal("--start 1e-200 --p 0", 1, "STALLED");
    expect_refusal("--start -0.137", 1, "INVERTED after 0 iterations");
    expect_refusal("--nu 0.5", 2, "lambda is infinite");
    expect_refusal("--p nan", 2, "--p");
    expect_refusal("--cap 0", 2, "--cap");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("--p -1346");
    measured("1", cell(output, "history", "k", -1));
    measured("2", asin(0.01 * cell(output, "limits", "push", 0)));
}

static const struct claim claims[] = {
    {"newton_step_names_the_reason", newton_step_names_the_reason, "11a"},
    {"limits_are_the_oracles", limits_are_the_oracles, "11b"},
    {"line_search_takes_the_first_length_that_descends",
     line_search_takes_the_first_length_that_descends, "11c"},
    {"load_stepping_arrives", load_stepping_arrives, "11d"},
    {"load_stepping_stops_at_the_limit_load",
     load_stepping_stops_at_the_limit_load, "11d"},
    {"runs_are_the_oracles", runs_are_the_oracles, "11a"},
    {"small_steps_are_no_convergence", small_steps_are_no_convergence, "11a"},
    {"map_and_prediction_agree", map_and_prediction_agree, "11a"},
    {"same_as_common_stretch", same_as_common_stretch, "11d"},
    {"history_goes_as_far_as_the_run", history_goes_as_far_as_the_run, NULL},
    {"failures_are_refused_with_their_reason",
     failures_are_refused_with_their_reason, "11a"},
};

static const char *const runs[] = {
    "",
    "--nu 0.137 --law cubic --p 238.5",
    "--nu 0.42 --p -371.4 --start 2.4 --search on",
    "--p -1340 --search on",
    "--law cubic --nu 0.02 --p 0 --start 3 --search on --stepping on",
    "--p -5371 --stepping on --cap 137",
    "--start -1.385 --p 0 --stepping on --nu 0",
    "--law linear --p -2385 --start 0.613",
};

static const struct column_rule rules[] = {
    {"history", "k", 0, "a count", 0},
    {"history", "*", 1e-6, "early iterates amplify round-off", 0},
    {"limits", "*", 1e-11, "closed forms", 0},
};

static const struct lesson lesson = {
    "11_newton_failure", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Not one point of the map contradicts the boundary drawn over it "
    "(figures/11_newton_failure/load_map.svg): the whole failure of the log "
    "law is one tangent that meets F = 0, because P is concave there.",
    "Run --law cubic --p -5000: it converges in a few iterations, to F < 0, a "
    "bar turned inside out, and no status says so. Then run --law cubic --nu 0 "
    "--start 2.5 --p 0: where does the bar come to rest, and what is the "
    "status?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
