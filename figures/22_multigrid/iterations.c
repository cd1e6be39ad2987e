/*
 * iterations.c - how many iterations does a solve take on a finer mesh?
 *
 * K and b of system.h, conjugate gradients with three preconditioners.  Tables:
 * history (the residual, n = 32, to k = 99: then round-off shows), iterations
 * (to 1e-10, and, rough, to 1e-4; and the products with K of the former: a
 * sweep counts one, on a coarser grid as much as it has entries).
 */
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "conjugate.h"
#include "linear/multigrid.h"
#include "plane/system.h"

#include <stdlib.h>

enum way { JACOBI, INCOMPLETE, MULTIGRID, WAYS };
static const char *const name[] = {"jacobi", "incomplete", "multigrid"};
static const double tolerance[] = {1e-4, 1e-10};
enum { SHOWN = 32, LARGEST = 64, SIZES = 5 }; /* n = 16, 32, ..., 256 */

/* Products with K that one application of B is worth. */
static double worth(enum way way, const struct multigrid *m)
{
    double entries = 0.0;
    const double all = m->K[0]->start[m->K[0]->n];
    if (way != MULTIGRID) return way == JACOBI ? m->K[0]->n / all : 1.0;
    for (int g = 0; g < m->grids - 1; g++)
        entries += (2.0 * SWEEPS + 1.0) * m->K[g]->start[m->K[g]->n];
    const struct matrix *L = m->coarsest;
    return (entries + 0.5 * matrix_cost(L->storage, L->n, L->p).solve) / all;
}

struct bench {
    struct csr *K;
    struct factor *L;
    struct multigrid *m;
    double *b, *x;
};

static struct cg_report solve(const struct bench *t, enum way way,
                              double aim, int cap)
{
    preconditioner *const with[] = {cg_jacobi, cg_incomplete, multigrid_cycle};
    const void *context[] = {t->K, t->L, t->m};
    return cg_solve(t->K, with[way], context[way], aim, cap, t->b, t->x);
}

static void print_history(const struct bench *t)
{
    table_begin_note("history", "with k residual", "n = %d", SHOWN);
    for (int way = 0; way < WAYS; way++) {
        struct cg_report r = {.status = MAX_ITERATIONS};
        for (int k = 0; r.status != OK && k < 100;
             k += way == MULTIGRID ? 1 : 3) {
            r = solve(t, (enum way)way, 1e-10, k);
            table_row(name[way], r.iterations, r.residual);
        }
    }
    table_end();
}

int main(void)
{
    double count[SIZES][WAYS][2] = {{{0.0}}}, cost[SIZES][WAYS] = {{0.0}};
    for (int i = 0; i < SIZES; i++) {
        const int n = 16 << i;
        struct system *s = system_alloc(n);
        struct bench t = {.K = system_matrix(s, NULL)};
        t.L = cg_factor(t.K);
        t.m = multigrid_alloc(t.K, n);
        t.b = allocate((size_t)t.K->n, sizeof *t.b);
        t.x = allocate((size_t)t.K->n, sizeof *t.x);
        system_right_side(s, NULL, t.b);
        if (n == SHOWN) print_history(&t);
        for (int way = n <= LARGEST ? 0 : MULTIGRID; way < WAYS; way++)
            for (int k = 0; k < 2; k++) {
                const struct cg_report r =
                    solve(&t, (enum way)way, tolerance[k], 4000);
                if (r.status == OK) count[i][way][k] = r.iterations;
                cost[i][way] = r.iterations * (1.0 + worth((enum way)way, t.m));
            }
        free(t.b);
        free(t.x);
        multigrid_free(t.m);
        csr_factor_free(t.L);
        csr_free(t.K);
        system_free(s);
    }
    table_begin("iterations", "n jacobi jacobi_rough jacobi_products "
                "incomplete incomplete_rough incomplete_products "
                "multigrid multigrid_rough multigrid_products");
    for (int i = 0; i < SIZES; i++) {
        struct cell c[1 + 3 * WAYS] = {cell_number(16 << i)};
        for (int k = 0; k < WAYS; k++) {
            const int there = count[i][k][1] > 0.0;
            c[1 + 3 * k] = cell_if(there, count[i][k][1]);
            c[2 + 3 * k] = cell_if(there, count[i][k][0]);
            c[3 + 3 * k] = cell_if(there, cost[i][k]);
        }
        table_row_of(1 + 3 * WAYS, c);
    }
    table_end();

    for (int i = 0; i < SIZES; i++)
        claim(count[i][MULTIGRID][0] > 0.0 && count[i][MULTIGRID][0] <= 4.5 &&
                  count[i][MULTIGRID][1] > 0.0 && count[i][MULTIGRID][1] <= 12,
              "with a V-cycle n = %d takes at most 4 iterations to 1e-4 and 12 "
              "to 1e-10 (%g, %g)", 16 << i, count[i][MULTIGRID][0],
              count[i][MULTIGRID][1]);
    for (int way = 0; way < MULTIGRID; way++) {
        const double slope =
            study_order(count[2][way][1], count[1][way][1], 2.0);
        claim(slope > 0.9 && slope < 1.1, "with %s they grow like n (%.2f)",
              name[way], slope);
    }
    claim(cost[2][MULTIGRID] < 0.5 * cost[2][INCOMPLETE] &&
              cost[1][MULTIGRID] < cost[1][INCOMPLETE],
          "from n = 32 on a V-cycle is also the least work (%g, %g products)",
          cost[1][MULTIGRID], cost[1][INCOMPLETE]);
    return table_finish();
}
