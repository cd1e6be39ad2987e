/*
 * drawn.h - random scenes of ladder.h, each with two loads at once.
 */
#ifndef FIGURES_23_DRAWN_H
#define FIGURES_23_DRAWN_H

#include "choice/ladder.h"

#include <gsl/gsl_rng.h>

enum drawn_kind { PULLED, PRESSED, CLAMPED, MOVING, DRAWN_KINDS };

/*
 * A scene of a kind.  Slenderness 1 to 6, nu from 0 to 0.48; weight across that
 * would bend a beam by 1/5000 to 1/5 of its length, a couple that bends as much
 * at most, and along the axis a pull of up to three times the buckling load or,
 * PRESSED, up to 0.9 of it.
 * CLAMPED at both ends it has weight along and is pushed on its upper side.
 * MOVING it is pulled and bent by a load that rises in 0.3 to 30 / omega, omega
 * the first frequency of a beam; on two meshes, the others on three.
 */
struct ladder_scene drawn_scene(gsl_rng *random, enum drawn_kind kind);

#endif
