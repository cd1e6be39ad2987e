/* compression.c - laws of figures/23_least_model/compression.h. */
#include "figures/23_least_model/compression.h"

#include "choice/rung.h"
#include "unit.h"

#include <math.h>

static int certified(const struct ladder_scene *scene, int level, int *stable)
{
    double flops;
    struct ladder_state *s =
        ladder_solve(scene, (struct ladder_model){BAR, 0, level});
    const int bound = compression_certifies(s, &flops);
    *stable = ladder_stable(s);
    ladder_free(s);
    return bound;
}

/* The largest pressure that passes, by the bound or by Cholesky's method. */
static double largest(int slender, double nu, int level, int by_bound)
{
    double low = 0.0, high = 400.0 / slender;
    for (int k = 0; k < 25; k++) {
        const double here = 0.5 * (low + high);
        const struct ladder_scene scene = {
            "pressed", slender, nu, .pull = {-here, 0.0}, .finest = 2};
        int stable;
        const int bound = certified(&scene, level, &stable);
        if (by_bound ? bound : stable)
            low = here;
        else
            high = here;
    }
    return low;
}

/* Columns are certified up to a part of the load at which they buckle, and none
 * beyond it; of a slender one that is most. */
static void no_column_is_certified_that_buckles(void)
{
    for (int slender = 2; slender <= 8; slender *= 2) {
        const double bound = largest(slender, 0.0, 0, 1);
        const double buckles = largest(slender, 0.0, 2, 0);
        ck_assert(bound > 0.5 * buckles && bound < 0.9 * buckles);
    }
}

/* [eq:compression] with one choice of t: a, b and c, if there is a bound.  That
 * K is at least so much is seen by dP/dF in many directions W. */
static int bound(const struct material *m, mat2 F, double more, double of[3])
{
    const double f = 0.5 * (F.m[0][0] + F.m[1][1]);
    const double turn = fabs(F.m[1][0] - F.m[0][1]);
    const double unequal =
        0.5 * hypot(F.m[0][0] - F.m[1][1], F.m[1][0] + F.m[0][1]);
    const double t = unequal + turn + more;
    const double rest = t > 0.0 ? (1.0 / t - 1.0) * (unequal + turn) : 0.0;
    const struct volume G = material_volume(m, mat2_det(F));
    const double delta = -m->mu - G.dG;
    of[0] = m->mu + 0.5 * delta - G.ddG * rest * unequal;
    of[1] = G.ddG * (1.0 - t) * f * f - 0.5 * delta;
    of[2] = 2.0 * delta + G.ddG * rest * turn;
    if (t >= 1.0 || G.ddG < 0.0) return 0;
    for (int k = 0; k < 40; k++) {
        const mat2 W = {{{sin(2.4 * k), sin(0.7 * k + 1.0)},
                         {cos(1.3 * k), cos(3.1 * k * k + 2.0)}}};
        const double apart = W.m[0][0] - W.m[1][1];
        const double shear = W.m[0][1] + W.m[1][0];
        const double omega = 0.5 * (W.m[1][0] - W.m[0][1]);
        const double trace = W.m[0][0] + W.m[1][1];
        const double least = of[0] * (apart * apart + shear * shear) +
                             of[1] * trace * trace - of[2] * omega * omega;
        ck_assert_double_ge(mat2_dot(W, material2_dpk1(m, F, W)),
                            least - 1e-12 * m->mu);
    }
    return 1;
}

/* On one square Korn's inequality is one term, with the least a and b and the
 * largest c.  Any of four choices of t will do. */
static int formula(const struct ladder_state *s)
{
    const double more[] = {0.0, 0.02, 0.06, 0.18}, pi = acos(-1.0);
    const double k2 = 1.0 / (sin(pi / 8.0) * sin(pi / 8.0)) - 0.5;
    for (int i = 0; i < COUNT(more); i++) {
        double a = INFINITY, b = INFINITY, c = 0.0;
        for (int e = 0; e < s->mesh->n_triangle; e++) {
            double of[3];
            if (!bound(&s->body->material,
                       body_deformation(s->body, s->u, e), more[i], of))
                of[0] = of[1] = of[2] = -1.0; /* no bound */
            a = fmin(a, of[0]), b = fmin(b, of[1]), c = fmax(c, of[2]);
        }
        const double least = fmin(a, b), bending = 4.0 * a * b / (a + b);
        const double root = sqrt(48.0 / (pi * pi * bending) + 0.3 / a) +
                            sqrt(k2 / (10.0 * least));
        if (least > 0.0 && c * (k2 / (2.0 * least) + root * root) < 1.0)
            return 1;
    }
    return 0;
}

static int says(double nu, double pull, int by_formula)
{
    const struct ladder_scene scene = {
        "pressed", 1, nu, .pull = {pull, 0.0}, .finest = 1};
    double flops;
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){BAR, 0, 0});
    const int certified =
        by_formula ? formula(s) : compression_certifies(s, &flops);
    ladder_free(s);
    return certified;
}

/* The same bars are certified: up to the same pressure to 1e-6 of it, and up to
 * the same pull. */
static void the_bound_is_the_formula(void)
{
    for (double nu = 0.0; nu < 0.45; nu += 0.1) {
        const double most = largest(1, nu, 0, 1);
        ck_assert(says(nu, -most * (1.0 - 1e-6), 1));
        ck_assert(!says(nu, -(most + 2e-5) * (1.0 + 1e-6), 1));
        for (double pull = -600.0; pull < 600.0; pull += 43.7)
            ck_assert_int_eq(says(nu, pull, 0), says(nu, pull, 1));
    }
}

/* Whatever is pulled, and only a little else. */
static void what_is_pulled_is_certified(void)
{
    for (double pull = 1.0; pull < 200.0; pull *= 2.3) {
        const struct ladder_scene scene = {
            "pulled", 4, 0.27, .pull = {pull, 0.0}, .finest = 1};
        int stable;
        ck_assert(certified(&scene, 0, &stable) && stable);
    }
}

/* The proof is for whole squares: of others nothing is said. */
static void parts_of_squares_are_refused(void)
{
    for (double slender = 2.0; slender < 3.0; slender += 0.25) {
        const struct ladder_scene scene = {
            "pulled", slender, 0.3, .pull = {5.0, 0.0}, .finest = 1};
        int stable;
        ck_assert_int_eq(certified(&scene, 0, &stable), slender < 2.1);
        ck_assert(stable);
    }
}

/* The work: a try of two triangles for each section; K with its factors. */
static void certificates_are_charged(void)
{
    double flops;
    struct ladder_state *s = ladder_solve(
        &ladder_scene[0], (struct ladder_model){BAR, 0, 0});
    ck_assert(compression_certifies(s, &flops));
    ck_assert_double_eq(flops, 60.0 * 2 * 16);
    ck_assert_double_eq(
        compression_cholesky(s),
        250.0 * 128 +
            matrix_cost(BANDED, s->body->n_equation, s->body->K->p).flops);
    ladder_free(s);
    s = ladder_solve(&ladder_scene[5], (struct ladder_model){BAR, 0, 0});
    ck_assert(!compression_certifies(s, &flops));
    ck_assert_double_eq(flops, 4 * 60.0 * 2 * 16);
    ladder_free(s);
    s = ladder_alloc(&ladder_scene[6],
                     (struct ladder_model){LINEAR_PLANE, 1, 0});
    ck_assert_double_eq(compression_cholesky(s), 0.0);
    ladder_free(s);
}

UNIT_MAIN("compression",
    LAW(no_column_is_certified_that_buckles),
    LAW(the_bound_is_the_formula),
    LAW(what_is_pulled_is_certified),
    LAW(parts_of_squares_are_refused),
    LAW(certificates_are_charged))
