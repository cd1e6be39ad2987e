/*
 * recover.c - a square whose vertices have been put anywhere is let go, under
 * three laws that exist inside out.
 *
 * Backward Euler with always projecting and a line search, dt = 1/240 s, from
 * rest; n = 4, all vertices scrambled by the same random numbers.  Tables: the
 * triangles after every step, and where each law ends.
 */
#include "plane/release.h"
#include "plane/step.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>

enum { N = 4, N_VERTEX = 25, N_DOF = 50, STEPS = 72, SEED = 1 };

/* How a law ended. */
struct end {
    double energy, min_J, winding;
    int systems;
};

static void print_triangles(const struct body *body, const double u[], int step)
{
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->mesh->triangle[3 * e];
        double x[6];
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++)
                x[2 * a + i] = body->mesh->X[2 * t[a] + i] + u[2 * t[a] + i];
        const double area = (x[2] - x[0]) * (x[5] - x[1]) -
                            (x[4] - x[0]) * (x[3] - x[1]);
        table_row(material_law(body->material.law), step,
                  area > 0.0 ? "upright" : "inside_out", x[0], x[1], x[2],
                  x[3], x[4], x[5]);
    }
}

static struct end let_go(const struct mesh *mesh, enum law law)
{
    const struct step_control control = step_method("always+search");
    const int held[N_VERTEX] = {0};
    struct body *body = body_alloc(mesh, material_notes(law), 1.0, CONSISTENT,
                                   held);
    double u[N_DOF] = {0.0}, v[N_DOF] = {0.0};
    struct end end = {0};
    release_scramble(body, SEED, u);
    print_triangles(body, u, 0);
    for (int step = 1; step <= STEPS; step++) {
        const struct step_report report = step_backward_euler(
            body, &control, 1.0 / 240.0, u, NULL, u, v, NULL);
        if (report.status != OK)
            die("%s law, step %d: %s", material_law(law), step,
                status_name(report.status));
        end.systems += report.iterations;
        print_triangles(body, u, step);
    }
    body_energy(body, u, &end.energy);
    end.min_J = body_min_J(body, u);
    end.winding = release_winding(body, u);
    body_free(body);
    return end;
}

int main(void)
{
    const enum law law[] = {CUBIC, EXTENDED, STABLE};
    struct mesh *mesh = mesh_square(N);
    struct end end[3];
    gsl_set_error_handler_off();
    table_begin("motion", "law step state x0 y0 x1 y1 x2 y2");
    for (int k = 0; k < 3; k++) end[k] = let_go(mesh, law[k]);
    table_end();
    table_begin("end", "law energy min_J winding systems");
    for (int k = 0; k < 3; k++)
        table_row(material_law(law[k]), end[k].energy, end[k].min_J,
                  end[k].winding, end[k].systems);
    table_end();
    mesh_free(mesh);

    for (int k = 0; k < 3; k++)
        claim(end[k].min_J > 0.0, "every triangle ends upright");
    claim(end[0].winding > 1.5 && end[1].winding > 1.5,
          "under the cubic and the extended law the square ends wound twice");
    claim(end[2].winding < 1.5 && end[2].min_J > 0.9 &&
              end[2].energy < 0.1 * end[0].energy,
          "under the stable law it comes back");
    return table_finish();
}
