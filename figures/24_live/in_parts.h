/* in_parts.h - a frame of the live square in sub-steps. */
#ifndef FIGURES_IN_PARTS_H
#define FIGURES_IN_PARTS_H

#include "motion/live.h"

/* Make one frame by integrate_frame(), whole ("parts" as well) or in sub-steps,
 * by backward Euler; in a frame that is "lost" the hand waits. */
struct live_report live_frame_in_parts(struct live *live, const double to[2]);

#endif
