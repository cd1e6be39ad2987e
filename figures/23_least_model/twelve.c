/*
 * twelve.c - do the estimates meet the truth, in twelve scenes?
 *
 * Each scene of ladder.h is climbed from the bar to the last rung; each rung is
 * estimated from its own answer, and compared with the richest model on a mesh
 * that is finer still.  Tables: rungs (all of them), chosen (the first that is
 * enough for 10 %), least (lowest and highest ratio of the stable ones; what a
 * linear u above the buckling load says by itself, in %).
 */
#include "choice/climb.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { MOST = 16 };
static const double tolerance = 0.1;

struct row {
    struct ladder_model model;
    double estimate, error, flops;
    double straight; /* the estimate without the buckling load, if unstable */
    int stable;
    enum part add;
};

/* What comes of the linear u alone, pressed or not. */
static double estimate_straight(const struct ladder_state *s)
{
    double part[N_PART];
    struct matrix *K = relax_factors(s);
    const double stress = relax_part(s, K, estimate_stress);
    estimate_parts(s, part);
    matrix_free(K);
    return hypot(hypot(part[GEOMETRY], part[MESH]), stress);
}

/* All rungs of a scene; returns how many.  Where a bar is not stable the ladder
 * goes on to the nonlinear law; here the linear one is looked at on the way. */
static int climb(const struct ladder_scene *scene, struct row row[MOST])
{
    struct ladder_state *truth = ladder_solve(scene, ladder_truth(scene));
    struct ladder_model model = {BAR, 0, 0};
    int n = 0, more = 1;
    while (more && n < MOST) {
        struct ladder_state *s = ladder_solve(scene, model);
        struct row *r = &row[n++];
        struct climb_rung judged;
        climb_judge(s, tolerance, &judged);
        *r = (struct row){.model = model, .flops = s->flops,
                          .estimate = judged.estimate, .add = judged.add,
                          .error = ladder_error(s, truth)};
        r->stable = ladder_stable(s);
        if (!r->stable && model.rung == LINEAR_PLANE)
            r->straight = estimate_straight(s);
        if (model.rung == BAR && !r->stable)
            model.rung = LINEAR_PLANE;
        else
            more = ladder_add(scene, r->add, &model);
        ladder_free(s);
    }
    claim(truth->status == OK, "%s has a truth", scene->name);
    ladder_free(truth);
    return n;
}

static void print(const char *scene, const struct row *r, const char *verdict)
{
    table_row(scene, ladder_rung(r->model.rung),
              r->model.moving ? "motion" : "rest", r->model.level,
              cell_rounded(4, 100.0 * r->estimate),
              cell_rounded(4, 100.0 * r->error),
              cell_rounded(4, r->estimate / r->error),
              r->stable ? "stable" : "unstable", r->flops, verdict);
}

int main(void)
{
    static struct row row[LADDER_SCENES][MOST];
    int n[LADDER_SCENES], within = 0, met = 0, all = 0;
    const char *const columns = "scene model state mesh estimate error ratio "
                                "stable flops verdict";
    double lowest = INFINITY, highest = 0.0, straight = 0.0, off = 0.0;
    gsl_set_error_handler_off();
    table_begin_note("rungs", columns, "estimate and error in %%");
    for (int k = 0; k < LADDER_SCENES; k++) {
        n[k] = climb(&ladder_scene[k], row[k]);
        for (int i = 0; i < n[k]; i++) {
            const struct row *r = &row[k][i];
            const double ratio = r->estimate / r->error;
            print(ladder_scene[k].name, r,
                  i + 1 < n[k] ? ladder_part(r->add) : "nothing");
            if (!r->stable) {
                straight = fmax(straight, r->straight);
                off = r->error;
                continue;
            }
            lowest = fmin(lowest, ratio);
            highest = fmax(highest, ratio);
            all++;
        }
    }
    table_end();
    table_begin_note("chosen", columns, "for a tolerance of 10 %%");
    for (int k = 0; k < LADDER_SCENES; k++) {
        int i = 0;
        while (i + 1 < n[k] &&
               !(row[k][i].stable && row[k][i].estimate <= tolerance))
            i++;
        const double ratio = row[k][i].estimate / row[k][i].error;
        print(ladder_scene[k].name, &row[k][i], "enough");
        within += ratio > 1.0 / 3.0 && ratio < 3.0;
        met += row[k][i].error <= tolerance;
    }
    table_end();
    table_begin("least", "rungs lowest highest straight within met");
    table_row(all, cell_rounded(3, lowest), cell_rounded(3, highest),
              cell_rounded(4, 100.0 * straight), within, met);
    table_end();

    claim(within == LADDER_SCENES && lowest > 0.5 && highest < 3.5,
          "estimate over error is between 0.5 and 3.5 on all stable rungs: %g "
          "to %g", lowest, highest);
    claim(straight > 0.0 && straight < 0.1 * off, "above the buckling load "
          "what comes of a linear u is blind: %g of %g", straight, off);
    claim(met == LADDER_SCENES, "%d scenes meet the tolerance", met);
    return table_finish();
}
