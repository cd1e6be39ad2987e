/*
 * hard.c - what each rung of the fallback is for: one is taken away at a time.
 *
 * The square, n = 8, a patch in the hand.  Tables: rungs (the script `hard`,
 * 300 frames, backward Euler, every rung and both laws), rare (what `hard` does
 * not show: the midpoint rule, or the one of 40 seeds of `mad` in which a rung
 * is seen best; what tells, with all rungs and without that one), mad (those
 * seeds with all rungs: frames, lost, most systems).
 */
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "without.h"

#include <gsl/gsl_errno.h>
#include <math.h>

/* Each rung and each law. */
static void print_rungs(struct without_result all[2][N_WITHOUT])
{
    struct pointers hard = pointers_hard();
    table_begin("rungs", "without log_lost log_freeze log_unfinished log_p50 "
                         "log_p99 log_energy log_last cubic_lost cubic_freeze "
                         "cubic_unfinished cubic_p50 cubic_p99 cubic_energy "
                         "cubic_last");
    for (int w = 0; w < N_WITHOUT; w++) {
        for (int l = 0; l < 2; l++)
            all[l][w] = without_play((enum without)w, 8, l ? CUBIC : LOG,
                                     BACKWARD_EULER, &hard);
        const struct without_result *a = &all[0][w], *b = &all[1][w];
        table_row(without_word((enum without)w), a->lost, a->freeze,
                  a->unfinished, a->p50, a->p99, a->energy, a->last, b->lost,
                  b->freeze, b->unfinished, b->p50, b->p99, b->energy, b->last);
    }
    table_end();
    pointers_free(&hard);
}

static const struct {
    enum without which;
    enum law law;
    enum method method;
    int seed; /* 0: hard */
    const char *what;
} RARE[] = {{FIRST_RUNG, LOG, IMPLICIT_MIDPOINT, 0,
             "u at the end of a swing that should go on (m)"},
            {PROJECTION, CUBIC, BACKWARD_EULER, 33,
             "frames in which the hand waits"},
            {STOPPING, CUBIC, BACKWARD_EULER, 4, "energy (J)"},
            {HALVING, LOG, BACKWARD_EULER, 18,
             "frames in which the hand waits"},
            {BOUND, CUBIC, BACKWARD_EULER, 25, "energy (J)"},
            {LEAPING, CUBIC, BACKWARD_EULER, 38, "speed (m/s)"},
            {TROUBLE, LOG, BACKWARD_EULER, 7, "unfinished frames"}};

/* value[k] := what tells, with all rungs and without one; of mad with all
 * rungs, frames are counted, and those lost. */
static void print_rare(double value[][2])
{
    int frames = 0, lost = 0;
    double most = 0.0;
    table_begin("rare", "without law integrator seed what all_rungs one_less");
    for (int k = 0; k < COUNT(RARE); k++) {
        const int seed = RARE[k].seed;
        struct pointers script =
            seed ? pointers_mad(seed, 600) : pointers_hard();
        for (int less = 0; less < 2; less++) {
            const struct without_result r =
                without_play(less ? RARE[k].which : NOTHING, 8, RARE[k].law,
                             RARE[k].method, &script);
            const double tells[COUNT(RARE)] = {r.last,   r.stands, r.energy,
                                               r.stands, r.energy, r.speed,
                                               r.unfinished};
            value[k][less] = tells[k];
            if (less || !seed) continue;
            frames += script.n;
            lost += r.lost;
            most = fmax(most, r.most);
        }
        table_row(without_word(RARE[k].which), material_law(RARE[k].law),
                  RARE[k].method == BACKWARD_EULER ? "backward" : "midpoint",
                  cell_if(seed, seed), RARE[k].what, value[k][0], value[k][1]);
        pointers_free(&script);
    }
    table_end();
    table_begin("mad", "frames lost most");
    table_row(frames, lost, most);
    table_end();
    claim(lost == 0 && most <= FRAME_SYSTEMS, "mad loses no frame (%d), and "
          "takes %d systems at most (%g)", lost, FRAME_SYSTEMS, most);
}

int main(void)
{
    struct without_result all[2][N_WITHOUT];
    double value[COUNT(RARE)][2];
    gsl_set_error_handler_off();
    print_rungs(all);
    print_rare(value);
    for (int l = 0; l < 2; l++) {
        const struct without_result *a = all[l];
        claim(a[NOTHING].lost == 0 && a[SECOND_RUNG].freeze >= 40,
              "the whole fallback loses no frame (%d); without the second rung "
              "the picture freezes for 40 frames or more (%d)",
              a[NOTHING].lost, a[SECOND_RUNG].freeze);
        claim(a[ACCEPTING].lost > a[NOTHING].unfinished, "an unfinished frame "
              "that is not accepted is lost, and more follow (%d, %d)",
              a[ACCEPTING].lost, a[NOTHING].unfinished);
        claim(a[LIFT].p50 > a[NOTHING].p50, "without the elastic lift "
              "a frame needs more systems (%g, %g)", a[LIFT].p50,
              a[NOTHING].p50);
    }
    claim(all[1][PROJECTION].unfinished > all[1][NOTHING].unfinished &&
              all[1][TROUBLE].unfinished > all[1][NOTHING].unfinished,
          "cubic law: without projection (%d) or memory (%d) more frames are "
          "unfinished (%d)", all[1][PROJECTION].unfinished,
          all[1][TROUBLE].unfinished, all[1][NOTHING].unfinished);
    claim(all[1][SEARCH].energy > 1e50, "without a line search the cubic body "
          "explodes (%g J)", all[1][SEARCH].energy);
    claim(value[0][1] < 1e-3 * value[0][0], "the first rung is what swings");
    for (int k = 1; k < COUNT(RARE); k++)
        claim(value[k][1] > 1.2 * value[k][0], "without the %s, %s: %g, with "
              "it %g", without_word(RARE[k].which), RARE[k].what, value[k][1],
              value[k][0]);
    return table_finish();
}
