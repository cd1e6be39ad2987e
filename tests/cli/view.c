/*
 * view.c - view.h for hand.sh: a window that nobody sees, and its clock.
 *
 * A frame takes MS milliseconds.  The pointer goes straight on, its button is
 * down in every other frame, and the captions go to stderr.
 */
#include "motion/view.h"

#include <stdio.h>
#include <stdlib.h>

double frame_clock(void);
double frame_clock(void) /* at the begin and at the end of a frame */
{
    static double now;
    return now += 1e-3 * atof(getenv("MS"));
}

struct view *view_open(const char *title, int must)
{
    (void)title, (void)must;
    return (struct view *)(void *)stderr; /* there is one */
}

void view_close(struct view *view) { (void)view; }

int view_next(struct view *view, const char *keys, struct pointer *pointer)
{
    static int k;
    (void)view, (void)keys;
    *pointer = (struct pointer){0.0625 * k, -0.03125 * k, k % 2, '.'};
    return k++ < 30;
}

void view_draw(struct view *view, const struct view_picture *picture,
               double seconds, const char *shot)
{
    (void)view, (void)seconds, (void)shot;
    fprintf(stderr, "%s\n", picture->caption);
}
