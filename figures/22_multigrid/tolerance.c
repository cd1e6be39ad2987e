/*
 * tolerance.c - how exactly does Newton's method want its increments?
 *
 * STEPS steps of the stretch from rest, reach 1/2, n = 24; each increment by CG
 * with a V-cycle, to |r| <= tolerance |b|.  K and the grids are made anew for
 * each increment, or kept while max|du| falls below 0.3 times the one before
 * (chord), until max|du| <= 1e-10 m.  Tables: tolerance (per step: increments,
 * matrices, iterations; how far u ends from that of the finest tolerance),
 * products (what a step without the chord rule costs, in products with K).
 */
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "conjugate.h"
#include "linear/multigrid.h"
#include "plane/system.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = 24, STEPS = 8, CAP = 60, SIZES = 8 };
static const double tolerances[SIZES] = {1e-10, 1e-8, 1e-6, 1e-4,
                                         1e-3,  1e-2, 1e-1, 0.5};

struct counts { int increments, matrices, iterations; };

/* A step in products with K: one of assembly counts 500 n^2 flops, a product
 * 56 n^2; an iteration is worth 8 (study iterations). */
static double worth(struct counts c)
{
    return (8.0 * c.iterations + 500.0 / 56.0 * c.increments) / STEPS;
}

static void print_products(const struct counts c[SIZES])
{
    table_begin_note("products", "tolerance increments iterations products",
                     "n = %d", N);
    for (int k = 0; k < SIZES; k++)
        table_row(tolerances[k], (double)c[k].increments / STEPS,
                  (double)c[k].iterations / STEPS, worth(c[k]));
    table_end();
}

/* Newton's method of one step, from the extrapolated and lifted guess. */
static void step(struct system *sys, double tolerance, int chord,
                 struct counts *c)
{
    struct scene *s = sys->scene;
    const size_t n_dof = (size_t)s->n_dof;
    double *w = allocate(n_dof, sizeof *w);
    double *next = allocate(n_dof, sizeof *next);
    double *q = allocate(n_dof, sizeof *q), *b = allocate(n_dof, sizeof *b);
    double *x = allocate(n_dof, sizeof *x), size = INFINITY;
    struct csr *K = NULL;
    struct multigrid *m = NULL;
    for (size_t r = 0; r < n_dof; r++) {
        w[r] = s->u[r] + s->set.dt * s->v[r];
        next[r] = w[r] + s->set.dt * (s->v[r] - s->v_before[r]);
    }
    scene_hold(s, ++s->steps * s->set.dt);
    step_boundary(s->body, s->g, 1, next);
    const struct incremental Phi = {s->set.dt, w, NULL};
    for (int k = 0, fresh = 1; size > 1e-10 && k < CAP; k++) {
        if (body_assemble(s->body, Phi, next, fresh ? EXACT : NO_TANGENT,
                          q) != OK)
            die("a step is not defined");
        if (fresh) {
            multigrid_free(m);
            csr_free(K);
            m = multigrid_alloc(K = system_matrix(sys, NULL), N);
            c->matrices++;
        }
        for (int v = 0; v < sys->n_vertex; v++)
            for (int i = 0; i < 2; i++)
                b[2 * v + i] = -q[2 * sys->vertex[v] + i];
        const struct cg_report r =
            cg_solve(K, multigrid_cycle, m, tolerance, 99, b, x);
        if (r.status != OK) die("CG ends with %s", status_name(r.status));
        c->iterations += r.iterations;
        c->increments++;
        const double before = size;
        size = 0.0;
        for (int v = 0; v < sys->n_vertex; v++)
            for (int i = 0; i < 2; i++) {
                next[2 * sys->vertex[v] + i] += x[2 * v + i];
                size = fmax(size, fabs(x[2 * v + i]));
            }
        fresh = !chord || !(size < 0.3 * before);
    }
    if (size > 1e-10) die("a step does not converge");
    memcpy(s->v_before, s->v, n_dof * sizeof *w);
    for (size_t r = 0; r < n_dof; r++) {
        s->v[r] = (next[r] - s->u[r]) / s->set.dt;
        s->u[r] = next[r];
    }
    multigrid_free(m);
    csr_free(K);
    free(w);
    free(next);
    free(q);
    free(b);
    free(x);
}

int main(void)
{
    struct counts c[2][SIZES] = {{{0}}};
    double apart[2][SIZES] = {{0.0}}, *exact = NULL;
    gsl_set_error_handler_off();
    for (int chord = 0; chord < 2; chord++)
        for (int k = 0; k < SIZES; k++) {
            struct system *s = system_alloc(N);
            const size_t n_dof = (size_t)s->scene->n_dof;
            scene_rest(s->scene);
            s->scene->set.reach = 0.5;
            for (int i = 0; i < STEPS; i++)
                step(s, tolerances[k], chord, &c[chord][k]);
            if (!exact)
                exact = memcpy(allocate(n_dof, sizeof *exact), s->scene->u,
                               n_dof * sizeof *exact);
            for (size_t r = 0; r < n_dof; r++)
                apart[chord][k] = fmax(apart[chord][k],
                                       fabs(s->scene->u[r] - exact[r]));
            system_free(s);
        }
    table_begin_note("tolerance", "rule tolerance increments matrices "
                     "per_increment per_step apart", "n = %d", N);
    for (int chord = 0; chord < 2; chord++)
        for (int k = 0; k < SIZES; k++) {
            const double all = c[chord][k].iterations;
            table_row(chord ? "chord" : "newton", tolerances[k],
                      (double)c[chord][k].increments / STEPS,
                      (double)c[chord][k].matrices / STEPS,
                      all / c[chord][k].increments, all / STEPS,
                      apart[chord][k]);
        }
    table_end();
    print_products(c[0]);
    free(exact);
    for (int chord = 0; chord < 2; chord++)
        for (int k = 0; k < SIZES; k++)
            claim(apart[chord][k] <= 1e-10, "tolerance %g ends in the same u, "
                  "within Newton's tolerance", tolerances[k]);
    claim(c[0][3].iterations <= 4.5 * c[0][3].increments &&
              c[1][3].iterations <= 4.5 * c[1][3].increments,
          "to 1e-4 an increment takes at most 4.5 iterations");
    claim(c[0][3].increments == c[0][0].increments &&
              c[0][5].iterations < c[0][0].iterations / 3,
          "1e-4 costs no increment; 1e-2 saves two thirds of the iterations");
    for (int k = 0; k < SIZES; k++)
        claim(worth(c[0][5]) <= worth(c[0][k]), "1e-2 is the least work");
    return table_finish();
}
