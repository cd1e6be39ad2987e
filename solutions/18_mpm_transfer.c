/*
 * 18_mpm_transfer.c - what survives the way from particles to a grid and back.
 * Notes: the material point method, interpolating functions, P2G and G2P.
 * Problem.  In every step particles give their mass and velocity to the nodes
 * around them, P2G [eq:p2g], and take a velocity back, G2P [eq:g2p].
 *
 *     o - o - o - o     node a = j nodes[0] + i has v[2a] and v[2a + 1], as
 *     |. .|. .| . |     particle p has x[2p], x[2p + 1], v alike, and B[p]
 *     o - o - o - o     (particles.h).  Order 1 reaches 2 nodes per axis,
 *     |  .|. .|  .|     order 2 reaches 3 and order 3 reaches 4.
 * Run       make lesson-18; make lesson-18 ARGS=-h lists its options
 * PREDICT 1 fraction of the spin left by 100 transfers of PIC, --order 1: ...
 * PREDICT 2 angular momentum lost by FLIP with --kick 1 (kg m^2/s): ...
 * PREDICT 3 fraction of the spin left with the cubic kernel, --order 3: ...
 * Plot: spin transfers ratio
 */
#include "base/options.h"
#include "particles/particle_scene.h"
#include "base/table.h"

#include <math.h>

/* On one axis, given x, return first and w[q] = N_i(x), dw[q] = dN_i/dx (1/m)
 * for nodes i = first + q at h i.  On a node order 1 has the next cell; else,
 * where the node at one end has no weight, either end may have it. */
static int weights(int order, double h, double x, double w[], double dw[])
{
    int first = 0;
    /* SLOT 18a(order, h, x, w, dw, &first): `first`, then each node's piece. */
    /* Order 2 has the nearest node in the middle; of orders 1 and 3 as many
     * nodes are left of x as right of it. */
    first = (int)floor(order == 2 ? x / h - 0.5 : x / h) - (order == 3);
    for (int q = 0; q <= order; q++) {
        const double t = x / h - (first + q), a = fabs(t), b = 2.0 - a;
        double slope = -1.0; /* dN/da */
        if (order == 1) w[q] = 1.0 - a;
        if (order == 2) {
            w[q] = a > 0.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0.75 - a * a;
            slope = a > 0.5 ? a - 1.5 : -2.0 * a;
        }
        if (order == 3) {
            w[q] = a > 1.0 ? b * b * b / 6.0 : 2.0 / 3.0 - a * a * (1 - a / 2);
            slope = a > 1.0 ? -0.5 * b * b : a * (1.5 * a - 2.0);
        }
        /* dN/dx = dN/da da/dt dt/dx, and a = |t| */
        dw[q] = (t < 0.0 ? -slope : slope) / h;
    }
    /* END 18a */
    return first;
}

/* P2G [alg:transfer]: given p, fill in mass and v of all nodes, 0 where nothing
 * is; PIC and FLIP have B = 0.  Statuses of grid_support() by your weights. */
static enum status p2g(const struct particles *p, struct grid *grid)
{
    /* SLOT 18b(p, grid): clear the grid, then each particle.  grid_support()
     * gives s.n nodes s.node[i], weights s.w[i], ways s.offset[i] = x_a - x_p,
     * and D = diag(s.inertia); where that is 0, so are the ways. */
    struct support s;
    for (int a = 0; a < grid->n_node; a++)
        grid->mass[a] = grid->v[2 * a] = grid->v[2 * a + 1] = 0.0;
    for (int q = 0; q < p->n; q++) {
        const enum status status = grid_support(grid, &p->x[2 * q], &s);
        if (status != OK) return status;
        for (int i = 0; i < s.n; i++) {
            const double m = p->mass[q] * s.w[i];
            grid->mass[s.node[i]] += m;
            for (int k = 0; k < 2; k++) {
                /* v_p + B_p D^-1 (x_a - x_p): the motion of p, at the node */
                double v = p->v[2 * q + k];
                for (int l = 0; l < 2; l++)
                    if (s.inertia[l] > 0.0)
                        v += p->B[q].m[k][l] / s.inertia[l] * s.offset[i][l];
                grid->v[2 * s.node[i] + k] += m * v;
            }
        }
    }
    /* So far v is the momentum. */
    for (int r = 0; r < 2 * grid->n_node; r++)
        if (grid->mass[r / 2] > 0.0) grid->v[r] /= grid->mass[r / 2];
    /* END 18b */
    return OK;
}

/* G2P [alg:transfer]: given grid->v of P2G and grid->next after the forces,
 * update v and B by the scheme, B = 0 but for APIC, and x after the time dt. */
static enum status g2p(const struct grid *grid, enum transfer scheme, double dt,
                       struct particles *p)
{
    /* SLOT 18c(grid, scheme, dt, p): all three schemes in one loop. */
    struct support s;
    for (int q = 0; q < p->n; q++) {
        const enum status status = grid_support(grid, &p->x[2 * q], &s);
        double after[2] = {0.0, 0.0}, change[2] = {0.0, 0.0};
        mat2 B = {{{0.0}}};
        if (status != OK) return status;
        for (int i = 0; i < s.n; i++)
            for (int k = 0; k < 2; k++) {
                const int r = 2 * s.node[i] + k;
                after[k] += s.w[i] * grid->next[r];
                change[k] += s.w[i] * (grid->next[r] - grid->v[r]);
                /* B = sum_a w_a v_a (x_a - x_p)^T */
                if (scheme != APIC) continue;
                for (int l = 0; l < 2; l++)
                    B.m[k][l] += s.w[i] * grid->next[r] * s.offset[i][l];
            }
        for (int k = 0, r = 2 * q; k < 2; k++, r++) {
            p->v[r] = scheme == FLIP ? p->v[r] + change[k] : after[k];
            /* with the grid, in FLIP too, so that neighbours move alike */
            p->x[r] += dt * after[k];
        }
        p->B[q] = B;
    }
    /* END 18c */
    return OK;
}

/* Given particles, return their angular momentum about 0, all of it. */
static double angular(const struct particles *p)
{
    double L = 0.0;
    /* SLOT 18d(p, &L): what turns about 0, and what turns in itself. */
    for (int q = 0; q < p->n; q++) {
        const double *x = &p->x[2 * q], *v = &p->v[2 * q];
        /* sum_a w_a (x_a - x_p) cross v_a, of which B is all that is kept */
        const double turns = p->B[q].m[1][0] - p->B[q].m[0][1];
        L += p->mass[q] * (x[0] * v[1] - x[1] * v[0] + turns);
    }
    /* END 18d */
    return L;
}

/* There and back; `kick` times a rigid motion is added to the nodes between. */
static void transfer(struct cloud c, enum transfer how, double dt, double kick)
{
    c.grid->kernel = weights;
    enum status status = p2g(c.p, c.grid);
    grid_kick(c.grid, (double[]){0.31 * kick, -0.47 * kick}, 1.7 * kick);
    if (status == OK) status = g2p(c.grid, how, dt, c.p);
    if (status != OK) die("the place of a particle is %s", status_name(status));
}

/* The nodes around x (m), and the sums that the derivation needs. */
static void print_weights(int order, double h, double x)
{
    const char *const name[] = {"w", "w_x", "D", "dw", "dw_x"};
    const double exact[] = {1.0, x, kernel_inertia(order, h, x), 0.0, 1.0};
    double w[ORDER_MAX + 1] = {0.0}, dw[ORDER_MAX + 1] = {0.0}, sum[5] = {0.0};
    const int first = weights(order, h, x, w, dw);
    table_begin("weights", "node w h_dw");
    for (int q = 0; q <= order; q++) {
        const double at = h * (first + q), D = (at - x) * (at - x);
        const double term[] = {w[q], w[q] * at, w[q] * D, dw[q], dw[q] * at};
        for (int k = 0; k < 5; k++) sum[k] += term[k];
        table_row(first + q, w[q], h * dw[q]);
    }
    table_end();
    table_begin("sums", "of sum exact");
    for (int k = 0; k < 5; k++) table_row(name[k], sum[k], exact[k]);
    table_end();
}

/* Seven particles go there and back by each scheme; then the nodes by APIC. */
static void print_transfer(int order, double dt, double kick)
{
    struct cloud c = {NULL, NULL};
    table_begin("transfer", "scheme momentum_x momentum_y L_before L_grid "
                "L_kicked L_after E_before E_grid E_kicked E_after");
    for (int s = PIC; s <= APIC; s++) {
        cloud_free(c);
        c = cloud_seven(order, (enum transfer)s);
        const double L = angular(c.p), E = particles_moments(c.p).kinetic;
        transfer(c, (enum transfer)s, dt, kick);
        const struct moments on = grid_moments(c.grid, c.grid->v);
        const struct moments kicked = grid_moments(c.grid, c.grid->next);
        const struct moments end = particles_moments(c.p);
        table_row(transfer_name((enum transfer)s), end.momentum[0],
                  end.momentum[1], L, on.angular, kicked.angular, angular(c.p),
                  E, on.kinetic, kicked.kinetic, end.kinetic);
    }
    table_end();
    table_begin("grid", "node mass v_x v_y");
    const double *v = c.grid->v;
    for (int a = 0; a < c.grid->n_node; a++)
        if (c.grid->mass[a] > 0.0)
            table_row(a, c.grid->mass[a], v[2 * a], v[2 * a + 1]);
    table_end();
    cloud_free(c);
}

/* A turning disc goes there and back in its place; what is left of its L.
 * disc: some of its particles, too. */
static void print_spin(int order, enum transfer scheme, int steps, int disc)
{
    struct cloud c = cloud_disc(order, 32, scheme);
    const double L = angular(c.p);
    table_begin("spin", "transfers ratio");
    for (int step = 0; step <= steps; step++) {
        if (step > 0) transfer(c, scheme, 0.0, 0.0);
        table_row(step, angular(c.p) / L);
    }
    table_end();
    if (disc) {
        table_begin("disc", "x y v_x v_y");
        for (int q = 0; q < c.p->n; q += 11)
            table_row(c.p->x[2 * q], c.p->x[2 * q + 1], c.p->v[2 * q],
                      c.p->v[2 * q + 1]);
        table_end();
    }
    cloud_free(c);
}

/* One transfer of cos kx on a periodic bar; wavelengths in cells. */
static void print_filter(int order, int ppc)
{
    table_begin("filter", "wavelength scheme factor predicted");
    for (int cells = 16; cells >= 4; cells /= 2)
        for (int s = PIC; s <= APIC; s++) {
            const enum transfer scheme = (enum transfer)s;
            const double k = 2.0 * acos(-1.0) / cells;
            struct cloud c = cloud_wave(order, 16, ppc, k, scheme);
            transfer(c, scheme, 0.0, 0.0);
            table_row(cells, transfer_name(scheme), particles_wave_part(c.p, k),
                      transfer_factor(order, scheme, k));
            cloud_free(c);
        }
    table_end();
}

int main(int argc, char *argv[])
{
    int order = 2, scheme = PIC, steps = 100, ppc = 4, disc = 0;
    double x = 2.385, dt = 0.013, kick = 0.0;
    const struct option options[] = {
        {"order", .integer = &order, .min = 1, .max = 3, .help = "of kernels"},
        {"x", .real = &x, .max = 8, .unit = "cells", .help = "for weights"},
        {"dt", .real = &dt, .min = 1e-6, .max = 1, .unit = "s", .help = "step"},
        {"kick", .real = &kick, .min = -9, .max = 9, .help = "for transfer"},
        {"scheme", .choice = &scheme, .choices = TRANSFERS, .help = "for spin"},
        {"steps", .integer = &steps, .max = 1000, .help = "for spin"},
        {"disc", .choice = &disc, .choices = "no yes", .help = "its particles"},
        {"ppc", .integer = &ppc, .min = 1, .max = 64, .help = "for filter"},
    };
    options_parse("18_mpm_transfer", options, COUNT(options), argc, argv);
    print_weights(order, 0.385, 0.385 * x);
    print_transfer(order, dt, kick);
    print_spin(order, (enum transfer)scheme, steps, disc);
    print_filter(order, ppc);
    return table_finish();
}
