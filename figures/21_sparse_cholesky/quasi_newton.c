/*
 * quasi_newton.c - do old factors get better by what the last systems said?
 *
 * The scenes and the rule of kept.c, factors kept across steps, from the
 * parabola through three states; as they are, and corrected by the last five
 * increments of more than 1e-7 m and the changes
 * of q that came with them (pairs.h).  Pairs turn with the body, and are
 * forgotten with the factors.  Mflop: as in kept.c, but for the tangents, and 8
 * flops per unknown and pair of each system.
 */
#include "pairs.h"
#include "linear/sparse.h"
#include "motion/work.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <string.h>

enum { CELLS = 40, STEPS = 60, SCENES_HERE = 4 };
enum { N_DOF = 2 * (CELLS + 1) * (CELLS + 1) };
static const enum reading reading[SCENES_HERE] = {STRETCH, RIGID, TRACTION,
                                                  SPIN};

/* Old factors, and the pairs that came with them, in the directions that the
 * body had when K was factored. */
struct old {
    int usable, last, least; /* systems of steps, as in body.h */
    double turned[2], scale;
    struct pairs pairs;
};

struct count {
    int systems, factorisations;
    double flops;
};

/* v := its pairs of numbers turned by the angle of (c, s). */
static void turn(int n, double c, double s, double v[])
{
    for (int r = 0; r < n; r += 2) {
        const double x = v[r], y = v[r + 1];
        v[r] = c * x - s * y;
        v[r + 1] = s * x + c * y;
    }
}

/* A step from the guess u. */
static void step(struct scene *s, struct old *old, int most,
                 struct incremental Phi, double u[], struct count *count)
{
    struct body *body = s->body;
    double q[N_DOF], x[N_DOF], now[2], size = INFINITY;
    int systems = 0, fresh = !old->usable || (old->last > KEPT_SYSTEMS &&
                                              old->last > old->least + 1);
    body_turned(body, u, now);
    for (;;) {
        const int small = size <= 1e-10;
        claim(body_assemble(body, Phi, u, fresh && !small ? EXACT : NO_TANGENT,
                            q) == OK && systems < 40, "a step");
        if (small && body_max_free(body, q) <= 1e-10 * old->scale) break;
        if (fresh) {
            claim(matrix_factor(body->K) == OK, "K is positive definite");
            count->factorisations++;
            old->usable = 1, old->pairs.count = 0, old->least = 99;
            old->scale = matrix_max_diagonal(body->K);
            body_turned(body, u, old->turned);
            memcpy(now, old->turned, sizeof now);
        }
        const double c = now[0] * old->turned[0] + now[1] * old->turned[1];
        const double d = now[1] * old->turned[0] - now[0] * old->turned[1];
        turn(s->n_dof, c, -d, q);
        body_gather(body, q, x);
        if (systems > 0 && !fresh && size > 1e-7) pairs_learn(&old->pairs, x);
        count->flops += pairs_solve(&old->pairs, most, body->K, x);
        body_scatter(body, x, q);
        turn(s->n_dof, c, d, q);
        for (int r = 0; r < s->n_dof; r++) u[r] -= q[r];
        const double before = size;
        size = body_max_free(body, q);
        fresh = size > 0.3 * before;
        systems++;
    }
    old->last = systems;
    if (systems < old->least) old->least = systems;
    count->systems += systems;
}

static struct count run(enum reading scene, int most)
{
    struct scene_setting set = scene_notes(scene, CUBIC, CELLS);
    if (scene == STRETCH) set.reach = 0.5;
    struct scene *s = scene_alloc(&set);
    struct old old = {.pairs = pairs_make(s->body->n_equation)};
    struct count count = {0};
    double w[N_DOF], u[N_DOF];
    while (s->steps < STEPS) {
        scene_hold(s, ++s->steps * set.dt);
        for (int r = 0; r < N_DOF; r++) {
            w[r] = s->u[r] + set.dt * s->v[r];
            u[r] = w[r] + set.dt * (s->v[r] - s->v_before[r]);
        }
        step_boundary(s->body, s->g, 1, u);
        step(s, &old, most, (struct incremental){set.dt, w, s->f}, u, &count);
        for (int r = 0; r < N_DOF; r++) {
            s->v_before[r] = s->v[r];
            s->v[r] = (u[r] - s->u[r]) / set.dt;
            s->u[r] = u[r];
        }
    }
    count.flops += count.factorisations * s->body->pattern->flops +
                   count.systems * s->body->pattern->solve +
                   (count.systems + STEPS) * work_elements(s->body, NO_TANGENT);
    pairs_free(&old.pairs);
    scene_free(s);
    return count;
}

int main(void)
{
    table_begin_note("quasi_newton", "scene pairs systems factorisations mflop",
                     "n = %d, per step", CELLS);
    struct count c[SCENES_HERE][2];
    for (int k = 0; k < SCENES_HERE; k++)
        for (int i = 0; i < 2; i++) {
            c[k][i] = run(reading[k], i ? MOST_PAIRS : 0);
            table_row(scene_name(reading[k]), i ? MOST_PAIRS : 0,
                      (double)c[k][i].systems / STEPS,
                      (double)c[k][i].factorisations / STEPS,
                      1e-6 * c[k][i].flops / STEPS);
        }
    table_end();
    double all[2] = {0.0, 0.0};
    for (int k = 0; k < SCENES_HERE; k++)
        for (int i = 0; i < 2; i++) all[i] += c[k][i].flops;
    claim(all[1] > all[0], "all in all, pairs save no flop");
    return table_finish();
}
