/*
 * bifurcation.c - elements are indefinite from the first bit of compression;
 * when is the body?
 *
 * Tables: the load up to which K of the straight column is positive definite,
 * by mesh, beside Euler's; the straight branch and the buckled one of 80 x 8
 * squares; the shape at the last load.
 */
#include "plane/scene.h"
#include "../13_backward_euler_2d/corners.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

static struct scene *column(int n)
{
    const struct scene_setting set = scene_column(CUBIC, n, 0.0);
    return scene_alloc(&set);
}

/* By halving between a load that it bears and one that it does not. */
static double critical(int n)
{
    struct scene *s = column(n);
    double low = 0.01, high = 0.1;
    while (high - low > 1e-6) {
        const double e = 0.5 * (low + high);
        (scene_walk(s, "notes", e, 0.0).status == OK ? &low : &high)[0] = e;
    }
    scene_free(s);
    return low;
}

int main(void)
{
    const double Euler = M_PI * M_PI / 300.0;
    double bears[3];
    table_begin_note("critical", "cells rows bears", "Euler %.6f", Euler);
    for (int k = 0; k < 3; k++) {
        bears[k] = critical(20 << k);
        table_row(20 << k, 2 << k, bears[k]);
    }
    table_end();

    struct scene *up = column(80), *flat = column(80);
    table_begin("branches", "load buckled straight stable energy_buckled "
                            "energy_straight");
    for (int k = 0; k <= 30; k++) {
        const double e = 0.02 + 0.001 * k;
        const enum status straight = scene_walk(flat, "notes", e, 0.0).status;
        scene_walk(up, "demand+search", e, 1e-3);
        const double bent[] = {fabs(*scene_middle(up)),
                               fabs(*scene_middle(flat))};
        table_row(e, bent[0] > 1e-9 ? bent[0] : 0.0,
                  bent[1] > 1e-9 ? bent[1] : 0.0,
                  straight == OK ? "stable" : "saddle", scene_energy(up),
                  scene_energy(flat));
    }
    table_end();
    table_begin("shape", "x0 y0 x1 y1 x2 y2 negative");
    for (int t = 0; t < up->mesh->n_triangle; t++) {
        double x[6];
        const double J = corners_of(up, t, x);
        table_row(x[0], x[1], x[2], x[3], x[4], x[5], J < 1.0 ? "yes" : "no");
    }
    table_end();
    scene_free(up);
    scene_free(flat);

    claim(fabs(bears[2] - 0.03418750189058484) < 2e-6 &&
              fabs(bears[0] - 0.06212949317507448) < 2e-6 &&
              bears[2] > Euler && bears[2] < bears[1],
          "the column bears %.5f, and less the finer the mesh, towards Euler's "
          "%.5f", bears[2], Euler);
    return table_finish();
}
