/* kept.c - outputs of programs that are no student's; see judging.h. */
#include "judging.h"

#include "child.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The file `what` of run r of a program, in a folder of the program's name. */
static const char *kept_file(const char *program, int r, const char *what,
                             char path[PATH_SIZE])
{
    const char *slash = strrchr(program, '/');
    const char *name = slash ? slash + 1 : program;
    if (snprintf(path, PATH_SIZE, "%s/%s/%d.%s", judging.kept, name, r, what) >=
        PATH_SIZE)
        quit("a path of more than %d characters", PATH_SIZE);
    return path;
}

int is_kept(const char *program)
{
    char path[PATH_SIZE];
    return judging.kept &&
           access(kept_file(program, 0, "ending", path), R_OK) == 0;
}

void keep_outputs(const char *program)
{
    char out[PATH_SIZE], err[PATH_SIZE], path[PATH_SIZE];
    kept_file(program, 0, "ending", path);
    *strrchr(path, '/') = '\0'; /* its folder */
    if (mkdir(path, 0777) < 0)
        quit("cannot make %s: %s", path, strerror(errno));
    child_restart_clock(); /* each program has the time of a judgement */
    for (int r = 0; r < judging.lesson->n_run; r++) {
        const double before = child_seconds();
        const struct ending ending =
            output_run(program, judging.lesson->runs[r],
                       kept_file(program, r, "out", out),
                       kept_file(program, r, "err", err));
        FILE *file = fopen(kept_file(program, r, "ending", path), "w");
        if (!file ||
            fprintf(file, "%d %d %.17g\n", ending.status, (int)ending.limit,
                    child_seconds() - before) < 0 ||
            fclose(file) != 0)
            quit("cannot write %s", path);
    }
}

struct output *output_kept(const char *program, int r)
{
    char out[PATH_SIZE], err[PATH_SIZE], path[PATH_SIZE];
    struct ending ending = {0, NO_LIMIT};
    double seconds = 0.0;
    int limit = 0;
    FILE *file = NULL;
    if (judging.kept) file = fopen(kept_file(program, r, "ending", path), "r");
    if (!file)
        return output_of(program, judging.lesson->runs[r], judging.work);
    if (fscanf(file, "%d %d %lf", &ending.status, &limit, &seconds) != 3)
        quit("cannot read %s", path);
    fclose(file);
    ending.limit = (enum limit)limit;
    child_spend(seconds);
    return output_read_back(ending, kept_file(program, r, "out", out),
                            kept_file(program, r, "err", err));
}
