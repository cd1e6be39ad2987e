/* clock.c - see clock.h. */
#include "base/clock.h"

#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>

#ifndef BUILD_FLAGS
#define BUILD_FLAGS ""
#endif
#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

static double told(clockid_t which)
{
    struct timespec t;
    if (clock_gettime(which, &t) != 0) clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double clock_seconds(void) { return told(CLOCK_MONOTONIC); }
double clock_processor(void) { return told(CLOCK_PROCESS_CPUTIME_ID); }

void clock_machine(size_t size, char text[])
{
    struct utsname system = {.machine = "unknown"};
    char processor[128] = "", line[256];
    FILE *cpuinfo = fopen("/proc/cpuinfo", "r"); /* Linux; elsewhere uname */

    while (cpuinfo && !*processor && fgets(line, sizeof line, cpuinfo))
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':'))
            snprintf(processor, sizeof processor, "%.100s",
                     strchr(line, ':') + 2);
    if (cpuinfo) fclose(cpuinfo);
    processor[strcspn(processor, "\n")] = '\0';
    uname(&system);
    snprintf(text, size, "%s, %s%s%s", *processor ? processor : system.machine,
             COMPILER, *BUILD_FLAGS ? " " : "", BUILD_FLAGS);
}
