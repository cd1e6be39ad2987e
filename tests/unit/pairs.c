/* pairs.c - laws of figures/21_sparse_cholesky/pairs.h.  The judge is the
 * formula of Broyden, Fletcher, Goldfarb and Shanno, pair after pair:
 *     H := (I - s y^T / s.y) H (I - y s^T / s.y) + s s^T / s.y. */
#include "figures/21_sparse_cholesky/pairs.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = 7, PAIRS = 12 };

/* Numbers without a pattern, in (-1, 1). */
static double entropy(int i) { return sin(2.385 * i * i + 3.714 * i + 0.7); }

/* Of a definite matrix without a pattern: its factors, and its inverse. */
static struct matrix *factors(double H[N][N])
{
    struct matrix *K = matrix_alloc(DENSE, N, 0);
    for (int i = 0; i < N; i++)
        for (int j = 0; j <= i; j++) {
            const double a = entropy(N * i + j) + (i == j ? 6.0 : 0.0);
            matrix_add(K, i, j, a);
            if (i != j) matrix_add(K, j, i, a);
        }
    ck_assert_int_eq(matrix_factor(K), OK);
    for (int j = 0; j < N; j++) {
        double e[N] = {0.0};
        e[j] = 1.0;
        matrix_solve(K, e);
        for (int i = 0; i < N; i++) H[i][j] = e[i];
    }
    return K;
}

static double dot(const double a[], const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < N; i++) sum += a[i] * b[i];
    return sum;
}

static void update(double H[N][N], const double s[], const double y[])
{
    const double sy = dot(s, y);
    double Hy[N] = {0.0};
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) Hy[i] += H[i][j] * y[j];
    const double yHy = dot(y, Hy);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            H[i][j] += (1.0 + yHy / sy) * s[i] * s[j] / sy -
                       (Hy[i] * s[j] + s[i] * Hy[j]) / sy;
}

/* What the last pairs say, at most `most` of them, whatever has gone before; a
 * pair whose s.y is not positive says nothing, and leaves the others. */
static void two_loops_are_the_formula(void)
{
    double H0[N][N];
    struct matrix *K = factors(H0);
    for (int most = 0; most <= MOST_PAIRS; most++) {
        struct pairs p = pairs_make(N);
        double s[PAIRS][N], y[PAIRS][N], before[N], step[N] = {0.0};
        int n = 0, refused = 0;
        for (int k = 0; k < PAIRS; k++) {
            double b[N], H[N][N], want[N] = {0.0};
            const int bad = k == 2 || k == 7;
            for (int i = 0; i < N; i++) /* K step, and a little else */
                b[i] = k == 0 ? entropy(i)
                              : before[i] + (bad ? -9.0 : 9.0) * step[i] +
                                    0.3 * entropy(N * k + i);
            if (k > 0) {
                for (int i = 0; i < N; i++) {
                    s[n][i] = step[i];
                    y[n][i] = b[i] - before[i];
                }
                ck_assert((dot(s[n], y[n]) > 0.0) == !bad);
                refused += bad;
                n += !bad;
                pairs_learn(&p, b);
            }
            ck_assert_int_eq(p.count, n);
            memcpy(before, b, sizeof b);
            memcpy(H, H0, sizeof H);
            for (int i = n > most ? n - most : 0; i < n; i++)
                update(H, s[i], y[i]);
            for (int i = 0; i < N; i++) want[i] = dot(H[i], b);
            const double flops = pairs_solve(&p, most, K, b);
            ck_assert_double_eq(flops, 8.0 * N * (n < most ? n : most));
            for (int i = 0; i < N; i++) {
                close_to(b[i], want[i], 1e-12);
                step[i] = -b[i];
            }
        }
        ck_assert_int_eq(refused, 2);
        pairs_free(&p);
    }
    matrix_free(K);
}

static const struct unit_law laws[] = {
    {"two_loops_are_the_formula", two_loops_are_the_formula},
};

UNIT_MAIN("pairs", laws)
