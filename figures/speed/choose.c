/*
 * choose.c - does the price that `make choose` expects meet the clock?
 *
 * The least model for 10 % of each scene of lessons/scenes, or the last one
 * where none is enough: milliseconds per frame as price.h expects them, from
 * the linear systems that the scene has and a calibration on another body,
 * against those measured, the least of what a fifth of a second has time for;
 * both are seconds of the processor.
 * Run from the top of the tree.  Tables: choose, within (a factor of 1.5).
 */
#include "choice/climb.h"
#include "../../lessons/choose/price.h"
#include "choice/scene_file.h"
#include "base/clock.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>

static const char *const name[] = {
    "arch", "buckled", "flap", "guyed", "harder", "leaning", "plunge",
    "pressed", "probe", "section", "stout", "straight", "stretch", "strip",
    "thread", "tremor"};
enum { ALL = sizeof name / sizeof *name, FINEST = 2 };
static const double tolerance = 0.1;

/* The least seconds of the solve; what allocates is left out, as in price.h. */
static double measured(const struct ladder_scene *scene,
                       struct ladder_model model)
{
    double best = INFINITY;
    const double start = clock_processor();
    do {
        struct ladder_state *s = ladder_alloc(scene, model);
        const double before = clock_processor();
        rung_solve(s);
        best = fmin(best, clock_processor() - before);
        ladder_free(s);
    } while (clock_processor() - start < 0.2);
    return best;
}

/* A row; the larger of the two times over the smaller. */
static double print_scene(const char *word)
{
    struct scene_file file;
    char path[80];
    struct climb_rung tried[CLIMB_MOST];
    int n;
    snprintf(path, sizeof path, "lessons/scenes/%s.scene", word);
    scene_file_read("choose", path, FINEST, &file);
    struct ladder_state *s = climb_ladder(&file.scene, tolerance, tried, &n);
    const double frames = price_frames(s);
    const double expects =
        1e3 / frames *
        price_seconds(s, price_calibrate(LINEAR_TRIANGLE, 1.0, s->model));
    const double takes = 1e3 * measured(&file.scene, s->model) / frames;
    table_row(word, ladder_rung(s->model.rung),
              s->model.moving ? "motion" : "rest", s->model.level,
              s->systems / frames, expects, takes, expects / takes);
    ladder_free(s);
    return fmax(expects / takes, takes / expects);
}

int main(void)
{
    double worst = 1.0;
    int within = 0;
    gsl_set_error_handler_off();
    study_machine();
    table_begin("choose", "scene model state mesh systems predicted_ms "
                          "measured_ms over");
    for (int k = 0; k < ALL; k++) {
        const double off = print_scene(name[k]);
        within += off <= 1.5;
        worst = fmax(worst, off);
    }
    table_end();
    table_begin("within", "line scenes within worst");
    table_row("all", (int)ALL, within, worst);
    table_end();
    return table_finish();
}
