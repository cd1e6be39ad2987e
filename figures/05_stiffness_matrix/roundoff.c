/*
 * roundoff.c - from which mesh on does round-off undo what refining gains?
 *
 * -u'' = 1 with u = 0 at both ends of (0, 1) on n elements, by Cholesky's
 * method [eq:cholesky] for p = 1, in single and in double precision.  Each
 * operation is rounded by itself, so that every machine computes the same.
 * Tables: flops of the factorisation [eq:band-cost]; largest error of u at
 * nodes, where only round-off errs, and in the middle of elements, over the
 * largest u; the error of exact arithmetic; and the residual |b - A u| / (|A|
 * |u|) in epsilons.  Then the n with the least error, and the largest residual.
 */
#include "linear/matrix.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum precision { SINGLE, DOUBLE };

/* Through memory, so that no machine keeps more digits. */
static double rounded(enum precision to, double value)
{
    const volatile float single = (float)value;
    const volatile double twice = value;
    return to == SINGLE ? (double)single : twice;
}

/* u[0..n], from tridiag(-1, 2, -1) u = h^2, with L's diagonal in l. */
static void solve(enum precision to, int n, double l[], double u[])
{
    const double h2 = 1.0 / n / n;
    u[0] = 0.0;
    l[0] = INFINITY; /* nothing is left of node 1 */
    for (int i = 1; i < n; i++) {
        const double below = rounded(to, -1.0 / l[i - 1]);
        const double square = rounded(to, below * below);
        l[i] = rounded(to, sqrt(rounded(to, 2.0 - square)));
        const double product = rounded(to, below * u[i - 1]);
        u[i] = rounded(to, rounded(to, h2 - product) / l[i]);
    }
    u[n] = 0.0;
    for (int i = n - 1; i > 0; i--) {
        const double below = i < n - 1 ? rounded(to, -1.0 / l[i]) : 0.0;
        const double product = rounded(to, below * u[i + 1]);
        u[i] = rounded(to, rounded(to, u[i] - product) / l[i]);
    }
}

static double exact(double x)
{
    return 0.5 * rounded(DOUBLE, x * (1.0 - x));
}

static double error(int n, const double u[])
{
    double worst = 0.0;
    for (int i = 0; i < n; i++) {
        const double x = (double)i / n, middle = (i + 0.5) / n;
        const double chord = 0.5 * rounded(DOUBLE, u[i] + u[i + 1]);
        worst = fmax(worst, fmax(fabs(u[i] - exact(x)),
                                 fabs(chord - exact(middle))));
    }
    return worst / 0.125;
}

static double residual(enum precision to, int n, const double u[])
{
    double worst = 0.0;
    for (int i = 1; i < n; i++) {
        const double sum = rounded(DOUBLE, u[i - 1] + u[i + 1]);
        const double force = rounded(DOUBLE, 2.0 * u[i] - sum);
        worst = fmax(worst, fabs(1.0 / n / n - force));
    }
    return worst / (4.0 * 0.125) / (to == SINGLE ? FLT_EPSILON : DBL_EPSILON);
}

int main(void)
{
    double best[] = {INFINITY, INFINITY}, last[2], worst = 0.0;
    int at[2] = {0};

    table_begin("roundoff", "n flops single double exact residual_single "
                            "residual_double");
    for (int n = 4; n <= 1 << 20; n *= 2) {
        double *l = allocate((size_t)n + 1, sizeof *l);
        double *u = allocate((size_t)n + 1, sizeof *u);
        double r[2];
        for (int to = SINGLE; to <= DOUBLE; to++) {
            solve((enum precision)to, n, l, u);
            last[to] = error(n, u);
            r[to] = residual((enum precision)to, n, u);
            worst = fmax(worst, r[to]);
            if (last[to] < best[to]) {
                best[to] = last[to];
                at[to] = n;
            }
        }
        table_row(n, matrix_cost(BANDED, n - 1, 1).flops, last[SINGLE],
                  last[DOUBLE], 1.0 / n / n, r[SINGLE], r[DOUBLE]);
        free(l);
        free(u);
    }
    table_end();
    table_begin("best", "single double residual");
    table_row(at[SINGLE], at[DOUBLE], worst);
    table_end();
    claim(at[SINGLE] < at[DOUBLE] && last[SINGLE] > 0.9 &&
              last[DOUBLE] > 1000.0 * best[DOUBLE],
          "beyond %d elements in single and %d in double precision the error "
          "grows, to %g and %g", at[SINGLE], at[DOUBLE], last[SINGLE],
          last[DOUBLE]);
    claim(worst <= 1.0, "the residual is at most one epsilon on every mesh "
          "(%g)", worst);
    return table_finish();
}
