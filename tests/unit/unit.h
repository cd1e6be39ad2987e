/*
 * unit.h - laws of common/, run under Check, each in a child of its own.
 *
 * A unit file ends with UNIT_MAIN("module", LAW(a), LAW(b) ...), which names
 * its laws, functions without arguments; the program prints "ok module: law" or
 * "FAIL module: law: why" per law and exits with 1 if any failed.  Arguments
 * name the laws to run, or those to leave out, as -law; it exits with 2 if it
 * has not all of them.
 */
#ifndef TESTS_UNIT_UNIT_H
#define TESTS_UNIT_UNIT_H

#include "base/options.h" /* COUNT */

#include <check.h>

struct unit_law {
    const char *name;
    void (*check)(void);
};

int unit_run(const char *module, const struct unit_law laws[], int n, int argc,
             char *argv[]);

#define LAW(name) {#name, name}
#define UNIT_MAIN(module, ...)                                                 \
    int main(int argc, char *argv[])                                           \
    {                                                                          \
        const struct unit_law laws[] = {__VA_ARGS__};                          \
        return unit_run(module, laws, COUNT(laws), argc, argv);                \
    }

/* |got - want| <= tolerance, and got is finite. */
#define close_to(got, want, tolerance)                                         \
    ck_assert_double_eq_tol((got), (want), (tolerance))

/* What a call printed and how it ended: fork, call, collect. */
struct outcome {
    int status; /* exit status */
    char out[8192], err[1024];
};
struct outcome outcome_of(void (*call)(void));

#endif
