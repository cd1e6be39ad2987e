/* element.c - laws of figures/11_newton_failure/element.h. */
#include "figures/11_newton_failure/element.h"

#include "figures/study/study.h"
#include "unit.h"

#include "../oracle/11_newton_failure.h"

#include <math.h>
#include <stdlib.h>

static const struct newton_control plain = {1e-10, 1000, 0, 0};

static struct material of(enum law law, double nu)
{
    return material_make(law, 1000.0, nu);
}

static void newton_from_a_start_is_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_newton); k++) {
        const struct material m = of(oracle_newton[k].cubic ? CUBIC : LOG, 0.3);
        const struct element_report got =
            element_newton(&m, oracle_newton[k].p, oracle_newton[k].start,
                           &plain);
        if (oracle_newton[k].iterations < 0) {
            ck_assert_int_eq(got.status, INVERTED);
            continue;
        }
        ck_assert_int_eq(got.status, OK);
        close_to(got.F, oracle_newton[k].F, 1e-9);
        close_to(got.iterations, oracle_newton[k].iterations, 2);
    }
    for (int k = 0; k < COUNT(oracle_rest); k++) {
        const struct material m = of(CUBIC, oracle_rest[k].nu);
        close_to(element_newton(&m, 0.0, oracle_rest[k].start, &plain).F,
                 oracle_rest[k].F, 1e-9);
    }
}

static void what_is_no_number_ends_with_a_reason(void)
{
    const struct material cubic = of(CUBIC, 0.0), log_ = of(LOG, 0.3);
    const struct element_report flat = element_newton(&cubic, 0.0, 2.0, &plain);
    ck_assert_int_eq(flat.status, NONFINITE); /* P' = 0 */
    ck_assert(flat.iterations == 0 && flat.F == 2.0);
    ck_assert_int_eq(element_newton(&log_, NAN, 1.0, &plain).status, NONFINITE);
    ck_assert_int_eq(element_newton(&log_, 0.0, NAN, &plain).status, INVERTED);
    ck_assert_int_eq(element_newton(&log_, 0.0, 1e-200, &plain).status,
                     STALLED);
    ck_assert_int_eq(element_newton(&cubic, 613.7, 1.0, &plain).status,
                     MAX_ITERATIONS);
}

/* Each where plain Newton fails, P(F) = p in the end. */
static void cures_arrive(void)
{
    static const struct { double p, jump; } scene[] = {
        {-2385.0, 0.0}, {-37140.0, 0.0}, {0.0, 3.714}, {0.0, -6.137}};
    for (int k = 0; k < COUNT(scene); k++) {
        const double p = scene[k].p, jump = scene[k].jump;
        for (int c = 0; c < N_CURE; c++) {
            const struct element_report got =
                element_cured((enum cure)c, of(LOG, 0.3), p, jump, 10, plain);
            const int fails =
                c == CURE_PLAIN || (c == CURE_SEARCH && jump > 0.0);
            ck_assert_int_eq(got.status, fails ? INVERTED : OK);
            const struct material m = of(c == CURE_CUBIC ? CUBIC : LOG, 0.3);
            if (!fails)
                close_to(material1_pk1(&m, got.F), p, 1e-9 * (1.0 - p));
        }
    }
}

/* Pushed on without a load, the element is inverted by a step of more than
 * 1/|jump| of the way: 2^-10 will do for the one, and not for the other. */
static void steps_are_as_short_as_they_may_be(void)
{
    const struct newton_control long_way = {1e-10, 100000, 0, 0};
    const struct material m = of(LOG, 0.3);
    const struct element_report at_last =
        element_stepping(&m, 0.0, 700.0, &long_way);
    ck_assert_int_eq(at_last.status, OK);
    ck_assert_int_gt(at_last.iterations, 1024);
    const struct element_report too_far =
        element_stepping(&m, 0.0, 1500.0, &long_way);
    ck_assert_int_eq(too_far.status, STALLED);
    close_to(too_far.F, 1.0, 1e-15);
}

/* Pressed so hard only the shortest step succeeds at first; those after it are
 * longer and longer, so that it arrives in far less than 2^10 of them. */
static void steps_grow_again(void)
{
    const struct material m = of(LOG, 0.3);
    const struct newton_control control = {1e-10, 25, 0, 0};
    for (int k = 9; k <= 10; k++)
        ck_assert((element_newton(&m, ldexp(-1e6, -k), 1.0, &control).status ==
                   OK) == (k == 10));
    const struct element_report end = element_stepping(&m, -1e6, 0.0, &plain);
    ck_assert_int_eq(end.status, OK);
    ck_assert_int_lt(end.iterations, 200);
}

/* nu = 0, by hand: w / mu = e^2 - e^3 / 3 of e = F - 1, its slope and Newton's
 * step; and of what the slope promises for the whole step, the part that w
 * really falls, less *part. */
static double energy(double e) { return e * e - e * e * e / 3.0; }
static double slope(double e) { return 2.0 * e - e * e; }
static double newton_step(double e) { return -slope(e) / (2.0 - 2.0 * e); }
static double fall(double e, void *part)
{
    const double step = newton_step(e);
    return (energy(e + step) - energy(e)) / (slope(e) * step) -
           *(double *)part;
}

/* One step of the scalar and of a bar of one element, from e. */
static void takes_the_length(double e, double length)
{
    const struct newton_control once = {1e-10, 1, 1, 0};
    const double b[] = {0.0, 0.0};
    const struct bar bar = {1, 1.0, {1, 0}, b, of(CUBIC, 0.0)};
    struct newton_step history[2];
    double u[] = {0.0, e};
    const struct element_report got =
        element_newton(&bar.material, 0.0, 1.0 + e, &once);
    ck_assert_int_eq(got.status, MAX_ITERATIONS);
    close_to(got.F, 1.0 + e + length * newton_step(e), 1e-12);
    ck_assert_int_eq(bar_newton(&bar, &once, u, history).status,
                     MAX_ITERATIONS);
    close_to(u[1], got.F - 1.0, 1e-12);
    ck_assert(history[0].length == length);
}

/* The whole step is taken if and only if w falls by 1e-4 of the slope. */
static void line_search_is_armijos(void)
{
    double enough = 1.5e-4, too_little = 0.75e-4;
    takes_the_length(0.2385, 1.0);
    takes_the_length(study_root(fall, &enough, 0.1, 0.8), 1.0);
    takes_the_length(study_root(fall, &too_little, 0.1, 0.8), 0.5);
    takes_the_length(0.9, 0.25); /* w: 0.57; 39, 3.8, 0.13 */
}

/* P' < 0 beyond e = 1, far from P = 0 at e = 2 and close to it. */
static void line_search_does_not_go_uphill(void)
{
    const struct newton_control search = {1e-10, 60, 1, 0};
    const struct material m = of(CUBIC, 0.0);
    ck_assert_int_eq(element_newton(&m, 0.0, 2.5, &search).status, NOT_SPD);
    ck_assert_int_eq(element_newton(&m, 0.0, 2.99, &search).status, NOT_SPD);
}

/* As in bars.c: P is flat at e = 1, and steep for the log law at F = 0. */
static void neither_test_is_enough_alone(void)
{
    const struct newton_control coarse = {1e-8, 60, 0, 0};
    const struct material m = of(CUBIC, 0.0), log_ = of(LOG, 0.3);
    const double d = 1e-5;
    const struct element_report flat =
        element_newton(&m, m.mu * (1.0 - d * d), 2.0 - 2.0 * d, &coarse);
    ck_assert_int_eq(flat.status, OK);
    close_to(flat.F, 2.0 - d, 1e-9);
    const struct element_report steep =
        element_newton(&log_, 0.0, 1e-10, &coarse);
    ck_assert_int_eq(steep.status, OK);
    close_to(steep.F, 1.0, 1e-8);
}

/* A cure is what its comment says, to the last digit. */
static void cures_start_where_they_say(void)
{
    const struct newton_control search = {1e-10, 1000, 1, 0};
    for (int k = 0; k < 4; k++) {
        const double p = k < 2 ? 0.0 : 238.5, jump = k % 2 ? -0.613 : 0.4237;
        const struct material log_ = of(LOG, 0.3), cubic = of(CUBIC, 0.3);
        const double good = k < 2 ? 1.0 - jump / 7.0
                                  : exp(p / material_modulus(&log_));
        const struct element_report want[] = {
            [CURE_PLAIN] = element_newton(&log_, p, 1.0 - jump, &plain),
            [CURE_STEPPING] = element_stepping(&log_, p, jump, &plain),
            [CURE_SEARCH] = element_newton(&log_, p, 1.0 - jump, &search),
            [CURE_START] = element_newton(&log_, p, good, &plain),
            [CURE_CUBIC] = element_newton(&cubic, p, 1.0 - jump, &plain)};
        /* where plain Newton arrives one step of the load will do */
        ck_assert_int_eq(want[CURE_PLAIN].status, OK);
        ck_assert_int_eq(want[CURE_STEPPING].iterations,
                         want[CURE_PLAIN].iterations);
        for (int c = 0; c < N_CURE; c++) {
            const struct element_report got =
                element_cured((enum cure)c, log_, p, jump, 7, plain);
            ck_assert_int_eq(got.status, want[c].status);
            ck_assert_int_eq(got.iterations, want[c].iterations);
            ck_assert_double_eq(got.F, want[c].F);
        }
    }
}

/* With as many iterations as it takes it arrives, with one less it does not. */
static void stepping_counts_all_iterations(void)
{
    const struct material m = of(LOG, 0.3);
    const int all = element_stepping(&m, -37140.0, 0.0, &plain).iterations;
    struct newton_control control = plain;
    ck_assert_int_gt(all, 25); /* more than one attempt may take */
    control.max_iterations = all;
    ck_assert_int_eq(element_stepping(&m, -37140.0, 0.0, &control).status, OK);
    for (int less = 1; less < all; less++) {
        control.max_iterations = all - less;
        const struct element_report cut =
            element_stepping(&m, -37140.0, 0.0, &control);
        ck_assert_int_eq(cut.status, MAX_ITERATIONS);
        ck_assert_int_eq(cut.iterations, all - less);
    }
}

UNIT_MAIN("element",
    LAW(newton_from_a_start_is_the_oracles),
    LAW(what_is_no_number_ends_with_a_reason),
    LAW(cures_arrive),
    LAW(steps_are_as_short_as_they_may_be),
    LAW(steps_grow_again),
    LAW(line_search_is_armijos),
    LAW(line_search_does_not_go_uphill),
    LAW(neither_test_is_enough_alone),
    LAW(cures_start_where_they_say),
    LAW(stepping_counts_all_iterations))
