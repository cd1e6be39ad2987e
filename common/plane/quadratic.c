/* quadratic.c - see quadratic.h. */
#include "plane/quadratic.h"

#include "linear/sparse.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 6, POINTS = 3, BLOCKS = NODES * (NODES + 1) / 2 };

/* The points of the rule: barycentric coordinates [eq:three-points]. */
static const double point[POINTS][3] = {{2.0 / 3, 1.0 / 6, 1.0 / 6},
                                        {1.0 / 6, 2.0 / 3, 1.0 / 6},
                                        {1.0 / 6, 1.0 / 6, 2.0 / 3}};

void quadratic_shape(const double l[3], const double of_l[6], double N[6],
                     double gradient[12])
{
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        N[a] = l[a] * (2.0 * l[a] - 1.0);
        N[3 + a] = 4.0 * l[b] * l[c];
        for (int j = 0; j < 2; j++) {
            gradient[2 * a + j] = (4.0 * l[a] - 1.0) * of_l[2 * a + j];
            gradient[2 * (3 + a) + j] =
                4.0 * (l[b] * of_l[2 * c + j] + l[c] * of_l[2 * b + j]);
        }
    }
}

void quadratic_nodes(const struct mesh *mesh, int e, int node[NODES])
{
    const int row = mesh->n + 1, across = mesh->n / 2;
    const int low = e / 2 / across * 2 * row + e / 2 % across * 2;
    const int below[NODES] = {0, 2, 2 * row + 2, row + 2, row + 1, 1};
    const int above[NODES] = {0, 2 * row + 2, 2 * row, 2 * row + 1, row,
                              row + 1};
    for (int a = 0; a < NODES; a++)
        node[a] = low + (e % 2 ? above : below)[a];
}

void quadratic_straighten(struct mesh *mesh)
{
    for (int e = 0; e < mesh->n * mesh->rows / 2; e++) {
        int node[NODES];
        quadratic_nodes(mesh, e, node);
        for (int a = 0; a < 3; a++)
            for (int j = 0; j < 2; j++)
                mesh->X[2 * node[3 + a] + j] =
                    0.5 * (mesh->X[2 * node[(a + 1) % 3] + j] +
                           mesh->X[2 * node[(a + 2) % 3] + j]);
    }
}

/* The gradients of l of a triangle and its area, which is > 0; the edges are
 * straight to round-off, and the nodes in their middles. */
static double corner_gradients(const struct mesh *mesh, const int node[NODES],
                               double of_l[6])
{
    const double area = mesh_gradients_of(mesh, node, of_l);
    assert(area > 0.0);
    for (int a = 0; a < 3; a++)
        for (int j = 0; j < 2; j++)
            assert(fabs(mesh->X[2 * node[3 + a] + j] -
                        0.5 * (mesh->X[2 * node[(a + 1) % 3] + j] +
                               mesh->X[2 * node[(a + 2) % 3] + j])) <=
                   1e-9 * sqrt(area));
    return area;
}

/* Number the free unknowns, along the lines of the shorter side, or as the
 * pattern has it. */
static int number_equations(struct quadratic *body, const int held[])
{
    const int n = body->mesh->n, rows = body->mesh->rows, by_rows = n <= rows;
    int next = 0;
    for (int line = 0; line <= (by_rows ? rows : n); line++)
        for (int k = 0; k <= (by_rows ? n : rows); k++) {
            const int a = by_rows ? line * (n + 1) + k : k * (n + 1) + line;
            for (int i = 0; i < 2; i++) {
                int *r = &body->equation[2 * a + i];
                *r = held[a] ? -1 : next++;
                if (!held[a] && body->pattern)
                    *r = 2 * body->pattern->place[a] + i;
            }
        }
    return next;
}

/* Nodes, weight, gradients, mass of triangle e.  By insertion the nodes get the
 * order of their equations, and block (a, b), a >= b, is below the diagonal. */
static void make_element(struct quadratic *body, int e, double rho)
{
    int node[NODES], order[NODES], *sorted = &body->node[NODES * e];
    double of_l[6], N[NODES], gradient[2 * NODES];
    quadratic_nodes(body->mesh, e, node);
    const double area = corner_gradients(body->mesh, node, of_l);
    body->weight[e] = area / POINTS;
    for (int a = 0; a < NODES; a++) {
        const int equation = body->equation[2 * node[a]];
        int k = a;
        for (; k > 0; k--) {
            if (body->equation[2 * node[order[k - 1]]] <= equation) break;
            order[k] = order[k - 1];
        }
        order[k] = a;
        body->mass[node[a]] += rho * area * (a < 3 ? 3.0 : 16.0) / 57.0;
    }
    for (int k = 0; k < NODES; k++) sorted[k] = node[order[k]];
    for (int p = 0; p < POINTS; p++) {
        quadratic_shape(point[p], of_l, N, gradient);
        for (int k = 0; k < NODES; k++)
            memcpy(&body->gradient[36 * e + 12 * p + 2 * k],
                   &gradient[2 * order[k]], 2 * sizeof *gradient);
    }
}

/* Each two nodes of a triangle are neighbours: so does a list of linear
 * triangles say that has each pair of the six in it. */
static struct sparse *find_pattern(const struct quadratic *body,
                                   const int held[])
{
    static const int triple[][3] = {{0, 1, 2}, {0, 3, 4}, {0, 5, 3},
                                    {1, 3, 4}, {1, 5, 4}, {2, 3, 4},
                                    {2, 5, 3}};
    const int n_triple = (int)(sizeof triple / sizeof *triple);
    const struct mesh *mesh = body->mesh;
    const int n_list = n_triple * body->n_element;
    int *list = allocate(3 * (size_t)n_list, sizeof *list), *next = list;
    for (int e = 0; e < body->n_element; e++) {
        int node[NODES];
        quadratic_nodes(mesh, e, node);
        for (int k = 0; k < n_triple; k++)
            for (int c = 0; c < 3; c++) *next++ = node[triple[k][c]];
    }
    struct sparse *pattern = sparse_alloc(mesh->n + 1, mesh->rows + 1, n_list,
                                          list, held, SPARSE_LEAF);
    free(list);
    return pattern;
}

struct quadratic *quadratic_alloc(const struct mesh *mesh,
                                  struct material material, double rho,
                                  const int held[], enum storage storage)
{
    struct quadratic *body = allocate(1, sizeof *body);
    assert(material.law != LINEAR && (storage == BANDED || storage == SPARSE));
    assert(mesh->n % 2 == 0 && mesh->rows % 2 == 0);
    *body = (struct quadratic){.mesh = mesh, .material = material,
                               .n_element = mesh->n * mesh->rows / 2};
    const size_t elements = (size_t)body->n_element;
    body->node = allocate(NODES * elements, sizeof(int));
    body->weight = allocate(elements, sizeof(double));
    body->gradient = allocate(36 * elements, sizeof(double));
    body->mass = allocate((size_t)mesh->n_vertex, sizeof(double));
    body->equation = allocate(2 * (size_t)mesh->n_vertex, sizeof(int));
    body->place = allocate(BLOCKS * elements, sizeof(int));
    if (storage == SPARSE) body->pattern = find_pattern(body, held);
    body->n_equation = number_equations(body, held);

    int widest = 0;
    for (int e = 0; e < body->n_element; e++) {
        make_element(body, e, rho);
        const int *node = &body->node[NODES * e];
        const int last = body->equation[2 * node[NODES - 1]];
        for (int a = 0; a < NODES; a++) {
            const int first = body->equation[2 * node[a]];
            if (first >= 0 && last - first > widest) widest = last - first;
        }
    }
    body->K = body->pattern ? matrix_alloc_sparse(body->pattern)
                            : matrix_alloc(BANDED, body->n_equation,
                                           widest + 1);
    int *place = body->place;
    for (int e = 0; e < body->n_element; e++)
        for (int a = 0; a < NODES; a++)
            for (int b = 0; b <= a; b++) {
                const int *node = &body->node[NODES * e];
                const int row = body->equation[2 * node[a]];
                const int column = body->equation[2 * node[b]];
                *place++ =
                    column < 0 ? -1 : matrix_place(body->K, row, column);
            }
    return body;
}

void quadratic_free(struct quadratic *body)
{
    if (!body) return;
    free(body->node);
    free(body->weight);
    free(body->gradient);
    free(body->mass);
    free(body->equation);
    free(body->place);
    matrix_free(body->K);
    sparse_free(body->pattern);
    free(body);
}

void quadratic_load(const struct quadratic *body, const double density[2],
                    double f[])
{
    for (int e = 0; e < body->n_element; e++) {
        int node[NODES];
        quadratic_nodes(body->mesh, e, node);
        for (int a = 3; a < NODES; a++)
            for (int i = 0; i < 2; i++)
                f[2 * node[a] + i] += body->weight[e] * density[i];
    }
}

/* F at point p of triangle e, whose gradients are g. */
static mat2 deformation(const struct quadratic *body, const double u[], int e,
                        const double g[2 * NODES])
{
    mat2 F = mat2_identity();
    for (int a = 0; a < NODES; a++)
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++)
                F.m[i][j] += u[2 * body->node[NODES * e + a] + i] *
                             g[2 * a + j];
    return F;
}

enum status quadratic_energy(const struct quadratic *body, const double u[],
                             double *energy)
{
    *energy = 0.0;
    for (int e = 0; e < body->n_element; e++)
        for (int p = 0; p < POINTS; p++) {
            const double *g = &body->gradient[36 * e + 12 * p];
            const mat2 F = deformation(body, u, e, g);
            const double J = mat2_det(F);
            if (!material_defined(&body->material, J))
                return isnan(J) ? NONFINITE : INVERTED;
            *energy += body->weight[e] * material2_psi(&body->material, F);
        }
    return isfinite(*energy) ? OK : NONFINITE;
}

double quadratic_min_J(const struct quadratic *body, const double u[])
{
    double least = INFINITY;
    for (int e = 0; e < body->n_element; e++)
        for (int p = 0; p < POINTS; p++)
            least = fmin(least, mat2_det(deformation(
                body, u, e, &body->gradient[36 * e + 12 * p])));
    return least;
}

/* Add what a point gives to the blocks (a, b), a >= b [eq:element-tangent]; mu
 * and v have the point's weight. */
static void add_blocks(double mu, struct volume v, const double g[2 * NODES],
                       const double c[2 * NODES], const int place[BLOCKS],
                       size_t stride, double entries[])
{
    for (int a = 0; a < NODES; a++)
        for (int b = 0; b <= a; b++, place++) {
            if (*place < 0) continue;
            const double *g_a = &g[2 * a], *g_b = &g[2 * b];
            const double *c_a = &c[2 * a], *c_b = &c[2 * b];
            const double same = mu * (g_a[0] * g_b[0] + g_a[1] * g_b[1]);
            const double cross = v.dG * (g_a[0] * g_b[1] - g_a[1] * g_b[0]);
            double *column = &entries[*place], *next = column + stride - 1;
            column[0] += same + v.ddG * c_a[0] * c_b[0];
            column[1] += v.ddG * c_a[1] * c_b[0] - cross;
            if (a != b) next[0] += v.ddG * c_a[0] * c_b[1] + cross;
            next[1] += same + v.ddG * c_a[1] * c_b[1];
        }
}

enum status quadratic_assemble(struct quadratic *body, struct incremental Phi,
                               const double u[], enum tangent tangent,
                               double q[])
{
    const struct mesh *mesh = body->mesh;
    const double dt = Phi.dt;
    assert(tangent != PROJECTED);
    if (tangent == EXACT) matrix_zero(body->K);
    for (int r = 0; r < 2 * mesh->n_vertex; r++) {
        const double mass = Phi.w ? body->mass[r / 2] : 0.0;
        const int k = body->equation[r];
        q[r] = Phi.w ? mass * (u[r] - Phi.w[r]) : 0.0;
        if (Phi.f) q[r] -= dt * dt * Phi.f[r];
        if (tangent == EXACT && k >= 0) matrix_add(body->K, k, k, mass);
    }
    for (int e = 0; e < body->n_element; e++)
        for (int p = 0; p < POINTS; p++) {
            const double *g = &body->gradient[36 * e + 12 * p];
            const double weight = dt * dt * body->weight[e];
            const double mu = weight * body->material.mu;
            const mat2 F = deformation(body, u, e, g), cof = mat2_cofactor(F);
            const double J = mat2_det(F);
            if (!material_defined(&body->material, J))
                return isnan(J) ? NONFINITE : INVERTED;
            const struct volume v =
                material_volume_weighted(&body->material, J, weight);
            double c[2 * NODES]; /* c_a = cof(F) g_a [eq:element-force] */
            for (int a = 0; a < NODES; a++)
                for (int i = 0; i < 2; i++) {
                    const double x = g[2 * a], y = g[2 * a + 1];
                    c[2 * a + i] = cof.m[i][0] * x + cof.m[i][1] * y;
                    q[2 * body->node[NODES * e + a] + i] +=
                        mu * (F.m[i][0] * x + F.m[i][1] * y) +
                        v.dG * c[2 * a + i];
                }
            if (tangent == EXACT)
                add_blocks(mu, v, g, c, &body->place[BLOCKS * e],
                           body->K->stride, body->K->a);
        }
    for (int r = 0; r < 2 * mesh->n_vertex; r++)
        if (!isfinite(q[r])) return NONFINITE;
    return OK;
}

enum status quadratic_increment(struct quadratic *body, const double q[],
                                double du[])
{
    const enum status status = matrix_factor(body->K);
    if (status != OK) return status;
    double *d = allocate((size_t)body->n_equation, sizeof *d);
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        if (body->equation[r] >= 0) d[body->equation[r]] = -q[r];
    matrix_solve(body->K, d);
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        du[r] = body->equation[r] >= 0 ? d[body->equation[r]] : 0.0;
    free(d);
    return OK;
}
