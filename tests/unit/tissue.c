/* tissue.c - laws of common/plane/tissue.h. */
#include "plane/tissue.h"

#include "../oracle/26_cut.h"
#include "unit.h"

#include <math.h>
#include <stdlib.h>

/* Two squares, 0 1 2 3 and 4 5 6 7, that share no vertex: 3 and 4 are at one
 * X. */
static struct tissue two_squares(void)
{
    static const int t[12] = {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6};
    static const double X[16] = {0, 0, 1, 0, 0, 1, 2, 1,
                                 2, 1, 3, 1, 2, 2, 3, 2};
    struct mesh *mesh = mesh_rectangle(7, 1, 1.0, 1.0);
    mesh->n_vertex = 8;
    mesh->n_triangle = 4;
    for (int c = 0; c < 12; c++) mesh->triangle[c] = t[c];
    for (int r = 0; r < 16; r++) mesh->X[r] = X[r];
    return tissue_alloc(mesh);
}

static unsigned seed_of = 1;
static double chance(void) /* in (0, 1), a linear congruence */
{
    seed_of = seed_of * 1103515245u + 12345u;
    return ((seed_of >> 16) % 9973 + 0.5) / 9973.0;
}

/* A square whose triangles hang together along this fraction of their edges. */
static struct tissue random_cuts(double fraction)
{
    struct mesh *whole = mesh_square(3), *mesh = mesh_rectangle(53, 1, 1, 1);
    int *across = mesh_across(whole), fan[54], joined[54];
    const int *t = whole->triangle;
    mesh->n_triangle = 18;
    mesh->n_vertex = 0;
    for (int c = 0; c < 54; c++) {
        fan[c] = c;
        joined[c] = chance() < fraction; /* edge c, from this side */
    }
    for (int again = 54 * 54; again--;) { /* the first corner names a fan */
        const int c = again % 54, e = c / 3 * 3, f = across[c] * 3;
        for (int p = e; p < e + 3; p++)
            for (int q = f; q < f + 3 && joined[c] && f != e; q++)
                if (p != c && t[p] == t[q])
                    fan[p] = fan[q] = fan[p] < fan[q] ? fan[p] : fan[q];
    }
    for (int c = 0; c < 54; c++) {
        const int a = fan[c] == c ? mesh->n_vertex++
                                  : mesh->triangle[fan[c]];
        mesh->triangle[c] = a;
        for (int i = 0; i < 2; i++) mesh->X[2 * a + i] = whole->X[2 * t[c] + i];
    }
    free(across);
    mesh_free(whole);
    return tissue_alloc(mesh);
}

/* The eigenvalues of K at rest that vanish: each loose part has three motions,
 * or one that turns it about the vertex that is held. */
static void parts_are_loose_that_move_without_a_force(void)
{
    enum { NONE, PAIRS, ONE, KINDS };
    for (int round = 0; round < 8 * KINDS; round++) {
        struct tissue s = random_cuts(0.2 + 0.1 * (round % 8));
        const struct mesh *mesh = s.mesh;
        const int kind = round % KINDS;
        double value[108];
        int loose, motions = 0;
        for (int e = 0; e < 18 && kind == PAIRS; e += 5)
            for (int k = 0; k < 2; k++) s.held[mesh->triangle[3 * e + k]] = 1;
        if (kind == ONE) s.held[mesh->triangle[round]] = 1;
        const int n = oracle_spectrum(mesh->n_vertex, s.held, mesh->X, 18,
                                      mesh->triangle, 384.6, 576.9, value);
        for (int i = 0; i < n; i++)
            motions += fabs(value[i]) < 1e-10 * value[n - 1];
        const int parts = tissue_parts(&s, &loose);
        ck_assert_int_eq(motions, 3 * loose - 2 * (kind == ONE));
        ck_assert(loose == parts || kind == PAIRS);
        tissue_free(s);
    }
}

static void lips_open(void)
{
    struct tissue s = two_squares();
    for (int r = 0; r < 16; r++) s.u[r] = 100.0 * r;
    s.u[6] = 1.0, s.u[7] = 2.0, s.u[8] = -2.0, s.u[9] = 6.0;
    close_to(tissue_opening(s.mesh, s.u), 5.0, 1e-15);
    tissue_free(s);
}

/* A square of 2 x 2: what is held, pulled, nearest and marked. */
static void a_square_is_held_pulled_and_marked(void)
{
    static const int chain[4] = {7, 4, 0, 3};
    static const double x[2] = {0.6, -0.7};
    struct tissue s = tissue_alloc(mesh_square(2));
    const struct tissue_whole w = tissue_hold(&s, 2.385);
    int cut[24] = {0};
    cut[20] = 7; /* 4-5 */
    for (int a = 0; a < 9; a++) ck_assert_int_eq(s.held[a], a % 3 == 0);
    ck_assert_int_eq(tissue_nearest(w.mesh, x), 2);
    tissue_mark(w.mesh, 4, chain, cut);
    int pulled = 0;
    for (int c = 0; c < 24; c++) {
        const int *t = &w.mesh->triangle[c / 3 * 3];
        const int a = t[(c + 1) % 3], b = t[(c + 2) % 3];
        const int right = a % 3 == 2 && b % 3 == 2;
        const int pair = 10 * (a < b ? a : b) + (a < b ? b : a);
        ck_assert_int_eq(w.pulled[c], right);
        ck_assert_int_eq(cut[c], c == 20 ? 7
                                 : pair == 47 || pair == 4 || pair == 3);
        ck_assert(w.across[c] == c / 3 || !right);
        pulled += right;
    }
    ck_assert_int_eq(pulled, 2);
    close_to(w.traction[0], 2.385, 1e-15);
    close_to(w.traction[1], 0.0, 1e-15);
    free(w.across);
    free(w.pulled);
    tissue_free(s);
}

/* The strip: 50 x 15 cells of one size, held below and pulled nowhere, and
 * neighbours have near numbers. */
static void a_strip_lies_on_bone(void)
{
    struct tissue s = tissue_strip();
    const struct tissue_whole w = tissue_on_bone(&s);
    int bone = 0;
    ck_assert_int_eq(w.mesh->n_vertex, 51 * 16);
    ck_assert_int_eq(w.mesh->n_triangle, 2 * 50 * 15);
    for (int a = 0; a < w.mesh->n_vertex; a++) {
        const double *X = &w.mesh->X[2 * a];
        ck_assert(fabs(X[0]) < 1.58114 && fabs(X[1]) < 0.474342);
        ck_assert_int_eq(s.held[a], X[1] < -0.4743);
        bone += s.held[a];
    }
    ck_assert_int_eq(bone, 51);
    for (int c = 0; c < 3 * w.mesh->n_triangle; c++) {
        const int *t = &w.mesh->triangle[c / 3 * 3];
        double g[6];
        close_to(mesh_gradients(w.mesh, c / 3, g), 0.002, 1e-12);
        ck_assert_int_le(abs(t[c % 3] - t[(c + 1) % 3]), 17);
        ck_assert(!w.pulled[c] && w.across[c] >= 0);
    }
    close_to(w.rho, 1.0, 1e-15);
    free(w.across);
    free(w.pulled);
    tissue_free(s);
}

/* K of the cut body times (y and copies y + d), its rows added up, is K of the
 * whole body and the border times (y, d). */
static void a_border_is_the_cut_body(void)
{
    static const int across_it[3] = {1, 4, 7}; /* the middle column */
    struct tissue s = tissue_alloc(mesh_square(2));
    struct mesh *cut = mesh_square(3); /* room */
    double X[24], y[12] = {0}, d[6], q[12] = {0}, p[6] = {0};
    int held[2][12] = {{0}};
    cut->n = 11, cut->rows = 0;
    cut->n_vertex = 12;
    cut->n_triangle = 8;
    for (int c = 0; c < 24; c++) {
        const int a = s.mesh->triangle[c], right = c / 3 % 4 >= 2;
        cut->triangle[c] = a;
        for (int k = 0; k < 3; k++)
            if (a == across_it[k] && right) cut->triangle[c] = 9 + k;
        for (int i = 0; i < 2; i++)
            X[2 * cut->triangle[c] + i] = s.mesh->X[2 * a + i];
    }
    for (int r = 0; r < 24; r++) cut->X[r] = X[r];
    for (int a = 0; a < 9; a++) held[0][a] = held[1][a] = a % 3 == 0;
    struct body *body[2] = {
        body_alloc(s.mesh, material_notes(LOG), 1.0, LUMPED, held[0]),
        body_alloc(cut, material_notes(LOG), 1.0, LUMPED, held[1])};
    for (int m = 0; m < 2; m++) {
        double u[24] = {0}, none[24];
        ck_assert(body_assemble(body[m], at_rest(NULL), u, EXACT, none) == OK);
    }
    const struct tissue_border b = tissue_border_alloc(body);
    const int n = body[0]->n_equation, N = body[1]->n_equation, k = N - n;
    ck_assert_int_eq(n, 12);
    ck_assert_int_eq(k, 6);
    double x[18], f[18];
    for (int i = 0; i < n; i++) y[i] = 0.31 * i - 0.02 * i * i;
    for (int j = 0; j < k; j++) d[j] = 1.7 - 0.63 * j;
    for (int i = 0; i < N; i++)
        x[i] = y[b.old[i]] + (b.jump[i] < 0 ? 0.0 : d[b.jump[i]]);
    matrix_multiply(body[1]->K, x, f);
    for (int i = 0; i < N; i++) {
        q[b.old[i]] += f[i];
        if (b.jump[i] >= 0) p[b.jump[i]] += f[i];
    }
    for (int i = 0; i < n; i++) {
        double sum = 0.0;
        for (int j = 0; j < n; j++) sum += matrix_get(body[0]->K, i, j) * y[j];
        for (int j = 0; j < k; j++) sum += b.B[n * j + i] * d[j];
        close_to(sum, q[i], 1e-10);
    }
    for (int j = 0; j < k; j++) {
        double sum = 0.0;
        for (int i = 0; i < n; i++) sum += b.B[n * j + i] * y[i];
        for (int i = 0; i < k; i++) sum += matrix_get(b.C, j, i) * d[i];
        close_to(sum, p[j], 1e-10);
    }
    tissue_border_free(b);
    body_free(body[0]);
    body_free(body[1]);
    mesh_free(cut);
    tissue_free(s);
}

UNIT_MAIN("tissue",
    LAW(parts_are_loose_that_move_without_a_force),
    LAW(lips_open),
    LAW(a_square_is_held_pulled_and_marked),
    LAW(a_strip_lies_on_bone),
    LAW(a_border_is_the_cut_body))
