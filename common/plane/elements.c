/* elements.c - see elements.h. */
#include "plane/elements.h"

#include <stdlib.h>
#include <string.h>

struct elements *elements_alloc(const struct mesh *mesh, int reach)
{
    struct elements *elements = allocate(1, sizeof *elements);
    const int distance = reach * (mesh->n + 2); /* vertices, at most */
    elements->mesh = mesh;
    elements->K = matrix_alloc(BANDED, 2 * mesh->n_vertex, 2 * distance + 1);
    elements->f =
        allocate(2 * (size_t)mesh->n_vertex, sizeof *elements->f);
    elements->held = allocate((size_t)mesh->n_vertex, sizeof(int));
    return elements;
}

void elements_free(struct elements *elements)
{
    matrix_free(elements->K);
    free(elements->f);
    free(elements->held);
    free(elements);
}

void elements_cell(const struct mesh *mesh, int cell, int corner[4])
{
    const int *below = &mesh->triangle[6 * cell], *above = below + 3;
    memcpy(corner, below, 3 * sizeof *corner);
    corner[3] = above[2];
}

void elements_lattice(struct mesh *mesh, const double x[], const double y[])
{
    double *X = mesh->X;
    for (int j = 0; j <= mesh->rows; j++)
        for (int i = 0; i <= mesh->n; i++) {
            *X++ = x[i];
            *X++ = y[j];
        }
}

void elements_add(struct elements *elements, int count, const int node[],
                  const double E[])
{
    for (int a = 0; a < count; a++)
        for (int i = 0; i < 2; i++)
            for (int b = 0; b < count; b++)
                for (int j = 0; j < 2; j++)
                    matrix_add(elements->K, 2 * node[a] + i, 2 * node[b] + j,
                               *E++);
}

double elements_linear(struct elements *elements, const int vertex[3],
                       double mu, double lambda)
{
    double g[6], E[36], *entry = E;
    const double area = mesh_gradients_of(elements->mesh, vertex, g);
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++)
            for (int b = 0; b < 3; b++)
                for (int j = 0; j < 2; j++) {
                    const double *A = &g[2 * a], *B = &g[2 * b];
                    const double dot = A[0] * B[0] + A[1] * B[1];
                    *entry++ = area * (mu * ((i == j) * dot + A[j] * B[i]) +
                                       lambda * A[i] * B[j]);
                }
    elements_add(elements, 3, vertex, E);
    return area;
}

enum status elements_solve(struct elements *elements, double u[])
{
    const int n_vertex = elements->mesh->n_vertex;
    const double zero[2] = {0.0, 0.0};
    for (int a = 0; a < n_vertex; a++) {
        const int row[2] = {2 * a, 2 * a + 1};
        if (elements->held[a])
            matrix_dirichlet(elements->K, elements->f, 2, row, zero,
                             KEEP_DIAGONAL);
    }
    const enum status status = matrix_factor(elements->K);
    if (status != OK) return status;
    matrix_solve(elements->K, elements->f);
    memcpy(u, elements->f, 2 * (size_t)n_vertex * sizeof *u);
    return OK;
}
