/* hang.c - laws of figures/25_elements/hang.h and trial.h. */
#include "figures/25_elements/hang.h"
#include "figures/25_elements/trial.h"

#include "linear/sparse.h"
#include "unit.h"

#include <math.h>

/* Where lambda is 0 nothing is averaged; distances are parts of the second. */
static void averages_are_of_lambda(void)
{
    const struct hang linear = hang_of(HANG_LINEAR, 8, 1.5, 0.0);
    const struct hang averaged = hang_of(HANG_AVERAGED, 8, 1.5, 0.0);
    struct hang more = linear;
    close_to(hang_apart(&averaged, &linear), 0.0, 1e-10);
    close_to(averaged.div, linear.div, 1e-10 * linear.div);
    for (int r = 0; r < 2 * HANG_SHARED; r++) more.u[r] *= 1.25;
    close_to(hang_apart(&more, &linear), 0.25, 1e-13);
    close_to(hang_apart(&linear, &more), 0.2, 1e-13);
}

/* Each element goes to the answer of quadratic ones on a fine mesh, and so do
 * its sag and its div u; near nu = 1/2 the mean of a cell helps. */
static void all_elements_have_one_limit(void)
{
    const struct hang fine = hang_of(HANG_QUADRATIC, 32, 2.0, 0.3);
    for (int e = HANG_LINEAR; e <= HANG_QUADRATIC; e++) {
        const struct hang coarse =
            hang_of((enum hang_element)e, 8, 1.5, 0.3);
        const struct hang half = hang_of((enum hang_element)e, 16, 1.5, 0.3);
        const double error = hang_apart(&half, &fine);
        ck_assert_double_lt(error, 0.02);
        ck_assert_double_lt(error, 0.45 * hang_apart(&coarse, &fine));
        close_to(half.sag / fine.sag, 1.0, 0.02);
        close_to(half.div / fine.div, 1.0, 0.05);
        ck_assert_double_eq(half.sag, half.u[2 * 14 + 1]);
    }
    ck_assert_double_lt(fine.sag, 0.0);
    const struct hang locked = hang_of(HANG_QUADRATIC, 32, 2.0, 0.495);
    const struct hang linear = hang_of(HANG_LINEAR, 16, 1.5, 0.495);
    const struct hang averaged = hang_of(HANG_AVERAGED, 16, 1.5, 0.495);
    ck_assert_double_lt(hang_apart(&averaged, &locked),
                        0.3 * hang_apart(&linear, &locked));
}

/* Criss-cross cells are their own mirror images: what hangs down is even in X2,
 * and what goes along is odd. */
static void a_cross_is_its_own_mirror_image(void)
{
    const struct hang cross = hang_of(HANG_CROSSED, 4, 1.5, 0.3);
    for (int j = 0; j < 5; j++)
        for (int i = 0; i < 5; i++) {
            const double *u = &cross.u[2 * (5 * j + i)];
            const double *mirrored = &cross.u[2 * (5 * (4 - j) + i)];
            close_to(u[0], -mirrored[0], 1e-12);
            close_to(u[1], mirrored[1], 1e-12);
        }
}

/* The weight of a trial is 50 times that of a square that hangs, and otherwise
 * they are the same system, assembled by two modules. */
static void a_weight_is_fifty_of_one(void)
{
    for (int quadratic = 0; quadratic < 2; quadratic++) {
        const struct hang one =
            hang_of(quadratic ? HANG_QUADRATIC : HANG_LINEAR, 8, 1.5, 0.3);
        const struct trial trial = trial_of(
            TRIAL_WEIGHT, quadratic ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE, 8,
            1.5);
        ck_assert_int_eq(trial.end.status, OK);
        ck_assert_int_eq(trial.end.systems, 1);
        ck_assert_int_eq(trial.unknowns, quadratic ? 2 * 17 * 16 : 2 * 9 * 8);
        for (int r = 0; r < 2 * HANG_SHARED; r++)
            close_to(trial.end.u[r], 50.0 * one.u[r], 1e-10);
    }
}

/* At rest a pull is that of work.h; a swing by leapfrog is near that by the
 * midpoint rule, in steps of 3/4 of the longest, which halves with h. */
static void trials_rest_and_move(void)
{
    const struct work_setting set = {SLOW_PULL, LOG, 0, 8, 4, BACKWARD_EULER,
                                     1e-10, LINEAR_TRIANGLE, 1.0};
    const struct work rest = work_run(&set);
    const struct trial pull = trial_of(TRIAL_PULL, LINEAR_TRIANGLE, 8, 1.0);
    close_to(trial_apart(&pull.end, &rest), 0.0, 1e-8);
    ck_assert_int_ge(pull.end.systems, 16);
    for (int q = 0; q < 2; q++) {
        const enum element element = q ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE;
        const double longest = trial_longest_step(element, 8, 1.0);
        const struct trial swing = trial_of(TRIAL_SWING, element, 8, 1.0);
        const struct trial leaps = trial_of(TRIAL_EXPLICIT, element, 8, 1.0);
        struct scene *s = trial_alloc(TRIAL_EXPLICIT, element, 8, 1.0);
        close_to(longest / trial_longest_step(element, 16, 1.0), 2.0, 0.1);
        ck_assert_int_eq(leaps.end.steps,
                         (int)ceil(work_end(SWING) / (0.75 * longest)));
        ck_assert_int_eq(swing.end.steps, 32);
        close_to(leaps.end.flops,
                 leaps.end.steps * work_elements(s->body, NO_TANGENT), 1e-6);
        ck_assert_double_lt(trial_apart(&leaps.end, &swing.end), 0.05);
        ck_assert(swing.end.min_J > 0.3 && swing.end.min_J < 1.0);
        scene_free(s);
    }
}

/* What is held ends where the scene says, what rests has no mass, a system
 * costs what sparse.h counts, and a push is that of work.h. */
static void trials_are_those_of_their_scenes(void)
{
    static const int coarsest[] = {4, 4, 8, 4, 4, 4, 4};
    static const int linear[] = {6, 4, 6, 5, 5, 4};
    static const int quadratic[] = {4, 3, 3, 3, 3, 3};
    static const int finest[] = {64, 32, 64, 32, 64, 48};
    for (int k = 0; k < TRIAL_SCENES; k++) {
        const enum trial_scene scene = (enum trial_scene)k;
        struct scene *s = trial_alloc(scene, QUADRATIC_TRIANGLE, 8, 1.0);
        ck_assert_int_eq(trial_coarsest(scene), coarsest[k]);
        ck_assert((s->body->rho == 0.0) == (k <= TRIAL_COLUMN));
        if (k == TRIAL_WEIGHT)
            close_to(trial_of(scene, QUADRATIC_TRIANGLE, 8, 1.0).end.flops,
                     s->body->pattern->flops + s->body->pattern->solve +
                         work_elements(s->body, EXACT), 1e-6);
        scene_free(s);
        if (k == TRIAL_PUSH) continue;
        ck_assert_int_eq(trial_meshes(scene, LINEAR_TRIANGLE), linear[k]);
        ck_assert_int_eq(trial_meshes(scene, QUADRATIC_TRIANGLE),
                         quadratic[k]);
        ck_assert_int_eq(trial_finest(scene).n, finest[k]);
    }
    const struct work_setting set = {PUSH, LOG, 1, 4, 32, IMPLICIT_MIDPOINT,
                                     1e-10, LINEAR_TRIANGLE, 1.0};
    const struct trial push = trial_of(TRIAL_PUSH, LINEAR_TRIANGLE, 4, 1.0);
    const struct work run = work_run(&set);
    struct work more = push.end;
    ck_assert_int_eq(push.end.status, OK);
    close_to(trial_apart(&push.end, &run), 0.0, 1e-8);
    close_to(push.end.u[8], -0.6, 1e-12);
    close_to(push.end.u[0], 0.0, 1e-12);
    work_correct(&more, 0.25, &push.end, &(struct work){.status = OK});
    close_to(trial_apart(&more, &push.end), 0.25, 1e-12);
}

/* A mesh that is graded too far has no answer: cells whose stiffness is lost in
 * round-off at rest, and a corner that passes through itself in motion. */
static void what_fails_is_said(void)
{
    const struct trial pull = trial_of(TRIAL_PULL, LINEAR_TRIANGLE, 8, 50.0);
    const struct trial push = trial_of(TRIAL_PUSH, LINEAR_TRIANGLE, 8, 16.0);
    ck_assert_int_ne(pull.end.status, OK);
    ck_assert_int_eq(push.end.status, INVERTED);
    ck_assert(push.end.min_J < 0.0 && push.end.steps < 32);
}

/* From three meshes, each of which leaves the same part of the error. */
static void a_limit_goes_on_as_three_meshes_do(void)
{
    double floor;
    const struct work limit = trial_limit(TRIAL_WEIGHT, &floor);
    struct work run[3];
    for (int k = 0; k < 3; k++)
        run[k] = trial_of(TRIAL_WEIGHT, QUADRATIC_TRIANGLE, 16 << k, 2.0).end;
    const double ratio =
        work_distance(&run[0], &run[1]) / work_distance(&run[1], &run[2]);
    double off = 0.0, size = 0.0;
    for (int i = 0; i < limit.n_shared; i++) {
        const double *u[3] = {run[0].u, run[1].u, run[2].u};
        const double before = u[1][i] + (u[1][i] - u[0][i]) / (ratio - 1.0);
        close_to(limit.u[i], u[2][i] + (u[2][i] - u[1][i]) / (ratio - 1.0),
                 1e-3 * floor);
        off += pow(before - limit.u[i], 2);
        size += pow(limit.u[i], 2);
    }
    close_to(floor, sqrt(off / size) / ratio, 0.02 * floor);
}

/* Cost c n^3 for an error of n^-2: at any error what the formula says. */
static void costs_are_between_two_meshes(void)
{
    const double error[] = {1.0 / 16, 1.0 / 64, 1.0 / 256};
    const double cost[] = {64.0, 512.0, 4096.0};
    ck_assert_double_eq(trial_at(0.1, 3, error, cost), 64.0);
    for (double wanted = 0.06; wanted > 0.004; wanted *= 0.9)
        close_to(trial_at(wanted, 3, error, cost) * pow(wanted, 1.5), 1.0,
                 1e-12);
    ck_assert(trial_at(0.0038, 3, error, cost) == INFINITY);
    ck_assert(trial_at(0.01, 2, error, cost) == INFINITY);
}

UNIT_MAIN("hang",
    LAW(averages_are_of_lambda),
    LAW(all_elements_have_one_limit),
    LAW(a_cross_is_its_own_mirror_image),
    LAW(a_weight_is_fifty_of_one),
    LAW(trials_rest_and_move),
    LAW(trials_are_those_of_their_scenes),
    LAW(what_fails_is_said),
    LAW(a_limit_goes_on_as_three_meshes_do),
    LAW(costs_are_between_two_meshes))
