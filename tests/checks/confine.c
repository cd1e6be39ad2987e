/* confine.c - limits of a child, and what it leaves behind; see confine.h. */
#if defined(__linux__)
#define _DEFAULT_SOURCE /* syscall */
#endif
#include "confine.h"

#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

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

void child_set_limits(void)
{
    const rlim_t output = (rlim_t)MEGABYTES_OUTPUT << 20;
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, output, output);
    limit(RLIMIT_CPU, SECONDS_COMPUTING, SECONDS_COMPUTING + 1);
#if !defined(__APPLE__)
    const char *sanitized = getenv("SANITIZED"); /* takes all addresses */
    const rlim_t memory = (rlim_t)MEGABYTES_MEMORY << 20;
    if (!sanitized || !*sanitized) limit(RLIMIT_AS, memory, memory);
#endif
#if defined(__linux__)
    /* Some more than all that there are now, whose ever they are, so that too
     * many are seen; root has no limit, and kill_all() is all there is. */
    unsigned long all = 0;
    FILE *file = fopen("/proc/loadavg", "r");
    if (file && fscanf(file, "%*f %*f %*f %*u/%lu", &all) == 1)
        limit(RLIMIT_NPROC, all + 2 * MOST_PROCESSES,
              all + 2 * MOST_PROCESSES);
    if (file) fclose(file);
#endif
}

/* The C library has no names for this yet: linux/landlock.h. */
#if defined(SYS_landlock_create_ruleset) && !defined(WITHOUT_LANDLOCK)
static void allow(int rules, const char *path, uint64_t access)
{
    struct {
        uint64_t access;
        int32_t file;
    } __attribute__((packed)) beneath = {access, open(path, O_RDONLY)};
    enum { PATH_BENEATH = 1 };
    if (beneath.file < 0) return;
    syscall(SYS_landlock_add_rule, rules, PATH_BENEATH, &beneath, 0);
    close(beneath.file);
}

void child_confine(const char *folder)
{
    const uint64_t write_file = 1 << 1, remove_dir = 1 << 4,
                   remove_file = 1 << 5, make_reg = 1 << 8,
                   make_others = 0x1ec0, truncate = 1 << 14;
    struct {
        uint64_t files, network, scopes;
    } handled = {write_file | remove_dir | remove_file | make_reg | make_others,
                 0, 0};
    const long version =
        syscall(SYS_landlock_create_ruleset, NULL, 0, 1 /* its version */);
    if (version < 1) return;
    if (version >= 3) handled.files |= truncate;
    if (version >= 6) handled.scopes = 1 << 1; /* signals */
    const int rules = (int)syscall(SYS_landlock_create_ruleset, &handled,
                                   sizeof handled, 0);
    if (rules < 0) return;
    allow(rules, folder,
          handled.files & (write_file | remove_file | make_reg | truncate));
    allow(rules, "/dev/null", handled.files & (write_file | truncate));
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    syscall(SYS_landlock_restrict_self, rules, 0);
    close(rules);
}
#else
void child_confine(const char *folder) { (void)folder; }
#endif
