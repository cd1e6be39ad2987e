/*
 * cliff.c - what does symplectic Euler do 1 % below its critical step, and 1 %
 * above it?
 *
 * The square, n = 8, both ends held, lumped mass, from a ripple of all modes:
 * energy over that of the start.  A table ends when it is above 1e8.  growth is
 * what the energy of the fastest mode should be multiplied by per step
 * [eq:amplification]; below, an invariant bounds the energy by (1 + 0.99) /
 * (1 - 0.99) [eq:critical-step].
 */
#include "frequency.h"
#include "motion/integrate.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

struct run {
    int steps;
    double growth;    /* due, per step */
    double largest;   /* of the energies */
    double logarithm; /* of the growth per step, over the last ten */
};

/* At `side` of the critical step of the model. */
static struct run print_run(struct model *model, double side, const char *name)
{
    const double dt = side * 2.0 / frequency_largest(model);
    const double half_trace = 2.0 * side * side - 1.0;
    struct state s = state_ripple(model);
    const double start = model_energy(model, s.u, s.v);
    struct run run = {.growth =
                          side > 1.0 ? exp(2.0 * acosh(half_trace)) : 1.0};
    double E[301];

    table_begin(name, "k t energy growth");
    for (int k = 0; k <= 300; k++) {
        E[k] = model_energy(model, s.u, s.v) / start;
        if (!(E[k] < 1e8)) break;
        table_row(k, k * dt, E[k], run.growth);
        run.steps = k;
        run.largest = fmax(run.largest, E[k]);
        if (integrate_step(model, SYMPLECTIC_EULER, dt, NULL, &s).status != OK)
            break;
    }
    table_end();
    if (run.steps >= 10)
        run.logarithm = log(E[run.steps] / E[run.steps - 10]) / 10.0;
    state_free(&s);
    return run;
}

int main(void)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 8);
    set.mass = LUMPED;
    struct scene *scene = scene_alloc(&set);
    struct model *model = model_body(scene->body);
    const struct run below = print_run(model, 0.99, "cliff_below");
    const struct run above = print_run(model, 1.01, "cliff_above");
    model_free(model);
    scene_free(scene);

    claim(below.steps == 300 && below.largest < 1.99 / 0.01,
          "at 0.99 the energy stays below 199 times that of the start for 300 "
          "steps (%d steps, %g times)", below.steps, below.largest);
    claim(above.steps > 20 && above.steps < 200 &&
              fabs(above.logarithm / log(above.growth) - 1.0) < 0.02,
          "at 1.01 the energy passes 1e8 with the growth %g of the fastest "
          "mode (after %d steps, with %g)", above.growth, above.steps,
          exp(above.logarithm));
    return table_finish();
}
