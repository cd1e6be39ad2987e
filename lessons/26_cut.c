/*
 * 26_cut.c - a knife: a square of rubber is cut while it moves.
 *
 * Notes: the introduction, "push, pull or even cut/excise portions of the
 * tissue"; the body and its steps are those of Lecture 2, 3.3.
 *
 * Problem.  The square (-1, 1)^2 is held on its left side and pulled at its
 * right one.  In the middle of its motion a blade goes through it.  The cut
 * follows the edges of the mesh: an edge is marked in both of its triangles,
 * the vertices on the cut are doubled, and the motion goes on.
 *
 *     6---7---8     Corner c = 3e + k is vertex k of triangle e; edge c of e is
 *     | / # / |     the one opposite to corner c.  Cut along 4-7 (#), vertex 7
 *     3---4---5     has two fans of triangles, and becomes two vertices; vertex
 *     | / | / |     4 has one fan, all around the tip, and stays whole
 *     0---1---2
 *
 * Run       make lesson-26; make lesson-26 ARGS=-h lists its options
 * PREDICT 1 vertices that --blade ring adds: ...
 * PREDICT 2 Euler's number of the body then: ...
 * Plot: steps t elastic
 */
#include "base/options.h"
#include "base/table.h"
#include "plane/step.h"
#include "plane/tissue.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* From x to the nearest point of the blade, from blade[0], blade[1] straight to
 * blade[2], blade[3]. */
static double distance(const double blade[4], double x, double y)
{
    const double d[2] = {blade[2] - blade[0], blade[3] - blade[1]};
    const double length2 = d[0] * d[0] + d[1] * d[1];
    const double along = (x - blade[0]) * d[0] + (y - blade[1]) * d[1];
    const double s = fmin(1.0, fmax(0.0, along / length2));
    return hypot(x - blade[0] - s * d[0], y - blade[1] - s * d[1]);
}

/*
 * Given a straight blade, fill chain[] with the vertices of the cheapest path
 * along edges, first, ..., last, and return how many there are [alg:cut-path];
 * 1 where first is last.  An edge costs its length and the distance() of its
 * middle from the blade.  Where two paths cost the same, either will do.
 */
static int path(const struct mesh *mesh, const double blade[4], int first,
                int last, int chain[])
{
    double *cost = allocate((size_t)mesh->n_vertex, sizeof *cost);
    int *next = allocate((size_t)mesh->n_vertex, sizeof *next);
    int n = 0;
    /* SLOT 26a(mesh, blade, first, last, chain, cost, next, &n, distance): set
     * n and chain[0..n-1].  cost and next are room, a number per vertex. */
    todo("26a", mesh, blade, first, last, chain, cost, next, &n, distance);
    /* END 26a */
    free(next);
    free(cost);
    return n;
}

/*
 * Given the marks cut[c] != 0, one at each side of an edge, open the whole mesh
 * along them [alg:open]: triangle[c] := the new vertex of corner c.  Corners of
 * one vertex have the same new vertex exactly if one comes from the other
 * through triangles around it, across edges that are not marked.  The new
 * vertices are numbered from 0 on, those of vertex a before those of a + 1, in
 * any order among themselves.  Return how many there are.
 */
static int open_cut(const struct tissue_whole *whole, const int cut[],
                    int triangle[])
{
    const int *t = whole->mesh->triangle, *across = whole->across;
    const int corners = 3 * whole->mesh->n_triangle;
    const int n_vertex = whole->mesh->n_vertex;
    int *fan = allocate((size_t)corners, sizeof *fan);
    int *next = allocate((size_t)n_vertex + 1, sizeof *next);
    /* SLOT 26b(t, across, cut, corners, n_vertex, triangle, fan, next): given
     * t[c], the old vertex of corner c, set triangle[].  fan is room for a
     * number per corner, next is n_vertex + 1 zeros; next[n_vertex] is
     * returned. */
    todo("26b", t, across, cut, corners, n_vertex, triangle, fan, next);
    /* END 26b */
    const int n_new = next[n_vertex];
    free(next);
    free(fan);
    return n_new;
}

/*
 * Given a body before a cut, and the triangles after it, carry over what the
 * vertices have: X, held, u and v of a new vertex are those of the old one in
 * the same corner.  Its mass, a third of rho area of each of its triangles, and
 * its force, half of what acts on each of its pulled edges, are added up anew
 * [eq:lumped-cut]; the arrays hold anything before.
 */
static void carry(const struct tissue_whole *whole, const struct tissue *before,
                  const struct tissue *after)
{
    const int *old = before->mesh->triangle, *t = after->mesh->triangle;
    const int corners = 3 * after->mesh->n_triangle;
    double *X = after->mesh->X;
    /* SLOT 26c(whole, before, after, old, t, corners, X): given old[c] and
     * t[c], the vertices of corner c before and after, set X and the arrays of
     * after; mesh_gradients() returns the area of a triangle. */
    todo("26c", whole, before, after, old, t, corners, X);
    /* END 26c */
}

static double dot(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/*
 * Given the factor L of A, order n, the k columns of B, which begin at B[n j],
 * and C, dense and of order k, solve [eq:jumps]
 *
 *     A   y + B d = b      A is the matrix before the cut, d are the jumps
 *     B^T y + C d = c      between the lips, y and d hold b and c before
 *
 * by nothing but solves with L and a factorisation of order k: a status of
 * matrix_factor() that is not OK is returned, and y and d are spoilt, as C is.
 */
static enum status solve(const struct matrix *L, const double B[],
                         struct matrix *C, double y[], double d[])
{
    const int n = L->n, k = C->n;
    double *Z = allocate((size_t)n * (size_t)k, sizeof *Z);
    enum status status = OK;
    /* SLOT 26d(L, B, C, n, k, y, d, Z, &status, dot): Z is room for n k
     * numbers; matrix_solve(), matrix_add(), matrix_factor_solve(). */
    todo("26d", L, B, C, n, k, y, d, Z, &status, dot);
    /* END 26d */
    free(Z);
    return status;
}

static const char *const names[] = {"whole", "cut"};

/* Strokes of the knife; those of a ring begin where the last one ends. */
#define BLADES "slit inner across ring cross"
static const struct {
    int n;
    double at[5][4];
} blades[] = {
    {1, {{0.03, 1.1, -0.04, 0.05}}},
    {1, {{-0.55, -0.31, 0.6, 0.36}}},
    {1, {{0.1, 1.3, -0.2, -1.2}}},
    {5, {{0.55, 0.03, 0.2, 0.53}, {0.2, 0.53, -0.47, 0.3},
         {-0.47, 0.3, -0.45, -0.35}, {-0.45, -0.35, 0.22, -0.54},
         {0.22, -0.54, 0.55, 0.03}}},
    {2, {{-0.6, -0.05, 0.6, 0.1}, {0.05, -0.6, -0.07, 0.6}}},
};

/* The body before, opened along the marks. */
static struct tissue cut_body(const struct tissue_whole *whole,
                              const int cut[], const struct tissue *before)
{
    struct mesh *mesh = allocate(1, sizeof *mesh);
    mesh->n_triangle = whole->mesh->n_triangle;
    mesh->triangle = allocate(3 * (size_t)mesh->n_triangle, sizeof(int));
    mesh->n_vertex = open_cut(whole, cut, mesh->triangle);
    mesh->n = mesh->n_vertex - 1;
    mesh->X = allocate(2 * (size_t)mesh->n_vertex, sizeof *mesh->X);
    const struct tissue s = tissue_alloc(mesh);
    carry(whole, before, &s);
    return s;
}

/* Returns how many of its parts are loose. */
static int print_mesh(const char *name, const struct tissue *s)
{
    const struct mesh *mesh = s->mesh;
    int loose, boundary = 0, *across = mesh_across(mesh);
    for (int c = 0; c < 3 * mesh->n_triangle; c++)
        boundary += across[c] == c / 3;
    const int edges = (3 * mesh->n_triangle + boundary) / 2;
    const int parts = tissue_parts(s, &loose);
    table_row(name, mesh->n_vertex, edges, mesh->n_triangle,
              mesh->n_vertex - edges + mesh->n_triangle, boundary, parts,
              loose);
    free(across);
    return loose;
}

static void print_state(double t, const char *name, const struct tissue *s,
                        const struct body *body)
{
    double mass = 0.0, p[2] = {0.0}, kinetic = 0.0, load = 0.0, elastic;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        const double m = s->mass[r / 2];
        mass += 0.5 * m;
        p[r % 2] += m * s->v[r];
        kinetic += 0.5 * m * s->v[r] * s->v[r];
        load -= s->f[r] * s->u[r];
    }
    if (body_energy(body, s->u, &elastic) != OK) die("t = %g: inverted", t);
    table_row(t, name, mass, p[0], p[1], kinetic, elastic, load,
              tissue_opening(s->mesh, s->u));
}

/* At rest under its forces, from u = 0; so many parts are loose.  *whole is the
 * elastic energy of the whole body, which sets it. */
static void print_rest(const char *name, const struct tissue *s,
                       struct body *body, int loose, double *whole)
{
    double elastic = 0.0;
    double *u = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *u);
    const struct step_control newton = step_method("search");
    const enum status status =
        step_solve(body, &newton, at_rest(s->f), u).status;
    const int solved = status == OK && body_energy(body, u, &elastic) == OK;
    if (*whole == 0.0) *whole = elastic;
    table_row(name, status_name(status), loose ? "loose" : MISSING,
              cell_if(solved, elastic),
              cell_if(solved && *whole > 0.0, elastic / *whole),
              cell_if(solved, tissue_opening(s->mesh, u)));
    free(u);
}

/* The first increment of Newton's method from u = 0, of a step or (dt = 0) at
 * rest: of the cut body by its own factors, and by those of the whole one. */
static void print_update(const char *name, struct body *const body[2],
                         const struct tissue s[2], double dt)
{
    const int n = body[0]->n_equation, N = body[1]->n_equation, k = N - n;
    if (k == 0) return; /* nothing has opened */
    double *u = allocate(2 * (size_t)body[1]->mesh->n_vertex, sizeof *u);
    double *q = allocate(2 * (size_t)body[1]->mesh->n_vertex, sizeof *q);
    double *x = allocate((size_t)N, sizeof *x);
    double *y = allocate((size_t)N, sizeof *y); /* and d behind it */
    for (int m = 0; m < 2; m++)
        body_assemble(body[m], (struct incremental){dt > 0.0 ? dt : 1.0,
                                                    dt > 0.0 ? u : NULL,
                                                    s[m].f}, u, EXACT, q);
    body_gather(body[1], q, x);
    struct tissue_border border = tissue_border_alloc(body);
    const struct matrix_cost anew = matrix_cost(BANDED, N, body[1]->K->p);
    const struct matrix_cost kept = matrix_cost(BANDED, n, body[0]->K->p);
    for (int i = 0; i < N; i++) {
        x[i] = -x[i];
        y[border.old[i]] += x[i];
        if (border.jump[i] >= 0) y[n + border.jump[i]] += x[i];
    }
    const enum status factored = matrix_factor_solve(body[1]->K, x);
    enum status status = matrix_factor(body[0]->K);
    if (status == OK) status = solve(body[0]->K, border.B, border.C, y, &y[n]);
    double off = 0.0, size = 0.0;
    for (int i = 0; i < N; i++) {
        const int j = border.jump[i];
        const double u_i = y[border.old[i]] + (j < 0 ? 0.0 : y[n + j]);
        off = fmax(off, fabs(u_i - x[i]));
        size = fmax(size, fabs(x[i]));
    }
    if (factored != OK || status != OK) die("the update: NOT_SPD");
    table_row(name, n, k, off <= 1e-10 * size ? "yes" : "no",
              anew.flops + anew.solve,
              (k + 1) * kept.solve + n * (k * (k + 1.0) + 4.0 * k) +
                  matrix_cost(DENSE, k, 0).flops);
    tissue_border_free(border);
    free(y);
    free(x);
    free(q);
    free(u);
}

int main(int argc, char *argv[])
{
    int n = 8, blade = 0, steps = 10;
    double pull = 100.0;
    const double dt = 1.0 / 30.0;
    const struct option options[] = {
        {"blade", .choice = &blade, .choices = BLADES, .help = "its path"},
        {"n", .integer = &n, .min = 4, .max = 60, .help = "n x n squares"},
        {"steps", .integer = &steps, .min = 1, .max = 100,
         .help = "before the cut, and after it"},
        {"pull", .real = &pull, .min = -100, .max = 400, .unit = "N/m",
         .help = "traction on the right side"},
    };
    options_parse("26_cut", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    const struct tissue square = tissue_alloc(mesh_square(n));
    const struct tissue_whole whole = tissue_hold(&square, pull);
    struct tissue s[2];
    struct body *body[2];
    int *cut = allocate(3 * (size_t)whole.mesh->n_triangle, sizeof *cut);
    int *chain = allocate((size_t)whole.mesh->n_vertex, sizeof *chain);
    s[0] = cut_body(&whole, cut, &square);

    table_begin("chain", "stroke x y");
    for (int k = 0; k < blades[blade].n; k++) {
        const double *at = blades[blade].at[k];
        const int length = path(whole.mesh, at, tissue_nearest(whole.mesh, at),
                                tissue_nearest(whole.mesh, &at[2]), chain);
        tissue_mark(whole.mesh, length, chain, cut);
        for (int m = 0; m < length; m++)
            table_row(k, whole.mesh->X[2 * chain[m]],
                      whole.mesh->X[2 * chain[m] + 1]);
    }
    table_end();

    const struct step_control newton = step_method("demand+search");
    table_begin("steps", "t body mass momentum_x momentum_y kinetic elastic "
                "load opening");
    for (int k = 0; k < 2; k++) {
        if (k == 1) s[1] = cut_body(&whole, cut, &s[0]);
        body[k] = body_alloc(s[k].mesh, material_notes(CUBIC), whole.rho,
                             LUMPED, s[k].held);
        double *g = allocate(2 * (size_t)s[k].mesh->n_vertex, sizeof *g);
        for (int m = 0; m <= steps; m++) {
            if (m > 0 && step_backward_euler(body[k], &newton, dt, g, s[k].f,
                                             s[k].u, s[k].v, NULL).status != OK)
                die("step %d fails", k * steps + m);
            print_state((k * steps + m) * dt, names[k], &s[k], body[k]);
        }
        free(g);
    }
    table_end();

    table_begin("mesh", "body vertices edges triangles euler boundary parts "
                "loose");
    int loose[2];
    for (int k = 0; k < 2; k++) loose[k] = print_mesh(names[k], &s[k]);
    table_end();
    table_begin("rest", "body status reason elastic times opening");
    double elastic = 0.0; /* of the whole body */
    for (int k = 0; k < 2; k++)
        print_rest(names[k], &s[k], body[k], loose[k], &elastic);
    table_end();
    table_begin("update", "of unknowns jumps agree factor_flops "
                "update_flops");
    if (!loose[1]) print_update("rest", body, s, 0.0);
    print_update("step", body, s, dt);
    for (int k = 0; k < 2; k++) {
        body_free(body[k]);
        tissue_free(s[k]);
    }
    table_end();
    free(chain);
    free(cut);
    free(whole.pulled);
    free(whole.across);
    tissue_free(square);
    return table_finish();
}
