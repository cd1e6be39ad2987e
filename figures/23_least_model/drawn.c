/* drawn.c - see drawn.h. */
#include "drawn.h"

#include <math.h>

gsl_rng *drawn_start(unsigned long seed)
{
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, seed);
    return random;
}

const char *drawn_name(enum drawn_kind kind)
{
    static const char *const name[DRAWN_KINDS] = {
        "pulled", "pressed", "clamped", "rising", "swinging", "pressed-moving"};
    return name[kind];
}

static double between(gsl_rng *random, double low, double high)
{
    return low + (high - low) * gsl_rng_uniform(random);
}

static int one_in(gsl_rng *random, unsigned long n)
{
    return gsl_rng_uniform_int(random, n) == 0;
}

static double at_most(double most, double x)
{
    return fmax(-most, fmin(most, x));
}

/* What bends a beam by a part `bend` of its length: weight, and a couple and a
 * pull across that may bend as much. */
static void draw_across(gsl_rng *random, double bend, struct ladder_scene *s)
{
    const double height = 2.0 / s->slender;
    const double stiff = 1000.0 * pow(height, 3);
    s->weight[1] = -fmin(50.0, bend * stiff / 12.0 / height);
    s->couple = between(random, -2.0, 2.0) * bend * 500.0;
    s->couple = at_most(200.0 / height, s->couple);
    s->pull[1] = at_most(100.0, between(random, -1.0, 1.0) * 0.75 *
                                    s->weight[1]);
    if (one_in(random, 8)) s->weight[1] = s->couple = s->pull[1] = 0.0;
}

/* Along the axis `share` of what buckles it, < 0: pulled; by a part of it that
 * is the weight. */
static void draw_along(double share, double by_weight, struct ladder_scene *s)
{
    s->pull[0] = -(1.0 - by_weight);
    s->weight[0] = -by_weight / 2.0;
    const double scale = share / ladder_pressed(s);
    const double most = share > 0.0 ? 100.0 : 300.0;
    s->pull[0] *= fmin(most, fabs(scale)) * (share > 0.0 ? 1.0 : -1.0);
    s->weight[0] *= fmin(most, fabs(scale)) * (share > 0.0 ? 1.0 : -1.0);
}

static void draw_clamped(gsl_rng *random, double bend, struct ladder_scene *s)
{
    draw_across(random, bend, s);
    s->held = LADDER_ENDS;
    s->push[1] = at_most(100.0, 16.0 * s->weight[1] / s->slender);
    s->weight[0] = between(random, -1.0, 1.0) * 20.0 / s->slender;
    s->pull[1] = s->couple = 0.0;
}

/* The first frequency across of a beam with shear, about. */
static double first_frequency(const struct ladder_scene *s)
{
    const int ends = s->held == LADDER_ENDS;
    return 1.0 / hypot(s->slender / (ends ? 102.0 : 16.0),
                       1.0 / (ends ? 29.0 : 14.3));
}

static void draw_motion(gsl_rng *random, int swings, struct ladder_scene *s)
{
    const double first = first_frequency(s);
    s->T = exp(between(random, log(0.3), log(30.0))) / first;
    s->time = swings ? SWINGS : RISES;
    s->end = swings ? between(random, 1.6, 9.0) * s->T
                    : s->T + between(random, 0.0, 6.4) / first;
    s->dt = fmax(fmin(s->T, 2.0 / first) / 16.0, s->end / 150.0);
    s->finest = 1;
}

struct ladder_scene drawn_scene(gsl_rng *random, enum drawn_kind kind)
{
    struct ladder_scene s = {.name = drawn_name(kind), .finest = 2};
    const int pressed = kind == PRESSED || kind == PRESSED_MOVING;
    s.slender = exp(between(random, log(0.5), log(12.0)));
    s.nu = between(random, 0.0, 0.49);
    const double bend = 0.2 * exp(between(random, log(1e-3), 0.0));
    if (kind == CLAMPED || (kind > CLAMPED && !pressed && one_in(random, 4)))
        draw_clamped(random, bend, &s);
    else {
        const double share = pressed ? between(random, 0.0, 0.9)
                                     : -between(random, 0.0, 3.0);
        draw_across(random, bend, &s);
        draw_along(share, one_in(random, 2) ? 0.0 : gsl_rng_uniform(random),
                   &s);
    }
    if (kind > CLAMPED)
        draw_motion(random, kind == SWINGING ||
                                (pressed && one_in(random, 4)), &s);
    return s;
}

struct ladder_scene drawn_squares(gsl_rng *random, double most, double spread)
{
    struct ladder_scene s = {.name = "squares", .finest = 1};
    s.slender = 1 << gsl_rng_uniform_int(random, 4);
    s.nu = between(random, 0.0, 0.45);
    const double along = most * ladder_buckles(&s) * s.slender / 2.0;
    double *const load[] = {&s.weight[0], &s.pull[0], &s.weight[1],
                            &s.pull[1]};
    for (int k = 0; k < 4; k++) {
        const double size = along * exp(-between(random, 0.0, spread));
        const double sign = gsl_rng_uniform(random) < 0.5 ? -1.0 : 1.0;
        if (gsl_rng_uniform(random) < 0.6)
            *load[k] = sign * size / (k < 2 ? 1.0 : 4.0 * s.slender);
    }
    return s;
}
