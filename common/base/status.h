/*
 * status.h - how a computation ended, and the two ways a program gives up.
 *
 * Three kinds of failure, three mechanisms.  A numerical outcome (a matrix
 * that is not positive definite, a system without a solution) is a status: the
 * algorithm reacts to it.  A bug in the caller is an assert.  What machine or
 * user did wrong (memory, a full disk) is die(): one line, exit status 1.
 *
 * Names: die, allocate, todo.
 */
#ifndef COMMON_STATUS_H
#define COMMON_STATUS_H

#include <stddef.h>

enum status {
    OK,
    NOT_SPD,      /* a pivot of the Cholesky factorisation is not > 0 */
    INCOMPATIBLE, /* singular system, right-hand side outside the range */
    NONFINITE,    /* a NaN or an infinity where a number is due */
    INVERTED,     /* det F left the domain of the material */
    STALLED,      /* no step makes progress, and the residual is not small */
    SADDLE,       /* in balance, but not a minimum: K is not SPD there */
    MAX_ITERATIONS,
    OUTSIDE       /* a particle is where the grid has no nodes for it */
};

/* Return the status as the word that programs print: "OK", "NOT_SPD", ... */
const char *status_name(enum status status);

/* Print "error: <message>" on stderr and exit with status 1. */
_Noreturn void die(const char *format, ...)
    __attribute__((__format__(__printf__, 1, 2)));

/* Return n * size zeroed bytes of malloc(), or die(). */
void *allocate(size_t n, size_t size);

/*
 * The placeholder for a slot that the student has not written yet: print the
 * slot on stderr and exit with status 3.  The further arguments are what the
 * slot has to work with; they are named so that the compiler counts them as
 * used, and are not looked at.
 */
_Noreturn void todo(const char *slot, ...);

#endif
