/* free_bar.c - see free_bar.h. */
#include "free_bar.h"

#include <math.h>
#include <stdlib.h>

/* A bar from `first` to first + 1 and a grid of -2 h to `room`. */
static struct cloud bar(int order, double h, double first, int count,
                        double room)
{
    const double low[2] = {-2.0 * h, -0.5};
    const double ends[2][2] = {{first, -0.5}, {first + 1.0, 0.5}};
    const int nodes[2] = {(int)lround(room / h) + 3, 1};
    return (struct cloud){
        grid_alloc(order, low, h, nodes),
        particles_box(ends[0], ends[1], (int[]){count, 1}, 1.0)};
}

struct cloud free_bar_ringing(int order, int cells, double a,
                              enum transfer transfer)
{
    const double first = 0.5003;
    struct cloud c = bar(order, 1.0 / cells, first, 2 * cells, 2.0);
    const double pi = acos(-1.0);
    for (int q = 0; q < c.p->n; q++) {
        const double X = c.p->x[2 * q] - first;
        c.p->v[2 * q] = a * cos(pi * X);
        if (transfer == APIC)
            c.p->B[q].m[0][0] = -a * pi * sin(pi * X) *
                                kernel_inertia(order, 1.0 / cells, first + X);
    }
    return c;
}

struct cloud free_bar_outlying(int order, double eps)
{
    const double h = 0.125, last = ((order == 2 ? 9.5 : 9.0) + eps) * h;
    /* all places are multiples of the last digit of `last`, none is rounded */
    return bar(order, h, last - 1.0 + 0.25 * h, 16, 1.5);
}

/* omega^2 is the largest eigenvalue of M^-1/2 K M^-1/2. */
double free_bar_frequency(const struct particle_body *body)
{
    struct unknowns *map = unknowns_alloc(body->grid);
    const size_t n_dof = (size_t)map->n_dof;
    double *u = allocate(n_dof, sizeof *u), *m = allocate(n_dof, sizeof *m);
    double *value = allocate(n_dof, sizeof *value), omega = NAN;
    unknowns_number(body->grid, NO_WALL, map);
    struct matrix *K = matrix_alloc(BANDED, map->n, map->n);
    struct matrix *A = matrix_alloc(DENSE, map->n, 0);
    for (int r = 0; r < map->n_dof; r++)
        if (map->equation[r] >= 0)
            m[map->equation[r]] = body->grid->mass[r / 2];
    if (particle_stiffness(body, u, map->equation, map->sign, K) == OK) {
        for (int i = 0; i < map->n; i++)
            for (int j = 0; j < map->n; j++)
                matrix_add(A, i, j, matrix_get(K, i, j) / sqrt(m[i] * m[j]));
        if (matrix_eigenvalues(A, value) == OK)
            omega = sqrt(value[map->n - 1]);
    }
    matrix_free(K);
    matrix_free(A);
    unknowns_free(map);
    free(u);
    free(m);
    free(value);
    return omega;
}
