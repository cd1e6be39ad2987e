/*
 * 20_mpm_implicit.c - what a right implicit step of particles satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *   20a body (orders, laws), step (rate, 0 too, g, mass), u, v:
 *       residual_is_the_gradient_of_the_potential; mass, v: free_fall_has_no
 *       _residual, and an end that is 0 in residual_agrees_with_the_library
 *   20b grid, wall, at_wall, axes: unknowns_are_those_of_the_wall; columns: the
 *       same, and with the wall on the right
 *   20c body, step (wall, mass, dt, g, 0 too): newton_agrees_with_the_library;
 *       convex: indefinite_matrices_are_projected; dpk1 (none to
 *       all of the 40 halvings), small: newton_ends_as_it_says; report:
 *       inverted_states_are_avoided
 *   20d step, u, p, s (orders), rate: update_is_g2p
 */
#include "program.h"

#include "judge.h"

#include "../oracle/particle_step.h"

#include <stdio.h>
#include <string.h>

#define ROUND_OFF 1e-12  /* of sums of some hundred products */
#define CONVERGED 1e-9   /* Newton's method stops at 1e-10 h */
#define ORACLE 1e-10     /* one step; the method is quadratic */
#define DERIVATIVE 1e-6  /* central differences with a step of 1e-6 */

/* A body on its grid after P2G, and a field u on the nodes with mass. */
struct trial_body {
    struct cloud cloud;
    struct particle_body of;
    struct particle_step how;
    int n_all;
    double *field;
};
static struct trial_body trial_of(struct cloud cloud, enum law law, double dt,
                                  double g, int consistent)
{
    struct trial_body t = {.cloud = cloud, .n_all = 2 * cloud.grid->n_node};
    t.of = (struct particle_body){cloud.grid, cloud.p, material_notes(law),
                                  NULL};
    t.how.rate = dt > 0.0 ? 1.0 / dt : 0.0;
    t.how.consistent = consistent;
    t.how.g[0] = g;
    t.how.g[1] = cloud.grid->nodes[1] > 1 ? -0.7 * g : 0.0;
    expect(grid_p2g(cloud.grid, cloud.p) == OK, "the library's P2G");
    t.field = guarded_alloc(t.n_all);
    for (int s = 0; s < t.n_all; s++)
        t.field[s] = s % 2 < (cloud.grid->nodes[1] > 1 ? 2 : 1)
                         ? 0.02 * cloud.grid->h * ((13 * s + 7) % 29 - 14) / 14
                         : 0.0;
    return t;
}

static double dot_of(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int s = 0; s < n; s++) sum += a[s] * b[s];
    return sum;
}

/* The value of the potential at t->field + along * w, and r there. */
static double potential_at(const struct trial_body *t, double along,
                           const double w[], double r[])
{
    double *place = guarded_copy(t->n_all, t->field);
    struct potential got;
    for (int s = 0; s < t->n_all; s++) place[s] += along * w[s];
    expect(potential(&t->of, &t->how, place, &got, r) == OK,
           "potential: status must be OK");
    return potential_sum(got);
}

/* ---- 20a ----------------------------------------------------------------- */

/* A body at rest that falls freely: u = dt (v + dt g), and no force. */
static void free_fall_has_no_residual(void)
{
    const int orders[] = {1, 2, 3};
    for (int k = 0; k < 6; k++) {
        struct cloud cloud = cloud_block(orders[k / 2]);
        for (int q = 0; q < cloud.p->n; q++) {
            cloud.p->F[q] = mat2_identity();
            cloud.p->v[2 * q] = 0.385;
            cloud.p->v[2 * q + 1] = -0.271;
        }
        if (orders[k / 2] == 1) /* one in the first cell, on node 0 */
            for (int i = 0; i < 2; i++)
                cloud.p->x[i] = cloud.grid->origin[i] + 0.385 * cloud.grid->h;
        struct trial_body t = trial_of(cloud, CUBIC, 0.01, -9.81, k % 2);
        double *r = guarded_alloc(t.n_all);
        for (int s = 0; s < t.n_all; s++)
            t.field[s] =
                0.01 * ((s % 2 ? -0.271 : 0.385) + 0.01 * t.how.g[s % 2]);
        potential_at(&t, 0.0, t.field, r);
        for (int s = 0; s < t.n_all; s++)
            expect_close(r[s], 0.0, ROUND_OFF, 1.0, "free fall, order %d, %s "
                         "mass: r of node %d", orders[k / 2],
                         k % 2 ? "consistent" : "lumped", s / 2);
        cloud_free(cloud);
    }
}

static void residual_is_the_gradient_of_the_potential(void)
{
    for (int k = 0; k < 12; k++) {
        const int order = 1 + k % 3, law = k % 2 ? LOG : CUBIC;
        struct trial_body t =
            trial_of(k < 6 ? cloud_block(order) : cloud_strained(order),
                     (enum law)law, k % 4 ? 0.0238 : 0.0, 3.85, k / 3 % 2);
        double *w = guarded_alloc(t.n_all), *r = guarded_alloc(t.n_all);
        double *unused = guarded_alloc(t.n_all);
        const double e = 1e-6;
        for (int s = 0; s < t.n_all; s++)
            w[s] = t.field[t.n_all - 2 - s + 2 * (s % 2)];
        potential_at(&t, 0.0, w, r);
        const double slope = (potential_at(&t, e, w, unused) -
                              potential_at(&t, -e, w, unused)) / (2.0 * e);
        expect_close(dot_of(t.n_all, r, w), slope, DERIVATIVE, 1.0,
                     "%s, order %d, %s law, 1 / dt = %g, %s mass: r.w, against "
                     "the difference quotient of E", k < 6 ? "block" : "bar",
                     order, material_law((enum law)law), t.how.rate,
                     t.how.consistent ? "consistent" : "lumped");
        cloud_free(t.cloud);
    }
}

static void residual_agrees_with_the_library(void)
{
    for (int k = 0; k < 6; k++) {
        struct trial_body t = trial_of(cloud_block(1 + k % 3), CUBIC, 0.0238,
                                       -9.81, k / 3);
        double *r = guarded_alloc(t.n_all), *want = guarded_alloc(t.n_all);
        double *zero = guarded_alloc(t.n_all);
        struct potential there, here;
        memset(zero, 0, (size_t)t.n_all * sizeof *zero);
        const double got = potential_at(&t, 0.0, zero, r) -
                           potential_at(&t, -1.0, t.field, zero);
        memset(zero, 0, (size_t)t.n_all * sizeof *zero);
        particle_potential(&t.of, &t.how, zero, &here, want);
        particle_potential(&t.of, &t.how, t.field, &there, want);
        expect_close(got, potential_sum(there) - potential_sum(here),
                     ROUND_OFF, 1.0, "E(u) - E(0)");
        for (int s = 0; s < t.n_all; s++)
            expect_close(r[s], want[s], ROUND_OFF, 100.0,
                         "order %d, %s mass: r of node %d", 1 + k % 3,
                         k / 3 ? "consistent" : "lumped", s / 2);
        cloud_free(t.cloud);
    }
}

/* ---- 20b ----------------------------------------------------------------- */

/* The unknowns of the program and of the library move the nodes alike: up to
 * their order and their signs.  Beside the arrays are numbers that look as if
 * they were some of them, and in them what a wall before this has left. */
static void compare_unknowns(const struct grid *on, enum wall wall)
{
    enum { BESIDE = 8 };
    struct unknowns *want = unknowns_alloc(on), map = *want, *got = &map;
    const char *what = wall_name(wall);
    const int n_all = got->n_dof;
    int *room = allocate((size_t)(n_all + 2 * BESIDE), sizeof *room);
    got->equation = room + BESIDE;
    got->sign = guarded_copy(n_all, want->sign);
    for (int s = 0; s < n_all; s++) {
        got->equation[s] = s % 2;
        got->sign[s] = -0.5;
    }
    got->n = n_all;
    number(on, wall, got);
    unknowns_number(on, wall, want);
    for (int i = 0; i < BESIDE; i++)
        expect(room[i] == 0 && got->equation[n_all + i] == 0,
               "equation[] has entries 0 to %d; one beyond is written", n_all);
    expect(got->n == want->n, "wall %s, order %d: got %d unknowns, want %d",
           what, on->order, got->n, want->n);
    for (int s = 0; s < n_all; s++) {
        const int moves = want->equation[s] >= 0;
        expect(got->equation[s] < got->n, "equation[%d] = %d, of %d unknowns",
               s, got->equation[s], got->n);
        expect((got->equation[s] >= 0) == moves, "wall %s, order %d: component "
               "%d of node %d %s", what, on->order, s % 2, s / 2,
               moves ? "must move" : "must not move");
        for (int o = 0; o < s && moves; o++) {
            if (want->equation[o] < 0) continue;
            const int same = want->equation[o] == want->equation[s];
            expect((got->equation[o] == got->equation[s]) == same,
                   "wall %s, order %d: nodes %d and %d must %s", what,
                   on->order, o / 2, s / 2,
                   same ? "share an unknown" : "have unknowns of their own");
            expect(!same || got->sign[o] * got->sign[s] == -1.0,
                   "wall %s, order %d: nodes %d and %d must move against each "
                   "other", what, on->order, o / 2, s / 2);
        }
        expect(!moves || fabs(got->sign[s]) == 1.0, "sign[%d] = %g", s,
               got->sign[s]);
    }
    free(room);
    unknowns_free(want);
}

static void unknowns_are_those_of_the_wall(void)
{
    for (int order = 1; order <= 3; order++)
        for (int wall = NO_WALL; wall <= MIRROR; wall++) {
            struct cloud bar_ = cloud_hanging(order, 8, 2);
            struct cloud block_ = cloud_block(order);
            for (int q = 0; q < block_.p->n; q++) block_.p->x[2 * q] -= 0.13;
            expect(grid_p2g(bar_.grid, bar_.p) == OK &&
                       grid_p2g(block_.grid, block_.p) == OK, "P2G");
            compare_unknowns(bar_.grid, (enum wall)wall);
            compare_unknowns(block_.grid, (enum wall)wall);
            /* nodes with mass everywhere, most of them beyond the wall */
            for (int a = 0; a < block_.grid->n_node; a++)
                block_.grid->mass[a] = 1.0;
            block_.grid->origin[0] =
                -block_.grid->h * ((block_.grid->nodes[0] + 1) / 2);
            compare_unknowns(block_.grid, (enum wall)wall);
            cloud_free(bar_);
            cloud_free(block_);
        }
}

/* ---- 20c ----------------------------------------------------------------- */

static struct particle_report solved(const struct trial_body *t, double u[])
{
    const struct particle_report got = newton(&t->of, &t->how, u);
    expect(got.status == OK, "newton: status %s after %d iterations, dt = %g",
           status_name(got.status), got.iterations, 1.0 / t->how.rate);
    return got;
}

static struct trial_body scene_of(int k)
{
    const int order = 1 + k % 3;
    struct trial_body t = k < 3   ? trial_of(cloud_block(order), CUBIC, 0.0333,
                                             0.0, 0)
                          : k < 6 ? trial_of(cloud_strained(order), LOG, 0.01,
                                             -9.81, k == 4)
                                  : trial_of(cloud_hanging(order, 8, 2), CUBIC,
                                             k < 9 ? 0.0 : 0.0333, 500.0, 0);
    if (k >= 6) t.how.wall = k < 9 ? MIRROR : HELD;
    return t;
}

static void newton_agrees_with_the_library(void)
{
    for (int k = 0; k < 12; k++) {
        struct trial_body t = scene_of(k);
        double *u = guarded_alloc(t.n_all), *want = guarded_alloc(t.n_all);
        solved(&t, u);
        particle_newton(&t.of, &t.how, 1e-12, want);
        for (int s = 0; s < t.n_all; s++)
            expect_close(u[s], want[s], CONVERGED, 1.0,
                         "scene %d: component %d of u of node %d", k, s % 2,
                         s / 2);
        cloud_free(t.cloud);
    }
}

/* du falls like its square, so that ten systems are plenty. */
static void newton_is_quadratic(void)
{
    for (int k = 0; k < 12; k++) {
        struct trial_body t = scene_of(k);
        double *u = guarded_alloc(t.n_all);
        const int systems = solved(&t, u).iterations;
        expect(systems <= 10, "scene %d: %d iterations, where a right tangent "
               "takes at most 7", k, systems);
        cloud_free(t.cloud);
    }
}

/* sum m v grows by dt sum m g; L by dt sum m v_new cross v_old. */
static void free_bodies_obey_the_balances(void)
{
    for (int k = 0; k < 6; k++) {
        struct trial_body t = scene_of(k);
        struct grid *on = t.cloud.grid;
        double *u = guarded_alloc(t.n_all), L = 0.0, due = 0.0;
        double gain[2] = {0.0, 0.0}, impulse[2] = {0.0, 0.0};
        solved(&t, u);
        for (int a = 0; a < on->n_node; a++) {
            const double *v = &on->v[2 * a], m = on->mass[a];
            const double new[2] = {t.how.rate * u[2 * a],
                                   t.how.rate * u[2 * a + 1]};
            double x[2];
            grid_place(on, a, x);
            for (int i = 0; i < 2; i++) {
                gain[i] += m * (new[i] - v[i]);
                impulse[i] += m * t.how.g[i] / t.how.rate;
            }
            L += m * ((x[0] + u[2 * a]) * new[1] - (x[1] + u[2 * a + 1]) *
                      new[0] - x[0] * v[1] + x[1] * v[0]);
            due += m * (new[0] * v[1] - new[1] * v[0]) / t.how.rate;
        }
        for (int i = 0; i < 2; i++)
            expect_close(gain[i], impulse[i], ROUND_OFF * 10.0, 1.0,
                         "scene %d: momentum after one step, less before", k);
        if (k < 3)
            expect_close(L, due, ROUND_OFF * 10.0, 1.0,
                         "scene %d: angular momentum of the moved nodes, less "
                         "before", k);
        cloud_free(t.cloud);
    }
}

/* At rest the nodes that are held carry everything. */
static void wall_carries_the_weight(void)
{
    for (int order = 1; order <= 3; order++) {
        struct trial_body t =
            trial_of(cloud_hanging(order, 8, 4), CUBIC, 0.0, 500.0, 0);
        double *u = guarded_alloc(t.n_all), *r = guarded_alloc(t.n_all);
        double reaction = 0.0;
        struct potential unused;
        t.how.wall = HELD;
        solved(&t, u);
        particle_potential(&t.of, &t.how, u, &unused, r);
        for (int a = 0; a <= 2; a++) reaction -= r[2 * a];
        expect_close(reaction, 500.0, CONVERGED, 500.0,
                     "order %d: force on the nodes at x <= 0", order);
        cloud_free(t.cloud);
    }
}

static void balances_hold(void)
{
    free_bodies_obey_the_balances();
    wall_carries_the_weight();
}

/* Halves of a log bar that run into each other: u = dt v would turn particles
 * inside out, and so does the first du. */
static void inverted_states_are_avoided(void)
{
    for (int order = 1; order <= 3; order++) {
        struct cloud cloud = cloud_hanging(order, 8, 2);
        for (int q = 0; q < cloud.p->n; q++) {
            cloud.p->x[2 * q] += 0.3;
            cloud.p->v[2 * q] = q < cloud.p->n / 2 ? 240.0 : -240.0;
        }
        struct trial_body t = trial_of(cloud, LOG, 0.0333, 0.0, 0);
        double *u = guarded_alloc(t.n_all), *r = guarded_alloc(t.n_all);
        double *zero = guarded_alloc(t.n_all);
        memset(zero, 0, (size_t)t.n_all * sizeof *zero);
        struct potential before, after;
        const struct particle_report got = solved(&t, u);
        const struct particle_report due =
            particle_newton(&t.of, &t.how, 1e-10, guarded_alloc(t.n_all));
        expect(due.part[0] < 1.0, "the first du is taken whole");
        expect(got.part[0] == due.part[0], "order %d: report.part[0] is %g; of "
               "du %g is the first of 1, 1/2, ... with which E falls", order,
               got.part[0], due.part[0]);
        particle_potential(&t.of, &t.how, zero, &before, r);
        expect(particle_potential(&t.of, &t.how, u, &after, r) == OK &&
                   potential_sum(after) < potential_sum(before),
               "order %d: the potential must decrease", order);
        cloud_free(cloud);
    }
}

/* A tangent 1e16 times too soft: du is so much too long. */
static mat2 much_too_soft(const struct material *material, mat2 F, mat2 dF)
{
    return mat2_scale(1e-16, material2_dpk1(material, F, dF));
}

/* 1e10 times: 40 halvings of du are enough, and 30 are not. */
static mat2 too_soft(const struct material *material, mat2 F, mat2 dF)
{
    return mat2_scale(1e-10, material2_dpk1(material, F, dF));
}

/* A tangent a hundred times too stiff: a step goes a hundredth of the way. */
static mat2 much_too_stiff(const struct material *material, mat2 F, mat2 dF)
{
    return mat2_scale(100.0, material2_dpk1(material, F, dF));
}

/* Ten times, so that r falls by a tenth only. */
static mat2 too_stiff(const struct material *material, mat2 F, mat2 dF)
{
    return mat2_scale(10.0, material2_dpk1(material, F, dF));
}

/* max|A^-1 r| of the unknowns at u; max|r| over max A_ii in *residual. */
static double next_increment(const struct trial_body *t, const double u[],
                             double *residual)
{
    struct unknowns *map = unknowns_alloc(t->cloud.grid);
    unknowns_number(t->cloud.grid, t->how.wall, map);
    struct matrix *A = unknowns_matrix(&t->of, map);
    double *r = guarded_alloc(t->n_all), *y = guarded_alloc(map->n);
    struct potential unused;
    particle_potential(&t->of, &t->how, u, &unused, r);
    particle_stiffness(&t->of, u, map->equation, map->sign, A);
    particle_mass_matrix(&t->of, 0, t->how.rate * t->how.rate, map, A);
    unknowns_gather(map, r, y);
    *residual = unknowns_largest(map, y) / matrix_max_diagonal(A);
    expect(matrix_factor(A) == OK, "A must be positive definite");
    matrix_solve(A, y);
    const double largest = unknowns_largest(map, y);
    matrix_free(A);
    unknowns_free(map);
    return largest;
}

/* Velocities of the nodes that pull them all the same way; or to and fro, so
 * that the first u is -1 and 1 by turns. */
static void pull(struct trial_body *t, int rough)
{
    struct grid *on = t->cloud.grid;
    double *u = guarded_alloc(t->n_all), *r = guarded_alloc(t->n_all);
    struct potential unused;
    for (int s = 0; s < t->n_all; s++) {
        on->v[s] = 0.0;
        u[s] = s % 2 || s / 2 <= 2 ? 0.0 : s / 2 % 2 ? -1e-3 : 1e-3;
    }
    particle_potential(&t->of, &t->how, u, &unused, r);
    for (int s = 0; s < t->n_all; s += 2)
        if (on->mass[s / 2] > 0.0)
            on->v[s] = rough ? r[s] / on->mass[s / 2] : 1.0;
}

/* A linear bar whose nodes are pulled: du is large while r is small, or r while
 * du is. */
static void both_criteria_are_asked(void)
{
    for (int rough = 0; rough < 2; rough++) {
        struct cloud cloud = cloud_hanging(1, 8, 2);
        struct trial_body t = trial_of(cloud, LINEAR, 10.0, 0.0, 0);
        const double small = 1e-10 * cloud.grid->h;
        double *u = guarded_alloc(t.n_all), residual, increment;
        t.how.wall = HELD;
        t.of.dpk1 = too_stiff;
        t.how.rate = 1e5; /* first a step whose A is much larger */
        solved(&t, u);
        t.how.rate = 0.1;
        pull(&t, rough);
        for (int s = 0; s < t.n_all; s++) u[s] = 0.0;
        increment = next_increment(&t, u, &residual);
        /* a first du that is small, or a first r that is */
        for (int s = 0; s < t.n_all; s++)
            cloud.grid->v[s] *= 0.95 * small / (rough ? increment : residual);
        solved(&t, u);
        increment = next_increment(&t, u, &residual);
        expect(residual <= small, "a bar pulled %s, A ten times too stiff: in "
               "the end max|r| is %g max A_ii, which is more than %g",
               rough ? "to and fro" : "one way", residual, small);
        expect(increment <= small, "a bar pulled %s, A ten times too stiff: in "
               "the end the next max|du| would be %g, which is more than %g",
               rough ? "to and fro" : "one way", increment, small);
        cloud_free(cloud);
    }
}

static void failures_are_named(void)
{
    struct trial_body soft =
        trial_of(cloud_hanging(2, 8, 2), CUBIC, 0.0, 500.0, 0);
    soft.how.wall = HELD;
    soft.of.dpk1 = much_too_soft;
    const struct particle_report end =
        newton(&soft.of, &soft.how, guarded_alloc(soft.n_all));
    expect(end.status == STALLED && end.iterations <= 1, "du is 1e16 times too "
           "long, so that 40 halvings are not enough: the status must be "
           "STALLED after 0 or 1 iterations, not %s after %d",
           status_name(end.status), end.iterations);
    soft.of.dpk1 = too_soft;
    const struct particle_report far =
        newton(&soft.of, &soft.how, guarded_alloc(soft.n_all));
    expect(far.iterations > 1 || far.status != STALLED, "du is 1e10 times too "
           "long, so that some 35 halvings are enough: not STALLED after %d "
           "iterations; the line search may halve 40 times", far.iterations);
    cloud_free(soft.cloud);
    struct trial_body stiff =
        trial_of(cloud_hanging(2, 8, 2), CUBIC, 0.0, 500.0, 0);
    stiff.how.wall = HELD;
    stiff.of.dpk1 = much_too_stiff;
    const struct particle_report slow =
        newton(&stiff.of, &stiff.how, guarded_alloc(stiff.n_all));
    expect(slow.status == MAX_ITERATIONS && slow.iterations == STEP_CAP, "du "
           "is a hundred times too short: MAX_ITERATIONS after %d systems, not "
           "%s after %d", STEP_CAP, status_name(slow.status), slow.iterations);
    cloud_free(stiff.cloud);
    struct trial_body t =
        trial_of(cloud_hanging(3, 8, 1), CUBIC, 0.0, 500.0, 0);
    double *u = guarded_alloc(t.n_all);
    t.how.wall = MIRROR;
    enum status got = newton(&t.of, &t.how, u).status;
    expect(got == NOT_SPD, "cubic kernel, one particle per cell, no inertia: "
           "some nodes move without strain, so the status must be NOT_SPD, not "
           "%s", status_name(got));
    t.how.wall = NO_WALL;
    got = newton(&t.of, &t.how, u).status;
    expect(got == NOT_SPD, "a static bar that nothing holds must be NOT_SPD, "
           "not %s", status_name(got));
    cloud_free(t.cloud);
}

static void newton_ends_as_it_says(void)
{
    both_criteria_are_asked();
    failures_are_named();
}

/* A block at rest, pressed to half its area, a long step: A is indefinite at
 * u = 0.  There may be several u with r = 0; any will do. */
static void indefinite_matrices_are_projected(void)
{
    for (int k = 0; k < 4; k++) {
        const char *law = k / 2 ? "cubic" : "log";
        struct cloud cloud = cloud_block(1 + k % 2);
        for (int q = 0; q < cloud.p->n; q++) {
            cloud.p->F[q] = mat2_scale(0.7, cloud.p->F[q]);
            cloud.p->v[2 * q] = cloud.p->v[2 * q + 1] = 0.0;
        }
        struct trial_body t = trial_of(cloud, k / 2 ? CUBIC : LOG, 0.3, 0.0, 0);
        double *u = guarded_alloc(t.n_all), *r = guarded_alloc(t.n_all);
        double *zero = guarded_alloc(t.n_all);
        memset(zero, 0, (size_t)t.n_all * sizeof *zero);
        struct potential before, after;
        const struct particle_report got = newton(&t.of, &t.how, u);
        expect(got.status == OK, "a pressed block, %s law: A is indefinite, "
               "and has to be projected; the status is %s", law,
               status_name(got.status));
        particle_potential(&t.of, &t.how, zero, &before, r);
        particle_potential(&t.of, &t.how, u, &after, r);
        for (int s = 0; s < t.n_all; s++)
            expect_close(r[s], 0.0, CONVERGED, 100.0, "a pressed block, %s "
                         "law: r of node %d", law, s / 2);
        expect(potential_sum(after) < potential_sum(before),
               "a pressed block, %s law: the potential must decrease", law);
        cloud_free(cloud);
    }
}

/* ---- 20d ----------------------------------------------------------------- */

static void update_is_g2p(void)
{
    for (int k = 0; k < 6; k++) {
        const double dt = k < 2 ? 2.385 : 0.0238;
        const enum transfer scheme = k % 2 ? FLIP : PIC;
        struct trial_body t =
            trial_of(cloud_block(1 + k / 2), CUBIC, dt, 0.0, 0);
        struct cloud other = cloud_block(1 + k / 2);
        t.how.transfer = scheme;
        for (int s = 0; s < t.n_all; s++)
            t.cloud.grid->next[s] = t.field[s] / dt;
        expect(grid_g2p(t.cloud.grid, scheme, dt, other.p) == OK, "G2P");
        expect(update(t.cloud.grid, &t.how, t.field, t.cloud.p) == OK,
               "update: status must be OK");
        for (int q = 0; q < other.p->n; q++) {
            for (int i = 0; i < 4; i++)
                expect_close(t.cloud.p->F[q].m[i / 2][i % 2],
                             other.p->F[q].m[i / 2][i % 2], ROUND_OFF, 1.0,
                             "%s, particle %d: F_%d%d", transfer_name(scheme),
                             q, i / 2 + 1, i % 2 + 1);
            for (int i = 2 * q; i < 2 * q + 2; i++) {
                expect_close(t.cloud.p->x[i], other.p->x[i], ROUND_OFF, 1.0,
                             "%s, particle %d: x", transfer_name(scheme), q);
                expect_close(t.cloud.p->v[i], other.p->v[i], ROUND_OFF, 1.0,
                             "%s, particle %d: v", transfer_name(scheme), q);
            }
        }
        cloud_free(t.cloud);
        cloud_free(other);
    }
}

/* ---- all together -------------------------------------------------------- */

/* A step of dt against an explicit one: velocities differ by dt^2, and they
 * change by dt. */
static void small_steps_are_explicit(void)
{
    double error[2];
    for (int k = 0; k < 2; k++) {
        const double dt = k ? 1e-5 : 2e-5;
        struct trial_body t = trial_of(cloud_block(2), CUBIC, dt, -9.81, 0);
        double *u = guarded_alloc(t.n_all), *f = guarded_alloc(t.n_all);
        double *zero = guarded_alloc(t.n_all);
        const struct grid *on = t.cloud.grid;
        memset(zero, 0, (size_t)t.n_all * sizeof *zero);
        solved(&t, u);
        particle_force(&t.of, zero, f);
        error[k] = 0.0;
        for (int s = 0; s < t.n_all; s++)
            if (on->mass[s / 2] > 0.005) {
                const double a = f[s] / on->mass[s / 2] + t.how.g[s % 2];
                const double got = (u[s] / dt - on->v[s]) / dt;
                error[k] = fmax(error[k], fabs(got - a));
            }
        cloud_free(t.cloud);
    }
    expect_close(log2(error[0] / error[1]), 1.0, 0.1, 1.0,
                 "order in dt of (v_new - v) / dt, against the explicit step");
}

static void steps_are_the_oracles(void)
{
    static const char *const component[] = {"F11", "F12", "F21", "F22"};
    for (int k = 0; k < 2 * COUNT(oracle_step); k++) {
        char options[120];
        const int flip = k % 2;
        snprintf(options, sizeof options, "%s%s%s", oracle_step[k / 2].options,
                 *oracle_step[k / 2].options ? " " : "",
                 flip ? "--scheme FLIP" : "--scheme PIC");
        struct output *out = run(options);
        const struct {
            const char *name;
            double want;
        } is[] = {{"elastic", oracle_step[k / 2].elastic},
                  {"grid_before", oracle_step[k / 2].grid_before},
                  {"grid_after", oracle_step[k / 2].grid_after},
                  {"potential", oracle_step[k / 2].potential}};
        for (int i = 0; i < COUNT(is); i++)
            expect_close(cell(out, "energies", is[i].name, 1), is[i].want,
                         ORACLE, 1.0, "%s: %s after one step", options,
                         is[i].name);
        for (int p = 0; p < 3; p++) {
            const int q = oracle_step[k / 2].at[p].particle;
            for (int i = 0; i < 2; i++) {
                expect_close(cell(out, "particles", i ? "y" : "x", q),
                             oracle_step[k / 2].at[p].x[i], ORACLE, 1.0,
                             "%s: place of particle %d", options, q);
                expect_close(cell(out, "particles", i ? "v_y" : "v_x", q),
                             flip ? oracle_step[k / 2].at[p].flip[i]
                                  : oracle_step[k / 2].at[p].pic[i],
                             ORACLE, 10.0, "%s: velocity of particle %d",
                             options, q);
            }
            for (int i = 0; i < 4; i++)
                expect_close(cell(out, "particles", component[i], q),
                             oracle_step[k / 2].at[p].F[i], ORACLE, 1.0,
                             "%s: %s of particle %d", options, component[i], q);
        }
    }
}

/* The worst place of a hanging bar that is loaded in so many steps. */
static double hang(int order, enum law law, enum wall wall, int cells, int ppc,
                   int loads, double *stress)
{
    const struct material made_of = material_notes(law);
    struct cloud cloud = cloud_hanging(order, cells, ppc);
    double *u = guarded_alloc(2 * cloud.grid->n_node);
    for (int k = 1; k <= loads; k++) {
        struct trial_body t = trial_of(cloud, law, 0.0, 500.0 * k / loads, 0);
        t.how.wall = wall;
        solved(&t, u);
        expect(update(cloud.grid, &t.how, u, cloud.p) == OK, "update");
    }
    const struct hanging_error worst = hanging_error(cloud.p, &made_of, 500.0);
    *stress = worst.stress / 500.0;
    cloud_free(cloud);
    return worst.place;
}

static void hanging_bars_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_hanging); k++) {
        double stress;
        const double place =
            hang(oracle_hanging[k].order, oracle_hanging[k].cubic ? CUBIC : LOG,
                 oracle_hanging[k].mirror ? MIRROR : HELD,
                 oracle_hanging[k].cells, oracle_hanging[k].ppc,
                 oracle_hanging[k].loads, &stress);
        expect_close(place, oracle_hanging[k].error, 1e-7, 1.0,
                     "order %d, %s wall, %d cells, %d particles per cell, %d "
                     "loads: error of the places", oracle_hanging[k].order,
                     oracle_hanging[k].mirror ? "mirror" : "held",
                     oracle_hanging[k].cells, oracle_hanging[k].ppc,
                     oracle_hanging[k].loads);
        expect_close(stress, oracle_hanging[k].stress_error, 1e-6, 1.0,
                     "... and of the stress");
    }
}

/* Errors C h^p of the closed form: p and C. */
static void static_bars_have_their_order(void)
{
    const struct {
        int order, wall;
        double slope, constant;
    } due[] = {{1, MIRROR, 2.0, 0.0669}, {2, MIRROR, 2.0, 0.0407},
               {3, MIRROR, 2.0, 0.0253}, {2, HELD, 1.0, 0.2302},
               {3, HELD, 1.0, 0.3176}};
    for (int k = 0; k < COUNT(due); k++) {
        double unused;
        const enum wall wall = (enum wall)due[k].wall;
        const int order = due[k].order;
        const double coarse = hang(order, CUBIC, wall, 16, 2, 1, &unused);
        const double fine = hang(order, CUBIC, wall, 32, 2, 1, &unused);
        expect_close(log2(coarse / fine), due[k].slope, 0.05, 1.0,
                     "order %d kernel, wall %s: order in h", due[k].order,
                     wall_name(wall));
        expect_close(fine * pow(32.0, due[k].slope), due[k].constant, 0.02,
                     due[k].constant, "order %d kernel, wall %s: constant",
                     due[k].order, wall_name(wall));
    }
}

static void hanging_bars_are_right(void)
{
    static_bars_have_their_order();
    hanging_bars_are_the_oracles();
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *held = run("--wall held"), *mirror = run("--wall mirror");
    struct output *cubic = run("--order 3 --wall mirror");
    /* one particle in the middle of a linear cell is an element */
    const double elements = cell(run("--order 1"), "bar", "error", 1);
    measured("1a", cell(cubic, "bar", "error", 5) / elements);
    measured("1b", cell(cubic, "bar", "error", 11) / elements);
    measured("2a", log2(cell(held, "bar", "error", 8) /
                        cell(held, "bar", "error", 9)));
    measured("2b", log2(cell(mirror, "bar", "error", 8) /
                        cell(mirror, "bar", "error", 9)));
}

static const struct claim claims[] = {
    {"free_fall_has_no_residual", free_fall_has_no_residual, "20a"},
    {"residual_is_the_gradient_of_the_potential",
     residual_is_the_gradient_of_the_potential, "20a"},
    {"residual_agrees_with_the_library", residual_agrees_with_the_library,
     "20a"},
    {"unknowns_are_those_of_the_wall", unknowns_are_those_of_the_wall, "20b"},
    {"newton_is_quadratic", newton_is_quadratic, "20c"},
    {"inverted_states_are_avoided", inverted_states_are_avoided, "20c"},
    {"newton_ends_as_it_says", newton_ends_as_it_says, "20c"},
    {"indefinite_matrices_are_projected", indefinite_matrices_are_projected,
     "20c"},
    {"balances_hold", balances_hold, "20c"},
    {"newton_agrees_with_the_library", newton_agrees_with_the_library, "20c"},
    {"small_steps_are_explicit", small_steps_are_explicit, "20c"},
    {"update_is_g2p", update_is_g2p, "20d"},
    {"hanging_bars_are_right", hanging_bars_are_right, NULL},
    {"steps_are_the_oracles", steps_are_the_oracles, NULL},
};

static const char *const runs[] = {
    "",
    "--wall mirror --steps 4 --law log",
    "--order 1 --wall mirror --steps 3 --scheme FLIP --dt 0.01",
    "--order 3 --scene strained --steps 3 --dt 0.002385",
    "--scene strained --mass consistent --dt 0.0238 --steps 2",
    "--scene block --steps 5 --scheme FLIP --dt 0.01",
    "--scene block --order 3 --law log --steps 3",
};

#define STATE "Newton's method to 1e-10, beyond which it is quadratic"
static const struct column_rule rules[] = {
    {"energies", "t", 1e-14, "k dt", 0},
    {"energies", "iterations", 1, "the last test may fall either way", 1},
    {"energies", "*", 1e-8, STATE, 1},
    {"newton", "k", 0, "a count", 0},
    {"newton", "part", 0, "a power of 1/2", 1},
    {"newton", "*", 1e-7, "differences of the iterates", 0},
    {"step", "node", 0, "a number", 0},
    {"step", "x", 1e-14, "the grid", 1},
    {"step", "y", 1e-14, "the grid", 1},
    {"step", "*", 1e-7, STATE ", / dt, where nodes are light", 0},
    {"particles", "*", 1e-8, STATE, 1},
    {"bar", "cells", 0, "a count", 0},
    {"bar", "ppc", 0, "a count", 0},
    {"bar", "wall", 0, "a word", 0},
    {"bar", "loads", 0, "a count", 0},
    {"bar", "status", 0, "a word", 0},
    {"bar", "*", 1e-7, STATE, 1},
};

static const struct lesson lesson = {
    "20_mpm_implicit", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "The step does not care how little mass a node has: where explicit steps "
    "with the linear kernel would have to shrink to nothing, four linear "
    "systems are enough. It does care whether particles hold the nodes: "
    "with one per cell the second load is NOT_SPD.",
    "Take the guess u = dt v in newton() and run --scene strained --law log "
    "with ever longer steps. When does a status other than OK come?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
