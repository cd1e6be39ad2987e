/* options.c - laws of common/base/options.h and status.h. */
#include "base/options.h"

#include "base/status.h"
#include "unit.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct {
    int n, way;
    double beta;
    const char *name;
} got;

/* Parse "--n 8 ..." with the table of an imaginary program. */
static void parse(const char *line)
{
    static char words[256]; /* a text option borrows from it */
    char *argv[16] = {"prog"};
    int argc = 1;
    snprintf(words, sizeof words, "%s", line);
    for (char *w = strtok(words, " "); w; w = strtok(NULL, " "))
        argv[argc++] = w;
    got.n = 4;
    got.way = 1;
    got.beta = 2.385;
    got.name = "hard";
    const struct option table[] = {
        {"n", .integer = &got.n, .min = 1, .max = 1000, .help = "elements"},
        {"beta", .real = &got.beta, .min = 0, .max = 1e9, .unit = "N",
         .help = "coefficient", .why = "negative is unstable"},
        {"way", .choice = &got.way, .choices = "keep one", .help = "way"},
        {"file", .text = &got.name, .unit = "a file's name", .help = "input"},
    };
    options_parse("prog", table, COUNT(table), argc, argv);
}

static void values_are_set(void)
{
    parse("");
    ck_assert(got.n == 4 && got.way == 1 && got.beta == 2.385);
    ck_assert_str_eq(got.name, "hard");
    parse("--n 8 --beta=3.714e2 --way keep");
    ck_assert(got.n == 8 && got.way == 0 && got.beta == 371.4);
    parse("--n 8 --n 9");
    ck_assert(got.n == 9);
    parse("--beta 1e-310"); /* strtod() says ERANGE; the range has it */
    ck_assert(got.beta == 1e-310);
    parse("--n 1000 --beta 0");
    ck_assert(got.n == 1000 && got.beta == 0.0);
    parse("--n 1 --beta 1e9");
    ck_assert(got.n == 1 && got.beta == 1e9);
    parse("--file a=b");
    ck_assert_str_eq(got.name, "a=b");
    parse("--file=--n");
    ck_assert_str_eq(got.name, "--n");
}

static const char *line_given;
static void parse_given_line(void)
{
    parse(line_given);
    puts("went on");
}

static void bad_input_is_one_line_and_status_2(void)
{
    char long_word[230];
    memset(long_word, '7', sizeof long_word);
    memcpy(long_word, "--n=", 4);
    long_word[sizeof long_word - 1] = '\0';
    const char *const bad[] = {
        "--n 0",        "--n -3",     "--n 1e9",
        "--n abc",      "--n 4x",     "--n nan",
        "--n",          "--n=",       "--n 1001",
        "--beta nan",   "--beta -0.1", "--beta inf",
        "--beta 1e10",  "--beta 2,5", "--way two",
        "--way ke",     "--way",      "--what 3",
        "-n 3",         "stray",      "--n 99999999999999999999",
        "--beta 1e999", "--n 4\n5",   "--a\nb 3",
        "a\nb",        "--way=keep\r", long_word,
        "--file",       "--file=",
    };
    for (int i = 0; i < COUNT(bad); i++) {
        line_given = bad[i];
        const struct outcome end = outcome_of(parse_given_line);
        ck_assert_msg(end.status == 2, "%s: status %d", bad[i], end.status);
        ck_assert_msg(end.out[0] == '\0', "%s: printed %s", bad[i], end.out);
        ck_assert_msg(strchr(end.err, '\n') == end.err + strlen(end.err) - 1,
                      "%s: not one line: %s", bad[i], end.err);
        ck_assert_msg(strncmp(end.err, "prog: ", 6) == 0, "%s", end.err);
        ck_assert_msg(strstr(end.err, ": must be ") ||
                      strstr(end.err, "; -h lists them"), "%s", end.err);
    }
}

static void message_names_option_value_and_range(void)
{
    line_given = "--n 4x";
    ck_assert_str_eq(outcome_of(parse_given_line).err,
                     "prog: --n 4x: must be a whole number from 1 to 1000\n");
    line_given = "--beta -1";
    ck_assert_str_eq(
        outcome_of(parse_given_line).err,
        "prog: --beta -1: must be a number from 0 to 1000000000 N; "
        "negative is unstable\n");
    line_given = "--way two";
    ck_assert_str_eq(outcome_of(parse_given_line).err,
                     "prog: --way two: must be one of: keep one\n");
    line_given = "--n";
    ck_assert_str_eq(
        outcome_of(parse_given_line).err,
        "prog: --n has no value: must be a whole number from 1 to 1000\n");
    line_given = "--file=";
    ck_assert_str_eq(outcome_of(parse_given_line).err,
                     "prog: --file : must be a file's name\n");
    line_given = "--what=3";
    ck_assert_str_eq(outcome_of(parse_given_line).err,
                     "prog: no option --what; -h lists them\n");
    line_given = "stray";
    ck_assert_str_eq(outcome_of(parse_given_line).err,
                     "prog: 'stray' is not an option; -h lists them\n");
}

static void help_lists_the_options(void)
{
    line_given = "-h";
    const struct outcome end = outcome_of(parse_given_line);
    ck_assert_int_eq(end.status, 0);
    ck_assert_str_eq(
        end.out,
        "usage: prog [--option value] ...\n"
        "  --n          elements [4]; a whole number from 1 to 1000\n"
        "  --beta       coefficient [2.385]; a number from 0 to 1000000000"
        " N; negative is unstable\n"
        "  --way        way [one]; one of: keep one\n"
        "  --file       input [hard]; a file's name\n");
    ck_assert_str_eq(end.err, "");
    line_given = "--n 7 --help";
    ck_assert_int_eq(outcome_of(parse_given_line).status, 0);
    ck_assert_ptr_nonnull(strstr(outcome_of(parse_given_line).out, "[7]"));
}

static void ask_for_too_much(void)
{
    volatile size_t n = SIZE_MAX / 8;
    allocate(n, 16);
}

static void no_memory_is_said(void)
{
    char want[80];
    const struct outcome end = outcome_of(ask_for_too_much);
    snprintf(want, sizeof want, "error: out of memory: %zu x 16 bytes\n",
             SIZE_MAX / 8);
    ck_assert_int_eq(end.status, 1);
    ck_assert_ptr_nonnull(strstr(end.err, want)); /* a sanitizer says more */
    double *some = allocate(3, sizeof *some), *none = allocate(0, sizeof *none);
    ck_assert(some[0] == 0.0 && some[1] == 0.0 && some[2] == 0.0);
    ck_assert_ptr_nonnull(none);
    free(some);
    free(none);
}

static void statuses_have_names(void)
{
    ck_assert_str_eq(status_name(OK), "OK");
    ck_assert_str_eq(status_name(NOT_SPD), "NOT_SPD");
    ck_assert_str_eq(status_name(INCOMPATIBLE), "INCOMPATIBLE");
    ck_assert_str_eq(status_name(NONFINITE), "NONFINITE");
    ck_assert_str_eq(status_name(INVERTED), "INVERTED");
    ck_assert_str_eq(status_name(STALLED), "STALLED");
    ck_assert_str_eq(status_name(SADDLE), "SADDLE");
    ck_assert_str_eq(status_name(MAX_ITERATIONS), "MAX_ITERATIONS");
    ck_assert_str_eq(status_name(OUTSIDE), "OUTSIDE");
}

UNIT_MAIN("options",
    LAW(values_are_set),
    LAW(bad_input_is_one_line_and_status_2),
    LAW(message_names_option_value_and_range),
    LAW(help_lists_the_options),
    LAW(no_memory_is_said),
    LAW(statuses_have_names))
