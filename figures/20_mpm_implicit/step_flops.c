/* step_flops.c - see step_flops.h. */
#include "step_flops.h"

#include "../study/study.h"

double step_flops_look(int order, int n) { return 17.0 * (order + 1) * n; }

double step_flops_tangent(int order, int n)
{
    return 4.25 * (order + 1) * (order + 1) * n;
}

static double look(struct cloud c)
{
    return step_flops_look(c.grid->order, c.p->n);
}

double step_flops_explicit(struct cloud c) { return 3.0 * look(c); }

double step_flops_implicit(struct cloud c, struct material material,
                           enum wall wall,
                           const struct particle_report *report)
{
    const struct particle_body body = {c.grid, c.p, material, NULL};
    const double tangent = step_flops_tangent(c.grid->order, c.p->n);
    const double factored = report->iterations + report->projections;
    struct unknowns *map = unknowns_alloc(c.grid);

    claim(grid_p2g(c.grid, c.p) == OK, "the bar is on its grid");
    unknowns_number(c.grid, wall, map);
    const struct matrix_cost cost =
        matrix_cost(BANDED, map->n, particle_band(&body, map->equation));
    unknowns_free(map);
    return 3.0 * look(c) + report->iterations * (cost.solve + look(c)) +
           factored * (cost.flops + tangent);
}
