/*
 * 15_definiteness.c - the four modes of dP/dF, the projection of what is
 * negative among them, and a column that is pressed until it buckles.
 *
 * Notes: Lecture 3, of which they give the title and two references only.
 * Problem.  psi = mu/2 (F:F - 2) + G(J).  With F = U S V^T [eq:signed-svd]
 * dP/dF has four modes U E V^T [eq:modes], E being
 *
 *     MODE_TWIST       MODE_FLIP        MODE_LOW and MODE_HIGH
 *     | 0 -1 |         | 0  1 |         | e1  0 |
 *     | 1  0 |/sqrt 2  | 1  0 |/sqrt 2  |  0 e2 |, e1^2 + e2^2 = 1
 *
 * A negative factor may turn Newton's direction uphill.  The body: a column
 * (-1, 1) x (-0.1, 0.1), its ends held and moved inwards by e; statics, in the
 * terms of body.h dt = 1 and rho = 0, q = dPsi/du.
 *
 * Run       make lesson-15; make lesson-15 ARGS=-h lists its options
 * PREDICT 1 J below which a pressed element of the cubic law is indefinite: ...
 * PREDICT 3 deflection of the middle of the pushed column, e = 0.05 (m): ...
 * Plot: where s least
 */
#include "material/modes.h"
#include "base/options.h"
#include "plane/history.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

/* Given F = U diag(s1, s2) V^T, return U and V, rotations, and s1 >= |s2|;
 * any of them where there are many. */
static struct svd signed_svd(mat2 F)
{
    struct svd svd = {.U = mat2_identity(), .V = mat2_identity()};
    /* SLOT 15a(F, &svd): U, V, s1, s2 of svd, in closed form, without a
     * division; mat2_rotation(); atan2(0, 0) is 0. */
    /* p = (s1 + s2) (cos, sin)(minus), q = (s1 - s2) (cos, sin)(plus) for the
     * turns of U by (plus + minus) / 2 and of V by (plus - minus) / 2. */
    const double p[2] = {F.m[0][0] + F.m[1][1], F.m[1][0] - F.m[0][1]};
    const double q[2] = {F.m[0][0] - F.m[1][1], F.m[1][0] + F.m[0][1]};
    const double minus = atan2(p[1], p[0]), plus = atan2(q[1], q[0]);
    svd.U = mat2_rotation(0.5 * (plus + minus));
    svd.V = mat2_rotation(0.5 * (plus - minus));
    svd.s1 = 0.5 * (hypot(p[0], p[1]) + hypot(q[0], q[1]));
    svd.s2 = 0.5 * (hypot(p[0], p[1]) - hypot(q[0], q[1]));
    /* END 15a */
    return svd;
}

/* Given s1, s2, return in value[] the factors MODE_TWIST, MODE_FLIP, MODE_LOW
 * <= MODE_HIGH [eq:modes]; the material must be defined at J. */
static void eigenvalues(const struct material *material, double s1, double s2,
                        double value[4])
{
    const double mu = material->mu, J = s1 * s2;
    const struct volume G = material_volume(material, J); /* G.dG, G.ddG */
    /* SLOT 15b(mu, J, G, s1, s2, value): s1 = s2 and s1 = -s2 as well. */
    /* (a b; b c), psi's Hessian in s1 and s2, has the modes LOW and HIGH. */
    const double a = mu + G.ddG * s2 * s2, c = mu + G.ddG * s1 * s1;
    const double b = G.ddG * J + G.dG, root = hypot(0.5 * (a - c), b);
    value[MODE_TWIST] = mu + G.dG; /* (P^1 + P^2) / (s1 + s2) */
    value[MODE_FLIP] = mu - G.dG;  /* (P^1 - P^2) / (s1 - s2) */
    value[MODE_LOW] = 0.5 * (a + c) - root;
    value[MODE_HIGH] = 0.5 * (a + c) + root;
    /* END 15b */
}

/* Given dF, return dP, mode by mode, no factor below floor [eq:projection];
 * with floor = -INFINITY it is material2_dpk1(). */
static mat2 projected_dpk1(const struct material *material, mat2 F,
                           double floor, mat2 dF)
{
    const struct svd svd = signed_svd(F);
    const double s1 = svd.s1, s2 = svd.s2;
    const struct volume G = material_volume(material, s1 * s2);
    double value[4];
    mat2 dP = {0};
    eigenvalues(material, s1, s2, value);
    /* SLOT 15c(svd, s1, s2, G, value, floor, dF, &dP): (e1, e2) is
     * (cos z, sin z) in MODE_HIGH, (-sin z, cos z) in MODE_LOW. */
    /* 2 z is the angle of (a - c, 2 b) of 15b. */
    const double z = 0.5 * atan2(2.0 * (G.ddG * s1 * s2 + G.dG),
                                 G.ddG * (s2 * s2 - s1 * s1));
    const double half = sqrt(0.5);
    const mat2 E[] = {{{{0.0, -half}, {half, 0.0}}},
                      {{{0.0, half}, {half, 0.0}}},
                      {{{-sin(z), 0.0}, {0.0, cos(z)}}},
                      {{{cos(z), 0.0}, {0.0, sin(z)}}}};
    const mat2 turned = mat2_multiply(mat2_transpose(svd.U),
                                      mat2_multiply(dF, svd.V));
    /* dP = U (sum of value (E : U^T dF V) E) V^T */
    mat2 sum = {0};
    for (int m = MODE_TWIST; m <= MODE_HIGH; m++) {
        const double factor = fmax(value[m], floor) * mat2_dot(E[m], turned);
        sum = mat2_add(sum, mat2_scale(factor, E[m]));
    }
    dP = mat2_multiply(svd.U, mat2_multiply(sum, mat2_transpose(svd.V)));
    /* END 15c */
    return dP;
}

/* Given u, return q and du [eq:newton]: K du = -q at the free unknowns, du = 0
 * at the held ones.  NEVER solves with K as it is, whatever it is; ALWAYS with
 * projected elements; ON_DEMAND with these only where K as it is cannot be
 * factored [alg:on-demand].  *definite: can it?  Not OK: du means nothing. */
static enum status direction(struct body *body, enum projection projection,
                             const double u[], double q[], double du[],
                             int *definite)
{
    enum status status = OK;
    double *b = allocate((size_t)body->n_equation, sizeof *b);
    /* SLOT 15d(body, projection, u, q, du, definite, b, &status): q and body->K
     * by body_assemble(body, at_rest(NULL), u, EXACT or PROJECTED, q), b[] by
     * body_gather().  matrix_factor() overwrites K with what matrix_solve()
     * needs; matrix_solve_indefinite(K, b, NULL) needs K itself. */
    status = body_assemble(body, at_rest(NULL), u, EXACT, q);
    *definite = status == OK && matrix_factor(body->K) == OK;
    /* Only K as it is can tell whether it is definite; the attempt to factor
     * it has overwritten it. */
    const int project = projection == ALWAYS ||
                        (projection == ON_DEMAND && !*definite);
    if (status == OK && (project || !*definite))
        status = body_assemble(body, at_rest(NULL), u,
                               project ? PROJECTED : EXACT, q);
    if (status == OK && project) status = matrix_factor(body->K);
    body_gather(body, q, b);
    for (int k = 0; k < body->n_equation; k++) b[k] = -b[k];
    if (status == OK && (project || *definite))
        matrix_solve(body->K, b);
    else if (status == OK)
        status = matrix_solve_indefinite(body->K, b, NULL);
    body_scatter(body, b, du);
    /* END 15d */
    free(b);
    return status;
}

static const struct {
    const char *name;
    mat2 F;
} states[] = {
    {"generic", {{{1.17, 0.23}, {-0.31, 0.88}}}},
    {"pressed", {{{0.61, 0.17}, {-0.09, 0.83}}}},
    {"stretched", {{{2.31, 0.19}, {-0.27, 1.43}}}},
    {"rest", {{{1.0, 0.0}, {0.0, 1.0}}}},
    {"mirrored", {{{0.6, 0.8}, {0.8, -0.6}}}},
    {"point", {{{0.0, 0.0}, {0.0, 0.0}}}},
};

/* The factors, where the material is defined, and the projected dP for dF; the
 * least factor of F = diag(1, s). */
static void print_modes(const struct material *material)
{
    const mat2 dF = {{{0.0, 1.0}, {0.3, 0.1}}};
    double v[4];
    table_begin("modes",
                "state J s1 s2 twist flip low high dP11 dP12 dP21 dP22");
    for (int k = 0; k < COUNT(states); k++) {
        const mat2 F = states[k].F;
        const struct svd svd = signed_svd(F);
        if (!material_defined(material, mat2_det(F))) continue;
        eigenvalues(material, svd.s1, svd.s2, v);
        const mat2 dP = projected_dpk1(material, F, 0.0, dF);
        table_row(states[k].name, mat2_det(F), svd.s1, svd.s2, v[MODE_TWIST],
                  v[MODE_FLIP], v[MODE_LOW], v[MODE_HIGH], dP.m[0][0],
                  dP.m[0][1], dP.m[1][0], dP.m[1][1]);
    }
    table_end();
    table_begin("where", "s least");
    for (double s = 0.25; s <= 3.0; s += 0.25) {
        eigenvalues(material, fmax(s, 1.0), fmin(s, 1.0), v);
        table_row(s, fmin(fmin(v[MODE_TWIST], v[MODE_FLIP]), v[MODE_LOW]));
    }
    table_end();
}

/* du.q of the three directions, downhill is negative: pulled, pressed a little,
 * and half-way to the buckled column, after 12 systems of ON_DEMAND. */
static void print_descent(struct scene *s, double e, double *q, double *du)
{
    const char *const state[] = {"pulled", "pressed", "half-way"};
    const double load[] = {-e, 0.4 * e, e};
    struct step_control control = step_method("demand+search");
    control.max_iterations = 12;
    table_begin("descent", "state definite never demand always");
    for (int k = 0, definite = 0; k < 3; k++) {
        double d[3] = {0.0, 0.0, 0.0};
        scene_rest(s);
        scene_press(s, load[k], 1e-3);
        if (k == 2) step_solve(s->body, &control, at_rest(NULL), s->u);
        for (int m = NEVER; m <= ALWAYS; m++) {
            direction(s->body, (enum projection)m, s->u, q, du, &definite);
            for (int r = 0; r < s->n_dof; r++) d[m] += q[r] * du[r];
        }
        table_row(state[k], definite ? "yes" : "no", d[0], d[1], d[2]);
    }
    table_end();
}

/* Each method, without a push and with one: u2 of the middle (m); is K positive
 * definite before, and where Newton's method ends [alg:certify]? */
static void print_column(struct scene *s, double e, double *q, double *du)
{
    const char *const method[] = {"notes", "demand+search", "always+search"};
    table_begin("column",
                "load method push systems deflection energy start end status");
    for (int m = NEVER, start = 0, end = 0; m <= ALWAYS; m++)
        for (double push = 0.0; push <= 1e-3; push += 1e-3) {
            scene_rest(s);
            scene_press(s, e, push);
            direction(s->body, (enum projection)m, s->u, q, du, &start);
            scene_rest(s);
            const struct step_report report = scene_walk(s, method[m], e, push);
            direction(s->body, (enum projection)m, s->u, q, du, &end);
            const double energy = scene_energy(s);
            table_row(e, method[m], push, report.iterations,
                      fabs(*scene_middle(s)),
                      cell_if(isfinite(energy), energy), start ? "yes" : "no",
                      end ? "yes" : "no", status_name(report.status));
        }
    table_end();
}

int main(int argc, char *argv[])
{
    int law = 1, half = 2;
    double e = 0.05;
    const struct option options[] = {
        {"law", .choice = &law, .choices = "log cubic", .help = "r"},
        {"half", .integer = &half, .min = 1, .max = 8, .help = "cells, axis to "
                                                              "side"},
        {"e", .real = &e, .min = 1e-4, .max = 0.2, .unit = "m",
         .help = "how far each end moves inwards"},
    };
    options_parse("15_definiteness", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    const struct material material = material_notes(law ? CUBIC : LOG);
    print_modes(&material);
    const struct scene_setting set = scene_column(material.law, 20 * half, e);
    struct scene *s = scene_alloc(&set);
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    double *du = allocate((size_t)s->n_dof, sizeof *du);
    print_descent(s, e, q, du);
    print_column(s, e, q, du);
    history_nodes(s, "f", s->f);
    free(du);
    free(q);
    scene_free(s);
    return table_finish();
}
