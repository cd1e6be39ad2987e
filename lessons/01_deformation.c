/*
 * 01_deformation.c - what a deformation does near a point: F, J, and strain.
 *
 * Notes: Lecture 1, "Kinematics", the strain measures of "Elasticity and
 * Constitutive Modeling", and "Inversion" with its Figure 4.
 *
 * Problem.  phi takes a material point X to its place x = phi(X) = X + u.  From
 * the places of the vertices of a mesh find F = d phi / d X on every element
 * [eq:deformation-gradient] [eq:triangle-gradient], its determinant J
 * [eq:jacobian], and which elements are turned inside out, J < 0.  Then ask of
 * three strain measures [eq:linear-strain] [eq:green-strain] [eq:left-strain]
 * which of them notices a motion that deforms nothing.
 *
 *         X2                       x1          an inverted triangle: its
 *         | \          F          / |          vertices run clockwise, and
 *         |   \      ----->     /   |          J = area / area is negative
 *        X0 -- X1             x0 -- x2
 *
 * Run       make lesson-01, or with options: -h lists them
 * Expect    sin 2 pi X on 10 elements: 4 inverted, 2 collapsed; the linear
 *           strain of a rotation passes 1, 5, 10 % at 8.11, 18.19, 25.84
 *           degrees; a strip in a loop: J >= 0.526 everywhere, and 20 % of it
 *           shares its place with another part
 * Plot: bar X0 sine_F
 */
#include "material.h"
#include "options.h"
#include "poisson.h"
#include "table.h"
#include "tensor.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

/*
 * F of the bar element (X0, X1) whose ends are now at x0, x1, and its sign
 * [eq:deformation-gradient]: 1 upright, -1 inverted, 0 collapsed.
 *
 * size  in   largest coordinate of the bar before and after: round-off can
 *            move a point by a few DBL_EPSILON size, so an element is
 *            collapsed when |x1 - x0| <= 16 DBL_EPSILON size
 * *F    out  the element's deformation gradient
 */
static int bar_gradient(double X0, double X1, double x0, double x1,
                        double size, double *F)
{
    int sign = 0;
    /* SLOT 1a(X0, X1, x0, x1, size, F, sign): set *F, and set sign to 1, -1
     * or 0 [eq:deformation-gradient]. */
    todo("1a", X0, X1, x0, x1, size, F, sign);
    /* END 1a */
    return sign;
}

/*
 * F of a triangle whose vertices went from X to x: the matrix that takes every
 * reference edge to its deformed edge [eq:triangle-gradient].  Returns
 * J = det F [eq:jacobian], negative when the triangle is inverted.
 *
 * node  in   its three vertices, in either sense of rotation
 * X, x  in   coordinate i of vertex a is X[2 a + i], x[2 a + i]
 * *F    out  deformation gradient
 */
static double triangle_gradient(const int node[3], const double X[],
                                const double x[], mat2 *F)
{
    double J = 0.0;
    /* SLOT 1b(node, X, x, F, J): edges from node[0] as columns of Dm (before)
     * and Ds (after); *F = Ds Dm^{-1} and J = det F [eq:triangle-gradient]. */
    todo("1b", node, X, x, F, J);
    /* END 1b */
    return J;
}

/*
 * Three strains of F, all zero for F = I:
 *
 * *linear  out  (F + F^T)/2 - I    [eq:linear-strain]
 * *green   out  (F^T F - I)/2      [eq:green-strain]
 * *left    out  (F F^T - I)/2      [eq:left-strain]
 */
static void strains(mat2 F, mat2 *linear, mat2 *green, mat2 *left)
{
    /* SLOT 1c(&F, linear, green, left): fill the three tensors. */
    todo("1c", &F, linear, green, left);
    /* END 1c */
}

/* ---- one dimension: the notes' Figure 4 --------------------------------- */

static double square(double X) { return X * X; }
static double square_dX(double X) { return 2.0 * X; }
static double sine(double X) { return sin(2.0 * M_PI * X); }
static double sine_dX(double X) { return 2.0 * M_PI * cos(2.0 * M_PI * X); }

/* F and sign of n equal elements of (a, 1) under phi: F[0..n-1], sign[...]. */
static void deform_bar(double a, int n, field *phi, double F[], int sign[])
{
    double *X = allocate((size_t)n + 1, sizeof *X);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double size = 0.0;

    grid_make(a, 1.0, n, 1.0, X);
    for (int j = 0; j <= n; j++) {
        x[j] = phi(X[j]);
        size = fmax(size, fmax(fabs(X[j]), fabs(x[j])));
    }
    for (int e = 0; e < n; e++)
        sign[e] = bar_gradient(X[e], X[e + 1], x[e], x[e + 1], size, &F[e]);
    free(X);
    free(x);
}

/* phi and phi' of both maps, and F of n elements. */
static void print_maps(double a, int n)
{
    double *F = allocate(2 * (size_t)n, sizeof *F);
    int *sign = allocate(2 * (size_t)n, sizeof *sign);

    table_begin("curve", "X square square_dX sine sine_dX");
    for (int k = 0; k <= 200; k++) {
        const double X = a + (1.0 - a) * k / 200;
        table_row(X, square(X), square_dX(X), sine(X), sine_dX(X));
    }
    table_end();

    deform_bar(a, n, square, F, sign);
    deform_bar(a, n, sine, F + n, sign + n);
    table_begin("bar", "X0 X1 square_F square_sign sine_F sine_sign");
    for (int e = 0; e < n; e++)
        table_row(a + (1.0 - a) * e / n, a + (1.0 - a) * (e + 1) / n, F[e],
                  sign[e], F[n + e], sign[n + e]);
    table_end();
    free(F);
    free(sign);
}

/* On (0, 1), mesh by mesh: the smallest F of X^2, and how many elements
 * sin 2 pi X inverts and collapses. */
static void print_refinement(void)
{
    enum { N_MAX = 32 };
    double F[N_MAX];
    int sign[N_MAX];

    table_begin("refine", "n square_min_F inverted collapsed share");
    for (int n = 2; n <= N_MAX; n++) {
        double min_F = INFINITY;
        int inverted = 0, collapsed = 0;
        deform_bar(0.0, n, square, F, sign);
        for (int e = 0; e < n; e++) min_F = fmin(min_F, F[e]);
        deform_bar(0.0, n, sine, F, sign);
        for (int e = 0; e < n; e++) {
            inverted += sign[e] < 0;
            collapsed += sign[e] == 0;
        }
        table_row(n, min_F, inverted, collapsed, (double)inverted / n);
    }
    table_end();
}

/* X^2 near 0, where F = 2 X: the stress of lesson 02's log law has no limit. */
static void print_near_zero(double E, double nu)
{
    const struct material log_law = material_make(LOG, E, nu);
    table_begin("near_zero", "X F log_stress");
    for (int k = 1; k <= 3; k++) {
        const double X = gsl_pow_int(10.0, -k);
        table_row(X, square_dX(X), material1_pk1(&log_law, square_dX(X)));
    }
    table_end();
}

/* ---- triangle meshes ---------------------------------------------------- */

struct mesh {
    int n_node, n_tri;
    int *node;     /* [3 n_tri], owned */
    double *X, *x; /* [2 n_node] places before and after, owned */
};

/* (-a, a) x (-b, b) in nx x ny cells, each cut in two by diagonals that take
 * turns.  Every second triangle is listed clockwise, as in meshes from files,
 * which promise no sense of rotation. */
static struct mesh mesh_make(double a, double b, int nx, int ny)
{
    struct mesh mesh = {(nx + 1) * (ny + 1), 2 * nx * ny, NULL, NULL, NULL};
    const size_t n_node = (size_t)mesh.n_node;
    mesh.node = allocate(3 * (size_t)mesh.n_tri, sizeof *mesh.node);
    mesh.X = allocate(2 * n_node, sizeof *mesh.X);
    mesh.x = allocate(2 * n_node, sizeof *mesh.x);

    for (int p = 0; p < mesh.n_node; p++) {
        mesh.X[2 * p] = a * (2.0 * (p % (nx + 1)) / nx - 1.0);
        mesh.X[2 * p + 1] = b * (2.0 * (p / (nx + 1)) / ny - 1.0);
    }
    for (int cell = 0; cell < nx * ny; cell++) {
        const int i = cell % nx, j = cell / nx, flip = (i + j) % 2;
        const int c00 = j * (nx + 1) + i, c10 = c00 + 1;
        const int c01 = c00 + nx + 1, c11 = c01 + 1;
        const int corner[6] = {c00, c10, flip ? c01 : c11,
                               c11, flip ? c10 : c00, c01};
        for (int k = 0; k < 6; k++) mesh.node[6 * cell + k] = corner[k];
    }
    return mesh;
}

static void mesh_free(struct mesh *mesh)
{
    free(mesh->node);
    free(mesh->X);
    free(mesh->x);
}

/* A plane motion with one parameter: x = phi(X). */
typedef void motion(double parameter, const double X[2], double x[2]);

/*
 * The square (-1, 1)^2 pushed to the right inside, its boundary held:
 * J = 1 - 4 s X (1 - X^2) (1 - Y^2)^2, negative somewhere iff
 * |s| > 3 sqrt(3)/8 = 0.6495.
 */
static void push(double s, const double X[2], double x[2])
{
    const double p = 1.0 - X[0] * X[0], q = 1.0 - X[1] * X[1];
    x[0] = X[0] + s * p * p * q * q;
    x[1] = X[1];
}

/* A strip: 6 m by 0.6 m, the middle 3 m of it bent into an arc. */
static const double half_length = 3.0, half_width = 0.3, arc = 3.0;

/*
 * The arc turns by `angle` (radians, > 0), the tails stay straight; lines
 * across the strip stay straight and keep their length.  J = 1 - Y angle/arc
 * in the arc, 1 in the tails.
 */
static void bend(double angle, const double X[2], double x[2])
{
    const double curvature = angle / arc;
    const double s = fmax(-0.5 * arc, fmin(0.5 * arc, X[0]));
    const double c = cos(curvature * s), d = sin(curvature * s);
    x[0] = d / curvature + (X[0] - s) * c - X[1] * d;
    x[1] = (1.0 - c) / curvature + (X[0] - s) * d + X[1] * c;
}

static void mesh_move(struct mesh *mesh, motion *phi, double parameter)
{
    for (int p = 0; p < mesh->n_node; p++)
        phi(parameter, mesh->X + 2 * p, mesh->x + 2 * p);
}

/* Area of the triangle a b c, negative when it runs clockwise. */
static double signed_area(const double a[], const double b[], const double c[])
{
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) -
                  (c[0] - a[0]) * (b[1] - a[1]));
}

/* Sums over a deformed mesh; areas of the deformed triangles are J A. */
struct census {
    int inverted;
    double signed_area, absolute_area, min_J;
};

static struct census mesh_census(const struct mesh *mesh)
{
    struct census sum = {0, 0.0, 0.0, INFINITY};
    for (int e = 0; e < mesh->n_tri; e++) {
        const int *v = mesh->node + 3 * e;
        const double *X = mesh->X;
        const double A = fabs(
            signed_area(X + 2 * v[0], X + 2 * v[1], X + 2 * v[2]));
        mat2 F;
        const double J = triangle_gradient(v, X, mesh->x, &F);
        sum.inverted += !(J > 0.0); /* catches NaN as well */
        sum.signed_area += J * A;
        sum.absolute_area += fabs(J) * A;
        sum.min_J = fmin(sum.min_J, J);
    }
    return sum;
}

/* How many deformed triangles hold the centre of deformed triangle e: 1 when
 * the motion is one to one there. */
static int owners(const struct mesh *mesh, int e)
{
    double centre[2] = {0.0, 0.0};
    int count = 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            centre[i] += mesh->x[2 * mesh->node[3 * e + k] + i] / 3.0;
    for (int t = 0; t < mesh->n_tri; t++) {
        const double *a = mesh->x + 2 * mesh->node[3 * t];
        const double *b = mesh->x + 2 * mesh->node[3 * t + 1];
        const double *c = mesh->x + 2 * mesh->node[3 * t + 2];
        const double p = signed_area(centre, a, b);
        const double q = signed_area(centre, b, c);
        const double r = signed_area(centre, c, a);
        count += (p > 0 && q > 0 && r > 0) || (p < 0 && q < 0 && r < 0);
    }
    return count;
}

/* Every triangle before and after; `shared` says whether to count owners. */
static void print_triangles(const char *name, const struct mesh *mesh,
                            int shared)
{
    table_begin(name,
                shared ? "J owners x0 y0 x1 y1 x2 y2 X0 Y0 X1 Y1 X2 Y2"
                       : "J x0 y0 x1 y1 x2 y2 X0 Y0 X1 Y1 X2 Y2");
    for (int e = 0; e < mesh->n_tri; e++) {
        const int *v = mesh->node + 3 * e;
        double row[14];
        int n = 0;
        mat2 F;
        row[n++] = triangle_gradient(v, mesh->X, mesh->x, &F);
        if (shared) row[n++] = owners(mesh, e);
        for (int k = 0; k < 6; k++) row[n++] = mesh->x[2 * v[k / 2] + k % 2];
        for (int k = 0; k < 6; k++) row[n++] = mesh->X[2 * v[k / 2] + k % 2];
        table_row_of(n, row);
    }
    table_end();
}

/* The pushed square, at eighths of the push and all of it. */
static void print_push(int m, double s)
{
    struct mesh mesh = mesh_make(1.0, 1.0, m, m);
    table_begin("push",
                "s inverted min_J exact_min_J signed_area absolute_area");
    for (int k = 0; k <= 8; k++) {
        mesh_move(&mesh, push, s * k / 8);
        const struct census sum = mesh_census(&mesh);
        table_row(s * k / 8, sum.inverted, sum.min_J,
                  1.0 - fabs(s * k / 8) * 8.0 / (3.0 * sqrt(3.0)),
                  sum.signed_area, sum.absolute_area);
    }
    table_end();
    print_triangles("square", &mesh, 0);
    mesh_free(&mesh);
}

/* The strip, at sixths of its bend and all of it: J > 0 is not enough. */
static void print_strip(double degrees)
{
    struct mesh mesh = mesh_make(half_length, half_width, 60, 6);
    table_begin("bend", "degrees inverted min_J exact_min_J shared");
    for (int k = 1; k <= 6; k++) {
        const double angle = degrees * k / 6 * M_PI / 180.0;
        int shared = 0;
        mesh_move(&mesh, bend, angle);
        const struct census sum = mesh_census(&mesh);
        for (int e = 0; e < mesh.n_tri; e++) shared += owners(&mesh, e) > 1;
        table_row(degrees * k / 6, sum.inverted, sum.min_J,
                  1.0 - half_width * angle / arc,
                  (double)shared / mesh.n_tri);
    }
    table_end();
    print_triangles("strip", &mesh, 1);
    mesh_free(&mesh);
}

/* ---- strain measures ---------------------------------------------------- */

/* F as slot 1b finds it, for a clockwise triangle moved by x = F X + c. */
static mat2 observed(mat2 F)
{
    const int node[3] = {0, 2, 1};
    const double X[6] = {0.1, 0.2, 1.3, 0.4, 0.5, 1.7};
    const double c[2] = {0.7, -0.3};
    double x[6];
    mat2 result = {{{0.0, 0.0}, {0.0, 0.0}}};
    for (int k = 0; k < 6; k++)
        x[k] = F.m[k % 2][0] * X[k - k % 2] + F.m[k % 2][1] * X[k - k % 2 + 1] +
               c[k % 2];
    triangle_gradient(node, X, x, &result);
    return result;
}

/* What the notes say about rigid motions, case by case, with w = `angle`. */
static void print_rigid(double angle, double E, double nu)
{
    const struct material law = material_make(LINEAR, E, nu);
    const mat2 spin = {{{0.0, -angle}, {angle, 0.0}}}; /* skew */
    const mat2 cases[] = {
        mat2_identity(), spin, mat2_add(mat2_identity(), spin),
        mat2_scale(0.0, mat2_identity()), mat2_rotation(angle)};

    table_begin_note("rigid", "case J linear green left stress energy",
                     "cases: 0 translation, F = I; 1 F = W skew; 2 du/dX = W; "
                     "3 du/dX = -I; 4 rotation. All tensors are multiples "
                     "of I: entry 11; stress and energy by the linear law");
    for (int k = 0; k < COUNT(cases); k++) {
        const mat2 F = observed(cases[k]);
        mat2 linear, green, left;
        strains(F, &linear, &green, &left);
        table_row(k, mat2_det(F), linear.m[0][0], green.m[0][0],
                  left.m[0][0],
                  2.0 * law.mu * linear.m[0][0] +
                      law.lambda * mat2_trace(linear),
                  material2_psi(&law, F));
    }
    table_end();
}

static double max_difference(mat2 A, mat2 B)
{
    double largest = 0.0;
    for (int k = 0; k < 4; k++)
        largest = fmax(largest, fabs(A.m[k / 2][k % 2] - B.m[k / 2][k % 2]));
    return largest;
}

/* The strains of a rotation, and by how much a rotation changes the strains
 * of a body that is stretched along x: largest change of an entry. */
static void print_angles(double stretch)
{
    const mat2 U = {{{stretch, 0.0}, {0.0, 1.0}}};
    mat2 linear_0, green_0, left_0;
    strains(U, &linear_0, &green_0, &left_0);

    table_begin("angles", "degrees linear green left linear_change "
                          "green_change left_change");
    for (int degrees = 0; degrees <= 180; degrees += 2) {
        const mat2 R = mat2_rotation(degrees * M_PI / 180.0);
        mat2 linear, green, left, linear_1, green_1, left_1;
        strains(R, &linear, &green, &left);
        strains(mat2_multiply(R, U), &linear_1, &green_1, &left_1);
        table_row(degrees, linear.m[0][0], green.m[0][0], left.m[0][0],
                  max_difference(linear_1, linear_0),
                  max_difference(green_1, green_0),
                  max_difference(left_1, left_0));
    }
    table_end();
}

/* The angle in degrees where the linear strain of a rotation is `level`, by
 * bisection: it grows from 0 to 1 between 0 and 90 degrees. */
static double angle_of_strain(double level)
{
    double low = 0.0, high = 90.0;
    for (int k = 0; k < 60; k++) {
        const double middle = 0.5 * (low + high);
        mat2 linear, green, left;
        strains(mat2_rotation(middle * M_PI / 180.0), &linear, &green, &left);
        if (fabs(linear.m[0][0]) < level) low = middle;
        else high = middle;
    }
    return 0.5 * (low + high);
}

static void print_thresholds(void)
{
    const double level[] = {0.01, 0.05, 0.1};
    table_begin("thresholds", "level degrees");
    for (int k = 0; k < COUNT(level); k++)
        table_row(level[k], angle_of_strain(level[k]));
    table_end();
}

int main(int argc, char *argv[])
{
    int n = 10, m = 16;
    double left = 0.0, push_ = 1.05, bend_ = 270.0, angle = 30.0;
    double stretch = 1.3, E = 1000.0, nu = 0.3;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 1000, .help = "bar elements"},
        {"left", .real = &left, .min = -2, .max = 0.9, .unit = "m",
         .help = "the bar is (left, 1)"},
        {"m", .integer = &m, .min = 1, .max = 64,
         .help = "cells along a side of the square"},
        {"push", .real = &push_, .min = -5, .max = 5, .unit = "m",
         .help = "how far the centre of the square is pushed"},
        {"bend", .real = &bend_, .min = 6, .max = 360, .unit = "degrees",
         .help = "turn of the strip"},
        {"angle", .real = &angle, .min = -360, .max = 360, .unit = "degrees",
         .help = "rotation of table rigid"},
        {"stretch", .real = &stretch, .min = 0.05, .max = 20,
         .help = "stretch of the body that table angles turns"},
        {"E", .real = &E, .min = 1e-6, .max = 1e12, .unit = "N/m^2",
         .help = "Young's modulus"},
        {"nu", .real = &nu, .min = 0, .max = 0.4999,
         .help = "Poisson's ratio, below 1/2",
         .why = "at 1/2 the material is incompressible, lambda infinite"},
    };
    options_parse("01_deformation", options, COUNT(options), argc, argv);

    print_maps(left, n);
    print_refinement();
    print_near_zero(E, nu);
    print_push(m, push_);
    print_strip(bend_);
    print_rigid(angle * M_PI / 180.0, E, nu);
    print_angles(stretch);
    print_thresholds();
    return table_finish();
}
