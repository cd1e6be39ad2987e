/* table.c - see table.h. */
#include "table.h"

#include "status.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_header(const char *columns)
{
    for (; *columns; columns++) putchar(*columns == ' ' ? '\t' : *columns);
    putchar('\n');
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

void table_row_of(int n, const double value[])
{
    for (int i = 0; i < n; i++)
        printf("%.17g%c", value[i], i + 1 < n ? '\t' : '\n');
}

void table_end(void)
{
    fputs("\n\n", stdout);
}

void table_matrix(const char *name, const struct matrix *A)
{
    table_begin(name, "i j value");
    for (int i = 0; i < A->n; i++)
        for (int j = 0; j < A->n; j++)
            if (abs(i - j) <= A->p) table_row(i, j, matrix_get(A, i, j));
    table_end();
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
