/* 11_newton_failure.c - what right maps of Newton's failures satisfy. */
#include "judge.h"

#define main program_main
#include PROGRAM
#undef main

#include "../oracle/11_newton_failure.h"

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
}

static void reason(enum law law, double p, double F, double increment,
                   enum status want, const char *why)
{
    const struct material m = of(law, 0.3);
    double step;
    const enum status got = newton_step(&m, p, F, increment, 1e-10, &step);
    expect(got == want, "p = %g, F = %g, last increment %g: %s, not %s (%s)", p,
           F, increment, status_name(want), status_name(got), why);
    if (want == MAX_ITERATIONS)
        expect_close(step, (p - material1_pk1(&m, F)) / material1_dpk1(&m, F),
                     ROUND_OFF, fabs(F), "step from F = %g", F);
}

static void newton_step_names_the_reason(void)
{
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
    reason(LOG, 0.0, 1e-12, 1e-12, MAX_ITERATIONS,
           "the increment is small, the residual 1e16");
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
    expect_close(l.push, 1.0, ROUND_OFF, 1.0, "push, dg / dX");
    expect_close(l.pull, oracle_pull, ROUND_OFF, 3.0, "pull, dg / dX");
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
}

static void line_search_takes_the_first_length_that_descends(void)
{
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

/* The boundary of a bar of 7 elements, free at the other end, moves by dg. */
static void boundary_step_is_one_scalar_newton(void)
{
    enum { n = 7 };
    const double b[n + 1] = {0.0};
    for (int k = -6; k < 4; k++) {
        const double jump = 0.4237 * k + 0.05;
        const struct bar bar = {n, 1.0 / n, {1, 0}, b, of(LOG, 0.3)};
        double u[n + 1] = {jump / n};
        const struct newton_report report = bar_newton(&bar, &plain, u, NULL);
        const struct outcome out =
            cured(PLAIN, bar.material, 0.0, jump, n, plain);
        expect(out.status == report.status,
               "dg = %g dX: %s, the bar of 7 elements says %s", jump,
               status_name(out.status), status_name(report.status));
    }
}

/* One element with a free end is bar_newton(), answer and all. */
static void scalar_newton_is_the_bar(void)
{
    static const double p[] = {-1347.0, -1000.0, -37140.0, 238.5, 1000.0};
    for (int l = 1; l < 3; l++)
        for (int s = 0; s < 2; s++)
            for (int k = 0; k < COUNT(p); k++) {
                const struct material m = of((enum law)l, 0.3);
                const struct newton_control control = {1e-10, 1000, s, 0};
                const double b[] = {0.0, p[k]};
                const struct bar bar = {1, 1.0, {1, 0}, b, m};
                double u[] = {0.0, 0.0};
                const struct newton_report report =
                    bar_newton(&bar, &control, u, NULL);
                const struct outcome out = solve(&m, p[k], 1.0, &control);
                expect(out.status == report.status,
                       "p = %g: %s, the bar says %s", p[k],
                       status_name(out.status), status_name(report.status));
                expect(abs(out.iterations - report.iterations) <= SHIFT,
                       "p = %g: %d iterations, the bar needs %d", p[k],
                       out.iterations, report.iterations);
                if (out.status == OK)
                    expect_close(out.F, 1.0 + u[1], CONVERGED, 1.0,
                                 "F under p = %g, against the bar", p[k]);
            }
    boundary_step_is_one_scalar_newton();
}

static void load_stepping_arrives(void)
{
    const struct material m = of(LOG, 0.3);
    static const double p[] = {-1000.0, -2385.0, -37140.0, -1e5, 714.0};
    for (int k = 0; k < COUNT(p); k++) {
        const struct outcome out = load_stepping(&m, p[k], 0.0, &plain);
        expect(out.status == OK, "p = %g: %s with F = %g; after a failed step "
               "go back to the last equilibrium and halve", p[k],
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
        expect(out.status == OK, "boundary moved by %g dX: %s", jump[k],
               status_name(out.status));
        expect_close(out.F, 1.0, CONVERGED, 1.0,
                     "F of the unloaded element after dg = %g dX", jump[k]);
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
    struct output *output = run("");
    for (int k = 0; k < COUNT(oracle_false); k++) {
        expect_close(cell(output, "false", "step_over_start", k),
                     oracle_false[k].step_over_start, 1e-10, 1.0,
                     "first step / F0 for F0 = %g", oracle_false[k].start);
        expect_close(cell(output, "false", "residual", k),
                     oracle_false[k].residual, 1e-10,
                     fabs(oracle_false[k].residual),
                     "residual at F0 = %g", oracle_false[k].start);
        expect_close(cell(output, "false", "F", k), 1.0, CONVERGED, 1.0,
                     "F from F0 = %g: small increments are no convergence",
                     oracle_false[k].start);
    }
}

/* Outside the closed forms nothing fails, inside nothing converges. */
static void map_and_prediction_agree(void)
{
    struct output *output = run("--nu 0.237 --grid 24 --p 100");
    const struct material m = of(LOG, 0.237);
    const double largest = exp(0.5 + m.mu / m.lambda);
    int rows;
    const double *load = column(output, "load_map", "load", &rows);
    const double *start = column(output, "load_map", "start", NULL);
    const double *found = column(output, "load_map", "reason_log", NULL);
    const double *cubic = column(output, "load_map", "reason_cubic", NULL);
    for (int k = 0; k < rows; k++) {
        const double F = start[k], p = load[k] * (2.0 * m.mu + m.lambda);
        const int fails =
            F <= 0.0 ||
            p <= material1_pk1(&m, F) - F * material1_dpk1(&m, F);
        expect(found[k] == (fails ? INVERTED : OK),
               "log law, p = %g from F = %g: reason %g", p, F, found[k]);
        expect(cubic[k] == OK, "cubic law, p = %g from F = %g: reason %g", p,
               F, cubic[k]);
    }
    const double *dg = column(output, "step_map", "dg", &rows);
    const double *n = column(output, "step_map", "n", NULL);
    const double *push = column(output, "step_map", "push", NULL);
    const double *pull = column(output, "step_map", "pull", NULL);
    const double *lift = column(output, "step_map", "pull_lift", NULL);
    for (int k = 0; k < rows; k++) {
        expect((push[k] == OK) == (dg[k] * n[k] < 1.0),
               "push by %g, %g elements: reason %g", dg[k], n[k], push[k]);
        expect((pull[k] == OK) == (dg[k] * n[k] < largest - 1.0),
               "pull by %g, %g elements: reason %g", dg[k], n[k], pull[k]);
        expect((lift[k] == OK) == (dg[k] < largest - 1.0),
               "pull by %g with the lift: reason %g", dg[k], lift[k]);
    }
}

static void example_is_the_oracles(void)
{
    struct output *output = run("");
    int rows;
    const double *n = column(output, "example", "n", &rows);
    const double *dt = column(output, "example", "dt", NULL);
    for (int k = 0; k < COUNT(oracle_example); k++) {
        int r = 0;
        while (r < rows && !(lround(n[r]) == oracle_example[k].n &&
                             fabs(dt[r] - oracle_example[k].dt) < 1e-9))
            r++;
        expect(r < rows, "table `example` lacks n = %d, dt = %g",
               oracle_example[k].n, oracle_example[k].dt);
        expect_close(cell(output, "example", "largest_step", r),
                     oracle_example[k].largest_step, 1e-11, 50.0,
                     "largest |dg| / dX");
        expect_close(cell(output, "example", "log_fails", r),
                     oracle_example[k].fails, 1e-9, 1.0,
                     "time of the log law's first failure, n = %d, dt = %g",
                     oracle_example[k].n, oracle_example[k].dt);
        if (oracle_example[k].log >= 0)
            expect_close(cell(output, "example", "log_iterations", r),
                         oracle_example[k].log, SHIFT, 1.0,
                         "iterations of the log law");
        expect_close(cell(output, "example", "cubic_iterations", r),
                     oracle_example[k].cubic, SHIFT, 1.0,
                     "iterations of the cubic law");
    }
}

static void giveup_is_the_oracles(void)
{
    struct output *output = run("");
    expect_close(cell(output, "critical", "cubic_tangent", 0),
                 oracle_cubic_tangent, 1e-8, 1.0, "nu of the limit load");
    expect_close(cell(output, "critical", "cubic_rest", 0), oracle_cubic_rest,
                 1e-8, 1.0, "nu of the second rest state");
    expect_close(cell(output, "critical", "log_tangent", 0),
                 oracle_log_tangent, 1e-7, 1.0, "nu of the log law's tangent");
    for (int k = 0, r = 0; k < COUNT(oracle_giveup); k++, r++) {
        if (r == 3) r = 4; /* nu = 0.05 is not in the oracle */
        expect_close(cell(output, "giveup", "nu", r), oracle_giveup[k].nu,
                     1e-14, 1.0, "nu of row %d", r);
        expect_close(cell(output, "giveup", "F_limit", r),
                     oracle_giveup[k].F_limit, 1e-9, 1.0, "F of limit load");
        expect_close(cell(output, "giveup", "P_limit", r),
                     oracle_giveup[k].P_limit, 1e-9, 500.0, "limit load");
        expect_close(cell(output, "giveup", "F_rest", r),
                     oracle_giveup[k].F_rest, 1e-9, 1.0, "second rest state");
    }
    for (int k = 0; k < COUNT(oracle_localisation); k++) {
        expect_close(cell(output, "localisation", "iterations", k),
                     oracle_localisation[k].iterations, SHIFT, 1.0,
                     "iterations, both ends held, case %d", k);
        expect_close(cell(output, "localisation", "F_min", k),
                     oracle_localisation[k].F_min, CONVERGED, 1.0, "min F");
        expect_close(cell(output, "localisation", "F_max", k),
                     oracle_localisation[k].F_max, CONVERGED, 1.0, "max F");
    }
}

static void failures_are_refused_with_their_reason(void)
{
    expect_refusal("--p -1347", 1, "INVERTED");
    expect_refusal("--law cubic --nu 0 --start 2 --p 0", 1, "NONFINITE");
    expect_refusal("--law cubic --nu 0 --p 613.7", 1, "MAX_ITERATIONS");
    expect_refusal("--start -0.137", 2, "F > 0");
    expect_refusal("--nu 0.5", 2, "incompressible");
    expect_refusal("--E 0", 2, "--E");
    expect_refusal("--p nan", 2, "--p");
    expect_refusal("--n 0", 2, "--n");
}

static const struct claim claims[] = {
    {"newton_step_names_the_reason", newton_step_names_the_reason, "11a"},
    {"limits_are_the_oracles", limits_are_the_oracles, "11b"},
    {"line_search_takes_the_first_length_that_descends",
     line_search_takes_the_first_length_that_descends, "11c"},
    {"scalar_newton_is_the_bar", scalar_newton_is_the_bar, "11a"},
    {"load_stepping_arrives", load_stepping_arrives, "11d"},
    {"load_stepping_stops_at_the_limit_load",
     load_stepping_stops_at_the_limit_load, "11d"},
    {"runs_are_the_oracles", runs_are_the_oracles, "11a"},
    {"map_and_prediction_agree", map_and_prediction_agree, "11a"},
    {"example_is_the_oracles", example_is_the_oracles, NULL},
    {"giveup_is_the_oracles", giveup_is_the_oracles, NULL},
    {"failures_are_refused_with_their_reason",
     failures_are_refused_with_their_reason, "11a"},
};

static const char *const runs[] = {
    "",
    "--nu 0.137 --grid 21 --law cubic --p 238.5",
    "--nu 0.42 --E 2.4 --p -0.6 --start 2.4 --search on --hard -9.3 --grid 17",
    "--n 3 --tolerance 1e-7 --cap 137 --grid 15 --hard -0.6",
};

#define GRID "a point of the grid"
#define REASON "reasons are equal; no grid point is within 1e-4 of a boundary"
#define COUNTED "round-off near a boundary may cost two iterations"
#define ANSWER "Newton ends beyond its tolerance of 1e-10"
static const struct column_rule rules[] = {
    {"history", "k", 0, "a count", 0},
    {"history", "*", 1e-6, "early iterates amplify round-off", 0},
    {"limits", "*", 1e-11, "closed forms", 0},
    {"boundary", "*", 1e-11, "closed forms", 0},
    {"loads", "p", 1e-14, "given", 0},
    {"loads", "reason_log", 0, REASON, 1},
    {"loads", "reason_cubic", 0, REASON, 1},
    {"loads", "iterations_log", 2, COUNTED, 1},
    {"loads", "iterations_cubic", 2, COUNTED, 1},
    {"loads", "*", 1e-8, ANSWER, 1},
    {"load_map", "load", 1e-14, GRID, 0},
    {"load_map", "start", 1e-14, GRID, 0},
    {"load_map", "reason_log", 0, REASON, 1},
    {"load_map", "reason_cubic", 0, REASON, 1},
    {"load_map", "*", 2, COUNTED, 1},
    {"step_map", "dg", 1e-13, GRID, 0},
    {"step_map", "push_iterations", 2, COUNTED, 1},
    {"step_map", "pull_iterations", 2, COUNTED, 1},
    {"step_map", "*", 0, REASON, 1},
    {"example", "log_iterations", 2, COUNTED, 1},
    {"example", "cubic_iterations", 2, COUNTED, 1},
    {"example", "*", 1e-12, "sines", 0},
    {"false", "iterations", 2, COUNTED, 1},
    {"false", "reason", 0, REASON, 1},
    {"false", "F", 1e-8, ANSWER, 1},
    {"false", "*", 1e-10, "one step", 0},
    {"giveup", "*", 1e-9, "bisection to round-off", 0},
    {"critical", "*", 1e-7, "bisection of a sampled minimum", 0},
    {"stress", "*", 1e-12, "closed forms", 0},
    {"rest_map", "nu", 1e-14, GRID, 0},
    {"rest_map", "start", 1e-14, GRID, 0},
    {"rest_map", "reason", 0, REASON, 1},
    {"rest_map", "iterations", NOT_COMPARED,
     "a start near P' = 0 is thrown far and may need many", 0},
    {"rest_map", "F", NOT_COMPARED,
     "near P' = 0 round-off decides which rest state is found", 0},
    {"limit_load", "iterations_plain", 2, COUNTED, 1},
    {"limit_load", "iterations_search", 2, COUNTED, 1},
    {"limit_load", "iterations_stepping", NOT_COMPARED,
     "failed attempts near the limit load depend on round-off", 0},
    {"limit_load", "F_stepping", 0.03, "the last step before the limit", 1},
    {"limit_load", "*", 1e-8, ANSWER, 0},
    {"localisation", "reason", 0, REASON, 1},
    {"localisation", "iterations", 2, COUNTED, 1},
    {"localisation", "*", 1e-8, ANSWER, 0},
    {"localised", "*", 1e-8, ANSWER, 0},
    {"load_cures", "x", 1e-13, GRID, 0},
    {"load_cures", "plain_iterations", 2, COUNTED, 1},
    {"load_cures", "stepping_iterations", 5, "two iterations in a few steps",
     1},
    {"load_cures", "search_iterations", 2, COUNTED, 1},
    {"load_cures", "start_iterations", 2, COUNTED, 1},
    {"load_cures", "cubic_iterations", 2, COUNTED, 1},
    {"load_cures", "F_cubic", 1e-8, ANSWER, 1},
    {"load_cures", "*", 0, REASON, 1},
    {"step_cures", "x", 1e-13, GRID, 0},
    {"step_cures", "plain_iterations", 2, COUNTED, 1},
    {"step_cures", "stepping_iterations", 0.1,
     "two iterations in each of many steps", 0},
    {"step_cures", "search_iterations", 2, COUNTED, 1},
    {"step_cures", "start_iterations", 2, COUNTED, 1},
    {"step_cures", "cubic_iterations", 2, COUNTED, 1},
    {"step_cures", "F_cubic", 1e-8, ANSWER, 1},
    {"step_cures", "*", 0, REASON, 1},
    {"chart", "solves", 0, "a count", 0},
    {"chart", "*", 1e-7, "errors relative to F, of order 1 at the start", 1},
    {"chart_reasons", "linear", 1e-9, "bisection to round-off", 0},
    {"chart_reasons", "*", 0, REASON, 1},
};

static const struct lesson lesson = {
    "11_newton_failure", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Not one point of the map contradicts the boundary drawn over it (table "
    "`load_map`): the whole failure of the log law is one tangent that meets "
    "F = 0, because P is concave there.",
    "--law cubic --p -5000 converges in a few iterations, to F < 0: a bar "
    "turned inside out, and nobody complains. Then --law cubic --nu 0 "
    "--start 2.5 --p 0: at rest, three times as long."};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
