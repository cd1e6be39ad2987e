/*
 * 22_multigrid.c - solving without factors: conjugate gradients, and a V-cycle
 * that makes the number of iterations independent of the mesh.
 *
 * Notes: beyond them; the system is that of Lecture 2, 3.3.5.
 *
 * Problem.  K x = b, Newton's first increment in a step of a stretched body
 * (system.h), by conjugate gradients with a preconditioner B [alg:cg].  One of
 * them is a V-cycle over grids of n, n/2, ... squares per side [alg:v-cycle].
 *
 *     o---.---o---.---o     vertices of both grids are o, of the fine one only
 *     |   |   |   |   |     are . ; vertex (i, j), 0 < i < n, 0 <= j <= n, is
 *     .---.---.---.---.     v = j (n - 1) + i - 1, its component k x[2v + k];
 *     |   |   |   |   |     columns i = 0 and i = n are held and have none
 *     o---.---o---.---o
 *
 * Run       make lesson-22; make lesson-22 ARGS=-h lists its options
 * PREDICT 1a iterations of Jacobi at n = 96; at n = 32 it takes 222: ...
 * PREDICT 1b entries of all coarser grids over those of K, n = 32: ...
 * Plot: history k residual logy
 */
#include "linear/cg.h"
#include "linear/multigrid.h"
#include "base/options.h"
#include "plane/system.h"
#include "base/table.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CAP = 2000 }; /* iterations */

/* How a solve went; residual[k] is |r| / |b| before iteration k, and
 * curvature[k] p.Kp / p.p in it. */
struct report {
    enum status status;
    int iterations;
    double residual[CAP + 1], curvature[CAP + 1];
};

static double dot(int n, const double x[], const double y[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += x[i] * y[i];
    return sum;
}

/*
 * Conjugate gradients: given K, B and b, return x, from x = 0; z := B r is
 * precondition(context, r, z).  OK: |r| <= tolerance |b|, Euclidean norms;
 * NOT_SPD: p.Kp or r.z is not positive; NONFINITE: a number is not finite;
 * MAX_ITERATIONS: not done after cap iterations, cap <= CAP.  Whatever it is, x
 * is the last iterate.  Eight parameters: K, B and its context, b, x, and when
 * to stop.
 */
static void cg(const struct csr *K, preconditioner *precondition,
               const void *context, double tolerance, int cap,
               const double b[], double x[], struct report *report)
{
    const int n = K->n;
    const size_t bytes = (size_t)n * sizeof *x;
    double *r = allocate((size_t)n, sizeof *r);
    double *z = allocate((size_t)n, sizeof *z);
    double *p = allocate((size_t)n, sizeof *p);
    double *Kp = allocate((size_t)n, sizeof *Kp);
    memset(report, 0, sizeof *report);
    /* SLOT 22a(K, precondition, context, tolerance, cap, b, x, report, n,
     * bytes, r, z, p, Kp, dot): fill report on the way; r, z, p, Kp are 0. */
    todo("22a", K, precondition, context, tolerance, cap, b, x, report, n,
         bytes, r, z, p, Kp, dot);
    /* END 22a */
    free(Kp);
    free(p);
    free(z);
    free(r);
}

/*
 * Given vectors of the free vertices of the grid of n squares per side, n even,
 * and of n/2, add: fine += P coarse or, down, coarse += P^T fine.
 */
static void transfer(int n, int down, double coarse[], double fine[])
{
    /* SLOT 22b(n, down, coarse, fine): a vertex has the mean of the one, two or
     * four coarse ones around it; held ones count with 0. */
    todo("22b", n, down, coarse, fine);
    /* END 22b */
}

/* Given b = m->b[g], return in x = m->x[g] the result of one V-cycle on grid g
 * for m->K[g] x = b [alg:v-cycle]; m->r[g] is room for a residual.  Two sweeps
 * forward before the coarser grid, two backward after it; on the coarsest one x
 * is exact. */
static void cycle(const struct multigrid *m, int g)
{
    const struct csr *K = m->K[g];
    double *x = m->x[g], *b = m->b[g], *r = m->r[g];
    /* SLOT 22c(m, g, K, x, b, r, transfer, cycle): x starts from 0;
     * multigrid_sweep(); for the last grid matrix_solve() with m->coarsest. */
    todo("22c", m, g, K, x, b, r, transfer, cycle);
    /* END 22c */
}

/* The preconditioner: z := the result of a V-cycle for K z = r. */
static void v_cycle(const void *context, const double r[], double z[])
{
    const struct multigrid *m = context;
    const size_t bytes = (size_t)m->K[0]->n * sizeof *z;
    memcpy(m->b[0], r, bytes);
    cycle(m, 0);
    memcpy(z, m->x[0], bytes);
}

/* The last row is that of an iteration that was not made. */
static void print_history(const struct report *report)
{
    table_begin("history", "k residual curvature");
    for (int k = 0; k <= report->iterations; k++)
        table_row(k, report->residual[k],
                  cell_if(report->curvature[k] != 0.0, report->curvature[k]));
    table_end();
}

static void print_grids(const struct multigrid *m)
{
    table_begin("grids", "n unknowns entries");
    for (int g = 0; g < m->grids; g++)
        table_row(m->n[g], m->K[g]->n, m->K[g]->start[m->K[g]->n]);
    table_end();
}

static void print_solution(const struct system *s, const double x[])
{
    const int width = s->scene->mesh->n - 1;
    table_begin("vertices", "i j x y");
    for (int j = 0; j < s->n_vertex / width; j++)
        for (int i = 0; i < width; i++) {
            const double *at = &x[2 * (j * width + i)];
            table_row(i + 1, j, at[0], at[1]);
        }
    table_end();
}

int main(int argc, char *argv[])
{
    int n = 32, with = 2, cap = CAP;
    double tolerance = 1e-10, squeeze = 0.0;
    const struct option options[] = {
        {"n", .integer = &n, .min = 4, .max = 128, .help = "n x n squares"},
        {"with", .choice = &with,
         .choices = "jacobi incomplete multigrid", .help = "preconditioner"},
        {"tolerance", .real = &tolerance, .min = 1e-13, .max = 0.9,
         .help = "of |r| / |b|"},
        {"cap", .integer = &cap, .min = 0, .max = CAP, .help = "iterations"},
        {"squeeze", .real = &squeeze, .min = 0.0, .max = 0.9,
         .help = "press the body before K is assembled"},
    };
    options_parse("22_multigrid", options, COUNT(options), argc, argv);
    gsl_set_error_handler_off();
    struct system *s = system_alloc(n);
    if (squeeze > 0.0) system_press(s, squeeze);
    struct csr *K = system_matrix(s, NULL);
    struct multigrid *m = multigrid_alloc(K, n);
    struct factor *L = cg_factor(K);
    struct report *report = allocate(1, sizeof *report);
    double *b = allocate((size_t)K->n, sizeof *b);
    double *x = allocate((size_t)K->n, sizeof *x);

    system_right_side(s, NULL, b);
    print_grids(m);
    *report = (struct report){.status = NOT_SPD, .residual[0] = 1.0};
    preconditioner *const way[] = {cg_jacobi, cg_incomplete, v_cycle};
    const void *context[] = {K, L, m->status == OK ? m : NULL};
    if (context[with]) /* else what it needs does not exist */
        cg(K, way[with], context[with], tolerance, cap, b, x, report);
    print_history(report);
    if (report->status == OK) print_solution(s, x);
    if (report->status != OK)
        die("%s after %d iterations", status_name(report->status),
            report->iterations);
    free(report);
    free(x);
    free(b);
    csr_factor_free(L);
    multigrid_free(m);
    csr_free(K);
    system_free(s);
    return table_finish();
}
