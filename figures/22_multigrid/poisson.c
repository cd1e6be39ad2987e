/*
 * poisson.c - how many iterations with a V-cycle, as Poisson's ratio comes near
 * 1/2?
 *
 * K and b of system.h with another nu, conjugate gradients.  Table: iterations
 * to 1e-10 for n = 16, 32, 64, 128, and, rough, to 1e-4 for n = 32.
 */
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "conjugate.h"
#include "linear/multigrid.h"
#include "plane/system.h"

#include <stdlib.h>

static int iterations(int n, double nu, double tolerance)
{
    struct system *s = system_alloc(n);
    struct body *body = s->scene->body;
    body->material = material_make(CUBIC, 1000.0, nu);
    system_store(s, body->K->storage);
    struct csr *K = system_matrix(s, NULL);
    struct multigrid *m = multigrid_alloc(K, n);
    double *b = allocate((size_t)K->n, sizeof *b);
    double *x = allocate((size_t)K->n, sizeof *x);
    system_right_side(s, NULL, b);
    const struct cg_report r =
        cg_solve(K, multigrid_cycle, m, tolerance, 99, b, x);
    claim(r.status == OK, "nu = %g, n = %d: %s", nu, n, status_name(r.status));
    free(b);
    free(x);
    multigrid_free(m);
    csr_free(K);
    system_free(s);
    return r.iterations;
}

int main(void)
{
    static const double ratio[] = {0.0, 0.3, 0.4, 0.45, 0.48, 0.49};
    int count[COUNT(ratio)][4];
    table_begin("poisson", "nu n16 n32 n64 n128 rough");
    for (int k = 0; k < COUNT(ratio); k++) {
        int *c = count[k];
        for (int i = 0; i < 4; i++)
            c[i] = iterations(16 << i, ratio[k], 1e-10);
        table_row(ratio[k], c[0], c[1], c[2], c[3],
                  iterations(32, ratio[k], 1e-4));
    }
    table_end();
    for (int k = 0; k < COUNT(ratio); k++)
        claim(count[k][3] - count[k][0] <= (ratio[k] < 0.485 ? 1 : 6),
              "the mesh hardly matters (nu = %g: %d to %d)", ratio[k],
              count[k][0], count[k][3]);
    claim(10 * count[3][1] > 15 * count[1][1] &&
              count[5][1] > 3 * count[1][1],
          "nu = 0.45 takes more than 1.5 times, 0.49 more than 3 times as many "
          "as 0.3 (%d, %d, %d)", count[3][1], count[5][1], count[1][1]);
    return table_finish();
}
