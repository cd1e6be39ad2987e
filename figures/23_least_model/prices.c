/* prices.c - see prices.h. */
#include "prices.h"

#include "../study/study.h"
#include "compression.h"
#include "choice/climb.h"

/* Flops of what the verdict asks for: 130 per triangle for geometry, law,
 * dimension and inertia, of a bar for the two triangles of a section that
 * differ.  Each part that is forces has three products D w, 170 per triangle,
 * and two steps of conjugate gradients, which are a solve and 30 per unknown.
 * The factors are there: of linear triangles at rest those of their solve, of a
 * nonlinear law those of its certificate.  In motion K is factored for it. */
static double estimates(const struct ladder_state *s)
{
    const int n = s->body->n_equation;
    const int parts = s->model.rung == LINEAR_PLANE ? 2 : 1; /* stress */
    const struct matrix_cost cost = matrix_cost(BANDED, n, s->body->K->p);
    if (s->model.rung == BAR) return 130.0 * 2 * s->mesh->n;
    return 130.0 * s->mesh->n_triangle +
           parts * (3.0 * 170.0 * s->mesh->n_triangle +
                    2.0 * (cost.solve + 30.0 * n)) +
           (s->model.moving ? 250.0 * s->mesh->n_triangle + cost.flops
            : s->scene->time != STANDS ? cost.solve : 0.0); /* inertia */
}

static struct price price_of(const struct ladder_state *s,
                             const struct ladder_state *truth)
{
    struct climb_rung r;
    climb_judge(s, 0.0, &r);
    struct price p = {.error = ladder_error(s, truth), .flops = s->flops,
                      .estimates = estimates(s), .estimate = r.estimate,
                      .add = r.add};
    p.stable = ladder_stable(s);
    p.certificate = p.cholesky = compression_cholesky(s);
    if (s->model.rung == BAR) {
        const int enough = compression_certifies(s, &p.certificate);
        claim(!enough || p.stable, "%s: the bound is right", s->scene->name);
        if (!enough) p.certificate += p.cholesky;
    }
    return p;
}

/* Whether a scene has the model. */
static int exists(const struct ladder_scene *scene, struct ladder_model model)
{
    if (model.moving && scene->time == STANDS) return 0;
    if (model.rung == BAR) return !model.moving && model.level == 0;
    return model.level <= scene->finest;
}

void prices_find(const struct ladder_scene *scene, struct prices *prices)
{
    struct ladder_state *truth = ladder_solve(scene, ladder_truth(scene));
    prices->scene = scene;
    prices->richest = (struct ladder_model){LOG_PLANE, scene->time != STANDS,
                                            scene->finest};
    for (int rung = BAR; rung <= LOG_PLANE; rung++)
        for (int moving = 0; moving < 2; moving++)
            for (int level = 0; level < PRICES_LEVELS; level++) {
                const struct ladder_model model = {(enum rung)rung, moving,
                                                   level};
                if (!exists(scene, model)) continue;
                struct ladder_state *s = ladder_solve(scene, model);
                const int n = s->body->n_equation, p = s->body->K->p;
                prices->of[rung][moving][level] = price_of(s, truth);
                prices->dense = matrix_cost(DENSE, n, 0).flops /
                                matrix_cost(BANDED, n, p).flops;
                ladder_free(s);
            }
    ladder_free(truth);
}

const struct price *prices_at(const struct prices *prices,
                              struct ladder_model m)
{
    return &prices->of[m.rung][m.moving][m.level];
}

struct ladder_model prices_cheapest(const struct prices *prices,
                                    double tolerance, int *none)
{
    struct ladder_model best = prices->richest;
    *none = 1;
    for (int rung = BAR; rung <= LOG_PLANE; rung++)
        for (int moving = 0; moving < 2; moving++)
            for (int level = 0; level < PRICES_LEVELS; level++) {
                const struct ladder_model model = {(enum rung)rung, moving,
                                                   level};
                const struct price *p = prices_at(prices, model);
                if (!exists(prices->scene, model) || p->error > tolerance)
                    continue;
                if (*none || p->flops < prices_at(prices, best)->flops)
                    best = model;
                *none = 0;
            }
    return best;
}

int prices_climb(const struct prices *prices, double tolerance,
                 struct ladder_model *chosen, double *cost, double *cholesky)
{
    *chosen = (struct ladder_model){BAR, 0, 0};
    *cost = *cholesky = 0.0;
    for (;;) {
        const struct price *p = prices_at(prices, *chosen);
        *cost += p->flops + p->estimates + p->certificate;
        *cholesky += p->flops + p->estimates + p->cholesky;
        if (p->stable && p->estimate <= tolerance) return 1;
        if (!ladder_add(prices->scene, p->add, chosen)) return 0;
    }
}
