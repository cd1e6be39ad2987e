/* elements.c - see elements.h. */
#include "plane/elements.h"

#include <stdlib.h>
#include <string.h>

struct elements *elements_alloc(const struct mesh *mesh, int reach)
{
    struct elements *elements = allocate(1, sizeof *elements);
    const int apart = reach * (mesh->n + 2); /* vertices, at most */
    elements->mesh = mesh;
    elements->K = matrix_alloc(BANDED, 2 * mesh->n_vertex, 2 * apart + 1);
    elements->f =
        allocate(2 * (size_t)mesh->n_vertex, sizeof *elements->f);
    return elements;
}

void elements_free(struct elements *elements)
{
    if (!elements) return;
    matrix_free(elements->K);
    free(elements->f);
    free(elements);
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

enum status elements_solve(struct elements *elements, const int held[],
                           double u[])
{
    const int n_vertex = elements->mesh->n_vertex;
    int *row = allocate(2 * (size_t)n_vertex, sizeof *row), n_row = 0;
    double *zero = allocate(2 * (size_t)n_vertex, sizeof *zero);
    for (int a = 0; a < n_vertex; a++) {
        if (!held[a]) continue;
        row[n_row++] = 2 * a;
        row[n_row++] = 2 * a + 1;
    }
    matrix_dirichlet(elements->K, elements->f, n_row, row, zero,
                     KEEP_DIAGONAL);
    const enum status status = matrix_factor(elements->K);
    if (status == OK) {
        matrix_solve(elements->K, elements->f);
        memcpy(u, elements->f, 2 * (size_t)n_vertex * sizeof *u);
    }
    free(row);
    free(zero);
    return status;
}
