/*
 * near.c - how far from a cut may the body stay as it was?
 *
 * The square of lesson 26, linear, is held on its left side, pulled at its
 * right one with 1 N/m, and cut once: within, or from its upper side.  The
 * least model after the cut moves only the vertices within R of the blade, and
 * leaves the others where they were.  Table misses: how often, over all cuts
 * and R = c, 2 c, 4 c, the opening misses more than 1.5 times the estimate
 * c / (2 R), where c is half the length of a cut within, and the length of one
 * from the side, behind which its image would be.
 */
int program_main(int argc, char *argv[]);
#define PROGRAM "../../solutions/26_cut.c"
#define main program_main
#include PROGRAM
#undef main

#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "plane/step.h"
#include "plane/tissue.h"

enum { N = 32, CUTS = 24, RADII = 3 };

/* Cut number k; returns c. */
static double draw(int k, double blade[4])
{
    const double length = 0.2 + 0.6 * fmod(0.6180339887 * k, 1.0);
    const double x = -0.6 + 1.2 * fmod(0.7548776662 * k, 1.0);
    const double lean = (-0.4 + 0.8 * fmod(0.5698402910 * k, 1.0)) * length;
    const double top = k % 2 ? 1.0 : -0.5 + fmod(0.3 * k, 1.0) + length / 2.0;
    blade[0] = x;
    blade[1] = top;
    blade[2] = x + lean;
    blade[3] = top - length;
    return k % 2 ? length : length / 2.0;
}

/* A body with K of linear elasticity, whose vertices within R of the blade are
 * free. */
static struct body *linear_body(const struct tissue *s, const double blade[4],
                                double R)
{
    const double *X = s->mesh->X;
    const size_t vertices = (size_t)s->mesh->n_vertex;
    double *rest = allocate(2 * vertices, sizeof *rest);
    int *held = allocate(vertices, sizeof *held);
    for (int a = 0; a < s->mesh->n_vertex; a++)
        held[a] = s->held[a] || distance(blade, X[2 * a], X[2 * a + 1]) > R;
    struct body *body =
        body_alloc(s->mesh, material_notes(CUBIC), 1.0, LUMPED, held);
    if (body_stiffness(body, rest, EXACT, body->K) != OK) die("no K");
    free(rest);
    free(held);
    return body;
}

/* to := u + K^-1 (f - K u), of the vertices within R of the blade. */
static void relax(const struct tissue *s, const double blade[4], double R,
                  const double u[], double to[])
{
    const size_t n = 2 * (size_t)s->mesh->n_vertex;
    struct body *all = linear_body(s, blade, INFINITY);
    struct body *near = linear_body(s, blade, R);
    double *q = allocate(n, sizeof *q), *some = allocate(n, sizeof *some);
    body_gather(all, u, some);
    matrix_multiply(all->K, some, to);
    body_scatter(all, to, q);
    for (size_t i = 0; i < n; i++) q[i] -= s->f[i];
    if (body_increment(near, near->K, q, to) != OK) die("not definite");
    for (size_t i = 0; i < n; i++) to[i] += u[i];
    body_free(all);
    body_free(near);
    free(q);
    free(some);
}

/* What is missing of the opening of cut k at R = c, 2 c, 4 c. */
static void cut_once(int k, double missing[RADII])
{
    double blade[4], open[RADII + 1];
    const double c = draw(k, blade);
    const struct tissue square = tissue_alloc(mesh_square(N));
    const size_t corners = 3 * (size_t)square.mesh->n_triangle;
    int *chain = allocate(corners, sizeof *chain);
    int *cut = allocate(corners, sizeof *cut);
    const struct tissue_whole whole = tissue_hold(&square, 1.0);
    const struct tissue before = cut_body(&whole, cut, &square);
    relax(&before, blade, INFINITY, square.u, before.u);
    const int m = path(square.mesh, blade, tissue_nearest(square.mesh, blade),
                       tissue_nearest(square.mesh, &blade[2]), chain);
    tissue_mark(square.mesh, m, chain, cut);
    const struct tissue s = cut_body(&whole, cut, &before);
    double *u = allocate(2 * (size_t)s.mesh->n_vertex, sizeof *u);
    for (int r = 0; r <= RADII; r++) {
        const double R = r < RADII ? c * (1 << r) : INFINITY;
        relax(&s, blade, R, s.u, u);
        open[r] = tissue_opening(s.mesh, u);
    }
    for (int r = 0; r < RADII; r++) missing[r] = 1.0 - open[r] / open[RADII];
    free(u);
    tissue_free(s);
    tissue_free(before);
    tissue_free(square);
    free(whole.across);
    free(whole.pulled);
    free(chain);
    free(cut);
}

int main(void)
{
    double missing[RADII];
    int misses = 0, above[RADII] = {0};
    for (int k = 0; k < CUTS; k++) {
        cut_once(k, missing);
        for (int r = 0; r < RADII; r++) {
            above[r] += missing[r] > 0.5 / (1 << r);
            misses += missing[r] > 1.5 * 0.5 / (1 << r);
        }
    }
    table_begin("misses", "misses of");
    table_row(misses, CUTS * RADII);
    table_end();
    claim(5 * misses <= CUTS * RADII, "at most a fifth lose 1.5 times the "
          "estimate (%d of %d)", misses, CUTS * RADII);
    claim(above[0] > CUTS / 3 && above[1] > CUTS / 3,
          "the estimate is in the middle, not above all (%d, %d)", above[0],
          above[1]);
    return table_finish();
}
