/*
 * 02_constitutive.c - energy, stress and tangent of three elastic laws.
 *
 * Notes: Lecture 1, "Neo-Hookean", "Inversion"; Lecture 2, sections 2.2, 2.3.
 *
 * Problem.  A hyperelastic law is its energy psi(F): the first Piola-Kirchhoff
 * stress P is the gradient of psi, the tangent that of P.  Write all three for
 * linear and for Neo-Hookean elasticity, with r = ln J, which resists collapse
 * with an infinite force, and a cubic r, which lets a body turn inside out.
 *
 *         r |              __..--
 *         0 +---------_.-''1------- J    defined at   J < 0   J = 0   J > 0
 *           |      .-' /                  log            no      no     yes
 *           |   .-'   |                   cubic         yes     yes     yes
 *     -11/6 + cubic   | log              equal up to the third derivative at 1
 *
 * Run       make lesson-02; make lesson-02 ARGS=-h lists its options
 * PREDICT 1 slope dP/dF at rest in 1D, E = 1000, nu = 0.3 (N/m^2): ...
 * PREDICT 2 the cubic law's stress is off the log law's at F = 1.05 by (%): ...
 * PREDICT 3 power of t, first remainder, stress right only at rest: ...
 * Plot: curve_cubic F P
 */
#include "material/material.h"
#include "base/options.h"
#include "base/status.h"
#include "base/table.h"

#include <math.h>

/* The structs are in material.h.  Where a law is not defined the functions
 * return INVERTED and not a NaN, and leave their output untouched. */

/* mu and lambda from E and nu [eq:lame].  One dimension means uniaxial strain:
 * the modulus is 2 mu + lambda and not E.  Two dimensions mean plane strain. */
static struct material lame(enum law law, double E, double nu)
{
    const double mu = E / (2.0 * (1.0 + nu));
    const double lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    return (struct material){law, mu, lambda};
}

/* v->r, v->dr, v->ddr := r, r', r'' at J: LOG r = ln J for J > 0, CUBIC its
 * expansion at J = 1 up to the third power of J - 1 [eq:r-cubic]. */
static enum status volumetric(enum law law, double J, struct volumetric *v)
{
    if (law == LINEAR) return OK; /* it has no r */
    /* SLOT 2a(law, J, v): given J, fill v, or return INVERTED where the law is
     * not defined. */
    todo("2a", law, J, v);
    /* END 2a */
    return OK;
}

/*
 * One dimension, F = J a number [eq:psi-neohookean] [eq:psi-linear]:
 *     psi = mu/2 (F^2 - 1) - mu r + lambda/2 r^2,   P = dpsi/dF,   dP = dP/dF;
 *     LINEAR: psi = (mu + lambda/2) (F - 1)^2.
 */
struct response1 {
    double psi, P, dP;
};
static enum status response1(const struct material *material, double F,
                             struct response1 *out)
{
    const double mu = material->mu, lambda = material->lambda;
    struct volumetric v = {0};
    if (volumetric(material->law, F, &v) != OK) return INVERTED;
    /* SLOT 2b(material, mu, lambda, F, v, out): given F, set out->psi, out->P,
     * out->dP for LINEAR and, with v, for both Neo-Hookean laws. */
    todo("2b", material, mu, lambda, F, v, out);
    /* END 2b */
    return OK;
}

/*
 * Two dimensions, J = det F and cof F = dJ/dF, written out: F may be singular.
 *     psi = mu/2 (F:F - 2) - mu r + lambda/2 r^2        [eq:psi-neohookean]
 *     LINEAR: psi = mu eps:eps + lambda/2 tr(eps)^2     [eq:psi-linear]
 * P is its gradient [eq:pk1-neohookean]; eps = (F + F^T)/2 - I.
 */
static enum status response2(const struct material *material, mat2 F,
                             double *psi, mat2 *P)
{
    const double mu = material->mu, lambda = material->lambda;
    struct volumetric v = {0};
    if (volumetric(material->law, mat2_det(F), &v) != OK) return INVERTED;
    /* SLOT 2c(material, mu, lambda, F, v, psi, P): given F, set *psi, *P for
     * LINEAR and, with v, for both Neo-Hookean laws. */
    todo("2c", material, mu, lambda, F, v, psi, P);
    /* END 2c */
    return OK;
}

/* The change of P when F changes by a small dF [eq:dpk1]: linear in dF, and
 * symmetric, A : dP(F; B) = B : dP(F; A). */
static enum status tangent2(const struct material *material, mat2 F, mat2 dF,
                            mat2 *dP)
{
    const double mu = material->mu, lambda = material->lambda;
    struct volumetric v = {0};
    if (volumetric(material->law, mat2_det(F), &v) != OK) return INVERTED;
    /* SLOT 2d(material, mu, lambda, F, dF, v, dP): given F and dF, set *dP:
     * each factor of P changes in the direction dF. */
    todo("2d", material, mu, lambda, F, dF, v, dP);
    /* END 2d */
    return OK;
}

/* Print Figure 6: a law where it is defined, at F = J = -1 ... 3. */
static void print_curve(const struct material *material, int n)
{
    const char *const name[] = {"curve_linear", "curve_log", "curve_cubic"};
    table_begin(name[material->law], "F psi P dP r");
    for (int i = 0; i <= n; i++) {
        const double F = (4.0 * i - n) / n;
        struct volumetric v = {0};
        struct response1 out;
        if (volumetric(material->law, F, &v) == OK &&
            response1(material, F, &out) == OK)
            table_row(F, out.psi, out.P, out.dP,
                      cell_if(material->law != LINEAR, v.r));
    }
    table_end();
}

/* A row of table state: r, r', r'', psi and P at F, where they exist. */
static void print_state(const struct material *material, mat2 F)
{
    struct volumetric v = {0};
    double psi = 0.0;
    mat2 P = F;
    const double J = mat2_det(F);
    const int ok = volumetric(material->law, J, &v) == OK &&
                   response2(material, F, &psi, &P) == OK;
    const int r = ok && material->law != LINEAR;
    table_row(material_law(material->law), J, cell_if(r, v.r),
              cell_if(r, v.dr), cell_if(r, v.ddr), cell_if(ok, psi),
              cell_if(ok, P.m[0][0]), cell_if(ok, P.m[0][1]),
              cell_if(ok, P.m[1][0]), cell_if(ok, P.m[1][1]));
}

/* Four rows of table tangent: dP when one entry of F grows by 1. */
static void print_tangent(const struct material *material, mat2 F)
{
    static const char *const entry[2][2] = {{"F11", "F12"}, {"F21", "F22"}};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            mat2 dF = {{{0.0, 0.0}, {0.0, 0.0}}}, dP = dF;
            dF.m[i][j] = 1.0;
            const int ok = tangent2(material, F, dF, &dP) == OK;
            table_row(material_law(material->law), entry[i][j],
                      cell_if(ok, dP.m[0][0]), cell_if(ok, dP.m[0][1]),
                      cell_if(ok, dP.m[1][0]), cell_if(ok, dP.m[1][1]));
        }
}

int main(int argc, char *argv[])
{
    int n = 160;
    double E = 1000.0, nu = 0.3;
    mat2 F = MATERIAL_STATE;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 9999, .help = "parts of a curve"},
        {"E", .real = &E, .min = 1e-6, .max = 1e12, .unit = "N/m^2",
         .help = "Young's modulus", .why = "a solid resists: E > 0"},
        {"nu", .real = &nu, .min = 0, .max = 0.4999, .help = "Poisson's ratio",
         .why = "lambda is infinite at 1/2, an incompressible solid"},
        {"F11", .real = &F.m[0][0], .min = -99, .max = 99, .help = "entry 11"},
        {"F12", .real = &F.m[0][1], .min = -99, .max = 99, .help = "entry 12"},
        {"F21", .real = &F.m[1][0], .min = -99, .max = 99, .help = "entry 21"},
        {"F22", .real = &F.m[1][1], .min = -99, .max = 99, .help = "entry 22"},
    };
    options_parse("02_constitutive", options, COUNT(options), argc, argv);
    struct material m[CUBIC + 1];
    for (int k = LINEAR; k <= CUBIC; k++) m[k] = lame((enum law)k, E, nu);
    for (int k = LINEAR; k <= CUBIC; k++) print_curve(&m[k], n);
    if (mat2_det(F) > 0.0 && mat2_det(F) < 1e-140)
        die("NONFINITE: J = %g is too small for 1/J^2", mat2_det(F));
    table_begin("state", "law J r dr ddr psi P11 P12 P21 P22");
    for (int k = LINEAR; k <= CUBIC; k++) print_state(&m[k], F);
    table_end();
    table_begin("tangent", "law entry dP11 dP12 dP21 dP22");
    for (int k = LINEAR; k <= CUBIC; k++) print_tangent(&m[k], F);
    table_end();
    return table_finish();
}
