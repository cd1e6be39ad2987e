/* whole_step.c - see whole_step.h. */
#include "whole_step.h"

#include <stdlib.h>
#include <string.h>

struct particle_report particles_step(struct grid *grid, struct particles *p,
                                      struct material material,
                                      const struct particle_step *step)
{
    const struct particle_body body = {grid, p, material, NULL};
    const int n_dof = 2 * grid->n_node;
    double *u = allocate((size_t)n_dof, sizeof *u);
    struct particle_report report = {.status = grid_p2g(grid, p)};
    if (report.status == OK) report = particle_newton(&body, step, 1e-10, u);
    if (report.status == OK) {
        /* an endless step: the displacement takes the place of v dt */
        const double rate = step->rate > 0.0 ? step->rate : 1.0;
        for (int s = 0; s < n_dof; s++) grid->next[s] = rate * u[s];
        report.status = grid_g2p(grid, step->transfer, 1.0 / rate, p);
        if (step->rate == 0.0)
            memset(p->v, 0, 2 * (size_t)p->n * sizeof *p->v);
    }
    free(u);
    return report;
}

enum status particles_step_explicit(struct grid *grid, struct particles *p,
                                    struct material material,
                                    const struct particle_step *step)
{
    const struct particle_body body = {grid, p, material, NULL};
    const int n_dof = 2 * grid->n_node;
    const double dt = 1.0 / step->rate;
    struct unknowns *map = unknowns_alloc(grid);
    double *f = allocate((size_t)n_dof, sizeof *f);
    double *momentum = allocate((size_t)n_dof, sizeof *momentum);
    double *mass = allocate((size_t)n_dof, sizeof *mass);
    double *zero = allocate((size_t)n_dof, sizeof *zero);
    enum status status = grid_p2g(grid, p);
    if (status == OK) status = particle_force(&body, zero, f);
    if (status == OK) {
        for (int a = 0; a < grid->n_node; a++)
            for (int k = 0; k < 2; k++) {
                const int s = 2 * a + k;
                f[s] = grid->mass[a] * (grid->v[s] + dt * step->g[k]) +
                       dt * f[s];
            }
        unknowns_number(grid, step->wall, map);
        unknowns_gather(map, f, momentum);
        for (int s = 0; s < n_dof; s++)
            if (map->equation[s] >= 0)
                mass[map->equation[s]] += grid->mass[s / 2];
        for (int e = 0; e < map->n; e++) momentum[e] /= mass[e];
        unknowns_scatter(map, momentum, grid->next);
        status = grid_g2p(grid, step->transfer, dt, p);
    }
    unknowns_free(map);
    free(f);
    free(momentum);
    free(mass);
    free(zero);
    return status;
}
