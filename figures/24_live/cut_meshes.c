/*
 * cut_meshes.c - how far does a cut open, on finer and finer meshes?
 *
 * The strip of strip.h, pulled by 15 mm and cut to half of its height.  At the
 * tip the strain is singular, with 1 / sqrt(r), so that energy and opening
 * converge with the order 1 in the end.  Table: the force in the hand before
 * and after (N), the opening (m), its order from three meshes, and the linear
 * systems.
 */
#include "strip.h"
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

int main(void)
{
    const int n[] = {20, 40, 80, 160};
    double opening[COUNT(n)], order = 0.0;
    gsl_set_error_handler_off();

    table_begin("meshes", "n whole cut opening order systems");
    for (int k = 0; k < COUNT(n); k++) {
        const int rows = 3 * n[k] / 10;
        struct strip whole = strip_alloc(n[k], rows);
        struct strip cut = strip_alloc(n[k], rows / 2);
        strip_pull(&whole, 0.0075);
        strip_pull(&whole, 0.015);
        const int systems = strip_cut(&whole, &cut);
        opening[k] = cut.opening;
        if (k >= 2)
            order = study_order(opening[k - 1] - opening[k - 2],
                                opening[k] - opening[k - 1], 2.0);
        const struct cell found =
            k < 2 ? cell_word(MISSING) : cell_rounded(3, order);
        table_row(n[k], cell_rounded(6, whole.force),
                  cell_rounded(6, cut.force), cell_rounded(6, cut.opening),
                  found, systems);
        strip_free(&whole);
        strip_free(&cut);
    }
    table_end();
    claim(fabs(order - 1.0) < 0.2, "the opening converges with an order that "
          "goes to 1 (%g)", order);
    return table_finish();
}
