/* rule.c - see rule.h. */
#include "rule.h"

#include <assert.h>
#include <math.h>

static const double tolerances[] = {1e-2, 1e-5};
enum { FINE_STEPS = 32, FINEST_STEPS = 128 }; /* of the midpoint's probes */

struct rule {
    const struct trials *trials;
    int meshes;              /* 2 or 3 */
    int probed[TRIALS_MOST]; /* the rule has looked at this run */
};

/* The index of a setting's run, or -1. */
static int find(const struct trials *trials, const struct work_setting *set)
{
    for (int k = 0; k < trials->count; k++) {
        const struct work_setting *at = &trials->set[k];
        const int same = at->law == set->law && at->dynamic == set->dynamic &&
                         at->n == set->n && at->steps == set->steps &&
                         (!set->dynamic || at->method == set->method);
        if (same && (at->law == LINEAR || at->tolerance == set->tolerance ||
                     (at->dynamic && at->method == SYMPLECTIC_EULER)))
            return k;
    }
    return -1;
}

/* The same run, which is looked at from now on; NULL. */
static const struct work *probe(struct rule *rule,
                                const struct work_setting *set)
{
    const int k = find(rule->trials, set);
    if (k < 0) return NULL;
    rule->probed[k] = 1;
    return &rule->trials->work[k];
}

/* all += s (a - b), a part of the error; INFINITE where a run has failed or
 * does not exist. */
static double add(struct rule *rule, double s, const struct work_setting *a,
                  const struct work_setting *b, struct work *all)
{
    struct work one = {.status = OK};
    const struct work *x = probe(rule, a), *y = probe(rule, b);
    if (!x || !y) {
        all->status = NONFINITE;
        return INFINITY;
    }
    one.n_shared = all->n_shared = x->n_shared;
    work_correct(&one, s, x, y);
    work_correct(all, s, x, y);
    return work_distance(&one, NULL) / rule->trials->size;
}

/* The best in time of a mesh, the same law, static or dynamic. */
static struct work_setting best_in_time(struct work_setting set, int n)
{
    set.tolerance = tolerances[1];
    set.n = n;
    if (!set.dynamic) return set;
    set.method = IMPLICIT_MIDPOINT;
    set.steps = FINE_STEPS;
    return set;
}

/* By which the error in space falls from a mesh to the next. */
static double falls(struct rule *rule, const struct work_setting *set, int n)
{
    const struct material notes = material_notes(LINEAR);
    if (rule->meshes == 2) return pow(2.0, 2.0 * material_corner(&notes));
    struct work none = {.status = OK};
    struct work_setting at[3];
    for (int k = 0; k < 3; k++) at[k] = best_in_time(*set, n << k);
    return fmin(fmax(add(rule, 1.0, &at[1], &at[0], &none) /
                         add(rule, 1.0, &at[1], &at[2], &none), 1.5), 4.0);
}

/* What the error should be, and its parts. */
static double expected(struct rule *rule, const struct work_setting *set,
                       double part[N_PART])
{
    const int coarsest = work_coarsest(set->scene);
    const int last = coarsest << (rule->meshes - 1);
    struct work all = {.status = OK};
    struct work_setting a = best_in_time(*set, last / 2);
    struct work_setting b = best_in_time(*set, last);
    const double ratio = falls(rule, set, coarsest);
    part[SPACE] = add(rule, pow(ratio, log2((double)last / set->n)) /
                                (ratio - 1.0), &a, &b, &all);
    a = best_in_time(*set, 2 * coarsest); /* the coarsest may not buckle */
    b = a;
    b.law = LOG;
    b.dynamic = 1;
    b = best_in_time(b, 2 * coarsest);
    part[MODEL] = add(rule, 1.0, &a, &b, &all);
    a = *set; /* solver and time */
    a.n = coarsest;
    b = a;
    b.tolerance = tolerances[1];
    part[SOLVER] = add(rule, 1.0, &a, &b, &all);
    a = b;
    b.method = IMPLICIT_MIDPOINT;
    if (set->dynamic) b.steps = FINEST_STEPS;
    part[TIME] = add(rule, 1.0, &a, &b, &all);
    return work_distance(&all, NULL) / rule->trials->size;
}

double rule_parts(const struct trials *trials, int meshes,
                  const struct work_setting *set, double part[N_PART])
{
    struct rule rule = {.trials = trials, .meshes = meshes};
    return expected(&rule, set, part);
}

/* Refine what leaves the least error, and rather the time where all fail; false
 * when nothing can be refined. */
static int refine(struct rule *rule, struct work_setting *set)
{
    const struct work_setting from = *set;
    double least = 0.0, part[N_PART];
    int any = 0;
    for (int k = SOLVER; k >= SPACE; k--) {
        struct work_setting next = from;
        if (k == SPACE) next.n *= 2;
        if (k == TIME) next.steps *= from.dynamic ? 2 : 8;
        if (k == SOLVER) next.tolerance = tolerances[1];
        if (k == SOLVER && from.tolerance == tolerances[1]) continue;
        if (find(rule->trials, &next) < 0) continue;
        const double left = expected(rule, &next, part);
        if (any && !(left < least)) continue;
        any = 1;
        least = left;
        *set = next;
    }
    return any;
}

/* From a coarsest setting to the first that should be good enough; false: there
 * is none. */
static int follow(struct rule *rule, double error, struct work_setting *set)
{
    double part[N_PART];
    expected(rule, set, part);
    if (part[MODEL] > error) return 0;
    do {
        if (expected(rule, set, part) <= error) return 1;
    } while (refine(rule, set));
    return 0;
}

/* Flops of a run by the systems that it needs on the coarsest mesh: of a band,
 * and of what is once per element. */
static double predicted(struct rule *rule, const struct work_setting *set)
{
    struct work_setting coarse = *set;
    const int rows = work_coarsest(set->scene) == 8 ? set->n / 8 : set->n;
    const int n = 2 * set->n * (rows + 1);
    const int p = 2 * rows + 3 < 2 * set->n ? 2 * rows + 3 : 2 * set->n - 1;
    const double triangles = 2.0 * set->n * rows;
    const struct matrix_cost cost = matrix_cost(BANDED, n, p);
    coarse.n = work_coarsest(set->scene);
    const struct work *w = probe(rule, &coarse);
    return w->factorisations * (cost.flops + 250.0 * triangles) +
           w->systems * cost.solve + 100.0 * triangles *
               (w->systems + w->steps - w->factorisations);
}

/* What the rule has looked at, but for the run that is taken. */
static void charge(const struct rule *rule, struct rule_choice *choice)
{
    const struct trials *trials = rule->trials;
    for (int k = 0; k < trials->count; k++) {
        if (!rule->probed[k] || k == choice->taken) continue;
        choice->probes++;
        choice->flops += trials->work[k].flops;
    }
}

struct rule_choice rule_take(const struct trials *trials, int meshes,
                             double error)
{
    enum { MODELS = 3 * (N_METHOD + 1) };
    struct rule rule = {.trials = trials, .meshes = meshes};
    struct rule_choice choice = {.taken = -1};
    struct work_setting end[MODELS];
    double flops[MODELS];
    int ends = 0;
    assert(meshes == 2 || meshes == 3);
    for (int law = LINEAR; law <= (meshes == 2 ? LOG : CUBIC); law++)
        for (int m = -1; m < N_METHOD; m++) { /* -1: static */
            struct work_setting set = {
                .scene = trials->scene, .law = (enum law)law,
                .n = work_coarsest(trials->scene), .dynamic = m >= 0,
                .method = m >= 0 ? (enum method)m : BACKWARD_EULER,
                .tolerance = tolerances[0]};
            set.steps = !set.dynamic ? 1
                        : set.method == SYMPLECTIC_EULER ? 32 : 4;
            if (law == LINEAR && set.method == SYMPLECTIC_EULER) continue;
            if (!follow(&rule, error, &set)) continue;
            flops[ends] = predicted(&rule, &set);
            end[ends++] = set;
        }
    while (choice.taken < 0) { /* the cheapest; where it fails, more steps */
        int best = -1;
        for (int k = 0; k < ends; k++)
            if (flops[k] < INFINITY && (best < 0 || flops[k] < flops[best]))
                best = k;
        if (best < 0) break;
        const int k = find(trials, &end[best]);
        if (trials->work[k].status == OK) {
            choice.taken = k;
        } else {
            rule.probed[k] = 1;
            end[best].steps *= 2;
            flops[best] = find(trials, &end[best]) < 0
                              ? INFINITY : predicted(&rule, &end[best]);
        }
    }
    charge(&rule, &choice);
    return choice;
}
