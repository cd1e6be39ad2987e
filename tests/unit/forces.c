/* forces.c - laws of common/particle_force.h: forces are slopes of the
 * energy, products slopes of the forces, and the numbers are the oracle's. */
#include "particle_force.h"
#include "particle_scene.h"

#include "../oracle/particle_force.h"
#include "unit.h"

#include <limits.h>
#include <math.h>
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
        double energy, f[DOF], Kw[DOF], torque = 0.0;
        ck_assert(particle_energy(&s.body, s.u, &energy) == OK);
        ck_assert(particle_force(&s.body, s.u, f) == OK);
        close_to(energy, oracle_force[k].energy, 1e-12);
        close_to(dot(f, s.u), oracle_force[k].work, 1e-12);
        for (int a = 0; a < NODES; a++) {
            double x[2];
            grid_place(s.grid, a, x);
            torque += x[0] * f[2 * a + 1] - x[1] * f[2 * a];
        }
        close_to(torque, oracle_force[k].torque, 1e-11);
        ck_assert(particle_product(&s.body, s.u, s.u, Kw) == OK);
        close_to(dot(Kw, s.u), oracle_force[k].bend, 1e-12);
        memset(s.w, 0, sizeof s.w);
        s.w[2 * node_at(oracle_force[k].column)] = 1.0;
        ck_assert(particle_product(&s.body, s.u, s.w, Kw) == OK);
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
            double f[DOF], sum[3] = {0.0, 0.0, 0.0};
            ck_assert(particle_force(&s.body, s.u, f) == OK);
            for (int a = 0; a < NODES; a++) {
                double x[2];
                grid_place(s.grid, a, x);
                for (int i = 0; i < 2; i++) {
                    sum[i] += f[2 * a + i];
                    x[i] += s.u[2 * a + i];
                }
                sum[2] += x[0] * f[2 * a + 1] - x[1] * f[2 * a];
            }
            for (int i = 0; i < (law == LINEAR ? 2 : 3); i++)
                close_to(sum[i], 0.0, 1e-12);
            scene_free(&s);
        }
}

/* Energy, force and product by central differences. */
static void slopes_agree(void)
{
    for (int order = 1; order <= ORDER_MAX; order++)
        for (enum law law = LINEAR; law <= CUBIC; law++) {
            struct scene s = seven(order, law);
            const double step = 1e-5;
            double f[DOF], Kw[DOF], v[2][DOF], at[DOF], energy[2];
            ck_assert(particle_force(&s.body, s.u, f) == OK);
            ck_assert(particle_product(&s.body, s.u, s.w, Kw) == OK);
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

/* With all unknowns, and with a mirror that makes two nodes one: K w again. */
static void the_matrix_is_the_product(void)
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
        ck_assert(particle_product(&s.body, s.u, s.w, Kw) == OK);
        for (int r = 0; r < DOF; r++)
            if (equation[r] >= 0) folded[equation[r]] += sign[r] * Kw[r];

        const int band = particle_band(&s.body, equation);
        ck_assert_int_lt(band, n);
        for (int dense = 0; dense < 2; dense++) {
            struct matrix *K = matrix_alloc(dense ? DENSE : BANDED, n, band);
            ck_assert(particle_stiffness(&s.body, s.u, equation, sign, K) ==
                      OK);
            matrix_multiply(K, y, Ky);
            for (int e = 0; e < n; e++) close_to(Ky[e], folded[e], 1e-11);
            if (dense) { /* the band is not wider than it must be */
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

/* A change of the tangent is used by product and matrix, not by the force. */
static mat2 twice(const struct material *material, mat2 F, mat2 dF)
{
    return mat2_scale(2.0, material2_dpk1(material, F, dF));
}
static void a_tangent_of_ones_own_is_used(void)
{
    struct scene s = seven(2, CUBIC);
    double Kw[DOF], other[DOF], f[DOF], same[DOF];
    int equation[DOF];
    ck_assert(particle_product(&s.body, s.u, s.w, Kw) == OK);
    ck_assert(particle_force(&s.body, s.u, f) == OK);
    s.body.dpk1 = twice;
    ck_assert(particle_product(&s.body, s.u, s.w, other) == OK);
    ck_assert(particle_force(&s.body, s.u, same) == OK);
    for (int r = 0; r < DOF; r++) {
        close_to(other[r], 2.0 * Kw[r], 1e-12);
        ck_assert_double_eq(same[r], f[r]);
        equation[r] = r;
    }
    struct matrix *K =
        matrix_alloc(BANDED, DOF, particle_band(&s.body, equation));
    ck_assert(particle_stiffness(&s.body, s.u, equation, NULL, K) == OK);
    matrix_multiply(K, s.w, Kw);
    for (int r = 0; r < DOF; r++) close_to(Kw[r], other[r], 1e-11);
    matrix_free(K);
    scene_free(&s);
}

/* Particles at the middles of linear cells are linear elements with one Gauss
 * point: f = P(F) across the cell, and K its slope over h. */
static void a_bar_has_the_elements_forces(void)
{
    const double low[2] = {0.0, -0.5}, high[2] = {8 * H, 0.5};
    const int nodes[2] = {9, 1}, count[2] = {8, 1};
    for (enum law law = LINEAR; law <= CUBIC; law++) {
        const struct material m = material_notes(law);
        struct grid *grid = grid_alloc(1, low, H, nodes);
        struct particles *p = particles_box(low, high, count, 1.0);
        const struct particle_body body = {
            .grid = grid, .particles = p, .material = m};
        double u[18], w[18], f[18], Kw[18];
        grid_shake(grid, 0.8 * H, u);
        for (int r = 0; r < 18; r++) u[r] = r % 2 ? 0.0 : u[r];
        for (int r = 0; r < 18; r++) w[r] = r % 2 ? 0.0 : u[(5 * r + 4) % 18];
        ck_assert(particle_force(&body, u, f) == OK);
        ck_assert(particle_product(&body, u, w, Kw) == OK);
        double before = 0.0, change = 0.0;
        for (int a = 0; a <= 8; a++) {
            double after = 0.0, turn = 0.0;
            if (a < 8) {
                const double F = 1.0 + (u[2 * a + 2] - u[2 * a]) / H;
                after = material1_pk1(&m, F);
                turn = material1_dpk1(&m, F) * (w[2 * a + 2] - w[2 * a]) / H;
            }
            close_to(f[2 * a], after - before, 1e-11);
            close_to(Kw[2 * a], change - turn, 1e-10);
            close_to(f[2 * a + 1], 0.0, 1e-300);
            close_to(Kw[2 * a + 1], 0.0, 1e-300);
            before = after;
            change = turn;
        }
        grid_free(grid);
        particles_free(p);
    }
}

static void failures_are_named(void)
{
    struct scene s = seven(2, LOG);
    double energy, f[DOF];
    int equation[DOF];
    for (int r = 0; r < DOF; r++) equation[r] = r;
    struct matrix *K =
        matrix_alloc(BANDED, DOF, particle_band(&s.body, equation));
#define EXPECT(status)                                                         \
    do {                                                                       \
        ck_assert(particle_energy(&s.body, s.u, &energy) == (status));         \
        ck_assert(particle_force(&s.body, s.u, f) == (status));                \
        ck_assert(particle_product(&s.body, s.u, s.w, f) == (status));         \
        ck_assert(particle_stiffness(&s.body, s.u, equation, NULL, K) ==       \
                  (status));                                                   \
    } while (0)
    EXPECT(OK);
    s.w[7 * 11] = NAN;
    ck_assert(particle_product(&s.body, s.u, s.w, f) == NONFINITE);
    s.w[7 * 11] = 0.0;
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
    s.particles->x[5] = -2.5 * H;
    EXPECT(OUTSIDE);
    ck_assert_int_eq(particle_band(&s.body, equation), INT_MAX);
#undef EXPECT
    matrix_free(K);
    scene_free(&s);
}

static const struct unit_law laws[] = {
    {"forces_are_the_oracles", forces_are_the_oracles},
    {"forces_balance", forces_balance},
    {"slopes_agree", slopes_agree},
    {"the_matrix_is_the_product", the_matrix_is_the_product},
    {"a_tangent_of_ones_own_is_used", a_tangent_of_ones_own_is_used},
    {"a_bar_has_the_elements_forces", a_bar_has_the_elements_forces},
    {"failures_are_named", failures_are_named},
};

UNIT_MAIN("forces", laws)
