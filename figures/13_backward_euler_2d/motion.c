/*
 * motion.c - a free square that ought to spin for ever.
 *
 * The scene `spin` (6 rad/s, (0.2, 0.1) m/s), n = 4, cubic law, 45 steps of
 * backward Euler with dt = 1/30.  Table: its triangles after every step.
 */
#include "corners.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

static void print_triangles(const struct scene *s)
{
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        double x[6];
        const double J = corners_of(s, e, x);
        table_row("spin", s->steps * s->set.dt, J, x[0], x[1], x[2], x[3], x[4],
                  x[5]);
    }
}

int main(void)
{
    const struct step_control newton = step_method("notes");
    const struct scene_setting set = scene_notes(SPIN, CUBIC, 4);
    struct scene *s = scene_alloc(&set);
    const struct scene_measures start = scene_measure(s);
    double left = 1.0;

    gsl_set_error_handler_off();
    table_begin("motion", "scene t J x0 y0 x1 y1 x2 y2");
    print_triangles(s);
    while (s->steps < 45) {
        if (scene_step(s, &newton).status != OK) die("the spin fails");
        print_triangles(s);
        if (s->steps == 30) left = scene_measure(s).angular / start.angular;
    }
    table_end();
    scene_free(s);

    claim(fabs(left - 0.55) < 0.01,
          "nearly half of the spin is gone after one second, %g is left", left);
    return table_finish();
}
