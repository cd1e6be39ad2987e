/*
 * pointer.h - a hand in a live scene: a line per frame, from a file,
 * from a script or from a window.
 *
 *     x y down key
 *
 * x, y     where the pointer is (m)
 * down     1: the button is down, 0: it is up
 * key      one of POINTER_KEYS; `.` is none
 *
 * A replay of the same lines gives the same states, bit for bit.
 */
#ifndef COMMON_POINTER_H
#define COMMON_POINTER_H

/* law, integrator, start, fallback, what is grabbed, element, finer, coarser,
 * reset */
#define POINTER_KEYS ".lispge+-r"

struct pointer {
    double x, y;
    int down;
    char key;
};

struct pointers {
    int n; /* frames */
    struct pointer *frame;
};

/*
 * Scripts.
 *
 *     pull   the middle of the right side goes to the right with `speed` (m/s),
 *            for 40 frames, and is held where it is for 20
 *     hard   pulled, shaken, slammed and pushed through itself in 180 frames,
 *            then let go, 120 frames
 *     mad    `frames` frames of a hand that grabs, leaps and lets go at random
 *            (GSL's Mersenne twister from `seed`), then 120 with the hand off
 */
struct pointers pointers_pull(double speed);
struct pointers pointers_hard(void);
struct pointers pointers_mad(int seed, int frames);

/* The script of this name, "mad" of 600 frames, or the lines of the file.  Any
 * other line than above ends the program with exit status 2 and one message
 * that names file and line. */
struct pointers pointers_named(const char *name, double speed, int seed);

/*
 * Write them to path: a file gets all of them or stays what it was, a device, a
 * pipe or a link is written into.  die() when that fails.
 */
void pointers_write(const struct pointers *pointers, const char *path);

void pointers_add(struct pointers *pointers, struct pointer pointer);
void pointers_free(struct pointers *pointers);

#endif
