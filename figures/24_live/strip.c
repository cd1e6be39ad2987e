/* strip.c - see strip.h. */
#include "strip.h"

#include "motion/live.h"

#include <stdlib.h>
#include <string.h>

static const double WIDTH = 0.1, HEIGHT = 0.03; /* m */
static const double DEPTH = 0.01; /* of which forces and energies are (m) */

/* Vertex i of row j, of a lip where it has two. */
static int vertex(const struct strip *s, int i, int j)
{
    return j * (s->n + 2) + (i == s->n / 2 + 1 && j <= s->tip ? i - 1 : i);
}

static struct mesh *cut_mesh(const struct strip *s)
{
    struct mesh *mesh =
        mesh_rectangle(s->n + 1, s->rows, 0.5 * WIDTH, 0.5 * HEIGHT);
    int *t = mesh->triangle;
    for (int j = 0; j <= s->rows; j++)
        for (int i = 0; i <= s->n + 1; i++) {
            const int place = i > s->n / 2 ? i - 1 : i;
            mesh->X[2 * (j * (s->n + 2) + i)] =
                WIDTH * ((double)place / s->n - 0.5);
            /* no cell beyond the last vertices, and none between the lips */
            if (j == s->rows || i > s->n || i == s->n / 2) continue;
            const int a = vertex(s, i, j), c = vertex(s, i + 1, j + 1);
            const int cell[6] = {a, vertex(s, i + 1, j), c,
                                 a, c, vertex(s, i, j + 1)};
            memcpy(t, cell, sizeof cell);
            t += 6;
        }
    mesh->n_triangle = 2 * s->n * s->rows;
    return mesh;
}

struct strip strip_alloc(int n, int tip)
{
    struct strip s = {.n = n, .rows = 3 * n / 10, .tip = tip};
    s.mesh = cut_mesh(&s);
    const size_t size = 2 * (size_t)s.mesh->n_vertex;
    int *held = allocate(size, sizeof *held);
    for (int j = 0; j <= s.rows; j++) {
        held[vertex(&s, 0, j)] = held[vertex(&s, n + 1, j)] = 1;
        if (j <= tip) held[j * (n + 2) + n / 2 + 1] = 1; /* alone */
    }
    s.body = body_alloc(s.mesh, material_notes(LOG), 0.0, LUMPED, held);
    s.u = allocate(size, sizeof(double));
    s.g = allocate(size, sizeof(double));
    s.q = allocate(size, sizeof(double));
    free(held);
    return s;
}

void strip_free(struct strip *s)
{
    body_free(s->body);
    mesh_free(s->mesh);
    free(s->u);
    free(s->g);
    free(s->q);
}

/* The balance from s->u, which has its held values; returns the systems. */
static int balance(struct strip *s)
{
    const struct step_control newton = step_method("search");
    const int lip = 2 * vertex(s, s->n / 2, s->rows);
    const struct step_report report =
        step_solve(s->body, &newton, at_rest(NULL), s->u);
    if (report.status != OK ||
        step_certify(s->body, at_rest(NULL), s->u) != OK ||
        body_energy(s->body, s->u, &s->energy) != OK ||
        body_force(s->body, s->u, s->q) != OK) die("no stable balance");
    s->energy *= DEPTH;
    s->opening = s->u[lip + 2] - s->u[lip];
    s->force = 0.0;
    for (int j = 0; j <= s->rows; j++)
        s->force += DEPTH * s->q[2 * vertex(s, s->n + 1, j)];
    return report.iterations;
}

void strip_pull(struct strip *s, double d)
{
    for (int j = 0; j <= s->rows; j++) s->g[2 * vertex(s, s->n + 1, j)] = d;
    if (live_lift(s->body, at_rest(NULL), s->u, s->g, EXACT, s->q) != OK)
        die("no lift to %g m", d);
    memcpy(s->u, s->q, 2 * (size_t)s->mesh->n_vertex * sizeof *s->u);
    balance(s);
}

int strip_cut(const struct strip *whole, struct strip *s)
{
    memcpy(s->u, whole->u, 2 * (size_t)s->mesh->n_vertex * sizeof *s->u);
    for (int j = s->tip + 1; j <= s->rows; j++) {
        double *lip = &s->u[2 * vertex(s, s->n / 2, j)];
        memcpy(lip + 2, lip, 2 * sizeof *lip);
    }
    return balance(s);
}
