/*
 * cost.c - what does the error of a strain cost, when a body bends?
 *
 * A strip of 4 m by 1 m is bent into an arc, F = R diag(1 - Y k, 1) with the
 * curvature k; its ends then lean by `lean` degrees.  On n x 4n cells the
 * triangles have the linear [eq:linear-strain] or the Green strain
 * [eq:green-strain], to compare with the Green strain of the arc at their
 * centres.  Table: error (root mean square, relative to that strain's), the
 * operations + - x / of the mesh, and what the linear strain of the arc itself
 * is off by, which no mesh mends.
 */
#include "../study/study.h"
#include "base/table.h"
#include "material/tensor.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { LINEAR_STRAIN, GREEN_STRAIN, STRAINS };
static const char *const NAME[STRAINS] = {"linear", "green"};
/* F from D_s and D_m^-1: four differences, and a product of twelve; then the
 * strain: sums and halves, or three products of columns. */
static const int OPERATIONS[STRAINS] = {16 + 4, 16 + 14};
static const double LENGTH = 4.0, HEIGHT = 1.0;

static void bend(double k, const double X[2], double x[2])
{
    x[0] = sin(k * X[0]) / k - X[1] * sin(k * X[0]);
    x[1] = (1.0 - cos(k * X[0])) / k + X[1] * cos(k * X[0]);
}

static mat2 strain(int which, mat2 F)
{
    const mat2 T = mat2_transpose(F), I = mat2_identity();
    return mat2_scale(0.5, which == GREEN_STRAIN
                               ? mat2_subtract(mat2_multiply(T, F), I)
                               : mat2_subtract(mat2_add(F, T),
                                               mat2_scale(2.0, I)));
}

/* The Green strain of the arc, in closed form, and how far its linear strain is
 * off, at X. */
static mat2 arc_strain(double k, const double X[2], mat2 *off)
{
    const double stretch = 1.0 - k * X[1];
    const mat2 U = {{{stretch, 0.0}, {0.0, 1.0}}};
    const mat2 G = {{{0.5 * (stretch * stretch - 1.0), 0.0}, {0.0, 0.0}}};
    const mat2 F = mat2_multiply(mat2_rotation(k * X[0]), U);
    *off = mat2_subtract(strain(LINEAR_STRAIN, F), G);
    return G;
}

/* Add the squares of the errors of the triangle with the corner X and edges
 * along X1 and X2, and of the strain that it should have. */
static void add_triangle(double k, const double X[2], const double edge[2],
                         double sum[STRAINS + 1], double *size)
{
    const double A[2] = {X[0] + edge[0], X[1]}, B[2] = {X[0], X[1] + edge[1]};
    const double centre[2] = {X[0] + edge[0] / 3.0, X[1] + edge[1] / 3.0};
    double x[2], a[2], b[2];
    mat2 F, off;
    bend(k, X, x);
    bend(k, A, a);
    bend(k, B, b);
    for (int i = 0; i < 2; i++) { /* the edges at rest lie along the axes */
        F.m[i][0] = (a[i] - x[i]) / edge[0];
        F.m[i][1] = (b[i] - x[i]) / edge[1];
    }
    const mat2 exact = arc_strain(k, centre, &off);
    for (int w = 0; w < STRAINS; w++) {
        const mat2 miss = mat2_subtract(strain(w, F), exact);
        sum[w] += mat2_dot(miss, miss);
    }
    sum[STRAINS] += mat2_dot(off, off);
    *size += mat2_dot(exact, exact);
}

/* error[which] of the mesh, error[STRAINS] of the arc's linear strain. */
static void errors(int n, double k, double error[STRAINS + 1])
{
    const double h[2] = {LENGTH / (4 * n), HEIGHT / n};
    double sum[STRAINS + 1] = {0.0}, size = 0.0;

    for (int j = 0; j < n; j++)
        for (int i = 0; i < 4 * n; i++)
            for (int up = 1; up >= -1; up -= 2) {
                /* the corner at the right angle, from which edges go up */
                const double X[2] = {(i + (up < 0)) * h[0] - 0.5 * LENGTH,
                                     (j + (up < 0)) * h[1] - 0.5 * HEIGHT};
                const double edge[2] = {up * h[0], up * h[1]};
                add_triangle(k, X, edge, sum, &size);
            }
    for (int w = 0; w <= STRAINS; w++) error[w] = sqrt(sum[w] / size);
}

int main(void)
{
    const int lean[] = {5, 45};
    double error[STRAINS + 1], before = 0.0, least = INFINITY, order = 0.0;

    table_begin("cost", "lean strain n operations error floor");
    for (int k = 0; k < 2; k++)
        for (int w = 0; w < STRAINS; w++)
            for (int n = 2; n <= 64; n *= 2) {
                const double angle = lean[k] * M_PI / 180.0;
                errors(n, angle / (0.5 * LENGTH), error);
                table_row(lean[k], NAME[w], n, 8.0 * n * n * OPERATIONS[w],
                          error[w], cell_if(w == LINEAR_STRAIN, error[2]));
                if (w == LINEAR_STRAIN)
                    least = fmin(least, error[w] / error[2]);
                order = study_order(before, error[w], 2.0);
                before = error[w];
                claim(w == LINEAR_STRAIN || n < 32 || fabs(order - 1.0) < 0.02,
                      "the Green strain is of order one (%g)", order);
            }
    table_end();
    claim(least > 0.98, "no mesh brings the linear strain below what it is "
          "off by on the arc (%g of it)", least);
    return table_finish();
}
