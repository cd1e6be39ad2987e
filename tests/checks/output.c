/* output.c - see output.h. */
#include "output.h"

#include "judge.h" /* program_main */

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

void quit(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("judge: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

/* ---- output tables ------------------------------------------------------ */

static void read_row(struct output *output, struct named_table *table,
                     char *line)
{
    if (table->n_row == table->capacity) {
        const int capacity = table->capacity ? 2 * table->capacity : 64;
        double *value =
            malloc(sizeof *value * (size_t)capacity * (size_t)table->n_column);
        if (!value) quit("out of memory");
        for (int c = 0; c < table->n_column; c++)
            for (int r = 0; r < table->n_row; r++)
                value[c * capacity + r] = table->value[c * table->capacity + r];
        free(table->value);
        table->value = value;
        table->capacity = capacity;
    }
    char *rest = line;
    for (int c = 0; c < table->n_column; c++) {
        char *end;
        const double value = strtod(rest, &end);
        if (end == rest || (*end != '\t' && *end != '\0' && *end != ' ')) {
            snprintf(output->error, sizeof output->error,
                     "table `%s`, row %d: no number under `%s`", table->name,
                     table->n_row + 1, table->column[c]);
            return;
        }
        table->value[c * table->capacity + table->n_row] = value;
        rest = end;
    }
    table->n_row++;
}

static void read_header(struct named_table *table, char *line)
{
    for (char *word = strtok(line, "\t ");
         word && table->n_column < MAX_COLUMNS; word = strtok(NULL, "\t "))
        snprintf(table->column[table->n_column++], sizeof table->column[0],
                 "%.60s", word);
}

/* Tables as common/table.h describes them; comment lines after the name and
 * blank lines between tables are free. */
static void read_tables(struct output *output, const char *path)
{
    FILE *file = fopen(path, "r");
    char line[4096];
    struct named_table *table = NULL;

    if (!file) quit("cannot read %s: %s", path, strerror(errno));
    while (!*output->error && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\r\n")] = '\0';
        if (line[strspn(line, " \t")] == '\0') {
            table = NULL;
        } else if (line[0] == '#') {
            if (table) continue;
            if (output->n_table == MAX_TABLES) {
                snprintf(output->error, sizeof output->error,
                         "more than %d tables", MAX_TABLES);
                break;
            }
            table = &output->table[output->n_table++];
            snprintf(table->name, sizeof table->name, "%.60s",
                     line + 1 + strspn(line + 1, " \t"));
        } else if (!table) {
            snprintf(output->error, sizeof output->error,
                     "a line that belongs to no table: %.60s", line);
        } else if (table->n_column == 0) {
            read_header(table, line);
        } else {
            read_row(output, table, line);
        }
    }
    fclose(file);
}

void output_free(struct output *output)
{
    if (!output) return;
    for (int t = 0; t < output->n_table; t++) free(output->table[t].value);
    free(output);
}

const struct named_table *find_table(const struct output *output,
                                     const char *name)
{
    for (int t = 0; t < output->n_table; t++)
        if (strcmp(output->table[t].name, name) == 0) return &output->table[t];
    return NULL;
}

const double *find_column(const struct named_table *table, const char *name)
{
    for (int c = 0; c < table->n_column; c++)
        if (strcmp(table->column[c], name) == 0)
            return table->value + c * table->capacity;
    return NULL;
}

/* ---- running a program -------------------------------------------------- */

static void limit(int resource, rlim_t value)
{
    struct rlimit rule;
    if (getrlimit(resource, &rule) < 0) return;
    if (rule.rlim_max == RLIM_INFINITY || rule.rlim_max > value)
        rule.rlim_cur = value;
    setrlimit(resource, &rule);
}

void set_limits(void)
{
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, (rlim_t)MEGABYTES_OUTPUT << 20);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__APPLE__)
    limit(RLIMIT_AS, (rlim_t)GIGABYTES_MEMORY << 30);
#endif
}

void redirect(int fd, const char *path)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || dup2(file, fd) < 0) _exit(2);
    close(file);
}

/* The last line of a file that is not empty. */
void last_line(const char *path, size_t size, char text[])
{
    FILE *file = fopen(path, "r");
    char line[512];
    text[0] = '\0';
    while (file && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        if (*line) snprintf(text, size, "%s", line);
    }
    if (file) fclose(file);
}

struct output *output_of(const char *program, const char *options,
                         const char *folder)
{
    char out[320], err[320], words[512], *argv[64];
    int argc = 0;
    struct output *output = calloc(1, sizeof *output);

    if (!output) quit("out of memory");
    snprintf(out, sizeof out, "%s/out.%ld", folder, (long)getpid());
    snprintf(err, sizeof err, "%s/err.%ld", folder, (long)getpid());
    snprintf(words, sizeof words, "%s", options);
    argv[argc++] = (char *)(program ? program : "program");
    for (char *w = strtok(words, " "); w && argc < 63; w = strtok(NULL, " "))
        argv[argc++] = w;
    argv[argc] = NULL;

    fflush(NULL);
    const pid_t child = fork();
    if (child < 0) quit("cannot fork: %s", strerror(errno));
    if (child == 0) {
        redirect(STDOUT_FILENO, out);
        redirect(STDERR_FILENO, err);
        set_limits();
        alarm(SECONDS_A_CHECK);
        if (!program) exit(program_main(argc, argv));
        execv(program, argv);
        _exit(127);
    }
    int status;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) quit("cannot wait: %s", strerror(errno));
    output->status =
        WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    last_line(err, sizeof output->stderr_, output->stderr_);
    if (output->status == 0)
        read_tables(output, out);
    else {
        FILE *file = fopen(out, "r"); /* to tell whether anything was printed */
        if (file && fgetc(file) != EOF) output->n_table = 1;
        if (file) fclose(file);
    }
    remove(out);
    remove(err);
    return output;
}
