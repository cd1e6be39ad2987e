/* triangles.c - see triangles.h. */
#include "plane/triangles.h"

#include "linear/vec.h" /* INLINE */
#include "material/modes.h"
#include "plane/lanes.h"
#include "plane/quadratic.h"

#include <math.h>

/* What goes over triangles is written once, and compiled for linear ones, 3
 * nodes and 1 point, and for quadratic ones. */
enum { MOST_NODES = QUADRATIC_NODES };
INLINE int points_of(int nodes)
{
    return nodes == 3 ? 1 : QUADRATIC_POINTS;
}

INLINE const double *gradient_at(const struct body *body, int e, int p,
                                 int nodes)
{
    return &body->gradient[2 * nodes * (points_of(nodes) * e + p)];
}

/* F = I + sum_a u_a (x) grad N_a at point p of triangle e. */
INLINE mat2 deformation(const struct body *body, const double u[], int e, int p,
                        int nodes)
{
    const int *t = &body->vertex[nodes * e];
    const double *g = gradient_at(body, e, p, nodes);
    mat2 F = {{{1.0, 0.0}, {0.0, 1.0}}};
#pragma GCC unroll 6
    for (int a = 0; a < nodes; a++)
#pragma GCC unroll 2
        for (int i = 0; i < 2; i++) {
            F.m[i][0] += u[2 * t[a] + i] * g[2 * a];
            F.m[i][1] += u[2 * t[a] + i] * g[2 * a + 1];
        }
    return F;
}
mat2 triangles_deformation(const struct body *body, const double u[], int e,
                           int p)
{
    return deformation(body, u, e, p, body->nodes);
}

/* *energy += that of the triangles from `first` on. */
INLINE enum status energy_of(const struct body *body, const double u[],
                             double *energy, int first, int nodes)
{
    for (int e = first; e < body->n_element; e++)
        for (int p = 0; p < points_of(nodes); p++) {
            const mat2 F = deformation(body, u, e, p, nodes);
            const double J = mat2_det(F);
            if (!material_defined(&body->material, J))
                return isnan(J) ? NONFINITE : INVERTED;
            *energy += body->area[e] * material2_psi(&body->material, F);
        }
    return OK;
}

enum status triangles_energy(const struct body *body, const double u[],
                             double *energy)
{
    int next = 0;
    *energy = 0.0;
    if (body->element != LINEAR_TRIANGLE)
        return energy_of(body, u, energy, 0, 6);
    const enum status status = lanes_energy(body, u, energy, &next);
    return status == OK ? energy_of(body, u, energy, next, 3) : status;
}

/* The factors of M_ab I + dt^2 area (...), which a point adds to K. */
struct factors {
    double m_aa, m_ab;  /* mass of a vertex, of a pair; linear triangles */
    double mu, dG, ddG; /* mu, G', G'' times dt^2 area */
};

/* Add block (a, b) to the lower band, column by column. */
INLINE void add_block(mat2 block, int a, int b, int place, size_t stride,
                      double entries[])
{
    if (place < 0) return;
    /* column b_1 of K has rows a_1 and a_2, and so has b_2 behind it */
    double *column = &entries[place], *next = column + stride - 1;
    column[0] += block.m[0][0];
    column[1] += block.m[1][0];
    if (a != b) next[0] += block.m[0][1]; /* else above the diagonal */
    next[1] += block.m[1][1];
}

/* Add the blocks M_ab I + mu g_a.g_b I + G'' c_a c_b^T
 * + G' (g_a x g_b) (0 1; -1 0), a >= b [eq:element-tangent]. */
INLINE void add_exact(struct factors s, int nodes, const double g[],
                      const double c[], const int place[], size_t stride,
                      double entries[])
{
#pragma GCC unroll 6
    for (int a = 0, k = 0; a < nodes; a++)
#pragma GCC unroll 6
        for (int b = 0; b <= a; b++, k++) {
            const double *g_a = &g[2 * a], *g_b = &g[2 * b];
            const double *c_a = &c[2 * a], *c_b = &c[2 * b];
            const double same = (a == b ? s.m_aa : s.m_ab) +
                                s.mu * (g_a[0] * g_b[0] + g_a[1] * g_b[1]);
            const double cross = s.dG * (g_a[0] * g_b[1] - g_a[1] * g_b[0]);
            const double c0 = s.ddG * c_a[0], c1 = s.ddG * c_a[1];
            const mat2 block = {{{same + c0 * c_b[0], c0 * c_b[1] + cross},
                                 {c1 * c_b[0] - cross, same + c1 * c_b[1]}}};
            add_block(block, a, b, place[k], stride, entries);
        }
}

/* The same with the negative eigenvalues of dP/dF clamped to 0, modes.h; none
 * is negative if |G'| <= mu and G'' >= 0 [eq:projection]. */
static void add_projected(struct factors s, int nodes, const double g[],
                          const double c[], mat2 F, const int place[],
                          size_t stride, double entries[])
{
    if (fabs(s.dG) <= s.mu && s.ddG >= 0.0) {
        add_exact(s, nodes, g, c, place, stride, entries);
        return;
    }
    static const enum mode order[4] = {MODE_TWIST, MODE_FLIP, MODE_HIGH,
                                       MODE_LOW};
    const struct modes modes = modes_of(F, s.mu, s.dG, s.ddG);
    double d[4][MOST_NODES][2]; /* dF/du_a in direction m */
    for (int m = 0; m < 4; m++)
        for (int a = 0; a < nodes; a++)
            for (int i = 0; i < 2; i++)
                d[m][a][i] = modes.direction[m].m[i][0] * g[2 * a] +
                             modes.direction[m].m[i][1] * g[2 * a + 1];
    for (int a = 0, k = 0; a < nodes; a++)
        for (int b = 0; b <= a; b++, k++) {
            mat2 block =
                mat2_scale(a == b ? s.m_aa : s.m_ab, mat2_identity());
            for (int o = 0; o < 4; o++) {
                const enum mode m = order[o];
                if (!(modes.value[m] > 0.0)) continue;
                for (int i = 0; i < 2; i++) /* value d_a d_b^T */
                    for (int j = 0; j < 2; j++)
                        block.m[i][j] +=
                            modes.value[m] * d[m][a][i] * d[m][b][j];
            }
            add_block(block, a, b, place[k], stride, entries);
        }
}

/* The factors of a step, equal at all points. */
struct scales {
    double dt, rho_aa, rho_ab; /* rho: times the shares of a vertex, a pair */
    const double *u, *w;
    enum tangent tangent;
};

/* Add the part of point p of triangle e to q and, unless NO_TANGENT, of K; of
 * linear triangles with their mass. */
INLINE enum status add_point(const struct body *body, struct scales scale,
                             int e, int p, int nodes, double q[])
{
    const int *t = &body->vertex[nodes * e];
    const int *place = &body->place[nodes * (nodes + 1) / 2 * e];
    const double *g = gradient_at(body, e, p, nodes);
    const double *u = scale.u, *w = scale.w;
    const double area = scale.dt * scale.dt * body->area[e]; /* dt^2 A */
    const mat2 F = deformation(body, u, e, p, nodes);
    const double J = F.m[0][0] * F.m[1][1] - F.m[0][1] * F.m[1][0];
    if (!material_defined(&body->material, J))
        return isnan(J) ? NONFINITE : INVERTED;
    const struct volume v = material_volume_weighted(&body->material, J, area);
    const struct factors s = {nodes == 3 ? scale.rho_aa * body->area[e] : 0.0,
                              nodes == 3 ? scale.rho_ab * body->area[e] : 0.0,
                              area * body->material.mu, v.dG, v.ddG};
    double c[2 * MOST_NODES], move[2 * MOST_NODES];

#pragma GCC unroll 6
    for (int a = 0; a < nodes; a++) { /* c_a = cof(F) g_a */
        c[2 * a] = F.m[1][1] * g[2 * a] - F.m[1][0] * g[2 * a + 1];
        c[2 * a + 1] = F.m[0][0] * g[2 * a + 1] - F.m[0][1] * g[2 * a];
        for (int i = 0; i < 2; i++)
            move[2 * a + i] = u[2 * t[a] + i] - w[2 * t[a] + i];
    }
#pragma GCC unroll 6
    for (int a = 0; a < nodes; a++)
#pragma GCC unroll 2
        for (int i = 0; i < 2; i++) {
            /* dt^2 A P g_a, P = mu F + G' cof(F) */
            double pull =
                s.mu * (F.m[i][0] * g[2 * a] + F.m[i][1] * g[2 * a + 1]) +
                s.dG * c[2 * a + i];
            /* sum_b M_ab (u_b - w_b), M_ab the same for all b but a */
            if (nodes == 3) {
                pull += s.m_ab * (move[i] + move[2 + i] + move[4 + i]);
                pull += (s.m_aa - s.m_ab) * move[2 * a + i];
            }
            q[2 * t[a] + i] += pull;
        }
    if (scale.tangent == EXACT)
        add_exact(s, nodes, g, c, place, body->K->stride, body->K->a);
    if (scale.tangent == PROJECTED)
        add_projected(s, nodes, g, c, F, place, body->K->stride, body->K->a);
    return OK;
}

/* ... of triangles first .. end - 1, one after the other. */
INLINE enum status assemble(const struct body *body, struct incremental Phi,
                            const double u[], enum tangent tangent, double q[],
                            int first, int end, int nodes)
{
    const double rho = Phi.w ? body->rho : 0.0;
    const struct scales scale = {
        Phi.dt, rho * body_mass_share(body->mass, 1),
        rho * body_mass_share(body->mass, 0), u,
        Phi.w ? Phi.w : u, /* at rest u - w is 0 */
        tangent};
    for (int e = first; e < end; e++)
        for (int p = 0; p < points_of(nodes); p++) {
            const enum status status = add_point(body, scale, e, p, nodes, q);
            if (status != OK) return status;
        }
    return OK;
}

enum status triangles_assemble(const struct body *body, struct incremental Phi,
                               const double u[], enum tangent tangent,
                               double q[])
{
    enum status status = OK;
    if (body->element != LINEAR_TRIANGLE)
        return triangles_one_by_one(body, Phi, u, tangent, q);
    for (int e = 0; status == OK && e < body->n_element;) {
        status = lanes_assemble(body, Phi, u, tangent, q, &e);
        const int end = lanes_end(body, e);
        if (status == OK)
            status = assemble(body, Phi, u, tangent, q, e, end, 3);
        e = end;
    }
    return status;
}

enum status triangles_one_by_one(const struct body *body,
                                 struct incremental Phi, const double u[],
                                 enum tangent tangent, double q[])
{
    return body->element == LINEAR_TRIANGLE
               ? assemble(body, Phi, u, tangent, q, 0, body->n_element, 3)
               : assemble(body, Phi, u, tangent, q, 0, body->n_element, 6);
}
