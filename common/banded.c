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
 *
 * L is zero left of the x and the zeros behind each column stand for it.  The
 * compiler turns the plain loops into vector instructions: loops over r have a
 * constant length, and those over c are unrolled to keep t in registers.
 */
#include "banded.h"

#include <assert.h>
#include <float.h>
#include <math.h>

enum { W = 8, H = 24 };

size_t band_stride(int p)
{
    return (((size_t)p + H + W - 1 + 7) / 8 | 1) * 8;
}

/* t -= x y for columns first <= k < J of L; h is 8, 16 or H, a constant. */
__attribute__((always_inline)) static inline void
subtract(const int h, int first, int J, int i, size_t stride, const double a[],
         double t[W][H])
{
    double sum[W][H] = {{0.0}};
    for (int k = first; k < J; k++) {
        const double *x = &a[(size_t)k * stride + (size_t)(i - k)];
        const double *y = &a[(size_t)k * stride + (size_t)(J - k)];
#pragma GCC unroll 8
        for (int c = 0; c < W; c++)
            for (int r = 0; r < h; r++) sum[c][r] += y[c] * x[r];
    }
#pragma GCC unroll 8
    for (int c = 0; c < W; c++)
        for (int r = 0; r < h; r++) t[c][r] -= sum[c][r];
}

/* The tile at the diagonal, of w columns: a := L; l, 1 / l_cc for the rest. */
static enum status first_tile(int n, int p, int J, int w, size_t stride,
                              double a[], double l[W][W], double inverse[W])
{
    const int end = p + 1 < H ? p + 1 : H; /* of the rows of column J */
    double t[W][H] = {{0.0}};
    for (int c = 0; c < w; c++)
        for (int r = c; r < H && r < end + c; r++)
            t[c][r] = a[(size_t)(J + c) * stride + (size_t)(r - c)];
    subtract(H, J > p ? J - p : 0, J, J, stride, a, t);
    for (int c = 0; c < w; c++) {
        double *column = &a[(size_t)(J + c) * stride];
        for (int b = 0; b < c; b++) {
            l[c][b] = t[b][c];
            for (int r = 0; r < H; r++) t[c][r] -= l[c][b] * t[b][r];
        }
        if (!(t[c][c] > n * DBL_EPSILON * column[0])) return NOT_SPD;
        inverse[c] = 1.0 / sqrt(t[c][c]);
        for (int r = 0; r < H; r++) t[c][r] *= inverse[c];
        for (int r = c; r < H && r < end + c; r++) column[r - c] = t[c][r];
    }
    return OK;
}

/* A tile below it, of h rows: what sticks out of the band is zero. */
__attribute__((always_inline)) static inline void
lower_tile(const int h, int p, int J, int i, size_t stride, double a[],
           double l[W][W], const double inverse[W])
{
    double *corner = &a[(size_t)J * stride + (size_t)(i - J)];
    const size_t next = stride - 1; /* from A[i][j] to A[i][j+1] */
    double t[W][H];
    for (int c = 0; c < W; c++)
        for (int r = 0; r < h; r++)
            t[c][r] = corner[(size_t)c * next + (size_t)r];
    subtract(h, i > p ? i - p : 0, J, i, stride, a, t);
#pragma GCC unroll 8
    for (int c = 0; c < W; c++) {
#pragma GCC unroll 8
        for (int b = 0; b < c; b++)
            for (int r = 0; r < h; r++) t[c][r] -= l[c][b] * t[b][r];
        for (int r = 0; r < h; r++) t[c][r] *= inverse[c];
    }
    for (int c = 0; c < W; c++)
        for (int r = 0; r < h; r++)
            corner[(size_t)c * next + (size_t)r] = t[c][r];
}

enum status band_factor(int n, int p, size_t stride, double a[])
{
    double l[W][W] = {{0.0}}, inverse[W] = {0.0}; /* L at the panel */

    assert(p >= BAND_WIDE && stride >= band_stride(p));
    for (int J = 0; J < n; J += W) {
        const int w = n - J < W ? n - J : W;
        const int rows = n - J < w + p ? n : J + w + p;
        if (first_tile(n, p, J, w, stride, a, l, inverse) != OK) return NOT_SPD;
        for (int i = J + H; i < rows; i += H)
            if (rows - i <= 8)
                lower_tile(8, p, J, i, stride, a, l, inverse);
            else if (rows - i <= 16)
                lower_tile(16, p, J, i, stride, a, l, inverse);
            else
                lower_tile(H, p, J, i, stride, a, l, inverse);
    }
    return OK;
}

void band_solve(int n, int p, size_t stride, const double l[], double b[])
{
    for (int j = 0; j < n; j++) {
        const double *column = &l[(size_t)j * stride];
        const int last = n - 1 - j < p ? n - 1 - j : p;
        const double b_j = b[j] /= column[0];
        for (int d = 1; d <= last; d++) b[j + d] -= column[d] * b_j;
    }
    for (int j = n - 1; j >= 0; j--) {
        const double *column = &l[(size_t)j * stride];
        const int last = n - 1 - j < p ? n - 1 - j : p;
        double sum[8] = {0.0}; /* eight at a time, which the sum allows */
        int d = 1;
        for (; d + 7 <= last; d += 8)
            for (int r = 0; r < 8; r++) sum[r] += column[d + r] * b[j + d + r];
        for (; d <= last; d++) sum[0] += column[d] * b[j + d];
        for (int r = 0; r < 8; r++) b[j] -= sum[r];
        b[j] /= column[0];
    }
}
