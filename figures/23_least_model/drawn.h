/*
 * drawn.h - random scenes of ladder.h, each with two loads at once or more.
 */
#ifndef FIGURES_23_DRAWN_H
#define FIGURES_23_DRAWN_H

#include "choice/ladder.h"

#include <gsl/gsl_rng.h>

/* Random numbers from a seed, for the caller to free with gsl_rng_free(). */
gsl_rng *drawn_start(unsigned long seed);

enum drawn_kind { PULLED, PRESSED, CLAMPED, MOVING, DRAWN_KINDS };
const char *drawn_name(enum drawn_kind kind); /* a word */

/*
 * A scene of a kind.  Slenderness 1 to 6, nu from 0 to 0.48; weight across that
 * would bend a beam by 1/5000 to 1/5 of its length, a couple that bends as much
 * at most, and along the axis a pull of up to three times the buckling load or,
 * PRESSED, up to 0.9 of it.
 * CLAMPED at both ends it has weight along and is pushed on its upper side.
 * MOVING it is pulled and bent by a load that rises in 0.15 to 15 over the
 * first frequency of a beam; on two meshes, the others on three.
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
