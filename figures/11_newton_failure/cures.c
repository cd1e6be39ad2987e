/*
 * cures.c - how many linear solves does each cure cost, and when does it fail?
 *
 * One element of the log law from rest, 60 sizes x each of a load
 * -p / (2 mu + lambda) and of a push dg / h of the boundary in a bar of ten
 * elements: plain Newton, load stepping, line search, a better start, and the
 * cubic law.
 */
#include "element.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { GRID = 60, ELEMENTS = 10 };

int main(void)
{
    const struct newton_control control = {1e-10, 1000, 0, 0};
    const struct material m = material_notes(LOG);
    int lost[2][N_CURE] = {{0}}, below[2] = {1, 1}, lift = 1;

    for (int moved = 0; moved < 2; moved++) {
        table_begin_note(
            moved ? "step_cures" : "load_cures",
            "x plain plain_iterations stepping stepping_iterations search "
            "search_iterations start start_iterations cubic cubic_iterations "
            "F_cubic", moved ? "x = dg / h" : "x = -p / (2 mu + lambda)");
        for (int i = 0; i < GRID; i++) {
            const double x = pow(10.0, -1.503 + 3.013 * i / (GRID - 1));
            const double p = moved ? 0.0 : -x * material_modulus(&m);
            struct element_report end[N_CURE];
            struct cell row[2 * N_CURE + 2] = {cell_number(x)};
            for (int c = 0; c < N_CURE; c++) {
                end[c] = element_cured((enum cure)c, m, p, moved ? x : 0.0,
                                       ELEMENTS, control);
                row[2 * c + 1] = cell_word(status_name(end[c].status));
                row[2 * c + 2] = cell_number(end[c].iterations);
                lost[moved][c] += end[c].status != OK;
            }
            row[2 * N_CURE + 1] =
                cell_if(end[CURE_CUBIC].status == OK, end[CURE_CUBIC].F);
            table_row_of(2 * N_CURE + 2, row);
            below[moved] &= (end[CURE_PLAIN].status == OK) == (x < 1.0);
            if (moved)
                lift &= (end[CURE_START].status == OK) == (x < ELEMENTS);
        }
        table_end();
    }

    claim(below[0] && below[1], "plain Newton converges for x < 1 and nowhere "
          "else, under a load and for a push");
    claim(lost[0][CURE_STEPPING] + lost[0][CURE_SEARCH] + lost[0][CURE_START] +
              lost[0][CURE_CUBIC] == 0,
          "under a load no cure fails");
    claim(lost[1][CURE_STEPPING] == 0 && lost[1][CURE_CUBIC] == 0,
          "for a push load stepping and the cubic law never fail");
    claim(lost[1][CURE_SEARCH] == lost[1][CURE_PLAIN] && lift,
          "for a push the line search fails with plain Newton, and the linear "
          "lift at dg = 1, the length of the bar");
    return table_finish();
}
