/* confine.c - limits of a child, and what it leaves behind; see confine.h. */
#if defined(__linux__)
#define _DEFAULT_SOURCE /* syscall */
#endif
#include "confine.h"

#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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
enum { EXECUTE = 1 << 0, WRITE_FILE = 1 << 1, READ_FILE = 1 << 2 };

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

static long version(void)
{
    return syscall(SYS_landlock_create_ruleset, NULL, 0, 1 /* its version */);
}

/* Rules that allow nothing of these yet, or -1. */
static int rules_for(uint64_t files, uint64_t scopes)
{
    const struct {
        uint64_t files, network, scopes;
    } handled = {files, 0, scopes};
    return (int)syscall(SYS_landlock_create_ruleset, &handled, sizeof handled,
                        0);
}

static void obey(int rules)
{
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    syscall(SYS_landlock_restrict_self, rules, 0);
    close(rules);
}

void child_confine(const char *folder)
{
    const uint64_t remove_dir = 1 << 4, remove_file = 1 << 5;
    const uint64_t make_reg = 1 << 8, make_others = 0x1ec0;
    const uint64_t truncate = version() >= 3 ? 1 << 14 : 0;
    const uint64_t within = WRITE_FILE | remove_file | make_reg | truncate;
    const int rules = rules_for(within | remove_dir | make_others,
                                version() >= 6 ? 1 << 1 : 0 /* signals */);
    if (rules < 0) return;
    allow(rules, folder, within);
    allow(rules, "/dev/null", WRITE_FILE | truncate);
    obey(rules);
}

/* The libraries of this process, which a program of ours has too. */
static void allow_libraries(int rules, FILE *maps)
{
    char line[4200], before[4200] = "";
    while (fgets(line, sizeof line, maps)) {
        const char *path = strchr(line, '/');
        line[strcspn(line, "\n")] = '\0';
        if (!path || !strstr(path, ".so") || !strcmp(path, before)) continue;
        allow(rules, strcpy(before, path), READ_FILE | EXECUTE);
    }
}

void child_see_only(const char *folder, const char *program)
{
    static const char *const system[] = {"/usr", "/lib", "/lib64", "/etc",
                                         "/dev", "/proc", "/sys"};
    FILE *maps = fopen("/proc/self/maps", "r");
    const int rules = maps ? rules_for(READ_FILE | EXECUTE, 0) : -1;
    if (rules >= 0) {
        for (size_t k = 0; k < sizeof system / sizeof *system; k++)
            allow(rules, system[k], READ_FILE);
        allow_libraries(rules, maps);
        if (folder) allow(rules, folder, READ_FILE);
        allow(rules, program, READ_FILE | EXECUTE);
        obey(rules);
    }
    if (maps) fclose(maps);
}
#else
void child_confine(const char *folder) { (void)folder; }
void child_see_only(const char *folder, const char *program)
{
    (void)folder;
    (void)program;
}
#endif
