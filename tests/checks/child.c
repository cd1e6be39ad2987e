/* child.c - see child.h. */
#if defined(__linux__)
#define _DEFAULT_SOURCE /* syscall */
#endif
#include "confine.h"

#include "output.h" /* quit */

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#if defined(__linux__)
#include <linux/sched.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

static struct {
    int inside;         /* this process is a child already */
    const char *folder; /* where children work, or NULL */
    const char *stranger; /* the program that is not trusted, or NULL */
    int handed;         /* a descriptor for the next child, or 0 */
    double spent;       /* CPU seconds before the clock was restarted */
    double idle;        /* wall seconds since then in which none computed */
    volatile sig_atomic_t signal; /* the judge was told to end */
    void (*interrupted)(void);
} running;

void child_work_in(const char *folder, const char *stranger)
{
    running.folder = folder;
    running.stranger = stranger;
}

void child_am_inside(void) { running.inside = 1; }
void child_hand_over(int descriptor) { running.handed = descriptor; }

/* ---- in the child -------------------------------------------------------- */

/* A new file, whatever an earlier child left under that name. */
static void attach(int fd, const char *path, int flags)
{
    if (flags & O_CREAT) unlink(path);
    const int file = open(path, flags, 0666);
    if (file < 0 || dup2(file, fd) < 0) _exit(2);
    if (file != fd) close(file);
}

static void die_with_parent(void)
{
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

_Noreturn static void be_the_child(void (*body)(void *), void *context,
                                   const char *out, const char *err)
{
    static const int reset[] = {SIGINT,  SIGTERM, SIGHUP, SIGQUIT,
                                SIGALRM, SIGPIPE, SIGCHLD};
    const int new_file = O_WRONLY | O_CREAT | O_EXCL;
    sigset_t none;
    die_with_parent();
#if defined(__linux__)
    if (running.inside) setpgid(0, 0); /* dies with its parent all the same */
#endif
    for (size_t s = 0; s < sizeof reset / sizeof *reset; s++)
        signal(reset[s], SIG_DFL);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    attach(STDIN_FILENO, "/dev/null", O_RDONLY);
    attach(STDOUT_FILENO, out, new_file);
    attach(STDERR_FILENO, err, new_file);
    const int handed = running.inside ? 0 : running.handed;
    if (handed && dup2(handed, CHILD_DESCRIPTOR) < 0) _exit(2);
    for (int fd = 3; fd < 256; fd++)
        if (!handed || fd != CHILD_DESCRIPTOR) close(fd);
    child_set_limits();
    if (!running.inside && running.folder) {
        if (chdir(running.folder) < 0) _exit(2);
        child_confine(running.folder);
    }
    running.inside = 1;
    body(context);
    fflush(NULL);
    _exit(0);
}

void child_become(const char *program, char *const argv[])
{
    if (running.stranger && strcmp(program, running.stranger) == 0)
        child_see_only(running.folder, program);
    execv(program, argv);
}

/* ---- in the judge -------------------------------------------------------- */

static void note_signal(int number) { running.signal = number; }

void child_on_interrupt(void (*interrupted)(void))
{
    static const int wanted[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    running.interrupted = interrupted;
    for (size_t s = 0; s < sizeof wanted / sizeof *wanted; s++) {
        struct sigaction old;
        /* what is ignored (nohup) stays ignored */
        if (sigaction(wanted[s], NULL, &old) < 0 || old.sa_handler == SIG_IGN)
            continue;
        signal(wanted[s], note_signal);
    }
}

static double all_seconds(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

void child_restart_clock(void)
{
    running.spent = all_seconds();
    running.idle = 0.0;
}

void child_spend(double seconds) { running.spent -= seconds; }

double child_seconds(void) { return all_seconds() - running.spent; }

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

/* Go before all that a child may start, or no more, where the system allows it:
 * it is root's means, whose children are limited in no other way. */
static void hurry(int first)
{
#if defined(__linux__)
    static int is_first;
    const struct sched_param priority = {.sched_priority = first};
    if (first == is_first) return;
    if (!sched_setscheduler(0, first ? SCHED_RR : SCHED_OTHER, &priority))
        is_first = first;
#else
    (void)first;
#endif
}

/* The judge is to end: the children first, in good order if they can. */
static void stop_if_told(pid_t child)
{
    if (!running.signal || running.inside) return;
    kill(-child, SIGTERM);
    for (int round = 0; round < 100; round++) {
        if (waitpid(child, NULL, WNOHANG) != 0) break;
        doze(10000);
    }
    kill(-child, SIGKILL);
    waitpid(child, NULL, 0);
    if (running.interrupted) running.interrupted();
    signal(running.signal, SIG_DFL);
    raise(running.signal);
}

static int count_files(const char *folder)
{
    int n = 0;
    DIR *files = folder ? opendir(folder) : NULL;
    while (files && readdir(files)) n++;
    if (files) closedir(files);
    return n;
}

/* Wall seconds since `*last`, of which no more are counted than a judge needs
 * between two looks: in the rest it was stopped itself, or frozen, and its
 * children may have been so as well. */
static double waited_since(double *last)
{
    const double now = wall(), passed = now - *last;
    *last = now;
    return passed < 0.25 ? passed : 0.25;
}

/* What the child's processes ran into in the `interval` since the last look,
 * where the system lets us see them. */
static enum limit limit_seen(double interval, double *seconds)
{
    struct sight sight;
    if (!child_look_around(&sight)) return NO_LIMIT;
    /* a thread may compute while its process is said to sleep */
    if (sight.computing == 0 && sight.seconds == *seconds)
        running.idle += interval;
    *seconds = sight.seconds;
    if (sight.threads > MOST_PROCESSES) return LIMIT_PROCESSES;
    if (count_files(running.folder) > MOST_FILES) return LIMIT_FILES;
    if (sight.seconds + child_seconds() > SECONDS_JUDGING) return LIMIT_CPU;
    if (running.idle > SECONDS_IDLE) return LIMIT_IDLE;
    return NO_LIMIT;
}

/* `seconds`: CPU time of the child and of those that it waited for. */
static struct ending ending_of(int status, double seconds, enum limit limit)
{
    struct ending ending = {0, limit};
    ending.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    if (limit != NO_LIMIT || !WIFSIGNALED(status)) return ending;
    if (WTERMSIG(status) == SIGXCPU) ending.limit = LIMIT_CPU;
    /* The hard limit is the system's: it counts clock ticks, and tells us
     * exact times, and on a machine shared with others the two differ. */
    if (WTERMSIG(status) == SIGKILL && seconds > 0.5 * SECONDS_COMPUTING)
        ending.limit = LIMIT_CPU;
    if (WTERMSIG(status) == SIGXFSZ) ending.limit = LIMIT_OUTPUT;
    return ending;
}

/* Between the judge and a child: a program that kills or stops its parent does
 * so to this process, and the judge sees it.  It reports how the child ends. */
_Noreturn static void be_the_parent(void (*body)(void *), void *context,
                                    const char *out, const char *err,
                                    int report)
{
    int status = 0;
    setsid();
    die_with_parent();
    const pid_t child = fork();
    if (child == 0) be_the_child(body, context, out, err);
    while (child > 0 && waitpid(child, &status, WUNTRACED) < 0)
        if (errno != EINTR) _exit(1);
    const struct ending ending =
        ending_of(status, all_seconds(),
                  child > 0 && WIFSTOPPED(status) ? LIMIT_STOPPED : NO_LIMIT);
    if (child > 0 && write(report, &ending, sizeof ending) > 0) _exit(0);
    _exit(1);
}

/* Fork; where the system allows it the child is the first process of a
 * namespace, and all that it has started and shared is gone when it ends. */
static pid_t fork_apart(void)
{
#if defined(__linux__)
    const unsigned long apart = CLONE_NEWPID | CLONE_NEWIPC | SIGCHLD;
    pid_t child = (pid_t)syscall(SYS_clone, apart, NULL, NULL, NULL, 0);
    if (child < 0) /* who is not root is so in a namespace of users */
        child = (pid_t)syscall(SYS_clone, apart | CLONE_NEWUSER, NULL, NULL,
                               NULL, 0);
    if (child >= 0) return child;
#endif
    return fork();
}

/* Quit where the disk has no room for a file: the child could only end. */
static void make_room(const char *path)
{
    unlink(path); /* it may be a link */
    const int file = open(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (file < 0 && (errno == ENOSPC || errno == EDQUOT))
        quit("cannot write %s: %s", path, strerror(errno));
    if (file >= 0) close(file);
}

struct ending child_run(void (*body)(void *), void *context, const char *out,
                        const char *err)
{
    enum limit limit = NO_LIMIT;
    int status = 0;

    fflush(NULL);
    make_room(out);
    make_room(err);
    const double before = all_seconds();
    int report[2];
    if (pipe(report) < 0) quit("cannot make a pipe: %s", strerror(errno));
    const pid_t child = running.inside ? fork() : fork_apart();
    if (child < 0) quit("cannot fork: %s", strerror(errno));
    if (child == 0 && running.inside) be_the_child(body, context, out, err);
    if (child == 0) be_the_parent(body, context, out, err, report[1]);
    close(report[1]);
    if (!running.inside) hurry(1);

    double last = wall(), waited = 0.0, looked = 0.0, seconds = 0.0;
    for (long pause = 200;; pause = pause < 20000 ? 2 * pause : pause) {
        const pid_t ended = waitpid(child, &status, WNOHANG | WUNTRACED);
        if (ended < 0 && errno != EINTR)
            quit("cannot wait: %s", strerror(errno));
        if (ended == child && !WIFSTOPPED(status)) break;
        stop_if_told(child);
        waited += waited_since(&last);
        if (ended == child) limit = LIMIT_STOPPED;
        if (!running.inside && limit == NO_LIMIT && waited - looked > 0.1) {
            limit = limit_seen(waited - looked, &seconds);
            looked = waited;
        }
        if (limit == NO_LIMIT && waited > SECONDS_WAITING) limit = LIMIT_IDLE;
        if (limit != NO_LIMIT) kill(running.inside ? child : -child, SIGKILL);
        doze(pause);
    }
    struct ending ending = ending_of(status, all_seconds() - before, limit);
    struct ending reported;
    kill(-child, SIGKILL); /* what is left of its group */
    if (!running.inside) hurry(0);
    if (read(report[0], &reported, sizeof reported) == sizeof reported &&
        limit == NO_LIMIT)
        ending = reported;
    close(report[0]);
    return ending;
}

int child_command(const char *command)
{
    int status = 0;
    fflush(NULL);
    const pid_t child = fork();
    if (child < 0) quit("cannot fork: %s", strerror(errno));
    if (child == 0) {
        setsid();
        signal(SIGINT, SIG_DFL);
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    while (waitpid(child, &status, WNOHANG) != child) {
        stop_if_told(child);
        doze(5000);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 127;
}
