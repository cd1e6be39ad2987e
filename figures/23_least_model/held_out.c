/*
 * held_out.c - do the estimates hold in scenes on which they were not made?
 *
 * Random scenes of drawn.h are climbed, and what is accepted for 10, 3 and 1 %
 * is compared with the logarithmic law on a mesh finer than the finest, in
 * steps of half the length; a scene is judged where the estimate of that is at
 * most half of the tolerance.  Those at rest are climbed for the root mean
 * square and for the force in the hand as well, and those in motion are counted
 * apart.  The estimates were made on the seeds 1 to 50, and not on these.
 * Three digits: of a pressed column the fifth depends on where Newton's method
 * stops, and so on the compiler.  A larger run is
 *
 *     make BUILD=build/more CFLAGS='-O2 -DSCENES=300 -DSEED=20261201' \
 *         build/more/data/23_least_model/held_out.tsv
 *
 * Tables: rungs (for the displacement), counts (of scenes, by quantity and
 * tolerance; moving: of the displacement in motion), kinds (by kind of scene,
 * for the displacement).
 */
#include "choice/estimate.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "drawn.h"
#include "judged.h"

#include <gsl/gsl_errno.h>

#ifndef SCENES
#define SCENES 42
#define SEED 2357
#endif
enum { MOVING = LADDER_HAND + 1, COUNTED };
static const char *const counted_name[COUNTED] = {"displacement", "rms",
                                                  "force", "moving"};

static void print_rungs(int k, const char *kind, const struct judged_rung r[],
                        int n)
{
    for (int i = 0; i < n; i++)
        table_row(k, kind, ladder_rung(r[i].model.rung),
                  cell_rounded(3, 100.0 * r[i].estimate),
                  cell_rounded(3, 100.0 * r[i].error), r[i].sure ? "yes" : "no",
                  r[i].how[0], r[i].how[1], r[i].how[2]);
}

/* One scene: its rungs into the table, and what is accepted. */
static void try(int k, struct ladder_scene *scene, struct judged *kind,
                struct judged count[COUNTED][JUDGED_WANTED])
{
    struct judged_rung rung[JUDGED_RUNGS];
    struct ladder_state *truth = ladder_solve(scene, ladder_truth(scene));
    int asked = 0;
    if (truth->status == OK && estimate_doubt(truth) == NO_DOUBT)
        asked = scene->time == STANDS ? MOVING : 1;
    for (int q = 0; q < asked; q++) {
        struct judged by[JUDGED_WANTED] = {{{0}}};
        scene->quantity = (enum ladder_quantity)q;
        const int n = judged_climb(truth, rung, by);
        if (q == LADDER_LARGEST) print_rungs(k, scene->name, rung, n);
        for (int t = 0; t < JUDGED_WANTED; t++) {
            judged_add(&count[scene->time == STANDS ? q : MOVING][t], by[t]);
            if (q == LADDER_LARGEST) judged_add(kind, by[t]);
        }
    }
    ladder_free(truth);
}

static void print_kind(const char *kind, struct judged c)
{
    table_row(kind, c.of[JUDGED], c.of[REACHED], c.of[ACCEPTED], c.of[TWICE],
              c.of[THRICE], c.of[LOWER]);
}

/* Prints the row of what is counted for a tolerance, and adds it up. */
static void print_count(int q, int t, struct judged c, struct judged *sum)
{
    table_row(counted_name[q], 100.0 * judged_wanted[t], c.of[JUDGED],
              c.of[REACHED], c.of[ACCEPTED], c.of[ABOVE], c.of[TWICE],
              c.of[THRICE], c.of[LOWER], c.of[RIGHT]);
    judged_add(sum, c);
}

static void claim_right(int q, struct judged sum)
{
    const int accepted = sum.of[ACCEPTED];
    claim(50 * sum.of[TWICE] <= accepted && sum.of[THRICE] == 0, "%s: %d of %d "
          "accepted are wrong by more than twice the tolerance, %d by thrice",
          counted_name[q], sum.of[TWICE], accepted, sum.of[THRICE]);
}

int main(void)
{
    struct judged count[COUNTED][JUDGED_WANTED] = {{{{0}}}};
    struct judged sum[COUNTED] = {{{0}}}, all = {{0}};
    struct judged kind[DRAWN_KINDS] = {{{0}}};
    gsl_set_error_handler_off();
    gsl_rng *random = drawn_start(SEED);
    table_begin("rungs",
                "scene kind model estimate error sure ten three one");
    for (int k = 0; k < SCENES; k++) {
        const enum drawn_kind of = (enum drawn_kind)(k % DRAWN_KINDS);
        struct ladder_scene scene = drawn_scene(random, of);
        try(k, &scene, &kind[of], count);
    }
    table_end();
    gsl_rng_free(random);
    table_begin("counts", "quantity tolerance judged reached accepted above "
                          "twice thrice lower right");
    for (int q = 0; q < COUNTED; q++)
        for (int t = 0; t < JUDGED_WANTED; t++)
            print_count(q, t, count[q][t], &sum[q]);
    table_end();
    table_begin("kinds", "kind judged reached accepted twice thrice lower");
    for (int k = 0; k < DRAWN_KINDS; k++) {
        print_kind(drawn_name((enum drawn_kind)k), kind[k]);
        judged_add(&all, kind[k]);
    }
    print_kind("all", all);
    table_end();
    for (int q = 0; q < COUNTED; q++) claim_right(q, sum[q]);
    claim(4 * all.of[LOWER] <= all.of[ACCEPTED], "a lower rung would have done "
          "in %d of %d", all.of[LOWER], all.of[ACCEPTED]);
    return table_finish();
}
