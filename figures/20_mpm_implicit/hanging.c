/*
 * hanging.c - the bar hung by its end, by particles and by finite elements.
 *
 * 500 N/m stretch it to 1.544 at the wall.  `once` puts all of the load on in
 * one step, on one grid, as finite elements do; `reset` takes ten steps, and
 * each begins with a new grid.  The error is the worst of all particles, or of
 * the middles of all elements [eq:hanging-bar]; the work, what a loop over the
 * particles visits: particles times nodes per particle.
 */
#include "whole_step.h"
#include "bar/bar_scene.h"
#include "step_flops.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { FINEST = 4 }; /* 8, 16, 32, 64 cells */

/* Flops of a Newton iteration per cell of 64. */
static double iteration(int order, int ppc)
{
    const struct matrix_cost cost = matrix_cost(BANDED, 64, order);
    return (cost.flops + cost.solve) / 64.0 + step_flops_look(order, ppc) +
           step_flops_tangent(order, ppc);
}

/* The worst place of particles; NAN where a step ends with another status.
 * Each stands in the middle of `among` (odd), of which the others have no mass:
 * they only follow the nodes, and tell the error between the particles. */
static double particles_error(int order, int cells, int ppc, int among,
                              enum wall wall, int loads, enum status *status)
{
    const struct material material = material_notes(CUBIC);
    struct cloud c = cloud_hanging(order, cells, among * ppc);
    struct particle_step step = {.wall = wall};
    for (int q = 0; q < c.p->n; q++) {
        const double share = q % among == among / 2 ? among : 0.0;
        c.p->mass[q] *= share;
        c.p->volume[q] *= share;
    }
    *status = OK;
    for (int k = 1; k <= loads && *status == OK; k++) {
        step.g[0] = 500.0 * k / loads;
        *status = particles_step(c.grid, c.p, material, &step).status;
    }
    const double error = hanging_error(c.p, &material, 500.0).place;
    cloud_free(c);
    return *status == OK ? error : NAN;
}

static double elements_error(int cells)
{
    struct bar_scene scene = bar_scene_notes(CUBIC, cells);
    scene.c = 500.0;
    struct bar_state *state = bar_scene_solve(&scene, NULL);
    double worst = 0.0, F;
    for (int e = 0; e < cells; e++) {
        const double X = (e + 0.5) / cells;
        const double x = X + 0.5 * (state->u[e] + state->u[e + 1]);
        const double exact = hanging_place(&scene.material, 500.0, X, &F);
        worst = fmax(worst, fabs(x - exact));
    }
    bar_state_free(state);
    return worst;
}

/* Of 16 cells with the mirror, over the error of 16 elements. */
static double anywhere(int order, int ppc, int loads, double elements)
{
    enum status status;
    return particles_error(order, 16, ppc, 31, MIRROR, loads, &status) /
           elements;
}

/* The elements' error is that of their middles, where it is largest. */
static void claim_anywhere(double elements)
{
    claim(fabs(anywhere(1, 2, 1, elements) - 1.0) < 1e-3,
          "anywhere, the linear kernel has the error of the elements");
    claim(fabs(anywhere(3, 2, 1, elements) - 0.297) < 1e-3 &&
              fabs(anywhere(3, 4, 10, elements) - 0.207) < 1e-3 &&
              anywhere(3, 2, 10, elements) > 15.0,
          "cubic, anywhere: 0.30 of it, 0.21 with ten grids and four per cell, "
          "more than 15 times with two");
}

/* A row for every number of cells; error[] of them. */
static void rows(int order, int ppc, enum wall wall, int loads, double error[])
{
    static const char *const kernel[] = {"linear", "quadratic", "cubic"};
    for (int k = 0; k < FINEST; k++) {
        const int cells = 8 << k;
        enum status status;
        error[k] = particles_error(order, cells, ppc, 1, wall, loads, &status);
        const double slope =
            k > 0 ? study_order(error[k - 1], error[k], 2.0) : NAN;
        table_row(kernel[order - 1], ppc, wall_name(wall), cells,
                  (double)cells * ppc * (order + 1),
                  cell_if(status == OK, error[k]),
                  cell_if(isfinite(slope), slope), status_name(status));
    }
}

int main(void)
{
    double fem[FINEST], once[4][FINEST], held[4][FINEST], two[4][FINEST];
    double four[4][FINEST];
    const char *const columns = "kernel ppc wall cells work error order status";
    table_begin("elements", "cells work error order");
    for (int k = 0; k < FINEST; k++) {
        fem[k] = elements_error(8 << k);
        table_row(8 << k, 2 * (8 << k), fem[k],
                  cell_if(k > 0, study_order(fem[k ? k - 1 : 0], fem[k], 2.0)));
    }
    table_end();
    table_begin("once", columns);
    for (int p = 1; p <= 3; p++) rows(p, 2, MIRROR, 1, once[p]);
    for (int p = 2; p <= 3; p++) rows(p, 2, HELD, 1, held[p]);
    table_end();
    table_begin("reset", columns);
    for (int p = 1; p <= 3; p++) rows(p, 2, MIRROR, 10, two[p]);
    for (int p = 1; p <= 3; p++) rows(p, 4, MIRROR, 10, four[p]);
    table_end();

    for (int k = 1; k < FINEST; k++) {
        claim(fabs(study_order(fem[k - 1], fem[k], 2.0) - 2.0) < 0.02,
              "finite elements have order 2");
        for (int p = 1; p <= 3; p++)
            claim(fabs(study_order(once[p][k - 1], once[p][k], 2.0) - 2.0) <
                      0.03,
                  "on one grid order-%d particles have order 2", p);
        for (int p = 2; p <= 3; p++)
            claim(fabs(study_order(held[p][k - 1], held[p][k], 2.0) - 1.0) <
                      0.03,
                  "with held nodes order 1 is left");
        claim(four[1][k] > 3e-2 && four[1][k] < 5e-2, "the linear kernel with "
              "four per cell stays at 4 per cent");
    }
    claim(isnan(two[1][1]) && isnan(two[1][3]),
          "with two per cell it ends with a named status");
    for (int k = 1; k < FINEST; k++)
        claim(fabs(four[2][k] / 3e-4 - 1.0) < 0.25 && two[2][k] > two[2][0] &&
                  two[3][k] < two[3][k - 1] && four[3][k] < four[3][k - 1],
              "the quadratic kernel stops at 3e-4, the cubic one goes on");
    claim(fabs(two[3][1] / fem[1] - 7.0) < 0.5,
          "cubic, two per cell: seven times the error of 16 elements");
    /* The middle of a chord is 1/8 F' h^2 from the curve, a quarter 3/32. */
    for (int k = 0; k < FINEST; k++)
        claim(fabs(once[1][k] / fem[k] - 0.75) < 3e-3, "linear: as a chord");
    claim_anywhere(fem[1]);
    enum status status;
    const double near = particles_error(3, 16, 4, 1, MIRROR, 1, &status);
    claim(fabs(four[3][1] / near - 0.59) < 0.01 && fabs(near - 1.11e-4) < 1e-6,
          "cubic, four per cell: ten grids have 0.59 of the error of one");
    claim(fabs(iteration(3, 2) / iteration(1, 1) - 5.0) < 0.1, "an iteration "
          "with the cubic kernel costs five times as much as with elements");
    claim(held[2][3] / once[2][3] > 300.0,
          "the mirror is 300 times better at 64 cells");
    return table_finish();
}
