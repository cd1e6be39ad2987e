/* quadratic.c - see quadratic.h. */
#include "plane/quadratic.h"

#include "base/status.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum { NODES = QUADRATIC_NODES, POINTS = QUADRATIC_POINTS };

/* The points of the rule: barycentric coordinates [eq:three-points]. */
static const double point[POINTS][3] = {{2.0 / 3, 1.0 / 6, 1.0 / 6},
                                        {1.0 / 6, 2.0 / 3, 1.0 / 6},
                                        {1.0 / 6, 1.0 / 6, 2.0 / 3}};

void quadratic_shape(const double l[3], const double of_l[6], double N[6],
                     double gradient[12])
{
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3; /* edge bc faces a */
        N[a] = l[a] * (2.0 * l[a] - 1.0);
        N[3 + a] = 4.0 * l[b] * l[c];
        for (int j = 0; j < 2; j++) {
            gradient[2 * a + j] = (4.0 * l[a] - 1.0) * of_l[2 * a + j];
            gradient[2 * (3 + a) + j] =
                4.0 * (l[b] * of_l[2 * c + j] + l[c] * of_l[2 * b + j]);
        }
    }
}

void quadratic_nodes(const struct mesh *mesh, int e, int node[NODES])
{
    const int row = mesh->n + 1, per_row = mesh->n / 2;
    const int square = e / 2, i = square % per_row, j = square / per_row;
    const int low = 2 * j * row + 2 * i; /* the lower left corner */
    const int below[NODES] = {0, 2, 2 * row + 2, row + 2, row + 1, 1};
    const int above[NODES] = {0, 2 * row + 2, 2 * row, 2 * row + 1, row,
                              row + 1};
    const int *from_low = e % 2 == 0 ? below : above;
    for (int a = 0; a < NODES; a++) node[a] = low + from_low[a];
}

void quadratic_straighten(struct mesh *mesh)
{
    assert(mesh->n % 2 == 0 && mesh->rows % 2 == 0);
    for (int e = 0; e < mesh->n * mesh->rows / 2; e++) {
        int node[NODES];
        quadratic_nodes(mesh, e, node);
        for (int a = 0; a < 3; a++)
            for (int j = 0; j < 2; j++)
                mesh->X[2 * node[3 + a] + j] =
                    0.5 * (mesh->X[2 * node[(a + 1) % 3] + j] +
                           mesh->X[2 * node[(a + 2) % 3] + j]);
    }
}

/* Return the gradients of l of a triangle and its area, which is > 0; the edges
 * are straight to round-off, and the nodes in their middles. */
static double corner_gradients(const struct mesh *mesh, const int node[NODES],
                               double of_l[6])
{
    const double area = mesh_gradients_of(mesh, node, of_l);
    assert(area > 0.0);
    for (int a = 0; a < 3; a++)
        for (int j = 0; j < 2; j++)
            assert(fabs(mesh->X[2 * node[3 + a] + j] -
                        0.5 * (mesh->X[2 * node[(a + 1) % 3] + j] +
                               mesh->X[2 * node[(a + 2) % 3] + j])) <=
                   1e-9 * sqrt(area));
    return area;
}

double quadratic_gradients(const struct mesh *mesh, int e,
                           double gradient[POINTS][2 * NODES])
{
    int node[NODES];
    double of_l[6], N[NODES];
    quadratic_nodes(mesh, e, node);
    const double area = corner_gradients(mesh, node, of_l);
    for (int p = 0; p < POINTS; p++)
        quadratic_shape(point[p], of_l, N, gradient[p]);
    return area;
}

void quadratic_shares(const struct mesh *mesh, double area[])
{
    memset(area, 0, (size_t)mesh->n_vertex * sizeof *area);
    for (int e = 0; e < mesh->n * mesh->rows / 2; e++) {
        int node[NODES];
        double of_l[6];
        quadratic_nodes(mesh, e, node);
        /* 3 (3/57 + 16/57) = 1: nothing of the mass is lost */
        const double all = corner_gradients(mesh, node, of_l);
        for (int a = 0; a < NODES; a++)
            area[node[a]] += all * (a < 3 ? 3.0 : 16.0) / 57.0;
    }
}

void quadratic_load(const struct mesh *mesh, const double density[2],
                    double f[])
{
    for (int e = 0; e < mesh->n * mesh->rows / 2; e++) {
        int node[NODES];
        double of_l[6];
        quadratic_nodes(mesh, e, node);
        /* int N_a dA: A/3 in a middle, 0 at a vertex */
        const double third = corner_gradients(mesh, node, of_l) / 3.0;
        for (int a = 3; a < NODES; a++)
            for (int i = 0; i < 2; i++)
                f[2 * node[a] + i] += third * density[i];
    }
}

int *quadratic_pairs(const struct mesh *mesh, int *n_list)
{
    static const int triple[][3] = {{0, 1, 2}, {0, 3, 4}, {0, 5, 3},
                                    {1, 3, 4}, {1, 5, 4}, {2, 3, 4},
                                    {2, 5, 3}};
    const int n_triple = (int)(sizeof triple / sizeof *triple);
    const int n_element = mesh->n * mesh->rows / 2;
    *n_list = n_triple * n_element;
    int *list = allocate(3 * (size_t)*n_list, sizeof *list), *next = list;
    for (int e = 0; e < n_element; e++) {
        int node[NODES];
        quadratic_nodes(mesh, e, node);
        for (int k = 0; k < n_triple; k++)
            for (int c = 0; c < 3; c++) *next++ = node[triple[k][c]];
    }
    return list;
}
