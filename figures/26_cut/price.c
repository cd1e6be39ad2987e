/*
 * price.c - when are jumps cheaper than new factors?
 *
 * The square of lesson 26, n x n squares, held on its left side, has a cut of m
 * edges down its middle column, from the upper side.  K is a band.  By jumps a
 * system costs a solve with the old factors for each of the k unknowns of the
 * lips and one for the load, k (k + 1) + 4 k products of length N, and a dense
 * factorisation of order k; anew it costs a factorisation and a solve, with the
 * copies beside their vertices or behind all of them.
 */
#include "base/study.h"
#include "base/table.h"
#include "plane/body.h"

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
    claim(dearer, "a cut halfway through is dearer by jumps than anew");
    claim(behind, "with the copies behind all vertices jumps are the cheaper");
    claim(few, "jumps pay for some, and for fewer than p / 4");
    return table_finish();
}
