/*
 * 16_invertible.c - five laws that exist for every F, inside out too, and a
 * triangle that is crushed and let go.
 *
 * Notes: Lecture 3 (a title and two references) and Figure 5.
 *
 * Problem.  With F = U diag(s1, s2) V^T [eq:signed-svd] the stress of an
 * isotropic law is P = U diag(P^1, P^2) V^T [eq:pk1-principal].  What may P^ be
 * where s2 <= 0 and the log law has no value?
 *
 *     P^2 |         __..--       cubic     r = s - s^2/2 + s^3/3, as it is
 *       0 +-----+--''------ s2   stress    log law; its P^ goes on straight
 *         |   .'1                energy    the same, but with an energy
 *         | ./  below eps the    extended  log law; G(J) goes on as a parabola
 *         |/    log law is left  stable    G(J) a parabola everywhere
 *
 * Run       make lesson-16; make lesson-16 ARGS=-h lists its options
 * PREDICT 1 how many of the five laws push a crushed point apart: ...
 * PREDICT 3 `stable` is off the log law at s2 = 1.1, --s1 1, by (%): ...
 * Plot: principal s2 P2 key=law
 */
#include "plane/circuit.h"
#include "material/modes.h"
#include "base/options.h"
#include "plane/release.h"
#include "plane/step.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

enum form { BY_CUBIC, BY_STRESS, BY_ENERGY, BY_J, BY_STABLE, N_FORM };
static const char *const form_name[N_FORM] = {"cubic", "stress", "energy",
                                              "extended", "stable"};

/* A law of the table: its form, mu and lambda, and eps, below which `stress`
 * and `energy` leave the log law in s1 and s2, and `extended` in J. */
struct principal_law {
    enum form form;
    double mu, lambda, eps;
};

/* P^(s) = P^(c) + A (s - c) with ci = max(si, eps) and the log law's P^(c);
 * for `stress` A is its derivative dP^/ds at c; for `energy` the same, but with
 * 2 mu + lambda on the diagonal [eq:principal-extended]. */
static void principal_extended(const struct principal_law *law,
                               const double s[2], double P[2])
{
    const double mu = law->mu, lambda = law->lambda;
    /* SLOT 16a(law, mu, lambda, s, P): P[0] and P[1]. */
    /* c: the nearest point with s1, s2 >= eps; from there, straight on */
    const double c[2] = {fmax(s[0], law->eps), fmax(s[1], law->eps)};
    const double pull = lambda * log(c[0] * c[1]) - mu;
    for (int i = 0; i < 2; i++) {
        /* dP^i/ds_i; `pull` has the other c in it too, so that for `stress`
         * dP^1/ds2 and dP^2/ds1 differ: no energy has these two. */
        const double own = law->form == BY_ENERGY
                               ? 2.0 * mu + lambda
                               : mu + (lambda - pull) / (c[i] * c[i]);
        P[i] = mu * c[i] + pull / c[i] + own * (s[i] - c[i]) +
               lambda / (c[0] * c[1]) * (s[1 - i] - c[1 - i]);
    }
    /* END 16a */
}

/* Given J, return G, G', G'' of psi = mu/2 (F:F - 2) + G(J): the log law's
 * G = -mu ln J + lambda/2 (ln J)^2 for J >= eps; below it the polynomial of
 * second order with the same G, G', G'' at eps [eq:g-extended]. */
static void extended(const struct principal_law *law, double J, double G[3])
{
    /* SLOT 16b(law, J, G): J is 0 or negative as well. */
    const double at = fmax(J, law->eps), r = log(at), t = J - at;
    const double slope = law->lambda * r - law->mu; /* dG/dr */
    /* dr/dJ = 1 / J: G' = G_r / J, G'' = (G_rr - G_r) / J^2, G_rr = lambda */
    G[2] = (law->lambda - slope) / (at * at);
    /* Taylor's series at eps; above it t = 0, and these are the log law's. */
    G[1] = slope / at + G[2] * t;
    G[0] = -law->mu * r + 0.5 * law->lambda * r * r + slope / at * t +
           0.5 * G[2] * t * t;
    /* END 16b */
}

/* P^; for a law of G(J) it is P^i = mu si + G'(J) sk, k the other one. */
static void principal(const struct principal_law *law, const double s[2],
                      double P[2])
{
    const enum law same = law->form == BY_CUBIC ? CUBIC : STABLE;
    const struct material material = {same, law->mu, law->lambda};
    double G[3] = {0.0, material_volume(&material, s[0] * s[1]).dG, 0.0};
    if (law->form == BY_J) extended(law, s[0] * s[1], G);
    for (int i = 0; i < 2; i++) P[i] = law->mu * s[i] + G[1] * s[1 - i];
    if (law->form == BY_STRESS || law->form == BY_ENERGY)
        principal_extended(law, s, P);
}

/* Given F, return P = U diag(P^1, P^2) V^T [eq:pk1-principal]. */
static mat2 stress(const struct principal_law *law, mat2 F)
{
    mat2 P = F;
    /* SLOT 16c(law, F, &P, principal): modes_svd(F) of modes.h gives U, V, s1
     * and s2; mat2_transpose(). */
    const struct svd svd = modes_svd(F);
    /* The singular vectors of P are those of F; only the s change. */
    const double s[2] = {svd.s1, svd.s2};
    double hat[2];
    principal(law, s, hat);
    const mat2 D = {{{hat[0], 0.0}, {0.0, hat[1]}}};
    P = mat2_multiply(svd.U, mat2_multiply(D, mat2_transpose(svd.V)));
    /* END 16c */
    return P;
}

/*
 * Given u, let it go downhill on Psi(u) to where the body rests [alg:release].
 *
 *     K du = -q, K projected and shifted; u += du, or less by step_search()
 *
 * until max|q| <= small at the free vertices, with at most CAP systems.  Then K
 * as it is, shifted: if it is not positive definite, the status is SADDLE.  New
 * since 13d are the two changes of K, the search, and this test at the end.
 * recovered: OK, every J > 0, and |Psi| <= RELEASE_ENERGY.
 */
enum { CAP = 300 };
static struct release_report release(struct body *body, double u[])
{
    const double small = RELEASE_TOLERANCE * material_modulus(&body->material);
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    double *q = allocate(n_dof, sizeof *q);
    double *du = allocate(n_dof, sizeof *du);
    struct release_report report = {.status = MAX_ITERATIONS};
    /* SLOT 16d(body, u, small, q, du, &report): body_assemble(body,
     * at_rest(NULL), u, PROJECTED or EXACT, q); release_shift(),
     * matrix_factor() for body->K; body_max_free(), _increment(), _energy(),
     * _min_J(). */
    for (;;) {
        report.status = body_assemble(body, at_rest(NULL), u, PROJECTED, q);
        if (report.status != OK || body_max_free(body, q) <= small) break;
        report.status = MAX_ITERATIONS;
        if (report.iterations == CAP) break;
        /* Projected: no eigenvalue is negative.  Shifted: none is 0 either, as
         * it would be for a body that can still turn. */
        release_shift(body);
        report.status = body_increment(body, body->K, q, du);
        if (report.status == OK)
            report.status = step_search(body, at_rest(NULL), q, du, u);
        if (report.status != OK) break;
        report.iterations++;
    }
    if (report.status == OK) {
        body_assemble(body, at_rest(NULL), u, EXACT, q);
        release_shift(body);
        /* At rest on a minimum, or on a saddle? */
        if (matrix_factor(body->K) != OK) report.status = SADDLE;
    }
    body_energy(body, u, &report.energy);
    report.min_J = body_min_J(body, u);
    report.recovered = report.status == OK && report.min_J > 0.0 &&
                       fabs(report.energy) <= RELEASE_ENERGY;
    /* END 16d */
    free(du);
    free(q);
    return report;
}

/* P^ at s, for circuit_work() and the first table. */
static void diagonal(const double s[2], void *law, double out[2])
{
    const mat2 P = stress(law, (mat2){{{s[0], 0.0}, {0.0, s[1]}}});
    out[0] = P.m[0][0];
    out[1] = P.m[1][1];
}

/* Every law, s2 from low to high; log: P2, if s2 > 0. */
static void print_principal(const char *table, struct principal_law law[],
                            const struct material *log, double s1, double low,
                            double high)
{
    table_begin(table, "law s1 s2 P1 P2 log");
    for (int k = 0; k < N_FORM; k++)
        for (int i = 0; i <= 100; i++) {
            const double s[2] = {s1, low + 0.01 * (high - low) * i};
            const mat2 F = {{{s[0], 0.0}, {0.0, fmax(s[1], 1e-9)}}};
            double P[2];
            diagonal(s, &law[k], P);
            table_row(form_name[k], s[0], s[1], P[0], P[1],
                      cell_if(s[1] > 1e-9, material2_pk1(log, F).m[1][1]));
        }
    table_end();
}

/* One triangle, its vertex 0 held. */
static void print_single(const struct mesh *mesh, enum law law, double nu)
{
    struct body *body = body_alloc(mesh, material_make(law, 1000.0, nu), 0.0,
                                   CONSISTENT, (const int[]){1, 0, 0});
    for (int k = 0; k < N_CRUSHED; k++) {
        double u[6] = {0.0};
        release_place(body, RELEASE_CRUSHED[k].F, u);
        const struct release_report report = release(body, u);
        table_row(RELEASE_CRUSHED[k].name, material_law(law),
                  status_name(report.status), report.iterations, report.energy,
                  report.min_J, report.recovered ? "yes" : "no");
    }
    body_free(body);
}

int main(int argc, char *argv[])
{
    double nu = 0.3, eps = 0.25, s1 = 1.25;
    const struct option options[] = {
        {"s1", .real = &s1, .min = 0.01, .max = 10, .help = "of `principal`"},
        {"eps", .real = &eps, .min = 0.15, .max = 0.99,
         .help = "where the log law is left", .why = "the loop lies below it"},
        {"nu", .real = &nu, .min = 0, .max = 0.49, .help = "Poisson's ratio"},
    };
    options_parse("16_invertible", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    const struct material m = material_make(LOG, 1000.0, nu);
    static const double loop[] = {1.0, -0.5, 1.5, -0.5, 1.5, 0.1, 1.0, 0.1};
    struct principal_law law[N_FORM];
    for (int k = 0; k < N_FORM; k++)
        law[k] = (struct principal_law){(enum form)k, m.mu, m.lambda, eps};

    print_principal("principal", law, &m, s1, -1.0, 1.5);
    print_principal("near_rest", law, &m, 1.0, 0.6, 1.4);
    table_begin("loop", "law work");
    for (int k = 0; k < N_FORM; k++)
        table_row(form_name[k], circuit_work(diagonal, &law[k], 4, loop));
    table_end();
    table_begin("single", "start law status iterations energy min_J recovered");
    struct mesh *triangle =
        mesh_triangle((const double[]){0.0, 0.0, 1.0, 0.1, 0.3, 0.9});
    print_single(triangle, CUBIC, nu);
    print_single(triangle, EXTENDED, nu);
    print_single(triangle, STABLE, nu);
    mesh_free(triangle);
    table_end();
    return table_finish();
}
