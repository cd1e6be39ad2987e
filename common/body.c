/* body.c - see body.h. */
#include "body.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number the free unknowns, row by row from right to left; how many. */
static int number_equations(const struct mesh *mesh, const int fixed[],
                            int equation[])
{
    int next = 0;
    for (int j = 0; j <= mesh->n; j++)
        for (int i = mesh->n; i >= 0; i--) {
            const int a = j * (mesh->n + 1) + i;
            for (int k = 0; k < 2; k++)
                equation[2 * a + k] = fixed[a] ? -1 : next++;
        }
    return next;
}

/* The unknowns of triangle e, in the order of its 6x6 matrix. */
static void element_equations(const struct body *body, int e, int number[6])
{
    for (int r = 0; r < 6; r++)
        number[r] =
            body->equation[2 * body->mesh->triangle[3 * e + r / 2] + r % 2];
}

static int half_bandwidth(const struct body *body)
{
    int number[6], p = 0;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        element_equations(body, e, number);
        for (int r = 0; r < 6; r++)
            for (int c = 0; c < 6; c++)
                if (number[c] >= 0 && number[r] - number[c] > p)
                    p = number[r] - number[c];
    }
    return p;
}

static void scatter_map(const struct body *body, int place[])
{
    int number[6];
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        element_equations(body, e, number);
        for (int r = 0; r < 6; r++)
            for (int c = 0; c <= r; c++) {
                const int low = number[r] < number[c] ? number[r] : number[c];
                const int high = number[r] < number[c] ? number[c] : number[r];
                const size_t at =
                    (size_t)low * body->K->stride + (size_t)(high - low);
                assert(low < 0 || at < INT_MAX);
                *place++ = low < 0 ? -1 : (int)at;
            }
    }
}

struct body *body_alloc(const struct mesh *mesh, struct material material,
                        double rho, enum mass mass, const int fixed[])
{
    const size_t triangles = (size_t)mesh->n_triangle;
    struct body *body = allocate(1, sizeof *body);
    assert(material.law != LINEAR && mesh_clockwise(mesh) < 0);
    body->mesh = mesh;
    body->material = material;
    body->rho = rho;
    body->mass = mass;
    body->equation = allocate(2 * (size_t)mesh->n_vertex, sizeof(int));
    body->n_equation = number_equations(mesh, fixed, body->equation);
    body->area = allocate(triangles, sizeof(double));
    body->gradient = allocate(6 * triangles, sizeof(double));
    for (int e = 0; e < mesh->n_triangle; e++)
        body->area[e] = mesh_gradients(mesh, e, &body->gradient[6 * e]);
    body->K = matrix_alloc(BANDED, body->n_equation, half_bandwidth(body));
    body->place = allocate(21 * triangles, sizeof(int));
    scatter_map(body, body->place);
    return body;
}

void body_free(struct body *body)
{
    if (!body) return;
    free(body->equation);
    free(body->area);
    free(body->gradient);
    free(body->place);
    matrix_free(body->K);
    free(body);
}

/* F = I + sum_a u_a (x) grad N_a of triangle e. */
static inline mat2 deformation(const struct body *body, const double u[], int e)
{
    const int *t = &body->mesh->triangle[3 * e];
    const double *g = &body->gradient[6 * e];
    mat2 F = {{{1.0, 0.0}, {0.0, 1.0}}};
#pragma GCC unroll 3
    for (int a = 0; a < 3; a++)
#pragma GCC unroll 2
        for (int i = 0; i < 2; i++)
#pragma GCC unroll 2
            for (int k = 0; k < 2; k++)
                F.m[i][k] += u[2 * t[a] + i] * g[2 * a + k];
    return F;
}

/* The area of triangle e in which the mass of vertices a and b counts:
 * int N_a N_b, or its row sums. */
static inline double shared_area(const struct body *body, int e, int a, int b)
{
    if (body->mass == LUMPED) return a == b ? body->area[e] / 3.0 : 0.0;
    return body->area[e] / (a == b ? 6.0 : 12.0);
}

enum status body_energy(const struct body *body, const double u[],
                        double *energy)
{
    *energy = 0.0;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const mat2 F = deformation(body, u, e);
        const double J = mat2_det(F);
        if (!material_defined(&body->material, J))
            return isnan(J) ? NONFINITE : INVERTED;
        *energy += body->area[e] * material2_psi(&body->material, F);
    }
    return isfinite(*energy) ? OK : NONFINITE;
}

void body_mass(const struct body *body, const double v[], double out[])
{
    memset(out, 0, 2 * (size_t)body->mesh->n_vertex * sizeof *out);
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->mesh->triangle[3 * e];
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                for (int i = 0; i < 2; i++)
                    out[2 * t[a] + i] += body->rho *
                                         shared_area(body, e, a, b) *
                                         v[2 * t[b] + i];
    }
}

double body_min_J(const struct body *body, const double u[])
{
    double least = INFINITY;
    for (int e = 0; e < body->mesh->n_triangle; e++)
        least = fmin(least, mat2_det(deformation(body, u, e)));
    return least;
}

/*
 * The loops over an element's few vertices and components are unrolled: which
 * vertex and which component is then known to the compiler, and what an
 * element computes stays in registers.
 */

/* K := area (mu g_a.g_b I + G'' c_a c_b^T + G' (g_a x g_b) (0 1; -1 0)), the
 * lower triangle of the 6x6 matrix by rows [eq:element-tangent]. */
static inline void exact_tangent(double area, double mu, double dG, double ddG,
                                 const double g[6], const double c[6],
                                 double K[21])
{
    int k = 0;
#pragma GCC unroll 6
    for (int r = 0; r < 6; r++)
#pragma GCC unroll 6
        for (int s = 0; s <= r; s++) {
            const int a = r / 2 * 2, b = s / 2 * 2;
            const double same = mu * (g[a] * g[b] + g[a + 1] * g[b + 1]);
            const double cross = dG * (g[a] * g[b + 1] - g[a + 1] * g[b]);
            K[k++] = area * (ddG * c[r] * c[s] + (r % 2 == s % 2 ? same
                                                  : r % 2 == 0   ? cross
                                                                 : -cross));
        }
}

/*
 * The same with the negative eigenvalues of dP/dF clamped to 0.
 *
 * With F = R(x) diag(s1, s2) R(y)^T, dP/dF has the eigenvectors
 * R(x) E R(y)^T and eigenvalues [eq:projection]
 *
 *     E = (0 -1; 1 0)/sqrt 2   mu + G'         E = (0 1; 1 0)/sqrt 2   mu - G'
 *     E = diag(cos z, sin z)   those of ( mu + G'' s2^2   G'' J + G'   )
 *                                       ( G'' J + G'      mu + G'' s1^2 )
 *
 * Source: Irving, Teran & Fedkiw, Graph. Models 68 (2006), sec. 3 (the idea);
 * Smith, de Goes & Kim, ACM Trans. Graph. 38 (2019), sec. 4 (closed forms).
 */
static void projected_tangent(double area, double mu, double dG, double ddG,
                              const double g[6], mat2 F, double K[21])
{
    const double half_sum = hypot(F.m[0][0] + F.m[1][1],
                                  F.m[1][0] - F.m[0][1]) / 2.0;
    const double half_difference = hypot(F.m[0][0] - F.m[1][1],
                                         F.m[1][0] + F.m[0][1]) / 2.0;
    const double turn = atan2(F.m[1][0] - F.m[0][1], F.m[0][0] + F.m[1][1]);
    const double axes = atan2(F.m[1][0] + F.m[0][1], F.m[0][0] - F.m[1][1]);
    const mat2 U = mat2_rotation((axes + turn) / 2.0);
    const mat2 V = mat2_rotation((axes - turn) / 2.0);
    const double s1 = half_sum + half_difference;
    const double s2 = half_sum - half_difference;
    const double A = mu + ddG * s2 * s2, C = mu + ddG * s1 * s1;
    const double B = ddG * s1 * s2 + dG;
    const double z = 0.5 * atan2(2.0 * B, A - C);
    const double root = hypot((A - C) / 2.0, B);
    const double value[4] = {mu + dG, mu - dG, (A + C) / 2.0 + root,
                             (A + C) / 2.0 - root};
    const mat2 E[4] = {{{{0.0, -M_SQRT1_2}, {M_SQRT1_2, 0.0}}},
                       {{{0.0, M_SQRT1_2}, {M_SQRT1_2, 0.0}}},
                       {{{cos(z), 0.0}, {0.0, sin(z)}}},
                       {{{-sin(z), 0.0}, {0.0, cos(z)}}}};

    memset(K, 0, 21 * sizeof *K);
    for (int m = 0; m < 4; m++) {
        const mat2 D =
            mat2_multiply(U, mat2_multiply(E[m], mat2_transpose(V)));
        double d[6]; /* the derivative of (F in direction D) by u */
        if (!(value[m] > 0.0)) continue;
        for (int r = 0; r < 6; r++)
            d[r] = D.m[r % 2][0] * g[r / 2 * 2] +
                   D.m[r % 2][1] * g[r / 2 * 2 + 1];
        for (int r = 0, k = 0; r < 6; r++)
            for (int s = 0; s <= r; s++)
                K[k++] += area * value[m] * d[r] * d[s];
    }
}

/* The element's matrix K and its mass into the entries of the whole. */
static inline void scatter(const int place[21], const double K[21], double m_aa,
                           double m_ab, double entries[])
{
    int k = 0;
#pragma GCC unroll 6
    for (int r = 0; r < 6; r++)
#pragma GCC unroll 6
        for (int s = 0; s <= r; s++, k++)
            if (place[k] >= 0)
                entries[place[k]] += K[k] + (r == s           ? m_aa
                                             : r % 2 == s % 2 ? m_ab
                                                              : 0.0);
}

enum status body_assemble(struct body *body, double dt, const double w[],
                          const double f[], const double u[],
                          enum tangent tangent, double q[])
{
    const double mu = body->material.mu, lambda = body->material.lambda;
    const int n_dof = 2 * body->mesh->n_vertex;
    double *entries = body->K->a;

    if (tangent != NO_TANGENT) matrix_zero(body->K);
    for (int r = 0; r < n_dof; r++) q[r] = f ? -dt * dt * f[r] : 0.0;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->mesh->triangle[3 * e];
        const double *g = &body->gradient[6 * e];
        const double area = dt * dt * body->area[e];
        const double m_ab = body->rho * shared_area(body, e, 0, 1);
        const double m_aa = body->rho * shared_area(body, e, 0, 0);
        const mat2 F = deformation(body, u, e);
        const double J = mat2_det(F);
        if (!material_defined(&body->material, J))
            return isnan(J) ? NONFINITE : INVERTED;
        const struct volumetric v = material_r(&body->material, J);
        const double dG = (lambda * v.r - mu) * v.dr;
        const double ddG = lambda * v.dr * v.dr + (lambda * v.r - mu) * v.ddr;
        double c[6], K[21], move[6];

#pragma GCC unroll 6
        for (int r = 0; r < 6; r++)
            move[r] = u[2 * t[r / 2] + r % 2] - w[2 * t[r / 2] + r % 2];
#pragma GCC unroll 6
        for (int r = 0; r < 6; r++) {
            const int a = r / 2 * 2, i = r % 2;
            const double sign = i == 0 ? 1.0 : -1.0; /* c_a = cof(F) g_a */
            c[r] = sign * (F.m[1 - i][1] * g[a] - F.m[1 - i][0] * g[a + 1]);
            q[2 * t[r / 2] + i] +=
                area * (mu * (F.m[i][0] * g[a] + F.m[i][1] * g[a + 1]) +
                        dG * c[r]) +
                m_ab * (move[i] + move[2 + i] + move[4 + i]) +
                (m_aa - m_ab) * move[r];
        }
        if (tangent == EXACT) {
            exact_tangent(area, mu, dG, ddG, g, c, K);
            scatter(&body->place[21 * e], K, m_aa, m_ab, entries);
        } else if (tangent == PROJECTED) {
            projected_tangent(area, mu, dG, ddG, g, F, K);
            scatter(&body->place[21 * e], K, m_aa, m_ab, entries);
        }
    }
    for (int r = 0; r < n_dof; r++)
        if (!isfinite(q[r])) return NONFINITE;
    return OK;
}
