/*
 * cells.c - NN_slug.judge --cells MINE REFERENCE: two files with output, cell
 * by cell, for `make diff` and `make plot`.  MINE may be cut off anywhere, and
 * hold anything.  Tab-separated lines, the first field their kind:
 *
 *     table  NAME . . . rows-of-mine rows-of-the-reference
 *     column NAME . . COLUMN 1 1 off reason
 *     cell   NAME row key COLUMN mine reference off allowed
 *     stray  . . . . line-of-mine
 *
 * An empty `mine` or `reference` (a dot above is empty too): that one has no
 * such table, column or row.  `off` is |mine - reference| over what the check
 * allows, inf for a word that is another, and `-` where nothing is compared.
 * A row is counted in the reference, or in mine if it is one too many; its key
 * is the first columns, which tell it from the others.
 */
#include "judging.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_KEYS = 3, MOST_ROWS = 4000, ROWS_TOO_MANY = 1000 };

/* Two tables of one name, either may be NULL, and which columns are the key. */
struct pair {
    const struct named_table *mine, *want;
    int n_key;     /* the first columns of want; 0: none tell its rows apart */
    int too_many;  /* rows of mine that are printed so far without partner */
};

/* A field without what ends fields and lines. */
static void print_field(const char *text)
{
    putchar('\t');
    for (; *text; text++) putchar((unsigned char)*text < ' ' ? ' ' : *text);
}

static void print_number(double value)
{
    if (isnan(value))
        fputs("\tnan", stdout);
    else
        printf("\t%.17g", value);
}

/* A cell, or an empty field where there is none. */
static void print_cell(const struct named_table *table, int c, int r)
{
    if (!table || c < 0 || r < 0)
        putchar('\t');
    else if (word_at(table, c, r))
        print_field(*word_at(table, c, r) ? word_at(table, c, r) : "\"\"");
    else
        print_number(number_at(table, c, r));
}

static void print_stray(const char *line)
{
    static int n;
    if (++n > ROWS_TOO_MANY) return;
    fputs("stray\t\t\t\t", stdout);
    print_field(line);
    putchar('\n');
}

/* Whether two rows agree in a column, numbers but for round-off. */
static int same_cell(const struct named_table *a, int c_a, int r,
                     const struct named_table *b, int c, int s)
{
    const char *y = word_at(a, c_a, r), *z = word_at(b, c, s);
    if (y || z) return y && z && strcmp(y, z) == 0;
    const double v = number_at(a, c_a, r), w = number_at(b, c, s);
    return times_allowed(v, w, 1e-9 * fmax(fabs(v), fabs(w))) <= 1.0;
}

/* Whether no two rows agree in all of the first n columns. */
static int tells_apart(const struct named_table *table, int n)
{
    for (int r = 1; r < table->n_row; r++)
        for (int s = 0; s < r; s++) {
            int c = 0;
            while (c < n && same_cell(table, c, r, table, c, s)) c++;
            if (c == n) return 0;
        }
    return 1;
}

static void find_key(struct pair *pair)
{
    const struct named_table *table = pair->want;
    pair->n_key = 0;
    if (!table || table->n_row > MOST_ROWS) return;
    for (int n = 1; n <= MOST_KEYS && n <= table->n_column; n++)
        if (tells_apart(table, n)) {
            pair->n_key = n;
            return;
        }
}

/* Whether row r of mine has the key of row s. */
static int same_key(const struct pair *pair, int r, int s)
{
    for (int c = 0; c < pair->n_key; c++) {
        const int c_mine = find_column(pair->mine, pair->want->column[c]);
        if (c_mine < 0 || !same_cell(pair->mine, c_mine, r, pair->want, c, s))
            return 0;
    }
    return 1;
}

/* The row of mine for each of the reference's, or -1, in partner[].  One after
 * the other, unless their numbers differ and most find one with their key. */
static void find_partners(const struct pair *pair, int partner[])
{
    const int n = pair->want->n_row;
    const int n_mine = pair->mine ? pair->mine->n_row : 0;
    int found = 0, next = 0;
    for (int s = 0; s < n; s++) {
        partner[s] = -1;
        if (n == n_mine || pair->n_key == 0) continue;
        for (int r = next; r < n_mine && r < next + n; r++)
            if (same_key(pair, r, s)) {
                partner[s] = r;
                next = r + 1;
                found++;
                break;
            }
    }
    if (2 * found > (n < n_mine ? n : n_mine)) return;
    for (int s = 0; s < n; s++) partner[s] = s < n_mine ? s : -1;
}

static void print_key(const struct pair *pair, const struct named_table *table,
                      int r)
{
    putchar('\t');
    for (int c = 0; c < (pair->n_key ? pair->n_key : 1); c++) {
        char text[80];
        if (c >= table->n_column) break;
        snprintf(text, sizeof text, "%.6g", number_at(table, c, r));
        printf("%s%s = %.60s", c ? ", " : "", table->column[c],
               word_at(table, c, r) ? word_at(table, c, r) : text);
    }
}

/* The lines of row r of mine and row s of the reference; -1: there is none. */
static void print_row(struct pair *pair, int r, int s, const double limit[])
{
    const struct named_table *mine = pair->mine, *want = pair->want;
    const struct named_table *one = s >= 0 ? want : mine;
    if (s < 0 && pair->too_many++ > ROWS_TOO_MANY) return;
    for (int c = 0; want && c < want->n_column; c++) {
        const int c_mine = mine ? find_column(mine, want->column[c]) : -1;
        printf("cell\t%s\t%d", want->name, (s >= 0 ? s : r) + 1);
        print_key(pair, one, s >= 0 ? s : r);
        printf("\t%s", want->column[c]);
        print_cell(mine, c_mine, r);
        print_cell(want, c, s);
        if (limit[c] < 0.0) {
            puts("\t-\t");
        } else if (c_mine < 0 || r < 0 || s < 0) {
            puts("\t\t");
        } else if (word_at(mine, c_mine, r) || word_at(want, c, s)) {
            printf("\t%s\t\n",
                   same_cell(mine, c_mine, r, want, c, s) ? "0" : "inf");
        } else {
            const double allowed = limit[c] + row_allows(want, c, s);
            print_number(times_allowed(number_at(mine, c_mine, r),
                                       number_at(want, c, s), allowed));
            print_number(allowed);
            putchar('\n');
        }
    }
    for (int c = 0; mine && r >= 0 && c < mine->n_column; c++) {
        if (want && find_column(want, mine->column[c]) >= 0) continue;
        printf("cell\t%s\t%d", mine->name, (s >= 0 ? s : r) + 1);
        print_key(pair, one, s >= 0 ? s : r);
        print_field(mine->column[c]);
        print_cell(mine, c, r);
        puts("\t\t\t");
    }
}

/* The lines of all columns; what each of the reference's allows, -1 where it is
 * not compared, in limit[]. */
static void print_columns(const struct pair *pair, double limit[])
{
    const struct named_table *mine = pair->mine, *want = pair->want;
    for (int c = 0; want && c < want->n_column; c++) {
        const char *name = want->column[c];
        const struct column_rule *rule = find_rule(want->name, name);
        const int compared = rule && rule->tolerance >= 0.0;
        limit[c] = compared ? column_allows(rule, want, c) : -1.0;
        printf("column\t%s\t\t\t%s\t%s\t1\t%s\t%s\n", want->name, name,
               mine && find_column(mine, name) >= 0 ? "1" : "",
               compared ? "" : "-", rule ? rule->reason : "no rule");
    }
    for (int c = 0; mine && c < mine->n_column; c++) {
        if (want && find_column(want, mine->column[c]) >= 0) continue;
        printf("column\t%s\t\t", mine->name);
        print_field(mine->column[c]);
        puts("\t1\t\t\t");
    }
}

static void print_table(struct pair pair)
{
    const struct named_table *mine = pair.mine, *want = pair.want;
    const int n = want ? want->n_row : 0, n_mine = mine ? mine->n_row : 0;
    double limit[MAX_COLUMNS];
    int *partner = calloc((size_t)n + 1, sizeof *partner), next = 0;

    if (!partner) quit("out of memory");
    fputs("table", stdout);
    print_field(want ? want->name : mine->name);
    fputs("\t\t\t", stdout);
    mine ? printf("\t%d", n_mine) : printf("\t");
    want ? printf("\t%d\t\t\n", n) : printf("\t\t\t\n");
    print_columns(&pair, limit);
    find_key(&pair);
    if (want) find_partners(&pair, partner);
    for (int s = 0; s < n; s++) {
        for (; next < partner[s]; next++) print_row(&pair, next, -1, limit);
        if (partner[s] >= 0) next = partner[s] + 1;
        print_row(&pair, partner[s], s, limit);
    }
    for (; next < n_mine; next++) print_row(&pair, next, -1, limit);
    free(partner);
}

void cells_print(const char *mine, const char *reference)
{
    struct output *got = output_read(mine, print_stray);
    struct output *want = output_read(reference, print_stray);
    for (int t = 0; t < want->n_table; t++) {
        const struct named_table *w = &want->table[t];
        print_table((struct pair){find_table(got, w->name), w, 0, 0});
    }
    for (int t = 0; t < got->n_table; t++) {
        const struct named_table *g = &got->table[t];
        if (!find_table(want, g->name))
            print_table((struct pair){g, NULL, 0, 0});
    }
    output_free(got);
    output_free(want);
}
