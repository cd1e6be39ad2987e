/*
 * certificate.c - how much of the stable does the bound [eq:compression] find,
 * and does it ever call stable what is not?
 *
 * Columns that are pressed more and more: the largest load that the bound
 * passes, over the largest at which K is positive definite on cells of a
 * quarter of the size, both by bisection.  Then random scenes, loads along the
 * axis and across, up to twice a column's buckling load, on three meshes.
 */
#include "compression.h"
#include "choice/rung.h"
#include "drawn.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { SCENES = 1000, LEVELS = 3 };

/* Of the bar's answer on a mesh: the bound's verdict, and that of K. */
static void ask(const struct ladder_scene *scene, int level, int *bound,
                int *stable)
{
    struct ladder_state *s =
        ladder_solve(scene, (struct ladder_model){BAR, 0, level});
    double flops;
    *bound = compression_certifies(s, &flops);
    *stable = ladder_stable(s);
    ladder_free(s);
}

/* The largest load that passes: by the bound, or by K on a mesh. */
static double largest(struct ladder_scene scene, int level, int by_bound)
{
    double low = 0.0, high = 1.5 * ladder_buckles(&scene) * scene.slender;
    for (int k = 0; k < 30; k++) {
        int bound, stable;
        scene.pull[0] = -0.5 * (low + high);
        ask(&scene, level, &bound, &stable);
        if (by_bound ? bound : stable)
            low = -scene.pull[0];
        else
            high = -scene.pull[0];
    }
    return low;
}

int main(void)
{
    double least = INFINITY, most = 0.0;
    int wrong = 0, passed = 0, sound = 0;
    gsl_set_error_handler_off();
    for (int slender = 1; slender <= 8; slender *= 2)
        for (int k = 0; k < 3; k++) {
            const struct ladder_scene scene = {
                .name = "pressed", .slender = slender,
                .nu = (const double[]){0.0, 0.3, 0.45}[k], .finest = 2};
            const double bound = largest(scene, 0, 1);
            const double fine = largest(scene, 2, 0);
            least = fmin(least, bound / fine);
            most = fmax(most, bound / fine);
        }
    table_begin("scatter", "level scenes stable bound");
    for (int level = 0; level < LEVELS; level++) {
        gsl_rng *random = drawn_start(23);
        int n_stable = 0, n_bound = 0, n_wrong = 0;
        for (int k = 0; k < SCENES; k++) {
            const struct ladder_scene scene = drawn_squares(random, 2.0, 3.0);
            int bound, stable;
            ask(&scene, level, &bound, &stable);
            n_stable += stable;
            n_bound += bound;
            n_wrong += bound && !stable;
        }
        gsl_rng_free(random);
        table_row(level, SCENES, n_stable, n_bound);
        wrong += n_wrong;
        passed += n_bound;
        sound += n_stable;
    }
    table_end();
    claim(wrong == 0 && most < 1.0, "the bound passes nothing unstable (%d "
          "scenes, at most %g of the load)", wrong, most);
    claim(least > 0.04 && 3 * passed > 2 * sound, "and it passes %g of a "
          "column's load or more, %d of %d stable scenes", least, passed,
          sound);
    return table_finish();
}
