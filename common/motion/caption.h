/*
 * caption.h - what a window says of a live scene: how the last frame went, and
 * which key does what, with what it does now.
 *
 *     fast: OK, 3 systems in 1.2 ms
 *     [l] law: log   [i] time step: backward
 *     ...
 */
#ifndef COMMON_CAPTION_H
#define COMMON_CAPTION_H

#include "motion/live.h"

enum { CAPTION = 360 };

/* text := lines of at most 60 letters, without a newline at the end.  Each key
 * of POINTER_KEYS but `.` stands in brackets, before what it does. */
void caption_of(const struct live *live, const struct live_report *report,
                double seconds, char text[CAPTION]);

#endif
