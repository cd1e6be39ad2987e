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
        const double factor = material.lambda / area;
        double E[64]; /* factor D D^T */
        for (int r = 0; r < 64; r++) E[r] = factor * D[r / 8] * D[r % 8];
        elements_add(s, 4, corner, E);
    }
    memcpy(s->held, held, (size_t)mesh->n_vertex * sizeof *held);
    if (elements_solve(s, u) != OK) die("averaged, n = %d", mesh->n);
    elements_free(s);
}

int *hang_cross(const struct mesh *mesh)
{
    const int row = mesh->n + 1;
    const int corner[5] = {0, 2, 2 * row + 2, 2 * row, 0};
    int *list = allocate(3 * (size_t)mesh->n_triangle / 2, sizeof *list);
    int *t = list;
    for (int j = 0; j < mesh->rows; j += 2)
        for (int i = 0; i < mesh->n; i += 2)
            for (int k = 0; k < 4; k++) {
                const int low = j * row + i;
                *t++ = low + corner[k];
                *t++ = low + corner[k + 1];
                *t++ = low + row + 1;
            }
    return list;
}

/* What lies on an edge of a square is no vertex: held, and with a diagonal. */
static void solve_crossed(const struct mesh *mesh, struct material material,
                          const int held[], const int triangle[], double u[])
{
    const double diagonal[4] = {1.0, 0.0, 0.0, 1.0};
    struct elements *s = elements_alloc(mesh, 2);
    for (int e = 0; e < mesh->n_triangle / 2; e++) {
        const int *t = &triangle[3 * e];
        add_weight(elements_linear(s, t, material.mu, material.lambda), t,
                   s->f);
    }
    memcpy(s->held, held, (size_t)mesh->n_vertex * sizeof *held);
    for (int j = 0; j <= mesh->rows; j++)
        for (int i = 1 - j % 2; i <= mesh->n; i += 2) {
            const int a = j * (mesh->n + 1) + i;
            elements_add(s, 1, &a, diagonal);
            s->held[a] = 1;
        }
    if (elements_solve(s, u) != OK) die("criss-cross, n = %d", mesh->n / 2);
    elements_free(s);
}

/* Root of the mean of (div u)^2 over linear triangles. */
static double size_of_div(const struct mesh *mesh, int n_triangle,
                          const int triangle[], const double u[])
{
    double sum = 0.0, g[6];
    for (int e = 0; e < n_triangle; e++) {
        const int *t = &triangle[3 * e];
        const double area = mesh_gradients_of(mesh, t, g);
        double div = 0.0;
        for (int a = 0; a < 3; a++)
            for (int k = 0; k < 2; k++) div += u[2 * t[a] + k] * g[2 * a + k];
        sum += area / 4.0 * div * div;
    }
    return sqrt(sum);
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

struct hang hang_whole(enum hang_element element, int n, double m, double nu,
                       struct mesh **whole, double **of_whole)
{
    const int twice = element == HANG_QUADRATIC || element == HANG_CROSSED;
    const int cells = twice ? 2 * n : n;
    const struct material material = material_make(CUBIC, 1000.0, nu);
    struct mesh *mesh = *whole = mesh_square(cells);
    struct hang hang = {.div = 0.0};
    double *u = allocate(2 * (size_t)mesh->n_vertex, sizeof *u);
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int j = 0; j <= cells; j++) held[j * (cells + 1)] = 1;
    mesh_grade(mesh, m, MESH_LEFT | MESH_BOTTOM | MESH_TOP);
    if (twice) quadratic_straighten(mesh);
    if (element == HANG_QUADRATIC) {
        hang.div = solve_quadratic(mesh, material, held, u);
    } else if (element == HANG_CROSSED) {
        int *triangle = hang_cross(mesh);
        solve_crossed(mesh, material, held, triangle, u);
        hang.div = size_of_div(mesh, mesh->n_triangle / 2, triangle, u);
        free(triangle);
    } else {
        if (element == HANG_LINEAR) solve_linear(mesh, material, held, u);
        else solve_averaged(mesh, material, held, u);
        hang.div = size_of_div(mesh, mesh->n_triangle, mesh->triangle, u);
    }
    double *to = hang.u;
    for (int j = 0; j <= 4; j++)
        for (int i = 0; i <= 4; i++)
            for (int k = 0; k < 2; k++)
                *to++ = u[2 * (j * (cells / 4) * (cells + 1) +
                               i * (cells / 4)) + k];
    hang.sag = hang.u[2 * (2 * 5 + 4) + 1];
    *of_whole = u;
    free(held);
    return hang;
}

struct hang hang_of(enum hang_element element, int n, double m, double nu)
{
    struct mesh *mesh;
    double *u;
    const struct hang hang = hang_whole(element, n, m, nu, &mesh, &u);
    free(u);
    mesh_free(mesh);
    return hang;
}

struct hang hang_limit(double nu)
{
    struct hang run[3];
    for (int j = 0; j < 3; j++)
        run[j] = hang_of(HANG_QUADRATIC, 32 << j, 3.0, nu);
    const double ratio =
        hang_apart(&run[0], &run[1]) / hang_apart(&run[1], &run[2]);
    const double of_div =
        (run[1].div - run[0].div) / (run[2].div - run[1].div);
    struct hang limit = run[2];
    for (int r = 0; r < 2 * HANG_SHARED; r++)
        limit.u[r] += (run[2].u[r] - run[1].u[r]) / (ratio - 1.0);
    limit.sag += (run[2].sag - run[1].sag) / (ratio - 1.0);
    limit.div += (run[2].div - run[1].div) / (of_div - 1.0);
    return limit;
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
