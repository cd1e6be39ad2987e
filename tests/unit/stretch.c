/* stretch.c - laws of common/stretch.h. */
#include "stretch.h"

#include "unit.h"

#include "../oracle/11_newton_failure.h"

#include <math.h>
#include <stdlib.h>

static const struct newton_control plain = {1e-10, 1000, 0, 0};

static struct material of(enum law law, double nu)
{
    return material_make(law, 1000.0, nu);
}

/* The whole bar, one element with a free end, and the scalar: the same. */
static void stretch_is_a_bar_of_one_element(void)
{
    static const double p[] = {-1347.0, -1000.0, -37140.0, 238.5, 1000.0};
    for (int l = LOG; l <= CUBIC; l++)
        for (int search = 0; search < 2; search++)
            for (int k = 0; k < COUNT(p); k++) {
                const struct material m = of((enum law)l, 0.3);
                const struct newton_control control = {1e-10, 1000, search, 0};
                const double b[] = {0.0, p[k]};
                const struct bar bar = {1, 1.0, {1, 0}, b, m};
                double u[] = {0.0, 0.0};
                const struct newton_report want =
                    bar_newton(&bar, &control, u, NULL);
                const struct stretch_report got =
                    stretch_newton(&m, p[k], 1.0, &control);
                ck_assert_int_eq(got.status, want.status);
                ck_assert_int_le(abs(got.iterations - want.iterations), 2);
                if (got.status == OK) close_to(got.F, 1.0 + u[1], 1e-9);
            }
}

static void newton_from_a_start_is_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_newton); k++) {
        const struct material m = of(oracle_newton[k].cubic ? CUBIC : LOG, 0.3);
        const struct stretch_report got =
            stretch_newton(&m, oracle_newton[k].p, oracle_newton[k].start,
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
        close_to(stretch_newton(&m, 0.0, oracle_rest[k].start, &plain).F,
                 oracle_rest[k].F, 1e-9);
    }
}

static void what_is_no_number_ends_with_a_reason(void)
{
    const struct material cubic = of(CUBIC, 0.0), log_ = of(LOG, 0.3);
    ck_assert_int_eq(stretch_newton(&cubic, 0.0, 2.0, &plain).status,
                     NONFINITE); /* P' = 0 */
    ck_assert_int_eq(stretch_newton(&log_, NAN, 1.0, &plain).status, NONFINITE);
    ck_assert_int_eq(stretch_newton(&log_, 0.0, NAN, &plain).status, INVERTED);
    ck_assert_int_eq(stretch_newton(&log_, 0.0, 1e-200, &plain).status,
                     STALLED);
    ck_assert_int_eq(stretch_newton(&cubic, 613.7, 1.0, &plain).status,
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
            const struct stretch_report got =
                stretch_cured((enum cure)c, of(LOG, 0.3), p, jump, 10, plain);
            const int fails =
                c == CURE_PLAIN || (c == CURE_SEARCH && jump > 0.0);
            ck_assert_int_eq(got.status, fails ? INVERTED : OK);
            const struct material m = of(c == CURE_CUBIC ? CUBIC : LOG, 0.3);
            if (!fails)
                close_to(material1_pk1(&m, got.F), p, 1e-9 * (1.0 - p));
        }
    }
}

/* At nu = 0 no stress of the cubic law exceeds mu = 500, at F = 2. */
static void stepping_stops_at_the_limit_load(void)
{
    const struct material m = of(CUBIC, 0.0);
    const struct stretch_report got = stretch_stepping(&m, 613.7, 0.0, &plain);
    ck_assert_int_eq(got.status, STALLED);
    close_to(material1_pk1(&m, got.F), 500.0, 1.0);
    ck_assert(got.F < 2.0);
    const struct newton_control short_of = {1e-10, 7, 0, 0};
    const struct stretch_report cut =
        stretch_stepping(&m, 613.7, 0.0, &short_of);
    ck_assert_int_eq(cut.status, MAX_ITERATIONS);
    ck_assert_int_le(cut.iterations, 7);
}

/* The boundary of a bar of 7 elements, free at the other end, moves by dg. */
static void boundary_step_is_one_stretch(void)
{
    enum { n = 7 };
    const double b[n + 1] = {0.0};
    for (int k = -6; k < 4; k++) {
        const double jump = 0.4237 * k + 0.05;
        const struct bar bar = {n, 1.0 / n, {1, 0}, b, of(LOG, 0.3)};
        double u[n + 1] = {jump / n};
        ck_assert_int_eq(
            stretch_newton(&bar.material, 0.0, 1.0 - jump, &plain).status,
            bar_newton(&bar, &plain, u, NULL).status);
    }
}

/* u(0, t) = sin t: every step starts the first element at F = 1 - dg / dX. */
static void moving_end_is_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_example); k++) {
        const double dt = oracle_example[k].dt, n = oracle_example[k].n;
        double fails = 0.0, largest = 0.0;
        int most[3] = {0, 0, 0};
        for (int i = 1; (i - 1) * dt < 6.3 - 1e-9; i++)
            for (int law = LOG; law <= CUBIC; law++) {
                const struct material m = of((enum law)law, 0.3);
                const double dg = (sin(i * dt) - sin((i - 1) * dt)) * n;
                largest = fmax(largest, fabs(dg));
                if (law == LOG && fails > 0.0) continue;
                const struct stretch_report end =
                    stretch_newton(&m, 0.0, 1.0 - dg, &plain);
                if (end.status != OK) fails = i * dt;
                if (end.iterations > most[law]) most[law] = end.iterations;
            }
        close_to(largest, oracle_example[k].largest_step, 1e-9);
        close_to(fails, oracle_example[k].fails, 1e-9);
        close_to(most[CUBIC], oracle_example[k].cubic, 2);
        if (oracle_example[k].log >= 0)
            close_to(most[LOG], oracle_example[k].log, 2);
    }
}

/* Limit loads and second rest states of the cubic law: P' = 0, P = 0. */
static void limit_loads_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_giveup); k++) {
        const struct material m = of(CUBIC, oracle_giveup[k].nu);
        const double F = oracle_giveup[k].F_limit;
        const double rest = oracle_giveup[k].F_rest;
        if (F > 0.0) close_to(material1_dpk1(&m, F), 0.0, 1e-9);
        if (F > 0.0)
            close_to(material1_pk1(&m, F), oracle_giveup[k].P_limit, 1e-9);
        if (rest > 0.0) close_to(material1_pk1(&m, rest), 0.0, 1e-9);
    }
}

/* Ten elements, both ends held, the right one moved at once. */
static void bar_localises_as_the_oracles(void)
{
    enum { n = 10 };
    const double b[n + 1] = {0.0};
    for (int k = 0; k < COUNT(oracle_localisation); k++) {
        const struct bar bar = {n, 1.0 / n, {1, 1}, b,
                                of(CUBIC, oracle_localisation[k].nu)};
        double u[n + 1] = {0.0}, low = INFINITY, high = -INFINITY;
        u[n] = oracle_localisation[k].end;
        close_to(bar_newton(&bar, &plain, u, NULL).iterations,
                 oracle_localisation[k].iterations, 2);
        for (int e = 1; e <= n; e++) {
            low = fmin(low, 1.0 + (u[e] - u[e - 1]) * n);
            high = fmax(high, 1.0 + (u[e] - u[e - 1]) * n);
        }
        close_to(low, oracle_localisation[k].F_min, 1e-9);
        close_to(high, oracle_localisation[k].F_max, 1e-9);
    }
}

static const struct unit_law laws[] = {
    {"stretch_is_a_bar_of_one_element", stretch_is_a_bar_of_one_element},
    {"newton_from_a_start_is_the_oracles", newton_from_a_start_is_the_oracles},
    {"what_is_no_number_ends_with_a_reason",
     what_is_no_number_ends_with_a_reason},
    {"cures_arrive", cures_arrive},
    {"stepping_stops_at_the_limit_load", stepping_stops_at_the_limit_load},
    {"boundary_step_is_one_stretch", boundary_step_is_one_stretch},
    {"moving_end_is_the_oracles", moving_end_is_the_oracles},
    {"limit_loads_are_the_oracles", limit_loads_are_the_oracles},
    {"bar_localises_as_the_oracles", bar_localises_as_the_oracles},
};
UNIT_MAIN("stretch", laws)
