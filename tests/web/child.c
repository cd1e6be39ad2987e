/*
 * child.c - child.h in a page: a child is a copy of this instance of the
 * program, which lessons/web/student_judge.js makes and runs to its end.
 */
#include "child.h"
#include "judge.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

/* What the page does. */
int page_run(void (*body)(void *), void *context, const char *out,
             const char *err, int handed, enum limit *limit);
void page_pair(int both[2]);
double page_seconds(void);
void page_limit(double seconds);
_Noreturn void page_signal(int number);

#pragma weak program_main /* a scene has none */
static int handed;
static double spent;

struct ending child_run(void (*body)(void *), void *context, const char *out,
                        const char *err)
{
    struct ending ending = {0, NO_LIMIT};
    fflush(NULL);
    ending.status = page_run(body, context, out, err, handed, &ending.limit);
    return ending;
}

/* In the copy. */
_Noreturn void page_body(void (*body)(void *), void *context)
{
    handed = 0;
    body(context);
    fflush(NULL);
    _exit(0);
}

void child_hand_over(int descriptor) { handed = descriptor; }

/* The judge of a known mistake is a file with what it says to the check that
 * catches it.  Where that is made, the program is the one that is compiled in,
 * with a mistake that the environment chooses (tests/tools/web_kept.mjs). */
void child_become(const char *program, char *const argv[])
{
    char text[1100], path[400];
    FILE *judge = fopen(program, "r");
    for (int n = 0; !judge && getenv("MISTAKE"); n++)
        if (!argv[n]) exit(program_main(n, (char **)argv));
    if (!judge || !argv[4]) return;
    text[fread(text, 1, sizeof text - 1, judge)] = '\0';
    snprintf(path, sizeof path, "%s/judge.message", argv[4]);
    FILE *message = fopen(path, "w");
    if (!message) return;
    fputs(text, message);
    fclose(message);
    _exit(1);
}

void child_on_interrupt(void (*interrupted)(void)) { (void)interrupted; }
void child_work_in(const char *folder, const char *stranger)
{
    (void)folder, (void)stranger;
}
void child_am_inside(void) {}
int child_command(const char *command)
{
    (void)command;
    return 127;
}

void child_restart_clock(void) { spent = page_seconds(); }
double child_seconds(void) { return page_seconds() - spent; }
void child_spend(double seconds) { spent -= seconds; }

/* ---- of POSIX ------------------------------------------------------------ */

int setrlimit(int resource, const struct rlimit *limit)
{
    (void)resource;
    page_limit((double)limit->rlim_cur);
    return 0;
}

int socketpair(int domain, int type, int protocol, int both[2])
{
    (void)domain, (void)type, (void)protocol;
    page_pair(both);
    return 0;
}

ssize_t recv(int socket, void *to, size_t size, int flags)
{
    (void)flags;
    return read(socket, to, size);
}

char *mkdtemp(char *name)
{
    memset(name + strlen(name) - 6, 'a', 6);
    return mkdir(name, 0700) < 0 ? NULL : name;
}

int mkstemp(char *name)
{
    memset(name + strlen(name) - 6, 'a', 6);
    return open(name, O_RDWR | O_CREAT | O_EXCL);
}

mode_t umask(mode_t mode) { return mode = 0; }
int pause(void) { page_signal(9); }
int madvise(void *at, size_t size, int advice)
{
    (void)at, (void)size, (void)advice;
    return 0;
}

/* ---- how a program ends, in the words of glibc --------------------------- */

void abort(void) { page_signal(6); }
_Noreturn void __assert_fail(const char *claim, const char *file, int line,
                             const char *function)
{
    fprintf(stderr, "judge: %s:%d: %s: Assertion `%s' failed.\n", file, line,
            function, claim);
    page_signal(6);
}
void __ubsan_handle_type_mismatch_minimal_abort(void) { page_signal(11); }

char *strsignal(int number)
{
    return (char *)(number == 4    ? "Illegal instruction"
                    : number == 6  ? "Aborted"
                    : number == 8  ? "Floating point exception"
                    : number == 11 ? "Segmentation fault"
                                   : "Unknown signal");
}

/* ---- the heap is counted: malloc() is linked to __wrap_malloc() ---------- */

static unsigned long on_heap;
size_t malloc_usable_size(void *);

#define COUNTED(name, parameters, arguments)        \
    void *__real_##name parameters;                 \
    void *__wrap_##name parameters                  \
    {                                               \
        void *new = __real_##name arguments;        \
        on_heap += malloc_usable_size(new);         \
        return new;                                 \
    }
COUNTED(malloc, (size_t size), (size))
COUNTED(calloc, (size_t n, size_t size), (n, size))
COUNTED(aligned_alloc, (size_t align, size_t size), (align, size))

void *__real_realloc(void *old, size_t size);
void *__wrap_realloc(void *old, size_t size)
{
    const size_t before = malloc_usable_size(old);
    void *new = __real_realloc(old, size);
    if (new || size == 0) on_heap += malloc_usable_size(new) - before;
    return new;
}

int __real_posix_memalign(void **to, size_t align, size_t size);
int __wrap_posix_memalign(void **to, size_t align, size_t size)
{
    const int status = __real_posix_memalign(to, align, size);
    if (status == 0) on_heap += malloc_usable_size(*to);
    return status;
}

void __real_free(void *old);
void __wrap_free(void *old)
{
    on_heap -= malloc_usable_size(old);
    __real_free(old);
}

struct mallinfo2 mallinfo2(void) { return (struct mallinfo2){on_heap, 0}; }
