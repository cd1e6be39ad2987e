/* work.c - laws of work.h and trials.h of figures/work_precision/. */
#include "figures/study/study.h"
#include "base/table.h"
#include "figures/work_precision/trials.h"

#include "unit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct work_setting setting(enum work_scene scene, enum law law,
                                   int dynamic, int n, int steps,
                                   enum method method)
{
    return (struct work_setting){scene, law, dynamic, n, steps, method, 1e-10,
                                 LINEAR_TRIANGLE, 1.0};
}

static struct work run(enum work_scene scene, enum law law, int dynamic, int n,
                       int steps, enum method method)
{
    const struct work_setting set =
        setting(scene, law, dynamic, n, steps, method);
    const struct work work = work_run(&set);
    ck_assert_msg(work.status == OK, "%s", work_scene_name(scene));
    return work;
}

/* Component k of column i and row j of the shared vertices. */
static double at(const struct work *work, int i, int j, int k)
{
    return work->u[2 * (5 * j + i) + k];
}

static void scenes_end_where_they_say(void)
{
    static const double right[] = {0.42, 0.6, 0.0, 0.0, -0.1, -0.6,
                                   0.42073549240394825, 0.0};
    static const double left[] = {-0.42, 0.0, 0.0, 0.0, 0.1, 0.0,
                                  -0.42073549240394825, 0.0};
    static const char *const name[] = {"slow_pull", "fast_pull", "shake",
                                       "swing", "buckle", "push", "jolted_pull",
                                       "weight"};
    for (int s = 0; s < WORK_SCENES; s++) {
        const enum work_scene scene = (enum work_scene)s;
        const int n = work_coarsest(scene), last = s == BUCKLE ? 1 : 4;
        const struct work end = run(scene, LOG, 1, n, 8, BACKWARD_EULER);
        ck_assert_str_eq(work_scene_name(scene), name[s]);
        ck_assert_int_eq(n, s == BUCKLE ? 8 : 4);
        ck_assert_int_eq(end.n_shared, s == BUCKLE ? 20 : 50);
        for (int j = 0; j <= last; j++) {
            const double tilt = s == BUCKLE ? 0.1 * (j - 0.5) / 4.0 : 0.0;
            close_to(at(&end, 0, j, 0), left[s] + tilt, 1e-14);
            if (s != SHAKE && s != WEIGHT)
                close_to(at(&end, 4, j, 0), right[s] - tilt, 1e-14);
            close_to(at(&end, 0, j, 1), 0.0, 1e-14);
        }
        if (s == SHAKE) ck_assert(fabs(at(&end, 4, 2, 1)) > 0.01);
        if (s == WEIGHT) ck_assert(at(&end, 4, 2, 1) < -0.3);
    }
}

/* Pull, fast pull and push are one linear problem and a shift. */
/* A hump of (0.1, 0.2) (1 - X1^2)^2 (1 - X2^2)^2. */
static void a_hump_is_plucked(void)
{
    const struct work_setting set =
        setting(SWING, LOG, 1, 4, 8, BACKWARD_EULER);
    struct scene *s = work_alloc(&set);
    double *u = allocate((size_t)s->n_dof, sizeof *u);
    work_pluck(s, u);
    for (int j = 0; j <= 4; j++)
        for (int i = 0; i <= 4; i++) {
            static const double of[] = {0.0, 0.5625, 1.0, 0.5625, 0.0};
            for (int k = 0; k < 2; k++)
                close_to(u[2 * (5 * j + i) + k], 0.1 * (k + 1) * of[i] * of[j],
                         1e-15);
        }
    free(u);
    scene_free(s);
}

static void linear_answers_need_one_system(void)
{
    const struct work once = run(SLOW_PULL, LINEAR, 0, 8, 1, BACKWARD_EULER);
    const struct work often = run(SLOW_PULL, LINEAR, 0, 8, 7, BACKWARD_EULER);
    close_to(work_distance(&once, &often), 0.0, 1e-13);
    ck_assert_int_eq(once.systems, 1);
    ck_assert_int_eq(often.systems, 7);
    ck_assert_int_eq(often.factorisations, 1);
    const struct work moving = run(SHAKE, LINEAR, 1, 4, 9, BACKWARD_EULER);
    ck_assert_int_eq(moving.systems, 9);
    ck_assert_int_eq(moving.factorisations, 1);
    /* BDF2 has a first step of half the length */
    ck_assert_int_eq(run(SHAKE, LINEAR, 1, 4, 9, BDF2).factorisations, 2);
}

static void slow_is_static(void)
{
    for (int law = LINEAR; law <= CUBIC; law++) {
        const struct work rest =
            run(SLOW_PULL, (enum law)law, 0, 4, 4, BACKWARD_EULER);
        const struct work slow =
            run(SLOW_PULL, (enum law)law, 1, 4, 64, BACKWARD_EULER);
        const struct work fast =
            run(FAST_PULL, (enum law)law, 1, 4, 64, IMPLICIT_MIDPOINT);
        const struct work still =
            run(FAST_PULL, (enum law)law, 0, 4, 4, BACKWARD_EULER);
        ck_assert(work_distance(&rest, &slow) < 1e-4);
        ck_assert(work_distance(&still, &fast) > 0.1);
    }
}

/* All methods go to one limit, with their orders; the linear law as well. */
static void methods_have_their_orders(void)
{
    const struct work ends[] = {
        run(FAST_PULL, LINEAR, 1, 4, 1024, IMPLICIT_MIDPOINT),
        run(FAST_PULL, LOG, 1, 4, 1024, IMPLICIT_MIDPOINT)};
    for (int k = 0; k < 7; k++) {
        const enum method method = (enum method)(k < 4 ? k : k - 3);
        const enum law law = k < 4 ? LOG : LINEAR;
        const struct work end = ends[law];
        const struct work coarse = run(FAST_PULL, law, 1, 4, 64, method);
        const struct work fine = run(FAST_PULL, law, 1, 4, 128, method);
        const double order = study_order(work_distance(&coarse, &end),
                                      work_distance(&fine, &end), 2.0);
        close_to(order, method == BACKWARD_EULER ? 1.0 : 2.0, 0.1);
    }
    /* a swing moves */
    const struct work swing = run(SWING, LOG, 1, 4, 64, IMPLICIT_MIDPOINT);
    const struct work later = run(SWING, LOG, 1, 4, 128, SYMPLECTIC_EULER);
    ck_assert(work_distance(&swing, NULL) > 0.02);
    ck_assert(work_distance(&swing, &later) <
              0.1 * work_distance(&swing, NULL));
}

/* By the textbook's sums: 30 unknowns, half bandwidth 7, 32 triangles. */
static void work_is_counted(void)
{
    double factor = 0.0, solve = 0.0;
    for (int k = 0; k < 30; k++) {
        const int below = k < 22 ? 7 : 29 - k;
        factor += (below + 1) * (below + 1);
        solve += 2 * (2 * below + 1);
    }
    const struct work once = run(SLOW_PULL, LINEAR, 0, 4, 1, BACKWARD_EULER);
    close_to(once.flops, factor + 250.0 * 32 + solve + 100.0 * 32, 1e-9);
    const struct work moving = run(SLOW_PULL, LINEAR, 1, 4, 5, BACKWARD_EULER);
    close_to(moving.flops, factor + 250.0 * 32 + 5 * solve + 9 * 100.0 * 32,
             1e-9);
    const struct work leapt = run(FAST_PULL, LOG, 1, 4, 64,
                                     SYMPLECTIC_EULER);
    close_to(leapt.flops, 64 * 100.0 * 32, 1e-9);
    ck_assert_int_eq(leapt.systems, 0);
    struct work_setting loose = setting(PUSH, LOG, 1, 8, 8, BACKWARD_EULER);
    const struct work tight = work_run(&loose);
    loose.tolerance = 1e-2;
    const struct work cheap = work_run(&loose);
    ck_assert(cheap.systems < tight.systems);
    ck_assert(work_distance(&cheap, &tight) > 0.0);
    ck_assert(cheap.seconds > 0.0);
}

/* n = 4 by quadratic triangles: 8 of them, the same unknowns; linear answers by
 * their law alone scale, and are those of one system. */
static void other_elements_are_counted(void)
{
    struct work_setting set = setting(FAST_PULL, LOG, 1, 4, 64,
                                      SYMPLECTIC_EULER);
    set.element = QUADRATIC_TRIANGLE;
    const struct work leapt = work_run(&set);
    ck_assert_int_eq(leapt.status, OK);
    close_to(leapt.flops, 64 * 400.0 * 8, 1e-9);
    set = setting(WEIGHT, LINEAR, 0, 8, 1, BACKWARD_EULER);
    set.element = QUADRATIC_TRIANGLE;
    set.grade = 1.5;
    const struct work once = work_run(&set);
    set.steps = 3;
    const struct work often = work_run(&set);
    ck_assert_int_eq(once.factorisations, 1);
    close_to(work_distance(&once, &often), 0.0, 1e-12);
    ck_assert_double_gt(work_distance(&once, NULL), 0.1);
}

/* The explicit method has lost this scene when it has made four steps, and what
 * is beyond 100 m is then on the left alone. */
static void what_is_lost_is_lost_on_each_side(void)
{
    const struct work_setting set =
        setting(PUSH, CUBIC, 1, 8, 6, SYMPLECTIC_EULER);
    const struct work lost = work_run(&set);
    double least = 0.0, most = 0.0;
    for (int i = 0; i < lost.n_shared; i++) {
        least = fmin(least, lost.u[i]);
        most = fmax(most, lost.u[i]);
    }
    ck_assert(least < -150.0 && most < 95.0);
    ck_assert_int_eq(lost.status, NONFINITE);
    ck_assert_int_eq(lost.steps, 4);
}

static void failures_have_no_answer(void)
{
    const struct work_setting set =
        setting(SLOW_PULL, LOG, 1, 4, 4, SYMPLECTIC_EULER);
    const struct work lost = work_run(&set);
    const struct work there = run(SLOW_PULL, LOG, 0, 4, 1, BACKWARD_EULER);
    struct work sum = there;
    ck_assert(lost.status != OK);
    ck_assert(work_distance(&lost, NULL) == INFINITY);
    ck_assert(work_distance(&there, &lost) == INFINITY);
    work_correct(&sum, 1.0, &there, &lost);
    ck_assert_int_eq(sum.status, lost.status);
    sum = there;
    work_correct(&sum, 1.0, &lost, &there);
    ck_assert_int_eq(sum.status, lost.status);
    /* a step that is too long for the guess still ends well */
    run(FAST_PULL, LOG, 1, 16, 4, IMPLICIT_MIDPOINT);
    /* the cubic law passes through itself, and says so */
    const struct work_setting through =
        setting(PUSH, CUBIC, 1, 48, 16, IMPLICIT_MIDPOINT);
    const struct work inside = work_run(&through);
    ck_assert_int_eq(inside.status, INVERTED);
    ck_assert(inside.min_J <= 0.0);
}

static void corrections_add_up(void)
{
    const struct work a = {.n_shared = 4, .u = {1.0, 2.0, 3.0, 4.0}};
    const struct work b = {.n_shared = 4, .u = {0.5, 1.0, 4.0, 2.0}};
    struct work c = a;
    work_correct(&c, 0.5, &a, &b);
    close_to(c.u[0], 1.25, 1e-15);
    close_to(c.u[2], 2.5, 1e-15);
    close_to(c.u[3], 5.0, 1e-15);
    close_to(work_distance(&a, &b),
             sqrt((0.25 + 1.0 + 1.0 + 4.0) / 2.0), 1e-15);
}

/* Closer to finer meshes and steps than they are to each other. */
static void limits_are_limits(void)
{
    const struct work_setting rest = setting(SLOW_PULL, LINEAR, 0, 0, 0,
                                             BACKWARD_EULER);
    const struct work_setting swing = setting(SWING, LINEAR, 1, 0, 0,
                                              BACKWARD_EULER);
    double floor, moving_floor;
    const struct work limit = work_limit(&rest, &floor);
    const struct work n48 = run(SLOW_PULL, LINEAR, 0, 48, 1, BACKWARD_EULER);
    const struct work n96 = run(SLOW_PULL, LINEAR, 0, 96, 1, BACKWARD_EULER);
    const double apart = work_distance(&n48, &n96);
    ck_assert(work_distance(&limit, &n96) < 0.6 * apart);
    ck_assert(floor > 0.0 && floor < apart);
    const struct work moving = work_limit(&swing, &moving_floor);
    struct work mesh[3];
    for (int k = 0; k < 3; k++)
        mesh[k] = run(SWING, LINEAR, 1, 12 << k, 32, IMPLICIT_MIDPOINT);
    const struct work late =
        run(SWING, LINEAR, 1, 24, 128, IMPLICIT_MIDPOINT);
    const double ratio = work_distance(&mesh[0], &mesh[1]) /
                         work_distance(&mesh[1], &mesh[2]);
    ck_assert(ratio > 2.0 && ratio < 4.0);
    for (int i = 0; i < moving.n_shared; i++)
        close_to(moving.u[i],
                 mesh[2].u[i] + (mesh[2].u[i] - mesh[1].u[i]) / (ratio - 1.0) +
                     16.0 / 15.0 * (late.u[i] - mesh[1].u[i]), 1e-12);
    ck_assert(moving_floor > 0.0 &&
              moving_floor < work_distance(&mesh[1], &mesh[2]));
}

/* ---- trials.h ------------------------------------------------------------ */

static int same(const struct work_setting *a, const struct work_setting *b)
{
    return a->law == b->law && a->dynamic == b->dynamic && a->n == b->n &&
           a->steps == b->steps && a->method == b->method &&
           a->tolerance == b->tolerance;
}

static const struct trials *asked;
static int row;

static void print_the_row(void)
{
    table_begin("row", "scene asked law method n steps tolerance error flops "
                       "status systems element grade floor");
    trials_row(asked, row, 0.25);
    exit(table_finish());
}

static void rows_say_what_was_tried(const struct trials *s)
{
    asked = s;
    for (row = 0; row < s->all; row += 25) {
        const struct work_setting *set = &s->set[row];
        const struct work *work = &s->work[row];
        char want[200];
        snprintf(want, sizeof want, "\n%s\t0.25\t%s\t%s\t%d\t%d\t%.17g\t",
                 work_scene_name(s->scene), material_law(set->law),
                 set->dynamic ? method_name(set->method) : "static", set->n,
                 set->steps, set->tolerance);
        const struct outcome end = outcome_of(print_the_row);
        ck_assert_msg(strstr(end.out, want) != NULL, "%s, not %s", end.out,
                      want);
        snprintf(want, sizeof want, "\t%s\t%d\t%s\t%g\t%.3e\n",
                 status_name(work->status), work->systems,
                 set->element ? "quadratic" : "linear",
                 set->grade > 1.0 ? set->grade : 1.0, s->floor);
        ck_assert_msg(strstr(end.out, want) != NULL, "%s, not %s", end.out,
                      want);
    }
}

static void sweeps_know_the_cheapest(void)
{
    struct trials *s = trials_alloc(BUCKLE, 1);
    int dynamic = 0, leapt = 0;
    ck_assert_int_eq(s->count, 276);
    for (int k = 0; k < s->count; k++) {
        const struct work_setting *set = &s->set[k];
        dynamic += set->dynamic;
        leapt += set->dynamic && set->method == SYMPLECTIC_EULER;
        for (int i = 0; i < k; i++)
            ck_assert(!same(set, &s->set[i]));
        const int best = trials_cheapest(s, s->count, s->error[k]);
        if (s->error[k] == INFINITY) continue;
        ck_assert(s->error[best] <= s->error[k]);
        ck_assert(s->work[best].flops <= s->work[k].flops);
        for (int i = 0; i < s->count; i++)
            ck_assert(s->error[i] > s->error[k] ||
                      s->work[i].flops >= s->work[best].flops);
    }
    ck_assert_int_eq(s->all, 417);
    for (int k = s->count; k < s->all; k++)
        ck_assert(s->set[k].element == QUADRATIC_TRIANGLE ||
                  s->set[k].grade == 1.5);
    /* two rows of linear triangles do not bend, one of quadratic ones does */
    ck_assert_double_gt(s->error[trials_cheapest(s, s->count, 0.3)], 0.15);
    ck_assert_double_lt(s->error[trials_cheapest(s, s->all, 0.06)], 0.06);
    ck_assert_int_eq(trials_cheapest(s, s->count, 0.06), -1);
    ck_assert_double_lt(s->floor, 1e-3);
    ck_assert_int_eq(dynamic, 249);
    ck_assert_int_eq(leapt, 24);
    ck_assert_int_eq(trials_cheapest(s, s->count, 0.0), -1);
    ck_assert(s->floor > 0.0 && s->floor < 0.1 && s->size > 0.1);
    rows_say_what_was_tried(s);
    trials_free(s);
}

UNIT_MAIN("work",
    LAW(scenes_end_where_they_say),
    LAW(a_hump_is_plucked),
    LAW(linear_answers_need_one_system),
    LAW(slow_is_static),
    LAW(methods_have_their_orders),
    LAW(work_is_counted),
    LAW(other_elements_are_counted),
    LAW(what_is_lost_is_lost_on_each_side),
    LAW(failures_have_no_answer),
    LAW(corrections_add_up),
    LAW(limits_are_limits),
    LAW(sweeps_know_the_cheapest))
