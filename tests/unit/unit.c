/* unit.c - see unit.h. */
#include "unit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* Is the law to be run?  Arguments name those to run or, as -law, to skip. */
static int wanted(const char *law, int argc, char *argv[])
{
    for (int k = 1; k < argc; k++) {
        const int out = argv[k][0] == '-';
        if (strcmp(argv[k] + out, law) == 0) return !out;
    }
    return argc < 2 || argv[1][0] == '-';
}

/* A law that does not end is ended after minutes of its own computing, which no
 * load of the machine takes away, or half an hour of waiting. */
enum { COMPUTES = 300, WAITS = 1800 };
static void limit_laws(void)
{
    struct rlimit limit;
    if (getenv("CK_FORK") || getrlimit(RLIMIT_CPU, &limit) != 0) return;
    if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur > COMPUTES)
        limit.rlim_cur = COMPUTES;
    setrlimit(RLIMIT_CPU, &limit);
}

int unit_run(const char *module, const struct unit_law laws[], int n, int argc,
             char *argv[])
{
    int failed = 0, left_out = 0;
    limit_laws();
    for (int i = 0; i < n; i++) {
        if (!wanted(laws[i].name, argc, argv)) {
            left_out++;
            continue;
        }
        const TTest test = {laws[i].name, (TFun)laws[i].check, __FILE__,
                            __LINE__};
        Suite *suite = suite_create(module);
        TCase *tcase = tcase_create(laws[i].name);
        tcase_set_timeout(tcase, WAITS);
        tcase_add_test(tcase, &test);
        suite_add_tcase(suite, tcase);
        SRunner *runner = srunner_create(suite);
        srunner_run_all(runner, CK_SILENT);
        TestResult **result = srunner_results(runner);
        if (tr_rtype(result[0]) == CK_PASS) {
            printf("ok %s: %s\n", module, laws[i].name);
        } else {
            printf("FAIL %s: %s: line %d: %s\n", module, laws[i].name,
                   tr_lno(result[0]), tr_msg(result[0]));
            failed++;
        }
        free(result);
        srunner_free(runner);
    }
    const int named = argc > 1 && argv[1][0] != '-' ? n - left_out : left_out;
    if (named != argc - 1) {
        fprintf(stderr, "%s: a law that is named is not there\n", module);
        return 2;
    }
    return failed > 0;
}

static void read_back(FILE *file, size_t size, char text[])
{
    rewind(file);
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
}

struct outcome outcome_of(void (*call)(void))
{
    struct outcome outcome = {0};
    FILE *out = tmpfile(), *err = tmpfile();
    int status = 0;

    ck_assert_ptr_nonnull(out);
    ck_assert_ptr_nonnull(err);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        dup2(fileno(out), STDOUT_FILENO);
        dup2(fileno(err), STDERR_FILENO);
        call();
        exit(0);
    }
    waitpid(child, &status, 0);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    read_back(out, sizeof outcome.out, outcome.out);
    read_back(err, sizeof outcome.err, outcome.err);
    return outcome;
}
