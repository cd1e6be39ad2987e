/*
 * kink.c - what does a jump of beta inside an element cost, and is the exact
 * integral of beta the best number to put into A?
 *
 * Equal elements, c = 1/3.  The smooth problem by three rules; unit flux and
 * beta = 1 left of c, 4 right of it, with three means of beta on the element of
 * c.  Orders [eq:order]: over a factor 4 of h.
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { FINEST = 128 };
static const double c = 1.0 / 3.0;

static double jump_beta(double x) { return x < c ? 1.0 : 4.0; }
static double jump(double x) { return x < c ? x : c + (x - c) / 4.0; }
static double jump_dx(double x) { return 1.0 / jump_beta(x); }

/* -(beta u')' = f, in so many ways: by rules, or by the midpoint rule with
 * means of beta on the element of c. */
enum { SAMPLED, EXACT, HARMONIC };
static const struct problem {
    const char *name, *orders, *columns;
    int ways, means;
    field *beta, *f, *exact, *exact_dx;
    double flux[2]; /* at the left and the right end */
    int held;       /* the end: 0 left, 1 right */
} SMOOTH = {"solution", "solution_orders",
    "n h nodal_midpoint nodal_trapezoid nodal_gauss2 L2_midpoint L2_trapezoid "
    "L2_gauss2 energy_midpoint energy_trapezoid energy_gauss2", 3, 0,
    smooth_beta, smooth_f, smooth_exact, smooth_exact_dx, {-2, 0}, 1
}, JUMP = {"jump", "jump_orders",
    "n h nodal_sampled nodal_exact nodal_harmonic L2_sampled L2_exact "
    "L2_harmonic energy_sampled energy_exact energy_harmonic", 3, 1,
    jump_beta, field_zero, jump, jump_dx, {0, 1}, 0};

/* A and b, before the ends are held. */
static void assemble(const struct problem *p, int n, const double x[], int way,
                     struct matrix *A, double b[])
{
    const struct quadrature *const rule[] = {&MIDPOINT, &TRAPEZOID, &GAUSS2};
    const int e = (int)(c * n);
    const double s = c * n - e; /* c on element e */

    poisson_assemble(n, x, p->beta, p->f,
                     p->means ? &MIDPOINT : rule[way], A, b);
    b[0] += p->flux[0];
    b[n] += p->flux[1];
    if (!p->means) return;
    const double mean[] = {[SAMPLED] = s > 0.5 ? 1.0 : 4.0,
                           [EXACT] = 4.0 - 3.0 * s, /* integral of beta */
                           [HARMONIC] = 4.0 / (1.0 + 3.0 * s)}; /* 1 / beta */
    const double extra = n * (mean[way] - mean[SAMPLED]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            matrix_add(A, e + i, e + k, i == k ? extra : -extra);
}

/* Make c a node of x and u, if it is none; returns the number of elements. */
static int insert_c(int n, double x[], double u[])
{
    const int e = (int)(c * n);
    const double s = c * n - e; /* c on element e */

    if (s == 0.0) return n;
    for (int j = n; j > e; j--) {
        x[j + 1] = x[j];
        u[j + 1] = u[j];
    }
    x[e + 1] = c;
    u[e + 1] = (1.0 - s) * u[e] + s * u[e + 2];
    return n + 1;
}

enum norm { NODAL, L2, ENERGY, NORMS };

/* The error on n equal elements; L2 and energy on a mesh with c as one more
 * node, so that there is no kink inside an element. */
static double error(const struct problem *p, int n, enum norm norm, int way)
{
    const int node[] = {0, n};
    const double end[] = {p->exact(0.0), p->exact(1.0)};
    double x[FINEST + 2], u[FINEST + 2];
    struct matrix *A = matrix_alloc(BANDED, n + 1, 1);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    assemble(p, n, x, way, A, u);
    matrix_dirichlet(A, u, 1, node + p->held, end + p->held, KEEP_DIAGONAL);
    if (matrix_factor(A) != OK) die("the matrix is not SPD");
    matrix_solve(A, u);
    matrix_free(A);
    const int elements = norm == NODAL ? n : insert_c(n, x, u);
    const struct poisson_error of =
        poisson_errors(elements, x, u, p->beta, p->exact, p->exact_dx);
    return norm == NODAL ? of.nodal : norm == L2 ? of.L2 : of.energy;
}

/* Both tables of a problem, and its orders. */
static void print(const struct problem *p, double order[NORMS][3])
{
    table_begin(p->name, p->columns);
    for (int n = 4; n <= FINEST; n *= 2) {
        double row[11] = {n, 1.0 / n}, *next = row + 2;
        for (enum norm norm = NODAL; norm < NORMS; norm++)
            for (int way = 0; way < p->ways; way++)
                *next++ = error(p, n, norm, way);
        table_row_of(2 + NORMS * p->ways, row);
    }
    table_end();
    struct cell row[9], *next = row;
    table_begin(p->orders, p->columns + 4); /* without n and h */
    for (enum norm norm = NODAL; norm < NORMS; norm++)
        for (int way = 0; way < p->ways; way++) {
            const double coarse = error(p, FINEST / 4, norm, way);
            const double fine = error(p, FINEST, norm, way);
            order[norm][way] = study_order(coarse, fine, 4.0);
            /* - where the error is round-off */
            *next++ = cell_if(fine > 1e-12, order[norm][way]);
        }
    table_row_of(NORMS * p->ways, row);
    table_end();
}

int main(void)
{
    double smooth[NORMS][3], jumping[NORMS][3];

    print(&SMOOTH, smooth);
    print(&JUMP, jumping);
    for (int rule = 0; rule < 3; rule++)
        claim(fabs(smooth[L2][rule] - 2.0) < 0.01 &&
                  fabs(smooth[ENERGY][rule] - 1.0) < 0.01,
              "all rules have L2 order 2 and energy order 1");
    claim(fabs(jumping[L2][SAMPLED] - 1.0) < 0.02 &&
              fabs(jumping[L2][EXACT] - 1.0) < 0.02 &&
              fabs(jumping[L2][HARMONIC] - 1.5) < 0.02,
          "where beta jumps the L2 orders are 1, 1 and 1.5");
    for (int n = 4; n <= FINEST; n *= 2)
        claim(error(&JUMP, n, ENERGY, EXACT) <
                  fmin(error(&JUMP, n, ENERGY, SAMPLED),
                       error(&JUMP, n, ENERGY, HARMONIC)),
              "in energy the exact integral is the best of the three");
    return table_finish();
}
