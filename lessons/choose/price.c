/* price.c - see price.h. */
#include "price.h"

#include "base/clock.h"
#include "choice/rung.h"

#include <math.h>

static const double enough = 0.1; /* s */
static const double a_while = 2e-3; /* twenty ticks of a browser's clock (s) */

/* Return the least time of the scene's solve, over its columns (s): the mean of
 * as many as take a while. */
static double timed(enum element element, double grade,
                    const struct ladder_scene *scene, struct ladder_model model,
                    int *systems)
{
    double best = INFINITY;
    const double start = clock_processor();
    do {
        double took = 0.0;
        int columns = 0;
        while (took < a_while) {
            struct ladder_state *s =
                ladder_alloc_of(element, grade, scene, model);
            const double before = clock_processor();
            rung_solve(s);
            took += clock_processor() - before;
            columns += s->mesh->n;
            *systems = s->systems;
            ladder_free(s);
        }
        best = fmin(best, took / columns);
    } while (clock_processor() - start < enough);
    return best;
}

struct price price_calibrate(enum element element, double grade,
                             struct ladder_model model)
{
    struct ladder_scene scene = {.slender = 4, .nu = 0.3,
        .weight = {0.0, -0.5}, .time = model.moving ? RISES : STANDS,
        .T = 1.0, .dt = 0.02, .end = 0.2, .finest = model.level};
    int few, many;
    const double once = timed(element, grade, &scene, model, &few);
    if (!model.moving || model.rung != LINEAR_PLANE)
        return (struct price){0.0, once / few};
    scene.end = 1.0; /* one factorisation for more steps */
    const double longer = timed(element, grade, &scene, model, &many);
    const double system = (longer - once) / (many - few);
    return (struct price){fmax(0.0, once - few * system), system};
}

double price_seconds(const struct ladder_state *s, struct price price)
{
    return s->mesh->n * (price.begin + s->systems * price.system);
}

double price_frames(const struct ladder_state *s)
{
    return s->model.moving ? floor(s->scene->end / ladder_step(s) + 0.5) : 1.0;
}

int price_columns(const struct ladder_state *s, const struct price price[],
                  int n, double seconds)
{
    const double frames = price_frames(s), coarsest =
        (double)s->mesh->n / (1 << s->model.level);
    double t[2] = {0.0, 0.0}, power = 1.0;
    int level = 0;
    for (; level < n && t[1] <= seconds; level++) {
        t[0] = t[1];
        t[1] = coarsest * (1 << level) / frames *
               (price[level].begin + s->systems * price[level].system);
    }
    if (level > 1) power = log2(t[1] / t[0]);
    return (int)(coarsest * (1 << (level - 1)) *
                 pow(seconds / t[1], 1.0 / power));
}
