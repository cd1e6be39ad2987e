/* crushed.c - laws that exist for every F, and what lets a crushed body go. */
#include "plane/circuit.h"
#include "plane/release.h"
#include "unit.h"

#include <gsl/gsl_math.h>
#include <string.h>

static const double nu = 0.2385, E = 371.4;

static struct material odd(enum law law)
{
    return material_make(law, E, nu);
}

/* ---- the laws EXTENDED and STABLE ---------------------------------------- */

/* J = 1.04, 0.281, 0.22, 0, -0.92. */
static const mat2 state[] = {{{{1.1371, 0.2385}, {-0.3714, 0.8371}}},
                             {{{0.4385, 0.1371}, {-0.2613, 0.5564}}},
                             {{{0.3714, 0.1371}, {-0.2613, 0.4961}}},
                             {{{0.64, 0.48}, {0.48, 0.36}}},
                             {{{0.3714, 0.8731}, {0.9613, -0.2185}}}};

static void every_law_has_its_word(void)
{
    static const char *const word[] = {"linear", "log", "cubic", "extended",
                                       "stable"};
    for (int law = LINEAR; law <= STABLE; law++)
        ck_assert_str_eq(material_law((enum law)law), word[law]);
}

/* P and dP against differences of psi and P; the step leaves 1e-8. */
static void stress_and_tangent_are_derivatives(void)
{
    const double h = 1e-5, F1[] = {-0.7385, 0.0, 0.2, 0.3714, 1.2385};
    for (int law = EXTENDED; law <= STABLE; law++) {
        const struct material m = odd((enum law)law);
        for (int k = 0; k < COUNT(state); k++)
            for (int r = 0; r < 4; r++) {
                mat2 dF = {{{0.0, 0.0}, {0.0, 0.0}}};
                dF.m[r / 2][r % 2] = 1.0;
                const mat2 plus = mat2_add(state[k], mat2_scale(h, dF));
                const mat2 minus = mat2_add(state[k], mat2_scale(-h, dF));
                close_to(material2_pk1(&m, state[k]).m[r / 2][r % 2],
                         (material2_psi(&m, plus) - material2_psi(&m, minus)) /
                             (2.0 * h), 1e-6 * E);
                close_to(mat2_norm(mat2_subtract(
                             material2_dpk1(&m, state[k], dF),
                             mat2_scale(0.5 / h, mat2_subtract(
                                 material2_pk1(&m, plus),
                                 material2_pk1(&m, minus))))), 0.0, 1e-5 * E);
            }
        for (int k = 0; k < COUNT(F1); k++) {
            close_to(material1_pk1(&m, F1[k]),
                     (material1_psi(&m, F1[k] + h) -
                      material1_psi(&m, F1[k] - h)) / (2.0 * h), 1e-6 * E);
            close_to(material1_dpk1(&m, F1[k]),
                     (material1_pk1(&m, F1[k] + h) -
                      material1_pk1(&m, F1[k] - h)) / (2.0 * h), 1e-5 * E);
        }
    }
}

static void extended_is_log_above_eps(void)
{
    const struct material m = odd(EXTENDED), log = odd(LOG);
    const mat2 dF = {{{0.731, -0.512}, {0.3714, 0.6133}}};
    for (int k = 0; k < 2; k++) {
        ck_assert(mat2_det(state[k]) > EXTENDED_BELOW);
        close_to(material2_psi(&m, state[k]), material2_psi(&log, state[k]),
                 1e-13 * E);
        close_to(mat2_norm(mat2_subtract(material2_pk1(&m, state[k]),
                                         material2_pk1(&log, state[k]))),
                 0.0, 1e-13 * E);
        close_to(mat2_norm(mat2_subtract(material2_dpk1(&m, state[k], dF),
                                         material2_dpk1(&log, state[k], dF))),
                 0.0, 1e-13 * E);
    }
    close_to(material1_psi(&m, 0.3), material1_psi(&log, 0.3), 1e-13 * E);
    close_to(material1_dpk1(&m, 0.3), material1_dpk1(&log, 0.3), 1e-13 * E);
}

/* psi, P and dP/dF on both sides of J = eps, 2e-9 apart: a jump shows. */
static void extended_is_smooth_at_eps(void)
{
    const struct material m = odd(EXTENDED);
    const double below = EXTENDED_BELOW - 1e-9, above = EXTENDED_BELOW + 1e-9;
    close_to(material1_psi(&m, below), material1_psi(&m, above), 1e-6 * E);
    close_to(material1_pk1(&m, below), material1_pk1(&m, above), 1e-6 * E);
    close_to(material1_dpk1(&m, below), material1_dpk1(&m, above), 1e-5 * E);
    close_to(material1_dpk1(&m, -1.0), material1_dpk1(&m, below), 1e-5 * E);
}

static void stable_is_linear_in_uniaxial_strain(void)
{
    const struct material m = odd(STABLE);
    const double modulus = material_modulus(&m), F[] = {-2.0, 0.0, 1.0, 3.714};
    for (int k = 0; k < COUNT(F); k++) {
        const mat2 along = {{{F[k], 0.0}, {0.0, 1.0}}};
        const double e = F[k] - 1.0;
        close_to(material1_psi(&m, F[k]), 0.5 * modulus * e * e, 1e-12 * E);
        close_to(material1_pk1(&m, F[k]), modulus * e, 1e-12 * E);
        close_to(material1_dpk1(&m, F[k]), modulus, 1e-12 * E);
        close_to(material2_psi(&m, along), 0.5 * modulus * e * e, 1e-12 * E);
        close_to(material2_pk1(&m, along).m[0][0], modulus * e, 1e-12 * E);
    }
}

/* ---- one triangle -------------------------------------------------------- */

static const double corners[6] = {0.2, -0.1, 1.3714, 0.0613, 0.4385, 0.9238};

static struct body *triangle(struct mesh **mesh, enum law law, int held)
{
    *mesh = mesh_triangle(corners);
    return body_alloc(*mesh, odd(law), 0.0, CONSISTENT,
                      (const int[]){held, 0, 0});
}

/* Force area P grad N_a and its derivative, under every law of the body. */
static void a_body_takes_every_law(void)
{
    for (int law = CUBIC; law <= STABLE; law++) {
        struct mesh *mesh;
        struct body *body = triangle(&mesh, (enum law)law, 1);
        double u[6] = {0.0}, q[6], near[2][6], g[6];
        const double area = mesh_gradients(mesh, 0, g), h = 1e-6;
        release_place(body, state[4], u);
        u[0] = state[4].m[0][0] * corners[0] + state[4].m[0][1] * corners[1] -
               corners[0];
        u[1] = state[4].m[1][0] * corners[0] + state[4].m[1][1] * corners[1] -
               corners[1];
        const struct material m = odd((enum law)law);
        const mat2 P = material2_pk1(&m, state[4]);
        ck_assert(body_force(body, u, q) == OK);
        for (int r = 0; r < 6; r++)
            close_to(q[r], area * (P.m[r % 2][0] * g[r / 2 * 2] +
                                   P.m[r % 2][1] * g[r / 2 * 2 + 1]),
                     1e-11 * E);
        struct matrix *K = body_matrix(body);
        ck_assert(body_stiffness(body, u, EXACT, K) == OK);
        for (int r = 2; r < 6; r++) {
            for (int side = 0; side < 2; side++) {
                u[r] += side ? -2.0 * h : h;
                body_force(body, u, near[side]);
            }
            u[r] += h;
            for (int s = 2; s < 6; s++)
                close_to(matrix_get(K, body->equation[s], body->equation[r]),
                         (near[0][s] - near[1][s]) / (2.0 * h), 1e-5 * E);
        }
        matrix_free(K);
        body_free(body);
        mesh_free(mesh);
    }
}

static void a_triangle_is_a_mesh(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    double g[6];
    ck_assert(mesh->n_vertex == 3 && mesh->n_triangle == 1);
    ck_assert(memcmp(mesh->X, corners, sizeof corners) == 0);
    close_to(mesh_gradients(mesh, 0, g),
             0.5 * (1.1714 * 1.0238 - 0.1613 * 0.2385), 1e-14);
    ck_assert_int_eq(mesh_clockwise(mesh), -1);
    mesh_free(mesh);
}

/* ---- the work round a polygon -------------------------------------------- */

static void turning(const double x[2], void *unused, double out[2])
{
    (void)unused;
    out[0] = -0.5 * x[1];
    out[1] = 0.5 * x[0];
}

/* The gradient of sin(3 x) exp(y). */
static void gradient(const double x[2], void *scale, double out[2])
{
    out[0] = *(double *)scale * 3.0 * cos(3.0 * x[0]) * exp(x[1]);
    out[1] = *(double *)scale * sin(3.0 * x[0]) * exp(x[1]);
}

static void work_tells_a_gradient(void)
{
    const double corner[] = {0.0, 0.0, 2.0, 0.5, 1.5, 1.7385, -0.3, 1.0};
    double area = 0.0, scale = 2.385;
    for (int k = 0; k < 4; k++) {
        const double *a = &corner[2 * k], *b = &corner[2 * ((k + 1) % 4)];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    close_to(circuit_work(turning, NULL, 4, corner), area, 1e-14);
    close_to(circuit_work(turning, NULL, 3, corner),
             0.5 * (2.0 * 1.7385 - 0.75), 1e-14);
    close_to(circuit_work(gradient, &scale, 4, corner), 0.0, 1e-12);
}

/* ---- letting go ---------------------------------------------------------- */

/* Far from rest, in each way that a triangle can be; and what it says. */
static void a_report_says_what_is(void)
{
    for (int law = CUBIC; law <= STABLE; law++)
        for (int k = 0; k < N_CRUSHED; k++) {
            struct mesh *mesh;
            struct body *body = triangle(&mesh, (enum law)law, 1);
            const int point =
                strcmp(RELEASE_CRUSHED[k].name, "point") == 0;
            double u[6] = {0.0}, q[6], energy;
            release_place(body, RELEASE_CRUSHED[k].F, u);
            if (point) u[0] = -corners[0], u[1] = -corners[1];
            const struct release_report report = release_solve(body, 100, u);
            ck_assert_int_eq((int)report.status, point ? SADDLE : OK);
            ck_assert_int_eq(report.recovered, !point);
            ck_assert(point ? report.iterations == 0 : report.iterations > 2);
            body_energy(body, u, &energy);
            body_force(body, u, q);
            close_to(report.energy, energy, 1e-12);
            close_to(report.min_J, point ? 0.0 : 1.0, 1e-6);
            ck_assert(body_max_free(body, q) <=
                      1.01e-9 * material_modulus(&body->material));
            ck_assert(point == (energy > RELEASE_ENERGY));
            body_free(body);
            mesh_free(mesh);
        }
}

/* Cubic with a small nu: swollen, in balance, with less energy than at rest. */
static void swollen_is_not_recovered(void)
{
    struct mesh *mesh = mesh_triangle(corners);
    const int held[3] = {1, 0, 0};
    struct body *body = body_alloc(mesh, material_make(CUBIC, E, 0.05), 0.0,
                                   CONSISTENT, held);
    double u[6] = {0.0};
    release_place(body, RELEASE_CRUSHED[2].F, u);
    const struct release_report report = release_solve(body, 100, u);
    ck_assert_int_eq((int)report.status, OK);
    ck_assert(report.min_J > 3.0 && report.energy < -1.0);
    ck_assert(!report.recovered);
    body_free(body);
    mesh_free(mesh);
}

static void a_cap_and_a_nan_are_named(void)
{
    struct mesh *mesh;
    struct body *body = triangle(&mesh, CUBIC, 1);
    double u[6] = {0.0};
    release_place(body, RELEASE_CRUSHED[2].F, u);
    struct release_report report = release_solve(body, 3, u);
    ck_assert(report.status == MAX_ITERATIONS && report.iterations == 3);
    ck_assert(!report.recovered);
    u[3] = (double)NAN;
    report = release_solve(body, 3, u);
    ck_assert(report.status == NONFINITE && !report.recovered);
    body_free(body);
    mesh_free(mesh);
}

/* The shift is seen on the diagonal of K, and nowhere else. */
static void a_shift_is_on_the_diagonal(void)
{
    struct mesh *mesh;
    struct body *body = triangle(&mesh, CUBIC, 1);
    matrix_zero(body->K);
    release_shift(body);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            close_to(matrix_get(body->K, i, j),
                     i == j ? 1e-8 * material_modulus(&body->material) : 0.0,
                     1e-20);
    body_free(body);
    mesh_free(mesh);
}

/* The outputs of splitmix64 for the seed 1234567, as published with it. */
static void random_places_are_splitmix64(void)
{
    static const unsigned long long z[] = {
        6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
        4593380528125082431u};
    struct mesh *mesh;
    struct body *body = triangle(&mesh, CUBIC, 1);
    double u[6] = {0.371, -0.238};
    release_scramble(body, 1234567, u);
    ck_assert(u[0] == 0.371 && u[1] == -0.238);
    for (int r = 2; r < 6; r++)
        close_to(u[r] + corners[r],
                 2.0 * (double)(z[r - 2] >> 11) / 9007199254740992.0 - 1.0,
                 1e-15);
    body_free(body);
    mesh_free(mesh);
}

/* Six triangles round the middle with angles of 120 degrees: twice round,
 * wherever the whole is. */
static void a_winding_is_counted(void)
{
    struct mesh *mesh = mesh_square(2);
    const int held[9] = {0};
    struct body *body = body_alloc(mesh, odd(CUBIC), 0.0, CONSISTENT, held);
    double u[18] = {0.0};
    close_to(release_winding(body, u), 1.0, 1e-14);
    static const int way[8] = {0, 1, 5, 8, 7, 3, 2, 6};
    for (int k = 0; k < 8; k++) {
        const double angle = k < 6 ? 2.0 * M_PI * k / 3.0 : M_PI;
        const double far = k < 6 ? 1.0 : 3.0, *X = &mesh->X[2 * way[k]];
        u[2 * way[k]] = far * cos(angle) - X[0];
        u[2 * way[k] + 1] = far * sin(angle) - X[1];
    }
    close_to(release_winding(body, u), 2.0, 1e-14);
    ck_assert(body_min_J(body, u) > 0.0);
    for (int r = 0; r < 18; r++) u[r] += r % 2 ? -0.37 : 0.71;
    close_to(release_winding(body, u), 2.0, 1e-14);
    body_free(body);
    mesh_free(mesh);

    body = triangle(&mesh, CUBIC, 1);
    memset(u, 0, sizeof u);
    ck_assert(release_winding(body, u) < 0.5);
    body_free(body);
    mesh_free(mesh);
}

UNIT_MAIN("crushed",
    LAW(every_law_has_its_word),
    LAW(stress_and_tangent_are_derivatives),
    LAW(extended_is_log_above_eps),
    LAW(extended_is_smooth_at_eps),
    LAW(stable_is_linear_in_uniaxial_strain),
    LAW(a_body_takes_every_law),
    LAW(a_triangle_is_a_mesh),
    LAW(work_tells_a_gradient),
    LAW(a_report_says_what_is),
    LAW(swollen_is_not_recovered),
    LAW(a_cap_and_a_nan_are_named),
    LAW(a_shift_is_on_the_diagonal),
    LAW(random_places_are_splitmix64),
    LAW(a_winding_is_counted))
