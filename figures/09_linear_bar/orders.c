/*
 * orders.c - is the linear bar exact at its nodes?
 *
 * The cosine load, held at 0 and free at 1, in units of modulus and load, on 4
 * to 128 elements.  Nodal errors with the load integrated by the midpoint rule,
 * by two Gauss points and exactly; L2 and energy errors with the midpoint rule;
 * and the orders [eq:order] of the two finest meshes.
 */
#include "bar/bar_scene.h"
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

enum { MIDPOINT_RULE, GAUSS, EXACT, L2, ENERGY, N_ERROR };

static double cosine(double x) { return cos(M_PI_2 * x); }
/* its integral from 0, and the integral of that */
static double cosine_1(double x) { return sin(M_PI_2 * x) / M_PI_2; }
static double cosine_2(double x)
{
    const double half = sin(0.5 * M_PI_2 * x) / M_PI_2;
    return 2.0 * half * half;
}
static double exact(double x) { return cosine_1(1.0) * x - cosine_2(x); }
static double exact_dx(double x) { return cosine_1(1.0) - cosine_1(x); }

/* b_i = int f N_i in closed form, by parts. */
static void exact_load(int n, double b[])
{
    const double h = 1.0 / n;
    for (int i = 0; i <= n; i++) b[i] = 0.0;
    for (int e = 0; e < n; e++) {
        const double X0 = e * h, X1 = (e + 1) * h;
        const double mean = (cosine_2(X1) - cosine_2(X0)) / h;
        b[e] += mean - cosine_1(X0);
        b[e + 1] += cosine_1(X1) - mean;
    }
}

static void errors(int n, double error[N_ERROR])
{
    const struct bar_scene scene = {.n = n, .material = {LINEAR, 0.5, 0.0},
                                    .held = {1, 0}, .shape = COSINE, .c = 1.0};
    const int held[] = {0};
    const double zero[] = {0.0};
    struct matrix *K = matrix_alloc(BANDED, n + 1, 1);
    double *x = allocate((size_t)n + 1, sizeof *x);
    double *u = allocate((size_t)n + 1, sizeof *u);

    poisson_grid(0.0, 1.0, n, 1.0, x);
    for (int way = EXACT; way >= MIDPOINT_RULE; way--) {
        poisson_assemble(n, x, field_one, cosine, &GAUSS2, K, u);
        if (way == MIDPOINT_RULE) bar_scene_load(&scene, u);
        if (way == EXACT) exact_load(n, u);
        matrix_dirichlet(K, u, 1, held, zero, KEEP_DIAGONAL);
        if (matrix_factor(K) != OK) die("K is not positive definite");
        matrix_solve(K, u);
        const struct poisson_error e =
            poisson_errors(n, x, u, field_one, exact, exact_dx);
        error[way] = e.nodal;
        error[L2] = e.L2;
        error[ENERGY] = e.energy;
    }
    matrix_free(K);
    free(x);
    free(u);
}

int main(void)
{
    double coarse[N_ERROR], fine[N_ERROR] = {0}, order[N_ERROR], worst = 0.0;

    table_begin("orders", "n h midpoint gauss exact L2 energy");
    for (int n = 4; n <= 128; n *= 2) {
        for (int k = 0; k < N_ERROR; k++) coarse[k] = fine[k];
        errors(n, fine);
        table_row(n, 1.0 / n, fine[0], fine[1], fine[2], fine[3], fine[4]);
        for (int k = 0; k < N_ERROR; k++)
            order[k] = study_order(coarse[k], fine[k], 2.0);
        worst = fmax(worst, fine[EXACT]);
    }
    table_end();
    table_begin("orders_of", "midpoint gauss L2 energy");
    table_row(order[MIDPOINT_RULE], order[GAUSS], order[L2], order[ENERGY]);
    table_end();

    /* Gauss's finest error is near round-off */
    claim(fabs(order[MIDPOINT_RULE] - 2.0) < 0.02 &&
              fabs(order[GAUSS] - 4.0) < 0.02 && fabs(order[L2] - 2.0) < 0.02 &&
              fabs(order[ENERGY] - 1.0) < 0.02,
          "the orders are 2, 4, 2, 1 (%g, %g, %g, %g)", order[MIDPOINT_RULE],
          order[GAUSS], order[L2], order[ENERGY]);
    claim(fabs(fine[MIDPOINT_RULE] * 128 * 128 * 24 / (1.0 + M_PI_2) - 1.0) <
              1e-3 && fabs(fine[ENERGY] * 128 * sqrt(24.0) - 1.0) < 1e-3,
          "the constants are (1 + pi/2) / 24 at the nodes and 1 / sqrt(24) in "
          "energy");
    claim(worst < 1e-12, "with exact loads the nodal values are exact (off by "
          "%g)", worst);
    return table_finish();
}
