/*
 * finer.c - what keeps triangles from turning over: shorter steps, or the log
 * law?
 *
 * The ends are pushed together (compress, cubic law, projected on demand, line
 * search) as in compression.c, in steps of 1/30 s and of a quarter of it.  Then
 * from the last state of 1/30 s before a triangle turns over by the log law,
 * with the same method and with all cures.  Tables: the least J of all states,
 * and the systems of the whole run; and how far the log law comes.
 */
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <string.h>

enum { FRAMES = 60, SIZES = 3, FINER = 4 };

static struct scene *start(int n, enum law law, int parts)
{
    struct scene_setting set = scene_notes(COMPRESS, law, n);
    set.dt /= parts;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, PLAIN); /* as in compression.c */
    return s;
}

/* The least J; *upright := the steps before a triangle first turns over. */
static double squeeze(int n, int parts, int *systems, int *upright)
{
    const struct step_control control = step_method("demand+search");
    struct scene *s = start(n, CUBIC, parts);
    double least = 1.0;
    while (s->steps < FRAMES * parts) {
        const struct step_report report = scene_step(s, &control);
        if (report.status != OK) die("%s", status_name(report.status));
        *systems += report.iterations;
        least = fmin(least, body_min_J(s->body, s->u));
        if (least > 0.0) *upright = s->steps;
    }
    scene_free(s);
    return least;
}

/* `upright` steps by the cubic law, the others by the log law, with `method`;
 * returns the steps that are OK. */
static int change_law(int n, int upright, const char *method)
{
    const struct step_control before = step_method("demand+search");
    const struct step_control after = step_method(method);
    struct scene *s = start(n, CUBIC, 1), *by_log = start(n, LOG, 1);
    const size_t size = (size_t)s->n_dof * sizeof *s->u;

    while (s->steps < upright)
        if (scene_step(s, &before).status != OK) die("no step");
    memcpy(by_log->u, s->u, size);
    memcpy(by_log->v, s->v, size);
    memcpy(by_log->v_before, s->v_before, size);
    by_log->steps = s->steps;
    enum status status = OK;
    while (status == OK && by_log->steps < FRAMES)
        status = scene_step(by_log, &after).status;
    const int steps = by_log->steps;
    table_row(n, method, upright, steps, status_name(status));
    scene_free(s);
    scene_free(by_log);
    return steps;
}

int main(void)
{
    static const int size[SIZES] = {4, 8, 16};
    double least[SIZES][2];
    int upright[SIZES][2];

    table_begin("finer", "n parts least_J systems");
    for (int i = 0; i < SIZES; i++)
        for (int m = 0; m < 2; m++) {
            const int parts = m ? FINER : 1;
            int systems = 0;
            least[i][m] = squeeze(size[i], parts, &systems, &upright[i][m]);
            table_row(size[i], parts, least[i][m], systems);
        }
    table_end();
    for (int i = 0; i < SIZES; i++)
        claim(least[i][1] < -0.08 && least[i][1] < least[i][0] - 0.03,
              "in shorter steps a triangle is inverted further (n = %d: %g, "
              "%g)", size[i], least[i][0], least[i][1]);

    table_begin_note("change", "n method from steps reason",
                     "by the log law from the step `from`");
    for (int i = 1; i < SIZES; i++) { /* with n = 4 no triangle turns over */
        const int from = upright[i][0];
        claim(change_law(size[i], from, "demand+search") == FRAMES &&
                  change_law(size[i], from, "all") == from,
              "from there the log law comes to the end, but not from an "
              "extrapolated guess (n = %d)", size[i]);
    }
    table_end();
    return table_finish();
}
