/*
 * loads.c - where does Newton's method end under a load, and after a jump?
 *
 * One element.  Tables: loads, of both laws from rest, either side of the load
 * -(2 mu + lambda) at which the first step inverts the log law
 * [eq:first-step], of -(3 mu + 11/2 lambda), at which the cubic law has F = 0,
 * and far beyond; limit_load, of the cubic law at nu = 0, where no equilibrium
 * has more than P = mu = 500, and at nu = 0.05, where beyond 527.25 the next
 * one is far away, by plain Newton, load stepping and line search; example, the
 * notes' bar, of length 1 and free at one end, whose other end moves by sin t
 * until t >= 6.3, each step started from the state of the step before: only the
 * first of n elements starts away from F = 1, at 1 - dg / h.
 */
#include "element.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static const struct newton_control CONTROL = {1e-10, 1000, 0, 0};

static void print_loads(void)
{
    static const double load[] = {1000.0,  -100.0,  -1346.0,  -1347.0, -4000.0,
                                  -4326.0, -4327.0, -10000.0, -100000.0};
    const struct material log_law = material_notes(LOG);
    const struct material cubic = material_notes(CUBIC);
    const double modulus = material_modulus(&log_law);
    const double collapse = -(3.0 * cubic.mu + 5.5 * cubic.lambda);
    int log_as_predicted = 1, cubic_as_predicted = 1;

    table_begin("loads", "p reason_log iterations_log F_log iterations_cubic "
                         "F_cubic F_linear");
    for (int k = 0; k < COUNT(load); k++) {
        const double p = load[k];
        const struct element_report a =
            element_newton(&log_law, p, 1.0, &CONTROL);
        const struct element_report b =
            element_newton(&cubic, p, 1.0, &CONTROL);
        table_row(p, status_name(a.status), a.iterations,
                  cell_if(a.status == OK, a.F), b.iterations,
                  cell_if(b.status == OK, b.F), 1.0 + p / modulus);
        log_as_predicted &= a.status == (p <= -modulus ? INVERTED : OK);
        cubic_as_predicted &= b.status == OK && (b.F < 0.0) == (p < collapse);
    }
    table_end();
    claim(log_as_predicted, "the log law is INVERTED at and below p = "
          "-(2 mu + lambda) = %g, and converges above", -modulus);
    claim(cubic_as_predicted, "the cubic law converges under every load, and "
          "ends with F < 0 below %g", collapse);
}

static void print_limit_load(void)
{
    const struct newton_control searched = {1e-10, 1000, 1, 0};
    int differ = 1, jumped = 1;
    double last = 0.0;

    table_begin("limit_load", "nu p F_plain");
    for (int i = 0; i < 2; i++)
        for (int k = 0; k <= 3; k++) {
            const struct material m = material_make(CUBIC, 1000.0, 0.05 * i);
            const double p = (0.4637 + 0.0478 * k) * 1000.0;
            const struct element_report a =
                element_newton(&m, p, 1.0, &CONTROL);
            const struct element_report b =
                element_stepping(&m, p, 0.0, &CONTROL);
            const struct element_report c =
                element_newton(&m, p, 1.0, &searched);
            table_row(0.05 * i, p, cell_if(a.status == OK, a.F));
            if (i == 0 && k > 0) {
                differ &= a.status == MAX_ITERATIONS && b.status == STALLED &&
                          c.status == NOT_SPD;
                last = b.F;
            }
            if (i == 1 && k > 1)
                jumped &= a.status == OK && a.F > 3.0 && b.status == OK &&
                          b.F > 3.0;
        }
    table_end();
    claim(differ, "beyond the limit load of nu = 0 plain Newton wanders, load "
          "stepping stalls and the line search finds P' < 0");
    claim(last > 1.9 && last < 2.0, "load stepping stops just before the "
          "limit point F = 2 (at %g)", last);
    claim(jumped, "at nu = 0.05 plain Newton and load stepping jump beyond "
          "F = 3 without a word");
}

/* push: the largest dg / h. */
static void print_example(void)
{
    static const struct { int n; double dt; } scene[] = {
        {10, 0.001}, {10, 0.01}, {10, 0.1}, {10, 0.2}, {10, 0.5},
        {100, 0.001}, {100, 0.01}, {100, 0.05}, {100, 0.1}, {100, 0.5}};
    const struct material log_law = material_notes(LOG);
    const struct material cubic = material_notes(CUBIC);
    const double pull = exp(0.5 + log_law.mu / log_law.lambda) - 1.0;
    int as_predicted = 1, cubic_fails = 0;

    table_begin("example", "n dt push");
    for (int k = 0; k < COUNT(scene); k++) {
        const double dt = scene[k].dt;
        double last = 0.0, push = 0.0;
        int log_fails = 0, too_far = 0;
        for (int i = 1; last < 6.3 - 1e-9; i++) {
            last = i * dt;
            const double jump = (sin(last) - sin(last - dt)) * scene[k].n;
            const double F = 1.0 - jump;
            push = fmax(push, jump);
            too_far |= jump >= 1.0 || jump <= -pull;
            log_fails |=
                element_newton(&log_law, 0.0, F, &CONTROL).status != OK;
            cubic_fails |=
                element_newton(&cubic, 0.0, F, &CONTROL).status != OK;
        }
        table_row(scene[k].n, dt, push);
        as_predicted &= too_far == log_fails;
    }
    table_end();
    claim(as_predicted, "the log law fails where a step is beyond the limits "
          "1 and %g, and only there", -pull);
    claim(!cubic_fails, "the cubic law survives every time step");
}

int main(void)
{
    print_loads();
    print_limit_load();
    print_example();
    return table_finish();
}
