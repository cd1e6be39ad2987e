/* output.c - see output.h. */
#include "output.h"

#include "judge.h" /* program_main */

#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void (*before_quit)(void);

void quit(const char *format, ...)
{
    va_list arguments;
    if (before_quit) before_quit();
    va_start(arguments, format);
    fputs("judge: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

FILE *open_regular(const char *path)
{
    struct stat about;
    const int fd = open(path, O_RDONLY | O_NONBLOCK);
    if (fd < 0) return NULL;
    FILE *file = NULL;
    if (fstat(fd, &about) == 0 && S_ISREG(about.st_mode))
        file = fdopen(fd, "r");
    if (!file) close(fd);
    return file;
}

#define STDOUT_IS_FOR_TABLES \
    ". stdout is for tables, so print anything else to stderr"

/* ---- output tables ------------------------------------------------------ */

static void *more(void *old, size_t n, size_t size)
{
    void *memory = realloc(old, n * size);
    if (!memory) quit("out of memory");
    return memory;
}

/* Room for twice as many rows. */
static void grow(struct named_table *table)
{
    const int old = table->capacity, capacity = old ? 2 * old : 64;
    const size_t n = (size_t)capacity * (size_t)table->n_column;
    table->value = more(table->value, n, sizeof *table->value);
    table->word = more(table->word, n, sizeof *table->word);
    for (int c = table->n_column - 1; c > 0; c--) { /* the last one first */
        memmove(table->value + c * capacity, table->value + c * old,
                (size_t)old * sizeof *table->value);
        memmove(table->word + c * capacity, table->word + c * old,
                (size_t)old * sizeof *table->word);
    }
    table->capacity = capacity;
}

static void read_cell(struct named_table *table, int column, const char *text)
{
    const int at = column * table->capacity + table->n_row;
    char *end;
    table->value[at] = strtod(text, &end);
    table->word[at] = NULL;
    if (end != text && *end == '\0') return;
    table->value[at] = NAN;
    table->word[at] = strdup(text);
    if (!table->word[at]) quit("out of memory");
}

static void read_row(struct output *output, struct named_table *table,
                     char *line)
{
    int n_cell = 1;
    for (const char *c = line; *c; c++) n_cell += *c == '\t';
    if (n_cell != table->n_column) {
        if (output->stray) {
            output->stray(line);
            return;
        }
        snprintf(output->error, sizeof output->error,
                 "table `%s`, row %d: %d cells, but %d columns, in the line "
                 "`%.60s`" STDOUT_IS_FOR_TABLES,
                 table->name, table->n_row + 1, n_cell, table->n_column, line);
        return;
    }
    if (table->n_row == table->capacity) grow(table);
    for (int c = 0; c < n_cell; c++) {
        char *end = line + strcspn(line, "\t");
        *end = '\0';
        read_cell(table, c, line);
        line = end + 1;
    }
    table->n_row++;
}

static void read_header(struct output *output, struct named_table *table,
                        char *line)
{
    for (char *name = strtok(line, "\t"); name; name = strtok(NULL, "\t")) {
        if (table->n_column == MAX_COLUMNS) {
            if (output->stray) output->stray(name);
            if (output->stray) return;
            snprintf(output->error, sizeof output->error,
                     "table `%s` has more than %d columns", table->name,
                     MAX_COLUMNS);
            return;
        }
        snprintf(table->column[table->n_column++], sizeof table->column[0],
                 "%.60s", name);
    }
}

/* Tables as table.h describes them; comment lines after the name and blank
 * lines between tables are free. */
static void read_tables(struct output *output, const char *path)
{
    FILE *file = open_regular(path);
    char *line = NULL;
    size_t size = 0;
    struct named_table *table = NULL;

    if (!file) {
        snprintf(output->error, sizeof output->error, "there is none");
        return;
    }
    while (!*output->error && getline(&line, &size, file) >= 0) {
        output->printed = 1;
        if (output->stray && !strchr(line, '\n')) {
            output->stray(line);
            break;
        }
        line[strcspn(line, "\r\n")] = '\0';
        if (line[strspn(line, " \t")] == '\0') {
            table = NULL;
        } else if (line[0] == '#' && table) {
            continue;
        } else if (output->stray &&
                   (line[0] == '#' ? output->n_table == MAX_TABLES : !table)) {
            output->stray(line);
        } else if (line[0] == '#') {
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
                     "a line that belongs to no table: `%.60s`"
                     STDOUT_IS_FOR_TABLES, line);
        } else if (table->n_column == 0) {
            read_header(output, table, line);
        } else {
            read_row(output, table, line);
        }
    }
    free(line);
    fclose(file);
}

struct output *output_read(const char *path, void (*stray)(const char *line))
{
    struct output *output = calloc(1, sizeof *output);
    if (!output) quit("out of memory");
    output->stray = stray;
    read_tables(output, path);
    return output;
}

void output_free(struct output *output)
{
    if (!output) return;
    for (int t = 0; t < output->n_table; t++) {
        struct named_table *table = &output->table[t];
        for (int c = 0; c < table->n_column; c++)
            for (int r = 0; r < table->n_row; r++)
                free(table->word[c * table->capacity + r]);
        free(table->value);
        free(table->word);
    }
    free(output);
}

const struct named_table *find_table(const struct output *output,
                                     const char *name)
{
    for (int t = 0; t < output->n_table; t++)
        if (strcmp(output->table[t].name, name) == 0) return &output->table[t];
    return NULL;
}

int find_column(const struct named_table *table, const char *name)
{
    for (int c = 0; c < table->n_column; c++)
        if (strcmp(table->column[c], name) == 0) return c;
    return -1;
}

double number_at(const struct named_table *table, int column, int row)
{
    return table->value[column * table->capacity + row];
}

const char *word_at(const struct named_table *table, int column, int row)
{
    return table->word[column * table->capacity + row];
}

/* ---- running a program -------------------------------------------------- */

/* The last line of a file that is not empty. */
void last_line(const char *path, size_t size, char text[])
{
    FILE *file = open_regular(path);
    char line[512];
    text[0] = '\0';
    while (file && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        if (*line) snprintf(text, size, "%s", line);
    }
    if (file) fclose(file);
}

struct command {
    const char *program; /* NULL: program_main() */
    int argc;
    char **argv;
};

static void be_program(void *context)
{
    const struct command *command = context;
    if (!command->program) exit(program_main(command->argc, command->argv));
    child_become(command->program, command->argv);
    _exit(127);
}

struct ending output_run(const char *program, const char *options,
                         const char *out, const char *err)
{
    enum { MAX_WORDS = 64 };
    char words[1024], *argv[MAX_WORDS + 1];
    int argc = 0;
    if (snprintf(words, sizeof words, "%s", options) >= (int)sizeof words)
        quit("options of more than %zu characters: %s", sizeof words, options);
    argv[argc++] = (char *)(program ? program : "program");
    for (char *w = strtok(words, " "); w; w = strtok(NULL, " ")) {
        if (argc == MAX_WORDS)
            quit("options of more than %d words: %s", MAX_WORDS - 1, options);
        argv[argc++] = w;
    }
    argv[argc] = NULL;

    struct command command = {program, argc, argv};
    return child_run(be_program, &command, out, err);
}

struct output *output_read_back(struct ending ending, const char *out,
                                const char *err)
{
    struct output *output = calloc(1, sizeof *output);
    if (!output) quit("out of memory");
    output->status = ending.status;
    output->limit = ending.limit;
    last_line(err, sizeof output->stderr_, output->stderr_);
    if (output->status == 0 || output->status == 1) {
        read_tables(output, out);
    } else {
        FILE *file = open_regular(out);
        if (file && fgetc(file) != EOF) output->printed = 1;
        if (file) fclose(file);
    }
    return output;
}

struct output *output_of(const char *program, const char *options,
                         const char *folder)
{
    char out[PATH_SIZE], err[PATH_SIZE];
    snprintf(out, sizeof out, "%s/out.%ld", folder, (long)getpid());
    snprintf(err, sizeof err, "%s/err.%ld", folder, (long)getpid());
    const struct ending ending = output_run(program, options, out, err);
    struct output *output = output_read_back(ending, out, err);
    remove(out);
    remove(err);
    return output;
}
