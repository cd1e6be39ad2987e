/*
 * seconds.c - the error of the opening against milliseconds: a cut along edges
 * of the mesh, and one whose vertices have been moved onto the blade.
 *
 * The cuts of opening.h.  The time of a cut goes from the blade to the opening:
 * path, moved vertices, new triangles, K, its factors and the solution; the
 * best of 41 runs, and its mean over the cuts.
 */
#include "opening.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

enum { RUNS = 41 };

int main(void)
{
    double truth[OPENING_CUTS];
    openings_truth(truth);
    study_machine();
    table_begin("opening", "n way rms spread flops ms");
    for (int n = 8; n <= 27; n += n / 2)
        for (int moved = 0; moved < 2; moved++) {
            const struct openings all = openings(n, moved, RUNS, truth);
            table_row(n, moved ? "moved" : "edges", all.rms, all.spread,
                      all.flops, 1e3 * all.seconds);
        }
    table_end();
    return table_finish();
}
