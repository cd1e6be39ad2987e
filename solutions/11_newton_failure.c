/*
 * 11_newton_failure.c - where Newton's method fails, predicted and mapped, and
 * what each cure costs.
 *
 * Notes: Lecture 2, sections 2.5.5 and 2.5.6.
 *
 * Problem.  In a bar with one free end every element carries a known stress p,
 * so Newton on the bar [alg:newton] is one scalar Newton per element,
 *
 *     F := F + (p - P(F)) / P'(F)   until P(F) = p,
 *
 * and everything that can happen to it can be drawn: load p against start F0,
 * or boundary step dg against the number of elements, where the element at the
 * boundary starts at F0 = 1 - dg / dX.  The log law fails when an iterate
 * leaves F > 0; the cubic law does not mind, and gives something else up.
 *
 *         P |        .-'        the tangent at F0 meets the level p at F1:
 *           |     .-'o F0       F1 <= 0 when p <= P(F0) - F0 P'(F0)
 *           |   .' .'                                  [eq:first-step]
 *     ------+--/-.'----- F
 *           | /.'
 *       p - +.' - - -
 *
 * Run       make lesson-11, or with options: -h lists them
 * Expect    log law from rest, E = 1000, nu = 0.3: p = -1346 converges in 21
 *           iterations, -1347 is INVERTED, and 2 mu + lambda = 1346.15; a
 *           boundary step converges for -2.2113 dX < dg < dX
 * Plot: boundary start load
 */
#include "bar.h"
#include "options.h"
#include "table.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/*
 * Where the iteration stands at F, and its next step (p - P(F)) / P'(F).
 *
 * increment  in   |step| that led to F, INFINITY at the start
 * step       out  the next step; 0 where there is none
 *
 * INVERTED        the law is not defined at F
 * NONFINITE       the residual P(F) - p or the step is not a finite number
 * OK              converged: |residual| <= tolerance (2 mu + lambda), and
 *                 |increment| <= tolerance as well or the residual is 0
 * STALLED         the increment cannot change F any more (<= DBL_EPSILON), but
 *                 the residual is not small
 * MAX_ITERATIONS  none of these: go on with the step
 */
static enum status newton_step(const struct material *material, double p,
                               double F, double increment, double tolerance,
                               double *step)
{
    *step = 0.0;
    /* SLOT 11a(material, p, F, increment, tolerance, step): find the reason
     * and the step; write every comparison so that a NaN fails it. */
    if (!material_defined(material, F)) return INVERTED;
    const double residual = material1_pk1(material, F) - p;
    const double next = -residual / material1_dpk1(material, F);
    const double small = tolerance * material_modulus(material);
    if (residual == 0.0) return OK;
    if (!isfinite(residual) || !isfinite(next)) return NONFINITE;
    if (fabs(residual) <= small && increment <= tolerance) return OK;
    if (increment <= DBL_EPSILON) return STALLED;
    *step = next;
    return MAX_ITERATIONS;
    /* END 11a */
}

/* What the failures should be, from the material alone [eq:first-step]. */
struct limits {
    double load;     /* p at or below which the first step from F inverts */
    double step;     /* largest drop of the load from the equilibrium at F */
    double start;    /* F0 at or above which it inverts for p = 0 */
    double push;     /* dg / dX at or above which the start is inverted */
    double pull;     /* dg / dX at or below which the first step inverts */
    double collapse; /* p at which the cubic law has F = 0 */
};

/*
 * The limits of the log law in terms of mu and lambda; of the cubic law only
 * `collapse` is asked for.  F > 0 is where a load step starts; at nu = 0 and
 * near it start and pull may be infinite.
 */
static struct limits predict(double mu, double lambda, double F)
{
    struct limits limits = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    /* SLOT 11b(mu, lambda, F, &limits): the six closed forms [eq:first-step].
     * limits.load at F = 1 is -(2 mu + lambda). */
    limits.load = (2.0 * lambda * log(F) - 2.0 * mu - lambda) / F;
    limits.step = mu * F + (mu + lambda - lambda * log(F)) / F; /* F P' */
    limits.start = exp(0.5 + mu / lambda);
    limits.push = 1.0;
    limits.pull = 1.0 - limits.start;
    limits.collapse = -(3.0 * mu + 5.5 * lambda);
    /* END 11b */
    return limits;
}

/*
 * The length of a step by backtracking [alg:line-search]: the first of 1, 1/2,
 * 1/4, ... > 1e-12 at which the law is defined and the energy
 * w(F) = psi(F) - p (F - 1) has decreased enough (Armijo),
 *
 *     w(F + length step) <= w(F) + 1e-4 length w'(F) step + noise,
 *
 * noise = 16 eps |w(F)|: at the minimum w has no digits left to compare.
 * NOT_SPD: the step does not lead downhill (P' < 0).  STALLED: no length does.
 */
static enum status line_search(const struct material *material, double p,
                               double F, double step, double *length)
{
    const double w = material1_psi(material, F) - p * (F - 1.0);
    const double slope = (material1_pk1(material, F) - p) * step;
    *length = 1.0;
    /* SLOT 11c(material, p, F, step, length, w, slope): find *length and
     * return the status.  psi may only be asked for where it is defined. */
    const double noise = 16.0 * DBL_EPSILON * fabs(w);
    if (!(slope < 0.0)) return NOT_SPD;
    for (; *length > 1e-12; *length *= 0.5) {
        const double trial = F + *length * step;
        if (!material_defined(material, trial)) continue;
        const double w_trial =
            material1_psi(material, trial) - p * (trial - 1.0);
        if (w_trial <= w + 1e-4 * *length * slope + noise) return OK;
    }
    return STALLED;
    /* END 11c */
}

struct outcome {
    enum status status;
    int iterations; /* linear systems solved */
    double F;       /* the last state */
};

/* Newton from F until P(F) = p [alg:newton], as bar_newton() on one element. */
static struct outcome solve(const struct material *material, double p,
                            double F, const struct newton_control *control)
{
    struct outcome state = {MAX_ITERATIONS, 0, F};
    double increment = INFINITY;
    for (;;) {
        double step, length = 1.0;
        state.status = newton_step(material, p, state.F, increment,
                                   control->tolerance, &step);
        if (state.status != MAX_ITERATIONS) return state;
        if (state.iterations >= control->max_iterations) return state;
        state.iterations++;
        if (control->line_search) {
            state.status = line_search(material, p, state.F, step, &length);
            if (state.status != OK) return state;
        }
        state.F += length * step;
        increment = fabs(step);
    }
}

/*
 * Load stepping with halving [alg:load-stepping].  At the fraction s of the way
 * the load is s p and the boundary has moved by s jump (in units of dX); s = 0
 * is the state of rest, F = 1.  A step from s to s + ds starts at the last
 * equilibrium, less ds jump.  It fails: it is taken back, ds := ds / 2.  It
 * converges: s := s + ds, ds := 2 ds, but never beyond s = 1.  The first ds is
 * 1; one attempt may take `patience` iterations, all of them together
 * control->max_iterations (then: MAX_ITERATIONS).  STALLED: ds < 2^-10.
 * F is the last equilibrium; iterations counts the failed attempts as well.
 */
static struct outcome load_stepping(const struct material *material, double p,
                                    double jump,
                                    const struct newton_control *control)
{
    const int patience = 25;
    struct newton_control attempt = *control;
    struct outcome state = {OK, 0, 1.0};
    /* SLOT 11d(material, p, jump, patience, &attempt, &state): walk from s = 0
     * to s = 1 by calls of solve(), and keep the books in state. */
    const int budget = attempt.max_iterations;
    double s = 0.0, ds = 1.0;
    while (s < 1.0 && state.status == OK) {
        const int left = budget - state.iterations;
        attempt.max_iterations = left < patience ? left : patience;
        ds = fmin(ds, 1.0 - s);
        const struct outcome trial = solve(
            material, (s + ds) * p, state.F - ds * jump, &attempt);
        state.iterations += trial.iterations;
        if (trial.status == OK) {
            state.F = trial.F;
            s += ds;
            ds *= 2.0;
        } else {
            ds *= 0.5;
            if (ds < ldexp(1.0, -10)) state.status = STALLED;
            if (state.iterations >= budget) state.status = MAX_ITERATIONS;
        }
    }
    /* END 11d */
    return state;
}

enum cure { PLAIN, STEPPING, SEARCH, START, CUBIC_R, N_CURE };
#define CURES "plain stepping search start cubic"

/*
 * The log law from rest to load p with the boundary moved by jump dX, one cure
 * at a time.  START begins at exp(p / (2 mu + lambda)), or for p = 0 at the
 * linear lift: the jump shared by all n elements, F0 = 1 - jump / n.
 */
static struct outcome cured(enum cure cure, struct material material, double p,
                            double jump, int n, struct newton_control control)
{
    double F = 1.0 - jump;
    if (cure == STEPPING) return load_stepping(&material, p, jump, &control);
    if (cure == SEARCH) control.line_search = 1;
    if (cure == CUBIC_R) material.law = CUBIC;
    if (cure == START)
        F = p == 0.0 ? 1.0 - jump / n : exp(p / material_modulus(&material));
    return solve(&material, p, F, &control);
}

/* ---- maps ---- */

#define REASONS "reasons: 0 converged, 1 not SPD, 3 not finite, 4 inverted, " \
                "5 stalled, 6 cap"

static double none_is_zero(double x) { return isfinite(x) ? x : 0.0; }

static void print_limits(const struct material *m)
{
    static const double at[] = {1.0, 0.75, 0.25, 0.05};
    table_begin_note("limits", "F load step start push pull collapse",
                     "0 where there is no limit");
    for (int k = 0; k < COUNT(at); k++) {
        const struct limits limits = predict(m->mu, m->lambda, at[k]);
        table_row(at[k], limits.load, limits.step, none_is_zero(limits.start),
                  limits.push, none_is_zero(limits.pull), limits.collapse);
    }
    table_end();

    table_begin("boundary", "start load");
    for (int k = 1; k <= 150; k++) {
        const double F = k / 30.0;
        table_row(F, predict(m->mu, m->lambda, F).load);
    }
    table_end();
}

/* From rest, plain Newton: either side of the limit, and far beyond it. */
static void print_loads(const struct material law[2], double E,
                        const struct newton_control *control)
{
    static const double per_E[] = {1.0,    -0.1,  -1.346, -1.347, -4.0,
                                   -4.326, -4.327, -10.0, -100.0};
    table_begin_note("loads", "p reason_log iterations_log F_log reason_cubic "
                     "iterations_cubic F_cubic F_linear",
                     REASONS "; F is 0 where not converged");
    for (int k = 0; k < COUNT(per_E); k++) {
        const double p = per_E[k] * E;
        const struct outcome a = solve(&law[0], p, 1.0, control);
        const struct outcome b = solve(&law[1], p, 1.0, control);
        table_row(p, a.status, a.iterations, a.status == OK ? a.F : 0.0,
                  b.status, b.iterations, b.status == OK ? b.F : 0.0,
                  1.0 + p / material_modulus(&law[0]));
    }
    table_end();
}

/* Load against start; grid points in each direction. */
static void print_load_map(const struct material law[2], int grid,
                           const struct newton_control *control)
{
    const double modulus = material_modulus(&law[0]);
    table_begin_note("load_map", "load start reason_log iterations_log "
                     "reason_cubic iterations_cubic",
                     REASONS "; load in units of 2 mu + lambda");
    for (int i = 0; i < grid; i++)
        for (int j = 0; j < grid; j++) {
            const double load = -3.983 + 5.977 * i / (grid - 1);
            const double start = -0.977 + 5.9431 * j / (grid - 1);
            const double p = load * modulus;
            const struct outcome a = solve(&law[0], p, start, control);
            const struct outcome b = solve(&law[1], p, start, control);
            table_row(load, start, a.status, a.iterations, b.status,
                      b.iterations);
        }
    table_end();
}

/* Boundary step |dg| against the number of elements of a bar of length 1: push
 * (dg > 0) and pull, from rest and with the linear lift. */
static void print_step_map(const struct material law[2], int grid,
                           const struct newton_control *control)
{
    table_begin_note("step_map", "dg n push push_iterations pull "
                     "pull_iterations push_lift pull_lift cubic_push "
                     "cubic_pull", REASONS);
    for (int i = 0; i < grid; i++)
        for (int k = 1; k <= 14; k++) {
            const int n = (int)lround(pow(2.0, 0.5 * k));
            const double dg = pow(10.0, -2.486 + 3.477 * i / (grid - 1));
            struct outcome out[2][3];
            for (int s = 0; s < 2; s++) {
                const double jump = (s ? -1.0 : 1.0) * dg * n;
                out[s][0] = cured(PLAIN, law[0], 0.0, jump, n, *control);
                out[s][1] = cured(START, law[0], 0.0, jump, n, *control);
                out[s][2] = cured(CUBIC_R, law[0], 0.0, jump, n, *control);
            }
            table_row(dg, n, out[0][0].status, out[0][0].iterations,
                      out[1][0].status, out[1][0].iterations,
                      out[0][1].status, out[1][1].status, out[0][2].status,
                      out[1][2].status);
        }
    table_end();
}

/* The notes' example, u(0, t) = sin t until t >= 6.3: only the first element
 * starts away from F = 1.  fails is the time of the first failure, or 0. */
static void print_example(const struct material law[2],
                          const struct newton_control *control)
{
    static const struct { int n; double dt; } scene[] = {
        {10, 0.001}, {10, 0.01}, {10, 0.1}, {10, 0.2}, {10, 0.5},
        {100, 0.001}, {100, 0.01}, {100, 0.05}, {100, 0.1}, {100, 0.5}};
    table_begin("example", "n dt largest_step log_iterations log_fails "
                           "cubic_iterations cubic_fails");
    for (int k = 0; k < COUNT(scene); k++) {
        const double dt = scene[k].dt;
        double largest = 0.0, fails[2] = {0.0, 0.0};
        int most[2] = {0, 0};
        for (int i = 1; (i - 1) * dt < 6.3 - 1e-9; i++) {
            const double jump =
                (sin(i * dt) - sin((i - 1) * dt)) * scene[k].n;
            largest = fmax(largest, fabs(jump));
            for (int l = 0; l < 2; l++) {
                if (fails[l] > 0.0) continue;
                const struct outcome out =
                    solve(&law[l], 0.0, 1.0 - jump, control);
                if (out.iterations > most[l]) most[l] = out.iterations;
                if (out.status != OK) fails[l] = i * dt;
            }
        }
        table_row(scene[k].n, dt, largest, most[0], fails[0], most[1],
                  fails[1]);
    }
    table_end();
}

/* Squashed starts of the log law at p = 0: the first increment is below any
 * tolerance while the residual is enormous. */
static void print_false(const struct material *m,
                        const struct newton_control *control)
{
    table_begin("false", "start step_over_start increment residual reason "
                         "iterations F");
    for (int k = 1; k <= 3; k++) {
        const double F = pow(10.0, -4.0 * k);
        double step;
        newton_step(m, 0.0, F, INFINITY, control->tolerance, &step);
        const struct outcome out = solve(m, 0.0, F, control);
        table_row(F, step / F, 0.1 * step, material1_pk1(m, F), out.status,
                  out.iterations, out.F);
    }
    table_end();
}

/* ---- what the cubic law gives up ---- */

typedef double law_function(const struct material *material, double F);

/* The first zero of f in (a, b), by steps of 1/128 and bisection; 0 if none. */
static double first_zero(law_function *f, const struct material *m, double a,
                         double b)
{
    for (; a < b; a += 1.0 / 128) {
        double low = a, high = a + 1.0 / 128;
        if (f(m, low) > 0.0 && f(m, high) <= 0.0) {
            for (int k = 0; k < 60; k++) {
                const double middle = 0.5 * (low + high);
                *(f(m, middle) > 0.0 ? &low : &high) = middle;
            }
            return low;
        }
    }
    return 0.0;
}

/* The smallest value of f on (a, b): sampled, then refined around the best. */
static double smallest(law_function *f, const struct material *m, double a,
                       double b)
{
    while (b - a > 1e-6) {
        const double d = (b - a) / 200.0;
        double best = a;
        for (int k = 1; k <= 200; k++)
            if (f(m, a + k * d) < f(m, best)) best = a + k * d;
        a = fmax(a, best - d);
        b = fmin(b, best + d);
    }
    return f(m, 0.5 * (a + b));
}

/* The nu in (a, b) at which the smallest value of f on (F0, F1) changes sign */
static double critical_nu(enum law law, law_function *f, double F0, double F1,
                          double a, double b)
{
    const struct material first = material_make(law, 1.0, a);
    const int sign = smallest(f, &first, F0, F1) > 0.0;
    for (int k = 0; k < 40; k++) {
        const double nu = 0.5 * (a + b);
        const struct material m = material_make(law, 1.0, nu);
        *((smallest(f, &m, F0, F1) > 0.0) == sign ? &a : &b) = nu;
    }
    return 0.5 * (a + b);
}

/* Limit load and second rest state over nu, and where nearby starts end. */
static void print_giveup(double E, const struct newton_control *control)
{
    static const double nu[] = {0.0,  0.02,   0.03, 0.05,
                                0.07, 0.0713, 0.1,  0.3};
    enum { N_NU = COUNT(nu) };
    struct material m[N_NU];

    table_begin_note("giveup", "nu F_limit P_limit F_rest", "0: none");
    for (int k = 0; k < N_NU; k++) {
        m[k] = material_make(CUBIC, E, nu[k]);
        const double F = first_zero(material1_dpk1, &m[k], 1.0, 8.0);
        table_row(nu[k], F, F > 0.0 ? material1_pk1(&m[k], F) : 0.0,
                  first_zero(material1_pk1, &m[k], 1.0 + 1.0 / 64, 8.0));
    }
    table_end();

    table_begin("critical", "cubic_tangent cubic_rest log_tangent");
    table_row(critical_nu(CUBIC, material1_dpk1, 1.5, 6.0, 0.04, 0.2),
              critical_nu(CUBIC, material1_pk1, 2.0, 6.0, 0.01, 0.06),
              critical_nu(LOG, material1_dpk1, 1.5, 9.0, 0.45, 0.495));
    table_end();

    table_begin_note("stress", "F nu0 nu2 nu5 nu7 nu30 log30",
                     "stress / E of the cubic law, and of the log law");
    const struct material log_ = material_make(LOG, E, 0.3);
    for (int k = -20; k <= 220; k++) {
        const double F = k / 40.0;
        table_row(F, material1_pk1(&m[0], F) / E, material1_pk1(&m[1], F) / E,
                  material1_pk1(&m[3], F) / E, material1_pk1(&m[4], F) / E,
                  material1_pk1(&m[7], F) / E,
                  material1_pk1(&log_, fmax(F, 0.05)) / E);
    }
    table_end();

    table_begin_note("rest_map", "nu start reason iterations F",
                     REASONS "; F is 0 where not converged");
    for (int i = 0; i <= 20; i++)
        for (int j = -20; j <= 120; j += 2) {
            const struct material at = material_make(CUBIC, E, 0.005 * i);
            const struct outcome out = solve(&at, 0.0, j / 20.0, control);
            table_row(0.005 * i, j / 20.0, out.status, out.iterations,
                      out.status == OK ? out.F : 0.0);
        }
    table_end();
}

/* The failure of load stepping: no equilibrium, or none nearby, beyond the
 * limit load of the cubic law.  It stops there (nu = 0) or jumps (0.05). */
static void print_limit_load(double E, const struct newton_control *control)
{
    struct newton_control searched = *control;
    searched.line_search = 1;
    table_begin_note("limit_load", "nu p reason_plain iterations_plain F_plain "
                     "reason_stepping iterations_stepping F_stepping "
                     "reason_search iterations_search",
                     REASONS "; F_stepping is its last state, F_plain is 0 "
                     "where plain Newton fails");
    for (int i = 0; i < 2; i++)
        for (int k = 0; k <= 3; k++) {
            const struct material m = material_make(CUBIC, E, 0.05 * i);
            const double p = (0.4637 + 0.0478 * k) * E;
            const struct outcome a = solve(&m, p, 1.0, control);
            const struct outcome b = load_stepping(&m, p, 0.0, control);
            const struct outcome c = solve(&m, p, 1.0, &searched);
            table_row(0.05 * i, p, a.status, a.iterations,
                      a.status == OK ? a.F : 0.0, b.status, b.iterations, b.F,
                      c.status, c.iterations);
        }
    table_end();
}

/* Ten elements, both ends prescribed, the right one moved at once: the cubic
 * law at nu = 0.05 answers with a bar that is not uniform. */
static void print_localisation(double E, const struct newton_control *control)
{
    enum { n = 10 };
    static const double nu[] = {0.3, 0.05, 0.05}, end[] = {1.0, 1.0, 2.5};
    const double b[n + 1] = {0.0};
    double F[3][n];

    table_begin_note("localisation", "nu end reason iterations F_min F_max",
                     REASONS);
    for (int k = 0; k < 3; k++) {
        const struct bar bar = {
            n, 1.0 / n, {1, 1}, b, material_make(CUBIC, E, nu[k])};
        double u[n + 1] = {0.0}, low = INFINITY, high = -INFINITY;
        u[n] = end[k];
        const struct newton_report report = bar_newton(&bar, control, u, NULL);
        for (int e = 1; e <= n; e++) {
            F[k][e - 1] = 1.0 + (u[e] - u[e - 1]) / bar.h;
            low = fmin(low, F[k][e - 1]);
            high = fmax(high, F[k][e - 1]);
        }
        table_row(nu[k], end[k], report.status, report.iterations, low, high);
    }
    table_end();
    table_begin("localised", "X nu30 nu5");
    for (int e = 0; e < n; e++) table_row((e + 0.5) / n, F[0][e], F[1][e]);
    table_end();
}

/* ---- cures ---- */

static void print_cures(const struct material *m, int n, int grid,
                        const struct newton_control *control)
{
    const double modulus = material_modulus(m);
    for (int moved = 0; moved < 2; moved++) {
        table_begin_note(
            moved ? "step_cures" : "load_cures",
            "x plain plain_iterations stepping stepping_iterations search "
            "search_iterations start start_iterations cubic cubic_iterations "
            "F_cubic", REASONS "; %s", moved ? "x = dg / dX" :
            "x = -p / (2 mu + lambda)");
        for (int i = 0; i < grid; i++) {
            const double x = pow(10.0, -1.503 + 3.013 * i / (grid - 1));
            struct outcome out[N_CURE];
            for (int c = 0; c < N_CURE; c++)
                out[c] = cured((enum cure)c, *m, moved ? 0.0 : -x * modulus,
                               moved ? x : 0.0, n, *control);
            table_row(x, out[0].status, out[0].iterations, out[1].status,
                      out[1].iterations, out[2].status, out[2].iterations,
                      out[3].status, out[3].iterations, out[4].status,
                      out[4].iterations, out[4].status == OK ? out[4].F : 0.0);
        }
        table_end();
    }
}

/* P(F) = p of the log law for p < 0, by bisection: P' > 0 for F < 1. */
static double log_answer(const struct material *m, double p)
{
    double low = 1e-6, high = 1.0;
    for (int k = 0; k < 100; k++) {
        const double middle = 0.5 * (low + high);
        *(material1_pk1(m, middle) < p ? &low : &high) = middle;
    }
    return high;
}

/* Speed against accuracy: the error of F after k linear solves, by giving each
 * cure k solves and no more.  Error 1 or more: F is inverted. */
static void print_chart(const struct material *m, double p,
                        struct newton_control control)
{
    const double exact = log_answer(m, p);
    enum status final[N_CURE];
    table_begin_note("chart", "solves " CURES, "relative error of F");
    for (int k = 0; k <= 24; k++) {
        double error[N_CURE];
        control.max_iterations = k;
        for (int c = 0; c < N_CURE; c++) {
            const struct outcome out =
                cured((enum cure)c, *m, p, 0.0, 1, control);
            error[c] = fabs(out.F - exact) / exact;
            final[c] = out.status;
        }
        table_row(k, error[0], error[1], error[2], error[3], error[4]);
    }
    table_end();
    table_begin_note("chart_reasons", "linear " CURES,
                     REASONS "; linear: the error of 1 + p / (2 mu + lambda)");
    table_row(fabs(1.0 + p / material_modulus(m) - exact) / exact, final[0],
              final[1], final[2], final[3], final[4]);
    table_end();
}

/* One run with its history; dies with the reason if it does not converge. */
static void print_scene(const struct material *m, double p, double start,
                        struct newton_control control)
{
    const struct outcome all = solve(m, p, start, &control);
    if (all.status != OK) { /* the residual of the last state that has one */
        control.max_iterations = all.iterations - (all.status == INVERTED);
        const double F = solve(m, p, start, &control).F;
        die("p = %g from F = %g: %s after %d iterations, F = %g; last residual "
            "%g at F = %g", p, start, status_name(all.status), all.iterations,
            all.F, material1_pk1(m, F) - p, F);
    }
    table_begin_note("history", "k F residual", "%d iterations",
                     all.iterations);
    for (int k = 0; k <= all.iterations; k++) {
        control.max_iterations = k;
        const double F = solve(m, p, start, &control).F;
        table_row(k, F, material1_pk1(m, F) - p);
    }
    table_end();
}

int main(int argc, char *argv[])
{
    int law = 1, search = 0, n = 10, grid = 60, cap = 1000;
    double E = 1000.0, nu = 0.3, p = -1346.0, start = 1.0, hard = -1.5;
    struct newton_control control = {1e-10, 0, 0, 0};
    const struct option options[] = {
        {"law", .choice = &law, .choices = "linear log cubic",
         .help = "material of the single run"},
        {"E", .real = &E, .min = 1e-6, .max = 1e9, .unit = "N/m^2",
         .help = "Young's modulus"},
        {"nu", .real = &nu, .min = 0.0, .max = 0.4999,
         .help = "Poisson's ratio",
         .why = "at 1/2 the material is incompressible and lambda infinite"},
        {"p", .real = &p, .min = -1e12, .max = 1e12, .unit = "N/m^2",
         .help = "stress of the single run"},
        {"start", .real = &start, .min = -20.0, .max = 20.0,
         .help = "its start F0, > 0 for the log law"},
        {"search", .choice = &search, .choices = "off on",
         .help = "its line search"},
        {"hard", .real = &hard, .min = -100.0, .max = -0.01,
         .help = "load of the chart / (2 mu + lambda)"},
        {"n", .integer = &n, .min = 1, .max = 1000,
         .help = "elements that share the linear lift"},
        {"grid", .integer = &grid, .min = 2, .max = 150,
         .help = "points of the maps in each direction"},
        {"cap", .integer = &cap, .min = 1, .max = 1000,
         .help = "iterations before the cap"},
        {"tolerance", .real = &control.tolerance, .min = 1e-13, .max = 1e-3,
         .help = "of residual / (2 mu + lambda) and of increment"},
    };
    options_parse("11_newton_failure", options, COUNT(options), argc, argv);
    control.max_iterations = cap;

    const struct material one = material_make((enum law)law, E, nu);
    const struct material both[] = {material_make(LOG, E, nu),
                                    material_make(CUBIC, E, nu)};
    if (!material_defined(&one, start)) {
        fprintf(stderr, "11_newton_failure: --start %g is inverted: the log "
                        "law is defined for F > 0 only\n", start);
        return 2;
    }
    control.line_search = search;
    print_scene(&one, p, start, control);
    control.line_search = 0;
    print_limits(&both[0]);
    print_loads(both, E, &control);
    print_load_map(both, grid, &control);
    print_step_map(both, grid, &control);
    print_example(both, &control);
    print_false(&both[0], &control);
    print_giveup(E, &control);
    print_limit_load(E, &control);
    print_localisation(E, &control);
    print_cures(&both[0], n, grid, &control);
    print_chart(&both[0], hard * material_modulus(&both[0]), control);
    return table_finish();
}
