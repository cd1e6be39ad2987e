/*
 * clock.h - seconds, and what machine and build they belong to.
 */
#ifndef COMMON_CLOCK_H
#define COMMON_CLOCK_H

#include <stddef.h>

/* Seconds of a monotonic clock, from an arbitrary start. */
double clock_seconds(void);

/* Return the seconds that a processor has worked for this process; where nobody
 * counts them, as in a browser, clock_seconds(). */
double clock_processor(void);

/* Write "<processor>, <compiler> <flags>" into text, for a table's note. */
void clock_machine(size_t size, char text[]);

#endif
