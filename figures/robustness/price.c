/*
 * price.c - what does projection on demand cost where nothing has to be
 * projected?
 *
 * The first step of `stretch`, n = 64: factorisations, and milliseconds, the
 * medians of nine runs in turn.
 */
#include "base/clock.h"
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

static struct step_report step(const char *method, struct times *time)
{
    const struct step_control control = step_method(method);
    const struct scene_setting set = scene_notes(STRETCH, CUBIC, 64);
    struct scene *s = scene_alloc(&set);
    const double start = clock_seconds();
    const struct step_report report = scene_step(s, &control);
    times_record(time, clock_seconds() - start, report.status == OK);
    scene_free(s);
    return report;
}

int main(void)
{
    static const char *const method[] = {"notes", "demand+search"};
    struct step_report r[2];
    struct times time[2] = {0};

    study_machine();
    for (int run = 0; run < 9; run++)
        for (int m = 0; m < 2; m++) r[m] = step(method[m], &time[m]);
    table_begin("price", "method status systems factorisations projections ms");
    for (int m = 0; m < 2; m++)
        table_row(method[m], status_name(r[m].status), r[m].iterations,
                  r[m].factorisations, r[m].projections,
                  1e3 * times_median(&time[m]));
    table_end();
    claim(r[0].status == OK && r[1].status == OK &&
              r[1].factorisations <= 1.3 * r[0].factorisations,
          "projection on demand costs at most 1.3 times the plain step: %d "
          "factorisations, and %d", r[1].factorisations, r[0].factorisations);
    return table_finish();
}
