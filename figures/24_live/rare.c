/*
 * rare.c - what the rungs of the fallback are for that `hard` hardly needs.
 *
 * The square, n = 8, a patch in the hand.  Tables: mad (16 scripts `mad` by
 * both laws, with all rungs: frames, lost, most systems, largest energy), rare
 * (of each of these rungs what tells, with all rungs and without that one: for
 * the first rung in a swing by the midpoint rule, for the others in a script
 * `mad`; and in how many of the 16 this grows, or falls, by a factor of 1.2 or
 * more).
 */
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "without.h"

#include <gsl/gsl_errno.h>
#include <math.h>

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
    table_begin("mad", "frames lost most energy");
    table_row(frames, lost, most, energy);
    table_end();
    claim(lost == 0 && most <= FRAME_SYSTEMS, "mad loses no frame (%d), and "
          "takes %d systems at most (%g)", lost, FRAME_SYSTEMS, most);
}

int main(void)
{
    struct seen seen[COUNT(RARE)] = {{0}};
    gsl_set_error_handler_off();
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
    table_begin("rare", "without law integrator seed what all_rungs one_less "
                        "grows falls");
    for (int k = 0; k < COUNT(RARE); k++) {
        const int seed = RARE[k].seed;
        table_row(without_word(RARE[k].which), material_law(RARE[k].law),
                  RARE[k].method == BACKWARD_EULER ? "backward" : "midpoint",
                  cell_if(seed, seed), WORDS[RARE[k].tells], seen[k].all_rungs,
                  seen[k].one_less, cell_if(seed, seen[k].grows),
                  cell_if(seed, seen[k].falls));
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
    return table_finish();
}
