/*
 * energy.c - which smaller steps make worse answers?
 *
 * A free bar of 8 cells rings in its first mode for one period, 2 / c; the
 * energy that is left, kinetic of the particles and elastic, over that at the
 * start.  Quadratic kernel, two particles per cell, explicit and implicit steps
 * of PIC, FLIP and APIC (whose B is not counted), and finite elements by
 * backward Euler.  Steps in h / c.  `price`: the cheapest explicit and the
 * cheapest implicit steps of particles that lose at most so much, in flops.
 */
#include "step_flops.h"
#include "motion/integrate.h"
#include "particles/particle_bodies.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = 8, SIZES = 7 };
static const double COURANT[SIZES] = {2.0,  1.2, 0.8, 0.4, 0.2, 0.1, 0.05};

static double energy(const struct particles *p, const struct material *m)
{
    return particles_moments(p).kinetic + particles_elastic(p, m);
}

/* What is left; NAN where a step fails, or where the energy has grown. */
static double left(enum transfer transfer, int implicit, double courant,
                   int *steps, const char **how, double *flops)
{
    const struct material m = material_notes(CUBIC);
    const double c = sqrt(material_modulus(&m));
    struct cloud bar = cloud_ringing(2, CELLS, 0.02 * c, transfer);
    *steps = (int)lround(2.0 * CELLS / courant);
    const struct particle_step step = {.rate = *steps * c / 2.0,
                                       .transfer = transfer};
    const double start = energy(bar.p, &m);
    enum status status = OK;
    *flops = 0.0;
    for (int k = 0; k < *steps && status == OK; k++) {
        if (!implicit) {
            status = particles_step_explicit(bar.grid, bar.p, m, &step);
            *flops += step_flops_explicit(bar);
            continue;
        }
        const struct particle_report report =
            particles_step(bar.grid, bar.p, m, &step);
        status = report.status;
        *flops += step_flops_implicit(bar, m, NO_WALL, &report);
    }
    const double ratio = energy(bar.p, &m) / start;
    *how = status != OK ? status_name(status) : ratio > 1.1 ? "unstable" : "OK";
    cloud_free(bar);
    return status == OK && ratio <= 1.1 ? ratio : NAN;
}

/* Finite elements with a lumped mass: 8 elements, by backward Euler.  The bar
 * is linear, and a free bar in its first mode is two bars held in the middle.
 */
static double elements_left(double courant)
{
    struct model *bar = model_bar(CELLS / 2, LUMPED);
    const double h = 1.0 / (CELLS / 2), pi = acos(-1.0);
    const int steps = (int)lround(2.0 * CELLS / courant);
    const double c = sqrt(bar->A->a[0] * h / 2.0);
    const double dt = 4.0 / c / steps;
    double u[CELLS] = {0.0}, v[CELLS], q[CELLS], w[CELLS];
    for (int a = 0; a < bar->n_dof; a++) v[a] = sin(0.5 * pi * (a + 1) * h);
    const double start = model_energy(bar, u, v);
    for (int k = 0; k < steps; k++) {
        /* q at u: M (u - u - dt v) + dt^2 A u */
        model_mass(bar, v, w);
        claim(model_force(bar, u, q) == OK, "linear");
        for (int a = 0; a < bar->n_dof; a++)
            q[a] = dt * dt * q[a] - dt * w[a];
        claim(model_newton(bar, dt, q).status == OK, "definite");
        for (int a = 0; a < bar->n_dof; a++) {
            u[a] += q[a];
            v[a] = q[a] / dt;
        }
    }
    const double ratio = model_energy(bar, u, v) / start;
    model_free(bar);
    return ratio;
}

/* The cheapest of implicit or explicit steps that lose `lost` at most: three
 * cells of a row, the scheme, the steps and the flops. */
static double cheapest(double lost, double kept[3][SIZES],
                       double flops[3][SIZES], struct cell row[3])
{
    double least = INFINITY;
    row[0] = row[1] = row[2] = CELL(MISSING);
    for (int s = PIC; s <= APIC; s++)
        for (int k = 0; k < SIZES; k++) {
            if (!(fabs(1.0 - kept[s][k]) <= lost && flops[s][k] < least))
                continue;
            least = flops[s][k];
            row[0] = CELL(transfer_name((enum transfer)s));
            row[1] = CELL((int)lround(2.0 * CELLS / COURANT[k]));
            row[2] = CELL(least);
        }
    return least;
}

int main(void)
{
    const double wanted[4] = {0.4, 0.15, 0.05, 0.02};
    double kept[2][3][SIZES], flops[2][3][SIZES], fem[SIZES];
    table_begin("energy", "step scheme courant steps left lost status");
    for (int implicit = 0; implicit < 2; implicit++)
        for (int s = PIC; s <= APIC; s++)
            for (int k = 0; k < SIZES; k++) {
                int steps;
                const char *how;
                const double e =
                    left((enum transfer)s, implicit, COURANT[k], &steps, &how,
                         &flops[implicit][s][k]);
                kept[implicit][s][k] = e;
                table_row(implicit ? "implicit" : "explicit",
                          transfer_name((enum transfer)s), COURANT[k], steps,
                          cell_if(isfinite(e), e),
                          cell_if(isfinite(e), fabs(1.0 - e)), how);
            }
    table_end();
    table_begin("elements", "courant steps left lost");
    for (int k = 0; k < SIZES; k++) {
        fem[k] = elements_left(COURANT[k]);
        table_row(COURANT[k], (int)lround(2.0 * CELLS / COURANT[k]), fem[k],
                  1.0 - fem[k]);
    }
    table_end();
    table_begin("price", "lost explicit explicit_steps explicit_flops implicit "
                         "implicit_steps implicit_flops");
    for (int k = 0; k < 4; k++) {
        struct cell row[7] = {CELL(wanted[k])};
        const double freely = cheapest(wanted[k], kept[0], flops[0], &row[1]);
        const double solving = cheapest(wanted[k], kept[1], flops[1], &row[4]);
        table_row_of(7, row);
        claim(solving > 10.0 * freely,
              "for a vibration implicit steps cost ten times as much, or more");
    }
    table_end();
    for (int k = 4; k < SIZES; k++) {
        claim(kept[0][PIC][k] < kept[0][PIC][k - 1] &&
                  kept[1][PIC][k] < kept[1][PIC][k - 1],
              "PIC loses more in smaller steps");
        claim(kept[1][FLIP][k] > kept[1][FLIP][k - 1], "implicit FLIP less");
    }
    claim(kept[0][PIC][5] < 0.005 && kept[0][FLIP][5] > 0.97,
          "at a tenth PIC keeps 0.4 per cent, FLIP 98");
    for (int k = 3; k < SIZES; k++)
        claim(fabs(kept[1][FLIP][k] - fem[k]) < 0.012,
              "implicit FLIP keeps what implicit finite elements keep (%g, %g)",
              kept[1][FLIP][k], fem[k]);
    claim(isnan(kept[0][FLIP][0]) && isfinite(kept[1][FLIP][0]),
          "twice the limit: explicit fails, implicit does not");
    return table_finish();
}
