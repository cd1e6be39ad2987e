/*
 * judging.h - what the parts of the judge know of each other; checks see only
 * judge.h.  claims.c and tables.c are what a check may call; compare.c adds the
 * last check, and cells.c prints what it compares; verdict.c runs one in a
 * child (output.h, child.h); kept.c spares runs of the workbook's programs;
 * report.c writes for machines; diagnose.c looks for
 * known mistakes; judge.c runs all and prints.  Each calls those named before
 * it only.
 */
#ifndef TESTS_CHECKS_JUDGING_H
#define TESTS_CHECKS_JUDGING_H

#include "judge.h"
#include "output.h"

enum { MAX_RUNS = 16 };

/* Paths are absolute: a child works in the folder `work`. */
struct judging {
    const struct lesson *lesson;
    const char *file;      /* what is judged, for the heading */
    const char *subject;   /* the judge with that program compiled in; NULL:
                            * this one */
    const char *reference; /* program of the reference solution */
    const char *mistakes;  /* folder with the known mistakes' programs */
    const char *prepare;   /* command that builds them, or NULL */
    const char *result;    /* file for "verdict check slot mistakes" */
    const char *report;    /* file for all that is said; NULL: none */
    const char *kept;      /* folder with what the reference and the known
                            * mistakes have printed; NULL: run them */
    const struct claim *again; /* the one that is asked after others, in
                                * one process, or NULL */
    const char *as;        /* the mistake that is judged itself, or NULL */
    char work[PATH_SIZE - 300]; /* folder for captured output */
};
extern struct judging judging;

/* How the messages begin that are no slot's, or a verdict of their own. */
#define UNREADABLE "the output cannot be read: "
#define NOT_FINITE "not finite: "

enum verdict { PASS, WRONG, UNFINISHED, CRASHED, TIMEOUT, NONFINITE_, NOT_RUN };
extern const char *const verdict_name[];

/* What a check that fails has compared: numbers or words, or nothing. */
struct figures {
    char got[80], want[80], allowed[32];
};

/* What a check has found. */
struct finding {
    enum verdict verdict;
    char text[1100];
    struct figures figures;
    char slot[16];
    int costly; /* it took all its time or output: do not run the others */
};

/* ---- claims.c */

/* A file in the folder of the judge. */
const char *work_file(const char *name, char path[PATH_SIZE]);

/* Before wrong(): what its message compares. */
void keep_figures(const struct figures *figures);

/* The output of the program under test. */
struct output *output_of_subject(const char *options);

/* ---- kept.c */

/*
 * `make test` asks again and again what a reference or a known mistake prints:
 * its rules have a judge run each program once, with all options of the lesson,
 * and keep that in the folder judging.kept.  A judge of a student's program is
 * given no such folder.
 */
void keep_outputs(const char *program);
int is_kept(const char *program);
/* What the program prints in run r of the lesson: kept, or else run now.  What
 * is kept has cost the seconds that it took. */
struct output *output_kept(const char *program, int r);

/* ---- compare.c */

/* Whether some table of `want` is missing or different in `got`; then `text`
 * says where. */
int tables_differ(const struct output *got, const struct output *want,
                  size_t size, char text[]);

/* The rule of a column, or NULL; what it allows |yours - reference|; what a row
 * is allowed on top of that; and the difference in units of both together, 0
 * where there is none. */
const struct column_rule *find_rule(const char *table, const char *name);
double column_allows(const struct column_rule *rule,
                     const struct named_table *want, int c);
double row_allows(const struct named_table *want, int c, int r);
double times_allowed(double got, double want, double limit);

/* The check that every lesson ends with. */
void check_same_numbers_as_reference(void);

/* ---- cells.c */

/* Two files with output, cell by cell; see there. */
void cells_print(const char *mine, const char *reference);

/* ---- verdict.c */

/* The claim of this index: those of the lesson, the one that every lesson ends
 * with, and behind it what was predicted; then those of the slots in one
 * process, the last one first. */
struct claim claim_at(const struct lesson *lesson, int index);

/* In the child: the check.  That it came to its end is said by a number, which
 * the judge hands over and gets back. */
void run_claim(const struct claim *claim);

/* Run the claim of this index in a child of its own. */
void examine(int index, struct finding *finding);

/* ---- report.c */

/* Write what was found to judging.report, if it is asked for: records that end
 * in RS, of fields with US between.  The first has lesson, file, verdict,
 * check, slot, mistakes (commas between), next and message; each other one a
 * check: claim, status, slot, got, want, allowed and message.  What there is
 * not is empty; `first` is the index of the first check that fails, n if none
 * does. */
void write_report(int n, const struct finding finding[], int first,
                  const char *mistakes, const char *next);

/* ---- diagnose.c */

/* Print text, wrapped, each line with this indent. */
void print_wrapped(const char *indent, const char *text);

/* Say which known mistakes give the numbers of the program under test: its
 * output, and what it is told by the first check that it fails, the one of this
 * index.  Their names, with commas between, go to `found`. */
void diagnose(int index, const struct finding *bad, size_t size, char found[]);

#endif
