/*
 * fibre.h - one preferred direction: what fibres pull, and a body full of them.
 *
 * At rest a fibre lies along the unit vector g.  In the deformed body it lies
 * along n = F g / l, and l = |F g| is its stretch.  Its energy W(l) gives
 *
 *     T = W', T' = W''                                  [eq:fibre-tension]
 *     P = T n g^T                                       [eq:fibre-pk1]
 *     dP = (T' n n^T + T/l (I - n n^T)) dF g g^T        [eq:fibre-dpk1]
 *
 * so dP/dF has the eigenvalues T', T/l, 0, 0, and clamping the first two at 0
 * is its projection.  W, T and T' per undeformed area, in the unit of E.
 *
 *     MUSCLE  T = k (l - 1)^2 for l > 1, else 0     passive: a slack rope
 *               + a sigma (1 - ((l - 1)/w)^2) for |l - 1| < w, else 0   active
 *     CORD    T = k (l - 1) + a sigma               the linear model of both
 *                                                   [eq:force-length]
 *
 * Source: Holzapfel, Nonlinear Solid Mechanics, sec. 6.7, for P and dP; Gordon,
 * Huxley & Julian, J. Physiol. 184 (1966), for the curve, of which the parabola
 * is the least one that has its limbs.
 */
#ifndef COMMON_FIBRE_H
#define COMMON_FIBRE_H

#include "plane/body.h"

enum fibre_law { MUSCLE, CORD };
struct fibre {
    enum fibre_law law;
    double k;          /* of a cord its stiffness, of a muscle its passive
                        * tension at l = 2 (N/m^2) */
    double sigma;      /* largest active tension (N/m^2) */
    double width;      /* w, 0 < w < 1: half the width of the active part */
    double activation; /* a, 0 <= a <= 1 */
};

/* The lesson's muscle: k = 200, sigma = 300, w = 1/2. */
struct fibre fibre_muscle(double activation);

/* W, T, T' at the stretch l >= 0; W = 0 at l = 1. */
struct tension {
    double W, T, dT;
};
struct tension fibre_tension(const struct fibre *fibre, double l);

/* Return stress and tangent for the direction g, |g| = 1.  A fibre of length 0
 * points nowhere: its P is 0, and so is its dP. */
mat2 fibre_pk1(const struct fibre *fibre, const double g[2], mat2 F);
mat2 fibre_dpk1(const struct fibre *fibre, const double g[2], mat2 F, mat2 dF,
                enum tangent tangent); /* EXACT or PROJECTED */

/* Fibres of one law all over a body, in triangle e along the angle[e] from the
 * axis of X1 (radians); the array is borrowed. */
struct fibres {
    struct fibre fibre;
    const double *angle; /* [n_triangle] */
};

/* Return a new array of angles for the caller to free: at the centre of a
 * triangle tilt + bend X1, given in degrees and degrees/m. */
double *fibres_bent(const struct mesh *mesh, double tilt, double bend);

/* Give them to the body, which borrows them, in place of what it had. */
void fibres_attach(struct body *body, const struct fibres *fibres);

/* Return the stretch of the fibre of triangle e, and *angle (or NULL). */
double fibres_stretch(const struct body *body, const struct fibres *fibres,
                      const double u[], int e, double *angle);

#endif
