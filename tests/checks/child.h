/*
 * child.h - running code that is not trusted, in a child, to its end.
 */
#ifndef TESTS_CHECKS_CHILD_H
#define TESTS_CHECKS_CHILD_H

enum {
    SECONDS_COMPUTING = 5, /* CPU time, which no other program takes away */
    SECONDS_IDLE = 5,      /* wall time in which nothing computes */
    SECONDS_WAITING = 60,  /* wall time, where idleness cannot be seen */
    MEGABYTES_OUTPUT = 8,
    MEGABYTES_MEMORY = 1024
};

/* What a child ran into, if anything. */
enum limit { NO_LIMIT, LIMIT_CPU, LIMIT_IDLE, LIMIT_OUTPUT, LIMIT_STOPPED };

struct ending {
    int status; /* exit status, or -signal */
    enum limit limit;
};

/*
 * Run body(context) in a child; its exit status is 0 when the body returns.
 * The child's stdin is empty, its stdout and stderr go to the files out and
 * err, it holds no other descriptor, and its time, memory, and output are
 * limited.  When it has ended, all that it left behind is killed.  A child
 * within a child is killed with the outer one.
 *
 * Ctrl-C and its like end the children first, then call `interrupted`, which
 * may be NULL, then the judge.
 */
struct ending child_run(void (*body)(void *), void *context, const char *out,
                        const char *err);
void child_on_interrupt(void (*interrupted)(void));

/* CPU seconds that all ended children have taken. */
double child_seconds(void);

#endif
