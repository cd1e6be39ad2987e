/* trials.c - see trials.h. */
#include "trials.h"

#include "base/table.h"

#include <math.h>
#include <stdlib.h>

static const double tolerances[] = {1e-2, 1e-5};

/* A setting with both tolerances, where they play a part. */
static void add(struct trials *trials, struct work_setting set)
{
    const int solves = set.law != LINEAR &&
                       !(set.dynamic && set.method == SYMPLECTIC_EULER);
    for (int k = 0; k <= solves; k++) {
        set.tolerance = tolerances[k];
        trials->set[trials->count++] = set;
    }
}

/* Steps of the coarsest and the finest dynamic run on a mesh. */
static int first_steps(enum method method)
{
    return method == SYMPLECTIC_EULER ? 32 : 4;
}
static int last_steps(enum method method, int level)
{
    return method == SYMPLECTIC_EULER ? 256 : 128 >> level;
}

static void settings(struct trials *trials)
{
    for (int law = LINEAR; law <= CUBIC; law++)
        for (int level = 0; level < 3; level++) {
            struct work_setting set = {
                .scene = trials->scene, .law = (enum law)law,
                .n = work_coarsest(trials->scene) << level,
                .method = BACKWARD_EULER};
            for (set.steps = 1; set.steps <= 8; set.steps *= 8)
                if (law != LINEAR || set.steps == 1) add(trials, set);
            set.dynamic = 1;
            for (int m = law == LINEAR; m < N_METHOD; m++) {
                set.method = (enum method)m;
                set.steps = first_steps(set.method);
                for (; set.steps <= last_steps(set.method, level);
                     set.steps *= 2)
                    add(trials, set);
            }
        }
}

/* A setting of another element, static and dynamic. */
static void other_settings(struct trials *trials, struct work_setting set)
{
    const int level = (int)log2(set.n / work_coarsest(set.scene));
    set.tolerance = tolerances[1];
    set.method = BACKWARD_EULER;
    set.steps = 1;
    trials->set[trials->count++] = set;
    set.dynamic = 1;
    set.method = IMPLICIT_MIDPOINT;
    for (set.steps = 4; set.steps <= 128 >> level; set.steps *= 2)
        trials->set[trials->count++] = set;
    set.method = SYMPLECTIC_EULER;
    if (set.law == LINEAR) return;
    for (set.steps = 32; set.steps <= 512; set.steps *= 2)
        trials->set[trials->count++] = set;
}

static void other_elements(struct trials *trials)
{
    static const struct {
        enum element element;
        double grade;
    } other[] = {{LINEAR_TRIANGLE, 1.5}, {QUADRATIC_TRIANGLE, 1.0},
                 {QUADRATIC_TRIANGLE, 2.0}};
    for (int k = 0; k < 3; k++)
        for (int law = LINEAR; law <= LOG; law++)
            for (int level = 0; level < 4; level++) {
                const int quadratic = other[k].element == QUADRATIC_TRIANGLE;
                if (quadratic ? level == 0 && trials->scene == BUCKLE
                              : level == 3)
                    continue; /* an odd number of rows; enough */
                other_settings(trials, (struct work_setting){
                    .scene = trials->scene, .law = (enum law)law,
                    .n = work_coarsest(trials->scene) << level,
                    .element = other[k].element, .grade = other[k].grade});
            }
}

struct trials *trials_alloc(enum work_scene scene, int others)
{
    const struct work_setting model = {.scene = scene, .law = LOG,
                                       .dynamic = 1,
                                       .element = work_limit_element(scene)};
    struct trials *trials = allocate(1, sizeof *trials);
    trials->scene = scene;
    trials->limit = work_limit(&model, &trials->floor);
    trials->size = work_distance(&trials->limit, NULL);
    trials->floor /= trials->size;
    settings(trials);
    const int linear = trials->count;
    if (others) other_elements(trials);
    trials->all = trials->count;
    trials->count = linear;
    for (int k = 0; k < trials->all; k++) {
        trials->work[k] = work_run(&trials->set[k]);
        trials->error[k] =
            work_distance(&trials->work[k], &trials->limit) / trials->size;
    }
    return trials;
}

void trials_free(struct trials *trials) { free(trials); }

/* At the same cost the smaller error is better. */
static int is_better(const struct trials *trials, int a, int b)
{
    const double more = trials->work[a].flops - trials->work[b].flops;
    return more < 0.0 ||
           (more == 0.0 && trials->error[a] < trials->error[b]);
}

int trials_cheapest(const struct trials *trials, int count, double error)
{
    int best = -1;
    for (int k = 0; k < count; k++)
        if (trials->error[k] <= error &&
            (best < 0 || is_better(trials, k, best)))
            best = k;
    return best;
}

void trials_row(const struct trials *trials, int k, double asked)
{
    const struct work_setting *set = &trials->set[k];
    const int ok = trials->work[k].status == OK;
    table_row(work_scene_name(trials->scene), asked, material_law(set->law),
              set->dynamic ? method_name(set->method) : "static", set->n,
              set->steps, set->tolerance,
              ok ? cell_rounded(4, trials->error[k]) : cell_word(MISSING),
              cell_if(ok, trials->work[k].flops),
              status_name(trials->work[k].status), trials->work[k].systems,
              set->element == LINEAR_TRIANGLE ? "linear" : "quadratic",
              set->grade > 0.0 ? set->grade : 1.0,
              cell_rounded(4, trials->floor));
}
