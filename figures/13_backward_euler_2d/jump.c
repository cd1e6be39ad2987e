/*
 * jump.c - how far may the boundary move in one step?
 *
 * From rest both ends of the square, n = 8, jump by a part of the mesh width h
 * along X1.  Newton with Cholesky starts from the last state with the boundary
 * values written in, which squeezes the triangles there, or from the lifted one
 * [eq:lift-2d].  Tables: jump (iterations and reasons over the jump; min_J of
 * the solution, cubic law), guess (the triangles of the start and of the
 * solution after a jump of 0.85 h, cubic law).
 */
#include "corners.h"
#include "base/options.h"
#include "plane/scene.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

enum { N = 8 };
static const double h = 2.0 / N;

static struct scene *square_at_rest(enum law law)
{
    const struct scene_setting set = scene_notes(RIGID, law, N);
    return scene_alloc(&set);
}

/* Boundary values: both ends shifted by jump h. */
static void shift(struct scene *s, double jump)
{
    for (int a = 0; a < s->mesh->n_vertex; a++)
        s->g[2 * a] = s->held[a] ? jump * h : 0.0;
}

/* One step after the jump, and how it ends: at the first matrix that is not
 * positive definite. */
static enum status jump_step(struct scene *s, double jump, int lift,
                             int *iterations)
{
    struct step_control newton = step_method("notes");
    newton.lift = lift;
    shift(s, jump);
    const struct step_report report =
        step_backward_euler(s->body, &newton, s->set.dt, s->g, s->f, s->u,
                            s->v, NULL);
    *iterations = report.iterations;
    return report.indefinite ? NOT_SPD : report.status;
}

static void print_triangles(const struct scene *s, double t)
{
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        double x[6];
        const double J = corners_of(s, e, x);
        table_row("rigid", t, J, x[0], x[1], x[2], x[3], x[4], x[5]);
    }
}

/* A jump of 0.85 h, which needs the lift; the least J of the start. */
static double print_guess(void)
{
    struct scene *s = square_at_rest(CUBIC);
    int unused;

    table_begin_note("guess", "scene t J x0 y0 x1 y1 x2 y2",
                     "t = 0: u0 and boundary values; t = dt: the solution");
    shift(s, 0.85);
    step_boundary(s->body, s->g, 0, s->u);
    const double start_J = body_min_J(s->body, s->u);
    print_triangles(s, 0.0);
    memset(s->u, 0, (size_t)s->n_dof * sizeof *s->u);
    if (jump_step(s, 0.85, 1, &unused) != OK) die("the lifted step fails");
    print_triangles(s, s->set.dt);
    table_end();
    scene_free(s);
    return start_J;
}

int main(void)
{
    const double jumps[] = {0.25, 0.5,  0.6,  0.7, 0.75, 0.8, 0.85,
                            0.9,  0.95, 1.05, 1.5, 3.0};
    const enum law law[2] = {LOG, CUBIC};
    double limit[2] = {0.0, 0.0}, least_J = 1.0;
    int lifted = 0, most = 0;

    gsl_set_error_handler_off();
    table_begin_note("jump", "jump log reason_log cubic reason_cubic "
                     "log_lifted cubic_lifted min_J",
                     "n = %d; iterations; min_J of the solution, cubic", N);
    for (int k = 0; k < COUNT(jumps); k++) {
        enum status status[2], status_lifted[2]; /* log, cubic */
        struct cell plain[2], lift[2];           /* iterations */
        double min_J = 0.0;
        for (int l = 0; l < 2; l++) {
            int count;
            struct scene *s = square_at_rest(law[l]);
            status[l] = jump_step(s, jumps[k], 0, &count);
            plain[l] = cell_if(status[l] == OK, count);
            if (status[l] == OK) limit[l] = jumps[k];
            scene_free(s);

            s = square_at_rest(law[l]);
            status_lifted[l] = jump_step(s, jumps[k], 1, &count);
            lift[l] = cell_if(status_lifted[l] == OK, count);
            if (status_lifted[l] == OK && count > most) most = count;
            min_J = body_min_J(s->body, s->u); /* the cubic law's is left */
            scene_free(s);
        }
        table_row(jumps[k], plain[0], status_name(status[0]), plain[1],
                  status_name(status[1]), lift[0], lift[1], min_J);
        if (jumps[k] == 0.85) least_J = min_J;
        lifted += status_lifted[0] == OK && status_lifted[1] == OK;
    }
    table_end();

    const double start_J = print_guess();
    claim(limit[0] < 1.0 && limit[1] < 1.0,
          "from the last state no jump of h or more is survived (log %g h, "
          "cubic %g h)", limit[0], limit[1]);
    claim(fabs(start_J - 0.15) < 1e-12 && least_J > 0.9,
          "after a jump of 0.85 h the start has J = %g, the solution 0.9 or "
          "more (%g)", start_J, least_J);
    claim(lifted == COUNT(jumps) && most <= 6,
          "the lifted start survives all %d jumps (%d), in 6 iterations or "
          "less (%d)", COUNT(jumps), lifted, most);
    return table_finish();
}
