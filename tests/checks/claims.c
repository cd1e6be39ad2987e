/* claims.c - inside a check: what it may say and run; see judge.h. */
#include "judging.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *work_file(const char *name, char path[PATH_SIZE])
{
    snprintf(path, PATH_SIZE, "%s/%s", judging.work, name);
    return path;
}

/* Who takes the folder or the descriptors away is no trouble of the judge. */
static FILE *open_work(const char *name, const char *mode)
{
    char path[PATH_SIZE];
    FILE *file = fopen(work_file(name, path), mode);
    if (!file && errno != ENOSPC) before_quit = NULL;
    if (!file) quit("cannot write %s", path);
    return file;
}

/* Close a file of this, or quit where the disk has no room for it. */
static void close_work(FILE *file)
{
    if (fclose(file) == 0) return;
    if (errno != ENOSPC) before_quit = NULL;
    quit("cannot write into %s", judging.work);
}

void wrong(const char *format, ...)
{
    va_list arguments;
    FILE *file = open_work("judge.message", "w");
    if (judging.again)
        fprintf(file, "slot %s: %s passes in a process of its own, and fails "
                "where other checks have called the program before: something "
                "is kept from call to call, as in a static variable. ",
                judging.again->slot, judging.again->name);
    va_start(arguments, format);
    vfprintf(file, format, arguments);
    va_end(arguments);
    close_work(file);
    _exit(1);
}

void keep_figures(const struct figures *figures)
{
    FILE *file = open_work("judge.figures", "w");
    fprintf(file, "%s\n%s\n%s\n", figures->got, figures->want,
            figures->allowed);
    close_work(file);
}

void expect_close(double got, double want, double tolerance, double scale,
                  const char *what, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(text, sizeof text, what, arguments);
    va_end(arguments);
    if (isfinite(got) && fabs(got - want) <= tolerance * scale) return;
    struct figures figures;
    snprintf(figures.got, sizeof figures.got, "%.17g", got);
    snprintf(figures.want, sizeof figures.want, "%.17g", want);
    snprintf(figures.allowed, sizeof figures.allowed, "%.17g",
             tolerance * scale);
    keep_figures(&figures);
    if (!isfinite(got)) wrong(NOT_FINITE "%s is %g", text, got);
    /* more digits where ten of them are alike */
    const int digits = fabs(got - want) < 1e-9 * fabs(want) ? 17 : 10;
    wrong("%s: got %.*g, want %.*g (off by %.2g; allowed %.2g)", text, digits,
          got, digits, want, fabs(got - want), tolerance * scale);
}

/* Stop this check if the program stopped as none should: at a slot that is
 * not written, or by a signal. */
static void pass_on(const struct output *output)
{
    if (output->status != 3 && output->status >= 0) return;
    fprintf(stderr, "%s\n", output->stderr_);
    fflush(NULL);
    if (output->status == 3) _exit(3);
    while (output->limit == LIMIT_IDLE) pause(); /* until the judge ends it */
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

struct output *output_of_subject(const char *options)
{
    char with_mode[1024];
    for (int r = 0; judging.as && r < judging.lesson->n_run; r++)
        if (strcmp(options, judging.lesson->runs[r]) == 0)
            return output_kept(judging.as, r);
    if (!judging.subject) return output_of(NULL, options, judging.work);
    snprintf(with_mode, sizeof with_mode, "--run %s", options);
    return output_of(judging.subject, with_mode, judging.work);
}

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

void measured(const char *key, double value)
{
    FILE *file = open_work("judge.measured", "a");
    fprintf(file, "%s %.17g\n", key, value);
    close_work(file);
}
