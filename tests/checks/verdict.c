/* verdict.c - a check in a child of its own, and how it ended. */
#define _DARWIN_C_SOURCE /* MSG_DONTWAIT, on macOS */
#include "judging.h"

#include <errno.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

const char *const verdict_name[] = {
    "ok", "WRONG", "UNFINISHED", "CRASHED", "TIMEOUT", "NONFINITE", "not run"};

/* The check's own message, if it wrote one. */
static int read_message(size_t size, char text[])
{
    char path[PATH_SIZE];
    FILE *file = open_regular(work_file("judge.message", path));
    if (!file) return 0;
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
    return 1;
}

/* The figures that it wrote before, if any. */
static void read_figures(struct figures *figures)
{
    char path[PATH_SIZE];
    FILE *file = open_regular(work_file("judge.figures", path));
    if (!file) return;
    if (fscanf(file, "%79[^\n]%*c%79[^\n]%*c%31[^\n]", figures->got,
               figures->want, figures->allowed) < 2)
        *figures = (struct figures){0};
    fclose(file);
}

static int starts(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Why a check that wrote no message did not come to its end. */
static void explain_end(struct ending ending, struct finding *finding)
{
    char path[PATH_SIZE], line[512], slot[16];
    char *text = finding->text;
    const size_t size = sizeof finding->text;

    last_line(work_file("judge.stderr", path), sizeof line, line);
    const char *colon = *line ? ": " : "";
    finding->verdict = CRASHED;
    finding->costly = ending.limit != NO_LIMIT;
    if (ending.limit == LIMIT_CPU || ending.limit == LIMIT_IDLE)
        finding->verdict = TIMEOUT;
    if (ending.limit == LIMIT_CPU) {
        snprintf(text, size,
                 "still running after %d seconds of computing: is there a loop "
                 "that cannot stop, or a method that is much too slow?",
                 SECONDS_COMPUTING);
    } else if (ending.limit == LIMIT_IDLE) {
        snprintf(text, size,
                 "still running, but computing nothing: does the program wait "
                 "for something?");
    } else if (ending.limit == LIMIT_OUTPUT) {
        snprintf(text, size,
                 "more than %d MB of output: is there a loop that never stops "
                 "printing?", MEGABYTES_OUTPUT);
    } else if (ending.limit == LIMIT_FILES) {
        snprintf(text, size, "the program has written more than %d files",
                 MOST_FILES);
    } else if (ending.limit == LIMIT_PROCESSES) {
        snprintf(text, size,
                 "the program has started more than %d processes or threads",
                 MOST_PROCESSES);
    } else if (ending.limit == LIMIT_STOPPED) {
        snprintf(text, size, "the program stopped itself with a signal");
    } else if (ending.status == -SIGILL || ending.status == -SIGTRAP) {
        /* that is what BOUNDS of the Makefile makes of it */
        snprintf(text, size, "an index beyond the end of an array, or below 0: "
                 "signal %d", -ending.status);
    } else if (ending.status < 0) {
        snprintf(text, size, "signal %d (%s)%s%s", -ending.status,
                 strsignal(-ending.status), colon, line);
    } else if (ending.status == 3 &&
               sscanf(line, "unfinished: slot %15s", slot) == 1) {
        finding->verdict = UNFINISHED;
        snprintf(finding->slot, sizeof finding->slot, "%s", slot);
        snprintf(text, size, "slot %s is not written yet", slot);
    } else {
        snprintf(text, size,
                 "the program ended in the middle of its work, with exit(%d)"
                 "%s%s", ending.status, colon, line);
    }
}

/* A number that nobody guesses. */
static uint64_t any_number(void)
{
    uint64_t number = (uint64_t)time(NULL) ^ (uint64_t)getpid() << 32;
    FILE *file = fopen("/dev/urandom", "r");
    if (file && fread(&number, sizeof number, 1, file) != 1)
        quit("cannot read /dev/urandom");
    if (file) fclose(file);
    return number;
}

/* While the check runs, the number is nowhere, but two others that give it. */
static uint64_t masked, mask;

/* The number goes back, or one more where the judge itself cannot go on. */
static void say(uint64_t more)
{
    masked = (masked ^ mask) + more;
    if (write(CHILD_DESCRIPTOR, &masked, sizeof masked) < 0) _exit(2);
}

/* In the subject of a judge it is the program that has left no memory, no
 * descriptors or no processes, but not the one that has filled the disk. */
static void say_trouble(void)
{
    if (judging.reference || errno == ENOSPC) say(1);
}

void run_claim(const struct claim *claim)
{
    if (read(CHILD_DESCRIPTOR, &masked, sizeof masked) != sizeof masked)
        quit("no number for the end of a check");
    mask = any_number();
    masked ^= mask;
    before_quit = say_trouble;
    claim->check();
    guards_hold();
    before_quit = NULL;
    say(0);
}

/* The checks of the slots, the last first: what a slot keeps from call to call
 * meets other arguments here.  They have half the time, for what does not end
 * is asked for in processes of their own as well. */
static void check_all_together(void)
{
    const rlim_t seconds = (SECONDS_COMPUTING + 1) / 2;
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1});
    for (int i = judging.lesson->n_claim - 1; i >= 0; i--) {
        if (!judging.lesson->claims[i].slot) continue;
        judging.again = &judging.lesson->claims[i];
        judging.again->check();
        guards_hold();
    }
}

struct claim claim_at(const struct lesson *lesson, int i)
{
    if (i < lesson->n_claim) return lesson->claims[i];
    if (i == lesson->n_claim + 2)
        return (struct claim){"same_in_another_order", check_all_together, 0};
    if (i > lesson->n_claim)
        return (struct claim){"predictions", lesson->predicted, NULL};
    return (struct claim){"same_numbers_as_reference",
                          check_same_numbers_as_reference, NULL};
}

/* In the child: run the claim of this index, in the subject if there is one.
 * The comparison with the reference is the judge's own: the subject does no
 * more there than run the program. */
static void begin_claim(void *context)
{
    const int *index = context;
    const struct claim claim = claim_at(judging.lesson, *index);
    char number[16];
    snprintf(number, sizeof number, "%d", *index);
    if (!judging.subject || *index == judging.lesson->n_claim) {
        run_claim(&claim);
    } else {
        char *argv[] = {(char *)judging.subject, (char *)"--claim", number,
                        (char *)"--work", judging.work, NULL};
        child_become(judging.subject, argv);
        fprintf(stderr, "judge: cannot run %s\n", judging.subject);
        if (read(CHILD_DESCRIPTOR, &masked, sizeof masked) > 0) say(1);
        _exit(2);
    }
}

void examine(int index, struct finding *finding)
{
    const struct claim claim = claim_at(judging.lesson, index);
    char out[PATH_SIZE], err[PATH_SIZE], path[PATH_SIZE];
    const uint64_t given = any_number();
    uint64_t back = ~given;
    int both_ways[2];

    chmod(judging.work, 0700);
    remove(work_file("judge.message", path));
    remove(work_file("judge.figures", path));
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, both_ways) < 0 ||
        write(both_ways[0], &given, sizeof given) < 0)
        quit("cannot make a socket: %s", strerror(errno));
    child_hand_over(both_ways[1]);
    const struct ending ending =
        child_run(begin_claim, &index, work_file("judge.stdout", out),
                  work_file("judge.stderr", err));
    child_hand_over(0);
    if (recv(both_ways[0], &back, sizeof back, MSG_DONTWAIT) < 0) back = ~given;
    close(both_ways[0]);
    close(both_ways[1]);
    snprintf(finding->slot, sizeof finding->slot, "%s",
             claim.slot ? claim.slot : "");
    finding->verdict = PASS;
    if (ending.limit == NO_LIMIT && ending.status == 0 && back == given)
        return;
    /* limits are those of a single check, and 2 is the judge's own trouble: it
     * may have no files left in a process that the program has changed */
    finding->verdict = NOT_RUN;
    if (index > judging.lesson->n_claim + 1 &&
        (ending.limit != NO_LIMIT || ending.status == 2))
        return;
    finding->verdict = WRONG;
    if (ending.limit == NO_LIMIT && ending.status == 1 &&
        read_message(sizeof finding->text, finding->text)) {
        read_figures(&finding->figures);
        if (starts(finding->text, NOT_FINITE)) finding->verdict = NONFINITE_;
        if (starts(finding->text, UNREADABLE)) *finding->slot = '\0';
        if (index > judging.lesson->n_claim)
            sscanf(finding->text, "slot %15[0-9a-z]", finding->slot);
    } else {
        if (ending.status == 2 && back == given + 1) {
            last_line(err, sizeof finding->text, finding->text);
            quit("%s", starts(finding->text, "judge: ")
                           ? finding->text + strlen("judge: ")
                           : "a check cannot go on: is the disk full?");
        }
        explain_end(ending, finding);
    }
}
