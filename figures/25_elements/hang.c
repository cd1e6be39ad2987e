/* hang.c - see hang.h. */
#include "hang.h"

#include "base/status.h"
#include "plane/body.h"
#include "plane/elements.h"
#include "plane/quadratic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double density[2] = {0.0, -1.0};

/* f += the weight of a linear triangle, a third at each vertex. */
static void add_weight(double area, const int vertex[3], double f[])
{
    for (int a = 0; a < 3; a++)
        for (int k = 0; k < 2; k++)
            f[2 * vertex[a] + k] += area / 3.0 * density[k];
}

/* f, and u: one increment from rest. */
static void solve_linear(const struct mesh *mesh, struct material material,
                         const int held[], double u[])
{
    double *f = allocate(2 * (size_t)mesh->n_vertex, sizeof *f), g[6];
    struct body *body = body_alloc(mesh, material, 0.0, CONSISTENT, held);
    for (int e = 0; e < mesh->n_triangle; e++)
        add_weight(-mesh_gradients(mesh, e, g), &mesh->triangle[3 * e], f);
    struct matrix *K = body_matrix(body);
    if (body_stiffness(body, u, EXACT, K) != OK ||
        body_increment(body, K, f, u) != OK)
        die("linear triangles, n = %d", mesh->n);
    matrix_free(K);
    body_free(body);
    free(f);
}

/* The triangles without lambda, and lambda/2 |cell| (mean of div u)^2 of each
 * cell. */
static void solve_averaged(const struct mesh *mesh, struct material material,
                           const int held[], double u[])
{
    const int n_cell = mesh->n * mesh->rows;
    struct elements *s = elements_alloc(mesh, 1);
    for (int cell = 0; cell < n_cell; cell++) {
        int corner[4];
        double D[8] = {0.0}, area = 0.0, g[6];
        elements_cell(mesh, cell, corner);
        for (int e = 0; e < 2; e++) {
            const int at[3] = {0, 1 + e, 2 + e};
            const int t[3] = {corner[0], corner[1 + e], corner[2 + e]};
            const double part = mesh_gradients_of(mesh, t, g);
            elements_linear(s, t, material.mu, 0.0);
            add_weight(part, t, s->f);
            area += part;
            for (int a = 0; a < 3; a++)
                for (int k = 0; k < 2; k++)
                    D[2 * at[a] + k] += part * g[2 * a + k];
        }
        elements_square(s, 4, corner, material.lambda / area, D);
    }
    memcpy(s->held, held, (size_t)mesh->n_vertex * sizeof *held);
    if (elements_solve(s, u) != OK) die("averaged, n = %d", mesh->n);
    elements_free(s);
}

/* Returns div, see hang.h. */
static double solve_quadratic(const struct mesh *mesh, struct material material,
                              const int held[], double u[])
{
    const size_t n_dof = 2 * (size_t)mesh->n_vertex;
    double *f = allocate(n_dof, sizeof *f), *q = allocate(n_dof, sizeof *q);
    double sum = 0.0;
    struct body *body = body_alloc_of(QUADRATIC_TRIANGLE, mesh, material, 0.0,
                                      CONSISTENT, held);
    body_store(body, SPARSE);
    quadratic_load(mesh, density, f);
    if (body_assemble(body, at_rest(f), u, EXACT, q) != OK ||
        body_increment(body, body->K, q, u) != OK)
        die("quadratic triangles, n = %d", mesh->n / 2);
    for (int e = 0; e < body->n_element; e++)
        for (int p = 0; p < 3; p++) {
            double div = 0.0;
            for (int a = 0; a < 6; a++)
                for (int k = 0; k < 2; k++)
                    div += u[2 * body->vertex[6 * e + a] + k] *
                           body->gradient[36 * e + 12 * p + 2 * a + k];
            sum += body->area[e] * div * div;
        }
    body_free(body);
    free(f);
    free(q);
    return sqrt(sum / 4.0);
}

struct hang hang_of(enum hang_element element, int n, double m, double nu)
{
    const int cells = element == HANG_QUADRATIC ? 2 * n : n;
    const struct material material = material_make(CUBIC, 1000.0, nu);
    struct mesh *mesh = mesh_square(cells);
    struct hang hang = {.div = 0.0};
    double *u = allocate(2 * (size_t)mesh->n_vertex, sizeof *u), g[6];
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int j = 0; j <= cells; j++) held[j * (cells + 1)] = 1;
    mesh_grade(mesh, m, MESH_LEFT | MESH_BOTTOM | MESH_TOP);
    if (element == HANG_QUADRATIC) {
        quadratic_straighten(mesh);
        hang.div = solve_quadratic(mesh, material, held, u);
    } else {
        if (element == HANG_LINEAR) solve_linear(mesh, material, held, u);
        else solve_averaged(mesh, material, held, u);
        for (int e = 0; e < mesh->n_triangle; e++) {
            const double area = mesh_gradients(mesh, e, g);
            double div = 0.0;
            for (int a = 0; a < 3; a++)
                for (int k = 0; k < 2; k++)
                    div += u[2 * mesh->triangle[3 * e + a] + k] * g[2 * a + k];
            hang.div += area / 4.0 * div * div;
        }
        hang.div = sqrt(hang.div);
    }
    double *to = hang.u;
    for (int j = 0; j <= 4; j++)
        for (int i = 0; i <= 4; i++)
            for (int k = 0; k < 2; k++)
                *to++ = u[2 * (j * (cells / 4) * (cells + 1) +
                               i * (cells / 4)) + k];
    hang.sag = hang.u[2 * (2 * 5 + 4) + 1];
    free(u);
    free(held);
    mesh_free(mesh);
    return hang;
}

double hang_apart(const struct hang *a, const struct hang *b)
{
    double apart = 0.0, size = 0.0;
    for (int r = 0; r < 2 * HANG_SHARED; r++) {
        apart += (a->u[r] - b->u[r]) * (a->u[r] - b->u[r]);
        size += b->u[r] * b->u[r];
    }
    return sqrt(apart / size);
}
