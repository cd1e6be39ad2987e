/* strip.c - see strip.h. */
#include "strip.h"

int program_main(int argc, char *argv[]);
#define PROGRAM "../../solutions/26_cut.c"
#define main program_main
#include PROGRAM
#undef main

#include "base/options.h"
#include "base/table.h"
#include "motion/live.h"

static const double WIDTH = 0.1, HEIGHT = 0.03; /* m */
static const double DEPTH = 0.01; /* of which forces and energies are (m) */

struct tissue strip_knife(const struct tissue *section, const double blade[4])
{
    const struct mesh *mesh = section->mesh;
    const size_t corners = 3 * (size_t)mesh->n_triangle;
    const struct tissue_whole whole = {
        mesh, mesh_across(mesh), allocate(corners, sizeof(int)), {0.0}, 1.0};
    int *cut = allocate(corners, sizeof *cut);
    int *chain = allocate((size_t)mesh->n_vertex, sizeof *chain);
    const int length = path(mesh, blade, tissue_nearest(mesh, blade),
                            tissue_nearest(mesh, &blade[2]), chain);
    tissue_mark(mesh, length, chain, cut);
    const struct tissue s = cut_body(&whole, cut, section);
    free(chain);
    free(cut);
    free(whole.pulled);
    free(whole.across);
    return s;
}

struct strip strip_alloc(int n, int cells)
{
    struct strip s = {.n = n, .rows = 3 * n / 10};
    struct mesh *mesh = tissue_section(n, s.rows, WIDTH, HEIGHT);
    s.uncut = tissue_alloc(mesh);
    for (int a = 0; a < mesh->n_vertex; a++)
        s.uncut.held[a] = fabs(mesh->X[2 * a]) > 0.499 * WIDTH;

    const double blade[4] = {0.0, 0.5 * HEIGHT, 0.0,
                             HEIGHT * (0.5 - (double)cells / s.rows)};
    s.s = strip_knife(&s.uncut, blade);
    s.body = body_alloc(s.s.mesh, material_notes(LOG), 0.0, LUMPED, s.s.held);
    s.g = allocate(2 * (size_t)s.s.mesh->n_vertex, sizeof *s.g);
    s.q = allocate(2 * (size_t)s.s.mesh->n_vertex, sizeof *s.q);
    return s;
}

void strip_free(struct strip *s)
{
    body_free(s->body);
    tissue_free(s->s);
    tissue_free(s->uncut);
    free(s->g);
    free(s->q);
}

static int in_hand(const struct strip *s, int a)
{
    return s->s.mesh->X[2 * a] > 0.499 * WIDTH;
}

/* The balance from s->s.u, which has its held values; returns the systems. */
static int balance(struct strip *s)
{
    const struct step_control newton = step_method("search");
    double *u = s->s.u;
    const struct step_report report =
        step_solve(s->body, &newton, at_rest(NULL), u);
    if (report.status != OK ||
        step_certify(s->body, at_rest(NULL), u) != OK ||
        body_energy(s->body, u, &s->energy) != OK ||
        body_force(s->body, u, s->q) != OK) die("no stable balance");
    s->energy *= DEPTH;
    s->opening = tissue_opening(s->s.mesh, u);
    s->force = 0.0;
    for (int a = 0; a < s->s.mesh->n_vertex; a++)
        if (in_hand(s, a)) s->force += DEPTH * s->q[2 * a];
    return report.iterations;
}

void strip_pull(struct strip *s, double d)
{
    for (int a = 0; a < s->s.mesh->n_vertex; a++)
        if (in_hand(s, a)) s->g[2 * a] = d;
    if (live_lift(s->body, at_rest(NULL), s->s.u, s->g, EXACT, s->q) != OK)
        die("no lift to %g m", d);
    memcpy(s->s.u, s->q, 2 * (size_t)s->s.mesh->n_vertex * sizeof *s->q);
    balance(s);
}

int strip_cut(const struct strip *whole, struct strip *s)
{
    for (int c = 0; c < 3 * s->s.mesh->n_triangle; c++)
        memcpy(&s->s.u[2 * s->s.mesh->triangle[c]],
               &whole->s.u[2 * whole->s.mesh->triangle[c]],
               2 * sizeof *s->s.u);
    return balance(s);
}
