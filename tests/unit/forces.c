/* forces.c - laws of particle_force.h: forces are slopes of the energy, the
 * tangent is that of the forces, and the numbers are the oracle's. */
#include "particles/particle_force.h"
#include "particles/particle_scene.h"

#include "../oracle/particle_force.h"
#include "unit.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define H 0.385

enum { NODES = 11 * 11, DOF = 2 * NODES };

/* Seven particles on a grid with nodes at H (-2 ... 8), displaced by u. */
struct scene {
    struct particle_body body;
    struct grid *grid;
    struct particles *particles;
    double u[DOF], w[DOF]; /* w: another irregular field */
};
static struct scene seven(int order, enum law law)
{
    const double low[2] = {-2.0 * H, -2.0 * H};
    const int nodes[2] = {11, 11};
    struct scene s = {.grid = grid_alloc(order, low, H, nodes)};
    s.particles = particles_seven(NULL);
    s.body = (struct particle_body){.grid = s.grid,
                                    .particles = s.particles,
                                    .material = material_notes(law)};
    grid_shake(s.grid, 0.35 * H, s.u);
    for (int r = 0; r < DOF; r++) s.w[r] = s.u[(7 * r + 31) % DOF];
    return s;
}

static void scene_free(struct scene *s)
{
    grid_free(s->grid);
    particles_free(s->particles);
}

static double dot(const double a[], const double b[])
{
    double sum = 0.0;
    for (int r = 0; r < DOF; r++) sum += a[r] * b[r];
    return sum;
}

/* out := K w, all unknowns by themselves. */
static enum status times(const struct particle_body *body, const double u[],
                         const double w[], double out[])
{
    const int n = 2 * body->grid->n_node;
    int equation[DOF];
    for (int r = 0; r < n; r++) equation[r] = r;
    struct matrix *K = matrix_alloc(BANDED, n, n);
    const enum status status = particle_stiffness(body, u, equation, NULL, K);
    matrix_multiply(K, w, out);
    matrix_free(K);
    return status;
}

/* Node of the oracle's cell (i, j). */
static int node_at(const int cell[2])
{
    return (cell[1] + 2) * 11 + cell[0] + 2;
}

/* Relative to forces of size 50 and entries of K of size 500; the oracle has 16
 * digits, and sums of ten terms lose two of them. */
static void forces_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_force); k++) {
        const enum law law = strcmp(oracle_force[k].law, "log") ? CUBIC : LOG;
        struct scene s = seven(oracle_force[k].order, law);
        double energy, f[DOF], Kw[DOF], torque;
        ck_assert(particle_energy(&s.body, s.u, &energy) == OK);
        ck_assert(particle_force(&s.body, s.u, f) == OK);
        close_to(energy, oracle_force[k].energy, 1e-12);
        close_to(dot(f, s.u), oracle_force[k].work, 1e-12);
        torque = grid_balance(s.grid, NULL, f).torque;
        close_to(torque, oracle_force[k].torque, 1e-11);
        ck_assert(times(&s.body, s.u, s.u, Kw) == OK);
        close_to(dot(Kw, s.u), oracle_force[k].bend, 1e-12);
        memset(s.w, 0, sizeof s.w);
        s.w[2 * node_at(oracle_force[k].column)] = 1.0;
        ck_assert(times(&s.body, s.u, s.w, Kw) == OK);
        for (int n = 0; n < ORACLE_FORCE_NODES; n++) {
            const int a = node_at(oracle_force[k].row[n].node);
            for (int i = 0; i < 2; i++) {
                close_to(f[2 * a + i], oracle_force[k].row[n].f[i], 1e-11);
                close_to(Kw[2 * a + i], oracle_force[k].row[n].K[i], 1e-10);
            }
        }
        scene_free(&s);
    }
}

/* Displacements move the grid's image of the body and not the space around it:
 * neither a force nor a torque, about the nodes where they are now. */
static void forces_balance(void)
{
    for (int order = 1; order <= ORDER_MAX; order++)
        for (enum law law = LINEAR; law <= CUBIC; law++) {
            struct scene s = seven(order, law);
            double f[DOF];
            ck_assert(particle_force(&s.body, s.u, f) == OK);
            const struct balance sum = grid_balance(s.grid, s.u, f);
            for (int i = 0; i < 2; i++) close_to(sum.force[i], 0.0, 1e-12);
            if (law != LINEAR) close_to(sum.torque, 0.0, 1e-12);
            for (int r = 0; r < DOF; r++) f[r] = r == 2 * 50 + 1 ? 2.0 : 0.0;
            const struct balance one = grid_balance(s.grid, s.u, f);
            double x[2];
            grid_place(s.grid, 50, x);
            close_to(one.force[0], 0.0, 1e-300);
            close_to(one.force[1], 2.0, 1e-300);
            close_to(one.torque, 2.0 * (x[0] + s.u[100]), 1e-14);
            for (int r = 0; r < DOF; r++) f[r] = r == DOF - 1 ? 2.0 : 0.0;
            close_to(grid_balance(s.grid, s.u, f).force[1], 2.0, 1e-300);
            scene_free(&s);
        }
}

/* Energy, force and tangent by central differences. */
static void slopes_agree(void)
{
    for (int order = 1; order <= ORDER_MAX; order++)
        for (enum law law = LINEAR; law <= CUBIC; law++) {
            struct scene s = seven(order, law);
            const double step = 1e-5;
            double f[DOF], Kw[DOF], v[2][DOF], at[DOF], energy[2];
            ck_assert(particle_force(&s.body, s.u, f) == OK);
            ck_assert(times(&s.body, s.u, s.w, Kw) == OK);
            for (int side = 0; side < 2; side++) {
                for (int r = 0; r < DOF; r++)
                    at[r] = s.u[r] + (side ? step : -step) * s.w[r];
                ck_assert(particle_energy(&s.body, at, &energy[side]) == OK);
                ck_assert(particle_force(&s.body, at, v[side]) == OK);
            }
            /* central differences: an error of step^2 times third derivatives,
             * and round-off of the energy, 20 eps / step */
            close_to((energy[0] - energy[1]) / (2.0 * step), dot(f, s.w), 1e-8);
            for (int r = 0; r < DOF; r++)
                close_to((v[0][r] - v[1][r]) / (2.0 * step), Kw[r], 1e-7);
            scene_free(&s);
        }
}

/* The other ways to the force; differences have errors of step^2 times third
 * derivatives, and round-off of 20 J over the step. */
static void three_forms_are_one_force(void)
{
    for (int order = 1; order <= ORDER_MAX; order++)
        for (enum law law = LOG; law <= CUBIC; law++) {
            struct scene s = seven(order, law);
            double f[DOF], cauchy[DOF], slope[DOF];
            for (int r = 0; r < DOF; r++) f[r] = cauchy[r] = slope[r] = NAN;
            ck_assert(particle_force(&s.body, s.u, f) == OK);
            ck_assert(particle_cauchy_force(&s.body, s.u, cauchy) == OK);
            ck_assert(
                particle_difference_force(&s.body, s.u, 1e-5 * H, slope) == OK);
            for (int r = 0; r < DOF; r++) {
                close_to(cauchy[r], f[r], 1e-12);
                close_to(slope[r], f[r], 1e-7);
            }
            scene_free(&s);
        }
}

/* Errors fall like t^2, and like t when force or tangent are wrong. */
static void taylor_tells_right_from_wrong(void)
{
    for (int wrong = 0; wrong < 3; wrong++) {
        struct scene s = seven(2, LOG);
        double f[DOF], Kw[DOF], right[DOF];
        struct taylor error[2];
        ck_assert(particle_force(&s.body, s.u, right) == OK);
        ck_assert(times(&s.body, s.u, s.w, Kw) == OK);
        memcpy(f, right, sizeof f);
        for (int r = 0; r < DOF; r++) {
            if (wrong == 1) f[r] *= 1.1;
            if (wrong == 2) Kw[r] *= 1.1;
        }
        for (int k = 0; k < 2; k++)
            ck_assert(particle_taylor(&s.body, s.u, s.w, k ? 5e-5 : 1e-4, f, Kw,
                                      &error[k]) == OK);
        const double energy = log2(error[0].energy / error[1].energy);
        const double force = log2(error[0].force / error[1].force);
        close_to(energy, wrong == 1 ? 1.0 : 2.0, 0.02);
        close_to(force, wrong == 0 ? 2.0 : wrong == 1 ? 0.0 : 1.0, 0.02);
        /* the first term that is left out of the energy, t^2 w.K w / 2 */
        if (wrong == 0)
            close_to(error[0].energy / (0.5e-8 * dot(s.w, Kw)), 1.0, 0.01);
        scene_free(&s);
    }
}

/* Particles F X + shift h with F_p = F and masses on the nodes; the force that
 * crossing leaves over is the oracle's. */
static void a_stretched_bar_is_the_oracles(void)
{
    const struct material cubic = material_notes(CUBIC);
    for (int k = 0; k < COUNT(oracle_bar); k++)
        for (int order = 1; order <= ORDER_MAX; order++) {
            const double F = 1.385, h = 1.0 / oracle_bar[k].cells;
            struct cloud bar =
                cloud_bar(order, oracle_bar[k].cells, 2, F, 0.0137);
            const struct particle_body body = {
                .grid = bar.grid, .particles = bar.p, .material = cubic};
            const size_t n = 2 * (size_t)bar.grid->n_node;
            double *u = allocate(2 * n, sizeof *u), *f = u + n;
            close_to(bar.p->x[0], F * 0.25 * h + 0.0137 * h, 1e-15);
            close_to(grid_moments(bar.grid, u).mass, 1.0, 1e-13);
            ck_assert(particle_force(&body, u, f) == OK);
            const struct inner inner = cloud_bar_inner(bar, f);
            close_to(inner.force / material1_pk1(&cubic, F),
                     oracle_bar[k].force[order - 1], 1e-12);
            close_to(inner.acceleration, oracle_bar[k].acceleration[order - 1],
                     1e-8);
            for (int a = 0; a < bar.grid->n_node; a++) { /* ends do not count */
                const double at = h * (a - 2) - 0.0137 * h;
                f[2 * a] = at < 1.99 * h || at > F - 1.99 * h   ? 1e9
                           : at < 2.99 * h || at > F - 2.99 * h ? 2.0
                                                                : -1.0;
                bar.grid->mass[a] = 4.0;
            }
            close_to(cloud_bar_inner(bar, f).force, 2.0, 1e-300);
            close_to(cloud_bar_inner(bar, f).acceleration, 0.5, 1e-300);
            free(u);
            cloud_free(bar);
        }
}

/* Two nodes that a mirror makes one: K w of all unknowns, folded. */
static void the_matrix_is_folded(void)
{
    for (int order = 1; order <= ORDER_MAX; order++) {
        struct scene s = seven(order, LOG);
        int equation[DOF], n = 0;
        double sign[DOF], y[DOF], Kw[DOF], Ky[DOF], folded[DOF] = {0.0};
        for (int r = 0; r < DOF; r++) { /* nodes 3 cells apart are mirrored */
            const int twin = 2 * (r / 2 - 3) + r % 2;
            const int mirrored = r / 2 % 11 == 6;
            equation[r] = r % 5 == 2 ? -1 : mirrored ? equation[twin] : n++;
            sign[r] = mirrored ? -1.0 : 1.0;
        }
        for (int e = 0; e < n; e++) y[e] = s.w[(3 * e + 5) % DOF];
        for (int r = 0; r < DOF; r++)
            s.w[r] = equation[r] < 0 ? 0.0 : sign[r] * y[equation[r]];
        ck_assert(times(&s.body, s.u, s.w, Kw) == OK);
        for (int r = 0; r < DOF; r++)
            if (equation[r] >= 0) folded[equation[r]] += sign[r] * Kw[r];

        const int band = particle_band(&s.body, equation);
        ck_assert_int_lt(band, n);
        for (int full = 0; full < 2; full++) {
            struct matrix *K = matrix_alloc(BANDED, n, full ? n : band);
            ck_assert(particle_stiffness(&s.body, s.u, equation, sign, K) ==
                      OK);
            matrix_multiply(K, y, Ky);
            for (int e = 0; e < n; e++) close_to(Ky[e], folded[e], 1e-11);
            if (full) { /* the band is not wider than it must be */
                int widest = 0;
                for (int i = 0; i < n; i++)
                    for (int j = 0; j < i; j++)
                        if (fabs(matrix_get(K, i, j)) > 1e-14 && i - j > widest)
                            widest = i - j;
                ck_assert_int_eq(widest, band);
            }
            matrix_free(K);
        }
        /* no signs: all 1 */
        struct matrix *K = matrix_alloc(BANDED, n, band);
        struct matrix *L = matrix_alloc(BANDED, n, band);
        for (int r = 0; r < DOF; r++) sign[r] = 1.0;
        ck_assert(particle_stiffness(&s.body, s.u, equation, sign, K) == OK);
        ck_assert(particle_stiffness(&s.body, s.u, equation, NULL, L) == OK);
        for (int e = 0; e < n; e++)
            ck_assert_double_eq(matrix_get(K, e, e), matrix_get(L, e, e));
        matrix_free(K);
        matrix_free(L);
        scene_free(&s);
    }
}

/* A change of the tangent is used by the matrix, not by the force. */
static mat2 twice(const struct material *material, mat2 F, mat2 dF)
{
    return mat2_scale(2.0, material2_dpk1(material, F, dF));
}
static void a_tangent_of_ones_own_is_used(void)
{
    struct scene s = seven(2, CUBIC);
    double Kw[DOF], other[DOF], f[DOF], same[DOF];
    ck_assert(times(&s.body, s.u, s.w, Kw) == OK);
    ck_assert(particle_force(&s.body, s.u, f) == OK);
    s.body.dpk1 = twice;
    ck_assert(times(&s.body, s.u, s.w, other) == OK);
    ck_assert(particle_force(&s.body, s.u, same) == OK);
    for (int r = 0; r < DOF; r++) {
        close_to(other[r], 2.0 * Kw[r], 1e-12);
        ck_assert_double_eq(same[r], f[r]);
    }
    scene_free(&s);
}

static void failures_are_named(void)
{
    struct scene s = seven(2, LOG);
    double energy, f[DOF];
    struct taylor taylor;
    int equation[DOF];
    for (int r = 0; r < DOF; r++) equation[r] = r;
    struct matrix *K =
        matrix_alloc(BANDED, DOF, particle_band(&s.body, equation));
#define EXPECT(status)                                                         \
    do {                                                                       \
        ck_assert(particle_energy(&s.body, s.u, &energy) == (status));         \
        ck_assert(particle_force(&s.body, s.u, f) == (status));                \
        ck_assert(particle_cauchy_force(&s.body, s.u, f) == (status));         \
        ck_assert(particle_difference_force(&s.body, s.u, 1e-6, f) ==          \
                  (status));                                                   \
        ck_assert(particle_taylor(&s.body, s.u, s.w, 0.0, f, f, &taylor) ==    \
                  (status));                                                   \
        ck_assert(particle_stiffness(&s.body, s.u, equation, NULL, K) ==       \
                  (status));                                                   \
    } while (0)
    EXPECT(OK);
    for (int r = 0; r < DOF; r++) { /* a mirror image of the body */
        double x[2];
        grid_place(s.grid, r / 2, x);
        s.u[r] = r % 2 ? 0.0 : -2.0 * x[0];
    }
    EXPECT(INVERTED);
    s.body.material.law = CUBIC;
    EXPECT(OK);
    s.u[2 * 11 * 5 + 11] = INFINITY;
    EXPECT(NONFINITE);
    s.u[2 * 11 * 5 + 11] = NAN;
    EXPECT(NONFINITE);
    s.u[2 * 11 * 5 + 11] = 0.0;
    for (int r = 0; r < DOF; r++) { /* J = 1e120 is finite, r^2 is not */
        double x[2];
        grid_place(s.grid, r / 2, x);
        s.u[r] = 1e60 * x[r % 2];
    }
    ck_assert(particle_energy(&s.body, s.u, &energy) == NONFINITE);
    ck_assert(particle_force(&s.body, s.u, f) == NONFINITE);
    for (int r = 0; r < DOF; r++) s.u[r] = 0.0;
    s.particles->x[5] = -2.5 * H;
    EXPECT(OUTSIDE);
    ck_assert_int_eq(particle_band(&s.body, equation), INT_MAX);
#undef EXPECT
    matrix_free(K);
    scene_free(&s);
}

UNIT_MAIN("forces",
    LAW(forces_are_the_oracles),
    LAW(forces_balance),
    LAW(slopes_agree),
    LAW(three_forms_are_one_force),
    LAW(taylor_tells_right_from_wrong),
    LAW(a_stretched_bar_is_the_oracles),
    LAW(the_matrix_is_folded),
    LAW(a_tangent_of_ones_own_is_used),
    LAW(failures_are_named))
