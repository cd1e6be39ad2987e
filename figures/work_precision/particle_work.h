/*
 * particle_work.h - two bodies by particles, and what a setting of them costs
 * and has wrong; beside work.h, whose finite elements they compete with.
 *
 *     hung   the bar of particle_bodies.h under 500 N/m, cubic law, at rest;
 *            the load is put on in equal steps, each with a new grid
 *     let go the square of `weight` in work.h, log law, its left end at x1 = 0
 *
 * The wall at x1 = 0 is a mirror.  A particle says where a place X near its own
 * is, x_p + F_p (X - X_p); of the bar's end, where no stress is, F = 1 as well.
 */
#ifndef FIGURES_PARTICLE_WORK_H
#define FIGURES_PARTICLE_WORK_H

#include "work.h"
#include "particles/particle_bodies.h"

enum particle_body_name { HUNG, LET_GO };
struct particle_setting {
    enum particle_body_name body;
    int order;    /* of the kernel */
    int per_cell; /* particles along each axis of a cell */
    int cells;    /* along the body; of the square a multiple of 4 */
    int steps;
    int implicit; /* backward Euler, else symplectic; hung: always static */
    enum transfer transfer;
};

/*
 * Flops of one look at an element or a particle with s nodes of d components,
 * 17 s d, and 4.25 (s d)^2 more with the tangent: for a triangle 100 and 250,
 * as work_flops() has them.
 */
double work_look(int s, int d, int tangent);

/*
 * From rest to the end.  Work is counted as work_flops() does, with two looks
 * more per step, at the transfers.  Answers are u of the bar's end, in u[0] of
 * two entries, and u of the square at the vertices of work_run(), as the mean
 * of what the nearest particles say.  INVERTED also where F of a particle is,
 * at the end.
 */
struct work particle_work(const struct particle_setting *set);

/* The bar by as many finite elements, all of the load at once. */
struct work element_bar_work(int cells);

#endif
