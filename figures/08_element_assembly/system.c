/*
 * system.c - A u = b of the exercise: does the order of the elements matter,
 * can a status be trusted, and what does a banded matrix save?
 *
 * Five unequal elements, visited in natural, reversed and random order
 * [alg:element-assembly], against the loop over vertices, which writes each
 * entry once [eq:quadrature-A] [eq:quadrature-b].  Tables: validity, four
 * systems on 64 elements, factored and solved; a run is valid if u solves a
 * system that differs from A u = b by at most 20 eps, whatever the status of
 * the factorisation says.  work, n equal elements by dense and by banded
 * storage: flops of factorisation and solves [eq:cholesky-flops], and the L2
 * error [eq:norm-L2].
 */
#include "exercise.h"
#include "bar/poisson.h"
#include "linear/residual.h"
#include "../study/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* ---- order --------------------------------------------------------------- */

enum { FEW = 5, N = FEW + 1 };

static void by_element(const double x[], const int order[], struct matrix *A,
                       double b[])
{
    matrix_zero(A);
    for (int i = 0; i < N; i++) b[i] = 0.0;
    for (int k = 0; k < FEW; k++) {
        const int e = order[k];
        double K[2][2], r[2];
        poisson_element(x[e], x[e + 1], bvp_beta, bvp_f, &MIDPOINT, K, r);
        for (int a = 0; a < 2; a++) {
            b[e + a] += r[a];
            for (int c = 0; c < 2; c++) matrix_add(A, e + a, e + c, K[a][c]);
        }
    }
}

/* beta / h, and the share of the load, of the element between nodes e, e + 1 */
static double stiffness(const double x[], int e)
{
    return bvp_beta(0.5 * (x[e] + x[e + 1])) / (x[e + 1] - x[e]);
}

static double load(const double x[], int e)
{
    return 0.5 * (x[e + 1] - x[e]) * bvp_f(0.5 * (x[e] + x[e + 1]));
}

static void by_vertex(const double x[], struct matrix *A, double b[])
{
    for (int i = 0; i < N; i++) {
        b[i] = (i > 0 ? load(x, i - 1) : 0.0) + (i < FEW ? load(x, i) : 0.0);
        matrix_add(A, i, i, (i > 0 ? stiffness(x, i - 1) : 0.0) +
                                (i < FEW ? stiffness(x, i) : 0.0));
        if (i < FEW) matrix_add(A, i, i + 1, -stiffness(x, i));
        if (i < FEW) matrix_add(A, i + 1, i, -stiffness(x, i));
    }
}

/* max_k |v_k - w_k| / max_k |w_k| in units of eps */
static double difference_eps(int size, const double v[], const double w[])
{
    double largest = 0.0, scale = 0.0;
    for (int k = 0; k < size; k++) {
        largest = fmax(largest, fabs(v[k] - w[k]));
        scale = fmax(scale, fabs(w[k]));
    }
    return largest / (DBL_EPSILON * scale);
}

static void claim_order(void)
{
    static const int order[3][FEW] = {
        {0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {3, 0, 4, 2, 1}};
    struct matrix *A = matrix_alloc(DENSE, N, 0);
    struct matrix *V = matrix_alloc(DENSE, N, 0);
    double x[N], b[N], v[N], worst = 0.0;
    poisson_grid(0.0, 1.0, FEW, 3.0, x);
    by_vertex(x, V, v);
    for (int k = 0; k < 3; k++) {
        by_element(x, order[k], A, b);
        worst = fmax(worst, fmax(difference_eps(N * N, A->a, V->a),
                                 difference_eps(N, b, v)));
    }
    matrix_free(A);
    matrix_free(V);
    /* two terms per entry: their sum does not depend on their order */
    claim(worst <= 1.0, "the same A and b in every order (%g eps)", worst);
}

/* ---- validity ------------------------------------------------------------ */

enum trial { AS_IT_MUST_BE, NOTHING_HELD, ROW_ONLY, NAN_IN_LOAD };
static const char *const name[] = {"correct", "nothing held", "row only",
                                   "NaN in the load"};
enum { MANY = 64 };

/* Of trial `t`: A, b and the nodes. */
static struct matrix *system_of(enum trial t, double x[], double b[])
{
    struct matrix *A = exercise_system(DENSE, MANY, x, b);
    if (t == NAN_IN_LOAD) b[MANY / 2] = (double)NAN;
    if (t == NOTHING_HELD || t == ROW_ONLY) {
        poisson_assemble(MANY, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
        b[MANY] -= 0.5;
    }
    if (t == ROW_ONLY) { /* the column stays, nothing moves into b */
        const int n = MANY;
        matrix_add(A, n, n - 1, -matrix_get(A, n, n - 1));
        b[n] = matrix_get(A, n, n) * bvp_exact(1.0);
    }
    return A;
}

static void print_validity(void)
{
    double x[MANY + 1], b[MANY + 1], u[MANY + 1], off[4];
    enum status status[4];
    int valid[4];

    table_begin("validity", "trial factored valid wrong_by");
    for (int t = AS_IT_MUST_BE; t <= NAN_IN_LOAD; t++) {
        struct matrix *A = system_of((enum trial)t, x, b);
        struct matrix *L = matrix_copy(A);
        for (int i = 0; i <= MANY; i++) u[i] = b[i];
        status[t] = matrix_factor(L);
        if (status[t] == OK) matrix_solve(L, u);
        off[t] = 0.0;
        for (int i = 0; i <= MANY; i++)
            off[t] = fmax(off[t], fabs(u[i] - bvp_exact(x[i])));
        valid[t] = status[t] == OK && matrix_backward_error(A, u, b) <= 20.0;
        table_row(name[t], status_name(status[t]), valid[t] ? "yes" : "no",
                  cell_if(status[t] == OK && t != NAN_IN_LOAD, off[t]));
        matrix_free(A);
        matrix_free(L);
    }
    table_end();
    claim(valid[0] && !valid[1] && !valid[2] && !valid[3],
          "only the correct system is valid");
    claim(status[ROW_ONLY] == OK && off[ROW_ONLY] > 0.8,
          "with the row alone Cholesky says OK, and u is wrong by 0.8 (%g)",
          off[ROW_ONLY]);
    claim(status[NOTHING_HELD] == NOT_SPD, "a singular matrix is NOT_SPD");
}

/* ---- work ---------------------------------------------------------------- */

static void print_work(void)
{
    double flops[2] = {0.0, 0.0}, L2[2] = {0.0, 0.0}, apart = 0.0;

    table_begin("work", "n flops_dense flops_banded L2_banded");
    for (int n = 4; n <= 256; n *= 2) {
        for (int storage = DENSE; storage <= BANDED; storage++) {
            double *x = allocate((size_t)n + 1, sizeof *x);
            double *u = allocate((size_t)n + 1, sizeof *u);
            struct matrix *A = exercise_system((enum storage)storage, n, x, u);
            const struct matrix_cost cost =
                matrix_cost(A->storage, n + 1, A->p);
            flops[storage] = cost.flops + cost.solve;
            if (matrix_factor(A) != OK) die("A is not positive definite");
            matrix_solve(A, u);
            L2[storage] = poisson_errors(n, x, u, bvp_beta, bvp_exact,
                                         bvp_exact_dx).L2;
            matrix_free(A);
            free(x);
            free(u);
        }
        apart = fmax(apart, fabs(L2[0] / L2[1] - 1.0));
        table_row(n, flops[0], flops[1], L2[1]);
    }
    table_end();
    /* round-off: condition number 1e5 times eps, over an error of 5e-7 */
    claim(apart < 1e-5, "both storages give one error (relative difference %g)",
          apart);
    claim(flops[0] > 2000.0 * flops[1], "with 256 elements dense pays 2000 "
          "times the flops (%g)", flops[0] / flops[1]);
}

int main(void)
{
    claim_order();
    print_validity();
    print_work();
    return table_finish();
}
