/*
 * stability.c - how small must an explicit step be when the last particle of a
 * bar has only just reached a node?
 * 8 cells, two particles per cell, both ends free, the last particle eps h
 * within reach of a node.  `grid` is the limit of the nodes by themselves,
 * 2 / omega; `flip` that of a step with its transfers: no eigenvalue of it, as
 * a linear map of all v_p and F_p, is beyond 1.  Times in h / c, c the speed of
 * sound; steps: the explicit ones (FLIP) for 1/30 s; systems: of one implicit
 * step, until du is 1e-10 of the first (its own test, 1e-10 h, is not met if
 * the light node moves far); flops: of either; times: implicit over explicit,
 * with these systems and (times_one) with one; explicit_times: of 1/30 s.
 */
#include "whole_step.h"
#include "free_bar.h"
#include "ringing.h"
#include "step_flops.h"
#include "particles/particle_bodies.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <math.h>

enum { P = 16, STATE = 2 * P }; /* v, then F - 1, along the bar */
static const double H = 0.125;
struct outlying {
    int order;
    double eps;
};

static double grid_limit(struct outlying at)
{
    const struct material material = material_notes(CUBIC);
    struct cloud c = free_bar_outlying(at.order, at.eps);
    const struct particle_body body = {c.grid, c.p, material, NULL};
    claim(grid_p2g(c.grid, c.p) == OK, "the bar is on its grid");
    const double dt = 2.0 / free_bar_frequency(&body) / H;
    cloud_free(c);
    return dt * sqrt(material_modulus(&material));
}

/* One explicit FLIP step of the state z from rest. */
static void flip_step(struct outlying at, double dt, double z[STATE])
{
    struct cloud c = free_bar_outlying(at.order, at.eps);
    const struct particle_step step = {.rate = 1.0 / dt, .transfer = FLIP};
    for (int p = 0; p < P; p++) {
        c.p->v[2 * p] = z[p];
        c.p->F[p].m[0][0] = 1.0 + z[P + p];
    }
    const struct material m = material_notes(CUBIC);
    claim(particles_step_explicit(c.grid, c.p, m, &step) == OK, "one step");
    for (int p = 0; p < P; p++) {
        z[p] = c.p->v[2 * p];
        z[P + p] = c.p->F[p].m[0][0] - 1.0;
    }
    cloud_free(c);
}

/* log of the largest |eigenvalue| of the step, less 1e-4. */
static double growth(double courant, void *outlying)
{
    const struct outlying at = *(struct outlying *)outlying;
    const struct material material = material_notes(CUBIC);
    const double c = sqrt(material_modulus(&material));
    gsl_matrix *A = gsl_matrix_alloc(STATE, STATE);
    gsl_vector_complex *value = gsl_vector_complex_alloc(STATE);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(STATE);
    double most = 0.0;
    for (int k = 0; k < STATE; k++) {
        const double e = k < P ? 1e-5 * c : 1e-5; /* as large as strains */
        double more[STATE] = {0.0}, less[STATE] = {0.0};
        more[k] = e;
        less[k] = -e;
        flip_step(at, courant * H / c, more);
        flip_step(at, courant * H / c, less);
        for (int i = 0; i < STATE; i++)
            gsl_matrix_set(A, (size_t)i, (size_t)k, (more[i] - less[i]) /
                           (2.0 * e) * (k < P ? c : 1.0) / (i < P ? c : 1.0));
    }
    gsl_eigen_nonsymm(A, value, work);
    for (size_t i = 0; i < STATE; i++)
        most = fmax(most, gsl_complex_abs(gsl_vector_complex_get(value, i)));
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(value);
    gsl_matrix_free(A);
    return log(most) - 1e-4;
}

/* The linear systems of an implicit step, and the flops of an explicit one, of
 * this one, and of one with a single system; own: the program's report. */
static int systems(struct outlying at, double flops[3],
                   struct particle_report *own)
{
    const struct material material = material_notes(CUBIC);
    struct cloud c = free_bar_outlying(at.order, at.eps);
    const struct particle_step step = {.rate = 30.0, .transfer = FLIP};
    ringing_start(c, 0.02 * sqrt(material_modulus(&material)));
    flops[0] = step_flops_explicit(c);
    const double start = ringing_energy(c, material);
    struct particle_report r = particles_step(c.grid, c.p, material, &step);
    const double kept = ringing_energy(c, material) / start;
    *own = r;
    claim(r.status != OK || kept < 0.075, "it keeps 7 %% of the energy");
    while (r.iterations > 1 &&
           r.increment[r.iterations - 2] <= 1e-10 * r.increment[0])
        r.iterations--;
    claim(r.projections == 0, "all systems are definite");
    claim(r.increment[r.iterations - 1] <= 1e-10 * r.increment[0], "done");
    const int n = r.iterations;
    flops[1] = step_flops_implicit(c, material, NO_WALL, &r);
    r.iterations = 1;
    flops[2] = step_flops_implicit(c, material, NO_WALL, &r);
    cloud_free(c);
    return n;
}

int main(void)
{
    const char *const kernel[] = {"linear", "quadratic", "cubic"};
    const double eps[] = {0.25, 0.01, 1e-3, 1e-6};
    const struct material m = material_notes(CUBIC);
    const double implicit = sqrt(material_modulus(&m)) / 30.0 / H;
    table_begin("critical", "kernel eps grid flip implicit systems steps "
                            "explicit_flops implicit_flops times "
                            "times_one explicit_times");
    for (int order = 1; order <= 3; order++)
        for (int k = 0; k < 4; k++) {
            struct outlying at = {order, eps[k]};
            const double grid = grid_limit(at);
            const double flip = study_root(growth, &at, grid / 2.0, grid);
            struct particle_report own;
            double flops[3];
            const int n = systems(at, flops, &own);
            const double steps = ceil(implicit / flip);
            table_row(kernel[order - 1], eps[k], grid, flip, implicit, n, steps,
                      steps * flops[0], flops[1], flops[1] / flops[0],
                      flops[2] / flops[0], steps * flops[0] / flops[1]);
            claim(n == 4, "four systems");
            claim(own.status == (order == 3 && k == 3 ? MAX_ITERATIONS : OK) &&
                      (own.iterations > n) == (order > 1 && k == 3),
                  "its own test: never met by cubic, 1e-6, late by quadratic");
            claim(flops[1] < 4.1 * flops[0] && 4.1 < steps &&
                      flops[2] < 1.8 * flops[0],
                  "an implicit step costs as much as 4 explicit ones at most, "
                  "with one system less than 1.8");
            if (order == 1 && eps[k] <= 1e-3)
                claim(fabs(grid / (2.0 * sqrt(eps[k])) - 1.0) < 2e-3 &&
                          fabs(flip / grid * sqrt(2.0) - 1.0) < 1e-3,
                      "linear: 2 sqrt(eps), with transfers 1/sqrt(2) of it");
            claim(order == 1 || (grid > 0.95 && grid < 1.5), "any eps");
        }
    table_end();
    return table_finish();
}
