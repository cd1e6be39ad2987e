/*
 * kink.c - what do a point load and a jump of beta inside an element cost, and
 * is the exact integral of beta the best number to put into A?
 *
 * Equal elements, c = 1/3.  The smooth problem by three rules; -u'' = delta_c,
 * both ends held; unit flux and beta = 1 left of c, 4 right of it, with three
 * means of beta on the element of c.  Orders [eq:order]: over a factor 4 of h.
 */
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>

enum { FINEST = 128 };
static const double c = 1.0 / 3.0;

static double tent(double x) { return x < c ? x * (1.0 - c) : c * (1.0 - x); }
static double tent_dx(double x) { return x < c ? 1.0 - c : -c; }
static double jump_beta(double x) { return x < c ? 1.0 : 4.0; }
static double jump(double x) { return x < c ? x : c + (x - c) / 4.0; }
static double jump_dx(double x) { return 1.0 / jump_beta(x); }

static const struct problem {
    const char *name, *orders, *columns;
    int cases; /* rules, or means of beta */
    field *beta, *f, *exact, *exact_dx;
    double qa, qb;   /* fluxes */
    int held, first; /* so many ends from this one on: 0 left, 1 right */
} SMOOTH = {"solution", "solution_orders",
    "n h nodal_midpoint nodal_trapezoid nodal_gauss2 L2_midpoint L2_trapezoid "
    "L2_gauss2 energy_midpoint energy_trapezoid energy_gauss2",
    3, smooth_beta, smooth_f, smooth_exact, smooth_exact_dx, -2.0, 0.0, 1, 1
}, POINT_LOAD = {"point_load", "point_load_orders", "n h nodal L2 energy",
    1, field_one, field_zero, tent, tent_dx, 0.0, 0.0, 2, 0
}, JUMP = {"jump", "jump_orders",
    "n h nodal_sampled nodal_exact nodal_harmonic L2_sampled L2_exact "
    "L2_harmonic energy_sampled energy_exact energy_harmonic",
    3, jump_beta, field_zero, jump, jump_dx, 0.0, 1.0, 1, 0};

/* The error in column i on n equal elements; the norms on a mesh with c as one
 * more node, at the fraction s of element e: no kink inside an element. */
static double error(const struct problem *p, int n, int i)
{
    const struct quadrature *const rule[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    const int e = (int)(c * n), k = i % p->cases, node[] = {0, n};
    const double s = c * n - e, g[] = {p->exact(0), p->exact(1)};
    /* sampled; the integral of beta exact; that of 1 / beta exact */
    const double mean[] = {s > 0.5 ? 1.0 : 4.0, 4.0 - 3.0 * s,
                           4.0 / (1.0 + 3.0 * s)};
    const double extra = n * (mean[k] - mean[0]);
    double x[FINEST + 1], u[FINEST + 1], X[FINEST + 2], U[FINEST + 2];
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    grid_make(0.0, 1.0, n, 1.0, x);
    poisson_assemble(n, x, p->beta, p->f, rule[p == &JUMP ? 0 : k], A, u);
    for (int a = 0; a < 2 && p == &POINT_LOAD; a++) u[e + a] = a ? s : 1.0 - s;
    for (int a = 0; a < 2 && p == &JUMP; a++)
        for (int b = 0; b < 2; b++)
            matrix_add(A, e + a, e + b, a == b ? extra : -extra);
    u[0] += p->qa, u[n] += p->qb;
    matrix_dirichlet(A, u, p->held, node + p->first, g + p->first,
                     KEEP_DIAGONAL);
    if (matrix_factor(A) != OK) die("the matrix is not SPD");
    matrix_solve(A, u);
    matrix_free(A);
    const int m = s > 0.0 ? e : n; /* c is a node already when s = 0 */
    for (int j = 0; j <= n; j++) X[j + (j > m)] = x[j], U[j + (j > m)] = u[j];
    X[m + 1] = c;
    U[m + 1] = (1.0 - s) * u[e] + s * u[e + 1];
    const struct poisson_error
        nodes = poisson_errors(n, x, u, p->beta, p->exact, p->exact_dx),
        all = poisson_errors(n + (m < n), X, U, p->beta, p->exact, p->exact_dx);
    const double size[] = {nodes.nodal, all.L2, all.energy};
    return size[i / p->cases];
}

static double order(const struct problem *p, int i)
{
    return order_of(error(p, FINEST / 4, i), error(p, FINEST, i), 4.0);
}

static void print(const struct problem *p)
{
    table_begin(p->name, p->columns);
    for (int n = 4; n <= FINEST; n *= 2) {
        double row[11] = {n, 1.0 / n};
        for (int i = 0; i < 3 * p->cases; i++) row[2 + i] = error(p, n, i);
        table_row_of(2 + 3 * p->cases, row);
    }
    table_end();
    struct cell row[9];
    table_begin(p->orders, p->columns + 4); /* without n and h */
    for (int i = 0; i < 3 * p->cases; i++) /* - where the error is round-off */
        row[i] = cell_if(error(p, FINEST, i) > 1e-12, order(p, i));
    table_row_of(3 * p->cases, row);
    table_end();
}

int main(void)
{
    print(&SMOOTH);
    print(&POINT_LOAD);
    print(&JUMP);
    for (int i = 3; i < 9; i++)
        claim(fabs(order(&SMOOTH, i) - (i < 6 ? 2 : 1)) < 0.01,
              "all rules have L2 order 2 and energy order 1");
    claim(error(&POINT_LOAD, FINEST, 0) < 1e-12 &&
              fabs(order(&POINT_LOAD, 1) - 1.5) < 0.01,
          "under a point load the nodes are exact and the L2 order is 1.5");
    for (int i = 3; i < 6; i++)
        claim(fabs(order(&JUMP, i) - (i < 5 ? 1.0 : 1.5)) < 0.02,
              "where beta jumps the L2 orders are 1, 1 and 1.5");
    for (int n = 4; n <= FINEST; n *= 2)
        claim(error(&JUMP, n, 7) < fmin(error(&JUMP, n, 6), error(&JUMP, n, 8)),
              "in energy the exact integral is the best of the three");
    return table_finish();
}
