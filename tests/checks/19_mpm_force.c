/*
 * 19_mpm_force.c - what right forces of particles on nodes satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *   19a u: affine_motions_have_their_F, shaken_nodes_have_their_F; F_n: the
 *       same, of seven particles; m->s (orders): both; a bar: a_bar_stays_a_bar
 *   19b body (orders, laws), m, volume: forces_are_the_oracles,
 *       force_is_the_slope_of_the_energy; f of several particles:
 *       forces_add_up_to_nothing; E, nu: the runs
 *   19c body, m, w, volume: product_is_the_slope_of_the_force,
 *       products_are_the_oracles
 */
#include "program.h"

#include "judge.h"

#include "../oracle/particle_force.h"

#include <stdio.h>
#include <string.h>

#define ROUND_OFF 1e-13 /* of sums of some dozen products, relative to ... */
#define FORCE 60.0      /* ... the forces of the seven particles (N) */
#define STIFFNESS 700.0 /* ... and their tangent (N/m) */
#define DERIVATIVE 1e-7 /* central differences with a step of 1e-5 h */

enum { DOF = 2 * 11 * 11 };

/* Seven particles and irregular displacements of their nodes; w is another
 * field. */
struct shaken {
    struct cloud cloud;
    struct particle_body body;
    double *u, *w;
};
static struct shaken shaken(int order, enum law law)
{
    struct shaken s = {.cloud = cloud_seven(order, PIC)};
    s.body = (struct particle_body){s.cloud.grid, s.cloud.p,
                                    material_notes(law), NULL};
    s.u = guarded_alloc(DOF);
    s.w = guarded_alloc(DOF);
    grid_shake(s.cloud.grid, 0.35 * s.cloud.grid->h, s.u);
    for (int r = 0; r < DOF; r++) s.w[r] = s.u[(7 * r + 31) % DOF];
    return s;
}

/* Each order of kernels, with each law. */
static void with_each(void (*check_one)(struct shaken s, const char *what))
{
    for (int order = 1; order <= 3; order++)
        for (int law = LOG; law <= CUBIC; law++) {
            char what[40];
            struct shaken s = shaken(order, (enum law)law);
            snprintf(what, sizeof what, "order %d, %s law", order,
                     material_law((enum law)law));
            check_one(s, what);
            cloud_free(s.cloud);
        }
}

/* Node a goes to turn x_a + shift: u, and v if it is a velocity (no x_a). */
static void set_affine(const struct grid *grid, mat2 turn,
                       const double shift[2], int whole, double u[])
{
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        for (int k = 0; k < 2; k++)
            u[2 * a + k] = turn.m[k][0] * x[0] + turn.m[k][1] * x[1] +
                           shift[k] - (whole ? x[k] : 0.0);
    }
}

static const double SHIFT[2] = {0.2385, -0.613};

/* ---- 19a ----------------------------------------------------------------- */

static void compare_F(mat2 got, mat2 want, const char *name, const char *what,
                      int p)
{
    for (int r = 0; r < 4; r++)
        expect_close(got.m[r / 2][r % 2], want.m[r / 2][r % 2], ROUND_OFF, 3.0,
                     "%s, particle %d: %s_%d%d", what, p, name, r / 2 + 1,
                     r % 2 + 1);
}

/* All nodes move by G x + a: F_hat = G everywhere, and F = G F_n. */
static void affine_one(struct shaken s, const char *what)
{
    const mat2 G = {{{1.185, -0.271}, {0.313, 0.8385}}};
    struct moved m;
    set_affine(s.cloud.grid, G, SHIFT, 1, s.u);
    for (int p = 0; p < s.cloud.p->n; p++) {
        expect(move(&s.body, p, s.u, &m) == OK, "%s: status must be OK", what);
        compare_F(m.F_hat, G, "nodes at G x + a: F_hat", what, p);
        compare_F(m.F, mat2_multiply(G, s.cloud.p->F[p]), "nodes at G x + a: F",
                  what, p);
    }
}
static void affine_motions_have_their_F(void)
{
    with_each(affine_one);
}

static void irregular_one(struct shaken s, const char *what)
{
    struct moved m;
    for (int p = 0; p < s.cloud.p->n; p++) {
        struct support here;
        grid_support(s.cloud.grid, &s.cloud.p->x[2 * p], &here);
        const mat2 want =
            mat2_add(mat2_identity(), support_gradient(&here, s.u));
        expect(move(&s.body, p, s.u, &m) == OK, "%s: status must be OK", what);
        compare_F(m.F_hat, want, "nodes shaken: F_hat", what, p);
        compare_F(m.F, mat2_multiply(want, s.cloud.p->F[p]), "nodes shaken: F",
                  what, p);
    }
}
static void shaken_nodes_have_their_F(void)
{
    with_each(irregular_one);
}

/* On a bar nothing moves across: F_22 stays 1. */
static void a_bar_stays_a_bar(void)
{
    struct cloud bar = cloud_bar(2, 8, 2, 1.385, 0.0137);
    const struct particle_body body = {bar.grid, bar.p, material_notes(CUBIC),
                                       NULL};
    double *u = guarded_alloc(2 * bar.grid->n_node);
    for (int a = 0; a < bar.grid->n_node; a++) {
        u[2 * a] = 0.1 * a / 8.0;
        u[2 * a + 1] = 0.0;
    }
    for (int p = 0; p < bar.p->n; p++) {
        struct moved m;
        expect(move(&body, p, u, &m) == OK, "a bar: status must be OK");
        compare_F(m.F_hat, (mat2){{{1.1, 0.0}, {0.0, 1.0}}},
                  "F_hat of a stretch by 1.1", "a bar", p);
    }
    cloud_free(bar);
}

/* ---- 19b ----------------------------------------------------------------- */

static double *force_of(const struct shaken *s, const double u[])
{
    double *f = guarded_alloc(DOF);
    expect(force(&s->body, u, f) == OK, "the force's status must be OK");
    return f;
}

static void sum_one(struct shaken s, const char *what)
{
    const double *f = force_of(&s, s.u);
    const struct balance sum = grid_balance(s.cloud.grid, s.u, f);
    for (int k = 0; k < 2; k++)
        expect_close(sum.force[k], 0.0, ROUND_OFF, FORCE,
                     "%s: sum of the forces, component %d", what, k);
}
static void forces_add_up_to_nothing(void)
{
    with_each(sum_one);
}

/* Central differences of the library's energy: errors of step^2 times third
 * derivatives, and round-off of 20 J over the step. */
static void slope_one(struct shaken s, const char *what)
{
    const double *f = force_of(&s, s.u);
    double *slope = guarded_alloc(DOF);
    particle_difference_force(&s.body, s.u, 1e-5 * s.cloud.grid->h, slope);
    for (int r = 0; r < DOF; r++)
        expect_close(f[r], slope[r], DERIVATIVE, 1.0,
                     "%s: force on node %d, component %d, against differences "
                     "of the energy",
                     what, r / 2, r % 2);
}
static void force_is_the_slope_of_the_energy(void)
{
    with_each(slope_one);
}

static void torque_one(struct shaken s, const char *what)
{
    const double *f = force_of(&s, s.u);
    expect_close(grid_balance(s.cloud.grid, s.u, f).torque, 0.0, ROUND_OFF,
                 FORCE, "%s: torque about 0 of forces at the displaced nodes",
                 what);
}
static void displaced_nodes_have_no_torque(void)
{
    with_each(torque_one);
}

/* Unstrained particles, nodes moved like a rigid body; and strained ones, whose
 * forces must turn with the nodes. */
static void rigid_one(struct shaken s, const char *what)
{
    const mat2 R = mat2_rotation(0.7132);
    const double *f = force_of(&s, s.u);
    double *turned = guarded_alloc(DOF);
    for (int a = 0; a < DOF / 2; a++) {
        double x[2], at[2];
        grid_place(s.cloud.grid, a, x);
        for (int k = 0; k < 2; k++) at[k] = x[k] + s.u[2 * a + k];
        for (int k = 0; k < 2; k++)
            turned[2 * a + k] =
                R.m[k][0] * at[0] + R.m[k][1] * at[1] + SHIFT[k] - x[k];
    }
    const double *g = force_of(&s, turned);
    for (int a = 0; a < DOF / 2; a++)
        for (int k = 0; k < 2; k++)
            expect_close(g[2 * a + k],
                         R.m[k][0] * f[2 * a] + R.m[k][1] * f[2 * a + 1],
                         ROUND_OFF, FORCE,
                         "%s, all turned by 0.7132: force on "
                         "node %d, component %d, against the turned force",
                         what, a, k);
    for (int p = 0; p < s.cloud.p->n; p++)
        s.cloud.p->F[p] = mat2_rotation(0.3 * p);
    set_affine(s.cloud.grid, R, SHIFT, 1, s.u);
    f = force_of(&s, s.u);
    for (int r = 0; r < DOF; r++)
        expect_close(f[r], 0.0, ROUND_OFF, FORCE,
                     "%s, rotated particles, nodes turned by 0.7132: force on "
                     "node %d",
                     what, r / 2);
}
static void rigid_motions_turn_the_forces(void)
{
    with_each(rigid_one);
}

static int node_of(const int cell[2])
{
    return 11 * (cell[1] + 2) + cell[0] + 2;
}

static void forces_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_force); k++) {
        const enum law law = strcmp(oracle_force[k].law, "log") ? CUBIC : LOG;
        struct shaken s = shaken(oracle_force[k].order, law);
        const double *f = force_of(&s, s.u);
        double work = 0.0, *want = guarded_alloc(DOF);
        particle_force(&s.body, s.u, want);
        for (int r = 0; r < DOF; r++) work += f[r] * s.u[r];
        for (int n = 0; n < ORACLE_FORCE_NODES; n++) {
            const int a = node_of(oracle_force[k].row[n].node);
            for (int i = 0; i < 2; i++)
                expect_close(f[2 * a + i], oracle_force[k].row[n].f[i], 1e-12,
                             FORCE,
                             "order %d, %s law: force on node %d, "
                             "component %d",
                             oracle_force[k].order, oracle_force[k].law, a, i);
        }
        for (int r = 0; r < DOF; r++)
            expect_close(f[r], want[r], ROUND_OFF, FORCE,
                         "order %d, %s law: force on node %d, component %d, "
                         "against particle_force()",
                         oracle_force[k].order, oracle_force[k].law, r / 2,
                         r % 2);
        expect_close(work, oracle_force[k].work, 1e-12, FORCE,
                     "order %d, %s law: sum f.u", oracle_force[k].order,
                     oracle_force[k].law);
        expect_close(grid_balance(s.cloud.grid, NULL, f).torque,
                     oracle_force[k].torque, 1e-12, FORCE,
                     "order %d, %s law: torque about 0 of forces at the nodes "
                     "before they moved",
                     oracle_force[k].order, oracle_force[k].law);
        if (law == CUBIC) { /* turned inside out, which that law has */
            for (int c = 0; c < 2; c++) s.cloud.p->F[3].m[c][0] *= -1.0;
            f = force_of(&s, s.u);
            particle_force(&s.body, s.u, want);
            for (int r = 0; r < DOF; r++)
                expect_close(f[r], want[r], ROUND_OFF, FORCE,
                             "order %d, a particle with det F < 0: force on "
                             "node %d, component %d", oracle_force[k].order,
                             r / 2, r % 2);
        }
        cloud_free(s.cloud);
    }
}

/* One particle in the middle of each linear cell is one Gauss point there. */
static void elements_are_those_of_lesson_10(void)
{
    enum { CELLS = 8, NODES = CELLS + 5 };
    const double h = 1.0 / CELLS;
    const struct material cubic = material_notes(CUBIC);
    struct cloud bar = cloud_bar(1, CELLS, 1, 1.0, 0.0);
    const struct particle_body body = {bar.grid, bar.p, cubic, NULL};
    double *u = guarded_alloc(2 * NODES), *w = guarded_alloc(2 * NODES);
    double *f = guarded_alloc(2 * NODES), *Kw = guarded_alloc(2 * NODES);
    for (int a = 0; a < NODES; a++) {
        u[2 * a] = 0.3 * h * sin(2.385 * a * a);
        w[2 * a] = cos(1.385 * a * a);
        u[2 * a + 1] = w[2 * a + 1] = 0.0;
    }
    expect(force(&body, u, f) == OK, "the force's status must be OK");
    for (int a = 2; a <= CELLS + 2; a++) {
        double want = 0.0;
        for (int e = a - 1; e <= a; e++) /* the cell from node e to e + 1 */
            if (e >= 2 && e < CELLS + 2)
                want +=
                    (e == a ? 1.0 : -1.0) *
                    material1_pk1(&cubic, 1.0 + (u[2 * e + 2] - u[2 * e]) / h);
        expect_close(f[2 * a], want, 1e-12, 1000.0,
                     "particles in the middle of linear cells: force on node "
                     "%d, against the stress of the elements beside it",
                     a - 2);
    }
    expect(product(&body, u, w, Kw) == OK, "the product's status must be OK");
    for (int a = 2; a <= CELLS + 2; a++) {
        double want = 0.0;
        for (int e = a - 1; e <= a; e++)
            if (e >= 2 && e < CELLS + 2)
                want -= (e == a ? 1.0 : -1.0) / h *
                        material1_dpk1(&cubic,
                                       1.0 + (u[2 * e + 2] - u[2 * e]) / h) *
                        (w[2 * e + 2] - w[2 * e]);
        expect_close(Kw[2 * a], want, 1e-12, 10000.0,
                     "the same: K w of node %d, against the elements beside it",
                     a - 2);
    }
    cloud_free(bar);
}

/* ---- 19c ----------------------------------------------------------------- */

static double *product_of(const struct shaken *s, const double w[])
{
    double *out = guarded_alloc(DOF);
    expect(product(&s->body, s->u, w, out) == OK,
           "the product's status must be OK");
    return out;
}

static double times(const double a[], const double b[])
{
    double sum = 0.0;
    for (int r = 0; r < DOF; r++) sum += a[r] * b[r];
    return sum;
}

static void symmetric_one(struct shaken s, const char *what)
{
    expect_close(times(s.u, product_of(&s, s.w)),
                 times(s.w, product_of(&s, s.u)), ROUND_OFF, STIFFNESS,
                 "%s: u.K w, against w.K u, which are equal where dP is a "
                 "derivative, not a difference quotient", what);
}
static void tangent_is_symmetric(void)
{
    with_each(symmetric_one);
}

/* Against the library's force, so that 19b has no part in it. */
static void tangent_one(struct shaken s, const char *what)
{
    const double step = 1e-5;
    double *at = guarded_alloc(DOF), *f = guarded_alloc(DOF);
    double *quotient = guarded_alloc(DOF);
    for (int side = 0; side < 2; side++) {
        const double t = side ? -step : step;
        for (int r = 0; r < DOF; r++) at[r] = s.u[r] + t * s.w[r];
        particle_force(&s.body, at, f);
        for (int r = 0; r < DOF; r++)
            quotient[r] = (side ? quotient[r] : 0.0) - f[r] / (2.0 * t);
    }
    const double *Kw = product_of(&s, s.w);
    for (int r = 0; r < DOF; r++)
        expect_close(Kw[r], quotient[r], DERIVATIVE, 1.0,
                     "%s: K w of node %d, component %d, against differences "
                     "of the force",
                     what, r / 2, r % 2);
}
static void product_is_the_slope_of_the_force(void)
{
    with_each(tangent_one);
}

static void products_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_force); k++) {
        const enum law law = strcmp(oracle_force[k].law, "log") ? CUBIC : LOG;
        struct shaken s = shaken(oracle_force[k].order, law);
        expect_close(times(s.u, product_of(&s, s.u)), oracle_force[k].bend,
                     1e-12, STIFFNESS, "order %d, %s law: u.K u",
                     oracle_force[k].order, oracle_force[k].law);
        memset(s.w, 0, DOF * sizeof *s.w);
        s.w[2 * node_of(oracle_force[k].column)] = 1.0;
        const double *column_ = product_of(&s, s.w);
        for (int n = 0; n < ORACLE_FORCE_NODES; n++) {
            const int a = node_of(oracle_force[k].row[n].node);
            for (int i = 0; i < 2; i++)
                expect_close(column_[2 * a + i], oracle_force[k].row[n].K[i],
                             1e-12, STIFFNESS,
                             "order %d, %s law: entry of K, "
                             "node %d, component %d",
                             oracle_force[k].order, oracle_force[k].law, a, i);
        }
        cloud_free(s.cloud);
    }
}

/* ---- all together -------------------------------------------------------- */

static void failures_are_named(void)
{
    struct shaken s = shaken(2, LOG);
    double *f = guarded_alloc(DOF);
    const mat2 mirror = {{{-1.0, 0.0}, {0.0, 1.0}}};
    set_affine(s.cloud.grid, mirror, SHIFT, 1, s.w);
    for (int k = 0; k < 3; k++) {
        const enum status want = k == 0   ? INVERTED
                                 : k == 1 ? NONFINITE
                                          : OUTSIDE;
        if (k == 1) s.w[2 * 60] = NAN;
        if (k == 2) s.cloud.p->x[0] = -9.7;
        const enum status got = force(&s.body, s.w, f);
        const enum status also = product(&s.body, s.w, s.u, f);
        expect(got == want && also == want,
               "%s: statuses %s (force) and %s "
               "(product), must be %s",
               k == 0   ? "nodes mirrored, log law"
               : k == 1 ? "a node at NaN"
                        : "a particle far away",
               status_name(got), status_name(also), status_name(want));
    }
    cloud_free(s.cloud);
    expect_refusal("--shake 3 --law log", 1, "INVERTED");
    expect_refusal("--nu 0.5", 2, "nu");
    expect_refusal("--order 4", 2, "order");
    expect_refusal("--ppc 0", 2, "ppc");
}

static void bars_are_the_oracles(void)
{
    struct output *out = run("");
    for (int k = 0; k < COUNT(oracle_bar); k++)
        for (int order = 1; order <= 3; order++) {
            const int row = 4 * (order - 1) + (oracle_bar[k].cells > 8 ? 2 : 0);
            expect_close(cell(out, "crossing", "force_over_stress", row),
                         oracle_bar[k].force[order - 1], 1e-12, 1.0,
                         "F = 1.385, %d cells, order %d: force over stress",
                         oracle_bar[k].cells, order);
            expect_close(cell(out, "crossing", "acceleration", row),
                         oracle_bar[k].acceleration[order - 1], 1e-11, 1000.0,
                         "F = 1.385, %d cells, order %d: acceleration",
                         oracle_bar[k].cells, order);
        }
    out = run("--ppc 3 --stretch 0.85 --law log");
    for (int row = 0; row < 12; row++)
        expect_close(cell(out, "rest", "force_over_stress", row), 0.0, 1e-13,
                     10.0, "in one step from rest, row %d: force over stress",
                     row);
    out = run("--nu 0 --stretch 3 --ppc 1"); /* the cubic law has a second 0 */
    expect(is_missing(out, "crossing", "force_over_stress", 0),
           "F = 3, nu = 0: the bar has no stress, and there is no quotient");
}

/* The bar is under one stress; what is left over of it has a largest value that
 * is known.  60 shifts come close to it and none exceeds it. */
static void crossing_has_its_constant(void)
{
    enum { CELLS = 8, SHIFTS = 60 };
    const struct material cubic = material_notes(CUBIC);
    for (int k = 0; k < COUNT(oracle_crossing); k++)
        for (int order = 1; order <= 3; order++) {
            const double F = oracle_crossing[k].F;
            const double most = oracle_crossing[k].constant[order - 1];
            double worst = 0.0, u[2 * (2 * CELLS + 6)] = {0.0}, f[COUNT(u)];
            for (int i = 0; i < SHIFTS; i++) {
                struct cloud bar =
                    cloud_bar(order, CELLS, oracle_crossing[k].ppc, F,
                              fmod(0.6180339887 * i, 1.0));
                const struct particle_body body = {bar.grid, bar.p, cubic,
                                                   NULL};
                expect(force(&body, u, f) == OK, "the status must be OK");
                worst = fmax(worst, cloud_bar_inner(bar, f).force /
                                        fabs(material1_pk1(&cubic, F)));
                cloud_free(bar);
            }
            expect(worst < most + 1e-12 && worst > 0.85 * most - 1e-12,
                   "a bar stretched by %g, %d particles per cell, order %d: "
                   "force over stress up to %.9g, must be up to %.9g",
                   F, oracle_crossing[k].ppc, order, worst, most);
        }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    const double rest = cell(output, "rest", "force_over_stress", 0);
    measured("2a", cell(output, "crossing", "force_over_stress", 0));
    measured("2b", cell(output, "crossing", "force_over_stress", 3));
    measured("3", fabs(rest) < 1e-12 ? 0.0 : rest); /* round-off is nothing */
}

static const struct claim claims[] = {
    {"affine_motions_have_their_F", affine_motions_have_their_F, "19a"},
    {"shaken_nodes_have_their_F", shaken_nodes_have_their_F, "19a"},
    {"a_bar_stays_a_bar", a_bar_stays_a_bar, "19a"},
    {"forces_add_up_to_nothing", forces_add_up_to_nothing, "19b"},
    {"displaced_nodes_have_no_torque", displaced_nodes_have_no_torque, "19b"},
    {"rigid_motions_turn_the_forces", rigid_motions_turn_the_forces, "19b"},
    {"force_is_the_slope_of_the_energy", force_is_the_slope_of_the_energy,
     "19b"},
    {"forces_are_the_oracles", forces_are_the_oracles, "19b"},
    {"tangent_is_symmetric", tangent_is_symmetric, "19c"},
    {"product_is_the_slope_of_the_force", product_is_the_slope_of_the_force,
     "19c"},
    {"products_are_the_oracles", products_are_the_oracles, "19c"},
    {"elements_are_those_of_lesson_10", elements_are_those_of_lesson_10, NULL},
    {"failures_are_named", failures_are_named, NULL},
    {"bars_are_the_oracles", bars_are_the_oracles, NULL},
    {"crossing_has_its_constant", crossing_has_its_constant, NULL},
};

static const char *const runs[] = {
    "",
    "--order 1 --law log --shake 0.2385 --stretch 0.85 --ppc 3 --shift 0.41",
    "--order 3 --nu 0.2385 --shake 0.51 --stretch 1.713 --ppc 5 --shift 0",
    "--order 2 --law log --nu 0 --shake 0.31 --stretch 2.385 --ppc 1",
    "--shake 0 --stretch 1",
    "--law log --shake 3",
};

#define SUMS "sums over particles and nodes"
static const struct column_rule rules[] = {
    {"force", "node", 0, "a count", 0},
    {"force", "component", 0, "a count", 0},
    {"force", "quotient", 1e-8, "differences with a step of 1e-5 h", FORCE},
    {"force", "*", 1e-12, SUMS, FORCE},
    {"balance", "form", 0, "a word", 0},
    {"balance", "*", 1e-12, SUMS, FORCE},
    {"taylor", "t", 0, "a power of 2", 0},
    {"taylor", "energy", 1e-11, "differences of energies of 20 J", 1},
    {"taylor", "force", 1e-11, "differences of forces", 1},
    {"taylor", "*", 1e-5, "orders of such differences", 1},
    {"crossing", "cells", 0, "a count", 0},
    {"crossing", "ppc", 0, "a count", 0},
    {"crossing", "kernel", 0, "a word", 0},
    {"crossing", "force_over_stress", 1e-12, SUMS, 1},
    {"crossing", "acceleration", 1e-11, SUMS, 1000},
    {"rest", "cells", 0, "a count", 0},
    {"rest", "ppc", 0, "a count", 0},
    {"rest", "kernel", 0, "a word", 0},
    {"rest", "force_over_stress", 1e-12, SUMS, 1},
    {"rest", "acceleration", 1e-11, SUMS, 1000},
};

static const struct lesson lesson = {
    "19_mpm_force",
    claims,
    COUNT(claims),
    runs,
    COUNT(runs),
    rules,
    COUNT(rules),
    "The two bars are under the same stress. Where the particles have not left "
    "their cells the sums are exact; where they have, a force is left over "
    "that "
    "does not fall with h, and the acceleration grows.",
    "Run --stretch 1.5 --ppc 3. Why is every force 0, although the bar is "
    "stretched?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
