/*
 * drawn.h - random scenes of ladder.h.
 */
#ifndef FIGURES_23_DRAWN_H
#define FIGURES_23_DRAWN_H

#include "choice/ladder.h"

#include <gsl/gsl_rng.h>

/* Random numbers from a seed, for the caller to free with gsl_rng_free(). */
gsl_rng *drawn_start(unsigned long seed);

enum drawn_kind {
    PULLED, PRESSED, CLAMPED, RISING, SWINGING, PRESSED_MOVING, DRAWN_KINDS
};
const char *drawn_name(enum drawn_kind kind); /* a word */

/*
 * A scene of a kind.  Length over height 1/2 to 12, nu from 0 to 0.49; weight
 * across that would bend a beam by 1/5000 to 1/5 of its length, a couple and a
 * pull across that bend as much at most, none of the three in one scene of
 * eight, and along the axis a pull of up to three times the buckling load or,
 * PRESSED and PRESSED_MOVING, up to 0.9 of it, by the end or by the weight.
 * CLAMPED at both ends, as is one of four that are RISING or SWINGING, it has
 * weight along, and is pushed on its upper side by eight times its weight
 * across.  The stresses of all this are at most 0.3 E along and 0.1 E across.
 * In motion the load rises in T, and is watched for a while, or swings as
 * sin(t / T), up to one and a half times; T is 0.3 to 30 over a first frequency
 * of the body.  On two meshes, the others on three.
 */
struct ladder_scene drawn_scene(gsl_rng *random, enum drawn_kind kind);

/*
 * A body of whole squares, 1, 2, 4 or 8, at rest, nu up to 0.45, with up to
 * four loads of either sign, weight and pull along the axis and across, each of
 * them there in 6 of 10 scenes.  Along the axis it is at most `most` times the
 * pull under which a beam buckles, across 4 times the slenderness less;
 * e^-spread to 1 times that, as likely in one decade as in another.
 */
struct ladder_scene drawn_squares(gsl_rng *random, double most, double spread);

#endif
