/*
 * sag.c - which elements do not lock, and what do they say about the volume?
 *
 * The square of lesson 12's study of locking, at three of Poisson's ratios.
 * Table: how much of the sag of (1, 0) is missing, against graded quadratic
 * triangles with n = 64; and the size of div u, of that of the limit.
 */
#include "hang.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

static const char *const word[] = HANG_WORDS;
static const double nu[] = {0.3, 0.49, 0.4999};
static const struct {
    enum hang_element element;
    double m;
} kind[] = {{HANG_LINEAR, 1.0}, {HANG_LINEAR, 1.5}, {HANG_AVERAGED, 1.0},
            {HANG_CROSSED, 1.0}, {HANG_QUADRATIC, 1.0}, {HANG_QUADRATIC, 2.0}};
enum { RATIOS = COUNT(nu), KINDS = COUNT(kind) };

int main(void)
{
    struct hang limit[RATIOS];
    double missing[KINDS][RATIOS], div[KINDS][RATIOS];

    for (int r = 0; r < RATIOS; r++)
        limit[r] = hang_of(HANG_QUADRATIC, 64, 3.0, nu[r]);
    table_begin("sag", "element m n missing_0.3 missing_0.49 missing_0.4999 "
                       "div_0.3 div_0.49 div_0.4999");
    for (int k = 0; k < KINDS; k++)
        for (int n = 8; n <= 32; n *= 2) {
            for (int r = 0; r < RATIOS; r++) {
                const struct hang hang =
                    hang_of(kind[k].element, n, kind[k].m, nu[r]);
                missing[k][r] = 1.0 - hang.sag / limit[r].sag;
                div[k][r] = hang.div / limit[r].div;
            }
            /* differences, of which the condition of K takes digits */
            struct cell row[9] = {cell_word(word[kind[k].element]),
                                  cell_number(kind[k].m), cell_number(n)};
            for (int r = 0; r < RATIOS; r++) {
                row[3 + r] = cell_rounded(4, missing[k][r]);
                row[6 + r] = cell_rounded(4, div[k][r]);
            }
            table_row_of(9, row);
        }
    table_end();
    table_begin("limit", "nu sag");
    for (int r = 0; r < RATIOS; r++)
        table_row(nu[r], cell_rounded(6, limit[r].sag));
    table_end();
    claim(missing[0][2] > 0.3 && missing[1][2] > 0.3,
          "n = 32, nu = 0.4999: linear triangles lack a third, graded or not "
          "(%g, %g)", missing[0][2], missing[1][2]);
    claim(missing[2][2] < 0.02 && missing[3][2] < 0.02,
          "averaged and criss-cross triangles lack less than 2 %% (%g, %g)",
          missing[2][2], missing[3][2]);
    claim(missing[4][2] < 0.01 && missing[5][2] < 0.002,
          "quadratic, and graded quadratic lack less than 1, 0.2 %% (%g, %g)",
          missing[4][2], missing[5][2]);
    claim(div[2][2] > 50.0 && div[3][2] < 5.0 && div[4][2] < 2.0,
          "div u per triangle is a multiple of its size when it is averaged "
          "(%g), and is not of criss-cross and quadratic triangles (%g, %g)",
          div[2][2], div[3][2], div[4][2]);
    return table_finish();
}
