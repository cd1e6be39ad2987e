/*
 * trial.h - one scene of work.h, solved with one element on one mesh, and what
 * a linear system of it costs.
 *
 *     weight   linear elasticity, at rest
 *     pull     the slow one, and
 *     column   that has buckled, both at rest after 16 steps of their load
 *     shake    in 32 steps of the midpoint rule, as swing and push
 *     swing
 *     explicit the swing by leapfrog, in steps of 3/4 of the longest stable one
 *     push
 *
 * Meshes of n x n squares, (-1, 1)^2; the column has n x n/8; n counts edges.
 * Log law; lumped mass, of quadratic triangles the scaled one.  The implicit
 * motions have the same steps on all meshes, so that nothing but the error in
 * space makes two of them differ.
 */
#ifndef FIGURES_TRIAL_H
#define FIGURES_TRIAL_H

#include "../work_precision/work.h"

enum trial_scene {
    TRIAL_WEIGHT, TRIAL_PULL, TRIAL_COLUMN, TRIAL_SHAKE, TRIAL_SWING,
    TRIAL_EXPLICIT, TRIAL_PUSH, TRIAL_SCENES
};
const char *trial_name(enum trial_scene scene);

/* The coarsest n of a scene, others are multiples of it. */
int trial_coarsest(enum trial_scene scene);

/* The end as that of work.h, INVERTED also where min_J, here the least of all
 * steps of a motion, is not > 0; flops are of one system, of the whole motion
 * for TRIAL_EXPLICIT. */
struct trial {
    struct work end;
    int unknowns;
};

/* Its body with a sparse K, without a mass where it does not move; freed by
 * scene_free(). */
struct scene *trial_alloc(enum trial_scene scene, enum element element, int n,
                          double m);

/*
 * A system costs what sparse.h counts, the factor in the order of nested
 * dissection and two triangular solves, and its elements as work_elements() has
 * them.
 */
struct trial trial_of(enum trial_scene scene, enum element element, int n,
                      double m);

/* TRIAL_EXPLICIT, even mesh, in steps of another fraction of the longest. */
struct trial trial_explicit(enum element element, int n, double fraction);

/*
 * The elements that are compared, and meshes of each: the coarsest and so many
 * halvings of h, at most TRIAL_MESHES.  Not for TRIAL_PUSH.
 */
enum {
    TRIAL_EVEN, TRIAL_GRADED, TRIAL_QUADRATIC, TRIAL_BOTH, TRIAL_KINDS,
    TRIAL_MESHES = 6
};
struct trial_kind {
    const char *name;
    enum element element;
    double m;
};
extern const struct trial_kind trial_kinds[TRIAL_KINDS];
int trial_meshes(enum trial_scene scene, enum element element);

/* The limit, extrapolated from three meshes of quadratic triangles, as each
 * halving of h leaves the same fraction; *floor: what is not known of it,
 * relative.  The finest of these meshes, and how it is graded. */
struct trial_mesh {
    int n;
    double m;
};
struct trial_mesh trial_finest(enum trial_scene scene);
struct work trial_limit(enum trial_scene scene, double *floor);

/* |a - b| over the shared vertices, of |b|; INFINITY if a run is not OK. */
double trial_apart(const struct work *a, const struct work *b);

/* What an error costs: between the two of count meshes around it, both
 * logarithmic, or on the coarsest where that is good enough; INFINITY where the
 * finest has a larger error. */
double trial_at(double wanted, int count, const double error[],
                const double cost[]);

/* The longest stable step (s) of an explicit method at rest, both ends held:
 * 2 / omega of the largest frequency [eq:critical-step]. */
double trial_longest_step(enum element element, int n, double m);

#endif
