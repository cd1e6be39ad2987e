/*
 * 16_invertible.c - what laws satisfy that exist for every F.
 *
 * Arguments: slot, argument: varied by
 *   16a  law       below_eps_it_goes_on_straight (forms, eps), numbers_are_the_
 *                  oracles (mu, lambda)
 *        s         above_eps_it_is_the_log_law, below_eps_it_goes_on_straight
 *                  (one, the other or both below eps; negative)
 *   16b  law       volume_is_that_of_common (eps), numbers_are_the_oracles
 *        J         volume_is_the_logs_above_eps, volume_is_a_parabola_below_eps
 *                  (0, negative)
 *   16c  law       stress_turns_with_the_body (all forms)
 *        F         stress_is_the_materials (upright, inside out, rank one),
 *                  a_point_feels_no_force
 *   16d  body      a_crushed_triangle_recovers, a_held_square_recovers (laws,
 *                  meshes, what is held), failures_are_named (log law, a
 *                  modulus below 0), it_stops_where_the_forces_are_small (E)
 *        u         crushed, a point, scrambled, wound, inside out, NaN,
 *                  almost at rest
 */
#include "program.h"

#include "judge.h"

#include "../oracle/16_invertible.h"

#include <gsl/gsl_math.h>
#include <string.h>

#define ROUND_OFF 1e-12 /* sums of a few products, relative to their size */
#define DERIVATIVE 1e-7 /* central differences with a step of 1e-4 */

/* A material of high entropy. */
static struct principal_law odd(enum form form, double eps)
{
    const struct material m = material_make(LOG, 371.4, 0.2385);
    return (struct principal_law){form, m.mu, m.lambda, eps};
}

static struct material like(const struct principal_law *law, enum law of)
{
    return (struct material){of, law->mu, law->lambda};
}

static struct principal_law notes(enum form form, double eps)
{
    const struct material m = material_notes(LOG);
    return (struct principal_law){form, m.mu, m.lambda, eps};
}

static double modulus_of(const struct principal_law *law)
{
    return 2.0 * law->mu + law->lambda;
}

/* P^ of `stress` or `energy` at (s1, s2), guarded. */
static void hat(const struct principal_law *law, double s1, double s2,
                double P[2])
{
    double *s = guarded_copy(2, (const double[]){s1, s2});
    double *out = guarded_alloc(2);
    principal_extended(law, s, out);
    memcpy(P, out, 2 * sizeof *P);
}

static void log_hat(const struct principal_law *law, double s1, double s2,
                    double P[2])
{
    const struct material m = like(law, LOG);
    const mat2 A = material2_pk1(&m, (mat2){{{s1, 0.0}, {0.0, s2}}});
    P[0] = A.m[0][0];
    P[1] = A.m[1][1];
}

/* ---- 16a ----------------------------------------------------------------- */

static void above_eps_it_is_the_log_law(void)
{
    const double s[][2] = {{1.0, 1.0}, {1.2385, 0.2001}, {0.2613, 0.3714},
                           {0.22, 2.385}};
    for (int form = BY_STRESS; form <= BY_ENERGY; form++)
        for (int k = 0; k < COUNT(s); k++) {
            const struct principal_law law = odd((enum form)form, 0.2);
            double got[2], want[2];
            hat(&law, s[k][0], s[k][1], got);
            log_hat(&law, s[k][0], s[k][1], want);
            for (int i = 0; i < 2; i++)
                expect_close(got[i], want[i], ROUND_OFF, 10.0 * law.mu,
                             "`%s`, eps = 0.2: P^%d at (%g, %g), where the log "
                             "law is to be kept", form_name[form], i + 1,
                             s[k][0], s[k][1]);
        }
}

/* Below eps P^ of `stress` is P^(c) + A (s - c), A by differences of the log
 * law; of `energy` with 2 mu + lambda on the diagonal. */
static void below_eps_it_goes_on_straight(void)
{
    const double s[][2] = {{1.1371, -0.4}, {1.1371, 0.1}, {0.1, 0.7385},
                           {2.385, 0.19}, {0.1371, -0.0613}};
    const double h = 1e-4;
    for (int form = BY_STRESS; form <= BY_ENERGY; form++)
        for (int k = 0; k < COUNT(s); k++) {
            const double eps = k % 2 ? 0.31 : 0.2;
            const struct principal_law law = odd((enum form)form, eps);
            const double c[2] = {fmax(s[k][0], eps), fmax(s[k][1], eps)};
            double got[2], want[2], plus[2], minus[2];
            hat(&law, s[k][0], s[k][1], got);
            log_hat(&law, c[0], c[1], want);
            for (int j = 0; j < 2; j++) {
                log_hat(&law, c[0] + (j ? 0.0 : h), c[1] + (j ? h : 0.0), plus);
                log_hat(&law, c[0] - (j ? 0.0 : h), c[1] - (j ? h : 0.0),
                        minus);
                for (int i = 0; i < 2; i++) {
                    double A = (plus[i] - minus[i]) / (2.0 * h);
                    if (i == j && form == BY_ENERGY) A = modulus_of(&law);
                    want[i] += A * (s[k][j] - c[j]);
                }
            }
            /* h^2/6 of the third derivative, 6 lambda ln(..) / s^4 */
            for (int i = 0; i < 2; i++)
                expect_close(got[i], want[i], 1e-5, 20.0 * modulus_of(&law),
                             "`%s`, eps = %g: P^%d at (%g, %g), against the "
                             "log law at (%g, %g) and its derivatives there",
                             form_name[form], eps, i + 1, s[k][0], s[k][1],
                             c[0], c[1]);
        }
}

/* dP^1/ds2 = dP^2/ds1 is what it takes; `stress` fails it. */
static void only_one_of_them_has_an_energy(void)
{
    const double h = 1e-4;
    for (int form = BY_STRESS; form <= BY_ENERGY; form++) {
        const struct principal_law law = odd((enum form)form, 0.2);
        double plus[2], minus[2], across, along;
        hat(&law, 1.1371, -0.3 + h, plus);
        hat(&law, 1.1371, -0.3 - h, minus);
        across = (plus[0] - minus[0]) / (2.0 * h);
        hat(&law, 1.1371 + h, -0.3, plus);
        hat(&law, 1.1371 - h, -0.3, minus);
        along = (plus[1] - minus[1]) / (2.0 * h);
        if (form == BY_ENERGY)
            expect_close(across, along, DERIVATIVE, modulus_of(&law),
                         "`energy` at (1.1371, -0.3): dP^1/ds2 against "
                         "dP^2/ds1, which are equal if P^ has an energy");
        else
            expect(fabs(across - along) > modulus_of(&law),
                   "`stress` at (1.1371, -0.3): dP^1/ds2 and dP^2/ds1 are %g "
                   "and %g; the slope of P^2 has to follow s1", across, along);
    }
}

/* ---- 16b ----------------------------------------------------------------- */

static void volume_at(const struct principal_law *law, double J, double G[3])
{
    double *out = guarded_alloc(3);
    extended(law, J, out);
    memcpy(G, out, 3 * sizeof *G);
}

static void volume_is_the_logs_above_eps(void)
{
    const struct principal_law law = odd(BY_J, 0.2);
    const double J[] = {0.2001, 0.371, 1.0, 2.385};
    for (int k = 0; k < COUNT(J); k++) {
        const double r = log(J[k]), mu = law.mu, lambda = law.lambda;
        const double want[] = {-mu * r + 0.5 * lambda * r * r,
                               (lambda * r - mu) / J[k],
                               (lambda + mu - lambda * r) / (J[k] * J[k])};
        double G[3];
        volume_at(&law, J[k], G);
        for (int i = 0; i < 3; i++)
            expect_close(G[i], want[i], ROUND_OFF, 100.0 * mu,
                         "eps = 0.2: derivative %d of G at J = %g, which is "
                         "that of the log law", i, J[k]);
    }
}

/* A jump is seen at 1e-9 from eps: what is smooth moves by 1e-9 of a slope. */
static void volume_is_smooth_at_eps(void)
{
    static const char *const what[] = {"G", "G'", "G''"};
    const struct principal_law law = odd(BY_J, 0.2);
    double below[3], above[3];
    volume_at(&law, 0.2 - 1e-9, below);
    volume_at(&law, 0.2 + 1e-9, above);
    for (int i = 0; i < 3; i++)
        expect_close(below[i], above[i], 1e-6, 100.0 * law.mu,
                     "eps = 0.2: %s just below eps, against just above",
                     what[i]);
}

/* Central differences are exact for a parabola. */
static void volume_is_a_parabola_below_eps(void)
{
    const struct principal_law law = odd(BY_J, 0.2);
    const double h = 0.01, J[] = {0.1, 0.0, -0.7385, -2.0};
    for (int k = 0; k < COUNT(J); k++) {
        double at[3], plus[3], minus[3];
        volume_at(&law, J[k], at);
        volume_at(&law, J[k] + h, plus);
        volume_at(&law, J[k] - h, minus);
        expect_close((plus[0] - minus[0]) / (2.0 * h), at[1], 1e-9,
                     1e4 * law.mu, "J = %g: G' against differences of G",
                     J[k]);
        expect_close((plus[1] - minus[1]) / (2.0 * h), at[2], 1e-9,
                     1e4 * law.mu, "J = %g: G'' against differences of G'",
                     J[k]);
    }
}

static void volume_is_that_of_common(void)
{
    const struct principal_law law = odd(BY_J, EXTENDED_BELOW);
    const struct material m = like(&law, EXTENDED);
    const double J[] = {1.238, 0.2501, 0.2499, 0.0, -0.871};
    for (int k = 0; k < COUNT(J); k++) {
        const mat2 F = {{{1.0, 0.0}, {0.0, J[k]}}};
        const struct volume want = material_volume(&m, J[k]);
        double G[3];
        volume_at(&law, J[k], G);
        const double psi = 0.5 * law.mu * (J[k] * J[k] - 1.0) + G[0];
        expect_close(G[1], want.dG, ROUND_OFF, 100.0 * law.mu,
                     "J = %g: G' against EXTENDED of material.h", J[k]);
        expect_close(G[2], want.ddG, ROUND_OFF, 100.0 * law.mu,
                     "J = %g: G'' against EXTENDED of material.h", J[k]);
        expect_close(psi, material2_psi(&m, F), ROUND_OFF, 100.0 * law.mu,
                     "J = %g: psi against EXTENDED of material.h", J[k]);
    }
}

/* ---- 16c ----------------------------------------------------------------- */

/* Upright, inside out, rank one. */
static const mat2 general[] = {{{{1.1371, 0.2385}, {-0.3714, 0.8613}}},
                               {{{0.3714, 0.7385}, {0.9613, -0.2731}}},
                               {{{-0.8731, 0.1371}, {0.0613, 0.1238}}},
                               {{{0.64, 0.48}, {0.48, 0.36}}}};

static void expect_same(mat2 got, mat2 want, double size, const char *what,
                        int form, int state)
{
    for (int r = 0; r < 4; r++)
        expect_close(got.m[r / 2][r % 2], want.m[r / 2][r % 2], 1e-11, size,
                     "`%s`, F number %d (J = %.3f): P%d%d %s", form_name[form],
                     state, mat2_det(general[state]), r / 2 + 1, r % 2 + 1,
                     what);
}

/* P = mu F + G' cof F needs no singular values. */
static void stress_is_the_materials(void)
{
    const enum form form[] = {BY_CUBIC, BY_STABLE, BY_J};
    const enum law same[] = {CUBIC, STABLE, EXTENDED};
    for (int k = 0; k < 3; k++)
        for (int f = 0; f < COUNT(general); f++) {
            const struct principal_law law = odd(form[k], EXTENDED_BELOW);
            const struct material m = like(&law, same[k]);
            expect_same(stress(&law, general[f]),
                        material2_pk1(&m, general[f]), 100.0 * law.mu,
                        "against material.h", (int)form[k], f);
        }
}

static void stress_turns_with_the_body(void)
{
    const mat2 Q = mat2_rotation(1.2385), R = mat2_rotation(-0.7371);
    for (int form = 0; form < N_FORM; form++)
        for (int f = 0; f < COUNT(general); f++) {
            const struct principal_law law = odd((enum form)form, 0.2);
            const mat2 P = stress(&law, general[f]);
            expect_same(stress(&law, mat2_multiply(Q, general[f])),
                        mat2_multiply(Q, P), 100.0 * law.mu,
                        "of Q F, against Q P(F)", form, f);
            expect_same(stress(&law, mat2_multiply(general[f], R)),
                        mat2_multiply(P, R), 100.0 * law.mu,
                        "of F Q, against P(F) Q", form, f);
        }
}

/* -I is a rotation, so P(-F) = -P(F), and P(0) = 0 where P is continuous. */
static void a_point_feels_no_force(void)
{
    const enum form form[] = {BY_CUBIC, BY_J, BY_STABLE};
    const mat2 zero = {{{0.0, 0.0}, {0.0, 0.0}}};
    for (int k = 0; k < 3; k++) {
        const struct principal_law law = odd(form[k], 0.2);
        const mat2 P = stress(&law, zero);
        expect_close(mat2_norm(P), 0.0, ROUND_OFF, law.mu,
                     "`%s`: |P| at F = 0", form_name[form[k]]);
    }
}

/* ---- 16d ----------------------------------------------------------------- */

/* A triangle or the square of n cells per side, whose boundary is held, or
 * vertex 0 alone, or nothing. */
enum held { BOUNDARY, CORNER, NOTHING };
static struct body *body_of(struct mesh *mesh, enum law law, enum held which)
{
    int held[25] = {0};
    const int n = mesh->n;
    for (int a = 0; a < mesh->n_vertex; a++) {
        const int i = a % (n + 1), j = a / (n + 1);
        held[a] = (which == CORNER && a == 0) ||
                  (which == BOUNDARY &&
                   (i == 0 || i == n || j == 0 || j == mesh->rows));
    }
    return body_alloc(mesh, material_notes(law), 0.0, CONSISTENT, held);
}

static const double corners[6] = {0.0, 0.0, 1.0, 0.1, 0.3, 0.9};
static const enum law smooth[] = {CUBIC, EXTENDED, STABLE};

static void expect_recovered(const struct body *body,
                             const struct release_report *report,
                             const double u[], const char *what)
{
    const char *law = material_law(body->material.law);
    double q[50], energy;
    expect(report->status == OK, "%s, %s law: %s after %d iterations", what,
           law, status_name(report->status), report->iterations);
    expect(body_force(body, u, q) == OK && body_energy(body, u, &energy) == OK,
           "%s, %s law: u is not finite", what, law);
    expect_close(body_max_free(body, q), 0.0, 1.01 * RELEASE_TOLERANCE,
                 material_modulus(&body->material),
                 "%s, %s law: the largest force at the end", what, law);
    expect(energy <= RELEASE_ENERGY && body_min_J(body, u) > 0.0,
           "%s, %s law: it ends with the energy %g and the least J %g", what,
           law, energy, body_min_J(body, u));
    expect_close(report->energy, energy, 1e-12, 1.0, "%s, %s law: the energy "
                 "in the report", what, law);
    expect_close(report->min_J, body_min_J(body, u), 1e-12, 1.0,
                 "%s, %s law: the least J in the report", what, law);
    expect(report->recovered, "%s, %s law: it has recovered, and the report "
           "says no", what, law);
    /* 4 to 8 here; a symmetric line or a wrong tangent takes tens */
    expect(report->iterations >= 1 && report->iterations <= 30,
           "%s, %s law: %d iterations", what, law, report->iterations);
}

static void a_crushed_triangle_recovers(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    for (int l = 0; l < 3; l++)
        for (int k = 0; k + 1 < N_CRUSHED; k++) {
            struct body *body = body_of(mesh, smooth[l], CORNER);
            double u[6] = {0.0};
            release_place(body, RELEASE_CRUSHED[k].F, u);
            const struct release_report report = release(body, u);
            expect_recovered(body, &report, u, RELEASE_CRUSHED[k].name);
            body_free(body);
        }
    mesh_free(mesh);
}

static void a_point_is_not_at_rest(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    for (int l = 0; l < 3; l++) {
        struct body *body = body_of(mesh, smooth[l], CORNER);
        const char *law = material_law(smooth[l]);
        double u[6];
        for (int r = 0; r < 6; r++) u[r] = -corners[r];
        const struct release_report report = release(body, u);
        expect(report.status == SADDLE,
               "a triangle crushed to a point, %s law: the forces are 0, but K "
               "is not positive definite: SADDLE, not %s", law,
               status_name(report.status));
        expect(!report.recovered && report.iterations == 0,
               "a triangle crushed to a point, %s law: recovered says %d after "
               "%d iterations", law, report.recovered, report.iterations);
        if (smooth[l] == EXTENDED)
            expect_close(report.energy, oracle_point_extended, ROUND_OFF, 1e3,
                         "its energy");
        body_free(body);
    }
    mesh_free(mesh);
}

/* The inside of a square at random, its boundary held: there is one rest. */
static void a_held_square_recovers(void)
{
    struct mesh *mesh = mesh_square(4);
    for (int l = 0; l < 3; l++)
        for (unsigned seed = 1; seed <= 5; seed++) {
            struct body *body = body_of(mesh, smooth[l], BOUNDARY);
            double u[50] = {0.0};
            release_scramble(body, seed, u);
            const struct release_report report = release(body, u);
            expect_recovered(body, &report, u, "a square scrambled inside");
            for (int r = 0; r < 50; r++)
                expect_close(u[r], 0.0, 1e-8, 1.0,
                             "a square scrambled inside, %s law: u of vertex "
                             "%d", material_law(smooth[l]), r / 2);
            body_free(body);
        }
    mesh_free(mesh);
}

/* All J > 0, all forces 0, K positive definite, and not at rest: the boundary
 * goes twice round the middle. */
static void a_wound_square_has_not_recovered(void)
{
    struct mesh *mesh = mesh_square(2);
    struct body *body = body_of(mesh, CUBIC, NOTHING);
    double u[18] = {0.0};
    release_scramble(body, 3, u);
    const struct release_report known = release_solve(body, CAP, u);
    expect_close(known.energy, oracle_wound_cubic, 1e-9, oracle_wound_cubic,
                 "the wound square that this check needs");
    const struct release_report report = release(body, u);
    expect(report.status == OK,
           "the doubly wound square is a minimum of the energy: OK, not %s",
           status_name(report.status));
    expect(!report.recovered,
           "the doubly wound square: every J > %.2g, but its energy is %.6g; "
           "it has not recovered", report.min_J, report.energy);
    body_free(body);
    mesh_free(mesh);
}

/* So small that its energy is below RELEASE_ENERGY whatever it does: three
 * vertices of a square are held as in a mirror, and J < 0 stays. */
static void inside_out_is_not_recovered(void)
{
    const int held[4] = {1, 1, 0, 1}; /* all of triangle 0 */
    struct mesh *mesh = mesh_square(1);
    for (int r = 0; r < 8; r++) mesh->X[r] *= 1e-6;
    struct body *body =
        body_alloc(mesh, material_notes(STABLE), 0.0, CONSISTENT, held);
    double u[8] = {0.0};
    for (int r = 0; r < 8; r += 2) u[r] = -2.0 * mesh->X[r];
    const struct release_report report = release(body, u);
    expect(report.status == OK && report.energy <= RELEASE_ENERGY &&
               report.min_J < 0.0, "the small square that this check needs: "
           "%s, energy %.2g, least J %.2g", status_name(report.status),
           report.energy, report.min_J);
    expect(!report.recovered, "a small square with a triangle that is inside "
           "out, J = %.2g: it has not recovered", report.min_J);
    body_free(body);
    mesh_free(mesh);
}

/* Cubic, nu = 0.05: turned inside out, it ends swollen, with less energy than
 * at rest. */
static void swollen_is_not_recovered(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    const int held[3] = {1, 0, 0};
    struct body *body = body_alloc(mesh, material_make(CUBIC, 1e3, 0.05), 0.0,
                                   CONSISTENT, held);
    double u[6] = {0.0};
    release_place(body, RELEASE_CRUSHED[2].F, u);
    const struct release_report report = release(body, u);
    expect(!report.recovered,
           "a swollen triangle: its energy %.6g is below that of rest; it has "
           "not recovered", report.energy);
    body_free(body);
    mesh_free(mesh);
    inside_out_is_not_recovered();
}

static void failures_are_named(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    struct body *body = body_of(mesh, CUBIC, CORNER);
    double u[6] = {0.0, 0.0, (double)NAN, 0.0, 0.0, 0.0};
    const struct release_report report = release(body, u);
    expect(report.status == NONFINITE && !report.recovered,
           "a vertex at NaN: NONFINITE, not %s", status_name(report.status));
    body_free(body);

    /* straight down from a log law that is not defined */
    body = body_of(mesh, LOG, CORNER);
    for (int r = 0; r < 6; r++) u[r] = -corners[r];
    expect(release(body, u).status == INVERTED,
           "the log law at a point: INVERTED");
    body_free(body);

    /* a modulus below 0: there is no projected K that the shift could save */
    body = body_of(mesh, CUBIC, CORNER);
    body->material.mu *= -1.0;
    body->material.lambda *= -1.0;
    release_place(body, RELEASE_CRUSHED[0].F, u);
    const struct release_report soft = release(body, u);
    expect(soft.status == NOT_SPD && !soft.recovered && soft.iterations == 0,
           "a modulus below 0: the first system is NOT_SPD; the report says %s "
           "after %d", status_name(soft.status), soft.iterations);
    body_free(body);
    mesh_free(mesh);

    /* A square pressed to 0.232 of its width is about to yield sideways: its
     * exact K is almost singular, the projected one is not, and 1862 systems
     * would be needed. */
    int held[25] = {0};
    double slow[50];
    mesh = mesh_square(4);
    for (int a = 0; a < 25; a++) held[a] = a % 5 == 0 || a % 5 == 4;
    body = body_alloc(mesh, material_notes(EXTENDED), 0.0, CONSISTENT, held);
    for (int a = 0; a < 25; a++) {
        slow[2 * a] = -0.768 * mesh->X[2 * a];
        slow[2 * a + 1] = held[a] ? 0.0 : 0.05;
    }
    const struct release_report stuck = release(body, slow);
    expect(stuck.status == MAX_ITERATIONS && !stuck.recovered &&
               stuck.iterations == CAP,
           "a square pressed to 0.232 of its width: MAX_ITERATIONS after %d "
           "systems; the report says %s after %d", CAP,
           status_name(stuck.status), stuck.iterations);
    body_free(body);
    mesh_free(mesh);
}

/* The limit is that of the forces, at dt = 1: just below it nothing is solved,
 * just above it something is. */
static void it_stops_where_the_forces_are_small(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    for (int l = 0; l < 3; l++)
        for (int above = 0; above < 2; above++) {
            struct body *body = body_of(mesh, smooth[l], CORNER);
            body->material = material_make(smooth[l], 371.4, 0.2385);
            const double small = RELEASE_TOLERANCE *
                                 material_modulus(&body->material);
            const double want = small * (above ? 1.05 : 0.95);
            double u[6] = {0.0}, q[6], stretch = 1e-9;
            for (int k = 0; k < 3; k++) { /* q is almost linear in it */
                const mat2 F = {{{1.0 + stretch, 0.0}, {0.0, 1.0}}};
                release_place(body, F, u);
                expect(body_force(body, u, q) == OK, "a stretch has no force");
                stretch *= want / body_max_free(body, q);
            }
            const struct release_report report = release(body, u);
            expect(report.status == OK && report.recovered &&
                       (report.iterations > 0) == above,
                   "almost at rest, %s law: the largest force is %.3g of the "
                   "limit, and the report says %s after %d systems",
                   material_law(smooth[l]), want / small,
                   status_name(report.status), report.iterations);
            body_free(body);
        }
    mesh_free(mesh);
}

/* ---- all ----------------------------------------------------------------- */

static void expect_row(enum form form, double eps,
                       const struct oracle_principal *at, const double want[2])
{
    const struct principal_law law = notes(form, eps);
    double P[2];
    principal(&law, at->s, P);
    for (int i = 0; i < 2; i++)
        expect_close(P[i], want[i], ROUND_OFF,
                     fmax(fabs(want[0]), fabs(want[1])),
                     "`%s`, eps = %g: P^%d at (%g, %g)", form_name[form], eps,
                     i + 1, at->s[0], at->s[1]);
}

static void numbers_are_the_oracles(void)
{
    for (int k = 0; k < COUNT(oracle_principal); k++) {
        const struct oracle_principal *at = &oracle_principal[k];
        expect_row(BY_CUBIC, 0.25, at, at->cubic);
        expect_row(BY_STRESS, 0.25, at, at->stress);
        expect_row(BY_ENERGY, 0.25, at, at->energy);
        expect_row(BY_J, 0.25, at, at->extended);
        expect_row(BY_J, 0.0625, at, at->extended_16);
        expect_row(BY_STABLE, 0.25, at, at->stable);
        for (int fine = 0; fine < 2; fine++) {
            const struct principal_law law = notes(BY_J, fine ? 0.0625 : 0.25);
            const double want = fine ? at->psi_extended_16 : at->psi_extended;
            double G[3];
            volume_at(&law, at->s[0] * at->s[1], G);
            expect_close(0.5 * law.mu * (gsl_hypot(at->s[0], at->s[1]) *
                                             gsl_hypot(at->s[0], at->s[1]) -
                                         2.0) + G[0],
                         want, ROUND_OFF, fmax(want, 1e4),
                         "eps = %g: psi at (%g, %g)", law.eps, at->s[0],
                         at->s[1]);
        }
    }
    struct output *out = run("");
    for (int k = 0; k < N_FORM; k++)
        expect_close(cell(out, "loop", "work", k),
                     k == BY_STRESS ? oracle_loop_work : 0.0, 1e-10, 1e3,
                     "work once round the loop, `%s`", form_name[k]);
    for (int k = 0; k < row_count(out, "single"); k++) {
        const int point = strcmp(word(out, "single", "start", k), "point") == 0;
        expect(strcmp(word(out, "single", "status", k),
                      point ? "SADDLE" : "OK") == 0,
               "table single, row %d: status %s", k,
               word(out, "single", "status", k));
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *off = run("--s1 1");
    int push = 0, r = 0;
    for (int k = 0; k < N_FORM; k++) {
        const struct principal_law law = notes((enum form)k, 0.25);
        const mat2 P = stress(&law, (mat2){{{0.0, 0.0}, {0.0, 0.0}}});
        push += mat2_norm(P) > ROUND_OFF * law.mu;
    }
    measured("1", push);
    while (strcmp(word(off, "principal", "law", r), "stable") != 0 ||
           fabs(cell(off, "principal", "s2", r) - 1.1) > 1e-9)
        r++;
    measured("3", 100.0 * (cell(off, "principal", "P2", r) /
                               cell(off, "principal", "log", r) - 1.0));
}

static const struct claim claims[] = {
    {"above_eps_it_is_the_log_law", above_eps_it_is_the_log_law, "16a"},
    {"below_eps_it_goes_on_straight", below_eps_it_goes_on_straight, "16a"},
    {"only_one_of_them_has_an_energy", only_one_of_them_has_an_energy, "16a"},
    {"volume_is_the_logs_above_eps", volume_is_the_logs_above_eps, "16b"},
    {"volume_is_smooth_at_eps", volume_is_smooth_at_eps, "16b"},
    {"volume_is_a_parabola_below_eps", volume_is_a_parabola_below_eps, "16b"},
    {"volume_is_that_of_common", volume_is_that_of_common, "16b"},
    {"stress_is_the_materials", stress_is_the_materials, "16c"},
    {"stress_turns_with_the_body", stress_turns_with_the_body, "16c"},
    {"a_point_feels_no_force", a_point_feels_no_force, "16c"},
    {"a_crushed_triangle_recovers", a_crushed_triangle_recovers, "16d"},
    {"a_point_is_not_at_rest", a_point_is_not_at_rest, "16d"},
    {"a_held_square_recovers", a_held_square_recovers, "16d"},
    {"a_wound_square_has_not_recovered", a_wound_square_has_not_recovered,
     "16d"},
    {"swollen_is_not_recovered", swollen_is_not_recovered, "16d"},
    {"it_stops_where_the_forces_are_small",
     it_stops_where_the_forces_are_small, "16d"},
    {"failures_are_named", failures_are_named, "16d"},
    {"numbers_are_the_oracles", numbers_are_the_oracles, NULL},
};

static const char *const runs[] = {
    "",
    "--s1 0.7385 --eps 0.1731",
    "--nu 0.2385 --s1 1.6 --eps 0.4",
};

/* Where Newton's method ends is as exact as its test; how soon it ends there
 * is up to the line search. */
static const struct column_rule rules[] = {
    {"principal", "law", 0, "a word", 0},
    {"principal", "s1", 1e-14, "given", 0},
    {"principal", "s2", 1e-14, "given", 0},
    {"principal", "*", 1e-11, "sums of a few products", 0},
    {"near_rest", "law", 0, "a word", 0},
    {"near_rest", "s1", 1e-14, "given", 0},
    {"near_rest", "s2", 1e-14, "given", 0},
    {"near_rest", "*", 1e-11, "sums of a few products", 500},
    {"loop", "law", 0, "a word", 0},
    {"loop", "work", 1e-11, "Gauss's rule with 24 points", 1000},
    {"single", "start", 0, "a word", 0},
    {"single", "law", 0, "a word", 0},
    {"single", "status", 0, "a reason", 0},
    {"single", "iterations", NOT_COMPARED, "how far each step goes is not "
     "prescribed", 0},
    {"single", "energy", 1e-9, "the test of the forces", 1000},
    {"single", "min_J", 1e-6, "the test of the forces", 1},
    {"single", "recovered", 0, "a word", 0},
};

static const struct lesson lesson = {
    "16_invertible", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Three of the five laws have P(0) = 0, and must: -I is a rotation in the "
    "plane. A triangle crushed to a point is in balance, and only the "
    "factorisation at the end says that it is not at rest "
    "(figures/16_invertible/principal.svg).",
    "In slot 16a give `stress` the diagonal that `energy` has, and look at the "
    "loop; then leave the off-diagonal terms out of both. What does each of "
    "the two changes do to the work, and why?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
