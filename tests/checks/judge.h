/*
 * judge.h - judging one program: checks in forked children, one verdict.
 *
 * tests/checks/NN_slug.c calls functions of the program under test, static ones
 * too, whatever it is (a student's file, the solution, a known mistake).  It
 * lists its checks, the runs and the column rules for the comparison with the
 * reference, and ends with int main() returning judge(&lesson, argc, argv).
 * Every check runs in a child of its own (child.h), with limits on time, memory
 * and output; the last check, added here, compares the output tables with those
 * of the reference solution.  Where all pass, those that have a slot are run in
 * one process, the last one first: a check must not rest on being the first.
 *
 * Names.  A student's program may use any name and define any macro, at file
 * scope too, and no check needs to care: the program is compiled alone, and its
 * names are none of the linker's.  What checks know of it, types, constants and
 * functions, is the solution's (program.h, which comes first); a struct is the
 * program's, where that has other members.
 */
#ifndef TESTS_CHECKS_JUDGE_H
#define TESTS_CHECKS_JUDGE_H

#undef COUNT
#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

/* A claim about the program, cheapest and most telling first. */
struct claim {
    const char *name; /* a claim in words_with_underscores, <= 50 characters */
    void (*check)(void);
    const char *slot; /* the slot to look at, "7a"; NULL when it is no one's */
};

/*
 * How to compare one column with the reference: |yours - reference| <=
 * tolerance * scale, scale being the largest |reference| in the column, or
 * `scale` where that is > 0 (for columns that vanish).  A word, `-` too, must
 * be the reference's word.  A negative tolerance says: do not compare.  Either
 * way there is a reason, which the student sees.  Every column of the
 * reference's tables needs a rule; column "*" stands for all the columns of a
 * table that have none of their own.
 *
 * An order or a constant of errors is allowed more where its errors are small.
 * If errors in column X may be off by d, then X_order may be off by 3 d / error
 * and X_constant by 20 d / error of itself, error being the smaller one of this
 * row and the row before: lengths are halved, and differ from 1 by 2^9 at most.
 */
struct column_rule {
    const char *table, *column;
    double tolerance;
    const char *reason;
    double scale;
};
#define NOT_COMPARED (-1.0)

struct lesson {
    const char *name; /* "07_poisson_bvp" */
    const struct claim *claims;
    int n_claim;
    const char *const *runs; /* option strings; "" is the default scene;
                              * what the reference cannot solve, exit status 1,
                              * must end so, after the same tables */
    int n_run;
    const struct column_rule *rules;
    int n_rule;
    const char *notice;   /* after a pass: what to notice */
    const char *break_it; /* and one thing to break */
    void (*predicted)(void); /* calls measured() for what was to be predicted */
};

/* The program's main(), renamed: see program.h. */
int program_main(int argc, char *argv[]);

/* Run the claims, print the verdict block; 0 when the verdict is OK. */
int judge(const struct lesson *lesson, int argc, char *argv[]);

/* ---- inside a check ---------------------------------------------------- */

/* The check fails with this message (two or three lines at most). */
_Noreturn void wrong(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

/* What the program gives where its header says PREDICT with this key: shown
 * beside the student's answer after a pass, and never a reason to fail. */
void measured(const char *key, double value);

/* wrong() unless condition holds. */
#define expect(condition, ...)              \
    do {                                    \
        if (!(condition)) wrong(__VA_ARGS__); \
    } while (0)

/*
 * |got - want| <= tolerance * scale, and got finite; `what` is printed with
 * both numbers.  Say at the call why the tolerance is what it is.
 */
void expect_close(double got, double want, double tolerance, double scale,
                  const char *what, ...) __attribute__((format(printf, 5, 6)));

/*
 * Arrays to hand over: n numbers that are NaN, or a copy of `values`, with NaN
 * before and behind them.  What a program reads beyond the ends, or before it
 * has set it, shows in its results; and once the check is through, one that has
 * written beyond the ends is wrong().  There is no place for an array in an
 * index that stands beside guarded indices.  They last as long as the check.
 * An array of the program's own, whose length the compiler knows, is guarded by
 * BOUNDS of the Makefile: an index beyond it is a trap.
 */
double *guarded_alloc(int n);
double *guarded_copy(int n, const double values[]);
int *guarded_indices(int n, const int values[]);

/* wrong() if something beside a guarded array has changed; the judge asks after
 * every check. */
void guards_hold(void);

/* wrong() if each further call of `call` keeps so many bytes or more, where the
 * C library counts what is on the heap (glibc 2.33 and later).  What a program
 * keeps from its first call on is its own affair.  Small blocks are not counted
 * exactly: bytes by the thousand. */
void expect_no_leak(void (*call)(void), double bytes, const char *what);

/* A program's output: its exit status, its tables, its last stderr line. */
struct output;

/* Run the program with options, split at spaces; it must exit with 0, and its
 * numbers must be finite. */
struct output *run(const char *options);

/*
 * Run the program with options that it cannot solve: it exits with status 1,
 * and its message on stderr has `text`.  The tables are those that it printed
 * before, the history up to the failure; there may be none, and their numbers
 * may be anything.
 */
struct output *run_unsolved(const char *options, const char *text);

/*
 * Run the program with options that it must refuse or cannot solve: it exits
 * with this status, and its message on stderr has `text`.  With status 1 it
 * may have printed tables, with any other it must not.
 */
void expect_refusal(const char *options, int status, const char *text);

/* Whether there is such a table. */
int has_table(const struct output *output, const char *table);

/* A column of a table, its length in *n (may be NULL); wrong() without it, or
 * when one of its cells is a word. */
const double *column(const struct output *output, const char *table,
                     const char *name, int *n);

/* One number of a table; row -1 is the last row.  wrong() for a word. */
double cell(const struct output *output, const char *table, const char *name,
            int row);

/* One word of a table; wrong() for a number. */
const char *word(const struct output *output, const char *table,
                 const char *name, int row);

/* Whether a cell is the word `-`, a value that there is not. */
int is_missing(const struct output *output, const char *table,
               const char *name, int row);

/* The number of rows of a table; wrong() without the table. */
int row_count(const struct output *output, const char *table);

#endif
