/* first_step.c - the first step from rest, and the jumps that it can take. */
#include "first_step.h"

#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct scene *first_scene(enum reading reading, enum element element,
                          enum law law, int n)
{
    struct scene_setting set = scene_notes(reading, law, n);
    set.element = element;
    return scene_alloc(&set);
}

void first_scatter(struct scene *s, int seed, double reach)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, (unsigned long)seed);
    for (int r = 0; r < s->n_dof; r++)
        s->u[r] = s->held[r / 2] ? 0.0
                                 : reach * (2.0 * gsl_rng_uniform(rng) - 1.0);
    gsl_rng_free(rng);
}

struct step_report first_step(struct scene *s, const char *method, double dt)
{
    const struct step_control control = step_method(method);
    scene_rest(s);
    s->set.dt = dt;
    return scene_step(s, &control);
}

int first_converges(struct scene *s, double dt)
{
    return first_step(s, "notes", dt).status == OK;
}

int first_definite(struct scene *s, double dt)
{
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    double *rest = allocate((size_t)s->n_dof, sizeof *rest);
    memset(s->u, 0, (size_t)s->n_dof * sizeof *s->u);
    scene_hold(s, dt);
    step_boundary(s->body, s->g, 0, s->u);
    const struct incremental Phi = {dt, rest, NULL};
    const int definite = body_assemble(s->body, Phi, s->u, EXACT, q) == OK &&
                         matrix_factor(s->body->K) == OK;
    free(q);
    free(rest);
    return definite;
}

double first_limit(struct scene *s, int (*holds)(struct scene *, double))
{
    for (int k = 250; k < 1000; k++)
        if (!holds(s, asin(0.002 * k * 2.0 / s->set.n))) return 0.002 * k;
    return INFINITY;
}

void first_limits(enum element element, int n, double first[4])
{
    for (int k = 0; k < 2; k++) {
        struct scene *s = first_scene(RIGID, element, k ? LOG : CUBIC, n);
        first[k] = first_limit(s, first_converges);
        first[2 + k] = first_limit(s, first_definite);
        scene_free(s);
    }
}
