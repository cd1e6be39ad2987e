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

double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

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
