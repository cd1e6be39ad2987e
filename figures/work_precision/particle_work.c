/* particle_work.c - see particle_work.h. */
#include "particle_work.h"

#include "../20_mpm_implicit/whole_step.h"
#include "bar/bar_scene.h"
#include "base/clock.h"

#include <assert.h>
#include <math.h>

static const double PULL = 500.0, WEIGHS = 50.0, END = 0.15;

double work_look(int s, int d, int tangent)
{
    return 17.0 * s * d + (tangent ? 4.25 * (s * d) * (s * d) : 0.0);
}

/* What a system of the next step costs. */
static struct matrix_cost system_cost(struct cloud c, struct material material,
                                      enum wall wall)
{
    const struct particle_body body = {c.grid, c.p, material, NULL};
    struct matrix_cost cost = {0.0, 0.0, 0.0};
    struct unknowns *map = unknowns_alloc(c.grid);
    if (grid_p2g(c.grid, c.p) == OK) {
        unknowns_number(c.grid, wall, map);
        const int p = particle_band(&body, map->equation);
        cost = matrix_cost(BANDED, map->n, p < map->n ? p : map->n - 1);
    }
    unknowns_free(map);
    return cost;
}

/* One step of the setting, and its share of the work. */
static void advance(const struct particle_setting *set, struct cloud c,
                    struct material material, struct work *w)
{
    const int d = set->body == HUNG ? 1 : 2, wide = set->order + 1;
    const int s = d == 1 ? wide : wide * wide;
    const double look = c.p->n * work_look(s, d, 0);
    const double all = c.p->n * work_look(s, d, 1);
    struct particle_step step = {.wall = MIRROR, .transfer = set->transfer};
    if (set->body == HUNG) step.g[0] = PULL * (w->steps + 1) / set->steps;
    if (set->body == LET_GO) step.g[1] = -WEIGHS;
    if (set->body == LET_GO) step.rate = set->steps / END;

    const int solves = set->body == HUNG || set->implicit;
    const struct matrix_cost cost = system_cost(c, material, step.wall);
    struct particle_report report = {.iterations = 0};
    const double start = clock_seconds();
    if (solves)
        report = particles_step(c.grid, c.p, material, &step);
    else
        report.status =
            particles_step_explicit(c.grid, c.p, material, &step);
    w->seconds += clock_seconds() - start;
    w->status = report.status;
    w->steps += report.status == OK;
    w->systems += report.iterations;
    w->factorisations += report.iterations + report.projections;
    w->flops += 3.0 * look + report.iterations * (cost.solve + look) +
                (report.iterations + report.projections) *
                    (cost.flops + all - look);
}

/* u at X: the mean of what the particles near it say, each by its F; they
 * began in rows, `apart` from each other. */
static void read_vertex(const double X[2], int row, double apart,
                        const struct particles *p, double u[2])
{
    int near = 0;
    u[0] = u[1] = 0.0;
    for (int j = 0; j < row; j++)
        for (int i = 0; i < row; i++) {
            const double d[2] = {X[0] - apart * (i + 0.5),
                                 X[1] + 1.0 - apart * (j + 0.5)};
            if (fabs(d[0]) > 0.6 * apart || fabs(d[1]) > 0.6 * apart) continue;
            const int q = j * row + i;
            const mat2 F = p->F[q];
            for (int k = 0; k < 2; k++)
                u[k] += p->x[2 * q + k] + F.m[k][0] * d[0] +
                        F.m[k][1] * d[1] - X[k];
            near++;
        }
    for (int k = 0; k < 2; k++) u[k] /= near;
}

/* u of the square at the shared vertices. */
static void read_square(const struct particle_setting *set,
                        const struct particles *p, struct work *w)
{
    const int row = set->cells * set->per_cell;
    w->n_shared = 2 * WORK_SHARED;
    double *u = w->u;
    for (int J = 0; J < WORK_SHARED / 5; J++)
        for (int I = 0; I < 5; I++, u += 2) {
            const double X[2] = {0.5 * I, 0.5 * J - 1.0};
            read_vertex(X, row, 2.0 / row, p, u);
        }
}

struct work particle_work(const struct particle_setting *set)
{
    struct work w = {.status = OK, .min_J = INFINITY};
    const int n = set->cells, row = n * set->per_cell;
    const struct material material =
        material_notes(set->body == HUNG ? CUBIC : LOG);
    struct cloud c = {NULL, NULL};
    assert(set->body == HUNG || n % 4 == 0);
    if (set->body == HUNG) {
        c = cloud_hanging(set->order, n, set->per_cell);
    } else {
        const double h = 2.0 / n, origin[2] = {-2.0 * h, -3.0};
        const double low[2] = {0.0, -1.0}, high[2] = {2.0, 1.0};
        const int nodes[2] = {n + 8, 5 * n / 2}, count[2] = {row, row};
        c.grid = grid_alloc(set->order, origin, h, nodes);
        c.p = particles_box(low, high, count, 1.0);
    }
    while (w.status == OK && w.steps < set->steps)
        advance(set, c, material, &w);
    for (int q = 0; q < c.p->n; q++)
        w.min_J = fmin(w.min_J, mat2_det(c.p->F[q]));
    if (w.status == OK && !(w.min_J > 0.0)) w.status = INVERTED;
    if (set->body == LET_GO) {
        read_square(set, c.p, &w);
    } else {
        const int last = row - 1;
        w.n_shared = 2;
        w.u[0] = c.p->x[2 * last] - 1.0 +
                 0.25 / row * (c.p->F[last].m[0][0] + 1.0);
    }
    cloud_free(c);
    return w;
}

struct work element_bar_work(int cells)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, cells);
    const struct matrix_cost cost = matrix_cost(BANDED, cells, 1);
    const double look = cells * work_look(2, 1, 0);
    scene.c = PULL;
    const double start = clock_seconds();
    struct bar_state *bar = bar_scene_solve(&scene, NULL);
    struct work w = {.status = bar->report.status, .steps = 1, .n_shared = 2};
    w.seconds = clock_seconds() - start;
    w.systems = w.factorisations = bar->report.iterations;
    w.flops = look + w.systems * (cost.flops + cost.solve +
                                  cells * work_look(2, 1, 1));
    w.u[0] = bar->u[cells];
    w.min_J = INFINITY;
    for (int e = 1; e <= cells; e++)
        w.min_J = fmin(w.min_J, bar_stretch(&bar->bar, bar->u, e));
    bar_state_free(bar);
    return w;
}
