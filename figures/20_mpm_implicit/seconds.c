/*
 * seconds.c - how many times as long as an explicit step does an implicit one
 * take here, and how many times as many flops has it?
 *
 * The free bar of ringing.h with each kernel, FLIP, at the start of its first
 * mode: a step of 1/30 s by Newton's method to 1e-10 h, and one of 80 steps per
 * period to 1e-2 h.  Each time is the best of 41, in which 20 steps are made,
 * each from the same particles.  systems: linear systems of the implicit step;
 * flops_times: implicit over explicit by step_flops.h; times: in microseconds.
 */
#include "whole_step.h"
#include "free_bar.h"
#include "ringing.h"
#include "step_flops.h"
#include "particles/particle_bodies.h"
#include "base/clock.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS = 41, STEPS = 20 };

/* What a step changes of the particles. */
struct kept {
    double *x, *v;
    mat2 *F, *B;
};

static void copy(struct kept to, struct kept from, int n)
{
    memcpy(to.x, from.x, 2 * (size_t)n * sizeof *to.x);
    memcpy(to.v, from.v, 2 * (size_t)n * sizeof *to.v);
    memcpy(to.F, from.F, (size_t)n * sizeof *to.F);
    memcpy(to.B, from.B, (size_t)n * sizeof *to.B);
}

/* Microseconds of a step, explicit if the tolerance is 0, and its report. */
static double microseconds(struct cloud bar, const struct particle_step *step,
                           double tolerance, struct particle_report *report)
{
    const struct material m = material_notes(CUBIC);
    const struct kept now = {bar.p->x, bar.p->v, bar.p->F, bar.p->B};
    const size_t n = (size_t)bar.p->n;
    const struct kept start = {
        allocate(2 * n, sizeof *start.x), allocate(2 * n, sizeof *start.v),
        allocate(n, sizeof *start.F), allocate(n, sizeof *start.B)};
    struct times times = {0};
    copy(start, now, bar.p->n);
    for (int r = 0; r < RUNS; r++) {
        const double begin = clock_seconds();
        for (int k = 0; k < STEPS; k++) {
            copy(now, start, bar.p->n);
            if (tolerance > 0.0)
                *report = ringing_step(bar, m, step, tolerance, 1.0);
            else
                report->status =
                    particles_step_explicit(bar.grid, bar.p, m, step);
        }
        times_record(&times, clock_seconds() - begin, report->status == OK);
    }
    copy(now, start, bar.p->n);
    free(start.x);
    free(start.v);
    free(start.F);
    free(start.B);
    return 1e6 * times_best(&times) / STEPS;
}

int main(void)
{
    const char *const kernel[] = {"linear", "quadratic", "cubic"};
    const struct material m = material_notes(CUBIC);
    const double c = sqrt(material_modulus(&m));
    const double rate[2] = {30.0, 80.0 * c / 2.0}, within[2] = {1e-10, 1e-2};

    study_machine();
    table_begin("steps", "kernel systems explicit_us implicit_us times "
                         "flops_times");
    for (int order = 1; order <= 3; order++)
        for (int k = 0; k < 2; k++) {
            struct cloud bar = free_bar_ringing(order, RINGING_CELLS,
                                                0.02 * c, FLIP);
            /* an explicit step takes as long whatever its length is */
            struct particle_step step = {.rate = rate[1], .transfer = FLIP};
            struct particle_report report = {.status = OK};
            const double freely = microseconds(bar, &step, 0.0, &report);
            step.rate = rate[k];
            const double solving =
                microseconds(bar, &step, within[k], &report);
            table_row(kernel[order - 1], report.iterations, freely, solving,
                      solving / freely,
                      step_flops_implicit(bar, m, NO_WALL, &report) /
                          step_flops_explicit(bar));
            cloud_free(bar);
        }
    table_end();
    return table_finish();
}
