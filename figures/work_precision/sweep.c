/* sweep.c - see sweep.h. */
#include "sweep.h"

#include "base/table.h"

#include <math.h>
#include <stdlib.h>

static const double tolerances[] = {1e-2, 1e-5};

/* A setting with both tolerances, where they play a part. */
static void add(struct sweep *sweep, struct work_setting set)
{
    const int solves = set.law != LINEAR &&
                       !(set.dynamic && set.method == SYMPLECTIC_EULER);
    for (int k = 0; k <= solves; k++) {
        set.tolerance = tolerances[k];
        sweep->set[sweep->count++] = set;
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

static void settings(struct sweep *sweep)
{
    for (int law = LINEAR; law <= CUBIC; law++)
        for (int level = 0; level < 3; level++) {
            struct work_setting set = {
                .scene = sweep->scene, .law = (enum law)law,
                .n = work_coarsest(sweep->scene) << level,
                .method = BACKWARD_EULER};
            for (set.steps = 1; set.steps <= 8; set.steps *= 8)
                if (law != LINEAR || set.steps == 1) add(sweep, set);
            set.dynamic = 1;
            for (int m = law == LINEAR; m < N_METHOD; m++) {
                set.method = (enum method)m;
                set.steps = first_steps(set.method);
                for (; set.steps <= last_steps(set.method, level);
                     set.steps *= 2)
                    add(sweep, set);
            }
        }
}

struct sweep *sweep_alloc(enum work_scene scene)
{
    const struct work_setting model = {.scene = scene, .law = LOG,
                                       .dynamic = 1};
    struct sweep *sweep = allocate(1, sizeof *sweep);
    sweep->scene = scene;
    const struct work limit = work_limit(&model, &sweep->floor);
    sweep->size = work_distance(&limit, NULL);
    sweep->floor /= sweep->size;
    settings(sweep);
    for (int k = 0; k < sweep->count; k++) {
        sweep->work[k] = work_run(&sweep->set[k]);
        sweep->error[k] =
            work_distance(&sweep->work[k], &limit) / sweep->size;
    }
    return sweep;
}

void sweep_free(struct sweep *sweep) { free(sweep); }

int sweep_cheapest(const struct sweep *sweep, double error)
{
    int best = -1;
    for (int k = 0; k < sweep->count; k++)
        if (sweep->error[k] <= error &&
            (best < 0 || sweep->work[k].flops < sweep->work[best].flops))
            best = k;
    return best;
}

/* ---- the balance rule ---------------------------------------------------- */

/* The run of a setting, or NULL. */
static const struct work *find(const struct sweep *sweep,
                               const struct work_setting *set)
{
    for (int k = 0; k < sweep->count; k++) {
        const struct work_setting *at = &sweep->set[k];
        const int same = at->law == set->law && at->dynamic == set->dynamic &&
                         at->n == set->n && at->steps == set->steps &&
                         (!set->dynamic || at->method == set->method);
        if (same && (at->law == LINEAR || at->tolerance == set->tolerance ||
                     (at->dynamic && at->method == SYMPLECTIC_EULER)))
            return &sweep->work[k];
    }
    return NULL;
}

/* Of the mesh: |a - b| / size; INFINITY if one has failed. */
static double apart(const struct sweep *sweep, const struct work_setting *a,
                    const struct work_setting *b)
{
    return work_distance(find(sweep, a), find(sweep, b)) / sweep->size;
}

/* all += s (a - b), a part of the error; its size, relative, which is INFINITY
 * if a run has failed or does not exist. */
static double add_part(const struct sweep *sweep, double s,
                       const struct work_setting *a,
                       const struct work_setting *b, struct work *all)
{
    struct work one = {.status = OK};
    const struct work *x = find(sweep, a), *y = find(sweep, b);
    if (!x || !y) {
        all->status = NONFINITE;
        return INFINITY;
    }
    one.n_shared = all->n_shared = x->n_shared;
    work_correct(&one, s, x, y);
    work_correct(all, s, x, y);
    return work_distance(&one, NULL) / sweep->size;
}

double sweep_parts(const struct sweep *sweep, const struct work_setting *set,
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
    const double coarse = apart(sweep, &a, &b);
    b.n = 4 * coarsest;
    const double ratio = fmin(fmax(coarse / apart(sweep, &a, &b), 1.5), 4.0);
    double left = 1.0 / (ratio - 1.0); /* of the finest mesh */
    for (int n = set->n; n < 4 * coarsest; n *= 2) left *= ratio;
    part[SPACE] = add_part(sweep, left, &a, &b, &all);

    b = a; /* the model: what the coarsest mesh may not show */
    b.law = LOG;
    b.dynamic = 1;
    b.method = IMPLICIT_MIDPOINT;
    b.steps = last_steps(b.method, 2);
    part[MODEL] = add_part(sweep, 1.0, &a, &b, &all);

    a = *set; /* time and solver */
    a.n = coarsest;
    b = a;
    b.tolerance = tolerances[1];
    part[SOLVER] = add_part(sweep, 1.0, &a, &b, &all);
    a = b;
    b.method = IMPLICIT_MIDPOINT;
    b.steps = set->dynamic ? last_steps(b.method, 0) : set->steps;
    part[TIME] = add_part(sweep, 1.0, &a, &b, &all);
    return work_distance(&all, NULL) / sweep->size;
}

/* What the error should be; INFINITY if the run has failed. */
static double whole(const struct sweep *sweep, const struct work_setting *set)
{
    double part[N_PART];
    const double all = sweep_parts(sweep, set, part);
    return find(sweep, set)->status == OK ? all : INFINITY;
}

/* Refine what leaves the least error, of what can be refined, and rather the
 * time where all of them fail; false when that is nothing. */
static int refine(const struct sweep *sweep, struct work_setting *set)
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
        if (!find(sweep, &next)) continue;
        const double left = whole(sweep, &next);
        if (any && !(left < least)) continue;
        any = 1;
        least = left;
        *set = next;
    }
    return any;
}

/* Follow the rule from a coarsest setting; the run it ends in, or NULL. */
static const struct work *balance(const struct sweep *sweep, double error,
                                  struct work_setting set)
{
    double part[N_PART];
    sweep_parts(sweep, &set, part);
    if (part[MODEL] > error) return NULL;
    do {
        if (whole(sweep, &set) <= error) return find(sweep, &set);
    } while (refine(sweep, &set));
    return NULL;
}

int sweep_balanced(const struct sweep *sweep, double error)
{
    const struct work *best = NULL;
    for (int law = LINEAR; law <= CUBIC; law++)
        for (int m = -1; m < N_METHOD; m++) { /* -1: static */
            struct work_setting set = {
                .scene = sweep->scene, .law = (enum law)law,
                .n = work_coarsest(sweep->scene), .dynamic = m >= 0,
                .method = m >= 0 ? (enum method)m : BACKWARD_EULER,
                .tolerance = tolerances[0]};
            set.steps = set.dynamic ? first_steps(set.method) : 1;
            if (law == LINEAR && set.method == SYMPLECTIC_EULER) continue;
            const struct work *end = balance(sweep, error, set);
            if (end && (!best || end->flops < best->flops)) best = end;
        }
    return best ? (int)(best - sweep->work) : -1;
}

void sweep_row(const struct sweep *sweep, int k, double asked)
{
    const struct work_setting *set = &sweep->set[k];
    const int ok = sweep->work[k].status == OK;
    table_row(work_scene_name(sweep->scene), asked, material_law(set->law),
              set->dynamic ? method_name(set->method) : "static", set->n,
              set->steps, set->tolerance,
              ok ? cell_rounded(4, sweep->error[k]) : cell_word(MISSING),
              cell_if(ok, sweep->work[k].flops),
              status_name(sweep->work[k].status), sweep->work[k].systems);
}
