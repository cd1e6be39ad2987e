/* judge.c - all the checks of a program, what is said of them, one verdict. */
#define _DARWIN_C_SOURCE /* mkdtemp, on macOS */
#include "judging.h"

#include "predict.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_CLAIMS = 24 };

struct judging judging;

/* The PREDICT lines of the program, and how many are without dots. */
static struct {
    struct prediction line[MAX_PREDICTIONS];
    int n, n_answer;
} predicted;

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

/* Run the claims, one after another, but those that have passed `together`, and
 * print a line for each, or, where they are many, for those that fail.  After
 * one that took all its time, or when time is up, the others are not run. */
static int examine_each(int n, struct finding finding[], int together)
{
    const int most_lines = predicted.n_answer ? 9 : 13; /* leave them room */
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
        } else if (!together || !claim.slot) {
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

/* The claims of the slots in one process, for nearly always all pass, and then
 * what is left, each in its own.  Put into *first the index of the first that
 * fails, n if none does; return whether time was up. */
static int examine_all(int n, struct finding finding[], int *first)
{
    const struct finding *together = &finding[n + 1];
    examine(n + 1, &finding[n + 1]);
    const int pass = together->verdict == PASS;
    if (!pass) child_restart_clock();
    const int over = examine_each(n, finding, pass);
    *first = 0;
    while (*first < n && finding[*first].verdict == PASS) ++*first;
    if (*first < n || pass || together->verdict == NOT_RUN) return over;
    *first = n + 1;
    printf("  %-10s %s\n", verdict_name[together->verdict],
           claim_at(judging.lesson, n + 1).name);
    return over;
}

/* What the student has predicted in this file, if it is given. */
static void read_predictions(const char *source)
{
    if (!source || !judging.lesson->predicted) return;
    predicted.n = predictions_read(source, predicted.line);
    for (int i = 0; i < predicted.n; i++)
        predicted.n_answer += *predicted.line[i].answer != '\0';
}

/* The predictions, one after the other, beside what is measured; `index` is
 * that of their claim. */
static void print_predictions(int index)
{
    struct finding finding;
    char path[PATH_SIZE], line[80], key[4], text[1024] = "";
    double value;

    if (predicted.n > 0 && predicted.n_answer == 0)
        printf("  You predicted nothing.\n");
    if (predicted.n_answer == 0) return;
    remove(work_file("judge.measured", path));
    examine(index, &finding);
    FILE *file = open_regular(path);
    while (file && fgets(line, sizeof line, file))
        for (int i = 0; i < predicted.n; i++) {
            const struct prediction *p = &predicted.line[i];
            if (*p->answer && sscanf(line, "%3s %lf", key, &value) == 2 &&
                strcmp(key, p->key) == 0)
                prediction_compare(p, value, sizeof text, text);
        }
    if (file) fclose(file);
    printf("  Predicted:\n");
    print_wrapped("    ", *text ? text
                                : "the program prints nothing to compare");
}

/* As JUDGE --measured REFERENCE: print what the program gives for each
 * prediction, a line "2a 6741.22" for each; return 1 where one is missing. */
static int print_measured(char *argv[], int index)
{
    struct finding finding;
    char path[PATH_SIZE], line[80];
    judging.reference = absolute(argv[2]);
    make_work(argv[0]);
    child_on_interrupt(remove_work);
    child_work_in(judging.work, NULL);
    examine(index, &finding);
    FILE *file = open_regular(work_file("judge.measured", path));
    while (file && fgets(line, sizeof line, file)) fputs(line, stdout);
    if (file) fclose(file);
    remove_work();
    return finding.verdict != PASS;
}

/* All checks pass. */
static void print_ok(const char *number, int n, const struct finding finding[])
{
    const struct finding none = {.verdict = PASS};
    write_result(&none, "-", "");
    write_report(n, finding, n, "", "");
    print_predictions(n);
    printf("  Notice:\n");
    print_wrapped("    ", judging.lesson->notice);
    printf("  Break it:\n");
    print_wrapped("    ", judging.lesson->break_it);
    printf("VERDICT %s: OK, all %d checks\n", number, n);
}

/* What to do next: where the tables are not those of the reference, see in
 * which cells, with the options that the message names.  Where another check
 * fails first and the default run is right, that comes second.  No hint is
 * about a line that is no table's. */
static const char *what_next(const char *number, int index,
                             const struct finding finding[], size_t size,
                             char text[])
{
    const struct lesson *lesson = judging.lesson;
    const struct finding *tables = &finding[lesson->n_claim];
    const int differ =
        tables->verdict == WRONG || tables->verdict == NONFINITE_;
    const char *options = "";
    for (int r = 0; differ && r < lesson->n_run; r++) {
        const char *run_ = lesson->runs[r];
        const char *at = *run_ ? strstr(tables->text, run_) : NULL;
        const size_t n = strlen(run_);
        if (at && strchr(": ", at[n]) && n > strlen(options)) options = run_;
    }
    const char *given = *options ? " ARGS='" : "", *end = *options ? "'" : "";
    if (strstr(finding[index].text, "belongs to no table"))
        snprintf(text, size, "make lesson-%s", number);
    else if (differ && index == lesson->n_claim)
        snprintf(text, size, "make diff-%s%s%s%s, make hint-%s", number, given,
                 options, end, number);
    else if (*options)
        snprintf(text, size, "make hint-%s, make diff-%s%s%s%s", number, number,
                 given, options, end);
    else if (finding[index].verdict == CRASHED)
        snprintf(text, size, "make debug-%s, make hint-%s", number, number);
    else
        snprintf(text, size, "make hint-%s", number);
    return text;
}

/* The first check that fails, the one of this index of n, and with `search` the
 * known mistakes; the last line is the verdict. */
static void print_failure(const char *number, int n, int index,
                          const struct finding finding[], int search)
{
    const struct finding *bad = &finding[index];
    const char *check = claim_at(judging.lesson, index).name;
    char mistakes[1024] = "", next[300];
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
    printf("    next: %s\n",
           what_next(number, index, finding, sizeof next, next));
    write_report(n, finding, index, mistakes, next);
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
    if (argc == 4 && strcmp(argv[1], "--cells") == 0) {
        cells_print(argv[2], argv[3]);
        return 0;
    }
    if (argc > 3 && strcmp(argv[1], "--keep") == 0) {
        judging.kept = absolute(argv[2]);
        child_work_in(judging.kept, NULL);
        for (int a = 3; a < argc; a++) keep_outputs(absolute(argv[a]));
        return 0;
    }
    be_the_subject(lesson, argc, argv);
    if (argc == 3 && strcmp(argv[1], "--measured") == 0)
        return print_measured(argv, n);
    judging.file = value_of(argc, argv, "--file");
    read_predictions(value_of(argc, argv, "--source"));
    judging.subject = absolute(value_of(argc, argv, "--subject"));
    judging.reference = absolute(value_of(argc, argv, "--reference"));
    judging.mistakes = absolute(value_of(argc, argv, "--mistakes"));
    judging.prepare = value_of(argc, argv, "--prepare");
    judging.result = value_of(argc, argv, "--result");
    judging.report = value_of(argc, argv, "--report");
    judging.kept = absolute(value_of(argc, argv, "--kept"));
    judging.as = value_of(argc, argv, "--as");
    const char *work = value_of(argc, argv, "--work");
    if (n + 2 > MAX_CLAIMS)
        quit("%s has more than %d claims", lesson->name, MAX_CLAIMS - 3);
    if (lesson->n_run > MAX_RUNS)
        quit("%s has more than %d runs", lesson->name, MAX_RUNS);
    if (!judging.file || !judging.reference)
        quit("usage: %s --file FILE [--source FILE] [--subject JUDGE] "
             "--reference PROGRAM [--mistakes FOLDER] [--prepare COMMAND] "
             "[--result FILE] [--report FILE] [--kept FOLDER "
             "[--as MISTAKE]] [--work FOLDER]", argv[0]);
    make_work(work ? work : argv[0]);
    child_on_interrupt(remove_work);
    child_work_in(judging.work, judging.subject);

    setvbuf(stdout, NULL, _IOLBF, 0);
    printf("%s\n", judging.file);
    int first;
    const int over = examine_all(n, finding, &first);
    if (first == n)
        print_ok(number, n, finding);
    else
        print_failure(number, n, first, finding, !over);
    remove_work();
    return first == n ? 0 : 1;
}
