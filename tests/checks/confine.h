/*
 * confine.h - what child.c asks of the system, most of it Linux's: limits of a
 * child, and a look at all that it has started.
 */
#ifndef TESTS_CHECKS_CONFINE_H
#define TESTS_CHECKS_CONFINE_H

#include "child.h"

/* This process, and all that it starts, has the limits of child.h. */
void child_set_limits(void);

/*
 * It changes files below `folder` only, and sends signals to processes below it
 * only.  Landlock does that from Linux 5.13 on, signals from 6.12 on; a system
 * without it refuses the first call, and all is as before.
 */
void child_confine(const char *folder);

/* From the next exec on it reads what a program needs, and the folder, which
 * may be NULL; it executes this program, and nothing else. */
void child_see_only(const char *folder, const char *program);

/* What can be seen of the processes below this one. */
struct sight {
    int threads, computing; /* or could, if the machine were free */
    double seconds; /* CPU time, that of their ended children too */
};

/* Look at all that descends from this process; in a namespace what loses its
 * parent stays there.  Returns 0 where nothing can be seen. */
int child_look_around(struct sight *sight);

#endif
