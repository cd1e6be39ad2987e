/*
 * 26_cut.c - what a path, an opened mesh and a carried state satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *   26a mesh, blade, first, last: path_is_a_chain_of_edges,
 *       path_is_the_cheapest (sizes, leaning meshes, blades; ends that are one)
 *   26b whole, cut: corners_agree_as_their_fans_do (sizes, random marks, none,
 *       all), cuts_have_the_counts_known_by_hand
 *   26c whole, before, after: what_a_vertex_has_is_carried (a whole body, one
 *       that is cut already), masses_and_forces_are_shared_out (density,
 *       traction, which edges); after holds NaN before, guarded
 *   26d L, B, C, y, d: jumps_solve_the_bordered_system (orders, numbers, band
 *       and dense), a_singular_border_is_not_spd
 */
#include "program.h"

#include "judge.h"

#include "../oracle/26_cut.h"

#include <string.h>

#define ROUND_OFF 1e-13 /* of sums of some hundred numbers */

static unsigned seed_of = 1;
static double chance(void) /* in (0, 1), a linear congruence */
{
    seed_of = seed_of * 1103515245u + 12345u;
    return ((seed_of >> 16) % 9973 + 0.5) / 9973.0;
}

/* A square whose vertices have moved: cells of all shapes, of two unequal
 * triangles. */
static struct mesh *leaning(int n)
{
    struct mesh *mesh = mesh_square(n);
    for (int a = 0; a < mesh->n_vertex; a++) {
        double *X = &mesh->X[2 * a];
        const double x = X[0], y = X[1];
        X[0] += 0.11 * sin(2.3 * y + 0.7) + 0.05 * sin(3.1 * x) + 0.06 * x * y;
        X[1] += 0.09 * sin(2.9 * x - 0.4) - 0.04 * cos(2.7 * y);
    }
    return mesh;
}

/* Which vertices the edge c has. */
static void ends_of(const int t[], int c, int end[2])
{
    end[0] = t[c / 3 * 3 + (c + 1) % 3];
    end[1] = t[c / 3 * 3 + (c + 2) % 3];
}

/* ---- 26a ----------------------------------------------------------------- */

enum { MOST_VERTICES = 64 };

static const double knives[][4] = {
    {0.03, 1.1, -0.04, 0.05}, {-0.9, -0.73, 0.85, 0.61},
    {-1.3, 0.62, 1.2, -0.81}, {0.41, -1.2, 0.37, 1.3},
    {0.2, 0.1, 0.23, 0.12},   {-0.7, 0.9, -0.65, -0.95}};
static const int sizes[] = {1, 2, 5, 7};

/* By hand: the nearest point of the blade is an end, or the foot. */
static double away(const double blade[4], double x, double y)
{
    const double dx = blade[2] - blade[0], dy = blade[3] - blade[1];
    const double length = hypot(dx, dy);
    const double along = ((x - blade[0]) * dx + (y - blade[1]) * dy) / length;
    if (along <= 0.0) return hypot(x - blade[0], y - blade[1]);
    if (along >= length) return hypot(x - blade[2], y - blade[3]);
    return fabs((x - blade[0]) * dy - (y - blade[1]) * dx) / length;
}

static double price(const struct mesh *mesh, const double blade[4], int a,
                    int b)
{
    const double *A = &mesh->X[2 * a], *B = &mesh->X[2 * b];
    return hypot(A[0] - B[0], A[1] - B[1]) +
           away(blade, 0.5 * (A[0] + B[0]), 0.5 * (A[1] + B[1]));
}

static int is_edge(const struct mesh *mesh, int a, int b)
{
    for (int c = 0; c < 3 * mesh->n_triangle; c++) {
        int end[2];
        ends_of(mesh->triangle, c, end);
        if ((end[0] == a && end[1] == b) || (end[0] == b && end[1] == a))
            return 1;
    }
    return 0;
}

static void expect_chain(const struct mesh *mesh, const double blade[4],
                         int first, int last)
{
    int none[MOST_VERTICES], seen[MOST_VERTICES] = {0};
    for (int a = 0; a < mesh->n_vertex; a++) none[a] = -1;
    int *got = guarded_indices(mesh->n_vertex, none);
    const int length = path(mesh, blade, first, last, got);
    expect(1 <= length && length <= mesh->n_vertex,
           "the path from vertex %d to %d has %d vertices, of %d", first, last,
           length, mesh->n_vertex);
    expect(got[0] == first && got[length - 1] == last,
           "the path from vertex %d to %d begins with %d and ends with %d",
           first, last, got[0], got[length - 1]);
    for (int k = 0; k < length; k++) {
        expect(0 <= got[k] && got[k] < mesh->n_vertex && !seen[got[k]],
               "the path from %d to %d is at vertex %d twice, or there is no "
               "such vertex", first, last, got[k]);
        seen[got[k]] = 1;
        expect(k == 0 || is_edge(mesh, got[k - 1], got[k]),
               "the path from %d to %d goes from vertex %d to %d, which no "
               "edge joins", first, last, got[k - 1], got[k]);
    }
}

static void path_is_a_chain_of_edges(void)
{
    for (int s = 0; s < COUNT(sizes); s++) {
        struct mesh *mesh = leaning(sizes[s]);
        for (int k = 0; k < COUNT(knives); k++) {
            expect_chain(mesh, knives[k], 0, mesh->n_vertex - 1);
            expect_chain(mesh, knives[k], mesh->n_vertex - 1, 1);
            expect_chain(mesh, knives[k], 2, 2);
        }
        mesh_free(mesh);
    }
}

/* By the method of Floyd and Warshall: the costs of all paths. */
static void path_is_the_cheapest(void)
{
    static double least[MOST_VERTICES][MOST_VERTICES];
    for (int s = 0; s < COUNT(sizes); s++)
        for (int k = 0; k < COUNT(knives); k++) {
            struct mesh *mesh = leaning(sizes[s]);
            const int N = mesh->n_vertex;
            for (int a = 0; a < N; a++)
                for (int b = 0; b < N; b++)
                    least[a][b] = a == b                 ? 0.0
                                  : is_edge(mesh, a, b)
                                      ? price(mesh, knives[k], a, b)
                                      : 1e9;
            for (int m = 0; m < N; m++)
                for (int a = 0; a < N; a++)
                    for (int b = 0; b < N; b++)
                        least[a][b] =
                            fmin(least[a][b], least[a][m] + least[m][b]);
            for (int first = 0; first < N; first += 3)
                for (int last = 1; last < N; last += 5) {
                    int got[MOST_VERTICES];
                    double sum = 0.0;
                    const int length = path(mesh, knives[k], first, last, got);
                    for (int m = 1; m < length; m++)
                        sum += price(mesh, knives[k], got[m - 1], got[m]);
                    expect_close(sum, least[first][last], ROUND_OFF, 10.0,
                                 "n = %d, a blade from (%g, %g) to (%g, %g): "
                                 "cost of the path from vertex %d to %d",
                                 mesh->n, knives[k][0], knives[k][1],
                                 knives[k][2], knives[k][3], first, last);
                }
            mesh_free(mesh);
        }
}

/* ---- 26b ----------------------------------------------------------------- */

static struct tissue_whole whole_mesh(struct mesh *mesh)
{
    const struct tissue_whole w = {mesh, mesh_across(mesh),
                            allocate(3 * (size_t)mesh->n_triangle, sizeof(int)),
                            {0.613, -0.385}, 2.385};
    return w;
}

static void whole_free(struct tissue_whole w)
{
    free(w.across);
    free(w.pulled);
    mesh_free((struct mesh *)w.mesh);
}

/* Mark this part of the edges on both sides, by any number but 0. */
static void random_marks(const struct tissue_whole *w, double part, int marks[])
{
    for (int c = 0; c < 3 * w->mesh->n_triangle; c++) marks[c] = -1;
    for (int c = 0; c < 3 * w->mesh->n_triangle; c++) {
        int end[2], other[2];
        if (marks[c] >= 0) continue;
        marks[c] = chance() < part ? 1 + c % 3 : 0;
        ends_of(w->mesh->triangle, c, end);
        for (int d = 3 * w->across[c]; d < 3 * w->across[c] + 3; d++) {
            ends_of(w->mesh->triangle, d, other);
            if (other[0] == end[1] && other[1] == end[0])
                marks[d] = marks[c] ? 7 : 0;
        }
    }
}

/* Whether corner d can be reached from corner c of the same vertex: around it
 * both ways, from triangle to triangle.  Corner c has the vertex; the edges of
 * its triangle at the vertex are the other two. */
static int same_fan(const struct tissue_whole *w, const int marks[], int c,
                    int d)
{
    const int *t = w->mesh->triangle;
    for (int way = 1; way <= 2; way++)
        for (int at = c, turns = 0; turns < 9; turns++) {
            if (at == d) return 1;
            const int edge = at / 3 * 3 + (at + way) % 3;
            if (marks[edge] || w->across[edge] == at / 3) break;
            for (int k = 0; k < 3; k++)
                if (t[3 * w->across[edge] + k] == t[c]) {
                    at = 3 * w->across[edge] + k;
                    break;
                }
        }
    return 0;
}

static void expect_fans(const struct tissue_whole *w, const int marks[],
                        const char *what)
{
    const int corners = 3 * w->mesh->n_triangle, *t = w->mesh->triangle;
    int *none = allocate((size_t)corners, sizeof *none);
    int *old = allocate((size_t)corners, sizeof *old);
    for (int c = 0; c < corners; c++) none[c] = old[c] = -1;
    int *got = guarded_indices(corners, none);
    const int n_new = open_cut(w, guarded_indices(corners, marks), got);
    int most = 0;
    for (int c = 0; c < corners; c++) {
        expect(0 <= got[c] && got[c] < n_new && got[c] < corners,
               "%s: corner %d has vertex %d, of %d", what, c, got[c], n_new);
        expect(old[got[c]] < 0 || old[got[c]] == t[c],
               "%s: the new vertex %d was %d in one corner and %d in another",
               what, got[c], old[got[c]], t[c]);
        old[got[c]] = t[c];
        most = got[c] > most ? got[c] : most;
        for (int d = 0; d < c; d++)
            if (t[d] == t[c])
                expect((got[d] == got[c]) == same_fan(w, marks, c, d),
                       "%s: the triangles %d and %d at vertex %d are in %s, "
                       "and have got %s", what, d / 3, c / 3, t[c],
                       same_fan(w, marks, c, d) ? "one fan" : "two fans",
                       got[d] == got[c] ? "one vertex" : "two vertices");
    }
    expect(most == n_new - 1, "%s: the largest number is %d, and %d vertices "
           "were returned", what, most, n_new);
    for (int b = 0; b < n_new; b++) {
        expect(old[b] >= 0, "%s: no corner has the new vertex %d", what, b);
        expect(b == 0 || old[b - 1] <= old[b],
               "%s: the new vertex %d was %d, and %d was %d: the copies of a "
               "vertex belong beside it", what, b - 1, old[b - 1], b, old[b]);
    }
    free(old);
    free(none);
}

static void an_edge_alone_opens_nothing(void)
{
    struct tissue_whole w = whole_mesh(leaning(4));
    const int corners = 3 * w.mesh->n_triangle;
    for (int c = 0; c < corners; c++) {
        int end[2], other[2], marks[96] = {0};
        ends_of(w.mesh->triangle, c, end);
        int inside = 1; /* both ends */
        for (int d = 0; d < corners; d++) {
            ends_of(w.mesh->triangle, d, other);
            if ((other[0] == end[0] && other[1] == end[1]) ||
                (other[0] == end[1] && other[1] == end[0])) marks[d] = 1;
            if (w.across[d] == d / 3)
                inside &= other[0] != end[0] && other[0] != end[1] &&
                          other[1] != end[0] && other[1] != end[1];
        }
        if (!inside && w.across[c] != c / 3) continue;
        int got[96];
        const int n_new = open_cut(&w, marks, got);
        expect(n_new == w.mesh->n_vertex, "only the edge from %d to %d is "
               "marked, %s: there are %d vertices, not %d", end[0], end[1],
               inside ? "both of whose ends are tips" : "of the boundary",
               n_new, w.mesh->n_vertex);
    }
    whole_free(w);
}

static void corners_agree_as_their_fans_do(void)
{
    static const double parts[] = {0.0, 0.1, 0.3, 0.5, 0.8, 1.0};
    for (int s = 0; s < COUNT(sizes); s++) {
        struct tissue_whole w = whole_mesh(leaning(sizes[s]));
        int marks[3 * 98];
        for (int k = 0; k < 5 * COUNT(parts); k++) {
            random_marks(&w, parts[k / 5], marks);
            expect_fans(&w, marks, k < 5 ? "nothing is marked"
                                   : k >= 25 ? "all edges are marked"
                                             : "random edges are marked");
        }
        whole_free(w);
    }
}

static struct oracle_counts counts_of(int n_triangle, const int t[],
                                      int n_vertex)
{
    struct oracle_counts counts = {n_vertex, 0, 0, 0};
    int *part = allocate((size_t)n_triangle, sizeof *part);
    for (int e = 0; e < n_triangle; e++) part[e] = e;
    for (int c = 0; c < 3 * n_triangle; c++) {
        int end[2], other[2], alone = 1;
        ends_of(t, c, end);
        for (int d = 0; d < 3 * n_triangle; d++) {
            ends_of(t, d, other);
            if (other[0] != end[1] || other[1] != end[0]) continue;
            alone = 0;
            const int from = part[d / 3], to = part[c / 3];
            for (int e = 0; e < n_triangle; e++)
                if (part[e] == from) part[e] = to;
        }
        counts.boundary += alone;
    }
    for (int e = 0; e < n_triangle; e++) counts.parts += part[e] == e;
    counts.euler = n_vertex - (3 * n_triangle + counts.boundary) / 2 +
                   n_triangle;
    free(part);
    return counts;
}

static void marks_drawn(const struct tissue_whole *w, int k, int marks[])
{
    const int width = w->mesh->n + 1;
    memset(marks, 0, 3 * (size_t)w->mesh->n_triangle * sizeof *marks);
    for (int s = 0; s < 2; s++)
        for (int m = 1; m < oracle_cuts[k].length[s]; m++) {
            const int *A = oracle_cuts[k].at[s][m - 1];
            const int *B = oracle_cuts[k].at[s][m];
            const int a = A[1] * width + A[0], b = B[1] * width + B[0];
            for (int c = 0; c < 3 * w->mesh->n_triangle; c++) {
                int end[2];
                ends_of(w->mesh->triangle, c, end);
                if ((end[0] == a && end[1] == b) ||
                    (end[0] == b && end[1] == a)) marks[c] = 1;
            }
        }
}

static void cuts_have_the_counts_known_by_hand(void)
{
    struct tissue_whole w = whole_mesh(leaning(6));
    for (int k = 0; k < COUNT(oracle_cuts); k++) {
        int marks[216], got[216];
        marks_drawn(&w, k, marks);
        const int n_new = open_cut(&w, marks, got);
        const struct oracle_counts c = counts_of(72, got, n_new);
        const struct oracle_counts d = oracle_cuts[k].added;
        const char *name = oracle_cuts[k].name;
        expect(c.vertices == 49 + d.vertices,
               "%s: %d vertices are new, not %d", name, n_new - 49, d.vertices);
        expect(c.boundary == 24 + d.boundary,
               "%s: %d edges of the boundary, not %d", name, c.boundary,
               24 + d.boundary);
        expect(c.parts == 1 + d.parts, "%s: %d parts, not %d", name, c.parts,
               1 + d.parts);
        expect(c.euler == 1 + d.euler, "%s: Euler's number is %d, not %d", name,
               c.euler, 1 + d.euler);
    }
    whole_free(w);
}

/* ---- 26c ----------------------------------------------------------------- */

/* A mesh with these corners and an array of each kind: NaN. */
static struct tissue empty(int n_triangle, const int t[], int n_vertex)
{
    struct mesh *mesh = allocate(1, sizeof *mesh);
    int *held = allocate((size_t)n_vertex, sizeof *held);
    for (int a = 0; a < n_vertex; a++) held[a] = -7;
    *mesh = (struct mesh){.n = n_vertex - 1, .n_vertex = n_vertex,
                          .n_triangle = n_triangle,
                          .X = guarded_alloc(2 * n_vertex),
                          .triangle = guarded_indices(3 * n_triangle, t)};
    const struct tissue s = {
        mesh, guarded_indices(n_vertex, held), guarded_alloc(2 * n_vertex),
        guarded_alloc(2 * n_vertex), guarded_alloc(n_vertex),
        guarded_alloc(2 * n_vertex)};
    free(held);
    return s;
}

/* Corners of the fans, by same_fan(); the copies of a vertex are the last in
 * the order, which carry() takes as it is. */
static int fans_of(const struct tissue_whole *w, const int marks[], int t[])
{
    const int corners = 3 * w->mesh->n_triangle;
    int n_vertex = 0;
    for (int c = corners - 1; c >= 0; c--) {
        t[c] = -1;
        for (int d = corners - 1; d > c; d--)
            if (w->mesh->triangle[c] == w->mesh->triangle[d] &&
                same_fan(w, marks, c, d)) t[c] = t[d];
        if (t[c] < 0) t[c] = n_vertex++;
    }
    return n_vertex;
}

/* A body before the cut: of any state, opened along the marks. */
static struct tissue any_state(const struct tissue_whole *w, const int marks[])
{
    int t[3 * 98];
    const int n = fans_of(w, marks, t);
    struct tissue s = empty(w->mesh->n_triangle, t, n);
    for (int c = 0; c < 3 * w->mesh->n_triangle; c++)
        for (int i = 0; i < 2; i++)
            s.mesh->X[2 * t[c] + i] = w->mesh->X[2 * w->mesh->triangle[c] + i];
    for (int a = 0; a < n; a++) {
        s.held[a] = chance() < 0.4;
        s.mass[a] = NAN;
        for (int i = 0; i < 2; i++) {
            s.u[2 * a + i] = 0.05 * (chance() - 0.5);
            s.v[2 * a + i] = chance() - 0.3;
        }
    }
    return s;
}

/* A body with random marks, then with more of them; which edges are pulled. */
struct case_of {
    struct tissue_whole w;
    struct tissue before, after;
};

static struct case_of random_case(int k)
{
    struct tissue_whole w = whole_mesh(leaning(sizes[k % COUNT(sizes)]));
    int marks[3 * 98], more[3 * 98], t[3 * 98];
    random_marks(&w, k % 3 * 0.2, marks);
    random_marks(&w, k % 4 * 0.25, more);
    w.rho = 0.3 + chance();
    for (int i = 0; i < 2; i++) w.traction[i] = chance() - 0.5;
    for (int c = 0; c < 3 * w.mesh->n_triangle; c++) {
        more[c] |= marks[c];
        w.pulled[c] = w.across[c] == c / 3 && chance() < 0.5;
    }
    struct case_of s = {w, any_state(&w, marks), {0}};
    const int n = fans_of(&w, more, t);
    s.after = empty(w.mesh->n_triangle, t, n);
    carry(&s.w, &s.before, &s.after);
    return s;
}

static void what_a_vertex_has_is_carried(void)
{
    for (int k = 0; k < 24; k++) {
        const struct case_of s = random_case(k);
        for (int c = 0; c < 3 * s.w.mesh->n_triangle; c++) {
            const int a = s.before.mesh->triangle[c];
            const int b = s.after.mesh->triangle[c];
            expect(s.before.held[a] == (s.after.held[b] != 0), "vertex %d, "
                   "%s, has become %d: that has got held = %d", a,
                   s.before.held[a] ? "which was held" : "which was free", b,
                   s.after.held[b]);
            for (int i = 0; i < 2; i++) {
                expect_close(s.after.mesh->X[2 * b + i],
                             s.before.mesh->X[2 * a + i], 0.0, 1.0,
                             "X of vertex %d, which was %d", b, a);
                expect_close(s.after.u[2 * b + i], s.before.u[2 * a + i], 0.0,
                             1.0, "u of vertex %d, which was %d", b, a);
                expect_close(s.after.v[2 * b + i], s.before.v[2 * a + i], 0.0,
                             1.0, "v of vertex %d, which was %d", b, a);
            }
        }
    }
}

static void masses_and_forces_are_shared_out(void)
{
    for (int k = 0; k < 24; k++) {
        const struct case_of s = random_case(k);
        const int *t = s.after.mesh->triangle, n = s.after.mesh->n_vertex;
        const double *X = s.w.mesh->X;
        double *mass = allocate((size_t)n, sizeof *mass);
        double *f = allocate(2 * (size_t)n, sizeof *f);
        for (int c = 0; c < 3 * s.w.mesh->n_triangle; c++) {
            const int *old = &s.w.mesh->triangle[c / 3 * 3];
            const double *A = &X[2 * old[0]], *B = &X[2 * old[1]];
            const double *C = &X[2 * old[2]];
            mass[t[c]] += s.w.rho / 6.0 * ((B[0] - A[0]) * (C[1] - A[1]) -
                                           (B[1] - A[1]) * (C[0] - A[0]));
            if (!s.w.pulled[c]) continue;
            int end[2], was[2];
            ends_of(t, c, end);
            ends_of(s.w.mesh->triangle, c, was);
            for (int m = 0; m < 2; m++)
                for (int i = 0; i < 2; i++)
                    f[2 * end[m] + i] +=
                        0.5 * s.w.traction[i] *
                        hypot(X[2 * was[0]] - X[2 * was[1]],
                              X[2 * was[0] + 1] - X[2 * was[1] + 1]);
        }
        for (int a = 0; a < n; a++) {
            expect_close(s.after.mass[a], mass[a], ROUND_OFF, s.w.rho,
                         "the mass of vertex %d of %d", a, n);
            for (int i = 0; i < 2; i++)
                expect_close(s.after.f[2 * a + i], f[2 * a + i], ROUND_OFF, 1.0,
                             "f of vertex %d, component %d", a, i);
        }
        free(f);
        free(mass);
    }
}

/* ---- the two together ---------------------------------------------------- */

/* The whole body and the cut one: the vertices of the whole are those of the
 * mesh, old[] has them for those of the cut.  exact: K has whole numbers. */
struct two_bodies {
    struct tissue_whole w;
    struct tissue s[2];
    struct body *body[2];
    int old[216];
};

static struct two_bodies bodies_drawn(int k, int exact)
{
    struct mesh *mesh = leaning(6);
    for (int r = 0; exact && r < 98; r++)
        mesh->X[r] = r % 2 ? r / 14 : r / 2 % 7;
    struct two_bodies two = {.w = whole_mesh(mesh)};
    struct material rubber = material_notes(CUBIC);
    int marks[216], t[216], none[216] = {0};
    marks_drawn(&two.w, k, marks);
    two.s[0] = any_state(&two.w, none);
    memcpy(two.s[0].mesh->triangle, mesh->triangle, sizeof none);
    for (int a = 0; a < 49; a++) {
        two.s[0].held[a] = a % 7 == 0;
        for (int i = 0; i < 2; i++)
            two.s[0].mesh->X[2 * a + i] = mesh->X[2 * a + i];
    }
    if (exact) rubber.mu = 384.0, rubber.lambda = 576.0;
    if (exact) memset(two.s[0].u, 0, 98 * sizeof(double));
    two.s[1] = empty(72, t, open_cut(&two.w, marks, t));
    memcpy(two.s[1].mesh->triangle, t, sizeof t);
    carry(&two.w, &two.s[0], &two.s[1]);
    for (int c = 0; c < 216; c++) two.old[t[c]] = mesh->triangle[c];
    for (int m = 0; m < 2; m++)
        two.body[m] = body_alloc(two.s[m].mesh, rubber, two.w.rho, LUMPED,
                                 two.s[m].held);
    return two;
}

/* K of the whole body is that of the cut one with its copies added up, in
 * another order: to round-off, and with whole numbers to the last digit. */
static void glued_again_K_is_the_old_one(void)
{
    for (int run = 0; run < 2 * COUNT(oracle_cuts); run++) {
        const int exact = run % 2, k = run / 2;
        const struct two_bodies two = bodies_drawn(k, exact);
        struct matrix *K[2];
        for (int m = 0; m < 2; m++) {
            K[m] = body_matrix(two.body[m]);
            expect(body_stiffness(two.body[m], two.s[m].u, EXACT, K[m]) == OK,
                   "%s: K is not finite", oracle_cuts[k].name);
        }
        struct matrix *glued = matrix_alloc(DENSE, K[0]->n, 0);
        const int *whole_one = two.body[0]->equation;
        const int *cut_one = two.body[1]->equation;
        const int rows = 2 * two.s[1].mesh->n_vertex;
        for (int p = 0; p < rows; p++)
            for (int q = 0; q < rows; q++)
                if (cut_one[p] >= 0 && cut_one[q] >= 0)
                    matrix_add(glued, whole_one[2 * two.old[p / 2] + p % 2],
                               whole_one[2 * two.old[q / 2] + q % 2],
                               matrix_get(K[1], cut_one[p], cut_one[q]));
        for (int i = 0; i < K[0]->n; i++)
            for (int j = 0; j < K[0]->n; j++)
                expect_close(matrix_get(glued, i, j), matrix_get(K[0], i, j),
                             exact ? 0.0 : ROUND_OFF, matrix_max_diagonal(K[0]),
                             "%s: K[%d][%d] glued", oracle_cuts[k].name, i,
                             j);
        matrix_free(glued);
        for (int m = 0; m < 2; m++) {
            matrix_free(K[m]);
            body_free(two.body[m]);
        }
        whole_free(two.w);
    }
}

/* The eigenvalues of K at rest are the oracle's: as many vanish as the loose
 * parts have motions, and no more. */
static void a_loose_part_has_three_motions(void)
{
    for (int k = 0; k < COUNT(oracle_cuts); k++) {
        const struct two_bodies two = bodies_drawn(k, 0);
        const struct mesh *mesh = two.s[1].mesh;
        const struct material rubber = two.body[1]->material;
        const char *name = oracle_cuts[k].name;
        const int motions = oracle_cuts[k].motions;
        struct matrix *K = body_matrix(two.body[1]);
        double got[2 * 216], want[2 * 216], zero[2 * 216] = {0.0};
        const int n = oracle_spectrum(
            mesh->n_vertex, two.s[1].held, mesh->X, mesh->n_triangle,
            mesh->triangle, rubber.mu, rubber.lambda, want);
        expect(n == K->n, "%s: %d unknowns, not %d", name, K->n, n);
        expect(body_stiffness(two.body[1], zero, EXACT, K) == OK &&
                   matrix_eigenvalues(K, got) == OK,
               "%s: K is not finite", name);
        for (int i = 0; i < n; i++) {
            const double part = want[i] / want[n - 1];
            expect(i < motions ? fabs(part) < 1e-12 : part > 1e-5,
                   "%s: K has not %d motions without a force: eigenvalue %d is "
                   "%g of the largest", name, motions, i + 1, part);
            expect_close(got[i], want[i], ROUND_OFF, want[n - 1],
                         "%s: eigenvalue %d of K", name, i + 1);
        }
        matrix_free(K);
        for (int m = 0; m < 2; m++) body_free(two.body[m]);
        whole_free(two.w);
    }
}

/* f.u / 2 at rest, linear, of a strip of width 1 and length 3, held below and
 * pulled upwards by 1 N/m, with a cut of m edges halfway up its left side. */
static double released(int n, int m)
{
    struct tissue_whole w = whole_mesh(mesh_rectangle(n, 3 * n, 0.5, 1.5));
    const struct mesh *mesh = w.mesh;
    const int corners = 3 * mesh->n_triangle;
    int *marks = allocate((size_t)corners, sizeof *marks);
    int *t = allocate((size_t)corners, sizeof *t);
    struct tissue s[2];
    double energy = 0.0;
    w.traction[0] = 0.0, w.traction[1] = 1.0;
    for (int c = 0; c < corners; c++) {
        int end[2], in_row = 1;
        ends_of(mesh->triangle, c, end);
        w.pulled[c] = 1;
        for (int k = 0; k < 2; k++) {
            const double *X = &mesh->X[2 * end[k]];
            w.pulled[c] &= X[1] > 1.5 - 1e-9;
            in_row &= fabs(X[1]) < 1e-9 && X[0] < (m + 0.1) / n - 0.5;
        }
        marks[c] = in_row;
    }
    s[0] = empty(mesh->n_triangle, mesh->triangle, mesh->n_vertex);
    for (int a = 0; a < mesh->n_vertex; a++) {
        s[0].held[a] = mesh->X[2 * a + 1] < 1e-9 - 1.5;
        for (int i = 0; i < 2; i++) {
            s[0].mesh->X[2 * a + i] = mesh->X[2 * a + i];
            s[0].u[2 * a + i] = s[0].v[2 * a + i] = 0.0;
        }
    }
    const int n_new = open_cut(&w, marks, t);
    s[1] = empty(mesh->n_triangle, t, n_new);
    carry(&w, &s[0], &s[1]);
    struct body *body = body_alloc(s[1].mesh, material_notes(CUBIC), 0.0,
                                   LUMPED, s[1].held);
    double *q = allocate(2 * (size_t)n_new, sizeof *q);
    for (int i = 0; i < 2 * n_new; i++) q[i] = -s[1].f[i];
    expect(body_stiffness(body, s[1].u, EXACT, body->K) == OK &&
               body_increment(body, body->K, q, s[1].u) == OK,
           "the strip with a cut of %d of %d edges has no rest", m, n);
    for (int i = 0; i < 2 * n_new; i++) energy -= 0.5 * q[i] * s[1].u[i];
    body_free(body);
    whole_free(w);
    free(q);
    free(t);
    free(marks);
    return energy;
}

/* F of the energy that a cut longer by an edge sets free over one shorter.  The
 * error has order 1, so both meshes together are better: 2.4 per cent at most,
 * and 1 with twice as many squares (figures/26_cut/open.c). */
static void a_cut_concentrates_the_stress_as_known(void)
{
    for (int k = 0; oracle_edge_crack[k].r < 0.55; k++) {
        const double r = oracle_edge_crack[k].r;
        double F[2];
        for (int fine = 0; fine < 2; fine++) {
            const int n = fine ? 20 : 10, m = (int)round(r * n);
            const double G =
                0.5 * n * (released(n, m + 1) - released(n, m - 1));
            F[fine] = sqrt(G * 1000.0 / 0.91 / (acos(-1.0) * r));
        }
        expect_close(2.0 * F[1] - F[0], oracle_edge_crack[k].closed, 0.03,
                     oracle_edge_crack[k].closed, "the stress at the tip of a "
                     "cut through %g of a strip, by two meshes", r);
    }
}

/* ---- 26d ----------------------------------------------------------------- */

enum { MOST_UNKNOWNS = 40 };

/* A random matrix of order n + k, (A B; B^T C), positive definite, times x. */
static void jumps_solve_the_bordered_system(void)
{
    for (int round = 0; round < 24; round++) {
        const int n = 3 + round % 7 * 4, k = 1 + round % 5 * 2, N = n + k;
        double H[MOST_UNKNOWNS][MOST_UNKNOWNS], x[MOST_UNKNOWNS];
        double b[MOST_UNKNOWNS] = {0.0}, border[MOST_UNKNOWNS * 10];
        struct matrix *A = matrix_alloc(round % 2 ? DENSE : BANDED, n, n - 1);
        struct matrix *C = matrix_alloc(DENSE, k, 0);
        for (int i = 0; i < N; i++) {
            x[i] = chance() - 0.4;
            for (int j = 0; j <= i; j++)
                H[i][j] = H[j][i] =
                    i == j ? 0.6 * N + chance() : chance() - 0.5;
        }
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                b[i] += H[i][j] * x[j];
                if (i < n && j < n) matrix_add(A, i, j, H[i][j]);
                if (i < n && j >= n) border[n * (j - n) + i] = H[i][j];
                if (i >= n && j >= n) matrix_add(C, i - n, j - n, H[i][j]);
            }
        expect(matrix_factor(A) == OK, "A is positive definite");
        double *y = guarded_copy(n, b), *d = guarded_copy(k, &b[n]);
        const enum status got =
            solve(A, guarded_copy(n * k, border), C, y, d);
        expect(got == OK, "n = %d, k = %d: got %s, want OK", n, k,
               status_name(got));
        for (int i = 0; i < N; i++)
            expect_close(i < n ? y[i] : d[i - n], x[i], ROUND_OFF, 1.0,
                         "n = %d, k = %d: entry %d of (y, d)", n, k, i);
        matrix_free(A);
        matrix_free(C);
    }
}

/* A = 4 I, B of whole numbers: S is what the table says, to the last digit. */
static void a_singular_border_is_not_spd(void)
{
    static const struct {
        double S[2][2];
        enum status status;
        const char *what;
    } cases[] = {{{{4, -2}, {-2, 1}}, NOT_SPD, "singular"},
                 {{{1, 2}, {2, 1}}, NOT_SPD, "indefinite"},
                 {{{-1, 0}, {0, 3}}, NOT_SPD, "indefinite"},
                 {{{4, -2}, {-2, 2}}, OK, "positive definite"}};
    static const double border[6] = {4, 0, -8, 8, 4, 4};
    for (int m = 0; m < COUNT(cases); m++) {
        struct matrix *A = matrix_alloc(BANDED, 3, 1);
        struct matrix *C = matrix_alloc(DENSE, 2, 0);
        double y[3] = {0.3, -0.7, 0.2}, d[2] = {0.1, 0.4};
        for (int i = 0; i < 3; i++) matrix_add(A, i, i, 4.0);
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++) {
                double sum = cases[m].S[i][j];
                for (int r = 0; r < 3; r++)
                    sum += border[3 * i + r] * border[3 * j + r] / 4.0;
                matrix_add(C, i, j, sum);
            }
        expect(matrix_factor(A) == OK, "A is positive definite");
        const enum status got = solve(A, border, C, y, d);
        expect(got == cases[m].status,
               "S = (%g %g; %g %g) is %s: got %s, want %s", cases[m].S[0][0],
               cases[m].S[0][1], cases[m].S[1][0], cases[m].S[1][1],
               cases[m].what, status_name(got), status_name(cases[m].status));
        matrix_free(A);
        matrix_free(C);
    }
}

/* ---- the program --------------------------------------------------------- */

static const char *const strokes[] = {"slit", "inner", "across", "ring",
                                      "cross"};

static const struct output *cut_by(const char *blade, const char *more)
{
    char options[80];
    snprintf(options, sizeof options, "--blade %s %s", blade, more);
    return run(options);
}

/* The rows before and after the cut, at the same t. */
static void nothing_jumps_at_the_instant(void)
{
    static const char *const kept[] = {"mass", "momentum_x", "momentum_y",
                                       "kinetic", "elastic", "load"};
    for (int k = 0; k < COUNT(strokes); k++) {
        const struct output *const r = cut_by(strokes[k], "--n 6 --steps 4");
        expect(cell(r, "steps", "t", 4) == cell(r, "steps", "t", 5),
               "--blade %s: no time has two rows", strokes[k]);
        for (int m = 0; m < COUNT(kept); m++)
            expect_close(cell(r, "steps", kept[m], 5),
                         cell(r, "steps", kept[m], 4), ROUND_OFF, 100.0,
                         "--blade %s: %s after the cut", strokes[k], kept[m]);
        expect_close(cell(r, "steps", "opening", 5), 0.0, ROUND_OFF, 1.0,
                     "--blade %s: opening when it is cut", strokes[k]);
        expect(cell(r, "steps", "opening", -1) > 1e-3,
               "--blade %s: the cut has not opened after four steps",
               strokes[k]);
    }
}

static void a_loose_part_is_named(void)
{
    for (int k = 0; k < COUNT(strokes); k++) {
        const struct output *const r = cut_by(strokes[k], "--steps 3");
        const int is_loose = k == 2 || k == 3;
        expect(cell(r, "mesh", "loose", 1) == is_loose,
               "--blade %s: got %g loose parts, not %d", strokes[k],
               cell(r, "mesh", "loose", 1), is_loose);
        expect(strcmp(word(r, "rest", "status", 1),
                      is_loose ? "NOT_SPD" : "OK") == 0,
               "--blade %s: at rest got %s, want %s", strokes[k],
               word(r, "rest", "status", 1), is_loose ? "NOT_SPD" : "OK");
        expect(row_count(r, "steps") == 8, "--blade %s: the body has not moved "
               "on", strokes[k]);
    }
}

/* The update of the program, whose matrices come from a body. */
static void the_update_is_the_factorisation(void)
{
    for (int k = 0; k < COUNT(strokes); k++) {
        const struct output *const r = cut_by(strokes[k], "--n 6 --steps 1");
        for (int row = 0; row < row_count(r, "update"); row++)
            expect(strcmp(word(r, "update", "agree", row), "yes") == 0,
                   "--blade %s: the increment of `%s` is not that of new "
                   "factors", strokes[k], word(r, "update", "of", row));
    }
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    const struct output *const r = run("--blade ring");
    measured("1", cell(r, "mesh", "vertices", 1) -
                      cell(r, "mesh", "vertices", 0));
    measured("2", cell(r, "mesh", "euler", 1));
}

static const struct claim claims[] = {
    {"path_is_a_chain_of_edges", path_is_a_chain_of_edges, "26a"},
    {"path_is_the_cheapest", path_is_the_cheapest, "26a"},
    {"an_edge_alone_opens_nothing", an_edge_alone_opens_nothing, "26b"},
    {"cuts_have_the_counts_known_by_hand", cuts_have_the_counts_known_by_hand,
     "26b"},
    {"corners_agree_as_their_fans_do", corners_agree_as_their_fans_do, "26b"},
    {"what_a_vertex_has_is_carried", what_a_vertex_has_is_carried, "26c"},
    {"masses_and_forces_are_shared_out", masses_and_forces_are_shared_out,
     "26c"},
    {"glued_again_K_is_the_old_one", glued_again_K_is_the_old_one, "26c"},
    {"a_loose_part_has_three_motions", a_loose_part_has_three_motions, "26c"},
    {"a_cut_concentrates_the_stress_as_known",
     a_cut_concentrates_the_stress_as_known, "26c"},
    {"jumps_solve_the_bordered_system", jumps_solve_the_bordered_system, "26d"},
    {"a_singular_border_is_not_spd", a_singular_border_is_not_spd, "26d"},
    {"nothing_jumps_at_the_instant", nothing_jumps_at_the_instant, NULL},
    {"a_loose_part_is_named", a_loose_part_is_named, NULL},
    {"the_update_is_the_factorisation", the_update_is_the_factorisation,
     "26d"},
};

static const char *const runs[] = {
    "",
    "--blade inner --n 7 --pull 213.7",
    "--blade across --n 9 --steps 4",
    "--blade ring --steps 6 --pull 61.3",
    "--blade cross --n 10 --steps 5",
    "--blade slit --n 5 --pull -23.85",
};

#define STATE "Newton's method to 1e-10, beyond which it is quadratic"
static const struct column_rule rules[] = {
    {"chain", "*", 1e-14, "the mesh", 1},
    {"steps", "t", 1e-14, "m dt", 0},
    {"steps", "body", 0, "a word", 0},
    {"steps", "mass", 1e-13, "a sum", 0},
    {"steps", "momentum_x", 1e-8, STATE ", / dt", 1},
    {"steps", "momentum_y", 1e-8, STATE ", / dt", 1},
    {"steps", "opening", 1e-8, STATE, 1},
    {"steps", "*", 1e-8, STATE, 0},
    {"mesh", "*", 0, "counts", 0},
    {"rest", "status", 0, "a reason", 0},
    {"rest", "reason", 0, "a reason", 0},
    {"rest", "*", 1e-8, STATE, 1},
    {"update", "factor_flops", NOT_COMPARED,
     "the band depends on the order of the copies", 0},
    {"update", "*", 1e-13, "counts", 0},
};

static const struct lesson lesson = {
    "26_cut", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "With --blade ring the loose island has no equation of rest, and yet every "
    "step of the moving body is solved: its mass holds the island where its "
    "stiffness does not.",
    "In slot 26c give the copies no velocity. Which columns of `steps` jump at "
    "the instant of the cut, and which do not?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
