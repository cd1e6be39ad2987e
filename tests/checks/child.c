/* child.c - see child.h. */
#include "child.h"

#include "output.h" /* quit */

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

static struct {
    int inside;                   /* this process is a child already */
    volatile sig_atomic_t signal; /* the judge was told to end */
    void (*interrupted)(void);
} running;

/* ---- in the child -------------------------------------------------------- */

/* No more than this; a `hard` limit is for a program that ignores the first.
 * What is limited more strictly already stays so. */
static void limit(int resource, rlim_t value, rlim_t hard)
{
    struct rlimit rule;
    if (getrlimit(resource, &rule) < 0) return;
    if (rule.rlim_cur == RLIM_INFINITY || rule.rlim_cur > value)
        rule.rlim_cur = value;
    if (rule.rlim_max == RLIM_INFINITY || rule.rlim_max > hard)
        rule.rlim_max = hard;
    setrlimit(resource, &rule);
}

static void set_limits(void)
{
    const rlim_t output = (rlim_t)MEGABYTES_OUTPUT << 20;
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, output, output);
    limit(RLIMIT_CPU, SECONDS_COMPUTING, SECONDS_COMPUTING + 1);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__APPLE__)
    const rlim_t memory = (rlim_t)MEGABYTES_MEMORY << 20;
    limit(RLIMIT_AS, memory, memory);
#endif
}

static void attach(int fd, const char *path, int flags)
{
    const int file = open(path, flags, 0666);
    if (file < 0 || dup2(file, fd) < 0) _exit(2);
    if (file != fd) close(file);
}

_Noreturn static void be_the_child(void (*body)(void *), void *context,
                                   const char *out, const char *err)
{
    static const int reset[] = {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGPIPE,
                                SIGCHLD};
    sigset_t none;
    if (!running.inside) setpgid(0, 0);
    running.inside = 1;
    for (size_t s = 0; s < sizeof reset / sizeof *reset; s++)
        signal(reset[s], SIG_DFL);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    attach(STDIN_FILENO, "/dev/null", O_RDONLY);
    attach(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
    attach(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
    for (int fd = 3; fd < 256; fd++) close(fd);
    set_limits();
    body(context);
    fflush(NULL);
    _exit(0);
}

/* ---- in the judge -------------------------------------------------------- */

static void note_signal(int number) { running.signal = number; }

void child_on_interrupt(void (*interrupted)(void))
{
    static const int wanted[] = {SIGINT, SIGTERM, SIGHUP};
    running.interrupted = interrupted;
    for (size_t s = 0; s < sizeof wanted / sizeof *wanted; s++) {
        struct sigaction old;
        /* what is ignored (nohup) stays ignored */
        if (sigaction(wanted[s], NULL, &old) < 0 || old.sa_handler == SIG_IGN)
            continue;
        signal(wanted[s], note_signal);
    }
}

double child_seconds(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static void doze(long microseconds)
{
    const struct timespec time = {0, 1000 * microseconds};
    nanosleep(&time, NULL);
}

static double wall(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#if defined(__linux__)
/* State, parent and group of a process of /proc; 0 when it is gone. */
static int look_at(const char *pid, char *state, int *parent, int *group)
{
    char path[300], line[512];
    snprintf(path, sizeof path, "/proc/%s/stat", pid);
    FILE *file = fopen(path, "r");
    if (!file) return 0;
    const char *read = fgets(line, sizeof line, file);
    fclose(file);
    const char *name_end = read ? strrchr(line, ')') : NULL;
    return name_end &&
           sscanf(name_end + 1, " %c %d %d", state, parent, group) == 3;
}
#endif

/* Whether some process of the child's group computes, or could if the machine
 * were free; 1 where that cannot be seen. */
static int busy(pid_t child)
{
    int found = 0;
#if defined(__linux__)
    DIR *all = opendir("/proc");
    for (const struct dirent *d; all && !found && (d = readdir(all));) {
        char state;
        int parent, group;
        if (d->d_name[0] < '0' || d->d_name[0] > '9' ||
            !look_at(d->d_name, &state, &parent, &group))
            continue;
        found = group == child && strchr("RD", state);
    }
    if (all) closedir(all);
    if (!all) found = 1;
#else
    (void)child;
    found = 1;
#endif
    return found;
}

/* Kill the child's group, and what left that group as far as the system hands
 * it back to us (a daemon does, on Linux). */
static void kill_all(pid_t child)
{
    kill(-child, SIGKILL);
#if defined(__linux__)
    for (int round = 0; round < 50; round++) {
        int left = 0;
        DIR *all = opendir("/proc");
        for (const struct dirent *d; all && (d = readdir(all));) {
            char state;
            int parent, group;
            if (d->d_name[0] < '0' || d->d_name[0] > '9' ||
                !look_at(d->d_name, &state, &parent, &group) ||
                parent != (int)getpid())
                continue;
            left = 1;
            kill((pid_t)atoi(d->d_name), SIGKILL);
        }
        if (all) closedir(all);
        while (waitpid(-1, NULL, WNOHANG) > 0) continue;
        if (!left) break;
        doze(1000);
    }
#endif
}

/* The judge is to end: the children first. */
static void stop_if_told(pid_t child)
{
    if (!running.signal || running.inside) return;
    kill_all(child);
    if (running.interrupted) running.interrupted();
    signal(running.signal, SIG_DFL);
    raise(running.signal);
}

static struct ending ending_of(int status, enum limit limit)
{
    struct ending ending = {0, limit};
    ending.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    if (limit != NO_LIMIT || !WIFSIGNALED(status)) return ending;
    if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)
        ending.limit = LIMIT_CPU; /* SIGKILL: at the hard limit */
    if (WTERMSIG(status) == SIGXFSZ) ending.limit = LIMIT_OUTPUT;
    return ending;
}

struct ending child_run(void (*body)(void *), void *context, const char *out,
                        const char *err)
{
    enum limit limit = NO_LIMIT;
    int status = 0;

    fflush(NULL);
#if defined(__linux__)
    if (!running.inside) prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    const pid_t child = fork();
    if (child < 0) quit("cannot fork: %s", strerror(errno));
    if (child == 0) be_the_child(body, context, out, err);
    if (!running.inside) setpgid(child, child); /* who comes first */

    const double start = wall();
    double active = start;
    for (long pause = 200;; pause = pause < 20000 ? 2 * pause : pause) {
        const pid_t ended = waitpid(child, &status, WNOHANG | WUNTRACED);
        if (ended < 0 && errno != EINTR)
            quit("cannot wait: %s", strerror(errno));
        if (ended == child && !WIFSTOPPED(status)) break;
        stop_if_told(child);
        const double now = wall();
        if (ended == child) limit = LIMIT_STOPPED;
        if (!running.inside && now - start > 1.0 && busy(child)) active = now;
        if (!running.inside && now - active > SECONDS_IDLE) limit = LIMIT_IDLE;
        if (now - start > SECONDS_WAITING) limit = LIMIT_IDLE;
        if (limit != NO_LIMIT) kill(child, SIGKILL);
        if (limit == NO_LIMIT) doze(pause);
    }
    if (!running.inside) kill_all(child);
    return ending_of(status, limit);
}
