/*
 * price.c - does a wider kernel or a finer grid keep more of a turning disc,
 * and what does it cost?
 *
 * The disc of disc.c: what PIC and APIC lose of its angular momentum in a
 * hundred transfers, for three kernels and three grids.  The price is how often
 * a particle visits a node on one way, there or back.
 */
#include "particles/particle_scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum { TRANSFERS_MADE = 100, GRIDS = 3 };

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

int main(void)
{
    const char *const kernel[] = {"linear", "quadratic", "cubic"};
    double pic[ORDER_MAX + 1][GRIDS];
    table_begin("price", "kernel cells visits pic_lost");
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int k = 0; k < GRIDS; k++) {
            int n;
            pic[order][k] = lost(order, 16 << k, PIC, &n);
            table_row(kernel[order - 1], 16 << k,
                      n * (order + 1) * (order + 1), pic[order][k]);
            const double apic = lost(order, 16 << k, APIC, &n);
            claim(fabs(apic) < 1e-12, "APIC loses no spin (%g)", apic);
        }
    table_end();
    for (int order = 2; order <= ORDER_MAX; order++)
        for (int k = 0; k < GRIDS; k++)
            claim(pic[order][k] > pic[order - 1][k],
                  "a wider kernel loses more");
    return table_finish();
}
