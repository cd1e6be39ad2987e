/* numbers.c - laws of figures/23_least_model/numbers.h and drawn.h. */
#include "figures/23_least_model/drawn.h"
#include "figures/23_least_model/numbers.h"

#include "unit.h"

#include <math.h>

/* 1 at the load of Euler, and of Greenhill under its own weight: 7.8373. */
static void a_force_is_measured_by_what_buckles(void)
{
    for (int slender = 1; slender <= 8; slender *= 2) {
        struct ladder_scene s = {.slender = slender, .nu = 0.37};
        const double height = 2.0 / slender, P = ladder_buckles(&s);
        s.pull[0] = -0.7 * P / height;
        close_to(numbers_of(&s).force, 0.7, 1e-12);
        s.pull[0] *= -1.0;
        close_to(numbers_of(&s).force, -0.7, 1e-12);
        s.weight[0] =
            -1.2 * 7.8373 * P / pow(0.5 * acos(-1.0), 2) / (2.0 * height);
        close_to(numbers_of(&s).force, 1.2 - 0.7, 1e-3);
    }
}

/* They are those of the linear answer at rest; turned is the larger of two. */
static void numbers_are_those_of_the_linear_answer(void)
{
    /* after a rise a body goes at most twice as far */
    static const struct {
        enum ladder_time time;
        double T;
    } motion[] = {{STANDS, 0.0}, {RISES, 0.6}, {RISES, 0.03}, {SWINGS, 0.03}};
    for (int k = 0; k < 2 * COUNT(motion); k++) {
        const enum ladder_time time = motion[k / 2].time;
        struct ladder_scene scene = {.slender = 4, .nu = 0.3,
            .weight = {0.0, k % 2 ? -1.0 : -0.01}, .pull = {4.0, 0.0},
            .time = time, .T = motion[k / 2].T, .dt = 0.1, .end = 2.0};
        struct ladder_state *s = ladder_solve(
            &scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
        const struct numbers n = numbers_of(&scene);
        close_to(n.strain, estimate_strain(s), 1e-12);
        close_to(n.geometry, estimate_geometry(s), 1e-12);
        close_to(n.bends, estimate_dimension(s), 1e-12);
        close_to(n.strained, 1.3 / 1.4 * n.strain, 1e-12);
        close_to(n.moves, time != STANDS ? estimate_inertia(s) : 0.0, 1e-12);
        const double pulled = fabs(n.force) * n.bends;
        const double farther = k / 2 == 2 ? 2.0 : 1.0 + 2.0 * n.moves;
        close_to(n.turned, farther * fmax(n.geometry, pulled), 1e-12);
        ck_assert(n.force < -0.1 && (n.moves > 0.0) == (time != STANDS));
        ck_assert((n.moves > 0.5) == (k / 2 >= 2));
        ladder_free(s);
    }
    const struct numbers is[] = {{.turned = 0.11, .bends = 0.0},
                                 {.strained = 0.11}, {.bends = 0.11},
                                 {.moves = 0.051},
                                 {.strain = 0.2, .strained = 0.1,
                                  .bends = 0.1, .moves = 0.05, .turned = 0.1}};
    const enum rung rung[] = {CUBIC_PLANE, CUBIC_PLANE, LINEAR_PLANE,
                              LINEAR_PLANE, BAR};
    for (int k = 0; k < COUNT(is); k++)
        ck_assert_int_eq(numbers_rung(is[k], 0.1), rung[k]);
    for (int k = 0; k < COUNT(is); k++)
        ck_assert_int_eq(numbers_moving(is[k], 0.1), k == 3);
}

/* Least and most of a number, which are to be `low` and `high`, or nearly. */
struct range {
    double least, most;
};
static void take(struct range *r, double x)
{
    if (r->least == 0.0 && r->most == 0.0) r->least = r->most = x;
    r->least = fmin(r->least, x);
    r->most = fmax(r->most, x);
}
static void spans(struct range r, double low, double high)
{
    const double part = 0.02 * (high - low);
    ck_assert_msg(r.least >= low - 1e-12 && r.most <= high + 1e-12 &&
                  r.least <= low + part && r.most >= high - part,
                  "%g to %g, not %g to %g", r.least, r.most, low, high);
}

/* Each number of a scene is in the range of drawn.h, and in all of it. */
static void random_scenes_are_as_said(void)
{
    enum { SCENES = 2000 };
    gsl_rng *random = drawn_start(2385);
    for (int kind = PULLED; kind < DRAWN_KINDS; kind++) {
        const int pressed = kind == PRESSED || kind == PRESSED_MOVING;
        const int moves = kind > CLAMPED;
        struct range slender = {0.0, 0.0}, nu = slender, bends = slender,
                     turns = slender, across = slender, along = slender,
                     weighs = slender, rises = slender;
        int straight = 0, clamped = 0, swings = 0;
        for (int k = 0; k < SCENES; k++) {
            const struct ladder_scene s =
                drawn_scene(random, (enum drawn_kind)kind);
            const double L = 2.0, h = L / s.slender, EI = pow(h, 3) * 1e3 / 12;
            const double bend = -s.weight[1] * h * pow(L, 3) / (8.0 * EI);
            const int ends = s.held == LADDER_ENDS;
            take(&slender, log(s.slender));
            take(&nu, s.nu);
            clamped += ends;
            straight += ladder_symmetric(&s) && !ends;
            swings += s.time == SWINGS;
            if (s.weight[1] != 0.0 && s.weight[1] > -50.0) {
                take(&bends, log(bend));
                if (fabs(s.couple * h) < 200.0)
                    take(&turns, s.couple * pow(h, 3) / 24 * L / EI / bend);
                take(&across, s.pull[1] * h * L * L / 3.0 / EI / bend);
            }
            if (ends) take(&weighs, s.weight[0] * s.slender);
            else take(&along, ladder_pressed(&s));
            close_to(s.push[1], ends ? fmax(-100.0, 8.0 * s.weight[1] * h) : 0,
                     1e-12);
            ck_assert(fabs(s.couple * h) <= 200.1 && fabs(s.pull[1]) <= 100.0);
            ck_assert(s.pull[0] >= (pressed ? -100.1 : 0.0) &&
                      s.pull[0] <= (pressed ? 0.0 : 300.1));
            ck_assert_int_eq(s.time != STANDS, moves);
            ck_assert_int_eq(s.finest, moves ? 1 : 2);
            ck_assert_str_eq(s.name, drawn_name((enum drawn_kind)kind));
            if (!moves) continue;
            const double slow = hypot(s.slender / (ends ? 102.0 : 16.0),
                                      1.0 / (ends ? 29.0 : 14.3));
            take(&rises, log(s.T / slow));
            ck_assert(s.end >= (s.time == RISES ? 1.0 : 1.6) * s.T);
            ck_assert(s.dt >= s.end / 150.1 && s.dt < s.end / 15.0);
        }
        spans(slender, log(0.5), log(12.0));
        spans(nu, 0.0, 0.49);
        spans(bends, log(2e-4), log(0.2));
        if (kind == CLAMPED)
            spans(weighs, -20.0, 20.0);
        else {
            spans(turns, -1.0, 1.0);
            spans(across, -1.0, 1.0);
            spans(along, pressed ? 0.0 : -3.0, pressed ? 0.9 : 0.0);
        }
        if (moves) spans(rises, log(0.3), log(30.0));
        const double part = kind == CLAMPED ? 1.0
                            : kind == RISING || kind == SWINGING ? 0.25 : 0.0;
        const double error = 4.0 * sqrt(0.25 / SCENES); /* four standard ones */
        close_to((double)clamped / SCENES, part, error);
        close_to((double)straight / SCENES, (1.0 - part) / 8.0, error);
        close_to((double)swings / SCENES, kind == SWINGING ? 1.0 :
                 kind == PRESSED_MOVING ? 0.25 : 0.0, error);
    }
    gsl_rng_free(random);
}

/* Squares: along at most `most` of what buckles, across 4 slender less; each of
 * four loads is there in 6 of 10, with either sign; sizes by decades. */
static void random_squares_are_as_said(void)
{
    enum { SCENES = 4000 };
    gsl_rng *random = drawn_start(3714);
    int there[4] = {0}, positive[4] = {0}, of_size[4] = {0};
    struct range size[4] = {{0.0, 0.0}}, nu = {0.0, 0.0};
    for (int k = 0; k < SCENES; k++) {
        const struct ladder_scene s = drawn_squares(random, 0.5, 3.0);
        const double buckles = ladder_buckles(&s) * s.slender / 2.0;
        const double load[4] = {s.weight[0], s.pull[0], s.weight[1], s.pull[1]};
        for (int i = 0; i < 4; i++) {
            if (load[i] == 0.0) continue;
            const double across = i < 2 ? 1.0 : 4.0 * s.slender;
            there[i]++;
            positive[i] += load[i] > 0.0;
            take(&size[i], log(fabs(load[i]) * across / buckles / 0.5));
        }
        take(&nu, s.nu);
        of_size[(int)lround(log2(s.slender))]++;
        ck_assert(s.time == STANDS && s.held == LADDER_LEFT && s.finest == 1);
    }
    for (int i = 0; i < 4; i++) { /* four standard errors */
        close_to((double)there[i] / SCENES, 0.6, 4.0 * sqrt(0.24 / SCENES));
        close_to((double)positive[i] / there[i], 0.5,
                 4.0 * sqrt(0.25 / there[i]));
        close_to((double)of_size[i] / SCENES, 0.25,
                 4.0 * sqrt(0.1875 / SCENES));
        spans(size[i], -3.0, 0.0);
    }
    spans(nu, 0.0, 0.45);
    gsl_rng_free(random);
}

UNIT_MAIN("numbers",
    LAW(a_force_is_measured_by_what_buckles),
    LAW(numbers_are_those_of_the_linear_answer),
    LAW(random_scenes_are_as_said),
    LAW(random_squares_are_as_said))
