/*
 * vec.h - V numbers in one register, for tiles.c and front.c.
 *
 * A vec is an extension of C that gcc and clang have for any processor; to both
 * of them it may alias the numbers.  Loops over vecs are unrolled, with
 * constants for bounds: otherwise they would not stay in registers.  V is what
 * the registers hold, or VEC_WIDTH, 2, 4 or 8, for any processor.
 */
#ifndef COMMON_VEC_H
#define COMMON_VEC_H

#ifndef VEC_WIDTH
#if defined __AVX512F__
#define VEC_WIDTH 8
#elif defined __AVX__
#define VEC_WIDTH 4
#else
#define VEC_WIDTH 2
#endif
#endif
#if VEC_WIDTH == 8
#define VEC_OF(x) \
    (vec){(x)[0], (x)[1], (x)[2], (x)[3], (x)[4], (x)[5], (x)[6], (x)[7]}
#elif VEC_WIDTH == 4
#define VEC_OF(x) (vec){(x)[0], (x)[1], (x)[2], (x)[3]}
#else
#define VEC_OF(x) (vec){(x)[0], (x)[1]}
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

#endif
