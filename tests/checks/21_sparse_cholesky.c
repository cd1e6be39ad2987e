/*
 * 21_sparse_cholesky.c - what a right order, tree and sparse factor satisfy.
 *
 * Arguments: slot, argument: varied by checks
 *   21a i0, i1, j0, j1, leaf: every_vertex_has_a_number, and
 *       lines_are_numbered_last; width, next: both, and
 *       both_orders_agree_with_the_fast_one by --n
 *   21b K: arrows_have_their_trees, tree_is_that_of_elimination (patterns,
 *       orders, entries that are 0)
 *   21c K: factor_times_its_transpose_is_K (patterns, orders), the_pivot_is
 *       _compared_with_its_own_entry (units), what_is_not_spd_is_named; parent,
 *       k: with K; L: holds NaN before; x, mark, list: as the row before left
 *       them, guarded
 */
#include "program.h"

#include "judge.h"

#include <string.h>

#define ROUND_OFF 1e-13 /* of sums of some thirty products */

/* ---- 21a ----------------------------------------------------------------- */

enum { WIDTH = 23, HEIGHT = 19, NO_PLACE = -7 };

struct rectangle {
    int i0, i1, j0, j1;
};

/* How many places, and the least and the largest of them, in a rectangle. */
struct range {
    int count, least, most;
};

static struct range range_of(struct rectangle r, const int place[])
{
    struct range range = {0, 1 << 20, -1};
    for (int j = r.j0; j < r.j1; j++)
        for (int i = r.i0; i < r.i1; i++) {
            const int p = place[j * WIDTH + i];
            range.count++;
            if (p < range.least) range.least = p;
            if (p > range.most) range.most = p;
        }
    return range;
}

/* No two places are alike, when this holds of the whole and of its parts. */
static int whole(struct range r)
{
    return r.count == 0 || r.most - r.least + 1 == r.count;
}

/* Whether the line at `at`, across direction 0 or 1, is numbered last, the
 * sides one after the other. */
static int line_is_at(struct rectangle r, int across, int at,
                      const int place[], struct rectangle side[2])
{
    struct rectangle line = r;
    side[0] = side[1] = r;
    if (across == 0) side[0].i1 = line.i0 = at, side[1].i0 = line.i1 = at + 1;
    else side[0].j1 = line.j0 = at, side[1].j0 = line.j1 = at + 1;
    const struct range all = range_of(r, place), l = range_of(line, place);
    const struct range s[2] = {range_of(side[0], place),
                               range_of(side[1], place)};
    return whole(l) && whole(s[0]) && whole(s[1]) && l.most == all.most &&
           l.count + s[0].count + s[1].count == all.count &&
           (s[0].count == 0 || s[0].most < l.least) &&
           (s[1].count == 0 || s[1].most < l.least);
}

static void expect_rows(struct rectangle r, const int place[])
{
    const int first = range_of(r, place).least;
    for (int j = r.j0, p = first; j < r.j1; j++)
        for (int i = r.i0; i < r.i1; i++, p++)
            expect(place[j * WIDTH + i] == p, "columns %d to %d, rows %d to %d "
                   "are not cut, and numbered row by row from %d on: vertex "
                   "(%d, %d) has place %d, not %d", r.i0, r.i1 - 1, r.j0,
                   r.j1 - 1, first, i, j, place[j * WIDTH + i], p);
}

/* The same of every part of the rectangle that is cut; any middle will do, and
 * either side of a square. */
static void expect_lines(struct rectangle r, int leaf, const int place[])
{
    const int width = r.i1 - r.i0, height = r.j1 - r.j0;
    if (width * height <= leaf) {
        expect_rows(r, place);
        return;
    }
    for (int across = 0; across < 2; across++) {
        const int length = across ? height : width;
        const int first = across ? r.j0 : r.i0;
        if (length < (across ? width : height)) continue;
        for (int k = (length - 1) / 2; k <= length / 2; k++) {
            struct rectangle side[2];
            if (!line_is_at(r, across, first + k, place, side)) continue;
            struct rectangle line = r;
            if (across) line.j0 = first + k, line.j1 = first + k + 1;
            else line.i0 = first + k, line.i1 = first + k + 1;
            expect_rows(line, place);
            expect_lines(side[0], leaf, place);
            expect_lines(side[1], leaf, place);
            return;
        }
    }
    wrong("no line in the middle of columns %d to %d, rows %d to %d has the "
          "last numbers, behind those of either side",
          r.i0, r.i1 - 1, r.j0, r.j1 - 1);
}

static const struct rectangle rectangles[] = {
    {0, 2, 0, 2}, {3, 6, 2, 4}, {0, 7, 0, 5},   {2, 7, 1, 12},
    {1, 9, 3, 9}, {4, 8, 0, 4}, {0, 23, 0, 19}, {5, 22, 2, 18},
    {3, 18, 0, 19}};
static const int leaves[] = {4, 5, 9, 30};

/* Number one of them from 11 on; returns what dissect() does. */
static int number(struct rectangle r, int leaf, int place[])
{
    for (int v = 0; v < WIDTH * HEIGHT; v++) place[v] = NO_PLACE;
    return dissect(r.i0, r.i1, r.j0, r.j1, leaf, WIDTH, 11, place);
}

static void every_vertex_has_a_number(void)
{
    int place[WIDTH * HEIGHT];
    for (int k = 0; k < COUNT(rectangles); k++)
        for (int l = 0; l < COUNT(leaves); l++) {
            const struct rectangle r = rectangles[k];
            const int next = number(r, leaves[l], place);
            const int n = (r.i1 - r.i0) * (r.j1 - r.j0);
            int seen[11 + WIDTH * HEIGHT] = {0};
            expect(next == 11 + n, "%d vertices from 11 on: the next free "
                   "number is %d, not %d", n, 11 + n, next);
            for (int v = 0; v < WIDTH * HEIGHT; v++) {
                const int i = v % WIDTH, j = v / WIDTH, p = place[v];
                const int in = r.i0 <= i && i < r.i1 && r.j0 <= j && j < r.j1;
                expect(in || p == NO_PLACE, "vertex (%d, %d) is not in the "
                       "rectangle and has got a number", i, j);
                if (!in) continue;
                expect(11 <= p && p < 11 + n && !seen[p],
                       "place %d of vertex (%d, %d) is not one of 11 to %d, or "
                       "another vertex has it", p, i, j, 10 + n);
                seen[p] = 1;
            }
        }
}

/* A mesh of another width: 2 x 2 vertices in rows of five. */
static void rows_are_a_width_apart(void)
{
    int place[10];
    for (int v = 0; v < 10; v++) place[v] = NO_PLACE;
    dissect(1, 3, 0, 2, 4, 5, 0, place);
    for (int v = 0; v < 10; v++) {
        const int in = v % 5 == 1 || v % 5 == 2;
        expect(place[v] == (in ? 2 * (v / 5) + v % 5 - 1 : NO_PLACE),
               "width 5, columns 1 and 2: place[%d] is %d", v, place[v]);
    }
}

static void lines_are_numbered_last(void)
{
    rows_are_a_width_apart();
    int place[WIDTH * HEIGHT];
    for (int k = 0; k < COUNT(rectangles); k++)
        for (int l = 0; l < COUNT(leaves); l++) {
            number(rectangles[k], leaves[l], place);
            expect_lines(rectangles[k], leaves[l], place);
        }
}

/* ---- matrices, and elimination that looks at every entry ----------------- */

enum { MOST = 40 };

/* A random symmetric, diagonally dominant matrix of order n; how many of 100
 * entries there are, from a linear congruence. */
static struct csr *random_matrix(int n, int percent, unsigned seed)
{
    double dense[MOST][MOST] = {{0.0}};
    struct csr *K = csr_alloc(n, n * n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j <= i; j++) {
            seed = seed * 1103515245u + 12345u;
            const double value = (seed >> 16) % 1000 / 1000.0 - 0.5;
            seed = seed * 1103515245u + 12345u;
            if (i == j) dense[i][i] = 0.62 * n + value;
            else if ((int)((seed >> 16) % 100) < percent)
                dense[i][j] = dense[j][i] = value + 0.0371;
        }
    for (int i = 0, k = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            if (dense[i][j] != 0.0)
                K->index[k] = j, K->value[k++] = dense[i][j];
        K->start[i + 1] = k;
    }
    return K;
}

/* filled[i][j] != 0: L_ij is an entry. */
static void eliminate(const struct csr *K, char filled[MOST][MOST])
{
    memset(filled, 0, MOST * MOST);
    for (int i = 0; i < K->n; i++)
        for (int p = K->start[i]; p < K->start[i + 1]; p++)
            filled[i][K->index[p]] = 1;
    for (int k = 0; k < K->n; k++)
        for (int i = k + 1; i < K->n; i++)
            for (int j = k + 1; j < K->n; j++)
                if (filled[i][k] && filled[j][k]) filled[i][j] = 1;
}

/* ---- 21b ----------------------------------------------------------------- */

static void expect_tree(const struct csr *K, const char *what)
{
    int parent[MOST], count[MOST];
    char filled[MOST][MOST];
    eliminate(K, filled);
    for (int j = 0; j < K->n; j++) parent[j] = count[j] = 1000 + j;
    analyse(K, parent, count);
    for (int j = 0; j < K->n; j++) {
        int first = -1, entries = 1;
        for (int i = K->n - 1; i > j; i--)
            if (filled[i][j]) first = i, entries++;
        expect(parent[j] == first, "%s: the parent of %d is %d, not %d", what,
               j, first, parent[j]);
        expect(count[j] == entries, "%s: column %d of L has %d entries, not %d",
               what, j, entries, count[j]);
    }
}

/* The arrow with its first row full fills, that with its last one does not. */
static struct csr *arrow(int n, int tip)
{
    struct csr *K = csr_alloc(n, 3 * n);
    for (int i = 0, k = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            if (i == j || i == tip || j == tip)
                K->index[k] = j, K->value[k++] = i == j ? n : -0.385;
        K->start[i + 1] = k;
    }
    return K;
}

static void arrows_have_their_trees(void)
{
    for (int tip = 8; tip >= 0; tip -= 4) {
        struct csr *K = arrow(9, tip);
        expect_tree(K, tip == 8   ? "all joined to the last row"
                       : tip == 0 ? "all joined to the first row"
                                  : "all joined to a row in the middle");
        csr_free(K);
    }
}

static void tree_is_that_of_elimination(void)
{
    for (unsigned seed = 1; seed <= 60; seed++) {
        struct csr *K = random_matrix(1 + (int)seed % MOST,
                                      (int)(seed * 7 % 31), seed);
        expect_tree(K, "a random pattern");
        for (int p = 0; p < K->start[K->n]; p++) K->value[p] = 0.0;
        expect_tree(K, "a pattern whose entries are 0");
        csr_free(K);
    }
}

/* ---- 21c ----------------------------------------------------------------- */

/* L of K, with a tree and counts that are not the program's. */
static enum status factor_of(const struct csr *K, struct factor **L)
{
    int parent[MOST] = {0}, count[MOST];
    int *mark = guarded_indices(K->n, parent);
    int *list = guarded_indices(K->n, parent);
    double *x = guarded_alloc(K->n);
    char filled[MOST][MOST];
    enum status status = OK;
    eliminate(K, filled);
    for (int j = 0; j < K->n; j++) {
        parent[j] = mark[j] = -1;
        count[j] = 1;
        x[j] = 0.0;
        for (int i = K->n - 1; i > j; i--)
            if (filled[i][j]) parent[j] = i, count[j]++;
    }
    *L = csr_factor_alloc(K->n, count);
    for (int p = 0; p < (*L)->start[K->n]; p++) { /* there is nothing yet */
        (*L)->row[p] = K->n - 1;
        (*L)->value[p] = NAN;
    }
    for (int k = 0; k < K->n && status == OK; k++) {
        status = factor_row(K, k, parent, *L, x, mark, list);
        for (int j = 0; j < K->n && status == OK; j++)
            expect(x[j] == 0.0, "after row %d: got x[%d] = %g, want 0", k, j,
                   x[j]);
    }
    for (int j = 0; j < K->n && status == OK; j++) {
        const int *row = &(*L)->row[(*L)->start[j]];
        const int m = (*L)->end[j] - (*L)->start[j];
        expect(m == count[j], "column %d of L has got %d entries, it has %d", j,
               m, count[j]);
        expect(row[0] == j, "column %d of L begins with row %d", j, row[0]);
        for (int p = 1; p < m; p++)
            expect(row[p - 1] < row[p] && filled[row[p]][j],
                   "column %d of L: row %d after row %d", j, row[p],
                   row[p - 1]);
    }
    return status;
}

/* L L^T = K to a relative tolerance. */
static void expect_factor(const struct csr *K, const char *what)
{
    double product[MOST][MOST] = {{0.0}}, largest = 0.0;
    struct factor *L;
    const enum status status = factor_of(K, &L);
    expect(status == OK, "%s: %s, although it is positive definite", what,
           status_name(status));
    for (int j = 0; j < K->n; j++)
        for (int p = L->start[j]; p < L->end[j]; p++)
            for (int q = L->start[j]; q < L->end[j]; q++)
                product[L->row[p]][L->row[q]] += L->value[p] * L->value[q];
    for (int i = 0; i < K->n; i++)
        for (int p = K->start[i]; p < K->start[i + 1]; p++) {
            largest = fmax(largest, fabs(K->value[p]));
            product[i][K->index[p]] -= K->value[p];
        }
    for (int i = 0; i < K->n; i++)
        for (int j = 0; j <= i; j++)
            expect_close(product[i][j], 0.0, ROUND_OFF, largest,
                         "%s: entry (%d, %d) of L L^T - K", what, i, j);
    csr_factor_free(L);
}

static void factor_times_its_transpose_is_K(void)
{
    struct csr *one = arrow(1, 0), *last = arrow(9, 8), *first = arrow(9, 0);
    expect_factor(one, "one unknown");
    csr_free(one);
    expect_factor(last, "all joined to the last row");
    expect_factor(first, "all joined to the first row");
    csr_free(last);
    csr_free(first);
    for (unsigned seed = 1; seed <= 60; seed++) {
        struct csr *K = random_matrix(1 + (int)seed % MOST,
                                      (int)(seed * 7 % 31), seed);
        expect_factor(K, "a random matrix");
        csr_free(K);
    }
}

/* Unknowns of very different scales do not make a matrix indefinite. */
static void the_pivot_is_compared_with_its_own_entry(void)
{
    struct csr *K = random_matrix(20, 20, 3);
    struct factor *L;
    for (int i = 0; i < K->n; i++)
        for (int p = K->start[i]; p < K->start[i + 1]; p++)
            K->value[p] *= pow(10.0, 9.0 * (sin(i) + sin(K->index[p])));
    expect(factor_of(K, &L) == OK, "scales from 1e-18 to 1e18: NOT_SPD, "
           "although it is positive definite");
    csr_factor_free(L);
    csr_free(K);
}

/* The second pivot of a block 1, c; c, 1 is 1 - c^2 = part n eps; the block
 * begins in row `at` of I. */
static enum status border(int at, double part)
{
    enum { N = 32 };
    struct csr *K = csr_alloc(N, N + 2);
    struct factor *L;
    for (int i = 0, k = 0; i < N; i++) {
        const int in = i == at || i == at + 1;
        for (int j = in ? at : i; j <= (in ? at + 1 : i); j++) {
            K->index[k] = j;
            K->value[k++] =
                0x1p-20 * (i == j ? 1.0 : sqrt(1.0 - part * N * DBL_EPSILON));
        }
        K->start[i + 1] = k;
    }
    const enum status status = factor_of(K, &L);
    csr_factor_free(L);
    csr_free(K);
    return status;
}

static void the_least_pivot_is_n_eps(void)
{
    for (int at = 0; at <= 30; at += 15) {
        expect(border(at, 0.5) == NOT_SPD, "n = 32, pivot %d is 16 eps K_kk: "
               "OK, although it is not larger than n eps K_kk", at + 1);
        expect(border(at, 2.0) == OK, "n = 32, pivot %d is 64 eps K_kk: "
               "NOT_SPD, although it is larger than n eps K_kk", at + 1);
    }
}

static void what_is_not_spd_is_named(void)
{
    static const char *const what[] = {"a negative pivot", "a zero pivot",
                                       "NaN on the diagonal",
                                       "NaN below the diagonal"};
    for (int bad = 0; bad < COUNT(what); bad++)
        for (int k = 0; k < 20; k++) {
            struct csr *K = random_matrix(20, 25, 5);
            struct factor *L;
            for (int p = K->start[k]; p < K->start[k + 1]; p++) {
                if (K->index[p] == k && bad < 3)
                    K->value[p] = bad == 0 ? -K->value[p] : bad == 1 ? 0.0
                                                                     : NAN;
                if (K->index[p] < k && bad == 3) K->value[p] = NAN;
            }
            const int spoilt = bad < 3 || K->index[K->start[k]] < k;
            const enum status status = factor_of(K, &L);
            expect(status == (spoilt ? NOT_SPD : OK), "%s in row %d: %s",
                   what[bad], k, status_name(status));
            csr_factor_free(L);
            csr_free(K);
        }
}

/* ---- the whole ----------------------------------------------------------- */

static void both_orders_agree_with_the_fast_one(void)
{
    for (int n = 2; n <= 14; n += 3) {
        char options[32];
        struct system *s = system_alloc(n);
        double *du = allocate((size_t)s->scene->n_dof, sizeof *du);
        double largest = 0.0;
        snprintf(options, sizeof options, "--n %d", n);
        struct output *o = run(options);
        system_store(s, SPARSE);
        for (int r = 0; r < s->scene->n_dof; r++) s->b[r] = -s->b[r];
        expect(body_increment(s->scene->body, s->scene->body->K, s->b, du) ==
               OK, "the matrix is not SPD");
        for (int v = 0; v < s->n_vertex; v++)
            largest = fmax(largest, fabs(du[2 * s->vertex[v]]));
        for (int v = 0; v < s->n_vertex; v++)
            for (int k = 0; k < 4; k++) {
                const char *name[] = {"rows_x", "rows_y", "dissection_x",
                                      "dissection_y"};
                expect_close(cell(o, "vertices", name[k], v),
                             du[2 * s->vertex[v] + k % 2], 1e-12, largest,
                             "%s at vertex %d, n = %d", name[k], v, n);
            }
        for (int row = 0; row < 2; row++)
            expect_close(cell(o, "cost", "residual", row), 0.0, 1e-12, 1.0,
                         "relative residual, n = %d", n);
        system_free(s);
        free(du);
    }
}

/* A band without zeros inside: all that is between the first entry of a row
 * and its diagonal. */
static void rows_fill_the_band_and_dissection_less(void)
{
    struct output *o = run("--n 48");
    const double rows = cell(o, "cost", "entries", 0);
    const double less = cell(o, "cost", "entries", 1);
    struct system *s = system_alloc(48);
    struct csr *K = system_matrix(s, NULL);
    double band = 0.0;
    for (int i = 0; i < K->n; i++) band += i - K->index[K->start[i]] + 1;
    expect_close(rows, band, 0.0, 1.0, "entries of L in row-by-row order, "
                 "against those of the rows from their first entry on");
    expect(less > 0.35 * rows && less < 0.45 * rows,
           "n = 48: dissection has %.2f of the entries; it should be 0.41",
           less / rows);
    csr_free(K);
    system_free(s);
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("--n 64");
    char options[16];
    int n = 4;
    measured("1", cell(output, "cost", "flops", 0) /
                      cell(output, "cost", "flops", 1));
    for (; n < 64; n *= 2) {
        snprintf(options, sizeof options, "--n %d", n);
        output = run(options);
        if (2.0 * cell(output, "cost", "flops", 1) <
            cell(output, "cost", "flops", 0))
            break;
    }
    measured("2", n);
}

static const struct claim claims[] = {
    {"every_vertex_has_a_number", every_vertex_has_a_number, "21a"},
    {"lines_are_numbered_last", lines_are_numbered_last, "21a"},
    {"arrows_have_their_trees", arrows_have_their_trees, "21b"},
    {"tree_is_that_of_elimination", tree_is_that_of_elimination, "21b"},
    {"factor_times_its_transpose_is_K", factor_times_its_transpose_is_K, "21c"},
    {"the_pivot_is_compared_with_its_own_entry",
     the_pivot_is_compared_with_its_own_entry, "21c"},
    {"the_least_pivot_is_n_eps", the_least_pivot_is_n_eps, "21c"},
    {"what_is_not_spd_is_named", what_is_not_spd_is_named, "21c"},
    {"both_orders_agree_with_the_fast_one",
     both_orders_agree_with_the_fast_one, "21c"},
    {"rows_fill_the_band_and_dissection_less",
     rows_fill_the_band_and_dissection_less, "21b"},
};

static const char *const runs[] = {"", "--n 2", "--n 5", "--n 9 --leaf 9",
                                   "--n 16"};

#define ORDER "any middle, and any order within a line, will do"
static const struct column_rule rules[] = {
    {"rows", "k", 0, "a number", 0},
    {"rows", "parent", 0, "K decides", 0},
    {"rows", "count", 0, "K decides", 0},
    {"dissection", "k", 0, "a number", 0},
    {"dissection", "*", NOT_COMPARED, ORDER, 0},
    {"cost", "order", 0, "a word", 0},
    {"cost", "unknowns", 0, "a count", 0},
    {"cost", "matrix", 0, "a count", 0},
    {"cost", "entries", 0.06, ORDER, 0},
    {"cost", "flops", 0.1, ORDER, 0},
    {"cost", "residual", 1e-12, "round-off", 1},
    {"cost", "status", 0, "a word", 0},
    {"vertices", "i", 0, "a number", 0},
    {"vertices", "j", 0, "a number", 0},
    {"vertices", "place", NOT_COMPARED, ORDER, 0},
    {"vertices", "*", 1e-12, "round-off", 0},
};

static const struct lesson lesson = {
    "21_sparse_cholesky", claims, COUNT(claims), runs, COUNT(runs), rules,
    COUNT(rules),
    "Both orders do the same elimination on the same equations, and give the "
    "same increment to round-off. What differs is which zeros are destroyed.",
    "In slot 21a number the line first instead of last. The increment stays "
    "right to the last digits; how many entries does L have now?",
    what_was_predicted};

int main(int argc, char *argv[])
{
    return judge(&lesson, argc, argv);
}
