/*
 * output.h - running a program in a child, and reading the tables it prints.
 */
#ifndef TESTS_CHECKS_OUTPUT_H
#define TESTS_CHECKS_OUTPUT_H

#include <stddef.h>

enum {
    SECONDS_A_CHECK = 5,
    MEGABYTES_OUTPUT = 8,
    GIGABYTES_MEMORY = 4,
    MAX_TABLES = 64,
    MAX_COLUMNS = 32
};

/* The judge itself cannot go on: one line on stderr, exit status 2. */
_Noreturn void quit(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

struct named_table {
    char name[64];
    int n_column, n_row;
    char column[MAX_COLUMNS][64];
    double *value; /* [n_column][capacity] by columns; owned */
    int capacity;
};

struct output {
    int status;  /* exit status, or -signal */
    int n_table; /* where status is not 0: 1 if anything was printed */
    struct named_table table[MAX_TABLES];
    char error[512];   /* what is wrong with the format, or "" */
    char stderr_[512]; /* last line on stderr, or "" */
};

/*
 * Run `program`, or program_main() of the program under test when it is NULL,
 * in a child with limits on time, memory and output, and read its tables.
 * options are split at spaces; `folder` is for captured output.
 */
struct output *output_of(const char *program, const char *options,
                         const char *folder);
void output_free(struct output *output);

const struct named_table *find_table(const struct output *output,
                                     const char *name);
const double *find_column(const struct named_table *table, const char *name);

/* Limits for this process; stdout or stderr into a file; a file's last line. */
void set_limits(void);
void redirect(int fd, const char *path);
void last_line(const char *path, size_t size, char text[]);

#endif
