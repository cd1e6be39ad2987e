/*
 * poisson_ratio.c - the hanging bar over Poisson's ratio, c = 540, n = 16.
 *
 * Below nu = 0.0712 the cubic law has a largest tension.  Where the weight is
 * beyond it, the branch that starts at rest has no equilibrium, the tangent
 * loses definiteness on the way, and Newton's method that stops there, as
 * Cholesky does, says NOT_SPD.  A bar with nu = 0.05 that is held at both ends
 * and pulled to twice its length at once does find an equilibrium, but not the
 * uniform one.
 */
#include "bar/bar_scene.h"
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

/* The largest P of the cubic law in (1, 4), where there is one; else infinity.
 * P' is a polynomial of degree 4: steps of 1/4096 are fine enough. */
static double limit_load(const struct material *m)
{
    for (double F = 1.0; F < 4.0; F += 1.0 / 4096)
        if (!(material1_dpk1(m, F) > 0.0)) return material1_pk1(m, F);
    return INFINITY;
}

static void print_sweep(void)
{
    static const double nus[] = {0.0, 0.02, 0.05, 0.07,  0.1, 0.2,
                                 0.3, 0.4,  0.45, 0.49, 0.499};
    struct bar_scene scene = bar_scene_notes(CUBIC, 16);
    scene.c = 540.0;

    table_begin("nu_sweep", "nu modulus cubic_status cubic_iterations cubic_u1 "
                            "log_status log_iterations log_u1");
    for (int k = 0; k < COUNT(nus); k++) {
        struct bar_state *s[2];
        for (int l = 0; l < 2; l++) {
            scene.material = material_make(l ? LOG : CUBIC, 1000.0, nus[k]);
            struct newton_control control = bar_scene_control(&scene);
            control.definite = 1;
            s[l] = bar_scene_solve(&scene, &control);
        }
        const enum status a = s[0]->report.status, b = s[1]->report.status;
        table_row(nus[k], material_modulus(&scene.material), status_name(a),
                  cell_if(a == OK, s[0]->report.iterations),
                  cell_if(a == OK, s[0]->u[16]), status_name(b),
                  cell_if(b == OK, s[1]->report.iterations),
                  cell_if(b == OK, s[1]->u[16]));
        bar_state_free(s[0]);
        bar_state_free(s[1]);
        /* the first element carries all of the weight but half its own */
        const struct material cubic = material_make(CUBIC, 1000.0, nus[k]);
        const int carried = 540.0 * (1.0 - 1.0 / 32.0) < limit_load(&cubic);
        claim(a == (carried ? OK : NOT_SPD) && b == OK,
              "nu = %g: NOT_SPD where the limit load %g is passed, the log law "
              "always OK (%s, %s)", nus[k], limit_load(&cubic),
              status_name(a), status_name(b));
    }
    table_end();
}

/* Ten elements, both ends held, the right one moved at once. */
static void print_localised(void)
{
    static const double nu[] = {0.3, 0.05, 0.05}, end[] = {1.0, 1.0, 2.5};
    struct bar_scene scene = bar_scene_notes(CUBIC, 10);
    double spread[3];
    scene.held[1] = 1;

    table_begin("localised", "nu pulled status F_min F_max");
    for (int k = 0; k < 3; k++) {
        double high = -INFINITY;
        scene.material = material_make(CUBIC, 1000.0, nu[k]);
        scene.g[1] = end[k];
        struct bar_state *s = bar_scene_solve(&scene, NULL);
        const double low = bar_min_stretch(&s->bar, s->u);
        for (int e = 1; e <= 10; e++)
            high = fmax(high, bar_stretch(&s->bar, s->u, e));
        table_row(nu[k], end[k], status_name(s->report.status), low, high);
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

int main(void)
{
    print_sweep();
    print_localised();
    return table_finish();
}
