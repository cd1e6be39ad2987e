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
 * Tables: all runs, `-` for an error where the body inverts; how well the limit
 * is known; and the gains, for the errors that linear triangles reach and that
 * are five times what is not known of the limit, `-` where an element does not
 * get there.
 */
#include "trial.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum { PLAIN_LINEAR, GRADED, QUADRATIC, BOTH, KINDS };
enum { SCENES = EXPLICIT + 1, MESHES = 6, TARGETS = 3 };
static const double target[TARGETS] = {0.01, 0.003, 0.001};
static const struct {
    const char *name;
    enum element element;
    double m;
} kind[KINDS] = {{"linear", LINEAR_TRIANGLE, 1.0},
                 {"linear", LINEAR_TRIANGLE, 1.5},
                 {"quadratic", QUADRATIC_TRIANGLE, 1.0},
                 {"quadratic", QUADRATIC_TRIANGLE, 2.0}};

/* Meshes: the coarsest and so many halvings of h, of both degrees; the finest
 * of the limit, and how it is graded. */
static const struct {
    int linear, quadratic, limit_n;
    double limit_m;
} extent[SCENES] = {
    [WEIGHT] = {6, 4, 64, 2.0}, [PULL] = {4, 3, 32, 2.0},
    [COLUMN] = {6, 3, 64, 2.0}, [SHAKE] = {5, 3, 32, 1.5},
    [SWING] = {5, 3, 64, 1.0},  [EXPLICIT] = {4, 3, 48, 1.0},
};

/* u := u + s (u - before) */
static void correct(struct trial *u, double s, const struct trial *before)
{
    for (int r = 0; r < u->n_shared; r++)
        u->u[r] += s * (u->u[r] - before->u[r]);
}

static struct trial limit_of(enum trial_scene scene, double *floor)
{
    struct trial run[3];
    for (int k = 0; k < 3; k++)
        run[k] = trial_of(scene, QUADRATIC_TRIANGLE,
                          extent[scene].limit_n / (4 >> k),
                          extent[scene].limit_m);
    const double ratio =
        trial_apart(&run[0], &run[1]) / trial_apart(&run[1], &run[2]);
    if (!(ratio > 1.5)) die("%s has no limit", trial_name(scene));
    correct(&run[2], 1.0 / (ratio - 1.0), &run[1]);
    correct(&run[1], 1.0 / (ratio - 1.0), &run[0]);
    *floor = trial_apart(&run[1], &run[2]) / ratio;
    return run[2];
}

/* INFINITY where the finest mesh has a larger error. */
static double flops_for(double wanted, int count, const double error[],
                        const double flops[])
{
    if (error[0] <= wanted) return flops[0];
    for (int k = 1; k < count; k++)
        if (error[k] <= wanted)
            return flops[k] * pow(wanted / error[k],
                                  log(flops[k - 1] / flops[k]) /
                                      log(error[k - 1] / error[k]));
    return INFINITY;
}

/* Rows of all runs of a scene; flops of each element for each target. */
static void run(enum trial_scene scene, const struct trial *limit,
                double flops[TARGETS][KINDS])
{
    for (int k = 0; k < KINDS; k++) {
        const int linear = kind[k].element == LINEAR_TRIANGLE;
        const int count =
            linear ? extent[scene].linear : extent[scene].quadratic;
        double error[MESHES], cost[MESHES];
        for (int j = 0; j < count; j++) {
            const int n = trial_coarsest(scene) << j;
            const struct trial trial =
                trial_of(scene, kind[k].element, n, kind[k].m);
            error[j] = trial_apart(&trial, limit);
            cost[j] = trial.flops;
            table_row(trial_name(scene), kind[k].name, kind[k].m, n,
                      trial.unknowns,
                      isfinite(error[j]) ? cell_rounded(3, error[j])
                                         : cell_word(MISSING),
                      cost[j]);
        }
        for (int t = 0; t < TARGETS; t++)
            flops[t][k] = flops_for(target[t], count, error, cost);
    }
}

int main(void)
{
    double floor[SCENES], flops[SCENES][TARGETS][KINDS];

    table_begin("runs", "scene element m n unknowns error flops");
    for (enum trial_scene s = WEIGHT; s <= EXPLICIT; s++) {
        const struct trial limit = limit_of(s, &floor[s]);
        run(s, &limit, flops[s]);
    }
    table_end();
    table_begin("limits", "scene n m unknown");
    for (enum trial_scene s = WEIGHT; s <= EXPLICIT; s++)
        table_row(trial_name(s), extent[s].limit_n, extent[s].limit_m,
                  cell_rounded(2, floor[s]));
    table_end();
    table_begin("gains", "scene error linear graded quadratic both");
    for (enum trial_scene s = WEIGHT; s <= EXPLICIT; s++)
        for (int t = 0; t < TARGETS; t++) {
            const double *of = flops[s][t];
            if (!isfinite(of[PLAIN_LINEAR]) || floor[s] > 0.2 * target[t])
                continue;
            struct cell row[6] = {cell_word(trial_name(s)),
                                  cell_number(target[t]),
                                  cell_rounded(3, of[PLAIN_LINEAR])};
            for (int k = GRADED; k <= BOTH; k++)
                row[2 + k] =
                    isfinite(of[k]) ? cell_rounded(2, of[PLAIN_LINEAR] / of[k])
                                    : cell_word(MISSING);
            table_row_of(6, row);
        }
    table_end();
    for (enum trial_scene s = WEIGHT; s <= EXPLICIT; s++) {
        const double *of = flops[s][s < SWING]; /* 0.3 %, or 1 % */
        if (s == PULL) continue;                /* 4 times, with n = 4 */
        if (s < SWING)
            claim(of[PLAIN_LINEAR] > 10.0 * of[BOTH], "%s, 0.3 %%: graded "
                  "quadratic triangles need 10 times fewer flops (%g, %g)",
                  trial_name(s), of[PLAIN_LINEAR], of[BOTH]);
        else
            claim(of[PLAIN_LINEAR] < 2.0 * of[QUADRATIC] &&
                  of[PLAIN_LINEAR] < 2.0 * of[BOTH],
                  "%s, 1 %%: hardly anything is gained (%g, %g, %g)",
                  trial_name(s), of[PLAIN_LINEAR], of[QUADRATIC], of[BOTH]);
    }
    return table_finish();
}
