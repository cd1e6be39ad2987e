/* tables.c - inside a check: what stands in a program's tables; see judge.h. */
#include "judging.h"

#include <string.h>

int has_table(const struct output *output, const char *table)
{
    return find_table(output, table) != NULL;
}

static const struct named_table *the_table(const struct output *output,
                                           const char *table)
{
    const struct named_table *found = find_table(output, table);
    if (!found) wrong("the program prints no table `%s`", table);
    return found;
}

int row_count(const struct output *output, const char *table)
{
    return the_table(output, table)->n_row;
}

static int the_column(const struct named_table *table, const char *name)
{
    const int c = find_column(table, name);
    if (c < 0) wrong("table `%s` has no column `%s`", table->name, name);
    return c;
}

static int the_row(const struct named_table *table, int row)
{
    const int r = row < 0 ? row + table->n_row : row;
    if (r < 0 || r >= table->n_row)
        wrong("table `%s` has %d rows; there is no row %d", table->name,
              table->n_row, row < 0 ? row : row + 1);
    return r;
}

static void expect_number(const struct named_table *table, int c, int r)
{
    if (word_at(table, c, r))
        wrong("table `%s`, row %d, column `%s`: the word %s stands where a "
              "number is due",
              table->name, r + 1, table->column[c], word_at(table, c, r));
}

const double *column(const struct output *output, const char *table,
                     const char *name, int *n)
{
    const struct named_table *found = the_table(output, table);
    const int c = the_column(found, name);
    if (found->n_row == 0) wrong("table `%s` has no rows", table);
    for (int r = 0; r < found->n_row; r++) expect_number(found, c, r);
    if (n) *n = found->n_row;
    return found->value + c * found->capacity;
}

double cell(const struct output *output, const char *table, const char *name,
            int row)
{
    const struct named_table *found = the_table(output, table);
    const int c = the_column(found, name), r = the_row(found, row);
    expect_number(found, c, r);
    return number_at(found, c, r);
}

const char *word(const struct output *output, const char *table,
                 const char *name, int row)
{
    const struct named_table *found = the_table(output, table);
    const int c = the_column(found, name), r = the_row(found, row);
    if (!word_at(found, c, r))
        wrong("table `%s`, row %d, column `%s`: the number %.10g stands where "
              "a word is due",
              table, r + 1, name, number_at(found, c, r));
    return word_at(found, c, r);
}

int is_missing(const struct output *output, const char *table,
               const char *name, int row)
{
    const struct named_table *found = the_table(output, table);
    const int c = the_column(found, name), r = the_row(found, row);
    return word_at(found, c, r) && strcmp(word_at(found, c, r), "-") == 0;
}
