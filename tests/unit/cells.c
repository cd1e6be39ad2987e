/* cells.c - laws of lessons/choose/cells.h and price.h, and of the loads and
 * the price of other triangles. */
#include "lessons/choose/cells.h"

#include "base/clock.h"
#include "lessons/choose/price.h"
#include "choice/relax.h"
#include "choice/rung.h"

#include "unit.h"

#include <math.h>
#include <stdio.h>

enum { HANGING = 0, FAST = 7 };

static struct ladder_state *solved(enum rung rung, int moving, int level)
{
    struct ladder_state *s = ladder_solve(
        &ladder_scene[FAST], (struct ladder_model){rung, moving, level});
    ck_assert_int_eq(s->status, OK);
    return s;
}

/* Systems times columns, and once; a price that is 16 times as much for twice
 * the columns grows with their fourth power, within the levels and beyond. */
static void prices_go_with_columns(void)
{
    struct ladder_state *s = solved(LINEAR_PLANE, 1, 1);
    const double frames = price_frames(s), unit = 1e-6 / s->systems * frames;
    const struct price price[] = {{0.0, unit}, {0.0, 8.0 * unit},
                                  {0.0, 64.0 * unit}};
    close_to(frames, 36.0, 1e-12);
    ck_assert_int_eq(s->systems, 36);
    close_to(price_seconds(s, (struct price){2.0, 0.5}), 32.0 * 20.0, 1e-9);
    for (int n = 12; n < 300; n *= 2) /* 16 columns at level 0: 16e-6 s */
        ck_assert_int_eq(price_columns(s, price, 3, 16e-6 *
                                       pow((n + 0.5) / 16.0, 4)),
                         n < 16 ? (int)(16.0 * pow((n + 0.5) / 16.0, 4)) : n);
    ladder_free(s);
}

/* A processor's clock that goes on by one tick each time that it is asked, or
 * by three, in place of the library's, and a wall's that nobody may ask: no
 * load of the machine changes what is measured. */
static const double tick = 1.0 / 1024.0;
static double told = 1024.0, three_from = INFINITY;
double clock_processor(void)
{
    return told += told < three_from ? tick : 3.0 * tick;
}
double clock_seconds(void) { return 1e6 * clock_processor(); }
void clock_machine(size_t size, char text[]) { snprintf(text, size, "counts"); }

/* By this clock every solve takes as long: the price is that of a column and a
 * system, and so many are solved that they take a tenth of a second.  A motion
 * by the linear law in 50 steps, which is measured after that in 10, takes
 * three times as long: two ticks for 40 steps. */
static void a_tenth_of_a_second_is_measured(void)
{
    const struct ladder_model bar = {BAR, 0, 0}, plane = {CUBIC_PLANE, 0, 2},
                              moving = {LINEAR_PLANE, 1, 2};
    double start = clock_processor();
    const struct price one = price_calibrate(LINEAR_TRIANGLE, 1.0, bar);
    ck_assert(told - start >= 0.1 && told - start < 0.11);
    ck_assert_double_eq(one.begin, 0.0);
    close_to(tick / one.system, 16.0, 1e-9); /* columns; one system */
    start = clock_processor();
    const struct price cubic = price_calibrate(LINEAR_TRIANGLE, 1.0, plane);
    const double systems = tick / (64.0 * cubic.system);
    ck_assert(told - start >= 0.1 && told - start < 0.11);
    close_to(systems, floor(systems + 0.5), 1e-9);
    ck_assert(systems > 1.5);
    close_to(price_calibrate(QUADRATIC_TRIANGLE, 2.0, plane).system,
             cubic.system, 1e-9); /* they need as many systems */
    three_from = told + 0.09;
    const struct price step = price_calibrate(LINEAR_TRIANGLE, 1.0, moving);
    close_to(step.system * 64.0 / tick, 2.0 / 40.0, 1e-9);
    close_to(step.begin * 64.0 / tick, 1.0 - 10.0 * 2.0 / 40.0, 1e-9);
}

/* Loads of quadratic and graded triangles are those of the linear ones; they
 * bend as a body does whose mesh is twice as fine, or more. */
static void other_triangles_have_the_same_load(void)
{
    struct ladder_scene scene = {.slender = 2, .nu = 0.3, .couple = 7.0,
        .pull = {0.4, -0.2}, .push = {0.3, -0.1}, .weight = {0.5, -0.6}};
    struct ladder_state *one = ladder_alloc(
        &scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
    for (int k = 0; k < 3; k++) {
        struct ladder_state *s = ladder_alloc_of(
            k ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE, k < 2 ? 2.0 : 1.0,
            &scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
        double sum[2][3] = {{0.0}}; /* along, across, and turning */
        for (int w = 0; w < 2; w++) {
            const struct ladder_state *of = w ? one : s;
            for (int r = 0; r < 2 * of->mesh->n_vertex; r += 2) {
                const double *X = &of->mesh->X[r], *f = &of->f[r];
                sum[w][0] += f[0] + 3.0 * of->hand[r];
                sum[w][1] += f[1] + 3.0 * of->hand[r + 1];
                sum[w][2] += X[0] * f[1] - X[1] * f[0];
            }
        }
        for (int i = 0; i < 3; i++) close_to(sum[0][i], sum[1][i], 1e-12);
        ck_assert_int_eq(s->body->element == QUADRATIC_TRIANGLE, k > 0);
        ck_assert_int_eq(s->mesh->graded, k < 2);
        ladder_free(s);
    }
    ladder_free(one);
}

/* Cells are about square, and quadratic ones, which are two by two, fit, for
 * every ratio of the sides, at rest and in motion. */
static void cells_fit_every_ratio(void)
{
    for (int k = 0; k <= 310; k++) {
        const struct ladder_scene scene = {.slender = 0.5 + 0.05 * k,
            .nu = 0.3, .weight = {0.0, -1e-3}, .time = RISES, .T = 1.0,
            .dt = 0.1, .end = 0.1};
        for (int i = 0; i < 4; i++) {
            struct ladder_state *s = ladder_alloc_of(
                i < 2 ? LINEAR_TRIANGLE : QUADRATIC_TRIANGLE, 2.0, &scene,
                (struct ladder_model){CUBIC_PLANE, i % 2, 0});
            const double ratio = 4.0 * scene.slender / s->mesh->n;
            ck_assert(s->mesh->n % 2 == 0 && s->mesh->rows == 4);
            ck_assert(ratio > 0.65 && ratio < 1.5);
            ck_assert_int_eq(rung_solve(s), OK);
            ladder_free(s);
        }
    }
}

/* What they say of each mesh's error is what a finer one says. */
static void cells_say_what_a_finer_mesh_says(void)
{
    const struct ladder_scene scene = {.slender = 2, .nu = 0.4,
        .weight = {0.0, -2.0}};
    struct cells cells[CELLS];
    ck_assert(cells_compare(&scene, CUBIC_PLANE, cells));
    struct ladder_state *fine = ladder_alloc_of(
        QUADRATIC_TRIANGLE, 1.0, &scene,
        (struct ladder_model){CUBIC_PLANE, 0, CELLS_LEVELS});
    fine->status = rung_solve(fine);
    for (int k = 0; k < CELLS; k++) {
        const struct cells *c = &cells[k];
        struct ladder_state *s = ladder_alloc_of(
            c->element, c->grade, &scene,
            (struct ladder_model){CUBIC_PLANE, 0, c->level});
        s->status = rung_solve(s);
        const double error = ladder_error(s, fine);
        ck_assert(c->solved && c->flops == s->flops);
        ck_assert_msg(c->error > error && c->error < 1.3 * error + 1e-2,
                      "kind %d: %g, the error %g", k, c->error, error);
        ladder_free(s);
    }
    ladder_free(fine);
    for (int k = 0; k < 3; k++) {
        const double room = 0.1 / pow(3.0, k);
        const struct cells *best = cells_cheapest(cells, room);
        ck_assert(best && best->error <= room);
        for (int i = 0; i < CELLS; i++)
            ck_assert(cells[i].error > room || cells[i].flops >= best->flops);
    }
    ck_assert(!cells_cheapest(cells, 1e-6));
    const struct ladder_scene column = {.slender = 4, .nu = 0.3,
        .pull = {-20.0, 0.0}};
    ck_assert(!cells_compare(&column, LINEAR_PLANE, cells)); /* it buckles */
    ck_assert(!cells_cheapest(cells, 10.0));
    /* on the finest mesh alone, which is the least stiff */
    const struct ladder_scene hardly = {.slender = 4, .nu = 0.3,
        .pull = {-14.015, 0.0}};
    const int best = CELLS - 1;
    ck_assert(!cells_compare(&hardly, LINEAR_PLANE, cells));
    ck_assert(cells[best - 1].solved && !cells[best].solved);
    ck_assert(cells[0].solved && cells[0].error == INFINITY);
    ck_assert_str_eq(cells_name(LINEAR_TRIANGLE), "linear");
    ck_assert_str_eq(cells_name(QUADRATIC_TRIANGLE), "quadratic");
}

/* Quadratic triangles: each factorisation has a tangent of 1300 flops beside a
 * look of 400, and each system a look. */
static void a_quadratic_triangle_is_counted(void)
{
    struct ladder_state *s = ladder_alloc_of(
        QUADRATIC_TRIANGLE, 1.0, &ladder_scene[HANGING],
        (struct ladder_model){CUBIC_PLANE, 0, 0});
    ck_assert_int_eq(rung_solve(s), OK);
    const struct matrix_cost cost =
        matrix_cost(BANDED, s->body->n_equation, s->body->K->p);
    const double triangles = s->mesh->n_triangle / 4.0;
    const double factorisations =
        (s->flops - s->systems * (cost.solve + 400.0 * triangles)) /
        (cost.flops + 1700.0 * triangles);
    close_to(factorisations, floor(factorisations + 0.5), 1e-9);
    ck_assert(factorisations > 0.5 && factorisations < s->systems + 0.5);
    ladder_free(s);
}

UNIT_MAIN("cells",
    LAW(prices_go_with_columns),
    LAW(a_tenth_of_a_second_is_measured),
    LAW(other_triangles_have_the_same_load),
    LAW(cells_fit_every_ratio),
    LAW(cells_say_what_a_finer_mesh_says),
    LAW(a_quadratic_triangle_is_counted))
