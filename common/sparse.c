/*
 * sparse.c - see sparse.h.
 *
 * A front is assembled from the matrix and from what its two children leave,
 * then its pivots are eliminated: the multifrontal method.  What a front leaves
 * waits on one of two stacks, that of even or that of odd depth, until its
 * parent has taken it.
 */
#include "sparse.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { NEIGHBOURS = 8 }; /* of a vertex of a square grid, however it is cut */

struct sparse_front {
    int first, pivots; /* places first .. first + pivots - 1 */
    int rest, at;      /* how many later ones, and where in s->rest */
    int child[2];      /* -1: none */
    int depth;
    size_t l, u;       /* where in the factor, in the work */
};

/* What the recursion carries along. */
struct dissection {
    struct sparse *s;
    const int *held;
    int row, leaf; /* vertices in a row of the mesh; leaf of sparse_alloc() */
};

struct box {
    int from[2], to[2]; /* columns and rows of vertices, to exclusive */
};

static int count_free(const struct dissection *d, struct box b)
{
    int count = 0;
    for (int j = b.from[1]; j < b.to[1]; j++)
        for (int i = b.from[0]; i < b.to[0]; i++)
            count += !d->held[j * d->row + i];
    return count;
}

/* Number the free vertices of the box, a new front of these children. */
static int number(struct dissection *d, struct box b, int depth, int child0,
                  int child1)
{
    struct sparse *s = d->s;
    struct sparse_front *f = &s->front[s->n_front];
    *f = (struct sparse_front){.first = s->n_vertex, .depth = depth};
    f->child[0] = child0, f->child[1] = child1;
    for (int j = b.from[1]; j < b.to[1]; j++)
        for (int i = b.from[0]; i < b.to[0]; i++)
            if (!d->held[j * d->row + i])
                s->place[j * d->row + i] = s->n_vertex++;
    f->pivots = s->n_vertex - f->first;
    return s->n_front++;
}

/* Cut the box in two and a line between them, which is numbered last
 * [alg:dissection].  The front of the box, -1: no vertex of it is free. */
static int dissect(struct dissection *d, struct box b, int depth)
{
    const int count = count_free(d, b);
    if (count == 0) return -1;
    if (count <= d->leaf) return number(d, b, depth, -1, -1);
    for (int side = 0; side < 4; side++) /* a side that is held is no part */
        for (;;) {
            struct box edge = b, other = b;
            const int k = side / 2;
            if (side % 2) edge.from[k] = other.to[k] = b.to[k] - 1;
            else edge.to[k] = other.from[k] = b.from[k] + 1;
            if (count_free(d, edge) > 0) break;
            b = other;
        }
    const int k = b.to[0] - b.from[0] < b.to[1] - b.from[1];
    struct box before = b, line = b, after = b;
    before.to[k] = line.from[k] = (b.from[k] + b.to[k]) / 2;
    after.from[k] = line.to[k] = line.from[k] + 1;
    const int child0 = dissect(d, before, depth + 1);
    const int child1 = dissect(d, after, depth + 1);
    return number(d, line, depth, child0, child1);
}

/* The later neighbours of every vertex, which are the blocks of the matrix. */
static void find_blocks(struct sparse *s, const struct mesh *mesh)
{
    int *list = allocate((size_t)(NEIGHBOURS + 1) * (size_t)s->n_vertex,
                         sizeof *list);
    int *count = list + NEIGHBOURS * s->n_vertex;
    for (int t = 0; t < 3 * mesh->n_triangle; t++)
        for (int k = 1; k < 3; k++) {
            const int a = s->place[mesh->triangle[t]];
            const int b = s->place[mesh->triangle[t / 3 * 3 + (t + k) % 3]];
            int known = a < 0 || b < a;
            for (int i = 0; i < (known ? 0 : count[a]); i++)
                if (list[NEIGHBOURS * a + i] == b) known = 1;
            if (known) continue;
            assert(count[a] < NEIGHBOURS);
            list[NEIGHBOURS * a + count[a]++] = b;
        }
    s->start = allocate((size_t)s->n_vertex + 1, sizeof(int));
    for (int v = 0; v < s->n_vertex; v++)
        s->start[v + 1] = s->start[v] + 1 + count[v];
    s->row = allocate(2 * (size_t)s->start[s->n_vertex], sizeof(int));
    s->local = s->row + s->start[s->n_vertex];
    for (int v = 0; v < s->n_vertex; v++) {
        s->row[s->start[v]] = v;
        memcpy(&s->row[s->start[v] + 1], &list[NEIGHBOURS * v],
               (size_t)count[v] * sizeof(int));
    }
    free(list);
}

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* The row of a place in a front. */
static int row_of(const struct sparse *s, const struct sparse_front *f,
                  int place)
{
    if (place < f->first + f->pivots) return 2 * (place - f->first);
    const int *list = &s->rest[f->at];
    const int *found = bsearch(&place, list, (size_t)f->rest, sizeof(int),
                               compare);
    assert(found);
    return front_row(2 * f->pivots, 2 * (int)(found - list));
}

/* Add those of the n places that come after front f, and are new, to its rest;
 * seen[v] is the last front that has found v. */
static void add_rest(struct sparse *s, int f, int n, const int place[],
                     int seen[])
{
    struct sparse_front *front = &s->front[f];
    for (int k = 0; k < n; k++) {
        const int v = place[k];
        if (v < front->first + front->pivots || seen[v] == f) continue;
        seen[v] = f;
        s->rest[front->at + front->rest++] = v;
    }
}

/* The rest of front f, which begins at s->rest[at]: the later neighbours of its
 * pivots, and what its children have left [eq:fill].  Returns its end. */
static int find_rest(struct sparse *s, int f, int at, int seen[])
{
    struct sparse_front *front = &s->front[f];
    const int first = s->start[front->first];
    const int own = s->start[front->first + front->pivots] - first;
    const struct sparse_front none = {0};
    const struct sparse_front *child[2];
    for (int c = 0; c < 2; c++)
        child[c] = front->child[c] < 0 ? &none : &s->front[front->child[c]];
    const int room = at + own + child[0]->rest + child[1]->rest + 1;
    s->rest = realloc(s->rest, (size_t)room * sizeof *s->rest);
    if (!s->rest) die("out of memory: %d rows", room);
    front->at = at;
    add_rest(s, f, own, &s->row[first], seen);
    for (int c = 0; c < 2; c++)
        add_rest(s, f, child[c]->rest, &s->rest[child[c]->at], seen);
    qsort(&s->rest[at], (size_t)front->rest, sizeof(int), compare);
    return at + front->rest;
}

/* Numbers that a front leaves to its parent. */
static size_t left_over(const struct sparse_front *f)
{
    return front_size(front_row(2 * f->rest, 0), 0);
}

/* Where the numbers of every front are, and what they cost.  Two stacks: what
 * the children leave is on top of the other one. */
static void lay_out(struct sparse *s)
{
    size_t top[2] = {0, 0}, most[2] = {0, 0}, longest = 0;
    for (int i = 0; i < s->n_front; i++) {
        struct sparse_front *f = &s->front[i];
        const int p = 2 * f->pivots, rest = 2 * f->rest, odd = f->depth % 2;
        const size_t rows = (size_t)(front_row(p, 0) + front_row(rest, 0));
        f->l = s->factor;
        s->factor += front_size(p, rest);
        f->u = top[odd];
        top[odd] += left_over(f);
        if (top[odd] > most[odd]) most[odd] = top[odd];
        for (int c = 1; c >= 0; c--)
            if (f->child[c] >= 0) top[!odd] = s->front[f->child[c]].u;
        if (rows > longest) longest = rows;
        for (int m = p + rest - 1; m >= rest; m--) {
            s->numbers += m + 1.0;
            s->flops += (m + 1.0) * (m + 1.0);
            s->solve += 2.0 * (2.0 * m + 1.0);
        }
    }
    for (int i = 0; i < s->n_front; i++)
        if (s->front[i].depth % 2) s->front[i].u += most[0];
    s->vector = most[0] + most[1];
    s->work = s->vector + longest;
}

/* The rows of every front's blocks in it, and of its rest in its parent. */
static void find_rows(struct sparse *s, int n_rest)
{
    s->up = allocate((size_t)n_rest + 1, sizeof *s->up);
    for (int i = 0; i < s->n_front; i++) {
        const struct sparse_front *f = &s->front[i];
        for (int b = s->start[f->first]; b < s->start[f->first + f->pivots];
             b++)
            s->local[b] = row_of(s, f, s->row[b]);
        for (int c = 0; c < 2; c++) {
            if (f->child[c] < 0) continue;
            const struct sparse_front *child = &s->front[f->child[c]];
            for (int k = child->at; k < child->at + child->rest; k++)
                s->up[k] = row_of(s, f, s->rest[k]);
        }
    }
}

struct sparse *sparse_alloc(const struct mesh *mesh, const int held[],
                            int leaf)
{
    const size_t n = (size_t)mesh->n_vertex;
    struct sparse *s = allocate(1, sizeof *s);
    struct dissection d = {s, held, mesh->n + 1, leaf};
    const struct box all = {{0, 0}, {mesh->n + 1, mesh->n + 1}};
    int n_rest = 0;

    s->place = allocate(n, sizeof *s->place);
    for (size_t a = 0; a < n; a++) s->place[a] = -1;
    s->front = allocate(2 * n, sizeof *s->front);
    dissect(&d, all, 0);
    assert(leaf > 0 && s->n_vertex > 0);
    find_blocks(s, mesh);
    int *seen = allocate(n, sizeof *seen);
    for (size_t v = 0; v < n; v++) seen[v] = -1;
    for (int f = 0; f < s->n_front; f++)
        n_rest = find_rest(s, f, n_rest, seen);
    free(seen);
    find_rows(s, n_rest);
    lay_out(s);
    return s;
}

void sparse_free(struct sparse *s)
{
    if (!s) return;
    free(s->place);
    free(s->start);
    free(s->row);
    free(s->front);
    free(s->rest);
    free(s->up);
    free(s);
}

int sparse_block(const struct sparse *s, int i, int j)
{
    for (int b = s->start[j]; b < s->start[j + 1]; b++)
        if (s->row[b] == i) return b;
    return -1;
}

static struct front front_of(const struct sparse *s, int i, double l[],
                             double work[])
{
    const struct sparse_front *f = &s->front[i];
    return (struct front){2 * f->pivots, 2 * f->rest, &l[f->l], &work[f->u]};
}

enum status sparse_factor(const struct sparse *s, const double a[], double l[],
                          double work[])
{
    double *diagonal = &work[s->vector];
    enum status status = OK;
    for (int i = 0; i < s->n_front && status == OK; i++) {
        const struct sparse_front *f = &s->front[i];
        const struct front front = front_of(s, i, l, work);
        memset(front.l, 0, front_size(front.pivots, front.rest) * sizeof *l);
        memset(front.u, 0, left_over(f) * sizeof *front.u);
        for (int v = 0; v < f->pivots; v++) {
            const int first = s->start[f->first + v];
            diagonal[2 * v] = a[4 * first];
            diagonal[2 * v + 1] = a[4 * first + 3];
            for (int b = first; b < s->start[f->first + v + 1]; b++)
                for (int k = 0; k < 2; k++) {
                    double *to = front_entry(&front, s->local[b], 2 * v + k);
                    to[0] = a[4 * b + 2 * k];
                    to[1] = a[4 * b + 2 * k + 1];
                }
        }
        for (int c = 0; c < 2; c++) {
            if (f->child[c] < 0) continue;
            const struct front child = front_of(s, f->child[c], l, work);
            front_extend(&child, &s->up[s->front[f->child[c]].at], &front);
        }
        status = front_factor(&front, 2 * s->n_vertex, diagonal);
    }
    return status;
}

void sparse_solve(const struct sparse *s, double l[], double work[], double b[])
{
    double *x = &work[s->vector];
    for (int turn = 0; turn < 2 * s->n_front; turn++) {
        const int back = turn >= s->n_front;
        const int i = back ? 2 * s->n_front - 1 - turn : turn;
        const struct sparse_front *f = &s->front[i];
        const struct front front = front_of(s, i, l, work);
        const int p = front.pivots, rest = front.rest, below = front_row(p, 0);
        double *pivot = &b[2 * f->first];
        memset(x, 0, (size_t)(below + front_row(rest, 0)) * sizeof *x);
        memcpy(x, pivot, (size_t)p * sizeof *x);
        for (int k = 0; back && k < rest; k++)
            x[below + k] = b[2 * s->rest[f->at + k / 2] + k % 2];
        if (back) front_backward(&front, x);
        else front_forward(&front, x);
        memcpy(pivot, x, (size_t)p * sizeof *x);
        for (int k = 0; !back && k < rest; k++)
            b[2 * s->rest[f->at + k / 2] + k % 2] += x[below + k];
    }
}
