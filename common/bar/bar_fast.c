/* bar_fast.c - see bar_fast.h. */
#include "bar/bar_fast.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

/* What a sweep carries from element to element. */
struct front {
    int held;     /* it started at a prescribed end */
    double c;     /* held: compliance of what lies behind; else not used */
    double y;     /* force of what lies behind on the node: -q, eliminated */
    double P;     /* stress of the element behind; 0 beyond a free end */
    double max_q; /* so far; a NaN does not stay here, but it does in y */
    int singular; /* a pivot was 0 to round-off */
};

/* P = v (p[0] + p[1] v + ... + p[4] v^4) of v = u_e - u_{e-1}; k = dP/dv. */
struct polynomial {
    double p[5], k[5];
};

/* The cubic law multiplied out, with e = v / h [eq:pk1-neohookean]
 * [eq:r-cubic]: P = mu (2 e - e^2) + lambda r r'. */
static struct polynomial stress_polynomial(const struct bar *bar)
{
    const double mu = bar->material.mu, lambda = bar->material.lambda;
    const double p[5] = {2.0 * mu + lambda, -mu - 1.5 * lambda,
                         11.0 / 6.0 * lambda, -5.0 / 6.0 * lambda,
                         lambda / 3.0};
    struct polynomial result;
    double power = 1.0;
    for (int a = 0; a < 5; a++) {
        power /= bar->h;
        result.p[a] = p[a] * power;
        result.k[a] = (a + 1) * result.p[a];
    }
    return result;
}

static inline double horner(const double a[5], double v)
{
    return a[0] + v * (a[1] + v * (a[2] + v * (a[3] + v * a[4])));
}

/*
 * Eliminate the node of the front: sign +1 for a sweep to the right, -1 to the
 * left; v = u_e - u_{e-1} of the element ahead, b the node's load.
 */
static inline void eliminate(const struct polynomial *law, double sign,
                             double v, double b, struct front *f, double *l,
                             double *z)
{
    const double P = v * horner(law->p, v), k = horner(law->k, v);
    const double minus_q = sign * (P - f->P) + b, y = f->y + minus_q;
    const double per_k = 1.0 / k;

    if (!(fabs(minus_q) <= f->max_q)) f->max_q = fabs(minus_q);
    if (f->held) {
        const double t = k * f->c; /* pivot = (1 + t) / c */
        const double w = 1.0 / (1.0 + t);
        if (!(fabs(w) < 1.0 / DBL_EPSILON)) f->singular = 1;
        *l = t * w;
        *z = y * f->c * w;
        f->c += per_k;
    } else { /* pivot = k */
        *l = 1.0;
        *z = y * per_k;
    }
    f->y = *l * y;
    f->P = P;
}

/* The front at an end; behind a prescribed end lies its first element. */
static struct front front_make(const struct polynomial *law, int held,
                               double v)
{
    struct front f = {.held = held};
    if (!held) return f;
    f.P = v * horner(law->p, v);
    f.c = 1.0 / horner(law->k, v);
    return f;
}

/*
 * Residual, tangent and elimination in one pass.  The fronts meet at node m,
 * 1 <= m <= n; du_m is its increment.  NOT_SPD when a pivot vanishes.
 */
static enum status sweep_forward(const struct bar *bar, const double u[],
                                 int m, double l[], double z[], double *max_q,
                                 double *du_m)
{
    const int n = bar->n;
    const double *b = bar->b;
    const struct polynomial law = stress_polynomial(bar);
    struct front L = front_make(&law, bar->held[0], u[1] - u[0]);
    struct front R =
        front_make(&law, m < n && bar->held[1], u[n] - u[n - 1]);
    int i = L.held, j = n - R.held; /* at a held end l and z stay 0 */

    for (; i < m && j > m; i++, j--) {
        eliminate(&law, 1.0, u[i + 1] - u[i], b[i], &L, &l[i], &z[i]);
        eliminate(&law, -1.0, u[j] - u[j - 1], b[j], &R, &l[j], &z[j]);
    }
    for (; i < m; i++)
        eliminate(&law, 1.0, u[i + 1] - u[i], b[i], &L, &l[i], &z[i]);
    for (; j > m; j--)
        eliminate(&law, -1.0, u[j] - u[j - 1], b[j], &R, &l[j], &z[j]);
    *max_q = R.max_q > L.max_q ? R.max_q : L.max_q;
    *du_m = 0.0;
    const int open = m < n || !bar->held[1]; /* node m may move */
    const double minus_q = open ? R.P - L.P + b[m] : 0.0;
    const double y = L.y + R.y + minus_q;
    const double k_L = L.held ? 1.0 / L.c : 0.0, k_R = R.held ? 1.0 / R.c : 0.0;
    const double zero = DBL_EPSILON * (fabs(k_L) + fabs(k_R));
    const double pivot = k_L + k_R;
    if (!isfinite(y) || !isfinite(L.c) || !isfinite(R.c)) return NONFINITE;
    if (fabs(minus_q) > *max_q) *max_q = fabs(minus_q);
    if (L.singular || R.singular || (open && fabs(pivot) <= zero))
        return NOT_SPD;
    if (open) *du_m = y / pivot;
    return OK;
}

/* u += du outwards from node m, which has no fewer nodes on its left; returns
 * max |du|, not finite if any is not. */
static double sweep_back(int n, int m, const double l[], const double z[],
                         double du_m, double u[])
{
    double left = du_m, right = du_m, largest = fabs(du_m);
    int i = m - 1, j = m + 1;

    u[m] += du_m;
    for (; i >= 0 && j <= n; i--, j++) {
        left = z[i] + l[i] * left;
        right = z[j] + l[j] * right;
        u[i] += left;
        u[j] += right;
        if (!(fabs(left) <= largest)) largest = fabs(left);
        if (!(fabs(right) <= largest)) largest = fabs(right);
    }
    for (; i >= 0; i--) {
        left = z[i] + l[i] * left;
        u[i] += left;
        if (!(fabs(left) <= largest)) largest = fabs(left);
    }
    return largest + 0.0 * (left + right);
}

struct newton_report bar_fast_newton(const struct bar *bar,
                                     const struct newton_control *control,
                                     enum elimination sweep, double u[])
{
    assert(bar->material.law == CUBIC && !control->line_search &&
           !control->definite);
    const int n = bar->n, m = sweep == FROM_LEFT ? n : (n + 1) / 2;
    const size_t size = (size_t)n + 1;
    struct newton_report report = {MAX_ITERATIONS, 0, 0.0, 0.0};
    double *l = allocate(size, sizeof *l), *z = allocate(size, sizeof *z);
    const double force = control->tolerance * material_modulus(&bar->material);
    const double length = control->tolerance * n * bar->h;

    for (int k = 0;; k++) {
        double du_m;
        report.status =
            sweep_forward(bar, u, m, l, z, &report.residual, &du_m);
        if (report.status == NONFINITE) break;
        if (report.residual <= force && (k > 0 ? report.increment <= length
                                               : report.residual == 0.0)) {
            report.status = OK;
            break;
        }
        if (k > 0 && report.increment <= DBL_EPSILON * n * bar->h) {
            report.status = STALLED;
            break;
        }
        if (report.status != OK) break;
        report.status = MAX_ITERATIONS;
        if (k == control->max_iterations) break;
        report.iterations = k + 1;
        report.increment = sweep_back(n, m, l, z, du_m, u);
        if (!isfinite(report.increment)) {
            report.status = NONFINITE;
            break;
        }
    }
    free(l);
    free(z);
    return report;
}
