/*
 * finds.c - Newton's method looks for q = 0, not for less energy, nor for the
 * equilibrium that one has in mind.
 *
 * Bars of the cubic law, from rest.  Tables: energy, 16 elements, c = -4000:
 * the first full step raises the energy and turns elements inside out; with the
 * line search of bar_newton() the energy falls in every step [alg:line-search].
 * localised, ten elements held at both ends and pulled at once: at nu = 0.05
 * and to twice its length the bar does find an equilibrium, but not the uniform
 * one.  Below nu = 0.0712 the law has a largest tension, too: where the weight
 * (c = 540) is beyond it the branch from rest has no equilibrium, and the
 * method that stops where K loses definiteness says NOT_SPD.
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static void print_energy(void)
{
    enum { CAP = 40 };
    static const char *const name[2] = {"full", "search"};
    struct bar_scene scene = bar_scene_notes(CUBIC, 16);
    struct newton_step history[CAP + 1];
    scene.c = -4000.0;

    table_begin("energy", "steps k energy min_F");
    for (int search = 0; search < 2; search++) {
        struct newton_control control = bar_scene_control(&scene);
        control.max_iterations = CAP;
        control.line_search = search;
        struct bar_state *s = bar_state_alloc(&scene);
        s->report = bar_newton(&s->bar, &control, s->u, history);
        int rose = 0;
        for (int k = 0; k <= s->report.iterations; k++) {
            const double energy = history[k].energy;
            table_row(name[search], k, energy, history[k].min_F);
            if (k == 0) continue;
            const double before = history[k - 1].energy;
            rose |= energy > before + 1e-12 * fabs(before);
        }
        claim(s->report.status == OK, "%s steps find the equilibrium",
              name[search]);
        claim(rose == !search, "full steps raise the energy, those of the "
              "line search never (%s)", name[search]);
        claim(search || (history[1].energy > 1e4 && history[1].min_F < -1.0),
              "the first full step raises the energy to more than 10 kJ and "
              "turns an element inside out (%g J, F = %g)", history[1].energy,
              history[1].min_F);
        bar_state_free(s);
    }
    table_end();
}

static void print_localised(void)
{
    static const double nu[] = {0.3, 0.05, 0.05}, end[] = {1.0, 1.0, 2.5};
    struct bar_scene scene = bar_scene_notes(CUBIC, 10);
    double spread[3];
    scene.held[1] = 1;

    table_begin("localised", "nu pulled F_min F_max");
    for (int k = 0; k < 3; k++) {
        double high = -INFINITY;
        scene.material = material_make(CUBIC, 1000.0, nu[k]);
        scene.g[1] = end[k];
        struct bar_state *s = bar_scene_solve(&scene, NULL);
        const double low = bar_min_stretch(&s->bar, s->u);
        for (int e = 1; e <= 10; e++)
            high = fmax(high, bar_stretch(&s->bar, s->u, e));
        table_row(nu[k], end[k], low, high);
        claim(s->report.status == OK, "nu = %g, pulled by %g: an equilibrium",
              nu[k], end[k]);
        spread[k] = high - low;
        bar_state_free(s);
    }
    table_end();
    claim(spread[0] < 1e-10 && spread[1] > 1.0 && spread[2] < 1e-10,
          "only nu = 0.05 pulled by 1 is not uniform (F differs by %g, %g, %g)",
          spread[0], spread[1], spread[2]);
}

/* The largest P of the cubic law in (1, 4), where there is one; else infinity.
 * P' is a polynomial of degree 4: steps of 1/4096 are fine enough. */
static double limit_load(const struct material *m)
{
    for (double F = 1.0; F < 4.0; F += 1.0 / 4096)
        if (!(material1_dpk1(m, F) > 0.0)) return material1_pk1(m, F);
    return INFINITY;
}

static void claim_limit(void)
{
    static const double nu[] = {0.0, 0.02, 0.05, 0.07,  0.1, 0.2,
                                0.3, 0.4,  0.45, 0.49, 0.499};
    struct bar_scene scene = bar_scene_notes(CUBIC, 16);
    scene.c = 540.0;
    for (int k = 0; k < COUNT(nu); k++)
        for (int l = 0; l < 2; l++) {
            scene.material = material_make(l ? LOG : CUBIC, 1000.0, nu[k]);
            struct newton_control control = bar_scene_control(&scene);
            control.definite = 1;
            struct bar_state *s = bar_scene_solve(&scene, &control);
            /* the first element carries all of the weight but half its own */
            const int carried = l || 540.0 * (1.0 - 1.0 / 32.0) <
                                         limit_load(&scene.material);
            claim(s->report.status == (carried ? OK : NOT_SPD),
                  "nu = %g: NOT_SPD where the limit load of the cubic law is "
                  "passed, the log law always OK (%s)", nu[k],
                  status_name(s->report.status));
            bar_state_free(s);
        }
}

int main(void)
{
    print_energy();
    print_localised();
    claim_limit();
    return table_finish();
}
