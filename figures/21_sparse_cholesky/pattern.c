/*
 * pattern.c - which entries of L are no entries of K?
 *
 * The free vertices of 12 x 12 squares between two held ends, numbered row by
 * row and by nested dissection; one point for each 2x2 block of L, marked where
 * it is fill [eq:fill].  Tables: grid, the vertices with their places and how
 * many lines cut off their piece; rows and dissection, the blocks; and counts.
 */
#include "linear/sparse.h"
#include "plane/mesh.h"
#include "../study/study.h"
#include "base/table.h"

#include <stdlib.h>
#include <string.h>

enum { N = 12, WIDTH = N - 1, ALL = WIDTH * (N + 1), LEAF = 4 };

/* Eliminate on the graph with its vertices in this order and print the blocks
 * of L; how many, and how many of them are fill. */
static void print_blocks(const char *name, const struct dissection *d,
                         const int order[ALL], int count[2])
{
    static char edge[ALL][ALL], filled[ALL][ALL];
    memset(edge, 0, sizeof edge);
    for (int v = 0; v < ALL; v++)
        for (int b = d->start[v]; b < d->start[v + 1]; b++)
            edge[order[v]][order[d->row[b]]] =
                edge[order[d->row[b]]][order[v]] = 1;
    memcpy(filled, edge, sizeof edge);
    for (int k = 0; k < ALL; k++)
        for (int i = k + 1; i < ALL; i++) {
            if (!filled[i][k]) continue;
            for (int j = k + 1; j < ALL; j++)
                if (filled[j][k]) filled[i][j] = 1;
        }
    count[0] = count[1] = 0;
    table_begin(name, "row column what");
    for (int i = 0; i < ALL; i++)
        for (int j = 0; j <= i; j++) {
            if (!filled[i][j]) continue;
            table_row(i, j, edge[i][j] ? "entry" : "fill");
            count[0]++;
            count[1] += !edge[i][j];
        }
    table_end();
}

int main(void)
{
    struct mesh *mesh = mesh_square(N);
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    int rows[ALL], same[ALL], depth[ALL], count[2][2];
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = a % (N + 1) == 0 || a % (N + 1) == N;
    struct dissection *d = dissection_alloc(
        mesh->n + 1, mesh->rows + 1, mesh->n_triangle, mesh->triangle, held,
        LEAF);
    for (int p = 0; p < d->n_piece; p++)
        for (int v = 0; v < d->piece[p].count; v++)
            depth[d->piece[p].first + v] = d->piece[p].depth;
    table_begin("grid", "i j place depth");
    int next = 0;
    for (int j = 0; j <= N; j++)
        for (int i = 0; i <= N; i++) {
            const int a = j * (N + 1) + i, place = d->place[a];
            if (held[a]) continue;
            same[place] = place;
            rows[place] = next++;
            table_row(i, j, place, depth[place]);
        }
    table_end();
    print_blocks("rows", d, rows, count[0]);
    print_blocks("dissection", d, same, count[1]);
    table_begin("counts", "order blocks fill");
    table_row("rows", count[0][0], count[0][1]);
    table_row("dissection", count[1][0], count[1][1]);
    table_end();

    /* row by row, all from the first entry of a row on: the vertex below to the
     * left, or below where there is none to the left */
    const int band =
        2 * WIDTH - 1 + N * (WIDTH + 1 + (WIDTH - 1) * (WIDTH + 2));
    claim(count[0][0] - count[0][1] == count[1][0] - count[1][1],
          "both orders have the entries of K");
    claim(count[0][0] > 1.15 * count[1][0] && count[1][1] > 0,
          "dissection fills less (%d blocks after %d)", count[1][0],
          count[0][0]);
    claim(count[0][0] == band, "rows fill the band (%d blocks of %d)",
          count[0][0], band);
    dissection_free(d);
    mesh_free(mesh);
    free(held);
    return table_finish();
}
