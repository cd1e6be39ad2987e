/*
 * complexity.c - six ways to solve one system, from the full matrix to
 * multigrid.
 *
 * K x = b of system.h, n = 8 to 256, from the assembled K to x; CG to |r| <=
 * 1e-12 |b|.  An x whose backward error is above 1e-12 has no time.  What is
 * made once per mesh (the order of elimination) is not counted; factors and
 * coarser grids are.  The six take turns; medians.
 *
 * Flops are counted: for Cholesky by its columns; for CG two per entry in each
 * product, sweep and triangle, 10 per unknown in each iteration, and what makes
 * the preconditioner.  Tables: solvers, exponents (of the last doubling of n).
 */
#include "../22_multigrid/conjugate.h"
#include "base/clock.h"
#include "machine.h"
#include "solved.h"
#include "linear/multigrid.h"
#include "linear/sparse.h"
#include "../study/study.h"
#include "plane/system.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

enum rung { FULL, BAND, FRONTS, JACOBI, INCOMPLETE, MULTIGRID, RUNGS };
static const char *const name[] = {"dense",  "band",       "dissection",
                                   "jacobi", "incomplete", "multigrid"};
static const int largest[] = {32, 128, 256, 128, 128, 256};
enum { SIZES = 6 }; /* n = 8, 16, ..., 256 */

struct measured {
    struct times seconds;
    double flops;
};

/* Flops that make a V-cycle's grids, and of one cycle. */
static void count_grids(const struct multigrid *m, double *make, double *cycle)
{
    const struct matrix *L = m->coarsest;
    const struct matrix_cost last = matrix_cost(L->storage, L->n, L->p);
    *make = last.flops, *cycle = last.solve;
    for (int g = 0; g < m->grids - 1; g++) {
        *make += 2.0 * 16.0 * m->K[g]->start[m->K[g]->n];
        *cycle += 2.0 * (2.0 * SWEEPS + 1.0) * m->K[g]->start[m->K[g]->n] +
                  2.0 * 2.0 * 4.0 * m->K[g]->n;
    }
}

static void by_cg(int rung, const struct csr *K, int n, const double b[],
                  double x[], struct measured *m)
{
    preconditioner *with = cg_jacobi;
    const void *context = K;
    struct factor *L = NULL;
    struct multigrid *grids = NULL;
    double make = 0.0, apply = K->n;
    const double start = clock_seconds();
    if (rung == INCOMPLETE) {
        context = L = cg_factor(K);
        with = cg_incomplete;
    }
    if (rung == MULTIGRID) {
        context = grids = multigrid_alloc(K, n);
        with = multigrid_cycle;
    }
    const struct cg_report r =
        context ? cg_solve(K, with, context, 1e-12, 9999, b, x)
                : (struct cg_report){.status = NOT_SPD};
    const double seconds = clock_seconds() - start;
    if (L) {
        for (int j = 0; j < L->n; j++) /* m^2 at most, with m entries */
            make += pow(L->start[j + 1] - L->start[j], 2.0);
        apply = 4.0 * L->start[L->n];
    }
    if (grids) count_grids(grids, &make, &apply);
    m->flops = make + r.iterations * (apply + 2.0 * K->start[K->n] +
                                      10.0 * K->n);
    times_record(&m->seconds, seconds,
                 r.status == OK && solved_error(K, x, b) <= 1e-12);
    csr_factor_free(L);
    multigrid_free(grids);
}

static void by_factors(int rung, struct system *s, const struct csr *K,
                       const double b[], double x[], struct measured *m)
{
    struct body *body = s->scene->body;
    const enum storage storage[] = {DENSE, BANDED, SPARSE};
    struct matrix *A = body->K, *full = NULL;
    double *y = allocate((size_t)K->n, sizeof *y);
    if (rung != FULL) {
        system_store(s, storage[rung]);
        A = body->K;
    }
    body_gather(body, s->b, y);
    if (rung == FULL) {
        A = full = matrix_alloc(DENSE, K->n, 0);
        for (int i = 0; i < K->n; i++)
            for (int k = K->start[i]; k < K->start[i + 1]; k++)
                matrix_add(A, i, K->index[k], K->value[k]);
        for (int i = 0; i < K->n; i++) y[i] = b[i];
    }
    const double start = clock_seconds();
    const enum status status = matrix_factor(A);
    if (status == OK) matrix_solve(A, y);
    const double seconds = clock_seconds() - start;
    for (int v = 0; v < s->n_vertex; v++)
        for (int i = 0; i < 2; i++)
            x[2 * v + i] = full ? y[2 * v + i]
                                : y[body->equation[2 * s->vertex[v] + i]];
    const struct sparse *p = body->pattern;
    const struct matrix_cost cost =
        rung == FRONTS ? (struct matrix_cost){p->numbers, p->flops, p->solve}
                       : matrix_cost(storage[rung], A->n, A->p);
    m->flops = cost.flops + cost.solve;
    times_record(&m->seconds, seconds,
                 status == OK && solved_error(K, x, b) <= 1e-12);
    matrix_free(full);
    free(y);
}

int main(void)
{
    static struct measured m[RUNGS][SIZES];
    gsl_set_error_handler_off();
    study_machine();
    for (int i = 0; i < SIZES; i++) {
        const int n = 8 << i, turns = n <= 64 ? 9 : 3;
        struct system *s = system_alloc(n);
        struct csr *K = system_matrix(s, NULL);
        double *b = allocate((size_t)K->n, sizeof *b);
        double *x = allocate((size_t)K->n, sizeof *x);
        system_right_side(s, NULL, b);
        for (int turn = 0; turn < turns; turn++)
            for (int k = 0; k < RUNGS; k++) {
                if (n > largest[k] || (k == FULL && turn > 0)) continue;
                if (k <= FRONTS) by_factors(k, s, K, b, x, &m[k][i]);
                else by_cg(k, K, n, b, x, &m[k][i]);
            }
        free(b);
        free(x);
        csr_free(K);
        system_free(s);
    }
    table_begin("solvers", "solver n flops milliseconds");
    for (int k = 0; k < RUNGS; k++)
        for (int i = 0; i < SIZES && 8 << i <= largest[k]; i++) {
            const double t = times_median(&m[k][i].seconds);
            table_row(name[k], 8 << i, m[k][i].flops,
                      cell_if(!isnan(t), 1e3 * t));
        }
    table_end();
    table_begin("exponents", "solver n flops seconds");
    for (int k = 0; k < RUNGS; k++) {
        int i = SIZES - 1;
        while (8 << i > largest[k]) i--;
        const struct measured *a = &m[k][i], *c = &m[k][i - 1];
        const double t = study_order(times_median(&a->seconds),
                                  times_median(&c->seconds), 2.0);
        table_row(name[k], 8 << i, study_order(a->flops, c->flops, 2.0),
                  cell_if(!isnan(t), t));
    }
    table_end();
    const struct measured *mg = m[MULTIGRID];
    claim(study_order(mg[5].flops, mg[3].flops, 4.0) <= 2.2,
          "from n = 64 to 256 the work with multigrid grows like n^2");
    return table_finish();
}
