/* particles.c - see particles.h. */
#include "particles/particles.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *transfer_name(enum transfer transfer)
{
    static const char *const name[] = {"PIC", "FLIP", "APIC"};
    return name[transfer];
}

/* ---- kernels ------------------------------------------------------------- */

int kernel_weights(int order, double h, double x, double w[], double dw[])
{
    assert(order >= 1 && order <= ORDER_MAX);
    /* order 2: cell is the node before the nearest one, and f - 1 = t the
     * distance from the nearest, |t| <= 1/2; else x is f beyond the node cell
     */
    const double cell = floor(order == 2 ? x / h - 0.5 : x / h);
    const double f = x / h - cell, g = 1.0 - f, t = f - 1.0;
    if (order == 1) {
        w[0] = g;
        w[1] = f;
        dw[0] = -1.0 / h;
        dw[1] = 1.0 / h;
        return (int)cell;
    }
    if (order == 2) {
        w[0] = 0.5 * (0.5 - t) * (0.5 - t);
        w[1] = 0.75 - t * t;
        w[2] = 0.5 * (0.5 + t) * (0.5 + t);
        dw[0] = (t - 0.5) / h;
        dw[1] = -2.0 * t / h;
        dw[2] = (t + 0.5) / h;
        return (int)cell;
    }
    w[0] = g * g * g / 6.0; /* order 3: nodes are 1 + f, f, g, 1 + g away */
    w[1] = f * f * (0.5 * f - 1.0) + 2.0 / 3.0;
    w[2] = g * g * (0.5 * g - 1.0) + 2.0 / 3.0;
    w[3] = f * f * f / 6.0;
    dw[0] = -0.5 * g * g / h;
    dw[1] = f * (1.5 * f - 2.0) / h;
    dw[2] = -g * (1.5 * g - 2.0) / h;
    dw[3] = 0.5 * f * f / h;
    return (int)cell - 1;
}

double kernel_inertia(int order, double h, double x)
{
    assert(order >= 1 && order <= ORDER_MAX);
    if (order > 1) return h * h * (order == 2 ? 0.25 : 1.0 / 3.0);
    const double f = x / h - floor(x / h);
    return h * h * (f * (1.0 - f)); /* (1 - f) f^2 + f (1 - f)^2 */
}

/* ---- grid ---------------------------------------------------------------- */

struct grid *grid_alloc(int order, const double origin[2], double h,
                        const int nodes[2])
{
    struct grid *grid = allocate(1, sizeof *grid);
    assert(order >= 1 && order <= ORDER_MAX && h > 0.0);
    assert(nodes[0] > order && (nodes[1] > order || nodes[1] == 1));
    grid->order = order;
    grid->kernel = kernel_weights;
    grid->h = h;
    for (int k = 0; k < 2; k++) {
        grid->nodes[k] = nodes[k];
        grid->origin[k] = origin[k];
    }
    grid->n_node = nodes[0] * nodes[1];
    grid->mass = allocate((size_t)grid->n_node, sizeof *grid->mass);
    grid->v = allocate(2 * (size_t)grid->n_node, sizeof *grid->v);
    grid->next = allocate(2 * (size_t)grid->n_node, sizeof *grid->next);
    return grid;
}

void grid_free(struct grid *grid)
{
    if (!grid) return;
    free(grid->mass);
    free(grid->v);
    free(grid->next);
    free(grid);
}

void grid_place(const struct grid *grid, int a, double x[2])
{
    x[0] = grid->origin[0] + grid->h * (a % grid->nodes[0]);
    x[1] = grid->origin[1] + grid->h * (a / grid->nodes[0]);
}

enum status grid_support(const struct grid *grid, const double x[2],
                         struct support *s)
{
    const double h = grid->h;
    double w[2][ORDER_MAX + 1] = {{0.0}, {1.0}}, dw[2][ORDER_MAX + 1] = {{0.0}};
    double way[2] = {0.0, 0.0}; /* from the origin, within the period */
    int first[2] = {0, 0}, width[2] = {1, 1};
    s->n = 0;
    s->inertia[0] = s->inertia[1] = 0.0;
    for (int k = 0; k < 2 && grid->nodes[k] > 1; k++) {
        const double length = h * grid->nodes[k];
        const int endless = k == 0 && grid->periodic;
        way[k] = x[k] - grid->origin[k];
        if (!isfinite(way[k])) return NONFINITE;
        if (endless) way[k] -= length * floor(way[k] / length);
        if (way[k] < 0.0 || way[k] > length) return OUTSIDE;
        width[k] = grid->order + 1;
        first[k] = grid->kernel(grid->order, h, way[k], w[k], dw[k]);
        if (!endless && (first[k] < 0 || first[k] + width[k] > grid->nodes[k]))
            return OUTSIDE;
        s->inertia[k] = kernel_inertia(grid->order, h, way[k]);
    }
    s->n = width[0] * width[1];
    for (int q = 0; q < width[0]; q++) {
        const int n = grid->nodes[0], i = first[0] + q;
        const int column = grid->periodic ? (i % n + n) % n : i; /* around */
        const double offset = h * i - way[0];
        for (int r = 0, a = q; r < width[1]; r++, a += width[0]) {
            const int j = first[1] + r;
            s->node[a] = j * n + column;
            s->w[a] = w[0][q] * w[1][r];
            s->gradient[a][0] = dw[0][q] * w[1][r];
            s->gradient[a][1] = w[0][q] * dw[1][r];
            s->offset[a][0] = offset;
            s->offset[a][1] = h * j - way[1];
        }
    }
    return OK;
}

void support_value(const struct support *s, const double u[], double value[2])
{
    value[0] = value[1] = 0.0;
    for (int q = 0; q < s->n; q++)
        for (int k = 0; k < 2; k++) value[k] += s->w[q] * u[2 * s->node[q] + k];
}

mat2 support_gradient(const struct support *s, const double u[])
{
    mat2 G = {{{0.0}}};
    for (int q = 0; q < s->n; q++)
        for (int k = 0; k < 2; k++)
            for (int l = 0; l < 2; l++)
                G.m[k][l] += u[2 * s->node[q] + k] * s->gradient[q][l];
    return G;
}

/* ---- particles ----------------------------------------------------------- */

struct particles *particles_alloc(int n)
{
    const size_t size = (size_t)n;
    struct particles *p = allocate(1, sizeof *p);
    p->n = n;
    p->x = allocate(2 * size, sizeof *p->x);
    p->v = allocate(2 * size, sizeof *p->v);
    p->F = allocate(size, sizeof *p->F);
    p->B = allocate(size, sizeof *p->B);
    p->mass = allocate(size, sizeof *p->mass);
    p->volume = allocate(size, sizeof *p->volume);
    for (int q = 0; q < n; q++) p->F[q] = mat2_identity();
    return p;
}

void particles_free(struct particles *p)
{
    if (!p) return;
    free(p->x);
    free(p->v);
    free(p->F);
    free(p->B);
    free(p->mass);
    free(p->volume);
    free(p);
}

struct particles *particles_box(const double low[2], const double high[2],
                                const int count[2], double rho)
{
    struct particles *p = particles_alloc(count[0] * count[1]);
    const double width[2] = {(high[0] - low[0]) / count[0],
                             (high[1] - low[1]) / count[1]};
    int q = 0;
    for (int j = 0; j < count[1]; j++)
        for (int i = 0; i < count[0]; i++, q++) {
            p->x[2 * q] = low[0] + width[0] * (i + 0.5);
            p->x[2 * q + 1] = low[1] + width[1] * (j + 0.5);
            p->volume[q] = width[0] * width[1];
            p->mass[q] = rho * p->volume[q];
        }
    return p;
}

/* ---- transfers ----------------------------------------------------------- */

enum status grid_p2g(struct grid *grid, const struct particles *p)
{
    const size_t n = (size_t)grid->n_node;
    memset(grid->mass, 0, n * sizeof *grid->mass);
    memset(grid->v, 0, 2 * n * sizeof *grid->v);
    for (int q = 0; q < p->n; q++) {
        struct support s;
        const enum status status = grid_support(grid, &p->x[2 * q], &s);
        if (status != OK) return status;
        /* C = B D^-1; where D = 0 (on a node of the linear kernel, across a
         * bar) no node with weight is away from the particle */
        mat2 C = {{{0.0}}};
        for (int k = 0; k < 2; k++)
            for (int l = 0; l < 2; l++)
                if (s.inertia[l] > 0.0)
                    C.m[k][l] = p->B[q].m[k][l] / s.inertia[l];
        for (int i = 0; i < s.n; i++) {
            const double m = p->mass[q] * s.w[i]; /* m_p N_a */
            grid->mass[s.node[i]] += m;
            for (int k = 0; k < 2; k++)
                grid->v[2 * s.node[i] + k] +=
                    m * (p->v[2 * q + k] + C.m[k][0] * s.offset[i][0] +
                         C.m[k][1] * s.offset[i][1]);
        }
    }
    for (int a = 0; a < grid->n_node; a++) {
        if (!(grid->mass[a] > 0.0)) continue; /* else momentum / mass */
        for (int k = 0; k < 2; k++) grid->v[2 * a + k] /= grid->mass[a];
    }
    memcpy(grid->next, grid->v, 2 * n * sizeof *grid->next);
    return OK;
}

enum status grid_g2p(const struct grid *grid, enum transfer transfer, double dt,
                     struct particles *p)
{
    for (int q = 0; q < p->n; q++) {
        struct support s;
        double before[2], after[2];
        const enum status status = grid_support(grid, &p->x[2 * q], &s);
        if (status != OK) return status;
        support_value(&s, grid->v, before);
        support_value(&s, grid->next, after);
        p->B[q] = (mat2){{{0.0}}};
        if (transfer == APIC)
            for (int i = 0; i < s.n; i++)
                for (int k = 0; k < 2; k++)
                    for (int l = 0; l < 2; l++)
                        p->B[q].m[k][l] += s.w[i] * s.offset[i][l] *
                                           grid->next[2 * s.node[i] + k];
        p->F[q] = mat2_add(
            p->F[q],
            mat2_multiply(mat2_scale(dt, support_gradient(&s, grid->next)),
                          p->F[q]));
        for (int k = 0; k < 2; k++) {
            if (transfer == FLIP)
                p->v[2 * q + k] += after[k] - before[k];
            else
                p->v[2 * q + k] = after[k];
            p->x[2 * q + k] += dt * after[k];
        }
    }
    return OK;
}

/* ---- moments ------------------------------------------------------------- */

/* Add a point of mass m at x with velocity v. */
static void add_point(struct moments *all, double m, const double x[2],
                      const double v[2])
{
    all->mass += m;
    for (int k = 0; k < 2; k++) {
        all->momentum[k] += m * v[k];
        all->kinetic += 0.5 * m * v[k] * v[k];
    }
    all->angular += m * (x[0] * v[1] - x[1] * v[0]);
}

struct moments particles_moments(const struct particles *p)
{
    struct moments all = {.mass = 0.0};
    for (int q = 0; q < p->n; q++) {
        add_point(&all, p->mass[q], &p->x[2 * q], &p->v[2 * q]);
        all.angular += p->mass[q] * (p->B[q].m[1][0] - p->B[q].m[0][1]);
    }
    return all;
}

struct moments grid_moments(const struct grid *grid, const double v[])
{
    struct moments all = {.mass = 0.0};
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        add_point(&all, grid->mass[a], x, &v[2 * a]);
    }
    return all;
}
