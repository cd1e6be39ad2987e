/*
 * chart.c - the chart of the course: what does thinking save, and what does a
 * fast solver?
 *
 * Every model of each scene of ladder.h is solved and measured against the
 * truth.  For a tolerance of 10, 1 and 0.1 %: the cheapest model that meets it,
 * the one that the ladder chooses, and the counted work of the richest model
 * over that of the cheapest.  Beside it, what the band saves of the richest one
 * with dense factors.  Tables: choice, chart, right.
 */
#include "choice/estimate.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { LEVELS = 4, MODELS = 4 * 2 * LEVELS, TOLERANCES = 3 };
static const double wanted[TOLERANCES] = {0.1, 0.01, 0.001};

static struct outcome {
    double error, flops, estimate;
    int stable;
    enum part add;
} of[LOG_PLANE + 1][2][LEVELS]; /* [rung][moving][level] */

static struct outcome *at(struct ladder_model m)
{
    return &of[m.rung][m.moving][m.level];
}

/* All models that a scene has; returns how many. */
static int models_of(const struct ladder_scene *scene,
                     struct ladder_model all[MODELS])
{
    int n = 0;
    for (int rung = BAR; rung <= LOG_PLANE; rung++)
        for (int moving = 0; moving < (scene->time == STANDS ? 1 : 2); moving++)
            for (int level = 0; level <= scene->finest; level++)
                if (rung != BAR || (!moving && level == 0))
                    all[n++] = (struct ladder_model){(enum rung)rung, moving,
                                                     level};
    return n;
}

static void solve_all(const struct ladder_scene *scene, double *dense)
{
    struct ladder_model all[MODELS];
    const int models = models_of(scene, all);
    struct ladder_state *truth = ladder_solve(scene, ladder_truth(scene));
    for (int k = 0; k < models; k++) {
        struct ladder_state *s = ladder_solve(scene, all[k]);
        struct outcome *o = at(all[k]);
        estimate_state(s, 0.0, &o->estimate, &o->add);
        o->stable = ladder_stable(s);
        o->error = ladder_error(s, truth);
        o->flops = s->flops;
        const int n = s->body->n_equation;
        *dense = matrix_cost(DENSE, n, 0).flops /
                 matrix_cost(BANDED, n, s->body->K->p).flops;
        ladder_free(s);
    }
    ladder_free(truth);
}

/* The one with the fewest flops of those that meet the tolerance; *none: there
 * is no such one, and the richest is returned. */
static struct ladder_model cheapest(const struct ladder_scene *scene,
                                    double tolerance, int *none)
{
    struct ladder_model best = {LOG_PLANE, scene->time != STANDS,
                                scene->finest};
    struct ladder_model all[MODELS];
    const int models = models_of(scene, all);
    *none = 1;
    for (int k = 0; k < models; k++) {
        const struct outcome *o = at(all[k]);
        if (o->error > tolerance) continue;
        if (*none || o->flops < at(best)->flops) best = all[k];
        *none = 0;
    }
    return best;
}

static const char *name(const struct ladder_model *m)
{
    static const char *const moving[] = {"bar", "linear,moving",
                                         "cubic,moving", "log,moving"};
    if (!m) return MISSING;
    return m->moving ? moving[m->rung] : ladder_rung(m->rung);
}

int main(void)
{
    double factor[LADDER_SCENES][TOLERANCES], dense[LADDER_SCENES];
    int right[TOLERANCES] = {0}, reached[TOLERANCES] = {0};
    int wrong[TOLERANCES] = {0}; /* enough, it says, and it is not */
    gsl_set_error_handler_off();
    table_begin("choice",
                "tolerance scene chosen mesh error best level factor right");
    for (int k = 0; k < LADDER_SCENES; k++) {
        const struct ladder_scene *scene = &ladder_scene[k];
        solve_all(scene, &dense[k]);
        const struct ladder_model richest = {
            LOG_PLANE, scene->time != STANDS, scene->finest};
        for (int t = 0; t < TOLERANCES; t++) {
            struct ladder_model chosen = {BAR, 0, 0};
            int none, more = 1;
            const struct ladder_model best = cheapest(scene, wanted[t], &none);
            const struct outcome *o = at(chosen);
            while (more && !(o->stable && o->estimate <= wanted[t])) {
                more = ladder_add(scene, o->add, &chosen);
                o = at(chosen);
            }
            const int agrees = more != none && (none || o == at(best));
            factor[k][t] = none ? NAN : at(richest)->flops / at(best)->flops;
            right[t] += agrees;
            reached[t] += !none;
            wrong[t] += more && o->error > wanted[t];
            table_row(100.0 * wanted[t], scene->name,
                      name(more ? &chosen : NULL), cell_if(more, chosen.level),
                      cell_rounded(6, 100.0 * o->error),
                      name(none ? NULL : &best), cell_if(!none, best.level),
                      cell_if(!none, factor[k][t]), agrees ? "yes" : "no");
        }
    }
    table_end();
    table_begin("chart", "scene ten one tenth dense");
    for (int k = 0; k < LADDER_SCENES; k++) {
        const double *f = factor[k];
        table_row(ladder_scene[k].name, cell_if(f[0] > 0, f[0]),
                  cell_if(f[1] > 0, f[1]), cell_if(f[2] > 0, f[2]), dense[k]);
    }
    table_end();
    table_begin("right", "tolerance right reached wrong");
    for (int t = 0; t < TOLERANCES; t++)
        table_row(100.0 * wanted[t], right[t], reached[t], wrong[t]);
    table_end();
    for (int t = 0; t < TOLERANCES; t++)
        claim(right[t] >= 10 && wrong[t] == 0, "at %g %% the cheapest model "
              "that meets it is chosen in %d of 12 scenes, one that does not "
              "in %d", 100.0 * wanted[t], right[t], wrong[t]);
    return table_finish();
}
