/* elements.c - laws of common/plane/elements.h. */
#include "plane/elements.h"
#include "plane/body.h"
#include "plane/quadratic.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>

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

/* Some vertices, and not the first ones. */
static void hold(int held[N_VERTEX])
{
    for (int a = 0; a < N_VERTEX; a++)
        held[a] = a % (N + 1) == N || a == 2 * N + 4;
}

static void linear_triangles_are_those_of_the_body(void)
{
    struct mesh *mesh = skew();
    const struct material material = material_make(CUBIC, 1000.0, 0.3);
    struct elements *elements = elements_alloc(mesh, 1);
    int held[N_VERTEX];
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
    ck_assert_int_eq(elements_solve(elements, held, u), OK);
    struct body *body = body_alloc(mesh, material, 0.0, CONSISTENT, held);
    struct matrix *K = body_matrix(body);
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
    const int held[N_VERTEX] = {0};
    double u[2 * N_VERTEX] = {0.0};
    u[0] = 7.0;
    for (int e = 0; e < mesh->n_triangle; e++)
        elements_linear(elements, &mesh->triangle[3 * e], 1.0, 1.0);
    ck_assert_int_eq(elements_solve(elements, held, u), NOT_SPD);
    ck_assert(u[0] == 7.0);
    elements_free(elements);
    mesh_free(mesh);
}

static const struct unit_law laws[] = {
    {"linear_triangles_are_those_of_the_body",
     linear_triangles_are_those_of_the_body},
    {"an_element_goes_where_its_nodes_are",
     an_element_goes_where_its_nodes_are},
    {"what_nothing_holds_is_not_solved", what_nothing_holds_is_not_solved},
};

UNIT_MAIN("elements", laws)
