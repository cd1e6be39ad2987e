/*
 * order.c - does the order of the elements matter?
 *
 * A and b of the exercise on five unequal elements, element by element in
 * natural, reversed and random order [alg:element-assembly], against the loop
 * over vertices, which writes each entry once [eq:quadrature-A]
 * [eq:quadrature-b]; the differences are in units of eps.
 */
#include "bar/poisson.h"
#include "base/study.h"
#include "base/table.h"

#include <float.h>
#include <math.h>

enum { n = 5, N = n + 1 };

static void by_element(const double x[], const int order[], struct matrix *A,
                       double b[])
{
    matrix_zero(A);
    for (int i = 0; i < N; i++) b[i] = 0.0;
    for (int k = 0; k < n; k++) {
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
        b[i] = (i > 0 ? load(x, i - 1) : 0.0) + (i < n ? load(x, i) : 0.0);
        matrix_add(A, i, i, (i > 0 ? stiffness(x, i - 1) : 0.0) +
                                (i < n ? stiffness(x, i) : 0.0));
        if (i < n) matrix_add(A, i, i + 1, -stiffness(x, i));
        if (i < n) matrix_add(A, i + 1, i, -stiffness(x, i));
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

int main(void)
{
    static const char *const name[] = {"natural", "reversed", "random"};
    const int order[3][n] = {{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {3, 0, 4, 2, 1}};
    struct matrix *A = matrix_alloc(DENSE, N, 0);
    struct matrix *V = matrix_alloc(DENSE, N, 0);
    double x[N], b[N], v[N], worst = 0.0;

    poisson_grid(0.0, 1.0, n, 3.0, x);
    by_vertex(x, V, v);
    table_begin("assembly", "order A_eps b_eps");
    for (int k = 0; k < 3; k++) {
        by_element(x, order[k], A, b);
        const double A_eps = difference_eps(N * N, A->a, V->a);
        const double b_eps = difference_eps(N, b, v);
        table_row(name[k], A_eps, b_eps);
        worst = fmax(worst, fmax(A_eps, b_eps));
    }
    table_end();
    matrix_free(A);
    matrix_free(V);
    /* two terms per entry: their sum does not depend on their order */
    claim(worst <= 1.0, "the same A and b in every order (%g eps)", worst);
    return table_finish();
}
