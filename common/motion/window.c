/* window.c - window.h without a window, for all programs but that of `make
 * live`, which brings window_sdl.c. */
#include "motion/window.h"

struct window *window_open(void) { return NULL; }

void window_close(struct window *window) { (void)window; }

int window_next(struct window *window, struct pointers *input, int k,
                int mouse)
{
    (void)window, (void)mouse;
    return k < input->n;
}

void window_draw(struct window *window, const struct live *live,
                 const struct live_report *report, double seconds,
                 const char *shot)
{
    (void)window, (void)live, (void)report, (void)seconds, (void)shot;
}
