/* steps.c - laws of particle_step.h and particle_bodies.h, and of lesson 20's
 * free_bar.h. */
#include "figures/20_mpm_implicit/whole_step.h"
#include "figures/20_mpm_implicit/free_bar.h"
#include "particles/particle_bodies.h"

#include "../oracle/particle_step.h"
#include "base/table.h"
#include "unit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Newton's method stops at 1e-10 h and is quadratic. */
static void steps_are_the_oracles(void)
{
    static const enum stepping which[] = {HANGING, HANGING, STRAINED, BLOCK,
                                          BLOCK};
    static const enum law law[] = {CUBIC, LOG, CUBIC, CUBIC, LOG};
    for (int k = 0; k < 2 * COUNT(oracle_step); k++) {
        const int row = k / 2, flip = k % 2;
        const struct material material = material_notes(law[row]);
        struct particle_step step = {.rate = row == 2 ? 100.0 : 30.0,
                                     .consistent = row == 2,
                                     .wall = row < 2 ? HELD : NO_WALL,
                                     .transfer = flip ? FLIP : PIC};
        struct cloud c = cloud_stepping(which[row], 2, step.g);
        const struct particle_report report =
            particles_step(c.grid, c.p, material, &step);
        ck_assert_int_eq(report.status, OK);
        ck_assert_int_le(report.iterations, 6);
        close_to(particles_elastic(c.p, &material), oracle_step[row].elastic,
                 1e-10);
        close_to(potential_sum(report.E), oracle_step[row].potential, 1e-10);
        close_to(grid_moments(c.grid, c.grid->v).kinetic,
                 oracle_step[row].grid_before, 1e-10);
        close_to(grid_moments(c.grid, c.grid->next).kinetic,
                 oracle_step[row].grid_after, 1e-10);
        for (int p = 0; p < 3; p++) {
            const int q = oracle_step[row].at[p].particle;
            for (int i = 0; i < 2; i++) {
                if (row > 2 || i == 0)
                    close_to(c.p->x[2 * q + i], oracle_step[row].at[p].x[i],
                             1e-10);
                close_to(c.p->v[2 * q + i],
                         flip ? oracle_step[row].at[p].flip[i]
                              : oracle_step[row].at[p].pic[i], 1e-9);
            }
            for (int i = 0; i < 4; i++)
                close_to(c.p->F[q].m[i / 2][i % 2], oracle_step[row].at[p].F[i],
                         1e-10);
        }
        cloud_free(c);
    }
}

static void hanging_bars_are_the_oracles(void)
{
    const struct material cubic = material_notes(CUBIC);
    const struct material logarithm = material_notes(LOG);
    double F;
    close_to(hanging_place(&cubic, 500.0, 1.0, &F), oracle_end_cubic, 1e-13);
    close_to(F, 1.0, 1e-14);
    close_to(hanging_place(&logarithm, 500.0, 1.0, &F), oracle_end_log, 1e-13);
    close_to(hanging_place(&cubic, 500.0, 0.0, &F), 0.0, 1e-13);
    close_to(material1_pk1(&cubic, F), 500.0, 1e-10);
    for (int k = 0; k < COUNT(oracle_hanging); k++) {
        const struct material *material =
            oracle_hanging[k].cubic ? &cubic : &logarithm;
        struct cloud c =
            cloud_hanging(oracle_hanging[k].order, oracle_hanging[k].cells,
                          oracle_hanging[k].ppc);
        struct particle_step step = {
            .wall = oracle_hanging[k].mirror ? MIRROR : HELD};
        for (int i = 1; i <= oracle_hanging[k].loads; i++) {
            step.g[0] = 500.0 * i / oracle_hanging[k].loads;
            ck_assert_int_eq(
                particles_step(c.grid, c.p, *material, &step).status, OK);
        }
        const struct hanging_error worst =
            hanging_error(c.p, material, 500.0);
        close_to(worst.place, oracle_hanging[k].error, 1e-8);
        close_to(worst.stress / 500.0, oracle_hanging[k].stress_error, 1e-7);
        for (int p = 0; p < c.p->n; p++)
            close_to(c.p->v[2 * p], 0.0, 1e-15);
        cloud_free(c);
    }
}

static void critical_steps_are_the_oracles(void)
{
    const struct material material = material_notes(CUBIC);
    const double c = sqrt(material_modulus(&material));
    for (int k = 0; k < COUNT(oracle_critical); k++) {
        struct cloud bar = free_bar_outlying(oracle_critical[k].order,
                                             oracle_critical[k].eps);
        const struct particle_body body = {bar.grid, bar.p, material, NULL};
        ck_assert_int_eq(grid_p2g(bar.grid, bar.p), OK);
        close_to(2.0 / free_bar_frequency(&body) * c / 0.125 /
                     oracle_critical[k].grid, 1.0, 1e-8);
        cloud_free(bar);
    }
}

/* A body on its grid, and fields on the nodes with mass. */
struct scene {
    struct cloud c;
    struct particle_body body;
    struct unknowns *map;
    double *u, *r, *w; /* [n_dof] */
};
static struct scene scene_of(struct cloud c, enum wall wall)
{
    struct scene s = {.c = c};
    s.body = (struct particle_body){c.grid, c.p, material_notes(CUBIC), NULL};
    for (int p = 0; p < c.p->n; p++) c.p->x[2 * p] -= 0.03;
    ck_assert_int_eq(grid_p2g(c.grid, c.p), OK);
    s.map = unknowns_alloc(c.grid);
    unknowns_number(c.grid, wall, s.map);
    s.u = allocate(3 * (size_t)s.map->n_dof, sizeof *s.u);
    s.r = s.u + s.map->n_dof;
    s.w = s.r + s.map->n_dof;
    double *y = allocate((size_t)s.map->n_dof, sizeof *y);
    for (int e = 0; e < s.map->n; e++) y[e] = 0.001 * ((7 * e + 3) % 13 - 5);
    unknowns_scatter(s.map, y, s.u);
    for (int e = 0; e < s.map->n; e++) y[e] = 0.1 * ((5 * e + 2) % 11 - 4);
    unknowns_scatter(s.map, y, s.w);
    free(y);
    return s;
}

/* Of a map that is not numbered yet each entry of u is written, and is 0. */
static void a_map_begins_with_no_unknowns(void)
{
    struct cloud c = cloud_block(2);
    struct unknowns *map = unknowns_alloc(c.grid);
    double *u = allocate((size_t)map->n_dof, sizeof *u);
    const double y[2] = {2.385, -0.716};
    ck_assert_int_eq(map->n, 0);
    for (int s = 0; s < map->n_dof; s++) u[s] = NAN;
    unknowns_scatter(map, y, u);
    for (int s = 0; s < map->n_dof; s++)
        ck_assert(map->equation[s] < 0 && u[s] == 0.0);
    free(u);
    unknowns_free(map);
    cloud_free(c);
}

static void scene_free(struct scene *s)
{
    unknowns_free(s->map);
    free(s->u);
    cloud_free(s->c);
}

static double dot(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int s = 0; s < n; s++) sum += a[s] * b[s];
    return sum;
}

static void the_residual_is_the_slope_of_the_potential(void)
{
    for (int k = 0; k < 6; k++) {
        struct scene s = scene_of(cloud_block(1 + k % 3), NO_WALL);
        const struct particle_step step = {
            .rate = 23.85, .g = {1.3, -9.81}, .consistent = k / 3};
        const int n = s.map->n_dof;
        struct potential E;
        double sum[2];
        for (int i = 0; i < 2; i++) {
            for (int q = 0; q < n; q++) s.u[q] += (i ? 2e-6 : -1e-6) * s.w[q];
            ck_assert_int_eq(
                particle_potential(&s.body, &step, s.u, &E, s.r), OK);
            sum[i] = potential_sum(E);
        }
        for (int q = 0; q < n; q++) s.u[q] -= 1e-6 * s.w[q];
        particle_potential(&s.body, &step, s.u, &E, s.r);
        close_to(dot(n, s.r, s.w), (sum[1] - sum[0]) / 2e-6, 1e-6);
        scene_free(&s);
    }
}

/* Up to 1e-12 of the parts counts as less, whatever the signs and the unit. */
static void round_off_is_allowed(void)
{
    for (double unit = 1e-9; unit < 1e10; unit *= 1e3) {
        const struct potential here = {2.0 * unit, 3.0 * unit, -5.0 * unit};
        for (int part = 0; part < 3; part++)
            for (int k = 0; k < 2; k++) {
                struct potential there = here;
                double *of[] = {&there.inertia, &there.elastic, &there.load};
                *of[part] += (k ? 1.1e-11 : 0.9e-11) * unit;
                ck_assert_int_eq(potential_falls(here, there), !k);
                *of[part] -= 1e-6 * unit;
                ck_assert(potential_falls(here, there));
            }
    }
}

/* T is what gather() and scatter() agree on, and T^T M T what both masses do;
 * at a mirror, where nodes share unknowns. */
static void unknowns_and_masses_agree(void)
{
    for (int k = 0; k < 18; k++) {
        const int order = 1 + k % 3, consistent = k / 3 % 2;
        const enum wall wall = (enum wall)(k / 6);
        struct cloud c = cloud_block(order);
        for (int p = 0; p < c.p->n; p++) c.p->x[2 * p] -= 0.1;
        struct scene s = scene_of(c, wall);
        const int n = s.map->n;
        double *y = allocate(3 * (size_t)n + 1, sizeof *y), *Ay = y + n;
        struct matrix *A = unknowns_matrix(&s.body, s.map);
        for (int e = 0; e < n; e++) y[e] = 0.1 * ((3 * e + 1) % 7 - 2);
        unknowns_scatter(s.map, y, s.u);
        for (int e = 0; e <= n; e++) Ay[e] = 2.385; /* which goes */
        unknowns_gather(s.map, s.w, Ay);
        ck_assert(Ay[n] == 2.385);
        close_to(dot(n, y, Ay), dot(s.map->n_dof, s.u, s.w), 1e-13);
        particle_mass_matrix(&s.body, consistent, 2.385, s.map, A);
        matrix_multiply(A, y, Ay);
        particle_mass(&s.body, consistent, s.u, s.r);
        close_to(dot(s.map->n_dof, s.u, s.r) * 2.385, dot(n, y, Ay), 1e-13);
        ck_assert_double_ge(matrix_max_diagonal(A),
                            matrix_get(A, n - 1, n - 1));
        ck_assert_double_gt(matrix_max_diagonal(A), matrix_get(A, 0, 0));
        y[n / 2] = -7.5;
        close_to(unknowns_largest(s.map, y), 7.5, 1e-15);
        y[n / 2] = NAN;
        ck_assert(isnan(unknowns_largest(s.map, y)));
        for (int r = 0; r < s.map->n_dof; r++) {
            double x[2];
            grid_place(s.c.grid, r / 2, x);
            const double u = s.u[r];
            if (wall == HELD && x[0] < 1e-12) close_to(u, 0.0, 1e-15);
            if (wall == MIRROR && fabs(x[0]) < 1e-12) close_to(u, 0.0, 1e-15);
            if (wall == MIRROR && fabs(x[0] - 0.25) < 1e-12)
                close_to(s.u[r - 4], -u, 1e-15);
            if (wall == NO_WALL)
                ck_assert((s.map->equation[r] >= 0) ==
                          (s.c.grid->mass[r / 2] > 0.0));
        }
        matrix_free(A);
        free(y);
        scene_free(&s);
    }
}

/* v after an implicit and an explicit step differ by dt^2, at all walls. */
static void small_steps_are_explicit(void)
{
    for (int k = 0; k < 9; k++) {
        double off[2];
        for (int i = 0; i < 2; i++) {
            struct cloud a = cloud_block(1 + k % 3), b = cloud_block(1 + k % 3);
            const struct particle_step step = {.rate = i ? 1e5 : 5e4,
                                               .g = {1.3, -9.81},
                                               .wall = (enum wall)(k / 3),
                                               .transfer = FLIP};
            const struct material material = material_notes(CUBIC);
            for (int p = 0; p < a.p->n; p++)
                b.p->x[2 * p] = a.p->x[2 * p] -= 0.17;
            ck_assert_int_eq(
                particles_step(a.grid, a.p, material, &step).status, OK);
            ck_assert_int_eq(
                particles_step_explicit(b.grid, b.p, material, &step), OK);
            off[i] = 0.0;
            for (int p = 0; p < 2 * a.p->n; p++)
                off[i] = fmax(off[i], fabs(a.p->v[p] - b.p->v[p]));
            cloud_free(a);
            cloud_free(b);
        }
        ck_assert_double_lt(off[0], 1e-3);
        close_to(log2(off[0] / off[1]), 2.0, 0.1);
    }
}

static void bodies_are_what_they_say(void)
{
    const double pi = acos(-1.0), h = 0.125, e = 1e-6;
    struct cloud ring = free_bar_ringing(2, 8, 3.85, APIC);
    struct cloud flip = free_bar_ringing(2, 8, 3.85, FLIP);
    const double X = ring.p->x[6] - 0.5003;
    close_to(ring.p->x[0], 0.5003 + h / 4.0, 1e-14);
    close_to(ring.grid->origin[0], -2.0 * h, 1e-15);
    close_to(ring.grid->origin[1], -0.5, 1e-15); /* the line through y = 0 */
    close_to(ring.p->v[6], 3.85 * cos(pi * X), 1e-13);
    close_to(ring.p->B[3].m[0][0],
             3.85 * (cos(pi * (X + e)) - cos(pi * (X - e))) / (2.0 * e) *
                 h * h / 4.0, 1e-8);
    close_to(flip.p->B[3].m[0][0], 0.0, 1e-15);
    close_to(flip.p->v[6], ring.p->v[6], 1e-15);
    cloud_free(ring);
    cloud_free(flip);
    for (double eps = 0.9; eps > 1e-14; eps *= 0.0613) /* to the last digit */
        for (int order = 1; order <= 3; order++) {
            const double last = (order == 2 ? 9.5 : 9.0) + eps;
            struct cloud out = free_bar_outlying(order, eps);
            for (int q = 0; q < 16; q++)
                close_to(out.p->x[2 * q] / h, last - 0.5 * (15 - q), 0x1p-60);
            cloud_free(out);
        }
}

static void failures_are_named(void)
{
    const struct material material = material_notes(CUBIC);
    struct particle_step step = {.g = {500.0, 0.0}, .wall = MIRROR};
    struct cloud c = cloud_hanging(3, 8, 1);
    ck_assert_int_eq(particles_step(c.grid, c.p, material, &step).status,
                     NOT_SPD);
    close_to(c.p->x[0], 0.0625, 1e-15); /* nothing has moved */
    step.wall = NO_WALL;
    step.rate = 10.0;
    enum status status = OK;
    for (int k = 0; k < 5 && status == OK; k++)
        status = particles_step(c.grid, c.p, material, &step).status;
    ck_assert_int_eq(status, OUTSIDE);
    cloud_free(c);
    ck_assert_str_eq(wall_name(HELD), "held");
    ck_assert_str_eq(wall_name(MIRROR), "mirror");
    const struct potential E = {1.0, 2.0, -2.5};
    const struct potential more = {1.0, 2.0, -2.5 + 1e-9};
    close_to(potential_sum(E), 0.5, 1e-15);
    ck_assert(potential_falls(more, E) && potential_falls(E, E));
    ck_assert(!potential_falls(E, more));
    const struct potential none = {0.0, 0.0, 0.0};
    ck_assert(potential_falls(none, none)); /* a body at rest stays there */
}

/* Particles of a log bar that run into each other: full steps would invert. */
static void halving_keeps_particles_from_inverting(void)
{
    struct cloud c = cloud_hanging(2, 8, 2);
    const struct particle_step step = {.rate = 30.0};
    for (int p = 0; p < c.p->n; p++) {
        c.p->x[2 * p] += 0.3;
        c.p->v[2 * p] = p < c.p->n / 2 ? 240.0 : -240.0;
    }
    const struct particle_report report =
        particles_step(c.grid, c.p, material_notes(LOG), &step);
    ck_assert_int_eq(report.status, OK);
    double least = 1.0;
    for (int k = 0; k < report.iterations; k++)
        least = fmin(least, report.part[k]);
    ck_assert_double_le(least, 0.5);
    cloud_free(c);
}

/* A block pressed to half its area: A is indefinite at u = 0, where a direction
 * of the projected one makes E fall, and r = 0 is found. */
static void projection_goes_on_where_A_is_indefinite(void)
{
    for (int k = 0; k < 4; k++) {
        const struct particle_step step = {.rate = 10.0 / 3.0};
        struct cloud c = cloud_block(1 + k % 2);
        for (int p = 0; p < c.p->n; p++)
            c.p->F[p] = mat2_scale(0.7, c.p->F[p]);
        const struct particle_body body = {
            c.grid, c.p, material_notes(k / 2 ? CUBIC : LOG), NULL};
        ck_assert_int_eq(grid_p2g(c.grid, c.p), OK);
        struct unknowns *map = unknowns_alloc(c.grid);
        unknowns_number(c.grid, NO_WALL, map);
        struct matrix *A = unknowns_matrix(&body, map);
        double *u = allocate(2 * (size_t)map->n_dof, sizeof *u);
        double *r = u + map->n_dof;
        particle_stiffness(&body, u, map->equation, map->sign, A);
        particle_mass_matrix(&body, 0, step.rate * step.rate, map, A);
        ck_assert_int_eq(matrix_factor(A), NOT_SPD);
        const struct particle_report report =
            particle_newton(&body, &step, 1e-10, u);
        struct potential E;
        ck_assert_int_eq(report.status, OK);
        ck_assert_int_ge(report.projections, 1);
        ck_assert_int_lt(report.projections, report.iterations);
        ck_assert_double_gt(report.part[0], 0.0);
        particle_potential(&body, &step, u, &E, r);
        for (int s = 0; s < map->n_dof; s++) close_to(r[s], 0.0, 1e-9);
        matrix_free(A);
        unknowns_free(map);
        free(u);
        cloud_free(c);
    }
    const struct material linear = material_notes(LINEAR);
    const mat2 F = {{{1.2, 0.3}, {-0.1, 0.7}}}, dF = {{{0.1, 0.2}, {0.5, 0.3}}};
    close_to(particle_projected(&linear, F, dF).m[1][0],
             material2_dpk1(&linear, F, dF).m[1][0], 1e-15);
}

static void print_block(void)
{
    struct cloud c = cloud_block(2);
    const struct material material = material_notes(CUBIC);
    const struct particle_step step = {.rate = 30.0};
    const struct particle_report report =
        particles_step(c.grid, c.p, material, &step);
    table_begin("energies", CLOUD_ENERGIES);
    cloud_energies(c, &material, 0.5, &report);
    table_end();
    cloud_tables(c, &report);
    cloud_free(c);
    exit(table_finish());
}
static void tables_have_their_names(void)
{
    const struct outcome got = outcome_of(print_block);
    ck_assert_int_eq(got.status, 0);
    ck_assert_ptr_nonnull(
        strstr(got.out, "# energies\nt\titerations\telastic"));
    ck_assert_ptr_nonnull(strstr(got.out, "\n0.5\t5\t0.04670914572"));
    ck_assert_ptr_nonnull(strstr(got.out, "# newton\nk\tresidual"));
    ck_assert_ptr_nonnull(strstr(got.out, "# step\nnode\tx\ty\tmass"));
    ck_assert_ptr_nonnull(strstr(got.out, "# particles\nx\ty\tv_x"));
}

UNIT_MAIN("steps",
    LAW(a_map_begins_with_no_unknowns),
    LAW(steps_are_the_oracles),
    LAW(hanging_bars_are_the_oracles),
    LAW(critical_steps_are_the_oracles),
    LAW(the_residual_is_the_slope_of_the_potential),
    LAW(round_off_is_allowed),
    LAW(unknowns_and_masses_agree),
    LAW(small_steps_are_explicit),
    LAW(bodies_are_what_they_say),
    LAW(failures_are_named),
    LAW(halving_keeps_particles_from_inverting),
    LAW(projection_goes_on_where_A_is_indefinite),
    LAW(tables_have_their_names))
