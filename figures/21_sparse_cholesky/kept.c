/*
 * kept.c - how long do factors last?
 *
 * Four scenes of scene.h, cubic law, 60 steps of 1/30 s from rest with the best
 * guess: new factors for every system, factors kept within a step [alg:chord],
 * and kept across steps [alg:kept].  Counted, so that no clock and no other
 * program is in it.  Mflop: per step, to factor, to solve, and 250 flops for an
 * element with its tangent, 100 without [eq:roofline].  All end in the same u.
 * Tables: kept (nu = 0.3), tissue (0.45: how many times fewer flops across
 * steps than within one, and how many times more in the worst step).  What a
 * step leaves goes on in v: the spin three times as long, with two tolerances.
 */
#include "linear/sparse.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 40, STEPS = 60, LONG = 180, SCENES_HERE = 4 };
enum { NEW, WITHIN, ACROSS, WAYS }; /* factors */
static const enum reading reading[SCENES_HERE] = {STRETCH, RIGID, TRACTION,
                                                  SPIN};
static const char *const way[WAYS] = {
    [WITHIN] = "within a step", [ACROSS] = "across steps"};

struct count {
    int systems, factorisations, most; /* most: systems of a step */
    double flops, worst;               /* of all steps, of the worst */
    double apart;                      /* (m) */
};

/* answer: [n_dof], written by new factors. */
static struct count run(enum reading scene, int factors, double nu, int steps,
                        double tolerance, double answer[])
{
    struct scene_setting set = scene_notes(scene, CUBIC, CELLS);
    struct step_control control = step_method("lift");
    struct count c = {0};
    set.nu = nu;
    if (scene == STRETCH) set.reach = 0.5;
    control.chord = factors != NEW;
    control.tolerance = tolerance;
    struct scene *s = scene_alloc(&set);
    body_store(s->body, SPARSE);
    const struct sparse *K = s->body->pattern;
    const double with_K = 250.0 * s->body->n_element; /* [eq:roofline] */
    const double without = 100.0 * s->body->n_element;
    while (s->steps < steps) {
        if (factors == WITHIN) s->body->kept.usable = 0;
        const struct step_report r = scene_step(s, &control);
        claim(r.status == OK, "step %d of %s", s->steps, scene_name(scene));
        const double flops = r.factorisations * (K->flops + with_K - without) +
                             r.iterations * K->solve +
                             (r.iterations + 1) * without;
        c.systems += r.iterations;
        c.factorisations += r.factorisations;
        c.flops += flops;
        if (r.iterations > c.most) c.most = r.iterations;
        if (flops > c.worst) c.worst = flops;
    }
    if (factors == NEW)
        memcpy(answer, s->u, (size_t)s->n_dof * sizeof *answer);
    for (int r = 0; r < s->n_dof; r++)
        c.apart = fmax(c.apart, fabs(s->u[r] - answer[r]));
    scene_free(s);
    return c;
}

int main(void)
{
    double *answer =
        allocate(2 * (CELLS + 1) * (CELLS + 1), sizeof *answer);
    struct count c[2][SCENES_HERE][WAYS];
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < SCENES_HERE; k++)
            for (int w = 0; w < WAYS; w++)
                c[t][k][w] = run(reading[k], w, t ? 0.45 : 0.3, STEPS, 1e-10,
                                 answer);
    run(SPIN, NEW, 0.3, LONG, 1e-12, answer);
    const double coarse = run(SPIN, ACROSS, 0.3, LONG, 1e-10, answer).apart;
    const double fine = run(SPIN, ACROSS, 0.3, LONG, 1e-12, answer).apart;
    free(answer);
    table_begin_note("kept", "scene factors systems most factorisations mflop "
                     "worst_mflop times_fewer",
                     "n = %d, per step; times_fewer: flops than within a step",
                     CELLS);
    for (int k = 0; k < SCENES_HERE; k++)
        for (int w = WITHIN; w < WAYS; w++) {
            const struct count *of = &c[0][k][w];
            table_row(scene_name(reading[k]), way[w],
                      (double)of->systems / STEPS, of->most,
                      (double)of->factorisations / STEPS,
                      1e-6 * of->flops / STEPS, 1e-6 * of->worst,
                      c[0][k][WITHIN].flops / of->flops);
        }
    table_end();
    table_begin("tissue", "scene times_fewer worst_times_more");
    for (int k = 0; k < SCENES_HERE; k++) {
        const struct count *in = &c[1][k][WITHIN];
        const struct count *on = &c[1][k][ACROSS];
        table_row(scene_name(reading[k]), in->flops / on->flops,
                  on->worst / in->worst);
    }
    table_end();
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < SCENES_HERE; k++) {
            const struct count *in = &c[t][k][WITHIN];
            const struct count *on = &c[t][k][ACROSS];
            const double gain = in->flops / on->flops;
            const double worst = on->worst / in->worst;
            /* what is left of a step is left in v, too, and moves what nothing
             * holds in each step that follows */
            claim(fmax(on->apart, in->apart) < (t ? 3e-10 : 1e-10),
                  "%s: the same u", scene_name(reading[k]));
            claim(on->factorisations * (t ? 4 : 5) <= in->factorisations,
                  "%s: kept across steps factors serve at least five (nu = "
                  "0.45: four)", scene_name(reading[k]));
            claim(gain > (t ? 2.0 : 2.4) && worst <= (t ? 1.3 : 1.0),
                  "%s: 2.4 times fewer flops, no more in the worst step (nu = "
                  "0.45: twice, up to 1.3 times as many; %g, %g)",
                  scene_name(reading[k]), gain, worst);
        }
    claim(coarse < 3e-9 && fine < 1e-10, "after 180 steps of the spin u is off "
          "by %g, with a tolerance of 1e-12 by %g", coarse, fine);
    return table_finish();
}
