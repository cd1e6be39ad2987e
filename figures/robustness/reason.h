/*
 * reason.h - how a step ended, in a word.
 */
#ifndef FIGURES_REASON_H
#define FIGURES_REASON_H

#include "plane/step.h"

/* Return status_name(), or "fails" where round-off decides between NOT_SPD,
 * NONFINITE, STALLED and MAX_ITERATIONS: without a line search, when the
 * iterates blow up. */
const char *reason_of(const struct step_control *control, enum status status);

#endif
