/*
 * random.c - does the model that numbers.h names do, in random scenes?
 *
 * Bodies of four shapes with up to four loads at once, along the axis and
 * across, at rest; nothing was tuned on them.  Where a bar or linear triangles
 * are named, what the law leaves out: against the log law on the same mesh.
 * Over: by more than the tolerance, wrong: by more than twice the tolerance,
 * which is what an estimate can promise, lost: by more than three times;
 * rich: the rung below would have done.  Near: a number that decides is at
 * least half of the tolerance; turned: over, and turned by at least 0.07, for
 * which the rule wants a finer mesh.  Tables: random, far (those not near).
 */
#include "drawn.h"
#include "numbers.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { ASKED = 1200 };
static const double tolerance = 0.1;
static const double turned_much = 0.07; /* seen on mesh 0 */

/* What is wrong with a model, on the mesh of the others: the law's part of the
 * error alone; NAN where the log law has no stable answer. */
static double wrong_by(const struct ladder_scene *scene, enum rung rung)
{
    struct ladder_state *log =
        ladder_solve(scene, (struct ladder_model){LOG_PLANE, 0, 1});
    struct ladder_state *s = ladder_solve(
        scene, (struct ladder_model){rung, 0, rung == BAR ? 0 : 1});
    double error = NAN;
    if (log->status == OK && s->status == OK && ladder_stable(log))
        error = ladder_error(s, log);
    ladder_free(s);
    ladder_free(log);
    return error;
}

/* Whether a number that could have asked for more comes close to doing so. */
static int is_near(struct numbers n, enum rung rung)
{
    const double bends = rung == BAR ? n.bends : 0.0;
    return fmax(fmax(n.strained, n.turned), bends) >= 0.5 * tolerance;
}

/* Of the scenes for which a model is named: near; wrong by more than once, of
 * these far from the tolerance and turned; by more than twice and three times
 * the tolerance; and those in which the rung below would have done. */
struct result {
    int scenes, near, over, far_over, turned, wrong, lost, rich;
};
static void ask(const struct ladder_scene *scene, struct result result[])
{
    const struct numbers n = numbers_of(scene);
    const enum rung rung = numbers_rung(n, tolerance);
    const int near = is_near(n, rung);
    const double error = wrong_by(scene, rung);
    struct result *r = &result[rung];
    if (isnan(error)) return;
    r->scenes++;
    if (rung > BAR) {
        const enum rung below = rung == LINEAR_PLANE ? BAR : LINEAR_PLANE;
        r->rich += wrong_by(scene, below) <= tolerance;
    }
    if (rung == CUBIC_PLANE) return; /* which law is another question */
    r->near += near;
    if (error > tolerance) {
        r->over++;
        r->far_over += !near;
        r->turned += n.turned >= turned_much;
    }
    r->wrong += error > 2.0 * tolerance;
    r->lost += error > 3.0 * tolerance;
}

int main(void)
{
    struct result result[CUBIC_PLANE + 1] = {{0}}, all = {0};
    const struct result *linear = &result[LINEAR_PLANE];
    gsl_set_error_handler_off();
    gsl_rng *random = drawn_start(25);
    table_begin("random", "model scenes near over turned wrong lost rich");
    for (int k = 0; k < ASKED; k++) {
        const struct ladder_scene scene = drawn_squares(random, 5.0, 8.0);
        ask(&scene, result);
    }
    gsl_rng_free(random);
    for (int k = BAR; k <= CUBIC_PLANE; k++) {
        const struct result *r = &result[k];
        table_row(k == CUBIC_PLANE ? "nonlinear" : ladder_rung((enum rung)k),
                  r->scenes, cell_if(k < CUBIC_PLANE, r->near),
                  cell_if(k < CUBIC_PLANE, r->over),
                  cell_if(k < CUBIC_PLANE, r->turned),
                  cell_if(k < CUBIC_PLANE, r->wrong),
                  cell_if(k < CUBIC_PLANE, r->lost), cell_if(k > BAR, r->rich));
        all.scenes += k < CUBIC_PLANE ? r->scenes : 0;
        all.near += r->near;
        all.over += r->over;
        all.far_over += r->far_over;
        all.wrong += r->wrong;
        all.lost += r->lost;
        all.rich += r->rich;
    }
    table_end();
    table_begin("far", "scenes over");
    table_row(all.scenes - all.near, all.far_over);
    table_end();
    claim(all.far_over == 0 && linear->turned == linear->over,
          "no number beyond %g: %d of %d are over; of %d linear models that "
          "are, %d are turned by %g", 0.5 * tolerance, all.far_over,
          all.scenes - all.near, linear->over, linear->turned, turned_much);
    claim(30 * all.over <= all.scenes && 100 * all.wrong <= all.scenes &&
              200 * all.lost <= all.scenes && 10 * all.rich <= ASKED,
          "of %d random scenes taken to be linear %d are wrong by more than "
          "the tolerance, %d by twice that, %d by thrice; %d of all could do "
          "with less", all.scenes, all.over, all.wrong, all.lost, all.rich);
    return table_finish();
}
