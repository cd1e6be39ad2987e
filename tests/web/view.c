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
