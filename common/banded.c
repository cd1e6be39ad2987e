/*
 * banded.c - see banded.h.
 *
 * Column j of L needs the columns k < j within the band: the textbook's three
 * loops read two numbers from memory for each multiplication.  Here a tile of
 * H rows and W columns is kept in registers while k runs: H + W numbers read,
 * H W multiplications done.
 *
 *              k ->      J
 *              . . . . . |\            panel: the W columns from J on
 *     J        y y y y y |t\           t   the tile, rows i..i+H-1
 *              . . . . . |tt\          y   W rows of L at the panel
 *     i        x x x x x |ttt          x   H rows of L at the tile
 *                x x x x |ttt
 *                    x x |ttt
 *
 * With next = stride - 1, entry (i, j) is a[i + j*next]; as next is a multiple
 * of 8, rows i..i+7 lie in the cache alike for every j.
 *
 * A vec is V numbers in one register, an extension of C that gcc and clang have
 * for any processor; to both of them it may alias the numbers.  Loops over vecs
 * are unrolled, with constants for bounds: otherwise t would not stay in
 * registers.  What is wanted 16 columns later is fetched from memory ahead of
 * time.
 */
#include "banded.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdint.h>

#if defined __AVX512F__
enum { V = 8 };
#elif defined __AVX__
enum { V = 4 };
#else
enum { V = 2 };
#endif
enum { W = V, Q = 3, H = Q * V };
typedef double vec __attribute__((vector_size(8 * V), aligned(8)));
typedef double two __attribute__((vector_size(16), aligned(8)));
#define VEC(x) (*(vec *)&(x)) /* the vec that begins with x */
#define TWO(x) (*(two *)&(x))
#define INLINE __attribute__((always_inline)) static inline
#ifdef __clang__ /* a loop left as it is costs time, it is no error */
#pragma clang diagnostic ignored "-Wpass-failed"
#define UNROLL _Pragma("clang loop unroll(full)")
#else
#define UNROLL _Pragma("GCC unroll 8")
#endif

size_t band_stride(int p)
{
    return (((size_t)p + 15) / 8 | 1) * 8 + 1;
}

/* t -= x y for n columns of L, next apart; of q vecs (a constant), down apart.
 */
INLINE void columns(const int q, int n, ptrdiff_t down, ptrdiff_t next,
                    const double *x, const double *y, vec t[W][Q])
{
    const uintptr_t ahead = 16 * sizeof *x * (uintptr_t)next;
    for (; n > 0; n--, x += next, y += next) {
        __builtin_prefetch((const void *)((uintptr_t)x + ahead));
        UNROLL for (int c = 0; c < W; c++)
            UNROLL for (int r = 0; r < q; r++)
                t[c][r] -= y[c] * VEC(x[r * down]);
    }
}

/* The columns of a band from k up to end. */
INLINE int subtract(const int q, int k, int end, int J, int i, ptrdiff_t next,
                    const double a[], vec t[W][Q])
{
    if (end > J) end = J;
    if (k >= end) return k;
    columns(q, end - k, V, next, &a[i + k * next], &a[J + k * next], t);
    return end;
}

/* For all columns before J.  In the first of them the lower vecs are zero. */
INLINE void subtract_all(const int q, int p, int J, int i, ptrdiff_t next,
                         const double a[], vec t[W][Q])
{
    int k = i > p ? i - p : 0;
    if (q > 1) k = subtract(1, k, i - p + V, J, i, next, a, t);
    if (q > 2) k = subtract(2, k, i - p + 2 * V, J, i, next, a, t);
    subtract(q, k, J, J, i, next, a, t);
}

/* Cholesky of the w columns of a tile at the diagonal, but for the factors
 * inverse[c] = 1 / L_cc.  For the tiles below it, l[c][b] = L_bc / L_cc.  A_cc
 * is diagonal[c * apart]. */
INLINE enum status eliminate(const int q, int n, int w, const double diagonal[],
                             ptrdiff_t apart, vec t[W][Q], vec l[W],
                             double inverse[W])
{
    UNROLL for (int c = 0; c < W; c++) {
        const double pivot = t[c][0][c];
        vec s[Q];
        if (c >= w) break;
        if (!(pivot > n * DBL_EPSILON * diagonal[c * apart])) return NOT_SPD;
        inverse[c] = 1.0 / sqrt(pivot);
        UNROLL for (int r = 0; r < q; r++) s[r] = t[c][r] * (1.0 / pivot);
        l[c] = s[0];
        UNROLL for (int b = c + 1; b < W; b++)
            UNROLL for (int r = 0; r < q; r++) t[b][r] -= t[c][0][b] * s[r];
    }
    return OK;
}

/* The same columns of a tile below. */
INLINE void substitute(const int q, const vec l[W], vec t[W][Q])
{
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int b = c + 1; b < W; b++)
            UNROLL for (int r = 0; r < q; r++) t[b][r] -= l[c][b] * t[c][r];
}

/* The tile at the diagonal of a band, of w columns: a := L. */
static enum status first_tile(int n, int p, int J, int w, ptrdiff_t next,
                              double a[], vec l[W], double inverse[W])
{
    double *corner = &a[J + J * next];
    vec t[W][Q] = {{{0.0}}};
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < Q; r++)
            if (c < w) t[c][r] = VEC(corner[c * next + r * V]);
    subtract_all(Q, p, J, J, next, a, t);
    if (eliminate(Q, n, w, corner, next + 1, t, l, inverse) != OK)
        return NOT_SPD;
    UNROLL for (int c = 0; c < W; c++) {
        for (int r = 0; r < c; r++) t[c][0][r] = 0.0; /* another's room */
        UNROLL for (int r = 0; r < Q; r++)
            if (c < w) VEC(corner[c * next + r * V]) = t[c][r] * inverse[c];
    }
    return OK;
}

/* A tile below it, of q vecs a column: what sticks out of the band is zero. */
INLINE void lower_tile(const int q, int p, int J, int i, ptrdiff_t next,
                       double a[], const vec l[W], const double inverse[W])
{
    double *corner = &a[i + J * next];
    vec t[W][Q];
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            t[c][r] = VEC(corner[c * next + r * V]);
    subtract_all(q, p, J, i, next, a, t);
    substitute(q, l, t);
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            VEC(corner[c * next + r * V]) = t[c][r] * inverse[c];
}

enum status band_factor(int n, int p, size_t stride, double a[])
{
    const ptrdiff_t next = (ptrdiff_t)stride - 1;
    vec l[W] = {{0.0}};
    double inverse[W] = {0.0};

    assert(p >= BAND_WIDE && stride >= band_stride(p));
    for (int J = 0; J < n; J += W) {
        const int w = n - J < W ? n - J : W;
        const int rows = n - J < w + p ? n : J + w + p;
        if (first_tile(n, p, J, w, next, a, l, inverse) != OK) return NOT_SPD;
        for (int i = J + H; i < rows; i += H)
            if (rows - i <= V)
                lower_tile(1, p, J, i, next, a, l, inverse);
            else if (rows - i <= 2 * V)
                lower_tile(2, p, J, i, next, a, l, inverse);
            else
                lower_tile(Q, p, J, i, next, a, l, inverse);
    }
    return OK;
}

/* By panels as well: the triangle at the diagonal, then vecs of rows below. */
void band_solve(int n, int p, size_t stride, const double l[], double b[])
{
    const ptrdiff_t next = (ptrdiff_t)stride - 1;
    const int height = (p + V - 1) / V * V; /* L is zero beyond p */
    for (int J = 0; J < n; J += W) {
        const int below = n - J < W ? n : J + W;
        const int end = n - below < height ? n : below + height;
        for (int j = J; j < below; j++) {
            const double inverse = 1.0 / l[j + j * next];
            for (int k = J; k < j; k++) b[j] -= l[j + k * next] * b[k];
            b[j] *= inverse;
        }
        int i = below;
        for (; i + V <= end; i += V) {
            vec t = VEC(b[i]);
            UNROLL for (int c = 0; c < W; c++)
                t -= VEC(l[i + (J + c) * next]) * b[J + c];
            VEC(b[i]) = t;
        }
        for (; i < end; i++)
            for (int j = J; j < below; j++) b[i] -= l[i + j * next] * b[j];
    }
    for (int J = (n - 1) / W * W; J >= 0; J -= W) {
        const int below = n - J < W ? n : J + W;
        const int end = n - below < height ? n : below + height;
        vec sum[W] = {{0.0}};
        int i = below;
        for (; i + V <= end; i += V)
            UNROLL for (int c = 0; c < W; c++)
                sum[c] += VEC(l[i + (J + c) * next]) * VEC(b[i]);
        for (; i < end; i++)
            UNROLL for (int c = 0; c < W; c++)
                sum[c][0] += l[i + (J + c) * next] * b[i];
        for (int j = below - 1; j >= J; j--) {
            const double inverse = 1.0 / l[j + j * next];
            for (int r = 0; r < V; r++) b[j] -= sum[j - J][r];
            for (int k = below - 1; k > j; k--) b[j] -= l[k + j * next] * b[k];
            b[j] *= inverse;
        }
    }
}

/* ---- fronts ------------------------------------------------------------- */

static int blocks(int n)
{
    return (n + V - 1) / V;
}

static int at_most(int a, int b)
{
    return a < b ? a : b;
}

/* Where panel K begins, when all before it are whole, in a triangle of `all`
 * blocks. */
INLINE ptrdiff_t panel(ptrdiff_t K, ptrdiff_t all)
{
    return V * V * (K * all - K * (K - 1) / 2);
}

int front_row(int pivots, int k)
{
    return blocks(pivots) * V + k;
}

size_t front_size(int pivots, int rest)
{
    const int K = pivots / V, all = blocks(pivots) + blocks(rest);
    return (size_t)(panel(K, all) + V * (all - K) * (pivots % V));
}

/* Column j of a front: row i is column[i / V * *down + i % V]. */
INLINE double *front_column(const struct front *f, int j, ptrdiff_t *down)
{
    const int first = blocks(f->pivots), rest = blocks(f->rest);
    ptrdiff_t K = j / V;
    if (K >= first) { /* rows count from 0, in the rest they do from first */
        *down = V * V;
        K -= first;
        return &f->u[panel(K, rest) - (K + first) * V * V + j % V * V];
    }
    *down = V * at_most(V, f->pivots - (int)K * V);
    return &f->l[panel(K, first + rest) - K * *down + j % V * V];
}

double *front_entry(const struct front *f, int i, int j)
{
    ptrdiff_t down;
    double *column = front_column(f, j, &down);
    return &column[i / V * down + i % V];
}

void front_extend(const struct front *child, const int row[],
                  const struct front *parent)
{
    const unsigned n = (unsigned)child->rest / 2;
    const int skip = front_row(child->pivots, 0);
    for (unsigned j = 0; j < n; j++) { /* two columns at a time */
        ptrdiff_t down, ignored;
        double *to = front_column(parent, row[j], &down);
        const double *from = front_column(child, skip + 2 * (int)j, &ignored);
        from += skip * V;
        for (unsigned i = j; i < n; i++) {
            const unsigned at = (unsigned)row[i];
            double *sum = &to[at / V * down + at % V];
            const double *add = &from[2 * i / V * V * V + 2 * i % V];
            TWO(sum[0]) += TWO(add[0]);
            TWO(sum[V]) += TWO(add[V]);
        }
    }
}

/* t -= the columns of L before pivot J, for rows of block i and block y. */
INLINE void subtract_panels(const int q, const struct front *f, int J, int i,
                            int y, vec t[W][Q])
{
    const int all = blocks(f->pivots) + blocks(f->rest);
    for (int K = 0; K * V < J; K++) {
        const int w = at_most(V, J - K * V);
        const double *first = &f->l[panel(K, all)];
        columns(q, w, V * w, V, first + (i - K) * V * w,
                first + (y - K) * V * w, t);
    }
}

/* Tile of q blocks from block i on: of the pivots of panel K, or (l == NULL) of
 * panel K of the rest, which is updated only. */
INLINE enum status front_tile(const int q, const struct front *f, int n, int K,
                              int i, const double diagonal[], vec l[W],
                              double inverse[W])
{
    const int first = blocks(f->pivots), all = first + blocks(f->rest);
    const int w = K < first ? at_most(W, f->pivots - K * W) : W;
    double *corner = K < first ? &f->l[panel(K, all) + (i - K) * V * w]
                               : &f->u[panel(K - first, all - first) +
                                       (i - K) * V * w];
    vec t[W][Q] = {{{0.0}}};
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w && (K < first || !f->fresh))
                t[c][r] = VEC(corner[c * V + r * V * w]);
    subtract_panels(q, f, at_most(K * W, f->pivots), i, K, t);
    if (K < first && i == K) {
        if (eliminate(q, n, w, &diagonal[K * W], 1, t, l, inverse) != OK)
            return NOT_SPD;
    } else if (K < first) {
        substitute(q, l, t);
    }
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w)
                VEC(corner[c * V + r * V * w]) =
                    K < first ? t[c][r] * inverse[c] : t[c][r];
    return OK;
}

enum status front_factor(const struct front *f, int n, const double diagonal[])
{
    const int all = blocks(f->pivots) + blocks(f->rest);
    vec l[W] = {{0.0}};
    double inverse[W] = {0.0};
    enum status status = OK;
    for (int K = 0; K < all && status == OK; K++)
        for (int i = K; i < all && status == OK; i += Q)
            status = all - i == 1 ? front_tile(1, f, n, K, i, diagonal, l,
                                               inverse)
                   : all - i == 2 ? front_tile(2, f, n, K, i, diagonal, l,
                                               inverse)
                                  : front_tile(Q, f, n, K, i, diagonal, l,
                                               inverse);
    return status;
}

void front_forward(const struct front *f, double x[])
{
    const int all = blocks(f->pivots) + blocks(f->rest);
    const double *l = f->l;
    for (int J = 0; J < f->pivots; J += W) {
        const int w = at_most(W, f->pivots - J);
        double y[W] = {0.0};
        for (int c = 0; c < w; c++) {
            y[c] = x[J + c] / l[c * V + c];
            for (int i = c + 1; i < w; i++) x[J + i] -= l[c * V + i] * y[c];
            x[J + c] = y[c];
        }
        l += V * w;
        for (int i = J / V + 1; i < all; i++, l += V * w) {
            vec t = VEC(x[i * V]);
            if (w == W)
                UNROLL for (int c = 0; c < W; c++) t -= VEC(l[c * V]) * y[c];
            else
                for (int c = 0; c < w; c++) t -= VEC(l[c * V]) * y[c];
            VEC(x[i * V]) = t;
        }
    }
}

void front_backward(const struct front *f, double x[])
{
    const int all = blocks(f->pivots) + blocks(f->rest);
    for (int K = blocks(f->pivots) - 1; K >= 0; K--) {
        const int w = at_most(W, f->pivots - K * W);
        const double *triangle = &f->l[panel(K, all)], *l = triangle + V * w;
        double *y = &x[K * V];
        vec sum[W] = {{0.0}};
        for (int i = K + 1; i < all; i++, l += V * w)
            if (w == W)
                UNROLL for (int c = 0; c < W; c++)
                    sum[c] += VEC(l[c * V]) * VEC(x[i * V]);
            else
                for (int c = 0; c < w; c++)
                    sum[c] += VEC(l[c * V]) * VEC(x[i * V]);
        for (int c = w - 1; c >= 0; c--) {
            for (int r = 0; r < V; r++) y[c] -= sum[c][r];
            for (int i = c + 1; i < w; i++) y[c] -= triangle[c * V + i] * y[i];
            y[c] /= triangle[c * V + c];
        }
    }
}
