/*
 * sparse.c - see sparse.h.
 *
 * A front is assembled from the matrix and from what its two children leave,
 * then its pivots are eliminated: the multifrontal method.  What a front leaves
 * waits on one of two stacks, that of even or that of odd depth, until its
 * parent has taken it.
 */
#include "linear/sparse.h"

#include "linear/front.h"
#include "linear/matrix.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

struct sparse_front {
    struct piece piece; /* of the dissection: its vertices are the pivots */
    int rest, at;       /* how many vertices of the rest, where in s->rest */
    size_t l, u;        /* where in the factor, in the room */
};

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Return the row of a place in a front. */
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

/* Find the rest of front f from s->rest[begin] on: the later neighbours of its
 * pivots, and what its children have left [eq:fill].  Returns its end. */
static int find_rest(struct sparse *s, int f, int begin, int seen[])
{
    struct sparse_front *front = &s->front[f];
    const struct piece piece = front->piece;
    const int first = s->start[piece.first];
    const int own = s->start[piece.first + piece.count] - first;
    int room = begin + own + 1;
    for (int c = 0; c < 2; c++)
        if (piece.child[c] >= 0) room += s->front[piece.child[c]].rest;
    s->rest = realloc(s->rest, (size_t)room * sizeof *s->rest);
    if (!s->rest) die("out of memory: %d rows", room);
    front->at = begin;
    add_rest(s, f, own, &s->row[first], seen);
    for (int c = 0; c < 2; c++) {
        if (piece.child[c] < 0) continue;
        const struct sparse_front *child = &s->front[piece.child[c]];
        add_rest(s, f, child->rest, &s->rest[child->at], seen);
    }
    qsort(&s->rest[begin], (size_t)front->rest, sizeof(int), compare);
    return begin + front->rest;
}

/* Place the numbers of every front, and count them.  Two stacks: the rest of
 * the children is on top of the other one. */
static void lay_out(struct sparse *s)
{
    size_t top[2] = {0, 0}, peak[2] = {0, 0}, largest = 0;
    for (int i = 0; i < s->order->n_piece; i++) {
        struct sparse_front *f = &s->front[i];
        const int p = 2 * f->piece.count, rest = 2 * f->rest;
        const int odd = f->piece.depth % 2, *child = f->piece.child;
        const size_t size = front_size(p, rest);
        f->l = s->factor;
        s->factor += size;
        f->u = top[odd];
        top[odd] += front_size(front_row(rest, 0), 0);
        if (top[odd] > peak[odd]) peak[odd] = top[odd];
        for (int c = 1; c >= 0; c--) /* child 0 is the lower one */
            if (child[c] >= 0) top[!odd] = s->front[child[c]].u;
        if (size > largest) largest = size;
        for (int m = p + rest - 1; m >= rest; m--) { /* m rows below a pivot */
            s->numbers += m + 1.0;
            s->flops += (m + 1.0) * (m + 1.0);
            s->solve += 2.0 * (2.0 * m + 1.0);
        }
    }
    for (int i = 0; i < s->order->n_piece; i++)
        if (s->front[i].piece.depth % 2) s->front[i].u += peak[0];
    s->vector = peak[0] + peak[1];
    s->l = s->vector; /* of a front's rows: two parts, filled up */
    s->l += (size_t)(front_row(2 * s->n_vertex, 0) + front_row(1, 0));
    s->room = s->l + largest;
}

/* Find the blocks of a front in it, and the rows of its rest in its parent. */
static void find_rows(struct sparse *s, int n_rest)
{
    s->up = allocate((size_t)n_rest + 1, sizeof *s->up);
    for (int i = 0; i < s->order->n_piece; i++) {
        const struct sparse_front *f = &s->front[i];
        const struct piece p = f->piece;
        const int *start = &s->start[p.first];
        for (int v = 0; v < p.count; v++)
            for (int b = start[v]; b < start[v + 1]; b++)
                s->local[b] = front_place(2 * p.count, 2 * f->rest,
                                          row_of(s, f, s->row[b]), 2 * v);
        for (int c = 0; c < 2; c++) {
            if (p.child[c] < 0) continue;
            const struct sparse_front *child = &s->front[p.child[c]];
            for (int k = child->at; k < child->at + child->rest; k++)
                s->up[k] = row_of(s, f, s->rest[k]);
        }
    }
}

struct sparse *sparse_alloc(int columns, int rows, int n_triangle,
                            const int triangle[], const int held[], int leaf)
{
    struct sparse *s = allocate(1, sizeof *s);
    struct dissection *d = s->order =
        dissection_alloc(columns, rows, n_triangle, triangle, held, leaf);
    int *seen = allocate((size_t)d->n_vertex, sizeof *seen), n_rest = 0;
    s->n_vertex = d->n_vertex;
    s->place = d->place;
    s->start = d->start;
    s->row = d->row;
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

/* Return the block of places i >= j, -1: it is zero. */
static int find_block(const struct sparse *s, int i, int j)
{
    for (int b = s->start[j]; b < s->start[j + 1]; b++)
        if (s->row[b] == i) return b;
    return -1;
}

size_t sparse_size(const struct sparse *s, int single)
{
    return s->room + (single ? (s->factor + 1) / 2 : s->factor);
}

/* Where the numbers of a factorisation are: A = L L^T, or L S L^T. */
struct memory {
    int single;       /* L is rounded */
    double *all;      /* [sparse_size()] */
    double *sign;     /* S, of all unknowns, or NULL */
};

/* Return front i, with its part of the memory. */
static struct front front_of(const struct sparse *s, int i, struct memory m)
{
    const struct sparse_front *f = &s->front[i];
    double *l = m.single ? &m.all[s->l] : &m.all[s->room + f->l];
    float *rounded = m.single ? (float *)&m.all[s->room] + f->l : NULL;
    return (struct front){2 * f->piece.count, 2 * f->rest, l, &m.all[f->u],
                          rounded, m.sign ? &m.sign[2 * f->piece.first] : NULL};
}

/* The part of front i in b := L^-1 b; or (back) in L^-T b. */
static void substitute_one(const struct sparse *s, int i, struct memory m,
                           int back, double b[])
{
    const struct sparse_front *f = &s->front[i];
    const struct front front = front_of(s, i, m);
    const int p = front.pivots, *place = &s->rest[f->at];
    const int rows = front_row(p, front_row(front.rest, 0));
    double *x = &m.all[s->vector], *rest = &x[front_row(p, 0)];
    double *pivot = &b[2 * f->piece.first];
    memset(x, 0, (size_t)rows * sizeof *x);
    memcpy(x, pivot, (size_t)p * sizeof *x);
    if (back) {
        for (int k = 0; k < f->rest; k++)
            memcpy(&rest[2 * k], &b[2 * place[k]], 2 * sizeof *b);
        front_backward(&front, x);
    } else {
        front_forward(&front, x);
        for (int k = 0; k < f->rest; k++) {
            b[2 * place[k]] += rest[2 * k]; /* -L_rest x: rest was 0 */
            b[2 * place[k] + 1] += rest[2 * k + 1];
        }
    }
    memcpy(pivot, x, (size_t)p * sizeof *x);
}

/* b := L^-1 b, by all fronts; or (back) L^-T b. */
static void substitute(const struct sparse *s, struct memory m, int back,
                       double b[])
{
    const int n = s->order->n_piece;
    for (int i = 0; i < n; i++)
        substitute_one(s, back ? n - 1 - i : i, m, back, b);
}

/* Factor a; and, b not NULL, b := L^-1 b. */
static enum status factor(const struct sparse *s, const double a[],
                          struct memory m, double b[])
{
    double *diagonal = &m.all[s->vector];
    enum status status = OK;
    for (int i = 0; i < s->order->n_piece && status == OK; i++) {
        const struct piece *piece = &s->front[i].piece;
        const struct front front = front_of(s, i, m);
        const int *start = &s->start[piece->first];
        front_fill(&front, start[piece->count] - start[0], &s->local[start[0]],
                   &a[4 * start[0]]);
        for (int v = 0; v < piece->count; v++) {
            diagonal[2 * v] = a[4 * start[v]]; /* of A: the scale of a pivot */
            diagonal[2 * v + 1] = a[4 * start[v] + 3];
        }
        /* u of the children: to l, and to u once front_factor() has set it */
        for (int after = 0; after < 2; after++) {
            if (after)
                status = front_factor(&front, 2 * s->n_vertex, diagonal);
            for (int c = 0; c < 2; c++) {
                const int k = piece->child[c];
                if (k < 0) continue;
                const struct front child = front_of(s, k, m);
                front_extend(&child, &s->up[s->front[k].at], &front, after);
            }
        }
        if (b && status == OK) substitute_one(s, i, m, 0, b);
    }
    return status;
}

enum status sparse_factor(const struct sparse *s, const double a[], int single,
                          double memory[], double b[])
{
    const struct memory m = {single, memory, NULL};
    const enum status status = factor(s, a, m, b);
    if (b && status == OK) substitute(s, m, 1, b);
    return status;
}

/* y := A x, by every block and its mirror image; a block of the diagonal is
 * one. */
static void multiply(const struct sparse *s, const double a[],
                     const double x[], double y[])
{
    memset(y, 0, 2 * (size_t)s->n_vertex * sizeof *y);
    for (int j = 0; j < s->n_vertex; j++) {
        const double *x_j = &x[2 * j], *a_jj = &a[4 * s->start[j]];
        y[2 * j] += a_jj[0] * x_j[0] + a_jj[1] * x_j[1];
        y[2 * j + 1] += a_jj[1] * x_j[0] + a_jj[3] * x_j[1];
        for (int b = s->start[j] + 1; b < s->start[j + 1]; b++) {
            const double *a_b = &a[4 * b], *x_i = &x[2 * s->row[b]];
            double *y_i = &y[2 * s->row[b]];
            y_i[0] += a_b[0] * x_j[0] + a_b[2] * x_j[1]; /* A_ij x_j */
            y_i[1] += a_b[1] * x_j[0] + a_b[3] * x_j[1];
            y[2 * j] += a_b[0] * x_i[0] + a_b[1] * x_i[1]; /* A_ij^T x_i */
            y[2 * j + 1] += a_b[2] * x_i[0] + a_b[3] * x_i[1];
        }
    }
}

static double max_diagonal(const struct sparse *s, const double a[])
{
    double largest = 0.0;
    for (int v = 0; v < s->n_vertex; v++) {
        const double *a_vv = &a[4 * s->start[v]];
        if (a_vv[0] > largest) largest = a_vv[0];
        if (a_vv[3] > largest) largest = a_vv[3];
    }
    return largest;
}

/* b := A^-1 b. */
static void solve(const struct sparse *s, struct memory m, double b[])
{
    substitute(s, m, 0, b); /* L S L^T x = b: S^-1 = S */
    if (m.sign)
        for (int k = 0; k < 2 * s->n_vertex; k++) b[k] *= m.sign[k];
    substitute(s, m, 1, b);
}

void sparse_solve(const struct sparse *s, int single, double memory[],
                  double b[])
{
    solve(s, (struct memory){single, memory, NULL}, b);
}

/* Solve as matrix_solve_indefinite(), for the blocks a: A = L S L^T, S a
 * diagonal of signs.  The memory is for L as it is. */
static enum status solve_indefinite(const struct sparse *s, const double a[],
                                    double memory[], double b[], int *negative)
{
    const size_t n = 2 * (size_t)s->n_vertex;
    double *sign = allocate(n, sizeof *sign);
    double *x = allocate(n, sizeof *x), *r = allocate(n, sizeof *r);
    int below = 0;
    const struct memory m = {0, memory, sign};
    const enum status status = factor(s, a, m, NULL);
    if (status == OK) {
        memcpy(x, b, n * sizeof *x);
        solve(s, m, x);
        /* without a search for pivots digits may be lost: once more */
        multiply(s, a, x, r);
        for (size_t k = 0; k < n; k++) r[k] = b[k] - r[k];
        solve(s, m, r);
        for (size_t k = 0; k < n; k++) b[k] = x[k] + r[k];
    }
    for (size_t k = 0; k < n; k++) below += sign[k] < 0.0; /* inertia of A */
    if (negative) *negative = below;
    free(sign);
    free(x);
    free(r);
    return status;
}

struct matrix *matrix_alloc_sparse(const struct sparse *s)
{
    static const struct matrix_sparse methods = {
        find_block,    multiply,     sparse_size,
        sparse_factor, sparse_solve, solve_indefinite,
        max_diagonal};
    return matrix_alloc_with(&methods, s, 2 * s->n_vertex,
                             4 * (size_t)s->start[s->n_vertex]);
}
