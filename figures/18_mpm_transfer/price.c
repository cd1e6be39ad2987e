/*
 * price.c - does a wider kernel or a finer grid keep more of a turning disc,
 * and what does it cost?
 *
 * The disc of disc.c: what PIC, FLIP and APIC lose of its angular momentum in a
 * hundred transfers, for three kernels and three grids; and what one transfer
 * loses of a rigid kick that the nodes get while the disc is at rest.  The
 * price is counted for each node that a particle visits, there and back.  PIC
 * weighs the mass, adds it up and does the same with two momenta and two
 * velocities; FLIP takes two differences, too, and weighs and adds them; APIC
 * has a product of 2 x 2 numbers with the vector to the node, on either way.
 */
#include "particles/particle_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { TRANSFERS_MADE = 100, GRIDS = 3 };
enum { PIC_FLOPS = 10, FLIP_FLOPS = 16, APIC_FLOPS = 26 };

/* The fraction of the angular momentum that is lost; n: particles. */
static double lost(int order, int cells, enum transfer how, int *n)
{
    struct cloud c = cloud_disc(order, cells, how);
    const double L = particles_moments(c.p).angular;
    for (int k = 0; k < TRANSFERS_MADE; k++) {
        claim(grid_p2g(c.grid, c.p) == OK, "all particles are on the grid");
        claim(grid_g2p(c.grid, how, 0.0, c.p) == OK, "and stay there");
    }
    const double left = particles_moments(c.p).angular / L;
    *n = c.p->n;
    cloud_free(c);
    return 1.0 - left;
}

/* The fraction of a kick's angular momentum that is lost. */
static double kick_lost(int order, int cells, enum transfer how)
{
    const double push[2] = {0.0, 0.0};
    struct cloud c = cloud_disc(order, cells, PIC);
    for (int k = 0; k < 2 * c.p->n; k++) c.p->v[k] = 0.0;
    claim(grid_p2g(c.grid, c.p) == OK, "all particles are on the grid");
    grid_kick(c.grid, push, 1.0);
    const double L = grid_moments(c.grid, c.grid->next).angular;
    claim(grid_g2p(c.grid, how, 0.0, c.p) == OK, "and stay there");
    const double left = particles_moments(c.p).angular / L;
    cloud_free(c);
    return 1.0 - left;
}

int main(void)
{
    const char *const kernel[] = {"linear", "quadratic", "cubic"};
    double pic[ORDER_MAX + 1][GRIDS], visits[ORDER_MAX + 1][GRIDS];
    table_begin("price", "kernel cells pic_flops pic_lost flip_flops kick_lost "
                         "apic_flops apic_lost");
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int k = 0; k < GRIDS; k++) {
            const int cells = 16 << k;
            int n;
            pic[order][k] = lost(order, cells, PIC, &n);
            const double flip = lost(order, cells, FLIP, &n);
            const double apic = lost(order, cells, APIC, &n);
            const double kick = kick_lost(order, cells, FLIP);
            claim(fabs(flip) < 1e-12 && fabs(apic) < 1e-12,
                  "FLIP and APIC lose no spin (%g, %g)", flip, apic);
            claim(fabs(kick / kick_lost(order, cells, PIC) - 1.0) < 1e-9 &&
                      fabs(kick_lost(order, cells, APIC)) < 1e-12,
                  "of a kick FLIP loses as much as PIC (%g), APIC nothing",
                  kick);
            visits[order][k] = 1.0 * n * (order + 1) * (order + 1);
            table_row(kernel[order - 1], cells, PIC_FLOPS * visits[order][k],
                      pic[order][k], FLIP_FLOPS * visits[order][k], kick,
                      APIC_FLOPS * visits[order][k],
                      fabs(apic) < 1e-12 ? 0.0 : apic);
        }
    table_end();
    for (int order = 1; order <= ORDER_MAX; order++)
        claim(APIC_FLOPS * visits[order][0] < PIC_FLOPS * visits[order][1],
              "APIC on the coarsest grid costs less than PIC on the next");
    for (int order = 2; order <= ORDER_MAX; order++)
        for (int k = 0; k < GRIDS; k++)
            claim(pic[order][k] > pic[order - 1][k],
                  "a wider kernel loses more");
    return table_finish();
}
