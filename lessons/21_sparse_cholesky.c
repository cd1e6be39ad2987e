/*
 * 21_sparse_cholesky.c - how much less there is to do when the zeros of a
 * matrix stay zeros: nested dissection, elimination tree, sparse Cholesky.
 *
 * Notes: beyond them; the system is that of Lecture 2, 3.3.5.
 *
 * Problem.  K du = -q, Newton's first increment in a step of a stretched body
 * (system.h), by K = L L^T twice: the vertices numbered row by row, and by
 * nested dissection [alg:dissection].  L has entries where K has none
 * [eq:fill]; the elimination tree [eq:elimination-tree] tells where before any
 * number is computed.
 *
 *     K by compressed rows (csr.h): row k is columns K->index[p], ascending,
 *         and values K->value[p], K->start[k] <= p < K->start[k + 1]
 *     L by compressed columns: column j is rows L->row[p], ascending, L_jj
 *         first, and values L->value[p], L->start[j] <= p < L->end[j]
 *
 * Run       make lesson-21; make lesson-21 ARGS=-h lists its options
 * PREDICT 1 flops row by row over flops by dissection, n = 64: ...
 * PREDICT 2 first of n = 4, 8, 16, 32, 64 with fewer than half of them: ...
 * Plot: rows k count
 */
#include "base/options.h"
#include "plane/system.h"
#include "base/table.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

/* Given the vertices of columns i0 <= i < i1 and rows j0 <= j < j1, number them
 * row by row, place[j * width + i] = next, next + 1, ..., and return the next
 * free number. */
static int number_rows(int i0, int i1, int j0, int j1, int width, int next,
                       int place[])
{
    for (int j = j0; j < j1; j++)
        for (int i = i0; i < i1; i++) place[j * width + i] = next++;
    return next;
}

/* Given the same and leaf >= 4, number by nested dissection [alg:dissection]: a
 * rectangle of more vertices is cut by a line of vertices across its longer
 * side, in the middle.  Lines and small rectangles go row by row. */
static int dissect(int i0, int i1, int j0, int j1, int leaf, int width,
                   int next, int place[])
{
    /* SLOT 21a(i0, i1, j0, j1, leaf, width, next, place, number_rows): return
     * the next free number. */
    todo("21a", i0, i1, j0, j1, leaf, width, next, place, number_rows);
    /* END 21a */
}

/* Given the pattern of K, fill in the elimination tree, parent[j] the smallest
 * i > j with L_ij != 0, -1 where there is none [eq:elimination-tree], and
 * count[j], how many entries column j of L has, with L_jj. */
static void analyse(const struct csr *K, int parent[], int count[])
{
    int *mark = allocate((size_t)K->n, sizeof *mark);
    /* SLOT 21b(K, parent, count, mark): row by row.  K has K_ki, i < k: where
     * does row k of L have entries?  mark is room for K->n numbers. */
    todo("21b", K, parent, count, mark);
    /* END 21b */
    free(mark);
}

/*
 * Given rows 0 to k - 1 of L, append row k [eq:up-looking]: it solves
 * L_(k-1) l = (K_k0, ..., K_k,k-1), and L_kk^2 = K_kk - l.l.  Every entry goes
 * to the end of its column.  NOT_SPD unless L_kk^2 > n eps K_kk.  x is zero
 * before and after; mark is -1 before row 0, then yours, and so is list.
 */
static enum status factor_row(const struct csr *K, int k, const int parent[],
                              struct factor *L, double x[], int mark[],
                              int list[])
{
    /* SLOT 21c(K, k, parent, L, x, mark, list): first the columns i < k with
     * L_ki != 0, each after those below it in the tree; then their values. */
    todo("21c", K, k, parent, L, x, mark, list);
    /* END 21c */
}

/* Entries of K's lower triangle and of L; m in a column are m^2 flops. */
struct cost {
    double unknowns, matrix, entries, flops, residual;
    enum status status;
};

static void print_costs(const struct cost cost[2])
{
    table_begin("cost", "order unknowns matrix entries flops residual status");
    for (int k = 0; k < 2; k++)
        table_row(k ? "dissection" : "rows", cost[k].unknowns, cost[k].matrix,
                  cost[k].entries, cost[k].flops,
                  cell_if(cost[k].status == OK, cost[k].residual),
                  status_name(cost[k].status));
    table_end();
    if (cost[0].status != OK || cost[1].status != OK)
        die("a factorisation ends with NOT_SPD");
}

static void print_tree(const char *name, int n, const int parent[],
                       const int count[])
{
    table_begin(name, "k parent count");
    for (int k = 0; k < n; k++)
        table_row(k, cell_if(parent[k] >= 0, parent[k]), count[k]);
    table_end();
}

/* The place of every vertex (i, j), and its increment in both orders. */
static void print_vertices(const struct system *s, const int place[],
                           const double rows[], const double other[])
{
    const int width = s->scene->mesh->n - 1;
    table_begin("vertices",
                "i j place rows_x rows_y dissection_x dissection_y");
    for (int j = 0; j < s->n_vertex / width; j++)
        for (int i = 0; i < width; i++) {
            const int v = j * width + i;
            table_row(i, j, place[v], rows[2 * v], rows[2 * v + 1],
                      other[2 * v], other[2 * v + 1]);
        }
    table_end();
}

/* The system in one order, with a table of this name; the solution at the
 * vertices goes to du, none when the status is NOT_SPD. */
static struct cost solve_in(const char *name, const struct system *s,
                            const int place[], double du[])
{
    struct csr *K = system_matrix(s, place);
    const int n = K->n;
    struct cost cost = {n, (K->start[n] + n) / 2.0, 0.0, 0.0, 0.0, OK};
    int *parent = allocate((size_t)n, sizeof *parent);
    int *count = allocate((size_t)n, sizeof *count);
    int *mark = allocate((size_t)n, sizeof *mark);
    int *list = allocate((size_t)n, sizeof *list);
    double *x = allocate((size_t)n, sizeof *x);
    double *b = allocate((size_t)n, sizeof *b);
    analyse(K, parent, count);
    print_tree(name, n, parent, count);
    struct factor *L = csr_factor_alloc(n, count);
    for (int j = 0; j < n; j++) {
        cost.entries += count[j];
        cost.flops += (double)count[j] * count[j];
        mark[j] = -1;
    }
    for (int k = 0; k < n && cost.status == OK; k++)
        cost.status = factor_row(K, k, parent, L, x, mark, list);
    system_right_side(s, place, b);
    system_right_side(s, place, x);
    if (cost.status == OK) csr_factor_solve(L, x);
    cost.residual = csr_residual(K, x, b);
    system_back(s, place, x, du);
    csr_factor_free(L);
    free(b);
    free(x);
    free(list);
    free(mark);
    free(count);
    free(parent);
    csr_free(K);
    return cost;
}

int main(int argc, char *argv[])
{
    int n = 12, leaf = 4;
    const struct option options[] = {
        {"n", .integer = &n, .min = 2, .max = 64, .help = "n x n squares"},
        {"leaf", .integer = &leaf, .min = 4, .max = 10000,
         .help = "vertices that are not cut"},
    };
    options_parse("21_sparse_cholesky", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    struct system *s = system_alloc(n);
    int *place = allocate((size_t)s->n_vertex, sizeof *place);
    double *rows = allocate(2 * (size_t)s->n_vertex, sizeof *rows);
    double *other = allocate(2 * (size_t)s->n_vertex, sizeof *other);

    dissect(0, n - 1, 0, n + 1, leaf, n - 1, 0, place);
    const struct cost cost[2] = {
        solve_in("rows", s, NULL, rows),
        solve_in("dissection", s, place, other)};
    print_vertices(s, place, rows, other);
    print_costs(cost);
    free(other);
    free(rows);
    free(place);
    system_free(s);
    return table_finish();
}
