/* cells.c - laws of common/choice/cells.h and price.h, and of the loads and the
 * price of other triangles. */
#include "choice/cells.h"

#include "base/clock.h"
#include "choice/price.h"
#include "choice/rung.h"

#include "unit.h"

#include <math.h>

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
    s = solved(BAR, 0, 0);
    ck_assert_int_eq(s->systems, 1);
    struct price bar, plane;
    int tries = 0;
    do { /* some hundred times as much, unless another process disturbs it */
        const double start = clock_seconds();
        bar = price_calibrate(s->model);
        ck_assert_double_ge(clock_seconds() - start, 0.1); /* of many solves */
        plane = price_calibrate((struct ladder_model){CUBIC_PLANE, 0, 2});
        ck_assert(bar.begin == 0.0 && bar.system > 0.0);
    } while (plane.system < 5.0 * bar.system && ++tries < 20);
    ck_assert_double_gt(plane.system, 5.0 * bar.system);
    struct price moving;
    do /* a factorisation takes longer than a step */
        moving = price_calibrate((struct ladder_model){LINEAR_PLANE, 1, 2});
    while (!(moving.begin > moving.system) && ++tries < 20);
    ck_assert(moving.begin > moving.system && moving.system > 0.0);
    ladder_free(s);
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

/* What they say of each mesh's error is what a finer one says. */
static void cells_say_what_a_finer_mesh_says(void)
{
    const struct ladder_scene scene = {.slender = 2, .nu = 0.4,
        .weight = {0.0, -2.0}};
    struct cells cells[CELLS_KINDS * CELLS_LEVELS];
    ck_assert(cells_compare(&scene, CUBIC_PLANE, cells));
    struct ladder_state *fine = ladder_alloc_of(
        QUADRATIC_TRIANGLE, 1.0, &scene,
        (struct ladder_model){CUBIC_PLANE, 0, CELLS_LEVELS});
    fine->status = rung_solve(fine);
    for (int k = 0; k < CELLS_KINDS * CELLS_LEVELS; k++) {
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
        for (int i = 0; i < CELLS_KINDS * CELLS_LEVELS; i++)
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
    const int best = CELLS_KINDS * CELLS_LEVELS - 1;
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

#define NAMED(law) {#law, law}
static const struct unit_law laws[] = {
    NAMED(prices_go_with_columns),
    NAMED(other_triangles_have_the_same_load),
    NAMED(cells_say_what_a_finer_mesh_says),
    NAMED(a_quadratic_triangle_is_counted),
};
UNIT_MAIN("cells", laws)
