/* bar.c - laws of material.h, tensor.h and bar.h of common/, and of lesson 10's
 * bar_fast.h. */
#include "bar/bar.h"
#include "figures/10_neohookean_bar/bar_fast.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>

static const enum law laws_of[] = {LINEAR, LOG, CUBIC};

/* |f(x+d) - f(x) - d f'(x)| falls like d^2 when f' is right. */
static double slope_of_remainder(double big, double small)
{
    return log2(big / small);
}

static void pk1_and_dpk1_are_derivatives_in_1d(void)
{
    for (int l = 0; l < 3; l++) {
        const struct material m = material_make(laws_of[l], 1000.0, 0.3);
        for (double F = 0.4; F < 3.0; F += 0.2385) {
            double psi[2], pk1[2];
            for (int k = 0; k < 2; k++) {
                const double d = ldexp(1e-3, -k);
                psi[k] = fabs(material1_psi(&m, F + d) - material1_psi(&m, F) -
                              d * material1_pk1(&m, F) -
                              d * d / 2 * material1_dpk1(&m, F));
                pk1[k] = fabs(material1_pk1(&m, F + d) - material1_pk1(&m, F) -
                              d * material1_dpk1(&m, F));
            }
            if (laws_of[l] == LINEAR) {
                close_to(psi[0], 0.0, 1e-9);
                close_to(pk1[0], 0.0, 1e-9);
            } else {
                ck_assert(psi[0] < 1e-3 && pk1[0] < 0.3);
                if (psi[1] > 1e-8)
                    close_to(slope_of_remainder(psi[0], psi[1]), 3.0, 0.2);
                if (pk1[1] > 1e-6)
                    close_to(slope_of_remainder(pk1[0], pk1[1]), 2.0, 0.2);
            }
        }
    }
}

static void pk1_and_dpk1_are_derivatives_in_2d(void)
{
    const mat2 F = {{{1.2, 0.37}, {-0.21, 0.83}}};
    const mat2 dF = {{{0.613, -0.2385}, {0.371, 0.137}}};
    for (int l = 0; l < 3; l++) {
        const struct material m = material_make(laws_of[l], 1000.0, 0.3);
        const double d = 1e-5; /* central: d^2 and round-off / d, both 1e-7 */
        const mat2 plus = mat2_add(F, mat2_scale(d, dF));
        const mat2 minus = mat2_subtract(F, mat2_scale(d, dF));
        close_to((material2_psi(&m, plus) - material2_psi(&m, minus)) / (2 * d),
                 mat2_dot(material2_pk1(&m, F), dF), 1e-6);
        const mat2 difference =
            mat2_scale(0.5 / d, mat2_subtract(material2_pk1(&m, plus),
                                              material2_pk1(&m, minus)));
        close_to(mat2_norm(mat2_subtract(difference,
                                         material2_dpk1(&m, F, dF))),
                 0.0, 1e-6);
    }
}

static void neohookean_is_frame_invariant(void)
{
    const mat2 F = {{{1.2, 0.37}, {-0.21, 0.83}}}, Q = mat2_rotation(0.7);
    const mat2 QF = mat2_multiply(Q, F);
    for (int l = 1; l < 3; l++) {
        const struct material m = material_make(laws_of[l], 1000.0, 0.3);
        const mat2 P = material2_pk1(&m, F);
        const mat2 PFt = mat2_multiply(P, mat2_transpose(F));
        close_to(material2_psi(&m, QF), material2_psi(&m, F), 1e-12);
        close_to(mat2_norm(mat2_subtract(material2_pk1(&m, QF),
                                         mat2_multiply(Q, P))),
                 0.0, 1e-11);
        close_to(PFt.m[0][1], PFt.m[1][0], 1e-11);
        close_to(material2_psi(&m, Q), 0.0, 1e-12);
        close_to(mat2_norm(material2_pk1(&m, Q)), 0.0, 1e-12);
    }
}

static void two_dimensions_contain_one(void)
{
    for (int l = 0; l < 3; l++) {
        const struct material m = material_make(laws_of[l], 1000.0, 0.3);
        const mat2 F = {{{0.7, 0.0}, {0.0, 1.0}}};
        close_to(material2_psi(&m, F), material1_psi(&m, 0.7), 1e-12);
        close_to(material2_pk1(&m, F).m[0][0], material1_pk1(&m, 0.7), 1e-11);
    }
}

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

static void oracle_values(void)
{
    /* source: independent computation with mpmath, E = 1000, nu = 0.3 */
    const struct material log_ = material_make(LOG, 1000.0, 0.3);
    const struct material cubic = material_make(CUBIC, 1000.0, 0.3);
    close_to(material1_psi(&cubic, 0.0), 1482.371794871795, 1e-11);
    close_to(material1_pk1(&cubic, 0.0), -4326.923076923077, 1e-11);
    close_to(material1_dpk1(&cubic, 0.0), 9903.846153846154, 1e-11);
    close_to(material1_psi(&log_, 0.2), 1181.5983491997217, 1e-11);
    close_to(material1_pk1(&log_, 0.2), -6488.763208944521, 1e-11);
    close_to(material1_dpk1(&log_, 0.2), 47636.12373703029, 1e-10);
    ck_assert(!material_defined(&log_, 0.0));
    ck_assert(!material_defined(&log_, NAN));
    ck_assert(material_defined(&cubic, -2.0) && !material_defined(&cubic, NAN));
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

/* Source: the same independent computation; standing and hanging bar. */
static void bar_under_its_weight_equals_the_oracle(void)
{
    static const struct {
        enum law law;
        double c, u1;
    } oracle[] = {
        {CUBIC, 10.0, 0.0037314461483301076},
        {LOG, 10.0, 0.003731416617320355},
        {CUBIC, 500.0, 0.24091178375151712},
        {LOG, 500.0, 0.23701196874011776},
        {CUBIC, 2000.0, 0.96226644947015},
        {LOG, 2000.0, 1.6282716677063909},
        {CUBIC, -10.0, -0.0036973173223975985},
        {LOG, -10.0, -0.003697288404573222},
    };
    for (int k = 0; k < COUNT(oracle); k++)
        for (int search = 0; search < 2; search++) {
            double b[n + 1], u[n + 1] = {0};
            weight(oracle[k].c, b);
            const struct bar bar = {n, 1.0 / n, {1, 0}, b,
                                    material_make(oracle[k].law, 1000.0, 0.3)};
            const struct newton_control control = {1e-12, 60, search, 0};
            const struct newton_report report =
                bar_newton(&bar, &control, u, NULL);
            ck_assert_msg(report.status == OK, "%s",
                          status_name(report.status));
            close_to(u[n], oracle[k].u1, 1e-10 * fabs(oracle[k].u1) + 1e-12);
        }
}

/* Log law from rest: the first step reaches F <= 0 iff p <= -(2 mu + lambda).
 */
static void failure_has_a_reason(void)
{
    for (int k = 0; k < 2; k++) {
        double b[n + 1] = {0}, u[n + 1] = {0};
        b[n] = k == 0 ? -1346.0 : -1347.0;
        const struct bar bar = {n, 1.0 / n, {1, 0}, b,
                                material_make(LOG, 1000.0, 0.3)};
        struct newton_control control = {1e-10, 60, 0, 0};
        const struct newton_report report = bar_newton(&bar, &control, u, NULL);
        ck_assert_int_eq(report.status, k == 0 ? OK : INVERTED);
        if (k == 0) ck_assert_int_le(abs(report.iterations - 21), 2);
        control.line_search = 1;
        for (int i = 0; i <= n; i++) u[i] = 0.0;
        ck_assert_int_eq(bar_newton(&bar, &control, u, NULL).status, OK);
        control.max_iterations = 2;
        for (int i = 0; i <= n; i++) u[i] = 0.0;
        ck_assert_int_eq(bar_newton(&bar, &control, u, NULL).status,
                         MAX_ITERATIONS);
    }
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
    LAW(pk1_and_dpk1_are_derivatives_in_1d),
    LAW(pk1_and_dpk1_are_derivatives_in_2d),
    LAW(neohookean_is_frame_invariant),
    LAW(two_dimensions_contain_one),
    LAW(energy_of_a_collapsing_element),
    LAW(oracle_values),
    LAW(residual_is_the_gradient_of_the_energy),
    LAW(bar_under_its_weight_equals_the_oracle),
    LAW(failure_has_a_reason),
    LAW(fused_sweep_is_newton),
    LAW(fused_sweep_fails_with_a_reason))
