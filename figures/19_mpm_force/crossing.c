/*
 * crossing.c - what do particles leave over of a stress that is the same
 * everywhere, once they have left their cells?
 *
 * No inner node of such a bar should feel a force.  With the spacing s of the
 * particles, in cells, a node at theta feels the stress times sum_k s N'(s (k +
 * theta)), which by Poisson summation is the sum over m = 1, 2, ... of
 *
 *     4 z S(z)^(p + 1) sin(2 pi m theta),  z = pi m / s,  S = sin z / z
 *                                                     [eq:cell-crossing]
 */
#include "particles/particle_force.h"
#include "particles/particle_scene.h"
#include "linear/matrix.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = 8, SHIFTS = 25, MODES = 200, PLACES = 300 };
static const char *const KERNEL[] = {"linear", "quadratic", "cubic"};

/* Force over stress and acceleration of a bar stretched F times. */
static struct inner left_over(int order, int cells, int ppc, double F,
                              double shift)
{
    const struct material cubic = material_notes(CUBIC);
    struct cloud bar = cloud_bar(order, cells, ppc, F, shift);
    const struct particle_body body = {bar.grid, bar.p, cubic, NULL};
    const size_t n = 2 * (size_t)bar.grid->n_node;
    double *u = allocate(n, sizeof *u), *f = allocate(n, sizeof *f);
    claim(particle_force(&body, u, f) == OK, "the bar is on its grid");
    struct inner inner = cloud_bar_inner(bar, f);
    inner.force /= fabs(material1_pk1(&cubic, F));
    free(u);
    free(f);
    cloud_free(bar);
    return inner;
}

/* The largest one, wherever the particles are. */
static double worst_shift(int order, int ppc, double F)
{
    double worst = 0.0;
    for (int i = 0; i < SHIFTS; i++)
        worst = fmax(
            worst,
            left_over(order, CELLS, ppc, F, fmod(0.6180339887 * i, 1.0)).force);
    return worst;
}

/* What Poisson summation says: its first `modes` terms at the worst theta. */
static double predicted(int order, double s, int modes)
{
    double size[MODES], worst = 0.0;
    for (int m = 1; m <= modes; m++) {
        const double z = acos(-1.0) * m / s;
        size[m - 1] = 4.0 * z * pow(sin(z) / z, order + 1);
    }
    for (int i = 0; i < PLACES; i++) {
        double sum = 0.0;
        for (int m = 1; m <= modes; m++)
            sum += size[m - 1] * sin(2.0 * acos(-1.0) * m * i / PLACES);
        worst = fmax(worst, fabs(sum));
    }
    return worst;
}

/* Flops of one linear system of an implicit step per cell of the plane, of n by
 * n: what step_flops.h of lesson 20 counts, here with two components, and a
 * factorisation in a band. */
static double system_flops(int order, int particles_per_axis, int n)
{
    const double nodes = (order + 1) * (order + 1);
    const struct matrix_cost band =
        matrix_cost(BANDED, 2 * n * n, 2 * order * (n + 1) + 1);
    return particles_per_axis * particles_per_axis *
               (34.0 * nodes + 17.0 * nodes * nodes) +
           band.flops / n / n;
}

int main(void)
{
    double far = 0.0, none = 0.0, before[ORDER_MAX] = {0.0}, old[ORDER_MAX];
    table_begin("spacing", "kernel order s measured predicted first_mode");
    for (int order = 1; order <= ORDER_MAX; order++)
        for (double s = 0.103; s < 1.4; s *= 1.021) {
            const int ppc = (int)ceil(1.05 / s); /* so that F is not 1 */
            const double measured = worst_shift(order, ppc, s * ppc);
            const double series = predicted(order, s, MODES);
            table_row(KERNEL[order - 1], order, s, measured,
                      cell_if(order > 1, series), predicted(order, s, 1));
            if (order > 1)
                far = fmax(far, fabs(measured - series) / pow(s, order));
        }
    table_end();
    claim(far < 0.03, "predicted to 3 %% of s^p, at 25 places (%g)", far);
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int k = 2; k <= 8; k *= 2)
            none = fmax(none, worst_shift(order, 2 * k, 2.0));
    claim(none < 1e-12, "nothing is left over at s = 1/k (%g)", none);

    table_begin("ppc", "ppc linear quadratic cubic linear_order "
                       "quadratic_order cubic_order");
    for (int ppc = 2; ppc <= 16; ppc *= 2) {
        double worst[ORDER_MAX] = {0.0}, rate[ORDER_MAX];
        for (int order = 1; order <= ORDER_MAX; order++) {
            for (double F = 0.71; F < 1.96; F += 0.041)
                worst[order - 1] =
                    fmax(worst[order - 1], worst_shift(order, ppc, F));
            rate[order - 1] =
                study_order(before[order - 1], worst[order - 1], 2);
            before[order - 1] = worst[order - 1];
            claim(ppc < 16 || fabs(rate[order - 1] - order) < 0.3,
                  "order %d in the spacing (%g)", order, rate[order - 1]);
        }
        table_row(ppc, worst[0], worst[1], worst[2], cell_if(ppc > 2, rate[0]),
                  cell_if(ppc > 2, rate[1]), cell_if(ppc > 2, rate[2]));
    }
    table_end();

    int n = 8; /* cells across, until the linear kernel is no longer dearer */
    while (system_flops(1, 50, n) > system_flops(ORDER_MAX, 2, n)) n++;
    claim(n > 123 && n < 128, "the cubic kernel is dearer from %d cells on", n);

    table_begin("refine", "cells h linear quadratic cubic");
    for (int cells = 8; cells <= 128; cells *= 2) {
        double now[ORDER_MAX];
        for (int k = 0; k < ORDER_MAX; k++) {
            now[k] = left_over(k + 1, cells, 2, 1.385, 0.0137).acceleration;
            claim(cells == 8 || fabs(now[k] / old[k] - 2.0) < 0.02,
                  "half the h, twice the acceleration");
            old[k] = now[k];
        }
        table_row(cells, 1.0 / cells, now[0], now[1], now[2]);
    }
    table_end();
    return table_finish();
}
