/*
 * moved.c - what does it cost that a cut follows the edges of the mesh?
 *
 * The square of lesson 26, linear, is held on its left side, pulled at its
 * right one with 1 N/m, and cut slantwise from its upper side.  Either the cut
 * follows the edges, or the vertices of the path have been moved onto the
 * blade, the first and the last one to its ends, each as far as no angle of its
 * triangles falls below LIMIT.  The truth is extrapolated from n = 24 and 48,
 * moved: the tip gives the opening an error of order 1.
 */
int program_main(int argc, char *argv[]);
#define PROGRAM "../../solutions/26_cut.c"
#define main program_main
#include PROGRAM
#undef main

#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "plane/step.h"
#include "plane/tissue.h"

static const double BLADE[4] = {0.11, 1.0, -0.33, -0.12};
static const double LIMIT = 20.0; /* degrees */

/* The smallest angle of the triangles around vertex a, -1: any (degrees); a
 * triangle that is turned over has a negative one. */
static double least_angle(const struct mesh *mesh, int a)
{
    double least = 180.0;
    for (int c = 0; c < 3 * mesh->n_triangle; c++) {
        const int *t = &mesh->triangle[c / 3 * 3];
        if (a >= 0 && t[0] != a && t[1] != a && t[2] != a) continue;
        const double *P = &mesh->X[2 * t[c % 3]];
        const double *Q = &mesh->X[2 * t[(c + 1) % 3]];
        const double *R = &mesh->X[2 * t[(c + 2) % 3]];
        const double q[2] = {Q[0] - P[0], Q[1] - P[1]};
        const double r[2] = {R[0] - P[0], R[1] - P[1]};
        const double angle = atan2(q[0] * r[1] - q[1] * r[0],
                                   q[0] * r[0] + q[1] * r[1]);
        least = fmin(least, angle * 180.0 / acos(-1.0));
    }
    return least;
}

/* Move vertex k of the path, of m, onto the blade; halve the way while an angle
 * is too small. */
static void move(struct mesh *mesh, int k, int m, int a)
{
    const double d[2] = {BLADE[2] - BLADE[0], BLADE[3] - BLADE[1]};
    double *X = &mesh->X[2 * a];
    const double old[2] = {X[0], X[1]};
    double s = ((X[0] - BLADE[0]) * d[0] + (X[1] - BLADE[1]) * d[1]) /
               (d[0] * d[0] + d[1] * d[1]);
    s = k == 0 ? 0.0 : k == m - 1 ? 1.0 : s;
    for (double part = 1.0; part > 0.01; part *= 0.5) {
        for (int i = 0; i < 2; i++)
            X[i] = old[i] + part * (BLADE[i] + s * d[i] - old[i]);
        if (least_angle(mesh, a) >= LIMIT) return;
    }
    for (int i = 0; i < 2; i++) X[i] = old[i];
}

/* The widest opening (m) and the smallest angle. */
static double opening(int n, int moved, double *angle)
{
    const struct tissue square = tissue_alloc(mesh_square(n));
    struct mesh *mesh = square.mesh;
    int *chain = allocate((size_t)mesh->n_vertex, sizeof *chain);
    int *cut = allocate(3 * (size_t)mesh->n_triangle, sizeof *cut);
    const int m = path(mesh, BLADE, tissue_nearest(mesh, BLADE),
                       tissue_nearest(mesh, &BLADE[2]), chain);
    const struct tissue_whole whole = tissue_hold(&square, 1.0);
    for (int k = 0; k < m && moved; k++) move(mesh, k, m, chain[k]);
    tissue_mark(mesh, m, chain, cut);
    *angle = least_angle(mesh, -1);
    const struct tissue s = cut_body(&whole, cut, &square);
    struct body *body =
        body_alloc(s.mesh, material_notes(CUBIC), 1.0, LUMPED, s.held);
    for (int r = 0; r < 2 * s.mesh->n_vertex; r++) s.f[r] = -s.f[r];
    if (body_stiffness(body, s.u, EXACT, body->K) != OK ||
        body_increment(body, body->K, s.f, s.u) != OK) die("no rest");
    const double widest = tissue_opening(s.mesh, s.u);
    body_free(body);
    tissue_free(s);
    tissue_free(square);
    free(whole.across);
    free(whole.pulled);
    free(cut);
    free(chain);
    return widest;
}

int main(void)
{
    enum { MESHES = 4 };
    double angle, edges[MESHES], moved[MESHES], smallest = 180.0;
    int falls = 1, edges_fall = 1;
    const double fine = opening(48, 1, &angle);
    const double truth = 2.0 * fine - opening(24, 1, &angle);
    table_begin("opening", "n edges moved angle");
    for (int k = 0, n = 8; k < MESHES; k++, n += n / 2) {
        edges[k] = 1.0 - opening(n, 0, &angle) / truth;
        moved[k] = 1.0 - opening(n, 1, &angle) / truth;
        table_row(n, edges[k], moved[k], angle);
        smallest = fmin(smallest, angle);
        if (k == 0) continue;
        falls &= fabs(moved[k]) < 0.8 * fabs(moved[k - 1]);
        edges_fall &= fabs(edges[k]) < fabs(edges[k - 1]);
    }
    table_end();
    claim(falls, "with moved vertices each finer mesh has a smaller error");
    claim(!edges_fall, "along the edges a finer mesh may have a larger one");
    claim(smallest >= LIMIT, "no angle falls below the limit (%g)", smallest);
    return table_finish();
}
