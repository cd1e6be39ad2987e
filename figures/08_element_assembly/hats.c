/*
 * hats.c - what does one element add, and where?
 *
 * Five unequal elements on (0, 1): the stiffness and load of each
 * [eq:poisson-local], and the matrix that they add up to
 * [alg:element-assembly].
 */
#include "bar/poisson.h"
#include "../study/study.h"
#include "base/table.h"

#include <math.h>

enum { n = 5 };

int main(void)
{
    struct matrix *A = matrix_alloc(DENSE, n + 1, 1);
    double x[n + 1], b[n + 1], off = 0.0;

    poisson_grid(0.0, 1.0, n, 3.0, x);
    poisson_assemble(n, x, bvp_beta, bvp_f, &MIDPOINT, A, b);
    table_begin("K_local", "e x0 x1 K00 K01 K10 K11 r0 r1");
    for (int e = 0; e < n; e++) {
        double K[2][2], r[2];
        poisson_element(x[e], x[e + 1], bvp_beta, bvp_f, &MIDPOINT, K, r);
        table_row(e, x[e], x[e + 1], K[0][0], K[0][1], K[1][0], K[1][1], r[0],
                  r[1]);
        off = fmax(off, fabs(K[0][1] - matrix_get(A, e, e + 1)));
    }
    table_end();
    matrix_table("A", A);
    table_begin("nodes", "x");
    for (int i = 0; i <= n; i++) table_row(x[i]);
    table_end();
    matrix_free(A);
    claim(off == 0.0, "off the diagonal every entry is one element's (%g)",
          off);
    return table_finish();
}
