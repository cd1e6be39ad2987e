/* climb.c - see climb.h. */
#include "choice/climb.h"

#include <assert.h>

int climb_judge(const struct ladder_state *s, double tolerance,
                struct climb_rung *r)
{
    assert(s->status == OK);
    r->model = s->model;
    r->doubt = estimate_doubt(s);
    estimate_parts(s, r->part);
    return estimate_verdict(s->model, s->scene->time, r->doubt == NO_DOUBT,
                            tolerance, r->part, &r->estimate, &r->add);
}

struct ladder_state *climb_ladder(const struct ladder_scene *scene,
                                  double tolerance,
                                  struct climb_rung tried[CLIMB_MOST], int *n)
{
    struct ladder_model model = ladder_first(scene);
    for (*n = 0;;) {
        struct ladder_state *s = ladder_solve(scene, model);
        struct climb_rung *r = &tried[(*n)++];
        r->model = model;
        if (s->status != OK || climb_judge(s, tolerance, r) ||
            r->doubt == LONG_STEPS)
            return s;
        if (!ladder_add(scene, r->add, &model) &&
            (model.moving || r->doubt != NO_DOUBT ||
             !ladder_add(scene, GEOMETRY, &model)))
            return s;
        ladder_free(s);
    }
}
