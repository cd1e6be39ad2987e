/* swing.c - see swing.h. */
#include "swing.h"
#include "base/clock.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

struct state swing_start(const struct body *body, double size)
{
    struct state s = state_make(2 * body->mesh->n_vertex);
    for (int a = 0; a < body->mesh->n_vertex; a++) {
        const double X = body->mesh->X[2 * a];
        if (body->equation[2 * a] < 0) continue;
        s.u[2 * a] = 0.4 * size * sin(M_PI * X);
        s.u[2 * a + 1] = size * cos(M_PI_2 * X);
    }
    return s;
}

double swing_norm(const struct model *model, const double v[])
{
    double *out = allocate((size_t)model->n_dof, sizeof *out), sum = 0.0;
    model_mass(model, v, out);
    for (int i = 0; i < model->n_dof; i++) sum += v[i] * out[i];
    free(out);
    return sqrt(sum);
}

const double SWING = 0.3;

struct swing_run swing_run(struct model *model, const double g[],
                           enum method method, int per_frame)
{
    const int due = SWING_FRAMES * per_frame;
    struct swing_run run = {.end = swing_start(model->body, SWING)};
    struct state *s = &run.end;
    const double E = model_energy(model, s->u, s->v), start = clock_seconds();
    while (run.steps < due && run.total.status == OK) {
        const struct step_report report = integrate_step(
            model, method, 1.0 / 30.0 / per_frame, g, s);
        run.total.status = report.status;
        run.total.iterations += report.iterations;
        run.total.factorisations += report.factorisations;
        run.steps += report.status == OK;
        /* explicit: what has gained this much energy has no end */
        if (method == SYMPLECTIC_EULER && report.status == OK &&
            (run.steps % 8 == 0 || run.steps == due) &&
            !(model_energy(model, s->u, s->v) < 1e2 * E))
            run.total.status = NONFINITE;
    }
    run.seconds = clock_seconds() - start;
    run.energy = model_energy(model, s->u, s->v) / E;
    return run;
}

void swing_limit(struct model *model, const double g[], int per_frame,
                 double u[])
{
    struct swing_run coarse = swing_run(model, g, IMPLICIT_MIDPOINT, per_frame);
    struct swing_run fine =
        swing_run(model, g, IMPLICIT_MIDPOINT, 2 * per_frame);
    for (int i = 0; i < model->n_dof; i++)
        u[i] = (4.0 * fine.end.u[i] - coarse.end.u[i]) / 3.0;
    state_free(&coarse.end);
    state_free(&fine.end);
}

double swing_distance(const struct model *model, double u[], const double w[])
{
    struct state start = swing_start(model->body, SWING);
    const double scale = swing_norm(model, start.u);
    for (int i = 0; i < start.n; i++) u[i] -= w[i];
    state_free(&start);
    return swing_norm(model, u) / scale;
}
