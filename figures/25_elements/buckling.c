/*
 * buckling.c - at which load does a slender column buckle, said by linear and
 * by quadratic triangles?
 *
 * The column (-1, 1) x (-1/8, 1/8), log law, both ends moved inwards by e.  The
 * mesh, the load and so the straight state stay the same when they are turned
 * by half a turn; the first way out does not, and Newton's method does not find
 * it by itself.  So e is bisected: K is positive definite at the straight state
 * and on the way to it, or is not.  Table: e, and how far it is above that of
 * quadratic triangles with n = 128, graded towards the sides with m = 3.
 */
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "plane/body.h"
#include "plane/quadratic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CAP = 12 }; /* systems */

/* The column of squares of side 2/n, on whose vertices one body lives. */
struct column {
    struct mesh *mesh;
    struct body *body;
    int *held;
};

/* Newton from u, whose ends have their places: 1, u is the straight state and K
 * is positive definite there. */
static int stands(const struct column *c, double u[], double q[], double du[])
{
    for (int k = 0; k < CAP; k++) {
        double largest = 0.0;
        if (body_assemble(c->body, at_rest(NULL), u, EXACT, q) != OK ||
            body_increment(c->body, c->body->K, q, du) != OK)
            return 0;
        for (int r = 0; r < 2 * c->mesh->n_vertex; r++) {
            u[r] += du[r];
            largest = fmax(largest, fabs(du[r]));
        }
        if (largest < 1e-8) return 1;
    }
    return 0;
}

/* The e at which K ceases to be positive definite, to 1e-7 m. */
static double limit(int quadratic, int n, double m)
{
    const int cells = quadratic ? 2 * n : n;
    const struct material material = material_notes(LOG);
    struct column c = {.mesh = mesh_rectangle(cells, cells / 8, 1.0, 0.125)};
    const size_t n_dof = 2 * (size_t)c.mesh->n_vertex;
    double *u = allocate(n_dof, sizeof *u), *q = allocate(n_dof, sizeof *q);
    double *du = allocate(n_dof, sizeof *du);
    double *trial = allocate(n_dof, sizeof *trial);
    double low = 0.0, step = 0.01;
    mesh_grade(c.mesh, m, MESH_LEFT | MESH_RIGHT | MESH_BOTTOM | MESH_TOP);
    c.held = allocate(n_dof, sizeof *c.held);
    for (int j = 0; j <= c.mesh->rows; j++)
        c.held[j * (cells + 1)] = c.held[j * (cells + 1) + cells] = 1;
    if (quadratic) quadratic_straighten(c.mesh);
    c.body = body_alloc_of(quadratic ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE,
                           c.mesh, material, 0.0, CONSISTENT, c.held);
    while (step > 1e-7) {
        for (int a = 0; a < c.mesh->n_vertex; a++) { /* carried on evenly */
            trial[2 * a] = u[2 * a] - step * c.mesh->X[2 * a];
            trial[2 * a + 1] = u[2 * a + 1];
        }
        if (stands(&c, trial, q, du)) {
            low += step;
            memcpy(u, trial, n_dof * sizeof *u);
        } else {
            step *= 0.5;
        }
    }
    body_free(c.body);
    mesh_free(c.mesh);
    free(c.held), free(u), free(q), free(du), free(trial);
    return low;
}

int main(void)
{
    static const struct {
        const char *element;
        int n;
        double m;
    } row[] = {{"linear", 16, 1.0}, {"linear", 32, 1.0}, {"linear", 64, 1.0},
               {"linear", 64, 1.5}, {"quadratic", 16, 1.0},
               {"quadratic", 32, 1.0}, {"quadratic", 32, 2.0}};
    const double truth = limit(1, 128, 3.0);
    double above[COUNT(row)];

    table_begin("buckling", "element n m e above");
    for (int k = 0; k < COUNT(row); k++) {
        const double e =
            limit(row[k].element[0] == 'q', row[k].n, row[k].m);
        above[k] = e / truth - 1.0;
        table_row(row[k].element, row[k].n, row[k].m, cell_rounded(4, e),
                  cell_rounded(2, above[k]));
    }
    table_end();
    claim(above[0] > 0.5 && fabs(above[4]) < 0.02,
          "n = 16: linear triangles carry more than half as much again (%g), "
          "quadratic ones are right to 2 %% (%g)", above[0], above[4]);
    claim(fabs(above[3] - above[2]) < 0.25 * above[2],
          "grading does not help linear triangles to bend (%g, %g)", above[2],
          above[3]);
    return table_finish();
}
