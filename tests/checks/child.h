/*
 * child.h - running code that is not trusted, in a child, to its end.
 */
#ifndef TESTS_CHECKS_CHILD_H
#define TESTS_CHECKS_CHILD_H

/* CPU time, which no other program takes away: thirty times what the dearest
 * check of a right program takes.  Tests give other seconds. */
#ifndef JUDGE_SECONDS
#define JUDGE_SECONDS 5
#endif

enum {
    SECONDS_COMPUTING = JUDGE_SECONDS,
    SECONDS_JUDGING = 4 * JUDGE_SECONDS, /* of all children together */
    SECONDS_IDLE = 5,     /* wall time in which none of them computes */
    SECONDS_WAITING = 12 * JUDGE_SECONDS, /* where idleness cannot be seen */
    MEGABYTES_OUTPUT = 8,  /* in one file */
    MOST_FILES = 64,
    MOST_PROCESSES = 128,
    MEGABYTES_MEMORY = 1024, /* unless SANITIZED is in the environment */
    CHILD_DESCRIPTOR = 4 /* in a page 3 is its folder */
};

/* What a child ran into, if anything. */
enum limit {
    NO_LIMIT,
    LIMIT_CPU,
    LIMIT_IDLE,
    LIMIT_OUTPUT,
    LIMIT_FILES,
    LIMIT_PROCESSES,
    LIMIT_STOPPED
};

struct ending {
    int status; /* exit status, or -signal */
    enum limit limit;
};

/*
 * Run body(context) in a child; its exit status is 0 when the body returns.
 * The child's stdin is empty, its stdout and stderr go to the new files out
 * and err, it holds no other descriptor, has no terminal, and its time,
 * memory, and output are limited.  When it has ended, all that it left behind
 * is killed.  A child within a child is killed with the outer one.
 *
 * Ctrl-C and its like end the children first, then call `interrupted`, which
 * may be NULL, then the judge.
 */
struct ending child_run(void (*body)(void *), void *context, const char *out,
                        const char *err);
void child_on_interrupt(void (*interrupted)(void));

/* The next children hold this descriptor as CHILD_DESCRIPTOR; 0: none. */
void child_hand_over(int descriptor);

/*
 * From now on children work in this folder (an absolute path).  Where the
 * system has the means (Linux with Landlock) they can change files nowhere
 * else, and send signals to each other only; and the program `stranger`, which
 * may be NULL, reads there and what a program needs, and executes only itself.
 */
void child_work_in(const char *folder, const char *stranger);

/* In a child: be this program from now on.  Returns where that fails. */
void child_become(const char *program, char *const argv[]);

/* This process is such a child, after exec: its own children are within it. */
void child_am_inside(void);

/* Run a command of the shell, which is trusted and has no limits; its exit
 * status.  Ctrl-C and its like end it. */
int child_command(const char *command);

/* Begin to count seconds anew; the CPU seconds of all children since then; and
 * seconds that are to count as well. */
void child_restart_clock(void);
double child_seconds(void);
void child_spend(double seconds);

#endif
