/*
 * 25_elements.c - a square that hangs from its left side: linear triangles and
 * quadratic ones; even and graded.
 *
 * Notes: beyond the notes; a triangle has the forces of Lecture 2, 3.3.2.
 *
 * Problem.  The body (-1, 1)^2 is held on its left side and hangs under 1 N per
 * square metre; linear elasticity, which is K at rest.  How far does (1, 0)
 * sink?  All elements have the same vertices, n x n cells; two by two of them
 * are a square of two quadratic triangles:
 *
 *         2           nodes 0 1 2: the corners, counter-clockwise; 3 4 5: the
 *         | \         middles of the edges opposite to them
 *         4   3       l = (l_0, l_1, l_2): barycentric coordinates, of which
 *         |     \     l_a is 1 at corner a, and 0 on the edge opposite to it
 *         0---5---1   dl_a/dX_j = of_l[2a + j]: the hats of lesson 12
 *
 * Run       make lesson-25; make lesson-25 ARGS=-h lists its options
 * PREDICT 1 sag with m = 0, quadratic over linear, --nu 0.4999 --n 16: ...
 * PREDICT 2 mass of a middle over that of a corner, one triangle: ...
 * PREDICT 3 order of quadratic triangles with --m 2, nu = 0.3: ...
 * Plot: axis X u_y
 */
#include "plane/body.h"
#include "plane/elements.h"
#include "plane/quadratic.h"
#include "base/options.h"
#include "base/table.h"

#include <math.h>

/* Given l, return in N[a] the six functions of degree 2, 1 at node a and 0 at
 * the other five, and in gradient[2a + j] their dN_a/dX_j (1/m). */
static void shapes(const double l[3], const double of_l[6], double N[6],
                   double gradient[12])
{
    /* SLOT 25a(l, of_l, N, gradient): nodes 0 to 2, then 3 to 5. */
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        N[a] = l[a] * (2.0 * l[a] - 1.0); /* 0 where l_a is 0 or 1/2 */
        N[3 + a] = 4.0 * l[b] * l[c];     /* 0 on both other edges */
        for (int j = 0; j < 2; j++) {
            /* the chain rule: dN/dX_j = sum_v dN/dl_v dl_v/dX_j */
            gradient[2 * a + j] = (4.0 * l[a] - 1.0) * of_l[2 * a + j];
            gradient[2 * (3 + a) + j] =
                4.0 * (l[b] * of_l[2 * c + j] + l[c] * of_l[2 * b + j]);
        }
    }
    /* END 25a */
}

/* Given the displacements u[2a + i] of the nodes of a quadratic triangle,
 * return q[2a + i] = dPsi/du_ai and K[12 (2a + i) + 2b + j] = dq_ai/du_bj, by
 * the three-point rule [eq:three-points].  INVERTED where the material is not
 * defined at one of the points; q and K are then incomplete. */
static enum status element(const struct material *material,
                           const double of_l[6], double area,
                           const double u[12], double q[12], double K[144])
{
    const double point[3][3] = {{2.0 / 3, 1.0 / 6, 1.0 / 6},
                                {1.0 / 6, 2.0 / 3, 1.0 / 6},
                                {1.0 / 6, 1.0 / 6, 2.0 / 3}};
    /* SLOT 25b(material, of_l, area, u, q, K, point, shapes): point[k] is l;
     * material_defined(), material2_pk1(), material2_dpk1(). */
    for (int r = 0; r < 12; r++) q[r] = 0.0;
    for (int r = 0; r < 144; r++) K[r] = 0.0;
    for (int k = 0; k < 3; k++) {
        double N[6], g[12];
        shapes(point[k], of_l, N, g);
        mat2 F = mat2_identity(), dF[12] = {{{{0.0}}}};
        for (int a = 0; a < 6; a++)
            for (int i = 0; i < 2; i++)
                for (int j = 0; j < 2; j++) {
                    /* F = I + sum u_ai e_i (x) grad N_a; dF_r = dF/du_r */
                    F.m[i][j] += u[2 * a + i] * g[2 * a + j];
                    dF[2 * a + i].m[i][j] = g[2 * a + j];
                }
        if (!material_defined(material, mat2_det(F))) return INVERTED;
        const mat2 P = material2_pk1(material, F);
        for (int s = 0; s < 12; s++) {
            const mat2 dP = material2_dpk1(material, F, dF[s]);
            /* a third of the area: P : dF_s, and dF_r : dP */
            q[s] += area / 3.0 * mat2_dot(P, dF[s]);
            for (int r = 0; r < 12; r++)
                K[12 * r + s] += area / 3.0 * mat2_dot(dF[r], dP);
        }
    }
    /* END 25b */
    return OK;
}

/* Given n even and the degree of the elements, 1 or 2, fill in x[0..n], the
 * lines of a lattice from -1 to 1: every degree-th line, an end of elements, is
 * graded towards -1, and if `both` towards 1 as well.  What is nearer to such
 * an end than L = 1/2 goes from the distance d to L (d/L)^m [eq:graded].  What
 * lies between two of them, in quadratic triangles, is in the middle.  m = 0
 * stands for the least m with which a corner, u ~ r^p, costs no order.  Returns
 * m. */
static double lines(int n, int degree, double p, double m, int both, double x[])
{
    const double L = 0.5;
    /* SLOT 25c(n, degree, p, m, both, L, x): fill x; return m. */
    if (m == 0.0) m = degree / p; /* p m = k in 2 min(k, p m) */
    for (int i = 0; i <= n; i += degree) {
        x[i] = -1.0 + 2.0 * i / n;
        const double d = 1.0 - fabs(x[i]); /* from the nearer end */
        if (d < L && (x[i] < 0.0 || both))
            x[i] = copysign(1.0 - L * pow(d / L, m), x[i]);
    }
    for (int i = 1; i < n; i += 2) /* the middle of the edge, not of the map */
        if (degree == 2) x[i] = 0.5 * (x[i - 1] + x[i + 1]);
    return m;
    /* END 25c */
}

/* Given the area of a quadratic triangle, return load[a] = int N_a, of a body
 * force 1, and mass[a], its mass on the diagonal, density 1, > 0, in the ratio
 * of the int N_a^2 (exercise 5). */
static void shares(double area, double load[6], double mass[6])
{
    /* SLOT 25d(area, load, mass): what do the six add up to? */
    for (int a = 0; a < 3; a++) {
        load[a] = 0.0; /* int l (2 l - 1) = |e| (1/3 - 1/3) */
        load[3 + a] = area / 3.0;
        /* 6 and 32 of 180; 3 (6 + 32) = 114 are to be all of the mass */
        mass[a] = area * 6.0 / 114.0;
        mass[3 + a] = area * 32.0 / 114.0;
    }
    /* END 25d */
}

/* ---- the square, once with each element ---------------------------------- */

enum { MOST = 64 }; /* cells per row */
enum kind { STRAIGHT, QUADRATIC };
static const char *const kind_name[] = {"linear", "quadratic"};

/* K and f of the two linear triangles of this cell. */
static void add_cell(struct elements *s, const struct material *material,
                     int cell)
{
    int corner[4];
    elements_cell(s->mesh, cell, corner);
    for (int e = 0; e < 2; e++) {
        const int t[3] = {corner[0], corner[1 + e], corner[2 + e]};
        const double area =
            elements_linear(s, t, material->mu, material->lambda);
        for (int a = 0; a < 3; a++) s->f[2 * t[a] + 1] -= area / 3.0;
    }
}

/* K and f of the quadratic triangle e. */
static void add_quadratic(struct elements *s, const struct material *material,
                          int e)
{
    const double rest[12] = {0.0};
    double of_l[6], q[12], E[144], load[6], mass[6];
    int node[6];
    quadratic_nodes(s->mesh, e, node);
    const double area = mesh_gradients_of(s->mesh, node, of_l);
    element(material, of_l, area, rest, q, E);
    shares(area, load, mass);
    elements_add(s, 6, node, E);
    for (int a = 0; a < 6; a++) s->f[2 * node[a] + 1] -= load[a];
}

/* u of the square on this mesh, whose left side is held. */
static void hang(const struct mesh *mesh, const struct material *material,
                 enum kind kind, double u[])
{
    const int n = mesh->n, quadratic = kind == QUADRATIC;
    struct elements *s = elements_alloc(mesh, quadratic ? 2 : 1);
    for (int j = 0; j <= n; j++) s->held[j * (n + 1)] = 1;
    for (int e = 0; e < (quadratic ? n * n / 2 : n * n); e++)
        if (quadratic) add_quadratic(s, material, e);
        else add_cell(s, material, e);
    const enum status status = elements_solve(s, u);
    if (status != OK) die("the tangent at rest: %s", status_name(status));
    elements_free(s);
}

int main(int argc, char *argv[])
{
    int n = 8;
    double m = 1.0, nu = 0.3, x[MOST + 1], y[MOST + 1], load[6], mass[6];
    double u[2 * (MOST + 1) * (MOST + 1)];
    const struct option options[] = {
        {"n", .integer = &n, .min = 4, .max = MOST, .help = "cells, even"},
        {"m", .real = &m, .min = 0, .max = 4, .help = "grading; 0: of p"},
        {"nu", .real = &nu, .min = 0, .max = 0.4999, .help = "Poisson's"},
    };
    options_parse("25_elements", options, COUNT(options), argc, argv);
    n += n % 2;
    const struct material material = material_make(CUBIC, 1000.0, nu);
    const double p = material_corner(&material);
    struct mesh *mesh = mesh_square(n);
    const int middle = n / 2 * (n + 1); /* at (-1, 0) */

    table_begin("sag", "element m unknowns sag");
    for (int kind = STRAIGHT; kind <= QUADRATIC; kind++) {
        const int degree = kind == QUADRATIC ? 2 : 1;
        const double grading = lines(n, degree, p, m, 0, x);
        lines(n, degree, p, m, 1, y);
        elements_lattice(mesh, x, y);
        hang(mesh, &material, (enum kind)kind, u);
        table_row(kind_name[kind], grading, 2 * n * (n + 1),
                  u[2 * (middle + n) + 1]);
    }
    table_end();
    table_begin("axis", "X u_y"); /* of quadratic triangles, X2 = 0 */
    for (int i = 0; i <= n; i++) table_row(x[i], u[2 * (middle + i) + 1]);
    table_end();
    table_begin("shares", "node load mass"); /* of a triangle of area 1 */
    shares(1.0, load, mass);
    for (int a = 0; a < 6; a++) table_row(a, load[a], mass[a]);
    table_end();
    mesh_free(mesh);
    return table_finish();
}
