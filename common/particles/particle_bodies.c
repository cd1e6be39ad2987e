/* particle_bodies.c - see particle_bodies.h. */
#include "particles/particle_bodies.h"

#include "base/table.h"

#include <math.h>

struct cloud cloud_hanging(int order, int cells, int ppc)
{
    const double h = 1.0 / cells, low[2] = {-2.0 * h, -0.5};
    const double ends[2][2] = {{0.0, -0.5}, {1.0, 0.5}};
    const int nodes[2] = {(int)lround(1.75 / h) + 3, 1};
    return (struct cloud){
        grid_alloc(order, low, h, nodes),
        particles_box(ends[0], ends[1], (int[]){cells * ppc, 1}, 1.0)};
}

/* Return F with P(F) = p >= 0: P is monotone there, and Newton's method
 * converges from the first step on. */
static double stretch_of(const struct material *material, double p)
{
    double F = 1.0;
    for (int k = 0; k < 60; k++) {
        const double dF = (material1_pk1(material, F) - p) /
                          material1_dpk1(material, F);
        F -= dF;
        if (fabs(dF) <= 1e-15) break;
    }
    return F;
}

double hanging_place(const struct material *material, double c, double X,
                     double *F)
{
    const double base = stretch_of(material, c);
    *F = stretch_of(material, c * (1.0 - X));
    return (base * c - material1_psi(material, base) -
            *F * c * (1.0 - X) + material1_psi(material, *F)) / c;
}

struct hanging_error hanging_error(const struct particles *p,
                                   const struct material *material, double c)
{
    struct hanging_error worst = {0.0, 0.0};
    for (int q = 0; q < p->n; q++) {
        const double X = (q + 0.5) / p->n;
        double F;
        const double x = hanging_place(material, c, X, &F);
        const double P = material1_pk1(material, p->F[q].m[0][0]);
        worst.place = fmax(worst.place, fabs(p->x[2 * q] - x));
        worst.stress = fmax(worst.stress, fabs(P - c * (1.0 - X)));
    }
    return worst;
}

struct cloud cloud_strained(int order)
{
    const double h = 0.125, low[2] = {-2.0 * h, -0.5};
    const int nodes[2] = {12, 1};
    struct cloud c = {grid_alloc(order, low, h, nodes), particles_alloc(10)};
    for (int q = 0; q < c.p->n; q++) {
        const double x = 0.16775 + 0.0613 * q + 0.004 * (2 * q % 5);
        c.p->x[2 * q] = x;
        c.p->v[2 * q] = 0.381275 - 1.9 * (x - 0.16775) + 0.3 * (3 * q % 4);
        c.p->F[q].m[0][0] = 0.93 + 0.021 * (5 * q % 7);
        c.p->mass[q] = c.p->volume[q] = 0.0613;
    }
    return c;
}

struct cloud cloud_block(int order)
{
    const double h = 0.25, low[2] = {-3.0 * h, -3.0 * h};
    const double box[2][2] = {{0.137, 0.091}, {0.637, 0.591}};
    const int nodes[2] = {10, 10}, count[2] = {4, 4};
    struct cloud c = {grid_alloc(order, low, h, nodes),
                      particles_box(box[0], box[1], count, 1.0)};
    for (int q = 0; q < c.p->n; q++) {
        const double x = c.p->x[2 * q] - 0.1995, y = c.p->x[2 * q + 1] - 0.1535;
        c.p->v[2 * q] = 0.73895 - 2.3 * y;
        c.p->v[2 * q + 1] = -0.54675 + 2.3 * x + 0.4 * y;
        c.p->F[q] = (mat2){{{1.04 + 0.01 * (3 * q % 5),
                             0.02 + 0.02 * ((q + 2) % 3)},
                            {-0.05 + 0.01 * (q % 4),
                             0.925 + 0.015 * ((q + 3) % 4)}}};
    }
    return c;
}

struct cloud cloud_stepping(enum stepping which, int order, double g[2])
{
    g[0] = which == HANGING ? 9.81 : which == STRAINED ? -9.81 : 0.0;
    g[1] = 0.0;
    if (which == HANGING) return cloud_hanging(order, 8, 2);
    return which == STRAINED ? cloud_strained(order) : cloud_block(order);
}

double particles_elastic(const struct particles *p,
                         const struct material *material)
{
    double sum = 0.0;
    for (int q = 0; q < p->n; q++)
        sum += p->volume[q] * material2_psi(material, p->F[q]);
    return sum;
}

void cloud_energies(struct cloud c, const struct material *material, double t,
                    const struct particle_report *report)
{
    const struct moments sum = particles_moments(c.p);
    table_row(t, report->iterations, particles_elastic(c.p, material),
              sum.kinetic, grid_moments(c.grid, c.grid->v).kinetic,
              grid_moments(c.grid, c.grid->next).kinetic,
              potential_sum(report->E), sum.momentum[0], sum.momentum[1],
              sum.angular);
}

void cloud_tables(struct cloud c, const struct particle_report *report)
{
    const double *x = c.p->x, *v = c.grid->v, *next = c.grid->next;
    table_begin("newton", "k residual increment part");
    for (int k = 0; k < report->iterations; k++)
        table_row(k, report->residual[k], report->increment[k],
                  report->part[k]);
    table_end();
    table_begin("step", "node x y mass v_x v_y next_x next_y");
    for (int a = 0, i = 0, k = 1; a < c.grid->n_node; a++, i += 2, k += 2) {
        double X[2];
        grid_place(c.grid, a, X);
        if (c.grid->mass[a] > 0.0)
            table_row(a, X[0], X[1], c.grid->mass[a], v[i], v[k], next[i],
                      next[k]);
    }
    table_end();
    table_begin("particles", "x y v_x v_y F11 F12 F21 F22");
    for (int q = 0, i = 0, k = 1; q < c.p->n; q++, i += 2, k += 2) {
        const mat2 F = c.p->F[q];
        table_row(x[i], x[k], c.p->v[i], c.p->v[k], F.m[0][0], F.m[0][1],
                  F.m[1][0], F.m[1][1]);
    }
    table_end();
}
