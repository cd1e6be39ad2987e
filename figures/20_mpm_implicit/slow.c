/*
 * slow.c - what do implicit steps save where a load grows slowly?
 *
 * The hanging bar (8 cells, quadratic kernel, four particles per cell, mirror)
 * starts at rest, and its load grows in proportion to time, to 500 N/m after so
 * many periods, 32 h / c.  Ten implicit steps follow it, or explicit ones of
 * 0.69 h / c, about the longest that stability.c allows for every eps; with
 * 0.8 h / c some state on the way is unstable.  The error is the worst of all
 * particles, compared with the static bar [eq:hanging-bar], at each tenth of
 * the load.  FLIP, which damps least; implicit steps to 1e-10 h.
 */
#include "whole_step.h"
#include "step_flops.h"
#include "particles/particle_bodies.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { CELLS = 8, LOADS = 10 };
static const double LOAD = 500.0; /* N/m */

struct slow {
    int steps;
    double flops, error;
};

/* `longest`: of explicit steps, in h / c; 0: an implicit one for each load. */
static struct slow follow(double periods, double longest)
{
    const struct material m = material_notes(CUBIC);
    const double T = 4.0 * periods / sqrt(material_modulus(&m));
    const int each =
        longest == 0.0
            ? 1 : (int)ceil(4.0 * CELLS * periods / longest / LOADS);
    struct cloud bar = cloud_hanging(2, CELLS, 4);
    struct slow out = {.steps = LOADS * each};
    struct particle_step step = {
        .rate = out.steps / T, .wall = MIRROR, .transfer = FLIP};
    for (int load = 0; load < LOADS; load++) {
        for (int k = 1; k <= each; k++) {
            step.g[0] = LOAD * (load * each + k) / out.steps;
            if (longest == 0.0) {
                const struct particle_report report =
                    particles_step(bar.grid, bar.p, m, &step);
                claim(report.status == OK, "an implicit step");
                out.flops += step_flops_implicit(bar, m, MIRROR, &report);
            } else {
                claim(particles_step_explicit(bar.grid, bar.p, m, &step) == OK,
                      "an explicit step");
                out.flops += step_flops_explicit(bar);
            }
        }
        out.error = fmax(out.error, hanging_error(bar.p, &m, step.g[0]).place);
    }
    cloud_free(bar);
    return out;
}

int main(void)
{
    const double periods[] = {10.0, 30.0, 100.0, 300.0};
    double error = 1.0;
    table_begin("slow", "periods explicit_steps explicit_flops explicit_error "
                        "implicit_steps implicit_flops implicit_error times");
    for (int k = 0; k < 4; k++) {
        const struct slow freely = follow(periods[k], 0.69);
        const struct slow solving = follow(periods[k], 0.0);
        const double times = freely.flops / solving.flops;
        table_row(periods[k], freely.steps, freely.flops, freely.error,
                  solving.steps, solving.flops, solving.error, times);
        claim(fabs(solving.error - 6.4e-4) < 1e-5,
              "implicit steps: 6.4e-4 for any time (%g)", solving.error);
        claim(freely.error < error && freely.error > 0.95 * solving.error,
              "explicit ones: less in more periods, but not less than these");
        claim(k < 2 || freely.error < 1.01 * solving.error,
              "in 100 periods or more, the same error");
        claim(fabs(times / periods[k] - 1.35) < 0.05,
              "1.35 times as many flops for each period (%g)", times);
        claim(k == 0 || follow(periods[k], 0.8).error > 1e-2,
              "with 0.8 h / c they do not stay with the static bar");
        error = freely.error;
    }
    table_end();
    return table_finish();
}
