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
 * H is Q V and W is V, the numbers in a register, vec.h.
 */
#include "linear/tiles.h"

#include <assert.h>
#include <float.h>
#include <math.h>

size_t tiles_stride(int p)
{
    return (((size_t)p + 15) / 8 | 1) * 8 + 1;
}

/* Return the columns of a band from k up to end.  This function and those below
 * have up to ten parameters: in a struct the tile t would not stay in
 * registers. */
INLINE int subtract(const int q, int k, int end, int J, int i, ptrdiff_t next,
                    const double a[], vec t[W][Q])
{
    if (end > J) end = J;
    if (k >= end) return k;
    vec_columns(q, end - k, V, next, &a[i + k * next], &a[J + k * next], t);
    return end;
}

/* Subtract all columns before J.  In the first of them the lower vecs are
 * zero. */
INLINE void subtract_all(const int q, int p, int J, int i, ptrdiff_t next,
                         const double a[], vec t[W][Q])
{
    int k = i > p ? i - p : 0;
    if (q > 1) k = subtract(1, k, i - p + V, J, i, next, a, t);
    if (q > 2) k = subtract(2, k, i - p + 2 * V, J, i, next, a, t);
    subtract(q, k, J, J, i, next, a, t);
}

enum status tiles_triangle(int n, int w, const double diagonal[],
                           ptrdiff_t apart, double sign[], vec t[W], vec l[W],
                           double inverse[W])
{
    UNROLL for (int c = 0; c < W; c++) {
        const double pivot = t[c][c];
        double s = 1.0, above = c < w ? diagonal[c * apart] : 0.0;
        if (c >= w) break;
        if (sign) s = sign[c] = pivot < 0.0 ? -1.0 : 1.0, above = fabs(above);
        if (!(s * pivot > n * DBL_EPSILON * above)) return NOT_SPD;
        inverse[c] = s / sqrt(s * pivot); /* S_c / L_cc, pivot = S_c L_cc^2 */
        l[c] = t[c] * (1.0 / pivot); /* now t_ib -= t_bc l_ic for b > c */
        UNROLL for (int b = c + 1; b < W; b++) t[b] -= t[c][b] * l[c];
    }
    return OK;
}

/* Factor rows i .. i + q V - 1 of a panel of w columns: a := L.  At the
 * diagonal i is J.  What sticks out of the band is zero. */
INLINE enum status tile(const int q, int n, int p, int J, int i, int w,
                        ptrdiff_t next, double a[], vec l[W],
                        double inverse[W])
{
    double *corner = &a[i + J * next];
    vec t[W][Q] = {{{0.0}}};
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w) t[c][r] = VEC(corner[c * next + r * V]);
    subtract_all(q, p, J, i, next, a, t); /* - sum_k<J L_ik L_jk */
    if (i > J) {
        vec_substitute(q, l, t);
    } else {
        vec first[W];
        UNROLL for (int c = 0; c < W; c++) first[c] = t[c][0];
        if (tiles_triangle(n, w, corner, next + 1, NULL, first, l, inverse) !=
            OK)
            return NOT_SPD;
        vec_substitute(q, l, t); /* and then the first again */
        UNROLL for (int c = 0; c < W; c++) {
            for (int r = 0; r < c; r++) first[c][r] = 0.0; /* another's room */
            t[c][0] = first[c];
        }
    }
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w) VEC(corner[c * next + r * V]) = t[c][r] * inverse[c];
    return OK;
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
        enum status status = OK;
        for (int i = J; i < rows && status == OK; i += H)
            status =
                rows - i <= V ? tile(1, n, p, J, i, w, next, a, l, inverse)
                : rows - i <= 2 * V
                    ? tile(2, n, p, J, i, w, next, a, l, inverse)
                    : tile(Q, n, p, J, i, w, next, a, l, inverse);
        if (status != OK) return status;
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
                t -= VEC(l[i + (J + c) * next]) * b[J + c]; /* L y = b */
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
                sum[c] += VEC(l[i + (J + c) * next]) * VEC(b[i]); /* L^T x */
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
