/*
 * matrix.h - symmetric linear systems: assemble, correct, factor, solve.
 *
 * Four storages behind one interface.  Number the nodes along the bar and
 * A[i][j] = 0 whenever |i - j| > p.  Keeping only the band costs n (p + 1)
 * numbers and about n (p + 1)^2 flops to factor, instead of n^2 and n^3 / 3
 * [eq:band-cost].  Half bandwidth p = 1 is the tridiagonal case.
 *
 *     A = | a0 b0  .  . |     DENSE   a[i*n + j]       = A[i][j]
 *         | b0 a1 b1  . |
 *         |  . b1 a2 b2 |     BANDED  a[j*stride + d]  = A[j+d][j],
 *         |  .  . b2 a3 |             0 <= d <= p: the lower triangle by
 *                                     columns, a0 b0 | a1 b1 | a2 b2 | a3 *
 *
 * The banded layout is LAPACK's lower band (uplo L, ldab = stride), and for a
 * narrow band, where stride = p + 1, GSL's symmetric band format.  Columns of a
 * wide one (TILES_WIDE, tiles.h) have room behind them that holds zeros.  The
 * entries * beyond the last row are zero and stay it.  SPARSE is sparse.h: 2x2
 * blocks by columns, in the order of nested dissection, and factors elsewhere.
 * PLAIN is a band of any width as a narrow one, by the textbook's loops: slow,
 * and with the same digits for every processor and compiler, where BANDED and
 * SPARSE add in the order that is fast.  It is for studies of chaotic paths.
 *
 * Source: Golub & Van Loan, Matrix Computations, 4th ed., sec. 4.2, 4.3;
 *         GSL manual, "Linear Algebra", "Symmetric Banded Format".
 */
#ifndef COMMON_MATRIX_H
#define COMMON_MATRIX_H

#include "base/status.h"

#include <stddef.h>

struct sparse; /* sparse.h: a pattern and the order of its elimination */

enum storage { DENSE, BANDED, SPARSE, PLAIN };
enum diagonal { KEEP_DIAGONAL, UNIT_DIAGONAL };

/* What sparse.c does with a matrix of its own; a program without any is built
 * without it.  Its functions of these names say what each does. */
struct matrix_sparse {
    int (*block)(const struct sparse *s, int i, int j);
    void (*multiply)(const struct sparse *s, const double a[],
                     const double x[], double y[]);
    size_t (*size)(const struct sparse *s, int single);
    enum status (*factor)(const struct sparse *s, const double a[], int single,
                          double memory[], double b[]);
    void (*solve)(const struct sparse *s, int single, double memory[],
                  double b[]);
    enum status (*solve_indefinite)(const struct sparse *s, const double a[],
                                    double memory[], double b[],
                                    int *negative);
    double (*max_diagonal)(const struct sparse *s, const double a[]);
};

struct matrix {
    enum storage storage;
    int n;         /* order */
    int p;         /* half bandwidth, 0 <= p < n; n - 1 unless banded */
    size_t stride; /* numbers per row (dense), per column (banded); sparse: 3,
                    * from a block's entry (0, 0) to (1, 1) */
    size_t size;   /* numbers of a */
    double *a;     /* entries, see above; owned */
    const struct matrix_sparse *sparse; /* of sparse storage; borrowed, */
    const struct sparse *pattern;       /* and so is this */
    int single;     /* sparse: L is rounded to single precision */
    double *factor; /* sparse: room to work and L, or NULL; owned */
    double *room;   /* in which matrix_solve_indefinite() works, made by its
                     * first call, or NULL; owned */
};

/* The cost of a matrix, see matrix_cost(). */
struct matrix_cost {
    double numbers; /* kept, without the room behind a wide band's columns */
    double flops;   /* of the factorisation */
    double solve;   /* flops of the two triangular solves */
};

/* Return a zero matrix; p is ignored when dense.  The caller frees it.
 * matrix_alloc_sparse() is in sparse.c and calls matrix_alloc_with(). */
struct matrix *matrix_alloc(enum storage storage, int n, int p);
struct matrix *matrix_alloc_sparse(const struct sparse *pattern);
struct matrix *matrix_alloc_with(const struct matrix_sparse *methods,
                                 const struct sparse *pattern, int n,
                                 size_t size);
struct matrix *matrix_copy(const struct matrix *A);

/*
 * Round the factor of a sparse matrix to single precision, or do not, from now
 * on; one that is there is lost when this changes.  The factorisation and the
 * residual stay in double precision: a solve then has seven digits, a chord
 * step of step.h as many as ever, and refine.h finds the others.
 */
void matrix_keep_single(struct matrix *A, int single);

/* Return a new matrix, of A's storage: rows and columns first .. first + n - 1
 * of A.  Not sparse. */
struct matrix *matrix_block(const struct matrix *A, int first, int n);
void matrix_free(struct matrix *A);

/* Zero every entry and keep the memory: call it before each assembly. */
void matrix_zero(struct matrix *A);

/*
 * A[i][j] += value, for |i - j| <= p, or within the pattern (asserted: a band
 * that is too narrow is a bug in the caller).  Banded and sparse storage drop
 * what lies above the diagonal, so an element loop scatters its whole symmetric
 * matrix into any storage.
 */
void matrix_add(struct matrix *A, int i, int j, double value);

/* Return where in a entry (i, j), i >= j, is, for an element loop that adds to
 * a by itself; of even i and j when sparse. */
int matrix_place(const struct matrix *A, int i, int j);

/* Return A[i][j]; 0 outside the band or the pattern. */
double matrix_get(const struct matrix *A, int i, int j);

/*
 * Prescribe u[node[k]] = value[k], 0 <= k < n_fixed, in A u = b and keep A
 * symmetric [eq:dirichlet-correction]:
 *
 *     b_i -= A_ik u_k   for every row i,
 *     row k and column k := 0, A_kk := d, b_k := d u_k,
 *
 * d being the old A_kk (KEEP_DIAGONAL, which leaves the scale of the matrix
 * alone) or 1 (UNIT_DIAGONAL).  The order of the nodes does not matter.  Not
 * sparse: there prescribed unknowns are left out.
 */
void matrix_dirichlet(struct matrix *A, double b[], int n_fixed,
                      const int node[], const double value[],
                      enum diagonal diagonal);

/*
 * Factor A = L L^T by Cholesky [eq:cholesky], in place unless sparse; of a
 * tridiagonal band A = L D L^T, see banded.h.
 *
 * NOT_SPD when a pivot is not above n eps times its own diagonal entry, which
 * is where round-off leaves the last pivot of a singular matrix; NaN is caught
 * as well.  A is then partly overwritten.  Newton's method reacts to it, so it
 * is never an abort.  The test is invariant under scaling of the unknowns, and
 * cannot be complete: on a strongly graded mesh (lengths 1 to 10 and more) the
 * round-off of small elements may exceed it, and a singular matrix passes.
 */
enum status matrix_factor(struct matrix *A);

/* b := A^{-1} b, for L from matrix_factor(). */
void matrix_solve(const struct matrix *L, double b[]);

/* Factor and solve, with the same digits; a sparse L is read once less.  A
 * status that is not OK leaves b spoilt. */
enum status matrix_factor_solve(struct matrix *A, double b[]);

/*
 * b := A^{-1} b for an A that is not factored, not dense, and need not be
 * positive definite, by L D L^T without pivoting: in a band GSL's; sparse with
 * the signs of D kept beside L (sparse.h), refined once.  *negative (or NULL)
 * is the number of negative pivots D_jj, which is the number of negative
 * eigenvalues of A (Sylvester's law of inertia).
 *
 * NOT_SPD: a pivot is 0 to round-off, |D_jj| <= eps |A_jj| (sparse: n eps); b
 * and *negative are then meaningless.
 *
 * Source: Golub & Van Loan, sec. 4.1.2 (L D L^T), 8.1.5 (inertia).
 */
enum status matrix_solve_indefinite(struct matrix *A, double b[],
                                    int *negative);

/* C := A + s B, of one storage, order and half bandwidth (asserted), none of
 * them factored; C may be A or B. */
void matrix_combine(const struct matrix *A, double s, const struct matrix *B,
                    struct matrix *C);

/* value[0..n-1] := the eigenvalues of A, not factored, in ascending order, by
 * GSL's dense symmetric solver: about n^3 flops.  NONFINITE: A is not finite.
 */
enum status matrix_eigenvalues(const struct matrix *A, double value[]);

/* y := A x, for an A that is not factored. */
void matrix_multiply(const struct matrix *A, const double x[], double y[]);

/* Return the bytes of the entries; sparse: and the factor, if any. */
size_t matrix_bytes(const struct matrix *A);

/* Return the largest entry of the diagonal, or 0; NaN is not looked at. */
double matrix_max_diagonal(const struct matrix *A);

/* Print a table of the entries within the band: columns i j value. */
void matrix_table(const char *name, const struct matrix *A);

/*
 * Return the cost of order n and half bandwidth p, without a matrix
 * [eq:band-cost]; p is ignored when dense.  Each + - * / and square root of the
 * textbook's Cholesky counts one: (m + 1)^2 for a column with m entries below
 * its pivot, and 2 (2 m + 1) in the solves [eq:cholesky-flops].  Real numbers,
 * for n^3 exceeds any int.
 */
struct matrix_cost matrix_cost(enum storage storage, int n, int p);

#endif
