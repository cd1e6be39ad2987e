/* compare.c - a program's tables against those of the reference. */
#include "judging.h"

#include <math.h>
#include <string.h>

const struct column_rule *find_rule(const char *table, const char *name)
{
    const struct column_rule *all = NULL;
    for (int i = 0; i < judging.lesson->n_rule; i++) {
        const struct column_rule *rule = &judging.lesson->rules[i];
        if (strcmp(rule->table, table) != 0) continue;
        if (strcmp(rule->column, name) == 0) return rule;
        if (strcmp(rule->column, "*") == 0) all = rule;
    }
    return all;
}

/* Tolerance times scale. */
double column_allows(const struct column_rule *rule,
                     const struct named_table *want, int c)
{
    double scale = rule->scale;
    if (!(scale > 0.0))
        for (int r = 0; r < want->n_row; r++)
            if (fabs(number_at(want, c, r)) > scale)
                scale = fabs(number_at(want, c, r));
    return rule->tolerance * scale;
}

/* The column of errors that an order or a constant belongs to (judge.h), and
 * which of the two it is; -1 for any other column. */
static int errors_of_column(const struct named_table *want, int c,
                            int *is_order)
{
    static const char *const end[] = {"_constant", "_order"};
    const char *name = want->column[c];
    char errors[128];
    for (int k = 0; k < 2; k++) {
        const size_t n = strlen(name), m = strlen(end[k]);
        *is_order = k;
        if (n <= m || strcmp(name + n - m, end[k]) != 0) continue;
        snprintf(errors, sizeof errors, "%.*s", (int)(n - m), name);
        return find_column(want, errors);
    }
    return -1;
}

/* What row r is allowed on top of that: what its errors are allowed, carried
 * into their order or constant. */
double row_allows(const struct named_table *want, int c, int r)
{
    int is_order;
    const int at = errors_of_column(want, c, &is_order);
    const struct column_rule *rule =
        at < 0 ? NULL : find_rule(want->name, want->column[at]);
    if (!rule || !(rule->tolerance > 0.0)) return 0.0;
    const double here = fabs(number_at(want, at, r));
    const double before = r > 0 ? fabs(number_at(want, at, r - 1)) : here;
    const double relative = column_allows(rule, want, at) / fmin(here, before);
    if (is_order) return 3.0 * relative;
    return 20.0 * relative * fabs(number_at(want, c, r));
}

double times_allowed(double got, double want, double limit)
{
    if (got == want || (isnan(got) && isnan(want))) return 0.0;
    const double times = fabs(got - want) / limit;
    return isnan(times) ? INFINITY : times;
}

/* A cell as a message quotes it. */
static const char *quoted(const struct named_table *table, int c, int r,
                          size_t size, char text[])
{
    if (word_at(table, c, r))
        snprintf(text, size, "`%s`", word_at(table, c, r));
    else
        snprintf(text, size, "%.10g", number_at(table, c, r));
    return text;
}

/* A cell as struct figures has it. */
static void figure(const struct named_table *table, int c, int r, char text[80])
{
    if (word_at(table, c, r))
        snprintf(text, 80, "%s", word_at(table, c, r));
    else
        snprintf(text, 80, "%.17g", number_at(table, c, r));
}

/* Whether a word differs, or stands against a number. */
static int words_differ(const struct named_table *got, int c_got,
                        const struct named_table *want, int c, int r)
{
    const char *y = word_at(got, c_got, r), *z = word_at(want, c, r);
    return y && z ? strcmp(y, z) != 0 : y != z;
}

/* What column_differs() has found; empty when it is no cell. */
static struct figures differing;

/* Compare one column; describe the first word that differs, or the worst and
 * the first bad number, in `text`. */
static int column_differs(const struct named_table *got,
                          const struct named_table *want, int c, size_t size,
                          char text[])
{
    const char *name = want->column[c];
    const struct column_rule *rule = find_rule(want->name, name);
    const int c_got = find_column(got, name);
    char mine[80], due[80], label[80];
    int worst = -1, first = -1;
    double excess = 0.0;

    if (!rule) quit("no rule for column `%s` of table `%s`", name, want->name);
    if (rule->tolerance < 0.0) return 0;
    if (c_got < 0) {
        snprintf(text, size, "table `%s` has no column `%s`", want->name, name);
        return 1;
    }
    for (int r = 0; r < want->n_row; r++) {
        if (!words_differ(got, c_got, want, c, r)) continue;
        snprintf(text, size,
                 "table `%s`, row %d (%s = %s), column `%s`: yours %s, "
                 "reference %s",
                 want->name, r + 1, want->column[0],
                 quoted(want, 0, r, sizeof label, label), name,
                 quoted(got, c_got, r, sizeof mine, mine),
                 quoted(want, c, r, sizeof due, due));
        figure(got, c_got, r, differing.got);
        figure(want, c, r, differing.want);
        return 1;
    }
    const double limit = column_allows(rule, want, c);
    for (int r = 0; r < want->n_row; r++) {
        const double times =
            times_allowed(number_at(got, c_got, r), number_at(want, c, r),
                          limit + row_allows(want, c, r));
        if (times <= 1.0) continue;
        if (first < 0) first = r;
        if (times > excess) {
            excess = times;
            worst = r;
        }
    }
    if (first < 0) return 0;
    snprintf(text, size,
             "table `%s`, row %d (%s = %s), column `%s`: yours %.10g, "
             "reference %.10g, %.2g times the tolerance (%.0e of the largest "
             "entry: %s); first bad row %d",
             want->name, worst + 1, want->column[0],
             quoted(want, 0, worst, sizeof label, label), name,
             number_at(got, c_got, worst), number_at(want, c, worst),
             excess, rule->tolerance,
             rule->reason, first + 1);
    figure(got, c_got, worst, differing.got);
    figure(want, c, worst, differing.want);
    snprintf(differing.allowed, sizeof differing.allowed, "%.17g",
             limit + row_allows(want, c, worst));
    return 1;
}

int tables_differ(const struct output *got, const struct output *want,
                  size_t size, char text[])
{
    for (int t = 0; t < want->n_table; t++) {
        const struct named_table *w = &want->table[t];
        const struct named_table *g = find_table(got, w->name);
        int compared = 0;
        for (int c = 0; c < w->n_column; c++) {
            const struct column_rule *rule = find_rule(w->name, w->column[c]);
            if (!rule)
                quit("no rule for column `%s` of table `%s`", w->column[c],
                     w->name);
            if (rule->tolerance >= 0.0) compared = 1;
        }
        if (!g) {
            snprintf(text, size, "the program prints no table `%s`", w->name);
            return 1;
        }
        if (!compared) continue;
        if (g->n_row != w->n_row) {
            snprintf(text, size, "table `%s` has %d rows, the reference %d",
                     w->name, g->n_row, w->n_row);
            return 1;
        }
        for (int c = 0; c < w->n_column; c++)
            if (column_differs(g, w, c, size, text)) return 1;
    }
    return 0;
}

void check_same_numbers_as_reference(void)
{
    for (int r = 0; r < judging.lesson->n_run; r++) {
        const char *options = judging.lesson->runs[r];
        char text[900];
        struct output *want = output_kept(judging.reference, r);
        if ((want->status != 0 && want->status != 1) || *want->error)
            quit("the reference solution fails with '%s': %s%s", options,
                 want->stderr_, want->error);
        struct output *got =
            want->status ? run_unsolved(options, "") : run(options);
        if (tables_differ(got, want, sizeof text, text)) {
            if (*differing.got) keep_figures(&differing);
            wrong("%s%s%s%s", *options ? "with " : "", options,
                  *options ? ": " : "", text);
        }
        output_free(got);
        output_free(want);
    }
}
