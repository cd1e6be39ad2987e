/*
 * disc.c - what is left of a turning disc after a hundred transfers?
 *
 * A disc of radius 0.3, four particles per cell, 1 rad/s; the particles stay in
 * their places.  Four ways: PIC, FLIP, APIC, and the mixture that many programs
 * use against FLIP's noise, 95 % FLIP and 5 % PIC.
 */
#include "particles/particle_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { TRANSFERS_MADE = 100, SHOWN = 3 };

/* One transfer; share < 1: of FLIP, the rest is PIC. */
static void transfer(struct grid *grid, enum transfer how, double share,
                     struct particles *p)
{
    claim(grid_p2g(grid, p) == OK, "all particles are on the grid");
    if (share == 1.0) {
        claim(grid_g2p(grid, how, 0.0, p) == OK, "and stay there");
        return;
    }
    for (int q = 0; q < p->n; q++) {
        struct support s;
        double pic[2];
        claim(grid_support(grid, &p->x[2 * q], &s) == OK, "inside");
        support_value(&s, grid->v, pic); /* without forces FLIP keeps v */
        for (int k = 0; k < 2; k++)
            p->v[2 * q + k] += (1.0 - share) * (pic[k] - p->v[2 * q + k]);
    }
}

/* What is left of the angular momentum; `name`: print some of the particles. */
static double spin(int order, int cells, enum transfer how, double share,
                   const char *name, int *n)
{
    struct cloud c = cloud_disc(order, cells, how);
    const double L = particles_moments(c.p).angular;
    for (int k = 0; k < TRANSFERS_MADE; k++) transfer(c.grid, how, share, c.p);
    const double left = particles_moments(c.p).angular / L;
    for (int q = 0; q < c.p->n; q++) {
        const double *x = &c.p->x[2 * q], *v = &c.p->v[2 * q];
        const int i = (int)floor(2.0 * x[0] * cells);
        const int j = (int)floor(2.0 * x[1] * cells);
        if (name && i % SHOWN == 0 && j % SHOWN == 0)
            table_row(name, x[0], x[1], v[0], v[1], hypot(v[0], v[1]));
    }
    *n = c.p->n;
    cloud_free(c);
    return left;
}

int main(void)
{
    static const char *const name[] = {"PIC", "FLIP", "APIC", "95 % FLIP"};
    double left[4];
    int n;
    table_begin("disc", "way x y v_x v_y speed");
    for (int way = 0; way < 4; way++)
        left[way] = spin(2, 32, way < 3 ? (enum transfer)way : PIC,
                         way < 3 ? 1.0 : 0.95, name[way], &n);
    table_end();
    table_begin("left", "way ratio");
    for (int way = 0; way < 4; way++) table_row(name[way], left[way]);
    table_end();

    claim(fabs(left[0] - 0.394896270) < 1e-8, "PIC leaves 39.5 %% (%.9f)",
          left[0]);
    claim(fabs(left[1] - 1.0) < 1e-12, "FLIP leaves all (%.12f)", left[1]);
    claim(left[3] > 0.9 && left[3] < 0.97, "5 %% of PIC lose as much as five "
          "transfers of PIC (%.3f)", left[3]);
    return table_finish();
}
