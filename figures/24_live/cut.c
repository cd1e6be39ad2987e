/*
 * cut.c - a strip of tissue is cut while a hand pulls at it: what does the hand
 * feel, and where does the energy go?
 *
 * The strip of strip.h, 40 x 12 cells, is pulled by up to 15 mm, whole and cut
 * to half of its height; and the whole one is cut at full pull.  Tables: pull
 * (the force in the hand), cut (at full pull: the forces, the opening, the
 * linear systems from the whole one's state, the energy of the whole one, what
 * the cut releases, and the work that it saves the hand, by Simpson's rule),
 * cells (the corners at full pull, in micrometres).
 */
#include "motion/live.h"
#include "strip.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { PULLS = 8 };
static const double FULL = 0.015; /* m */

static void print_cells(const struct strip *s, const char *name)
{
    for (int k = 0; k < s->n * s->rows; k++) { /* row by row, upwards */
        const int below = s->rows - 1 - k / s->n;
        const int *t = &s->s.mesh->triangle[6 * (k % s->n * s->rows + below)];
        const int corner[4] = {2 * t[1], 2 * t[2], 2 * t[5], 2 * t[0]};
        struct cell x[9] = {cell_word(name)};
        for (int a = 0; a < 4; a++)
            for (int i = 0; i < 2; i++)
                x[1 + 2 * a + i] = cell_number(
                    (double)lrint(1e6 * (s->s.mesh->X[corner[a] + i] +
                                         s->s.u[corner[a] + i])));
        table_row_of(9, x);
    }
}

int main(void)
{
    struct strip whole = strip_alloc(40, 0), cut = strip_alloc(40, 6);
    double work = 0.0;
    gsl_set_error_handler_off();

    table_begin("pull", "d whole cut");
    /* one index: the weights of Simpson's rule are 1 4 2 4 ... 2 4 1 */
    for (int k = 0; k <= PULLS; k++) {
        const double weight = k == 0 || k == PULLS ? 1.0 : k % 2 ? 4.0 : 2.0;
        strip_pull(&whole, FULL * k / PULLS);
        strip_pull(&cut, FULL * k / PULLS);
        table_row(FULL * k / PULLS, cell_rounded(6, whole.force),
                  cell_rounded(6, cut.force));
        work += weight * FULL / PULLS / 3.0 * (whole.force - cut.force);
    }
    table_end();
    const double released = whole.energy - cut.energy, before = cut.force;
    const int systems = strip_cut(&whole, &cut);
    table_begin("cut", "whole cut opening systems energy released work");
    table_row(cell_rounded(6, whole.force), cell_rounded(6, cut.force),
              cell_rounded(6, cut.opening), systems,
              cell_rounded(6, whole.energy), cell_rounded(6, released),
              cell_rounded(6, work));
    table_end();
    table_begin("cells", "strip x0 y0 x1 y1 x2 y2 x3 y3");
    print_cells(&whole, "whole");
    print_cells(&cut, "cut");
    table_end();

    claim(fabs(work / released - 1.0) < 1e-4, "the energy that the cut "
          "releases is the work that it saves the hand (%g, %g J)", released,
          work);
    claim(fabs(cut.force / before - 1.0) < 1e-6 && systems <= FRAME_SYSTEMS,
          "cut while pulled or before, the strip is the same, after %d systems",
          systems);
    strip_free(&whole);
    strip_free(&cut);
    return table_finish();
}
