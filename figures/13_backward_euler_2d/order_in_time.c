/*
 * order_in_time.c - how fast does the error of backward Euler fall with dt?
 *
 * A free square, E = 100, n = 4, is hit at t = 0, v = (3 sin(pi X1 / 2), 0).
 * Error of u after 0.05 s against the limit dt -> 0 on the same mesh, which the
 * three finest of seven runs give by Richardson's extrapolation; the price is
 * the number of linear systems.  Table in_space has the error of the mesh at
 * these vertices, in 64 steps each, against n = 32, and the longest dt whose
 * error is less.  Tables: orders_time, in_space.
 */
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

enum { RUNS = 7, SIDE = 5, N_DOF = 2 * SIDE * SIDE };

/* u after 0.05 s in `steps` steps at the vertices of n = 4, of a mesh with
 * n = 4 fine; the number of linear systems solved. */
static int hit_square(int steps, int fine, double u[N_DOF])
{
    const struct step_control newton = step_method("notes");
    struct scene_setting set = scene_notes(SPIN, CUBIC, 4 * fine);
    int systems = 0;
    set.E = 100.0;
    set.dt = 0.05 / steps;
    struct scene *s = scene_alloc(&set);
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        s->v[2 * a] = 3.0 * sin(M_PI_2 * s->mesh->X[2 * a]);
        s->v[2 * a + 1] = 0.0;
    }
    for (int k = 0; k < steps; k++) {
        const struct step_report report = scene_step(s, &newton);
        if (report.status != OK) die("the hit fails");
        systems += report.iterations;
    }
    for (int row = 0; row < SIDE; row++)
        for (int column = 0; column < SIDE; column++) {
            const int a = fine * (row * (4 * fine + 1) + column);
            memcpy(&u[2 * (row * SIDE + column)], &s->u[2 * a], 2 * sizeof *u);
        }
    scene_free(s);
    return systems;
}

/* The largest difference of a component. */
static double farthest(const double u[N_DOF], const double v[N_DOF])
{
    double most = 0.0;
    for (int r = 0; r < N_DOF; r++) most = fmax(most, fabs(u[r] - v[r]));
    return most;
}

int main(void)
{
    double u[RUNS][N_DOF], limit[N_DOF], before = 0.0, order = 0.0;
    double constant[2] = {0.0, 0.0}, coarse[N_DOF], fine[N_DOF];
    int systems[RUNS], worth = 0;

    gsl_set_error_handler_off();
    for (int k = 0; k < RUNS; k++) systems[k] = hit_square(4 << k, 1, u[k]);
    for (int r = 0; r < N_DOF; r++)
        limit[r] = (8.0 * u[RUNS - 1][r] - 6.0 * u[RUNS - 2][r] +
                    u[RUNS - 3][r]) / 3.0;
    hit_square(64, 1, coarse);
    hit_square(64, 8, fine);
    const double space = farthest(coarse, fine);
    table_begin("orders_time", "dt systems error order constant");
    for (int k = 0; k < RUNS - 2; k++) {
        const double dt = 0.05 / (4 << k);
        const double error = farthest(u[k], limit);
        order = study_order(before, error, 2.0);
        constant[0] = constant[1];
        constant[1] = error / dt;
        table_row(dt, systems[k], error, cell_if(k > 0, order), constant[1]);
        worth += error > space;
        before = error;
    }
    table_end();
    table_begin("in_space", "n error longest_dt_below");
    table_row(4, space, 0.05 / (4 << worth));
    table_end();

    /* the limits are approached like 1 - dt */
    claim(fabs(order - 1.0) < 0.01, "the order is 1 (%g)", order);
    claim(fabs(constant[1] / constant[0] - 1.0) < 0.01,
          "error / dt has a limit (%g after %g)", constant[1], constant[0]);
    claim(worth == 1 && systems[2] == 2 * systems[1],
          "twice the steps are twice the linear systems, and on this mesh four "
          "steps or eight are enough (%d)", worth);
    return table_finish();
}
