/* material.c - see material.h. */
#include "material/material.h"

#include <assert.h>
#include <gsl/gsl_sf_log.h>
#include <math.h>

const char *material_law(enum law law)
{
    static const char *const name[] = {"linear", "log", "cubic", "extended",
                                       "stable"};
    return name[law];
}

struct material material_make(enum law law, double E, double nu)
{
    assert(E > 0.0 && nu >= 0.0 && nu < 0.5);
    return (struct material){law, E / (2.0 * (1.0 + nu)), /* mu, lambda */
                             E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))};
}

struct material material_notes(enum law law)
{
    return material_make(law, 1000.0, 0.3);
}

const mat2 MATERIAL_STATE = {{{1.2385, 0.3714}, {-0.2613, 0.8731}}};

double material_modulus(const struct material *material)
{
    return 2.0 * material->mu + material->lambda;
}

double material_corner(const struct material *material)
{
    const double mu = material->mu, lambda = material->lambda;
    const double kappa = 3.0 - 2.0 * lambda / (mu + lambda); /* 3 - 4 nu */
    double low = 0.5, high = 1.0;
    for (int k = 0; k < 60; k++) {
        const double p = 0.5 * (low + high), s = sin(p * acos(0.0));
        /* the root of sin^2(p pi/2) = ((kappa + 1)^2 / 4 - p^2) / kappa */
        const double free =
            (0.25 * (kappa + 1.0) * (kappa + 1.0) - p * p) / kappa;
        if (s * s < free)
            low = p;
        else
            high = p;
    }
    return high;
}

/* Return s - r(J) with s = J - 1, that is s^2/2 - ... : no digits are lost near
 * J = 1, where the series begins, nor of a small J, which s does not know. */
static double s_minus_r(const struct material *material, double s, double J)
{
    if (material->law != LOG) return s * s / 2.0 - s * s * s / 3.0; /* CUBIC */
    return s < -0.5 ? s - log(J) : -gsl_sf_log_1plusx_mx(s); /* s - ln J */
}

/* Set G, G', G'' at J of EXTENDED: of the log law's Taylor polynomial of second
 * order about eps, or about J itself. */
static inline void extended(const struct material *material, double J,
                            double G[3])
{
    const double mu = material->mu, lambda = material->lambda;
    const double J0 = J < EXTENDED_BELOW ? EXTENDED_BELOW : J, t = J - J0;
    /* G = lambda r^2 / 2 - mu r, G' = (lambda r - mu) / J, and G'' */
    const double r = log(J0), over = 1.0 / J0, dG = (lambda * r - mu) * over;
    G[2] = (lambda + mu - lambda * r) * over * over;
    G[1] = dG + G[2] * t;
    G[0] = -mu * r + 0.5 * lambda * r * r + dG * t + 0.5 * G[2] * t * t;
}

struct volume material_volume_beyond(const struct material *material, double J,
                                     double weight)
{
    const double mu = material->mu, l = material->lambda + mu;
    if (material->law == STABLE) /* G = (lambda + mu) s^2 / 2 - mu s */
        return (struct volume){weight * (l * (J - 1.0) - mu), weight * l};
    double G[3];
    extended(material, J, G);
    return (struct volume){weight * G[1], weight * G[2]};
}

/* Return shape + mu s + G(J) with s = J - 1; see s_minus_r. */
static double add_volume(const struct material *material, double shape,
                         double J, double s)
{
    const double mu = material->mu, lambda = material->lambda;
    if (material->law == STABLE) return shape + 0.5 * (lambda + mu) * s * s;
    if (material->law == EXTENDED && J < EXTENDED_BELOW) {
        double G[3];
        extended(material, J, G);
        return shape + mu * s + G[0];
    }
    struct material like = *material;
    if (material->law == EXTENDED) like.law = LOG;
    /* mu s + G = mu (s - r) + lambda r^2 / 2 */
    const double r = material_r(&like, J).r;
    return shape + mu * s_minus_r(&like, s, J) + 0.5 * lambda * r * r;
}

/* mu/2 (F^2 - 1) = mu e^2/2 + mu e with e = F - 1; see add_volume. */
double material1_psi(const struct material *material, double F)
{
    const double mu = material->mu, e = F - 1.0;
    if (material->law == LINEAR)
        return 0.5 * material_modulus(material) * e * e;
    return add_volume(material, 0.5 * mu * e * e, F, e);
}

double material1_pk1(const struct material *material, double F)
{
    if (material->law == LINEAR) return material_modulus(material) * (F - 1.0);
    return material->mu * F + material_volume(material, F).dG; /* J = F */
}

double material1_dpk1(const struct material *material, double F)
{
    if (material->law == LINEAR) return material_modulus(material);
    const double mu = material->mu, lambda = material->lambda;
    if (material->law > CUBIC)
        return mu + material_volume_beyond(material, F, 1.0).ddG;
    /* mu + G'', G' = (lambda r - mu) r' */
    const struct volumetric v = material_r(material, F);
    return mu + lambda * v.dr * v.dr + (lambda * v.r - mu) * v.ddr;
}

/* With H = F - I and s = J - 1: F:F - 2 = H:H + 2 tr H = H:H + 2 (s - det H).
 */
double material2_psi(const struct material *material, mat2 F)
{
    const double mu = material->mu, lambda = material->lambda;
    const mat2 H = mat2_subtract(F, mat2_identity());
    if (material->law == LINEAR) {
        const mat2 eps = mat2_scale(0.5, mat2_add(H, mat2_transpose(H)));
        const double trace = mat2_trace(eps);
        return mu * mat2_dot(eps, eps) + 0.5 * lambda * trace * trace;
    }
    const double s = mat2_trace(H) + mat2_det(H);
    const double J = s < -0.5 ? mat2_det(F) : 1.0 + s;
    return add_volume(material, 0.5 * mu * mat2_dot(H, H) - mu * mat2_det(H), J,
                      s);
}

mat2 material2_pk1(const struct material *material, mat2 F)
{
    const double mu = material->mu, lambda = material->lambda;
    if (material->law == LINEAR) { /* 2 mu eps + lambda tr(eps) I */
        const mat2 H = mat2_subtract(F, mat2_identity());
        return mat2_add(mat2_scale(mu, mat2_add(H, mat2_transpose(H))),
                        mat2_scale(lambda * mat2_trace(H), mat2_identity()));
    }
    /* P = mu F + G' cof F, as dJ/dF = cof F */
    const double dG = material_volume(material, mat2_det(F)).dG;
    return mat2_add(mat2_scale(mu, F), mat2_scale(dG, mat2_cofactor(F)));
}

/* cof is linear in two dimensions: d(cof F) = cof(dF). */
mat2 material2_dpk1(const struct material *material, mat2 F, mat2 dF)
{
    const double mu = material->mu, lambda = material->lambda;
    if (material->law == LINEAR)
        return mat2_add(mat2_scale(mu, mat2_add(dF, mat2_transpose(dF))),
                        mat2_scale(lambda * mat2_trace(dF), mat2_identity()));
    /* mu dF + G'' (cof F : dF) cof F + G' cof(dF) */
    const struct volume v = material_volume(material, mat2_det(F));
    const mat2 cof = mat2_cofactor(F);
    return mat2_add(mat2_scale(mu, dF),
                    mat2_add(mat2_scale(v.ddG * mat2_dot(cof, dF), cof),
                             mat2_scale(v.dG, mat2_cofactor(dF))));
}
