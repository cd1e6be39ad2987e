/* judge.c - see judge.h. */
#include "judge.h"

#include "output.h"
#include "predict.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { WIDTH = 78, MAX_CLAIMS = 24, MAX_RUNS = 16 };

/* Paths are absolute: a child works in the folder `work`. */
static struct {
    const struct lesson *lesson;
    const char *file;      /* what is judged, for the heading */
    const char *subject;   /* the judge with that program compiled in; NULL:
                            * this one */
    const char *reference; /* program of the reference solution */
    const char *mistakes;  /* folder with the known mistakes' programs */
    const char *prepare;   /* command that builds those that CAUGHT_BY= names
                            * the check of, and judges of the JUDGED= */
    const char *result;    /* file for "verdict check slot mistakes" */
    char work[PATH_SIZE - 300]; /* folder for captured output */
    struct prediction predicted[MAX_PREDICTIONS];
    int n_predicted, n_answer; /* PREDICT lines; those without dots */
} judging;

/* How the messages begin that are no slot's, or a verdict of their own. */
#define UNREADABLE "the output cannot be read: "
#define NOT_FINITE "not finite: "

/* ---- inside a check ------------------------------------------------------ */

/* A file in the folder of the judge. */
static const char *work_file(const char *name, char path[PATH_SIZE])
{
    snprintf(path, PATH_SIZE, "%s/%s", judging.work, name);
    return path;
}

void wrong(const char *format, ...)
{
    char path[PATH_SIZE];
    va_list arguments;
    FILE *file = fopen(work_file("judge.message", path), "w");
    if (!file) quit("cannot write %s", path);
    va_start(arguments, format);
    vfprintf(file, format, arguments);
    va_end(arguments);
    fclose(file);
    _exit(1);
}

void expect_close(double got, double want, double tolerance, double scale,
                  const char *what, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(text, sizeof text, what, arguments);
    va_end(arguments);
    if (!isfinite(got)) wrong(NOT_FINITE "%s is %g", text, got);
    if (!(fabs(got - want) <= tolerance * scale))
        wrong("%s: got %.10g, want %.10g (off by %.2g; allowed %.2g)", text,
              got, want, fabs(got - want), tolerance * scale);
}

/* Stop this check if the program stopped as none should: at a slot that is
 * not written, or by a signal. */
static void pass_on(const struct output *output)
{
    if (output->status != 3 && output->status >= 0) return;
    fprintf(stderr, "%s\n", output->stderr_);
    fflush(NULL);
    if (output->status == 3) _exit(3);
    const int number = output->limit == LIMIT_STOPPED ? SIGSTOP
                       : output->limit == LIMIT_CPU   ? SIGXCPU
                                                      : -output->status;
    if (number != SIGSTOP) signal(number, SIG_DFL);
    raise(number);
    pause(); /* by SIGSTOP: until the judge ends it */
}

static void expect_finite(const struct output *output)
{
    for (int t = 0; t < output->n_table; t++) {
        const struct named_table *table = &output->table[t];
        for (int r = 0; r < table->n_row; r++)
            for (int c = 0; c < table->n_column; c++) {
                const double value = number_at(table, c, r);
                if (!word_at(table, c, r) && !isfinite(value))
                    wrong(NOT_FINITE "table `%s`, row %d, column `%s` is %g",
                          table->name, r + 1, table->column[c], value);
            }
    }
}

static struct output *output_of_subject(const char *options);

struct output *run(const char *options)
{
    struct output *output = output_of_subject(options);
    const char *space = *options ? " " : "";
    pass_on(output);
    if (output->status != 0)
        wrong("the program%s%s stopped with exit status %d: %s", space, options,
              output->status,
              *output->stderr_ ? output->stderr_ : "(no message)");
    if (*output->error) wrong(UNREADABLE "%s", output->error);
    if (output->n_table == 0)
        wrong("the program%s%s ended with exit status 0 and printed no table",
              space, options);
    expect_finite(output);
    return output;
}

/* Run a program that must end with this status and say `text`. */
static struct output *run_failing(const char *options, int status,
                                  const char *text)
{
    struct output *output = output_of_subject(options);
    pass_on(output);
    expect(output->status == status,
           "with %s the program must stop with exit status %d, not %d", options,
           status, output->status);
    expect(strstr(output->stderr_, text),
           "with %s the message must say %s; it says: %s", options, text,
           output->stderr_);
    if (*output->error)
        wrong("with %s the output cannot be read: %s", options, output->error);
    return output;
}

struct output *run_unsolved(const char *options, const char *text)
{
    return run_failing(options, 1, text);
}

void expect_refusal(const char *options, int status, const char *text)
{
    struct output *output = run_failing(options, status, text);
    expect(status == 1 || !output->printed,
           "with %s the program prints something and then fails", options);
    output_free(output);
}

/* ---- looking at tables --------------------------------------------------- */

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

/* ---- comparison with the reference -------------------------------------- */

static const struct column_rule *find_rule(const char *table, const char *name)
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

/* What allows |yours - reference|: tolerance times scale. */
static double allowed(const struct column_rule *rule,
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
static double carried(const struct named_table *want, int c, int r)
{
    int is_order;
    const int at = errors_of_column(want, c, &is_order);
    const struct column_rule *rule =
        at < 0 ? NULL : find_rule(want->name, want->column[at]);
    if (!rule || !(rule->tolerance > 0.0)) return 0.0;
    const double here = fabs(number_at(want, at, r));
    const double before = r > 0 ? fabs(number_at(want, at, r - 1)) : here;
    const double relative = allowed(rule, want, at) / fmin(here, before);
    if (is_order) return 3.0 * relative;
    return 20.0 * relative * fabs(number_at(want, c, r));
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

/* Whether a word differs, or stands against a number. */
static int words_differ(const struct named_table *got, int c_got,
                        const struct named_table *want, int c, int r)
{
    const char *y = word_at(got, c_got, r), *z = word_at(want, c, r);
    return y && z ? strcmp(y, z) != 0 : y != z;
}

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
        return 1;
    }
    const double limit_ = allowed(rule, want, c);
    for (int r = 0; r < want->n_row; r++) {
        const double y = number_at(got, c_got, r), z = number_at(want, c, r);
        const double off = fabs(y - z);
        const double limit_r = limit_ + carried(want, c, r);
        if (off <= limit_r || (isnan(y) && isnan(z)) || y == z) continue;
        if (first < 0) first = worst = r;
        if (off / limit_r > excess) {
            excess = off / limit_r;
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
    return 1;
}

/* Whether some table of `want` is missing or different in `got`. */
static int tables_differ(const struct output *got, const struct output *want,
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

static void check_same_numbers_as_reference(void)
{
    for (int r = 0; r < judging.lesson->n_run; r++) {
        const char *options = judging.lesson->runs[r];
        char text[900];
        struct output *want =
            output_of(judging.reference, options, judging.work);
        if ((want->status != 0 && want->status != 1) || *want->error)
            quit("the reference solution fails with '%s': %s%s", options,
                 want->stderr_, want->error);
        struct output *got =
            want->status ? run_unsolved(options, "") : run(options);
        if (tables_differ(got, want, sizeof text, text))
            wrong("%s%s%s%s", *options ? "with " : "", options,
                  *options ? ": " : "", text);
        output_free(got);
        output_free(want);
    }
}

/* ---- known mistakes ------------------------------------------------------ */

/* Print text, wrapped to WIDTH with an indent, each line starting with it. */
static void print_wrapped(const char *indent, const char *text)
{
    int at = 0;
    while (*text) {
        const int n = (int)strcspn(text, " \n");
        if (at > 0 && at + 1 + n > WIDTH) {
            putchar('\n');
            at = 0;
        }
        if (at == 0)
            at = printf("%s", indent);
        else
            at += printf(" ");
        at += printf("%.*s", n, text);
        text += n;
        if (*text == '\n') {
            putchar('\n');
            at = 0;
        }
        if (*text) text++;
    }
    if (at > 0) putchar('\n');
}

/* Same exit status and, where that is 0 or 1, all the tables of the other. */
static int coincide(const struct output *mine, const struct output *other)
{
    char text[900];
    if (mine->status != other->status) return 0;
    if (mine->status != 0 && mine->status != 1) return 1;
    return !*mine->error && !*other->error &&
           !tables_differ(mine, other, sizeof text, text);
}

/* The file NAME.why of a known mistake: on its first line the check that
 * catches it, and then what the student is told, in `text`. */
static void read_why(const char *name, char check[64], size_t size, char text[])
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/%s.why", judging.mistakes, name);
    FILE *file = fopen(path, "r");
    if (!file || fscanf(file, "%63s", check) != 1) quit("cannot read %s", path);
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
}

/* Whether there is such a program, and the check that catches it is the one
 * that failed first. */
static int is_suspect(const char *name, const char *failed)
{
    char path[PATH_SIZE], check[64], text[2048];
    snprintf(path, sizeof path, "%s/%s", judging.mistakes, name);
    if (strchr(name, '.') || access(path, X_OK) != 0) return 0;
    read_why(name, check, sizeof text, text);
    return strcmp(check, failed) == 0;
}

/* What is known of the mistakes with these names (blanks between), as the one
 * that was made or as those of which it may be one. */
static void print_explanations(int n, const char *names)
{
    char name[64], check[64], why[2048], text[2200];
    if (n > 1)
        printf("  Your numbers are those of a program with one of these known "
               "mistakes:\n");
    for (int used = 0; sscanf(names, "%63s%n", name, &used) == 1;
         names += used) {
        read_why(name, check, sizeof why, why);
        for (char *c = why; *c; c++)
            if (*c == '\n') *c = ' ';
        if (n > 1)
            snprintf(text, sizeof text, "(%s)%s", name, why);
        else
            printf("  Your numbers are those of a program with a known mistake "
                   "(%s):\n", name);
        print_wrapped("    ", n > 1 ? text : why + 1);
    }
}

/* The output of the program under test. */
static struct output *output_of_subject(const char *options)
{
    char with_mode[1024];
    if (!judging.subject) return output_of(NULL, options, judging.work);
    snprintf(with_mode, sizeof with_mode, "--run %s", options);
    return output_of(judging.subject, with_mode, judging.work);
}

/* Of a run with each of the lesson's options: the output of the program under
 * test and of the right one, and the CPU seconds that both took. */
struct both {
    int run;
    struct output *mine, *right;
    double seconds;
};

static int compare_seconds(const void *a, const void *b)
{
    const double s = ((const struct both *)a)->seconds;
    const double t = ((const struct both *)b)->seconds;
    return (s > t) - (s < t);
}

/* Whether a known mistake's program gives the outputs of the program under
 * test, and others than the right program in a run that comes to its end: those
 * that give up at once are all alike.  A number that a check has `got` tells as
 * well as a run does. */
static int explains(const char *name, const struct both both[], int got)
{
    char program[PATH_SIZE];
    snprintf(program, sizeof program, "%s/%s", judging.mistakes, name);
    int same = 1, tells = 0;
    for (int i = 0; i < judging.lesson->n_run && same; i++) {
        const char *options = judging.lesson->runs[both[i].run];
        struct output *other = output_of(program, options, judging.work);
        same = coincide(both[i].mine, other);
        tells |= (got || other->status == 0) && !coincide(both[i].right, other);
        output_free(other);
    }
    return same && tells;
}

/* Have built what is not; 0 when that fails. */
static int prepare(const char *variable, const char *names)
{
    char command[PATH_SIZE];
    if (!judging.prepare) return 1;
    snprintf(command, sizeof command, "%s %s='%s' >/dev/null",
             judging.prepare, variable, names);
    return child_command(command) == 0;
}

/* The known mistakes that give the outputs of the program under test, and that
 * this check catches, each name after a blank; see explains(). */
static void find_suspects(const char *check, int got, size_t size,
                          char suspects[])
{
    const int n_run = judging.lesson->n_run;
    struct both both[MAX_RUNS];
    struct dirent **entry;

    for (int r = 0; r < n_run; r++) {
        const char *options = judging.lesson->runs[r];
        const double before = child_seconds();
        both[r].run = r;
        both[r].mine = output_of_subject(options);
        both[r].right = output_of(judging.reference, options, judging.work);
        both[r].seconds = child_seconds() - before;
    }
    /* the cheapest run tells most of them apart */
    qsort(both, (size_t)n_run, sizeof *both, compare_seconds);
    const int n_entry = scandir(judging.mistakes, &entry, NULL, alphasort);
    for (int i = 0; i < n_entry; i++) {
        const char *name = entry[i]->d_name;
        if (child_seconds() < SECONDS_JUDGING && is_suspect(name, check) &&
            explains(name, both, got)) {
            const size_t end = strlen(suspects);
            snprintf(suspects + end, size - end, " %s", name);
        }
        free(entry[i]);
    }
    if (n_entry >= 0) free(entry);
    for (int r = 0; r < n_run; r++) {
        output_free(both[r].mine);
        output_free(both[r].right);
    }
}

/* ---- verdicts ------------------------------------------------------------ */

enum verdict { PASS, WRONG, UNFINISHED, CRASHED, TIMEOUT, NONFINITE_, NOT_RUN };

static const char *const verdict_name[] = {
    "ok", "WRONG", "UNFINISHED", "CRASHED", "TIMEOUT", "NONFINITE", "not run"};

struct finding {
    enum verdict verdict;
    char text[1100];
    char slot[16];
    int costly; /* it took all its time or output: do not run the others */
};

/* The check's own message, if it wrote one. */
static int read_message(size_t size, char text[])
{
    char path[PATH_SIZE];
    FILE *file = open_regular(work_file("judge.message", path));
    if (!file) return 0;
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
    return 1;
}

static int starts(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Why a check that wrote no message did not come to its end. */
static void explain_end(struct ending ending, struct finding *finding)
{
    char path[PATH_SIZE], line[512], slot[16];
    char *text = finding->text;
    const size_t size = sizeof finding->text;

    last_line(work_file("judge.stderr", path), sizeof line, line);
    const char *colon = *line ? ": " : "";
    finding->verdict = CRASHED;
    finding->costly = ending.limit != NO_LIMIT;
    if (ending.limit == LIMIT_CPU || ending.limit == LIMIT_IDLE)
        finding->verdict = TIMEOUT;
    if (ending.limit == LIMIT_CPU) {
        snprintf(text, size,
                 "no end after %d seconds of computing: is there a loop that "
                 "cannot stop, or a method that is much too slow?",
                 SECONDS_COMPUTING);
    } else if (ending.limit == LIMIT_IDLE) {
        snprintf(text, size,
                 "no end, and nothing computes: does the program wait for "
                 "something?");
    } else if (ending.limit == LIMIT_OUTPUT) {
        snprintf(text, size,
                 "more than %d MB of output: is there a loop that prints "
                 "without end?", MEGABYTES_OUTPUT);
    } else if (ending.limit == LIMIT_FILES) {
        snprintf(text, size, "the program has written more than %d files",
                 MOST_FILES);
    } else if (ending.limit == LIMIT_PROCESSES) {
        snprintf(text, size, "the program has started more than %d processes",
                 MOST_PROCESSES);
    } else if (ending.limit == LIMIT_STOPPED) {
        snprintf(text, size, "the program stopped itself by a signal");
    } else if (ending.status == -SIGILL || ending.status == -SIGTRAP) {
        /* that is what BOUNDS of the Makefile makes of it */
        snprintf(text, size, "an index beyond the end of an array, or below 0: "
                 "signal %d", -ending.status);
    } else if (ending.status < 0) {
        snprintf(text, size, "signal %d (%s)%s%s", -ending.status,
                 strsignal(-ending.status), colon, line);
    } else if (ending.status == 3 &&
               sscanf(line, "unfinished: slot %15s", slot) == 1) {
        finding->verdict = UNFINISHED;
        snprintf(finding->slot, sizeof finding->slot, "%s", slot);
        snprintf(text, size, "slot %s is not written yet", slot);
    } else if (ending.status == 2 && starts(line, "judge: ")) {
        quit("%s", line + 7);
    } else {
        snprintf(text, size,
                 "the program left in the middle of its work, with exit(%d)"
                 "%s%s", ending.status, colon, line);
    }
}

/* In the child: the check.  That it came to its end is said by a number, which
 * the judge hands over and gets back. */
static void run_claim(const struct claim *claim)
{
    uint64_t number;
    if (read(CHILD_DESCRIPTOR, &number, sizeof number) != sizeof number)
        quit("no number for the end of a check");
    claim->check();
    guards_hold();
    if (write(CHILD_DESCRIPTOR, &number, sizeof number) < 0) _exit(2);
}

/* A number that nobody guesses. */
static uint64_t any_number(void)
{
    uint64_t number = (uint64_t)time(NULL) ^ (uint64_t)getpid() << 32;
    FILE *file = fopen("/dev/urandom", "r");
    if (file && fread(&number, sizeof number, 1, file) != 1)
        quit("cannot read /dev/urandom");
    if (file) fclose(file);
    return number;
}

/* The claim that every lesson ends with; behind it, what was predicted. */
static struct claim claim_at(const struct lesson *lesson, int i)
{
    if (i < lesson->n_claim) return lesson->claims[i];
    if (i > lesson->n_claim)
        return (struct claim){"predictions", lesson->predicted, NULL};
    return (struct claim){"same_numbers_as_reference",
                          check_same_numbers_as_reference, NULL};
}

/* In the child: run the claim of this index, in the subject if there is one.
 * The comparison with the reference is the judge's own: the subject does no
 * more there than run the program. */
static void begin_claim(void *context)
{
    const int *index = context;
    const struct claim claim = claim_at(judging.lesson, *index);
    char number[16];
    snprintf(number, sizeof number, "%d", *index);
    if (!judging.subject || *index == judging.lesson->n_claim) {
        run_claim(&claim);
    } else {
        execl(judging.subject, judging.subject, "--claim", number, "--work",
              judging.work, "--reference", judging.reference, (char *)NULL);
        fprintf(stderr, "judge: cannot run %s\n", judging.subject);
        _exit(2);
    }
}

/* Run one claim in a child of its own. */
static void examine(int index, struct finding *finding)
{
    const struct claim claim = claim_at(judging.lesson, index);
    char out[PATH_SIZE], err[PATH_SIZE], path[PATH_SIZE];
    const uint64_t number = any_number();
    uint64_t back = ~number;
    int both_ways[2];

    chmod(judging.work, 0700);
    remove(work_file("judge.message", path));
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, both_ways) < 0 ||
        write(both_ways[0], &number, sizeof number) < 0)
        quit("cannot make a socket: %s", strerror(errno));
    child_hand_over(both_ways[1]);
    const struct ending ending =
        child_run(begin_claim, &index, work_file("judge.stdout", out),
                  work_file("judge.stderr", err));
    child_hand_over(0);
    const int finished =
        recv(both_ways[0], &back, sizeof back, MSG_DONTWAIT) == sizeof back &&
        back == number;
    close(both_ways[0]);
    close(both_ways[1]);
    snprintf(finding->slot, sizeof finding->slot, "%s",
             claim.slot ? claim.slot : "");
    finding->verdict = PASS;
    if (ending.limit == NO_LIMIT && ending.status == 0 && finished) return;
    finding->verdict = WRONG;
    if (ending.limit == NO_LIMIT && ending.status == 1 &&
        read_message(sizeof finding->text, finding->text)) {
        if (starts(finding->text, NOT_FINITE)) finding->verdict = NONFINITE_;
        if (starts(finding->text, UNREADABLE)) *finding->slot = '\0';
    } else {
        explain_end(ending, finding);
    }
}

/* Whether two messages have the same words and numbers, but for round-off: to
 * 1e-6 of the larger, or 1e-9, below which there is little else. */
static int say_the_same(const char *a, const char *b)
{
    while (*a && *b) {
        char *a_end, *b_end;
        const double x = strtod(a, &a_end), y = strtod(b, &b_end);
        if (a_end > a && b_end > b) {
            if (isfinite(x) != isfinite(y) ||
                fabs(x - y) > 1e-9 + 1e-6 * fmax(fabs(x), fabs(y)))
                return 0;
            a = a_end;
            b = b_end;
        } else if (*a++ != *b++) {
            return 0;
        }
    }
    return *a == *b;
}

/* Say which known mistakes give the numbers of the program under test: its
 * output, and what it is told by the first check that it fails, the one of this
 * index.  Their names, with commas between, go to `found`. */
static void diagnose(int index, const struct finding *bad, size_t size,
                     char found[])
{
    const struct claim claim = claim_at(judging.lesson, index);
    char suspects[1024] = "", names[1024] = "", name[64];
    char path[PATH_SIZE + 64];
    int n = 0, used = 0;

    if (!judging.mistakes || !prepare("CAUGHT_BY", claim.name)) return;
    child_restart_clock();
    find_suspects(claim.name, strstr(bad->text, ": got ") != NULL,
                  sizeof suspects, suspects);
    if (!*suspects || !prepare("JUDGED", suspects)) return;
    const char *subject = judging.subject;
    for (const char *s = suspects; sscanf(s, "%63s%n", name, &used) == 1;
         s += used) {
        struct finding its = {0};
        snprintf(path, sizeof path, "%s/%s.judge", judging.mistakes, name);
        if (access(path, X_OK) != 0 || child_seconds() > SECONDS_JUDGING)
            continue;
        judging.subject = path;
        examine(index, &its);
        if (its.verdict != bad->verdict || !say_the_same(its.text, bad->text))
            continue;
        strcat(strcat(names, " "), name);
        snprintf(found + strlen(found), size - strlen(found), "%s%s",
                 n++ ? "," : "", name);
    }
    judging.subject = subject;
    print_explanations(n, names);
}

static void write_result(const struct finding *finding, const char *check,
                         const char *mistakes)
{
    if (!judging.result) return;
    const char *verdict =
        finding->verdict == PASS ? "OK" : verdict_name[finding->verdict];
    FILE *file = fopen(judging.result, "w");
    if (!file ||
        fprintf(file, "%s %s %s %s\n", verdict, check,
                *finding->slot ? finding->slot : "-",
                *mistakes ? mistakes : "-") < 0 ||
        fclose(file) != 0)
        quit("cannot write %s", judging.result);
}

static const char *value_of(int argc, char *argv[], const char *name)
{
    for (int a = 1; a + 1 < argc; a += 2)
        if (strcmp(argv[a], name) == 0) return argv[a + 1];
    return NULL;
}

/* A path that holds whatever the current folder is; NULL stays NULL. */
static const char *absolute(const char *path)
{
    char here[PATH_SIZE];
    if (!path || *path == '/') return path;
    if (!getcwd(here, sizeof here))
        quit("cannot name the current folder: %s", strerror(errno));
    const size_t size = strlen(here) + strlen(path) + 2;
    char *whole = malloc(size);
    if (!whole) quit("out of memory");
    snprintf(whole, size, "%s/%s", here, path);
    return whole;
}

/* Remove the folder with captured output; a folder that the program has made
 * in it is left. */
static void remove_work(void)
{
    char path[PATH_SIZE];
    struct dirent **entry;
    const int n_entry = scandir(judging.work, &entry, NULL, alphasort);
    for (int i = 0; i < n_entry; i++) {
        snprintf(path, sizeof path, "%s/%s", judging.work, entry[i]->d_name);
        unlink(path); /* not . and .. */
        free(entry[i]);
    }
    if (n_entry >= 0) free(entry);
    rmdir(judging.work);
}

/* A folder FOLDER.XXXXXX with an absolute path. */
static void make_work(const char *folder)
{
    char name[PATH_SIZE - 300];
    if (snprintf(name, sizeof name, "%s.XXXXXX", folder) >= (int)sizeof name)
        quit("a path of more than %zu characters", sizeof name);
    if (!mkdtemp(name)) quit("cannot make %s: %s", name, strerror(errno));
    const char *whole = absolute(name);
    if (strlen(whole) >= sizeof judging.work)
        quit("a path of more than %zu characters", sizeof judging.work);
    strcpy(judging.work, whole);
}

/* The names collected so far, several to a line, and begin again. */
static void print_passed(char names[])
{
    if (*names) print_wrapped("  ok         ", names + 1);
    *names = '\0';
}

/* Run the claims, one after another, and print a line for each, or, where they
 * are many, for those that fail.  After one that took all its time, or when
 * time is up, the others are not run. */
static int examine_all(int n, struct finding finding[])
{
    const int most_lines = judging.n_answer ? 9 : 13; /* leave them room */
    char passed[MAX_CLAIMS * 64] = "";
    int bad = 0, over = 0;

    for (int i = 0; i < n; i++) {
        const struct claim claim = claim_at(judging.lesson, i);
        if (over && bad) {
            finding[i].verdict = NOT_RUN;
        } else if (over) {
            finding[i].verdict = TIMEOUT;
            snprintf(finding[i].text, sizeof finding[i].text,
                     "the checks before it have taken more than %d seconds of "
                     "computing", SECONDS_JUDGING);
        } else {
            examine(i, &finding[i]);
            over = finding[i].costly || child_seconds() > SECONDS_JUDGING;
        }
        bad |= finding[i].verdict != PASS;
        if (finding[i].verdict == PASS && n > most_lines) {
            strcat(strcat(passed, " "), claim.name);
            continue;
        }
        print_passed(passed);
        printf("  %-10s %s\n", verdict_name[finding[i].verdict], claim.name);
    }
    print_passed(passed);
    return over;
}

void measured(const char *key, double value)
{
    char path[PATH_SIZE];
    FILE *file = fopen(work_file("judge.measured", path), "a");
    if (!file) quit("cannot write %s", path);
    fprintf(file, "%s %.17g\n", key, value);
    fclose(file);
}

/* What the student has predicted in this file, if it is given. */
static void read_predictions(const char *source)
{
    if (!source || !judging.lesson->predicted) return;
    judging.n_predicted = predictions_read(source, judging.predicted);
    for (int i = 0; i < judging.n_predicted; i++)
        judging.n_answer += *judging.predicted[i].answer != '\0';
}

/* The predictions, one after the other, beside what is measured; `index` is
 * that of their claim. */
static void print_predictions(int index)
{
    struct finding finding;
    char path[PATH_SIZE], line[80], key[4], text[1024] = "";
    double value;

    if (judging.n_predicted > 0 && judging.n_answer == 0)
        printf("  Nothing was predicted.\n");
    if (judging.n_answer == 0) return;
    remove(work_file("judge.measured", path));
    examine(index, &finding);
    FILE *file = open_regular(path);
    while (file && fgets(line, sizeof line, file))
        for (int i = 0; i < judging.n_predicted; i++) {
            const struct prediction *p = &judging.predicted[i];
            if (*p->answer && sscanf(line, "%3s %lf", key, &value) == 2 &&
                strcmp(key, p->key) == 0)
                prediction_compare(p, value, sizeof text, text);
        }
    if (file) fclose(file);
    printf("  Predicted:\n");
    print_wrapped("    ", *text ? text : "what was cannot be measured");
}

/* All checks pass. */
static void print_ok(const char *number, int n)
{
    const struct finding none = {.verdict = PASS};
    write_result(&none, "-", "");
    print_predictions(n);
    printf("  Notice:\n");
    print_wrapped("    ", judging.lesson->notice);
    printf("  Break it:\n");
    print_wrapped("    ", judging.lesson->break_it);
    printf("VERDICT %s: OK, all %d checks\n", number, n);
}

/* The first check that fails, the one of this index, and with `search` the
 * known mistakes; the last line is the verdict. */
static void print_failure(const char *number, int index,
                          const struct finding *bad, int search)
{
    const char *check = claim_at(judging.lesson, index).name;
    char mistakes[1024] = "";
    write_result(bad, check, "");
    printf("  In %s", check);
    if (*bad->slot) printf(" (slot %s)", bad->slot);
    printf(":\n");
    print_wrapped("    ", bad->text);
    if (search && (bad->verdict == WRONG || bad->verdict == NONFINITE_))
        diagnose(index, bad, sizeof mistakes, mistakes);
    if (*mistakes) write_result(bad, check, mistakes);
    printf("VERDICT %s: %s", number, verdict_name[bad->verdict]);
    if (bad->verdict == UNFINISHED) printf(" (slot %s)", bad->slot);
    if (bad->verdict == CRASHED) printf(" in %s", check);
    printf("    next: make hint-%s\n", number);
}

/* As the subject of another judge: one claim, or the program itself. */
static void be_the_subject(const struct lesson *lesson, int argc, char *argv[])
{
    const char *claim = value_of(argc, argv, "--claim");
    const char *work = value_of(argc, argv, "--work");
    if (argc > 1 && strcmp(argv[1], "--run") == 0) {
        argv[1] = (char *)"program";
        exit(program_main(argc - 1, argv + 1));
    }
    if (!claim || !work) return;
    child_am_inside();
    snprintf(judging.work, sizeof judging.work, "%s", work);
    judging.reference = value_of(argc, argv, "--reference");
    const struct claim mine = claim_at(lesson, atoi(claim));
    run_claim(&mine);
    fflush(NULL);
    _exit(0);
}

int judge(const struct lesson *lesson, int argc, char *argv[])
{
    struct finding finding[MAX_CLAIMS] = {0};
    const char number[3] = {lesson->name[0], lesson->name[1], '\0'};
    const int n = lesson->n_claim + 1;

    judging.lesson = lesson;
    be_the_subject(lesson, argc, argv);
    judging.file = value_of(argc, argv, "--file");
    read_predictions(value_of(argc, argv, "--source"));
    judging.subject = absolute(value_of(argc, argv, "--subject"));
    judging.reference = absolute(value_of(argc, argv, "--reference"));
    judging.mistakes = absolute(value_of(argc, argv, "--mistakes"));
    judging.prepare = value_of(argc, argv, "--prepare");
    judging.result = value_of(argc, argv, "--result");
    const char *work = value_of(argc, argv, "--work");
    if (n > MAX_CLAIMS)
        quit("%s has more than %d claims", lesson->name, MAX_CLAIMS - 1);
    if (lesson->n_run > MAX_RUNS)
        quit("%s has more than %d runs", lesson->name, MAX_RUNS);
    if (!judging.file || !judging.reference)
        quit("usage: %s --file FILE [--source FILE] [--subject JUDGE] "
             "--reference PROGRAM [--mistakes FOLDER] [--prepare COMMAND] "
             "[--result FILE] [--work FOLDER]", argv[0]);
    make_work(work ? work : argv[0]);
    child_on_interrupt(remove_work);
    child_work_in(judging.work);

    setvbuf(stdout, NULL, _IOLBF, 0);
    printf("%s\n", judging.file);
    const int over = examine_all(n, finding);
    int first = 0;
    while (first < n && finding[first].verdict == PASS) first++;
    if (first == n)
        print_ok(number, n);
    else
        print_failure(number, first, &finding[first], !over);
    remove_work();
    return first == n ? 0 : 1;
}
