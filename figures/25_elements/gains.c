/*
 * gains.c - how many times fewer flops than linear triangles does another
 * element need for the same error?
 *
 * The scenes of trial.h, and their flops per linear system, of the explicit
 * method those of the whole motion.  Errors: at the vertices that all meshes
 * have, relative; flops at a wanted error are interpolated between the two
 * meshes around it, both logarithmic, or those of the coarsest mesh where that
 * is good enough.  The limit is extrapolated from three meshes of quadratic
 * triangles, as each halving of h leaves the same fraction.
 *
 * Table: the gains, for the errors that linear triangles reach and that are
 * five times what is not known of the limit, `-` where an element does not get
 * there; 0.03 only of the swing, which does not reach the smaller ones.
 */
#include "trial.h"

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { COMPARED = TRIAL_EXPLICIT + 1, TARGETS = 4 };
static const double target[TARGETS] = {0.03, 0.01, 0.003, 0.001};

/* The flops of each element for each target. */
static void run(enum trial_scene scene, const struct work *limit,
                double flops[TARGETS][TRIAL_KINDS])
{
    for (int k = 0; k < TRIAL_KINDS; k++) {
        const struct trial_kind *kind = &trial_kinds[k];
        const int count = trial_meshes(scene, kind->element);
        double error[TRIAL_MESHES], cost[TRIAL_MESHES];
        for (int j = 0; j < count; j++) {
            const int n = trial_coarsest(scene) << j;
            const struct trial trial =
                trial_of(scene, kind->element, n, kind->m);
            error[j] = trial_apart(&trial.end, limit);
            cost[j] = trial.end.flops;
        }
        for (int t = 0; t < TARGETS; t++)
            flops[t][k] = trial_at(target[t], count, error, cost);
    }
}

int main(void)
{
    double floor[COMPARED], flops[COMPARED][TARGETS][TRIAL_KINDS];

    for (enum trial_scene s = TRIAL_WEIGHT; s <= TRIAL_EXPLICIT; s++) {
        const struct work limit = trial_limit(s, &floor[s]);
        run(s, &limit, flops[s]);
    }
    table_begin("gains", "scene error linear graded quadratic both");
    for (enum trial_scene s = TRIAL_WEIGHT; s <= TRIAL_EXPLICIT; s++)
        for (int t = 0; t < TARGETS; t++) {
            const double *of = flops[s][t];
            if (!isfinite(of[TRIAL_EVEN]) || floor[s] > 0.2 * target[t])
                continue;
            if (s < TRIAL_SWING && t == 0) continue;
            struct cell row[6] = {cell_word(trial_name(s)),
                                  cell_number(target[t]),
                                  cell_rounded(3, of[TRIAL_EVEN])};
            for (int k = TRIAL_GRADED; k < TRIAL_KINDS; k++)
                row[2 + k] =
                    isfinite(of[k]) ? cell_rounded(2, of[TRIAL_EVEN] / of[k])
                                    : cell_word(MISSING);
            table_row_of(6, row);
        }
    table_end();
    for (enum trial_scene s = TRIAL_WEIGHT; s <= TRIAL_EXPLICIT; s++) {
        const double *of = flops[s][s < TRIAL_SWING ? 2 : 1];
        /* at 0.3 %, or 1 %; the pull gains 4 times, with n = 4 */
        if (s == TRIAL_PULL) continue;
        if (s == TRIAL_SWING)
            claim(of[TRIAL_QUADRATIC] < 0.8 * of[TRIAL_EVEN] &&
                  flops[s][0][TRIAL_QUADRATIC] > 1.1 * flops[s][0][TRIAL_EVEN],
                  "swing: quadratic triangles gain at 1 %% (%g, %g), but lose "
                  "at 3 %% (%g, %g)", of[TRIAL_EVEN], of[TRIAL_QUADRATIC],
                  flops[s][0][TRIAL_EVEN], flops[s][0][TRIAL_QUADRATIC]);
        if (s < TRIAL_SWING)
            claim(of[TRIAL_EVEN] > 10.0 * of[TRIAL_BOTH], "%s, 0.3 %%: graded "
                  "quadratic triangles need 10 times fewer flops (%g, %g)",
                  trial_name(s), of[TRIAL_EVEN], of[TRIAL_BOTH]);
        else
            claim(of[TRIAL_EVEN] < 2.0 * of[TRIAL_QUADRATIC] &&
                  of[TRIAL_EVEN] < 2.0 * of[TRIAL_BOTH],
                  "%s, 1 %%: hardly anything is gained (%g, %g, %g)",
                  trial_name(s), of[TRIAL_EVEN], of[TRIAL_QUADRATIC],
                  of[TRIAL_BOTH]);
    }
    return table_finish();
}
