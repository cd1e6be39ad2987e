/* particle_force.c - see particle_force.h. */
#include "particles/particle_force.h"

#include "linear/vec.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void support_pull_back(struct support *s, mat2 F)
{
    for (int i = 0; i < s->n; i++) { /* q_a = F^T grad N_a */
        const double g0 = s->gradient[i][0], g1 = s->gradient[i][1];
        for (int k = 0; k < 2; k++)
            s->gradient[i][k] = F.m[0][k] * g0 + F.m[1][k] * g1;
    }
}

/* Find the support of particle p with pulled back gradients, and F at the nodes
 * x + u. */
static enum status at_particle(const struct particle_body *body, int p,
                               const double u[], struct support *s, mat2 *F)
{
    const struct particles *all = body->particles;
    const enum status status = grid_support(body->grid, &all->x[2 * p], s);
    if (status != OK) return status;
    support_pull_back(s, all->F[p]); /* u (x) q = (u (x) grad N) F_p */
    *F = mat2_add(all->F[p], support_gradient(s, u));
    const double J = mat2_det(*F);
    if (!isfinite(J)) return NONFINITE;
    return material_defined(&body->material, J) ? OK : INVERTED;
}

/* out_a += scale P q_a. */
static void add_to_nodes(const struct support *s, double scale, mat2 P,
                         double out[])
{
    for (int i = 0; i < s->n; i++)
        for (int k = 0; k < 2; k++)
            out[2 * s->node[i] + k] += scale * (P.m[k][0] * s->gradient[i][0] +
                                                P.m[k][1] * s->gradient[i][1]);
}

static enum status all_finite(const double v[], int n)
{
    for (int r = 0; r < n; r++)
        if (!isfinite(v[r])) return NONFINITE;
    return OK;
}

static mat2 dpk1(const struct particle_body *body, mat2 F, mat2 dF)
{
    dpk1_function *const d = body->dpk1 ? body->dpk1 : material2_dpk1;
    return d(&body->material, F, dF);
}

enum status particle_energy(const struct particle_body *body, const double u[],
                            double *energy)
{
    *energy = 0.0;
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        mat2 F;
        const enum status status = at_particle(body, p, u, &s, &F);
        if (status != OK) return status;
        *energy +=
            body->particles->volume[p] * material2_psi(&body->material, F);
    }
    return all_finite(energy, 1);
}

enum status particle_force(const struct particle_body *body, const double u[],
                           double f[])
{
    const int n_dof = 2 * body->grid->n_node;
    memset(f, 0, (size_t)n_dof * sizeof *f);
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        mat2 F;
        const enum status status = at_particle(body, p, u, &s, &F);
        if (status != OK) return status;
        add_to_nodes(&s, -body->particles->volume[p],
                     material2_pk1(&body->material, F), f);
    }
    return all_finite(f, n_dof);
}

enum status particle_cauchy_force(const struct particle_body *body,
                                  const double u[], double f[])
{
    const int n_dof = 2 * body->grid->n_node;
    memset(f, 0, (size_t)n_dof * sizeof *f);
    for (int p = 0; p < body->particles->n; p++) {
        struct support now;
        mat2 F;
        const enum status status = at_particle(body, p, u, &now, &F);
        if (status != OK) return status;
        grid_support(body->grid, &body->particles->x[2 * p], &now);
        const mat2 hat = mat2_add(mat2_identity(), support_gradient(&now, u));
        const double J = mat2_det(F); /* F = F_hat F_p */
        const mat2 sigma =
            mat2_scale(1.0 / J, mat2_multiply(material2_pk1(&body->material, F),
                                              mat2_transpose(F)));
        /* gradient := F_hat^-T gradient */
        support_pull_back(&now, mat2_scale(1.0 / mat2_det(hat),
                                           mat2_transpose(mat2_cofactor(hat))));
        add_to_nodes(&now, -J * body->particles->volume[p], sigma, f);
    }
    return all_finite(f, n_dof);
}

enum status particle_difference_force(const struct particle_body *body,
                                      const double u[], double step, double f[])
{
    const int n_dof = 2 * body->grid->n_node;
    double *moved = allocate((size_t)n_dof, sizeof *moved), plus, minus;
    enum status status = OK;
    memcpy(moved, u, (size_t)n_dof * sizeof *moved);
    for (int r = 0; r < n_dof && status == OK; r++) {
        moved[r] = u[r] + step;
        status = particle_energy(body, moved, &plus);
        moved[r] = u[r] - step;
        if (status == OK) status = particle_energy(body, moved, &minus);
        moved[r] = u[r];
        if (status == OK) f[r] = -(plus - minus) / (2.0 * step);
    }
    free(moved);
    return status;
}

struct balance grid_balance(const struct grid *grid, const double u[],
                            const double f[])
{
    struct balance sum = {{0.0, 0.0}, 0.0};
    for (int a = 0; a < grid->n_node; a++) {
        double x[2];
        grid_place(grid, a, x);
        for (int k = 0; k < 2; k++) {
            x[k] += u ? u[2 * a + k] : 0.0;
            sum.force[k] += f[2 * a + k];
        }
        sum.torque += x[0] * f[2 * a + 1] - x[1] * f[2 * a];
    }
    return sum;
}

enum status particle_taylor(const struct particle_body *body, const double u[],
                            const double w[], double t, const double f[],
                            const double Kw[], struct taylor *error)
{
    const int n_dof = 2 * body->grid->n_node;
    double *moved = allocate((size_t)n_dof, sizeof *moved);
    double *g = allocate((size_t)n_dof, sizeof *g);
    double first = 0.0, second = 0.0, slope = 0.0; /* slope: dPsi/du.w */
    for (int r = 0; r < n_dof; r++) {
        moved[r] = u[r] + t * w[r];
        slope -= f[r] * w[r];
    }
    enum status status = particle_energy(body, u, &first);
    if (status == OK) status = particle_energy(body, moved, &second);
    if (status == OK) status = particle_force(body, moved, g);
    *error = (struct taylor){fabs(second - first - t * slope), 0.0};
    for (int r = 0; r < n_dof; r++) /* f(u + t w) = f - t K w + O(t^2) */
        error->force = fmax(error->force, fabs(g[r] - f[r] + t * Kw[r]));
    free(moved);
    free(g);
    return status;
}

int particle_band(const struct particle_body *body, const int equation[])
{
    int band = 0;
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        int low = INT_MAX, high = 0;
        if (grid_support(body->grid, &body->particles->x[2 * p], &s) != OK)
            return INT_MAX;
        for (int i = 0; i < s.n; i++)
            for (int k = 0; k < 2; k++) {
                const int e = equation[2 * s.node[i] + k];
                if (e < 0) continue;
                low = e < low ? e : low;
                high = e > high ? e : high;
            }
        band = high - low > band ? high - low : band;
    }
    return band;
}

/* The unknowns of a particle's nodes, -1 where there is none: their number in
 * K, the place of their diagonal entry, and q with their sign; q[a][j] is
 * component j of q of both unknowns of node a. */
struct its_unknowns {
    int number[2 * SUPPORT_MAX];
    double *diagonal[2 * SUPPORT_MAX];
    two q[SUPPORT_MAX][2];
};

/* Add block (a, b), a >= b, of K and its transpose entry by entry: an unknown
 * may be missing, they may stand in any order, and two nodes may share one. */
static void add_entries(const struct its_unknowns *map, int a, int b,
                        const two block[2])
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            const int row = map->number[2 * a + i];
            const int column = map->number[2 * b + k], below = row - column;
            if (row < 0 || column < 0) continue;
            if (below >= 0) map->diagonal[2 * b + k][below] += block[k][i];
            if (a != b && below <= 0)
                map->diagonal[2 * a + i][-below] += block[k][i];
        }
}

/* K += T^T (V q_a D q_b) T, T what the unknowns do to the n nodes.  D is
 * symmetric; of a banded K the lower half counts. */
static void add_particle(int n, double volume, two D[2][2][2],
                         const struct its_unknowns *map)
{
    for (int b = 0; b < n; b++) {
        const int *nb = &map->number[2 * b];
        double *const *column = &map->diagonal[2 * b];
        const int pair = nb[0] >= 0 && nb[1] == nb[0] + 1;
        two dP[2][2]; /* V dP for a unit of each unknown: dF = e_k (x) q */
        for (int k = 0; k < 2; k++)
            for (int J = 0; J < 2; J++)
                dP[k][J] = volume * (D[k][0][J] * map->q[b][0][k] +
                                     D[k][1][J] * map->q[b][1][k]);
        for (int a = b; a < n; a++) {
            const int *na = &map->number[2 * a], below = na[0] - nb[0];
            const two *q = map->q[a]; /* block: V dP q_a */
            const two block[2] = {dP[0][0] * q[0] + dP[0][1] * q[1],
                                  dP[1][0] * q[0] + dP[1][1] * q[1]};
            if (!pair || na[1] != na[0] + 1 || below < (a > b)) {
                add_entries(map, a, b, block);
                continue;
            }
            TWO(column[0][below]) += block[0];
            if (a > b) TWO(column[1][below - 1]) += block[1];
            else column[1][0] += block[1][1];
        }
    }
}

enum status particle_stiffness(const struct particle_body *body,
                               const double u[], const int equation[],
                               const double sign[], struct matrix *K)
{
    assert(K->storage == BANDED || K->storage == PLAIN);
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        struct its_unknowns map;
        mat2 F;
        two D[2][2][2]; /* D[k][L][J] = dP_.J for dF = e_k (x) e_L */
        const enum status status = at_particle(body, p, u, &s, &F);
        if (status != OK) return status;
        for (int k = 0; k < 2; k++)
            for (int L = 0; L < 2; L++) {
                mat2 unit = {{{0.0}}};
                unit.m[k][L] = 1.0;
                const mat2 dP = dpk1(body, F, unit);
                for (int J = 0; J < 2; J++)
                    D[k][L][J] = (two){dP.m[0][J], dP.m[1][J]};
            }
        for (int a = 0; a < s.n; a++) {
            const int r = 2 * s.node[a];
            const two signs = {sign ? sign[r] : 1.0, sign ? sign[r + 1] : 1.0};
            for (int J = 0; J < 2; J++) map.q[a][J] = signs * s.gradient[a][J];
            for (int k = 0; k < 2; k++) {
                const int e = equation[r + k];
                map.number[2 * a + k] = e;
                map.diagonal[2 * a + k] =
                    e < 0 ? NULL : &K->a[(size_t)e * K->stride];
            }
        }
        add_particle(s.n, body->particles->volume[p], D, &map);
    }
    return OK;
}
