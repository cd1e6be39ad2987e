/*
 * price.c - when are jumps cheaper than new factors?
 *
 * The square of lesson 26, n x n squares, held on its left side, has a cut of m
 * edges down its middle column, from the upper side.  K is a band.  By jumps a
 * system costs a solve with the old factors for each of the k unknowns of the
 * lips and one for the load, k (k + 1) + 4 k products of length N, and a dense
 * factorisation of order k; anew it costs a factorisation and a solve, with the
 * copies beside their vertices or behind all of them.
 *
 * Table tree: the same cut in a column of the mesh, by nested dissection
 * [alg:dissection] with the copies beside their vertices.  A column of L stays
 * what it was, but for the names of its rows, unless it is that of a vertex of
 * the cut, has rows of both its lips, or lies above such a one in the
 * elimination tree.
 */
#include "../study/study.h"
#include "base/table.h"
#include "linear/dissection.h"
#include "plane/body.h"

#include <math.h>
#include <stdlib.h>

struct price {
    int n, k, p;               /* unknowns before, jumps, half bandwidth */
    double anew, behind, jump; /* flops */
};

/* Unknowns and half bandwidth of the square with a cut of m edges; behind: the
 * copies have the last numbers. */
static struct matrix_cost cut_square(int n, int m, int behind, int *N, int *p)
{
    struct mesh *mesh = mesh_square(n), cut = *mesh;
    const int width = n + 1, middle = n / 2;
    int *first = allocate((size_t)mesh->n_vertex, sizeof *first);
    int *held = allocate((size_t)(mesh->n_vertex + m), sizeof *held), n_new = 0;
    for (int a = 0; a < mesh->n_vertex; a++) {
        first[a] = behind ? a : n_new;
        n_new += 1 + (a % width == middle && a / width > n - m);
    }
    cut.n_vertex = mesh->n_vertex + m;
    cut.n = cut.n_vertex - 1; /* one row of vertices: as they come */
    cut.rows = 0;
    cut.X = allocate(2 * (size_t)cut.n_vertex, sizeof *cut.X);
    cut.triangle = allocate(3 * (size_t)cut.n_triangle, sizeof *cut.triangle);
    for (int c = 0; c < 3 * cut.n_triangle; c++) {
        const int a = mesh->triangle[c];
        const int right = c / 6 % n >= middle; /* two triangles a square */
        const int copy = right && a % width == middle && a / width > n - m;
        const int b = !copy    ? first[a]
                      : behind ? mesh->n_vertex + a / width - (n - m) - 1
                               : first[a] + 1;
        cut.triangle[c] = b;
        held[b] = a % width == 0;
        for (int i = 0; i < 2; i++) cut.X[2 * b + i] = mesh->X[2 * a + i];
    }
    struct body *body =
        body_alloc(&cut, material_notes(CUBIC), 1.0, LUMPED, held);
    *N = body->n_equation;
    *p = body->K->p;
    body_free(body);
    free(cut.triangle);
    free(cut.X);
    free(held);
    free(first);
    mesh_free(mesh);
    return matrix_cost(BANDED, *N, *p);
}

static struct price price(int n, int m)
{
    struct price r;
    int N, p;
    const struct matrix_cost kept = cut_square(n, 0, 0, &r.n, &p);
    const struct matrix_cost behind = cut_square(n, m, 1, &N, &p);
    const struct matrix_cost anew = cut_square(n, m, 0, &N, &r.p);
    const double k = r.k = N - r.n;
    r.anew = anew.flops + anew.solve;
    r.behind = behind.flops + behind.solve;
    r.jump = (k + 1.0) * kept.solve + r.n * (k * (k + 1.0) + 4.0 * k) +
             matrix_cost(DENSE, r.k, 0).flops;
    return r;
}

/* new[2 a + right]: the number of vertex a in the order of elimination after a
 * cut of n / 2 edges down a column, of its right lip with right = 1; -1: held.
 * Returns how many there are; lip[] := 1 and 2 for the lips of a vertex. */
static int order_of_cut(const struct mesh *mesh, int column, int new[],
                        int lip[])
{
    const int n = mesh->n, width = n + 1;
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held), N = 0;
    int *vertex = allocate((size_t)mesh->n_vertex, sizeof *vertex);
    for (int a = 0; a < mesh->n_vertex; a++) held[a] = a % width == 0;
    struct dissection *order = dissection_alloc(
        width, width, mesh->n_triangle, mesh->triangle, held, 4);
    for (int a = 0; a < mesh->n_vertex; a++)
        if (held[a]) new[2 * a] = new[2 * a + 1] = -1;
        else vertex[order->place[a]] = a;
    for (int v = 0; v < order->n_vertex; v++) {
        const int a = vertex[v];
        const int two = a % width == column && a / width > n - n / 2;
        for (int k = 0; k < 2; k++) {
            new[2 * a + k] = N + (two && k);
            if (two) lip[N + k] = 1 + k;
        }
        N += 1 + two;
    }
    dissection_free(order);
    free(vertex);
    free(held);
    return N;
}

/* The part of the flops of a factorisation that has to be made anew; and
 * (print) its row. */
static double tree(int n, int column, int print)
{
    struct mesh *mesh = mesh_square(n);
    const size_t most = 2 * (size_t)mesh->n_vertex;
    int *new = allocate(most, sizeof *new), *lip = allocate(most, sizeof *lip);
    int *parent = allocate(most, sizeof *parent), columns = 0;
    int *count = allocate(most, sizeof *count);
    int *mark = allocate(most, sizeof *mark);
    const int N = order_of_cut(mesh, column, new, lip);
    char *joined = allocate((size_t)N * (size_t)N, 1); /* by a triangle */
    double flops = 0.0, anew = 0.0;
    for (int c = 0; c < 9 * mesh->n_triangle; c++) {
        const int e = c / 9, right = e / 2 % n >= column;
        const int i = new[2 * mesh->triangle[3 * e + c % 3] + right];
        const int j = new[2 * mesh->triangle[3 * e + c / 3 % 3] + right];
        if (i >= 0 && j >= 0) joined[i * N + j] = 1;
    }
    for (int k = 0; k < N; k++) { /* row k of L, as slot 21b */
        parent[k] = -1;
        count[k] = 1;
        mark[k] = k;
        for (int j = 0; j < k; j++)
            for (int i = j; joined[k * N + j] && mark[i] != k; i = parent[i]) {
                if (parent[i] < 0) parent[i] = k;
                if (lip[k] == 2 && mark[i] == k - 1 && !lip[i]) lip[i] = 3;
                count[i]++;
                mark[i] = k;
            }
    }
    for (int k = 0; k < N; k++) { /* 2 unknowns each: m^2 flops a column */
        const double m = 2.0 * count[k], own = m * m + (m - 1.0) * (m - 1.0);
        flops += own;
        if (!lip[k]) continue;
        anew += own;
        columns++;
        if (parent[k] >= 0) lip[parent[k]] = 3;
    }
    if (print) table_row(n, 2 * N, 2 * columns, flops, anew, anew / flops);
    free(joined);
    free(mark);
    free(count);
    free(parent);
    free(lip);
    free(new);
    mesh_free(mesh);
    return anew / flops;
}

int main(void)
{
    int dearer = 1, few = 1, behind = 1;
    table_begin("halfway", "n unknowns jumps anew jump behind");
    for (int n = 8; n <= 32; n *= 2) {
        const struct price r = price(n, n / 2);
        table_row(n, r.n, r.k, r.anew, r.jump, r.behind);
        dearer &= r.jump > r.anew;
        behind &= r.behind > r.jump;
    }
    table_end();

    table_begin("paying", "n bandwidth quarter jumps edges");
    for (int n = 8; n <= 32; n *= 2) {
        int m = 0;
        while (m < n - 1 && price(n, m + 1).jump < price(n, m + 1).anew) m++;
        const struct price r = price(n, m);
        table_row(n, r.p, r.p / 4.0, r.k, m);
        few &= r.k > 0 && r.k < r.p / 4.0;
    }
    table_end();
    table_begin_note("tree", "n unknowns anew flops flops_anew part",
                     "dissection; halfway down the middle");
    for (int n = 8; n <= 32; n *= 2) tree(n, n / 2, 1);
    table_end();
    table_begin_note("parts", "n least most", "of all columns");
    double least = 1.0, most = 0.0;
    for (int n = 8; n <= 32; n *= 2) {
        least = 1.0, most = 0.0;
        for (int column = 1; column < n; column++) {
            const double part = tree(n, column, 0);
            least = fmin(least, part);
            most = fmax(most, part);
        }
        table_row(n, least, most);
    }
    table_end();
    claim(dearer, "a cut halfway through is dearer by jumps than anew");
    claim(behind, "with the copies behind all vertices jumps are the cheaper");
    claim(few, "jumps pay for some, and for fewer than p / 4");
    claim(least > 0.02 && most < 0.2, "n = 32: of the flops of dissection "
          "less than a fifth is to be made anew (%g to %g)", least, most);
    return table_finish();
}
