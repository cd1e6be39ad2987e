/*
 * sheet.c - a square that is wound twice round its middle vertex: how does it
 * rest, and why does the stable law bring back more squares the finer they are?
 *
 * A square of n x n cells is wound twice round its middle vertex and let go
 * [alg:release]; once it is in balance, all its vertices are moved at random by
 * at most 1 mm, and it is let go again.  Table: is the balance stable (OK) or
 * not (SADDLE), its energy and least J, the least energy of a flat triangle, as
 * one must be on the way back, how many of them the energy could pay, and does
 * the moved square come back?  (Where s2 = 0 the energy mu/2 (s1^2 - 2) + G(0)
 * is least at a point.)  Table wound: the corners of the triangles in balance,
 * cubic law, n = 2.
 */
#include "plane/release.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { FINEST = 8, N_DOF = 2 * (FINEST + 1) * (FINEST + 1), SMALLEST = 9 };

struct end {
    struct release_report balance, moved;
    double winding; /* in balance */
    double price, pays; /* of a flat triangle; how many the energy could pay */
    double place[2 * SMALLEST]; /* of the vertices in balance, n = 2 */
};

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

static struct end let_go(int n, enum law law)
{
    struct mesh *mesh = mesh_square(n);
    const int held[N_DOF / 2] = {0};
    struct body *body =
        body_alloc(mesh, material_notes(law), 0.0, CONSISTENT, held);
    double u[N_DOF], random[N_DOF];
    struct end end;
    body_store(body, PLAIN);
    wind(mesh, u);
    end.balance = release_solve(body, 300, u);
    end.price = 2.0 / (n * n) * material2_psi(&body->material, (mat2){0});
    end.pays = end.balance.energy / end.price;
    end.winding = release_winding(body, u);
    if (n == 2)
        for (int r = 0; r < 2 * SMALLEST; r++)
            end.place[r] = mesh->X[r] + u[r];
    release_scramble(body, 1, random);
    for (int r = 0; r < body->n_equation; r++)
        u[r] += 1e-3 * (random[r] + mesh->X[r]);
    end.moved = release_solve(body, 300, u);
    body_free(body);
    mesh_free(mesh);
    return end;
}

static void print_wound(const double x[])
{
    struct mesh *mesh = mesh_square(2);
    table_begin("wound", "x0 y0 x1 y1 x2 y2");
    for (const int *t = mesh->triangle; t < mesh->triangle + 24; t += 3)
        table_row(x[2 * t[0]], x[2 * t[0] + 1], x[2 * t[1]], x[2 * t[1] + 1],
                  x[2 * t[2]], x[2 * t[2] + 1]);
    table_end();
    mesh_free(mesh);
}

int main(void)
{
    const enum law law[] = {CUBIC, EXTENDED, STABLE};
    struct end end[3][3]; /* law, n = 2, 4, 8 */
    table_begin("sheet", "law n status energy min_J price pays back");
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            const struct end *e = &end[k][i];
            end[k][i] = let_go(2 << i, law[k]);
            table_row(material_law(law[k]), 2 << i,
                      status_name(e->balance.status), e->balance.energy,
                      e->balance.min_J, e->price, e->pays,
                      e->moved.recovered ? "yes" : "no");
        }
    table_end();
    print_wound(end[0][0].place);

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            const struct release_report *r = &end[k][i].balance;
            const int gives_way = law[k] == STABLE && i > 0;
            claim(r->min_J > 0.0 && fabs(end[k][i].winding - 2.0) < 1e-9 &&
                      r->status == (gives_way ? SADDLE : OK),
                  "the wound square is in balance with every J > 0; this is "
                  "stable but under the stable law with n > 2 (%s, n = %d)",
                  material_law(law[k]), 2 << i);
            claim(end[k][i].moved.recovered == gives_way,
                  "moved by 1 mm, only what was not stable comes back");
            claim(i == 0 || r->min_J < end[k][i - 1].balance.min_J,
                  "the finer, the flatter is its flattest triangle");
            claim(i == 0 || end[k][i].pays > end[k][i - 1].pays,
                  "the finer, the more flat triangles its energy could pay");
        }
    return table_finish();
}
