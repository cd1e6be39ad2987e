/* particle_force.c - see particle_force.h. */
#include "particle_force.h"

#include <limits.h>
#include <math.h>
#include <string.h>

void support_pull_back(struct support *s, mat2 F)
{
    for (int i = 0; i < s->n; i++) {
        const double g0 = s->gradient[i][0], g1 = s->gradient[i][1];
        for (int k = 0; k < 2; k++)
            s->gradient[i][k] = F.m[0][k] * g0 + F.m[1][k] * g1;
    }
}

/* Support of particle p with pulled back gradients, and F at the nodes x + u.
 */
static enum status at_particle(const struct particle_body *body, int p,
                               const double u[], struct support *s, mat2 *F)
{
    const struct particles *all = body->particles;
    const enum status status = grid_support(body->grid, &all->x[2 * p], s);
    if (status != OK) return status;
    support_pull_back(s, all->F[p]);
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

static enum status finite(const double v[], int n)
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
    return finite(energy, 1);
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
    return finite(f, n_dof);
}

enum status particle_product(const struct particle_body *body, const double u[],
                             const double w[], double out[])
{
    const int n_dof = 2 * body->grid->n_node;
    memset(out, 0, (size_t)n_dof * sizeof *out);
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        mat2 F;
        const enum status status = at_particle(body, p, u, &s, &F);
        if (status != OK) return status;
        add_to_nodes(&s, body->particles->volume[p],
                     dpk1(body, F, support_gradient(&s, w)), out);
    }
    return finite(out, n_dof);
}

int particle_band(const struct particle_body *body, const int equation[])
{
    int band = 0;
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        int low = INT_MAX, high = 0;
        if (grid_support(body->grid, &body->particles->x[2 * p], &s) != OK)
            return INT_MAX;
        for (int r = 0; r < 2 * s.n; r++) {
            const int e = equation[2 * s.node[r / 2] + r % 2];
            if (e < 0) continue;
            low = e < low ? e : low;
            high = e > high ? e : high;
        }
        band = high - low > band ? high - low : band;
    }
    return band;
}

/* K += T^T (V q_a D q_b) T, T what the unknowns do to the nodes. */
static void add_particle(const struct support *s, double volume,
                         const mat2 D[4], const int equation[],
                         const double sign[], struct matrix *K)
{
    for (int c = 0; c < 2 * s->n; c++) {
        const int column = 2 * s->node[c / 2] + c % 2;
        const double *q = s->gradient[c / 2];
        if (equation[column] < 0) continue;
        /* dP for a unit displacement of this component: dF = e_(c%2) (x) q */
        const mat2 dP = mat2_add(mat2_scale(q[0], D[c % 2 * 2]),
                                 mat2_scale(q[1], D[c % 2 * 2 + 1]));
        for (int r = 0; r < 2 * s->n; r++) {
            const int row = 2 * s->node[r / 2] + r % 2;
            if (equation[row] < 0) continue;
            const double both = sign ? sign[row] * sign[column] : 1.0;
            matrix_add(K, equation[row], equation[column],
                       both * volume *
                           (dP.m[r % 2][0] * s->gradient[r / 2][0] +
                            dP.m[r % 2][1] * s->gradient[r / 2][1]));
        }
    }
}

enum status particle_stiffness(const struct particle_body *body,
                               const double u[], const int equation[],
                               const double sign[], struct matrix *K)
{
    for (int p = 0; p < body->particles->n; p++) {
        struct support s;
        mat2 F, D[4]; /* D[2k + L] = dP for dF = e_k (x) e_L */
        const enum status status = at_particle(body, p, u, &s, &F);
        if (status != OK) return status;
        for (int m = 0; m < 4; m++) {
            mat2 unit = {{{0.0}}};
            unit.m[m / 2][m % 2] = 1.0;
            D[m] = dpk1(body, F, unit);
        }
        add_particle(&s, body->particles->volume[p], D, equation, sign, K);
    }
    return OK;
}
