/* dissected.c - see dissected.h. */
#include "dissected.h"

#include "plane/mesh.h"

#include <stdlib.h>

struct sparse *dissected(int n)
{
    struct mesh *mesh = mesh_square(n);
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = a % (n + 1) == 0 || a % (n + 1) == n;
    struct sparse *s = sparse_alloc(n + 1, n + 1, mesh->n_triangle,
                                    mesh->triangle, held, SPARSE_LEAF);
    mesh_free(mesh);
    free(held);
    return s;
}
