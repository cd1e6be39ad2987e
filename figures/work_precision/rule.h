/*
 * rule.h - the balance rule [alg:balance], and what it costs to follow it.
 *
 * Parts of an error come from pairs of runs that differ in one knob
 * [eq:error-parts]: these probes have to be paid before the run that was
 * wanted.  On three meshes the order in space is measured.  On two, the
 * coarsest and the next, it is that of a corner [eq:corner], nothing fine is
 * run, and the cubic law, which costs the flops of the log law, is left out.
 * The rule sees nothing but its probes: what a finer run costs is counted from
 * the systems of the same run on the coarsest mesh; where the run that is taken
 * fails, it is one more probe, and the next takes twice the steps.
 */
#ifndef FIGURES_RULE_H
#define FIGURES_RULE_H

#include "trials.h"

/*
 * What a setting should have wrong, part by part, relative to size, without a
 * look at the limit [eq:error-parts]: each part is a difference of two runs
 * that differ in one knob, on the coarsest mesh but for space and model.
 * Returns the size of their sum: parts are vectors, and some cancel.  INFINITY
 * where a run that is needed has failed.
 */
double rule_parts(const struct trials *trials, int meshes,
                  const struct work_setting *set, double part[N_PART]);

struct rule_choice {
    int taken;    /* the setting, or -1: none gets there */
    int probes;   /* runs to decide, without the one that is taken */
    double flops; /* of these */
};

/*
 * What the rule takes for an error, from probes on two or three meshes: from
 * the coarsest setting of every model and method whose own part is small
 * enough, refine the knob that leaves the least error, until that is at most
 * `error`; of these settings the one that should have the fewest flops.
 */
struct rule_choice rule_take(const struct trials *trials, int meshes,
                             double error);

#endif
