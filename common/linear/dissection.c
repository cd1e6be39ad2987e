/* dissection.c - see dissection.h. */
#include "linear/dissection.h"

#include "base/status.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Of a vertex of a square grid, however it is cut; with quadratic triangles. */
enum { NEIGHBOURS = 18 };

/* The state of the recursion. */
struct state {
    struct dissection *d;
    const int *held;
    int row, leaf; /* vertices in a row of the mesh; leaf of the caller */
    int reach;     /* a triangle goes over so many columns or rows, and only
                    * every such line has no edge across it */
};

struct box {
    int from[2], to[2]; /* columns and rows of vertices, to exclusive */
};

static int count_free(const struct state *s, struct box b)
{
    int count = 0;
    for (int j = b.from[1]; j < b.to[1]; j++)
        for (int i = b.from[0]; i < b.to[0]; i++)
            count += !s->held[j * s->row + i];
    return count;
}

/* Number the free vertices of the box, row by row: a new piece. */
static int number(const struct state *s, struct box b, int depth, int child0,
                  int child1)
{
    struct dissection *d = s->d;
    struct piece *piece = &d->piece[d->n_piece];
    *piece = (struct piece){d->n_vertex, 0, depth, {child0, child1}};
    for (int j = b.from[1]; j < b.to[1]; j++)
        for (int i = b.from[0]; i < b.to[0]; i++)
            if (!s->held[j * s->row + i])
                d->place[j * s->row + i] = d->n_vertex++;
    piece->count = d->n_vertex - piece->first;
    return d->n_piece++;
}

/* Cut the box in two and a line between them, which is numbered last
 * [alg:dissection].  Returns the last piece, -1: no vertex of it is free. */
static int dissect(const struct state *s, struct box b, int depth)
{
    const int count = count_free(s, b);
    if (count == 0) return -1;
    if (count <= s->leaf) return number(s, b, depth, -1, -1);
    for (int i = 0; i < 2; i++) /* a side that is held is no part */
        for (int last = 0; last < 2; last++)
            for (;;) {
                struct box edge = b, other = b;
                if (last) edge.from[i] = other.to[i] = b.to[i] - 1;
                else edge.to[i] = other.from[i] = b.from[i] + 1;
                if (count_free(s, edge) > 0) break;
                b = other;
            }
    const int k = b.to[0] - b.from[0] < b.to[1] - b.from[1]; /* longer side */
    struct box before = b, line = b, after = b;
    line.from[k] = (b.from[k] + b.to[k]) / 2;
    line.from[k] -= line.from[k] % s->reach;
    before.to[k] = line.from[k];
    after.from[k] = line.to[k] = line.from[k] + 1;
    const int child0 = dissect(s, before, depth + 1);
    const int child1 = dissect(s, after, depth + 1);
    return number(s, line, depth, child0, child1);
}

/* Return the most columns or rows over which a triangle goes. */
static int find_reach(int columns, int n_triangle, const int triangle[])
{
    int reach = 1;
    for (int t = 0; t < n_triangle; t++)
        for (int c = 0; c < 3; c++) {
            const int a = triangle[3 * t + c];
            const int b = triangle[3 * t + (c + 1) % 3];
            const int sideways = abs(a % columns - b % columns);
            const int up = abs(a / columns - b / columns);
            if (sideways > reach) reach = sideways;
            if (up > reach) reach = up;
        }
    return reach;
}

/* The later neighbours of every vertex, by the edges of the triangles. */
static void find_neighbours(struct dissection *d, int n_triangle,
                            const int triangle[])
{
    int *list = allocate(NEIGHBOURS * (size_t)d->n_vertex, sizeof *list);
    int *count = allocate((size_t)d->n_vertex, sizeof *count);
    for (int t = 0; t < n_triangle; t++) {
        const int *vertex = &triangle[3 * t];
        for (int c = 0; c < 3; c++)
            for (int k = 1; k < 3; k++) {
                const int a = d->place[vertex[c]];
                const int b = d->place[vertex[(c + k) % 3]];
                int known = a < 0 || b < a; /* held, or earlier */
                for (int i = 0; i < (known ? 0 : count[a]); i++)
                    if (list[NEIGHBOURS * a + i] == b) known = 1;
                if (known) continue;
                assert(count[a] < NEIGHBOURS);
                list[NEIGHBOURS * a + count[a]++] = b;
            }
    }
    d->start = allocate((size_t)d->n_vertex + 1, sizeof(int));
    for (int v = 0; v < d->n_vertex; v++)
        d->start[v + 1] = d->start[v] + 1 + count[v]; /* 1: v itself */
    d->row = allocate((size_t)d->start[d->n_vertex], sizeof(int));
    for (int v = 0; v < d->n_vertex; v++) {
        d->row[d->start[v]] = v;
        memcpy(&d->row[d->start[v] + 1], &list[NEIGHBOURS * v],
               (size_t)count[v] * sizeof(int));
    }
    free(list);
    free(count);
}

struct dissection *dissection_alloc(int columns, int rows, int n_triangle,
                                    const int triangle[], const int held[],
                                    int leaf)
{
    const struct box all = {{0, 0}, {columns, rows}};
    const int n_vertex = columns * rows;
    struct dissection *d = allocate(1, sizeof *d);
    const struct state state = {d, held, columns, leaf,
                                find_reach(columns, n_triangle, triangle)};
    d->place = allocate((size_t)n_vertex, sizeof *d->place);
    for (int a = 0; a < n_vertex; a++) d->place[a] = -1;
    d->piece = allocate((size_t)n_vertex, sizeof *d->piece);
    assert(leaf > 0);
    dissect(&state, all, 0);
    assert(d->n_vertex > 0);
    find_neighbours(d, n_triangle, triangle);
    return d;
}

void dissection_free(struct dissection *d)
{
    if (!d) return;
    free(d->place);
    free(d->piece);
    free(d->start);
    free(d->row);
    free(d);
}
