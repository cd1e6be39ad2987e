/* particle_step.c - see particle_step.h. */
#include "particles/particle_step.h"

#include "material/modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *wall_name(enum wall wall)
{
    static const char *const name[] = {"none", "held", "mirror"};
    return name[wall];
}

/* ---- unknowns ------------------------------------------------------------ */

struct unknowns *unknowns_alloc(const struct grid *grid)
{
    struct unknowns *map = allocate(1, sizeof *map);
    map->n_dof = 2 * grid->n_node;
    map->equation = allocate((size_t)map->n_dof, sizeof *map->equation);
    map->sign = allocate((size_t)map->n_dof, sizeof *map->sign);
    for (int r = 0; r < map->n_dof; r++) {
        map->equation[r] = -1;
        map->sign[r] = 1.0;
    }
    return map;
}

void unknowns_free(struct unknowns *map)
{
    if (!map) return;
    free(map->equation);
    free(map->sign);
    free(map);
}

void unknowns_number(const struct grid *grid, enum wall wall,
                     struct unknowns *map)
{
    const int column = (int)lround(-grid->origin[0] / grid->h); /* of x_1 = 0 */
    const int n = grid->nodes[0], axes = grid->nodes[1] > 1 ? 2 : 1;
    map->n = 0;
    for (int a = 0; a < grid->n_node; a++) {
        const int free = wall == NO_WALL || a % n > column;
        for (int k = 0; k < 2; k++) {
            const int moves = free && k < axes && grid->mass[a] > 0.0;
            map->equation[2 * a + k] = moves ? map->n++ : -1;
            map->sign[2 * a + k] = 1.0;
        }
    }
    if (wall != MIRROR) return;
    for (int a = 0; a < grid->n_node; a++) {
        const int beyond = column - a % n; /* columns beyond the wall */
        if (beyond <= 0 || column + beyond >= n) continue;
        for (int r = 2 * a; r < 2 * a + 2; r++) { /* of node a + 2 beyond */
            map->equation[r] = map->equation[r + 4 * beyond];
            map->sign[r] = -1.0;
        }
    }
}

void unknowns_gather(const struct unknowns *map, const double r[], double y[])
{
    for (int e = 0; e < map->n; e++) y[e] = 0.0;
    for (int s = 0; s < map->n_dof; s++)
        if (map->equation[s] >= 0) y[map->equation[s]] += map->sign[s] * r[s];
}

void unknowns_scatter(const struct unknowns *map, const double y[], double u[])
{
    for (int s = 0; s < map->n_dof; s++) {
        const int e = map->equation[s];
        u[s] = e >= 0 ? map->sign[s] * y[e] : 0.0;
    }
}

struct matrix *unknowns_matrix(const struct particle_body *body,
                               const struct unknowns *map)
{
    const int band = particle_band(body, map->equation);
    return matrix_alloc(BANDED, map->n, band < map->n ? band : map->n - 1);
}

double unknowns_largest(const struct unknowns *map, const double y[])
{
    double largest = 0.0;
    for (int e = 0; e < map->n && !isnan(largest); e++)
        if (!(fabs(y[e]) <= largest)) largest = fabs(y[e]);
    return largest;
}

/* ---- mass ---------------------------------------------------------------- */

enum status particle_mass(const struct particle_body *body, int consistent,
                          const double w[], double out[])
{
    const struct particles *all = body->particles;
    for (int r = 0; r < 2 * body->grid->n_node; r++)
        out[r] = consistent ? 0.0 : body->grid->mass[r / 2] * w[r];
    if (!consistent) return OK;
    for (int p = 0; p < all->n; p++) {
        struct support s;
        double value[2];
        const enum status status = grid_support(body->grid, &all->x[2 * p], &s);
        if (status != OK) return status;
        support_value(&s, w, value); /* w(x_p) = sum_b N_b w_b */
        for (int i = 0; i < s.n; i++)
            for (int k = 0; k < 2; k++)
                out[2 * s.node[i] + k] += all->mass[p] * s.w[i] * value[k];
    }
    return OK;
}

enum status particle_mass_matrix(const struct particle_body *body,
                                 int consistent, double scale,
                                 const struct unknowns *map, struct matrix *A)
{
    const struct particles *all = body->particles;
    if (!consistent) {
        for (int r = 0; r < map->n_dof; r++)
            if (map->equation[r] >= 0)
                matrix_add(A, map->equation[r], map->equation[r],
                           scale * body->grid->mass[r / 2]);
        return OK;
    }
    for (int p = 0; p < all->n; p++) {
        struct support s;
        const enum status status = grid_support(body->grid, &all->x[2 * p], &s);
        if (status != OK) return status;
        for (int i = 0; i < s.n; i++)
            for (int k = 0; k < 2; k++)
                for (int j = 0; j < s.n; j++) { /* sum_p m_p N_i N_j */
                    const int r = 2 * s.node[i] + k, c = 2 * s.node[j] + k;
                    if (map->equation[r] < 0 || map->equation[c] < 0) continue;
                    matrix_add(A, map->equation[r], map->equation[c],
                               scale * all->mass[p] * s.w[i] * s.w[j] *
                                   map->sign[r] * map->sign[c]);
                }
    }
    return OK;
}

/* ---- potential ----------------------------------------------------------- */

double potential_sum(struct potential E)
{
    return E.inertia + E.elastic + E.load;
}

int potential_falls(struct potential here, struct potential there)
{
    const double size =
        fabs(here.inertia) + fabs(here.elastic) + fabs(here.load);
    return potential_sum(there) <= potential_sum(here) + 1e-12 * size;
}

enum status particle_potential(const struct particle_body *body,
                               const struct particle_step *step,
                               const double u[], struct potential *E,
                               double r[])
{
    const struct grid *grid = body->grid;
    const int n_dof = 2 * grid->n_node;
    double *w = allocate((size_t)n_dof, sizeof *w);
    double *Mw = allocate((size_t)n_dof, sizeof *Mw);
    *E = (struct potential){0.0, 0.0, 0.0};
    enum status status = particle_energy(body, u, &E->elastic);
    if (status == OK) status = particle_force(body, u, r);
    for (int s = 0; s < n_dof; s++) w[s] = step->rate * u[s] - grid->v[s];
    if (status == OK) status = particle_mass(body, step->consistent, w, Mw);
    if (status == OK)
        for (int a = 0; a < grid->n_node; a++)
            for (int k = 0; k < 2; k++) {
                const int s = 2 * a + k;
                const double weight = grid->mass[a] * step->g[k];
                E->inertia += 0.5 * w[s] * Mw[s];
                E->load -= weight * u[s];
                r[s] = step->rate * Mw[s] - r[s] - weight; /* r was f(u) */
            }
    if (status == OK && !isfinite(potential_sum(*E))) status = NONFINITE;
    free(w);
    free(Mw);
    return status;
}

/* ---- Newton -------------------------------------------------------------- */

struct room {
    double *r, *du, *trial, *y;
};

/* u -= part du with the first part of 1, 1/2, 1/4, ... at which E falls. */
static enum status search(const struct particle_body *body,
                          const struct particle_step *step,
                          const struct room *room, struct potential start,
                          double u[], double *part)
{
    const int n_dof = 2 * body->grid->n_node;
    for (*part = 1.0; *part > 1e-12; *part *= 0.5) {
        struct potential trial;
        for (int s = 0; s < n_dof; s++)
            room->trial[s] = u[s] - *part * room->du[s];
        if (particle_potential(body, step, room->trial, &trial, room->r) ==
                OK && potential_falls(start, trial)) {
            memcpy(u, room->trial, (size_t)n_dof * sizeof *u);
            return OK;
        }
    }
    return STALLED;
}

mat2 particle_projected(const struct material *material, mat2 F, mat2 dF)
{
    if (material->law == LINEAR) return material2_dpk1(material, F, dF);
    const struct modes modes = modes_at(material, F);
    return modes_dpk1(&modes, dF);
}

/* A := K + M / dt^2, factored; *weight := its largest diagonal entry. */
static enum status factor(const struct particle_body *body,
                          const struct particle_step *step,
                          const struct unknowns *map, const double u[],
                          struct matrix *A, double *weight)
{
    matrix_zero(A);
    enum status status =
        particle_stiffness(body, u, map->equation, map->sign, A);
    if (status == OK)
        status = particle_mass_matrix(body, step->consistent,
                                      step->rate * step->rate, map, A);
    if (status != OK) return status;
    *weight = matrix_max_diagonal(A);
    return matrix_factor(A);
}

struct particle_report particle_newton(const struct particle_body *body,
                                       const struct particle_step *step,
                                       double tolerance, double u[])
{
    const size_t n_dof = 2 * (size_t)body->grid->n_node;
    const struct particle_body convex = {body->grid, body->particles,
                                         body->material, particle_projected};
    struct particle_report report = {.status = OK};
    struct unknowns *map = unknowns_alloc(body->grid);
    const struct room room = {allocate(n_dof, sizeof(double)),
                              allocate(n_dof, sizeof(double)),
                              allocate(n_dof, sizeof(double)),
                              allocate(n_dof, sizeof(double))};
    double weight = 0.0;
    tolerance *= body->grid->h;
    memset(u, 0, n_dof * sizeof *u);
    unknowns_number(body->grid, step->wall, map);
    struct matrix *A = map->n > 0 ? unknowns_matrix(body, map) : NULL;
    for (int k = 0; A; k = ++report.iterations) {
        report.status = particle_potential(body, step, u, &report.E, room.r);
        if (report.status != OK) break;
        unknowns_gather(map, room.r, room.y);
        report.residual[k] = unknowns_largest(map, room.y);
        if (k > 0 && report.increment[k - 1] <= tolerance &&
            report.residual[k] <= tolerance * weight)
            break;
        report.status = MAX_ITERATIONS;
        if (k == STEP_CAP) break;
        report.status = factor(body, step, map, u, A, &weight);
        if (report.status == NOT_SPD) {
            report.status = factor(&convex, step, map, u, A, &weight);
            report.projections++;
        }
        if (report.status != OK) break;
        matrix_solve(A, room.y); /* A du = r, and u -= du */
        unknowns_scatter(map, room.y, room.du);
        report.increment[k] = unknowns_largest(map, room.y);
        report.status =
            isfinite(report.increment[k])
                ? search(body, step, &room, report.E, u, &report.part[k])
                : NONFINITE;
        if (report.status != OK) break;
    }
    matrix_free(A);
    unknowns_free(map);
    free(room.r);
    free(room.du);
    free(room.trial);
    free(room.y);
    return report;
}
