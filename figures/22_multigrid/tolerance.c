/*
 * tolerance.c - how exactly does Newton's method want its increments?
 *
 * STEPS steps of the stretch from rest, reach 1/2, n = 24; each increment by CG
 * with a V-cycle, to |r| <= tolerance |b|.  K and the grids are made anew for
 * each increment, or kept while max|du| falls below 0.3 times the one before
 * (chord), until max|du| <= 1e-10 m.  Table: tolerance (per step: increments,
 * matrices, iterations; how far u ends from that of the finest tolerance).
 */
#include "base/options.h"
#include "base/study.h"
#include "base/table.h"
#include "linear/cg.h"
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

/* Newton's method of one step, from the extrapolated and lifted guess. */
static void step(struct system *sys, double tolerance, int chord,
                 struct counts *c)
{
    struct scene *s = sys->scene;
    const size_t n_dof = (size_t)s->n_dof;
    double *w = allocate(5 * n_dof, sizeof *w), *next = w + n_dof;
    double *q = next + n_dof, *b = q + n_dof, *x = b + n_dof, size = INFINITY;
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
            multigrid_free(m), csr_free(K);
            m = multigrid_alloc(K = system_matrix(sys, NULL), N);
            c->matrices++;
        }
        for (int v = 0; v < K->n; v++)
            b[v] = -q[2 * sys->vertex[v / 2] + v % 2];
        const struct cg_report r =
            cg_solve(K, multigrid_cycle, m, tolerance, 99, b, x);
        if (r.status != OK) die("CG ends with %s", status_name(r.status));
        c->iterations += r.iterations;
        c->increments++;
        const double before = size;
        for (int v = 0; v < K->n; v++) {
            next[2 * sys->vertex[v / 2] + v % 2] += x[v];
            size = fmax(v > 0 ? size : 0.0, fabs(x[v]));
        }
        fresh = !chord || !(size < 0.3 * before);
    }
    if (size > 1e-10) die("a step does not converge");
    memcpy(s->v_before, s->v, n_dof * sizeof *w);
    for (size_t r = 0; r < n_dof; r++) {
        s->v[r] = (next[r] - s->u[r]) / s->set.dt;
        s->u[r] = next[r];
    }
    multigrid_free(m), csr_free(K);
    free(w);
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
    free(exact);
    for (int k = 0; k < 2 * SIZES; k++)
        claim(apart[k / SIZES][k % SIZES] <= 1e-10, "tolerance %g ends in the "
              "same u, within Newton's tolerance", tolerances[k % SIZES]);
    claim(c[0][3].iterations <= 4.5 * c[0][3].increments &&
              c[1][3].iterations <= 4.5 * c[1][3].increments,
          "to 1e-4 an increment takes at most 4.5 iterations");
    claim(c[0][3].increments == c[0][0].increments &&
              c[0][5].iterations < c[0][0].iterations / 3,
          "1e-4 costs no increment; 1e-2 saves two thirds of the iterations");
    return table_finish();
}
