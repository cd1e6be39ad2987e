/* relax.c - laws of common/choice/relax.h: the force in the hand, what a corner
 * says and the body does not, and the beam beside a bar. */
#include "choice/estimate.h"

#include "unit.h"

#include <math.h>

/* What the forces move, as a part of the displacement. */
static double moved(const struct ladder_state *s, relax_forces *forces)
{
    struct matrix *K = relax_factors(s);
    const double part = relax_part(s, K, forces);
    matrix_free(K);
    return part;
}

/* The force in the hand: by a hand alone that moves a linear body, hand.u is
 * hand.K^-1 hand, and an answer off by a fiftieth is off by that; what the mesh
 * changes meets the error, which is an energy's.  Beside a weight that bends,
 * pressed or pulled, the part of a linear law is what the cubic one changes. */
static void the_hand_has_a_force(void)
{
    const struct ladder_scene scene = {.slender = 4, .nu = 0.3,
        .pull = {0.0, -0.02}, .quantity = LADDER_HAND};
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
    struct ladder_state *t =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 3});
    const double part = moved(s, estimate_mesh);
    close_to(part / ladder_error(s, t), 1.0, 0.3);
    for (int r = 0; r < 2 * t->mesh->n_vertex; r++) t->u[r] *= 1.02;
    close_to(ladder_error(t, t), 0.0, 1e-15);
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) s->u[r] *= 1.02;
    struct ladder_state *once =
        ladder_solve(&scene, (struct ladder_model){LINEAR_PLANE, 0, 1});
    close_to(ladder_error(s, once), 0.02, 1e-9);
    ladder_free(s);
    ladder_free(t);
    ladder_free(once);
    static const double pull[] = {-5.0, -3.0, 2.0};
    for (int k = 0; k < 3; k++) {
        const struct ladder_scene two = {.slender = 4, .nu = 0.3,
            .pull = {pull[k], 0.0}, .weight = {0.0, -0.4},
            .quantity = LADDER_HAND};
        double got[N_PART];
        s = ladder_solve(&two, (struct ladder_model){LINEAR_PLANE, 0, 1});
        t = ladder_solve(&two, (struct ladder_model){CUBIC_PLANE, 0, 1});
        estimate_parts(s, got);
        const double want = ladder_error(s, t);
        const double both = hypot(got[STRESS], got[GEOMETRY]);
        ck_assert_msg(both > 0.75 * want && both < 1.5 * want,
                      "pulled by %g: %g and %g, the error %g", pull[k],
                      got[STRESS], got[GEOMETRY], want);
        ladder_free(s);
        ladder_free(t);
    }
}

/* Stretched to both sides of J = 2, from where on the cubic law says nothing of
 * the logarithm, neither in its corner nor by what it would move. */
static void laws_are_not_compared_beyond_their_series(void)
{
    static const struct ladder_scene scene = {.slender = 2, .nu = 0.1,
        .pull = {200.0, 0.0}};
    for (int k = 0; k < 2; k++) {
        struct ladder_state *s =
            ladder_solve(&scene, (struct ladder_model){CUBIC_PLANE, 0, 0});
        struct matrix *K = relax_factors(s);
        double J = 1.0;
        for (int r = 0; r < 2 * s->mesh->n_vertex; r++)
            s->u[r] *= k ? 5.0 : 3.0;
        for (int e = 0; e < s->mesh->n_triangle; e++)
            J = fmax(J, mat2_det(body_deformation(s->body, s->u, e)));
        ck_assert(k ? J > 2.0 && J < 2.3 : J > 1.5 && J < 2.0);
        ck_assert_int_eq(estimate_law(s) == 1.0, k);
        ck_assert_int_eq(relax_law(s, K) == 1.0, k);
        matrix_free(K);
        ladder_free(s);
    }
}

/* A beam that is pulled and has a load across at its end and a couple, at last
 * one that brings its end back, and one whose moment where it is held is none:
 * w = Q x^2 (3 L - x) / 6 - m x^2 / 2 and shear, in units of E' I; int n^2 / a,
 * int m^2 / I, shear and the axis that a bend shortens for the hand. */
static void a_bar_knows_how_a_beam_bends(void)
{
    static const double couple[] = {0.0, -3.0, -1.28, -1.92};
    for (int k = 0; k < 4; k++) {
        struct ladder_scene scene = {.slender = 4, .nu = 0.3,
            .pull = {1.0, -0.02}, .couple = couple[k]};
        struct ladder_state *s =
            ladder_solve(&scene, (struct ladder_model){BAR, 0, 0});
        const double L = 2.0, a = 0.5, I = pow(a, 3) / 12.0, N = a;
        const double Q = -0.02 * a, m = couple[k] * I;
        const double shear = 1.2 * 2.0 / (1.0 - 0.3) / a;
        const double more = 1.0 / (1.0 - ladder_pressed(&scene));
        double across = 0.0, shorter = 0.0, part[N_PART];
        for (int i = 0; i <= s->mesh->n; i++) {
            const double x = L * i / s->mesh->n;
            const double w =
                (Q * x * x * (3.0 * L - x) / 6.0 - m * x * x / 2.0) / I;
            const double turn = (Q * x * (L - x / 2.0) - m * x) / I;
            across = fmax(across, hypot(w + shear * Q * x, 0.5 * a * turn));
            shorter += L / s->mesh->n * N * pow(more * turn, 2) / 2.0;
        }
        shorter /= 1000.0 / (1.0 - 0.3 * 0.3);
        const double missed = 9.0 / 49.0 * N / 2.0;
        close_to(relax_dimension(s), (more * across + missed) /
                 (more * across + N * L / a), 1e-3);
        scene.quantity = LADDER_HAND;
        const double bends = (Q * Q * pow(L, 3) / 3.0 - Q * m * L * L +
                              m * m * L) / I + shear * Q * Q * L;
        const double want = (more * bends + missed * N + shorter) /
                            (bends + N * N * 4.0);
        close_to(relax_dimension(s), want, 1e-2 * want);
        estimate_parts(s, part);
        close_to(part[DIMENSION], relax_dimension(s), 1e-15);
        ck_assert(k < 3 || part[DIMENSION] > 2.0 * estimate_dimension(s));
        ck_assert(part[MESH] == 0.0 && part[STRESS] == 0.0);
        scene.pull[0] *= -20.0;
        close_to(relax_dimension(s), 1.0, 1e-15); /* it buckles */
        ladder_free(s);
    }
}

/* A bar under its weight W is pulled by Q: the weight moves the end, too, W / 2
 * over Q as far, and what the geometry leaves out of that is as much more of
 * what a hand must pull. */
static void a_weight_moves_the_hand(void)
{
    const struct ladder_scene scene = {.slender = 4, .nu = 0.3,
        .weight = {50.0, 0.0}, .pull = {10.0, 0.0}, .quantity = LADDER_HAND};
    double part[N_PART];
    struct ladder_state *s =
        ladder_solve(&scene, (struct ladder_model){BAR, 0, 0});
    estimate_parts(s, part);
    close_to(part[GEOMETRY] / estimate_geometry(s), 1.0 + 50.0 / 10.0, 1e-6);
    ladder_free(s);
}

/* Pulled by a few per cent the stress stiffens a linear body, and the squares
 * of H make it softer: together they are what the cubic law changes, and far
 * less than the root of their squares. */
static void what_cancels_is_not_added_up(void)
{
    for (int moving = 0; moving < 2; moving++) {
        const struct ladder_scene scene = {.slender = 2, .nu = 0.2,
            .pull = {60.0, -1.0}, .time = RISES, .T = 0.5, .dt = 0.02,
            .end = 0.7, .finest = 1};
        struct ladder_state *s = ladder_solve(
            &scene, (struct ladder_model){LINEAR_PLANE, moving, 0});
        struct ladder_state *t = ladder_solve(
            &scene, (struct ladder_model){CUBIC_PLANE, moving, 0});
        struct matrix *K = relax_factors(s);
        double part[N_PART], together;
        estimate_parts(s, part);
        const double want = ladder_error(s, t);
        const double got = hypot(part[STRESS], part[GEOMETRY]);
        const double apart =
            hypot(relax_part(s, K, estimate_stress),
                  relax_geometry(s, K, estimate_stress, &together));
        ck_assert_msg(got > 0.8 * want && got < 1.7 * want &&
                      apart > 1.2 * got && together < got,
                      "%g of %g and %g, the error %g", got, apart, together,
                      want);
        matrix_free(K);
        ladder_free(s);
        ladder_free(t);
    }
}

UNIT_MAIN("relax",
    LAW(the_hand_has_a_force),
    LAW(laws_are_not_compared_beyond_their_series),
    LAW(a_bar_knows_how_a_beam_bends),
    LAW(a_weight_moves_the_hand),
    LAW(what_cancels_is_not_added_up))
