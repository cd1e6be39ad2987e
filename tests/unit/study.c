/* study.c - laws of figures/study/study.h. */
#include "figures/study/study.h"

#include "base/clock.h"
#include "base/status.h"
#include "unit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static double cubic(double x, void *shift)
{
    return x * x * x - *(double *)shift;
}

/* Of values whose product is no number but 0; falling or rising. */
static double tiny(double x, void *size)
{
    return (x * x * x - 2.385) * *(double *)size;
}

static double never(double x, void *unused)
{
    (void)unused;
    return 1.0 + x * x;
}

static double hole(double x, void *unused)
{
    (void)unused;
    return x < 0.1 || x > 0.9 ? x - 0.5 : (double)NAN;
}

static void a_root_is_found_to_the_last_digit(void)
{
    double shift = 2.385;
    close_to(study_root(cubic, &shift, 0.0, 2.0), cbrt(2.385), 1e-15 * 2);
    close_to(study_root(cubic, &shift, 2.0, 0.0), cbrt(2.385), 1e-15 * 2);
    shift = 8.0; /* at an end */
    ck_assert_double_eq(study_root(cubic, &shift, 1.0, 2.0), 2.0);
    ck_assert_double_eq(study_root(cubic, &shift, 2.0, 3.0), 2.0);
    ck_assert_double_eq(study_root(cubic, &shift, 2.0, 2.0), 2.0);
    for (double size = -1e-200; size < 2e-200; size += 2e-200)
        close_to(study_root(tiny, &size, 0.0, 2.0), cbrt(2.385), 1e-15 * 2);
}

static void ask_without_a_root(void) { study_root(never, NULL, -1.0, 1.0); }
static void ask_a_hole(void) { study_root(hole, NULL, 0.0, 1.0); }

static void no_root_is_an_error(void)
{
    struct outcome outcome = outcome_of(ask_without_a_root);
    ck_assert_int_eq(outcome.status, 1);
    ck_assert(strstr(outcome.err, "no change of sign between -1 and 1"));
    outcome = outcome_of(ask_a_hole);
    ck_assert_int_eq(outcome.status, 1);
    ck_assert(strstr(outcome.err, "not finite"));
}

static void orders_are_the_exponents(void)
{
    const double h = 0.2385;
    for (double size = 3e-9; size < 1e9; size *= 1e4) /* of any errors */
        close_to(study_order(size * pow(3.0 * h, 2.5), size * pow(h, 2.5), 3.0),
                 2.5, 1e-13);
    ck_assert(isnan(study_order(0.0, 1.0, 2.0)));
    ck_assert(isnan(study_order(1.0, 0.0, 2.0)));
    ck_assert(isnan(study_order((double)NAN, 1.0, 2.0)));
}

static void claim_what_is_true(void)
{
    puts("table");
    claim(1 + 1 == 2, "never printed");
}

static void claim_what_is_false(void)
{
    puts("table");
    claim(1 + 1 == 3, "1 + 1 is %d", 3);
}

static void a_false_claim_ends_the_study(void)
{
    struct outcome outcome = outcome_of(claim_what_is_true);
    ck_assert_int_eq(outcome.status, 0);
    ck_assert_str_eq(outcome.err, "");
    outcome = outcome_of(claim_what_is_false);
    ck_assert_int_eq(outcome.status, 1);
    ck_assert_str_eq(outcome.out, "table\n"); /* the tables are not lost */
    ck_assert(strstr(outcome.err, "the claim is false: 1 + 1 is 3"));
}

static void seconds_are_sorted_and_need_a_valid_answer(void)
{
    static struct times t;
    ck_assert(isnan(times_median(&t)));
    const double sample[] = {5.0, 1.0, 4.0, 2.0, 3.0};
    for (int i = 0; i < 5; i++) times_record(&t, sample[i], 1);
    ck_assert_double_eq(times_best(&t), 1.0);
    ck_assert_double_eq(times_median(&t), 3.0);
    ck_assert_double_eq(times_quantile(&t, 0.25), 2.0);
    times_record(&t, 0.001, 0);
    ck_assert(isnan(times_best(&t)) && isnan(times_median(&t)));
    for (int i = 0; i < 2 * STUDY_SAMPLES; i++) times_record(&t, 1.0, 1);
    ck_assert_int_eq(t.runs, STUDY_SAMPLES);
    static struct times full; /* the fastest come last, but for one too many */
    for (int i = 0; i <= STUDY_SAMPLES; i++)
        times_record(&full, STUDY_SAMPLES - i, 1);
    ck_assert_double_eq(times_best(&full), 1.0);
    ck_assert_double_eq(times_median(&full), (STUDY_SAMPLES + 1) / 2.0);
}

/* The mean, or the mean square, of a true rate p between 0 and 1 of which there
 * is known that it gave so many hits: by the midpoint rule. */
static double moment(int power, int hits, int runs)
{
    double sum = 0.0, all = 0.0;
    for (int k = 0; k < 5000; k++) {
        const double p = (k + 0.5) / 5000;
        const double weight = pow(p, hits) * pow(1.0 - p, runs - hits);
        sum += weight * pow(p, power);
        all += weight;
    }
    return sum / all;
}

static void a_rate_is_as_sure_as_its_runs(void)
{
    const int runs[] = {1, 5, 60};
    for (int i = 0; i < 3; i++)
        for (int hits = 0; hits <= runs[i]; hits++) {
            const double mean = moment(1, hits, runs[i]);
            const double square = moment(2, hits, runs[i]);
            close_to(rate_error(hits, runs[i]), sqrt(square - mean * mean),
                     1e-6);
        }
    close_to(rate_error(800, 2000), sqrt(0.24 / 2000), 2e-5);
    close_to(rate_error(2000, 2000), 1.0 / 2000, 1e-5 / 10);
    /* 0.6 and 0.4 with a standard error of 0.05 each, and the larger first */
    close_to(rate_apart(60, 100, 40, 100), 0.2 / (0.0488 * sqrt(2.0)), 0.05);
    close_to(rate_apart(40, 100, 600, 1000),
             -0.2 / hypot(rate_error(40, 100), rate_error(600, 1000)), 1e-15);
    ck_assert_double_eq(rate_apart(250, 250, 250, 250), 0.0);
}

static void a_machine_is_a_note(void)
{
    char machine[512], want[600];
    clock_machine(sizeof machine, machine);
    snprintf(want, sizeof want, "# machine: %s\n\n\n", machine);
    ck_assert_str_eq(outcome_of(study_machine).out, want);
}

UNIT_MAIN("study",
    LAW(a_root_is_found_to_the_last_digit),
    LAW(no_root_is_an_error),
    LAW(orders_are_the_exponents),
    LAW(a_false_claim_ends_the_study),
    LAW(seconds_are_sorted_and_need_a_valid_answer),
    LAW(a_rate_is_as_sure_as_its_runs),
    LAW(a_machine_is_a_note))
