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
    static const char *const name[DRAWN_KINDS] = {"pulled", "pressed",
                                                  "clamped", "moving"};
    return name[kind];
}

static double between(gsl_rng *random, double low, double high)
{
    return low + (high - low) * gsl_rng_uniform(random);
}

struct ladder_scene drawn_scene(gsl_rng *random, enum drawn_kind kind)
{
    struct ladder_scene s = {.name = drawn_name(kind), .finest = 2};
    s.slender = exp(between(random, 0.0, log(6.0)));
    s.nu = between(random, 0.0, 0.48);
    const double height = 2.0 / s.slender, stiff = 1000.0 * pow(height, 3);
    const double bend = 0.2 * exp(between(random, log(1e-3), 0.0));
    const double share = kind == PRESSED ? -between(random, 0.0, 0.9)
                                         : between(random, 0.0, 3.0);
    s.pull[0] = fmin(share * ladder_buckles(&s) / height, 300.0);
    s.pull[0] = fmax(s.pull[0], -100.0);
    s.weight[1] = -bend * stiff / 12.0 / height; /* bends by w L^4 / (8 E I) */
    s.couple = between(random, -2.0, 2.0) * bend * 500.0;
    if (kind == CLAMPED) {
        s.held = LADDER_ENDS;
        s.push[1] = 8.0 * s.weight[1] * height;
        s.weight[0] = between(random, -1.0, 1.0) * 20.0 / s.slender;
        s.pull[0] = s.couple = 0.0;
    }
    if (kind == MOVING) {
        const double swing = 3.52 / s.slender * sqrt(1000.0 / 3.0) / 2.0;
        s.time = RISES;
        s.T = exp(between(random, log(0.3), log(30.0))) / swing;
        s.end = s.T + 3.2 / swing;
        s.dt = fmin(s.T, 2.0 / swing) / 16.0;
        s.dt = fmax(s.dt, s.end / 150.0);
        s.finest = 1;
    }
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
