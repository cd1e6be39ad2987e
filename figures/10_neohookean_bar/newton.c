/*
 * newton.c - what does Newton's method see, and what does it do?
 *
 * A standing bar, 12 elements, cubic law, c = -1300: after each step what the
 * method sees (residual, increment, energy) and what it does not, the largest
 * error of F.  One end is free, so each element has a Newton iteration of its
 * own, and the error over the square of the error before tends to |P'' / 2 P'|
 * of the element with the largest error [eq:newton].  Where round-off governs,
 * errors below 1e-10, there is no ratio, and the table ends.
 */
#include "bar/bar_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

static double second_derivative(const struct material *m, double F)
{
    const double d = 1e-5;
    return (material1_dpk1(m, F + d) - material1_dpk1(m, F - d)) / (2.0 * d);
}

static void print_elements(const struct bar *bar, const double u[])
{
    table_begin("elements", "X F P");
    for (int e = 1; e <= bar->n; e++) {
        const double F = bar_stretch(bar, u, e);
        table_row((e - 0.5) * bar->h, F, material1_pk1(&bar->material, F));
    }
    table_end();
}

int main(void)
{
    enum { CLEAN = 10 }; /* digits */
    const double round_off = pow(10.0, -CLEAN);
    struct bar_scene scene = bar_scene_notes(CUBIC, 12);
    scene.c = -1300.0;
    struct newton_control control = bar_scene_control(&scene);
    struct bar_state *limit = bar_scene_solve(&scene, NULL);
    const struct material *material = &scene.material;
    double before = 0.0, ratio = 0.0, predicted = 0.0, residual[2] = {0.0};

    if (limit->report.status != OK) die("the standing bar has no solution");
    print_elements(&limit->bar, limit->u);
    table_begin("newton", "k residual increment energy error ratio predicted");
    for (int k = 0; k <= limit->report.iterations; k++) {
        control.max_iterations = k;
        struct bar_state *s = bar_scene_solve(&scene, &control);
        double energy, error = 0.0, constant = 0.0;
        bar_energy(&s->bar, s->u, &energy);
        for (int e = 1; e <= scene.n; e++) {
            const double F = bar_stretch(&limit->bar, limit->u, e);
            const double off = fabs(bar_stretch(&s->bar, s->u, e) - F);
            if (off < error) continue;
            error = off;
            constant = fabs(0.5 * second_derivative(material, F) /
                            material1_dpk1(material, F));
        }
        const int clean = k > 0 && error > round_off;
        if (clean) {
            ratio = error / (before * before);
            predicted = constant;
        }
        if (k < 2) residual[k] = s->report.residual;
        table_row(k, s->report.residual, cell_if(k > 0, s->report.increment),
                  energy, error, cell_if(clean, ratio),
                  cell_if(clean, predicted));
        before = error;
        bar_state_free(s);
        if (error <= round_off) break;
    }
    table_end();
    bar_state_free(limit);

    claim(residual[1] > 2.0 * residual[0],
          "the first step makes the residual larger (%g N, then %g N)",
          residual[0], residual[1]);
    /* the error before the last of them is 2e-4: so large is the next term */
    claim(fabs(ratio / predicted - 1.0) < 1e-3,
          "error over the square of the error before is |P''/2P'| = %g in the "
          "end (it is %g)", predicted, ratio);
    return table_finish();
}
