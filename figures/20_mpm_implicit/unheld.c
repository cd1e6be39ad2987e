/*
 * unheld.c - which motions of the nodes does no particle resist?
 *
 * Where a displacement has no gradient at any particle, it costs no energy, and
 * a static problem has no unique solution.  A free bar of 8 cells with ppc
 * particles per cell, `offset` of their spacing behind the left ends: zero modes
 * of the tangent beside the translation.  `field` is one of them, of the
 * quadratic kernel.  `loads`: what a hanging bar says in its second load step,
 * when its particles no longer sit in the middles.
 */
#include "particle_bodies.h"
#include "study.h"
#include "table.h"

#include <math.h>

enum { CELLS = 8 };
static const char *const KERNEL[] = {"linear", "quadratic", "cubic"};

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
    const struct particle_body body = {c.grid, c.p, material_notes(CUBIC),
                                       NULL};
    struct unknowns *map = unknowns_alloc(c.grid);
    double u[256] = {0.0}, value[128];
    int zeros = 0;
    claim(map->n_dof <= 256, "room");
    unknowns_number(c.grid, NO_WALL, map);
    struct matrix *K = matrix_alloc(DENSE, map->n, 0);
    claim(particle_stiffness(&body, u, map->equation, map->sign, K) == OK &&
              matrix_eigenvalues(K, value) == OK, "at rest");
    while (zeros < map->n && value[zeros] < 1e-11 * value[map->n - 1]) zeros++;
    matrix_free(K);
    unknowns_free(map);
    return zeros - 1;
}

int main(void)
{
    const int due[][2] = {{0, 0}, {0, 1}, {2, 2}}; /* one particle per cell */
    table_begin("modes", "kernel ppc offset zero_modes");
    for (int order = 1; order <= 3; order++)
        for (int k = 0; k < 6; k++) {
            const int ppc = 1 + k / 2;
            const double offset = k % 2 ? 0.23 : 0.5;
            struct cloud c = bar(order, ppc, offset);
            const int zeros = zero_modes(c);
            table_row(KERNEL[order - 1], ppc, offset, zeros);
            claim(zeros == (ppc > 1 ? 0 : due[order - 1][k % 2]),
                  "no mode from two particles per cell on");
            cloud_free(c);
        }
    table_end();

    /* the slope at the particle of cell i is 0 if u_(i+1) - u_i = -a / b times
     * u_i - u_(i-1), a and b being how much each difference counts there */
    struct cloud c = bar(2, 1, 0.23);
    double *u = c.grid->next, jump = 1.0, worst = 0.0;
    const double f = 0.23 + 0.5; /* from the middle before, in cells */
    for (int i = 2; i < c.grid->n_node; i++) {
        u[2 * i] = u[2 * i - 2] + jump;
        jump *= -(1.0 - f) / f;
    }
    table_begin("field", "x u");
    for (int k = 0; k <= 32 * CELLS; k++) {
        struct support s;
        double at[2];
        claim(grid_support(c.grid, (double[]){k / (32.0 * CELLS), 0.0}, &s) ==
                  OK, "inside");
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
        const double slope = support_gradient(&s, u).m[0][0] / CELLS;
        table_row(c.p->x[2 * p] * CELLS, at[0], slope);
        worst = fmax(worst, fabs(slope));
    }
    table_end();
    claim(worst < 1e-14, "no particle sees it");
    cloud_free(c);

    table_begin("loads", "kernel ppc first second");
    for (int order = 1; order <= 3; order++)
        for (int ppc = 1; ppc <= 4; ppc *= 2) {
            enum status is[2];
            struct cloud hung = cloud_hanging(order, CELLS, ppc);
            for (int k = 0; k < 2; k++) {
                const struct particle_step step = {.wall = MIRROR,
                                                   .g = {50.0 * (k + 1), 0.0}};
                is[k] = particles_step(hung.grid, hung.p, material_notes(CUBIC),
                                       &step).status;
            }
            table_row(KERNEL[order - 1], ppc, status_name(is[0]),
                      status_name(is[1]));
            claim(ppc > 1 ? is[1] == OK : order == 1 || is[1] == NOT_SPD,
                  "singular with one particle per cell, and named");
            cloud_free(hung);
        }
    table_end();
    return table_finish();
}
