/*
 * view.c - view.h in a page, for what is held in the hand there: the scene runs
 * in lessons/web/student_judge.js, which waits for each frame.
 */
#include "motion/view.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>

/* What the page does.  The pointer: x, y, down, and the key's code. */
int page_frame(const char *keys, double pointer[4]);
void page_draw(const struct view_picture *picture, double seconds);

/* Its picture() reads a struct view_picture at these places. */
#define AT(place, member) \
    _Static_assert(offsetof(struct view_picture, member) == (place), #member)
AT(0, n_point); AT(4, x); AT(8, n_triangle); AT(12, triangle); AT(16, value);
AT(20, held); AT(24, ring); AT(28, n_arrow); AT(32, arrow); AT(2080, n_curve);
AT(2084, curve); AT(2088, alarm); AT(2092, caption); AT(2572, note);

struct view *view_open(const char *title, int must)
{
    (void)title, (void)must;
    return (struct view *)(void *)(size_t)16; /* there is one */
}

void view_close(struct view *view) { (void)view; }

int view_next(struct view *view, const char *keys, struct pointer *pointer)
{
    double now[4] = {0.0};
    (void)view;
    if (!page_frame(keys, now)) return 0;
    const char key = (char)now[3];
    *pointer = (struct pointer){now[0], now[1], now[2] > 0.0,
                                key && strchr(keys, key) ? key : '.'};
    return 1;
}

void view_draw(struct view *view, const struct view_picture *picture,
               double seconds, const char *shot)
{
    (void)view, (void)shot;
    page_draw(picture, seconds);
}

/* The page calls the handler of a signal where there was a trap. */
static void (*handler)(int);

int sigaction(int number, const struct sigaction *new, struct sigaction *old)
{
    (void)number, (void)old;
    handler = new->sa_handler;
    return 0;
}

void page_trapped(int number)
{
    if (handler) handler(number);
}

unsigned alarm(unsigned seconds) { return seconds = 0; }
