/* table.c - laws of common/base/table.h. */
#include "base/table.h"

#include "unit.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_tables(void)
{
    table_begin("first", "x u");
    table_row(0, 0.1);
    table_row(1, -2.0 / 3.0);
    table_row(cell_rounded(2, 14.0), cell_rounded(4, -0.02384999));
    table_end();
    table_begin_note("second", "k", "n = %d", 7);
    table_row(3);
    table_end();
    exit(table_finish());
}

static void tables_have_their_format(void)
{
    const struct outcome end = outcome_of(print_tables);
    ck_assert_int_eq(end.status, 0);
    ck_assert_str_eq(end.err, "");
    ck_assert_str_eq(end.out,
                     "# first\nx\tu\n0\t0.10000000000000001\n"
                     "1\t-0.66666666666666663\n"
                     "1.4e+01\t-2.385e-02\n\n\n"
                     "# second\n# n = 7\nk\n3\n\n\n");
}

/* ---- numbers ------------------------------------------------------------- */

enum { N_NUMBER = 250 };

/* Doubles of any size, bit patterns of a generator of 64 bits, then the ends
 * of the range. */
static void fill_numbers(double number[N_NUMBER])
{
    const double ends[] = {DBL_MAX, -DBL_MAX,      DBL_MIN, DBL_TRUE_MIN,
                           -0.0,    1.0 + DBL_EPSILON, 0.1,     1.0 / 3.0};
    uint64_t bits = 2385;
    for (int i = 0; i < N_NUMBER;) {
        bits = bits * 6364136223846793005u + 1442695040888963407u;
        const uint64_t mixed = bits ^ bits >> 29;
        memcpy(&number[i], &mixed, sizeof mixed);
        if (isfinite(number[i])) i++;
    }
    memcpy(number, ends, sizeof ends);
}

static void print_numbers(void)
{
    double number[N_NUMBER];
    fill_numbers(number);
    table_begin("numbers", "x");
    for (int i = 0; i < N_NUMBER; i++) table_row(number[i]);
    table_end();
}

static void numbers_come_back_exactly(void)
{
    double number[N_NUMBER];
    fill_numbers(number);
    const struct outcome end = outcome_of(print_numbers);
    const char *rest = strstr(end.out, "\nx\n") + 2;
    for (int i = 0; i < N_NUMBER; i++) {
        char *next;
        const double back = strtod(rest, &next);
        ck_assert_msg(next != rest, "number %d is not there", i);
        ck_assert_msg(memcmp(&back, &number[i], sizeof back) == 0,
                      "number %d, %a, comes back as %a", i, number[i], back);
        rest = next;
    }
}

/* ---- words --------------------------------------------------------------- */

static void print_words(void)
{
    char law[] = "log";
    const char *const reason = "not positive definite";
    const int steps = 7;
    const struct cell found = cell_if(1, 2.385), none = cell_if(0, 2.385);

    table_begin("words", "scene law steps x y z reason");
    table_row("stretch", law, steps, 0.5, MISSING, found, reason);
    table_row(law + 1, "-1.5e3x", 'a' - 90, 1 < 2, none, cell_if(0, NAN), "q");
    table_end();
}

static void words_and_missing_print_as_they_are(void)
{
    ck_assert_str_eq(
        outcome_of(print_words).out,
        "# words\nscene\tlaw\tsteps\tx\ty\tz\treason\n"
        "stretch\tlog\t7\t0.5\t-\t2.3849999999999998\tnot positive definite\n"
        "og\t-1.5e3x\t7\t1\t-\t-\tq\n\n\n");
}

static void print_not_finite(void)
{
    table_begin("not_finite", "a b c");
    table_row(fabs(NAN), cell_if(1, fabs(NAN)), INFINITY);
    table_end();
}

/* Otherwise a NaN would pass for a value that there is not. */
static void a_nan_is_not_missing(void)
{
    ck_assert_str_eq(outcome_of(print_not_finite).out,
                     "# not_finite\na\tb\tc\nnan\tnan\tinf\n\n\n");
}

static const char *word_given;
static void print_given_word(void)
{
    cell_word(word_given);
}

static void a_word_fits_into_its_cell(void)
{
    static const char *const bad[] = {"", "a\tb", "a\nb", "ab\r", NULL};
    for (int i = 0; i < COUNT(bad); i++) {
        word_given = bad[i];
        ck_assert_msg(strstr(outcome_of(print_given_word).err, "Assert"),
                      "word %d is taken", i);
    }
    word_given = "a word of three or more";
    ck_assert_int_eq(outcome_of(print_given_word).status, 0);
}

/* ---- rows ---------------------------------------------------------------- */

static int cells_given, as_cells;
static void print_given_row(void)
{
    static const double number[4] = {0};
    static const struct cell row[4] = {{0}};
    table_begin("before", "a b");
    table_row(1, 2);
    table_end();
    table_begin("three", "a b c");
    if (as_cells)
        table_row_of(cells_given, row);
    else
        table_row_of(cells_given, number);
    table_end();
}

static void a_row_is_as_long_as_its_header(void)
{
    for (as_cells = 0; as_cells <= 1; as_cells++)
        for (cells_given = 1; cells_given <= 4; cells_given++) {
            const struct outcome end = outcome_of(print_given_row);
            ck_assert_msg((end.status == 0) == (cells_given == 3),
                          "%d cells for 3 columns: status %d", cells_given,
                          end.status);
            ck_assert(end.status == 0 || strstr(end.err, "Assert"));
        }
}

/* ---- the end ------------------------------------------------------------- */

/* What cannot be written is an error where nothing is left to write as well. */
static void print_to_what_is_read(void)
{
    if (!freopen("/dev/null", "r", stdout)) exit(77);
    setvbuf(stdout, NULL, _IONBF, 0);
    print_tables();
}

static void an_error_is_not_forgotten(void)
{
    const struct outcome end = outcome_of(print_to_what_is_read);
    ck_assert_int_eq(end.status, 1);
    ck_assert(strncmp(end.err, "error: cannot write", 19) == 0);
}

UNIT_MAIN("table",
    LAW(tables_have_their_format),
    LAW(numbers_come_back_exactly),
    LAW(words_and_missing_print_as_they_are),
    LAW(a_nan_is_not_missing),
    LAW(a_word_fits_into_its_cell),
    LAW(a_row_is_as_long_as_its_header),
    LAW(an_error_is_not_forgotten))
