/*
 * held_out.c - do the estimates hold in scenes on which they were not made?
 *
 * Random scenes, drawn from a seed: slenderness, Poisson's ratio, one end or
 * both held, two loads at once, standing or rising.  Each is climbed, and what
 * is accepted for 10, 3 and 1 % is compared with the logarithmic law on a mesh
 * finer than the finest, where the estimate of that is at most half of this.
 * Three digits: of a pressed column the fifth depends on where Newton's method
 * stops, and so on the compiler.  Tables: rungs, accepted, counts (of scenes).
 */
#include "choice/estimate.h"
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "drawn.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { SCENES = 80, SEED = 2357, MOST = 14 };
static const double wanted[] = {0.1, 0.03, 0.01};

struct row {
    double estimate, error;
    struct ladder_model model;
    int stable;
};

/* All rungs; how many, as far as each has an answer. */
static int climb(const struct ladder_scene *scene,
                 const struct ladder_state *truth, struct row row[MOST])
{
    struct ladder_model model = ladder_first(scene);
    int n = 0;
    for (int more = 1; more && n < MOST;) {
        struct ladder_state *s = ladder_solve(scene, model);
        enum part add;
        more = s->status == OK;
        if (more) {
            struct row *r = &row[n++];
            r->model = model;
            estimate_state(s, 0.0, &r->estimate, &add);
            r->error = ladder_error(s, truth);
            r->stable = ladder_stable(s);
            more = ladder_add(scene, add, &model);
        }
        ladder_free(s);
    }
    return n;
}

/* Of a tolerance: scenes judged, those that some rung meets, those for which
 * one was accepted; of these errors beyond twice and three times the tolerance,
 * and scenes for which a lower rung would have done. */
struct count {
    int judged, reached, accepted, twice, thrice, lower;
};

/* What was accepted, for the table. */
static struct accepted {
    const char *kind, *how;
    double tolerance, estimate, error;
} accepted[SCENES * COUNT(wanted)];
static int n_accepted;

/* The first rung that is enough, and how it does. */
static void judge(const char *kind, const struct row row[], int n,
                  double tolerance, struct count *c)
{
    int k = 0, lower = 0, reached = 0;
    while (k < n && !(row[k].stable && row[k].estimate <= tolerance)) k++;
    for (int i = 0; i < n; i++) {
        reached |= row[i].error <= tolerance;
        lower |= i < k && row[i].error <= tolerance;
    }
    c->judged++;
    c->reached += reached;
    if (k == n) return;
    const double off = row[k].error / tolerance;
    c->accepted++;
    c->twice += off > 2.0;
    c->thrice += off > 3.0;
    c->lower += lower;
    accepted[n_accepted++] = (struct accepted){
        kind, off > 2.0 ? "wrong" : lower ? "lower" : "right",
        100.0 * tolerance, 100.0 * row[k].estimate, 100.0 * row[k].error};
}

/* One scene: its rungs into the table, and what is accepted. */
static void try(int k, const struct ladder_scene *scene, struct count count[])
{
    struct row row[MOST];
    struct ladder_state *truth = ladder_solve(scene, ladder_truth(scene));
    double own = INFINITY;
    enum part add;
    int n = 0;
    if (truth->status == OK && ladder_stable(truth)) {
        estimate_state(truth, 0.0, &own, &add);
        n = climb(scene, truth, row);
    }
    for (int i = 0; i < n; i++)
        table_row(k, scene->name, ladder_rung(row[i].model.rung),
                  cell_rounded(3, 100.0 * row[i].estimate),
                  cell_rounded(3, 100.0 * row[i].error),
                  row[i].stable ? "stable" : "unstable");
    for (int t = 0; t < COUNT(wanted); t++)
        if (own <= 0.5 * wanted[t])
            judge(scene->name, row, n, wanted[t], &count[t]);
    ladder_free(truth);
}

int main(void)
{
    struct count count[COUNT(wanted)] = {{0}};
    gsl_set_error_handler_off();
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, SEED);
    table_begin_note("rungs", "scene kind model estimate error stable",
                     "estimate and error in %%");
    for (int k = 0; k < SCENES; k++) {
        const struct ladder_scene scene =
            drawn_scene(random, (enum drawn_kind)(k % DRAWN_KINDS));
        try(k, &scene, count);
    }
    table_end();
    gsl_rng_free(random);
    table_begin_note("accepted", "kind how tolerance estimate error", "in %%");
    for (int i = 0; i < n_accepted; i++)
        table_row(accepted[i].kind, accepted[i].how, accepted[i].tolerance,
                  cell_rounded(3, accepted[i].estimate),
                  cell_rounded(3, accepted[i].error));
    table_end();
    table_begin("counts",
                "tolerance judged reached accepted twice thrice lower");
    for (int t = 0; t < COUNT(wanted); t++) {
        const struct count *c = &count[t];
        table_row(100.0 * wanted[t], c->judged, c->reached, c->accepted,
                  c->twice, c->thrice, c->lower);
    }
    table_end();
    for (int t = 0; t < COUNT(wanted); t++) {
        const struct count *c = &count[t];
        claim(50 * c->twice <= c->accepted && c->thrice == 0, "for %g %% %d of "
              "%d accepted are wrong by more than twice the tolerance, %d by "
              "more than three times", 100.0 * wanted[t], c->twice,
              c->accepted, c->thrice);
        claim(2 * c->lower < c->accepted, "for %g %% a lower rung would have "
              "done in %d of %d", 100.0 * wanted[t], c->lower, c->accepted);
    }
    return table_finish();
}
