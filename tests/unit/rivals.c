/* rivals.c - laws of figures/work_precision/particle_work.h: what particles
 * cost and have wrong beside finite elements. */
#include "figures/work_precision/particle_work.h"
#include "figures/study/study.h"

#include "unit.h"

#include <math.h>

static const struct work end = {.n_shared = 2, .u = {0.24096766839}};

static struct work particles(enum particle_body_name body, int order, int ppc,
                             int cells, int steps, int implicit)
{
    const struct particle_setting set = {body,  order,    ppc, cells,
                                         steps, implicit, APIC};
    return particle_work(&set);
}

/* 100 and 250 flops to 3 %; with the tangent quadratic in s d. */
static void looks_are_those_of_a_triangle(void)
{
    close_to(work_look(3, 2, 0), 100.0, 3.0);
    close_to(work_look(3, 2, 1), 250.0, 7.5);
    close_to(work_look(6, 1, 1), work_look(3, 2, 1), 1e-10);
    close_to(work_look(18, 1, 1) - 3.0 * work_look(6, 1, 1),
             6.0 * (work_look(6, 1, 1) - work_look(6, 1, 0)), 1e-10);
}

/* Of order 2, and the kernels by the constants of the study. */
static void bars_end_where_they_should(void)
{
    for (int order = 0; order <= 3; order++) {
        double e[2];
        for (int k = 0; k < 2; k++) {
            const struct work w =
                order ? particles(HUNG, order, 2, 32 << k, 1, 1)
                      : element_bar_work(32 << k);
            ck_assert_int_eq(w.status, OK);
            ck_assert_int_eq(w.n_shared, 2);
            ck_assert(w.min_J > 0.99 && w.min_J < 1.02);
            e[k] = work_distance(&w, &end);
        }
        ck_assert(e[1] < 2e-5);
        close_to(study_order(e[0], e[1], 2.0), 2.0, 0.05);
    }
}

/* The first load: nodes 1 to n move, with a band of half width `order`; wider
 * kernels reach one node more. */
static void work_of_particles_is_counted(void)
{
    const int n = 16;
    for (int order = 1; order <= 3; order++) {
        const struct work w = particles(HUNG, order, 2, n, 1, 1);
        const struct matrix_cost cost =
            matrix_cost(BANDED, n + (order > 1), order);
        const double look = 2 * n * work_look(order + 1, 1, 0);
        ck_assert_int_eq(w.factorisations, w.systems);
        close_to(w.flops, 3.0 * look + w.systems * (cost.flops + cost.solve +
                 2 * n * work_look(order + 1, 1, 1)), 1e-6);
    }
    const struct work leaps = particles(LET_GO, 2, 2, 4, 16, 0);
    ck_assert(leaps.systems == 0 && leaps.steps == 16);
    close_to(leaps.flops, 16 * 3 * 64 * work_look(9, 2, 0), 1e-6);
    ck_assert(leaps.seconds > 0.0);
}

static void work_of_elements_is_counted(void)
{
    const int n = 16;
    const struct work w = element_bar_work(n);
    const struct matrix_cost cost = matrix_cost(BANDED, n, 1);
    ck_assert(w.systems == w.factorisations && w.systems > 3);
    close_to(w.flops, n * work_look(2, 1, 0) + w.systems * (cost.flops +
             cost.solve + n * work_look(2, 1, 1)), 1e-6);
}

/* Every vertex, each component: what elements say of the same block. */
static void blocks_fall_as_elements_do(void)
{
    const struct work_setting set = {WEIGHT, LOG, 1, 16, 128,
                                     SYMPLECTIC_EULER, 1e-9, LINEAR_TRIANGLE,
                                     1.0};
    const struct work elements = work_run(&set);
    for (int order = 1; order <= 3; order++) {
        const struct work w = particles(LET_GO, order, 2, 8, 64, 0);
        ck_assert_int_eq(w.status, OK);
        ck_assert_int_eq(w.n_shared, elements.n_shared);
        for (int i = 0; i < w.n_shared; i++)
            close_to(w.u[i], elements.u[i], 0.035);
        ck_assert(work_distance(&w, &elements) < 0.01);
    }
    const struct work still = particles(LET_GO, 2, 2, 8, 8, 1);
    ck_assert(work_distance(&still, &elements) < 0.02);
}

/* A new grid for each load: another answer, and as many steps. */
static void loads_are_put_on_in_steps(void)
{
    const struct work w = particles(HUNG, 3, 4, 16, 10, 1);
    ck_assert(w.status == OK && w.steps == 10 && w.systems >= 30);
    ck_assert(work_distance(&w, &end) < 1e-4);
}

static void runs_that_fail_have_a_reason(void)
{
    const struct work loads = particles(HUNG, 1, 2, 32, 10, 1);
    ck_assert_int_eq(loads.status, NOT_SPD);
    ck_assert_int_lt(loads.steps, 10);
    const struct work leaps = particles(LET_GO, 2, 2, 8, 12, 0);
    ck_assert_int_eq(leaps.status, INVERTED);
    ck_assert_int_lt(leaps.steps, 12);
    ck_assert(work_distance(&leaps, NULL) == INFINITY);
}

UNIT_MAIN("rivals",
    LAW(looks_are_those_of_a_triangle),
    LAW(bars_end_where_they_should),
    LAW(work_of_particles_is_counted),
    LAW(work_of_elements_is_counted),
    LAW(blocks_fall_as_elements_do),
    LAW(loads_are_put_on_in_steps),
    LAW(runs_that_fail_have_a_reason))
