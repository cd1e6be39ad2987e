/*
 * solver.c - does a step of 1/30 s fail by its method, or by the solver?
 *
 * The swing of chart.c with one step per frame, for three frames (0.1 s), by
 * the implicit methods with two settings of Newton's method, both to 1e-10 m.
 * `plain` is that of chart.c, which starts from a + d b and has neither line
 * search nor projection; `robust` has the guess, the line search, the
 * projection and the new factors of ROBUST.  The error is relative to the
 * start, in the norm of M; the reference is the midpoint rule with 128 and 256
 * steps per frame and Richardson's extrapolation.  Symplectic Euler needs 8.
 */
#include "motion/integrate.h"
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 3, REFERENCE = 128 };
static const double SWING = 0.3; /* (m) */

/* A solver of model.h by the settings that model->context points to. */
static struct step_report solve_as_set(struct model *model, double d,
                                       const double a[], const double b[],
                                       const double g[], double u[])
{
    const size_t n = (size_t)model->n_dof;
    double *v = allocate(n, sizeof *v);
    memcpy(u, a, n * sizeof *u);
    memcpy(v, b, n * sizeof *v);
    const struct step_report report = step_backward_euler(
        model->body, model->context, d, g, model->f, u, v, NULL);
    free(v);
    return report;
}

struct run {
    enum status status;
    int steps, systems;
    struct state end;
};

static struct run run_swing(struct model *model, const double g[],
                            enum method method, int per_frame)
{
    struct run run = {.status = OK, .end = state_swing(model->body, SWING)};
    while (run.steps < FRAMES * per_frame && run.status == OK) {
        const struct step_report report = integrate_step(
            model, method, 1.0 / 30.0 / per_frame, g, &run.end);
        run.status = report.status;
        run.systems += report.iterations;
        run.steps += report.status == OK;
    }
    return run;
}

struct result {
    enum status status;
    int systems;
    double error, energy;
};

/* Prints a row: error and energy relative to the start. */
static struct result measure(struct model *model, const double g[], int n,
                             const char *setting, enum method method,
                             const double reference[])
{
    struct state start = state_swing(model->body, SWING);
    struct run run = run_swing(model, g, method, 1);
    const int ok = run.status == OK;
    struct result r = {.status = run.status, .systems = run.systems};
    r.energy = model_energy(model, run.end.u, run.end.v) /
               model_energy(model, start.u, start.v);
    for (int i = 0; i < start.n; i++) run.end.u[i] -= reference[i];
    r.error = model_norm(model, run.end.u) / model_norm(model, start.u);
    table_row(n, setting, method_name(method), status_name(r.status), run.steps,
              cell_if(ok, r.systems), cell_if(ok, r.error),
              cell_if(ok, r.energy));
    state_free(&run.end);
    state_free(&start);
    return r;
}

/* Does symplectic Euler get through? */
static int explicit_passes(struct model *model, const double g[], int per_frame)
{
    struct run run = run_swing(model, g, SYMPLECTIC_EULER, per_frame);
    state_free(&run.end);
    return run.status == OK;
}

/* plain and robust: a result for each method */
static void compare(int n, struct result plain[], struct result robust[])
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    set.mass = LUMPED;
    struct scene *scene = scene_alloc(&set);
    struct model *model = model_body(scene->body);
    struct step_control control = ROBUST;
    control.tolerance = INTEGRATE_NEWTON.tolerance;
    struct run coarse =
        run_swing(model, scene->g, IMPLICIT_MIDPOINT, REFERENCE);
    struct run fine =
        run_swing(model, scene->g, IMPLICIT_MIDPOINT, 2 * REFERENCE);
    double *reference = fine.end.u;
    const double critical = 2.0 / model_frequency(model);
    claim(n != 8 || (1.0 / 30.0 / 7.0 < critical &&
                     !explicit_passes(model, scene->g, 7) &&
                     explicit_passes(model, scene->g, 8)),
          "7 steps per frame of symplectic Euler are shorter than the critical "
          "step at rest (%g s) and fail, 8 get through", critical);
    for (int i = 0; i < model->n_dof; i++)
        reference[i] = (4.0 * fine.end.u[i] - coarse.end.u[i]) / 3.0;

    model->solve = solve_as_set;
    for (int m = BACKWARD_EULER; m < N_METHOD; m++) {
        model->context = &INTEGRATE_NEWTON;
        plain[m] = measure(model, scene->g, n, "plain", (enum method)m,
                           reference);
        model->context = &control;
        robust[m] = measure(model, scene->g, n, "robust", (enum method)m,
                            reference);
    }
    state_free(&coarse.end);
    state_free(&fine.end);
    model_free(model);
    scene_free(scene);
}

int main(void)
{
    static const double error_due[] = {0.0, 0.69, 0.333, 0.296};
    static const double energy_due[] = {0.0, 0.038, 0.993, 0.279};
    struct result plain[2][N_METHOD], robust[2][N_METHOD];
    table_begin("solver", "n setting method status steps systems error energy");
    compare(8, plain[0], robust[0]);
    compare(16, plain[1], robust[1]);
    table_end();

    for (int k = 0; k < 2; k++)
        for (int m = BACKWARD_EULER; m < N_METHOD; m++) {
            const struct result *p = &plain[k][m], *r = &robust[k][m];
            const char *name = method_name((enum method)m);
            claim((p->status == OK) == (m == BACKWARD_EULER),
                  "by the plain Newton method backward Euler alone gets "
                  "through (%s: %s)", name, status_name(p->status));
            claim(r->status == OK && r->systems >= 5 * FRAMES &&
                      r->systems <= 6 * FRAMES,
                  "with ROBUST's settings all get through, in 5 or 6 systems "
                  "per step (%s: %s, %d)", name, status_name(r->status),
                  r->systems);
            claim(fabs(r->error - error_due[m]) < 0.006 &&
                      fabs(r->energy - energy_due[m]) < 0.008,
                  "%s then has the error %g and leaves %g of the energy", name,
                  r->error, r->energy);
        }
    return table_finish();
}
