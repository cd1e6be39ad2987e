/*
 * second.c - what does a second right-hand side cost, and how much memory?
 *
 * K of the stretch, both ends held, in a band of half bandwidth 2 n - 1 and by
 * nested dissection with the fronts of sparse.h: flops of a factorisation over
 * those of a solve, and megabytes of the band and of K with L.  Counted.
 */
#include "linear/matrix.h"
#include "linear/sparse.h"
#include "plane/mesh.h"
#include "base/study.h"
#include "base/table.h"

#include <stdlib.h>

enum { LARGEST = 256 };

static struct sparse *dissected(int n)
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

int main(void)
{
    double most = 0.0; /* megabytes with the room to work */
    table_begin_note("second", "n band dissection band_megabytes megabytes",
                     "flops of a factorisation over those of a solve");
    for (int n = 32; n <= LARGEST; n *= 2) {
        const struct matrix_cost band =
            matrix_cost(BANDED, 2 * (n - 1) * (n + 1), 2 * n - 1);
        struct sparse *s = dissected(n);
        const double entries = 4.0 * s->start[s->n_vertex]; /* of K */
        table_row(n, band.flops / band.solve, s->flops / s->solve,
                  8e-6 * band.numbers, 8e-6 * (entries + s->numbers));
        most = 8e-6 * (entries + (double)sparse_size(s, 0));
        sparse_free(s);
    }
    table_end();
    claim(most < 220.0, "n = %d in 220 megabytes (%g)", LARGEST, most);
    return table_finish();
}
