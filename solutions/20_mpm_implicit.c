/*
 * 20_mpm_implicit.c - an implicit step of particles: the whole method.
 *
 * Notes: the material point method, backward Euler and the updates after it.
 *
 * Problem.  P2G has given the nodes m_a and v_a.  Now they move by u, so that
 *
 *     r = M (u / dt - v) / dt - f(u) - m g = 0        [eq:particle-residual]
 *
 * which is where E [eq:particle-potential] is stationary; Newton's method finds
 * it [alg:particle-newton].  The particles follow, and the grid is forgotten.
 *
 *   -1 | 0   1   2   3      component k of node a is u[2a + k], as in v, r, w;
 *    o-|-o---o---o---o      u = T y, y the unknowns of map: u_s = sign[s]
 *      |  . . . . . .       y[equation[s]], or 0 where equation[s] < 0.  Across
 *    wall at x_1 = 0        the wall u(-x_1) = -u(x_1) [eq:mirror]
 *
 * Run       make lesson-20, or with options: -h lists them
 * Expect    elastic energy 0.00798452951 after one step of the bar
 * Plot: energies t elastic
 */
#include "options.h"
#include "particle_bodies.h"
#include "particle_step.h"
#include "table.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TOLERANCE 1e-10 /* of du and of r / max A_ii, in cells */

static void number(const struct grid *grid, enum wall wall,
                   struct unknowns *map);
static enum status potential(const struct particle_body *body,
                             const struct particle_step *step,
                             const double u[], struct potential *E, double r[]);
static struct particle_report newton(const struct particle_body *body,
                                     const struct particle_step *step,
                                     double u[]);
static enum status update(const struct grid *grid,
                          const struct particle_step *step, const double u[],
                          struct particles *p);

/* P2G, the nodes' new places, G2P; u has room for all nodes. */
static struct particle_report advance(struct cloud c, struct material material,
                                      const struct particle_step *step,
                                      double u[])
{
    const struct particle_body body = {c.grid, c.p, material, NULL};
    struct particle_report report = {.status = grid_p2g(c.grid, c.p)};
    if (report.status == OK) report = newton(&body, step, u);
    if (report.status == OK) report.status = update(c.grid, step, u, c.p);
    return report;
}

static void print_energies(struct cloud c, struct material material, double t,
                           int iterations, struct potential E)
{
    const struct moments of = particles_moments(c.p);
    table_row(t, iterations, particles_elastic(c.p, &material), of.kinetic,
              grid_moments(c.grid, c.grid->v).kinetic,
              grid_moments(c.grid, c.grid->next).kinetic, potential_sum(E),
              of.momentum[0], of.momentum[1], of.angular);
}

/* Steps of a scene: every step's energies, the last one's iterations. */
static enum status print_steps(struct cloud c, struct material material,
                               const struct particle_step *step, int steps)
{
    const struct particle_body body = {c.grid, c.p, material, NULL};
    const size_t n = 2 * (size_t)c.grid->n_node;
    double *u = allocate(2 * n, sizeof *u), *r = u + n;
    struct particle_report report = {.status = OK};
    struct potential E = {0.0, 0.0, 0.0};
    table_begin("energies", "t iterations elastic kinetic grid_before "
                "grid_after potential momentum_x momentum_y angular");
    print_energies(c, material, 0.0, 0, E);
    for (int k = 1; k <= steps && report.status == OK; k++) {
        report.status = grid_p2g(c.grid, c.p);
        if (report.status == OK) report = newton(&body, step, u);
        if (report.status == OK)
            report.status = potential(&body, step, u, &E, r);
        for (size_t s = 0; s < n; s++) c.grid->next[s] = step->rate * u[s];
        if (report.status == OK) report.status = update(c.grid, step, u, c.p);
        if (report.status == OK)
            print_energies(c, material, k / step->rate, report.iterations, E);
    }
    table_end();
    table_begin("newton", "k residual increment part");
    for (int k = 0; k < report.iterations; k++)
        table_row(k, report.residual[k], report.increment[k], report.part[k]);
    table_end();
    free(u);
    return report.status;
}

static void print_step(struct cloud c)
{
    table_begin("step", "node x y mass v_x v_y next_x next_y");
    for (int a = 0; a < c.grid->n_node; a++) {
        const double *v = &c.grid->v[2 * a], *next = &c.grid->next[2 * a];
        double x[2];
        grid_place(c.grid, a, x);
        if (c.grid->mass[a] > 0.0)
            table_row(a, x[0], x[1], c.grid->mass[a], v[0], v[1], next[0],
                      next[1]);
    }
    table_end();
    table_begin("particles", "x y v_x v_y F11 F12 F21 F22");
    for (int q = 0; q < c.p->n; q++) {
        const double *x = &c.p->x[2 * q], *v = &c.p->v[2 * q];
        const mat2 F = c.p->F[q];
        table_row(x[0], x[1], v[0], v[1], F.m[0][0], F.m[0][1], F.m[1][0],
                  F.m[1][1]);
    }
    table_end();
}

/* The bar hung by its end, at rest under 500 N/m, which `loads` endless steps
 * have put on; each step begins with a new grid. */
static void print_bar(int order, struct material material, enum wall wall)
{
    table_begin("bar", "cells ppc wall loads error stress_error status");
    for (int row = 0; row < 12; row++) {
        const int cells = 8 << row % 2, ppc = 1 << row / 4;
        const int loads = row / 2 % 2 ? 10 : 1;
        struct cloud c = cloud_hanging(order, cells, ppc);
        double *u = allocate(2 * (size_t)c.grid->n_node, sizeof *u);
        struct particle_step step = {.wall = wall};
        enum status status = OK;
        for (int k = 1; k <= loads && status == OK; k++) {
            step.g[0] = 500.0 * k / loads;
            status = advance(c, material, &step, u).status;
        }
        const struct hanging_error e = hanging_error(c.p, &material, 500.0);
        table_row(cells, ppc, wall_name(wall), loads,
                  cell_if(status == OK, e.place),
                  cell_if(status == OK, e.stress / 500.0), status_name(status));
        free(u);
        cloud_free(c);
    }
    table_end();
}

/* The largest diagonal entry of A, and of y. */
static double largest(const struct matrix *A, const double y[])
{
    double most = 0.0;
    for (int e = 0; e < A->n; e++) {
        const double value = fabs(y ? y[e] : matrix_get(A, e, e));
        if (!(value <= most)) most = value;
    }
    return most;
}

/* Which nodes move, and by which unknown: fills map (its n, equation, sign);
 * unknowns are as in particle_step.h.  The wall is a column of nodes. */
static void number(const struct grid *grid, enum wall wall,
                   struct unknowns *map)
{
    const int columns = grid->nodes[0], axes = grid->nodes[1] > 1 ? 2 : 1;
    const int at_wall = (int)lround(-grid->origin[0] / grid->h);
    map->n = 0;
    /* SLOT 20c(grid, wall, columns, axes, at_wall, map): node a is in the column
     * a % columns.  First those that move by an unknown of their own. */
    for (int s = 0; s < map->n_dof; s++) {
        const int held = wall != NO_WALL && s / 2 % columns <= at_wall;
        const int moves = !held && s % 2 < axes && grid->mass[s / 2] > 0.0;
        map->equation[s] = moves ? map->n++ : -1;
        map->sign[s] = 1.0;
    }
    for (int s = 0; s < map->n_dof && wall == MIRROR; s++) {
        const int image = s + 4 * (at_wall - s / 2 % columns);
        if (image <= s || image >= map->n_dof) continue;
        map->equation[s] = map->equation[image];
        map->sign[s] = -1.0;
    }
    /* END 20c */
}

/* E and r = dE/du at all nodes; 1 / dt is step->rate.  Statuses are those of
 * particle_force(); E and r are then incomplete. */
static enum status potential(const struct particle_body *body,
                             const struct particle_step *step,
                             const double u[], struct potential *E, double r[])
{
    const double *v = body->grid->v, *mass = body->grid->mass;
    const int n = 2 * body->grid->n_node;
    double *w = allocate(2 * (size_t)n, sizeof *w), *Mw = w + n;
    enum status status = OK;
    *E = (struct potential){0.0, 0.0, 0.0};
    /* SLOT 20a(body, step, u, v, mass, n, w, Mw, E, r, &status): the parts of
     * E, and r.  particle_energy(), particle_force() and particle_mass() do the
     * sums over particles. */
    status = particle_energy(body, u, &E->elastic);
    if (status == OK) status = particle_force(body, u, r);
    for (int s = 0; s < n; s++) w[s] = step->rate * u[s] - v[s];
    if (status == OK) status = particle_mass(body, step->consistent, w, Mw);
    for (int s = 0; s < n && status == OK; s++) {
        const double weight = mass[s / 2] * step->g[s % 2];
        E->inertia += 0.5 * w[s] * Mw[s];
        E->load -= weight * u[s];
        r[s] = step->rate * Mw[s] - r[s] - weight;
    }
    /* END 20a */
    free(w);
    return status;
}

/*
 * The u with r = 0, from u = 0, by Newton's method.  Done: max|du| of the
 * unknowns <= TOLERANCE h, and then max|r| <= TOLERANCE h max A_ii.  Each du is
 * halved until E falls, or stays the same within round-off.  NOT_SPD: A is not
 * positive definite; STALLED: 40 halvings; MAX_ITERATIONS: after STEP_CAP.
 */
static struct particle_report newton(const struct particle_body *body,
                                     const struct particle_step *step,
                                     double u[])
{
    const int n = 2 * body->grid->n_node;
    const double small = TOLERANCE * body->grid->h;
    struct particle_report report = {.status = OK};
    struct unknowns *map = unknowns_alloc(body->grid);
    struct potential E, there;
    double *r = allocate(4 * (size_t)n, sizeof *r), *y = r + n, *du = y + n;
    double *trial = du + n, weight = 0.0;

    number(body->grid, step->wall, map);
    struct matrix *A = unknowns_matrix(body, map);
    memset(u, 0, (size_t)n * sizeof *u);
    /* SLOT 20b(body, step, n, small, &report, map, &E, &there, r, y, du, trial,
     * &weight, A, u): A = K + M / dt^2 by particle_stiffness(), which takes
     * map->equation and map->sign, and particle_mass_matrix(). */
    for (;;) {
        const int k = report.iterations;
        report.status = potential(body, step, u, &E, r);
        if (report.status != OK) break;
        unknowns_gather(map, r, y);
        report.residual[k] = largest(A, y);
        if (k > 0 && report.increment[k - 1] <= small &&
            report.residual[k] <= small * weight)
            break;
        report.status = MAX_ITERATIONS;
        if (k == STEP_CAP) break;

        matrix_zero(A);
        particle_stiffness(body, u, map->equation, map->sign, A);
        particle_mass_matrix(body, step->consistent, step->rate * step->rate,
                             map, A);
        weight = largest(A, NULL);
        report.status = matrix_factor(A);
        if (report.status != OK) break;
        matrix_solve(A, y);
        report.increment[k] = largest(A, y);
        unknowns_scatter(map, y, du);
        const double most =
            potential_sum(E) + 16.0 * DBL_EPSILON * potential_size(E);
        report.status = STALLED;
        double *part = &report.part[k];
        for (*part = 1.0; *part > 1e-12; *part *= 0.5) {
            for (int s = 0; s < n; s++) trial[s] = u[s] - *part * du[s];
            if (potential(body, step, trial, &there, r) == OK &&
                potential_sum(there) <= most)
                break;
        }
        if (!(*part > 1e-12)) break;
        memcpy(u, trial, (size_t)n * sizeof *u);
        report.iterations++;
    }
    /* END 20b */
    matrix_free(A);
    unknowns_free(map);
    free(r);
    return report;
}

/* F, v and x of all particles after the nodes have moved by u: v by PIC, FLIP
 * or APIC with v_a^{n+1} = u_a / dt, B = 0 but for APIC. */
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
        double moved[2], before[2];
        support_value(&s, u, moved);
        support_value(&s, grid->v, before);
        const mat2 gradient = support_gradient(&s, u);
        p->F[q] = mat2_add(p->F[q], mat2_multiply(gradient, p->F[q]));
        p->B[q] = (mat2){{{0.0}}};
        for (int i = 0; i < 4 * s.n && step->transfer == APIC; i++)
            p->B[q].m[i % 2][i / 2 % 2] += step->rate * s.w[i / 4] *
                                           u[2 * s.node[i / 4] + i % 2] *
                                           s.offset[i / 4][i / 2 % 2];
        for (int k = 0; k < 2; k++) {
            const double after = step->rate * moved[k];
            double *v = &p->v[2 * q + k];
            *v = step->transfer == FLIP ? *v + after - before[k] : after;
            p->x[2 * q + k] += moved[k];
        }
        /* END 20d */
    }
    return OK;
}

int main(int argc, char *argv[])
{
    int scene = 0, order = 2, law = 1, wall = HELD, scheme = PIC, steps = 1;
    int mass = 0;
    double dt = 1.0 / 30.0;
    const struct option options[] = {
        {"scene", .choice = &scene, .choices = "bar strained block",
         .help = "of particle_bodies.h"},
        {"order", .integer = &order, .min = 1, .max = 3, .help = "of kernels"},
        {"law", .choice = &law, .choices = "log cubic", .help = "material"},
        {"wall", .choice = &wall, .choices = WALLS, .help = "of bars at 0"},
        {"mass", .choice = &mass, .choices = "lumped consistent", .help = "M"},
        {"scheme", .choice = &scheme, .choices = TRANSFERS, .help = "of G2P"},
        {"dt", .real = &dt, .min = 1e-6, .max = 10, .unit = "s",
         .help = "time step"},
        {"steps", .integer = &steps, .min = 1, .max = 1000, .help = "how many"},
    };
    options_parse("20_mpm_implicit", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    const struct material material = material_notes(law ? CUBIC : LOG);
    const struct particle_step step = {
        .rate = 1.0 / dt,
        .g = {scene == 0 ? 9.81 : scene == 1 ? -9.81 : 0.0, 0.0},
        .consistent = mass,
        .wall = scene == 0 ? (enum wall)wall : NO_WALL,
        .transfer = (enum transfer)scheme};
    struct cloud c = scene == 0   ? cloud_hanging(order, 8, 2)
                     : scene == 1 ? cloud_strained(order)
                                  : cloud_block(order);
    const enum status status = print_steps(c, material, &step, steps);
    print_step(c);
    print_bar(order, material, (enum wall)wall);
    if (status != OK) die("a step ends with %s", status_name(status));
    cloud_free(c);
    return table_finish();
}
