/*
 * 02_constitutive.c - energy, stress and tangent of three elastic laws, in one
 * and two dimensions.
 *
 * Notes: Lecture 1, "Neo-Hookean" and "Inversion", Figure 6; Lecture 2,
 * sections 2.2 and 2.3.
 *
 * Problem.  A hyperelastic law is its energy psi(F) alone: the first
 * Piola-Kirchhoff stress P is the gradient of psi, the tangent the gradient of
 * P.  Write all three for linear elasticity [eq:psi-linear] and for
 * Neo-Hookean elasticity [eq:psi-neohookean] with r = ln J, which resists
 * collapse with an infinite force, and with the cubic r [eq:r-cubic], which
 * lets a body be turned inside out.
 *
 *         r |              __..--
 *         0 +---------_.-''1------- J    defined at   J < 0   J = 0   J > 0
 *           |      .-' /                  log            no      no     yes
 *           |   .-'   |                   cubic         yes     yes     yes
 *     -11/6 + .'      |
 *           | cubic   | log              equal up to the third derivative at 1
 *
 * The laws come first; all that follows must() measures them: is P the gradient
 * (Taylor tests), does a rotation cost energy, how far are the laws apart, and
 * where is the tangent negative?
 *
 * Run       make lesson-02, or with options: -h lists them
 * Expect    E = 1000, nu = 0.3: P_cubic / P_log - 1 passes 1, 5, 10 % at
 *           F = 1.246, 1.870, 1.976 and 0.839, 0.682, 0.583, is +273 % at
 *           F = 3; dP/dF > 0 for every F: cubic iff nu > 0.0712220, log iff
 *           nu < 0.4884056; Taylor slopes 2, 3 and 2
 * Plot: curve_cubic F P
 */
#include "material.h"
#include "options.h"
#include "status.h"
#include "table.h"
#include "tensor.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdio.h>

/* material.h gives the types: enum law {LINEAR, LOG, CUBIC}, struct material
 * {law, mu, lambda} and struct volumetric {r, dr, ddr}; tensor.h gives mat2.
 * The mathematics of material.h is written here. */
enum { N_LAW = CUBIC + 1 };
static const char *const law_name[N_LAW] = {"linear", "log", "cubic"};

/*
 * mu and lambda from E and nu [eq:lame].  They are those of a solid: one
 * dimension means uniaxial strain, with the modulus 2 mu + lambda and not E;
 * two dimensions mean plane strain.
 */
static struct material lame(enum law law, double E, double nu)
{
    const double mu = E / (2.0 * (1.0 + nu));
    const double lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    return (struct material){law, mu, lambda};
}

/*
 * r, r' and r'' at J, for LOG and CUBIC [eq:r-cubic]:
 *
 *     LOG    r = ln J                       CUBIC  r = s - s^2/2 + s^3/3
 *                                                  with s = J - 1
 *
 * v  out  v->r, v->dr, v->ddr; untouched when INVERTED, and for LINEAR
 *
 * INVERTED   LOG at a J that is not > 0: an answer and never a NaN
 */
static enum status volumetric(enum law law, double J, struct volumetric *v)
{
    if (law == LINEAR) return OK; /* it has no r */
    /* SLOT 2a(law, J, v): fill v, or return INVERTED where law is not defined
     * at J. */
    todo("2a", law, J, v);
    /* END 2a */
    return OK;
}

/*
 * One dimension, F = J a number [eq:psi-neohookean] [eq:psi-linear]:
 *
 *     psi = mu/2 (F^2 - 1) - mu r + lambda/2 r^2,   P = dpsi/dF,   dP = dP/dF;
 *     LINEAR: psi = (mu + lambda/2) (F - 1)^2.
 *
 * INVERTED   the law is not defined at F; out is untouched
 */
struct response1 {
    double psi, P, dP;
};
static enum status response1(const struct material *material, double F,
                             struct response1 *out)
{
    const double mu = material->mu, lambda = material->lambda;
    struct volumetric v = {0};
    const enum status status = volumetric(material->law, F, &v);
    if (status != OK) return status;
    /* SLOT 2b(material, mu, lambda, F, v, out): out->psi, out->P and out->dP,
     * for LINEAR and, with v, for both Neo-Hookean laws. */
    todo("2b", material, mu, lambda, F, v, out);
    /* END 2b */
    return OK;
}

/*
 * Two dimensions (plane strain), J = det F:
 *
 *     psi = mu/2 (F:F - 2) - mu r + lambda/2 r^2        [eq:psi-neohookean]
 *     P   = mu F + (lambda r - mu) r' cof F             [eq:pk1-neohookean]
 *     LINEAR: psi = mu eps:eps + lambda/2 tr(eps)^2, P = 2 mu eps +
 *             lambda tr(eps) I, eps = (F + F^T)/2 - I   [eq:psi-linear]
 *
 * with cof F = dJ/dF = J F^{-T}, written out: F may be singular.
 *
 * INVERTED   the law is not defined at J; psi and P are untouched
 */
static enum status response2(const struct material *material, mat2 F,
                             double *psi, mat2 *P)
{
    const double mu = material->mu, lambda = material->lambda;
    struct volumetric v = {0};
    const enum status status = volumetric(material->law, mat2_det(F), &v);
    if (status != OK) return status;
    /* SLOT 2c(material, mu, lambda, F, v, psi, P): *psi and *P for LINEAR and,
     * with v, for both Neo-Hookean laws. */
    todo("2c", material, mu, lambda, F, v, psi, P);
    /* END 2c */
    return OK;
}

/*
 * The change of P when F changes by a small dF [eq:dpk1]: linear in dF, and
 * symmetric, A : dP(F; B) = B : dP(F; A).
 *
 * INVERTED   the law is not defined at F; dP is untouched
 */
static enum status tangent2(const struct material *material, mat2 F, mat2 dF,
                            mat2 *dP)
{
    const double mu = material->mu, lambda = material->lambda;
    struct volumetric v = {0};
    const enum status status = volumetric(material->law, mat2_det(F), &v);
    if (status != OK) return status;
    /* SLOT 2d(material, mu, lambda, F, dF, v, dP): differentiate each factor
     * of P in the direction dF. */
    todo("2d", material, mu, lambda, F, dF, v, dP);
    /* END 2d */
    return OK;
}

/* For states in which every law is defined. */
static void must(enum status status)
{
    if (status != OK) die("a law is not defined: %s", status_name(status));
}

static void print_moduli(double E, double nu)
{
    const struct material m = lame(LINEAR, E, nu);
    table_begin_note("moduli", "E nu mu lambda modulus",
                     "modulus = 2 mu + lambda, of a bar that cannot thin");
    table_row(E, nu, m.mu, m.lambda, 2.0 * m.mu + m.lambda);
    table_end();
}

/* Figure 6: the laws where they are defined, F = -1 ... 3. */
static void print_curves(double E, double nu, int n)
{
    for (int law = LINEAR; law < N_LAW; law++) {
        const struct material m = lame((enum law)law, E, nu);
        struct response1 out;
        char name[40];
        snprintf(name, sizeof name, "curve_%s", law_name[law]);
        table_begin_note(name, "F psi P dP",
                         "rows only where the law is defined");
        for (int i = 0; i <= n; i++) {
            const double F = (4.0 * i - n) / n;
            if (response1(&m, F, &out) == OK)
                table_row(F, out.psi, out.P, out.dP);
        }
        table_end();
    }
}

/* A law against the log law, for GSL's root finder. */
struct comparison {
    struct material law, log;
    double level; /* a relative difference */
};

/* P / P_log - 1, for F > 0 and not 1. */
static double difference(const struct comparison *c, double F)
{
    struct response1 mine, log;
    must(response1(&c->law, F, &mine));
    must(response1(&c->log, F, &log));
    return mine.P / log.P - 1.0;
}

static double excess(double F, void *params)
{
    const struct comparison *c = params;
    return fabs(difference(c, F)) - c->level;
}

static double tangent1(double F, void *params)
{
    struct response1 out;
    must(response1(params, F, &out));
    return out.dP;
}

/* The root of f in (lower, upper), by Brent's method; 0 when f does not change
 * its sign there. */
static double root(double (*f)(double, void *), void *params, double lower,
                   double upper)
{
    enum { MOST = 200 };
    gsl_function function = {f, params};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    double x = 0.0;
    int status = gsl_root_fsolver_set(solver, &function, lower, upper);
    for (int i = 0; i < MOST && status == GSL_SUCCESS; i++) {
        status = gsl_root_fsolver_iterate(solver);
        x = gsl_root_fsolver_root(solver);
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver),
                                   gsl_root_fsolver_x_upper(solver), 0.0,
                                   1e-14) == GSL_SUCCESS)
            break;
    }
    gsl_root_fsolver_free(solver);
    return status == GSL_SUCCESS ? x : 0.0;
}

/* Going out from F = 1, the first F where |P / P_log - 1| reaches the level;
 * 0 when it does not before F = 20 or 1/20. */
static double first_passing(struct comparison *c, double direction)
{
    const double factor = exp(1e-3 * direction);
    double inner = factor;
    if (excess(inner, c) >= 0.0) return 0.0;
    for (int i = 0; i < 3000; i++, inner *= factor) {
        const double outer = inner * factor;
        if (excess(outer, c) >= 0.0)
            return root(excess, c, fmin(inner, outer), fmax(inner, outer));
    }
    return 0.0;
}

/* What Figure 6 does not show: how far apart the laws are, in per cent. */
static void print_differences(double E, double nu, int n)
{
    const struct material log = lame(LOG, E, nu);
    struct comparison cubic = {lame(CUBIC, E, nu), log, 0.0};
    struct comparison linear = {lame(LINEAR, E, nu), log, 0.0};

    table_begin_note("difference", "F cubic linear",
                     "100 (P / P_log - 1), where log is defined, but F = 1");
    for (int i = 0; i <= n; i++) {
        const double F = (4.0 * i - n) / n;
        if (F > 0.0 && F != 1.0)
            table_row(F, 100.0 * difference(&cubic, F),
                      100.0 * difference(&linear, F));
    }
    table_end();

    table_begin_note("passes",
                     "percent cubic_tension cubic_compression "
                     "linear_tension linear_compression",
                     "F where |P / P_log - 1| first passes so many per cent");
    const double percent[] = {1.0, 5.0, 10.0};
    for (int i = 0; i < COUNT(percent); i++) {
        cubic.level = linear.level = percent[i] / 100.0;
        table_row(percent[i], first_passing(&cubic, 1.0),
                  first_passing(&cubic, -1.0), first_passing(&linear, 1.0),
                  first_passing(&linear, -1.0));
    }
    table_end();
}

/*
 * min dP/dF over 1 <= F <= 100, by a scan and GSL's Brent minimiser in the cell
 * around the least value; *F_least is where.
 *
 * Tension is enough.  CUBIC: dP/dF is a convex polynomial that falls at F = 1.
 * LOG: F^2 dP/dF = mu (F^2 + 1) + lambda (1 - ln F), positive up to F = e.
 */
static const double F_END = 100.0;
static double least_tangent(struct material *material, double *F_least)
{
    enum { CELLS = 200, MOST = 200 };
    const double factor = pow(F_END, 1.0 / CELLS);
    gsl_function function = {tangent1, material};
    double F = 1.0, value = tangent1(1.0, material);

    *F_least = F;
    for (int i = 0; i < CELLS; i++) {
        F *= factor;
        if (!(tangent1(F, material) < value)) continue;
        value = tangent1(F, material);
        *F_least = F;
    }
    gsl_min_fminimizer *search =
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    if (gsl_min_fminimizer_set(search, &function, *F_least, *F_least / factor,
                               *F_least * factor) == GSL_SUCCESS) {
        for (int i = 0; i < MOST; i++) {
            if (gsl_min_fminimizer_iterate(search) != GSL_SUCCESS) break;
            if (gsl_min_test_interval(gsl_min_fminimizer_x_lower(search),
                                      gsl_min_fminimizer_x_upper(search), 0.0,
                                      1e-8) == GSL_SUCCESS)
                break;
        }
        *F_least = gsl_min_fminimizer_x_minimum(search);
        value = gsl_min_fminimizer_f_minimum(search);
    }
    gsl_min_fminimizer_free(search);
    return value;
}

/* The least tangent as a function of nu, for the law *params and E = 1. */
static double least_tangent_at(double nu, void *params)
{
    struct material material = lame(*(const enum law *)params, 1.0, nu);
    double F;
    return least_tangent(&material, &F);
}

/* The nu at which min dP/dF is 0, and that F; zeros when there is none. */
static double critical_nu(enum law law, double *F)
{
    const double nu = root(least_tangent_at, &law, law == LOG ? 0.3 : 0.0,
                           law == LOG ? 0.499 : 0.3);
    struct material material = lame(law, 1.0, nu);
    least_tangent(&material, F);
    if (nu == 0.0) *F = 0.0;
    return nu;
}

/* Where dP/dF is negative, for some nu on both sides of the critical one. */
static void print_negative_tangents(double E)
{
    static const struct {
        enum law law;
        double nu;
    } at[] = {{CUBIC, 0.02}, {CUBIC, 0.03}, {CUBIC, 0.07}, {CUBIC, 0.0713},
              {CUBIC, 0.3},  {LOG, 0.3},    {LOG, 0.488},  {LOG, 0.49},
              {LOG, 0.499}};

    table_begin_note("negative", "law nu F_least dP_least F_from F_to",
                     "law 1 log, 2 cubic; least over 1 <= F <= 100; dP/dF < 0 "
                     "from F_from to F_to, 0 0 when nowhere");
    for (int i = 0; i < COUNT(at); i++) {
        struct material m = lame(at[i].law, E, at[i].nu);
        double F, from = 0.0, to = 0.0;
        const double least = least_tangent(&m, &F);
        if (least < 0.0) {
            from = root(tangent1, &m, 1.0, F);
            to = root(tangent1, &m, F, F_END);
        }
        table_row(at[i].law, at[i].nu, F, least, from, to);
    }
    table_end();
}

/* dP/dF over 2 mu + lambda, for four nu; the third is the critical one. */
static void print_tangents(void)
{
    enum { N_NU = 4, POINTS = 160 };
    double F_cubic, F_log;
    const double nu_cubic = critical_nu(CUBIC, &F_cubic);
    const double nu_log = critical_nu(LOG, &F_log);

    table_begin_note("thresholds", "nu_cubic F_cubic nu_log F_log",
                     "dP/dF > 0 for every F: cubic for nu above, log for nu "
                     "below");
    table_row(nu_cubic, F_cubic, nu_log, F_log);
    table_end();

    for (int law = LOG; law <= CUBIC; law++) {
        const double nu[2][N_NU] = {{0.3, 0.45, nu_log, 0.499},
                                    {0.3, 0.1, nu_cubic, 0.02}};
        table_begin(law == LOG ? "tangent_log" : "tangent_cubic",
                    law == LOG ? "F nu_03 nu_045 nu_critical nu_0499"
                               : "F nu_03 nu_01 nu_critical nu_002");
        for (int i = 0; i <= POINTS; i++) {
            const double F = law == LOG ? exp(3.5 * i / POINTS)
                                        : -1.0 + 7.0 * i / POINTS;
            double scaled[N_NU];
            for (int k = 0; k < N_NU; k++) {
                struct material m = lame((enum law)law, 1.0, nu[law - LOG][k]);
                scaled[k] = tangent1(F, &m) / (2.0 * m.mu + m.lambda);
            }
            table_row(F, scaled[0], scaled[1], scaled[2], scaled[3]);
        }
        table_end();
    }
}

/* A state and a direction without any symmetry. */
static const mat2 F_state = {{{1.2385, 0.3714}, {-0.2613, 0.8731}}};
static const mat2 dF_state = {{{0.613, -0.731}, {0.512, 0.8247}}};

/* What is handed to the Taylor test: your law, or a wrong stress (the adjugate
 * where the cofactor is due), or a wrong tangent (that of the rest state). */
enum slip { RIGHT, WRONG_STRESS, WRONG_TANGENT, N_SLIP };

struct triple {
    double psi;
    mat2 P, dP;
};

static struct triple evaluate(const struct material *material, enum slip slip,
                              mat2 F, mat2 dF)
{
    struct triple out;
    must(response2(material, F, &out.psi, &out.P));
    must(tangent2(material, slip == WRONG_TANGENT ? mat2_identity() : F, dF,
                  &out.dP));
    if (slip == WRONG_STRESS) { /* transpose all but mu F */
        const mat2 shear = mat2_scale(material->mu, F);
        out.P = mat2_add(shear,
                         mat2_transpose(mat2_subtract(out.P, shear)));
    }
    return out;
}

/*
 * The remainders of Taylor's theorem along F + t H, and their slopes in t when
 * P and dP are the derivatives:
 *
 *     e[0] = |psi(t) - psi(0) - t P:H|                     2
 *     e[1] = |psi(t) - psi(0) - t P:H - t^2/2 H:dP(H)|     3
 *     e[2] = |P(t) - P(0) - t dP(H)|                       2
 *
 * Wrong stress: 1, 1, 1; wrong tangent: 2, 2, 1.  dimension is 1 or 2.
 */
static void remainders(int dimension, const struct material *material,
                       enum slip slip, double t, double e[3])
{
    if (dimension == 1) {
        const double F = 0.7385, H = 1.0;
        struct response1 here, there;
        must(response1(material, F, &here));
        must(response1(material, F + t * H, &there));
        e[0] = there.psi - here.psi - t * here.P * H;
        e[1] = e[0] - 0.5 * t * t * here.dP * H * H;
        e[2] = there.P - here.P - t * here.dP * H;
    } else {
        const mat2 H = dF_state;
        const struct triple here = evaluate(material, slip, F_state, H);
        const struct triple there = evaluate(
            material, slip, mat2_add(F_state, mat2_scale(t, H)), H);
        e[0] = there.psi - here.psi - t * mat2_dot(here.P, H);
        e[1] = e[0] - 0.5 * t * t * mat2_dot(H, here.dP);
        e[2] = mat2_norm(mat2_subtract(mat2_subtract(there.P, here.P),
                                       mat2_scale(t, here.dP)));
    }
    for (int k = 0; k < 3; k++) e[k] = fabs(e[k]);
}

/* t = 2^-2 ... 2^-10, the steps of the Taylor tests. */
enum { COARSE = 2, FINE = 10 };

/* Slopes between the last two steps; 0 where the remainder is round-off, below
 * 1e-9 t of the modulus: psi of the linear law is a square. */
static void slopes(int dimension, const struct material *material,
                   enum slip slip, double slope[3])
{
    const double t = ldexp(1.0, -FINE);
    const double modulus = 2.0 * material->mu + material->lambda;
    double coarse[3], fine[3];
    remainders(dimension, material, slip, 2.0 * t, coarse);
    remainders(dimension, material, slip, t, fine);
    for (int k = 0; k < 3; k++)
        slope[k] = fine[k] > 1e-9 * t * modulus ? log2(coarse[k] / fine[k])
                                                : 0.0;
}

static void print_taylor(double E, double nu)
{
    const struct material cubic = lame(CUBIC, E, nu);
    const char *columns = "P dP pair wrongP_P wrongP_dP wrongP_pair "
                          "wrongdP_P wrongdP_dP wrongdP_pair";
    double value[1 + 3 * N_SLIP];
    char text[120];

    table_begin("slopes", "dimension law P dP pair");
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int law = LINEAR; law < N_LAW; law++) {
            const struct material m = lame((enum law)law, E, nu);
            slopes(dimension, &m, RIGHT, value);
            table_row(dimension, law, value[0], value[1], value[2]);
        }
    table_end();

    snprintf(text, sizeof text, "t %s", columns);
    table_begin_note("taylor", text, "cubic law, two dimensions");
    for (int k = COARSE; k <= FINE; k++) {
        value[0] = ldexp(1.0, -k);
        for (int slip = RIGHT; slip < N_SLIP; slip++)
            remainders(2, &cubic, (enum slip)slip, value[0],
                       value + 1 + 3 * slip);
        table_row_of(COUNT(value), value);
    }
    table_end();

    table_begin("taylor_slopes", columns);
    for (int slip = RIGHT; slip < N_SLIP; slip++)
        slopes(2, &cubic, (enum slip)slip, value + 3 * slip);
    table_row_of(3 * N_SLIP, value);
    table_end();
}

/*
 * Rotation by `degrees`.  psi and P11: of the rotation alone; objectivity:
 * |P(Q F) - Q P(F)| and asymmetry: |P12' - P21'| of P' = P F^T, at F_state.
 */
static void print_rotation(double E, double nu, double degrees)
{
    const mat2 Q = mat2_rotation(degrees * M_PI / 180.0);
    table_begin("rotation", "law psi P11 objectivity asymmetry");
    for (int law = LINEAR; law < N_LAW; law++) {
        const struct material m = lame((enum law)law, E, nu);
        double psi, unused;
        mat2 P_rotation, P, P_rotated;
        must(response2(&m, Q, &psi, &P_rotation));
        must(response2(&m, F_state, &unused, &P));
        must(response2(&m, mat2_multiply(Q, F_state), &unused, &P_rotated));
        const mat2 PFt = mat2_multiply(P, mat2_transpose(F_state));
        table_row(law, psi, P_rotation.m[0][0],
                  mat2_norm(mat2_subtract(P_rotated, mat2_multiply(Q, P))),
                  fabs(PFt.m[0][1] - PFt.m[1][0]));
    }
    table_end();
}

/* (P_linear / P - 1) / e at F = 1 + e: tends to (mu + 3/2 lambda) over
 * (2 mu + lambda) for both laws. */
static void print_small_strain(double E, double nu)
{
    const struct material linear = lame(LINEAR, E, nu);
    struct response1 straight, bent;
    table_begin("small_strain", "e log cubic");
    for (int k = 1; k <= 4; k++) {
        const double e = pow(10.0, -k);
        double ratio[N_LAW];
        must(response1(&linear, 1.0 + e, &straight));
        for (int law = LOG; law < N_LAW; law++) {
            const struct material m = lame((enum law)law, E, nu);
            must(response1(&m, 1.0 + e, &bent));
            ratio[law] = (straight.P / bent.P - 1.0) / e;
        }
        table_row(e, ratio[LOG], ratio[CUBIC]);
    }
    table_end();
}

/* Four ways through the plane: both axes stretched, one, sheared, turned.
 * s is the stretch, the shear or the angle in degrees. */
enum path { EQUIBIAXIAL, UNIAXIAL, SHEAR, ROTATION, N_PATH };

static mat2 path_state(enum path path, double s)
{
    switch (path) {
    case EQUIBIAXIAL: return (mat2){{{s, 0.0}, {0.0, s}}};
    case UNIAXIAL: return (mat2){{{s, 0.0}, {0.0, 1.0}}};
    case SHEAR: return (mat2){{{1.0, s}, {0.0, 1.0}}};
    default: return mat2_rotation(s * M_PI / 180.0);
    }
}

static void print_paths(double E, double nu, int n)
{
    static const char *const path_name[N_PATH] = {"equibiaxial", "uniaxial",
                                                  "shear", "rotation"};
    static const double from[N_PATH] = {-1.5, -1.0, 0.0, 0.0};
    static const double to[N_PATH] = {2.5, 3.0, 2.0, 180.0};

    for (int path = EQUIBIAXIAL; path < N_PATH; path++)
        for (int law = LINEAR; law < N_LAW; law++) {
            const struct material m = lame((enum law)law, E, nu);
            char name[40];
            snprintf(name, sizeof name, "%s_%s", path_name[path],
                     law_name[law]);
            table_begin_note(name, "s J psi P",
                             "P is P%s; rows only where the law is defined",
                             path == SHEAR ? "12" : "11");
            for (int i = 0; i <= n; i++) {
                const double s = (from[path] * (n - i) + to[path] * i) / n;
                const mat2 F = path_state((enum path)path, s);
                double psi;
                mat2 P;
                if (response2(&m, F, &psi, &P) == OK)
                    table_row(s, mat2_det(F), psi,
                              P.m[0][path == SHEAR ? 1 : 0]);
            }
            table_end();
        }
}

int main(int argc, char *argv[])
{
    int n = 160;
    double E = 1000.0, nu = 0.3, angle = 30.0;
    const struct option options[] = {
        {"n", .integer = &n, .min = 1, .max = 10000,
         .help = "intervals of each curve"},
        {"E", .real = &E, .min = 1e-6, .max = 1e12, .unit = "N/m^2",
         .help = "Young's modulus",
         .why = "a solid resists: E > 0"},
        {"nu", .real = &nu, .min = 0.0, .max = 0.4999,
         .help = "Poisson's ratio",
         .why = "lambda is infinite at 1/2, an incompressible solid"},
        {"angle", .real = &angle, .min = -360.0, .max = 360.0,
         .unit = "degrees", .help = "the rotation of table rotation"},
    };
    options_parse("02_constitutive", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();

    print_moduli(E, nu);
    print_curves(E, nu, n);
    print_differences(E, nu, n);
    print_small_strain(E, nu);
    print_negative_tangents(E);
    print_tangents();
    print_taylor(E, nu);
    print_rotation(E, nu, angle);
    print_paths(E, nu, n);
    return table_finish();
}
