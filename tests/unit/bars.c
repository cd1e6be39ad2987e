/* bars.c - laws of common/bar/bar_scene.h and lesson 10's bar_gsl.h, and when
 * Newton's method of bar.h, bar_fast.h and bar_gsl.h stops and why. */
#include "figures/10_neohookean_bar/bar_fast.h"
#include "figures/10_neohookean_bar/bar_gsl.h"
#include "bar/bar_scene.h"

#include "../oracle/10_neohookean_bar.h"
#include "unit.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct bar_state *solved(const struct bar_scene *scene)
{
    struct bar_state *s = bar_scene_solve(scene, NULL);
    ck_assert_msg(s->report.status == OK, "%s", status_name(s->report.status));
    return s;
}

/* u(1) for a free end, u(1/2) for a held one, and what holds the left end. */
struct answer {
    double u, reaction;
};
static struct answer answer(struct bar_scene scene, int n)
{
    scene.n = n;
    struct bar_state *s = solved(&scene);
    const struct answer a = {s->u[scene.held[1] ? n / 2 : n],
                             bar_state_reaction(s)};
    bar_state_free(s);
    return a;
}

/* Richardson: (4 u_2n - u_n) / 3 leaves h^4. */
static void other_loads_are_the_oracles(void)
{
    for (int k = 0; k < 4; k++) {
        struct bar_scene scene = bar_scene_notes(k % 2 ? LOG : CUBIC, 1);
        scene.shape = COSINE;
        scene.c = k < 2 ? 1e3 : -1e3;
        const double coarse = answer(scene, 32).u, fine = answer(scene, 64).u;
        close_to((4.0 * fine - coarse) / 3.0, oracle_cosine[k], 1e-7);
    }
    for (int k = 0; k < 2; k++) {
        struct bar_scene scene = bar_scene_notes(CUBIC, 1);
        const double R = oracle_both_fixed[k].R;
        scene.c = oracle_both_fixed[k].c;
        scene.held[1] = 1;
        const struct answer a = answer(scene, 32), b = answer(scene, 64);
        close_to((4.0 * b.u - a.u) / 3.0, oracle_both_fixed[k].u_half, 1e-6);
        close_to(-(4.0 * b.reaction - a.reaction) / 3.0, R, 1e-5 * R);
    }
}

/* Whatever holds the bar: sum of the loads, and the places of held ends. */
static void a_scene_starts_as_it_says(void)
{
    for (int ends = 0; ends < 4; ends++) {
        struct bar_scene scene = bar_scene_notes(CUBIC, 7);
        double sum = 0.0;
        scene.c = 238.5;
        for (int k = 0; k < 2; k++) {
            scene.held[k] = ends >> k & 1;
            scene.g[k] = 0.1 + k;
            scene.pull[k] = scene.held[k] ? 0.0 : 37.1 + k;
        }
        struct bar_scene turned = scene; /* no sign makes the tolerance less */
        turned.c = -scene.c;
        for (int k = 0; k < 2; k++) {
            turned.g[k] = -scene.g[k];
            turned.pull[k] = -scene.pull[k];
        }
        ck_assert(bar_scene_control(&turned).tolerance ==
                  bar_scene_control(&scene).tolerance);
        struct bar_state *s = bar_state_alloc(&scene);
        for (int i = 0; i <= 7; i++) sum += s->b[i];
        close_to(sum, 238.5 + scene.pull[0] + scene.pull[1], 1e-10);
        for (int i = 0; i <= 7; i++)
            close_to(s->u[i], i == 0 && scene.held[0]   ? 0.1
                              : i == 7 && scene.held[1] ? 1.1
                                                        : 0.0, 1e-16);
        close_to(s->bar.h, 1.0 / 7.0, 1e-16);
        double b[9]; /* whatever was there, and not behind it */
        for (int i = 0; i < 9; i++) b[i] = NAN;
        bar_scene_load(&scene, b);
        for (int i = 0; i <= 7; i++) ck_assert(b[i] == s->b[i]);
        ck_assert(isnan(b[8]));
        bar_state_free(s);
    }
}

/* nu = 0.05, pulled to twice its length at once: the oracle's bar is not
 * uniform.  Beyond the limit load definiteness is lost on the way. */
static void indefinite_is_solved_or_refused(void)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, 10);
    scene.material = material_make(CUBIC, 1000.0, 0.05);
    scene.held[1] = 1;
    scene.g[1] = 1.0;
    struct bar_state *s = solved(&scene);
    double high = 0.0;
    for (int e = 1; e <= 10; e++)
        high = fmax(high, bar_stretch(&s->bar, s->u, e));
    close_to(bar_min_stretch(&s->bar, s->u), oracle_localised[0], 1e-9);
    close_to(high, oracle_localised[1], 1e-9);
    bar_state_free(s);

    /* the first of 16 elements carries all of the weight but half its own */
    for (int k = 0; k < 2; k++)
        for (int above = 0; above < 2; above++) {
            scene = bar_scene_notes(CUBIC, 16);
            scene.material = material_make(CUBIC, 1000.0, oracle_limit[k].nu);
            scene.c = oracle_limit[k].c / (1.0 - 1.0 / 32.0) *
                      (above ? 1.001 : 0.999);
            struct newton_control control = bar_scene_control(&scene);
            control.definite = 1;
            s = bar_scene_solve(&scene, &control);
            ck_assert_int_eq(s->report.status, above ? NOT_SPD : OK);
            bar_state_free(s);
            s = bar_scene_solve(&scene, NULL);
            ck_assert_int_ne(s->report.status, NOT_SPD);
            bar_state_free(s);
        }
}

static void history_has_the_failed_state(void)
{
    struct bar_scene scene = bar_scene_notes(LOG, 8);
    struct newton_step history[101];
    scene.c = -2000.0;
    struct newton_control control = bar_scene_control(&scene);
    struct bar_state *s = bar_state_alloc(&scene);
    s->report = bar_newton(&s->bar, &control, s->u, history);
    ck_assert_int_eq(s->report.status, INVERTED);
    ck_assert_int_eq(s->report.iterations, 1);
    close_to(history[0].residual, 250.0, 1e-10);
    close_to(history[1].min_F, bar_min_stretch(&s->bar, s->u), 1e-16);
    ck_assert(history[1].min_F < 0.0 && isnan(history[1].residual));
    ck_assert(isnan(history[1].energy));
    bar_state_free(s);

    control.line_search = 1; /* has it in 7 */
    s = bar_state_alloc(&scene);
    s->report = bar_newton(&s->bar, &control, s->u, history);
    ck_assert_int_eq(s->report.status, OK);
    ck_assert_int_le(abs(s->report.iterations - 7), 1);
    close_to(bar_state_reaction(s), 2000.0, 1e-8);
    bar_state_free(s);
}

static void mine(const char *why, const char *file, int line, int number)
{
    (void)why, (void)file, (void)line, (void)number;
}

static void gsl_newton_is_newton(void)
{
    for (int n = 2; n < 400; n *= 5)
        for (int k = 0; k < 2; k++) {
            struct bar_scene scene = bar_scene_notes(CUBIC, n);
            scene.c = k ? -1300.0 : 500.0;
            scene.g[0] = 0.2385;
            const struct newton_control control = bar_scene_control(&scene);
            struct bar_state *s = solved(&scene);
            struct bar_state *t = bar_state_alloc(&scene);
            t->report = bar_gsl_newton(&t->bar, &control, t->u);
            ck_assert_int_eq(t->report.status, OK);
            ck_assert_int_le(abs(t->report.iterations - s->report.iterations),
                             1);
            for (int i = 0; i <= n; i++)
                close_to(t->u[i], s->u[i], 1e-14 * n);
            bar_state_free(s);
            bar_state_free(t);
        }
    struct bar_scene scene = bar_scene_notes(CUBIC, 5);
    scene.c = NAN;
    struct newton_control control = {1e-12, 3, 0, 0};
    struct bar_state *s = bar_state_alloc(&scene);
    ck_assert_int_eq(bar_gsl_newton(&s->bar, &control, s->u).status,
                     NONFINITE);
    bar_state_free(s);
    scene.c = -1300.0;
    s = bar_state_alloc(&scene);
    gsl_set_error_handler(mine);
    ck_assert_int_eq(bar_gsl_newton(&s->bar, &control, s->u).status,
                     MAX_ITERATIONS);
    ck_assert(gsl_set_error_handler(NULL) == mine); /* it is put back */
    bar_state_free(s);
}

/* ---- when Newton's method stops ------------------------------------------ */

enum { NEWTON, SWEEP, TWO_SWEEPS, GSL, N_SOLVER };

/* By any of the four, where they all can: cubic law, right end free, n > 1. */
static struct newton_report solve(int solver, const struct bar *bar,
                                  const struct newton_control *control,
                                  double u[])
{
    if (solver == NEWTON) return bar_newton(bar, control, u, NULL);
    if (solver == GSL) return bar_gsl_newton(bar, control, u);
    return bar_fast_newton(bar, control,
                           solver == SWEEP ? FROM_LEFT : FROM_BOTH_ENDS, u);
}

/* u_i becomes -u_{n-i}: the same F and P, seen from behind.  F is largest and
 * P' smallest in the first element. */
static void mirror(int n, const double v[], double w[])
{
    for (int i = 0; i <= n; i++) w[i] = -v[n - i];
}

static void a_mirror_changes_nothing(void)
{
    enum { n = 7 };
    for (int k = 0; k < 8; k++) {
        const struct newton_control control = {1e-11, 30, k & 1, k >> 1 & 1};
        double b[n + 1], b_seen[n + 1], u[n + 1], seen[n + 1], v[n + 1];
        struct newton_step step[31], step_seen[31];
        for (int i = 0; i <= n; i++) {
            b[i] = 100.0 * cos(2.385 * i);
            u[i] = (i > 0) * 0.05 + 0.01 * sin(3.714 * i + 0.7);
        }
        mirror(n, b, b_seen);
        mirror(n, u, seen);
        const struct bar bar = {n, 1.0 / n, {1, 0}, b,
                                material_notes(k < 4 ? LOG : CUBIC)};
        const struct bar bar_seen = {n, 1.0 / n, {0, 1}, b_seen, bar.material};
        const struct newton_report want = bar_newton(&bar, &control, u, step);
        const struct newton_report got =
            bar_newton(&bar_seen, &control, seen, step_seen);
        ck_assert_int_eq(want.status, OK);
        ck_assert_int_eq(got.status, OK);
        ck_assert_int_eq(got.iterations, want.iterations);
        mirror(n, seen, v);
        for (int i = 0; i <= n; i++) close_to(v[i], u[i], 1e-13);
        for (int i = 0; i <= want.iterations; i++) {
            const struct newton_step *a = &step[i], *c = &step_seen[i];
            close_to(c->residual, a->residual, 1e-10); /* of forces of 1e2 */
            close_to(c->increment, a->increment, 1e-13);
            close_to(c->energy, a->energy, 1e-11);
            close_to(c->min_F, a->min_F, 1e-12);
            ck_assert(c->length == a->length && a->length <= 1.0);
            ck_assert(a->length == 1.0 || control.line_search);
        }
    }
}

/* nu = 0: P = mu (2 e - e^2) is flat at e = 1.  At e = 1 - 2d the residual is
 * small, and still e is wrong by d: the solution is 1 - d. */
static void a_small_residual_is_not_enough(void)
{
    enum { n = 4 };
    const double d = 1e-5;
    const struct newton_control control = {1e-8, 30, 0, 0};
    const struct material material = material_make(CUBIC, 1000.0, 0.0);
    const double b[n + 1] = {[n] = material.mu * (1.0 - d * d)};
    const struct bar bar = {n, 1.0 / n, {1, 0}, b, material};
    for (int k = NEWTON; k < N_SOLVER; k++) {
        double u[n + 1];
        for (int i = 0; i <= n; i++) u[i] = (1.0 - 2.0 * d) * i / n;
        ck_assert_int_eq(solve(k, &bar, &control, u).status, OK);
        close_to(u[n], 1.0 - d, 1e-9); /* eps / d, and d^2 of the last step */
    }
}

/* From three times its length without a load: the first increment, 0.6, would
 * pass this tolerance, the residual of 7 moduli does not. */
static void a_small_increment_is_not_enough(void)
{
    enum { n = 4 };
    const struct newton_control control = {0.65, 30, 0, 0};
    const double b[n + 1] = {0.0};
    const struct bar bar = {n, 1.0 / n, {1, 0}, b, material_notes(CUBIC)};
    for (int k = NEWTON; k < N_SOLVER; k++) {
        double u[n + 1];
        for (int i = 0; i <= n; i++) u[i] = 3.0 * i / n;
        const struct newton_report got = solve(k, &bar, &control, u);
        ck_assert_int_eq(got.status, OK);
        const double P = material1_pk1(&bar.material, 1.0 + u[n]);
        ck_assert_double_le(P, 0.65 * material_modulus(&bar.material));
        close_to(got.residual, P, 1e-9);
        ck_assert_double_gt(got.iterations, 1);
    }
}

/* A first element of the length 2^-53, by the log law: Newton doubles it, and
 * that is at round-off, while the force on it is 1e19.  By the cubic law: away
 * from rest by round-off, and nothing is small enough. */
static void what_round_off_cannot_move_is_stalled(void)
{
    enum { n = 4 };
    const double b[n + 1] = {0.0}, h = 1024.0;
    struct newton_control control = {1e-10, 100, 0, 0};
    struct bar bar = {n, h, {1, 0}, b, material_notes(LOG)};
    double u[n + 1] = {0.0};
    for (int i = 1; i <= n; i++) u[i] = -h * (1.0 - 0x1p-53);
    struct newton_report report = bar_newton(&bar, &control, u, NULL);
    ck_assert_int_eq(report.status, STALLED);
    ck_assert_int_eq(report.iterations, 1);
    ck_assert_double_gt(report.residual, 1e17);

    bar.material.law = CUBIC;
    control.tolerance = 0.0;
    for (int s = FROM_LEFT; s <= FROM_BOTH_ENDS; s++) {
        for (int i = 0; i <= n; i++) u[i] = 0.5 * DBL_EPSILON * h * i;
        report = bar_fast_newton(&bar, &control, (enum elimination)s, u);
        ck_assert_int_eq(report.status, STALLED);
        ck_assert_int_eq(report.iterations, 1);
    }
}

/* Unless a residual is 0 the iterates come to rest in round-off. */
static void no_tolerance_is_too_small(void)
{
    const struct newton_control control = {0.0, 100, 0, 0};
    for (int k = 0; k < 80; k++) {
        const struct bar_scene scene = {.n = 4, .held = {1, k & 1},
                                        .material = material_notes(CUBIC),
                                        .c = 11.925 * k + 1.0};
        struct bar_state *s = bar_state_alloc(&scene);
        const struct newton_report report = bar_fast_newton(
            &s->bar, &control, (enum elimination)(k >> 1 & 1), s->u);
        ck_assert(report.status == STALLED ||
                  (report.status == OK && report.residual == 0.0));
        ck_assert_double_le(report.residual, 1e-12); /* of forces of 1e3 */
        bar_state_free(s);
    }
}

/* nu = 0, P' = 2 mu (1 - e): two elements with e = 1/2 and 3/2 between ends
 * that are held, and in the middle k - k, but for the last digit of one e. */
static void a_pivot_of_round_off_is_reported(void)
{
    for (int s = NEWTON; s < GSL; s++)
        for (int digit = -1; digit <= 1; digit += 2) {
            const double b[3] = {0.0, 1.0, 0.0};
            const struct bar bar = {2, 1.0, {1, 1}, b,
                                    material_make(CUBIC, 1000.0, 0.0)};
            const struct newton_control control = {1e-10, 9, 0, 0};
            double u[3] = {-0.5 - digit * 0x1p-53, 0.0, 1.5};
            const struct newton_report report = solve(s, &bar, &control, u);
            ck_assert_int_eq(report.status, NOT_SPD);
            ck_assert_int_eq(report.iterations, 0);
        }
}

/* The same two elements at one end of four, for the sweep from that end. */
static void a_pivot_of_round_off_is_reported_at_each_end(void)
{
    for (int right = 0; right < 2; right++)
        for (int digit = -1; digit <= 1; digit += 2) {
            const double b[5] = {0.0};
            const struct bar bar = {4, 1.0, {1, 1}, b,
                                    material_make(CUBIC, 1000.0, 0.0)};
            const struct newton_control control = {1e-10, 9, 0, 0};
            const double half = 0.5 + digit * 0x1p-53;
            double u[2][5] = {{-half, 0.0, 1.5, 1.5, 1.5},
                              {-1.5, -1.5, -1.5, 0.0, half}};
            const struct newton_report report =
                solve(TWO_SWEEPS, &bar, &control, u[right]);
            ck_assert_int_eq(report.status, NOT_SPD);
            ck_assert_int_eq(report.iterations, 0);
        }
}

static void the_largest_free_entry_is_found(void)
{
    enum { n = 4 };
    for (int ends = 0; ends < 4; ends++) {
        const struct bar bar = {.n = n, .held = {ends & 1, ends >> 1}};
        for (int i = 0; i <= n; i++) {
            const int held = (i == 0 && bar.held[0]) || (i == n && bar.held[1]);
            double v[n + 1] = {0.5, -0.5, 0.5, -0.5, 0.5};
            v[i] = -2.385;
            ck_assert(bar_max_free(&bar, v) == (held ? 0.5 : 2.385));
            v[i] = NAN;
            ck_assert(bar_max_free(&bar, v) == (held ? 0.5 : INFINITY));
        }
    }
}

/* Without lambda the tangent of the cubic law is mu (2 - 2 H), which at twice
 * the length is 0: all of the bar, or its last element, at whose pivot GSL does
 * not look. */
static void a_pivot_of_zero_is_reported_by_gsl(void)
{
    enum { n = 4 };
    const struct newton_control control = {.tolerance = 1e-12,
                                           .max_iterations = 9};
    for (int stretched = 1; stretched <= n; stretched += n - 1) {
        double b[n + 1] = {0.0}, u[n + 1] = {0.0}, before[n + 1];
        const struct bar bar = {.n = n, .h = 0.25, .held = {1, 0}, .b = b,
                                .material = {CUBIC, .mu = 2.385}};
        for (int e = 1; e <= n; e++)
            u[e] = u[e - 1] + (e > n - stretched ? 0.25 : 0.0);
        memcpy(before, u, sizeof u);
        const struct newton_report end = bar_gsl_newton(&bar, &control, u);
        if (stretched == 1) {
            ck_assert_int_eq(end.status, NONFINITE);
            continue;
        }
        ck_assert_int_eq(end.status, NOT_SPD);
        ck_assert_int_eq(end.iterations, 0);
        ck_assert(end.residual > 1.0 && end.increment == 0.0);
        ck_assert(memcmp(before, u, sizeof u) == 0);
    }
}

static void a_load_that_is_no_number_is_reported(void)
{
    enum { n = 5 };
    for (int i = 0; i <= n; i++) {
        double b[n + 1] = {0.0}, u[n + 1] = {0.0}, q[n + 1];
        b[i] = NAN;
        const struct bar bar = {n, 1.0 / n, {1, 0}, b, material_notes(CUBIC)};
        ck_assert_int_eq(bar_residual(&bar, u, q), NONFINITE);
    }
}

/* A load that says what it was given, at any bar. */
static void given(int n, double h, const double f_mid[], const double pull[2],
                  double b[])
{
    for (int i = 0; i <= n; i++) b[i] = i < n ? f_mid[i] : h;
    b[0] += 1e3 * pull[0] + 1e6 * pull[1];
}

static void a_load_of_ones_own_is_used(void)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, 4);
    scene.c = 37.14;
    bar_scene_ends(&scene, 0, 1, (const double[]){2.385, 0.613});
    ck_assert(!scene.held[0] && scene.held[1]);
    struct bar_state *s = bar_state_by(given, &scene);
    const double want[] = {37.14 + 2385.0, 37.14, 37.14, 37.14, 0.25};
    for (int i = 0; i <= 4; i++) {
        close_to(s->b[i], want[i], 1e-12);
        close_to(s->u[i], i < 4 ? 0.0 : 0.613, 1e-16);
    }
    bar_state_free(s);
}

UNIT_MAIN("bars",
    LAW(other_loads_are_the_oracles),
    LAW(a_scene_starts_as_it_says),
    LAW(indefinite_is_solved_or_refused),
    LAW(history_has_the_failed_state),
    LAW(gsl_newton_is_newton),
    LAW(a_mirror_changes_nothing),
    LAW(a_small_residual_is_not_enough),
    LAW(a_small_increment_is_not_enough),
    LAW(what_round_off_cannot_move_is_stalled),
    LAW(no_tolerance_is_too_small),
    LAW(a_pivot_of_round_off_is_reported_at_each_end),
    LAW(a_pivot_of_round_off_is_reported),
    LAW(the_largest_free_entry_is_found),
    LAW(a_pivot_of_zero_is_reported_by_gsl),
    LAW(a_load_that_is_no_number_is_reported),
    LAW(a_load_of_ones_own_is_used))
