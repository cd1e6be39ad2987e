/* linear.c - laws of bar_scene.h for the linear bar, and of the hanging one. */
#include "bar/bar_scene.h"

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

UNIT_MAIN("linear",
    LAW(exact_solution_solves_the_problem),
    LAW(a_free_bar_starts_at_zero),
    LAW(hanging_bar_is_the_oracles))
