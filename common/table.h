/*
 * table.h - named tables on stdout, the only format that programs print.
 *
 *     # nodes              a name,
 *     # n = 4              further comment lines where useful,
 *     x	u             a header row of column names,
 *     0	1             rows of numbers (%.17g), tab-separated,
 *     0.25	0.97706       and two blank lines after the last row.
 *
 * gnuplot reads this as it is: plot "file" index "nodes" using "x":"u".
 */
#ifndef COMMON_TABLE_H
#define COMMON_TABLE_H

#include "matrix.h"

/* Start the table `name`; `columns` are its column names, space-separated. */
void table_begin(const char *name, const char *columns);

/* The same with one comment line between name and header. */
void table_begin_note(const char *name, const char *columns, const char *note,
                      ...) __attribute__((format(printf, 3, 4)));

/* One row; as many numbers as there are columns: table_row(x, u); */
#define table_row(...)                                             \
    table_row_of((int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)), \
                 (const double[]){__VA_ARGS__})
void table_row_of(int n, const double value[]);

/* End the table. */
void table_end(void);

/* A whole table of the entries of A within its band: columns i j value. */
void table_matrix(const char *name, const struct matrix *A);

/* A whole table of a vector: columns i value. */
void table_vector(const char *name, int n, const double v[]);

/*
 * Flush stdout and return the program's exit status, EXIT_SUCCESS.  Output
 * that could not be written (full disk, closed pipe) is die(): a truncated
 * table never goes with exit status 0.
 */
int table_finish(void);

#endif
