/* lanes.c - see lanes.h. */
#include "plane/lanes.h"

#include "linear/vec.h"

#include <assert.h>
#include <math.h>

/* The numbers of V triangles: their six gradients, and their areas. */
enum { GRADIENTS = 6, KEPT = GRADIENTS + 1, BLOCKS = 6 };

double *lanes_alloc(const struct body *body)
{
    const int groups = body->n_element / V;
    double *lanes = allocate((size_t)(groups * KEPT * V) + 1, sizeof *lanes);
    for (int group = 0; group < groups; group++)
        for (int l = 0; l < V; l++) {
            const int e = group * V + l;
            double *target = &lanes[group * KEPT * V + l];
            for (int k = 0; k < GRADIENTS; k++)
                target[k * V] = body->gradient[GRADIENTS * e + k];
            target[GRADIENTS * V] = body->area[e];
        }
    return lanes;
}

int lanes_end(const struct body *body, int e)
{
    const int end = (e / V + 1) * V;
    return end < body->n_element ? end : body->n_element;
}

/* The factors of a step, equal in all triangles. */
struct scales {
    double dt2, rho_aa, rho_ab; /* rho: times the shares of a vertex, a pair */
};

/* Of V triangles: F and J; c_a = cof(F) g_a; m_aa, m_ab, mu, G', G'' times what
 * triangles.c multiplies them by. */
struct points {
    vec F[2][2], J, c[GRADIENTS], m_aa, m_ab, mu, dG, ddG;
};

/* Return the numbers of V vertices, component i of vertex a of each triangle.
 * Indices have the width of an address: an int would be widened. */
INLINE vec lanes_of(const double u[], const int vertex[], int a, int i)
{
#define LANE(l) u[2 * (ptrdiff_t)vertex[3 * (l) + a] + i]
#if VEC_WIDTH == 8
    return (vec){LANE(0), LANE(1), LANE(2), LANE(3),
                 LANE(4), LANE(5), LANE(6), LANE(7)};
#elif VEC_WIDTH == 4
    return (vec){LANE(0), LANE(1), LANE(2), LANE(3)};
#else
    return (vec){LANE(0), LANE(1)};
#endif
}

/* Set F and J at u; return as triangles.c where the material is not defined. */
INLINE enum status deform(const struct body *body, const vec g[KEPT],
                          const vec u[GRADIENTS], struct points *pt)
{
    const vec zero = {0.0};
    UNROLL for (int i = 0; i < 2; i++)
        UNROLL for (int j = 0; j < 2; j++) {
            pt->F[i][j] = zero + (i == j ? 1.0 : 0.0);
            UNROLL for (int a = 0; a < 3; a++)
                pt->F[i][j] += u[2 * a + i] * g[2 * a + j];
        }
    pt->J = pt->F[0][0] * pt->F[1][1] - pt->F[0][1] * pt->F[1][0];
    for (int l = 0; l < V; l++)
        if (!material_defined(&body->material, pt->J[l]))
            return isnan(pt->J[l]) ? NONFINITE : INVERTED;
    return OK;
}

/* Set G' and G'' of material_volume_weighted() in all lanes. */
INLINE void volume(const struct material *material, vec weight,
                   struct points *pt)
{
    if (material->law == CUBIC) {
        /* G = lambda r^2 / 2 - mu r, r = s - s^2/2 + s^3/3 for log J */
        const vec s = pt->J - 1.0;
        const vec r = s * (1.0 - s * (0.5 - s * (1.0 / 3.0)));
        const vec dr = 1.0 - s + s * s, ddr = -1.0 + 2.0 * s;
        const vec pull = material->lambda * r - material->mu;
        pt->dG = weight * pull * dr; /* G' = (lambda r - mu) r' */
        pt->ddG = weight * (material->lambda * dr * dr + pull * ddr);
        return;
    }
    vec dG = {0.0}, ddG = {0.0};
    for (int l = 0; l < V; l++) {
        const struct volume v =
            material_volume_weighted(material, pt->J[l], weight[l]);
        dG[l] = v.dG;
        ddG[l] = v.ddG;
    }
    pt->dG = dG;
    pt->ddG = ddG;
}

/* The rest of the points of V triangles. */
INLINE void find_points(const struct body *body, struct scales scale,
                        const vec g[KEPT], struct points *pt)
{
    const vec area = scale.dt2 * g[GRADIENTS]; /* dt^2 A */
    UNROLL for (int a = 0; a < 3; a++) {
        pt->c[2 * a] = pt->F[1][1] * g[2 * a] - pt->F[1][0] * g[2 * a + 1];
        pt->c[2 * a + 1] = pt->F[0][0] * g[2 * a + 1] - pt->F[0][1] * g[2 * a];
    }
    pt->m_aa = scale.rho_aa * g[GRADIENTS];
    pt->m_ab = scale.rho_ab * g[GRADIENTS];
    pt->mu = area * body->material.mu;
    volume(&body->material, area, pt);
}

/* Add to q what V triangles pull at their vertices. */
INLINE void add_forces(const struct points *pt, const vec g[KEPT],
                       const vec move[GRADIENTS], const int vertex[],
                       double q[])
{
    double pull[GRADIENTS][V];
    UNROLL for (int a = 0; a < 3; a++)
        UNROLL for (int i = 0; i < 2; i++) {
            /* dt^2 A P g_a, P = mu F + G' cof(F); sum_b M_ab (u_b - w_b) */
            vec sum = pt->mu * (pt->F[i][0] * g[2 * a] +
                                pt->F[i][1] * g[2 * a + 1]) +
                      pt->dG * pt->c[2 * a + i];
            sum += pt->m_ab * (move[i] + move[2 + i] + move[4 + i]);
            sum += (pt->m_aa - pt->m_ab) * move[2 * a + i];
            VEC(pull[2 * a + i]) = sum;
        }
    for (int l = 0; l < V; l++)
        for (int a = 0; a < 3; a++)
            TWO(q[2 * (ptrdiff_t)vertex[3 * l + a]]) +=
                (two){pull[2 * a][l], pull[2 * a + 1][l]};
}

/* Add to K the blocks (a, b), a >= b, of V triangles [eq:element-tangent]. */
INLINE void add_blocks(const struct points *pt, const vec g[KEPT],
                       const int place[], size_t stride, double entries[])
{
    double block[BLOCKS][4][V]; /* entries 00, 10, 01, 11 */
    int k = 0;
    UNROLL for (int a = 0; a < 3; a++)
        UNROLL for (int b = 0; b <= a; b++, k++) {
            const vec *g_a = &g[2 * a], *g_b = &g[2 * b];
            const vec *c_a = &pt->c[2 * a], *c_b = &pt->c[2 * b];
            const vec same = (a == b ? pt->m_aa : pt->m_ab) +
                             pt->mu * (g_a[0] * g_b[0] + g_a[1] * g_b[1]);
            const vec cross = pt->dG * (g_a[0] * g_b[1] - g_a[1] * g_b[0]);
            const vec c0 = pt->ddG * c_a[0], c1 = pt->ddG * c_a[1];
            VEC(block[k][0]) = same + c0 * c_b[0];
            VEC(block[k][1]) = c1 * c_b[0] - cross;
            VEC(block[k][2]) = c0 * c_b[1] + cross;
            VEC(block[k][3]) = same + c1 * c_b[1];
        }
    for (int l = 0; l < V; l++, place += BLOCKS) {
        k = 0;
        UNROLL for (int a = 0; a < 3; a++)
            UNROLL for (int b = 0; b <= a; b++, k++) {
                if (place[k] < 0) continue;
                double *column = &entries[place[k]];
                double *next = column + stride - 1;
                TWO(column[0]) += (two){block[k][0][l], block[k][1][l]};
                if (a == b)
                    next[1] += block[k][3][l];
                else
                    TWO(next[0]) += (two){block[k][2][l], block[k][3][l]};
            }
    }
}

/* Return whether no eigenvalue is negative [eq:projection]. */
INLINE int is_convex(const struct points *pt)
{
    for (int l = 0; l < V; l++)
        if (!(fabs(pt->dG[l]) <= pt->mu[l] && pt->ddG[l] >= 0.0)) return 0;
    return 1;
}

/* The gradients and areas of the V triangles from e on. */
INLINE void geometry(const struct body *body, int e, vec g[KEPT])
{
    UNROLL for (int i = 0; i < KEPT; i++)
        g[i] = VEC(body->lanes[e * KEPT + i * V]);
}

INLINE enum status assemble(const enum tangent tangent, const struct body *body,
                            struct scales scale, const double u[],
                            const double w[], double q[], int *next)
{
    for (; *next + V <= body->n_element; *next += V) {
        const int *vertex = &body->vertex[3 * *next];
        vec g[KEPT], u_of[GRADIENTS], move[GRADIENTS];
        struct points pt;
        UNROLL for (int a = 0; a < 3; a++)
            UNROLL for (int i = 0; i < 2; i++) {
                u_of[2 * a + i] = lanes_of(u, vertex, a, i);
                move[2 * a + i] = u_of[2 * a + i] - lanes_of(w, vertex, a, i);
            }
        geometry(body, *next, g);
        const enum status status = deform(body, g, u_of, &pt);
        if (status != OK) return status;
        find_points(body, scale, g, &pt);
        if (tangent == PROJECTED && !is_convex(&pt)) return OK;
        add_forces(&pt, g, move, vertex, q);
        if (tangent != NO_TANGENT)
            add_blocks(&pt, g, &body->place[BLOCKS * *next], body->K->stride,
                       body->K->a);
    }
    return OK;
}

enum status lanes_assemble(const struct body *body, struct incremental Phi,
                           const double u[], enum tangent tangent, double q[],
                           int *next)
{
    const double rho = Phi.w ? body->rho : 0.0;
    const struct scales scale = {Phi.dt * Phi.dt,
                              rho * body_mass_share(body->mass, 1),
                              rho * body_mass_share(body->mass, 0)};
    const double *w = Phi.w ? Phi.w : u; /* at rest u - w is 0 */
    assert(body->element == LINEAR_TRIANGLE && *next % V == 0);
    if (tangent == NO_TANGENT)
        return assemble(NO_TANGENT, body, scale, u, w, q, next);
    return assemble(tangent, body, scale, u, w, q, next);
}

/* Return psi of the cubic law in all lanes, as material2_psi() computes it. */
INLINE vec cubic_psi(const struct material *material, const struct points *pt)
{
    const double mu = material->mu, lambda = material->lambda;
    /* H = F - I; s = J - 1 = tr H + det H */
    const vec H00 = pt->F[0][0] - 1.0, H11 = pt->F[1][1] - 1.0;
    const vec H01 = pt->F[0][1], H10 = pt->F[1][0];
    const vec det = H00 * H11 - H01 * H10, s = H00 + H11 + det;
    const vec dot = H00 * H00 + H01 * H01 + H10 * H10 + H11 * H11;
    vec J = 1.0 + s;
    for (int l = 0; l < V; l++)
        if (s[l] < -0.5) J[l] = pt->J[l];
    const vec t = J - 1.0;
    const vec r = t * (1.0 - t * (0.5 - t * (1.0 / 3.0)));
    /* mu (|F|^2 / 2 - 1 - r), |F|^2 / 2 - 1 = |H|^2 / 2 + s - det H */
    return 0.5 * mu * dot - mu * det + mu * (s * s / 2.0 - s * s * s / 3.0) +
           0.5 * lambda * r * r;
}

enum status lanes_energy(const struct body *body, const double u[],
                         double *energy, int *next)
{
    assert(body->element == LINEAR_TRIANGLE && *next % V == 0);
    if (body->material.law != CUBIC) return OK;
    for (; *next + V <= body->n_element; *next += V) {
        const int *vertex = &body->vertex[3 * *next];
        vec g[KEPT], u_of[GRADIENTS];
        struct points pt;
        UNROLL for (int a = 0; a < 3; a++)
            UNROLL for (int i = 0; i < 2; i++)
                u_of[2 * a + i] = lanes_of(u, vertex, a, i);
        geometry(body, *next, g);
        const enum status status = deform(body, g, u_of, &pt);
        if (status != OK) return status;
        const vec part = g[GRADIENTS] * cubic_psi(&body->material, &pt);
        for (int l = 0; l < V; l++) *energy += part[l];
    }
    return OK;
}
