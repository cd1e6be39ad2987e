/*
 * unheld.c - which motions of the nodes does no particle resist?
 *
 * Where a displacement has no gradient at any particle, it costs no energy, and
 * a static problem has no unique solution.  A free bar of 8 cells with ppc
 * particles per cell, `offset` of their spacing behind the left ends: zero
 * modes of the tangent beside the translation.  `field` is one, quadratic
 * kernel.  And what does a hanging bar say in two load steps?
 */
#include "whole_step.h"
#include "particles/particle_bodies.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { CELLS = 8 };

/* A bar at rest, moved to where its particles shall be, after P2G. */
static struct cloud bar(int order, int ppc, double offset)
{
    struct cloud c = cloud_hanging(order, CELLS, ppc);
    for (int p = 0; p < c.p->n; p++)
        c.p->x[2 * p] += (offset - 0.5) / (CELLS * ppc);
    claim(grid_p2g(c.grid, c.p) == OK, "the bar is on its grid");
    return c;
}

/* Eigenvalues of the tangent that are 0 to round-off, less one. */
static int zero_modes(struct cloud c)
{
    const struct particle_body body = {
        .grid = c.grid, .particles = c.p, .material = material_notes(CUBIC)};
    struct unknowns *map = unknowns_alloc(c.grid);
    double u[256] = {0.0}, value[128]; /* of some 20 nodes */
    int zeros = 0;
    unknowns_number(c.grid, NO_WALL, map);
    struct matrix *K = matrix_alloc(BANDED, map->n, map->n);
    claim(particle_stiffness(&body, u, map->equation, map->sign, K) == OK &&
              matrix_eigenvalues(K, value) == OK, "at rest");
    while (value[zeros] < 1e-11 * value[map->n - 1]) zeros++;
    matrix_free(K);
    unknowns_free(map);
    return zeros - 1;
}

static void claim_modes(void)
{
    const int due[][2] = {{0, 0}, {0, 1}, {2, 2}};
    for (int order = 1; order <= 3; order++)
        for (int ppc = 1; ppc <= 3; ppc++)
            for (int off = 0; off < 2; off++) {
                const double offset = off ? 0.23 : 0.5;
                struct cloud c = bar(order, ppc, offset);
                const int zeros = zero_modes(c);
                claim(zeros == (ppc > 1 ? 0 : due[order - 1][off]), "two hold");
                cloud_free(c);
            }
}

/* The slope at the particle of cell i is 0 if u_(i+1) - u_i is -(1 - f) / f
 * times u_i - u_(i-1), f its place from the middle of the cell before. */
static void print_field(void)
{
    struct cloud c = bar(2, 1, 0.07);
    double *u = c.grid->next, jump = 1.0, worst = 0.0, f = 0.57;
    for (int i = 2; i < c.grid->n_node; i++) {
        u[2 * i] = u[2 * i - 2] + jump;
        jump *= -(1.0 - f) / f;
    }
    table_begin("field", "x u");
    for (int k = 0; k <= 32 * CELLS; k++) {
        struct support s;
        double at[2];
        grid_support(c.grid, (double[]){k / (32.0 * CELLS), 0.0}, &s);
        support_value(&s, u, at);
        table_row(k / 32.0, at[0]);
    }
    table_end();
    table_begin("particles", "x u slope");
    for (int p = 0; p < c.p->n; p++) {
        struct support s;
        double at[2];
        grid_support(c.grid, &c.p->x[2 * p], &s);
        support_value(&s, u, at);
        const double slope = support_gradient(&s, u).m[0][0];
        table_row(c.p->x[2 * p] * CELLS, at[0], slope);
        worst = fmax(worst, fabs(slope));
    }
    table_end();
    claim(worst < 1e-13, "no particle sees it");
    cloud_free(c);
}

int main(void)
{
    claim_modes();
    print_field();
    const struct material m = material_notes(CUBIC);
    for (int order = 1; order <= 3; order++)
        for (int ppc = 1; ppc <= 4; ppc *= 2) {
            enum status is[2];
            struct cloud hung = cloud_hanging(order, CELLS, ppc);
            for (int k = 0; k < 2; k++) {
                const struct particle_step step = {.wall = MIRROR,
                                                   .g = {50.0 * (k + 1), 0.0}};
                is[k] = particles_step(hung.grid, hung.p, m, &step).status;
            }
            claim(is[0] == (order == 3 && ppc == 1 ? NOT_SPD : OK) &&
                      is[1] == (order > 1 && ppc == 1 ? NOT_SPD : OK),
                  "singular with one particle per cell, and named: cubic at "
                  "once, quadratic when they have left the middles");
            cloud_free(hung);
        }
    return table_finish();
}
