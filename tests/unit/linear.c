/* linear.c - laws of bar_scene.h for the linear bar, and how wrong it is. */
#include "bar/bar_scene.h"
#include "figures/11_newton_failure/element.h"

#include "unit.h"

#include "../oracle/09_linear_bar.h"

#include <math.h>

/* All ways to hold a bar, with numbers of high entropy. */
static struct bar_scene scene_of(enum shape shape, int left, int right)
{
    struct bar_scene scene = bar_scene_notes(LINEAR, 7);
    scene.shape = shape;
    scene.c = 53.7;
    scene.held[0] = left;
    scene.held[1] = right;
    scene.g[0] = 0.137;
    scene.g[1] = -0.2385;
    scene.pull[0] = left ? 0.0 : -12.3;
    scene.pull[1] = right ? 0.0 : 71.9;
    return scene;
}

/* P' = -f and modulus u' = P by central differences; the ends as prescribed. */
static void exact_solution_solves_the_problem(void)
{
    const double d = 1e-4; /* d^2 f''/6 and round-off / d: 1e-7 */
    for (int k = 0; k < 6; k++) {
        const struct bar_scene s =
            scene_of(k % 2 ? COSINE : UNIFORM, k / 2 != 1, k / 2 != 0);
        const double modulus = material_modulus(&s.material);
        for (double X = 0.05; X < 1.0; X += 0.137) {
            double P, before, after;
            const double f =
                s.c * (s.shape == COSINE ? cos(1.5707963267948966 * X) : 1.0);
            bar_scene_exact(&s, X, &P);
            const double slope = (bar_scene_exact(&s, X + d, &after) -
                                  bar_scene_exact(&s, X - d, &before)) / d / 2;
            close_to(modulus * slope, P, 1e-5);
            close_to((before - after) / d / 2, f, 1e-5);
        }
        for (int end = 0; end < 2; end++) {
            double P;
            const double u = bar_scene_exact(&s, end, &P);
            if (s.held[end]) close_to(u, s.g[end], 1e-15);
            else close_to(end ? P : -P, s.pull[end], 1e-12);
        }
    }
}

/* Held nowhere, under loads that balance, it is the one that starts at 0. */
static void a_free_bar_starts_at_zero(void)
{
    double P;
    struct bar_scene s = scene_of(UNIFORM, 0, 0);
    s.pull[0] = -s.pull[1] - s.c;
    ck_assert(bar_scene_exact(&s, 0.0, &P) == 0.0);
    close_to(P, -s.pull[0], 1e-12);
    const double u = bar_scene_exact(&s, 1.0, &P);
    close_to(P, s.pull[1], 1e-12);
    close_to(u, (s.pull[1] + s.c / 2) / material_modulus(&s.material), 1e-12);
}

/* Constant modulus and midpoint loads of a constant force: nodally exact. */
static void nodal_values_are_exact(void)
{
    for (int k = 0; k < 3; k++) {
        const struct bar_scene s = scene_of(UNIFORM, k != 1, k != 0);
        struct bar_state *state = bar_scene_solve(&s, NULL);
        ck_assert_int_eq(state->report.status, OK);
        for (int i = 0; i <= s.n; i++) {
            double P;
            close_to(state->u[i], bar_scene_exact(&s, (double)i / s.n, &P),
                     1e-14);
        }
        bar_state_free(state);
    }
}

static void hanging_bar_is_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_hanging); k++)
        for (int law = LINEAR; law <= CUBIC; law++) {
            const double want[] = {oracle_hanging[k].linear,
                                   oracle_hanging[k].log16,
                                   oracle_hanging[k].cubic16};
            struct bar_scene s = bar_scene_notes((enum law)law, 16);
            s.c = oracle_hanging[k].c;
            struct bar_state *state = bar_scene_solve(&s, NULL);
            close_to(state->u[16], want[law], 1e-10);
            bar_state_free(state);
        }
}

/* The relative error of linear elasticity at the oracle's strains and loads. */
static void linear_law_is_wrong_by_the_oracles(void)
{
    const struct newton_control control = {1e-13, 60, 0, 0};
    for (int k = 0; k < 6; k++) {
        const struct material m = material_notes(k / 3 ? CUBIC : LOG);
        const double modulus = material_modulus(&m);
        const double percent = oracle_model_error[k / 3][k % 3].percent;
        const double *number = &oracle_model_error[k / 3][k % 3].strain_t;
        for (int c = 0; c < 4; c++) {
            const double e =
                c < 2 ? number[c]
                      : element_newton(&m, number[c], 1.0, &control).F - 1.0;
            const double P = material1_pk1(&m, 1.0 + e);
            const double ratio = c < 2 ? modulus * e / P : P / (modulus * e);
            close_to(100.0 * fabs(ratio - 1.0), percent, 1e-8);
        }
    }
}

UNIT_MAIN("linear",
    LAW(exact_solution_solves_the_problem),
    LAW(a_free_bar_starts_at_zero),
    LAW(nodal_values_are_exact),
    LAW(hanging_bar_is_the_oracles),
    LAW(linear_law_is_wrong_by_the_oracles))
