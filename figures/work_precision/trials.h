/*
 * trials.h - all settings of work.h for one scene, and which of them is the
 * cheapest for an error.
 *
 * First linear triangles, even.  Static: every law, three meshes (1, 2, 4 times
 * the coarsest), 1 or 8 load steps.  Dynamic: every law, the three meshes, 4,
 * 8, ... steps, and every method of integrate.h.  Newton's tolerance is 1e-2 or
 * 1e-5 m.
 *
 * Then three other elements: linear triangles, graded by 1.5, and quadratic
 * ones, even and graded by 2, with a mesh more; LINEAR and LOG; static, by the
 * midpoint rule and by symplectic Euler; 1e-5 m.
 *
 * Errors are relative to the size of the limit of LOG, dynamic.
 */
#ifndef FIGURES_TRIALS_H
#define FIGURES_TRIALS_H

#include "work.h"

enum { TRIALS_MOST = 500 };
struct trials {
    enum work_scene scene;
    struct work limit;
    double size, floor; /* of the limit (m); what is not known of it, rel. */
    int count; /* of linear triangles, even */
    int all;   /* with the other elements, which come after them */
    struct work_setting set[TRIALS_MOST];
    struct work work[TRIALS_MOST];
    double error[TRIALS_MOST]; /* INFINITY where the run has failed */
};

/* All runs, or without `others` those with linear triangles, even, alone: all =
 * count.  The caller frees it. */
struct trials *trials_alloc(enum work_scene scene, int others);
void trials_free(struct trials *sweep);

/* Of the first `count` settings the one with the fewest flops among those with
 * at most this error, of those that cost the same the one with the smallest
 * error, or -1. */
int trials_cheapest(const struct trials *sweep, int count, double error);

/* Of an error [eq:error-parts]: the differences that the knobs make. */
enum part { MODEL, SPACE, TIME, SOLVER, N_PART };
#define PARTS "model space time solver" /* as words, in this order */

/* A row with the columns TRIALS_COLUMNS for setting k; `asked`: the error that
 * it was wanted for, 0: none. */
#define TRIALS_COLUMNS "scene asked law method n steps tolerance error flops " \
                      "reason systems element grade floor"
void trials_row(const struct trials *sweep, int k, double asked);

#endif
