/* bars.c - laws of common/bar_scene.h, bar_gsl.h, and of how Newton's
 * method of bar.h treats a tangent that is not positive definite. */
#include "bar_gsl.h"
#include "bar_scene.h"

#include "../oracle/10_neohookean_bar.h"
#include "unit.h"

#include <math.h>
#include <stdlib.h>

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
        struct bar_state *s = bar_state_alloc(&scene);
        for (int i = 0; i <= 7; i++) sum += s->b[i];
        close_to(sum, 238.5 + scene.pull[0] + scene.pull[1], 1e-10);
        for (int i = 0; i <= 7; i++)
            close_to(s->u[i], i == 0 && scene.held[0]   ? 0.1
                              : i == 7 && scene.held[1] ? 1.1
                                                        : 0.0, 1e-16);
        close_to(s->bar.h, 1.0 / 7.0, 1e-16);
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
    ck_assert(isnan(history[1].energy) && isnan(history[1].min_dP));
    bar_state_free(s);

    control.line_search = 1; /* has it in 7 */
    s = bar_state_alloc(&scene);
    s->report = bar_newton(&s->bar, &control, s->u, history);
    ck_assert_int_eq(s->report.status, OK);
    ck_assert_int_le(abs(s->report.iterations - 7), 1);
    close_to(bar_state_reaction(s), 2000.0, 1e-8);
    bar_state_free(s);
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
    ck_assert_int_eq(bar_gsl_newton(&s->bar, &control, s->u).status,
                     MAX_ITERATIONS);
    bar_state_free(s);
}

static const struct unit_law laws[] = {
    {"other_loads_are_the_oracles", other_loads_are_the_oracles},
    {"a_scene_starts_as_it_says", a_scene_starts_as_it_says},
    {"indefinite_is_solved_or_refused", indefinite_is_solved_or_refused},
    {"history_has_the_failed_state", history_has_the_failed_state},
    {"gsl_newton_is_newton", gsl_newton_is_newton},
};
UNIT_MAIN("bars", laws)
