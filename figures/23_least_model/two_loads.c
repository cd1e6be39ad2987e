/*
 * two_loads.c - what does the part `stress` see of a body that is pressed or
 * pulled along its axis while something bends it?
 *
 * A column is loaded along its axis by a share of its buckling load, negative
 * where it is pulled, and pushed sideways by a part of that.  Linear triangles
 * are compared with the logarithmic law on the same mesh, so that no mesh is in
 * it: the difference, the part after one step of conjugate gradients, which is
 * 1 / (1 - P / P_cr), and after two.  Tables: pushed, hardly; scenes, three in
 * which a ladder without this part takes linear triangles to be enough.
 */
#include "choice/climb.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

enum { LEVEL = 1 };

/* |e| / |u + e| after so many steps, 1 where the body gives way. */
static double after(const struct ladder_state *s, const struct matrix *K,
                    int steps)
{
    const int n = 2 * s->mesh->n_vertex;
    double *e = allocate((size_t)n, sizeof *e), part = 1.0;
    if (relax_follow(s, K, estimate_stress, steps, e)) {
        const double off = ladder_size(s, e);
        for (int r = 0; r < n; r++) e[r] += s->u[r];
        part = off / ladder_size(s, e);
    }
    free(e);
    return part;
}

/* part[1], part[2] of linear triangles, and part[0], what they are off by. */
static void compare(const struct ladder_scene *scene, double part[3])
{
    struct ladder_state *s =
        ladder_solve(scene, (struct ladder_model){LINEAR_PLANE, 0, LEVEL});
    struct ladder_state *t =
        ladder_solve(scene, (struct ladder_model){LOG_PLANE, 0, LEVEL});
    struct matrix *K = relax_factors(s);
    claim(s->status == OK && t->status == OK, "both laws have an answer");
    for (int k = 1; k <= 2; k++) part[k] = after(s, K, k);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->u[r] -= t->u[r];
    part[0] = ladder_size(s, s->u) / ladder_size(s, t->u);
    matrix_free(K);
    ladder_free(s);
    ladder_free(t);
}

/* Table scenes; how many chosen models meet 10 %. */
static int climb_all(const struct ladder_scene scene[], int n)
{
    int met = 0;
    table_begin_note("scenes", "scene linear error model level estimate chosen",
                     "linear: what geometry alone says; all in %%");
    for (int k = 0; k < n; k++) {
        struct ladder_state *truth =
            ladder_solve(&scene[k], ladder_truth(&scene[k]));
        struct ladder_state *s = ladder_solve(
            &scene[k], (struct ladder_model){LINEAR_PLANE, 0, 0});
        struct climb_rung tried[CLIMB_MOST];
        int n_tried;
        struct ladder_state *chosen =
            climb_ladder(&scene[k], 0.1, tried, &n_tried);
        const struct climb_rung *last = &tried[n_tried - 1];
        const double error = ladder_error(chosen, truth);
        table_row(scene[k].name,
                  cell_rounded(6, 100.0 * estimate_geometry(s)),
                  cell_rounded(6, 100.0 * ladder_error(s, truth)),
                  ladder_rung(chosen->model.rung), chosen->model.level,
                  cell_rounded(6, 100.0 * last->estimate),
                  cell_rounded(6, 100.0 * error));
        met += last->doubt == NO_DOUBT && last->estimate <= 0.1 && error <= 0.1;
        ladder_free(truth);
        ladder_free(s);
        ladder_free(chosen);
    }
    table_end();
    return met;
}

int main(void)
{
    static const double share[] = {-2.0, -0.5, 0.25, 0.5, 0.75, 0.9};
    static const double sideways[] = {1e-2, 1e-3};
    double least = INFINITY, most = 0.0, once = INFINITY, part[3];
    gsl_set_error_handler_off();
    for (int i = 0; i < COUNT(sideways); i++) {
        table_begin_note(i ? "hardly" : "pushed", "share once twice error",
                         "pushed sideways by %g %% of the load along the axis; "
                         "in %%", 100.0 * sideways[i]);
        for (int k = 0; k < COUNT(share); k++) {
            struct ladder_scene column = {.slender = 4, .nu = 0.3};
            column.pull[0] = -share[k] * ladder_buckles(&column) * 2.0;
            column.pull[1] = fabs(column.pull[0]) * sideways[i];
            compare(&column, part);
            table_row(100.0 * share[k], cell_rounded(6, 100.0 * part[1]),
                      cell_rounded(6, 100.0 * part[2]),
                      cell_rounded(6, 100.0 * part[0]));
            if (share[k] > 0.8) continue; /* how far it goes is another law's */
            least = fmin(least, part[2] / part[0]);
            most = fmax(most, part[2] / part[0]);
            once = fmin(once, part[1] / part[0]);
        }
        table_end();
    }
    const int met = climb_all(ladder_two_loads, LADDER_TWO_LOADS);
    claim(least > 0.9 && most < 1.3, "below 80 %% of the buckling load the "
          "part is %g to %g of what is left out", least, most);
    claim(once < 0.5, "one step alone sees %g of it", once);
    claim(met == LADDER_TWO_LOADS, "%d of three scenes with two loads meet 10 "
          "%%", met);
    return table_finish();
}
