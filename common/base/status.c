/* status.c - see status.h. */
#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

const char *status_name(enum status status)
{
    static const char *const name[] = {
        "OK",      "NOT_SPD", "INCOMPATIBLE",   "NONFINITE", "INVERTED",
        "STALLED", "SADDLE",  "MAX_ITERATIONS", "OUTSIDE"};
    return name[status];
}

void die(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("error: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

void *allocate(size_t n, size_t size)
{
    void *memory = calloc(n ? n : 1, size);
    if (!memory) die("out of memory: %zu x %zu bytes", n, size);
    return memory;
}

void todo(const char *slot, ...)
{
    fprintf(stderr, "unfinished: slot %s is not written yet\n", slot);
    exit(3);
}
