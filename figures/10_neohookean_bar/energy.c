/*
 * energy.c - Newton's method looks for q = 0, not for less energy.
 *
 * A standing bar, cubic law, 16 elements, c = -4000, from rest: the first full
 * step raises the energy and turns elements inside out.  With the line search
 * of bar_newton() the energy falls in every step [alg:line-search].
 */
#include "bar/bar_scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

int main(void)
{
    enum { CAP = 40 };
    static const char *const name[2] = {"full", "search"};
    struct bar_scene scene = bar_scene_notes(CUBIC, 16);
    struct newton_step history[CAP + 1];
    scene.c = -4000.0;

    table_begin("energy", "steps k energy length min_F");
    for (int search = 0; search < 2; search++) {
        struct newton_control control = bar_scene_control(&scene);
        control.max_iterations = CAP;
        control.line_search = search;
        struct bar_state *s = bar_state_alloc(&scene);
        s->report = bar_newton(&s->bar, &control, s->u, history);
        int rose = 0;
        for (int k = 0; k <= s->report.iterations; k++) {
            const struct newton_step *step = &history[k];
            table_row(name[search], k, step->energy,
                      cell_if(k < s->report.iterations, step->length),
                      step->min_F);
            if (k == 0) continue;
            const double before = history[k - 1].energy;
            rose |= step->energy > before + 1e-12 * fabs(before);
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
    return table_finish();
}
