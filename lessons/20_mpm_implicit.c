/*
 * 20_mpm_implicit.c - the material point method: an implicit step of particles.
 * Notes: the material point method, backward Euler and the updates after it.
 *
 * Problem.  P2G has given the nodes m_a and v_a.  Now they move by u, so that
 *
 *     r = M (u / dt - v) / dt - f(u) - m g = 0           [eq:particle-residual]
 *
 * where E [eq:particle-potential] is stationary; Newton's method finds it
 * [alg:particle-newton].  The particles follow, and the grid is forgotten.
 *
 *   -1 | 0   1   2   3      component k of node a is u[2a + k], as in v, r, w;
 *    o-|-o---o---o---o      u = T y, y the unknowns of map: u_s = sign[s]
 *      |. .  . .  . .       y[equation[s]], or 0 where equation[s] < 0.  Across
 *    wall at x_1 = 0        the wall u(-x_1) = -u(x_1) [eq:mirror]
 * Run       make lesson-20; make lesson-20 ARGS=-h lists its options
 * PREDICT 1a error over that of 16 elements, cubic, mirror, one grid: ...
 * PREDICT 1b and with a new grid for each of ten loads, 4 per cell: ...
 * PREDICT 2a order in h, quadratic, 2 per cell, one grid, x_1 <= 0 held: ...
 * PREDICT 2b and with the mirror: ...
 * Plot: step x next_x
 */
#include "base/options.h"
#include "particles/particle_bodies.h"
#include "particles/particle_step.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Given u, fill in *E and r = dE/du at all nodes; 1 / dt is step->rate.  Return
 * the status of particle_force(); E and r are then incomplete. */
static enum status potential(const struct particle_body *body,
                             const struct particle_step *step,
                             const double u[], struct potential *E, double r[])
{
    const double *v = body->grid->v, *mass = body->grid->mass;
    const int n = 2 * body->grid->n_node;
    double *w = allocate((size_t)n, sizeof *w);
    double *Mw = allocate((size_t)n, sizeof *Mw);
    enum status status = OK;
    /* SLOT 20a(body, step, u, v, mass, n, w, Mw, E, r, &status): the parts of
     * E, and r; particle_energy(), particle_force(), particle_mass(). */
    todo("20a", body, step, u, v, mass, n, w, Mw, E, r, &status);
    /* END 20a */
    free(Mw);
    free(w);
    return status;
}

/* Given the grid and the wall, say which nodes move, and by which unknown: fill
 * in map->n, equation and sign.  Node a is in the column a % columns, one of
 * which is the wall. */
static void number(const struct grid *grid, enum wall wall,
                   struct unknowns *map)
{
    const int columns = grid->nodes[0], axes = grid->nodes[1] > 1 ? 2 : 1;
    const int at_wall = (int)lround(-grid->origin[0] / grid->h);
    /* SLOT 20b(grid, wall, columns, axes, at_wall, map): only nodes with mass
     * move, by the first `axes` components; then their mirror images. */
    todo("20b", grid, wall, columns, axes, at_wall, map);
    /* END 20b */
}

/* What newton() works on: n numbers each. */
struct room {
    double *r, *y, *du, *trial;
};

static struct room room_alloc(size_t n)
{
    struct room room;
    room.r = allocate(n, sizeof *room.r);
    room.y = allocate(n, sizeof *room.y);
    room.du = allocate(n, sizeof *room.du);
    room.trial = allocate(n, sizeof *room.trial);
    return room;
}

static void room_free(struct room *room)
{
    free(room->trial);
    free(room->du);
    free(room->y);
    free(room->r);
}

/* Given body and step, find the u with r = 0, from u = 0.  Done: max|du| of the
 * unknowns <= small, and then max|r| <= small max A_ii; `part` of du is taken,
 * 1, 1/2, 1/4, ..., so that E falls, see potential_falls().  Where A is not
 * positive definite, it is made again without negative modes of dP/dF,
 * `convex`.  NOT_SPD: both fail; STALLED: 40 halvings; MAX_ITERATIONS: after
 * STEP_CAP linear systems.  Whether a system whose line search stalls counts is
 * up to you.  New since 16d: it projects on demand only. */
static struct particle_report newton(const struct particle_body *body,
                                     const struct particle_step *step,
                                     double u[])
{
    const int n = 2 * body->grid->n_node;
    const double small = 1e-10 * body->grid->h, rate = step->rate;
    const struct particle_body convex = {body->grid, body->particles,
                                         body->material, particle_projected};
    struct particle_report report = {.status = OK};
    struct unknowns *map = unknowns_alloc(body->grid);
    struct potential there;
    struct room room = room_alloc((size_t)n);
    double *r = room.r, *y = room.y, *du = room.du, *trial = room.trial;
    double weight = 0.0;
    number(body->grid, step->wall, map);
    struct matrix *A = unknowns_matrix(body, map);
    /* SLOT 20c(body, &convex, step, n, small, rate, &report, map, &there, r, y,
     * du, trial, &weight, A, u, potential): particle_stiffness() adds to A. */
    todo("20c", body, &convex, step, n, small, rate, &report, map, &there, r,
         y, du, trial, &weight, A, u, potential);
    /* END 20c */
    matrix_free(A);
    unknowns_free(map);
    room_free(&room);
    return report;
}

/* Given the nodes' displacements u, update F, v, x of all particles, v from
 * v^{n+1} = u / dt with PIC or FLIP. */
static enum status update(const struct grid *grid,
                          const struct particle_step *step, const double u[],
                          struct particles *p)
{
    struct support s;
    for (int q = 0; q < p->n; q++) {
        const enum status status = grid_support(grid, &p->x[2 * q], &s);
        if (status != OK) return status;
        /* SLOT 20d(grid, step, u, &s, p, q): this particle, whose nodes are in
         * s; support_value() and support_gradient() do the sums. */
        todo("20d", grid, step, u, &s, p, q);
        /* END 20d */
    }
    return OK;
}

static struct particle_report advance(struct cloud c, struct material material,
                                      const struct particle_step *step)
{
    const struct particle_body body = {c.grid, c.p, material, NULL};
    double *u = c.grid->next; /* a velocity in the end */
    struct particle_report report = {.status = grid_p2g(c.grid, c.p)};
    if (report.status == OK) report = newton(&body, step, u);
    if (report.status == OK) report.status = update(c.grid, step, u, c.p);
    for (int s = 0; s < 2 * c.grid->n_node; s++) u[s] *= step->rate;
    return report;
}

/* The bar hung by its end, at rest under 500 N/m, which `loads` steps without
 * inertia have put on; each begins with a new grid. */
static void print_bar(int order, struct material material, enum wall wall)
{
    table_begin("bar", "cells ppc wall loads error stress_error status");
    for (int ppc = 1; ppc <= 4; ppc *= 2)
        for (int loads = 1; loads <= 10; loads *= 10)
            for (int cells = 8; cells <= 16; cells *= 2) {
                struct cloud c = cloud_hanging(order, cells, ppc);
                struct particle_step step = {.wall = wall};
                enum status status = OK;
                for (int k = 1; k <= loads && status == OK; k++) {
                    step.g[0] = 500.0 * k / loads;
                    status = advance(c, material, &step).status;
                }
                const struct hanging_error e =
                    hanging_error(c.p, &material, 500.0);
                table_row(cells, ppc, wall_name(wall), loads,
                          cell_if(status == OK, e.place),
                          cell_if(status == OK, e.stress / 500.0),
                          status_name(status));
                cloud_free(c);
            }
    table_end();
}

int main(int argc, char *argv[])
{
    int scene = HANGING, order = 2, law = 1, wall = HELD, mass = 0, scheme = 0;
    int steps = 1;
    double dt = 1.0 / 30.0;
    const struct option options[] = {
        {"scene", .choice = &scene, .choices = STEPPING, .help = "what moves"},
        {"order", .integer = &order, .min = 1, .max = 3, .help = "of kernels"},
        {"law", .choice = &law, .choices = "log cubic", .help = "material"},
        {"wall", .choice = &wall, .choices = WALLS, .help = "of the bar"},
        {"mass", .choice = &mass, .choices = "lumped consistent", .help = "M"},
        {"scheme", .choice = &scheme, .choices = "PIC FLIP", .help = "of G2P"},
        {"dt", .real = &dt, .min = 1e-6, .max = 9, .unit = "s", .help = "step"},
        {"steps", .integer = &steps, .min = 1, .max = 1000, .help = "how many"},
    };
    options_parse("20_mpm_implicit", options, COUNT(options), argc, argv);
    const struct material material = material_notes(law ? CUBIC : LOG);
    struct particle_step step = {.rate = 1.0 / dt, .consistent = mass,
                                 .transfer = (enum transfer)scheme};
    if (scene == HANGING) step.wall = (enum wall)wall;
    struct cloud c = cloud_stepping((enum stepping)scene, order, step.g);
    struct particle_report last = {.status = OK};
    table_begin("energies", CLOUD_ENERGIES);
    cloud_energies(c, &material, 0.0, &last);
    for (int k = 1; k <= steps && last.status == OK; k++) {
        last = advance(c, material, &step);
        if (last.status == OK) cloud_energies(c, &material, k * dt, &last);
    }
    table_end();
    cloud_tables(c, &last);
    print_bar(order, material, (enum wall)wall);
    if (last.status != OK) die("a step ends with %s", status_name(last.status));
    cloud_free(c);
    return table_finish();
}
