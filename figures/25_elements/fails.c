/*
 * fails.c - where does a graded mesh make things worse?
 *
 * Tables: the error of quadratic triangles against m, n = 8; the longest stable
 * step of an explicit method, 2 / omega_max [eq:critical-step], whose smallest
 * cells shrink like n^-m; and the least J of a square of linear triangles, log
 * law, n = 16, whose held ends are pressed inwards by 0.3 m.
 */
#include "hang.h"

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "plane/body.h"
#include "plane/quadratic.h"
#include "plane/step.h"

#include <math.h>
#include <stdlib.h>

enum { POWERS = 3000 };
static const int held_left = MESH_LEFT | MESH_BOTTOM | MESH_TOP;

/* 2 / omega_max of quadratic triangles, rho = 1, at rest, by the power method
 * on M^-1 K: no shorter than the true one, by less than 1 %. */
static double longest_step(int n, double m)
{
    struct mesh *mesh = mesh_square(2 * n);
    const int n_dof = 2 * mesh->n_vertex;
    int *held = allocate((size_t)n_dof, sizeof *held);
    double *u = allocate((size_t)n_dof, sizeof *u);
    double *x = allocate((size_t)n_dof, sizeof *x);
    double *y = allocate((size_t)n_dof, sizeof *y), omega2 = 0.0;
    for (int j = 0; j <= 2 * n; j++) held[j * (2 * n + 1)] = 1;
    mesh_grade(mesh, m, held_left);
    quadratic_straighten(mesh);
    struct body *body =
        body_alloc_of(QUADRATIC_TRIANGLE, mesh, material_notes(CUBIC), 1.0,
                      CONSISTENT, held);
    body_store(body, SPARSE);
    double *mass = allocate((size_t)n_dof, sizeof *mass);
    if (body_assemble(body, at_rest(NULL), u, EXACT, y) != OK) return 0.0;
    for (int r = 0; r < n_dof; r++) {
        const int k = body->equation[r];
        if (k < 0) continue;
        mass[k] = body->diagonal[r / 2];
        x[k] = sin(1.0 + 2.3 * k * k);
    }
    for (int power = 0; power < POWERS; power++) {
        double top = 0.0, below = 0.0, largest = 0.0;
        matrix_multiply(body->K, x, y);
        for (int k = 0; k < body->n_equation; k++) {
            top += x[k] * y[k];
            below += mass[k] * x[k] * x[k];
            y[k] /= mass[k];
            largest = fmax(largest, fabs(y[k]));
        }
        omega2 = top / below;
        for (int k = 0; k < body->n_equation; k++) x[k] = y[k] / largest;
    }
    body_free(body);
    mesh_free(mesh);
    free(held), free(u), free(x), free(y), free(mass);
    return 2.0 / sqrt(omega2);
}

/* The least J when both ends have come so far inwards. */
static double press(double m, double to)
{
    struct mesh *mesh = mesh_square(16);
    const size_t n_dof = 2 * (size_t)mesh->n_vertex;
    int *held = allocate(n_dof, sizeof *held);
    double *u = allocate(n_dof, sizeof *u), *g = allocate(n_dof, sizeof *g);
    double e = 0.0, least = 1.0;
    for (int j = 0; j <= 16; j++) held[17 * j] = held[17 * j + 16] = 1;
    mesh_grade(mesh, m, held_left | MESH_RIGHT);
    struct body *body =
        body_alloc(mesh, material_notes(LOG), 0.0, CONSISTENT, held);
    const struct step_control control = step_method("lift+search");
    while (e < to - 1e-9) {
        for (int a = 0; a < mesh->n_vertex; a++)
            g[2 * a] = -(e + 0.02) * mesh->X[2 * a];
        step_boundary(body, g, 1, u);
        if (step_solve(body, &control, at_rest(NULL), u).status != OK)
            die("no equilibrium, m = %g, e = %g", m, e);
        least = body_min_J(body, u);
        e += 0.02;
    }
    body_free(body);
    mesh_free(mesh);
    free(held), free(u), free(g);
    return least;
}

int main(void)
{
    const double grading[] = {1.0, 1.5, 2.0, 2.5, 3.0, 4.0};
    const struct hang limit = hang_of(HANG_QUADRATIC, 64, 3.0, 0.3);
    double error[COUNT(grading)], step[3][3], order[3], least[3];

    table_begin("error", "m error");
    for (int k = 0; k < COUNT(grading); k++) {
        const struct hang hang = hang_of(HANG_QUADRATIC, 8, grading[k], 0.3);
        error[k] = hang_apart(&hang, &limit);
        table_row(grading[k], cell_rounded(4, error[k]));
    }
    table_end();
    table_begin("step", "m step_8 step_16 step_32 order");
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 3; j++)
            step[k][j] = longest_step(8 << j, grading[k]);
        order[k] = study_order(step[k][1], step[k][2], 2.0);
        table_row(grading[k], cell_rounded(3, step[k][0]),
                  cell_rounded(3, step[k][1]), cell_rounded(3, step[k][2]),
                  cell_rounded(2, order[k]));
    }
    table_end();
    table_begin("press", "m min_J");
    for (int k = 0; k < 3; k++) {
        least[k] = press(grading[k], 0.3);
        table_row(grading[k], least[k]);
    }
    table_end();
    claim(error[2] < error[0] && error[5] > error[0], "n = 8: m = 2 helps (%g "
          "after %g), and m = 4 is worse than no grading (%g)", error[2],
          error[0], error[5]);
    for (int k = 0; k < 3; k++)
        claim(fabs(order[k] - grading[k]) < 0.1, "the longest step falls like "
              "n^-m: m = %g, order %g", grading[k], order[k]);
    claim(least[0] > least[1] && least[1] > least[2], "pressed by 0.3 m, the "
          "worst triangle keeps less the finer it is: %g, %g, %g", least[0],
          least[1], least[2]);
    return table_finish();
}
