/*
 * posix.h - before all that is compiled for a page: what wasi-libc leaves out
 * of POSIX, and the judge and the library use; child.c beside this file has it.
 */
#ifndef TESTS_WEB_POSIX_H
#define TESTS_WEB_POSIX_H

#define CLOCK_PROCESS_CPUTIME_ID CLOCK_MONOTONIC
#define RLIMIT_CPU 0
#define MSG_DONTWAIT 0
#define HEAP_IS_COUNTED /* guard.c */

typedef unsigned long long rlim_t;
struct rlimit {
    rlim_t rlim_cur, rlim_max;
};
struct mallinfo2 {
    unsigned long uordblks, hblkhd;
};
struct mallinfo2 mallinfo2(void);
int setrlimit(int resource, const struct rlimit *limit);
int socketpair(int domain, int type, int protocol, int both[2]);
char *mkdtemp(char *name);
int pause(void);

/* of a scene in the hand: view.c */
struct sigaction {
    void (*sa_handler)(int);
};
int sigaction(int number, const struct sigaction *, struct sigaction *old);
unsigned alarm(unsigned seconds);

#endif
