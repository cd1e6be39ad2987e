/* mesh.c - see mesh.h. */
#include "mesh.h"

#include "status.h"

#include <assert.h>
#include <stdlib.h>

struct mesh *mesh_square(int n)
{
    assert(n > 0);
    struct mesh *mesh = allocate(1, sizeof *mesh);
    mesh->n = n;
    mesh->n_vertex = (n + 1) * (n + 1);
    mesh->n_triangle = 2 * n * n;
    mesh->X = allocate(2 * (size_t)mesh->n_vertex, sizeof *mesh->X);
    mesh->triangle = allocate(3 * (size_t)mesh->n_triangle, sizeof(int));
    for (int a = 0; a < mesh->n_vertex; a++) {
        mesh->X[2 * a] = -1.0 + 2.0 * (a % (n + 1)) / n;
        mesh->X[2 * a + 1] = -1.0 + 2.0 * (a / (n + 1)) / n;
    }
    int *t = mesh->triangle;
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            const int a = j * (n + 1) + i, b = a + n + 1; /* left corners */
            *t++ = a, *t++ = a + 1, *t++ = b + 1;
            *t++ = a, *t++ = b + 1, *t++ = b;
        }
    return mesh;
}

void mesh_free(struct mesh *mesh)
{
    if (!mesh) return;
    free(mesh->X);
    free(mesh->triangle);
    free(mesh);
}

double mesh_gradients(const struct mesh *mesh, int e, double gradient[6])
{
    const int *t = &mesh->triangle[3 * e];
    const double *X[3] = {&mesh->X[2 * t[0]], &mesh->X[2 * t[1]],
                          &mesh->X[2 * t[2]]};
    const double twice = (X[1][0] - X[0][0]) * (X[2][1] - X[0][1]) -
                         (X[2][0] - X[0][0]) * (X[1][1] - X[0][1]);
    for (int a = 0; a < 3; a++) { /* the opposite edge, turned by 90 degrees */
        const double *from = X[(a + 1) % 3], *to = X[(a + 2) % 3];
        gradient[2 * a] = -(to[1] - from[1]) / twice;
        gradient[2 * a + 1] = (to[0] - from[0]) / twice;
    }
    return 0.5 * twice;
}

int mesh_clockwise(const struct mesh *mesh)
{
    double gradient[6];
    for (int e = 0; e < mesh->n_triangle; e++)
        if (!(mesh_gradients(mesh, e, gradient) > 0.0)) return e;
    return -1;
}
