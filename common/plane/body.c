/* body.c - see body.h. */
#include "plane/body.h"

#include "linear/sparse.h"
#include "plane/lanes.h"
#include "plane/numbering.h"
#include "plane/quadratic.h"
#include "plane/triangles.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct numbering numbering_of(const struct body *body)
{
    return (struct numbering){body->n_element, body->nodes, body->vertex,
                              body->equation};
}

/* Set vertices, gradients and area of triangle e, the vertices in the order of
 * their equations. */
static void make_triangle(struct body *body, int e)
{
    const int nodes = body->nodes, points = body->points;
    int vertex[QUADRATIC_NODES], order[QUADRATIC_NODES];
    double gradient[QUADRATIC_POINTS][2 * QUADRATIC_NODES];
    if (body->element == QUADRATIC_TRIANGLE) {
        quadratic_nodes(body->mesh, e, vertex);
        /* of a point, a third of the triangle */
        body->area[e] = quadratic_gradients(body->mesh, e, gradient) / 3.0;
    } else {
        memcpy(vertex, &body->mesh->triangle[3 * e], 3 * sizeof *vertex);
        body->area[e] = mesh_gradients(body->mesh, e, gradient[0]);
    }
    numbering_order(nodes, vertex, body->equation, order);
    for (int k = 0; k < nodes; k++) {
        body->vertex[nodes * e + k] = vertex[order[k]];
        for (int p = 0; p < points; p++)
            memcpy(&body->gradient[2 * (nodes * (points * e + p) + k)],
                   &gradient[p][2 * order[k]], 2 * sizeof **gradient);
    }
}

/* Return the pattern of K, of the vertices that have an equation. */
static struct sparse *find_pattern(const struct body *body)
{
    const struct mesh *mesh = body->mesh;
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    int n_list = mesh->n_triangle, *pairs = NULL;
    if (body->element == QUADRATIC_TRIANGLE)
        pairs = quadratic_pairs(mesh, &n_list);
    for (int a = 0; a < mesh->n_vertex; a++)
        held[a] = body->equation[2 * a] < 0;
    struct sparse *pattern =
        sparse_alloc(mesh->n + 1, mesh->rows + 1, n_list,
                     pairs ? pairs : mesh->triangle, held, SPARSE_LEAF);
    free(pairs);
    free(held);
    return pattern;
}

void body_store(struct body *body, enum storage storage)
{
    assert(storage != DENSE);
    matrix_free(body->K);
    sparse_free(body->pattern);
    body->pattern = storage == SPARSE ? find_pattern(body) : NULL;
    body->n_equation =
        numbering_lines(body->mesh, body->pattern, body->equation);
    body->total_area = 0.0;
    for (int e = 0; e < body->n_element; e++) {
        make_triangle(body, e);
        body->total_area += body->points * body->area[e];
    }
    free(body->lanes);
    body->lanes = body->element == LINEAR_TRIANGLE ? lanes_alloc(body) : NULL;
    const struct numbering numbering = numbering_of(body);
    body->K = body->pattern
                  ? matrix_alloc_sparse(body->pattern)
                  : matrix_alloc(storage, body->n_equation,
                                 numbering_half_bandwidth(numbering));
    numbering_places(numbering, body->K, body->place);
    body->kept.usable = 0;
}

struct body *body_alloc_of(enum element element, const struct mesh *mesh,
                           struct material material, double rho,
                           enum mass mass, const int held[])
{
    const int quadratic = element == QUADRATIC_TRIANGLE;
    struct body *body = allocate(1, sizeof *body);
    assert(material.law != LINEAR && mesh_clockwise(mesh) < 0);
    assert(!quadratic || (mesh->n % 2 == 0 && mesh->rows % 2 == 0));
    *body = (struct body){.mesh = mesh, .material = material, .rho = rho,
                          .mass = mass, .element = element,
                          .nodes = quadratic ? QUADRATIC_NODES : 3,
                          .points = quadratic ? QUADRATIC_POINTS : 1,
                          .n_element = mesh->n_triangle / (quadratic ? 4 : 1)};
    const size_t triangles = (size_t)body->n_element;
    const size_t nodes = (size_t)body->nodes;
    const size_t points = (size_t)body->points;
    body->room =
        allocate(BODY_ROOM * 2 * (size_t)mesh->n_vertex, sizeof(double));
    body->past.v = body->room + 8 * 2 * (size_t)mesh->n_vertex;
    for (int j = 2; j <= PAST_ORDER; j++)
        body->past.d[j] =
            body->past.v + (size_t)(j - 1) * 2 * (size_t)mesh->n_vertex;
    body->equation = allocate(2 * (size_t)mesh->n_vertex, sizeof(int));
    for (int r = 0; r < 2 * mesh->n_vertex; r++)
        body->equation[r] = held[r / 2] ? -1 : 0;
    body->vertex = allocate(nodes * triangles, sizeof(int));
    body->area = allocate(triangles, sizeof(double));
    body->gradient = allocate(2 * nodes * points * triangles, sizeof(double));
    body->place = allocate(nodes * (nodes + 1) / 2 * triangles, sizeof(int));
    if (quadratic) {
        body->diagonal = allocate((size_t)mesh->n_vertex, sizeof(double));
        quadratic_shares(mesh, body->diagonal);
    }
    const int shorter = mesh->n < mesh->rows ? mesh->n : mesh->rows;
    const int limit = quadratic ? BODY_QUADRATIC_SPARSE_FROM : BODY_SPARSE_FROM;
    body_store(body, shorter < limit ? BANDED : SPARSE);
    return body;
}

struct body *body_alloc(const struct mesh *mesh, struct material material,
                        double rho, enum mass mass, const int held[])
{
    return body_alloc_of(LINEAR_TRIANGLE, mesh, material, rho, mass, held);
}

void body_free(struct body *body)
{
    if (!body) return;
    free(body->room);
    free(body->equation);
    free(body->vertex);
    free(body->area);
    free(body->gradient);
    free(body->place);
    free(body->lanes);
    free(body->diagonal);
    matrix_free(body->K);
    sparse_free(body->pattern);
    free(body);
}

mat2 body_deformation(const struct body *body, const double u[], int e)
{
    if (body->element == LINEAR_TRIANGLE)
        return triangles_deformation(body, u, e, 0);
    const int *t = &body->mesh->triangle[3 * e];
    /* a linear triangle of the mesh, four of them in a quadratic one */
    mat2 F = mat2_identity();
    double g[6];
    mesh_gradients(body->mesh, e, g);
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++)
                F.m[i][j] += u[2 * t[a] + i] * g[2 * a + j];
    return F;
}

enum status body_energy(const struct body *body, const double u[],
                        double *energy)
{
    const enum status status = triangles_energy(body, u, energy);
    if (status != OK) return status;
    if (body->add) body->add(body, 1.0, u, NO_TANGENT, energy, NULL);
    return isfinite(*energy) ? OK : NONFINITE;
}

double body_mass_share(enum mass mass, int own)
{
    /* int N_a N_b dA / A, or its sum over b at vertex a */
    if (mass == LUMPED) return own ? 1.0 / 3.0 : 0.0;
    return own ? 1.0 / 6.0 : 1.0 / 12.0;
}

double body_min_J(const struct body *body, const double u[])
{
    double least = INFINITY;
    for (int e = 0; e < body->n_element; e++)
        for (int p = 0; p < body->points; p++)
            least = fmin(least, mat2_det(triangles_deformation(body, u, e, p)));
    return least;
}

void body_turned(const struct body *body, const double u[], double by[2])
{
    const int n_dof = 2 * body->mesh->n_vertex;
    const double *X = body->mesh->X;
    double middle[2] = {0.0, 0.0}, along = 0.0, sideways = 0.0;
    for (int r = 0; r < n_dof; r++) middle[r % 2] += 2.0 * X[r] / n_dof;
    for (int r = 0; r < n_dof; r += 2) {
        const double X1 = X[r] - middle[0], X2 = X[r + 1] - middle[1];
        const double x1 = X1 + u[r], x2 = X2 + u[r + 1];
        /* sum |X| |x| times cosine and sine of the angle from X to x */
        along += X1 * x1 + X2 * x2;
        sideways += X1 * x2 - X2 * x1;
    }
    const double size = sqrt(along * along + sideways * sideways);
    by[0] = size > 0.0 ? along / size : 1.0;
    by[1] = size > 0.0 ? sideways / size : 0.0;
}

void body_mass(const struct body *body, const double v[], double out[])
{
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++)
        out[r] = body->diagonal ? body->rho * body->diagonal[r / 2] * v[r]
                                : 0.0;
    if (body->diagonal) return;
    const double own = body_mass_share(body->mass, 1);
    const double other = body_mass_share(body->mass, 0);
    for (int e = 0; e < body->n_element; e++) {
        const int *t = &body->vertex[3 * e];
        /* (M v)_a = sum_b M_ab v_b, M_ab = rho A times a share */
        const double mass = body->rho * body->area[e];
        for (int i = 0; i < 2; i++)
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    out[2 * t[a] + i] += mass * (a == b ? own : other) *
                                         v[2 * t[b] + i];
    }
}

struct incremental at_rest(const double f[])
{
    return (struct incremental){.dt = 1.0, .w = NULL, .f = f};
}

/* The mass of quadratic triangles in q and K. */
static void add_diagonal(struct body *body, struct incremental Phi,
                         const double u[], enum tangent tangent, double q[])
{
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++) {
        const int k = body->equation[r];
        const double mass = body->rho * body->diagonal[r / 2]; /* M_rr */
        q[r] += mass * (u[r] - Phi.w[r]);
        if (tangent != NO_TANGENT && k >= 0) matrix_add(body->K, k, k, mass);
    }
}

enum status body_assemble(struct body *body, struct incremental Phi,
                          const double u[], enum tangent tangent, double q[])
{
    const double dt = Phi.dt;
    const int n_dof = 2 * body->mesh->n_vertex;
    const int linear = body->element == LINEAR_TRIANGLE;

    assert(linear || !body->add);
    if (tangent != NO_TANGENT) {
        matrix_zero(body->K);
        body->kept.usable = 0;
    }
    /* q = M (u - w) + dt^2 (dPsi/du - f); here -dt^2 f */
    for (int r = 0; r < n_dof; r++) q[r] = Phi.f ? -dt * dt * Phi.f[r] : 0.0;
    if (Phi.w && !linear) add_diagonal(body, Phi, u, tangent, q);
    const enum status status = triangles_assemble(body, Phi, u, tangent, q);
    if (status != OK) return status;
    if (body->add) body->add(body, dt, u, tangent, NULL, q);
    int bad = 0;
    for (int r = 0; r < n_dof; r++) bad |= !isfinite(q[r]);
    return bad ? NONFINITE : OK;
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
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    double *rest = allocate(n_dof, sizeof *rest);
    double *q = allocate(n_dof, sizeof *q);
    struct body view = *body;
    view.K = M;
    body_assemble(&view, (struct incremental){0.0, rest, NULL}, rest, EXACT,
                  q); /* K = M + 0 */
    free(rest);
    free(q);
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

/* Numbers above 0 are in the order of their bits, INFINITY and NaN last, and
 * the largest of the bits is found without a branch. */
double body_max_free(const struct body *body, const double v[])
{
    long long largest_bits = 0;
    double largest;
    const int n_dof = 2 * body->mesh->n_vertex;
    for (int r = 0; r < n_dof; r++) {
        const double size = fabs(v[r]);
        long long bits;
        memcpy(&bits, &size, sizeof bits);
        bits = body->equation[r] < 0 ? 0 : bits;
        largest_bits = bits > largest_bits ? bits : largest_bits;
    }
    memcpy(&largest, &largest_bits, sizeof largest);
    return isfinite(largest) ? largest : INFINITY;
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
