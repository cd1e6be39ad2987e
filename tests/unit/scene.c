/* scene.c - laws of common/plane/scene.h and of the doors of body.h. */
#include "figures/13_backward_euler_2d/corners.h"
#include "figures/speed/readable.h"
#include "plane/scene.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers without a pattern, in (-1, 1). */
static double entropy(int i) { return sin(2.385 * i * i + 3.714 * i + 0.7); }

static struct scene *scene_of(enum reading reading, enum law law, int n)
{
    const struct scene_setting set = scene_notes(reading, law, n);
    return scene_alloc(&set);
}

static double *vector(const struct scene *scene, double size)
{
    double *v = allocate((size_t)scene->n_dof, sizeof *v);
    for (int r = 0; r < scene->n_dof; r++) v[r] = size * entropy(r);
    return v;
}

/* ---- scenes ------------------------------------------------------------- */

/* Column: reading; g at X1 = -1 and X1 = 1, in units of reach. */
static void ends_move_as_the_words_say(void)
{
    const double t = 0.7, s = sin(t);
    const double want[8][2][2] = {
        [RIGID] = {{s, 0}, {s, 0}},     [BOTH] = {{s, s}, {s, s}},
        [STRETCH] = {{-s, 0}, {s, 0}},  [COMPRESS] = {{s, 0}, {-s, 0}},
        [STEADY] = {{t * sin(1), 0}, {t * sin(1), 0}}};
    for (int reading = RIGID; reading <= SPIN; reading++) {
        struct scene_setting set = scene_notes((enum reading)reading, CUBIC, 3);
        set.reach = 2.385;
        struct scene *scene = scene_alloc(&set);
        const int n_held[] = {8, 8, 8, 8, 8, 4, 4, 0};
        int held = 0;
        scene_hold(scene, t);
        for (int a = 0; a < scene->mesh->n_vertex; a++) {
            const int right = scene->mesh->X[2 * a] > 0.0;
            held += scene->held[a];
            ck_assert(!scene->held[a] ||
                      fabs(fabs(scene->mesh->X[2 * a]) - 1.0) < 1e-15);
            for (int i = 0; i < 2; i++)
                close_to(scene->g[2 * a + i],
                         scene->held[a] ? 2.385 * want[reading][right][i] : 0,
                         1e-14);
        }
        ck_assert_int_eq(held, n_held[reading]);
        scene_free(scene);
    }
}

/* Forces of a constant density and traction: their sums and their torque about
 * the origin are the integrals, whatever n is. */
static void nodal_forces_add_up_to_the_loads(void)
{
    for (int n = 1; n <= 7; n += 3)
        for (int reading = GRAVITY; reading <= SPIN; reading++) {
            struct scene *scene = scene_of((enum reading)reading, LOG, n);
            const double want[3][3] = {{0.0, -200.0, 0.0},
                                       {80.0, -60.0, -60.0}, {0.0, 0.0, 0.0}};
            double sum[3] = {0.0, 0.0, 0.0};
            for (int r = 0; r < scene->n_dof; r++) {
                const double X = scene->mesh->X[r % 2 ? r - 1 : r + 1];
                sum[r % 2] += scene->f[r];
                sum[2] += r % 2 ? X * scene->f[r] : -X * scene->f[r];
            }
            for (int k = 0; k < 3; k++)
                close_to(sum[k], want[reading - GRAVITY][k], 1e-12);
            scene_free(scene);
        }
}

/* ... of both elements, graded or not: the traction has the lengths that the
 * edges have then. */
static void elements_and_grading_keep_the_loads(void)
{
    for (int k = 0; k < 4; k++)
        for (int reading = GRAVITY; reading <= TRACTION; reading++) {
            struct scene_setting set =
                scene_notes((enum reading)reading, LOG, 16);
            set.element = k % 2 ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE;
            set.grade = k / 2 ? 2.0 : 1.0;
            struct scene *scene = scene_alloc(&set);
            const int corner = 16, middle = 17 + 16; /* of the right end */
            double sum[2] = {0.0, 0.0}, bent = 0.0;
            for (int r = 0; r < scene->n_dof; r++) {
                const double Y = scene->mesh->X[r / 2 * 2 + 1];
                sum[r % 2] += scene->f[r];
                if (r % 2 == 0) bent += Y * Y * scene->f[r];
            }
            const int pulled = reading == TRACTION;
            close_to(sum[0], pulled ? 80.0 : 0.0, 1e-12);
            close_to(sum[1], pulled ? -60.0 : -200.0, 1e-12);
            /* 40 int Y^2 dY: exact by Simpson's rule */
            if (pulled && k % 2) close_to(bent, 40.0 * 2.0 / 3.0, 1e-12);
            /* the first edge: 1/8, graded (1/4)^2 / 2; or two cells of it */
            const double first[4] = {0.125, 0.25, 0.03125, 0.125};
            const double share[4] = {0.5, 1.0 / 6, 0.5, 1.0 / 6};
            if (pulled)
                close_to(scene->f[2 * corner], 40.0 * first[k] * share[k],
                         1e-13);
            if (!pulled && k % 2) ck_assert(scene->f[2 * corner + 1] == 0.0);
            if (k == 3) /* the middle of a straight edge */
                close_to(scene->mesh->X[2 * middle + 1], -0.9375, 1e-15);
            scene_free(scene);
        }
}

/* Steps of every scene with quadratic triangles, graded: OK, and near those of
 * linear ones at the middle of the right side. */
static void every_scene_runs_with_quadratic_triangles(void)
{
    for (int reading = RIGID; reading <= SPIN; reading++) {
        double u[2][2];
        for (int k = 0; k < 2; k++) {
            struct scene_setting set =
                scene_notes((enum reading)reading, CUBIC, k ? 8 : 16);
            set.reach = 0.3;
            set.element = k ? QUADRATIC_TRIANGLE : LINEAR_TRIANGLE;
            set.grade = k ? 1.5 : 1.0;
            struct scene *scene = scene_alloc(&set);
            const struct step_control control = {
                .tolerance = 1e-10, .max_iterations = 20,
                .guess = FROM_VELOCITY, .lift = 1, .line_search = 1,
                .projection = ON_DEMAND};
            ck_assert_int_eq(scene->body->element, set.element);
            for (int step = 0; step < 6; step++)
                ck_assert_int_eq(scene_step(scene, &control).status, OK);
            const double *middle = scene_middle(scene) - 1;
            for (int i = 0; i < 2; i++) u[k][i] = middle[i];
            ck_assert(scene_measure(scene).min_J > 0.0);
            scene_free(scene);
        }
        for (int i = 0; i < 2; i++) close_to(u[1][i], u[0][i], 0.01);
    }
}

/* A jump of the ends carried on linearly in X1, whatever the cells are. */
static void the_lift_goes_by_place(void)
{
    struct scene_setting set = scene_notes(STRETCH, CUBIC, 8);
    set.grade = 2.0;
    struct scene *scene = scene_alloc(&set);
    scene_hold(scene, 0.3);
    step_boundary(scene->body, scene->g, 1, scene->u);
    for (int a = 0; a < scene->mesh->n_vertex; a++)
        close_to(scene->u[2 * a], sin(0.3) * scene->mesh->X[2 * a], 1e-14);
    scene_free(scene);
}

/* The mass matrix integrates a linear velocity exactly: M v.v = int |v|^2. */
static void a_spin_starts_with_its_energy_and_momenta(void)
{
    struct scene *scene = scene_of(SPIN, CUBIC, 5);
    struct scene_measures m = scene_measure(scene);
    close_to(m.kinetic, 0.5 * (4.0 * 0.05 + 36.0 * 8.0 / 3.0), 1e-12);
    close_to(m.elastic, 0.0, 1e-12);
    close_to(m.momentum[0], 0.8, 1e-13);
    close_to(m.momentum[1], 0.4, 1e-13);
    close_to(m.angular, 6.0 * 8.0 / 3.0, 1e-12);
    close_to(m.min_J, 1.0, 1e-14);
    const struct step_control control = {
        .tolerance = 1e-12, .max_iterations = 20, .guess = FROM_VELOCITY,
        .lift = 1};
    for (int k = 0; k < 3; k++)
        ck_assert_int_eq(scene_step(scene, &control).status, OK);
    ck_assert_int_eq(scene->steps, 3);
    m = scene_measure(scene);
    close_to(m.momentum[0], 0.8, 1e-10); /* no force from outside */
    close_to(m.momentum[1], 0.4, 1e-10);
    ck_assert_double_eq(m.external, 0.0);
    scene_free(scene);
}

/* x = F X + c turning as it is, v = 6 (-x2, x1): int |x|^2 = 4/3 F:F + 4 |c|^2
 * on the square, and int f.u = f.c, both exactly. */
static void measures_are_the_integrals(void)
{
    const double F[2][2] = {{0.8714, 0.2385}, {-0.1371, 1.1238}};
    const double c[2] = {0.37, -0.731};
    struct scene *scene = scene_of(GRAVITY, CUBIC, 3);
    double squares = 4.0 * (c[0] * c[0] + c[1] * c[1]);
    for (int r = 0; r < 4; r++)
        squares += 4.0 / 3.0 * F[r / 2][r % 2] * F[r / 2][r % 2];
    for (int r = 0; r < scene->n_dof; r++) {
        const double *X = &scene->mesh->X[r / 2 * 2];
        const double x = F[r % 2][0] * X[0] + F[r % 2][1] * X[1] + c[r % 2];
        scene->u[r] = x - X[r % 2];
        scene->v[r % 2 ? r - 1 : r + 1] = r % 2 ? -6.0 * x : 6.0 * x;
    }
    const struct scene_measures m = scene_measure(scene);
    close_to(m.angular, 6.0 * squares, 1e-12);
    close_to(m.kinetic, 18.0 * squares, 1e-12);
    close_to(m.momentum[0], -24.0 * c[1], 1e-12);
    close_to(m.momentum[1], 24.0 * c[0], 1e-12);
    close_to(m.external, 200.0 * c[1], 1e-11);
    close_to(m.min_J, F[0][0] * F[1][1] - F[0][1] * F[1][0], 1e-14);
    scene_free(scene);
}

static void a_step_that_fails_is_not_counted(void)
{
    struct scene *scene = scene_of(RIGID, LOG, 8);
    const struct step_control none = {.tolerance = 1e-12, .max_iterations = 0};
    ck_assert_int_eq(scene_step(scene, &none).status, MAX_ITERATIONS);
    ck_assert_int_eq(scene->steps, 0);
    for (int r = 0; r < scene->n_dof; r++)
        ck_assert_double_eq(scene->u[r], 0.0);
    scene_free(scene);
}

/* An affine map: the same J everywhere, and corners where the map puts them. */
static void triangles_are_where_the_map_puts_them(void)
{
    struct scene *scene = scene_of(SPIN, CUBIC, 3);
    const double F[2][2] = {{0.8714, 0.2385}, {-0.1371, 1.1238}};
    const double *X = scene->mesh->X;
    for (int r = 0; r < scene->n_dof; r++)
        scene->u[r] = F[r % 2][0] * X[r / 2 * 2] +
                      F[r % 2][1] * X[r / 2 * 2 + 1] - X[r] + 0.37 * (r % 2);
    for (int e = 0; e < scene->mesh->n_triangle; e++) {
        const int *t = &scene->mesh->triangle[3 * e];
        double x[6];
        close_to(corners_of(scene, e, x), 0.8714 * 1.1238 + 0.2385 * 0.1371,
                 1e-14);
        for (int r = 0; r < 6; r++)
            close_to(x[r], F[r % 2][0] * X[2 * t[r / 2]] +
                           F[r % 2][1] * X[2 * t[r / 2] + 1] + 0.37 * (r % 2),
                     1e-14);
    }
    scene_free(scene);
}

/* ---- doors of the body --------------------------------------------------- */

/* The force is the gradient of the energy, the stiffness that of the force:
 * central differences along a direction, steps where both errors are small. */
static void force_and_stiffness_are_derivatives(void)
{
    const double step = 1e-5;
    for (int law = LOG; law <= CUBIC; law++) {
        struct scene *scene = scene_of(TRACTION, (enum law)law, 4);
        const struct body *body = scene->body;
        const size_t free_size = (size_t)body->n_equation;
        double *u = vector(scene, 0.03), *move = vector(scene, 0.5);
        double *q[3], energy[2], slope = 0.0;
        double *d = allocate(3 * free_size, sizeof *d);
        double *Kd = d + free_size, *dq = Kd + free_size;
        struct matrix *K = body_matrix(body);

        for (int k = 0; k < 3; k++) q[k] = vector(scene, 0.0);
        for (int r = 0; r < scene->n_dof; r++)
            if (scene->held[r / 2]) move[r] = 0.0;
        ck_assert_int_eq(body_force(body, u, q[2]), OK);
        ck_assert_int_eq(body_stiffness(body, u, EXACT, K), OK);
        for (int k = 0; k < 2; k++) {
            for (int r = 0; r < scene->n_dof; r++)
                u[r] += (k ? 2.0 : -1.0) * step * move[r];
            ck_assert_int_eq(body_energy(body, u, &energy[k]), OK);
            ck_assert_int_eq(body_force(body, u, q[k]), OK);
        }
        for (int r = 0; r < scene->n_dof; r++) {
            slope += q[2][r] * move[r];
            q[1][r] = (q[1][r] - q[0][r]) / (2.0 * step);
        }
        close_to((energy[1] - energy[0]) / (2.0 * step), slope,
                 1e-6 * fabs(slope)); /* step^2 and eps / step */
        body_gather(body, move, d);
        body_gather(body, q[1], dq);
        matrix_multiply(K, d, Kd);
        for (size_t i = 0; i < free_size; i++) close_to(dq[i], Kd[i], 1e-3);
        matrix_free(K);
        for (int k = 0; k < 3; k++) free(q[k]);
        free(u), free(move), free(d);
        scene_free(scene);
    }
}

static void doors_equal_the_assembly(void)
{
    struct scene *scene = scene_of(STRETCH, CUBIC, 5);
    struct body *body = scene->body;
    double *u = vector(scene, 0.03), *q = vector(scene, 0.0);
    double *w = vector(scene, 0.0), *inertia = vector(scene, 0.0);
    double *whole = vector(scene, 0.0);
    struct matrix *K = body_matrix(body), *M = body_matrix(body);
    const double dt = 0.2385;

    ck_assert_int_eq(body_force(body, u, q), OK);
    ck_assert_int_eq(body_stiffness(body, u, EXACT, K), OK);
    body_mass_matrix(body, M);
    body_mass(body, u, inertia);
    const struct incremental Phi = {dt, w, NULL};
    ck_assert_int_eq(body_assemble(body, Phi, u, EXACT, whole), OK);
    for (int r = 0; r < scene->n_dof; r++)
        close_to(whole[r], inertia[r] + dt * dt * q[r], 1e-12);
    matrix_combine(M, dt * dt, K, K);
    for (int i = 0; i < K->n; i++)
        for (int j = 0; j <= i; j++)
            close_to(matrix_get(K, i, j), matrix_get(body->K, i, j), 1e-11);
    matrix_free(K), matrix_free(M);
    free(u), free(q), free(w), free(inertia), free(whole);
    scene_free(scene);
}

static void gather_and_scatter_are_inverse(void)
{
    struct scene *scene = scene_of(TRACTION, CUBIC, 4);
    const struct body *body = scene->body;
    double *v = vector(scene, 1.0), *back = vector(scene, 7.0);
    double *p = vector(scene, 0.0), *Mv = vector(scene, 0.0);
    double *some = allocate(2 * (size_t)body->n_equation, sizeof *some);
    double *M_some = some + body->n_equation;
    struct matrix *M = body_matrix(body);

    body_gather(body, v, some);
    body_scatter(body, some, back);
    for (int r = 0; r < scene->n_dof; r++)
        ck_assert_double_eq(back[r], scene->held[r / 2] ? 0.0 : v[r]);
    /* M of the free unknowns is that of the whole where the rest is 0 */
    body_mass_matrix(body, M);
    matrix_multiply(M, some, M_some);
    body_scatter(body, M_some, Mv);
    body_mass(body, back, p);
    for (int r = 0; r < scene->n_dof; r++)
        if (!scene->held[r / 2]) close_to(Mv[r], p[r], 1e-14);
    matrix_free(M);
    free(v), free(back), free(some), free(p), free(Mv);
    scene_free(scene);
}

/* A du = -q where the vertices are free, du = 0 where they are held. */
static void an_increment_solves_the_free_system(void)
{
    struct scene *scene = scene_of(TRACTION, CUBIC, 3);
    const struct body *body = scene->body;
    double *q = vector(scene, 1.0), *du = vector(scene, 3.0);
    double *d = allocate(2 * (size_t)body->n_equation, sizeof *d);
    double *Ad = d + body->n_equation;
    struct matrix *A = body_matrix(body), *copy;

    ck_assert_int_eq(body_stiffness(body, scene->u, EXACT, A), OK);
    copy = matrix_copy(A);
    ck_assert_int_eq(body_increment(body, copy, q, du), OK);
    body_gather(body, du, d);
    matrix_multiply(A, d, Ad);
    body_gather(body, q, d);
    for (int k = 0; k < A->n; k++) close_to(Ad[k], -d[k], 1e-12);
    for (int r = 0; r < scene->n_dof; r++)
        if (scene->held[r / 2]) ck_assert_double_eq(du[r], 0.0);
    matrix_combine(A, -2.0, A, A); /* -A */
    ck_assert_int_eq(body_increment(body, A, q, du), NOT_SPD);
    matrix_free(A), matrix_free(copy);
    free(q), free(du), free(d);
    scene_free(scene);
}

static void the_largest_free_component_is_found(void)
{
    struct scene *scene = scene_of(TRACTION, CUBIC, 3); /* vertex 0 is held */
    double *v = vector(scene, 0.5);
    v[0] = 7.0;
    v[11] = -2.385;
    ck_assert_double_eq(body_max_free(scene->body, v), 2.385);
    v[12] = -INFINITY;
    ck_assert_double_eq(body_max_free(scene->body, v), INFINITY);
    v[12] = NAN;
    ck_assert_double_eq(body_max_free(scene->body, v), INFINITY);
    v[12] = 0.0;
    v[0] = NAN;
    ck_assert_double_eq(body_max_free(scene->body, v), 2.385);
    free(v);
    scene_free(scene);
}

static void doors_report_states_outside(void)
{
    struct scene *scene = scene_of(TRACTION, LOG, 2);
    double *u = vector(scene, 5.0), *q = vector(scene, 0.0);
    struct matrix *K = body_matrix(scene->body);
    ck_assert_int_eq(body_force(scene->body, u, q), INVERTED);
    ck_assert_int_eq(body_stiffness(scene->body, u, EXACT, K), INVERTED);
    u[3] = NAN;
    ck_assert_int_eq(body_force(scene->body, u, q), NONFINITE);
    matrix_free(K);
    free(u), free(q);
    scene_free(scene);
}

/* ---- the readable program ------------------------------------------------ */

static void the_readable_step_finds_the_same_u(void)
{
    const struct step_control notes = step_method("notes");
    struct scene *s = scene_of(STRETCH, CUBIC, 5);
    struct readable *r = readable_alloc(s->body, s->set.dt);
    double *u = vector(s, 0.0), *v = vector(s, 0.0);
    for (int step = 1; step <= 3; step++) {
        const struct step_report fast = scene_step(s, &notes);
        const struct step_report slow =
            readable_step(r, readable_gsl, s->g, u, v);
        ck_assert(fast.status == OK && slow.status == OK);
        ck_assert_int_eq(slow.iterations, fast.iterations);
        for (int i = 0; i < s->n_dof; i++) {
            close_to(u[i], s->u[i], 1e-12);
            close_to(v[i], s->v[i], 1e-10);
        }
    }
    readable_free(r);
    free(u), free(v);
    scene_free(s);
}

/* Its band ends where its entries end, and of what is held it has the identity,
 * which is its own Cholesky factor. */
static void the_readable_system_is_banded_and_corrected(void)
{
    struct scene *s = scene_of(STRETCH, CUBIC, 3);
    struct readable *r = readable_alloc(s->body, s->set.dt);
    double *u = vector(s, 0.01), *du = vector(s, 1.0);
    const int width = r->width;
    int widest = 0;
    readable_assemble(r, s->v, s->u); /* at rest */
    for (int i = 0; i < s->n_dof; i++) ck_assert(r->q[i] == 0.0);
    readable_assemble(r, s->v, u);
    for (int k = 0; k < s->n_dof * width; k++)
        if (r->K[k] != 0.0 && k % width > widest) widest = k % width;
    ck_assert_int_eq(widest, width - 1);
    for (int d = 1; d < width; d++) /* below the last row */
        ck_assert(r->K[(s->n_dof - d) * width + d] == 0.0);
    ck_assert(readable_gsl(r, s->v, u, du));
    for (int i = 0; i < s->n_dof; i++) {
        if (!s->held[i / 2]) continue;
        ck_assert(du[i] == 0.0 && r->K[i * width] == 1.0);
        for (int d = 1; d < width; d++) {
            if (i + d < s->n_dof) ck_assert(r->K[i * width + d] == 0.0);
            if (d <= i) ck_assert(r->K[(i - d) * width + d] == 0.0);
        }
    }
    readable_free(r);
    free(u), free(du);
    scene_free(s);
}

/* It stops where K is not positive definite, and leaves the state alone. */
static void the_readable_step_stops_at_an_indefinite_K(void)
{
    struct scene *s = scene_of(COMPRESS, CUBIC, 4);
    struct readable *r = readable_alloc(s->body, s->set.dt);
    double *u = vector(s, 0.0), *v = vector(s, 0.0);
    scene_hold(s, 1.2); /* all of it in one step */
    ck_assert_int_eq(readable_step(r, readable_gsl, s->g, u, v).status,
                     NOT_SPD);
    for (int i = 0; i < s->n_dof; i++) ck_assert(u[i] == 0.0 && v[i] == 0.0);
    readable_free(r);
    free(u), free(v);
    scene_free(s);
}

UNIT_MAIN("scene",
    LAW(ends_move_as_the_words_say),
    LAW(nodal_forces_add_up_to_the_loads),
    LAW(elements_and_grading_keep_the_loads),
    LAW(every_scene_runs_with_quadratic_triangles),
    LAW(the_lift_goes_by_place),
    LAW(a_spin_starts_with_its_energy_and_momenta),
    LAW(measures_are_the_integrals),
    LAW(a_step_that_fails_is_not_counted),
    LAW(triangles_are_where_the_map_puts_them),
    LAW(force_and_stiffness_are_derivatives),
    LAW(doors_equal_the_assembly),
    LAW(gather_and_scatter_are_inverse),
    LAW(an_increment_solves_the_free_system),
    LAW(the_largest_free_component_is_found),
    LAW(doors_report_states_outside),
    LAW(the_readable_step_finds_the_same_u),
    LAW(the_readable_system_is_banded_and_corrected),
    LAW(the_readable_step_stops_at_an_indefinite_K))
