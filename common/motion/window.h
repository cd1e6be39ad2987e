/*
 * window.h - a window on a live scene, which view.h shows where `make live` has
 * linked it; window_web.c is for a page.
 *
 * The square is coloured by log2 J: blue where it is pressed, white at rest,
 * orange where it is stretched, magenta where J <= 0; a red ring stands round a
 * knot.
 */
#ifndef COMMON_WINDOW_H
#define COMMON_WINDOW_H

#include "motion/live.h"

struct window;

/* Open a window.  NULL: the program was not linked by `make live`.  die() where
 * there is no display. */
struct window *window_open(void);
void window_close(struct window *window);

/*
 * Return whether there is a frame k.  In a window its time is waited for (space
 * stops it), and the mouse, where it is the input, adds a line to it.  False:
 * the input is at its end, or the window was closed, as it is by q and Esc.
 */
int window_next(struct window *window, struct pointers *input, int k,
                int mouse);

/* Draw the state after a frame that took this long (s); shot, unless NULL, is
 * the file to which the picture is written as well, as a BMP. */
void window_draw(struct window *window, const struct live *live,
                 const struct live_report *report, double seconds,
                 const char *shot);

#endif
