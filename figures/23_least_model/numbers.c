/* numbers.c - see numbers.h. */
#include "numbers.h"

#include <math.h>

/* The axial force over the one that buckles a beam, > 0 where it presses: at
 * the end pi^2/4 E' I / L^2, and 7.84 E' I / L^2 is the weight of a column that
 * buckles under itself. */
static double axial(const struct ladder_scene *s)
{
    const double pi = 2.0 * acos(0.0), L = 2.0, height = L / s->slender;
    const double bending =
        1000.0 / (1.0 - s->nu * s->nu) * pow(height, 3) / 12.0 / (L * L);
    return -(s->pull[0] * height / (0.25 * pi * pi) +
             s->weight[0] * L * height / 7.84) / bending;
}

/* How far a motion goes beyond rest, as a fraction: after a load has risen a
 * mode swings up to 2 / (omega T) too far, but never twice as far. */
static double overshoot(enum ladder_time time, double moves)
{
    return time == RISES ? fmin(1.0, 2.0 * moves) : 2.0 * moves;
}

/* P = (1 + c e) (2 mu + lambda) e of a bar whose sides are held, to the second
 * order, for both Neo-Hookean laws: what a linear stress lacks. */
static double stress_missed(double nu, double strain)
{
    return 0.5 * (1.0 + nu) / (1.0 - nu) * strain;
}

struct numbers numbers_of(const struct ladder_scene *scene)
{
    struct ladder_state *s =
        ladder_solve(scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
    const double strain = estimate_strain(s);
    struct numbers n = {.strained = stress_missed(scene->nu, strain),
                        .strain = strain,
                        .geometry = estimate_geometry(s),
                        .bends = estimate_dimension(s), .force = axial(scene)};
    if (scene->time != STANDS) n.moves = estimate_inertia(s);
    n.turned = (1.0 + overshoot(scene->time, n.moves)) *
               fmax(n.geometry, fabs(n.force) * n.bends);
    ladder_free(s);
    return n;
}

enum rung numbers_rung(struct numbers n, double tolerance)
{
    if (n.strained > tolerance || n.turned > tolerance) return CUBIC_PLANE;
    return n.bends > tolerance || numbers_moving(n, tolerance) ? LINEAR_PLANE
                                                               : BAR;
}

int numbers_moving(struct numbers n, double tolerance)
{
    return 2.0 * n.moves > tolerance;
}
