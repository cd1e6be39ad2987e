/* matrix.c - laws of common/linear/matrix.h; GSL's LU is the judge. */
#include "linear/residual.h"
#include "linear/tiles.h"
#include "linear/matrix.h"

#include "unit.h"

#include <float.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { N = 9 };

/* A random symmetric, diagonally dominant band matrix of half bandwidth p, in
 * either storage; the same numbers for the same seed. */
static struct matrix *random_matrix(enum storage storage, int p)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    struct matrix *A = matrix_alloc(storage, N, p);
    for (int i = 0; i < N; i++)
        for (int j = 0; j <= i; j++) {
            const double value = gsl_rng_uniform(rng) - 0.5;
            if (i == j)
                matrix_add(A, i, i, 2.385 + p + value);
            else if (i - j <= p) {
                matrix_add(A, i, j, value);
                matrix_add(A, j, i, value);
            }
        }
    gsl_rng_free(rng);
    return A;
}

static void fill(double v[])
{
    for (int i = 0; i < N; i++) v[i] = sin(2.385 * i + 0.7);
}

static void both_storages_hold_the_same_matrix(void)
{
    for (int p = 0; p < N; p++) {
        struct matrix *dense = random_matrix(DENSE, p);
        struct matrix *banded = random_matrix(BANDED, p);
        double x[N], y[N], z[N];
        fill(x);
        matrix_multiply(dense, x, y);
        matrix_multiply(banded, x, z);
        for (int i = 0; i < N; i++) {
            close_to(y[i], z[i], 10 * DBL_EPSILON);
            for (int j = 0; j < N; j++)
                ck_assert(matrix_get(dense, i, j) == matrix_get(banded, i, j));
        }
        ck_assert_uint_eq(matrix_bytes(dense), 8 * N * N);
        ck_assert_uint_eq(matrix_bytes(banded), 8 * N * ((size_t)p + 1));
        matrix_free(dense);
        matrix_free(banded);
    }
}

/* The corrected system, against elimination by hand and in any order. */
static void dirichlet_keeps_symmetry_and_solution(void)
{
    const int node[] = {6, 0, 2}, other[] = {2, 6, 0};
    const double g[] = {-0.731, 1.247, 0.613}, h[] = {0.613, -0.731, 1.247};
    for (int s = DENSE; s <= BANDED; s++)
        for (int d = KEEP_DIAGONAL; d <= UNIT_DIAGONAL; d++) {
            struct matrix *A0 = random_matrix((enum storage)s, 2);
            struct matrix *A = matrix_copy(A0), *B = matrix_copy(A0);
            double b0[N], b[N], c[N], r[N], x[N];
            fill(b0);
            fill(b);
            fill(c);
            matrix_dirichlet(A, b, 3, node, g, (enum diagonal)d);
            matrix_dirichlet(B, c, 3, other, h, (enum diagonal)d);
            for (int i = 0; i < N; i++) {
                close_to(b[i], c[i], 50 * DBL_EPSILON);
                for (int j = 0; j < N; j++) {
                    ck_assert(matrix_get(A, i, j) == matrix_get(B, i, j));
                    ck_assert(matrix_get(A, i, j) == matrix_get(A, j, i));
                }
            }
            ck_assert(matrix_get(A, 6, 6) ==
                      (d == KEEP_DIAGONAL ? matrix_get(A0, 6, 6) : 1.0));
            ck_assert(matrix_get(A, 6, 5) == 0.0 && matrix_get(A, 7, 6) == 0.0);
            ck_assert_int_eq(matrix_factor(A), OK);
            for (int i = 0; i < N; i++) x[i] = b[i];
            matrix_solve(A, x);
            matrix_multiply(A0, x, r); /* free rows: A0 x = b0 */
            for (int i = 0; i < N; i++)
                if (i != 0 && i != 2 && i != 6)
                    close_to(r[i], b0[i], 100 * DBL_EPSILON);
            for (int k = 0; k < 3; k++) close_to(x[node[k]], g[k], 1e-15);
            matrix_free(A0);
            matrix_free(A);
            matrix_free(B);
        }
}

/* -u'' with natural conditions: constants are in the null space. */
static struct matrix *neumann(enum storage storage, int n)
{
    struct matrix *A = matrix_alloc(storage, n + 1, 1);
    for (int e = 0; e < n; e++)
        for (int a = 0; a < 2; a++)
            for (int b = 0; b < 2; b++)
                matrix_add(A, e + a, e + b, (a == b ? 2.385 : -2.385) * n);
    return A;
}

/* A pivot of 1, 3 eps in (1, 1; 1, 1 + d) is round-off of the second diagonal
 * entry, or is not, in any unit, a power of 2. */
static void a_pivot_is_measured_by_its_own_diagonal(void)
{
    for (int s = DENSE; s <= BANDED; s++)
        for (int k = 0; k < 4; k++) {
            const double unit = k < 2 ? 1.0 : 0x1p-80;
            struct matrix *A = matrix_alloc((enum storage)s, 2, 1);
            matrix_add(A, 0, 0, unit);
            matrix_add(A, 1, 0, unit);
            matrix_add(A, 0, 1, unit);
            matrix_add(A, 1, 1, unit * (1.0 + (k % 2 ? 3 : 1) * DBL_EPSILON));
            ck_assert_int_eq(matrix_factor(A), k % 2 ? OK : NOT_SPD);
            matrix_free(A);
        }
}

/* One end held: condition number 16 n^2 / pi^2, 1.6e10 here; still SPD. */
static void ill_conditioned_is_still_spd(void)
{
    const int n = 100000, node[] = {0};
    const double g[] = {2.385};
    double *b = calloc((size_t)n + 1, sizeof *b);
    struct matrix *A = neumann(BANDED, n);
    matrix_dirichlet(A, b, 1, node, g, KEEP_DIAGONAL);
    ck_assert_int_eq(matrix_factor(A), OK);
    matrix_solve(A, b);
    close_to(b[n], 2.385, 1e-5); /* eps times the condition is 3.6e-6 */
    free(b);
    matrix_free(A);
}

/* A random SPD band of order n: like random_matrix(), diagonal 1 + p / 2. */
static struct matrix *random_band(int n, int p)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    struct matrix *A = matrix_alloc(BANDED, n, p);
    for (int j = 0; j < n; j++)
        for (int i = j; i < n && i <= j + A->p; i++)
            matrix_add(A, i, j,
                       i == j ? 1.613 + 0.5 * p : gsl_rng_uniform(rng) - 0.5);
    gsl_rng_free(rng);
    return A;
}

/* GSL's banded Cholesky of a copy without room behind the columns: its L, and
 * x := A^{-1} x. */
static gsl_matrix *gsl_band(const struct matrix *A, double x[])
{
    gsl_matrix *L = gsl_matrix_calloc((size_t)A->n, (size_t)A->p + 1);
    gsl_vector_view view = gsl_vector_view_array(x, (size_t)A->n);
    for (int j = 0; j < A->n; j++)
        for (int d = 0; d <= A->p && j + d < A->n; d++)
            gsl_matrix_set(L, (size_t)j, (size_t)d, matrix_get(A, j + d, j));
    ck_assert_int_eq(gsl_linalg_cholesky_band_decomp(L), 0);
    gsl_linalg_cholesky_band_svx(L, &view.vector);
    return L;
}

static const int widths[] = {0,  1,  2,  7,  8,  9,  15, 16, 17, 20, 23, 24,
                             25, 29, 31, 32, 42, 47, 54, 63, 67, 96};
static const int excess[] = {1, 2, 5, 8, 9, 23, 24, 50, 131}; /* n - p */

static void a_band_of_any_width_equals_gsl(void)
{
    for (int w = 0; w < COUNT(widths); w++)
        for (int e = 0; e < COUNT(excess); e++) {
            const int p = widths[w], n = p + excess[e];
            struct matrix *A = random_band(n, p);
            double *b = calloc((size_t)n, sizeof *b);
            double *x = calloc((size_t)n, sizeof *x), largest = 0.0;
            for (int i = 0; i < n; i++) b[i] = x[i] = sin(2.385 * i + 0.7);
            gsl_matrix *L = gsl_band(A, x);
            ck_assert_int_eq(matrix_factor(A), OK);
            matrix_solve(A, b);
            for (int j = 0; j < n; j++) {
                const double L_jj = gsl_matrix_get(L, (size_t)j, 0);
                for (int d = 0; d <= p && j + d < n; d++) {
                    const double L_ij = gsl_matrix_get(L, (size_t)j, (size_t)d);
                    /* banded.h keeps D_jj = L_jj^2 and L_ij / L_jj for p = 1 */
                    const double want = p != 1   ? L_ij
                                        : d == 0 ? L_jj * L_jj
                                                 : L_ij / L_jj;
                    close_to(matrix_get(A, j + d, j), want,
                             1e-12 * fmax(L_jj, L_jj * L_jj));
                }
                largest = fmax(largest, fabs(x[j]));
            }
            for (int i = 0; i < n; i++) close_to(b[i], x[i], 1e-12 * largest);
            gsl_matrix_free(L);
            matrix_free(A);
            free(b);
            free(x);
        }
}

/* Bit for bit, whatever the processor: each entry less its products one after
 * the other, and the same in the solves.  A copy is as plain. */
static void a_plain_band_adds_in_the_textbooks_order(void)
{
    enum { n = 61 };
    for (int p = 0; p <= 40; p += 5) {
        struct matrix *A = matrix_alloc(PLAIN, n, p);
        double L[n][n] = {{0.0}}, b[n], x[n];
        for (int i = 0; i < n; i++) {
            for (int j = i > p ? i - p : 0; j <= i; j++) {
                L[i][j] = i == j ? 1.613 + 0.5 * p : 0.5 * sin(2.385 * i + j);
                matrix_add(A, i, j, L[i][j]);
            }
            b[i] = x[i] = sin(2.385 * i + 0.7);
        }
        struct matrix *copy = matrix_copy(A);
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < j; k++)
                for (int i = j; i < n; i++) L[i][j] -= L[j][k] * L[i][k];
            L[j][j] = sqrt(L[j][j]);
            for (int i = j + 1; i < n; i++) L[i][j] *= 1.0 / L[j][j];
        }
        for (int j = 0; j < n; j++) {
            x[j] /= L[j][j];
            for (int i = j + 1; i < n; i++) x[i] -= L[i][j] * x[j];
        }
        for (int j = n - 1; j >= 0; j--) {
            for (int i = j + 1; i < n; i++) x[j] -= L[i][j] * x[i];
            x[j] /= L[j][j];
        }
        ck_assert_int_eq(matrix_factor(copy), OK);
        matrix_solve(copy, b);
        for (int i = 0; i < n; i++) {
            ck_assert_double_eq(b[i], x[i]);
            for (int j = i > p ? i - p : 0; j <= i; j++)
                ck_assert_double_eq(matrix_get(copy, i, j), L[i][j]);
        }
        ck_assert_uint_eq(matrix_bytes(copy), 8 * n * ((size_t)p + 1));
        ck_assert_int_eq(copy->storage, PLAIN);
        matrix_free(A), matrix_free(copy);
    }
}

/* What tiles.h asks for and promises; a tile that reaches too far shows. */
static void the_room_behind_a_column_stays_zero(void)
{
    for (int p = TILES_WIDE; p <= 40; p++) {
        const int n = 2 * p + 29;
        struct matrix *A = random_band(n, p);
        ck_assert_uint_eq((uintptr_t)A->a % 64, 0); /* a line of the cache */
        ck_assert_uint_eq(A->stride, tiles_stride(p));
        ck_assert_uint_eq(A->stride % 16, 9); /* the least with room for 8 */
        ck_assert(A->stride >= (size_t)p + 9 && A->stride < (size_t)p + 25);
        ck_assert_uint_eq(matrix_bytes(A), 8 * (size_t)n * A->stride);
        ck_assert_int_eq(matrix_factor(A), OK);
        for (int j = 0; j < n; j++)
            for (int d = 0; d < (int)A->stride; d++)
                if (d > p || j + d >= n)
                    ck_assert(A->a[(size_t)j * A->stride + (size_t)d] == 0.0);
        matrix_free(A);
    }
}

static void a_band_that_is_not_spd_is_reported(void)
{
    const int n = 83, wide[] = {7, 14, 16, 21, 63, 82};
    for (int w = 0; w < COUNT(wide); w++) {
        for (int k = 0; k < n; k++)
            for (int bad = 0; bad < 4; bad++) {
                struct matrix *A = random_band(n, wide[w]);
                matrix_add(A, k, bad == 3 && k > 4 ? k - 5 : k,
                           bad == 0   ? -2.0 * matrix_get(A, k, k)
                           : bad == 1 ? -matrix_get(A, k, k)
                           : bad == 2 ? (double)INFINITY
                                      : (double)NAN);
                ck_assert_int_eq(matrix_factor(A), NOT_SPD);
                matrix_free(A);
            }
        /* singular: springs between all neighbours, nothing held; stiff ones,
         * so that the round-off in the last pivot is large */
        struct matrix *A = matrix_alloc(BANDED, n, wide[w]);
        for (int i = 0; i < n; i++)
            for (int j = i - wide[w] > 0 ? i - wide[w] : 0; j < i; j++) {
                const double k = 2.385e9 * (1.0 + 0.5 * sin(3.714 * i + j));
                matrix_add(A, i, i, k);
                matrix_add(A, j, j, k);
                matrix_add(A, i, j, -k);
            }
        struct matrix *held = matrix_copy(A);
        matrix_add(held, 41, 41, 1e3); /* a weak spring, and it is SPD */
        ck_assert_int_eq(matrix_factor(A), NOT_SPD);
        ck_assert_int_eq(matrix_factor(held), OK);
        matrix_free(held);
        matrix_free(A);
    }
}

/* beta = 1, both ends given: (2/h) (1 - cos k pi h)
 * [eq:stiffness-eigenvalues]. */
static void eigenvalues_are_those_in_closed_form(void)
{
    enum { n = 12 };
    for (int storage = DENSE; storage <= BANDED; storage++) {
        struct matrix *A = matrix_alloc((enum storage)storage, n - 1, 1);
        double value[n - 1];
        for (int i = 0; i < n - 1; i++) {
            matrix_add(A, i, i, 2.0 * n);
            if (i == 0) continue;
            matrix_add(A, i, i - 1, -n);
            matrix_add(A, i - 1, i, -n);
        }
        ck_assert_int_eq(matrix_eigenvalues(A, value), OK);
        for (int k = 1; k < n; k++)
            close_to(value[k - 1], 2.0 * n * (1.0 - cos(k * M_PI / n)),
                     1e-14 * 4 * n);
        close_to(matrix_get(A, 3, 3), 2.0 * n, 1e-15); /* A is not touched */
        matrix_add(A, 2, 2, NAN);
        ck_assert_int_eq(matrix_eigenvalues(A, value), NONFINITE);
        matrix_free(A);
    }
}

/* Sylvester: as many negative pivots as negative eigenvalues of A - s I, in
 * whatever unit. */
static void pivots_of_a_band(int p)
{
    enum { n = 40 };
    struct matrix *A = random_band(n, p), *I = matrix_alloc(BANDED, n, p);
    struct matrix *shifted = matrix_alloc(BANDED, n, p);
    double value[n];
    ck_assert_int_eq(matrix_eigenvalues(A, value), OK);
    for (int i = 0; i < n; i++) matrix_add(I, i, i, 1.0);
    for (int k = 0; k <= n; k += 8) {
        const double s = k == 0   ? value[0] - 1.0
                         : k == n ? value[n - 1] + 1.0
                                  : 0.5 * (value[k - 1] + value[k]);
        double b[n], x[n];
        int negative = -1;
        matrix_combine(A, -s, I, shifted);
        for (size_t i = 0; i < shifted->size; i++)
            shifted->a[i] = ldexp(shifted->a[i], 20 * (k - n / 2));
        for (int i = 0; i < n; i++) b[i] = x[i] = sin(2.385 * i + 0.7);
        ck_assert_int_eq(matrix_solve_indefinite(shifted, x, &negative), OK);
        ck_assert_int_eq(negative, k);
        /* without pivoting L may be some hundred times A */
        ck_assert(matrix_residual(shifted, x, b) < 1e-12);
    }
    matrix_free(A), matrix_free(I), matrix_free(shifted);
}
static void negative_pivots_count_negative_eigenvalues(void)
{
    pivots_of_a_band(1);
    pivots_of_a_band(5);
    pivots_of_a_band(17); /* wide enough for tiles.h */
}

/* 1 + d - 1 = d is no pivot if it is at most a last digit of 1 + d. */
static void a_pivot_of_one_digit_is_none(void)
{
    for (int k = 0; k < 18; k++) {
        struct matrix *A = matrix_alloc(BANDED, 3, 1 + k % 2);
        const int digits = k / 2 - 4;
        double b[3] = {1.0, 1.0, 1.0};
        int negative;
        for (int i = 0; i < 3; i++) matrix_add(A, i, i, 1.0);
        matrix_add(A, 1, 0, 1.0);
        matrix_add(A, 1, 1, digits * DBL_EPSILON);
        ck_assert_int_eq(matrix_solve_indefinite(A, b, &negative),
                         digits < 0 || digits > 1 ? OK : NOT_SPD);
        matrix_free(A);
        if (digits == 0 || digits == 1) continue;
        ck_assert_int_eq(negative, digits < 0);
        ck_assert(b[0] == 1.0 && b[1] == 0.0 && b[2] == 1.0);
    }
}

static void a_block_has_the_entries_of_its_rows(void)
{
    for (int s = DENSE; s <= BANDED; s++)
        for (int n = 1; n <= 6; n++) {
            struct matrix *A = random_matrix((enum storage)s, 3);
            struct matrix *B = matrix_block(A, 2, n);
            ck_assert(B->storage == A->storage && B->n == n);
            for (int i = 0; i < n; i++)
                for (int j = 0; j < n; j++)
                    ck_assert(matrix_get(B, i, j) ==
                              matrix_get(A, i + 2, j + 2));
            matrix_free(A), matrix_free(B);
        }
}

/* Flops of the textbook's loop, step by step. */
static void costs_are_counted(void)
{
    for (int n = 1; n < 30; n++)
        for (int p = 0; p < n; p++) {
            struct matrix *A = matrix_alloc(BANDED, n, p < 12 ? p : 12);
            const struct matrix_cost cost = matrix_cost(BANDED, n, p);
            const struct matrix_cost dense = matrix_cost(DENSE, n, p);
            double flops = 0.0, all = 0.0, solve = 0.0;
            for (int k = 0; k < n; k++) {
                const int m = n - 1 - k < p ? n - 1 - k : p;
                flops += (m + 1) * (m + 1);
                solve += 2 * (m + 1 + m); /* L y = b, then L^T u = y */
                all += (n - k) * (n - k);
            }
            close_to(cost.flops, flops, 1e-9);
            close_to(cost.solve, solve, 1e-9);
            close_to(dense.solve, 2.0 * n * n, 1e-9);
            close_to(dense.flops, all, 1e-9);
            close_to(dense.numbers, n * n, 1e-9);
            if (p < 12)
                close_to(8.0 * cost.numbers, (double)matrix_bytes(A), 1e-9);
            matrix_free(A);
        }
    close_to(matrix_cost(DENSE, 100001, 1).numbers, 10000200001.0, 1e-4);
}

/* 2 MB, which is no large page everywhere, but then does no harm. */
static void many_numbers_start_at_a_large_page(void)
{
    struct matrix *A = matrix_alloc(BANDED, (1 << 18) + 1, 7);
    const size_t last = (1 << 21) + 7;
    ck_assert_uint_eq(matrix_bytes(A), 8 * (last + 1));
    ck_assert_uint_eq((uintptr_t)A->a % (1 << 21), 0);
    size_t other = 0;
    for (size_t k = 0; k <= last; k++) other += A->a[k] != 0.0;
    ck_assert_uint_eq(other, 0);
    matrix_free(A);
}

static void ask_for_too_large_a_matrix(void)
{
    matrix_alloc(DENSE, 2000000000, 0);
}

static void a_matrix_without_memory_is_an_error(void)
{
    const struct outcome end = outcome_of(ask_for_too_large_a_matrix);
    ck_assert_int_eq(end.status, 1);
    ck_assert_str_eq(end.err,
                     "error: out of memory: 4000000000000000000 numbers\n");
}

/* Nobody looks behind b, nor changes what is there. */
static void a_solve_stays_within_its_vector(void)
{
    for (int s = DENSE; s <= BANDED; s++)
        for (int p = 0; p < 20; p++) {
            struct matrix *A = matrix_alloc((enum storage)s, 20, p);
            double b[22];
            for (int i = 0; i < 20; i++) matrix_add(A, i, i, 4.0);
            for (int i = 0; i < 22; i++) b[i] = i > 0 && i < 21 ? 2.0 : NAN;
            ck_assert_int_eq(matrix_factor(A), OK);
            matrix_solve(A, &b[1]);
            for (int i = 1; i < 21; i++) close_to(b[i], 0.5, 1e-15);
            ck_assert(isnan(b[0]) && isnan(b[21]));
            matrix_free(A);
        }
}

/* A + e e_0 e_0^T is solved exactly by u: the residual is e |u_0|.  The row
 * `large` of A has the largest sum. */
static void backward_error_of(int large)
{
    enum { n = 23 };
    struct matrix *A = random_band(n, 4);
    matrix_add(A, large, large, 50.0);
    struct matrix *near = matrix_copy(A);
    double u[n], b[n], norm_A = 0.0, norm_u = 0.0, norm_b = 0.0;
    const double e = 1e-6 * matrix_get(A, 0, 0);
    for (int i = 0; i < n; i++) u[i] = sin(2.385 * i + 0.7);
    matrix_add(near, 0, 0, e);
    matrix_multiply(near, u, b);
    for (int i = 0; i < n; i++) {
        double row = 0.0;
        for (int j = 0; j < n; j++) row += fabs(matrix_get(A, i, j));
        norm_A = fmax(norm_A, row);
        norm_u = fmax(norm_u, fabs(u[i]));
        norm_b = fmax(norm_b, fabs(b[i]));
    }
    const double want =
        e * fabs(u[0]) / (DBL_EPSILON * (norm_A * norm_u + norm_b));
    close_to(matrix_backward_error(A, u, b), want, 10.0); /* round-off: eps */
    ck_assert_double_lt(matrix_backward_error(near, u, b), 10.0);
    /* in other units, powers of 2, the same number */
    const double error = matrix_backward_error(A, u, b);
    matrix_zero(near);
    matrix_combine(near, 0x1p-30, A, near);
    for (int i = 0; i < n; i++) u[i] *= 0x1p-20, b[i] *= 0x1p-50;
    ck_assert_double_eq(matrix_backward_error(near, u, b), error);
    for (int i = 0; i < n; i++) u[i] *= -1.0, b[i] *= -1.0;
    ck_assert_double_eq(matrix_backward_error(near, u, b), error);
    u[3] = NAN;
    ck_assert(isnan(matrix_backward_error(A, u, b)));
    matrix_free(A), matrix_free(near);
}

static void backward_error_is_that_of_a_nearby_system(void)
{
    backward_error_of(0);
    backward_error_of(22);
}

UNIT_MAIN("matrix",
    LAW(both_storages_hold_the_same_matrix),
    LAW(dirichlet_keeps_symmetry_and_solution),
    LAW(a_pivot_is_measured_by_its_own_diagonal),
    LAW(ill_conditioned_is_still_spd),
    LAW(a_band_of_any_width_equals_gsl),
    LAW(a_plain_band_adds_in_the_textbooks_order),
    LAW(the_room_behind_a_column_stays_zero),
    LAW(a_band_that_is_not_spd_is_reported),
    LAW(eigenvalues_are_those_in_closed_form),
    LAW(negative_pivots_count_negative_eigenvalues),
    LAW(backward_error_is_that_of_a_nearby_system),
    LAW(a_pivot_of_one_digit_is_none),
    LAW(a_block_has_the_entries_of_its_rows),
    LAW(costs_are_counted),
    LAW(many_numbers_start_at_a_large_page),
    LAW(a_matrix_without_memory_is_an_error),
    LAW(a_solve_stays_within_its_vector))
