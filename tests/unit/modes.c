/* modes.c - laws of modes.h, and of what Lecture 3 has in mesh.h, body.h,
 * scene.h, step.h: the column, and balance that is no minimum. */
#include "material/modes.h"
#include "plane/release.h"
#include "plane/scene.h"

#include "unit.h"

#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const mat2 states[] = {
    {{{1.17, 0.23}, {-0.31, 0.88}}}, {{{2.31, 0.19}, {-0.27, 1.43}}},
    {{{0.9, 0.4}, {0.35, -0.6}}},    {{{1.1, 0.5}, {0.44, 0.2}}},
    {{{1.0, 0.0}, {0.0, 1.0}}},      {{{0.6, 0.8}, {0.8, -0.6}}},
    {{{-0.7, 0.0}, {0.0, -0.7}}},    {{{0.0, 0.0}, {0.0, 0.0}}},
    {{{0.0, 1.0}, {1.0, 0.0}}},      {{{0.0, -2.385}, {2.385, 0.0}}},
};

static mat2 basis(int k)
{
    mat2 D = {0};
    D.m[k / 2][k % 2] = 1.0;
    return D;
}

/* C[r][c]: component r of dP for dF = basis(c). */
static void tangent(const struct material *material, mat2 F, double C[4][4])
{
    for (int c = 0; c < 4; c++) {
        const mat2 dP = material2_dpk1(material, F, basis(c));
        for (int r = 0; r < 4; r++) C[r][c] = dP.m[r / 2][r % 2];
    }
}

/* Ascending; C := the same with what is below floor lifted to it. */
static void by_gsl(double C[4][4], double floor, double value[4])
{
    gsl_matrix *A = gsl_matrix_alloc(4, 4), *V = gsl_matrix_alloc(4, 4);
    gsl_vector *d = gsl_vector_alloc(4);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(4);
    for (size_t i = 0; i < 16; i++)
        gsl_matrix_set(A, i / 4, i % 4, C[i / 4][i % 4]);
    gsl_eigen_symmv(A, d, V, work);
    gsl_eigen_symmv_sort(d, V, GSL_EIGEN_SORT_VAL_ASC);
    memset(C, 0, 16 * sizeof(double));
    for (size_t k = 0; k < 4; k++) {
        value[k] = gsl_vector_get(d, k);
        for (size_t i = 0; i < 16; i++)
            C[i / 4][i % 4] += fmax(value[k], floor) *
                               gsl_matrix_get(V, i / 4, k) *
                               gsl_matrix_get(V, i % 4, k);
    }
    gsl_eigen_symmv_free(work);
    gsl_vector_free(d);
    gsl_matrix_free(A);
    gsl_matrix_free(V);
}

static void every_matrix_has_a_signed_svd(void)
{
    for (int k = 0; k < COUNT(states); k++) {
        const struct svd svd = modes_svd(states[k]);
        const mat2 S = {{{svd.s1, 0.0}, {0.0, svd.s2}}};
        const mat2 F =
            mat2_multiply(svd.U, mat2_multiply(S, mat2_transpose(svd.V)));
        close_to(mat2_norm(mat2_subtract(F, states[k])), 0.0, 2e-15);
        close_to(mat2_det(svd.U), 1.0, 1e-14);
        close_to(mat2_det(svd.V), 1.0, 1e-14);
        ck_assert(svd.s1 >= fabs(svd.s2) * (1.0 - 1e-15));
    }
}

static void modes_are_the_eigenvectors(void)
{
    for (int law = LOG; law <= CUBIC; law++)
        for (int k = 0; k < COUNT(states); k++) {
            const struct material m = material_notes((enum law)law);
            double C[4][4], value[4], largest = 1000.0, sum = 0.0, trace = 0.0;
            if (!material_defined(&m, mat2_det(states[k]))) continue;
            const struct modes modes = modes_at(&m, states[k]);
            tangent(&m, states[k], C);
            for (int r = 0; r < 4; r++) trace += C[r][r];
            by_gsl(C, -INFINITY, value);
            for (int r = 0; r < 4; r++)
                largest = fmax(largest, fabs(value[r])), sum += modes.value[r];
            close_to(sum, trace, 1e-14 * 4.0 * largest);
            ck_assert(modes.value[MODE_LOW] <= modes.value[MODE_HIGH]);
            for (int r = 0; r < 4; r++) {
                const mat2 D = modes.direction[r];
                const mat2 dP = material2_dpk1(&m, states[k], D);
                const mat2 rest =
                    mat2_subtract(dP, mat2_scale(modes.value[r], D));
                close_to(mat2_norm(rest), 0.0, 1e-14 * largest);
                for (int s = 0; s < 4; s++)
                    close_to(mat2_dot(D, modes.direction[s]), r == s, 1e-14);
            }
        }
}

static void projected_stress_clamps_the_eigenvalues(void)
{
    for (int k = 0; k < COUNT(states); k++) {
        const struct material m = material_notes(CUBIC);
        const struct modes modes = modes_at(&m, states[k]);
        double C[4][4], value[4];
        tangent(&m, states[k], C);
        by_gsl(C, 0.0, value);
        for (int c = 0; c < 4; c++) {
            const mat2 dP = modes_dpk1(&modes, basis(c));
            for (int r = 0; r < 4; r++)
                close_to(dP.m[r / 2][r % 2], C[r][c],
                         1e-13 * (1000.0 + fabs(value[3])));
        }
    }
}

/* ---- the column ---------------------------------------------------------- */

static void a_rectangle_fills_its_box(void)
{
    struct mesh *mesh = mesh_rectangle(3, 5, 2.0, 0.25);
    double area = 0.0, gradient[6];
    ck_assert_int_eq(mesh->n_vertex, 24);
    ck_assert_int_eq(mesh->n_triangle, 30);
    ck_assert_int_eq(mesh_clockwise(mesh), -1);
    for (int e = 0; e < mesh->n_triangle; e++) {
        const double share = mesh_gradients(mesh, e, gradient);
        close_to(share, 2.0 / 30.0, 1e-15);
        area += share;
    }
    close_to(area, 2.0, 1e-14);
    for (int a = 0; a < 24; a++) {
        close_to(mesh->X[2 * a], -2.0 + 4.0 / 3.0 * (a % 4), 1e-15);
        close_to(mesh->X[2 * a + 1], -0.25 + 0.1 * (a / 4), 1e-15);
    }
    mesh_free(mesh);
}

static struct scene *column(double e)
{
    const struct scene_setting set = scene_column(CUBIC, 80, e);
    struct scene *scene = scene_alloc(&set);
    scene_hold(scene, acos(0.0));
    return scene;
}

static void a_column_is_numbered_across(void)
{
    struct scene *scene = column(0.036);
    ck_assert_int_eq(scene->body->n_equation, 2 * 79 * 9);
    ck_assert_int_eq(scene->body->K->p, 2 * 8 + 3);
    for (int a = 0; a < scene->mesh->n_vertex; a++)
        if (a % 81 == 0 || a % 81 == 80) {
            ck_assert_int_eq(scene->body->equation[2 * a], -1);
            close_to(scene->g[2 * a], a % 81 ? -0.036 : 0.036, 1e-15);
        }
    scene_free(scene);
}

static void the_lift_goes_through_a_column(void)
{
    struct scene *scene = column(0.036);
    step_boundary(scene->body, scene->g, 1, scene->u);
    for (int a = 0; a < scene->mesh->n_vertex; a++) {
        close_to(scene->u[2 * a], -0.036 * scene->mesh->X[2 * a], 1e-15);
        close_to(scene->u[2 * a + 1], 0.0, 1e-15);
    }
    for (int e = 0; e < scene->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(scene->body, scene->u, e);
        const mat2 want = {{{1.0 - 0.036, 0.0}, {0.0, 1.0}}};
        close_to(mat2_norm(mat2_subtract(F, want)), 0.0, 1e-13);
    }
    scene_free(scene);
}

static void a_column_is_pressed_and_pushed(void)
{
    struct scene *scene = column(0.0);
    for (int r = 0; r < scene->n_dof; r++)
        scene->u[r] = scene->v[r] = scene->v_before[r] = sin(r + 1.0);
    scene->steps = 7;
    scene_rest(scene);
    ck_assert_int_eq(scene->steps, 0);
    scene_press(scene, 0.036, 0.007);
    for (int a = 0; a < scene->mesh->n_vertex; a++) {
        const double X = scene->mesh->X[2 * a], half = cos(acos(0.0) * X);
        close_to(scene->u[2 * a], -0.036 * X, 1e-15);
        close_to(scene->u[2 * a + 1], 0.007 * half * half, 1e-15);
        close_to(scene->v[2 * a], 0.0, 1e-15);
        close_to(scene->v_before[2 * a + 1], 0.0, 1e-15);
    }
    scene_press(scene, 0.05, 0.0); /* on from there */
    for (int a = 0; a < scene->mesh->n_vertex; a++) {
        const double X = scene->mesh->X[2 * a], half = cos(acos(0.0) * X);
        close_to(scene->u[2 * a], -0.05 * X, 1e-15);
        close_to(scene->u[2 * a + 1], 0.007 * half * half, 1e-15);
    }
    scene_free(scene);
}

static void traction_pulls_a_column_by_its_end(void)
{
    struct scene_setting set = scene_column(CUBIC, 40, 0.0);
    ck_assert(set.rho == 0.0 && set.dt == 1.0); /* quasistatic */
    set.reading = TRACTION;
    set.force = 10.0;
    struct scene *scene = scene_alloc(&set);
    double sum[2] = {0.0, 0.0};
    for (int r = 0; r < scene->n_dof; r++) sum[r % 2] += scene->f[r];
    close_to(sum[0], 0.8 * 10.0 * 0.2, 1e-14); /* the end is 0.2 m high */
    close_to(sum[1], -0.6 * 10.0 * 0.2, 1e-14);
    scene_free(scene);
}

/* Straight columns: energies and definiteness of an independent computation
 * (double precision, scipy). */
/* With a direction that is ten times too long the length is an eighth, or
 * less; the energy is lower; uphill nothing is found. */
static void a_search_goes_down_the_line(void)
{
    struct scene *scene = column(0.02);
    double *q = allocate(2 * (size_t)scene->n_dof, sizeof *q), before, after;
    double *du = q + scene->n_dof;
    scene_press(scene, 0.02, 1e-3);
    body_assemble(scene->body, at_rest(NULL), scene->u, PROJECTED, q);
    ck_assert_int_eq(body_increment(scene->body, scene->body->K, q, du), OK);
    for (int r = 0; r < scene->n_dof; r++) du[r] *= 10.0;
    body_energy(scene->body, scene->u, &before);
    ck_assert_int_eq(step_search(scene->body, at_rest(NULL), q, du,
                                 scene->u), OK);
    body_energy(scene->body, scene->u, &after);
    ck_assert(after < before - 1e-6);
    body_assemble(scene->body, at_rest(NULL), scene->u, NO_TANGENT, q);
    for (int r = 0; r < scene->n_dof; r++) du[r] = 1e-3 * q[r];
    for (int a = 0; a < scene->mesh->n_vertex; a++)
        if (scene->held[a]) du[2 * a] = du[2 * a + 1] = 0.0;
    ck_assert_int_eq(step_search(scene->body, at_rest(NULL), q, du,
                                 scene->u), NOT_SPD);
    /* nor where q lies, and Phi rises at every length */
    for (int r = 0; r < scene->n_dof; r++) q[r] = -q[r], du[r] *= 1e9;
    ck_assert_int_eq(step_search(scene->body, at_rest(NULL), q, du,
                                 scene->u), STALLED);
    free(q);
    scene_free(scene);
}

/* Along du Phi falls, and rises again: a du that ends where it has fallen by
 * half of what is asked for, 1e-4 of the slope, is halved.  Of the first
 * unknown alone, or of the last. */
static void a_step_that_hardly_falls_is_halved(void)
{
    const struct scene_setting set = scene_notes(SPIN, CUBIC, 2);
    struct scene *s = scene_alloc(&set);
    for (int r = 0; r < s->n_dof; r += s->n_dof - 1) {
        double q[100], du[100] = {0.0}, u[100] = {0.0}, before, after;
        double low = 0.0, high = 3.0;
        u[r] = 1e-2;
        body_energy(s->body, u, &before);
        body_assemble(s->body, at_rest(NULL), u, NO_TANGENT, q);
        while (high - low > 1e-12) {
            const double length = 0.5 * (low + high);
            u[r] = 1e-2 * (1.0 - length);
            body_energy(s->body, u, &after);
            if (after - before < -0.5e-4 * length * 1e-2 * q[r]) low = length;
            else high = length;
        }
        u[r] = 1e-2;
        du[r] = -1e-2 * low;
        ck_assert_int_eq(step_search(s->body, at_rest(NULL), q, du, u), OK);
        close_to(u[r], 1e-2 + 0.5 * du[r], 1e-15);
    }
    scene_free(s);
}

/* A body that has turned by 1 and is strained by 1e-3 has an energy that is the
 * small sum of large terms: an increment of 1e-11, which changes Phi by less
 * than its round-off, is taken whole all the same, from wherever it comes. */
static void round_off_does_not_stop_a_search(void)
{
    const struct scene_setting set = scene_notes(SPIN, CUBIC, 24);
    struct scene *s = scene_alloc(&set);
    double *q = allocate(3 * (size_t)s->n_dof, sizeof *q);
    double *du = q + s->n_dof, *u = du + s->n_dof;
    const mat2 F = {{{1.001 * cos(1.0), -sin(1.0)}, {sin(1.0), cos(1.0)}}};
    unsigned long seed = 1;
    for (int k = 0; k < 20; k++) {
        release_place(s->body, F, u);
        for (int r = 0; r < s->n_dof; r++) {
            seed = (1103515245 * seed + 12345) % 2147483648;
            du[r] = 1e-11 * ((double)seed / 1073741824.0 - 1.0);
            q[r] = -1e-9 * du[r];
        }
        const double to = u[7] + du[7];
        ck_assert_int_eq(step_search(s->body, at_rest(NULL), q, du, u), OK);
        ck_assert(u[7] == to);
    }
    /* a long one, along which Phi seems to be flat, is not */
    for (int r = 0; r < s->n_dof; r++) du[r] *= 1e10, q[r] = -1e-15 * du[r];
    const double before = u[7];
    ck_assert_int_eq(step_search(s->body, at_rest(NULL), q, du, u), OK);
    ck_assert(fabs(u[7] - before) < 0.1 * fabs(du[7]));
    free(q);
    scene_free(s);
}

/* A column that is bent by less than a millimetre is pushed, to the other side
 * here; any other goes as if nobody pushed. */
static void what_is_straight_is_pushed(void)
{
    static const double bent[] = {0.6e-3, 0.9e-3, 1.1e-3, 1.9e-3};
    for (int k = 0; k < COUNT(bent); k++) {
        struct scene *scene[2];
        for (int pushed = 0; pushed < 2; pushed++) {
            const struct scene_setting set = scene_column(CUBIC, 20, 0.15);
            scene[pushed] = scene_alloc(&set);
            scene_hold(scene[pushed], acos(0.0));
            scene_press(scene[pushed], 0.0, bent[k]);
            close_to(*scene_middle(scene[pushed]), bent[k], 1e-15);
            scene_walk(scene[pushed], "demand+search", 0.15,
                       pushed ? -0.2 : 0.0);
        }
        const double free_ = *scene_middle(scene[0]);
        const double pushed = *scene_middle(scene[1]);
        if (bent[k] > 1e-3) ck_assert_double_eq(pushed, free_);
        else ck_assert(free_ > 0.01 && pushed < -0.01);
        scene_free(scene[0]);
        scene_free(scene[1]);
    }
}

static void converged_is_not_stable(void)
{
    const struct {
        double e, energy;
        enum status status;
    } rows[] = {{0.02, 0.08946751336471621, OK},
                {0.036, 0.2926138038403667, SADDLE},
                {0.05, 0.5691969891988555, SADDLE}};
    const struct step_control plain = step_method("notes");
    for (int k = 0; k < COUNT(rows); k++) {
        struct scene *scene = column(rows[k].e);
        double energy;
        step_boundary(scene->body, scene->g, 1, scene->u);
        const struct step_report report =
            step_solve(scene->body, &plain, at_rest(NULL), scene->u);
        ck_assert_int_eq(report.status, OK);
        body_energy(scene->body, scene->u, &energy);
        close_to(energy, rows[k].energy, 1e-12);
        ck_assert_int_eq(step_certify(scene->body, at_rest(NULL), scene->u),
                         rows[k].status);
        scene->u[scene->n_dof / 2] = NAN;
        ck_assert_int_eq(step_certify(scene->body, at_rest(NULL), scene->u),
                         NONFINITE);
        scene_free(scene);
    }
    ck_assert_str_eq(status_name(SADDLE), "SADDLE");
}

/* The energies of another program; 10 m would be a push to remember. */
static void a_column_walks_on(void)
{
    struct scene *scene = column(0.0);
    const double *middle = scene_middle(scene);
    const double *at = &scene->mesh->X[middle - scene->u - 1];
    ck_assert(fabs(at[0]) < 1e-15 && fabs(at[1]) < 1e-15);
    ck_assert_int_eq(scene_walk(scene, "notes", 0.04, 0.0).status, SADDLE);
    close_to(*middle, 0.0, 1e-9);
    ck_assert_int_eq(scene_walk(scene, "demand+search", 0.04, 1e-3).status, OK);
    close_to(fabs(*middle), 0.10107347482842402, 1e-6);
    close_to(scene_energy(scene), 0.35422048584304616, 1e-11);
    ck_assert_int_eq(scene_walk(scene, "demand+search", 0.05, 10.0).status, OK);
    close_to(scene_energy(scene), 0.5104410137736349, 1e-11);
    scene_free(scene);

    const struct scene_setting set = scene_notes(STRETCH, LOG, 2);
    scene = scene_alloc(&set);
    for (int r = 0; r < scene->n_dof; r += 2)
        scene->u[r] = -1.5 * scene->mesh->X[r];
    ck_assert(isinf(scene_energy(scene)));
    scene_free(scene);
}

UNIT_MAIN("modes",
    LAW(every_matrix_has_a_signed_svd),
    LAW(modes_are_the_eigenvectors),
    LAW(projected_stress_clamps_the_eigenvalues),
    LAW(a_rectangle_fills_its_box),
    LAW(a_column_is_numbered_across),
    LAW(the_lift_goes_through_a_column),
    LAW(a_column_is_pressed_and_pushed),
    LAW(traction_pulls_a_column_by_its_end),
    LAW(a_search_goes_down_the_line),
    LAW(round_off_does_not_stop_a_search),
    LAW(a_step_that_hardly_falls_is_halved),
    LAW(what_is_straight_is_pushed),
    LAW(converged_is_not_stable),
    LAW(a_column_walks_on))
