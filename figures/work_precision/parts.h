/*
 * parts.h - of what are the errors of the settings of trials.h made?
 *
 * The walk of the rule [alg:balance] in the shake, with the parts that it
 * estimates; in how many settings of the six scenes on which it was made one
 * estimated part is nearly all; and the settings of the column that are good by
 * luck, because their parts cancel.
 */
#ifndef FIGURES_PARTS_H
#define FIGURES_PARTS_H

#include "trials.h"

/* Tables: walk, parts, luck; claims. */
void parts_tables(struct trials *const s[WORK_SCENES]);

#endif
