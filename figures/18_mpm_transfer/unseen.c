/*
 * unseen.c - which motions of the particles does the grid not see?
 *
 * Eight cells of particles on a bar.  P2G maps as many velocities as there are
 * particles to fewer nodes; what it maps to 0, FLIP adds unchanged to the
 * particles, for ever.  The rank is that of the matrix m_p N_i(x_p), by GSL's
 * singular values; the unseen part of a zigzag is what is orthogonal to it.
 */
#include "particles/particles.h"
#include "../study/study.h"
#include "base/table.h"

#include <gsl/gsl_linalg.h>
#include <math.h>

enum { CELLS = 8, NODES = CELLS + 5, MOST = 8 * CELLS };

static struct grid *new_grid(int order)
{
    const double low[2] = {-2.0, 0.0};
    return grid_alloc(order, low, 1.0, (int[]){NODES, 1});
}

static struct particles *bar(int ppc)
{
    const double low[2] = {0.0, -0.5}, high[2] = {CELLS, 0.5};
    return particles_box(low, high, (int[]){CELLS * ppc, 1}, 1.0);
}

/* Rank of P2G; unseen[p] := the zigzag without what the nodes see of it. */
static int rank_of(struct grid *grid, const struct particles *p, int *nodes,
                   double unseen[])
{
    gsl_matrix *U = gsl_matrix_calloc((size_t)p->n + NODES, NODES);
    gsl_matrix *V = gsl_matrix_alloc(NODES, NODES);
    gsl_vector *S = gsl_vector_alloc(NODES), *work = gsl_vector_alloc(NODES);
    int rank = 0;
    claim(grid_p2g(grid, p) == OK, "all particles are on the grid");
    *nodes = 0;
    for (int a = 0; a < NODES; a++) *nodes += grid->mass[a] > 0.0;
    for (int q = 0; q < p->n; q++) {
        struct support s;
        claim(grid_support(grid, &p->x[2 * q], &s) == OK, "inside");
        for (int i = 0; i < s.n; i++)
            gsl_matrix_set(U, (size_t)q, (size_t)s.node[i], s.w[i]);
        unseen[q] = q % 2 ? -1.0 : 1.0;
    }
    gsl_linalg_SV_decomp(U, V, S, work);
    for (size_t a = 0; a < NODES; a++) {
        double part = 0.0;
        if (gsl_vector_get(S, a) < 1e-11) continue;
        rank++;
        for (int q = 0; q < p->n; q++)
            part += gsl_matrix_get(U, (size_t)q, a) * unseen[q];
        for (int q = 0; q < p->n; q++)
            unseen[q] -= gsl_matrix_get(U, (size_t)q, a) * part;
    }
    gsl_matrix_free(U);
    gsl_matrix_free(V);
    gsl_vector_free(S);
    gsl_vector_free(work);
    return rank;
}

int main(void)
{
    double unseen[MOST], flip = 0.0, rest = 0.0, apic = 0.0;
    int nodes, missing[ORDER_MAX + 1][5];
    table_begin("rank", "order ppc particles nodes rank unseen");
    for (int order = 1; order <= ORDER_MAX; order++)
        for (int ppc = 1; ppc <= 4; ppc++) {
            struct grid *grid = new_grid(order);
            struct particles *p = bar(ppc);
            const int rank = rank_of(grid, p, &nodes, unseen);
            missing[order][ppc] = p->n - rank;
            table_row(order, ppc, p->n, nodes, rank, p->n - rank);
            claim(ppc == 1 || rank == nodes, "two per cell see all nodes");
            particles_free(p);
            grid_free(grid);
        }
    table_end();
    claim(missing[2][2] == 5 && missing[2][4] == 21,
          "the quadratic kernel does not see 5 of 16 and 21 of 32 (%d, %d)",
          missing[2][2], missing[2][4]);

    /* a smooth motion and an unseen one; 100 transfers */
    struct grid *grid = new_grid(2);
    struct particles *p[4];
    for (int k = 0; k < 4; k++) p[k] = bar(4);
    rank_of(grid, p[0], &nodes, unseen);
    for (int k = 0; k < 4; k++)
        for (int q = 0; q < p[k]->n; q++)
            p[k]->v[2 * q] = cos(acos(-1.0) * p[k]->x[2 * q] / CELLS) +
                             (k < 3 ? 0.5 * unseen[q] : 0.0);
    for (int k = 0; k < 4; k++) /* 3: PIC of the smooth motion alone */
        for (int i = 0; i < (k == FLIP ? 100 : 1); i++) {
            const enum transfer how = k < 3 ? (enum transfer)k : PIC;
            claim(grid_p2g(grid, p[k]) == OK &&
                      grid_g2p(grid, how, 0.0, p[k]) == OK, "on the grid");
        }
    table_begin("modes", "x start unseen pic flip");
    for (int q = 0; q < p[0]->n; q++) {
        const double x = p[0]->x[2 * q];
        const double start = cos(acos(-1.0) * x / CELLS) + 0.5 * unseen[q];
        table_row(x, start, unseen[q], p[PIC]->v[2 * q], p[FLIP]->v[2 * q]);
        flip = fmax(flip, fabs(p[FLIP]->v[2 * q] - start));
        apic = fmax(apic, fabs(p[APIC]->v[2 * q] - p[PIC]->v[2 * q]));
        rest = fmax(rest, fabs(p[PIC]->v[2 * q] - p[3]->v[2 * q]));
    }
    table_end();
    for (int k = 0; k < 4; k++) particles_free(p[k]);
    grid_free(grid);
    claim(flip < 1e-12, "FLIP carries the unseen motion for ever (%g)", flip);
    claim(rest < 1e-12, "one PIC transfer has removed it (%g)", rest);
    claim(apic < 1e-12, "so has APIC, from B = 0 (%g)", apic);
    return table_finish();
}
