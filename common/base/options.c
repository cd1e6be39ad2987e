/* options.c - see options.h. */
#include "base/options.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The k-th word of a space-separated list; its length in *length, or 0. */
static const char *word(const char *list, int k, size_t *length)
{
    while (k > 0 && *list)
        if (*list++ == ' ') k--;
    *length = strcspn(list, " ");
    return list;
}

static void print_allowed(FILE *out, const struct option *option)
{
    if (option->choice)
        fprintf(out, "one of: %s", option->choices);
    else if (option->text)
        fprintf(out, "%s", option->unit);
    else
        fprintf(out, "%s from %.10g to %.10g%s%s",
                option->integer ? "a whole number" : "a number", option->min,
                option->max, option->unit ? " " : "",
                option->unit ? option->unit : "");
    if (option->why) fprintf(out, "; %s", option->why);
}

static void print_usage(const char *program, const struct option table[], int n)
{
    printf("usage: %s [--option value] ...\n", program);
    for (int i = 0; i < n; i++) {
        const struct option *option = &table[i];
        printf("  --%-10s %s", option->name, option->help);
        if (option->integer) printf(" [%d]", *option->integer);
        if (option->real) printf(" [%.10g]", *option->real);
        if (option->text && *option->text) printf(" [%s]", *option->text);
        if (option->choice) {
            size_t length;
            const char *name = word(option->choices, *option->choice, &length);
            printf(" [%.*s]", (int)length, name);
        }
        printf("; ");
        print_allowed(stdout, option);
        printf("\n");
    }
}

/* Print the words as one line, whatever they are. */
static void print_words(const char *program, char words[])
{
    for (char *c = words; *c; c++)
        if (iscntrl((unsigned char)*c)) *c = '?';
    fprintf(stderr, "%s: %s", program, words);
}

void options_refuse(const char *program, const char *words)
{
    char copy[600];
    snprintf(copy, sizeof copy, "%s", words);
    print_words(program, copy);
    fputc('\n', stderr);
    exit(2);
}

/* Print one line with the words in question and the values that are allowed. */
_Noreturn static void refuse(const char *program, const struct option *option,
                             const char *format, ...)
{
    char words[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    print_words(program, words);
    fputs(option ? ": must be " : "; -h lists them", stderr);
    if (option) print_allowed(stderr, option);
    fputc('\n', stderr);
    exit(2);
}

/* Store text in the option's variable; 0 when it is not allowed. */
static int set(const struct option *option, const char *text)
{
    if (option->choice) {
        size_t length;
        for (int k = 0;; k++) {
            const char *name = word(option->choices, k, &length);
            if (length == 0) return 0;
            if (strlen(text) == length && strncmp(text, name, length) == 0) {
                *option->choice = k;
                return 1;
            }
        }
    }

    if (option->text) {
        if (*text == '\0') return 0;
        *option->text = text;
        return 1;
    }

    char *end;
    const double value = option->integer ? (double)strtol(text, &end, 10)
                                         : strtod(text, &end);
    if (end == text || *end != '\0') return 0;
    if (!(value >= option->min && value <= option->max)) return 0; /* NaN too */
    if (option->integer)
        *option->integer = (int)value;
    else
        *option->real = value;
    return 1;
}

void options_parse(const char *program, const struct option table[], int n,
                   int argc, char *argv[])
{
    for (int a = 1; a < argc; a++) {
        const char *name = argv[a];
        if (strcmp(name, "-h") == 0 || strcmp(name, "--help") == 0) {
            print_usage(program, table, n);
            exit(0);
        }
        if (strncmp(name, "--", 2) != 0)
            refuse(program, NULL, "'%s' is not an option", name);
        name += 2;

        const size_t length = strcspn(name, "=");
        const struct option *option = NULL;
        for (int i = 0; i < n && !option; i++)
            if (strlen(table[i].name) == length &&
                strncmp(table[i].name, name, length) == 0)
                option = &table[i];
        if (!option)
            refuse(program, NULL, "no option --%.*s", (int)length, name);

        const char *value = /* NULL behind the last word */
            name[length] == '=' ? name + length + 1 : argv[++a];
        if (value && set(option, value)) continue;
        refuse(program, option, "--%s %s", option->name,
               value ? value : "has no value");
    }
}
