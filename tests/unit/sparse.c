/* sparse.c - laws of dissection.h, sparse.h and the sparse storage of matrix.h,
 * body.h and step.h; dense storage and the band are the judges. */
#include "figures/robustness/first_step.h"
#include "linear/front.h"
#include "linear/matrix.h"
#include "figures/21_sparse_cholesky/refine.h"
#include "linear/residual.h"
#include "plane/scene.h"
#include "linear/sparse.h"

#include "unit.h"

#include <float.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A square with some vertices held: both ends, the left one, none; or a
 * rectangle with any, each with the chance 1/4, by the seed. */
enum hold { ENDS, LEFT, NONE, ANY, HOLDS };
struct pattern {
    struct mesh *mesh;
    int *held, n; /* n: unknowns */
    struct sparse *sparse;
};

static struct pattern pattern_alloc(int n, int hold, unsigned long seed,
                                    int leaf)
{
    struct pattern p = {.mesh = hold == ANY
                                    ? mesh_rectangle(n, 1 + 2 * n / 3, 2.0, 1.0)
                                    : mesh_square(n)};
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    p.held = calloc((size_t)p.mesh->n_vertex, sizeof *p.held);
    for (int a = 1; a < p.mesh->n_vertex; a++) { /* 0 is free */
        const int left = a % (n + 1) == 0, right = a % (n + 1) == n;
        p.held[a] = hold == ANY ? gsl_rng_uniform(rng) < 0.25
                                : (left && hold != NONE) ||
                                      (right && hold == ENDS && n > 1);
    }
    p.held[0] = hold != NONE && hold != ANY;
    p.sparse = sparse_alloc(p.mesh->n + 1, p.mesh->rows + 1,
                            p.mesh->n_triangle, p.mesh->triangle, p.held,
                            leaf);
    p.n = 2 * p.sparse->n_vertex;
    gsl_rng_free(rng);
    return p;
}

static void pattern_free(struct pattern p)
{
    sparse_free(p.sparse);
    mesh_free(p.mesh);
    free(p.held);
}

/* A random symmetric, diagonally dominant matrix of the pattern, and the same
 * dense. */
static void random_pair(struct pattern p, unsigned long seed,
                        struct matrix **sparse, struct matrix **dense)
{
    const struct sparse *s = p.sparse;
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    *sparse = matrix_alloc_sparse(s);
    *dense = matrix_alloc(DENSE, p.n, 0);
    for (int v = 0; v < s->n_vertex; v++)
        for (int b = s->start[v]; b < s->start[v + 1]; b++)
            for (int k = 0; k < 4; k++) {
                const int i = 2 * s->row[b] + k % 2, j = 2 * v + k / 2;
                const double value =
                    gsl_rng_uniform(rng) - 0.5 + (i == j ? 5.385 : 0.0);
                if (i < j) continue;
                matrix_add(*sparse, i, j, value);
                matrix_add(*dense, i, j, value);
                if (i == j) continue;
                matrix_add(*sparse, j, i, value); /* dropped */
                matrix_add(*dense, j, i, value);
            }
    gsl_rng_free(rng);
}

static void fill(int n, double v[])
{
    for (int i = 0; i < n; i++) v[i] = sin(2.385 * i + 0.7);
}

/* max|a - b| <= tolerance max|b| */
static void same(int n, const double a[], const double b[], double tolerance)
{
    double largest = 0.0;
    for (int i = 0; i < n; i++) largest = fmax(largest, fabs(b[i]));
    for (int i = 0; i < n; i++) close_to(a[i], b[i], tolerance * largest);
}

static const int leaves[] = {1, 2, 3, 5, 16, 1000};

/* The piece of every place, and the first piece below every piece. */
static void pieces(const struct dissection *d, int piece[], int lowest[])
{
    for (int k = 0; k < d->n_piece; k++) {
        const struct piece *q = &d->piece[k];
        lowest[k] = k;
        for (int c = 0; c < 2; c++)
            if (q->child[c] >= 0 && lowest[q->child[c]] < lowest[k])
                lowest[k] = lowest[q->child[c]];
        for (int v = q->first; v < q->first + q->count; v++) piece[v] = k;
    }
}

static void a_line_separates_its_two_sides(void)
{
    for (int hold = 0; hold < HOLDS; hold++)
        for (int n = 3; n <= 17; n++) {
            struct pattern p = pattern_alloc(n, hold, 11, 4);
            const struct dissection *d = p.sparse->order;
            int piece[400], lowest[400], edges = 0, largest = 0;
            pieces(d, piece, lowest);
            for (int v = 0; v < d->n_vertex; v++)
                for (int b = d->start[v] + 1; b < d->start[v + 1]; b++) {
                    const int up = piece[d->row[b]], down = piece[v];
                    ck_assert_int_gt(d->row[b], v);
                    ck_assert(lowest[up] <= down && down <= up);
                    edges++;
                }
            int expected = 0; /* the edges between free vertices */
            for (int a = 0; a < p.mesh->n_vertex; a++)
                for (int k = 0; k < 3; k++) {
                    const int step[3] = {1, n + 1, n + 2}, b = a + step[k];
                    if (b >= p.mesh->n_vertex || (k != 1 && a % (n + 1) == n))
                        continue;
                    expected += !p.held[a] && !p.held[b];
                }
            ck_assert_int_eq(edges, expected);
            for (int k = 0; k < d->n_piece; k++)
                if (d->piece[k].count > largest) largest = d->piece[k].count;
            ck_assert_int_le(largest, n + 1);
            pattern_free(p);
        }
}

/* Rows of every front, by looking at all edges. */
static void fill_is_what_the_fronts_must_hold(void)
{
    for (int hold = 0; hold < HOLDS; hold++)
        for (int n = 1; n <= 13; n += 3)
            for (int l = 0; l < COUNT(leaves); l++) {
                struct pattern p = pattern_alloc(n, hold, 5, leaves[l]);
                const struct dissection *d = p.sparse->order;
                int piece[400], lowest[400];
                double numbers = 0.0, flops = 0.0, solve = 0.0;
                pieces(d, piece, lowest);
                for (int k = 0; k < d->n_piece; k++) {
                    const int end = d->piece[k].first + d->piece[k].count;
                    int rest[400] = {0}, m = 0;
                    for (int v = 0; v < end; v++)
                        for (int b = d->start[v]; b < d->start[v + 1]; b++)
                            if (piece[v] >= lowest[k] && d->row[b] >= end)
                                rest[d->row[b]] = 1;
                    for (int v = 0; v < d->n_vertex; v++) m += 2 * rest[v];
                    for (int c = 2 * d->piece[k].count; c > 0; c--, m++) {
                        numbers += m + 1;
                        flops += (m + 1.0) * (m + 1.0);
                        solve += 4.0 * m + 2.0;
                    }
                }
                ck_assert(p.sparse->numbers == numbers);
                ck_assert(p.sparse->flops == flops);
                ck_assert(p.sparse->solve == solve);
                ck_assert((double)p.sparse->factor >= numbers);
                pattern_free(p);
            }
}

static void solve_equals_dense_for_random_patterns(void)
{
    for (int n = 1; n <= 14; n++)
        for (int hold = 0; hold < HOLDS; hold++)
            for (int l = 0; l < COUNT(leaves); l++) {
                struct pattern p = pattern_alloc(n, hold, (unsigned)(n + l),
                                                 leaves[l]);
                struct matrix *A, *B;
                double x[450], y[450];
                random_pair(p, 1 + (unsigned)l, &A, &B);
                fill(p.n, x);
                fill(p.n, y);
                ck_assert_int_eq(matrix_factor(A), OK);
                ck_assert_int_eq(matrix_factor(B), OK);
                matrix_solve(A, x);
                matrix_solve(B, y);
                same(p.n, x, y, 1e-12);
                fill(p.n, x); /* the factor is still there */
                matrix_solve(A, x);
                same(p.n, x, y, 1e-12);
                matrix_free(A);
                matrix_free(B);
                pattern_free(p);
            }
}

/* More panels than take turns: A = (A11 A21^T; A21 A22), A11 of the pivots.
 * Its diagonal is 70, so that 1e-12 is some hundred times the round-off. */
static void a_front_of_many_panels_is_that_of_elimination(void)
{
    enum { MOST = 170 + 62 };
    static double A[MOST][MOST], S[MOST][MOST];
    for (int turn = 0; turn < 4; turn++) {
        const int p = turn < 2 ? 170 : 14, rest = turn % 2 ? 62 : 0;
        const int n = p + rest, whole = front_row(rest, 0);
        double *l = calloc(front_size(p, rest) + 1, sizeof *l);
        double *u = calloc(front_size(whole, 0) + 1, sizeof *u);
        double b[MOST], diagonal[MOST];
        double *x = calloc((size_t)front_row(p, front_row(rest, 0)), sizeof *x);
        const struct front front = {p, rest, l, u, NULL, NULL};
        gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
        for (int i = 0; i < n; i++)
            for (int j = 0; j <= i; j++) {
                A[i][j] = A[j][i] = gsl_rng_uniform(rng) - 0.5 +
                                    (i == j ? 0.3 * MOST : 0.0);
                S[i][j] = S[j][i] = A[i][j];
                if (j < p)
                    l[front_place(p, rest, i < p ? i : front_row(p, i - p),
                                  j)] = A[i][j];
            }
        for (int j = 0; j < p; j++) diagonal[j] = A[j][j];
        for (int k = 0; k < p; k++)
            for (int i = k + 1; i < n; i++)
                for (int j = k + 1; j < n; j++)
                    S[i][j] -= S[i][k] * S[k][j] / S[k][k];
        fill((int)front_size(whole, 0), u); /* another's, as in the stacks */
        ck_assert_int_eq(front_factor(&front, n, diagonal), OK);
        for (int i = 0; i < rest; i++)
            for (int j = 0; j <= i; j++)
                close_to(u[front_place(whole, 0, i, j)],
                         S[p + i][p + j] - A[p + i][p + j], 1e-12);
        fill(n, b);
        memcpy(x, b, (size_t)p * sizeof *x);
        front_forward(&front, x);
        memset(&x[front_row(p, 0)], 0, (size_t)rest * sizeof *x);
        front_backward(&front, x); /* x := A11^-1 b */
        for (int i = 0; i < p; i++) {
            double sum = 0.0;
            for (int j = 0; j < p; j++) sum += A[i][j] * x[j];
            close_to(sum, b[i], 1e-12);
        }
        gsl_rng_free(rng);
        free(l);
        free(u);
        free(x);
    }
}

/* Springs between all neighbours, nothing held: the round-off in the last
 * pivot is large, and what it is compared with is not what the front holds. */
static void what_is_singular_is_not_spd(void)
{
    for (int n = 1; n <= 12; n++)
        for (int l = 0; l < COUNT(leaves); l++) {
            struct pattern p = pattern_alloc(n, NONE, 1, leaves[l]);
            const struct sparse *s = p.sparse;
            struct matrix *A = matrix_alloc_sparse(s);
            for (int v = 0; v < s->n_vertex; v++)
                for (int b = s->start[v] + 1; b < s->start[v + 1]; b++)
                    for (int d = 0; d < 2; d++) {
                        const int i = 2 * s->row[b] + d, j = 2 * v + d;
                        const double k =
                            2.385e9 * (1.0 + 0.5 * sin(3.714 * i + j));
                        matrix_add(A, i, i, k);
                        matrix_add(A, j, j, k);
                        matrix_add(A, i, j, -k);
                    }
            struct matrix *held = matrix_copy(A);
            matrix_add(held, 0, 0, 1e3); /* weak springs, and it is SPD */
            matrix_add(held, 1, 1, 1e3);
            ck_assert_int_eq(matrix_factor(A), NOT_SPD);
            ck_assert_int_eq(matrix_factor(held), OK);
            matrix_free(held);
            matrix_free(A);
            pattern_free(p);
        }
}

/* Unknowns of very different scales. */
static void a_pivot_is_compared_with_its_own_diagonal(void)
{
    for (int l = 0; l < COUNT(leaves); l++) {
        struct pattern p = pattern_alloc(8, ENDS, 1, leaves[l]);
        const struct sparse *s = p.sparse;
        struct matrix *A, *B;
        random_pair(p, 3, &A, &B);
        for (int v = 0; v < s->n_vertex; v++)
            for (int k = 4 * s->start[v]; k < 4 * s->start[v + 1]; k++)
                A->a[k] *= pow(10.0, 9.0 * sin(s->row[k / 4]) + 9.0 * sin(v));
        ck_assert_int_eq(matrix_factor(A), OK);
        matrix_free(A);
        matrix_free(B);
        pattern_free(p);
    }
}

static void the_verbs_are_those_of_dense_storage(void)
{
    for (int hold = 0; hold < HOLDS; hold++) {
        struct pattern p = pattern_alloc(7, hold, 3, 5);
        struct matrix *A, *B;
        double x[200], y[200], z[200];
        random_pair(p, 3, &A, &B);
        fill(p.n, x);
        matrix_multiply(A, x, y);
        matrix_multiply(B, x, z);
        same(p.n, y, z, 10 * DBL_EPSILON);
        for (int i = 0; i < p.n; i++)
            for (int j = 0; j < p.n; j++)
                ck_assert(matrix_get(A, i, j) == matrix_get(B, i, j));
        ck_assert(matrix_max_diagonal(A) == matrix_max_diagonal(B));
        const size_t entries = 4 * (size_t)p.sparse->start[p.n / 2];
        ck_assert_uint_eq(matrix_bytes(A), 8 * entries);
        struct matrix *C = matrix_copy(A);
        matrix_combine(A, -0.5, A, C);
        for (int i = 0; i < p.n; i++)
            ck_assert(matrix_get(C, i, 0) == 0.5 * matrix_get(B, i, 0));
        ck_assert_int_eq(matrix_factor(A), OK);
        ck_assert_int_eq(A->p, A->n - 1);
        ck_assert_uint_eq(matrix_bytes(A), 8 * (entries + p.sparse->factor +
                                                p.sparse->room));
        matrix_zero(A);
        ck_assert(matrix_get(A, 3, 3) == 0.0 && matrix_get(C, 3, 3) > 2.0);
        matrix_free(A);
        matrix_free(B);
        matrix_free(C);
        pattern_free(p);
    }
}

/* Of all sizes, so that signs change in panels that are whole, cut off, and
 * many; with a diagonal that dominates no pivot is small. */
static void what_is_indefinite_is_solved_with_signs(void)
{
    for (int n = 1; n <= 14; n += 2 + n % 3)
        for (int hold = 0; hold < HOLDS; hold++)
            for (int l = 0; l < COUNT(leaves); l++) {
                struct pattern p = pattern_alloc(n, hold, (unsigned)(n + l),
                                                 leaves[l]);
                struct matrix *A, *B;
                double x[450], b[450], value[450];
                int negative, expected = 0;
                random_pair(p, 3, &A, &B);
                for (int k = 0; k < p.n; k++)
                    if (k % 7 == 4 || k % 16 / 8 == 1) {
                        matrix_add(A, k, k, -10.77);
                        matrix_add(B, k, k, -10.77);
                    }
                fill(p.n, b);
                fill(p.n, x);
                ck_assert_int_eq(matrix_solve_indefinite(A, x, &negative), OK);
                ck_assert_double_le(matrix_residual(B, x, b), 1e-13);
                matrix_eigenvalues(B, value);
                for (int k = 0; k < p.n; k++) expected += value[k] < 0.0;
                ck_assert_int_eq(negative, expected);
                matrix_free(A);
                matrix_free(B);
                pattern_free(p);
            }
}

/* Pivots of 1e-7 make entries of L large; one system more brings the digits
 * back. */
static void small_pivots_cost_no_digits(void)
{
    for (int hold = 0; hold < HOLDS; hold++) {
        struct pattern p = pattern_alloc(9, hold, 3, 5);
        struct matrix *A, *B;
        double x[250], b[250];
        random_pair(p, 3, &A, &B);
        for (int k = 0; k < p.n; k += 3) {
            const double less = 1e-7 - matrix_get(A, k, k);
            matrix_add(A, k, k, less);
            matrix_add(B, k, k, less);
        }
        fill(p.n, b);
        fill(p.n, x);
        ck_assert_int_eq(matrix_solve_indefinite(A, x, NULL), OK);
        ck_assert_double_le(matrix_residual(B, x, b), 1e-13);
        matrix_free(A);
        matrix_free(B);
        pattern_free(p);
    }
}

static void a_pivot_of_zero_is_reported_with_signs(void)
{
    for (int l = 0; l < COUNT(leaves); l++)
        for (int bad = 0; bad < 3; bad++) {
            struct pattern p = pattern_alloc(6, ENDS, 1, leaves[l]);
            struct matrix *A, *B;
            double x[100];
            random_pair(p, 3, &A, &B);
            fill(p.n, x);
            matrix_add(A, 0, 0, bad == 0   ? -matrix_get(A, 0, 0)
                                : bad == 1 ? (double)INFINITY
                                           : (double)NAN);
            ck_assert_int_eq(matrix_solve_indefinite(A, x, NULL), NOT_SPD);
            matrix_free(A);
            matrix_free(B);
            pattern_free(p);
        }
}

/* max|b - A x| / max|b| of one solve. */
static double residual_of(const struct matrix *A, const double b[], double x[])
{
    double largest = 0.0;
    memcpy(x, b, (size_t)A->n * sizeof *x);
    matrix_solve(A, x);
    for (int i = 0; i < A->n; i++) largest = fmax(largest, fabs(b[i]));
    return matrix_residual(A, x, b) / largest;
}

static void rounded_factors_have_seven_digits(void)
{
    for (int n = 1; n <= 14; n++)
        for (int hold = 0; hold < HOLDS; hold++)
            for (int l = 0; l < COUNT(leaves); l++) {
                struct pattern p = pattern_alloc(n, hold, (unsigned)(n + l),
                                                 leaves[l]);
                const struct sparse *s = p.sparse;
                const size_t entries = 4 * (size_t)s->start[s->n_vertex];
                struct matrix *A, *B;
                double b[450], x[450];
                random_pair(p, 1 + (unsigned)l, &A, &B);
                fill(p.n, b);
                for (int single = 1; single >= 0; single--) {
                    matrix_keep_single(A, single);
                    ck_assert_uint_eq(matrix_bytes(A), 8 * entries);
                    ck_assert_int_eq(matrix_factor(A), OK);
                    ck_assert_uint_eq(matrix_bytes(A),
                                      8 * (entries + sparse_size(s, single)));
                    const double residual = residual_of(A, b, x);
                    ck_assert_double_le(residual, single ? 4e-7 : 1e-14);
                    if (single && p.n > 10) ck_assert_double_gt(residual, 1e-9);
                    matrix_keep_single(A, single); /* nothing is lost */
                    ck_assert(residual_of(A, b, x) == residual);
                }
                ck_assert_uint_eq(sparse_size(s, 0), s->room + s->factor);
                ck_assert_uint_eq(sparse_size(s, 1) - s->room,
                                  (s->factor + 1) / 2);
                matrix_free(A);
                matrix_free(B);
                pattern_free(p);
            }
}

static void factors_solve_on_their_way(void)
{
    for (int n = 1; n <= 14; n++)
        for (int hold = 0; hold < HOLDS; hold++)
            for (int kind = 0; kind < 3; kind++) { /* single, double, dense */
                struct pattern p = pattern_alloc(n, hold, (unsigned)n, 5);
                struct matrix *A, *B;
                double x[450], y[450];
                random_pair(p, 7, &A, &B);
                matrix_keep_single(A, kind == 0);
                struct matrix *C = matrix_copy(kind < 2 ? A : B);
                if (kind == 0) matrix_keep_single(C, 1);
                fill(p.n, x);
                ck_assert_int_eq(matrix_factor(kind < 2 ? A : B), OK);
                matrix_solve(kind < 2 ? A : B, x);
                for (int turn = 0; turn < (kind < 2 ? 2 : 1); turn++) {
                    fill(p.n, y);
                    ck_assert_int_eq(matrix_factor_solve(C, y), OK);
                    for (int i = 0; i < p.n; i++) ck_assert(x[i] == y[i]);
                }
                matrix_free(A);
                matrix_free(B);
                matrix_free(C);
                pattern_free(p);
            }
}

/* The factors of A for the matrix c A: each turn leaves |1 - c| of the
 * residual. */
static void a_turn_must_halve_the_residual(void)
{
    static const double c[] = {0.55, 1.4, 0.45, 1.55};
    struct pattern p = pattern_alloc(7, ENDS, 3, 5);
    for (int k = 0; k < COUNT(c); k++) {
        struct matrix *A, *B;
        double b[200], x[200];
        random_pair(p, 3, &A, &B);
        ck_assert_int_eq(matrix_factor(A), OK);
        for (size_t i = 0; i < A->size; i++) A->a[i] *= c[k];
        fill(p.n, b);
        memcpy(x, b, sizeof x);
        ck_assert_int_eq(refine_solve(A, 1e-12, x, NULL), k < 2 ? OK : STALLED);
        if (k < 2) ck_assert_double_le(matrix_residual(A, x, b), 1e-10);
        matrix_free(A);
        matrix_free(B);
    }
    pattern_free(p);
}

static void refinement_ends_and_says_how(void)
{
    struct pattern p = pattern_alloc(7, ENDS, 3, 5);
    struct matrix *A, *B;
    double b[200] = {0.0};
    int solves;
    random_pair(p, 3, &A, &B);
    ck_assert_int_eq(matrix_factor(A), OK);
    ck_assert_int_eq(refine_solve(A, 1e-12, b, &solves), OK);
    ck_assert_int_eq(solves, 0);
    for (int i = 0; i < p.n; i++) b[i] = -2.385; /* it is no zero */
    ck_assert_int_eq(refine_solve(A, 1e-12, b, &solves), OK);
    ck_assert_int_eq(solves, 1);
    for (int at = 0; at < p.n; at += p.n - 1) { /* one entry, first or last */
        memset(b, 0, sizeof b);
        b[at] = 2.385;
        ck_assert_int_eq(refine_solve(A, 1e-12, b, &solves), OK);
        ck_assert_int_eq(solves, 1);
        ck_assert(b[at] != 0.0);
    }
    fill(p.n, b);
    ck_assert_int_eq(refine_solve(A, 0.0, b, &solves), STALLED);
    ck_assert_int_le(solves, 9);
    fill(p.n, b);
    b[5] = (double)NAN;
    ck_assert_int_eq(refine_solve(A, 1e-12, b, NULL), NONFINITE);
    matrix_free(A);
    matrix_free(B);
    pattern_free(p);
}

static void a_step_in_either_storage_is_the_same(void)
{
    const char *method[] = {"notes", "lift", "all"};
    for (int reading = STRETCH; reading <= SPIN; reading++)
        for (int m = 0; m < COUNT(method); m++) {
            struct scene_setting set = scene_notes((enum reading)reading,
                                                   CUBIC, 9);
            struct scene *s[2] = {scene_alloc(&set), scene_alloc(&set)};
            const struct step_control control = step_method(method[m]);
            body_store(s[1]->body, SPARSE);
            for (int step = 0; step < 3; step++)
                for (int k = 0; k < 2; k++) {
                    const struct step_report r = scene_step(s[k], &control);
                    ck_assert_int_eq(r.status, OK);
                    ck_assert_int_eq(s[k]->body->K->storage,
                                     k ? SPARSE : BANDED);
                }
            same(s[0]->n_dof, s[1]->u, s[0]->u, 1e-12);
            for (int k = 0; k < 2; k++) scene_free(s[k]);
        }
}

static void a_step_with_rounded_factors_is_the_same(void)
{
    for (int reading = STRETCH; reading <= SPIN; reading++)
        for (int chord = 0; chord < 2; chord++) {
            struct scene_setting set = scene_notes((enum reading)reading,
                                                   CUBIC, 9);
            struct scene *s[2] = {scene_alloc(&set), scene_alloc(&set)};
            struct step_control control = step_method("lift");
            struct step_report r[2];
            control.chord = chord;
            body_store(s[1]->body, SPARSE); /* and a band is not rounded */
            for (int step = 0; step < 6; step++) {
                for (int k = 0; k < 2; k++) {
                    s[k]->body->kept.usable = 0;
                    r[k] = scene_step(s[k], &control);
                    ck_assert_int_eq(r[k].status, OK);
                }
                ck_assert_int_le(abs(r[0].iterations - r[1].iterations), 1);
                ck_assert_int_eq(s[1]->body->K->single, chord);
            }
            same(s[0]->n_dof, s[1]->u, s[0]->u, 1e-12);
            for (int k = 0; k < 2; k++) scene_free(s[k]);
        }
}

/* The inverting scene of the notes' Newton: K is indefinite on the way, and
 * solved as it is, or projected. */
static void an_indefinite_step_is_the_same_too(void)
{
    struct scene_setting set = scene_notes(GRAVITY, CUBIC, 6);
    for (int project = 0; project < 2; project++) {
        struct scene *s[2] = {scene_alloc(&set), scene_alloc(&set)};
        struct step_control control = step_method(project ? "demand" : "notes");
        struct step_report report[2];
        body_store(s[1]->body, SPARSE);
        for (int k = 0; k < 2; k++) {
            double w[98] = {0.0};
            first_scatter(s[k], 3, 0.3);
            control.max_iterations = 3;
            const struct incremental Phi = {1.0, w, s[k]->f};
            report[k] = step_solve(s[k]->body, &control, Phi, s[k]->u);
            ck_assert_int_ge(report[k].indefinite, !project);
            ck_assert_int_ge(report[k].projections, project);
        }
        ck_assert_int_eq(report[0].indefinite, report[1].indefinite);
        same(s[0]->n_dof, s[1]->u, s[0]->u, 1e-9);
        for (int k = 0; k < 2; k++) scene_free(s[k]);
    }
}

/* At n and below it: one more cell across, of quadratic triangles two. */
static void stores_from(enum element element, int from)
{
    const int less = element == QUADRATIC_TRIANGLE ? 2 : 1;
    for (int n = from - less; n <= from; n += less) {
        struct scene_setting set = scene_notes(STRETCH, CUBIC, n);
        set.element = element;
        struct scene *s = scene_alloc(&set);
        ck_assert_int_eq(s->body->K->storage, n == from ? SPARSE : BANDED);
        struct matrix *A = body_matrix(s->body);
        ck_assert_int_eq(A->storage, n == from ? SPARSE : BANDED);
        body_store(s->body, BANDED);
        ck_assert_int_eq(s->body->K->storage, BANDED);
        if (element == LINEAR_TRIANGLE)
            ck_assert_int_eq(s->body->K->p, 2 * n - 1);
        matrix_free(A);
        scene_free(s);
    }
}

static void a_body_chooses_its_storage_by_n(void)
{
    stores_from(LINEAR_TRIANGLE, BODY_SPARSE_FROM);
    stores_from(QUADRATIC_TRIANGLE, BODY_QUADRATIC_SPARSE_FROM);
}

UNIT_MAIN("sparse",
    LAW(a_line_separates_its_two_sides),
    LAW(fill_is_what_the_fronts_must_hold),
    LAW(solve_equals_dense_for_random_patterns),
    LAW(a_front_of_many_panels_is_that_of_elimination),
    LAW(what_is_singular_is_not_spd),
    LAW(a_pivot_is_compared_with_its_own_diagonal),
    LAW(the_verbs_are_those_of_dense_storage),
    LAW(what_is_indefinite_is_solved_with_signs),
    LAW(small_pivots_cost_no_digits),
    LAW(a_pivot_of_zero_is_reported_with_signs),
    LAW(rounded_factors_have_seven_digits),
    LAW(factors_solve_on_their_way),
    LAW(a_turn_must_halve_the_residual),
    LAW(refinement_ends_and_says_how),
    LAW(a_step_in_either_storage_is_the_same),
    LAW(a_step_with_rounded_factors_is_the_same),
    LAW(an_indefinite_step_is_the_same_too),
    LAW(a_body_chooses_its_storage_by_n))
