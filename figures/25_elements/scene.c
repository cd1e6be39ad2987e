/*
 * scene.c - what is wrong with linear triangles near nu = 1/2?
 *
 * The square of lesson 12's study of locking at nu = 0.4999, by linear
 * triangles on a coarse and a fine mesh, and where it hangs: graded quadratic
 * triangles with n = 64.  Tables: the 25 shared vertices with their
 * displacement, along the rows and the columns that they make; and how much of
 * the sag is missing.
 */
#include "hang.h"

#include "base/study.h"
#include "base/table.h"

#include <math.h>

static const char *const word[] = {"coarse", "fine", "limit"};
enum { BODIES = 3, SIDE = 5 };

/* To 1e-6 m: what is 0 but for round-off, which nu amplifies, is 0. */
static struct cell displacement(double u)
{
    return cell_rounded(4, 1e-6 * round(1e6 * u) + 0.0);
}

int main(void)
{
    const double nu = 0.4999;
    const struct hang hang[BODIES] = {hang_of(HANG_LINEAR, 8, 1.0, nu),
                                      hang_of(HANG_LINEAR, 32, 1.0, nu),
                                      hang_of(HANG_QUADRATIC, 64, 3.0, nu)};
    double missing[BODIES];
    table_begin("lines", "body line X Y u_x u_y");
    for (int b = 0; b < BODIES; b++)
        for (int line = 0; line < 2 * SIDE; line++)
            for (int k = 0; k < SIDE; k++) {
                /* a row from left to right, or a column upwards */
                const int i = line < SIDE ? k : line - SIDE;
                const int j = line < SIDE ? line : k;
                const double *u = &hang[b].u[2 * (SIDE * j + i)];
                table_row(word[b], line, -1.0 + 0.5 * i, -1.0 + 0.5 * j,
                          displacement(u[0]), displacement(u[1]));
            }
    table_end();
    table_begin("missing", "body sag missing");
    for (int b = 0; b < BODIES; b++) {
        missing[b] = 1.0 - hang[b].sag / hang[BODIES - 1].sag;
        table_row(word[b], cell_rounded(4, hang[b].sag),
                  cell_rounded(4, missing[b]));
    }
    table_end();
    claim(missing[0] < 0.4 && missing[1] > 0.85 * missing[0],
          "sixteen times as many triangles bring back less than 15 %% of what "
          "is missing (%g, %g)", missing[0], missing[1]);
    return table_finish();
}
