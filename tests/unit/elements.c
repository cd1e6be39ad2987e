/* elements.c - laws of common/plane/elements.h. */
#include "plane/body.h"
#include "plane/elements.h"
#include "plane/body.h"
#include "plane/quadratic.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = 6, N_VERTEX = (N + 1) * (N + 1) };

static double entropy(int i) { return sin(2.385 * i * i + 3.714 * i + 0.7); }

static struct mesh *skew(void)
{
    struct mesh *mesh = mesh_square(N);
    for (int a = 0; a < N_VERTEX; a++) {
        mesh->X[2 * a] += 0.371 * mesh->X[2 * a + 1];
        mesh->X[2 * a + 1] += 0.137 * mesh->X[2 * a];
    }
    return mesh;
}

/* Some vertices, of them the first one. */
static void hold(int held[N_VERTEX])
{
    for (int a = 0; a < N_VERTEX; a++)
        held[a] = a % (N + 1) == N || a == 0 || a == 2 * N + 4;
}

static void linear_triangles_are_those_of_the_body(void)
{
    struct mesh *mesh = skew();
    const struct material material = material_make(CUBIC, 1000.0, 0.3);
    struct elements *elements = elements_alloc(mesh, 1);
    int *held = elements->held;
    double u[2 * N_VERTEX], q[2 * N_VERTEX], du[2 * N_VERTEX], area = 0.0;
    hold(held);
    for (int e = 0; e < mesh->n_triangle; e++)
        area += elements_linear(elements, &mesh->triangle[3 * e], material.mu,
                                material.lambda);
    close_to(area, 4.0, 1e-13);
    for (int r = 0; r < 2 * N_VERTEX; r++) {
        elements->f[r] = entropy(r);
        q[r] = -entropy(r);
    }
    struct body *body = body_alloc(mesh, material, 0.0, CONSISTENT, held);
    struct matrix *K = body_matrix(body);
    ck_assert_int_eq(elements_solve(elements, u), OK);
    const double rest[2 * N_VERTEX] = {0.0};
    ck_assert_int_eq(body_stiffness(body, rest, EXACT, K), OK);
    ck_assert_int_eq(body_increment(body, K, q, du), OK);
    for (int r = 0; r < 2 * N_VERTEX; r++) { /* u is about 0.1 */
        close_to(u[r], du[r], 1e-12);
        if (held[r / 2]) ck_assert(u[r] == 0.0);
    }
    matrix_free(K);
    body_free(body);
    elements_free(elements);
    mesh_free(mesh);
}

/* One element of six nodes, the entries of E all different. */
static void an_element_goes_where_its_nodes_are(void)
{
    struct mesh *mesh = mesh_square(N);
    struct elements *elements = elements_alloc(mesh, 2);
    double E[144];
    int node[6];
    quadratic_nodes(mesh, 7, node);
    for (int r = 0; r < 12; r++)
        for (int s = 0; s < 12; s++)
            E[12 * r + s] = 1.0 + (r < s ? 12 * r + s : 12 * s + r);
    for (int times = 1; times <= 2; times++) {
        elements_add(elements, 6, node, E);
        for (int r = 0; r < 12; r++)
            for (int s = 0; s < 12; s++)
                ck_assert(matrix_get(elements->K, 2 * node[r / 2] + r % 2,
                                     2 * node[s / 2] + s % 2) ==
                          times * E[12 * r + s]);
    }
    elements_free(elements);
    mesh_free(mesh);
}

static void what_nothing_holds_is_not_solved(void)
{
    struct mesh *mesh = skew();
    struct elements *elements = elements_alloc(mesh, 1);
    double u[2 * N_VERTEX] = {0.0};
    u[0] = 7.0;
    for (int e = 0; e < mesh->n_triangle; e++)
        elements_linear(elements, &mesh->triangle[3 * e], 1.0, 1.0);
    ck_assert_int_eq(elements_solve(elements, u), NOT_SPD);
    ck_assert(u[0] == 7.0);
    elements_free(elements);
    mesh_free(mesh);
}

/* The farthest two nodes of any element are so far apart: no band is wider. */
static void the_band_is_as_wide_as_its_elements(void)
{
    struct mesh *mesh = mesh_rectangle(4, N, 1.0, 1.5);
    for (int reach = 1; reach <= 2; reach++) {
        struct elements *elements = elements_alloc(mesh, reach);
        int widest = 0;
        for (int e = 0; e < mesh->n_triangle / (reach * reach); e++) {
            int node[6], count = reach == 1 ? 3 : 6;
            if (reach == 2) quadratic_nodes(mesh, e, node);
            else memcpy(node, &mesh->triangle[3 * e], 3 * sizeof *node);
            for (int a = 0; a < count; a++)
                for (int b = 0; b < count; b++)
                    if (node[a] - node[b] > widest) widest = node[a] - node[b];
        }
        ck_assert_int_eq(elements->K->p, 2 * widest + 1);
        elements_free(elements);
    }
    mesh_free(mesh);
}

static void a_cell_has_its_triangles(void)
{
    struct mesh *mesh = mesh_rectangle(4, 3, 1.0, 1.0);
    for (int cell = 0; cell < 12; cell++) {
        const int *t = &mesh->triangle[6 * cell];
        int corner[4];
        elements_cell(mesh, cell, corner);
        ck_assert_int_eq(corner[0], cell + cell / 4); /* five in a row */
        ck_assert_int_eq(corner[1], corner[0] + 1);
        ck_assert_int_eq(corner[2], corner[0] + 6);
        ck_assert_int_eq(corner[3], corner[0] + 5);
        for (int e = 0; e < 2; e++) {
            ck_assert_int_eq(t[3 * e], corner[0]);
            ck_assert_int_eq(t[3 * e + 1], corner[1 + e]);
            ck_assert_int_eq(t[3 * e + 2], corner[2 + e]);
        }
    }
    mesh_free(mesh);
}

static void a_lattice_is_a_product(void)
{
    struct mesh *mesh = mesh_rectangle(3, 2, 1.0, 1.0);
    const double x[4] = {-2.385, 0.1, 0.3714, 5.0}, y[3] = {-1.0, 0.6, 7.5};
    elements_lattice(mesh, x, y);
    for (int a = 0; a < 12; a++) {
        ck_assert(mesh->X[2 * a] == x[a % 4]);
        ck_assert(mesh->X[2 * a + 1] == y[a / 4]);
    }
    mesh_free(mesh);
}

UNIT_MAIN("elements",
    LAW(linear_triangles_are_those_of_the_body),
    LAW(an_element_goes_where_its_nodes_are),
    LAW(what_nothing_holds_is_not_solved),
    LAW(the_band_is_as_wide_as_its_elements),
    LAW(a_cell_has_its_triangles),
    LAW(a_lattice_is_a_product))
