/*
 * 17_fibres.c - fibres in a body: what one preferred direction costs and adds.
 *
 * Notes: Lecture 1, the anisotropic energy, Figures 2 and 3.
 * Problem.  At rest a fibre lies along the unit vector g; l = |F g| is its
 * stretch.  Its energy W(l) adds to that of the material, and T = W' pulls
 * along n = F g / l [eq:fibre-tension].
 *
 *     T |       .--.         /  MUSCLE: a passive part from l = 1 on, and an
 *       |     .'    '.  __.-'   active one, a parabola for |l - 1| < w, on
 *       |    /     __:-'        whose descending limb T' < 0
 *     0 +---+----+-----+---- l                        [eq:force-length]
 *          1-w   1    1+w
 *
 * Run       make lesson-17; make lesson-17 ARGS=-h lists its options
 * PREDICT 1a length of the free strip at full activation: ...
 * PREDICT 1b and when it carries 100 N/m^2: ...
 * Plot: force_length l T
 */
#include "plane/fibre.h"
#include "base/options.h"
#include "plane/history.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

/* Given the stretch l >= 0 of a fibre, return its W, T and T', where W = 0 at
 * l = 1.  The two laws are in fibre.h [eq:force-length]. */
static struct tension tension(const struct fibre *fibre, double l)
{
    const double k = fibre->k, w = fibre->width, e = l - 1.0;
    const double active = fibre->activation * fibre->sigma;
    struct tension t = {0.0, 0.0, 0.0};
    /* SLOT 17a(fibre, l, k, w, e, active, &t): t.W, t.T and t.dT, for CORD and
     * for MUSCLE; at a kink of T the T' of either side will do. */
    const double taut = fmax(e, 0.0), x = fmax(-w, fmin(e, w));
    if (fibre->law == CORD) {
        t.W = 0.5 * k * e * e + active * e; /* int T dl from l = 1 */
        t.T = k * e + active;
        t.dT = k;
    } else {
        t.W = k * taut * taut * taut / 3.0;
        t.W += active * (x - x * x * x / (3.0 * w * w));
        t.T = k * taut * taut + active * (1.0 - x * x / (w * w));
        t.dT = 2.0 * k * taut; /* and in the window that of the parabola */
        if (fabs(e) < w) t.dT -= active * 2.0 * x / (w * w);
    }
    /* END 17a */
    return t;
}

/* Given the direction g of a fibre at rest, F, and a small change dF, return
 * the stretch l, and put into *P the stress of the fibre and into *dP its
 * change.  PROJECTED: negative eigenvalues of dP/dF are set to 0.  At l = 0 the
 * fibre points nowhere, and P and dP are 0. */
static double stress(const struct fibre *fibre, const double g[2], mat2 F,
                     mat2 dF, enum tangent kind, mat2 *P, mat2 *dP)
{
    double l = 0.0;
    /* SLOT 17b(fibre, g, F, dF, kind, tension, P, dP, &l): l and n first; then
     * *P; then *dP, from what dF does to n and to T. */
    double n[2], dFg[2];
    for (int i = 0; i < 2; i++) {
        n[i] = F.m[i][0] * g[0] + F.m[i][1] * g[1];
        dFg[i] = dF.m[i][0] * g[0] + dF.m[i][1] * g[1];
    }
    l = hypot(n[0], n[1]);
    const struct tension t = tension(fibre, l);
    double along = t.dT, across = t.T / l; /* of n: d(T n) by d(l n) */
    if (kind == PROJECTED) {
        along = fmax(along, 0.0);
        across = fmax(across, 0.0);
    }
    for (int i = 0; i < 2; i++) n[i] /= l;
    const double dl = n[0] * dFg[0] + n[1] * dFg[1];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            const double change =
                along * dl * n[i] + across * (dFg[i] - dl * n[i]); /* d(T n) */
            P->m[i][k] = l > 0.0 ? t.T * n[i] * g[k] : 0.0;
            dP->m[i][k] = l > 0.0 ? change * g[k] : 0.0;
        }
    /* END 17b */
    return l;
}

/* Given u, add the fibres of body->added all over the body to *energy, or to q
 * and K, as body.h says of a body_addition. */
static void add_fibres(const struct body *body, double dt, const double u[],
                       enum tangent kind, double *energy, double q[])
{
    const struct fibres *fibres = body->added;
    /* SLOT 17c(body, dt, u, kind, energy, q, fibres, tension, stress): g from
     * fibres->angle[e] (radians), F from body_deformation(); body->area[e],
     * vertices &body->vertex[3 * e], gradients &body->gradient[6 * e]; unknown
     * 2a + i is number body->equation[2a + i] of body->K, -1 if held. */
    const struct fibre *fibre = &fibres->fibre;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const double g[2] = {cos(fibres->angle[e]), sin(fibres->angle[e])};
        const int *t = &body->vertex[3 * e], *number = body->equation;
        const double *G = &body->gradient[6 * e], area = body->area[e];
        const mat2 F = body_deformation(body, u, e);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 2; k++) {
                const int column = 2 * t[c] + k;
                mat2 dF = {{{0.0}}}, P, dP; /* dF/du of that unknown */
                for (int m = 0; m < 2; m++) dF.m[k][m] = G[2 * c + m];
                const double l = stress(fibre, g, F, dF, kind, &P, &dP);
                if (energy && !c && !k) *energy += area * tension(fibre, l).W;
                if (q) q[column] += dt * dt * area * mat2_dot(P, dF);
                if (kind == NO_TANGENT) continue;
                for (int a = 0; a < 3; a++)
                    for (int i = 0; i < 2; i++) {
                        const int row = 2 * t[a] + i;
                        const double *G_a = &G[2 * a], *dP_i = dP.m[i];
                        const double K = dP_i[0] * G_a[0] + dP_i[1] * G_a[1];
                        if (number[row] >= 0 && number[column] >= 0)
                            matrix_add(body->K, number[row], number[column],
                                       dt * dt * area * K);
                    }
            }
    }
    /* END 17c */
}

enum { CAP = 40 }; /* linear systems, which this loop solves by hand */
/* Given the load of a strip along its fibres, find x with F = diag(x[0], x[1])
 * and P = diag(load, 0), by Newton's method from diag(1, 1), until P is met to
 * `enough`, and return how it ended.  INVERTED: the material has no P there;
 * NOT_SPD: the 2x2 matrix is not positive definite; NONFINITE: P is not finite;
 * MAX_ITERATIONS: not done after CAP linear systems. */
static enum status strip(const struct material *material,
                         const struct fibre *fibre, double load, double x[2])
{
    const double g[2] = {1.0, 0.0}, enough = 1e-13 * material_modulus(material);
    enum status status = MAX_ITERATIONS;
    x[0] = x[1] = 1.0;
    /* SLOT 17d(material, fibre, load, x, enough, g, stress, &status): stress()
     * with dF = diag(1, 0), and material2_dpk1() also with diag(0, 1). */
    for (int k = 0; k <= CAP; k++) {
        const mat2 dl = {{{1.0}}}, dw = {{{0.0}, {0.0, 1.0}}};
        const mat2 F = {{{x[0], 0.0}, {0.0, x[1]}}};
        mat2 P, dP;
        if (!material_defined(material, mat2_det(F))) return INVERTED;
        stress(fibre, g, F, dl, EXACT, &P, &dP);
        P = mat2_add(material2_pk1(material, F), P);
        dP = mat2_add(material2_dpk1(material, F, dl), dP);
        const double q[2] = {P.m[0][0] - load, P.m[1][1]};
        if (!isfinite(q[0]) || !isfinite(q[1])) return NONFINITE;
        if (fmax(fabs(q[0]), fabs(q[1])) <= enough) return OK;
        if (k == CAP) break;
        const double a = dP.m[0][0], b = dP.m[1][1];
        const double c = material2_dpk1(material, F, dw).m[1][1];
        if (!(a > 0.0) || !(a * c > b * b)) return NOT_SPD; /* (a b; b c) */
        x[0] -= (c * q[0] - b * q[1]) / (a * c - b * b);    /* Cramer's rule */
        x[1] -= (a * q[1] - b * q[0]) / (a * c - b * b);
    }
    /* END 17d */
    return status;
}

/* The law over l, and in one F over the angle of the fibre. */
static void print_law(const struct fibre *fibre)
{
    const struct fibre passive = {MUSCLE, fibre->k, 0.0, fibre->width, 0.0};
    const struct fibre cord = {CORD, 2000.0, fibre->sigma, 0.5, 0.0};
    const mat2 F = {{{1.17, 0.23}, {-0.31, 0.88}}};
    table_begin("force_length", "l passive active T dT W cord_T");
    for (int i = 10; i <= 40; i++) { /* beside the kinks at 0.5 and 1.5 */
        const double l = i / 25.0, taut = tension(&passive, l).T;
        const struct tension t = tension(fibre, l);
        table_row(l, taut, t.T - taut, t.T, t.dT, t.W, tension(&cord, l).T);
    }
    table_end();
    table_begin("law", "angle activation l T dT T_l P11 P12 P21 P22");
    for (double angle = 0.0; angle < 2.0; angle += 0.7) {
        mat2 P, dP;
        const double g[2] = {cos(angle), sin(angle)};
        const double l = stress(fibre, g, F, F, EXACT, &P, &dP);
        const struct tension t = tension(fibre, l);
        table_row(angle, fibre->activation, l, t.T, t.dT, t.T / l, P.m[0][0],
                  P.m[0][1], P.m[1][0], P.m[1][1]);
    }
    table_end();
}

/* Each triangle's fibre in the square: angles at rest and now, l, T. */
static void print_field(const struct scene *s, const struct fibres *fibres)
{
    table_begin("field", "e angle angle_now l T");
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        double now;
        const double l = fibres_stretch(s->body, fibres, s->u, e, &now);
        table_row(e, fibres->angle[e], now, l, tension(&fibres->fibre, l).T);
    }
    table_end();
}

/* At rising activations; isometric: the tension at l = 1. */
static enum status print_strip(const struct material *material, double load,
                               struct fibre fibre)
{
    enum status status = OK;
    table_begin("strip", "activation length width isometric status");
    for (int k = 0; k <= 8 && status == OK; k++) {
        double x[2];
        fibre.activation = k / 8.0;
        status = strip(material, &fibre, load, x);
        table_row(fibre.activation, cell_if(status == OK, x[0]),
                  cell_if(status == OK, x[1]), tension(&fibre, 1.0).T,
                  status_name(status));
    }
    table_end();
    return status;
}

int main(int argc, char *argv[])
{
    int law = 1;
    double load = 0.0, bend = -45.0;
    struct fibre muscle = fibre_muscle(1.0);
    const struct option options[] = {
        {"law", .choice = &law, .choices = "log cubic", .help = "r"},
        {"activation", .real = &muscle.activation, .min = 0, .max = 1,
         .help = "of the fibres"},
        {"sigma", .real = &muscle.sigma, .min = 0, .max = 1e4, .unit = "N/m^2",
         .help = "largest active tension"},
        {"load", .real = &load, .min = -1e4, .max = 1e4, .unit = "N/m^2",
         .help = "that the strip carries"},
        {"bend", .real = &bend, .min = -90, .max = 90, .unit = "degrees/m",
         .help = "by which they turn along X1"},
    };
    options_parse("17_fibres", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    struct scene_setting set = scene_notes(GRAVITY, law ? CUBIC : LOG, 8);
    set.rho = set.force = 0.0;
    struct scene *s = scene_alloc(&set);
    double *angle = fibres_bent(s->mesh, 0.0, bend);
    const struct fibres fibres = {muscle, angle};
    const struct step_control newton = step_method("search");
    print_law(&muscle);
    const enum status status = print_strip(&s->body->material, load, muscle);
    s->body->add = add_fibres;
    s->body->added = &fibres;
    const enum status square =
        step_solve(s->body, &newton, at_rest(s->f), s->u).status;
    print_field(s, &fibres);
    history_nodes(s, "f", s->f);
    if (status != OK || square != OK)
        die("strip: %s, square: %s", status_name(status), status_name(square));
    free(angle);
    scene_free(s);
    return table_finish();
}
