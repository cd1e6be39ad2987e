/*
 * modes.h - the four modes of dP/dF, for psi = mu/2 (F:F - 2) + G(J).
 *
 * With F = U S V^T [eq:signed-svd], every matrix D = U E V^T below satisfies
 * dP(D) = value D, and the four are orthonormal [eq:modes]:
 *
 *     MODE_TWIST   E = (0 -1; 1 0)/sqrt 2  mu + G'
 *     MODE_FLIP    E = (0  1; 1 0)/sqrt 2  mu - G'
 *     MODE_LOW, MODE_HIGH                  the eigenvectors (e1, e2) and values
 *                  E = diag(e1, e2)        of ( mu + G'' s2^2   G'' J + G'   )
 *                                             ( G'' J + G'      mu + G'' s1^2 )
 *
 * None is negative if |G'| <= mu and G'' >= 0: the determinant of the last two
 * is mu^2 - G'^2 + G'' (mu F:F - 2 G' J), and F:F >= 2 |J|.
 *
 * Source: Irving, Teran & Fedkiw, Graph. Models 68 (2006), sec. 3 (the idea);
 * Smith, de Goes & Kim, ACM Trans. Graph. 38 (2019), sec. 4 (closed forms).
 */
#ifndef COMMON_MODES_H
#define COMMON_MODES_H

#include "material/material.h"

/* F = U S V^T with rotations U and V, S = diag(s1, s2), s1 >= |s2|: s2 carries
 * the sign of det F. */
struct svd {
    mat2 U, V;
    double s1, s2;
};

/* Decompose in closed form, for every finite F: where s1 = |s2| it is one of
 * many. */
struct svd modes_svd(mat2 F);

enum mode { MODE_TWIST, MODE_FLIP, MODE_LOW, MODE_HIGH };
#define MODES "twist flip scale_low scale_high" /* as words, in this order */

struct modes {
    double value[4];   /* unit of mu */
    mat2 direction[4]; /* dF, of length 1 */
};

/* Return the modes from mu, G'(J) and G''(J); or those of a material, not
 * LINEAR, at F. */
struct modes modes_of(mat2 F, double mu, double dG, double ddG);
struct modes modes_at(const struct material *material, mat2 F);

/* Return dP for dF by the nearest positive semi-definite matrix in the
 * Frobenius norm: sum_m max(value_m, 0) (D_m:dF) D_m [eq:projection]. */
mat2 modes_dpk1(const struct modes *modes, mat2 dF);

#endif
