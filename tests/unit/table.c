/* table.c - laws of common/base/table.h. */
#include "base/table.h"
#include "linear/matrix.h"

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

static void print_rows_three_ways(void)
{
    const double number[] = {1, 2.5, -0.75};
    const struct cell row[] = {CELL(1), CELL(2.5), CELL(-0.75)};
    table_begin("rows", "a b c");
    table_row(1, 2.5, -0.75);
    table_row_of(3, number);
    table_row_of(COUNT(row), row);
    table_end();
}

static void arrays_make_the_same_rows(void)
{
    ck_assert_str_eq(outcome_of(print_rows_three_ways).out,
                     "# rows\na\tb\tc\n"
                     "1\t2.5\t-0.75\n"
                     "1\t2.5\t-0.75\n"
                     "1\t2.5\t-0.75\n\n\n");
}

static void print_longest_row(void)
{
    table_begin("longest", "a b c d e f g h i j k l m n o p q r s t u v w x");
    table_row(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,
              19, 20, 21, 22, 23, "end");
    table_end();
}

static void a_row_may_have_24_cells(void)
{
    ck_assert_ptr_nonnull(
        strstr(outcome_of(print_longest_row).out,
               "\n1\t2\t3\t4\t5\t6\t7\t8\t9\t10\t11\t12\t13\t14\t15\t16\t17\t18"
               "\t19\t20\t21\t22\t23\tend\n\n\n"));
}

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

/* ---- whole tables -------------------------------------------------------- */

static void print_whole_tables(void)
{
    const double v[] = {2.385, -1};
    struct matrix *A = matrix_alloc(BANDED, 3, 1);
    for (int i = 0; i < 3; i++) matrix_add(A, i, i, i + 0.5);
    matrix_add(A, 2, 1, -4);
    matrix_table("A", A);
    table_vector("v", 2, v);
    matrix_free(A);
}

static void a_matrix_prints_its_band(void)
{
    ck_assert_str_eq(outcome_of(print_whole_tables).out,
                     "# A\ni\tj\tvalue\n0\t0\t0.5\n0\t1\t0\n1\t0\t0\n"
                     "1\t1\t1.5\n1\t2\t-4\n2\t1\t-4\n2\t2\t2.5\n\n\n"
                     "# v\ni\tvalue\n0\t2.3849999999999998\n1\t-1\n\n\n");
}

/* ---- the end ------------------------------------------------------------- */

static void print_to_full_disk(void)
{
    if (!freopen("/dev/full", "w", stdout)) exit(77);
    print_tables();
}

static void a_full_disk_is_an_error(void)
{
    const struct outcome end = outcome_of(print_to_full_disk);
    if (end.status == 77) return; /* no /dev/full here */
    ck_assert_int_eq(end.status, 1);
    ck_assert(strncmp(end.err, "error: cannot write", 19) == 0);
}

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
    LAW(arrays_make_the_same_rows),
    LAW(a_row_may_have_24_cells),
    LAW(a_row_is_as_long_as_its_header),
    LAW(a_matrix_prints_its_band),
    LAW(a_full_disk_is_an_error),
    LAW(an_error_is_not_forgotten))
