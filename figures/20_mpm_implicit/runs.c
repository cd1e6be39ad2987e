/*
 * runs.c - is the limit of the explicit step where its eigenvalues say?
 *
 * Linear kernel, the last particle of a bar eps h beyond a node, FLIP.  That
 * node has almost no mass, and P2G makes it forget its own velocity in every
 * step: the limit is sqrt(2) / omega, and not the grid's own 2 / omega.  Bars
 * with velocities of 1e-9 m/s make 1500 steps of 0.98 and 1.02 of it.
 * `moving`: and if the bar moves on at a speed V, so that eps grows?  The steps
 * for T = 1/30 s, each 0.95 of the limit at that moment: c sqrt(2 T / (h V)) of
 * the limits themselves, if eps h = V t.  `ringing`: and in the first mode with
 * which stability.c begins its implicit step, or in the reverse of it?  times:
 * their flops over those of an implicit step with four systems.
 */
#include "ringing.h"
#include "step_flops.h"
#include "particles/particle_bodies.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

/* The largest |v_p| on the way. */
static double run(double eps, double part, double *omega)
{
    const struct material material = material_notes(CUBIC);
    struct cloud c = cloud_outlying(1, eps);
    const struct particle_body body = {c.grid, c.p, material, NULL};
    struct particle_step step = {.transfer = FLIP};
    double most = 0.0;
    claim(grid_p2g(c.grid, c.p) == OK, "the bar is on its grid");
    *omega = particle_frequency(&body);
    step.rate = *omega / (part * sqrt(2.0));
    for (int p = 0; p < c.p->n; p++)
        c.p->v[2 * p] = 1e-9 * (p * 7 % 5 - 2.0);
    for (int k = 0; k < 1500 && most < 1e-2; k++) {
        if (particles_step_explicit(c.grid, c.p, material, &step) != OK) break;
        for (int p = 0; p < c.p->n; p++)
            most = fmax(most, fabs(c.p->v[2 * p]));
    }
    cloud_free(c);
    return most;
}

/* How many steps for 1/30 s, from these velocities; the bar is `c` after it. */
static int steps_of(struct cloud c)
{
    const struct material material = material_notes(CUBIC);
    const struct particle_body body = {c.grid, c.p, material, NULL};
    struct particle_step step = {.transfer = FLIP};
    int steps = 0;
    for (double left = 1.0 / 30.0; left > 0.0; steps++) {
        claim(grid_p2g(c.grid, c.p) == OK, "the bar is on its grid");
        const double limit = sqrt(2.0) / particle_frequency(&body);
        const double dt = fmin(0.95 * limit, left);
        step.rate = 1.0 / dt;
        claim(particles_step_explicit(c.grid, c.p, material, &step) == OK,
              "one step");
        left -= dt;
    }
    return steps;
}

static int moving(double V)
{
    struct cloud c = cloud_outlying(1, 1e-6);
    for (int p = 0; p < c.p->n; p++)
        c.p->v[2 * p] = V + 1e-9 * (p * 7 % 5 - 2.0);
    const int steps = steps_of(c);
    for (int p = 0; p < c.p->n; p++)
        claim(fabs(c.p->v[2 * p] - V) < 1e-8, "these steps are stable");
    cloud_free(c);
    return steps;
}

static void print_ringing(void)
{
    const struct material m = material_notes(CUBIC);
    const int due[2] = {22, 52};
    table_begin("ringing", "last_v steps times kept");
    for (int k = 0; k < 2; k++) {
        struct cloud c = cloud_outlying(1, 1e-6);
        const double speed = sqrt(material_modulus(&m));
        ringing_start(c, k ? -0.02 * speed : 0.02 * speed);
        const struct particle_report four = {.iterations = 4};
        const double last = c.p->v[2 * c.p->n - 2];
        const double start = ringing_energy(c, m);
        const double implicit = step_flops_implicit(c, m, NO_WALL, &four);
        const double freely = step_flops_explicit(c);
        const int steps = steps_of(c);
        const double times = steps * freely / implicit;
        const double kept = ringing_energy(c, m) / start;
        table_row(last, steps, times, kept);
        claim(steps == due[k], "%d steps", steps);
        claim(fabs(fabs(last) - 0.73) < 0.005, "at 0.73 m/s (%g)", last);
        claim(fabs(times - (k ? 16.1 : 6.8)) < 0.05, "flops: %g times", times);
        claim(fabs(kept - 1.0) < 0.05, "these steps are stable");
        cloud_free(c);
    }
    table_end();
}

static void print_moving(void)
{
    const double speed[] = {0.0, 0.01, 0.1, 1.0, 3.0};
    const struct material m = material_notes(CUBIC);
    int steps[5];
    table_begin("moving", "speed steps");
    for (int k = 0; k < 5; k++) {
        steps[k] = moving(speed[k]);
        table_row(speed[k], steps[k]);
    }
    table_end();
    const double c = sqrt(material_modulus(&m)), h = 0.125;
    const double due = c * sqrt(2.0 / 30.0 / (h * speed[1])) / 0.95;
    claim(fabs(steps[1] / due - 1.0) < 0.02, "as eps grows from 0 on, "
          "c sqrt(2 T / (h V)) (%d, %g)", steps[1], due);
    claim(steps[0] > 7000 && steps[3] < 35, "at rest 7000, at 1 m/s 32");
}

int main(void)
{
    table_begin("runs", "eps omega below above");
    for (double eps = 1e-3; eps > 5e-7; eps *= 0.1) {
        double omega;
        const double below = run(eps, 0.98, &omega);
        const double above = run(eps, 1.02, &omega);
        table_row(eps, omega, below, above);
        claim(below < 1e-8, "0.98 of the limit is stable (%g)", below);
        claim(above > 1e-4, "1.02 of the limit is not (%g)", above);
    }
    table_end();
    print_moving();
    print_ringing();
    return table_finish();
}
