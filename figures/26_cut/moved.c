/*
 * moved.c - what does it cost that a cut follows the edges of the mesh?
 *
 * The cuts of opening.h in both ways, which have the same unknowns.  What is
 * missing of the opening, its mean over the cuts and its standard deviation,
 * against the flops to factor K and to solve; the smallest angle is that of the
 * moved meshes.  seconds.c has the milliseconds.
 */
#include "opening.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

int main(void)
{
    double truth[OPENING_CUTS], smallest = 180.0, least = INFINITY, most = 0.0;
    double apart = 0.0;
    int same = 1;
    openings_truth(truth);
    table_begin("opening", "n flops edges edges_spread moved moved_spread "
                           "angle");
    for (int n = 8; n <= 27; n += n / 2) {
        const struct openings edges = openings(n, 0, 1, truth);
        const struct openings moved = openings(n, 1, 1, truth);
        table_row(n, moved.flops, edges.mean, edges.spread, moved.mean,
                  moved.spread, moved.angle);
        same &= edges.flops == moved.flops;
        smallest = fmin(smallest, moved.angle);
        least = fmin(least, edges.spread / moved.spread);
        most = fmax(most, edges.spread / moved.spread);
        apart = fmax(apart, fabs(edges.mean - moved.mean) / moved.spread);
    }
    table_end();
    claim(same, "both ways take the same flops");
    claim(least > 1.5 && most < 2.5, "moved vertices halve the spread of the "
          "opening between blades (%g to %g times)", least, most);
    claim(apart < 1.0, "but of the mean as much is missing (%g)", apart);
    claim(smallest >= OPENING_ANGLE, "no angle falls below the limit (%g)",
          smallest);
    return table_finish();
}
