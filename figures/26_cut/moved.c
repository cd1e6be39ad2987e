/*
 * moved.c - what does it cost that a cut follows the edges of the mesh?
 *
 * The cuts of opening.h in both ways, which have the same unknowns.  The table
 * has the missing fraction of the opening against the flops to factor K and to
 * solve.  Its root mean square over the cuts is the error, which consists of
 * the mean and of the standard deviation.  The smallest angle is that of the
 * moved meshes.  seconds.c has the milliseconds.
 */
#include "opening.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

int main(void)
{
    double truth[OPENING_CUTS], smallest = 180.0;
    double spread[2] = {INFINITY, 0.0}, mean[2] = {INFINITY, 0.0};
    double change = 0.0;
    int same = 1;
    openings_truth(truth);
    table_begin("opening", "n flops edges edges_spread edges_rms moved "
                           "moved_spread moved_rms angle");
    for (int n = 8; n <= 27; n += n / 2) {
        const struct openings edges = openings(n, 0, 1, truth);
        const struct openings moved = openings(n, 1, 1, truth);
        table_row(n, moved.flops, edges.mean, edges.spread, edges.rms,
                  moved.mean, moved.spread, moved.rms, moved.angle);
        same &= edges.flops == moved.flops;
        smallest = fmin(smallest, moved.angle);
        spread[0] = fmin(spread[0], moved.spread / edges.spread);
        spread[1] = fmax(spread[1], moved.spread / edges.spread);
        mean[0] = fmin(mean[0], moved.mean / edges.mean);
        mean[1] = fmax(mean[1], moved.mean / edges.mean);
        change = fmax(change, fabs(moved.rms / edges.rms - 1.0));
    }
    table_end();
    table_begin("more", "least most");
    table_row(mean[0] - 1.0, mean[1] - 1.0);
    table_end();
    claim(same, "both ways take the same flops");
    claim(spread[0] > 0.4 && spread[1] < 0.6, "moved vertices halve the "
          "spread of the opening between blades (%g to %g times)", spread[0],
          spread[1]);
    claim(mean[0] > 1.1 && mean[1] < 1.35, "but on average 10 to 35 per cent "
          "more is missing (%g to %g times)", mean[0], mean[1]);
    claim(change < 0.15, "so the root mean square changes by less than 15 per "
          "cent (%g)", change);
    claim(smallest >= OPENING_ANGLE, "no angle falls below the limit (%g)",
          smallest);
    return table_finish();
}
