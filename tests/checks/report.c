/* report.c - the verdict as a file for tests/tools/json.awk. */
#include "judging.h"

static const char FIELD = '\037', RECORD = '\036';

/* One field, and what ends it; the text has neither of the two ends. */
static void put(FILE *file, const char *text, char end)
{
    for (const char *c = text; *c; c++)
        putc(*c == FIELD || *c == RECORD ? '?' : *c, file);
    putc(end, file);
}

static const char *status_of(enum verdict verdict)
{
    return verdict == PASS      ? "passed"
           : verdict == NOT_RUN ? "not run"
                                : "failed";
}

void write_report(int n, const struct finding finding[], int first,
                  const char *mistakes, const char *next)
{
    const struct finding *bad = first != n ? &finding[first] : NULL;
    if (!judging.report) return;
    FILE *file = fopen(judging.report, "w");
    if (!file) quit("cannot write %s", judging.report);
    put(file, judging.lesson->name, FIELD);
    put(file, judging.file, FIELD);
    put(file, bad ? verdict_name[bad->verdict] : "OK", FIELD);
    put(file, bad ? claim_at(judging.lesson, first).name : "", FIELD);
    put(file, bad ? bad->slot : "", FIELD);
    put(file, mistakes, FIELD);
    put(file, next, FIELD);
    put(file, bad ? bad->text : "", RECORD);
    for (int k = 0; k < (first > n ? n + 1 : n); k++) {
        const int i = k < n ? k : first;
        const struct claim claim = claim_at(judging.lesson, i);
        const int run_at_all = finding[i].verdict != NOT_RUN;
        put(file, claim.name, FIELD);
        put(file, status_of(finding[i].verdict), FIELD);
        put(file, run_at_all || !claim.slot ? finding[i].slot : claim.slot,
            FIELD);
        put(file, finding[i].figures.got, FIELD);
        put(file, finding[i].figures.want, FIELD);
        put(file, finding[i].figures.allowed, FIELD);
        put(file, finding[i].text, RECORD);
    }
    if (fclose(file) != 0) quit("cannot write %s", judging.report);
}
