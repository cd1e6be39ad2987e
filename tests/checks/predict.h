/*
 * predict.h - what the student expected of the program, before it ran.
 *
 * The header comment of a lesson's file has two or three lines
 *
 *      * PREDICT 2a condition number, 64 elements, old diagonal: ...
 *
 * and the student puts a number, or a fraction, in the place of the dots.  What
 * the program gives instead comes from measured() of judge.h, by the key, 2a.
 */
#ifndef TESTS_CHECKS_PREDICT_H
#define TESTS_CHECKS_PREDICT_H

#include <stddef.h>

enum { MAX_PREDICTIONS = 8 };

struct prediction {
    char key[4];
    char answer[32]; /* as it stands there; "" for dots, or for nothing */
};

/* The PREDICT lines of a file, MAX_PREDICTIONS at most; returns how many. */
int predictions_read(const char *path, struct prediction p[]);

/* Adds "2a: 7000, measured 6741.22, off by 3.8 %. " to the text of this size,
 * or says that the answer is not a number. */
void prediction_compare(const struct prediction *p, double measured,
                        size_t size, char text[]);

#endif
