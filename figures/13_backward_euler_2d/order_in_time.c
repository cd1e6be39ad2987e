/*
 * order_in_time.c - how fast does the error of backward Euler fall with dt?
 *
 * A free square, E = 100, n = 4, is hit at t = 0, v = (3 sin(pi X1 / 2), 0).
 * Error of u after 0.05 s against the limit dt -> 0 on the same mesh, which the
 * three finest of seven runs give by Richardson's extrapolation.
 * Table: orders_time.
 */
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

enum { RUNS = 7, N_DOF = 50 };

/* u after 0.05 s in `steps` steps. */
static void hit_square(int steps, double u[N_DOF])
{
    const struct step_control newton = step_method("notes");
    struct scene_setting set = scene_notes(SPIN, CUBIC, 4);
    set.E = 100.0;
    set.dt = 0.05 / steps;
    struct scene *s = scene_alloc(&set);
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        s->v[2 * a] = 3.0 * sin(M_PI_2 * s->mesh->X[2 * a]);
        s->v[2 * a + 1] = 0.0;
    }
    for (int k = 0; k < steps; k++)
        if (scene_step(s, &newton).status != OK) die("the hit fails");
    memcpy(u, s->u, N_DOF * sizeof *u);
    scene_free(s);
}

int main(void)
{
    double u[RUNS][N_DOF], before = 0.0, order = 0.0, constant[2] = {0.0, 0.0};

    gsl_set_error_handler_off();
    for (int k = 0; k < RUNS; k++) hit_square(4 << k, u[k]);
    table_begin("orders_time", "dt error order constant");
    for (int k = 0; k < RUNS - 2; k++) {
        const double dt = 0.05 / (4 << k);
        double error = 0.0;
        for (int r = 0; r < N_DOF; r++) {
            const double limit = (8.0 * u[RUNS - 1][r] - 6.0 * u[RUNS - 2][r] +
                                  u[RUNS - 3][r]) / 3.0;
            error = fmax(error, fabs(u[k][r] - limit));
        }
        order = study_order(before, error, 2.0);
        constant[0] = constant[1];
        constant[1] = error / dt;
        table_row(dt, error, cell_if(k > 0, order), constant[1]);
        before = error;
    }
    table_end();

    /* the limits are approached like 1 - dt */
    claim(fabs(order - 1.0) < 0.01, "the order is 1 (%g)", order);
    claim(fabs(constant[1] / constant[0] - 1.0) < 0.01,
          "error / dt has a limit (%g after %g)", constant[1], constant[0]);
    return table_finish();
}
