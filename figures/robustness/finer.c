/*
 * finer.c - does a smaller time step keep triangles from turning over?
 *
 * The ends are pushed together (compress, cubic law, projected on demand, line
 * search) as in compression.c, in steps of 1/30 s and of a quarter of it.
 * Table: the least J of all states, and the systems of the whole run.
 */
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum { FRAMES = 60, SIZES = 3, FINER = 4 };

static double squeeze(int n, int parts, int *systems)
{
    struct scene_setting set = scene_notes(COMPRESS, CUBIC, n);
    set.dt /= parts;
    const struct step_control control = step_method("demand+search");
    struct scene *s = scene_alloc(&set);
    double least = 1.0;
    body_store(s->body, PLAIN); /* as in compression.c */
    while (s->steps < FRAMES * parts) {
        const struct step_report report = scene_step(s, &control);
        if (report.status != OK) die("%s", status_name(report.status));
        *systems += report.iterations;
        least = fmin(least, body_min_J(s->body, s->u));
    }
    scene_free(s);
    return least;
}

int main(void)
{
    static const int size[SIZES] = {4, 8, 16};
    double least[SIZES][2];

    table_begin("finer", "n parts least_J systems");
    for (int i = 0; i < SIZES; i++)
        for (int m = 0; m < 2; m++) {
            const int parts = m ? FINER : 1;
            int systems = 0;
            least[i][m] = squeeze(size[i], parts, &systems);
            table_row(size[i], parts, least[i][m], systems);
        }
    table_end();

    for (int i = 0; i < SIZES; i++)
        claim(least[i][1] < -0.08 && least[i][1] < least[i][0] - 0.03,
              "in shorter steps a triangle is inverted further (n = %d: %g, "
              "%g)", size[i], least[i][0], least[i][1]);
    return table_finish();
}
