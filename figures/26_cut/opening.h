/*
 * opening.h - 24 slanting cuts of the square of lesson 26: along edges of the
 * mesh, or with the vertices of the path moved onto the blade, the first and
 * the last one to its ends, each as far as no angle of its triangles falls
 * below OPENING_ANGLE.
 *
 * The square is linear, held on its left side and pulled at its right one with
 * 1 N/m.  The truth is extrapolated from n = 24 and 48, moved: the tip gives
 * the opening an error of order 1.
 */
#ifndef FIGURES_OPENING_H
#define FIGURES_OPENING_H

int program_main(int argc, char *argv[]);
#define PROGRAM "../../solutions/26_cut.c"
#define main program_main
#include PROGRAM
#undef main

#include "base/clock.h"
#include "plane/step.h"
#include "plane/tissue.h"

enum { OPENING_CUTS = 24 };
#define OPENING_ANGLE 20.0 /* degrees */

struct opening {
    double widest;  /* (m) */
    double flops;   /* to factor K and to solve */
    double seconds; /* from the blade to the opening */
    double angle;   /* the smallest one (degrees) */
};

/* The missing fraction of the opening, over all cuts. */
struct openings {
    double mean, spread, rms; /* standard deviation; root mean square */
    double flops, seconds, angle;
};

/* Blade number k, from the upper side downwards. */
static void opening_blade(int k, double blade[4])
{
    const double length = 0.5 + 0.7 * fmod(0.6180339887 * k, 1.0);
    blade[0] = -0.4 + 0.8 * fmod(0.7548776662 * k, 1.0);
    blade[1] = 1.0;
    blade[2] = blade[0] + length * (-0.4 + 0.8 * fmod(0.5698402910 * k, 1.0));
    blade[3] = 1.0 - length;
}

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
static void move(struct mesh *mesh, const double blade[4], int k, int m, int a)
{
    const double d[2] = {blade[2] - blade[0], blade[3] - blade[1]};
    double *X = &mesh->X[2 * a];
    const double old[2] = {X[0], X[1]};
    double s = ((X[0] - blade[0]) * d[0] + (X[1] - blade[1]) * d[1]) /
               (d[0] * d[0] + d[1] * d[1]);
    s = k == 0 ? 0.0 : k == m - 1 ? 1.0 : s;
    for (double part = 1.0; part > 0.01; part *= 0.5) {
        for (int i = 0; i < 2; i++)
            X[i] = old[i] + part * (blade[i] + s * d[i] - old[i]);
        if (least_angle(mesh, a) >= OPENING_ANGLE) return;
    }
    for (int i = 0; i < 2; i++) X[i] = old[i];
}

static struct opening opening(int n, const double blade[4], int moved)
{
    struct opening r;
    const struct tissue square = tissue_alloc(mesh_square(n));
    struct mesh *mesh = square.mesh;
    int *chain = allocate((size_t)mesh->n_vertex, sizeof *chain);
    int *cut = allocate(3 * (size_t)mesh->n_triangle, sizeof *cut);
    const struct tissue_whole whole = tissue_hold(&square, 1.0);
    const double start = clock_seconds();
    const int m = path(mesh, blade, tissue_nearest(mesh, blade),
                       tissue_nearest(mesh, &blade[2]), chain);
    for (int k = 0; k < m && moved; k++) move(mesh, blade, k, m, chain[k]);
    tissue_mark(mesh, m, chain, cut);
    const struct tissue s = cut_body(&whole, cut, &square);
    struct body *body =
        body_alloc(s.mesh, material_notes(CUBIC), 1.0, LUMPED, s.held);
    for (int i = 0; i < 2 * s.mesh->n_vertex; i++) s.f[i] = -s.f[i];
    if (body_stiffness(body, s.u, EXACT, body->K) != OK ||
        body_increment(body, body->K, s.f, s.u) != OK) die("no rest");
    r.widest = tissue_opening(s.mesh, s.u);
    r.seconds = clock_seconds() - start;
    const struct matrix_cost cost =
        matrix_cost(BANDED, body->K->n, body->K->p);
    r.flops = cost.flops + cost.solve;
    r.angle = least_angle(mesh, -1);
    body_free(body);
    tissue_free(s);
    tissue_free(square);
    free(whole.across);
    free(whole.pulled);
    free(cut);
    free(chain);
    return r;
}

static void openings_truth(double truth[OPENING_CUTS])
{
    double blade[4];
    for (int k = 0; k < OPENING_CUTS; k++) {
        opening_blade(k, blade);
        truth[k] = 2.0 * opening(48, blade, 1).widest -
                   opening(24, blade, 1).widest;
    }
}

/* Seconds and flops are means of a cut, the seconds of the best of the runs. */
static struct openings openings(int n, int moved, int runs,
                                const double truth[OPENING_CUTS])
{
    struct openings all = {.angle = 180.0};
    double squares = 0.0, blade[4];
    for (int k = 0; k < OPENING_CUTS; k++) {
        opening_blade(k, blade);
        struct opening cut = opening(n, blade, moved);
        for (int run = 1; run < runs; run++)
            cut.seconds =
                fmin(cut.seconds, opening(n, blade, moved).seconds);
        const double missing = 1.0 - cut.widest / truth[k];
        all.mean += missing / OPENING_CUTS;
        squares += missing * missing / OPENING_CUTS;
        all.flops += cut.flops / OPENING_CUTS;
        all.seconds += cut.seconds / OPENING_CUTS;
        all.angle = fmin(all.angle, cut.angle);
    }
    all.spread = sqrt(squares - all.mean * all.mean);
    all.rms = sqrt(squares);
    return all;
}

#endif
