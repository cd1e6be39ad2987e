/*
 * kernels.c - what do the three kernels look like, and what does a node feel
 * when a particle crosses into another cell?
 *
 * Weight N and slope h dN/dx of one node for a particle at t cells from it
 * [eq:bspline].  The force that a particle puts on a node is its stress times
 * the slope: where the slope jumps, so does the force.  Beside it the trap: the
 * quadratic pieces with the wrong first node, floor(x/h).
 */
#include "particles/particles.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { PER_CELL = 200, MIDDLE = 5 };

/* Weight and slope of node MIDDLE for a particle at MIDDLE + t. */
static void at(int order, double t, double *w, double *dw)
{
    double all[ORDER_MAX + 1], slope[ORDER_MAX + 1];
    const int q = MIDDLE - kernel_weights(order, 1.0, MIDDLE + t, all, slope);
    *w = q >= 0 && q <= order ? all[q] : 0.0;
    *dw = q >= 0 && q <= order ? slope[q] : 0.0;
}

/* The same with the pieces of order 2 and the first node floor(x/h). */
static double trap(double t)
{
    const double cell = floor(t), f = t - cell;
    const double w[] = {0.5 * (1.5 - f) * (1.5 - f),
                        0.75 - (f - 1.0) * (f - 1.0),
                        0.5 * (f - 0.5) * (f - 0.5)};
    const int q = (int)-cell;
    return q >= 0 && q <= 2 ? w[q] : 0.0;
}

int main(void)
{
    double jump[ORDER_MAX + 1] = {0.0}, least = 0.0, w, dw;
    table_begin("kernels", "t N_1 dN_1 N_2 dN_2 N_3 dN_3 trap");
    for (int i = -2 * PER_CELL; i <= 2 * PER_CELL; i++) {
        double row[8];
        row[0] = (i + 0.5) / PER_CELL;
        for (int order = 1; order <= ORDER_MAX; order++)
            at(order, row[0], &row[2 * order - 1], &row[2 * order]);
        row[7] = trap(row[0]);
        least = fmin(least, row[7]);
        table_row_of(8, row);
    }
    table_end();

    table_begin("jumps", "order nodes weight_jump slope_jump");
    for (int order = 1; order <= ORDER_MAX; order++) {
        double most = 0.0;
        for (int half = -4; half <= 4; half++) {
            double left, slope;
            at(order, 0.5 * half - 1e-9, &left, &slope);
            at(order, 0.5 * half + 1e-9, &w, &dw);
            most = fmax(most, fabs(w - left));
            jump[order] = fmax(jump[order], fabs(dw - slope));
        }
        table_row(order, (order + 1) * (order + 1), most, jump[order]);
        claim(most < 1e-8, "the weights are continuous (%g)", most);
    }
    table_end();
    claim(fabs(jump[1] - 2.0) < 1e-8, "the linear slope jumps by 2 at its node "
          "(%g)", jump[1]);
    claim(jump[2] < 1e-8 && jump[3] < 1e-8, "the others have no jump (%g, %g)",
          jump[2], jump[3]);
    claim(fabs(least + 0.25) < 0.01, "with the wrong first node a weight is "
          "as low as -1/4 (%g)", least);
    return table_finish();
}
