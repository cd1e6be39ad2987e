/*
 * compression.h - is K positive definite at u?  A bound that a bar can afford.
 *
 * Cholesky's method answers this for any u, and costs more than the bar that it
 * certifies.  Where the material is nowhere pressed, each triangle answers for
 * itself; where it is, a little, the held end keeps it from turning. With
 * delta = -mu - G'(J), q and n the unequal stretch and the shear of F,
 *
 *     w.Kw >= int a dev^2 + b tr^2 - c omega^2                [eq:compression]
 *
 * for every w that is 0 on the held end, and on a rectangle of length L and
 * height H, L / H whole, Korn's inequality bounds omega by dev and tr.  The
 * chapter has the proof.
 *
 * Source: M. Costabel & M. Dauge, Arch. Ration. Mech. Anal. 217 (2015), for the
 * square's inf-sup constant, at least sin(pi / 8).
 */
#ifndef FIGURES_COMPRESSION_H
#define FIGURES_COMPRESSION_H

#include "choice/ladder.h"

/* true: K is positive definite at state->u, and on any mesh on which F takes no
 * other values.  false: it may be all the same, or the rectangle is not made of
 * whole squares.  *flops: 60 per triangle and
 * weight of the inequality that is tried; of a bar, two triangles of each
 * section are all that differ. */
int compression_certifies(const struct ladder_state *state, double *flops);

/* What ladder_stable() costs: K assembled, 250 flops per triangle, and
 * factored; 0 in motion, where it is not asked. */
double compression_cholesky(const struct ladder_state *state);

#endif
