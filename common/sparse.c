/*
 * sparse.c - see sparse.h.
 *
 * A front is assembled from the matrix and from what its two children leave,
 * then its pivots are eliminated: the multifrontal method.  What a front leaves
 * waits on one of two stacks, that of even or that of odd depth, until its
 * parent has taken it.
 */
#include "sparse.h"

#include "banded.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

struct sparse_front {
    struct piece piece; /* of the dissection: its vertices are the pivots */
    int rest, at;       /* how many vertices of the rest, where in s->rest */
    size_t l, u;        /* where in the factor, in the work */
};

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* The row of a place in a front. */
static int row_of(const struct sparse *s, const struct sparse_front *f,
                  int place)
{
    const int after = place - f->piece.first;
    if (after < f->piece.count) return 2 * after;
    const int *list = &s->rest[f->at];
    const int *found = bsearch(&place, list, (size_t)f->rest, sizeof(int),
                               compare);
    assert(found);
    return front_row(2 * f->piece.count, 2 * (int)(found - list));
}

/* Add those of the n places that come after front f, and are new, to its rest;
 * seen[v] is the last front that has found v. */
static void add_rest(struct sparse *s, int f, int n, const int place[],
                     int seen[])
{
    struct sparse_front *front = &s->front[f];
    for (int k = 0; k < n; k++) {
        const int v = place[k];
        if (v < front->piece.first + front->piece.count) continue;
        if (seen[v] != f) s->rest[front->at + front->rest++] = v;
        seen[v] = f;
    }
}

/* The rest of front f, which begins at s->rest[at]: the later neighbours of its
 * pivots, and what its children have left [eq:fill].  Returns its end. */
static int find_rest(struct sparse *s, int f, int at, int seen[])
{
    struct sparse_front *front = &s->front[f];
    const struct piece piece = front->piece;
    const struct sparse_front none = {.rest = 0}, *child[2];
    const int first = s->start[piece.first];
    const int own = s->start[piece.first + piece.count] - first;
    for (int c = 0; c < 2; c++)
        child[c] = piece.child[c] < 0 ? &none : &s->front[piece.child[c]];
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
    for (int i = 0; i < s->order->n_piece; i++) {
        struct sparse_front *f = &s->front[i];
        const int p = 2 * f->piece.count, rest = 2 * f->rest;
        const int odd = f->piece.depth % 2, *child = f->piece.child;
        const size_t rows = (size_t)(front_row(p, 0) + front_row(rest, 0));
        f->l = s->factor;
        s->factor += front_size(p, rest);
        f->u = top[odd];
        top[odd] += left_over(f);
        if (top[odd] > most[odd]) most[odd] = top[odd];
        for (int c = 1; c >= 0; c--)
            if (child[c] >= 0) top[!odd] = s->front[child[c]].u;
        if (rows > longest) longest = rows;
        for (int m = p + rest - 1; m >= rest; m--) {
            s->numbers += m + 1.0;
            s->flops += (m + 1.0) * (m + 1.0);
            s->solve += 2.0 * (2.0 * m + 1.0);
        }
    }
    for (int i = 0; i < s->order->n_piece; i++)
        if (s->front[i].piece.depth % 2) s->front[i].u += most[0];
    s->vector = most[0] + most[1];
    s->work = s->vector + longest;
}

/* The rows of every front's blocks in it, and of its rest in its parent. */
static void find_rows(struct sparse *s, int n_rest)
{
    s->up = allocate((size_t)n_rest + 1, sizeof *s->up);
    for (int i = 0; i < s->order->n_piece; i++) {
        const struct sparse_front *f = &s->front[i];
        const struct piece p = f->piece;
        for (int b = s->start[p.first]; b < s->start[p.first + p.count]; b++)
            s->local[b] = row_of(s, f, s->row[b]);
        for (int c = 0; c < 2; c++) {
            if (p.child[c] < 0) continue;
            const struct sparse_front *child = &s->front[p.child[c]];
            for (int k = child->at; k < child->at + child->rest; k++)
                s->up[k] = row_of(s, f, s->rest[k]);
        }
    }
}

struct sparse *sparse_alloc(const struct mesh *mesh, const int held[],
                            int leaf)
{
    struct sparse *s = allocate(1, sizeof *s);
    struct dissection *d = s->order = dissection_alloc(mesh, held, leaf);
    int *seen = allocate((size_t)d->n_vertex, sizeof *seen), n_rest = 0;
    s->n_vertex = d->n_vertex;
    s->place = d->place, s->start = d->start, s->row = d->row;
    s->front = allocate((size_t)d->n_piece, sizeof *s->front);
    s->local = allocate((size_t)s->start[s->n_vertex], sizeof *s->local);
    for (int v = 0; v < s->n_vertex; v++) seen[v] = -1;
    for (int f = 0; f < d->n_piece; f++) {
        s->front[f].piece = d->piece[f];
        n_rest = find_rest(s, f, n_rest, seen);
    }
    free(seen);
    find_rows(s, n_rest);
    lay_out(s);
    return s;
}

void sparse_free(struct sparse *s)
{
    if (!s) return;
    dissection_free(s->order);
    free(s->local);
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
    const int leaf = f->piece.child[0] < 0 && f->piece.child[1] < 0;
    return (struct front){2 * f->piece.count, 2 * f->rest, &l[f->l],
                          &work[f->u], leaf};
}

enum status sparse_factor(const struct sparse *s, const double a[], double l[],
                          double work[])
{
    double *diagonal = &work[s->vector];
    enum status status = OK;
    for (int i = 0; i < s->order->n_piece && status == OK; i++) {
        const struct sparse_front *f = &s->front[i];
        const struct front front = front_of(s, i, l, work);
        memset(front.l, 0, front_size(front.pivots, front.rest) * sizeof *l);
        if (!front.fresh)
            memset(front.u, 0, left_over(f) * sizeof *front.u);
        for (int v = 0; v < f->piece.count; v++) {
            const int first = s->start[f->piece.first + v];
            diagonal[2 * v] = a[4 * first];
            diagonal[2 * v + 1] = a[4 * first + 3];
            for (int b = first; b < s->start[f->piece.first + v + 1]; b++)
                for (int k = 0; k < 2; k++) {
                    double *to = front_entry(&front, s->local[b], 2 * v + k);
                    to[0] = a[4 * b + 2 * k];
                    to[1] = a[4 * b + 2 * k + 1];
                }
        }
        for (int c = 0; c < 2; c++) {
            const int k = f->piece.child[c];
            if (k < 0) continue;
            const struct front child = front_of(s, k, l, work);
            front_extend(&child, &s->up[s->front[k].at], &front);
        }
        status = front_factor(&front, 2 * s->n_vertex, diagonal);
    }
    return status;
}

void sparse_solve(const struct sparse *s, double l[], double work[], double b[])
{
    double *x = &work[s->vector];
    for (int turn = 0; turn < 2 * s->order->n_piece; turn++) {
        const int back = turn >= s->order->n_piece;
        const int i = back ? 2 * s->order->n_piece - 1 - turn : turn;
        const struct sparse_front *f = &s->front[i];
        const struct front front = front_of(s, i, l, work);
        const int p = front.pivots, rest = front.rest, below = front_row(p, 0);
        double *pivot = &b[2 * f->piece.first];
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
