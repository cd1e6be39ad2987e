/*
 * 17_fibres.c - what right fibres satisfy.
 *
 * Arguments: slot, argument: varied by
 *   17a  fibre     tension_has_its_landmarks (activation 0, 1/4, 1, both laws),
 *                  tension_is_the_slope_of_the_energy (k, sigma, width)
 *        l         both, on each limb, at and beside the kinks
 *   17b  fibre, F  tangent_is_the_slope_of_the_stress, of both laws
 *        g         stress_pulls_along_the_fibre (angles), and with it P, l
 *        dF        tangent_is_the_slope_of_the_stress (each entry)
 *        kind      eigenvalues_are_slope_and_pull (NO_TANGENT: dP is unused)
 *   17c  body, u   a skew mesh whose held vertices have moved, in every check;
 *                  the lesson's square in the runs
 *        dt        force_is_the_slope_of_the_energy (energy: 0.7371 and 1)
 *        kind      agrees_with_the_fast_fibres, no_tangent_leaves_K_alone
 *        energy, q force_is_the_slope_of_the_energy (NULL or not)
 *        fibres    agrees_with_the_fast_fibres (law, an angle per triangle)
 *   17d  material  strip_has_its_length (laws), failures_are_named (mu, lambda)
 *        fibre     strip_has_its_length (activation), strip_takes_newtons_steps
 *                  (sigma, width), failures_are_named (CORD, k)
 *        load      strip_has_its_length, failures_are_named (NaN)
 */
#include "program.h"

#include "judge.h"

#include "../oracle/17_fibres.h"

#include <gsl/gsl_math.h>
#include <string.h>

#define ROUND_OFF 1e-13  /* a handful of products */
#define SUMS 1e-12       /* sums of some hundred products */
#define DERIVATIVE 1e-8  /* central differences, the best of a sweep of steps */
#define SOLVED 1e-12     /* quadratic: beyond the tolerance 1e-13 of P */

/* ---- fibres that no formula is made for ---------------------------------- */

static const struct fibre muscle = {MUSCLE, 213.7, 371.4, 0.4238, 0.6137};
static const struct fibre cord = {CORD, 213.7, 371.4, 0.4238, 0.2385};

static const struct fibre *one_of(int law)
{
    return law == MUSCLE ? &muscle : &cord;
}

static const char *name_of(const struct fibre *fibre)
{
    return fibre->law == MUSCLE ? "MUSCLE" : "CORD";
}

/* States with l on the ascending limb, the descending one, beyond it, slack. */
static const mat2 state[] = {{{{0.82, -0.19}, {0.27, 0.93}}},
                             {{{1.17, 0.23}, {-0.31, 0.98}}},
                             {{{1.71, 0.38}, {-0.62, 1.13}}},
                             {{{0.37, 0.11}, {-0.23, 0.16}}},
                             {{{-0.61, 0.52}, {0.44, 0.79}}}};
enum { STATES = COUNT(state) };
static const double angle_of_fibre = 0.7371;

static void direction(double angle, double g[2])
{
    g[0] = cos(angle);
    g[1] = sin(angle);
}

/* Stretch and stress; dF is of no interest. */
static double stress_of(const struct fibre *fibre, double angle, mat2 F,
                        mat2 *P)
{
    double g[2];
    mat2 dP;
    direction(angle, g);
    return stress(fibre, g, F, mat2_identity(), EXACT, P, &dP);
}

static mat2 change_of(const struct fibre *fibre, double angle, mat2 F, mat2 dF,
                      enum tangent kind)
{
    double g[2];
    mat2 P, dP;
    direction(angle, g);
    stress(fibre, g, F, dF, kind, &P, &dP);
    return dP;
}

/* Entry k of a 2x2 matrix, in the order 11, 12, 21, 22. */
static mat2 unit_change(int k)
{
    mat2 E = {{{0.0, 0.0}, {0.0, 0.0}}};
    E.m[k / 2][k % 2] = 1.0;
    return E;
}

/* ---- 17a ----------------------------------------------------------------- */

static void tension_has_its_landmarks(void)
{
    for (int k = 0; k < COUNT(oracle_tension); k++) {
        const double l = oracle_tension[k].l;
        struct fibre fibre = fibre_muscle(1.0);
        const int kink = l == 0.5 || l == 1.5;
        const struct tension all = tension(&fibre, l);
        expect_close(all.T, oracle_tension[k].T, ROUND_OFF, 300.0,
                     "T at l = %g, full activation", l);
        if (!kink)
            expect_close(all.dT, oracle_tension[k].dT, ROUND_OFF, 1e4,
                         "T' at l = %g, full activation", l);
        fibre.activation = 0.0;
        expect_close(tension(&fibre, l).T, oracle_tension[k].passive, ROUND_OFF,
                     300.0, "passive T at l = %g, no activation", l);
        fibre.activation = 0.25;
        expect_close(tension(&fibre, l).T,
                     oracle_tension[k].passive +
                         0.25 * oracle_tension[k].active,
                     ROUND_OFF, 300.0, "T at l = %g, activation 1/4", l);
    }
    const double x = 0.25 / muscle.width; /* of other k, sigma and w */
    expect_close(tension(&muscle, 1.25).T,
                 muscle.k / 16.0 +
                     muscle.activation * muscle.sigma * (1.0 - x * x),
                 ROUND_OFF, 300.0, "T of a MUSCLE of k = %g, sigma = %g, w = "
                 "%g, activation %g at l = 1.25", muscle.k, muscle.sigma,
                 muscle.width, muscle.activation);
    const struct tension rest = tension(&cord, 1.0);
    const struct tension pulled = tension(&cord, 1.25);
    const double active = cord.activation * cord.sigma;
    expect_close(rest.T, active, ROUND_OFF, active, "T of a CORD at l = 1");
    expect_close(rest.dT, cord.k, ROUND_OFF, cord.k,
                 "stiffness T' of a CORD at l = 1, which is k");
    expect_close(pulled.T, active + 0.25 * cord.k, ROUND_OFF, active,
                 "T of a CORD at l = 1.25");
}

static double central(const struct fibre *fibre, double l, double h, int slope)
{
    const struct tension a = tension(fibre, l - h), b = tension(fibre, l + h);
    return (slope ? b.T - a.T : b.W - a.W) / (2.0 * h);
}

/* The difference quotient closest to `got`, of a sweep of steps. */
static double best_difference(const struct fibre *fibre, double l, int slope,
                              double got)
{
    double best = INFINITY;
    for (double h = 1e-2; h > 1e-6; h *= 0.1) {
        const double d = central(fibre, l, h, slope);
        if (fabs(d - got) < fabs(best - got)) best = d;
    }
    return best;
}

static void tension_is_the_slope_of_the_energy(void)
{
    const double l[] = {0.3371, 0.6137, 0.8714, 0.9732, 1.0371, 1.2385, 1.3714,
                        1.6137, 2.0};
    for (int law = MUSCLE; law <= CORD; law++)
        for (int k = 0; k < COUNT(l); k++) {
            const struct fibre *fibre = one_of(law);
            const struct tension t = tension(fibre, l[k]);
            expect_close(t.T, best_difference(fibre, l[k], 0, t.T), DERIVATIVE,
                         300.0, "%s, l = %g: T against the change of W",
                         name_of(fibre), l[k]);
            expect_close(t.dT, best_difference(fibre, l[k], 1, t.dT),
                         DERIVATIVE, 1e3, "%s, l = %g: T' against the change "
                         "of T", name_of(fibre), l[k]);
        }
    /* no jump of W and T at the kinks, from either side; W is 0 at l = 1 */
    const double w = muscle.width, at[] = {1.0 - w, 1.0, 1.0 + w};
    for (int k = 0; k < COUNT(at); k++)
        for (int side = -1; side <= 1; side += 2) {
            const double near = at[k] + side * 1e-9;
            const struct tension a = tension(&muscle, at[k]);
            const struct tension b = tension(&muscle, near);
            expect_close(b.W, a.W, 1e-8, 100.0, "W beside l = %.4f, on the "
                         "side %+d, against W there", at[k], side);
            expect_close(b.T, a.T, 1e-8, 300.0, "T beside l = %.4f, on the "
                         "side %+d, against T there", at[k], side);
            expect_close(b.dT, central(&muscle, at[k] + side * 1e-5, 1e-6, 1),
                         1e-4, 1e3, "T' beside l = %.4f, on the side %+d",
                         at[k], side);
        }
    for (int law = MUSCLE; law <= CORD; law++)
        expect_close(tension(one_of(law), 1.0).W, 0.0, ROUND_OFF, 100.0,
                     "%s: W at l = 1", name_of(one_of(law)));
}

/* ---- 17b ----------------------------------------------------------------- */

/* P = T n g^T, entry by entry, in a state where nothing is symmetric. */
static void stress_pulls_along_the_fibre(void)
{
    for (int k = 0; k < COUNT(oracle_law); k++) {
        const double *f = oracle_law[k].F;
        const mat2 F = {{{f[0], f[1]}, {f[2], f[3]}}};
        const struct fibre fibre = fibre_muscle(oracle_law[k].activation);
        mat2 P;
        const double l = stress_of(&fibre, oracle_law[k].angle, F, &P);
        expect_close(l, oracle_law[k].l, ROUND_OFF, 1.0, "stretch in state %d",
                     k);
        for (int i = 0; i < 4; i++)
            expect_close(P.m[i / 2][i % 2], oracle_law[k].P[i], ROUND_OFF,
                         300.0, "P%d%d in state %d", i / 2 + 1, i % 2 + 1, k);
        expect_close(tension(&fibre, l).W, oracle_law[k].psi, ROUND_OFF, 300.0,
                     "W in state %d", k);
    }
    /* across its fibres a body may be pulled as it likes */
    const mat2 across = {{{1.0, 0.0}, {0.0, 1.9}}};
    const struct fibre passive = fibre_muscle(0.0);
    mat2 P;
    stress_of(&passive, 0.0, across, &P);
    for (int i = 0; i < 4; i++)
        expect_close(P.m[i / 2][i % 2], 0.0, ROUND_OFF, 300.0, "P%d%d when "
                     "pulled across a fibre at rest", i / 2 + 1, i % 2 + 1);
}

static void a_turned_body_has_turned_stress(void)
{
    const mat2 Q = mat2_rotation(1.2385);
    for (int c = 0; c < 2 * STATES; c++) {
        const struct fibre *fibre = one_of(c % 2);
        mat2 P, turned;
        stress_of(fibre, angle_of_fibre, state[c / 2], &P);
        stress_of(fibre, angle_of_fibre, mat2_multiply(Q, state[c / 2]),
                  &turned);
        const mat2 want = mat2_multiply(Q, P);
        for (int i = 0; i < 4; i++)
            expect_close(turned.m[i / 2][i % 2], want.m[i / 2][i % 2],
                         ROUND_OFF, 300.0, "%s, state %d: P%d%d of Q F, "
                         "against Q P", name_of(fibre), c / 2, i / 2 + 1,
                         i % 2 + 1);
    }
}

static void stress_is_the_slope_of_the_energy(void)
{
    const mat2 dF = {{{0.613, -0.371}, {0.238, 0.714}}};
    for (int c = 0; c < 2 * STATES; c++) {
        const struct fibre *fibre = one_of(c % 2);
        mat2 P, unused;
        stress_of(fibre, angle_of_fibre, state[c / 2], &P);
        const double got = mat2_dot(P, dF);
        double best = INFINITY;
        for (double h = 1e-2; h > 1e-6; h *= 0.1) {
            double W[2];
            for (int s = 0; s < 2; s++)
                W[s] = tension(fibre, stress_of(fibre, angle_of_fibre,
                                                mat2_add(state[c / 2],
                                                         mat2_scale(s ? h : -h,
                                                                    dF)),
                                                &unused)).W;
            const double d = (W[1] - W[0]) / (2.0 * h);
            if (fabs(d - got) < fabs(best - got)) best = d;
        }
        expect_close(got, best, DERIVATIVE, 300.0, "%s, state %d: P : dF, "
                     "against the change of W", name_of(fibre), c / 2);
    }
}

static void tangent_is_the_slope_of_the_stress(void)
{
    for (int c = 0; c < 8 * STATES; c++) {
        const struct fibre *fibre = one_of(c % 2);
        const int entry = c / 2 % 4, k = c / 8;
        const mat2 E = unit_change(entry);
        const mat2 got = change_of(fibre, angle_of_fibre, state[k], E, EXACT);
        mat2 best = {{{INFINITY, 0.0}, {0.0, 0.0}}};
        for (double h = 1e-2; h > 1e-6; h *= 0.1) {
            mat2 P[2];
            for (int s = 0; s < 2; s++)
                stress_of(fibre, angle_of_fibre,
                          mat2_add(state[k], mat2_scale(s ? h : -h, E)), &P[s]);
            const mat2 d = mat2_scale(0.5 / h, mat2_subtract(P[1], P[0]));
            if (!(mat2_norm(mat2_subtract(d, got)) >
                  mat2_norm(mat2_subtract(best, got))))
                best = d;
        }
        for (int i = 0; i < 4; i++)
            expect_close(got.m[i / 2][i % 2], best.m[i / 2][i % 2], DERIVATIVE,
                         1e3, "%s, state %d: dP%d%d for a change of F%d%d",
                         name_of(fibre), k, i / 2 + 1, i % 2 + 1, entry / 2 + 1,
                         entry % 2 + 1);
    }
}

/* dP/dF as a symmetric 4x4 matrix for the caller to free. */
static struct matrix *slopes(const struct fibre *fibre, double angle, mat2 F,
                             enum tangent kind)
{
    struct matrix *D = matrix_alloc(DENSE, 4, 0);
    for (int c = 0; c < 4; c++) {
        const mat2 dP = change_of(fibre, angle, F, unit_change(c), kind);
        for (int r = 0; r < 4; r++) matrix_add(D, r, c, dP.m[r / 2][r % 2]);
    }
    return D;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void eigenvalues_are_slope_and_pull(void)
{
    for (int c = 0; c < 4 * STATES; c++) {
        const struct fibre *fibre = one_of(c % 2);
        const enum tangent kind = c / 2 % 2 ? PROJECTED : EXACT;
        mat2 P;
        const double l = stress_of(fibre, angle_of_fibre, state[c / 4], &P);
        const struct tension t = tension(fibre, l);
        double want[4] = {t.dT, t.T / l, 0.0, 0.0}, got[4];
        for (int i = 0; i < 4 && kind == PROJECTED; i++)
            want[i] = fmax(want[i], 0.0);
        qsort(want, 4, sizeof *want, by_size);
        struct matrix *D =
            slopes(fibre, angle_of_fibre, state[c / 4], kind);
        expect(matrix_eigenvalues(D, got) == OK, "%s, state %d: dP is not "
               "finite", name_of(fibre), c / 4);
        for (int i = 0; i < 4; i++)
            expect_close(got[i], want[i], SUMS, 1e3, "%s%s, state %d: "
                         "eigenvalue %d of dP/dF",
                         kind == PROJECTED ? "PROJECTED, " : "", name_of(fibre),
                         c / 4, i + 1);
        matrix_free(D);
    }
    for (int c = 0; c < 2 * COUNT(oracle_law); c++) { /* and eigenvectors */
        const double *f = oracle_law[c / 2].F;
        const mat2 F = {{{f[0], f[1]}, {f[2], f[3]}}};
        const struct fibre fibre = fibre_muscle(oracle_law[c / 2].activation);
        struct matrix *D = slopes(&fibre, oracle_law[c / 2].angle, F,
                                  c % 2 ? PROJECTED : EXACT);
        const double *want =
            c % 2 ? oracle_law[c / 2].projected : oracle_law[c / 2].dP;
        for (int i = 0; i < 4; i++)
            for (int j = i; j < 4; j++)
                expect_close(matrix_get(D, i, j), *want++, SUMS, 1e3,
                             "state %d: entry %d, %d of %sdP/dF", c / 2, i + 1,
                             j + 1, c % 2 ? "the projected " : "");
        matrix_free(D);
    }
}

static void a_fibre_of_no_length_does_not_pull(void)
{
    const mat2 flat[] = {{{{0.0, 0.0}, {0.0, 0.0}}},
                         {{{0.0, 1.0}, {0.0, 1.0}}}};
    for (int c = 0; c < 8; c++) {
        const struct fibre *fibre = one_of(c % 2);
        const double g[2] = {1.0, 0.0};
        mat2 P, dP;
        const double l = stress(fibre, g, flat[c / 2 % 2], mat2_rotation(0.7),
                                c / 4 ? PROJECTED : EXACT, &P, &dP);
        expect_close(l, 0.0, ROUND_OFF, 1.0, "stretch of a fibre without "
                     "length");
        for (int i = 0; i < 4; i++) {
            expect_close(P.m[i / 2][i % 2], 0.0, ROUND_OFF, 1.0, "%s without "
                         "length: P%d%d", name_of(fibre), i / 2 + 1, i % 2 + 1);
            expect_close(dP.m[i / 2][i % 2], 0.0, ROUND_OFF, 1.0, "%s without "
                         "length: dP%d%d", name_of(fibre), i / 2 + 1,
                         i % 2 + 1);
        }
    }
}

/* ---- 17c ----------------------------------------------------------------- */

enum { N = 4, N_TRIANGLE = 32, N_DOF = 50 };

/* A smooth, irregular number in (-1, 1) for each r. */
static double odd_number(int r)
{
    return sin(2.385 * r + 0.613) * cos(0.3714 * r * r + 0.2385);
}

/* A square with displaced interior vertices, left side held, irregular fibres
 * in it, those of the program. */
static struct scene *skew_scene(struct fibres *fibres, double angle[])
{
    struct scene_setting set = scene_notes(GRAVITY, CUBIC, N);
    set.rho = set.force = 0.0;
    struct scene *s = scene_alloc(&set);
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const int inside_x = a % (N + 1) > 0 && a % (N + 1) < N;
        const int inside_y = a / (N + 1) > 0 && a / (N + 1) < N;
        if (inside_x) s->mesh->X[2 * a] += 0.11 * odd_number(2 * a);
        if (inside_y) s->mesh->X[2 * a + 1] += 0.11 * odd_number(2 * a + 1);
    }
    body_free(s->body);
    s->body = body_alloc(s->mesh, material_notes(CUBIC), 0.0, CONSISTENT,
                         s->held);
    for (int e = 0; e < N_TRIANGLE; e++) angle[e] = 1.3 * odd_number(e + 17);
    for (int r = 0; r < N_DOF; r++) s->u[r] = 0.13 * odd_number(r + 53);
    *fibres = (struct fibres){muscle, angle};
    s->body->add = add_fibres;
    s->body->added = fibres;
    return s;
}

/* No pull, no stiffness: what there was is what there is, to the last digit. */
static void fibres_switched_off_add_nothing(void)
{
    double angle[N_TRIANGLE], energy = 2.385, *q = guarded_alloc(N_DOF);
    struct fibres fibres;
    struct scene *s = skew_scene(&fibres, angle);
    fibres.fibre.k = fibres.fibre.activation = 0.0;
    for (int r = 0; r < N_DOF; r++) q[r] = odd_number(r);
    matrix_zero(s->body->K);
    matrix_add(s->body->K, 3, 2, 2.385);
    add_fibres(s->body, 0.7371, s->u, EXACT, NULL, q);
    add_fibres(s->body, 1.0, s->u, NO_TANGENT, &energy, NULL);
    for (int r = 0; r < N_DOF; r++)
        expect_close(q[r], odd_number(r), ROUND_OFF, 1.0, "q of vertex %d, "
                     "which fibres that are off must not change", r / 2);
    expect_close(matrix_get(s->body->K, 3, 2), 2.385, ROUND_OFF, 1.0,
                 "an entry of K, which fibres that are off must not change");
    expect_close(energy, 2.385, ROUND_OFF, 1.0,
                 "an energy, which fibres that are off must not change");
    scene_free(s);
}

/* Of the fibres alone, by the program; dt is not in it. */
static double energy_of(const struct body *body, double dt, const double u[])
{
    double energy = 0.0;
    add_fibres(body, dt, u, NO_TANGENT, &energy, NULL);
    return energy;
}

/* dt^2 times the gradient at u + h along, in q; and K for EXACT. */
static void force_of(const struct body *body, double dt, const double u[],
                     double h, enum tangent kind, double q[])
{
    double moved[N_DOF];
    for (int r = 0; r < N_DOF; r++) {
        moved[r] = u[r] + h * odd_number(r + 91);
        q[r] = 0.0;
    }
    matrix_zero(body->K);
    add_fibres(body, dt, moved, kind, NULL, q);
}

static void force_is_the_slope_of_the_energy(void)
{
    double angle[N_TRIANGLE], q[N_DOF], slope = 0.0, best = INFINITY;
    double plus[N_DOF], minus[N_DOF];
    struct fibres fibres;
    struct scene *s = skew_scene(&fibres, angle);
    force_of(s->body, 0.7371, s->u, 0.0, NO_TANGENT, q);
    for (int r = 0; r < N_DOF; r++)
        slope += q[r] * odd_number(r + 91) / gsl_pow_2(0.7371);
    for (double h = 1e-2; h > 1e-6; h *= 0.1) {
        for (int r = 0; r < N_DOF; r++) {
            plus[r] = s->u[r] + h * odd_number(r + 91);
            minus[r] = s->u[r] - h * odd_number(r + 91);
        }
        const double d = (energy_of(s->body, 0.7371, plus) -
                          energy_of(s->body, 1.0, minus)) / (2.0 * h);
        if (fabs(d - slope) < fabs(best - slope)) best = d;
    }
    expect_close(slope, best, 1e-7, 300.0, "q / dt^2 along a direction, "
                 "against the change of the energy of the fibres");
    scene_free(s);
}

/* Fibres that pull, in factors that are to be kept. */
static void no_tangent_leaves_K_alone(void)
{
    double angle[N_TRIANGLE], q[N_DOF] = {0.0}, energy = 0.0;
    struct fibres fibres;
    struct scene *s = skew_scene(&fibres, angle);
    struct matrix *K = s->body->K;
    for (int i = 0; i < K->n; i++) matrix_add(K, i, i, 2.385);
    struct matrix *want = matrix_copy(K);
    add_fibres(s->body, 0.7371, s->u, NO_TANGENT, NULL, q);
    add_fibres(s->body, 0.7371, s->u, NO_TANGENT, &energy, NULL);
    for (int i = 0; i < K->n; i++)
        for (int j = 0; j <= i; j++)
            expect_close(matrix_get(K, i, j), matrix_get(want, i, j), 0.0, 1.0,
                         "NO_TANGENT: K[%d][%d], against what it was before",
                         i, j);
    matrix_free(want);
    scene_free(s);
}

static void stiffness_is_the_slope_of_the_force(void)
{
    double angle[N_TRIANGLE], q[N_DOF], some[N_DOF], got[N_DOF], all[N_DOF];
    double along[N_DOF], plus[N_DOF], minus[N_DOF], least = INFINITY;
    struct fibres fibres;
    no_tangent_leaves_K_alone();
    struct scene *s = skew_scene(&fibres, angle);
    force_of(s->body, 0.7371, s->u, 0.0, EXACT, q);
    for (int r = 0; r < N_DOF; r++)
        along[r] = s->held[r / 2] ? 0.0 : odd_number(r + 91);
    body_gather(s->body, along, some);
    matrix_multiply(s->body->K, some, got);
    body_scatter(s->body, got, all);
    double best[N_DOF] = {0.0};
    for (double h = 1e-2; h > 1e-6; h *= 0.1) {
        double off = 0.0;
        for (int k = 0; k < 2; k++) {
            double u[N_DOF], *to = k ? plus : minus;
            for (int r = 0; r < N_DOF; r++)
                u[r] = s->u[r] + (k ? h : -h) * along[r];
            force_of(s->body, 0.7371, u, 0.0, NO_TANGENT, to);
        }
        for (int r = 0; r < N_DOF; r++)
            if (!s->held[r / 2])
                off = fmax(off, fabs((plus[r] - minus[r]) / (2.0 * h) -
                                     all[r]));
        for (int r = 0; r < N_DOF && off < least; r++)
            best[r] = (plus[r] - minus[r]) / (2.0 * h);
        least = fmin(least, off);
    }
    for (int r = 0; r < N_DOF; r++)
        if (!s->held[r / 2])
            expect_close(all[r], best[r], 1e-6, 1e3, "K times a direction, "
                         "vertex %d, component %d, against the change of q",
                         r / 2, r % 2);
    scene_free(s);
}

/* Another derivation of energy, q and K: that of fibre.h. */
static void agrees_with_the_fast_fibres(void)
{
    const enum tangent kinds[] = {EXACT, PROJECTED, NO_TANGENT};
    double angle[N_TRIANGLE], q[2][N_DOF], energy[2];
    struct fibres fibres;
    struct scene *s = skew_scene(&fibres, angle);
    for (int c = 0; c < 6; c++) {
        const enum tangent kind = kinds[c % 3];
        const struct incremental Phi = {0.7371, s->u, NULL};
        struct matrix *K = NULL; /* the program's */
        fibres.fibre = *one_of(c / 3 ? CORD : MUSCLE);
        for (int fast = 0; fast < 2; fast++) {
            s->body->add = add_fibres;
            if (fast) fibres_attach(s->body, &fibres);
            expect(body_energy(s->body, s->u, &energy[fast]) == OK &&
                       body_assemble(s->body, Phi, s->u, kind, q[fast]) == OK,
                   "the body with fibres has no energy or no force");
            if (!fast) K = matrix_copy(s->body->K);
        }
        expect_close(energy[0], energy[1], SUMS, 1e3, "energy, against "
                     "fibre.h");
        for (int r = 0; r < N_DOF; r++)
            expect_close(q[0][r], q[1][r], SUMS, 1e3, "q of vertex %d, "
                         "component %d, against fibre.h", r / 2, r % 2);
        for (int i = 0; i < K->n; i++)
            for (int j = 0; j <= i; j++)
                expect_close(matrix_get(K, i, j),
                             matrix_get(s->body->K, i, j), SUMS, 1e4,
                             "%s, %s: K[%d][%d] of the free unknowns, against "
                             "fibre.h", name_of(&fibres.fibre),
                             kind == EXACT ? "EXACT"
                             : kind == PROJECTED ? "PROJECTED"
                                                 : "NO_TANGENT", i, j);
        matrix_free(K);
    }
    scene_free(s);
}

/* ---- 17d ----------------------------------------------------------------- */

static void strip_has_its_length(void)
{
    for (int k = 0; k < COUNT(oracle_strip); k++) {
        const enum law law = oracle_strip[k].cubic ? CUBIC : LOG;
        const struct material material = material_notes(law);
        const struct fibre fibre = fibre_muscle(oracle_strip[k].activation);
        const struct {
            double load, length;
        } is[] = {{0.0, oracle_strip[k].length},
                  {oracle_strip[k].isometric, 1.0},
                  {oracle_strip[k].load_12, 1.2},
                  {oracle_strip[k].load_08, 0.8}};
        for (int c = 0; c < COUNT(is); c++) {
            double *x = guarded_alloc(2);
            const enum status status = strip(&material, &fibre, is[c].load, x);
            expect(status == OK, "%s law, activation %g, load %g, the strip: "
                   "got %s at (%g, %g), want OK", material_law(law),
                   fibre.activation, is[c].load, status_name(status), x[0],
                   x[1]);
            expect_close(x[0], is[c].length, SOLVED, 1.0, "%s law, activation "
                         "%g, load %g: length", material_law(law),
                         fibre.activation, is[c].load);
            if (c < 2)
                expect_close(x[1], c ? 1.0 : oracle_strip[k].width, SOLVED, 1.0,
                             "%s law, activation %g, load %g: width",
                             material_law(law), fibre.activation, is[c].load);
        }
    }
}

/* P of the strip at x, both parts from common/. */
static mat2 strip_stress(const struct material *material,
                         const struct fibre *fibre, const double x[2])
{
    const mat2 F = {{{x[0], 0.0}, {0.0, x[1]}}};
    return mat2_add(material2_pk1(material, F),
                    fibre_pk1(fibre, (const double[]){1.0, 0.0}, F));
}

/* Both numbers of P count.  nu = 0, k = 500: at x = (1.25, 1), where the first
 * system leads, P11 is the load to the last digit, and P22 is -mu/64. */
static void strip_is_free_at_its_sides(void)
{
    const struct material material = material_make(CUBIC, 1000.0, 0.0);
    const struct fibre rope = {MUSCLE, 500.0, 0.0, 0.5, 0.0};
    double *x = guarded_alloc(2);
    const enum status status = strip(&material, &rope, 250.0, x);
    expect(status == OK, "nu = 0, a slack muscle of k = 500, load 250: got %s "
           "at (%g, %g), want OK", status_name(status), x[0], x[1]);
    const mat2 P = strip_stress(&material, &rope, x);
    expect_close(P.m[0][0], 250.0, SOLVED, 1e3, "nu = 0, k = 500: P11 of the "
                 "strip under the load 250");
    expect_close(P.m[1][1], 0.0, SOLVED, 1e3, "nu = 0, k = 500, load 250: P22 "
                 "at the end");
}

/* An active part of small w: Newton's method leaps to and fro across the kink
 * at l = 1 - w, and sigma decides for how long.  The numbers of systems stay as
 * they are when sigma changes by 1e-6 of itself. */
static void strip_takes_newtons_steps(void)
{
    const struct material material = material_notes(CUBIC);
    struct fibre narrow = {MUSCLE, 200.0, 0.0, 0.1, 1.0};
    const struct {
        double w, sigma;
        int systems;
    } is[] = {{0.1, 456.0, 40}, {0.06, 368.0, 41}, {0.1, 452.0, 44},
              {0.1, 420.0, 58}, {0.1, 404.0, 110}};
    for (int k = 0; k < COUNT(is); k++) {
        double *x = guarded_alloc(2);
        narrow.sigma = is[k].sigma;
        narrow.width = is[k].w;
        const enum status want = is[k].systems <= CAP ? OK : MAX_ITERATIONS;
        const enum status status = strip(&material, &narrow, 0.0, x);
        expect(status == want, "w = %g, sigma = %g, which takes %d systems, "
               "of %d: the strip must end with %s, not %s", is[k].w,
               is[k].sigma, is[k].systems, CAP, status_name(want),
               status_name(status));
        if (want == OK)
            expect_close(mat2_norm(strip_stress(&material, &narrow, x)), 0.0,
                         SOLVED, 1e3, "w = %g, sigma = %g: |P| at the end",
                         is[k].w, is[k].sigma);
    }
}

/* Uniaxial stress at rest with cords of k = 2000, by Sherman-Morrison. */
static void cords_stiffen_and_shear(void)
{
    const struct material material = material_notes(CUBIC);
    const struct fibre stiff = {CORD, 2000.0, 0.0, 0.5, 0.0};
    const mat2 I = mat2_identity();
    const mat2 strain[3] = {unit_change(0), unit_change(3),
                            {{{0.0, 0.5}, {0.5, 0.0}}}};
    for (int k = 0; k < COUNT(oracle_polar); k++) {
        const double angle = oracle_polar[k].degrees * M_PI / 180.0;
        struct matrix *C = matrix_alloc(DENSE, 3, 0);
        double e[3] = {1.0, 0.0, 0.0};
        for (int c = 0; c < 3; c++) {
            const mat2 dP =
                mat2_add(material2_dpk1(&material, I, strain[c]),
                         change_of(&stiff, angle, I, strain[c], EXACT));
            for (int r = 0; r < 3; r++)
                matrix_add(C, r, c, mat2_dot(strain[r], dP));
        }
        expect(matrix_factor(C) == OK, "the material with cords is not stiff");
        matrix_solve(C, e);
        expect_close(1.0 / e[0], oracle_polar[k].modulus, SUMS, 3e3,
                     "modulus at %g degrees to the cords",
                     oracle_polar[k].degrees);
        expect_close(e[2] / e[0], oracle_polar[k].shear, SUMS, 1.0,
                     "shear per strain at %g degrees to the cords",
                     oracle_polar[k].degrees);
        matrix_free(C);
    }
}

static void failures_are_named(void)
{
    struct material material = material_notes(CUBIC);
    struct fibre fibre = fibre_muscle(1.0);
    double x[2];
    const struct {
        enum law law;
        double sigma, load;
        enum status status;
    } is[] = {{CUBIC, 3000.0, 0.0, NOT_SPD}, {LOG, 3000.0, 0.0, INVERTED},
              {CUBIC, 300.0, NAN, NONFINITE}, {CUBIC, 300.0, 0.0, OK}};
    for (int k = 0; k < COUNT(is); k++) {
        material = material_notes(is[k].law);
        fibre.sigma = is[k].sigma;
        const enum status status = strip(&material, &fibre, is[k].load, x);
        expect(status == is[k].status, "%s law, sigma %g, load %g, the strip: "
               "got %s at (%g, %g), want %s", material_law(is[k].law),
               is[k].sigma, is[k].load, status_name(status), x[0], x[1],
               status_name(is[k].status));
    }
    /* (-1 + 2 mu + lambda) (2 mu + lambda) = lambda^2 to the last digit */
    material = (struct material){CUBIC, 1.0, 2.0};
    const struct fibre pushing = {CORD, -3.0, 0.0, 0.5, 0.0};
    const enum status singular = strip(&material, &pushing, 0.5, x);
    expect(singular == NOT_SPD, "a cord of k = -3 in a material with mu = 1, "
           "lambda = 2, whose matrix is singular at rest: the strip must end "
           "with NOT_SPD, not %s", status_name(singular));
    /* its least pivot is 1/2, and that is enough */
    material = (struct material){CUBIC, 500.0, 0.0};
    const struct fibre almost = {CORD, -999.5, 0.0, 0.5, 0.0};
    const enum status soft = strip(&material, &almost, 1e-6, x);
    expect(soft == OK, "a cord that leaves the strip a stiffness of 1/2 N/m^2, "
           "load 1e-6: OK, not %s", status_name(soft));
    const struct output *out = run_unsolved("--sigma 3000", "NOT_SPD");
    expect(row_count(out, "strip") == 4 &&
               is_missing(out, "strip", "length", -1),
           "a strip that fails at the fourth activation has three lengths");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    measured("1a", cell(run(""), "strip", "length", -1));
    measured("1b", cell(run("--load 100"), "strip", "length", -1));
}

static const struct claim claims[] = {
    {"tension_has_its_landmarks", tension_has_its_landmarks, "17a"},
    {"tension_is_the_slope_of_the_energy", tension_is_the_slope_of_the_energy,
     "17a"},
    {"stress_pulls_along_the_fibre", stress_pulls_along_the_fibre, "17b"},
    {"a_turned_body_has_turned_stress", a_turned_body_has_turned_stress, "17b"},
    {"stress_is_the_slope_of_the_energy", stress_is_the_slope_of_the_energy,
     "17b"},
    {"tangent_is_the_slope_of_the_stress", tangent_is_the_slope_of_the_stress,
     "17b"},
    {"eigenvalues_are_slope_and_pull", eigenvalues_are_slope_and_pull, "17b"},
    {"a_fibre_of_no_length_does_not_pull", a_fibre_of_no_length_does_not_pull,
     "17b"},
    {"cords_stiffen_and_shear", cords_stiffen_and_shear, "17b"},
    {"fibres_switched_off_add_nothing", fibres_switched_off_add_nothing, "17c"},
    {"force_is_the_slope_of_the_energy", force_is_the_slope_of_the_energy,
     "17c"},
    {"stiffness_is_the_slope_of_the_force", stiffness_is_the_slope_of_the_force,
     "17c"},
    {"agrees_with_the_fast_fibres", agrees_with_the_fast_fibres, "17c"},
    {"strip_has_its_length", strip_has_its_length, "17d"},
    {"strip_is_free_at_its_sides", strip_is_free_at_its_sides, "17d"},
    {"strip_takes_newtons_steps", strip_takes_newtons_steps, "17d"},
    {"failures_are_named", failures_are_named, "17d"},
};

static const char *const runs[] = {
    "",
    "--law log --activation 0.6137 --bend 37.14",
    "--sigma 371.4 --load 123.85 --bend -12.385",
    "--activation 0",
    "--sigma 1000", /* the strip fails, the square does not */
};

#define STATE "Newton's method to 1e-10, beyond which it is quadratic"
static const struct column_rule rules[] = {
    {"force_length", "*", 1e-13, "a closed form", 1e3},
    {"law", "*", 1e-13, "a closed form", 1e3},
    {"strip", "length", SOLVED, "Newton's method to 1e-13", 1},
    {"strip", "width", SOLVED, "Newton's method to 1e-13", 1},
    {"strip", "status", 0, "a word", 0},
    {"strip", "*", 1e-14, "given", 1e3},
    {"field", "e", 0, "a number", 0},
    {"field", "angle", 1e-14, "given", 1},
    {"field", "T", 1e-9, STATE, 1e3},
    {"field", "*", 1e-9, STATE, 1},
    {"nodes", "u_x", 1e-9, STATE, 1},
    {"nodes", "u_y", 1e-9, STATE, 1},
    {"nodes", "*", 1e-14, "given", 1e3},
};

static const struct lesson lesson = {
    "17_fibres", claims, COUNT(claims), runs, COUNT(runs), rules, COUNT(rules),
    "At T = 0 a fibre has no stiffness across its direction, and on the "
    "descending limb a negative one along it: T' and T/l are all there is to "
    "look at, and two clamps make a body of fibres convex.",
    "Give the strip a stronger muscle (--sigma 1000, 2000, 3000). At which "
    "activation does it stop with NOT_SPD? Has it no length there, or did only "
    "the first step go too far?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
