/* body.c - see body.h. */
#include "plane/body.h"

#include "material/modes.h"
#include "linear/sparse.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number the unknowns that have a number, as the pattern has it, or row by row
 * from right to left, or in columns from the top down where these are shorter;
 * how many. */
static int number_equations(const struct body *body)
{
    const int n = body->mesh->n, rows = body->mesh->rows, by_rows = n <= rows;
    int next = 0;
    for (int line = 0; line <= (by_rows ? rows : n); line++)
        for (int k = by_rows ? n : rows; k >= 0; k--) {
            const int a = by_rows ? line * (n + 1) + k : k * (n + 1) + line;
            for (int i = 0; i < 2; i++) {
                int *r = &body->equation[2 * a + i];
                if (*r < 0) continue;
                *r = body->pattern ? 2 * body->pattern->place[a] + i : next;
                next++;
            }
        }
    return next;
}

/* The vertices of triangle e in the order of their equations, so that block
 * (a, b) of its matrix, a >= b, belongs to the lower triangle of K; with them
 * the gradients. */
static void sort_vertices(struct body *body, int e)
{
    int *vertex = &body->vertex[3 * e];
    double *gradient = &body->gradient[6 * e];
    memcpy(vertex, &body->mesh->triangle[3 * e], 3 * sizeof *vertex);
    body->area[e] = mesh_gradients(body->mesh, e, gradient);
    for (int k = 0; k < 3; k++) { /* compare 0 1, 1 2, 0 1 */
        int *pair = &vertex[k % 2];
        double *g = &gradient[k % 2 * 2];
        if (body->equation[2 * pair[0]] > body->equation[2 * pair[1]]) {
            const int first = pair[0];
            const double x = g[0], y = g[1];
            pair[0] = pair[1], pair[1] = first;
            g[0] = g[2], g[1] = g[3], g[2] = x, g[3] = y;
        }
    }
}

static int half_bandwidth(const struct body *body)
{
    int widest = 0;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->vertex[3 * e];
        for (int a = 0; a < 2; a++) { /* the last vertex and a free one */
            const int low = body->equation[2 * t[a]];
            const int apart = body->equation[2 * t[2]] - low;
            if (low >= 0 && apart > widest) widest = apart;
        }
    }
    return widest + 1; /* component 1 of the one, 0 of the other */
}

static void scatter_map(const struct body *body, int place[])
{
    for (int e = 0; e < body->mesh->n_triangle; e++)
        for (int a = 0; a < 3; a++)
            for (int b = 0; b <= a; b++) {
                const int row = body->equation[2 * body->vertex[3 * e + a]];
                const int column = body->equation[2 * body->vertex[3 * e + b]];
                *place++ =
                    column < 0 ? -1 : matrix_place(body->K, row, column);
            }
}

void body_store(struct body *body, enum storage storage)
{
    const struct mesh *mesh = body->mesh;
    assert(storage != DENSE);
    matrix_free(body->K);
    sparse_free(body->pattern);
    body->pattern = NULL;
    if (storage == SPARSE) {
        int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
        for (int a = 0; a < mesh->n_vertex; a++)
            held[a] = body->equation[2 * a] < 0;
        body->pattern = sparse_alloc(mesh->n + 1, mesh->rows + 1,
                                     mesh->n_triangle, mesh->triangle, held,
                                     SPARSE_LEAF);
        free(held);
    }
    body->n_equation = number_equations(body);
    for (int e = 0; e < mesh->n_triangle; e++) sort_vertices(body, e);
    body->K = body->pattern ? matrix_alloc_sparse(body->pattern)
                            : matrix_alloc(storage, body->n_equation,
                                           half_bandwidth(body));
    scatter_map(body, body->place);
}

struct body *body_alloc(const struct mesh *mesh, struct material material,
                        double rho, enum mass mass, const int held[])
{
    const size_t triangles = (size_t)mesh->n_triangle;
    struct body *body = allocate(1, sizeof *body);
    assert(material.law != LINEAR && mesh_clockwise(mesh) < 0);
    *body = (struct body){
        .mesh = mesh, .material = material, .rho = rho, .mass = mass};
    body->equation = allocate(2 * (size_t)mesh->n_vertex, sizeof(int));
    for (int r = 0; r < 2 * mesh->n_vertex; r++)
        body->equation[r] = held[r / 2] ? -1 : 0;
    body->vertex = allocate(3 * triangles, sizeof(int));
    body->area = allocate(triangles, sizeof(double));
    body->gradient = allocate(6 * triangles, sizeof(double));
    body->place = allocate(6 * triangles, sizeof(int));
    const int shorter = mesh->n < mesh->rows ? mesh->n : mesh->rows;
    body_store(body, shorter < BODY_SPARSE_FROM ? BANDED : SPARSE);
    return body;
}

void body_free(struct body *body)
{
    if (!body) return;
    free(body->equation);
    free(body->vertex);
    free(body->area);
    free(body->gradient);
    free(body->place);
    matrix_free(body->K);
    sparse_free(body->pattern);
    free(body);
}

/* F = I + sum_a u_a (x) grad N_a of triangle e. */
static inline mat2 deformation(const struct body *body, const double u[], int e)
{
    const int *t = &body->vertex[3 * e];
    const double *g = &body->gradient[6 * e];
    mat2 F = {{{1.0, 0.0}, {0.0, 1.0}}};
#pragma GCC unroll 3
    for (int a = 0; a < 3; a++)
#pragma GCC unroll 2
        for (int i = 0; i < 2; i++) {
            F.m[i][0] += u[2 * t[a] + i] * g[2 * a];
            F.m[i][1] += u[2 * t[a] + i] * g[2 * a + 1];
        }
    return F;
}

mat2 body_deformation(const struct body *body, const double u[], int e)
{
    return deformation(body, u, e);
}

/* int N_a N_b / area of a triangle, or its row sums [eq:mass]. */
static double mass_share(enum mass mass, int a, int b)
{
    if (mass == LUMPED) return a == b ? 1.0 / 3.0 : 0.0;
    return a == b ? 1.0 / 6.0 : 1.0 / 12.0;
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
    if (body->add) body->add(body, 1.0, u, NO_TANGENT, energy, NULL);
    return isfinite(*energy) ? OK : NONFINITE;
}

void body_mass(const struct body *body, const double v[], double out[])
{
    memset(out, 0, 2 * (size_t)body->mesh->n_vertex * sizeof *out);
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->vertex[3 * e];
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++)
                for (int i = 0; i < 2; i++)
                    out[2 * t[a] + i] += body->rho * body->area[e] *
                                         mass_share(body->mass, a, b) *
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

struct incremental at_rest(const double f[])
{
    return (struct incremental){.dt = 1.0, .w = NULL, .f = f};
}

/* What a triangle adds to K is M_ab I + dt^2 area (...); its factors. */
struct factors {
    double m_aa, m_ab;  /* mass of a vertex, of a pair */
    double mu, dG, ddG; /* mu, G', G'' times dt^2 area */
};

/* Add block (a, b) to the lower band, column by column. */
static inline void add_block(mat2 block, int a, int b, int place, size_t stride,
                             double entries[])
{
    if (place < 0) return;
    double *column = &entries[place], *next = column + stride - 1;
    column[0] += block.m[0][0];
    column[1] += block.m[1][0];
    if (a != b) next[0] += block.m[0][1];
    next[1] += block.m[1][1];
}

/* Add the blocks M_ab I + mu g_a.g_b I + G'' c_a c_b^T
 * + G' (g_a x g_b) (0 1; -1 0), a >= b [eq:element-tangent]. */
static inline void add_exact(struct factors s, const double g[6],
                             const double c[6], const int place[6],
                             size_t stride, double entries[])
{
#pragma GCC unroll 3
    for (int a = 0, k = 0; a < 3; a++)
#pragma GCC unroll 3
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
static void add_projected(struct factors s, const double g[6],
                          const double c[6], mat2 F, const int place[6],
                          size_t stride, double entries[])
{
    if (fabs(s.dG) <= s.mu && s.ddG >= 0.0) {
        add_exact(s, g, c, place, stride, entries);
        return;
    }
    static const enum mode order[4] = {MODE_TWIST, MODE_FLIP, MODE_HIGH,
                                       MODE_LOW};
    const struct modes modes = modes_of(F, s.mu, s.dG, s.ddG);
    double d[4][6]; /* dF/du_a in direction m */
    for (int m = 0; m < 4; m++)
        for (int r = 0; r < 6; r++)
            d[m][r] = modes.direction[m].m[r % 2][0] * g[r / 2 * 2] +
                      modes.direction[m].m[r % 2][1] * g[r / 2 * 2 + 1];
    for (int a = 0, k = 0; a < 3; a++)
        for (int b = 0; b <= a; b++, k++) {
            mat2 block =
                mat2_scale(a == b ? s.m_aa : s.m_ab, mat2_identity());
            for (int i = 0; i < 16; i++) {
                const enum mode m = order[i / 4];
                if (modes.value[m] > 0.0)
                    block.m[i / 2 % 2][i % 2] += modes.value[m] *
                                                 d[m][2 * a + i / 2 % 2] *
                                                 d[m][2 * b + i % 2];
            }
            add_block(block, a, b, place[k], stride, entries);
        }
}

enum status body_assemble(struct body *body, struct incremental Phi,
                          const double u[], enum tangent tangent, double q[])
{
    const double dt = Phi.dt, rho = Phi.w ? body->rho : 0.0;
    const double rho_aa = rho * mass_share(body->mass, 0, 0);
    const double rho_ab = rho * mass_share(body->mass, 0, 1);
    const double *w = Phi.w ? Phi.w : u; /* at rest u - w is 0 */
    const int n_dof = 2 * body->mesh->n_vertex;
    const size_t stride = body->K->stride;
    double *entries = body->K->a;

    if (tangent != NO_TANGENT) matrix_zero(body->K);
    for (int r = 0; r < n_dof; r++) q[r] = Phi.f ? -dt * dt * Phi.f[r] : 0.0;
    for (int e = 0; e < body->mesh->n_triangle; e++) {
        const int *t = &body->vertex[3 * e];
        const double *g = &body->gradient[6 * e];
        const double area = dt * dt * body->area[e];
        const mat2 F = deformation(body, u, e);
        const double J = F.m[0][0] * F.m[1][1] - F.m[0][1] * F.m[1][0];
        if (!material_defined(&body->material, J))
            return isnan(J) ? NONFINITE : INVERTED;
        const struct volume v =
            material_volume_weighted(&body->material, J, area);
        const struct factors s = {rho_aa * body->area[e],
                                  rho_ab * body->area[e],
                                  area * body->material.mu, v.dG, v.ddG};
        double c[6], move[6];

#pragma GCC unroll 3
        for (int a = 0; a < 3; a++) { /* c_a = cof(F) g_a */
            c[2 * a] = F.m[1][1] * g[2 * a] - F.m[1][0] * g[2 * a + 1];
            c[2 * a + 1] = F.m[0][0] * g[2 * a + 1] - F.m[0][1] * g[2 * a];
            for (int i = 0; i < 2; i++)
                move[2 * a + i] = u[2 * t[a] + i] - w[2 * t[a] + i];
        }
#pragma GCC unroll 3
        for (int a = 0; a < 3; a++)
#pragma GCC unroll 2
            for (int i = 0; i < 2; i++)
                q[2 * t[a] + i] +=
                    s.mu * (F.m[i][0] * g[2 * a] + F.m[i][1] * g[2 * a + 1]) +
                    s.dG * c[2 * a + i] +
                    s.m_ab * (move[i] + move[2 + i] + move[4 + i]) +
                    (s.m_aa - s.m_ab) * move[2 * a + i];
        if (tangent == NO_TANGENT) continue;
        if (tangent == EXACT)
            add_exact(s, g, c, &body->place[6 * e], stride, entries);
        else
            add_projected(s, g, c, F, &body->place[6 * e], stride, entries);
    }
    if (body->add) body->add(body, dt, u, tangent, NULL, q);
    for (int r = 0; r < n_dof; r++)
        if (!isfinite(q[r])) return NONFINITE;
    return OK;
}

enum status body_force(const struct body *body, const double u[], double q[])
{
    struct body view = *body; /* whose K is not written */
    return body_assemble(&view, at_rest(NULL), u, NO_TANGENT, q);
}

struct matrix *body_matrix(const struct body *body)
{
    if (body->pattern) return matrix_alloc_sparse(body->pattern);
    return matrix_alloc(body->K->storage, body->n_equation, body->K->p);
}

enum status body_stiffness(const struct body *body, const double u[],
                           enum tangent tangent, struct matrix *K)
{
    double *q = allocate(2 * (size_t)body->mesh->n_vertex, sizeof *q);
    struct body view = *body;
    view.K = K;
    const enum status status =
        body_assemble(&view, at_rest(NULL), u, tangent, q);
    free(q);
    return status;
}

void body_mass_matrix(const struct body *body, struct matrix *M)
{
    double *rest = allocate(4 * (size_t)body->mesh->n_vertex, sizeof *rest);
    double *q = rest + 2 * body->mesh->n_vertex;
    struct body view = *body;
    view.K = M;
    body_assemble(&view, (struct incremental){0.0, rest, NULL}, rest, EXACT,
                  q); /* K = M + 0 */
    free(rest);
}

void body_gather(const struct body *body, const double all[], double some[])
{
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        if (body->equation[r] >= 0) some[body->equation[r]] = all[r];
}

void body_scatter(const struct body *body, const double some[], double all[])
{
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        all[r] = body->equation[r] >= 0 ? some[body->equation[r]] : 0.0;
}

double body_max_free(const struct body *body, const double v[])
{
    double largest = 0.0;
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        if (body->equation[r] >= 0 && !(fabs(v[r]) <= largest))
            largest = isfinite(v[r]) ? fabs(v[r]) : INFINITY;
    return largest;
}

enum status body_increment(const struct body *body, struct matrix *A,
                           const double q[], double du[])
{
    const enum status status = matrix_factor(A);
    if (status != OK) return status;
    double *d = allocate((size_t)body->n_equation, sizeof *d);
    body_gather(body, q, d);
    matrix_solve(A, d);
    for (int k = 0; k < body->n_equation; k++) d[k] = -d[k];
    body_scatter(body, d, du);
    free(d);
    return OK;
}
