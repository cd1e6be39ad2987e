/*
 * block.c - a block of 16 particles that falls and turns, in implicit steps.
 *
 * It is strained and turns at the start; 18 steps of 1/60 s, quadratic kernel.
 * Nothing holds it, so that its centre falls exactly as backward Euler lets a
 * point fall, y = y_0 + k dt v_0 - g dt^2 k (k + 1) / 2, whatever the scheme.
 * L is its angular momentum about its centre.
 */
#include "whole_step.h"
#include "particles/particle_bodies.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { STEPS = 18, EACH = 6 };

/* The particles on the edge of the block, once around. */
static const int EDGE[] = {0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4, 0};

static void centre(const struct particles *p, double x[2])
{
    x[0] = x[1] = 0.0;
    for (int q = 0; q < 2 * p->n; q++) x[q % 2] += p->x[q] / p->n;
}

static double turning(const struct particles *p)
{
    const struct moments of = particles_moments(p);
    double x[2];
    centre(p, x);
    return of.angular - x[0] * of.momentum[1] + x[1] * of.momentum[0];
}

int main(void)
{
    const double dt = 1.0 / 60.0, g = 9.81;
    double kept[3] = {0.0};
    table_begin("outline", "scheme t x y L");
    for (int s = PIC; s <= FLIP; s++) {
        const struct particle_step step = {
            .rate = 1.0 / dt, .g = {0.0, -g}, .transfer = (enum transfer)s};
        struct cloud c = cloud_block(2);
        const struct moments start = particles_moments(c.p);
        const double L = turning(c.p);
        double from[2], at[2];
        centre(c.p, from);
        for (int k = 0; k <= STEPS; k++) {
            if (k % EACH == 0)
                for (int i = 0; i < 13; i++)
                    table_row(transfer_name((enum transfer)s), k * dt,
                              c.p->x[2 * EDGE[i]], c.p->x[2 * EDGE[i] + 1],
                              turning(c.p));
            centre(c.p, at);
            for (int i = 0; i < 2; i++)
                claim(fabs(at[i] - from[i] -
                           k * dt * start.momentum[i] / start.mass +
                           (i ? 0.5 * g * dt * dt * k * (k + 1) : 0.0)) < 1e-9,
                      "the centre falls as a point does");
            claim(k == STEPS || particles_step(c.grid, c.p,
                                               material_notes(CUBIC),
                                               &step).status == OK, "solved");
        }
        kept[s] = turning(c.p) / L;
        cloud_free(c);
    }
    table_end();
    table_begin("turning", "scheme kept");
    for (int s = PIC; s <= FLIP; s++)
        table_row(transfer_name((enum transfer)s), kept[s]);
    table_end();
    claim(fabs(kept[PIC]) < fabs(kept[FLIP]), "PIC keeps less of its turning");
    return table_finish();
}
