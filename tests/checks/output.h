/*
 * output.h - running a program in a child, and reading the tables it prints.
 */
#ifndef TESTS_CHECKS_OUTPUT_H
#define TESTS_CHECKS_OUTPUT_H

#include "child.h"

#include <stdio.h>

enum {
    MAX_TABLES = 64,
    MAX_COLUMNS = 32
};

/* The judge itself cannot go on: one line on stderr, exit status 2. */
_Noreturn void quit(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

/* What quit() calls first, or NULL. */
extern void (*before_quit)(void);

/* A path in the folder of a judge, or the judge's own. */
enum { PATH_SIZE = 4096 };

/*
 * A cell is a number when strtod takes the whole of it, nan and inf too, and
 * a word otherwise; `value` of a word is NaN, `word` of a number NULL.  Both
 * are arrays [n_column][capacity], by columns, and owned.
 */
struct named_table {
    char name[64];
    int n_column, n_row;
    char column[MAX_COLUMNS][64];
    double *value;
    char **word;
    int capacity;
};

struct output {
    int status;  /* exit status, or -signal */
    enum limit limit;
    int printed; /* whether there is anything on stdout */
    int n_table; /* tables are read where status is 0 or 1 */
    struct named_table table[MAX_TABLES];
    char error[512];   /* what is wrong with the format, or "" */
    char stderr_[512]; /* last line on stderr, or "" */
    void (*stray)(const char *line); /* takes what is not of the format,
                                      * which is no error then; or NULL */
};

/*
 * Run `program`, or program_main() of the program under test when it is NULL,
 * in a child with limits on time, memory and output, and read its tables.
 * options are split at spaces; `folder` is for captured output.
 */
struct output *output_of(const char *program, const char *options,
                         const char *folder);
/* The same in two steps, by way of the files out and err. */
struct ending output_run(const char *program, const char *options,
                         const char *out, const char *err);
struct output *output_read_back(struct ending ending, const char *out,
                                const char *err);
void output_free(struct output *output);

/* The tables of a file, whatever else is in it: lines that belong to no table,
 * and a last line that was cut off, go to stray().  Without the file there are
 * none. */
struct output *output_read(const char *path, void (*stray)(const char *line));

const struct named_table *find_table(const struct output *output,
                                     const char *name);
/* The index of a column, or -1. */
int find_column(const struct named_table *table, const char *name);

/* One cell: its number, NaN for a word; its word, NULL for a number. */
double number_at(const struct named_table *table, int column, int row);
const char *word_at(const struct named_table *table, int column, int row);

/* A file that is no pipe, terminal or the like; NULL if there is none. */
FILE *open_regular(const char *path);

/* The last line of a file that is not empty, or "". */
void last_line(const char *path, size_t size, char text[]);

#endif
