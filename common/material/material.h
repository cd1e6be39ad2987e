/*
 * material.h - hyperelastic materials: energy, stress and tangent side by side.
 *
 *     LINEAR  psi = mu eps:eps + lambda/2 tr(eps)^2, eps = sym(F) - I
 *                                                            [eq:psi-linear]
 *     LOG     psi = mu/2 (F:F - d) - mu r + lambda/2 r^2, r = ln J
 *     CUBIC   the same with r = s - s^2/2 + s^3/3, s = J - 1
 *                                              [eq:psi-neohookean] [eq:r-cubic]
 *
 *     All but LINEAR are psi = mu/2 (F:F - d) + G(J) and differ in G alone; two
 *     more exist for every F:
 *
 *     EXTENDED  the G of LOG for J >= eps = EXTENDED_BELOW, and below it the
 *               polynomial of second order that continues it  [eq:g-extended]
 *     STABLE    G = l/2 (J - 1)^2 - mu (J - 1), l = lambda + mu, which is
 *               l/2 (J - 1 - mu/l)^2 up to a constant          [eq:psi-stable]
 *
 * J = det F, d the dimension: 1 (uniaxial strain, F a number) or 2 (plane
 * strain).  P = d psi / d F; stresses in the unit of E, per undeformed area.
 *
 * Source: Bonet & Wood, Nonlinear Continuum Mechanics for Finite Element
 * Analysis, 2nd ed., sec. 6.4.3 (LOG); the cubic r is the lecture notes';
 * Smith, de Goes & Kim, ACM Trans. Graph. 37 (2018), sec. 3 (STABLE).
 */
#ifndef COMMON_MATERIAL_H
#define COMMON_MATERIAL_H

#include "material/tensor.h"

#include <assert.h>
#include <math.h>

enum law { LINEAR, LOG, CUBIC, EXTENDED, STABLE };
#define MATERIAL_LAWS "linear log cubic" /* the notes' three as words */
const char *material_law(enum law law);  /* "linear" ... "stable" */
#define EXTENDED_BELOW 0.25              /* eps */

struct material {
    enum law law;
    double mu, lambda; /* Lame parameters, unit of E */
};

/*
 * mu = E / (2 (1 + nu)), lambda = E nu / ((1 + nu)(1 - 2 nu))  [eq:lame];
 * for E > 0 and 0 <= nu < 1/2 (asserted).
 */
struct material material_make(enum law law, double E, double nu);

/* The notes' material: E = 1000 N/m^2, nu = 0.3. */
struct material material_notes(enum law law);

/* A state without any symmetry, at which lesson and studies look at a law. */
extern const mat2 MATERIAL_STATE;

/* Return 2 mu + lambda: the modulus of every law at F = 1 in uniaxial
 * strain. */
double material_modulus(const struct material *material);

/*
 * Return where a held side meets a free one at a right angle, u ~ r^p: p,
 * between 1/2 and 1, of the linear law in plane strain [eq:corner].  Elements
 * of size h have h^(2 p) of the energy wrong there.
 *
 * Source: M. L. Williams, J. Appl. Mech. 19 (1952).
 */
double material_corner(const struct material *material);

/* Return whether psi exists at J: LOG needs J > 0 (false for NaN). */
static inline int material_defined(const struct material *material, double J)
{
    return material->law == LOG ? J > 0.0 : !isnan(J);
}

/* r, r', r'' at J for LOG (J > 0) and CUBIC [eq:r-cubic]; here, and not in
 * material.c, because element loops live on it. */
struct volumetric {
    double r, dr, ddr;
};
static inline struct volumetric material_r(const struct material *material,
                                           double J)
{
    const double s = J - 1.0;
    assert(material_defined(material, J));
    if (material->law == LOG)
        return (struct volumetric){log(J), 1.0 / J, -1.0 / (J * J)};
    /* s - s^2/2 + s^3/3, without a division */
    return (struct volumetric){s * (1.0 - s * (0.5 - s * (1.0 / 3.0))),
                               1.0 - s + s * s, -1.0 + 2.0 * s};
}

/* G' and G'' of psi = mu/2 (F:F - d) + G(J), for every law but LINEAR: all that
 * a body has to know of a law beside mu.  LOG, CUBIC: G = -mu r + lambda/2 r^2.
 * Weighted: both times weight, in element loops. */
struct volume {
    double dG, ddG;
};
struct volume material_volume_beyond(const struct material *material, double J,
                                     double weight); /* EXTENDED, STABLE */
static inline struct volume material_volume_weighted(
    const struct material *material, double J, double weight)
{
    const double mu = material->mu, lambda = material->lambda;
    if (material->law > CUBIC)
        return material_volume_beyond(material, J, weight);
    const struct volumetric v = material_r(material, J);
    return (struct volume){
        weight * (lambda * v.r - mu) * v.dr,
        weight * (lambda * v.dr * v.dr + (lambda * v.r - mu) * v.ddr)};
}
static inline struct volume material_volume(const struct material *material,
                                            double J)
{
    return material_volume_weighted(material, J, 1.0);
}

/* Evaluate one dimension.  F must be where the material is defined
 * (asserted). */
double material1_psi(const struct material *material, double F);
double material1_pk1(const struct material *material, double F);
double material1_dpk1(const struct material *material, double F); /* dP/dF */

/* Evaluate two dimensions; dpk1 is the change of P for a small change dF of F:
 * dP_iJ = (dP_iJ / dF_kL) dF_kL [eq:dpk1]. */
double material2_psi(const struct material *material, mat2 F);
mat2 material2_pk1(const struct material *material, mat2 F);
mat2 material2_dpk1(const struct material *material, mat2 F, mat2 dF);

#endif
