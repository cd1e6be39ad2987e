/*
 * runs.c - is the limit of the explicit step where its eigenvalues say?
 *
 * Linear kernel, the last particle of a bar eps h beyond a node, FLIP.  That
 * node has almost no mass, and P2G makes it forget its own velocity in every
 * step: the limit is sqrt(2) / omega, and not the grid's own 2 / omega.  Bars
 * with velocities of 1e-9 m/s make 1500 steps of 0.98 and 1.02 of it.
 */
#include "particles/particle_bodies.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

/* The largest |v_p| on the way. */
static double run(double eps, double part, double *omega)
{
    const struct material material = material_notes(CUBIC);
    struct cloud c = cloud_outlying(1, eps);
    const struct particle_body body = {c.grid, c.p, material, NULL};
    struct particle_step step = {.transfer = FLIP};
    double most = 0.0;
    claim(grid_p2g(c.grid, c.p) == OK, "the bar is on its grid");
    *omega = particle_frequency(&body);
    step.rate = *omega / (part * sqrt(2.0));
    for (int p = 0; p < c.p->n; p++)
        c.p->v[2 * p] = 1e-9 * (p * 7 % 5 - 2.0);
    for (int k = 0; k < 1500 && most < 1e-2; k++) {
        if (particles_step_explicit(c.grid, c.p, material, &step) != OK) break;
        for (int p = 0; p < c.p->n; p++)
            most = fmax(most, fabs(c.p->v[2 * p]));
    }
    cloud_free(c);
    return most;
}

int main(void)
{
    table_begin("runs", "eps omega below above");
    for (double eps = 1e-3; eps > 5e-7; eps *= 0.1) {
        double omega;
        const double below = run(eps, 0.98, &omega);
        const double above = run(eps, 1.02, &omega);
        table_row(eps, omega, below, above);
        claim(below < 1e-8, "0.98 of the limit is stable (%g)", below);
        claim(above > 1e-4, "1.02 of the limit is not (%g)", above);
    }
    table_end();
    return table_finish();
}
