/* particle_scene.c - see particle_scene.h. */
#include "particles/particle_scene.h"

#include <assert.h>
#include <math.h>

/* (m), (m/s), (1/s), -, (kg), (m^2); tensors row by row. */
static const struct {
    double x[2], v[2], C[4], F[4], mass, volume;
} SEVEN[] = {
    {{0.913, 1.071},
     {1.31, -0.72},
     {0.7, -1.3, 2.1, 0.4},
     {1.17, 0.23, -0.31, 0.88},
     0.137,
     0.0371},
    {{1.237, 0.871},
     {-0.48, 2.17},
     {-0.9, 0.6, 1.7, -0.2},
     {0.82, -0.19, 0.27, 1.21},
     0.291,
     0.0289},
    {{1.349, 1.412},
     {0.29, 0.83},
     {1.1, 2.3, -0.5, 0.8},
     {1.36, 0.41, 0.12, 0.79},
     0.083,
     0.0413},
    {{1.583, 1.129},
     {-1.93, 0.37},
     {0.3, -0.7, 0.9, -1.6},
     {0.93, 0.08, -0.44, 1.14},
     0.214,
     0.0337},
    {{1.018, 1.537},
     {0.67, -1.51},
     {-1.2, 0.1, 0.5, 1.9},
     {1.05, -0.37, 0.29, 0.71},
     0.171,
     0.0298},
    {{1.461, 0.758},
     {2.38, 1.19},
     {2.2, -0.4, -1.1, 0.6},
     {0.76, 0.15, 0.09, 0.94},
     0.059,
     0.0356},
    {{0.801, 1.296},
     {-0.11, -2.06},
     {-0.3, 1.4, 0.2, -0.8},
     {1.22, -0.26, -0.18, 1.08},
     0.233,
     0.0401},
};

struct particles *particles_seven(const struct grid *grid)
{
    struct particles *p =
        particles_alloc((int)(sizeof SEVEN / sizeof SEVEN[0]));
    for (int q = 0; q < p->n; q++) {
        struct support s = {.inertia = {0.0, 0.0}};
        for (int k = 0; k < 2; k++) {
            p->x[2 * q + k] = SEVEN[q].x[k];
            p->v[2 * q + k] = SEVEN[q].v[k];
        }
        p->mass[q] = SEVEN[q].mass;
        p->volume[q] = SEVEN[q].volume;
        const enum status status =
            grid ? grid_support(grid, SEVEN[q].x, &s) : OK;
        assert(status == OK);
        (void)status;
        for (int k = 0; k < 2; k++)
            for (int l = 0; l < 2; l++) {
                p->F[q].m[k][l] = SEVEN[q].F[2 * k + l];
                p->B[q].m[k][l] = SEVEN[q].C[2 * k + l] * s.inertia[l];
            }
    }
    return p;
}

struct particles *particles_disc(const double centre[2], double radius,
                                 double spacing, double rho)
{
    const int reach = (int)ceil(radius / spacing) + 1;
    const int i0 = (int)floor(centre[0] / spacing) - reach;
    const int j0 = (int)floor(centre[1] / spacing) - reach;
    const double low[2] = {i0 * spacing, j0 * spacing};
    const int count[2] = {2 * reach + 2, 2 * reach + 2};
    const double high[2] = {(i0 + count[0]) * spacing,
                            (j0 + count[1]) * spacing};
    struct particles *p = particles_box(low, high, count, rho);
    int kept = 0;
    for (int q = 0; q < p->n; q++)
        if (hypot(p->x[2 * q] - centre[0], p->x[2 * q + 1] - centre[1]) <
            radius) {
            p->x[2 * kept] = p->x[2 * q];
            p->x[2 * kept + 1] = p->x[2 * q + 1];
            kept++;
        }
    p->n = kept;
    return p;
}

enum status particles_turn(struct particles *p, const struct grid *grid,
                           const double v[2], double omega,
                           const double centre[2])
{
    for (int q = 0; q < p->n; q++) {
        struct support s = {.inertia = {0.0, 0.0}};
        const enum status status =
            grid ? grid_support(grid, &p->x[2 * q], &s) : OK;
        if (status != OK) return status;
        p->v[2 * q] = v[0] - omega * (p->x[2 * q + 1] - centre[1]);
        p->v[2 * q + 1] = v[1] + omega * (p->x[2 * q] - centre[0]);
        p->B[q] =
            (mat2){{{0.0, -omega * s.inertia[1]}, {omega * s.inertia[0], 0.0}}};
    }
    return OK;
}

void grid_shake(const struct grid *grid, double size, double u[])
{
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        const long i = lround(x[0] / grid->h), j = lround(x[1] / grid->h);
        /* three primes, so that neighbours have nothing in common */
        for (int k = 0; k < 2; k++) {
            const long mixed =
                7919 * (i + 11) + 104729 * (j + 13) + 1299709 * (k + 1);
            u[2 * a + k] = size * ((double)(mixed % 1009) / 1009.0 - 0.5);
        }
    }
}

void grid_kick(struct grid *grid, const double v[2], double omega)
{
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        grid->next[2 * a] = grid->v[2 * a] + v[0] - omega * x[1];
        grid->next[2 * a + 1] = grid->v[2 * a + 1] + v[1] + omega * x[0];
    }
}

enum status particles_wave(struct particles *p, const struct grid *grid,
                           double k)
{
    for (int q = 0; q < p->n; q++) {
        struct support s = {.inertia = {0.0, 0.0}};
        const enum status status =
            grid ? grid_support(grid, &p->x[2 * q], &s) : OK;
        if (status != OK) return status;
        p->v[2 * q] = cos(k * p->x[2 * q]);
        p->v[2 * q + 1] = 0.0;
        p->B[q] = (mat2){{{0.0}}};
        p->B[q].m[0][0] = -k * sin(k * p->x[2 * q]) * s.inertia[0];
    }
    return OK;
}

double particles_wave_part(const struct particles *p, double k)
{
    double part = 0.0, whole = 0.0;
    for (int q = 0; q < p->n; q++) {
        const double wave = cos(k * p->x[2 * q]);
        part += p->v[2 * q] * wave;
        whole += wave * wave;
    }
    return part / whole;
}

struct cloud cloud_seven(int order, enum transfer transfer)
{
    const double h = 0.385, low[2] = {-2.0 * h, -2.0 * h};
    const int nodes[2] = {11, 11};
    struct cloud cloud = {.grid = grid_alloc(order, low, h, nodes)};
    cloud.p = particles_seven(transfer == APIC ? cloud.grid : NULL);
    return cloud;
}

struct cloud cloud_disc(int order, int cells, enum transfer transfer)
{
    const double h = 1.0 / cells, low[2] = {-0.5, -0.5}, zero[2] = {0.0, 0.0};
    const int nodes[2] = {cells + 1, cells + 1};
    struct cloud cloud = {grid_alloc(order, low, h, nodes),
                          particles_disc(zero, 0.3, 0.5 * h, 1.0)};
    const enum status status = particles_turn(
        cloud.p, transfer == APIC ? cloud.grid : NULL, zero, 1.0, zero);
    assert(status == OK);
    (void)status;
    return cloud;
}

struct cloud cloud_wave(int order, int cells, int ppc, double k,
                        enum transfer transfer)
{
    const double low[2] = {0.0, -0.5}, high[2] = {cells, 0.5};
    const int nodes[2] = {cells, 1}, count[2] = {cells * ppc, 1};
    struct cloud cloud = {grid_alloc(order, low, 1.0, nodes),
                          particles_box(low, high, count, 1.0)};
    cloud.grid->periodic = 1;
    const enum status status =
        particles_wave(cloud.p, transfer == APIC ? cloud.grid : NULL, k);
    assert(status == OK);
    (void)status;
    return cloud;
}

struct cloud cloud_bar(int order, int cells, int ppc, double F, double shift)
{
    const double h = 1.0 / cells, low[2] = {-2.0 * h, -0.5};
    const int nodes[2] = {(int)ceil(F * cells + shift) + 5, 1};
    const double ends[2][2] = {{0.0, -0.5}, {1.0, 0.5}};
    const int count[2] = {cells * ppc, 1};
    struct cloud bar = {grid_alloc(order, low, h, nodes),
                        particles_box(ends[0], ends[1], count, 1.0)};
    for (int q = 0; q < bar.p->n; q++) {
        bar.p->x[2 * q] = F * bar.p->x[2 * q] + shift * h;
        bar.p->F[q].m[0][0] = F;
    }
    const enum status status = grid_p2g(bar.grid, bar.p);
    assert(status == OK);
    (void)status;
    return bar;
}

struct inner cloud_bar_inner(struct cloud bar, const double f[])
{
    const double first = bar.p->x[0], last = bar.p->x[2 * (bar.p->n - 1)];
    const double edge = 0.5 * (last - first) / (bar.p->n - 1);
    const double room = 2.0 * bar.grid->h - edge;
    struct inner worst = {0.0, 0.0};
    for (int a = 0; a < bar.grid->n_node; a++) {
        double x[2];
        grid_place(bar.grid, a, x);
        if (x[0] < first + room || x[0] > last - room) continue;
        worst.force = fmax(worst.force, fabs(f[2 * a]));
        worst.acceleration =
            fmax(worst.acceleration, fabs(f[2 * a]) / bar.grid->mass[a]);
    }
    return worst;
}

void cloud_free(struct cloud cloud)
{
    grid_free(cloud.grid);
    particles_free(cloud.p);
}

double transfer_factor(int order, enum transfer transfer, double z)
{
    const double half = 0.5 * z, S = pow(sin(half) / half, order + 1);
    const double z_slope = S * (order + 1) * (half / tan(half) - 1.0);
    if (transfer == FLIP) return 1.0;
    return transfer == PIC ? S * S : S * (S - z_slope);
}
