/* trial.c - see trial.h. */
#include "trial.h"

#include "../14_time_step/frequency.h"
#include "linear/sparse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOAD_STEPS = 16, MOTION_STEPS = 32 };

static const struct {
    const char *name;
    enum work_scene scene;
    enum { HANGS, RESTS, MOVES } does;
} scenes[TRIAL_SCENES] = {
    [TRIAL_WEIGHT] = {"weight", WEIGHT, HANGS},
    [TRIAL_PULL] = {"pull", SLOW_PULL, RESTS},
    [TRIAL_COLUMN] = {"column", BUCKLE, RESTS},
    [TRIAL_SHAKE] = {"shake", SHAKE, MOVES},
    [TRIAL_SWING] = {"swing", SWING, MOVES},
    [TRIAL_EXPLICIT] = {"explicit", SWING, MOVES},
    [TRIAL_PUSH] = {"push", PUSH, MOVES},
};

const char *trial_name(enum trial_scene scene) { return scenes[scene].name; }

int trial_coarsest(enum trial_scene scene)
{
    return work_coarsest(scenes[scene].scene);
}

struct scene *trial_alloc(enum trial_scene scene, enum element element, int n,
                          double m)
{
    const struct work_setting set = {
        .scene = scenes[scene].scene, .law = LOG, .dynamic = 1,
        .n = element == QUADRATIC_TRIANGLE ? 2 * n : n, .element = element,
        .grade = m};
    struct scene *s = work_alloc(&set);
    if (scenes[scene].does != MOVES) s->body->rho = 0.0;
    body_store(s->body, SPARSE);
    return s;
}

/* Small displacements: one system. */
static void hang(struct scene *s, struct work *end)
{
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    end->systems = 1;
    end->status = body_assemble(s->body, at_rest(s->f), s->u, EXACT, q);
    if (end->status == OK)
        end->status = body_increment(s->body, s->body->K, q, s->u);
    free(q);
}

static void load(struct scene *s, enum work_scene scene, struct work *end)
{
    const struct step_control control = step_method("all");
    for (int k = 1; k <= LOAD_STEPS && end->status == OK; k++) {
        work_hold(s, scene, work_end(scene) * k / LOAD_STEPS);
        step_boundary(s->body, s->g, 1, s->u);
        const struct step_report report =
            step_solve(s->body, &control, at_rest(NULL), s->u);
        end->status = report.status;
        end->systems += report.iterations;
    }
}

/* v half a step before u: leapfrog is then symplectic Euler. */
static void half_a_step_back(const struct model *model, double dt,
                             struct state *now)
{
    double *r = allocate((size_t)now->n, sizeof *r);
    if (model_force(model, now->u, r) != OK) die("the hump inverts");
    model_accelerate(model, r);
    for (int k = 0; k < now->n; k++) now->v[k] = 0.5 * dt * r[k];
    free(r);
}

/* What goes downhill from a state that exists: that of a body is not lost
 * because a guess was bad. */
static struct step_report downhill(struct model *model, double d,
                                   const double a[], const double b[],
                                   const double g[], double u[])
{
    double *v = allocate((size_t)model->n_dof, sizeof *v);
    memcpy(u, a, (size_t)model->n_dof * sizeof *u);
    memcpy(v, b, (size_t)model->n_dof * sizeof *v);
    const struct step_report report = step_backward_euler(
        model->body, &ROBUST, d, g, model->f, u, v, NULL);
    free(v);
    return report;
}

/* Explicit steps are that fraction of the longest stable one. */
static void move(struct scene *s, enum trial_scene trial, double fraction,
                 struct work *end)
{
    const enum work_scene scene = scenes[trial].scene;
    const double last = work_end(scene);
    struct model *model = model_body(s->body);
    struct state now = state_make(s->n_dof);
    int steps = MOTION_STEPS;
    if (scene == PUSH) model->solve = downhill;
    if (scene == SWING) work_pluck(s, now.u);
    if (trial == TRIAL_EXPLICIT) {
        steps = (int)ceil(last / (fraction * 2.0 / frequency_largest(model)));
        half_a_step_back(model, last / steps, &now);
    }
    while (end->status == OK && end->steps < steps) {
        work_hold(s, scene, (end->steps + 1) * last / steps);
        const struct step_report report = integrate_step(
            model,
            trial == TRIAL_EXPLICIT ? SYMPLECTIC_EULER : IMPLICIT_MIDPOINT,
            last / steps, s->g, &now);
        end->status = report.status;
        end->systems += report.iterations;
        end->steps += report.status == OK;
        end->min_J = fmin(end->min_J, body_min_J(s->body, now.u));
        if (!(end->min_J > 0.0)) end->status = INVERTED;
    }
    memcpy(s->u, now.u, (size_t)s->n_dof * sizeof *s->u);
    state_free(&now);
    model_free(model);
}

static struct trial solved(enum trial_scene scene, enum element element, int n,
                           double m, double fraction)
{
    struct trial trial = {.end = {.status = OK, .min_J = 1.0}};
    struct scene *s = trial_alloc(scene, element, n, m);
    const struct sparse *K = s->body->pattern;

    if (scenes[scene].does == HANGS) hang(s, &trial.end);
    if (scenes[scene].does == RESTS) load(s, scenes[scene].scene, &trial.end);
    if (scenes[scene].does == MOVES) move(s, scene, fraction, &trial.end);
    trial.unknowns = s->body->n_equation;
    trial.end.flops = K->flops + K->solve + work_elements(s->body, EXACT);
    if (scene == TRIAL_EXPLICIT)
        trial.end.flops =
            trial.end.steps * work_elements(s->body, NO_TANGENT);
    work_share(s->mesh, s->u, &trial.end);
    scene_free(s);
    return trial;
}

struct trial trial_of(enum trial_scene scene, enum element element, int n,
                      double m)
{
    return solved(scene, element, n, m, 0.75);
}

struct trial trial_explicit(enum element element, int n, double fraction)
{
    return solved(TRIAL_EXPLICIT, element, n, 1.0, fraction);
}

/* ---- elements, compared -------------------------------------------------- */

const struct trial_kind trial_kinds[TRIAL_KINDS] = {
    {"linear", LINEAR_TRIANGLE, 1.0},
    {"linear", LINEAR_TRIANGLE, 1.5},
    {"quadratic", QUADRATIC_TRIANGLE, 1.0},
    {"quadratic", QUADRATIC_TRIANGLE, 2.0}};

/* Meshes of both degrees, and the finest of the limit. */
static const struct {
    int linear, quadratic;
    struct trial_mesh finest;
} extent[TRIAL_PUSH] = {
    [TRIAL_WEIGHT] = {6, 4, {64, 2.0}}, [TRIAL_PULL] = {4, 3, {32, 2.0}},
    [TRIAL_COLUMN] = {6, 3, {64, 2.0}}, [TRIAL_SHAKE] = {5, 3, {32, 1.5}},
    [TRIAL_SWING] = {5, 3, {64, 1.0}},  [TRIAL_EXPLICIT] = {4, 3, {48, 1.0}},
};

int trial_meshes(enum trial_scene scene, enum element element)
{
    return element == LINEAR_TRIANGLE ? extent[scene].linear
                                      : extent[scene].quadratic;
}

struct trial_mesh trial_finest(enum trial_scene scene)
{
    return extent[scene].finest;
}

double trial_apart(const struct work *a, const struct work *b)
{
    return work_distance(a, b) / work_distance(b, NULL);
}

struct work trial_limit(enum trial_scene scene, double *floor)
{
    const struct trial_mesh finest = extent[scene].finest;
    struct work run[3];
    for (int k = 0; k < 3; k++)
        run[k] = trial_of(scene, QUADRATIC_TRIANGLE, finest.n / (4 >> k),
                          finest.m).end;
    const double ratio =
        trial_apart(&run[0], &run[1]) / trial_apart(&run[1], &run[2]);
    if (!(ratio > 1.5)) die("%s has no limit", trial_name(scene));
    struct work limit = run[2], before = run[1];
    work_correct(&limit, 1.0 / (ratio - 1.0), &run[2], &run[1]);
    work_correct(&before, 1.0 / (ratio - 1.0), &run[1], &run[0]);
    *floor = trial_apart(&before, &limit) / ratio;
    return limit;
}

double trial_at(double wanted, int count, const double error[],
                const double cost[])
{
    if (error[0] <= wanted) return cost[0];
    for (int k = 1; k < count; k++)
        if (error[k] <= wanted)
            return cost[k] * pow(wanted / error[k],
                                 log(cost[k - 1] / cost[k]) /
                                     log(error[k - 1] / error[k]));
    return INFINITY;
}

double trial_longest_step(enum element element, int n, double m)
{
    struct scene *s = trial_alloc(TRIAL_EXPLICIT, element, n, m);
    struct model *model = model_body(s->body);
    const double longest = 2.0 / frequency_largest(model);
    model_free(model);
    scene_free(s);
    return longest;
}
