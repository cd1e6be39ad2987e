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

struct trials *trials_alloc(enum work_scene scene)
{
    const struct work_setting model = {.scene = scene, .law = LOG,
                                       .dynamic = 1,
                                       .element = work_limit_element(scene)};
    struct trials *trials = allocate(1, sizeof *trials);
    trials->scene = scene;
    const struct work limit = work_limit(&model, &trials->floor);
    trials->size = work_distance(&limit, NULL);
    trials->floor /= trials->size;
    settings(trials);
    const int linear = trials->count;
    other_elements(trials);
    trials->all = trials->count;
    trials->count = linear;
    for (int k = 0; k < trials->all; k++) {
        trials->work[k] = work_run(&trials->set[k]);
        trials->error[k] =
            work_distance(&trials->work[k], &limit) / trials->size;
    }
    return trials;
}

void trials_free(struct trials *trials) { free(trials); }

int trials_cheapest(const struct trials *trials, int count, double error)
{
    int best = -1;
    for (int k = 0; k < count; k++)
        if (trials->error[k] <= error &&
            (best < 0 || trials->work[k].flops < trials->work[best].flops))
            best = k;
    return best;
}

/* ---- the balance rule ---------------------------------------------------- */

/* The run of a setting, or NULL. */
static const struct work *find(const struct trials *trials,
                               const struct work_setting *set)
{
    for (int k = 0; k < trials->count; k++) {
        const struct work_setting *at = &trials->set[k];
        const int same = at->law == set->law && at->dynamic == set->dynamic &&
                         at->n == set->n && at->steps == set->steps &&
                         (!set->dynamic || at->method == set->method);
        if (same && (at->law == LINEAR || at->tolerance == set->tolerance ||
                     (at->dynamic && at->method == SYMPLECTIC_EULER)))
            return &trials->work[k];
    }
    return NULL;
}

/* Of the mesh: |a - b| / size; INFINITY if one has failed. */
static double apart(const struct trials *trials, const struct work_setting *a,
                    const struct work_setting *b)
{
    return work_distance(find(trials, a), find(trials, b)) / trials->size;
}

/* all += s (a - b), a part of the error; its size, relative, which is INFINITY
 * if a run has failed or does not exist. */
static double add_part(const struct trials *trials, double s,
                       const struct work_setting *a,
                       const struct work_setting *b, struct work *all)
{
    struct work one = {.status = OK};
    const struct work *x = find(trials, a), *y = find(trials, b);
    if (!x || !y) {
        all->status = NONFINITE;
        return INFINITY;
    }
    one.n_shared = all->n_shared = x->n_shared;
    work_correct(&one, s, x, y);
    work_correct(all, s, x, y);
    return work_distance(&one, NULL) / trials->size;
}

double trials_parts(const struct trials *trials, const struct work_setting *set,
                   double part[N_PART])
{
    const int coarsest = work_coarsest(set->scene);
    struct work all = {.status = OK};
    struct work_setting a = *set, b;
    /* the best in time of each mesh, the same law */
    a.tolerance = tolerances[1];
    if (a.dynamic) {
        a.method = IMPLICIT_MIDPOINT;
        a.steps = last_steps(a.method, 2);
    }
    b = a;
    a.n = 2 * coarsest;
    b.n = coarsest;
    const double coarse = apart(trials, &a, &b);
    b.n = 4 * coarsest;
    const double ratio = fmin(fmax(coarse / apart(trials, &a, &b), 1.5), 4.0);
    double left = 1.0 / (ratio - 1.0); /* of the finest mesh */
    for (int n = set->n; n < 4 * coarsest; n *= 2) left *= ratio;
    part[SPACE] = add_part(trials, left, &a, &b, &all);

    b = a; /* the model: what the coarsest mesh may not show */
    b.law = LOG;
    b.dynamic = 1;
    b.method = IMPLICIT_MIDPOINT;
    b.steps = last_steps(b.method, 2);
    part[MODEL] = add_part(trials, 1.0, &a, &b, &all);

    a = *set; /* time and solver */
    a.n = coarsest;
    b = a;
    b.tolerance = tolerances[1];
    part[SOLVER] = add_part(trials, 1.0, &a, &b, &all);
    a = b;
    b.method = IMPLICIT_MIDPOINT;
    b.steps = set->dynamic ? last_steps(b.method, 0) : set->steps;
    part[TIME] = add_part(trials, 1.0, &a, &b, &all);
    return work_distance(&all, NULL) / trials->size;
}

/* What the error should be; INFINITY if the run has failed. */
static double whole(const struct trials *trials, const struct work_setting *set)
{
    double part[N_PART];
    const double all = trials_parts(trials, set, part);
    return find(trials, set)->status == OK ? all : INFINITY;
}

/* Refine what leaves the least error, of what can be refined, and rather the
 * time where all of them fail; false when that is nothing. */
static int refine(const struct trials *trials, struct work_setting *set)
{
    const struct work_setting from = *set;
    double least = 0.0;
    int any = 0;
    for (int k = SOLVER; k >= SPACE; k--) {
        struct work_setting next = from;
        if (k == SPACE) next.n *= 2;
        if (k == TIME) next.steps *= from.dynamic ? 2 : 8;
        if (k == SOLVER) next.tolerance = tolerances[1];
        if (k == SOLVER && from.tolerance == tolerances[1]) continue;
        if (!find(trials, &next)) continue;
        const double left = whole(trials, &next);
        if (any && !(left < least)) continue;
        any = 1;
        least = left;
        *set = next;
    }
    return any;
}

/* Follow the rule from a coarsest setting; the run it ends in, or NULL. */
static const struct work *balance(const struct trials *trials, double error,
                                  struct work_setting set)
{
    double part[N_PART];
    trials_parts(trials, &set, part);
    if (part[MODEL] > error) return NULL;
    do {
        if (whole(trials, &set) <= error) return find(trials, &set);
    } while (refine(trials, &set));
    return NULL;
}

int trials_balanced(const struct trials *trials, double error)
{
    const struct work *best = NULL;
    for (int law = LINEAR; law <= CUBIC; law++)
        for (int m = -1; m < N_METHOD; m++) { /* -1: static */
            struct work_setting set = {
                .scene = trials->scene, .law = (enum law)law,
                .n = work_coarsest(trials->scene), .dynamic = m >= 0,
                .method = m >= 0 ? (enum method)m : BACKWARD_EULER,
                .tolerance = tolerances[0]};
            set.steps = set.dynamic ? first_steps(set.method) : 1;
            if (law == LINEAR && set.method == SYMPLECTIC_EULER) continue;
            const struct work *end = balance(trials, error, set);
            if (end && (!best || end->flops < best->flops)) best = end;
        }
    return best ? (int)(best - trials->work) : -1;
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
              set->grade > 0.0 ? set->grade : 1.0);
}
