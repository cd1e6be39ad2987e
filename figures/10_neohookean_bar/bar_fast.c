/* bar_fast.c - see bar_fast.h. */
#include "bar_fast.h"

#include "linear/vec.h"

#include <assert.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

typedef long long bits __attribute__((vector_size(sizeof(two))));

/* What the two sweeps carry from element to element: in lane 0 that to the
 * right, in lane 1 that to the left. */
struct fronts {
    two u;     /* of the node */
    two held;  /* 1: it started at a prescribed end; 0 */
    two c;     /* held: compliance of what lies behind; else 1 */
    two y;     /* force of what lies behind on the node: -q, eliminated */
    two P;     /* stress of the element behind; 0 beyond a free end */
    two max_q; /* so far; a NaN does not stay here, but it does in y */
    two least; /* held: of |c k| so far, which is above 1 while k > 0 */
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

INLINE two horner(const double a[5], two v)
{
    return a[0] + v * (a[1] + v * (a[2] + v * (a[3] + v * a[4])));
}

INLINE two absolute(two x)
{
    return (two)((bits)x & LLONG_MAX);
}

/* x in the lanes where it is larger than y; elsewhere y. */
INLINE two larger(two x, two y)
{
    const bits first = (bits)(x > y);
    return (two)((first & (bits)x) | (~first & (bits)y));
}

/* Eliminate the nodes of the fronts, with loads b; u of the nodes ahead. */
INLINE void eliminate(const struct polynomial *law, two u, two b,
                      struct fronts *f, two *l, two *z)
{
    const two right = {1.0, -1.0}, v = right * (u - f->u);
    const two P = v * horner(law->p, v), k = horner(law->k, v);
    const two minus_q = right * (P - f->P) + b;
    const two per_k = 1.0 / k, c = f->c + f->held * per_k;

    f->max_q = larger(absolute(minus_q), f->max_q);
    f->least = -larger(-absolute(k * c), -f->least);
    *l = f->c / c; /* the pivot is k / l */
    f->y = *l * (f->y + minus_q);
    *z = f->y * per_k;
    f->c = c;
    f->P = P;
    f->u = u;
}

/* The fronts at the ends; behind a prescribed end lies its first element. */
static struct fronts fronts_make(const struct polynomial *law, two held,
                                 const double u[], int n)
{
    const two v = {u[1] - u[0], u[n] - u[n - 1]};
    struct fronts f = {.held = held, .least = {1.0, 1.0}};
    f.u = (two){u[held[0] > 0.0], u[n - (held[1] > 0.0)]};
    f.P = held * (v * horner(law->p, v));
    f.c = held / horner(law->k, v) + (1.0 - held);
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
    const two held = {bar->held[0], m < n && bar->held[1]};
    struct fronts f = fronts_make(&law, held, u, n);
    int i = held[0] > 0.0, j = n - (held[1] > 0.0);
    two l_k, z_k; /* at a held end l and z stay 0 */

    for (; i < m && j > m; i++, j--) {
        eliminate(&law, (two){u[i + 1], u[j - 1]}, (two){b[i], b[j]}, &f, &l_k,
                  &z_k);
        l[i] = l_k[0], l[j] = l_k[1];
        z[i] = z_k[0], z[j] = z_k[1];
    }
    struct fronts L = f, R = f; /* the last nodes of one, by itself */
    for (; i < m; i++) {
        eliminate(&law, (two){u[i + 1], R.u[1]}, (two){b[i]}, &L, &l_k, &z_k);
        l[i] = l_k[0], z[i] = z_k[0];
    }
    for (; j > m; j--) {
        eliminate(&law, (two){L.u[0], u[j - 1]}, (two){0.0, b[j]}, &R, &l_k,
                  &z_k);
        l[j] = l_k[1], z[j] = z_k[1];
    }
    *max_q = fmax(L.max_q[0], R.max_q[1]);
    *du_m = 0.0;
    const int open = m < n || !bar->held[1]; /* node m may move */
    const double minus_q = open ? R.P[1] - L.P[0] + b[m] : 0.0;
    const double y = L.y[0] + R.y[1] + minus_q;
    const double k_L = held[0] / L.c[0], k_R = held[1] / R.c[1];
    const double zero = DBL_EPSILON * (fabs(k_L) + fabs(k_R));
    const double pivot = k_L + k_R;
    const int singular = (held[0] > 0.0 && L.least[0] <= DBL_EPSILON) ||
                         (held[1] > 0.0 && R.least[1] <= DBL_EPSILON);
    if (!isfinite(y) || !isfinite(L.c[0]) || !isfinite(R.c[1]))
        return NONFINITE;
    if (fabs(minus_q) > *max_q) *max_q = fabs(minus_q);
    if (singular || (open && fabs(pivot) <= zero)) return NOT_SPD;
    if (open) *du_m = y / pivot;
    return OK;
}

/* u += du outwards from node m, which has no fewer nodes on its left; returns
 * max |du|, not finite if any is not. */
static double sweep_back(int n, int m, const double l[], const double z[],
                         double du_m, double u[])
{
    two du = {du_m, du_m}, largest = absolute(du);
    int i = m - 1, j = m + 1;

    u[m] += du_m;
    for (; i >= 0 && j <= n; i--, j++) {
        du = (two){z[i], z[j]} + (two){l[i], l[j]} * du;
        u[i] += du[0];
        u[j] += du[1];
        largest = larger(absolute(du), largest);
    }
    double left = du[0], most = largest[0];
    for (; i >= 0; i--) {
        left = z[i] + l[i] * left;
        u[i] += left;
        if (fabs(left) > most) most = fabs(left);
    }
    return fmax(most, largest[1]) + 0.0 * (left + du[1]);
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
