/*
 * meshes.c - does J > 0 on every triangle mean that nothing overlaps?
 *
 * square: (-1, 1)^2 pushed inside by 1.05, as in push.c.  strip: 6 m by 0.6 m,
 * the middle 3 m of it bent into an arc, J = 1 - Y angle / 3; its tails cross.
 */
#include "base/status.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

enum { MOST = 720 };
struct triangles {
    int n;
    double X[6 * MOST], x[6 * MOST]; /* corners, before and after */
};

/* (-a, a) x (-b, b) in nx x ny cells, cut by diagonals that are all alike, as
 * in mesh.h, or take turns. */
static void cut(struct triangles *t, double a, double b, int nx, int ny,
                int turns)
{
    /* of the two triangles of a cell, as steps along x and y */
    static const int corner[2][6][2] = {
        {{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}, {0, 1}},
        {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 1}}};
    double *X = t->X;

    t->n = 2 * nx * ny;
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++)
            for (int k = 0; k < 6; k++) {
                const int *c = corner[turns ? (i + j) % 2 : 0][k];
                *X++ = a * (2.0 * (i + c[0]) / nx - 1.0);
                *X++ = b * (2.0 * (j + c[1]) / ny - 1.0);
            }
}

static void push(double s, const double X[2], double x[2])
{
    const double p = 1.0 - X[0] * X[0], q = 1.0 - X[1] * X[1];
    x[0] = X[0] + s * p * p * q * q;
    x[1] = X[1];
}

/* The arc turns by `angle` (radians, > 0); lines across the strip stay straight
 * and keep their length. */
static const double arc = 3.0, half_width = 0.3;
static void bend(double angle, const double X[2], double x[2])
{
    const double curvature = angle / arc;
    const double s = fmax(-0.5 * arc, fmin(0.5 * arc, X[0]));
    const double c = cos(curvature * s), d = sin(curvature * s);
    x[0] = d / curvature + (X[0] - s) * c - X[1] * d;
    x[1] = (1.0 - c) / curvature + (X[0] - s) * d + X[1] * c;
}

static double area(const double a[], const double b[], const double c[])
{
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) -
                  (c[0] - a[0]) * (b[1] - a[1]));
}

static double J_of(const double X[6], const double x[6])
{
    return area(x, x + 2, x + 4) / area(X, X + 2, X + 4);
}

/* How many triangles hold the centre of triangle e now. */
static int owners(const struct triangles *t, int e)
{
    double centre[2] = {0.0, 0.0};
    int count = 0;

    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++)
            centre[i] += t->x[6 * e + 2 * a + i] / 3.0;
    for (int k = 0; k < t->n; k++) {
        const double *x = t->x + 6 * k;
        const double p = area(centre, x, x + 2);
        const double q = area(centre, x + 2, x + 4);
        const double r = area(centre, x + 4, x);
        count += p * q > 0.0 && q * r > 0.0;
    }
    return count;
}

static void print_triangles(const char *name, const struct triangles *t)
{
    table_begin(name, "J owners x0 y0 x1 y1 x2 y2 X0 Y0 X1 Y1 X2 Y2");
    for (int e = 0; e < t->n; e++) {
        const double *X = t->X + 6 * e, *x = t->x + 6 * e;
        table_row(J_of(X, x), owners(t, e), x[0], x[1], x[2], x[3], x[4], x[5],
                  X[0], X[1], X[2], X[3], X[4], X[5]);
    }
    table_end();
}

int main(void)
{
    struct triangles *t = allocate(1, sizeof *t);
    double shared[7] = {0.0}, least = INFINITY;
    int inside_out = 0;

    cut(t, 1.0, 1.0, 16, 16, 0);
    for (int k = 0; k < 3 * t->n; k++) push(1.05, t->X + 2 * k, t->x + 2 * k);
    print_triangles("square", t);
    for (int e = 0; e < t->n; e++)
        inside_out += !(J_of(t->X + 6 * e, t->x + 6 * e) > 0.0);

    cut(t, 3.0, half_width, 60, 6, 1);
    table_begin("bend", "degrees inverted min_J exact_min_J shared");
    for (int k = 1; k <= 6; k++) {
        const double angle = 0.25 * M_PI * k;
        double min_J = INFINITY, inverted = 0.0;
        for (int a = 0; a < 3 * t->n; a++)
            bend(angle, t->X + 2 * a, t->x + 2 * a);
        for (int e = 0; e < t->n; e++) {
            const double J = J_of(t->X + 6 * e, t->x + 6 * e);
            min_J = fmin(min_J, J);
            inverted += !(J > 0.0);
            shared[k] += (owners(t, e) > 1) / (double)t->n;
        }
        least = fmin(least, min_J);
        table_row(45 * k, inverted, min_J, 1.0 - half_width * angle / arc,
                  shared[k]);
    }
    table_end();
    print_triangles("strip", t);
    free(t);

    claim(inside_out == 62, "62 triangles of the square are inverted, as in "
          "push.c (%d)", inside_out);
    claim(least > 0.5, "J > 0.5 on every triangle of the strip (%g)", least);
    claim(shared[4] == 0.0 && fabs(shared[6] - 0.2) < 0.02, "no part is shared "
          "at 180 degrees, a fifth is at 270 (%g)", shared[6]);
    return table_finish();
}
