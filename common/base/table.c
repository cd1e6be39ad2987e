/* table.c - see table.h. */
#include "base/table.h"

#include "base/status.h"

#include <assert.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int n_column; /* of the table begun last, which every row is held to */

static void print_header(const char *columns)
{
    n_column = 1;
    for (; *columns; columns++) {
        if (*columns == ' ') n_column++;
        putchar(*columns == ' ' ? '\t' : *columns);
    }
    putchar('\n');
}

struct cell cell_number(double number)
{
    return (struct cell){.number = number};
}

struct cell cell_word(const char *word)
{
    assert(word && *word && !strpbrk(word, "\t\r\n"));
    return (struct cell){.word = word};
}

struct cell cell_itself(struct cell cell)
{
    return cell;
}

struct cell cell_if(int present, double number)
{
    return present ? cell_number(number) : cell_word(MISSING);
}

struct cell cell_rounded(int digits, double number)
{
    assert(digits > 1); /* 1e-10 is a number that has no others */
    return (struct cell){.number = number, .digits = digits};
}

void table_begin(const char *name, const char *columns)
{
    printf("# %s\n", name);
    print_header(columns);
}

void table_begin_note(const char *name, const char *columns, const char *note,
                      ...)
{
    va_list arguments;
    va_start(arguments, note);
    printf("# %s\n# ", name);
    vprintf(note, arguments);
    putchar('\n');
    va_end(arguments);
    print_header(columns);
}

static void print_cell(struct cell cell, int last)
{
    if (cell.word)
        fputs(cell.word, stdout);
    else if (cell.digits)
        printf("%.*e", cell.digits - 1, cell.number);
    else
        printf("%.17g", cell.number);
    putchar(last ? '\n' : '\t');
}

void table_cells(int n, const struct cell row[])
{
    assert(n == n_column);
    for (int i = 0; i < n; i++) print_cell(row[i], i + 1 == n);
}

void table_numbers(int n, const double row[])
{
    assert(n == n_column);
    for (int i = 0; i < n; i++) print_cell(cell_number(row[i]), i + 1 == n);
}

void table_end(void)
{
    fputs("\n\n", stdout);
}

void table_vector(const char *name, int n, const double v[])
{
    table_begin(name, "i value");
    for (int i = 0; i < n; i++) table_row(i, v[i]);
    table_end();
}

int table_finish(void)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        die("cannot write the output: %s", strerror(errno));
    return EXIT_SUCCESS;
}
