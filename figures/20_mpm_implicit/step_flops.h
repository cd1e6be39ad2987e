/*
 * step_flops.h - what a step of the particles of a bar costs, in flops, counted
 * as work.h counts elements: a look at a particle with s nodes is 17 s flops,
 * and 4.25 s^2 more with its tangent; a banded factorisation and its solves are
 * what matrix_cost() says.
 */
#ifndef FIGURES_STEP_FLOPS_H
#define FIGURES_STEP_FLOPS_H

#include "particles/particle_bodies.h"

/* Of a look at n particles, and what their tangent takes besides. */
double step_flops_look(int order, int n);
double step_flops_tangent(int order, int n);

/* Of an explicit step: P2G, the force, G2P. */
double step_flops_explicit(struct cloud c);

/* Of an implicit step that goes as the report says, from where the particles
 * are now: P2G finds how large and how wide the matrix is. */
double step_flops_implicit(struct cloud c, struct material material,
                           enum wall wall,
                           const struct particle_report *report);

#endif
