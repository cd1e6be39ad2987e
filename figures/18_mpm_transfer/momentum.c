/*
 * momentum.c - where is angular momentum lost: on the way to the grid, or back?
 *
 * Seven particles go to the grid and back by each scheme and each kernel; once
 * nothing happens between, once the nodes get a rigid kick.  Angular momentum
 * about 0; B belongs to it in APIC [eq:apic].
 */
#include "particles/particle_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

/* Angular momentum, seven particles: before, on the grid, after a kick there,
 * and back on the particles; kinetic energy before and on the grid. */
struct way {
    double before, grid, kicked, after, kinetic, kinetic_grid;
};
static struct way transfer(int order, enum transfer how, int kick)
{
    const double push[2] = {0.31, -0.47};
    struct cloud c = cloud_seven(order, how);
    struct way way = {.before = particles_moments(c.p).angular,
                      .kinetic = particles_moments(c.p).kinetic};
    claim(grid_p2g(c.grid, c.p) == OK, "all particles are on the grid");
    if (kick) grid_kick(c.grid, push, 1.7);
    way.grid = grid_moments(c.grid, c.grid->v).angular;
    way.kinetic_grid = grid_moments(c.grid, c.grid->v).kinetic;
    way.kicked = grid_moments(c.grid, c.grid->next).angular;
    claim(grid_g2p(c.grid, how, 0.013, c.p) == OK, "and stay there");
    way.after = particles_moments(c.p).angular;
    cloud_free(c);
    return way;
}

int main(void)
{
    static const char *const kernel[] = {"linear", "quadratic", "cubic"};
    double to_grid = 0.0, kept = 0.0, energy = 0.0, pic = 0.0, flip = 0.0;
    table_begin("lost", "kernel scheme before p2g g2p g2p_kicked kinetic_grid");
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int how = PIC; how <= APIC; how++) {
            const struct way still = transfer(order, (enum transfer)how, 0);
            const struct way kick = transfer(order, (enum transfer)how, 1);
            const double lost = still.kicked - still.after;
            const double lost_kicked = kick.kicked - kick.after;
            table_row(kernel[order - 1], transfer_name((enum transfer)how),
                      still.before, still.before - still.grid, lost,
                      lost_kicked, still.kinetic_grid / still.kinetic);
            to_grid = fmax(to_grid, fabs(still.before - still.grid));
            energy = fmax(energy, still.kinetic_grid / still.kinetic);
            if (how == APIC)
                kept = fmax(kept, fmax(fabs(lost), fabs(lost_kicked)));
            if (how == FLIP)
                claim(fabs(lost) < 1e-14, "FLIP loses nothing when nothing "
                      "happens (%g)", lost);
            if (how == PIC && order == 2) pic = still.after;
            if (how == FLIP && order == 2) flip = lost_kicked;
        }
    table_end();
    claim(to_grid < 1e-14, "no scheme loses angular momentum on the way to the "
          "grid (%g)", to_grid);
    claim(kept < 1e-14, "APIC loses none on the way back (%g)", kept);
    claim(fabs(pic - 0.389267052) < 1e-9, "quadratic PIC keeps 0.389267052 of "
          "0.47704535 (%.9f)", pic);
    claim(fabs(flip - 0.146862) < 1e-6, "after the kick quadratic FLIP loses "
          "0.146862 (%.6f)", flip);
    claim(energy < 1.0, "the grid never has more kinetic energy (%g)", energy);
    return table_finish();
}
