/*
 * 18_mpm_transfer.c - what right weights and transfers satisfy.
 *
 * Arguments: slot, argument: varied by
 *   18a  order     each check of 18a
 *        h         weights_are_the_oracles, weights_are_continuous and others
 *        x         sums_are_those_of_the_derivation: on both sides of 0, on,
 *                  beside and between nodes
 *        w, dw     guarded in sums_are_those_of_the_derivation
 *   18b  p         p2g_keeps_mass_and_momentum (B or not, 2000),
 *                  p2g_does_every_node_and_no_other (two, equal masses)
 *        grid      the same (order, used before, full, h = 1), table `filter`
 *                  (a bar, periodic); expect_left
 *   18c  grid      with_all (order, next is not v), g2p_names_who_leaves
 *        scheme    with_all
 *        dt        check_places, flip_without_forces_is_the_identity (0)
 *        p         with_all; check_turning (PIC and FLIP with a B),
 *                  transfers_are_the_oracles
 *   18d  p         angular_counts_points_and_their_turning (B or not), table
 *                  `spin` (a disc)
 */
#include "program.h"

#include "judge.h"

#include "../oracle/particles.h"

#include <stdio.h>

#define ROUND_OFF 1e-14 /* of a few products; times h^-1 for gradients */
#define SUMS 1e-13      /* of a hundred products of numbers of size 1 */
#define ORACLE 1e-12    /* of ratios of such sums */

enum { SEVEN = ORACLE_PARTICLES, PLACES = 480 };

/* Places on, beside and between nodes, in cells, on both sides of 0: from -3 to
 * 0, where a cast to int rounds the other way than floor(), and from 3 to 6. */
static double place(int k)
{
    const double beside[] = {0.0, 1e-9, -1e-9, 0.5, 0.5 + 1e-9, 0.5 - 1e-9};
    const double from = k % 2 ? -3.0 : 3.0;
    k /= 2;
    if (k < 24) return from + k / 6 % 4 + beside[k % 6];
    return from + 3.0 * fmod(0.6180339887 * k, 1.0);
}

/* Seven particles and a grid with the library's kernel, so that slot 18b is not
 * judged by slot 18a. */
struct pair {
    struct grid *grid;
    struct particles *p;
};
static struct pair seven(int order, int with_B)
{
    const double h = oracle_h, low[2] = {-2.0 * h, -2.0 * h};
    const int nodes[2] = {11, 11};
    struct pair pair = {.grid = grid_alloc(order, low, h, nodes)};
    pair.p = particles_seven(with_B ? pair.grid : NULL);
    return pair;
}

static void pair_free(struct pair pair)
{
    grid_free(pair.grid);
    particles_free(pair.p);
}

/* sum m (x cross v + B21 - B12), written apart from slot 18d. */
static double turning(const struct particles *p)
{
    return particles_moments(p).angular;
}

/* What P2G of the library makes, with the kick between where `kicked`. */
static void library_p2g(struct pair pair, int kicked)
{
    expect(grid_p2g(pair.grid, pair.p) == OK, "the library's P2G");
    if (kicked) grid_kick(pair.grid, oracle_kick, oracle_kick_w);
}

/* ---- 18a ----------------------------------------------------------------- */

static void sums_are_those_of_the_derivation(void)
{
    const double h = oracle_h;
    for (int order = 1; order <= 3; order++)
        for (int k = 0; k < PLACES; k++) {
            double *w = guarded_alloc(order + 1);
            double *dw = guarded_alloc(order + 1);
            const double x = h * place(k);
            const int first = weights(order, h, x, w, dw);
            double one = 0.0, at = 0.0, D = 0.0, zero = 0.0, slope = 0.0;
            for (int q = 0; q <= order; q++) {
                const double node = h * (first + q);
                one += w[q];
                at += w[q] * node;
                D += w[q] * (node - x) * (node - x);
                zero += dw[q];
                slope += dw[q] * node;
            }
            expect_close(one, 1.0, ROUND_OFF, 1.0,
                         "order %d, x = %.10g h: sum of w", order, x / h);
            expect_close(at, x, ROUND_OFF, 1.0,
                         "order %d, x = %.10g h: sum of w x_i", order, x / h);
            expect_close(zero, 0.0, ROUND_OFF, 1.0 / h,
                         "order %d, x = %.10g h: sum of dw", order, x / h);
            expect_close(slope, 1.0, ROUND_OFF, 1.0 / h,
                         "order %d, x = %.10g h: sum of dw x_i", order, x / h);
            expect_close(D, kernel_inertia(order, h, x), ROUND_OFF, 1.0,
                         "order %d, x = %.10g h: sum of w (x_i - x)^2", order,
                         x / h);
        }
}

static void weights_are_not_negative(void)
{
    for (int order = 1; order <= 3; order++)
        for (int k = 0; k < PLACES; k++) {
            double *w = guarded_alloc(order + 1);
            double *dw = guarded_alloc(order + 1);
            weights(order, oracle_h, oracle_h * place(k), w, dw);
            for (int q = 0; q <= order; q++)
                expect(w[q] >= -ROUND_OFF,
                       "order %d, x = %.10g h: w[%d] = %.10g, and masses must "
                       "not be negative", order, place(k), q, w[q]);
        }
}

/* The weight that `node` has for a particle at s cells. */
static double weight_of(int order, double s, int node)
{
    double w[ORDER_MAX + 1], dw[ORDER_MAX + 1];
    const int q = node - weights(order, 0.5, 0.5 * s, w, dw);
    return q >= 0 && q <= order ? w[q] : 0.0;
}

/* From the left and from the right of all nodes and middles of cells. */
static void weights_are_continuous(void)
{
    for (int order = 1; order <= 3; order++)
        for (int half = -8; half <= 12; half++)
            for (int node = -8; node <= 10; node++)
                expect_close(weight_of(order, 0.5 * half + 1e-12, node),
                             weight_of(order, 0.5 * half - 1e-12, node), 1e-11,
                             1.0, "order %d: weight of node %d just right of x "
                             "= %g h, against just left", order, node,
                             0.5 * half);
}

/* Central differences, whose error falls with the square of the step; with
 * 1e-5 h it is 1e-10, and round-off adds 1e-11. */
static void gradients_are_slopes_of_the_weights(void)
{
    const double h = oracle_h, step = 1e-5 * h;
    for (int order = 1; order <= 3; order++)
        for (int k = 48; k < 120; k++) {
            const double x = h * place(k);
            double w[4], dw[4], plus[4], minus[4], unused[4];
            const int first = weights(order, h, x, w, dw);
            if (weights(order, h, x + step, plus, unused) != first ||
                weights(order, h, x - step, minus, unused) != first)
                continue;
            for (int q = 0; q <= order; q++)
                expect_close(dw[q], (plus[q] - minus[q]) / (2.0 * step), 1e-8,
                             1.0 / h,
                             "order %d, x = %.10g h: dw[%d], against the "
                             "differences of w[%d]", order, x / h, q, q);
        }
}

static void weights_are_the_oracles(void)
{
    const double h = 0.125; /* a power of 2: x / h is the oracle's place */
    for (int k = 0; k < COUNT(oracle_weights); k++) {
        double w[4], dw[4];
        const int order = oracle_weights[k].order;
        const double s = oracle_weights[k].s;
        const int first = weights(order, h, h * s, w, dw);
        const int want = oracle_weights[k].first;
        /* a node of no weight is at one end or at the other, or at none */
        for (int i = want - 1; i <= want + order + 1; i++) {
            const int q = i - first, o = i - want;
            const int in = q >= 0 && q <= order, known = o >= 0 && o <= order;
            expect_close(in ? w[q] : 0.0,
                         known ? oracle_weights[k].w[o] : 0.0, ROUND_OFF, 1.0,
                         "order %d, x = %g h, nodes from %d on: weight of node "
                         "%d", order, s, first, i);
            expect_close(in ? h * dw[q] : 0.0,
                         known ? oracle_weights[k].dw[o] : 0.0, ROUND_OFF, 1.0,
                         "order %d, x = %g h, nodes from %d on: h dw of node "
                         "%d", order, s, first, i);
        }
    }
}

/* ---- 18b ----------------------------------------------------------------- */

/* As seven(), but two thousand of them, none on a node. */
static struct pair two_thousand(int order)
{
    struct pair pair = seven(order, 0);
    particles_free(pair.p);
    pair.p = particles_alloc(2000);
    for (int r = 0; r < 4000; r++) {
        pair.p->x[r] = oracle_h * (1.0 + 5.0 * fmod(0.61803 * (r + 1), 1.0));
        pair.p->v[r] = 1.0 + r / 4000.0;
        pair.p->mass[r / 2] = 1.0 / 2000.0;
    }
    return pair;
}

/* Twice: what the grid has from before must be gone. */
static void p2g_keeps_mass_and_momentum(void)
{
    for (int order = 1; order <= 3; order++)
        for (int with_B = 0; with_B < 3; with_B++) {
            struct pair s =
                with_B < 2 ? seven(order, with_B) : two_thousand(order);
            const struct moments want = particles_moments(s.p);
            p2g(s.p, s.grid);
            expect(p2g(s.p, s.grid) == OK, "P2G must return OK");
            const struct moments got = grid_moments(s.grid, s.grid->v);
            expect_close(got.mass, want.mass, SUMS, 1.0,
                         "order %d: mass of all nodes, of %d particles", order,
                         s.p->n);
            for (int k = 0; k < 2; k++)
                expect_close(got.momentum[k], want.momentum[k], SUMS, 1.0,
                             "order %d, B %s: momentum of all nodes, component "
                             "%d", order, with_B == 1 ? "set" : "= 0", k);
            pair_free(s);
        }
}

/* `back`: by G2P.  Who has left the grid, or is nowhere, is named. */
static void expect_left(int back)
{
    for (int nan = 0; nan < 2; nan++) {
        struct pair s = seven(2, 0);
        const enum status want = nan ? NONFINITE : OUTSIDE;
        s.p->x[2 * SEVEN - 1] = nan ? NAN : 9.7;
        const enum status got =
            back ? g2p(s.grid, PIC, 0.1, s.p) : p2g(s.p, s.grid);
        expect(got == want, "%s with a particle at y = %g: status %s, must "
               "be %s", back ? "G2P" : "P2G", s.p->x[2 * SEVEN - 1],
               status_name(got), status_name(want));
        pair_free(s);
    }
}

/* A grid that two particles fill up to its corners, and numbers behind it that
 * are not its own. */
static void p2g_does_every_node_and_no_other(void)
{
    for (int order = 1; order <= 3; order++) {
        const double low[2] = {0.0, 0.0}, middle = 0.5 * order;
        const int n = order + 1, nodes[2] = {n, n};
        struct grid *grid = grid_alloc(order, low, 1.0, nodes), own = *grid;
        struct particles *p = particles_alloc(2);
        double mass[17], v[34];
        own.mass = mass;
        own.v = v;
        for (int a = 0; a <= n * n; a++)
            mass[a] = v[2 * a] = v[2 * a + 1] = 7.0;
        for (int r = 0; r < 4; r++) {
            p->x[r] = middle + 0.1 * (r - 1);
            p->v[r] = 2.385;
            p->mass[r / 2] = 0.3714;
        }
        p2g(p, &own);
        for (int r = 0; r < 2 * n * n + 2; r++)
            expect_close(v[r], r < 2 * n * n ? 2.385 : 7.0, SUMS, 1.0,
                         "order %d, a full grid of %d nodes, all particles "
                         "with v = 2.385: v[%d] of the nodes", order, n * n, r);
        grid_free(grid);
        particles_free(p);
    }
    expect_left(0);
}

/* v = a + G x, B = G D: the nodes get a + G x_i. */
static const double A[] = {0.31, -0.47};
static const mat2 G = {{{0.385, -1.271}, {0.713, 0.2385}}};
static void affine_velocity(const double x[], double v[])
{
    for (int k = 0; k < 2; k++)
        v[k] = A[k] + G.m[k][0] * x[0] + G.m[k][1] * x[1];
}
static void make_affine(struct pair pair, int with_B)
{
    for (int q = 0; q < SEVEN; q++) {
        struct support s;
        expect(grid_support(pair.grid, &pair.p->x[2 * q], &s) == OK, "inside");
        affine_velocity(&pair.p->x[2 * q], &pair.p->v[2 * q]);
        for (int k = 0; k < 4; k++)
            pair.p->B[q].m[k / 2][k % 2] =
                with_B ? G.m[k / 2][k % 2] * s.inertia[k % 2] : 0.0;
    }
}

static void p2g_hands_affine_fields_on(void)
{
    for (int order = 1; order <= 3; order++) {
        struct pair s = seven(order, 1);
        make_affine(s, 1);
        p2g(s.p, s.grid);
        for (int a = 0; a < s.grid->n_node; a++) {
            double x[2], v[2];
            grid_place(s.grid, a, x);
            affine_velocity(x, v);
            for (int k = 0; k < 2 && s.grid->mass[a] > 0.0; k++)
                expect_close(s.grid->v[2 * a + k], v[k], ORACLE, 1.0,
                             "order %d, v = a + G x, B = G D: velocity of node "
                             "%d, component %d, against a + G x", order, a, k);
        }
        pair_free(s);
    }
}

static void p2g_keeps_angular_momentum(void)
{
    for (int order = 1; order <= 3; order++)
        for (int with_B = 0; with_B < 2; with_B++) {
            struct pair s = seven(order, with_B);
            p2g(s.p, s.grid);
            expect_close(grid_moments(s.grid, s.grid->v).angular, turning(s.p),
                         SUMS, 1.0, "order %d, B %s: angular momentum of the "
                         "nodes", order, with_B ? "set" : "= 0");
            pair_free(s);
        }
}

/* Also without a particle near; and never more than the particles have. */
static void kinetic_energy_never_grows(void)
{
    for (int order = 1; order <= 3; order++)
        for (int k = 0; k < 9; k++) {
            struct pair s = seven(order, 0);
            for (int r = 0; r < 2 * SEVEN; r++)
                s.p->v[r] = sin(2.385 * r * r + k);
            p2g(s.p, s.grid);
            const double before = particles_moments(s.p).kinetic;
            const double after = grid_moments(s.grid, s.grid->v).kinetic;
            for (int r = 0; r < 2 * s.grid->n_node; r++)
                if (!(s.grid->mass[r / 2] > 0.0))
                    expect_close(s.grid->v[r], 0.0, 0.0, 1.0,
                                 "order %d: velocity of node %d, which has no "
                                 "mass", order, r / 2);
            expect_close(after < before ? 0.0 : after - before, 0.0, SUMS, 1.0,
                         "order %d, PIC: kinetic energy that P2G adds", order);
            pair_free(s);
        }
}

static void nodes_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_node); k++)
        for (int with_B = 0; with_B < 2; with_B++) {
            const int order = oracle_node[k].order, i = oracle_node[k].i;
            const int a = (oracle_node[k].j + 2) * 11 + i + 2;
            const double *v = with_B ? oracle_node[k].v_apic : oracle_node[k].v;
            struct pair s = seven(order, with_B);
            p2g(s.p, s.grid);
            expect_close(s.grid->mass[a], oracle_node[k].mass, ORACLE, 1.0,
                         "order %d: mass of node %d", order, a);
            for (int l = 0; l < 2; l++)
                expect_close(s.grid->v[2 * a + l], v[l], ORACLE, 1.0,
                             "order %d, B %s: velocity of node %d, component "
                             "%d", order, with_B ? "set" : "= 0", a, l);
            pair_free(s);
        }
}

/* ---- 18c ----------------------------------------------------------------- */

static void g2p_names_who_leaves(void) { expect_left(1); }

static void flip_without_forces_is_the_identity(void)
{
    for (int order = 1; order <= 3; order++) {
        struct pair s = seven(order, 0);
        library_p2g(s, 0);
        expect(g2p(s.grid, FLIP, 0.0, s.p) == OK, "G2P must return OK");
        for (int r = 0; r < 2 * SEVEN; r++) {
            expect_close(s.p->v[r], oracle_v[r / 2][r % 2], ROUND_OFF, 1.0,
                         "order %d, FLIP, no forces: v of particle %d, "
                         "component %d", order, r / 2, r % 2);
            expect_close(s.p->x[r], oracle_x[r / 2][r % 2], 0.0, 1.0,
                         "order %d, dt = 0: x of particle %d", order, r / 2);
        }
        pair_free(s);
    }
}

/* For each order and scheme: to the grid, a kick, and `back`. */
static void with_all(void (*back)(struct pair s, int order, enum transfer how))
{
    for (int order = 1; order <= 3; order++)
        for (int how = PIC; how <= APIC; how++) {
            struct pair s = seven(order, how == APIC);
            library_p2g(s, 1);
            back(s, order, (enum transfer)how);
            pair_free(s);
        }
}

/* All schemes: by the velocity of the grid and not by their own. */
static void check_places(struct pair s, int order, enum transfer how)
{
    const double dt = 0.2385;
    double want[SEVEN][2];
    for (int q = 0; q < SEVEN; q++) {
        struct support near;
        expect(grid_support(s.grid, &s.p->x[2 * q], &near) == OK, "inside");
        support_value(&near, s.grid->next, want[q]);
    }
    g2p(s.grid, how, dt, s.p);
    for (int r = 0; r < 2 * SEVEN; r++)
        expect_close(s.p->x[r],
                     oracle_x[r / 2][r % 2] + dt * want[r / 2][r % 2], SUMS,
                     1.0, "order %d, %s: x of particle %d, component %d, "
                     "against x + dt sum N_i v_i", order, transfer_name(how),
                     r / 2, r % 2);
}

static void places_move_with_the_grid(void)
{
    with_all(check_places);
}

static void check_momentum(struct pair s, int order, enum transfer how)
{
    const struct moments want = grid_moments(s.grid, s.grid->next);
    g2p(s.grid, how, oracle_dt, s.p);
    for (int k = 0; k < 2; k++)
        expect_close(particles_moments(s.p).momentum[k], want.momentum[k], SUMS,
                     1.0, "order %d, %s, after a kick: momentum of the "
                     "particles, component %d", order, transfer_name(how), k);
}

static void g2p_keeps_momentum(void)
{
    with_all(check_momentum);
}

static void check_turning(struct pair s, int order, enum transfer how)
{
    const double want = grid_moments(s.grid, s.grid->next).angular;
    for (int k = 0; k < 4 * SEVEN && how != APIC; k++)
        s.p->B[k / 4].m[k % 4 / 2][k % 2] = 0.2385; /* left from APIC */
    g2p(s.grid, how, oracle_dt, s.p);
    if (how == APIC)
        expect_close(turning(s.p), want, SUMS, 1.0,
                     "order %d, APIC, after a kick: sum m (x cross v + B_21 - "
                     "B_12)", order);
    else
        for (int k = 0; k < 4 * SEVEN; k++)
            expect_close(s.p->B[k / 4].m[k % 4 / 2][k % 2], 0.0, 0.0, 1.0,
                         "%s has no B; of particle %d", transfer_name(how),
                         k / 4);
}

static void apic_keeps_angular_momentum(void)
{
    with_all(check_turning);
}

/* APIC hands a + G x on; PIC does not, unless the particles lie evenly. */
static void affine_fields_come_back_by_apic_alone(void)
{
    for (int order = 1; order <= 3; order++)
        for (int how = PIC; how <= APIC; how += 2) {
            struct pair s = seven(order, 0);
            double worst = 0.0;
            make_affine(s, how == APIC);
            library_p2g(s, 0);
            g2p(s.grid, (enum transfer)how, 0.0, s.p);
            for (int q = 0; q < SEVEN; q++) {
                double v[2];
                affine_velocity(&s.p->x[2 * q], v);
                for (int k = 0; k < 2; k++)
                    worst = fmax(worst, fabs(s.p->v[2 * q + k] - v[k]));
            }
            if (how == APIC)
                expect_close(worst, 0.0, SUMS, 1.0,
                             "order %d, APIC: largest change of v = a + G x",
                             order);
            else
                expect(worst > 0.05, "order %d, PIC: v = a + G x changes by "
                       "%.3g only", order, worst);
            pair_free(s);
        }
}

static void transfers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_transfer); k++) {
        const enum transfer how = (enum transfer)oracle_transfer[k].transfer;
        const int order = oracle_transfer[k].order;
        const char *kick = oracle_transfer[k].kicked ? "kicked" : "still";
        struct pair s = seven(order, how == APIC);
        library_p2g(s, oracle_transfer[k].kicked);
        g2p(s.grid, how, oracle_dt, s.p);
        for (int i = 0; i < 2; i++) {
            expect_close(s.p->x[6 + i], oracle_transfer[k].x[i], ORACLE, 1.0,
                         "order %d, %s, %s: x of particle 3, component %d",
                         order, transfer_name(how), kick, i);
            expect_close(s.p->v[6 + i], oracle_transfer[k].v[i], ORACLE, 1.0,
                         "order %d, %s, %s: v of particle 3, component %d",
                         order, transfer_name(how), kick, i);
        }
        for (int i = 0; i < 4; i++)
            expect_close(s.p->B[3].m[i / 2][i % 2], oracle_transfer[k].B[i],
                         ORACLE, 1.0, "order %d, %s, %s: B_%d%d of particle 3",
                         order, transfer_name(how), kick, i / 2 + 1, i % 2 + 1);
        expect_close(turning(s.p), oracle_transfer[k].after, ORACLE, 1.0,
                     "order %d, %s, %s: angular momentum at the end", order,
                     transfer_name(how), kick);
        expect_close(particles_moments(s.p).kinetic,
                     oracle_transfer[k].kinetic_after, ORACLE, 1.0,
                     "order %d, %s, %s: kinetic energy at the end", order,
                     transfer_name(how), kick);
        pair_free(s);
    }
}

/* ---- 18d, and all together ----------------------------------------------- */

/* Points, then in themselves; the second law of it: a rigid turn of a disc. */
static void angular_counts_points_and_their_turning(void)
{
    for (int with_B = 0; with_B < 2; with_B++) {
        struct pair s = seven(2, with_B);
        struct particles inside = *s.p;
        inside.mass = guarded_copy(s.p->n, s.p->mass);
        inside.x = guarded_copy(2 * s.p->n, s.p->x);
        inside.v = guarded_copy(2 * s.p->n, s.p->v);
        expect_close(angular(&inside), turning(s.p), ORACLE, 1.0,
                     "B %s: angular momentum of the seven particles",
                     with_B ? "set" : "= 0");
        pair_free(s);
    }
}

/* What the later lessons use, with your kernel in your half: all nodes, all
 * particles, after a kick. */
static void all_agrees_with_the_library(void)
{
    for (int order = 1; order <= 3; order++)
        for (int how = PIC; how <= APIC; how++) {
            const char *name = transfer_name((enum transfer)how);
            struct pair s = seven(order, how == APIC);
            struct pair want = seven(order, how == APIC);
            s.grid->kernel = weights;
            library_p2g(want, 1);
            expect(p2g(s.p, s.grid) == OK, "P2G must return OK");
            grid_kick(s.grid, oracle_kick, oracle_kick_w);
            for (int r = 0; r < 2 * s.grid->n_node; r++)
                expect_close(s.grid->v[r], want.grid->v[r], 1e-10, 1.0,
                             "order %d, %s: velocity of node %d", order, name,
                             r / 2);
            expect(g2p(s.grid, (enum transfer)how, 0.1, s.p) == OK &&
                       grid_g2p(want.grid, (enum transfer)how, 0.1, want.p) ==
                           OK, "G2P must return OK");
            for (int r = 0; r < 2 * SEVEN; r++) {
                expect_close(s.p->x[r], want.p->x[r], ORACLE, 1.0,
                             "order %d, %s: x of particle %d", order, name,
                             r / 2);
                expect_close(s.p->v[r], want.p->v[r], ORACLE, 1.0,
                             "order %d, %s: v of particle %d", order, name,
                             r / 2);
            }
            pair_free(s);
            pair_free(want);
        }
}

static void spin_is_the_oracles(void)
{
    for (int k = 2; k < 4; k++) {
        char options[80];
        snprintf(options, sizeof options, "--order %d", oracle_disc[k].order);
        struct output *out = run(options);
        expect_close(cell(out, "spin", "ratio", 1), oracle_disc[k].once, 1e-11,
                     1.0, "%s: spin left by one PIC transfer", options);
        expect_close(cell(out, "spin", "ratio", 100), oracle_disc[k].hundred,
                     1e-11, 1.0, "%s: spin left by 100", options);
    }
    expect_close(cell(run("--scheme APIC"), "spin", "ratio", 100), 1.0, 1e-11,
                 1.0, "spin left by 100 APIC transfers");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *kick = run("--kick 1");
    measured("1", cell(run("--order 1"), "spin", "ratio", 100));
    measured("2", cell(kick, "transfer", "L_kicked", FLIP) -
                      cell(kick, "transfer", "L_after", FLIP));
    measured("3", cell(run("--order 3"), "spin", "ratio", 100));
}

static const struct claim claims[] = {
    {"sums_are_those_of_the_derivation", sums_are_those_of_the_derivation,
     "18a"},
    {"weights_are_not_negative", weights_are_not_negative, "18a"},
    {"weights_are_continuous", weights_are_continuous, "18a"},
    {"gradients_are_slopes_of_the_weights",
     gradients_are_slopes_of_the_weights, "18a"},
    {"weights_are_the_oracles", weights_are_the_oracles, "18a"},
    {"p2g_keeps_mass_and_momentum", p2g_keeps_mass_and_momentum, "18b"},
    {"kinetic_energy_never_grows", kinetic_energy_never_grows, "18b"},
    {"p2g_does_every_node_and_no_other", p2g_does_every_node_and_no_other,
     "18b"},
    {"p2g_hands_affine_fields_on", p2g_hands_affine_fields_on, "18b"},
    {"p2g_keeps_angular_momentum", p2g_keeps_angular_momentum, "18b"},
    {"nodes_are_the_oracles", nodes_are_the_oracles, "18b"},
    {"g2p_names_who_leaves", g2p_names_who_leaves, "18c"},
    {"flip_without_forces_is_the_identity",
     flip_without_forces_is_the_identity, "18c"},
    {"places_move_with_the_grid", places_move_with_the_grid, "18c"},
    {"g2p_keeps_momentum", g2p_keeps_momentum, "18c"},
    {"apic_keeps_angular_momentum", apic_keeps_angular_momentum, "18c"},
    {"affine_fields_come_back_by_apic_alone",
     affine_fields_come_back_by_apic_alone, "18c"},
    {"transfers_are_the_oracles", transfers_are_the_oracles, "18c"},
    {"angular_counts_points_and_their_turning",
     angular_counts_points_and_their_turning, "18d"},
    {"all_agrees_with_the_library", all_agrees_with_the_library, NULL},
    {"spin_is_the_oracles", spin_is_the_oracles, NULL},
};

static const char *const runs[] = {
    "",
    "--order 1 --x 4 --kick 1 --scheme FLIP --steps 3",
    ("--order 3 --x 5.0713 --kick 1 --scheme APIC --steps 7 --ppc 2 "
     "--disc yes"),
    "--order 1 --dt 0.2385 --kick -1.3 --scheme APIC --steps 5 --ppc 3",
    "--order 2 --x 3 --dt 0.1 --kick 2.385 --scheme FLIP --steps 9",
};

#define TRANSFER "sums over particles and nodes"
static const struct column_rule rules[] = {
    {"weights", "node", 0, "a count", 0},
    {"weights", "*", 1e-12, "closed forms", 1},
    {"sums", "of", 0, "a word", 0},
    {"sums", "*", 1e-12, "sums of four products", 1},
    {"transfer", "scheme", 0, "a word", 0},
    {"transfer", "*", 1e-11, TRANSFER, 1},
    {"grid", "node", 0, "a count", 0},
    {"grid", "mass", 1e-12, TRANSFER, 0},
    {"grid", "*", 1e-10, TRANSFER ", divided by small masses", 1},
    {"spin", "transfers", 0, "a count", 0},
    {"spin", "ratio", 1e-11, "as many transfers", 1},
    {"disc", "*", 1e-11, "as many transfers", 1},
    {"filter", "wavelength", 0, "a count", 0},
    {"filter", "scheme", 0, "a word", 0},
    {"filter", "*", 1e-11, TRANSFER, 1},
};

static const struct lesson lesson = {
    "18_mpm_transfer", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "P2G loses nothing but kinetic energy, in any scheme; what PIC is blamed "
    "for happens on the way back, and once per step: halve the time step and "
    "a second of motion goes through the filter twice as often.",
    "Start APIC with B = 0 in the disc. The velocities lose a little, once, "
    "and the ratio stays 1. Why?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
