/*
 * rival.h - a step of backward Euler with the solver of machine.h's rival:
 * guess, lift, factors kept in the step, and stop are those of step.h.
 */
#ifndef FIGURES_RIVAL_H
#define FIGURES_RIVAL_H

#include "machine.h"
#include "plane/scene.h"

static inline enum status rival_step(struct scene *s, struct rival *c)
{
    const int n = s->n_dof;
    double *w = allocate((size_t)n, sizeof *w);
    double *next = allocate((size_t)n, sizeof *next);
    double *q = allocate((size_t)n, sizeof *q);
    double *x = allocate((size_t)n, sizeof *x), size = INFINITY;
    const struct incremental Phi = {s->set.dt, w, NULL};
    enum status status = OK;
    for (int r = 0; r < n; r++) {
        w[r] = s->u[r] + s->set.dt * s->v[r];
        next[r] = w[r] + s->set.dt * (s->v[r] - s->v_before[r]);
    }
    scene_hold(s, ++s->steps * s->set.dt);
    step_boundary(s->body, s->g, 1, next);
    for (int k = 0; status == OK; k++) {
        status =
            body_assemble(s->body, Phi, next, k ? NO_TANGENT : EXACT, q);
        if (status != OK || size <= 1e-10) break;
        if (k == 0 && !rival_factor(c, s->body->K)) status = NOT_SPD;
        if (k == 30) status = MAX_ITERATIONS;
        body_gather(s->body, q, x);
        rival_solve(c, x);
        body_scatter(s->body, x, q);
        size = body_max_free(s->body, q);
        for (int r = 0; r < n; r++) next[r] -= q[r];
    }
    for (int r = 0; r < n; r++) {
        s->v_before[r] = s->v[r];
        s->v[r] = (next[r] - s->u[r]) / s->set.dt;
        s->u[r] = next[r];
    }
    free(w);
    free(next);
    free(q);
    free(x);
    return status;
}

#endif
