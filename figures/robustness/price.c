/*
 * price.c - what does projection on demand cost where nothing has to be
 * projected?
 *
 * The first step of `stretch`, n = 64: factorisations, and milliseconds.
 */
#include "base/clock.h"
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

/* Factorisations of the step by this method; a row of the table. */
static int step(const char *method)
{
    const struct step_control control = step_method(method);
    const struct scene_setting set = scene_notes(STRETCH, CUBIC, 64);
    struct scene *s = scene_alloc(&set);
    const double start = clock_seconds();
    const struct step_report report = scene_step(s, &control);
    const double seconds = clock_seconds() - start;
    table_row(method, status_name(report.status), report.iterations,
              report.factorisations, report.projections, 1e3 * seconds);
    scene_free(s);
    return report.status == OK ? report.factorisations : 0;
}

int main(void)
{
    study_machine();
    table_begin("price", "method status systems factorisations projections ms");
    const int plain = step("notes"), demand = step("demand+search");
    table_end();
    claim(plain > 0 && demand > 0 && demand <= 1.3 * plain,
          "projection on demand costs at most 1.3 times the plain step: %d "
          "factorisations, and %d", demand, plain);
    return table_finish();
}
