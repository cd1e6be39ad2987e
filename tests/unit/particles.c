/* particles.c - laws of particles.h: what kernels are, and what the way to the
 * grid and back keeps. */
#include "particles/particle_scene.h"

#include "../oracle/particles.h"
#include "unit.h"

#include <math.h>
#include <string.h>

/* Some places in cells, one of them on a node, one beside it, one before 0. */
static const double PLACES[] = {2.385, 7.5, 4.0, 3.9999, 5.1271, -1.3077};

/* Sums over the nodes of an axis; round-off of numbers of size 10. */
static void weights_reproduce_one_and_x(void)
{
    const double h = 0.385;
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int k = 0; k < COUNT(PLACES); k++) {
            double w[ORDER_MAX + 1], dw[ORDER_MAX + 1], one = 0.0, x = 0.0;
            double zero = 0.0, slope = 0.0, D = 0.0;
            const double at = PLACES[k] * h;
            const int first = kernel_weights(order, h, at, w, dw);
            for (int q = 0; q <= order; q++) {
                const double node = h * (first + q);
                ck_assert_double_ge(w[q], 0.0);
                one += w[q];
                x += w[q] * node;
                zero += dw[q];
                slope += dw[q] * node;
                D += w[q] * (node - at) * (node - at);
            }
            close_to(one, 1.0, 1e-14);
            close_to(x, at, 1e-14);
            close_to(zero, 0.0, 1e-14);
            close_to(slope, 1.0, 1e-13);
            close_to(D, kernel_inertia(order, h, at), 1e-14);
        }
}

/* Seven particles, or the same on a bar, and a grid that has room for them. */
struct scene {
    struct grid *grid;
    struct particles *p;
};
static struct scene seven(int order, int rows, int affine)
{
    const double origin[2] = {-2.0 * oracle_h, rows > 1 ? -oracle_h : 0.0};
    const int nodes[2] = {11, rows};
    struct grid *grid = grid_alloc(order, origin, oracle_h, nodes);
    return (struct scene){grid, particles_seven(affine ? grid : NULL)};
}

static void scene_free(struct scene scene)
{
    grid_free(scene.grid);
    particles_free(scene.p);
}

/* u(x) = a + G x at the nodes. */
static const double A[] = {0.31, -0.47};
static const mat2 G = {{{0.385, -1.271}, {0.713, 0.2385}}};
static void affine(const struct grid *grid, double u[])
{
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        for (int k = 0; k < 2; k++)
            u[2 * a + k] = A[k] + G.m[k][0] * x[0] + G.m[k][1] * x[1];
    }
}

static void a_support_reproduces_affine_fields(void)
{
    for (int order = 1; order <= ORDER_MAX; order++) {
        struct scene scene = seven(order, 10, 0);
        affine(scene.grid, scene.grid->v);
        for (int q = 0; q < scene.p->n; q++) {
            const double *x = &scene.p->x[2 * q];
            struct support s;
            double u[2], D[2] = {0.0, 0.0}, place[2];
            ck_assert(grid_support(scene.grid, x, &s) == OK);
            ck_assert_int_eq(s.n, (order + 1) * (order + 1));
            support_value(&s, scene.grid->v, u);
            const mat2 slope = support_gradient(&s, scene.grid->v);
            for (int k = 0; k < 2; k++) {
                close_to(u[k], A[k] + G.m[k][0] * x[0] + G.m[k][1] * x[1],
                         1e-14);
                for (int l = 0; l < 2; l++)
                    close_to(slope.m[k][l], G.m[k][l], 1e-13);
            }
            for (int i = 0; i < s.n; i++) {
                grid_place(scene.grid, s.node[i], place);
                for (int k = 0; k < 2; k++) {
                    close_to(place[k] - x[k], s.offset[i][k], 1e-14);
                    D[k] += s.w[i] * s.offset[i][k] * s.offset[i][k];
                }
            }
            for (int k = 0; k < 2; k++) close_to(D[k], s.inertia[k], 1e-14);
        }
        scene_free(scene);
    }
}

/* Beyond the nodes of any side by the smallest step, and not before. */
static void outside_is_named(void)
{
    const double origin[2] = {-0.5, 0.25}, h = 0.125;
    const int nodes[2] = {8, 9};
    for (int order = 1; order <= ORDER_MAX; order++) {
        struct grid *grid = grid_alloc(order, origin, h, nodes);
        const double margin = order == 1 ? 0.0 : order == 2 ? 0.5 : 1.0;
        struct support s;
        for (int k = 0; k < 2; k++) {
            const double low = origin[k] + margin * h;
            const double high = origin[k] + (nodes[k] - 1 - margin) * h;
            const double x[] = {low, low - 1e-12, high - 1e-12, high + 1e-12,
                                NAN, INFINITY,    -1e300,       1e300};
            const enum status want[] = {OK,        OUTSIDE,   OK,      OUTSIDE,
                                        NONFINITE, NONFINITE, OUTSIDE, OUTSIDE};
            for (int i = 0; i < COUNT(x); i++) {
                double place[2] = {0.0, 0.75};
                place[k] = x[i];
                ck_assert_str_eq(status_name(grid_support(grid, place, &s)),
                                 status_name(want[i]));
            }
        }
        grid_free(grid);
    }
}

static void a_period_leads_around(void)
{
    const double origin[2] = {-0.5, 0.25}, h = 0.125;
    const int nodes[2] = {8, 9};
    for (int order = 1; order <= ORDER_MAX; order++) {
        struct grid *grid = grid_alloc(order, origin, h, nodes);
        grid->periodic = 1;
        for (int turn = -3; turn <= 3; turn++) {
            struct support s, again;
            const double x[2] = {0.4271, 0.75},
                         there[2] = {0.4271 + turn, 0.75};
            ck_assert(grid_support(grid, x, &s) == OK);
            ck_assert(grid_support(grid, there, &again) == OK);
            for (int i = 0; i < s.n; i++) {
                ck_assert_int_eq(s.node[i], again.node[i]);
                ck_assert(s.node[i] >= 0 && s.node[i] < grid->n_node);
                close_to(s.w[i], again.w[i], 1e-13);
                close_to(s.offset[i][0], again.offset[i][0], 1e-14);
                ck_assert(fabs(s.offset[i][0]) <= 2.0 * h);
            }
        }
        grid_free(grid);
    }
}

/* All rows: moments, the kick, a particle at the end.  5e-15 is round-off of
 * some hundred sums of numbers of size 1. */
static void transfers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_transfer); k++) {
        const int order = oracle_transfer[k].order;
        const enum transfer how = (enum transfer)oracle_transfer[k].transfer;
        struct scene scene = seven(order, 10, how == APIC);
        struct grid *grid = scene.grid;
        close_to(particles_moments(scene.p).angular, oracle_transfer[k].before,
                 5e-15);
        ck_assert(grid_p2g(grid, scene.p) == OK);
        close_to(grid_moments(grid, grid->v).angular, oracle_transfer[k].grid,
                 5e-15);
        int nodes = 0;
        for (int a = 0; a < grid->n_node; a++) {
            nodes += grid->mass[a] > 0.0;
        }
        if (oracle_transfer[k].kicked)
            grid_kick(grid, oracle_kick, oracle_kick_w);
        ck_assert_int_eq(nodes, oracle_transfer[k].nodes);
        const struct moments moved = grid_moments(grid, grid->next);
        close_to(moved.angular, oracle_transfer[k].grid_after, 5e-14);
        close_to(moved.kinetic, oracle_transfer[k].kinetic_grid, 5e-14);
        ck_assert(grid_g2p(grid, how, oracle_dt, scene.p) == OK);
        const struct moments after = particles_moments(scene.p);
        close_to(after.angular, oracle_transfer[k].after, 5e-14);
        close_to(after.kinetic, oracle_transfer[k].kinetic_after, 5e-14);
        for (int i = 0; i < 2; i++) {
            close_to(after.momentum[i], moved.momentum[i], 5e-15);
            close_to(scene.p->x[6 + i], oracle_transfer[k].x[i], 5e-15);
            close_to(scene.p->v[6 + i], oracle_transfer[k].v[i], 2e-14);
        }
        for (int i = 0; i < 4; i++)
            close_to(scene.p->B[3].m[i / 2][i % 2], oracle_transfer[k].B[i],
                     5e-15);
        scene_free(scene);
    }
}

/* F := (I + dt G) F for v = A + G x, whatever F was. */
static void F_follows_the_grid(void)
{
    struct scene scene = seven(2, 10, 0);
    const mat2 F = {{{1.17, 0.23}, {-0.11, 0.94}}};
    const mat2 want = mat2_add(F, mat2_multiply(mat2_scale(oracle_dt, G), F));
    scene.p->F[0] = mat2_identity();
    scene.p->F[5] = F;
    affine(scene.grid, scene.grid->next);
    ck_assert(grid_g2p(scene.grid, PIC, oracle_dt, scene.p) == OK);
    close_to(mat2_norm(mat2_subtract(scene.p->F[5], want)), 0.0, 1e-14);
    close_to(mat2_norm(mat2_subtract(
                 scene.p->F[0],
                 mat2_add(mat2_identity(), mat2_scale(oracle_dt, G)))),
             0.0, 1e-14);
    scene_free(scene);
}

static void a_box_is_filled(void)
{
    const double low[2] = {0.2, -0.5}, high[2] = {1.4, 0.5};
    const int count[2] = {6, 4};
    struct particles *p = particles_box(low, high, count, 2.385);
    const struct moments all = particles_moments(p);
    double volume = 0.0;
    ck_assert_int_eq(p->n, 24);
    close_to(all.mass, 2.385 * 1.2, 1e-14);
    for (int q = 0; q < p->n; q++) {
        volume += p->volume[q];
        ck_assert(mat2_norm(mat2_subtract(p->F[q], mat2_identity())) == 0.0);
    }
    close_to(volume, 1.2, 1e-14);
    close_to(p->x[2 * 13], 0.5, 1e-15);
    close_to(p->x[2 * 13 + 1], 0.125, 1e-15);
    particles_free(p);
    particles_free(NULL);
    grid_free(NULL);
}

/* Counts, angular momenta at the start, and what PIC leaves of them. */
static void the_disc_is_the_oracles(void)
{
    const double origin[2] = {0.0, 0.0}, centre[2] = {0.5, 0.5};
    const double rest[2] = {0.0, 0.0};
    for (int k = 0; k < 4; k++) {
        const int cells = oracle_disc[k].cells,
                  nodes[2] = {cells + 1, cells + 1};
        const double h = 1.0 / cells;
        struct grid *grid = grid_alloc(oracle_disc[k].order, origin, h, nodes);
        struct particles *p = particles_disc(centre, 0.3, 0.5 * h, 1.0);
        ck_assert_int_eq(p->n, oracle_disc[k].n);
        ck_assert(particles_turn(p, grid, rest, 1.0, centre) == OK);
        close_to(particles_moments(p).angular, oracle_disc[k].L_APIC, 1e-14);
        ck_assert(particles_turn(p, NULL, rest, 1.0, centre) == OK);
        close_to(particles_moments(p).angular, oracle_disc[k].L_PIC, 1e-14);
        for (int step = 1; step <= 100; step++) {
            ck_assert(grid_p2g(grid, p) == OK);
            ck_assert(grid_g2p(grid, PIC, 0.0, p) == OK);
            const double left =
                particles_moments(p).angular / oracle_disc[k].L_PIC;
            if (step == 1) close_to(left, oracle_disc[k].once, 1e-12);
            if (step == 100) close_to(left, oracle_disc[k].hundred, 1e-12);
        }
        grid_free(grid);
        particles_free(p);
    }
    /* a lattice that is not the origin's neighbour, with a density */
    const double there[2] = {-3.2385, 1.7};
    struct particles *p = particles_disc(there, 0.2385, 0.01, 3.0);
    close_to(particles_moments(p).mass, 3.0 * 3.14159 * 0.2385 * 0.2385, 5e-3);
    ck_assert(particles_turn(p, NULL, A, 2.0, there) == OK);
    close_to(p->v[0], A[0] - 2.0 * (p->x[1] - there[1]), 1e-15);
    close_to(p->v[1], A[1] + 2.0 * (p->x[0] - there[0]), 1e-15);
    particles_free(p);
}

/* On a periodic bar, at the oracle's wavelengths, many particles per cell; the
 * sum over the particles is a rule of quadrature of order 3 or more, whose
 * error at 64 per cell is far below 1e-4. */
static void a_wave_is_filtered_as_predicted(void)
{
    const double low[2] = {0.0, -0.5}, high[2] = {16.0, 0.5};
    const int nodes[2] = {16, 1}, count[2] = {16 * 64, 1};
    struct particles *p = particles_box(low, high, count, 1.0);
    for (int order = 1; order <= ORDER_MAX; order++) {
        struct grid *grid = grid_alloc(order, low, 1.0, nodes);
        grid->periodic = 1;
        for (int cells = 16; cells >= 8; cells /= 2)
            for (int how = PIC; how <= APIC; how++) {
                const double k = 2.0 * acos(-1.0) / cells;
                ck_assert(particles_wave(p, how == APIC ? grid : NULL, k) ==
                          OK);
                close_to(particles_wave_part(p, k), 1.0, 1e-14);
                ck_assert(grid_p2g(grid, p) == OK);
                ck_assert(grid_g2p(grid, (enum transfer)how, 0.0, p) == OK);
                const double part = particles_wave_part(p, k);
                /* linear: the slope jumps at nodes, errors of order 2 in k h
                 * remain in APIC, whose D is not constant */
                if (order > 1 || how != APIC)
                    close_to(part,
                             transfer_factor(order, (enum transfer)how, k),
                             order > 1 ? 2e-4 : 2e-3);
            }
        grid_free(grid);
    }
    particles_free(p);
    /* the oracle's numbers, of 4 particles per cell */
    close_to(transfer_factor(1, PIC, acos(-1.0) / 8.0), 0.9745931220856417,
             1e-14);
    close_to(transfer_factor(2, PIC, acos(-1.0) / 8.0), 0.962132784086126,
             1e-14);
    close_to(transfer_factor(3, PIC, acos(-1.0) / 2.0), 0.4316790442127104,
             1e-14);
    close_to(transfer_factor(2, APIC, acos(-1.0) / 8.0), 0.9993210873149154,
             5e-6);
    close_to(transfer_factor(3, APIC, acos(-1.0) / 4.0), 0.9822469447088498,
             5e-5);
}

/* A cloud is the scene that its parts make, with B for APIC alone. */
static void a_cloud_is_ready_to_go(void)
{
    static const char *const word[] = {"PIC", "FLIP", "APIC"};
    for (int how = PIC; how <= APIC; how++) {
        const enum transfer transfer = (enum transfer)how;
        const double k = acos(-1.0) / 4.0;
        ck_assert_str_eq(transfer_name(transfer), word[how]);
        const struct cloud cloud[] = {cloud_seven(2, transfer),
                                      cloud_disc(3, 16, transfer),
                                      cloud_wave(2, 16, 4, k, transfer)};
        const double L[] = {how == APIC ? 0.50088734125 : 0.47704535,
                            how == APIC ? oracle_disc[1].L_APIC
                                        : oracle_disc[1].L_PIC};
        ck_assert_int_eq(cloud[1].p->n, 284);
        ck_assert_int_eq(cloud[2].p->n, 64);
        close_to(particles_moments(cloud[2].p).mass, 16.0, 1e-13);
        double corner[2];
        grid_place(cloud[0].grid, 0, corner);
        ck_assert(corner[0] == -0.77 && corner[1] == -0.77);
        ck_assert_int_eq(cloud[0].grid->n_node, 11 * 11);
        ck_assert_int_eq(cloud[1].grid->n_node, 17 * 17);
        ck_assert_int_eq(cloud[2].grid->n_node, 16);
        grid_place(cloud[0].grid, 11 * 11 - 1, corner);
        close_to(corner[0], 8 * 0.385, 1e-15);
        close_to(corner[1], 8 * 0.385, 1e-15);
        close_to(particles_wave_part(cloud[2].p, k), 1.0, 1e-14);
        for (int c = 0; c < 3; c++) {
            double B = 0.0;
            for (int q = 0; q < cloud[c].p->n; q++)
                B += mat2_norm(cloud[c].p->B[q]);
            ck_assert((B > 0.0) == (how == APIC));
            if (c < 2)
                close_to(particles_moments(cloud[c].p).angular, L[c], 1e-14);
            ck_assert(grid_p2g(cloud[c].grid, cloud[c].p) == OK);
            ck_assert(grid_g2p(cloud[c].grid, transfer, 0.0, cloud[c].p) == OK);
            cloud_free(cloud[c]);
        }
    }
}

UNIT_MAIN("particles",
    LAW(weights_reproduce_one_and_x),
    LAW(a_support_reproduces_affine_fields),
    LAW(outside_is_named),
    LAW(a_period_leads_around),
    LAW(transfers_are_the_oracles),
    LAW(F_follows_the_grid),
    LAW(a_box_is_filled),
    LAW(a_wave_is_filtered_as_predicted),
    LAW(the_disc_is_the_oracles),
    LAW(a_cloud_is_ready_to_go))
