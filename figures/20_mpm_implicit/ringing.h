/*
 * ringing.h - a free bar of 8 cells, or more, or of 8 elements, that rings in
 * its first mode for one period, 2 / c, at 0.02 c.  Two particles per cell.
 */
#ifndef FIGURES_RINGING_H
#define FIGURES_RINGING_H

#include "particles/particle_bodies.h"

enum { RINGING_CELLS = 8, RINGING_SIZES = 10 };

/* Into how many steps the period is divided. */
extern const int RINGING_STEPS[RINGING_SIZES];

struct ringing {
    /* The energy, kinetic of the particles (without APIC's B) and elastic, over
     * that at the start; NAN where a step fails, or where it has grown. */
    double left;
    const char *how; /* OK, the status of the step, or "unstable" */
    double flops;    /* of all steps */
    int systems;     /* linear systems of a step, at most */
};

/* Which bar: order of the kernel (1 to 3), how many cells, and how far it is
 * shifted on its grid, in cells. */
struct ringing_bar {
    int order, cells;
    double shift;
};

/* Explicit steps if the tolerance is 0, else implicit ones by particle_newton()
 * with this tolerance, in h: 1e-10 is that of particles_step(). */
struct ringing ringing_particles(struct ringing_bar of, enum transfer transfer,
                                 double tolerance, int steps);

/* v := a times the first mode of the free bar. */
void ringing_start(struct cloud bar, double a);

/* Kinetic of the particles and elastic (J). */
double ringing_energy(struct cloud bar, struct material material);

/* particles_step() with a tolerance of one's own.  part = 1/2 is the midpoint
 * rule of FLIP: half a step finds the velocity with which the particles go all
 * of it, and its gain counts twice [eq:one-solve]; otherwise part = 1. */
struct particle_report ringing_step(struct cloud bar, struct material material,
                                    const struct particle_step *step,
                                    double tolerance, double part);

/* FLIP by the midpoint rule, on the bar of order 2 and RINGING_CELLS. */
struct ringing ringing_midpoint(double tolerance, int steps);

/* What finite elements with a lumped mass keep, by backward Euler. */
double ringing_elements(int steps);

#endif
