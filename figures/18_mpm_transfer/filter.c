/*
 * filter.c - which waves does one transfer let pass?
 *
 * A periodic bar of 48 cells, 4 particles per cell, v = cos kx, one transfer
 * with each kernel; predicted for infinitely many particles [eq:pic-filter].
 * PIC applies this filter once per step and not once per second: a viscosity
 * (p + 1) h^2 / (12 dt), p the order of the kernel.
 */
#include "particles/particle_scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { CELLS = 48, PPC = 4 };

/* What is left of the wave with so many periods after `transfers`. */
static double left(int order, enum transfer how, int periods, int transfers)
{
    const double k = 2.0 * acos(-1.0) * periods / CELLS;
    struct cloud c = cloud_wave(order, CELLS, PPC, k, how);
    for (int i = 0; i < transfers; i++)
        claim(grid_p2g(c.grid, c.p) == OK &&
                  grid_g2p(c.grid, how, 0.0, c.p) == OK,
              "particles stay on the grid");
    const double part = particles_wave_part(c.p, k);
    cloud_free(c);
    return part;
}

int main(void)
{
    static const char *const kernel[] = {"linear", "quadratic", "cubic"};
    const double pi = acos(-1.0);
    double worst = 0.0;
    table_begin("filter", "kernel order wavelength pic pic_predicted apic "
                          "apic_predicted");
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int periods = 1; periods < CELLS / 2; periods++) {
            const double k = 2.0 * pi * periods / CELLS;
            const double pic = left(order, PIC, periods, 1);
            const double due = transfer_factor(order, PIC, k);
            table_row(kernel[order - 1], order, (double)CELLS / periods, pic,
                      due, left(order, APIC, periods, 1),
                      cell_if(order > 1, transfer_factor(order, APIC, k)));
            if (order > 1 && periods <= CELLS / 4)
                worst = fmax(worst, fabs(pic - due));
        }
    table_end();
    claim(worst < 5e-4, "from four cells on the prediction is right to 0.0005 "
          "(%g)", worst);

    /* a wave of 16 cells, for a time of 8 courses through a cell; and what a
     * viscosity nu would leave, exp(-nu k^2 t) */
    const double k = 2.0 * pi / 16.0, time = 8.0;
    double pic[4];
    table_begin("steps", "dt transfers pic viscosity flip apic");
    for (int i = 0; i < 4; i++) {
        const int transfers = 8 << 2 * i;
        const double dt = time / transfers, nu = 3.0 / (12.0 * dt);
        pic[i] = left(2, PIC, 3, transfers);
        table_row(dt, transfers, pic[i], exp(-nu * k * k * time),
                  left(2, FLIP, 3, transfers), left(2, APIC, 3, transfers));
        claim(fabs(log(pic[i]) / (-nu * k * k * time) - 1.0) < 0.02,
              "PIC is a viscosity (%g left)", pic[i]);
        claim(i == 0 || fabs(log(pic[i]) / log(pic[i - 1]) - 4.0) < 0.01,
              "a quarter of the step, four times the viscosity");
    }
    table_end();
    return table_finish();
}
