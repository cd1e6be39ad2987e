/*
 * table.h - named tables on stdout, the only format that programs print.
 *
 *     # nodes                     a name,
 *     # n = 4                     further comment lines where useful,
 *     method	x	u            a header row of column names,
 *     exact	0	1            rows of cells, tab-separated,
 *     newton	0.25	0.97706
 *     newton	0.5	-            and two blank lines after the last row.
 *
 * A cell is a number (%.17g, which strtod turns back into the same double, but
 * for cell_rounded()) or a word: the name of a scene, a law, a method, a
 * reason.  The word `-` stands where a value is missing.
 *
 * gnuplot reads this as it is: plot "file" index "nodes" using "x":"u".
 *
 * Names: cell_.
 */
#ifndef COMMON_TABLE_H
#define COMMON_TABLE_H

struct cell {
    const char *word; /* borrowed; NULL: the cell is the number */
    double number;
    int digits;       /* that are printed; 0: all */
};

/* For a value that is missing; a NaN that was computed stays a NaN. */
#define MISSING "-"

struct cell cell_number(double number);
struct cell cell_word(const char *word); /* not empty, no tab, no newline */
struct cell cell_itself(struct cell cell);

/* The number where it is present, else MISSING. */
struct cell cell_if(int present, double number);

/* The number to so many digits, as 2.385e+00, because the others are amplified
 * round-off, which no two machines have in common; the last of them may be one
 * more or less on another. */
struct cell cell_rounded(int digits, double number);

/* The cell of a number, a word, or a cell. */
#define CELL(x)                                           \
    _Generic((x),                                         \
        char *: cell_word,                                \
        const char *: cell_word,                          \
        struct cell: cell_itself,                         \
        default: cell_number)(x)

/* Start the table `name`; `columns` are its column names, space-separated. */
void table_begin(const char *name, const char *columns);

/* The same with one comment line between name and header. */
void table_begin_note(const char *name, const char *columns, const char *note,
                      ...) __attribute__((__format__(__printf__, 3, 4)));

/*
 * One row, a cell for each column, at most 24 of them:
 *
 *     table_row("stretch", n, 0.5, MISSING, status_name(s));
 *
 * The countdown behind the arguments fills up the parameters a to y, and the
 * number of it that falls to `n` is the number of the arguments.
 */
#define table_row(...)                                                      \
    TABLE_ROW(__VA_ARGS__, 24, 23, 22, 21, 20, 19, 18, 17, 16, 15, 14, 13,  \
              12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)
#define TABLE_ROW(a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q, r, s, t,  \
                  u, v, w, x, y, n, ...)                                    \
    table_cells(n, (const struct cell[]){                                   \
        CELL(a), CELL(b), CELL(c), CELL(d), CELL(e), CELL(f), CELL(g),      \
        CELL(h), CELL(i), CELL(j), CELL(k), CELL(l), CELL(m), CELL(o),      \
        CELL(p), CELL(q), CELL(r), CELL(s), CELL(t), CELL(u), CELL(v),      \
        CELL(w), CELL(x), CELL(y)})

/* One row from an array of n cells, or of n doubles. */
#define table_row_of(n, row)                    \
    _Generic(&(row)[0],                         \
        struct cell *: table_cells,             \
        const struct cell *: table_cells,       \
        double *: table_numbers,                \
        const double *: table_numbers)(n, row)
void table_cells(int n, const struct cell row[]);
void table_numbers(int n, const double row[]);

/* End the table. */
void table_end(void);

/* A whole table of a vector: columns i value. */
void table_vector(const char *name, int n, const double v[]);

/*
 * Flush stdout and return the program's exit status, EXIT_SUCCESS.
 * Output that could not be written (full disk, closed pipe) is die(): a
 * truncated table never goes with exit status 0.
 */
int table_finish(void);

#endif
