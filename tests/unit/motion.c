/* motion.c - quadratic triangles in motion: laws of model.h, integrate.h and
 * live.h. */
#include "figures/14_time_step/frequency.h"
#include "figures/14_time_step/swing.h"
#include "motion/live.h"

#include "unit.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The square, its left side held; for forget(). */
static struct model *square(int n, enum law law)
{
    struct mesh *mesh = mesh_square(n);
    int *held = allocate((size_t)mesh->n_vertex, sizeof *held);
    for (int j = 0; j <= n; j++) held[j * (n + 1)] = 1;
    struct body *body = body_alloc_of(QUADRATIC_TRIANGLE, mesh,
                                      material_notes(law), 2.385, LUMPED, held);
    free(held);
    return model_body(body);
}

static void forget(struct model *model)
{
    struct body *body = model->body;
    struct mesh *mesh = (struct mesh *)body->mesh;
    model_free(model);
    body_free(body);
    mesh_free(mesh);
}

/* omega^2 is the largest eigenvalue of M^-1/2 K M^-1/2, M being diagonal. */
static void the_fastest_mode_is_that_of_the_matrices(void)
{
    struct model *model = square(4, CUBIC);
    const struct body *body = model->body;
    const int n = body->n_equation;
    double *rest = allocate((size_t)model->n_dof, sizeof *rest);
    double *value = allocate((size_t)n, sizeof *value);
    double *x = allocate((size_t)n, sizeof *x), *y = allocate((size_t)n,
                                                             sizeof *y);
    struct matrix *K = body_matrix(body), *A = body_matrix(body);
    ck_assert_int_eq(body_stiffness(body, rest, EXACT, K), OK);
    double *mass = allocate((size_t)n, sizeof *mass);
    for (int r = 0; r < model->n_dof; r++)
        if (body->equation[r] >= 0)
            mass[body->equation[r]] = body->rho * body->diagonal[r / 2];
    for (int k = 0; k < n; k++) {
        memset(x, 0, (size_t)n * sizeof *x);
        x[k] = 1.0;
        matrix_multiply(K, x, y);
        for (int j = k; j < n && j <= k + K->p; j++)
            matrix_add(A, j, k, y[j] / sqrt(mass[j] * mass[k]));
    }
    ck_assert_int_eq(matrix_eigenvalues(A, value), OK);
    close_to(frequency_largest(model) / sqrt(value[n - 1]), 1.0, 1e-9);
    matrix_free(K), matrix_free(A);
    free(rest), free(value), free(x), free(y), free(mass);
    forget(model);
}

/* ---- live ---------------------------------------------------------------- */

static struct live *live_of(int n, enum law law, enum method method,
                            enum element element)
{
    gsl_set_error_handler_off();
    struct live *live = live_alloc(&(struct live_setting){
        n, law, method, PATCH, ELASTIC, 1, element});
    body_store(live->body, PLAIN);
    return live;
}

static struct live_report play(struct live *live, struct pointer pointer)
{
    double to[2];
    live_input(live, &pointer);
    live_hand(live->hand, &pointer, to);
    live_carry(live, to);
    return live_frame(live, to);
}

/* e: another element with the same vertices, state and hand; an odd number of
 * squares becomes even, and that is another mesh. */
static void e_changes_the_element(void)
{
    struct live *live = live_of(8, LOG, BACKWARD_EULER, LINEAR_TRIANGLE);
    for (int k = 0; k < 10; k++)
        play(live, (struct pointer){1.0 + 0.05 * k, 0.0, 1, '.'});
    int held[81];
    double u[162];
    for (int a = 0; a < 81; a++) held[a] = live->body->equation[2 * a] < 0;
    memcpy(u, live->now.u, sizeof u);
    live_input(live, &(struct pointer){1.45, 0.0, 1, 'e'});
    ck_assert_int_eq(live->set.element, QUADRATIC_TRIANGLE);
    ck_assert_int_eq(live->body->element, QUADRATIC_TRIANGLE);
    ck_assert_int_eq(live->body->K->storage, PLAIN);
    ck_assert(live->holding);
    for (int r = 0; r < 162; r++) {
        ck_assert_int_eq(live->body->equation[r] < 0, held[r / 2]);
        ck_assert(live->now.u[r] == u[r]);
    }
    ck_assert_str_eq(play(live, (struct pointer){1.5, 0.0, 1, '.'}).rung,
                     "fast");
    live_input(live, &(struct pointer){1.5, 0.0, 1, 'e'});
    ck_assert_int_eq(live->body->element, LINEAR_TRIANGLE);
    live_free(live);

    live = live_of(5, LOG, BACKWARD_EULER, LINEAR_TRIANGLE);
    live->now.u[7] = 0.01;
    live_input(live, &(struct pointer){0.0, 0.0, 0, 'e'});
    ck_assert(live->set.n == 6 && live->mesh->n == 6 && live->n_dof == 98);
    ck_assert(live->now.u[7] == 0.0);
    live_free(live);
    live = live_of(3, CUBIC, BACKWARD_EULER, QUADRATIC_TRIANGLE);
    ck_assert_int_eq(live->mesh->n, 4);
    live_input(live, &(struct pointer){0.0, 0.0, 0, '-'});
    live_input(live, &(struct pointer){0.0, 0.0, 0, '-'});
    ck_assert_int_eq(live->mesh->n, 2);
    live_free(live);
}

/* A state that is upright at the points of quadratic triangles alone is not
 * for LOG with linear ones. */
static void log_does_not_take_over_what_is_inverted(void)
{
    struct live *live = live_of(2, LOG, BACKWARD_EULER, QUADRATIC_TRIANGLE);
    live->now.u[2 * 8] = live->now.u[2 * 8 + 1] = -1.1; /* a corner */
    ck_assert_double_gt(body_min_J(live->body, live->now.u), 0.0);
    live_input(live, &(struct pointer){0.0, 0.0, 0, 'e'});
    ck_assert_double_lt(body_min_J(live->body, live->now.u), 0.0);
    ck_assert_int_eq(live->set.law, CUBIC);
    live_free(live);
}

/* The scripts of lesson 24: no frame is lost. */
static void no_frame_is_lost(void)
{
    for (int script = 0; script < 4; script++)
        for (int k = 0; k < 4; k++) {
            struct live *live =
                live_of(8, k % 2 ? CUBIC : LOG,
                        k / 2 ? IMPLICIT_MIDPOINT : BACKWARD_EULER,
                        QUADRATIC_TRIANGLE);
            struct pointers input = script == 0   ? pointers_pull(-3.0)
                                    : script == 1 ? pointers_pull(3.0)
                                    : script == 2 ? pointers_hard()
                                                  : pointers_mad(1, 600);
            int lost = 0;
            for (int j = 0; j < input.n; j++)
                lost += strcmp(play(live, input.frame[j]).rung, "lost") == 0;
            ck_assert_int_eq(lost, 0);
            for (int r = 0; r < live->n_dof; r++)
                ck_assert(isfinite(live->now.u[r]));
            pointers_free(&input);
            live_free(live);
        }
}

/* The push of a side under LOG: linear triangles stay upright and have no
 * knots; quadratic ones are upright at their points, and between them not. */
static void log_protects_the_points_alone(void)
{
    for (int k = 0; k < 2; k++) {
        struct live *live = live_of(8, LOG, BACKWARD_EULER, (enum element)k);
        struct pointers input = pointers_pull(-3.0);
        for (int j = 0; j < input.n; j++) play(live, input.frame[j]);
        ck_assert_double_gt(body_min_J(live->body, live->now.u), 0.0);
        ck_assert_int_eq(live_knots(live->mesh, live->now.u, NULL) > 0, k);
        pointers_free(&input);
        live_free(live);
    }
}

UNIT_MAIN("motion",
    LAW(the_fastest_mode_is_that_of_the_matrices),
    LAW(e_changes_the_element),
    LAW(log_does_not_take_over_what_is_inverted),
    LAW(no_frame_is_lost),
    LAW(log_protects_the_points_alone))
