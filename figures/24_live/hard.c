/*
 * hard.c - what each rung of the fallback is for: one is taken away at a time.
 *
 * The square, n = 8, a patch in the hand, backward Euler.  Tables: drag (the
 * patch is pushed in, 60 frames, cubic law, by the simple frame of lesson 24,
 * built up one safeguard at a time; first: the first frame lost), rungs
 * (the script `hard`, 300 frames, every rung and both laws); of the rungs that
 * `hard` hardly needs, mad (16 scripts `mad` by both laws, with all of them)
 * and rare (of each of these rungs the number that tells, with all rungs and
 * without that one: for the first rung in a swing by the midpoint rule, for the
 * others in a script `mad`; and in how many of the 16 this grows, or falls, by
 * a factor of 1.2 or more); stopped (`hard`, n = 16: frames after which the
 * velocity is 0, and the kinetic energy (J) that one takes at most).
 */
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "without.h"

#include <gsl/gsl_errno.h>
#include <math.h>

/* A drag: the simple frame, built up from the loop of lesson 13. */
static void print_drag(void)
{
    struct pointers push = pointers_pull(-5.0);
    struct without_result with[SIMPLE + 1];
    table_begin("drag", "with lost first most");
    for (int k = LOOP; k <= SIMPLE; k++) {
        with[k] = without_play((enum without)k, 8, CUBIC, BACKWARD_EULER,
                               &push);
        table_row(without_word((enum without)k), with[k].lost,
                  cell_if(with[k].lost, with[k].first), with[k].most);
    }
    table_end();
    pointers_free(&push);
    claim(with[LOOP].lost > with[LIFTED].lost && with[LIFTED].lost >= 50 &&
              with[DESCENDING].lost > 0 && with[DESCENDING].lost < 10,
          "the lift (%d, %d) and projection (%d) save frames",
          with[LOOP].lost, with[LIFTED].lost, with[DESCENDING].lost);
    claim(with[SEARCHING].lost == 0 && with[SEARCHING].most > FRAME_SYSTEMS &&
              with[HURRIED].lost >= 50 && with[SIMPLE].lost == 0,
          "a line search saves the rest, in up to %g systems; in %d at most "
          "only acceptance does (%d, %d)", with[SEARCHING].most, FRAME_SYSTEMS,
          with[HURRIED].lost, with[SIMPLE].lost);
}

static void judge_rungs(struct without_result all[2][N_WITHOUT])
{
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
}

/* Each rung and each law. */
static void print_rungs(void)
{
    struct without_result all[2][N_WITHOUT];
    struct pointers hard = pointers_hard();
    table_begin("rungs", "without log_lost log_energy cubic_lost "
                         "cubic_unfinished cubic_energy");
    for (int w = 0; w < N_WITHOUT; w++) {
        for (int l = 0; l < 2; l++)
            all[l][w] = without_play((enum without)w, 8, l ? CUBIC : LOG,
                                     BACKWARD_EULER, &hard);
        const struct without_result *a = &all[0][w], *b = &all[1][w];
        table_row(without_word((enum without)w), a->lost, a->energy, b->lost,
                  b->unfinished, b->energy);
    }
    table_end();
    pointers_free(&hard);
    judge_rungs(all);
}

/* ---- rungs that are rarely needed ---------------------------------------- */

enum { SEEDS = 16 };
enum tells { SWING, WAITS, ENERGY, SPEED, UNFINISHED };

static const struct {
    enum without which;
    enum law law;
    enum method method;
    int seed; /* the one shown; 0: hard */
    enum tells tells;
} RARE[] = {{FIRST_RUNG, LOG, IMPLICIT_MIDPOINT, 0, SWING},
            {PROJECTION, CUBIC, BACKWARD_EULER, 7, WAITS},
            {DEMAND, CUBIC, BACKWARD_EULER, 7, UNFINISHED},
            {STOPPING, CUBIC, BACKWARD_EULER, 4, ENERGY},
            {HALVING, LOG, BACKWARD_EULER, 4, WAITS},
            {BOUND, CUBIC, BACKWARD_EULER, 4, ENERGY},
            {LEAPING, CUBIC, BACKWARD_EULER, 38, SPEED},
            {TROUBLE, LOG, BACKWARD_EULER, 7, UNFINISHED}};

struct seen {
    double all_rungs, one_less; /* in the script shown */
    int grows, falls;           /* in so many of the 16 */
};

static const char *const WORDS[] = {
    "largest u at the end of a midpoint swing, which should go on (m)",
    "frames in which the hand waits", "largest energy (J)",
    "largest speed (m/s)", "unfinished frames"};

static double number(enum tells tells, struct without_result r)
{
    const double of[] = {r.last, r.stands, r.energy, r.speed, r.unfinished};
    return of[tells];
}

/* Is b larger than a by a factor of 1.2 or more? */
static int larger(double b, double a)
{
    return b > a && 5.0 * b >= 6.0 * a;
}

/* A script as row k of RARE has it, without one rung. */
static struct without_result play(enum without which, int k,
                                  const struct pointers *script)
{
    return without_play(which, 8, RARE[k].law, RARE[k].method, script);
}

/* The 16 scripts; what is counted of them with all rungs becomes table mad. */
static void play_mad(struct seen seen[])
{
    int frames = 0, lost = 0;
    double most = 0.0, energy = 0.0;
    for (int seed = 1; seed <= SEEDS; seed++) {
        struct pointers script = pointers_mad(seed, 600);
        struct without_result all[2];
        for (int l = 0; l < 2; l++) {
            all[l] = without_play(NOTHING, 8, l ? CUBIC : LOG, BACKWARD_EULER,
                                  &script);
            frames += script.n;
            lost += all[l].lost;
            most = fmax(most, all[l].most);
            energy = fmax(energy, all[l].energy);
        }
        for (int k = 1; k < COUNT(RARE); k++) {
            const enum tells t = RARE[k].tells;
            const double a = number(t, all[RARE[k].law == CUBIC]);
            const double b = number(t, play(RARE[k].which, k, &script));
            seen[k].grows += larger(b, a);
            seen[k].falls += larger(a, b);
        }
        pointers_free(&script);
    }
    table_begin("mad", "frames energy");
    table_row(frames, energy);
    table_end();
    claim(lost == 0 && most <= FRAME_SYSTEMS, "mad loses no frame (%d), and "
          "takes %d systems at most (%g)", lost, FRAME_SYSTEMS, most);
}

static void print_rare(void)
{
    struct seen seen[COUNT(RARE)] = {{0}};
    for (int k = 0; k < COUNT(RARE); k++) {
        const int seed = RARE[k].seed;
        struct pointers script = seed ? pointers_mad(seed, 600)
                                      : pointers_hard();
        seen[k].all_rungs = number(RARE[k].tells, play(NOTHING, k, &script));
        seen[k].one_less =
            number(RARE[k].tells, play(RARE[k].which, k, &script));
        pointers_free(&script);
    }
    play_mad(seen);
    table_begin("rare", "without law what all_rungs one_less grows falls");
    for (int k = 0; k < COUNT(RARE); k++) {
        const int seed = RARE[k].seed;
        table_row(without_word(RARE[k].which), material_law(RARE[k].law),
                  WORDS[RARE[k].tells], seen[k].all_rungs, seen[k].one_less,
                  cell_if(seed, seen[k].grows), cell_if(seed, seen[k].falls));
    }
    table_end();
    claim(seen[0].one_less < 1e-3 * seen[0].all_rungs,
          "the first rung is what swings");
    for (int k = 1; k < COUNT(RARE); k++) {
        const enum without w = RARE[k].which;
        const int n = seen[k].grows, less = seen[k].falls;
        claim(larger(seen[k].one_less, seen[k].all_rungs),
              "without the %s, %s: %g, with it %g", without_word(w),
              WORDS[RARE[k].tells], seen[k].one_less, seen[k].all_rungs);
        claim(w == STOPPING || w == LEAPING ? n <= 2 && less <= n
                                            : n >= 5 && n >= 5 * less,
              "of 16 scripts this grows in few (stop, leaps) or in many more "
              "than it falls in (%s: %d, %d)", without_word(w), n, less);
    }
}

/* ((u - u0) / dt at the end of an unfinished frame is the velocity of no
 * motion, so that it is not counted.) */
static void print_stopped(void)
{
    struct without_stop of[2];
    struct pointers hard = pointers_hard();
    table_begin("stopped", "law frames most");
    for (int l = 0; l < 2; l++) {
        const enum law law = l ? CUBIC : LOG;
        of[l] = without_play(NOTHING, 16, law, BACKWARD_EULER, &hard).stop;
        table_row(material_law(law), of[l].frames, of[l].energy);
    }
    table_end();
    pointers_free(&hard);
    claim(of[0].frames >= 40 && of[0].frames <= 50 && of[1].frames >= 20 &&
              of[1].frames <= 30,
          "the velocity is set to 0 in some of the 300 frames (LOG: %d, cubic: "
          "%d)", of[0].frames, of[1].frames);
    claim(fabs(of[0].energy - 50.7) < 1.0 && fabs(of[1].energy - 83.4) < 1.0,
          "a frame takes up to 51 J of kinetic energy under LOG (%g), 83 J "
          "under CUBIC (%g)", of[0].energy, of[1].energy);
}

int main(void)
{
    gsl_set_error_handler_off();
    print_drag();
    print_rungs();
    print_rare();
    print_stopped();
    return table_finish();
}
