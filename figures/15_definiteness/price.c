/*
 * price.c - what does a projected tangent cost?
 *
 * The ends of the square are pressed together (compress, n = 8, 60 steps), K
 * projected never, on demand, or always.  And near a solution, ends pressed by
 * 0.2 m each, where elements are indefinite and K is positive definite: systems
 * in all and per step; distance after k systems (0: < 1e-13); its order.
 */
#include "plane/scene.h"
#include "../robustness/reason.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { METHODS = 3, STEPS = 60, SYSTEMS = 12 };
static const char *const method[METHODS] = {"notes", "demand+search",
                                            "always+search"};
static const char *const word[METHODS] = {"never", "on demand", "always"};

struct run {
    int steps, systems, projected, worst, cost[STEPS];
    const char *reason;
    double at; /* sin t of the first step that fails, or of the last */
};

static struct run press(int m)
{
    const struct scene_setting set = scene_notes(COMPRESS, CUBIC, 8);
    const struct step_control control = step_method(method[m]);
    struct scene *s = scene_alloc(&set);
    struct run run = {0};
    while (run.steps < STEPS) {
        run.at = sin((s->steps + 1) * set.dt);
        const struct step_report r = scene_step(s, &control);
        run.reason = reason_of(&control, r.status);
        if (r.status != OK) break;
        run.cost[run.steps++] = r.iterations;
        run.systems += r.iterations;
        run.projected += r.projections;
        run.worst = r.iterations > run.worst ? r.iterations : run.worst;
    }
    scene_free(s);
    return run;
}

/* distance[k]: max|u - u*| after k full steps from the lifted ends. */
static void approach(int m, double distance[SYSTEMS + 1])
{
    struct scene_setting set = scene_notes(COMPRESS, CUBIC, 8);
    struct step_control control = step_method(method[m]);
    set.rho = 0.0;
    struct scene *s = scene_alloc(&set);
    double *goal = allocate((size_t)s->n_dof, sizeof *goal);
    control.line_search = 0;
    for (int k = -1; k <= SYSTEMS; k++) {
        control.max_iterations = k < 0 ? 400 : k;
        scene_rest(s);
        scene_press(s, 0.2, 0.0);
        const enum status status =
            step_solve(s->body, &control, at_rest(NULL), s->u).status;
        if (k < 0 && (status != OK ||
                      step_certify(s->body, at_rest(NULL), s->u) != OK))
            die("the square pressed by 0.2 is not at a minimum");
        for (int r = 0; r < s->n_dof; r++) {
            if (k < 0) goal[r] = s->u[r];
            s->u[r] -= goal[r];
        }
        const double d = body_max_free(s->body, s->u);
        if (k >= 0) distance[k] = d > 1e-13 ? d : 0.0;
    }
    free(goal);
    scene_free(s);
}

/* The order of the last three distances above round-off. */
static double last_order(const double distance[SYSTEMS + 1])
{
    int k = 2;
    while (k < SYSTEMS && distance[k + 1] > 0.0) k++;
    const double *d = &distance[k];
    return log(d[0] / d[-1]) / log(d[-1] / d[-2]);
}

int main(void)
{
    struct run run[METHODS];
    double distance[METHODS][SYSTEMS + 1], order[METHODS];
    table_begin("price",
                "method steps systems projected worst sin_t reason order");
    for (int m = 0; m < METHODS; m++) {
        run[m] = press(m);
        approach(m, distance[m]);
        order[m] = last_order(distance[m]);
        table_row(word[m], run[m].steps, run[m].systems, run[m].projected,
                  run[m].worst, run[m].at, run[m].reason,
                  cell_rounded(5, order[m]));
    }
    table_end();
    table_begin("steps", "k sin_t never demand always");
    for (int k = 0; k < STEPS; k++) {
        struct cell cost[METHODS];
        for (int m = 0; m < METHODS; m++)
            cost[m] = cell_if(k < run[m].steps, run[m].cost[k]);
        table_row(k + 1, sin((k + 1) / 30.0), cost[0], cost[1], cost[2]);
    }
    table_end();
    table_begin("approach", "k never demand always");
    for (int k = 0; k <= SYSTEMS; k++)
        table_row(k, distance[0][k], distance[1][k], distance[2][k]);
    table_end();

    claim(!strcmp(run[0].reason, "fails") && fabs(run[0].at - 0.6937) < 1e-3,
          "never: it fails at sin t = %.3f", run[0].at);
    claim(run[1].steps == STEPS && run[2].steps == STEPS &&
              run[1].systems < 600 && run[2].systems > 5 * run[1].systems,
          "on demand and always: all steps; always costs more than five times "
          "as much: %d, %d", run[2].systems, run[1].systems);
    claim(order[0] > 1.9 && order[1] > 1.9 && fabs(order[2] - 1.0) < 0.1,
          "the orders are 2, 2, 1 (%.2f %.2f %.2f)", order[0], order[1],
          order[2]);
    return table_finish();
}
