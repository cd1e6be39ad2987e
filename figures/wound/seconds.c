/*
 * seconds.c - how many milliseconds does a frame of the wound take?
 *
 * The frames of wound.c, without the picture, for a slow hand at rest and for a
 * quick one by four steps of BDF2: of each frame the best of RUNS runs, and of
 * these the median and the longest.
 */
int wound_main(void);
#define main wound_main
#include "wound.c"
#undef main

#include "../robustness/reason.h"
#include "../study/study.h"
#include "base/table.h"
#include "linear/sparse.h"
#include "motion/integrate.h"
#include "plane/quadratic.h"

enum { RUNS = 9 };

int main(void)
{
    static const struct way way[] = {{"rest", 0, BACKWARD_EULER},
                                     {"bdf2", 4, BDF2}};
    static const int r[] = {3, 4, 8, 16};
    study_machine();
    table_begin_note("frames", "hand way r systems median longest",
                     "systems per frame; ms");
    for (int h = 0; h < 2; h++)
        for (int m = 0; m < 4; m++) {
            struct times best = {0};
            struct motion motion[RUNS];
            for (int k = 0; k < RUNS; k++)
                motion[k] = move(r[m], way[h], h ? 0.1 : 0.5);
            for (int f = 0; f < FRAMES; f++) {
                double least = INFINITY;
                for (int k = 0; k < RUNS; k++)
                    least = fmin(least, motion[k].seconds[f]);
                times_record(&best, 1e3 * least, 1);
            }
            table_row(h ? "quick" : "slow", way[h].name, r[m],
                      motion[0].systems, times_median(&best),
                      times_quantile(&best, 1.0));
        }
    table_end();
    return table_finish();
}
