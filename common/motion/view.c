/* view.c - view.h without a window, for all programs but those of `make live`
 * and `make live-NN`, which bring view_sdl.c. */
#include "motion/view.h"

#include <stddef.h>

struct view *view_open(const char *title, int must)
{
    (void)title, (void)must;
    return NULL;
}

void view_close(struct view *view) { (void)view; }

int view_next(struct view *view, const char *keys, struct pointer *pointer)
{
    (void)view, (void)keys, (void)pointer;
    return 0;
}

void view_draw(struct view *view, const struct view_picture *picture,
               double seconds, const char *shot)
{
    (void)view, (void)picture, (void)seconds, (void)shot;
}
