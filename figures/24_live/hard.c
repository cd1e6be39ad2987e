/*
 * hard.c - what each rung of the fallback is for: one is taken away at a time.
 *
 * The square, n = 8, a patch in the hand, backward Euler.  Tables: drag (the
 * patch is pushed in, 60 frames, cubic law, without one of three rungs), rungs
 * (the script `hard`, 300 frames, every rung and both laws).  What that does
 * not show is in rare.c.
 */
#include "base/study.h"
#include "base/table.h"
#include "without.h"

#include <gsl/gsl_errno.h>

/* A drag: the loop without one of the three rungs that it needs, and with. */
static void print_drag(void)
{
    static const enum without less[4] = {SECOND_RUNG, SEARCH, ACCEPTING,
                                         NOTHING};
    struct pointers push = pointers_pull(-5.0);
    table_begin("drag", "without lost freeze unfinished energy");
    for (int k = 0; k < 4; k++) {
        const struct without_result r =
            without_play(less[k], 8, CUBIC, BACKWARD_EULER, &push);
        table_row(without_word(less[k]), r.lost, r.freeze, r.unfinished,
                  r.energy);
        claim(less[k] == NOTHING ? r.lost == 0 : r.freeze > 40, "pushed in, "
              "without %s: %d frames lost in a row", without_word(less[k]),
              r.freeze);
    }
    table_end();
    pointers_free(&push);
}

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

int main(void)
{
    struct without_result all[2][N_WITHOUT];
    gsl_set_error_handler_off();
    print_drag();
    print_rungs(all);
    for (int l = 0; l < 2; l++) {
        const struct without_result *a = all[l];
        claim(a[NOTHING].lost == 0 && a[SECOND_RUNG].freeze >= 40,
              "the whole fallback loses no frame (%d); without the second rung "
              "the picture freezes for 40 frames or more (%d)",
              a[NOTHING].lost, a[SECOND_RUNG].freeze);
        claim(a[ACCEPTING].lost > a[NOTHING].unfinished, "an unfinished frame "
              "that is not accepted is lost, and more follow (%d, %d)",
              a[ACCEPTING].lost, a[NOTHING].unfinished);
        claim(l ? a[ACCEPTING].freeze >= 40 : a[ACCEPTING].freeze <= 2,
              "in a row: 40 or more under the cubic law, two under LOG (%d)",
              a[ACCEPTING].freeze);
        claim(a[LIFT].p50 > a[NOTHING].p50, "without the elastic lift "
              "a frame needs more systems (%g, %g)", a[LIFT].p50,
              a[NOTHING].p50);
    }
    claim(all[1][PROJECTION].unfinished > all[1][NOTHING].unfinished &&
              all[1][TROUBLE].unfinished > all[1][NOTHING].unfinished,
          "cubic law: without projection (%d) or memory (%d) more frames are "
          "unfinished (%d)", all[1][PROJECTION].unfinished,
          all[1][TROUBLE].unfinished, all[1][NOTHING].unfinished);
    claim(all[0][NOTHING].energy > 1.9 * all[0][HALVING].energy,
          "LOG: with halved moves the largest energy is doubled (%g, %g J)",
          all[0][NOTHING].energy, all[0][HALVING].energy);
    claim(all[1][SEARCH].energy > 1e50, "without a line search the cubic body "
          "explodes (%g J)", all[1][SEARCH].energy);
    return table_finish();
}
