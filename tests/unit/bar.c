/* bar.c - laws of material.h and bar.h of common/, and of lesson 10's
 * bar_fast.h. */
#include "bar/bar.h"
#include "figures/10_neohookean_bar/bar_fast.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>

/* F - 1 is -1 to round-off, and ln F is not: mu/2 (F^2 - 1) - mu r +
 * lambda/2 r^2, term by term. */
static void energy_of_a_collapsing_element(void)
{
    const struct material m = material_make(LOG, 1000.0, 0.3);
    for (double J = 0.3; J > 1e-300; J *= 2.385e-5) {
        const double r = log(J);
        const double want =
            0.5 * m.mu * (J * J - 1.0) - m.mu * r + 0.5 * m.lambda * r * r;
        const mat2 F = {{{0.7 * J, 0.3 * J}, {-1.0, 1.0}}}; /* det F = J */
        close_to(material1_psi(&m, J), want, 1e-13 * want);
        close_to(material2_psi(&m, F),
                 want + 0.5 * m.mu * (1.0 - 0.42 * J * J), 1e-13 * want);
    }
}

enum { n = 16 };

/* A bar held on the left under its own weight c. */
static void weight(double c, double b[n + 1])
{
    for (int i = 0; i <= n; i++) b[i] = c / n * (i == 0 || i == n ? 0.5 : 1.0);
}

static void residual_is_the_gradient_of_the_energy(void)
{
    double b[n + 1], u[n + 1], q[n + 1], plus, minus;
    weight(238.5, b);
    const struct bar bar = {n, 1.0 / n, {1, 0}, b,
                            material_make(CUBIC, 1000.0, 0.3)};
    struct matrix *K = matrix_alloc(DENSE, n + 1, 0);
    for (int i = 0; i <= n; i++) u[i] = 0.05 * sin(2.385 * i);
    ck_assert_int_eq(bar_residual(&bar, u, q), OK);
    ck_assert_int_eq(bar_tangent(&bar, u, K), OK);
    for (int i = 0; i <= n; i++) {
        const double d = 1e-6, u_i = u[i];
        double q_plus[n + 1], q_minus[n + 1];
        u[i] = u_i + d;
        bar_energy(&bar, u, &plus);
        bar_residual(&bar, u, q_plus);
        u[i] = u_i - d;
        bar_energy(&bar, u, &minus);
        bar_residual(&bar, u, q_minus);
        u[i] = u_i;
        close_to((plus - minus) / (2 * d), q[i], 1e-4 * (1 + fabs(q[i])));
        for (int j = 0; j <= n; j++)
            close_to((q_plus[j] - q_minus[j]) / (2 * d), matrix_get(K, j, i),
                     1e-2); /* entries are 1e5; d^2 P''' / h^3 */
    }
    matrix_free(K);
}

/* Any ends, odd and even n, a tangent that is not definite: the iterates of
 * bar_newton() to the round-off of a sweep over a few elements. */
static void fused_sweep_is_newton(void)
{
    for (int n_ = 1; n_ <= n; n_++)
        for (int ends = 1; ends < 4; ends++)
            for (int k = 0; k < 2; k++) {
                double b[n + 1], u[n + 1], v[n + 1];
                for (int i = 0; i <= n_; i++) b[i] = 100.0 * cos(2.385 * i);
                const struct bar bar = {n_, 2.385 / n_, {ends & 1, ends >> 1},
                                        b, material_make(CUBIC, 1000.0,
                                                         k ? 0.02 : 0.3)};
                for (int steps = 1; steps <= 60; steps *= 60) {
                    const struct newton_control control = {1e-11, steps, 0, 0};
                    struct newton_report want;
                    for (int i = 0; i <= n_; i++) u[i] = 0.3 * sin(3.714 * i);
                    want = bar_newton(&bar, &control, u, NULL);
                    if (k && steps > 1) continue; /* it may go anywhere */
                    for (int s = FROM_LEFT; s <= FROM_BOTH_ENDS; s++) {
                        for (int i = 0; i <= n_; i++)
                            v[i] = 0.3 * sin(3.714 * i);
                        const struct newton_report got = bar_fast_newton(
                            &bar, &control, (enum elimination)s, v);
                        ck_assert_int_eq(got.status, want.status);
                        ck_assert_int_le(abs(got.iterations - want.iterations),
                                         steps > 1);
                        if (steps == 1 && want.iterations == 1)
                            close_to(got.residual, want.residual,
                                     1e-9 * want.residual + 1e-9);
                        for (int i = 0; i <= n_; i++)
                            close_to(v[i], u[i],
                                     1e-9 * (1.0 + want.increment));
                    }
                }
            }
}

static void fused_sweep_fails_with_a_reason(void)
{
    double b[n + 1] = {0}, u[n + 1] = {0};
    struct bar bar = {n, 1.0 / n, {0, 0}, b, material_make(CUBIC, 1000.0, 0.3)};
    const struct newton_control control = {1e-11, 3, 0, 0};
    for (int s = FROM_LEFT; s <= FROM_BOTH_ENDS; s++) {
        const enum elimination sweep = (enum elimination)s;
        b[n] = 1.0; /* nothing is held */
        bar.held[0] = 0;
        ck_assert_int_eq(bar_fast_newton(&bar, &control, sweep, u).status,
                         NOT_SPD);
        bar.held[0] = 1;
        b[n] = -1e5;
        ck_assert_int_eq(bar_fast_newton(&bar, &control, sweep, u).status,
                         MAX_ITERATIONS);
        for (int i = 1; i <= n; i++) { /* wherever the NaN is */
            for (int j = 0; j <= n; j++) b[j] = u[j] = 0.0;
            b[i] = NAN;
            ck_assert_int_eq(bar_fast_newton(&bar, &control, sweep, u).status,
                             NONFINITE);
            b[i] = 0.0;
            u[i] = 1e300;
            ck_assert_int_eq(bar_fast_newton(&bar, &control, sweep, u).status,
                             NONFINITE);
        }
        for (int i = 0; i <= n; i++) b[i] = u[i] = 0.0;
        ck_assert_int_eq(bar_fast_newton(&bar, &control, sweep, u).iterations,
                         0);
    }
}

UNIT_MAIN("bar",
    LAW(energy_of_a_collapsing_element),
    LAW(residual_is_the_gradient_of_the_energy),
    LAW(fused_sweep_is_newton),
    LAW(fused_sweep_fails_with_a_reason))
