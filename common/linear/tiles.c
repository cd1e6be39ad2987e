/*
 * tiles.c - see tiles.h.
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
 * H is Q V and W is V, the numbers in a register, vec.h.  What is wanted 16
 * columns later is fetched from memory ahead of time.
 */
#include "linear/tiles.h"

#include "linear/vec.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdint.h>

size_t tiles_stride(int p)
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

/* The columns of a band from k up to end.  This function and those below have
 * up to eleven parameters: in a struct the tile t would not stay in registers.
 */
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

enum status tiles_factor(int n, int p, size_t stride, double a[])
{
    const ptrdiff_t next = (ptrdiff_t)stride - 1;
    vec l[W] = {{0.0}};
    double inverse[W] = {0.0};

    assert(p >= TILES_WIDE && stride >= tiles_stride(p));
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
void tiles_solve(int n, int p, size_t stride, const double l[], double b[])
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

/* t -= the columns of L before pivot J, for rows of block i and block y. */
INLINE void subtract_panels(const int q, const struct front *f, int all, int J,
                            int i, int y, vec t[W][Q])
{
    const double *l = f->l;
    for (int K = 0; K * V < J; K++) {
        const int w = J - K * V < V ? J - K * V : V;
        columns(q, w, V * w, V, l + (i - K) * V * w, l + (y - K) * V * w, t);
        l += (all - K) * V * w;
    }
}

/* Tile of q blocks from block i on, of `all`, of panel K, which has w columns
 * and begins at a: of pivots, or of the rest. */
INLINE enum status front_tile(const int q, const struct front *f, int all,
                              int n, int K, int w, int i, double a[],
                              const double diagonal[], vec l[W],
                              double inverse[W])
{
    const int of_rest = K * V >= f->pivots;
    double *corner = a + (i - K) * V * w;
    vec t[W][Q] = {{{0.0}}};
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w && !of_rest) t[c][r] = VEC(corner[c * V + r * V * w]);
    subtract_panels(q, f, all, of_rest ? f->pivots : K * V, i, K, t);
    if (!of_rest && i == K) {
        if (eliminate(q, n, w, &diagonal[K * W], 1, t, l, inverse) != OK)
            return NOT_SPD;
        UNROLL for (int c = 0; c < W; c++) /* L^-T for the triangle of L */
            UNROLL for (int r = 0; r < V; r++) t[c][0][r] = r == c;
        substitute(1, l, t);
    } else if (!of_rest) {
        substitute(q, l, t);
    }
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w)
                VEC(corner[c * V + r * V * w]) =
                    of_rest ? t[c][r] : t[c][r] * inverse[c];
    return OK;
}

enum status tiles_front(const struct front *f, int n, const double diagonal[])
{
    const int first = front_row(f->pivots, 0) / V;
    const int all = first + front_row(f->rest, 0) / V;
    const size_t size = f->rounded ? front_size(f->pivots, f->rest) : 0;
    double *a = f->l, inverse[W] = {0.0};
    vec l[W] = {{0.0}};
    assert(front_row(1, 0) == V); /* front.c was compiled with other flags */
    for (int K = 0; K < all; K++) {
        const int left = f->pivots - K * V;
        const int w = 0 < left && left < V ? left : V;
        enum status status = OK;
        if (K == first) a = f->u;
        for (int i = K; i < all && status == OK; i += Q)
            status = all - i == 1 ? front_tile(1, f, all, n, K, w, i, a,
                                               diagonal, l, inverse)
                   : all - i == 2 ? front_tile(2, f, all, n, K, w, i, a,
                                               diagonal, l, inverse)
                                  : front_tile(Q, f, all, n, K, w, i, a,
                                               diagonal, l, inverse);
        if (status != OK) return status;
        a += (all - K) * V * w;
    }
    for (size_t i = 0; i < size; i++) f->rounded[i] = (float)f->l[i];
    return OK;
}
