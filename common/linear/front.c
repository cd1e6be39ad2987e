/* front.c - see front.h. */
#include "linear/front.h"

#include "linear/tiles.h"

#include <string.h>

/* Bytes that come from memory at once; numbers that are fetched ahead. */
enum { LINE = 64, AHEAD = 1024 };

/* Panels whose tiles take turns, and how many panels those subtract in one
 * turn: what they read stays in the nearest cache. */
enum { GROUP = 32 / V, TURN = 64 / V };

static int blocks(int n)
{
    return (n + V - 1) / V;
}

/* Return where panel K begins, when all before it are whole, in a triangle of
 * `all` blocks. */
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
    const int first = blocks(f->pivots), rest = blocks(f->rest), K = j / V;
    const int left = f->pivots - K * V;
    *down = V * (0 < left && left < V ? left : V);
    if (K < first) return &f->l[panel(K, first + rest) - K * *down + j % V * V];
    /* panels of u count from 0 */
    return &f->u[panel(K - first, rest) - K * *down + j % V * V];
}

int front_place(int pivots, int rest, int i, int j)
{
    const int K = j / V, w = pivots - K * V < V ? pivots - K * V : V;
    return (int)panel(K, blocks(pivots) + blocks(rest)) +
           (i / V - K) * V * w + j % V * V + i % V;
}

void front_fill(const struct front *f, int n, const int place[],
                const double block[])
{
    memset(f->l, 0, front_size(f->pivots, f->rest) * sizeof *f->l);
    for (int k = 0; k < n; k++, block += 4) {
        TWO(f->l[place[k]]) = TWO(block[0]); /* by columns, as the front */
        TWO(f->l[place[k] + V]) = TWO(block[2]);
    }
}

/* Add a 2x2 block of a child to rows `row` and row + 1 of two columns. */
INLINE void add_block(const double *add, double *target, ptrdiff_t down,
                      unsigned row)
{
    double *sum = &target[row / V * down + row % V];
    TWO(sum[0]) += TWO(add[0]);
    TWO(sum[V]) += TWO(add[V]);
}

void front_extend(const struct front *child, const int row[],
                  const struct front *parent, int after)
{
    const unsigned n = (unsigned)child->rest / 2;
    const int skip = front_row(child->pivots, 0);
    double *target[V / 2] = {NULL};
    ptrdiff_t down[V / 2] = {0}, of_child;
    unsigned J = 0, next, end = 0;
    while (end < n && row[end] < parent->pivots) end++;
    if (after) {
        J = end;
        end = n;
    }
    for (; J < end; J = next) { /* columns of one panel of the child */
        next = (2 * J / V + 1) * V / 2;
        if (next > end) next = end;
        for (unsigned j = J; j < next; j++)
            target[j - J] = front_column(parent, row[j], &down[j - J]);
        const double *column =
            front_column(child, skip + 2 * (int)J, &of_child);
        column += skip * V;
        for (unsigned i = J; i < n; i++) { /* one index: of a row of panels */
            const unsigned place = (unsigned)row[i];
            /* two of the V rows of a panel: row 2 i is in number 2 i / V */
            const double *add = &column[2 * i / V * V * V + 2 * i % V];
            /* nearly always the whole panel: with a constant for bound */
            const unsigned columns = (i < next ? i + 1 : next) - J;
            if (columns == V / 2)
                UNROLL for (unsigned c = 0; c < V / 2; c++)
                    add_block(add + 2 * V * c, target[c], down[c], place);
            else
                for (unsigned c = 0; c < columns; c++)
                    add_block(add + 2 * V * c, target[c], down[c], place);
        }
    }
}

/* Return S y, of the w columns of a block at y. */
static const double *signed_block(int w, const double sign[], const double y[],
                                  double result[W * V])
{
    for (int c = 0; c < w; c++) VEC(result[c * V]) = sign[c] * VEC(y[c * V]);
    return result;
}

/* t -= the columns of L in panels `begin` to `stop` - 1, for rows of block i
 * and block y. */
INLINE void subtract_panels(const int q, const struct front *f, int all,
                            int begin, int stop, int i, int y, vec t[W][Q])
{
    const double *l = f->l + panel(begin, all);
    for (int K = begin; K < stop; K++) {
        const int w = f->pivots - K * V < V ? f->pivots - K * V : V;
        const double *block = l + (y - K) * V * w;
        double room[W * V];
        if (f->sign) block = signed_block(w, &f->sign[K * V], block, room);
        vec_columns(q, w, V * w, V, l + (i - K) * V * w, block, t);
        l += (all - K) * V * w;
    }
}

/* A front that is being factored. */
struct work {
    const struct front *f;
    int n;                  /* order of the matrix */
    int first, all;         /* blocks of pivots, all blocks */
    const double *diagonal; /* of the matrix, at the pivots */
    vec l[W];               /* the triangle of the panel that is finished */
    double inverse[W];
};

/* Update the tile of q blocks from block i on, of panel K: subtract the columns
 * of panels `begin` to `stop` - 1; and, of pivots, finish it. */
INLINE enum status front_tile(const int q, const int finish, struct work *a,
                              int begin, int stop, int K, int i)
{
    const struct front *f = a->f;
    const int of_rest = K >= a->first, left = f->pivots - K * V;
    const int w = 0 < left && left < V ? left : V;
    double *corner = of_rest ? f->u + panel(K - a->first, a->all - a->first)
                             : f->l + panel(K, a->all);
    vec t[W][Q] = {{{0.0}}};
    corner += (i - K) * V * w;
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w && !(of_rest && begin == 0))
                t[c][r] = VEC(corner[c * V + r * V * w]);
    subtract_panels(q, f, a->all, begin, stop, i, K, t); /* - L_i S L_K^T */
    if (finish && i == K) {
        vec rows[W];
        UNROLL for (int c = 0; c < W; c++) rows[c] = t[c][0];
        if (tiles_triangle(a->n, w, &a->diagonal[K * W], 1,
                           f->sign ? &f->sign[K * W] : NULL, rows, a->l,
                           a->inverse) != OK)
            return NOT_SPD;
        UNROLL for (int c = 0; c < W; c++) /* L^-T for the triangle of L */
            UNROLL for (int r = 0; r < V; r++) t[c][0][r] = r == c;
    }
    if (finish) vec_substitute(q, a->l, t);
    UNROLL for (int c = 0; c < W; c++)
        UNROLL for (int r = 0; r < q; r++)
            if (c < w)
                VEC(corner[c * V + r * V * w]) =
                    finish ? t[c][r] * a->inverse[c] : t[c][r];
    if (f->sign && finish && i == K) /* L^-T S is there: L^-T */
        signed_block(w, &f->sign[K * W], corner, corner);
    return OK;
}

INLINE enum status any_tile(const int finish, struct work *a, int begin,
                            int stop, int K, int i)
{
    const int left = a->all - i;
    return left == 1 ? front_tile(1, finish, a, begin, stop, K, i)
         : left == 2 ? front_tile(2, finish, a, begin, stop, K, i)
                     : front_tile(Q, finish, a, begin, stop, K, i);
}

enum status front_factor(const struct front *f, int n, const double diagonal[])
{
    const int first = blocks(f->pivots), all = first + blocks(f->rest);
    const size_t size = f->rounded ? front_size(f->pivots, f->rest) : 0;
    struct work a = {f, n, first, all, diagonal, {{0.0}}, {0.0}};
    if (f->pivots == 0) /* nothing is subtracted */
        memset(f->u, 0, front_size(front_row(f->rest, 0), 0) * sizeof *f->u);
    for (int G = 0, end; G < all; G = end) { /* a group: panels G to end - 1 */
        const int before = G < first ? G : first;
        const int last = G < first ? first : all;
        end = G + GROUP < last ? G + GROUP : last;
        for (int begin = 0; begin < before; begin += TURN) {
            const int stop = begin + TURN < before ? begin + TURN : before;
            for (int down = 0; down < all - G; down += Q)
                for (int K = G; K < end && K + down < all; K++)
                    any_tile(0, &a, begin, stop, K, K + down);
        }
        for (int K = G; K < end && K < first; K++)
            for (int i = K; i < all; i += Q)
                if (any_tile(1, &a, G, K, K, i) != OK) return NOT_SPD;
    }
    for (size_t i = 0; i < size; i++) f->rounded[i] = (float)f->l[i];
    return OK;
}

/* Have the block that is wanted `ahead` numbers later fetched from
 * memory: what the processor fetches by itself ends with a page of 4 kB. */
INLINE void fetch(const int single, const struct front *f, ptrdiff_t l,
                  ptrdiff_t ahead)
{
    const uintptr_t begin = single ? (uintptr_t)f->rounded : (uintptr_t)f->l;
    const ptrdiff_t size = single ? sizeof *f->rounded : sizeof *f->l;
    UNROLL for (ptrdiff_t line = 0; line < V * W * size; line += LINE)
        __builtin_prefetch(
            (const void *)(begin + (uintptr_t)((l + ahead) * size + line)));
}

/* Return the kept numbers i .. i + V - 1. */
INLINE vec numbers(const int single, const struct front *f, ptrdiff_t i)
{
#define ROUNDED(i, r) f->rounded[(i) + (r)]
    return single ? VEC_OF(ROUNDED, i) : VEC(f->l[i]);
}

/* Of twice `half` vecs t the first half := the sums of lanes r and r + half,
 * where r has no bit `half`; where it has, of lanes r - half and r of the vec
 * that is `half` later.  With constants for lanes it is two shuffles and a sum,
 * so it is a macro. */
#define LOWER(half, r) ((r) & (half) ? b : a)[(r) & ~(half)]
#define UPPER(half, r) ((r) & (half) ? b : a)[(r) | (half)]
#define FOLD(half, t) \
    UNROLL for (int c = 0; c < half; c++) { \
        const vec a = t[c], b = t[c + half]; \
        t[c] = VEC_OF(LOWER, half) + VEC_OF(UPPER, half); \
    }

/* y[c] := the sum of all numbers of t[c]. */
INLINE void add_up(vec t[W], double y[W])
{
#if VEC_WIDTH > 4
    FOLD(4, t)
#endif
#if VEC_WIDTH > 2
    FOLD(2, t)
#endif
    FOLD(1, t)
    VEC(y[0]) = t[0];
}

INLINE void forward(const int single, const struct front *f, double x[])
{
    const int all = blocks(f->pivots) + blocks(f->rest);
    const vec none = {0.0};
    ptrdiff_t l = 0;
    for (int J = 0; J < f->pivots; J += W) {
        const int w = f->pivots - J < W ? f->pivots - J : W;
        double *y = &x[J];
        vec part[W];
        UNROLL for (int c = 0; c < W; c++)
            part[c] = c < w ? numbers(single, f, l + c * V) * VEC(x[J]) : none;
        /* y = L_JJ^-1 x_J: the triangle is kept as L^-T */
        add_up(part, y);
        l += V * w;
        for (int i = J / V + 1; i < all; i++, l += V * w) {
            vec t = VEC(x[i * V]);
            fetch(single, f, l, AHEAD);
            if (w == W) /* x_i -= L_iJ y */
                UNROLL for (int c = 0; c < W; c++)
                    t -= numbers(single, f, l + c * V) * y[c];
            else
                UNROLL for (int c = 0; c < W; c++)
                    if (c < w) t -= numbers(single, f, l + c * V) * y[c];
            VEC(x[i * V]) = t;
        }
    }
}

/* Substitute from the end of the kept numbers to their beginning. */
INLINE void backward(const int single, const struct front *f, double x[])
{
    const int all = blocks(f->pivots) + blocks(f->rest);
    const vec none = {0.0};
    ptrdiff_t l = (ptrdiff_t)front_size(f->pivots, f->rest);
    for (int K = blocks(f->pivots) - 1; K >= 0; K--) {
        const int w = f->pivots - K * W < W ? f->pivots - K * W : W;
        double y[W];
        vec part[W], t = none;
        UNROLL for (int c = 0; c < W; c++) part[c] = none;
        for (int i = all - 1; i > K; i--) {
            l -= V * w;
            fetch(single, f, l, -AHEAD);
            if (w == W) /* y = sum_i L_iK^T x_i */
                UNROLL for (int c = 0; c < W; c++)
                    part[c] += numbers(single, f, l + c * V) * VEC(x[i * V]);
            else
                UNROLL for (int c = 0; c < W; c++)
                    if (c < w)
                        part[c] +=
                            numbers(single, f, l + c * V) * VEC(x[i * V]);
        }
        add_up(part, y);
        l -= V * w;
        for (int c = w - 1; c >= 0; c--) /* L_KK^-T (x_K - y) */
            t += numbers(single, f, l + c * V) * (x[K * V + c] - y[c]);
        VEC(x[K * V]) = t;
    }
}

void front_forward(const struct front *f, double x[])
{
    if (f->rounded) forward(1, f, x);
    else forward(0, f, x);
}

void front_backward(const struct front *f, double x[])
{
    if (f->rounded) backward(1, f, x);
    else backward(0, f, x);
}
