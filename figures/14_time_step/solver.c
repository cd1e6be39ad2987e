/*
 * solver.c - does a step of 1/30 s fail by its method, or by the solver?
 *
 * The swing of chart.c with one step per frame, for three frames (0.1 s), by
 * the implicit methods with four settings of Newton's method, all to 1e-10 m.
 * `plain` is that of chart.c, which starts from a + d b and has neither line
 * search nor projection; `last` only starts elsewhere, from the last state, and
 * `downhill` only adds both; `robust` is ROBUST.  The error is relative to the
 * start, in the norm of M; the reference is the midpoint rule with 128 and 256
 * steps per frame and Richardson's extrapolation.  Symplectic Euler needs 8.
 */
#include "frequency.h"
#include "swing.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { REFERENCE = 128 };

enum setting { AS_IN_CHART, LAST, DOWNHILL, AS_ROBUST, N_SETTING };
static const char *const NAME[] = {"plain", "last", "downhill", "robust"};

static struct step_control control_of(enum setting setting)
{
    struct step_control c = setting == AS_ROBUST ? ROBUST : INTEGRATE_NEWTON;
    c.tolerance = INTEGRATE_NEWTON.tolerance;
    if (setting == LAST) c.guess = ROBUST.guess;
    if (setting == DOWNHILL) {
        c.line_search = ROBUST.line_search;
        c.projection = ROBUST.projection;
    }
    return c;
}

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

/* Prints and checks a row: error and energy relative to the start. */
static void measure(struct model *model, const double g[], int n,
                    enum setting setting, enum method method,
                    const double reference[])
{
    static const double error_due[] = {0.0, 0.69, 0.333, 0.296};
    static const double energy_due[] = {0.0, 0.038, 0.993, 0.279};
    static const char *const passes[] = {
        "backward Euler alone gets through", "all but BDF2 with n = 16 do",
        "all get through", "all get through"};
    struct step_control control = control_of(setting);
    model->context = &control;
    struct swing_run run = swing_run(model, g, method, 1);
    const enum status status = run.total.status;
    const int ok = status == OK, systems = run.total.iterations;
    const double error = swing_distance(model, run.end.u, reference);
    const double energy = run.energy;
    const char *name = method_name(method);
    table_row(n, NAME[setting], name, status_name(status), run.steps,
              cell_if(ok, systems), cell_if(ok, error),
              cell_if(ok, energy));
    const int due = setting == AS_IN_CHART ? method == BACKWARD_EULER
                    : setting == LAST      ? method != BDF2 || n == 8
                                           : 1;
    claim(ok == due, "%s: %s (%s, n = %d)", NAME[setting], passes[setting],
          name, n);
    claim(!ok || (fabs(error - error_due[method]) < 0.006 &&
                  fabs(energy - energy_due[method]) < 0.008),
          "%s, %s: %s then has the error %g and leaves %g of the energy",
          NAME[setting], status_name(status), name, error, energy);
    claim(setting != AS_ROBUST ||
              (systems >= 5 * SWING_FRAMES && systems <= 6 * SWING_FRAMES),
          "robust: 5 or 6 systems per step (%s: %d)", name, systems);
    state_free(&run.end);
}

/* Does symplectic Euler get through? */
static int explicit_passes(struct model *model, const double g[], int per_frame)
{
    struct swing_run run = swing_run(model, g, SYMPLECTIC_EULER, per_frame);
    state_free(&run.end);
    return run.total.status == OK;
}

static void compare(int n)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
    set.mass = LUMPED;
    struct scene *scene = scene_alloc(&set);
    struct model *model = model_body(scene->body);
    const double critical = 2.0 / frequency_largest(model);
    claim(n != 8 || (1.0 / 30.0 / 7.0 < critical &&
                     !explicit_passes(model, scene->g, 7) &&
                     explicit_passes(model, scene->g, 8)),
          "7 steps per frame of symplectic Euler are shorter than the critical "
          "step at rest (%g s) and fail, 8 get through", critical);
    swing_limit(model, scene->g, REFERENCE, scene->u);
    model->solve = solve_as_set;
    for (int m = BACKWARD_EULER; m < N_METHOD; m++)
        for (int k = 0; k < N_SETTING; k++)
            measure(model, scene->g, n, (enum setting)k, (enum method)m,
                    scene->u);
    model_free(model);
    scene_free(scene);
}

int main(void)
{
    table_begin("solver", "n setting method status steps systems error energy");
    compare(8);
    compare(16);
    table_end();
    return table_finish();
}
