/*
 * sheet.c - a square that is wound twice round its middle vertex: how does it
 * rest, and does it come back from there?
 *
 * A square of 2 x 2 cells is wound twice round its middle vertex and let go
 * under the cubic law [alg:release]; once it is in balance, all its vertices
 * are moved at random by at most 1 mm, and it is let go again.  Tables: the
 * corners of the triangles in balance; is the balance stable (OK) or not
 * (SADDLE), its energy and least J, and does the moved square come back?
 */
#include "plane/release.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { N = 2, N_VERTEX = (N + 1) * (N + 1), N_DOF = 2 * N_VERTEX };

/* Angles are doubled and, so that no triangle in the middle is flat, spread:
 * its six edges go to multiples of 2 pi / 3. */
static void wind(const struct mesh *mesh, double u[])
{
    const double edge[] = {0.0, 0.25, 0.5, 1.0, 1.25, 1.5, 2.0}; /* pi */
    for (int a = 0; a < mesh->n_vertex; a++) {
        const double *X = &mesh->X[2 * a];
        const double turn = atan2(X[1], X[0]) / M_PI;
        const double at = turn < 0.0 ? turn + 2.0 : turn, r = hypot(X[0], X[1]);
        int k = 0;
        while (k < 5 && at >= edge[k + 1]) k++;
        const double to = 2.0 * M_PI / 3.0 *
                          (k + (at - edge[k]) / (edge[k + 1] - edge[k]));
        u[2 * a] = r * cos(to) - X[0];
        u[2 * a + 1] = r * sin(to) - X[1];
    }
}

static void print_wound(const struct mesh *mesh, const double u[])
{
    table_begin("wound", "x0 y0 x1 y1 x2 y2");
    for (const int *t = mesh->triangle; t < mesh->triangle + 24; t += 3) {
        double x[6];
        for (int s = 0; s < 6; s++) {
            const int r = 2 * t[s / 2] + s % 2;
            x[s] = mesh->X[r] + u[r];
        }
        table_row(x[0], x[1], x[2], x[3], x[4], x[5]);
    }
    table_end();
}

int main(void)
{
    struct mesh *mesh = mesh_square(N);
    const int held[N_VERTEX] = {0};
    struct body *body =
        body_alloc(mesh, material_notes(CUBIC), 0.0, CONSISTENT, held);
    double u[N_DOF], random[N_DOF];
    body_store(body, PLAIN);
    wind(mesh, u);
    const struct release_report balance = release_solve(body, 300, u);
    const double winding = release_winding(body, u);
    print_wound(mesh, u);
    release_scramble(body, 1, random);
    for (int r = 0; r < body->n_equation; r++)
        u[r] += 1e-3 * (random[r] + mesh->X[r]);
    const struct release_report moved = release_solve(body, 300, u);

    table_begin("sheet", "status energy min_J back");
    table_row(status_name(balance.status), balance.energy, balance.min_J,
              moved.recovered ? "yes" : "no");
    table_end();
    claim(balance.status == OK && balance.min_J > 0.0 &&
              fabs(winding - 2.0) < 1e-9,
          "the wound square is in stable balance with every J > 0");
    claim(!moved.recovered, "moved by 1 mm, it does not come back");
    body_free(body);
    mesh_free(mesh);
    return table_finish();
}
