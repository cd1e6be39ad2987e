/*
 * vec.h - V numbers in one register, and what tiles.c and front.c both do with
 * a tile of them.
 *
 * A vec is an extension of C that gcc and clang have for any processor; to both
 * of them it may alias the numbers.  Loops over vecs are unrolled, with
 * constants for bounds: otherwise they would not stay in registers.  V is what
 * the registers hold, or VEC_WIDTH, 2, 4 or 8, for any processor.
 */
#ifndef COMMON_VEC_H
#define COMMON_VEC_H

#include <stddef.h>
#include <stdint.h>

#ifndef VEC_WIDTH
#if defined __AVX512F__
#define VEC_WIDTH 8
#elif defined __AVX__
#define VEC_WIDTH 4
#else
#define VEC_WIDTH 2
#endif
#endif
/* The vec of f(x, 0), f(x, 1), ... */
#if VEC_WIDTH == 8
#define VEC_OF(f, x) \
    (vec){f(x, 0), f(x, 1), f(x, 2), f(x, 3), \
          f(x, 4), f(x, 5), f(x, 6), f(x, 7)}
#elif VEC_WIDTH == 4
#define VEC_OF(f, x) (vec){f(x, 0), f(x, 1), f(x, 2), f(x, 3)}
#else
#define VEC_OF(f, x) (vec){f(x, 0), f(x, 1)}
#endif
enum { V = VEC_WIDTH };
enum { W = V, Q = 3, H = Q * V }; /* of a tile: columns, vecs, rows */
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

/* t -= x y for n columns of L, next apart; of q vecs (a constant), down apart.
 * Numbers 16 columns later are fetched from memory ahead of time. */
INLINE void vec_columns(const int q, int n, ptrdiff_t down, ptrdiff_t next,
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

/* t := t L^-T, but for the factors 1 / L_cc, with l of tiles_triangle(). */
INLINE void vec_substitute(const int q, const vec l[W], vec t[W][Q])
{
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int b = c + 1; b < W; b++)
            UNROLL for (int r = 0; r < q; r++) t[b][r] -= l[c][b] * t[c][r];
}

#endif
