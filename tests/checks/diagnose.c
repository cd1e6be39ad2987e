/* diagnose.c - which of the known mistakes has the program under test? */
#include "judging.h"

#include <ctype.h>
#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 78 };

void print_wrapped(const char *indent, const char *text)
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
        for (int k = 0; k < n; k++) /* a terminal gets nothing but text */
            putchar(iscntrl((unsigned char)text[k]) ? '?' : text[k]);
        at += n;
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
 * catches it, and then what the student is told, in `text`.  That of an
 * equivalent program is empty, and no check catches it. */
static void read_why(const char *name, char check[64], size_t size, char text[])
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/%s.why", judging.mistakes, name);
    FILE *file = fopen(path, "r");
    *check = '\0';
    if (!file || fscanf(file, "%63s", check) == 0 || ferror(file))
        quit("cannot read %s", path);
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
}

/* Whether there is such a program, or what it prints, and the check that
 * catches it is the one that failed first. */
static int is_suspect(const char *name, const char *failed)
{
    char path[PATH_SIZE], check[64], text[2048];
    snprintf(path, sizeof path, "%s/%s", judging.mistakes, name);
    if (!is_kept(path) && access(path, X_OK) != 0) return 0;
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
        struct output *other = output_kept(program, both[i].run);
        same = coincide(both[i].mine, other);
        tells |= (got || other->status == 0) && !coincide(both[i].right, other);
        output_free(other);
    }
    return same && tells;
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
        both[r].right = output_kept(judging.reference, r);
        both[r].seconds = child_seconds() - before;
    }
    /* the cheapest run tells most of them apart */
    qsort(both, (size_t)n_run, sizeof *both, compare_seconds);
    const int n_entry = scandir(judging.mistakes, &entry, NULL, alphasort);
    for (int i = 0; i < n_entry; i++) {
        char *name = entry[i]->d_name, *dot = strchr(name, '.');
        const int known = dot && strcmp(dot, ".why") == 0;
        if (known) *dot = '\0'; /* NAME.why */
        if (known && child_seconds() < SECONDS_JUDGING &&
            is_suspect(name, check) && explains(name, both, got)) {
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

void diagnose(int index, const struct finding *bad, size_t size, char found[])
{
    const struct claim claim = claim_at(judging.lesson, index);
    char suspects[1024] = "", names[1024] = "", name[64];
    char path[PATH_SIZE + 64];
    int n = 0, used = 0;

    if (!judging.mistakes) return;
    if (judging.prepare && child_command(judging.prepare) != 0) return;
    child_restart_clock();
    find_suspects(claim.name, strstr(bad->text, ": got ") != NULL,
                  sizeof suspects, suspects);
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
