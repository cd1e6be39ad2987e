/*
 * hand.h - a program of a lesson, held in the hand: a picture per frame, and
 * the pointer that moves it.
 *
 *     struct hand *hand = hand_open("12", HAND_WHOSE, "lr", argc, argv);
 *     while (hand_next(hand, &pointer)) {
 *         hand_slot("12e");         the call of now, should it never return
 *         ... one frame ...
 *         hand_draw(hand, &picture, status, "min_J systems", numbers);
 *     }
 *     return hand_close(hand);
 *
 * The pointer comes from the window of view.h, or where a program has none, or
 * with --input, from a script of pointer.h; the same lines give the same
 * frames.  hard and mad press a key every now and then, each in turn.
 * A slot that crashes, that does not return within a minute, that exits or
 * returns a place that is not finite ends the program with one line that names
 * it, and status 1.  So does one that has leaked a gigabyte.  In a window the
 * caption says how many frames were late: they took longer than 1/30 s.
 *
 * Names: program_.
 */
#ifndef COMMON_HAND_H
#define COMMON_HAND_H

/* The program whose slots it is, and whose main() is another here. */
#ifdef PROGRAM
int program_main(int argc, char *argv[]);
#define main program_main
#include PROGRAM
#undef main
#endif

#include "base/status.h"
#include "motion/view.h"
#include "plane/mesh.h"

struct hand;

/* Whose slots these are; `make live-NN` says it. */
#ifndef HAND_WHOSE
#define HAND_WHOSE "the reference's slots"
#endif

/* keys: letters that the scene knows, `r` among them.  Options: --input,
 * --seed, --frames, --record, --shot (the last picture of the window) and
 * --picture (the same as SVG).  GSL's own handler of errors is off then. */
struct hand *hand_open(const char *lesson, const char *whose,
                       const char *keys, int argc, char *argv[]);

/* Return the next frame: false at the end of the input, or of the window.  The
 * pointer stays within 2.7 m and 2.1 m of the middle. */
int hand_next(struct hand *hand, struct pointer *pointer);

/* The slot that is called from here on; NULL: none. */
void hand_slot(const char *slot);

/* Show the frame, whose caption is red unless it ended OK, and print a row of
 * the table `frames`: its columns are frame, x, y, down, status, seen (the sum
 * of all numbers of the picture) and these (separated by a space), to six
 * digits where they are not whole, and missing where they are not finite.  The
 * caption gets two last lines: the keys of all scenes, and which slots are the
 * student's. */
void hand_draw(struct hand *hand, struct view_picture *picture,
               enum status status, const char *columns, const double number[]);

/* Return the exit status; hand is freed. */
int hand_close(struct hand *hand);

/* Add to picture an arrow from a to a + scale d, if it can be seen. */
void hand_arrow(struct view_picture *picture, const double a[2],
                const double d[2], double scale);

/* Return the point that is held from here on, or -1: while the button is down
 * the one that was, or else the nearest one that is within reach (m). */
int hand_grab(int held, const struct pointer *pointer, int n, const double x[],
              double reach);

/* Return a picture of the triangles of a mesh, whose vertices are at x now. */
struct view_picture hand_triangles(const struct mesh *mesh, const double x[],
                                   const double value[]);

#endif
