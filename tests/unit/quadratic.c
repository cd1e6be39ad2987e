/* quadratic.c - laws of common/plane/quadratic.h, and of mesh_grade(). */
#include "plane/quadratic.h"
#include "figures/study/study.h"
#include "linear/sparse.h"
#include "plane/body.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>

enum { N = 4 }; /* cells of the mesh: 2 x 2 squares */

/* Numbers without a pattern, in (-1, 1). */
static double entropy(int i) { return sin(2.385 * i * i + 3.714 * i + 0.7); }

/* A sheared rectangle, the corners inside moved: no right angle, no two
 * triangles alike; then straight edges. */
static struct mesh *skew(int n)
{
    struct mesh *mesh = mesh_square(n);
    for (int a = 0; a < mesh->n_vertex; a++) {
        const int i = a % (n + 1), j = a / (n + 1);
        double *X = &mesh->X[2 * a];
        X[0] += 0.371 * X[1];
        X[1] += 0.137 * X[0];
        if (i == 0 || j == 0 || i == n || j == n) continue;
        X[0] += 0.4 / n * entropy(2 * a);
        X[1] += 0.4 / n * entropy(2 * a + 1);
    }
    quadratic_straighten(mesh);
    return mesh;
}

/* None held, or the left side; CUBIC, E = 1000, nu = 0.3. */
static struct body *body_of(const struct mesh *mesh, enum law law,
                            int held, enum storage storage)
{
    int *fixed = allocate((size_t)mesh->n_vertex, sizeof *fixed);
    for (int a = 0; a < mesh->n_vertex; a++)
        fixed[a] = held && a % (mesh->n + 1) == 0;
    struct body *body =
        body_alloc_of(QUADRATIC_TRIANGLE, mesh, material_make(law, 1000.0, 0.3),
                      2.385, CONSISTENT, fixed);
    body_store(body, storage);
    free(fixed);
    return body;
}

static void free_body(struct body *body)
{
    struct mesh *mesh = (struct mesh *)body->mesh;
    body_free(body);
    mesh_free(mesh);
}

static double *vector(const struct body *body, double size)
{
    const int n = 2 * body->mesh->n_vertex;
    double *v = allocate((size_t)n, sizeof *v);
    for (int r = 0; r < n; r++) v[r] = size * entropy(r + 7);
    return v;
}

/* The triangle of the laws of one element, and the gradients of its l. */
static const double corner[6] = {0.1, -0.2, 1.3, 0.15, 0.45, 0.9};
static double of_corner(double of_l[6])
{
    struct mesh *mesh = mesh_triangle(corner);
    const double area = mesh_gradients(mesh, 0, of_l);
    mesh_free(mesh);
    return area;
}

static const double place_of[6][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                      {0.0, 0.0, 1.0}, {0.0, 0.5, 0.5},
                                      {0.5, 0.0, 0.5}, {0.5, 0.5, 0.0}};

static void a_function_is_1_at_its_node_and_0_at_the_others(void)
{
    double of_l[6], N6[6], gradient[12];
    of_corner(of_l);
    for (int b = 0; b < 6; b++) {
        quadratic_shape(place_of[b], of_l, N6, gradient);
        for (int a = 0; a < 6; a++) close_to(N6[a], a == b, 1e-15);
    }
}

static void functions_add_up_to_1_and_gradients_to_0(void)
{
    double of_l[6];
    of_corner(of_l);
    for (int k = 0; k < 20; k++) {
        const double x = 0.5 + 0.4 * entropy(k), y = 0.5 + 0.4 * entropy(-k);
        const double l[3] = {x, y, 1.0 - x - y};
        double N6[6], gradient[12], sum = 0.0, slope[2] = {0.0, 0.0};
        quadratic_shape(l, of_l, N6, gradient);
        for (int a = 0; a < 6; a++) {
            sum += N6[a];
            for (int j = 0; j < 2; j++) slope[j] += gradient[2 * a + j];
        }
        close_to(sum, 1.0, 1e-14);
        close_to(slope[0], 0.0, 1e-13);
        close_to(slope[1], 0.0, 1e-13);
    }
}

/* Gradients against differences of the functions, exact for quadratics. */
static void gradients_are_derivatives(void)
{
    const double l[3] = {0.2385, 0.3714, 0.3901}, d = 0.1;
    double of_l[6], N6[6], gradient[12], ahead[6], behind[6], unused[12];
    of_corner(of_l);
    quadratic_shape(l, of_l, N6, gradient);
    for (int j = 0; j < 2; j++) {
        double on[3], back[3];
        for (int v = 0; v < 3; v++) {
            on[v] = l[v] + d * of_l[2 * v + j];
            back[v] = l[v] - d * of_l[2 * v + j];
        }
        quadratic_shape(on, of_l, ahead, unused);
        quadratic_shape(back, of_l, behind, unused);
        for (int a = 0; a < 6; a++)
            close_to(gradient[2 * a + j],
                     (ahead[a] - behind[a]) / (2.0 * d), 1e-13);
    }
}

/* Whether vertex a is a node inside the mesh. */
static int inside(const struct mesh *mesh, int a)
{
    const int i = a % (mesh->n + 1), j = a / (mesh->n + 1);
    return i > 0 && i < mesh->n && j > 0 && j < mesh->rows;
}

static void affine_maps_leave_the_interior_in_balance(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        struct body *body = body_of(skew(N), (enum law)law, 0, BANDED);
        const struct mesh *mesh = body->mesh;
        const double H[2][2] = {{0.2385, -0.1}, {0.3714, -0.15}};
        double *u = vector(body, 0.0), *q = vector(body, 0.0), energy;
        mat2 F = mat2_identity();
        for (int r = 0; r < 2 * mesh->n_vertex; r++)
            u[r] = H[r % 2][0] * mesh->X[r / 2 * 2] +
                   H[r % 2][1] * mesh->X[r / 2 * 2 + 1];
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++) F.m[i][j] += H[i][j];
        ck_assert_int_eq(
            body_assemble(body, at_rest(NULL), u, NO_TANGENT, q), OK);
        for (int a = 0; a < mesh->n_vertex; a++)
            if (inside(mesh, a)) {
                close_to(q[2 * a], 0.0, 1e-12 * 1000.0);
                close_to(q[2 * a + 1], 0.0, 1e-12 * 1000.0);
            }
        close_to(body_min_J(body, u), mat2_det(F), 1e-13);
        ck_assert_int_eq(body_energy(body, u, &energy), OK);
        /* two shears leave the area 4 */
        close_to(energy, 4.0 * material2_psi(&body->material, F),
                 1e-12 * 1000.0);
        free(u), free(q);
        free_body(body);
    }
}

/* u of degree 2 of the linear law, which is K at rest, balances the constant
 * body force f = -mu lap u - (lambda + mu) grad div u at all inner nodes. */
static void quadratic_maps_balance_their_body_force(void)
{
    struct body *body = body_of(skew(N), CUBIC, 0, BANDED);
    const struct mesh *mesh = body->mesh;
    const double mu = body->material.mu, lambda = body->material.lambda;
    /* u_i = c_i0 X^2 + c_i1 X Y + c_i2 Y^2 */
    const double c[2][3] = {{0.7, -0.4, 0.3}, {0.2, 0.6, -0.5}};
    const double div[2] = {2.0 * c[0][0] + c[1][1], c[0][1] + 2.0 * c[1][2]};
    const double density[2] = {
        -mu * 2.0 * (c[0][0] + c[0][2]) - (lambda + mu) * div[0],
        -mu * 2.0 * (c[1][0] + c[1][2]) - (lambda + mu) * div[1]};
    double *u = vector(body, 0.0), *q = vector(body, 0.0);
    double *x = vector(body, 0.0), *f = vector(body, 0.0);
    ck_assert_int_eq(body_assemble(body, at_rest(NULL), u, EXACT, q), OK);
    quadratic_load(mesh, density, f);
    for (int r = 0; r < 2 * mesh->n_vertex; r++) {
        const double *X = &mesh->X[r / 2 * 2];
        x[body->equation[r]] = c[r % 2][0] * X[0] * X[0] +
                               c[r % 2][1] * X[0] * X[1] +
                               c[r % 2][2] * X[1] * X[1];
    }
    matrix_multiply(body->K, x, q);
    for (int r = 0; r < 2 * mesh->n_vertex; r++)
        if (inside(mesh, r / 2))
            close_to(q[body->equation[r]], f[r], 1e-12 * 1000.0);
    free(u), free(q), free(x), free(f);
    free_body(body);
}

static void the_load_is_in_the_middles(void)
{
    struct body *body = body_of(skew(N), CUBIC, 0, BANDED);
    const double density[2] = {2.0, -3.0};
    double *f = vector(body, 0.0), sum[2] = {0.0, 0.0};
    quadratic_load(body->mesh, density, f);
    for (int a = 0; a < body->mesh->n_vertex; a++) {
        const int at_corner = a % (N + 1) % 2 == 0 && a / (N + 1) % 2 == 0;
        ck_assert_int_eq(f[2 * a] == 0.0, at_corner);
        for (int i = 0; i < 2; i++) sum[i] += f[2 * a + i];
    }
    close_to(sum[0], 8.0, 1e-12);
    close_to(sum[1], -12.0, 1e-12);
    free(f);
    free_body(body);
}

/* Phi and its derivatives along v; h halved, remainders fall by 8, by 4. */
static void taylor_slopes_are_those_of_derivatives(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        struct body *body = body_of(skew(N), (enum law)law, 0, BANDED);
        const int n = 2 * body->mesh->n_vertex;
        const struct incremental Phi = {1.0, NULL, NULL};
        double *u = vector(body, 0.03), *v = vector(body, 0.0);
        double *q = vector(body, 0.0), *trial = vector(body, 0.0);
        double *x = vector(body, 0.0), *y = vector(body, 0.0);
        double *Kv = vector(body, 0.0), *now = vector(body, 0.0);
        double energy, slope = 0.0, curvature = 0.0, rest[4][3];
        for (int r = 0; r < n; r++) v[r] = entropy(3 * r + 1);
        ck_assert_int_eq(body_assemble(body, Phi, u, EXACT, q), OK);
        ck_assert_int_eq(body_energy(body, u, &energy), OK);
        for (int r = 0; r < n; r++) x[body->equation[r]] = v[r];
        matrix_multiply(body->K, x, y);
        for (int r = 0; r < n; r++) {
            Kv[r] = y[body->equation[r]];
            slope += q[r] * v[r];
            curvature += v[r] * Kv[r];
        }
        for (int k = 0; k < 4; k++) {
            const double h = 4e-3 * pow(0.5, k);
            double there;
            for (int r = 0; r < n; r++) trial[r] = u[r] + h * v[r];
            ck_assert_int_eq(body_energy(body, trial, &there), OK);
            ck_assert_int_eq(
                body_assemble(body, Phi, trial, NO_TANGENT, now), OK);
            rest[k][0] = fabs(there - energy - h * slope);
            rest[k][1] = fabs(there - energy - h * slope -
                              0.5 * h * h * curvature);
            rest[k][2] = 0.0;
            for (int r = 0; r < n; r++)
                rest[k][2] = fmax(rest[k][2], fabs(now[r] - q[r] - h * Kv[r]));
        }
        const double want[3] = {2.0, 3.0, 2.0};
        for (int j = 0; j < 3; j++)
            close_to(study_order(rest[2][j], rest[3][j], 2.0), want[j], 0.1);
        free(u), free(v), free(q), free(trial), free(x), free(y), free(Kv);
        free(now);
        free_body(body);
    }
}

static void three_motions_cost_nothing(void)
{
    struct body *body = body_of(skew(N), CUBIC, 0, BANDED);
    const int n = body->n_equation;
    double *u = vector(body, 0.0), *q = vector(body, 0.0);
    double *value = allocate((size_t)n, sizeof *value);
    ck_assert_int_eq(body_assemble(body, at_rest(NULL), u, EXACT, q), OK);
    ck_assert_int_eq(matrix_eigenvalues(body->K, value), OK);
    for (int k = 0; k < 3; k++) close_to(value[k], 0.0, 1e-12 * value[n - 1]);
    ck_assert_double_gt(value[3], 1e-3 * value[n - 1]);
    free(u), free(q), free(value);
    free_body(body);
}

/* 3 and 16 parts of 57; at a corner of the square below the cut one triangle,
 * and both the mass in q and in K. */
static void the_mass_is_scaled(void)
{
    struct body *body = body_of(mesh_square(2), CUBIC, 0, BANDED);
    const double rho = 2.385, dt = 1e-6, area = 2.0;
    double *u = vector(body, 0.01), *w = vector(body, 0.0), sum = 0.0;
    double *q = vector(body, 0.0);
    const struct incremental Phi = {dt, w, NULL};
    for (int a = 0; a < 9; a++) sum += body->diagonal[a];
    close_to(sum, 4.0, 1e-13);
    close_to(body->diagonal[2], area * 3.0 / 57.0, 1e-14);
    close_to(body->diagonal[0], area * 6.0 / 57.0, 1e-14);
    close_to(body->diagonal[1], area * 16.0 / 57.0, 1e-14);
    close_to(body->diagonal[4], area * 32.0 / 57.0, 1e-14);
    ck_assert_int_eq(body_assemble(body, Phi, u, EXACT, q), OK);
    for (int r = 0; r < 18; r++) { /* dt^2 of the stiffness is 1e-9 */
        const int k = body->equation[r];
        close_to(q[r], rho * body->diagonal[r / 2] * u[r], 1e-8);
        close_to(matrix_get(body->K, k, k), rho * body->diagonal[r / 2],
                 1e-7);
    }
    free(u), free(w), free(q);
    free_body(body);
}

/* The same by the three doors of body.h: M v, the matrix, both settings. */
static void all_doors_have_the_same_mass(void)
{
    struct body *body = body_of(skew(N), CUBIC, 1, BANDED);
    const int n = 2 * body->mesh->n_vertex;
    double *v = vector(body, 1.0), *Mv = vector(body, 0.0), all = 0.0;
    double *one = vector(body, 0.0), *out = vector(body, 0.0);
    struct matrix *M = body_matrix(body);
    for (int r = 0; r < n; r += 2) one[r] = 1.0;
    body_mass(body, one, out);
    for (int r = 0; r < n; r++) all += out[r];
    close_to(all, 4.0 * 2.385, 1e-12); /* two shears leave the area 4 */
    body_mass(body, v, Mv);
    for (int lumped = 0; lumped < 2; lumped++) {
        body->mass = lumped ? LUMPED : CONSISTENT;
        body_mass_matrix(body, M);
        body_gather(body, v, one);
        matrix_multiply(M, one, out);
        body_gather(body, Mv, one);
        for (int k = 0; k < body->n_equation; k++)
            close_to(out[k], one[k], 1e-14);
    }
    body->rho = 0.0; /* what is static */
    body_mass(body, v, Mv);
    for (int r = 0; r < n; r++) ck_assert(Mv[r] == 0.0);
    matrix_free(M);
    free(v), free(Mv), free(one), free(out);
    free_body(body);
}

/* v.K v of a squeezed body, whose K is indefinite: the projected K is positive
 * definite, is no smaller in any direction, and is the exact one where all
 * is stretched. */
static void projection_clamps_at_each_point(void)
{
    struct body *body = body_of(skew(N), LOG, 1, BANDED);
    const int n = body->n_equation;
    double *u = vector(body, 0.0), *q = vector(body, 0.0);
    double *value = allocate((size_t)n, sizeof *value);
    double *x = allocate((size_t)n, sizeof *x), *y = vector(body, 0.0);
    struct matrix *K = body_matrix(body);
    for (int squeezed = 0; squeezed < 2; squeezed++) {
        for (int a = 0; a < body->mesh->n_vertex; a++)
            u[2 * a] = (squeezed ? -0.6 : 0.2) * (body->mesh->X[2 * a] + 1.4);
        for (int k = 0; k < n; k++) x[k] = entropy(5 * k + 2);
        double form[2] = {0.0, 0.0};
        for (int k = 0; k < 2; k++) {
            const enum tangent kind = k ? PROJECTED : EXACT;
            ck_assert_int_eq(body_stiffness(body, u, kind, K), OK);
            matrix_multiply(K, x, y);
            for (int r = 0; r < n; r++) form[k] += x[r] * y[r];
            ck_assert_int_eq(matrix_eigenvalues(K, value), OK);
            ck_assert_int_eq(value[0] > 0.0, k || !squeezed);
        }
        if (squeezed)
            ck_assert_double_gt(form[1], form[0]);
        else
            close_to(form[1], form[0], 1e-12 * form[0]);
    }
    matrix_free(K);
    free(u), free(q), free(value), free(x), free(y);
    free_body(body);
}

static void every_storage_gives_the_same_increment(void)
{
    double *du[3];
    struct body *body[3];
    const enum storage storage[3] = {BANDED, SPARSE, PLAIN};
    for (int k = 0; k < 3; k++) {
        struct mesh *mesh = k ? (struct mesh *)body[0]->mesh : skew(24);
        body[k] = body_of(mesh, LOG, 1, storage[k]);
        double *u = vector(body[k], 0.002), *q = vector(body[k], 0.0);
        du[k] = vector(body[k], 0.0);
        ck_assert_int_eq(
            body_assemble(body[k], at_rest(NULL), u, EXACT, q), OK);
        struct matrix *K = matrix_copy(body[k]->K);
        ck_assert_int_eq(body_increment(body[k], body[k]->K, q, du[k]), OK);
        double *x = vector(body[k], 0.0), *y = vector(body[k], 0.0);
        for (int r = 0; r < 2 * 25 * 25; r++)
            if (body[k]->equation[r] >= 0) x[body[k]->equation[r]] = du[k][r];
        matrix_multiply(K, x, y); /* K du = -q, q about 1 */
        for (int r = 0; r < 2 * 25 * 25; r++)
            if (body[k]->equation[r] >= 0)
                close_to(y[body[k]->equation[r]], -q[r], 1e-10);
        matrix_free(K);
        free(u), free(q), free(x), free(y);
    }
    double most = 0.0;
    for (int r = 0; r < 2 * 25 * 25; r++) most = fmax(most, fabs(du[0][r]));
    for (int r = 0; r < 2 * 25 * 25; r++)
        for (int k = 1; k < 3; k++)
            close_to(du[k][r], du[0][r], 1e-10 * most);
    ck_assert_int_eq(body[0]->K->p, 2 * 2 * 24 + 1);
    free(du[0]), free(du[1]), free(du[2]);
    body_free(body[1]);
    body_free(body[2]);
    free_body(body[0]);
}

static void a_column_is_numbered_across(void)
{
    struct body *body =
        body_of(mesh_rectangle(16, 2, 1.0, 0.125), CUBIC, 1, BANDED);
    ck_assert_int_eq(body->K->p, 2 * 2 * 3 + 1);
    free_body(body);
}

static void states_outside_are_reported(void)
{
    struct body *body = body_of(skew(N), LOG, 0, BANDED);
    double *u = vector(body, 0.0), *q = vector(body, 0.0), energy;
    for (int a = 0; a < body->mesh->n_vertex; a++)
        u[2 * a] = -2.0 * body->mesh->X[2 * a]; /* a mirror */
    ck_assert_int_eq(body_energy(body, u, &energy), INVERTED);
    ck_assert_int_eq(
        body_assemble(body, at_rest(NULL), u, EXACT, q), INVERTED);
    for (int r = 0; r < 2 * body->mesh->n_vertex; r++) u[r] = 0.0;
    u[7] = NAN;
    ck_assert_int_eq(body_energy(body, u, &energy), NONFINITE);
    ck_assert_int_eq(
        body_assemble(body, at_rest(NULL), u, NO_TANGENT, q), NONFINITE);
    free(u), free(q);
    free_body(body);
}

static void graded_sides_and_no_others(void)
{
    struct mesh *mesh = mesh_rectangle(8, 8, 2.0, 1.0);
    mesh_grade(mesh, 2.0, MESH_LEFT | MESH_TOP);
    const double across[9] = {-2.0, -1.75, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0};
    const double up[9] = {-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.875, 1.0};
    for (int j = 0; j < 9; j++)
        for (int i = 0; i < 9; i++) {
            close_to(mesh->X[2 * (9 * j + i)], across[i], 1e-15);
            close_to(mesh->X[2 * (9 * j + i) + 1], up[j], 1e-15);
        }
    quadratic_straighten(mesh);
    close_to(mesh->X[2 * 1], 0.5 * (-2.0 - 1.0), 1e-15);
    close_to(mesh->X[2 * 9 * 7 + 1], 0.5 * (0.5 + 1.0), 1e-15);
    mesh_free(mesh);
}

UNIT_MAIN("quadratic",
    LAW(a_function_is_1_at_its_node_and_0_at_the_others),
    LAW(functions_add_up_to_1_and_gradients_to_0),
    LAW(gradients_are_derivatives),
    LAW(affine_maps_leave_the_interior_in_balance),
    LAW(quadratic_maps_balance_their_body_force),
    LAW(the_load_is_in_the_middles),
    LAW(taylor_slopes_are_those_of_derivatives),
    LAW(three_motions_cost_nothing),
    LAW(the_mass_is_scaled),
    LAW(all_doors_have_the_same_mass),
    LAW(projection_clamps_at_each_point),
    LAW(every_storage_gives_the_same_increment),
    LAW(a_column_is_numbered_across),
    LAW(states_outside_are_reported),
    LAW(graded_sides_and_no_others))
