/* prices.c - laws of figures/23_least_model/prices.h. */
#include "figures/23_least_model/prices.h"

#include "figures/23_least_model/compression.h"
#include "choice/climb.h"
#include "unit.h"

#include <math.h>

static const struct ladder_scene scene = {.name = "some", .slender = 2,
    .nu = 0.3, .weight = {0.0, -1.5}, .finest = 1};

/* Errors and flops that are made up; what a scene at rest has not costs 0. */
static struct prices made_up(void)
{
    struct prices p = {.scene = &scene, .richest = {LOG_PLANE, 0, 1}};
    p.of[BAR][0][0] = (struct price){.error = 0.5, .flops = 1.0,
        .estimate = 0.9, .add = DIMENSION, .stable = 1, .estimates = 2.0,
        .certificate = 3.0, .cholesky = 5.0};
    p.of[LINEAR_PLANE][0][0] = (struct price){.error = 0.2, .flops = 10.0,
        .estimate = 0.04, .add = GEOMETRY, .stable = 0, .estimates = 20.0,
        .certificate = 30.0, .cholesky = 30.0};
    p.of[LINEAR_PLANE][0][1] = (struct price){.error = 0.1, .flops = 40.0};
    p.of[CUBIC_PLANE][0][0] = (struct price){.error = 0.05, .flops = 30.0,
        .estimate = 0.2, .add = MESH, .stable = 1, .estimates = 100.0,
        .certificate = 200.0, .cholesky = 200.0};
    p.of[CUBIC_PLANE][0][1] = (struct price){.error = 0.02, .flops = 120.0,
        .estimate = 0.05, .add = MESH, .stable = 1, .estimates = 1000.0,
        .certificate = 2000.0, .cholesky = 2000.0};
    p.of[LOG_PLANE][0][0] = (struct price){.error = 0.04, .flops = 35.0};
    p.of[LOG_PLANE][0][1] = (struct price){.error = 0.01, .flops = 140.0};
    return p;
}

static void is(struct ladder_model model, enum rung rung, int level)
{
    ck_assert(model.rung == rung && model.level == level && !model.moving);
}

static void the_cheapest_meets_the_tolerance(void)
{
    static const double tolerance[] = {0.6, 0.2, 0.1, 0.045, 0.02, 0.01};
    static const enum rung rung[] = {BAR, LINEAR_PLANE, CUBIC_PLANE, LOG_PLANE,
                                     CUBIC_PLANE, LOG_PLANE};
    static const int level[] = {0, 0, 0, 0, 1, 1};
    const struct prices p = made_up();
    int none;
    for (int k = 0; k < COUNT(level); k++) {
        is(prices_cheapest(&p, tolerance[k], &none), rung[k], level[k]);
        ck_assert(!none);
    }
    is(prices_cheapest(&p, 0.009, &none), LOG_PLANE, 1);
    ck_assert(none);
}

/* From the bar by what each rung adds; what is not stable is not enough. */
static void a_climb_pays_for_each_rung(void)
{
    const struct prices p = made_up();
    struct ladder_model chosen;
    double cost, cholesky;
    ck_assert(prices_climb(&p, 0.1, &chosen, &cost, &cholesky));
    is(chosen, CUBIC_PLANE, 1);
    close_to(cost, 6.0 + 60.0 + 330.0 + 3120.0, 1e-9);
    close_to(cholesky, 8.0 + 60.0 + 330.0 + 3120.0, 1e-9);
    ck_assert(prices_climb(&p, 0.9, &chosen, &cost, &cholesky));
    is(chosen, BAR, 0);
    ck_assert(!prices_climb(&p, 0.01, &chosen, &cost, &cholesky));
    is(chosen, CUBIC_PLANE, 1); /* there is no finer mesh to add */
}

/* Each model that the scene has, and no other, as it is solved by itself. */
static void prices_are_those_of_each_model(void)
{
    struct prices p = {.scene = NULL};
    prices_find(&scene, &p);
    struct ladder_state *truth = ladder_solve(&scene, ladder_truth(&scene));
    ck_assert(p.scene == &scene);
    is(p.richest, LOG_PLANE, 1);
    for (int rung = BAR; rung <= LOG_PLANE; rung++)
        for (int level = 0; level < PRICES_LEVELS; level++) {
            const struct ladder_model model = {(enum rung)rung, 0, level};
            const struct price *at = prices_at(&p, model);
            ck_assert(p.of[rung][1][level].flops == 0.0);
            if (level > (rung == BAR ? 0 : 1)) {
                ck_assert(at->flops == 0.0);
                continue;
            }
            struct ladder_state *s = ladder_solve(&scene, model);
            struct climb_rung judged;
            climb_judge(s, 0.0, &judged);
            ck_assert(at->flops == s->flops && at->add == judged.add &&
                      at->stable);
            close_to(at->error, ladder_error(s, truth), 1e-14);
            close_to(at->estimate, judged.estimate, 1e-14);
            ck_assert(at->cholesky == compression_cholesky(s));
            ck_assert(at->estimates > 0.0);
            ck_assert((at->certificate == at->cholesky) == (rung != BAR));
            const int n = s->body->n_equation, width = s->body->K->p;
            if (rung == LOG_PLANE && level == 1)
                close_to(p.dense, matrix_cost(DENSE, n, 0).flops /
                                      matrix_cost(BANDED, n, width).flops,
                         1e-12);
            ladder_free(s);
        }
    ladder_free(truth);
}

UNIT_MAIN("prices",
    LAW(the_cheapest_meets_the_tolerance),
    LAW(a_climb_pays_for_each_rung),
    LAW(prices_are_those_of_each_model))
