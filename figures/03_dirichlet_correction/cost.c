/*
 * cost.c - what does a 1 on the diagonal cost conjugate gradients?
 *
 * -beta u'' = f in (0, 1), u(0) = g, n elements; the equation of node 0 has the
 * old diagonal entry, or 1, or 1 with a start at u_0 = g, where it is
 * satisfied.  Tables: counts (condition number; iterations that its bound
 * 2 ((s-1)/(s+1))^k, s^2 the condition number, allows to 1e-10, and those until
 * |r| <= 1e-10 |b|), path (error after each iteration, over the first, in the
 * norm of the bound, (e^T A e)^(1/2); n = 64), and units (beta and f times a
 * scale, which does not change u: the largest error when |r| <= 1e-6 |b|).
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"
#include "../22_multigrid/conjugate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FINEST = 256 };
enum start { KEPT, ONE, ONE_FROM_G, STARTS };
static const char *const NAME[STARTS] = {"kept", "one", "one_from_g"};
static const double beta = 17500.0 / 13.0;
static const struct poisson_held *const held = &POISSON_HELD;

struct bar {
    int n;
    struct matrix *A; /* corrected */
    struct csr *K;    /* A once more */
    double b[FINEST + 1], u[FINEST + 1], exact[FINEST + 1];
};

static struct bar bar_alloc(int n, enum start start, double scale)
{
    const int left = 0;
    struct bar s = {.n = n, .A = matrix_alloc(DENSE, n + 1, 1),
                    .K = csr_alloc(n + 1, 3 * n + 3)};
    int entries = 0;
    for (int e = 0; e < n; e++)
        for (int a = 0; a < 2; a++) {
            s.b[e + a] += 0.5 * scale * held->f / n;
            for (int c = 0; c < 2; c++)
                matrix_add(s.A, e + a, e + c,
                           (a == c ? 1 : -1) * scale * beta * n);
        }
    matrix_dirichlet(s.A, s.b, 1, &left, held->g,
                     start == KEPT ? KEEP_DIAGONAL : UNIT_DIAGONAL);
    /* from u_0 = g: what is left of b is 0 there, and as it was elsewhere */
    if (start == ONE_FROM_G) s.b[0] = 0.0;
    for (int i = 0; i <= n; i++) {
        s.exact[i] = held->g[0] + held->f / beta * i / n * (1.0 - 0.5 * i / n);
        for (int j = i > 0 ? i - 1 : 0; j <= n && j <= i + 1; j++) {
            s.K->index[entries] = j;
            s.K->value[entries++] = matrix_get(s.A, i, j);
        }
        s.K->start[i + 1] = entries;
    }
    return s;
}

static void bar_free(struct bar *s)
{
    matrix_free(s->A);
    csr_free(s->K);
}

/* No preconditioner: z = r. */
static void identity(const void *n, const double r[], double z[])
{
    memcpy(z, r, (size_t)(*(const int *)n + 1) * sizeof *z);
}

static int solve(struct bar *s, enum start start, double tolerance, int cap)
{
    const int iterations = cg_solve(s->K, identity, &s->n, tolerance, cap, s->b,
                                    s->u).iterations;
    if (start == ONE_FROM_G) s->u[0] += held->g[0];
    return iterations;
}

/* Relative to the largest u. */
static double largest_error(const struct bar *s)
{
    double error = 0.0;
    for (int i = 0; i <= s->n; i++)
        error = fmax(error, fabs(s->u[i] - s->exact[i]));
    return error / s->exact[s->n];
}

/* (e^T A e)^(1/2), the norm of the bound. */
static double energy_error(const struct bar *s)
{
    double square = 0.0;
    for (int i = 0; i <= s->n; i++)
        for (int j = 0; j <= s->n; j++)
            square += (s->u[i] - s->exact[i]) * matrix_get(s->A, i, j) *
                      (s->u[j] - s->exact[j]);
    return sqrt(square);
}

static double bound(const struct bar *s, double *kappa)
{
    double *value = allocate((size_t)s->n + 1, sizeof *value);
    if (matrix_eigenvalues(s->A, value) != OK) die("A is not finite");
    *kappa = value[s->n] / value[0];
    free(value);
    return log(2e10) / log((sqrt(*kappa) + 1.0) / (sqrt(*kappa) - 1.0));
}

int main(void)
{
    int count[STARTS];
    double kappa, allowed[STARTS] = {0.0}, first = 0.0, worst[STARTS] = {0.0};

    table_begin("counts", "n start condition allowed iterations");
    for (int n = 64; n <= FINEST; n *= 4) {
        for (int k = KEPT; k < STARTS; k++) {
            struct bar s = bar_alloc(n, (enum start)k, 1.0);
            const double most = bound(&s, &kappa);
            if (n == 64) allowed[k] = most;
            count[k] = solve(&s, (enum start)k, 1e-10, 10 * n);
            table_row(n, NAME[k], cell_rounded(5, kappa),
                      cell_rounded(4, most), count[k]);
            bar_free(&s);
        }
        claim(count[KEPT] == n && count[ONE_FROM_G] == n && count[ONE] > n &&
                  count[ONE] < 1.07 * n, "n = %d: a 1 costs a few iterations "
              "(%d for %d), and none from u_0 = g", n, count[ONE], count[KEPT]);
    }
    table_end();
    table_begin("path", "start iteration error");
    for (int k = KEPT; k < STARTS; k++)
        for (int cap = 0; cap <= 68; cap++) {
            struct bar s = bar_alloc(64, (enum start)k, 1.0);
            solve(&s, (enum start)k, 1e-10, cap);
            if (cap == 0) first = energy_error(&s);
            const double e = energy_error(&s) / first;
            claim(e <= 2.0 * pow(2e10, -cap / allowed[k]),
                  "in its norm the error stays below its bound");
            table_row(NAME[k], cap, cell_if(e > 1e-6, e)); /* else round-off */
            bar_free(&s);
        }
    table_end();
    table_begin("units", "start scale iterations error");
    for (int k = KEPT; k < STARTS; k++)
        for (int power = -4; power <= 6; power++) {
            struct bar s = bar_alloc(64, (enum start)k, pow(10.0, power));
            const int n = solve(&s, (enum start)k, 1e-6, 640);
            const double e = largest_error(&s);
            worst[k] = fmax(worst[k], e);
            table_row(NAME[k], pow(10.0, power), n, e > 1e-6 ? e : 0.0);
            bar_free(&s);
        }
    table_end();
    claim(worst[ONE] > 0.7 && fmax(worst[KEPT], worst[ONE_FROM_G]) < 1e-6,
          "with a 1 the residual accepts an error of %g, with the old entry "
          "one of %g", worst[ONE], worst[KEPT]);
    return table_finish();
}
