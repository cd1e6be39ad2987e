/* whole_step.h - a step of particles from one state to the next: to the grid,
 * there by Newton's method or explicitly, and back. */
#ifndef FIGURES_WHOLE_STEP_H
#define FIGURES_WHOLE_STEP_H

#include "particles/particle_step.h"

/*
 * Make one step of the particles: P2G, particle_newton() with the tolerance
 * 1e-10, G2P; or, in the explicit one, v := v + dt (f(0) / m + g) instead
 * [eq:symplectic-euler].  Where the status is not OK, no particle has moved,
 * but for one that leaves the grid (OUTSIDE, in the next step's P2G).
 */
struct particle_report particles_step(struct grid *grid, struct particles *p,
                                      struct material material,
                                      const struct particle_step *step);
enum status particles_step_explicit(struct grid *grid, struct particles *p,
                                    struct material material,
                                    const struct particle_step *step);

#endif
