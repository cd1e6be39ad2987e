/* film.c - see film.h. */
#include "motion/film.h"
#include "base/table.h"

void film_frame(const struct live *live, int every, int k,
                const struct pointer *pointer)
{
    const struct mesh *mesh = live->mesh;
    for (int e = 0; e < mesh->n_triangle && k % every == 0; e++) {
        double x[6];
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++) {
                const int r = 2 * mesh->triangle[3 * e + a] + i;
                x[2 * a + i] = mesh->X[r] + live->now.u[r];
            }
        table_row(k, mat2_det(body_deformation(live->body, live->now.u, e)),
                  x[0], x[1], x[2], x[3], x[4], x[5], pointer->x, pointer->y,
                  pointer->down);
    }
}
