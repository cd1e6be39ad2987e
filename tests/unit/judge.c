/*
 * judge.c - laws of tests/checks/judge.h and output.h: what the judge reads
 * from a program's output, and what it takes for a difference.
 */
#define _DARWIN_C_SOURCE /* as judge.c and verdict.c need it */
#define JUDGE_SECONDS 300 /* valgrind takes forty times as long */
#include "../checks/confine.c"

/* The judge's clock, which may jump. */
#include <time.h>
static double jump_by;
static int told_time(clockid_t which, struct timespec *now)
{
    static int asked;
    const int status = clock_gettime(which, now);
    if (jump_by > 0.0 && ++asked > 5) now->tv_sec += (time_t)jump_by;
    return status;
}
#define clock_gettime told_time
#undef _DEFAULT_SOURCE /* each of the two files defines it */
#include "../checks/child.c"
#undef clock_gettime

#include "../checks/sight.c"

#include "../checks/output.c"

#include "../checks/guard.c"

#include "../checks/predict.c"

#include "../checks/claims.c"

#include "../checks/tables.c"

#include "../checks/kept.c"

#include "../checks/compare.c"

#include "../checks/cells.c"

#include "../checks/verdict.c"

#include "../checks/report.c"

#include "../checks/diagnose.c"

#include "../checks/judge.c"

#include "base/status.h"
#include "unit.h"

#include <fcntl.h>

/* The program that is judged here: it prints this and ends so. */
static struct {
    const char *text, *message;
    int status;
} program;

int program_main(int argc, char *argv[])
{
    (void)argc;
    (void)argv;
    fputs(program.text, stdout);
    fputs(program.message, stderr);
    return program.status;
}

static struct output *printed(const char *text, int status)
{
    program.text = text;
    program.message = "why it stopped: NOT_SPD";
    program.status = status;
    return output_of(NULL, "", judging.work);
}

static void begin(void)
{
    static const struct column_rule rules[] = {
        {"t", "free", NOT_COMPARED, "it differs from run to run", 0},
        {"t", "*", 1e-9, "round-off", 0},
        {"orders", "err", 1e-12, "round-off", 1.0},
        {"orders", "*", 1e-9, "round-off", 0},
    };
    static const struct lesson lesson = {
        .name = "00_unit", .rules = rules, .n_rule = COUNT(rules)};
    judging.lesson = &lesson;
    snprintf(judging.work, sizeof judging.work, "/tmp/unit's judge.XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(judging.work));
}

static void cells_are_numbers_or_words(void)
{
    begin();
    struct output *o = printed("# t\n# note\nmethod\tx\ty\n"
                               "exact\t1.5\t-\nline search\t-2e3\t3e\n"
                               "1x\tnan\t-inf\n\n\n",
                               0);
    ck_assert_str_eq(o->error, "");
    ck_assert_int_eq(row_count(o, "t"), 3);
    ck_assert_str_eq(word(o, "t", "method", 1), "line search");
    ck_assert_str_eq(word(o, "t", "method", -1), "1x");
    ck_assert_str_eq(word(o, "t", "y", 1), "3e");
    ck_assert(cell(o, "t", "x", 0) == 1.5 && cell(o, "t", "x", 1) == -2e3);
    ck_assert(isnan(cell(o, "t", "x", 2)) && cell(o, "t", "y", 2) < -1e308);
    ck_assert(is_missing(o, "t", "y", 0) && !is_missing(o, "t", "y", 1));
    ck_assert(!is_missing(o, "t", "x", 2) && !has_table(o, "u"));
    output_free(o);
    remove_work();
}

/* Many rows, so that the arrays grow several times. */
static void every_row_keeps_its_cells(void)
{
    enum { N = 3000 };
    static char text[N * 40];
    size_t end = (size_t)sprintf(text, "# t\nk\tw\tm\n");
    for (int k = 0; k < N; k++)
        end += (size_t)sprintf(text + end, "%d\tw%d\t%s\n", k, k % 37,
                               k % 3 ? "2.385" : "-");
    begin();
    struct output *o = printed(text, 0);
    ck_assert_int_eq(row_count(o, "t"), N);
    for (int k = 0; k < N; k++) {
        char w[16];
        snprintf(w, sizeof w, "w%d", k % 37);
        ck_assert(cell(o, "t", "k", k) == k);
        ck_assert_str_eq(word(o, "t", "w", k), w);
        ck_assert_int_eq(is_missing(o, "t", "m", k), k % 3 == 0);
    }
    output_free(o);
    remove_work();
}

static void unreadable_output_is_named(void)
{
    static const char *const bad[][2] = {
        {"# t\na\tb\n1\t2\nhere\n",
         "table `t`, row 2: 1 cells, but 2 columns, in the line `here`"},
        {"# t\na\n1\t2\n", "table `t`, row 1: 2 cells, but 1 columns"},
        {"# t\na\n1\n\n5\n", "a line that belongs to no table: `5`"},
        {"hello\n", "no table: `hello`. stdout is for tables"},
    };
    begin();
    for (int i = 0; i < COUNT(bad); i++) {
        struct output *o = printed(bad[i][0], 0);
        ck_assert_msg(strstr(o->error, bad[i][1]), "%s", o->error);
        output_free(o);
    }
    char text[1024] = "# t\n";
    for (int c = 0; c <= MAX_COLUMNS; c++)
        strcat(text, c < MAX_COLUMNS ? "c\t" : "c\n");
    struct output *o = printed(text, 0);
    ck_assert_str_eq(o->error, "table `t` has more than 32 columns");
    output_free(o);
    text[0] = '\0';
    for (int t = 0; t <= MAX_TABLES; t++) strcat(text, "# t\na\n1\n\n");
    o = printed(text, 0);
    ck_assert_str_eq(o->error, "more than 64 tables");
    output_free(o);
    remove_work();
}

/* What the judge says of a program that prints `mine` for `reference`. */
static const char *difference(const char *mine, const char *reference)
{
    static char text[900];
    struct output *got = printed(mine, 0), *want = printed(reference, 0);
    if (!tables_differ(got, want, sizeof text, text)) text[0] = '\0';
    output_free(got);
    output_free(want);
    return text;
}

static void words_must_be_the_reference_s(void)
{
    const char *const want = "# t\nlaw\tx\tfree\nlog\t1\tA\ncubic\t-\t2\n\n\n";
    begin();
    ck_assert_str_eq(difference(want, want), "");
    ck_assert_str_eq(
        difference("# t\nlaw\tx\tfree\nlog\t1\t7\ncubic\t-\t-\n", want), "");
    ck_assert_str_eq(
        difference("# t\nfree\tx\tlaw\n7\t1.0000000001\tlog\n7\t-\tcubic\n",
                   want), "");
    ck_assert_str_eq(
        difference("# t\nlaw\tx\tfree\nlog\t1\tA\nlin\t-\t2\n", want),
        "table `t`, row 2 (law = `cubic`), column `law`: yours `lin`, "
        "reference `cubic`");
    ck_assert_str_eq(
        difference("# t\nlaw\tx\tfree\nlog\t1\tA\ncubic\t0\t2\n", want),
        "table `t`, row 2 (law = `cubic`), column `x`: yours 0, "
        "reference `-`");
    ck_assert_str_eq(
        difference("# t\nlaw\tx\tfree\nlog\t-\tA\ncubic\t-\t2\n", want),
        "table `t`, row 1 (law = `log`), column `x`: yours `-`, reference 1");
    ck_assert_ptr_nonnull(
        strstr(difference("# t\nlaw\tx\tfree\nlog\tnan\tA\ncubic\tnan\t2\n",
                          want), "yours nan, reference `-`"));
    ck_assert_ptr_nonnull(
        strstr(difference("# t\nlaw\tx\tfree\nlog\t1.1\tA\ncubic\t-\t2\n",
                          want), "yours 1.1, reference 1, 1e+08 times"));
    remove_work();
}

/* The errors may be off by 1e-12: the order by 3e-12 over the error, and the
 * constant by 20e-12 over the error, of itself. */
static void an_order_is_as_good_as_its_errors(void)
{
    static const char *const want = "# orders\nerr\terr_order\terr_constant\n"
                                    "1e-2\t2\t7\n1e-9\t4\t8\n";
    static const struct {
        double order, constant;
        int differs;
    } trial[] = {{4.0029, 8.15, 0}, {4.0031, 8.0, 1}, {3.9969, 8.0, 1},
                 {4.0, 8.17, 1}, {4.0, 7.83, 1}};
    begin();
    for (int i = 0; i < COUNT(trial); i++) {
        char text[200];
        snprintf(text, sizeof text, "# orders\nerr\terr_order\terr_constant\n"
                 "1e-2\t2\t7\n1.0005e-9\t%g\t%g\n", trial[i].order,
                 trial[i].constant);
        ck_assert_msg((*difference(text, want) != 0) == trial[i].differs,
                      "trial %d: %s", i, difference(text, want));
    }
    ck_assert_ptr_nonnull(
        strstr(difference("# orders\nerr\terr_order\terr_constant\n"
                          "1e-2\t2.000001\t7\n1e-9\t4\t8\n", want),
               "column `err_order`: yours 2.000001"));
    remove_work();
}

static const char *const HISTORY = "# t\nx\n1\n2\n\n\n";

static void known_mistakes_tell_by_words_and_histories(void)
{
    begin();
    struct output *o[] = {printed(HISTORY, 0), printed(HISTORY, 1),
                          printed("# t\nx\n1\n-\n\n\n", 1), printed("", 1),
                          printed("", 2)};
    for (int i = 0; i < COUNT(o); i++)
        for (int k = 0; k < COUNT(o); k++) /* all but the history of none */
            ck_assert_msg(coincide(o[i], o[k]) ==
                              (i == k || (k == 3 && (i == 1 || i == 2))),
                          "%d and %d", i, k);
    for (int i = 0; i < COUNT(o); i++) output_free(o[i]);
    remove_work();
}

/* ---- as the student sees it: what a claim in its child comes to ---------- */

static void expect_finding(void (*check)(void), enum verdict verdict,
                           const char *message)
{
    const struct claim claim = {"check", check, "0a"};
    const struct lesson lesson = {
        .name = "00_unit", .claims = &claim, .n_claim = 1};
    const struct lesson *before = judging.lesson;
    struct finding finding = {0};
    judging.lesson = &lesson;
    examine(0, &finding);
    judging.lesson = before;
    ck_assert_msg(finding.verdict == verdict, "%s: %s",
                  verdict_name[finding.verdict], finding.text);
    ck_assert_msg(strstr(finding.text, message), "it says: %s", finding.text);
}

static void expect_wrong(void (*check)(void), const char *message)
{
    expect_finding(check, message ? WRONG : PASS, message ? message : "");
}

static void ask_refusal(void)
{
    expect_refusal("--p 1", 1, "NOT_SPD");
}

static void ask_bad_usage(void)
{
    expect_refusal("--p 1", 2, "NOT_SPD");
}

static void ask_other_reason(void)
{
    expect_refusal("--p 1", 1, "STALLED");
}

static void ask_history(void)
{
    struct output *o = run_unsolved("--p 1", "NOT_SPD");
    expect(cell(o, "t", "x", -1) == 2, "the history is not there");
    output_free(o);
}
static void ask_solved(void)
{
    output_free(run("--p 1"));
}

static void ask_number(void)
{
    cell(run("--p 1"), "t", "law", 0);
}

static void ask_numbers(void)
{
    column(run("--p 1"), "t", "law", NULL);
}

static void ask_word(void)
{
    word(run("--p 1"), "t", "x", 0);
}

static void unsolved_runs_keep_their_tables(void)
{
    begin();
    output_free(printed(HISTORY, 1));
    expect_wrong(ask_history, NULL);
    expect_wrong(ask_refusal, NULL);
    expect_wrong(ask_bad_usage, "must stop with exit status 2, not 1");
    expect_wrong(ask_other_reason, "the message must say STALLED");
    expect_wrong(ask_solved, "stopped with exit status 1: why it stopped");
    output_free(printed("", 1));
    expect_wrong(ask_refusal, NULL);
    output_free(printed("no table\n", 1));
    expect_wrong(ask_history, "the output cannot be read");
    output_free(printed("", 2));
    expect_wrong(ask_bad_usage, NULL);
    output_free(printed(HISTORY, 2));
    expect_wrong(ask_bad_usage, "prints something and then fails");
    remove_work();
}

static void a_word_is_no_number(void)
{
    begin();
    output_free(printed("# t\nlaw\tx\nlog\t1\n", 0));
    expect_wrong(ask_solved, NULL);
    expect_wrong(ask_number, "`law`: the word log stands where a number");
    expect_wrong(ask_numbers, "`law`: the word log stands where a number");
    expect_wrong(ask_word, "column `x`: the number 1 stands where a word");
    output_free(printed("# t\nlaw\tx\nlog\tnan\n", 0));
    expect_finding(ask_solved, NONFINITE_,
                   "not finite: table `t`, row 1, column `x` is nan");
    remove_work();
}

static void leave(void) { exit(0); }
static void leave_at_once(void) { _exit(0); }
static void leave_like_wrong(void) { _exit(1); }
static void trap(void) { abort(); } /* which no sanitizer takes over */
static void stop(void) { raise(SIGSTOP); }
static void index_beyond(void) { raise(SIGILL); } /* as BOUNDS has it */
static void not_written(void) { todo("0b"); }
static void write_behind(void) { guarded_alloc(3)[3] = 2.385; }
static void write_before(void) { guarded_alloc(3)[-1] = 2.385; }
static void change_behind(void) { guarded_alloc(3)[3] += 2.385; }
static double *kept[32];
static int n_kept;
static void keep_some(void) { kept[n_kept++ % 32] = malloc(40000); }
static void keep_none(void)
{
    keep_some();
    free(kept[--n_kept]);
}
static void leak(void) { expect_no_leak(keep_some, 32000.0, "keep_some()"); }
static void no_leak(void) { expect_no_leak(keep_none, 32000.0, "it"); }
static void stay_inside(void)
{
    const double values[] = {2.385, -1.247};
    double *array = guarded_alloc(2);
    for (int i = -3; i < 5; i++)
        expect(isnan(array[i]), "entry %d is no NaN", i);
    array[0] = array[1] = 0.0;
    array = guarded_copy(2, values);
    expect(array[1] == -1.247 && isnan(array[2]) && isnan(array[-1]),
           "the copy is another");
    expect(guarded_indices(2, (const int[]){3, 7})[1] == 7, "other indices");
}
static void daemonise(void)
{
    if (fork() == 0) {
        setsid();
        if (fork() == 0)
            for (;;) pause();
        _exit(0);
    }
}
static void look_at_descriptors(void)
{
    char c;
    expect(read(STDIN_FILENO, &c, 1) == 0, "stdin is not empty");
    for (int fd = CHILD_DESCRIPTOR + 1; fd < 64; fd++) /* that is the judge's */
        expect(fcntl(fd, F_GETFD) < 0, "descriptor %d is open", fd);
}

static void every_end_has_its_verdict(void)
{
    const double before = heap_bytes();
    keep_some();
    const int counted = heap_bytes() > before + 32000.0;
    begin();
    const int open_one = dup(STDOUT_FILENO);
    expect_finding(leave, CRASHED, "with exit(0)");
    expect_finding(leave_at_once, CRASHED, "with exit(0)");
    expect_finding(leave_like_wrong, CRASHED, "with exit(1)");
    expect_finding(trap, CRASHED, "signal 6");
    expect_finding(stop, CRASHED, "stopped itself");
    expect_finding(index_beyond, CRASHED, "an index beyond the end");
    expect_finding(not_written, UNFINISHED, "slot 0b is not written yet");
    expect_finding(look_at_descriptors, PASS, "");
    expect_finding(daemonise, PASS, "");
    expect_finding(stay_inside, PASS, "");
    expect_finding(no_leak, PASS, "");
    if (counted)
        expect_finding(leak, WRONG, "each call of keep_some() keeps memory");
    expect_finding(write_behind, WRONG, "entries 0 to 2, and entry 3");
    expect_finding(write_before, WRONG, "entries 0 to 2, and entry -1");
    expect_finding(change_behind, WRONG, "entries 0 to 2, and entry 3");
    ck_assert_int_eq(waitpid(-1, NULL, WNOHANG), -1); /* no child is left */
    close(open_one);
    remove_work();
}

/* Of a student's program `mine` all runs are like `text` with this status; the
 * right one prints HISTORY.  Is a program that prints `other` so explained? */
static int explained(const char *mine, int my_status, const char *other,
                     int other_status, int got)
{
    static const char *const runs[] = {""};
    struct lesson lesson = *judging.lesson;
    const struct lesson *before = judging.lesson;
    struct both both = {.mine = printed(mine, my_status),
                        .right = printed(HISTORY, 0)};
    char path[PATH_SIZE];
    FILE *file = fopen(work_file("mistake", path), "w");
    fprintf(file, "#!/bin/sh\nprintf '%s'\nexit %d\n", other, other_status);
    fclose(file);
    chmod(path, 0700);
    lesson.runs = runs;
    lesson.n_run = 1;
    judging.lesson = &lesson;
    const int is = explains("mistake", &both, got);
    judging.lesson = before;
    output_free(both.mine);
    output_free(both.right);
    return is;
}

/* A program that gives up at once is like every other that does, unless a check
 * has got a number from it. */
static void what_gives_up_at_once_explains_nothing(void)
{
    static const char *const one = "# t\nx\n1\n\n\n";
    static const char *const two = "# t\nx\n1\n2.385\n\n\n";
    begin();
    judging.mistakes = judging.work;
    ck_assert(explained(two, 0, two, 0, 0));
    ck_assert(!explained(one, 0, two, 0, 0) && !explained(two, 0, one, 0, 0));
    ck_assert(!explained(two, 0, two, 1, 0) && !explained(two, 1, two, 0, 1));
    ck_assert(!explained(HISTORY, 0, HISTORY, 0, 1)); /* the right numbers */
    ck_assert(!explained(one, 1, one, 1, 0));
    ck_assert(explained(one, 1, one, 1, 1));
    judging.mistakes = NULL;
    remove_work();
}

/* Only a program is a suspect that the check catches which failed first. */
static void suspects_are_caught_by_what_failed_first(void)
{
    static const char *const failed[][2] = {
        {"lift_is_there", "yes"},
        {"lift_is_there_too", ""},
        {"no_lift_is_there", ""},
        {"", ""},
    };
    char path[PATH_SIZE], check[64], told[80];
    begin();
    judging.mistakes = judging.work;
    FILE *why = fopen(work_file("lost.why", path), "w");
    fputs("lift_is_there\nThe lift is lost.\n", why);
    fclose(why);
    ck_assert(!is_suspect("lost", "lift_is_there")); /* there is none */
    fclose(fopen(work_file("lost", path), "w"));
    chmod(path, 0700);
    for (int i = 0; i < COUNT(failed); i++) {
        ck_assert_int_eq(is_suspect("lost", failed[i][0]), *failed[i][1] != 0);
        ck_assert(!is_suspect("lost.why", failed[i][0]));
    }
    read_why("lost", check, sizeof told, told);
    ck_assert_str_eq(check, "lift_is_there");
    ck_assert_str_eq(told, "\nThe lift is lost.\n");
    judging.mistakes = NULL;
    remove_work();
}

static void messages_agree_but_for_round_off(void)
{
    static const char *const mine = "u at node 3: got -0.914, want 2e-17";
    static const struct {
        const char *other;
        int same;
    } trial[] = {
        {"u at node 3: got -0.914, want 2e-17", 1},
        {"u at node 3: got -0.9140000002, want -5e-16", 1},
        {"u at node 3: got -0.91401, want 2e-17", 0},
        {"u at node 3: got 0.914, want 2e-17", 0},
        {"u at node 3: got -0.914, want 2e-7", 0},
        {"u at node 2: got -0.914, want 2e-17", 0},
        {"v at node 3: got -0.914, want 2e-17", 0},
        {"u at node 3: got nan, want 2e-17", 0},
        {"u at node 3: got -0.914, want", 0},
        {"u at node 3: got -0.914, want 2e-17 m", 0},
        {"", 0},
    };
    for (int i = 0; i < COUNT(trial); i++) {
        ck_assert_int_eq(say_the_same(mine, trial[i].other), trial[i].same);
        ck_assert_int_eq(say_the_same(trial[i].other, mine), trial[i].same);
    }
    ck_assert(say_the_same("nan is", "nan is"));
}

/* A program that sleeps for a moment, in which the judge does not see the clock
 * for long: what it waits for is no idleness of the program. */
static void sleeps(void *context)
{
    (void)context;
    doze(400000);
    _exit(0);
}
static void a_judge_that_was_frozen_ends_nothing(void)
{
    char out[sizeof judging.work + 8], err[sizeof judging.work + 8];
    begin();
    snprintf(out, sizeof out, "%s/out", judging.work);
    snprintf(err, sizeof err, "%s/err", judging.work);
    jump_by = 1000.0;
    const struct ending ending = child_run(sleeps, NULL, out, err);
    jump_by = 0.0;
    ck_assert_int_eq(ending.limit, NO_LIMIT);
    ck_assert_int_eq(ending.status, 0);
}

UNIT_MAIN("judge",
    LAW(a_judge_that_was_frozen_ends_nothing),
    LAW(suspects_are_caught_by_what_failed_first),
    LAW(what_gives_up_at_once_explains_nothing),
    LAW(messages_agree_but_for_round_off),
    LAW(cells_are_numbers_or_words),
    LAW(every_row_keeps_its_cells),
    LAW(unreadable_output_is_named),
    LAW(words_must_be_the_reference_s),
    LAW(an_order_is_as_good_as_its_errors),
    LAW(known_mistakes_tell_by_words_and_histories),
    LAW(unsolved_runs_keep_their_tables),
    LAW(a_word_is_no_number),
    LAW(every_end_has_its_verdict))
