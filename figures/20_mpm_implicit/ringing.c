/* ringing.c - see ringing.h. */
#include "ringing.h"

#include "whole_step.h"
#include "free_bar.h"
#include "motion/integrate.h"
#include "step_flops.h"
#include "../study/study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const int RINGING_STEPS[RINGING_SIZES] = {8,  13,  20,  40,  50,
                                          80, 160, 175, 240, 320};

void ringing_start(struct cloud bar, double a)
{
    const int n = bar.p->n;
    for (int p = 0; p < n; p++)
        bar.p->v[2 * p] = a * cos(acos(-1.0) / n * (p + 0.5));
}

double ringing_energy(struct cloud bar, struct material material)
{
    return particles_moments(bar.p).kinetic +
           particles_elastic(bar.p, &material);
}

/* free_bar_ringing(), shifted; APIC's B is that of the new place. */
static struct cloud shifted(struct ringing_bar of, double a,
                            enum transfer transfer)
{
    struct cloud bar = free_bar_ringing(of.order, of.cells, a, transfer);
    const double h = bar.grid->h;
    for (int q = 0; q < bar.p->n; q++) {
        double *x = &bar.p->x[2 * q], *B = &bar.p->B[q].m[0][0];
        const double slope = *B / kernel_inertia(of.order, h, *x);
        *x += of.shift * h;
        *B = slope * kernel_inertia(of.order, h, *x);
    }
    return bar;
}

struct particle_report ringing_step(struct cloud bar, struct material material,
                                    const struct particle_step *step,
                                    double tolerance, double part)
{
    const struct particle_body body = {bar.grid, bar.p, material, NULL};
    struct particle_step first = *step;
    first.rate = step->rate / part;
    const int n_dof = 2 * bar.grid->n_node, n = 2 * bar.p->n;
    double *u = allocate((size_t)n_dof, sizeof *u), *v = bar.p->v;
    double *before = allocate((size_t)n, sizeof *before);
    memcpy(before, v, (size_t)n * sizeof *before);
    struct particle_report report = {.status = grid_p2g(bar.grid, bar.p)};
    if (report.status == OK)
        report = particle_newton(&body, &first, tolerance, u);
    for (int s = 0; s < n_dof; s++) bar.grid->next[s] = first.rate * u[s];
    if (report.status == OK)
        report.status =
            grid_g2p(bar.grid, step->transfer, 1.0 / step->rate, bar.p);
    for (int s = 0; s < n; s++) v[s] += (1.0 / part - 1.0) * (v[s] - before[s]);
    free(before);
    free(u);
    return report;
}

static struct ringing ring(struct ringing_bar of, enum transfer transfer,
                           double tolerance, double part, int steps)
{
    const struct material m = material_notes(CUBIC);
    const double c = sqrt(material_modulus(&m));
    struct cloud bar = shifted(of, 0.02 * c, transfer);
    const struct particle_step step = {.rate = steps * c / 2.0,
                                       .transfer = transfer};
    const double start = ringing_energy(bar, m);
    struct ringing out = {.left = NAN};
    enum status status = OK;
    for (int k = 0; k < steps && status == OK; k++) {
        if (tolerance == 0.0) {
            status = particles_step_explicit(bar.grid, bar.p, m, &step);
            out.flops += step_flops_explicit(bar);
            continue;
        }
        const struct particle_report report =
            ringing_step(bar, m, &step, tolerance, part);
        status = report.status;
        out.flops += step_flops_implicit(bar, m, NO_WALL, &report);
        if (report.iterations > out.systems) out.systems = report.iterations;
    }
    const double ratio = ringing_energy(bar, m) / start;
    out.how = status != OK ? status_name(status)
              : ratio > 1.1 ? "unstable" : "OK";
    if (status == OK && ratio <= 1.1) out.left = ratio;
    cloud_free(bar);
    return out;
}

struct ringing ringing_particles(struct ringing_bar of, enum transfer transfer,
                                 double tolerance, int steps)
{
    return ring(of, transfer, tolerance, 1.0, steps);
}

struct ringing ringing_midpoint(double tolerance, int steps)
{
    const struct ringing_bar of = {2, RINGING_CELLS, 0.0};
    return ring(of, FLIP, tolerance, 0.5, steps);
}

/* The bar is linear, and a free bar in its first mode is two bars held in the
 * middle. */
double ringing_elements(int steps)
{
    enum { HALF = RINGING_CELLS / 2 };
    struct model *bar = model_bar(HALF, LUMPED);
    const double h = 1.0 / HALF, pi = acos(-1.0);
    const double c = sqrt(bar->A->a[0] * h / 2.0);
    const double dt = 4.0 / c / steps;
    double u[2 * HALF] = {0.0}, v[2 * HALF], q[2 * HALF], w[2 * HALF];
    for (int a = 0; a < bar->n_dof; a++) v[a] = sin(0.5 * pi * (a + 1) * h);
    const double start = model_energy(bar, u, v);
    for (int k = 0; k < steps; k++) {
        /* q at u: M (u - u - dt v) + dt^2 A u */
        model_mass(bar, v, w);
        claim(model_force(bar, u, q) == OK, "linear");
        for (int a = 0; a < bar->n_dof; a++)
            q[a] = dt * dt * q[a] - dt * w[a];
        claim(model_newton(bar, dt, q).status == OK, "definite");
        for (int a = 0; a < bar->n_dof; a++) {
            u[a] += q[a];
            v[a] = q[a] / dt;
        }
    }
    const double ratio = model_energy(bar, u, v) / start;
    model_free(bar);
    return ratio;
}
