/*
 * 01_deformation.c - what a deformation does near a point: F, J, and strain.
 *
 * Notes: Lecture 1, "Kinematics", the strain measures, and Figure 4.
 * Problem.  phi takes a material point X to its place x = phi(X) = X + u.  From
 * the places of the vertices of a mesh find F = d phi / d X and J = det F on
 * every element, and the elements that are inside out, J < 0.  Then ask which
 * of three strain measures is fooled by a motion that deforms nothing.
 *
 *         X2                       x1          an inverted triangle: its
 *         | \          F          / |          vertices run clockwise, and
 *         |   \      ----->     /   |          J = area / area is negative
 *        X0 -- X1             x0 -- x2
 *
 * Run       make lesson-01; make lesson-01 ARGS=-h lists its options
 * PREDICT 1 inverted, of 10 elements under sin 2 pi X: ...
 * PREDICT 2 entry 11 of the linear strain of a body turned by 30 degrees: ...
 * PREDICT 3 sum of J area over the pushed square (m^2): ...
 * Plot: bar X0 F
 */
#include "plane/mesh.h"
#include "base/options.h"
#include "bar/poisson.h"
#include "base/table.h"
#include "material/tensor.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>

/*
 * F of the bar element whose ends X0 and X1 (X0 > X1 is allowed) are now at x0
 * and x1.  Returns the sign of F [eq:deformation-gradient]: 1 upright, -1
 * inverted, 0 collapsed.  Collapsed means |x1 - x0| <= 16 DBL_EPSILON size, by
 * which round-off may move a point; size is the bar's largest coordinate,
 * before and after.
 */
static int bar_gradient(double X0, double X1, double x0, double x1,
                        double size, double *F)
{
    int sign = 0;
    /* SLOT 1a(X0, X1, x0, x1, size, F, sign): given both ends before and after,
     * set *F, and set sign to 1, -1 or 0. */
    todo("1a", X0, X1, x0, x1, size, F, sign);
    /* END 1a */
    return sign;
}

/*
 * F of a triangle whose vertices, in either sense of rotation, went from X to
 * x: it takes every reference edge to its deformed edge [eq:triangle-gradient].
 * Coordinate i of vertex a is X[2 a + i], x[2 a + i].  Returns J = det F
 * [eq:jacobian], negative when the triangle is inverted.
 */
static double triangle_gradient(const int node[3], const double X[],
                                const double x[], mat2 *F)
{
    double J = 0.0;
    /* SLOT 1b(node, X, x, F, J): given three vertices, take edges from node[0]
     * as columns of Dm (before) and Ds (after); set *F, and J = det F. */
    todo("1b", node, X, x, F, J);
    /* END 1b */
    return J;
}

/*
 * Three strains of F, all zero for F = I:
 * *linear  out  (F + F^T)/2 - I    [eq:linear-strain]
 * *green   out  (F^T F - I)/2      [eq:green-strain]
 * *left    out  (F F^T - I)/2      [eq:left-strain]
 */
static void strains(mat2 F, mat2 *linear, mat2 *green, mat2 *left)
{
    /* SLOT 1c(&F, linear, green, left): given F, fill the three tensors. */
    todo("1c", &F, linear, green, left);
    /* END 1c */
}

/* The maps of the notes' Figure 4. */
static double sine(double X) { return sin(2.0 * M_PI * X); }
static double square(double X) { return X * X; }

/* The square (-1, 1)^2 pushed to the right inside, its boundary held. */
static void push(double s, const double X[2], double x[2])
{
    const double p = 1.0 - X[0] * X[0], q = 1.0 - X[1] * X[1];
    x[0] = X[0] + s * p * p * q * q;
    x[1] = X[1];
}

/* F of n equal elements of (a, 1) under phi. */
static void print_bar(field *phi, double a, int n)
{
    static const char *const word[] = {"inverted", "collapsed", "upright"};
    double *X = allocate((size_t)n + 1, sizeof *X);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double size = 0.0, F = 0.0;

    poisson_grid(a, 1.0, n, 1.0, X);
    for (int j = 0; j <= n; j++) {
        x[j] = phi(X[j]);
        size = fmax(size, fmax(fabs(X[j]), fabs(x[j])));
    }
    table_begin("bar", "X0 X1 F sign");
    for (int e = 0; e < n; e++) {
        int sign = bar_gradient(X[e], X[e + 1], x[e], x[e + 1], size, &F);
        table_row(X[e], X[e + 1], F, word[1 + sign]);
    }
    table_end();
    free(X);
    free(x);
}

/* F and J of every triangle of the pushed square, and sums over them.  Every
 * second triangle is listed clockwise, as a mesh from a file may do. */
static void print_square(const struct mesh *mesh, double s)
{
    double *x = allocate(2 * (size_t)mesh->n_vertex, sizeof *x);
    double sum = 0.0, absolute = 0.0, min_J = INFINITY;
    const double A = 4.0 / mesh->n_triangle;
    int inverted = 0;

    for (int a = 0; a < mesh->n_vertex; a++)
        push(s, &mesh->X[2 * a], &x[2 * a]);
    table_begin("triangles", "e F11 F12 F21 F22 J");
    for (int e = 0; e < mesh->n_triangle; e++) {
        const int *v = mesh->triangle + 3 * e, other = e % 2 ? 2 : 1;
        const int node[3] = {v[0], v[other], v[3 - other]};
        mat2 F = {{{0.0, 0.0}, {0.0, 0.0}}};
        const double J = triangle_gradient(node, mesh->X, x, &F);
        inverted += !(J > 0.0); /* catches NaN as well */
        sum += J * A;
        absolute += fabs(J) * A;
        min_J = fmin(min_J, J);
        table_row(e, F.m[0][0], F.m[0][1], F.m[1][0], F.m[1][1], J);
    }
    table_end();
    table_begin("square", "s inverted min_J signed_area absolute_area");
    table_row(s, inverted, min_J, sum, absolute);
    table_end();
    free(x);
}

/* The strains of a body that is stretched along x and then turned. */
static void print_strains(double stretch, double angle)
{
    static const char *const measure[] = {"linear", "green", "left"};
    const mat2 U = {{{stretch, 0.0}, {0.0, 1.0}}};
    const mat2 F = mat2_multiply(mat2_rotation(angle), U);
    mat2 e[3] = {F, F, F};
    strains(F, &e[0], &e[1], &e[2]);
    table_begin("strains", "measure e11 e12 e22");
    for (int k = 0; k < 3; k++)
        table_row(measure[k], e[k].m[0][0], e[k].m[0][1], e[k].m[1][1]);
    table_end();
}

int main(int argc, char *argv[])
{
    int map = 0, n = 10, m = 16;
    double left = 0.0, s = 1.05, angle = 30.0, stretch = 1.3;
    const struct option options[] = {
        {"map", .choice = &map, .choices = "sine square", .help = "of the bar"},
        {"n", .integer = &n, .min = 1, .max = 1000, .help = "bar elements"},
        {"left", .real = &left, .min = -2, .max = 0.9, .unit = "m",
         .help = "the bar is (left, 1)"},
        {"m", .integer = &m, .min = 1, .max = 64, .help = "cells per side"},
        {"push", .real = &s, .min = -5, .max = 5, .unit = "m",
         .help = "how far the centre of the square is pushed"},
        {"stretch", .real = &stretch, .min = 0.05, .max = 20,
         .help = "of the body of table strains, along x"},
        {"angle", .real = &angle, .min = -360, .max = 360, .unit = "degrees",
         .help = "by which it turns then"},
    };
    options_parse("01_deformation", options, COUNT(options), argc, argv);

    struct mesh *mesh = mesh_square(m);
    print_bar(map ? square : sine, left, n);
    print_square(mesh, s);
    print_strains(stretch, angle * M_PI / 180.0);
    mesh_free(mesh);
    return table_finish();
}
