/* matrix.c - see matrix.h.  dense.h factors what is full, banded.h narrow
 * bands, tiles.h wide ones, indefinite.h the rest; a sparse matrix brings
 * its own functions (struct matrix_sparse). */
#define _DEFAULT_SOURCE /* madvise */
#include "linear/matrix.h"

#include "base/table.h"
#include "linear/banded.h"
#include "linear/dense.h"
#include "linear/indefinite.h"
#include "linear/tiles.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

/* Bytes of a line of the cache and of a large page; and how many numbers,
 * 16 MB, are worth large pages. */
enum { LINE = 64, LARGE_PAGE = 1 << 21, MANY = 1 << 21 };

/* Return where entry (i, j) lives, NULL outside of a sparse pattern; banded and
 * sparse storage hold i >= j only. */
static double *entry(const struct matrix *A, int i, int j)
{
    if (A->storage == SPARSE) {
        const int block = A->sparse->block(A->pattern, i / 2, j / 2);
        return block < 0 ? NULL : &A->a[4 * block + j % 2 * 2 + i % 2];
    }
    if (A->storage == DENSE) return &A->a[(size_t)i * A->stride + (size_t)j];
    return &A->a[(size_t)j * A->stride + (size_t)(i - j)];
}

static int is_wide(const struct matrix *A) /* for tiles.h */
{
    return A->storage == BANDED && A->p >= TILES_WIDE;
}

/* Return n zeros that start at a line of the cache: see tiles.h.  Many of them
 * are in large pages, where the system has such: fewer addresses to look up. */
static double *allocate_lines(size_t n)
{
    const size_t page = n < MANY ? LINE : LARGE_PAGE;
    const size_t bytes = (n * sizeof(double) + page - 1) / page * page;
    double *a = n < SIZE_MAX / 16 ? aligned_alloc(page, bytes) : NULL;
    if (!a) die("out of memory: %zu numbers", n);
#ifdef MADV_HUGEPAGE
    if (page == LARGE_PAGE) (void)madvise(a, bytes, MADV_HUGEPAGE);
#endif
    return memset(a, 0, bytes);
}

struct matrix *matrix_alloc(enum storage storage, int n, int p)
{
    assert(n > 0 && storage != SPARSE);
    struct matrix *A = allocate(1, sizeof *A);
    A->storage = storage;
    A->n = n;
    A->p = storage == DENSE || p >= n ? n - 1 : p;
    A->stride = is_wide(A) ? tiles_stride(A->p) : (size_t)A->p + 1;
    A->size = (size_t)n * A->stride;
    A->a = allocate_lines(A->size);
    return A;
}

struct matrix *matrix_alloc_with(const struct matrix_sparse *methods,
                                 const struct sparse *pattern, int n,
                                 size_t size)
{
    struct matrix *A = allocate(1, sizeof *A);
    *A = (struct matrix){.storage = SPARSE, .n = n, .p = n - 1, .stride = 3,
                         .size = size, .a = allocate_lines(size),
                         .sparse = methods, .pattern = pattern};
    return A;
}

struct matrix *matrix_copy(const struct matrix *A)
{
    struct matrix *copy =
        A->storage == SPARSE
            ? matrix_alloc_with(A->sparse, A->pattern, A->n, A->size)
            : matrix_alloc(A->storage, A->n, A->p);
    memcpy(copy->a, A->a, A->size * sizeof *A->a);
    return copy;
}

struct matrix *matrix_block(const struct matrix *A, int first, int n)
{
    assert(0 <= first && first + n <= A->n);
    struct matrix *block = matrix_alloc(A->storage, n, A->p);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            if (abs(i - j) <= block->p)
                matrix_add(block, i, j, matrix_get(A, first + i, first + j));
    return block;
}

void matrix_free(struct matrix *A)
{
    if (!A) return;
    free(A->a);
    free(A->factor);
    free(A->room);
    free(A);
}

void matrix_zero(struct matrix *A)
{
    memset(A->a, 0, A->size * sizeof *A->a);
}

void matrix_add(struct matrix *A, int i, int j, double value)
{
    assert(0 <= i && i < A->n && 0 <= j && j < A->n && abs(i - j) <= A->p);
    if (A->storage != DENSE && i < j) return;
    double *A_ij = entry(A, i, j);
    assert(A_ij);
    *A_ij += value;
}

double matrix_get(const struct matrix *A, int i, int j)
{
    assert(0 <= i && i < A->n && 0 <= j && j < A->n);
    if (abs(i - j) > A->p) return 0.0;
    const double *A_ij = A->storage != DENSE && i < j ? entry(A, j, i)
                                                      : entry(A, i, j);
    return A_ij ? *A_ij : 0.0;
}

int matrix_place(const struct matrix *A, int i, int j)
{
    const double *A_ij = entry(A, i, j);
    assert(i >= j && A_ij && A_ij - A->a < INT_MAX);
    return (int)(A_ij - A->a);
}

static void set(struct matrix *A, int i, int j, double value)
{
    if (A->storage == DENSE || i >= j) *entry(A, i, j) = value;
}

void matrix_dirichlet(struct matrix *A, double b[], int n_fixed,
                      const int node[], const double value[],
                      enum diagonal diagonal)
{
    assert(A->storage != SPARSE);
    for (int f = 0; f < n_fixed; f++) {
        const int k = node[f];
        const int first = k - A->p > 0 ? k - A->p : 0;
        const int last = k + A->p < A->n - 1 ? k + A->p : A->n - 1;
        const double d = diagonal == KEEP_DIAGONAL ? matrix_get(A, k, k) : 1.0;

        for (int i = first; i <= last; i++) {
            b[i] -= matrix_get(A, i, k) * value[f];
            set(A, i, k, 0.0);
            set(A, k, i, 0.0);
        }
        set(A, k, k, d); /* the loop has zeroed A_kk and changed b_k */
        b[k] = d * value[f];
    }
}

void matrix_keep_single(struct matrix *A, int single)
{
    assert(A->storage == SPARSE);
    if (A->single != single) {
        free(A->factor);
        A->factor = NULL;
    }
    A->single = single;
}

static enum status factor_sparse(struct matrix *A, double b[])
{
    if (!A->factor)
        A->factor = allocate_lines(A->sparse->size(A->pattern, A->single));
    return A->sparse->factor(A->pattern, A->a, A->single, A->factor, b);
}

enum status matrix_factor(struct matrix *A)
{
    if (A->storage == DENSE) return dense_factor(A->n, A->a);
    if (is_wide(A)) return tiles_factor(A->n, A->p, A->stride, A->a);
    if (A->storage != SPARSE) return banded_factor(A->n, A->p, A->a);
    return factor_sparse(A, NULL);
}

void matrix_solve(const struct matrix *L, double b[])
{
    if (L->storage == SPARSE)
        L->sparse->solve(L->pattern, L->single, L->factor, b);
    else if (L->storage == DENSE)
        dense_solve(L->n, L->a, b);
    else if (is_wide(L))
        tiles_solve(L->n, L->p, L->stride, L->a, b);
    else
        banded_solve(L->n, L->p, L->a, b);
}

enum status matrix_factor_solve(struct matrix *A, double b[])
{
    if (A->storage == SPARSE) return factor_sparse(A, b);
    const enum status status = matrix_factor(A);
    if (status == OK) matrix_solve(A, b);
    return status;
}

enum status matrix_solve_indefinite(struct matrix *A, double b[],
                                    int *negative)
{
    const int is_sparse = A->storage == SPARSE;
    assert(A->storage != DENSE);
    if (!A->room)
        A->room = allocate_lines(is_sparse ? A->sparse->size(A->pattern, 0)
                                           : (size_t)A->n * (size_t)(A->p + 1));
    return is_sparse
               ? A->sparse->solve_indefinite(A->pattern, A->a, A->room, b,
                                             negative)
               : indefinite_solve(A->n, A->p, A->stride, A->a, A->room, b,
                                  negative);
}

void matrix_combine(const struct matrix *A, double s, const struct matrix *B,
                    struct matrix *C)
{
    assert(A->storage == B->storage && A->n == B->n && A->p == B->p);
    assert(A->storage == C->storage && A->n == C->n && A->p == C->p);
    assert(A->pattern == B->pattern && A->pattern == C->pattern);
    for (size_t i = 0; i < A->size; i++)
        C->a[i] = A->a[i] + s * B->a[i];
}

enum status matrix_eigenvalues(const struct matrix *A, double value[])
{
    double *full = allocate((size_t)A->n * (size_t)A->n, sizeof *full);
    for (int i = 0; i < A->n; i++)
        for (int j = 0; j < A->n; j++)
            full[i * A->n + j] = matrix_get(A, i, j);
    const enum status status = dense_eigenvalues(A->n, full, value);
    free(full);
    return status;
}

void matrix_multiply(const struct matrix *A, const double x[], double y[])
{
    if (A->storage == SPARSE) {
        A->sparse->multiply(A->pattern, A->a, x, y);
        return;
    }
    for (int i = 0; i < A->n; i++) {
        const int first = i - A->p > 0 ? i - A->p : 0;
        const int last = i + A->p < A->n - 1 ? i + A->p : A->n - 1;
        y[i] = 0.0;
        for (int j = first; j <= last; j++) y[i] += matrix_get(A, i, j) * x[j];
    }
}

size_t matrix_bytes(const struct matrix *A)
{
    const size_t factors = A->factor ? A->sparse->size(A->pattern, A->single)
                                  : 0;
    return (A->size + factors) * sizeof *A->a;
}

double matrix_max_diagonal(const struct matrix *A)
{
    double largest = 0.0;
    if (A->storage == SPARSE) return A->sparse->max_diagonal(A->pattern, A->a);
    for (int r = 0; r < A->n; r++) {
        const double A_rr = *entry(A, r, r);
        if (A_rr > largest) largest = A_rr;
    }
    return largest;
}

void matrix_table(const char *name, const struct matrix *A)
{
    table_begin(name, "i j value");
    for (int i = 0; i < A->n; i++)
        for (int j = 0; j < A->n; j++)
            if (abs(i - j) <= A->p) table_row(i, j, matrix_get(A, i, j));
    table_end();
}

struct matrix_cost matrix_cost(enum storage storage, int n, int p)
{
    const double order = n, q = storage == DENSE ? n - 1 : p;
    const struct matrix_cost cost = {
        order * (q + 1.0),
        /* n - q columns of q + 1 numbers, then q, q - 1, ...: their squares */
        (order - q) * (q + 1.0) * (q + 1.0) +
            q * (q + 1.0) * (2.0 * q + 1.0) / 6.0,
        4.0 * (order * q - q * (q + 1.0) / 2.0) + 2.0 * order};
    return cost;
}
