/*
 * push.c - can an average of J reveal that triangles are inverted?
 *
 * The square (-1, 1)^2 of mesh.h, 16 cells per side, is pushed to the right
 * inside, its boundary held: x = X + s (1 - X^2)^2 (1 - Y^2)^2.  The map has
 * J = 1 - 4 s X (1 - X^2) (1 - Y^2)^2, which is negative somewhere iff |s| >
 * 3 sqrt(3)/8 = 0.6495.  The signed area that a closed curve encloses is a
 * matter of the curve alone, so the sum of J A is 4 whatever s is.
 */
#include "plane/mesh.h"
#include "base/status.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>

/* Sums over the triangles after a push; their areas are J A. */
struct census {
    int inverted;
    double signed_area, absolute_area, min_J;
};

static struct census push(const struct mesh *mesh, double s)
{
    struct census sum = {0, 0.0, 0.0, INFINITY};
    struct mesh moved = *mesh;
    moved.X = allocate(2 * (size_t)mesh->n_vertex, sizeof *moved.X);
    for (int a = 0; a < mesh->n_vertex; a++) {
        const double X = mesh->X[2 * a], Y = mesh->X[2 * a + 1];
        const double p = 1.0 - X * X, q = 1.0 - Y * Y;
        moved.X[2 * a] = X + s * p * p * q * q;
        moved.X[2 * a + 1] = Y;
    }
    for (int e = 0; e < mesh->n_triangle; e++) {
        double unused[6];
        const double A = mesh_gradients(mesh, e, unused);
        const double a = mesh_gradients(&moved, e, unused);
        sum.inverted += !(a > 0.0); /* catches NaN as well */
        sum.signed_area += a;
        sum.absolute_area += fabs(a);
        sum.min_J = fmin(sum.min_J, a / A);
    }
    free(moved.X);
    return sum;
}

int main(void)
{
    const double critical = 3.0 * sqrt(3.0) / 8.0;
    struct mesh *mesh = mesh_square(16);
    struct census sum = {0};
    double off = 0.0, late = 0.0;

    table_begin("push",
                "s inverted min_J exact_min_J signed_area absolute_area");
    for (int k = 0; k <= 8; k++) {
        const double s = 1.05 * k / 8;
        sum = push(mesh, s);
        table_row(s, sum.inverted, sum.min_J, 1.0 - s / critical,
                  sum.signed_area, sum.absolute_area);
        off = fmax(off, fabs(sum.signed_area - 4.0));
        late = fmax(late, fabs(sum.min_J - (1.0 - s / critical)));
    }
    table_end();
    const int before = push(mesh, 0.64).inverted;
    const int after = push(mesh, 0.66).inverted;
    mesh_free(mesh);

    claim(off < 1e-12, "the sum of J A is 4 in every row (off by %g)", off);
    claim(before == 0 && after > 0, "the mesh inverts near s = 0.6495 (%d "
          "triangles at 0.64, %d at 0.66)", before, after);
    claim(late < 0.015, "the least J of a triangle is that of the map to 0.015 "
          "(%g)", late);
    claim(sum.absolute_area > 4.2, "without signs the areas add up to more "
          "than 4.2 (%g)", sum.absolute_area);
    return table_finish();
}
