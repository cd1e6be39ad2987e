/*
 * finer.c - what keeps triangles from turning over: shorter steps, or another
 * law?
 *
 * The ends are pushed together (compress, projected on demand, line search) as
 * in compression.c, in steps of 1/30 s and of a quarter of it.  Then from some
 * state of the cubic law, upright or not, by the log or the extended law.
 * Tables: the least J of all states under the cubic and the extended law, and
 * the systems of the cubic run; and how far each law comes from each state.
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <string.h>

enum { FRAMES = 60, SIZES = 3, FINER = 4, STATES = 14 };

static struct scene *start(int n, enum law law, int parts)
{
    struct scene_setting set = scene_notes(COMPRESS, law, n);
    set.dt /= parts;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, PLAIN); /* as in compression.c */
    return s;
}

/* The least J. */
static double squeeze(int n, enum law law, int parts, int *systems)
{
    const struct step_control control = step_method("demand+search");
    struct scene *s = start(n, law, parts);
    double least = 1.0;
    while (s->steps < FRAMES * parts) {
        const struct step_report report = scene_step(s, &control);
        if (report.status != OK) die("%s", status_name(report.status));
        *systems += report.iterations;
        least = fmin(least, body_min_J(s->body, s->u));
    }
    scene_free(s);
    return least;
}

/* The steps that are OK when `from` goes on by another law; *least := the least
 * J of the states that follow. */
static int change_law(const struct scene *from, enum law law, double *least,
                      enum status *status)
{
    const struct step_control control = step_method("demand+search");
    struct scene *s = start(from->set.n, law, 1);
    const size_t size = (size_t)s->n_dof * sizeof *s->u;

    memcpy(s->u, from->u, size);
    memcpy(s->v, from->v, size);
    memcpy(s->v_before, from->v_before, size);
    s->steps = from->steps;
    *least = INFINITY;
    *status = OK;
    while (*status == OK && s->steps < FRAMES) {
        *status = scene_step(s, &control).status;
        if (*status == OK) *least = fmin(*least, body_min_J(s->body, s->u));
    }
    const int steps = s->steps;
    scene_free(s);
    return steps;
}

/* Change the law at some steps of the cubic run. */
static void change(int n)
{
    static const int at[STATES] = {0,  10, 14, 15, 16, 17, 18,
                                   19, 20, 22, 23, 24, 25, 30};
    const struct step_control control = step_method("demand+search");
    struct scene *s = start(n, CUBIC, 1);
    for (int i = 0; i < STATES; i++) {
        while (s->steps < at[i])
            if (scene_step(s, &control).status != OK) die("no step");
        double least, unused;
        enum status by_log, by_extended;
        const int logs = change_law(s, LOG, &unused, &by_log);
        const int steps = change_law(s, EXTENDED, &least, &by_extended);
        table_row(n, at[i], body_min_J(s->body, s->u), logs,
                  status_name(by_log), steps, status_name(by_extended), least);
        claim(steps == FRAMES && least > 0.02, "by the extended law all come "
              "to the end upright (n = %d, %d: %g)", n, at[i], least);
        const int some = at[i] == 24 || at[i] == (n == 8 ? 23 : 20) ||
                         (n == 16 && at[i] == 25);
        claim(at[i] > 25 || (logs == FRAMES) == some, "by the log law only "
              "some do (n = %d, %d: %d)", n, at[i], logs);
    }
    scene_free(s);
}

int main(void)
{
    static const int size[SIZES] = {4, 8, 16};
    double least[SIZES][2], extended[SIZES][2];

    table_begin("finer", "n parts least_J systems extended");
    for (int i = 0; i < SIZES; i++)
        for (int m = 0; m < 2; m++) {
            const int parts = m ? FINER : 1;
            int systems = 0, unused = 0;
            least[i][m] = squeeze(size[i], CUBIC, parts, &systems);
            extended[i][m] = squeeze(size[i], EXTENDED, parts, &unused);
            table_row(size[i], parts, least[i][m], systems, extended[i][m]);
        }
    table_end();
    for (int i = 0; i < SIZES; i++)
        claim(least[i][1] < -0.08 && least[i][1] < least[i][0] - 0.03 &&
                  extended[i][1] < -0.02 && (extended[i][0] > 0.02) == (i > 0),
              "in shorter steps a triangle is inverted further (n = %d: %g, "
              "%g; extended %g, %g)", size[i], least[i][0], least[i][1],
              extended[i][0], extended[i][1]);

    table_begin_note("change",
        "n from J log_steps log_reason steps reason least_J",
        "from the step `from` by the log, and by the extended law");
    for (int i = 1; i < SIZES; i++) change(size[i]);
    table_end();
    return table_finish();
}
