/*
 * view.h - a window that shows one picture per frame and has a pointer.  It
 * knows nothing of mechanics.  view_sdl.c shows it with SDL2, and is linked by
 * `make live` and `make live-NN` alone.
 *
 * Triangles are coloured by log2 of a value: blue below 1, white at 1, orange
 * above, magenta where it is not positive.  Below stand the milliseconds of the
 * last 240 frames and the line of 33.
 */
#ifndef COMMON_VIEW_H
#define COMMON_VIEW_H

#include "motion/pointer.h"

enum { VIEW_CAPTION = 480, VIEW_ARROWS = 64 };

struct view_picture {
    int n_point;
    const double *x;     /* [2 n_point] (m); 5.6 m by 4.4 m are seen at least */
    int n_triangle;
    const int *triangle; /* [3 n_triangle] */
    const double *value; /* [n_triangle] */
    const int *held;     /* [n_point] black squares; NULL: none */
    const int *ring;     /* [n_point] red rings; NULL: none */
    int n_arrow;
    double arrow[VIEW_ARROWS][4]; /* from x, y to x, y (m) */
    int n_curve;
    const double *curve; /* [2 n_curve] (m): a line through these points */
    int alarm;                    /* the caption is red */
    char caption[VIEW_CAPTION];   /* lines; `[key] what it is` up to 3 spaces */
    char note[80];                /* two lines beside the milliseconds */
};

struct view;

/* Where there is no display: die(), if there must be one, else NULL. */
struct view *view_open(const char *title, int must);
void view_close(struct view *view);

/* Wait until a frame begins, 30 per second (space stops them), and read the
 * pointer: one of the letters `keys` in its key, or '.'.  False: the window was
 * closed, as it is by q and Esc. */
int view_next(struct view *view, const char *keys, struct pointer *pointer);

/* Show the picture of a frame that took this long (s); shot, unless NULL, is
 * the file to which it is written as well, as a BMP. */
void view_draw(struct view *view, const struct view_picture *picture,
               double seconds, const char *shot);

#endif
