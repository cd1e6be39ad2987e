/* system.c - laws of common/linear/csr.h and common/plane/system.h. */
#include "figures/speed/solved.h"
#include "linear/sparse.h"
#include "plane/system.h"

#include "unit.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static void fill(int n, double v[])
{
    for (int i = 0; i < n; i++) v[i] = sin(2.385 * i + 0.7);
}

/* The matrix of the drawing in csr.h. */
static struct csr *drawn(void)
{
    const int start[] = {0, 2, 3, 5}, index[] = {0, 2, 1, 0, 2};
    const double value[] = {4.0, 7.0, 5.0, 7.0, 26.0};
    struct csr *A = csr_alloc(3, 5);
    for (int i = 0; i < 4; i++) A->start[i] = start[i];
    for (int k = 0; k < 5; k++)
        A->index[k] = index[k], A->value[k] = value[k];
    return A;
}

static void rows_multiply(void)
{
    const double x[] = {2.385, -1.2, 0.7}, b[] = {3.0, 0.5, 9.0};
    double y[3];
    struct csr *A = drawn();
    csr_multiply(A, x, y);
    close_to(y[0], 4.0 * 2.385 + 7.0 * 0.7, 1e-15 * 20);
    close_to(y[1], -6.0, 1e-15 * 10);
    close_to(y[2], 7.0 * 2.385 + 26.0 * 0.7, 1e-14 * 10);
    const double r = hypot(hypot(b[0] - y[0], b[1] - y[1]), b[2] - y[2]);
    close_to(csr_residual(A, x, b), r / hypot(hypot(3.0, 0.5), 9.0), 1e-14);
    const double most = fmax(fabs(b[0] - y[0]), fabs(b[2] - y[2]));
    const double nan[] = {1.0, NAN, 2.0};
    const double error = most / (33.0 * 2.385 + 9.0);
    const double minus_x[] = {-2.385, 1.2, -0.7};
    const double minus_b[] = {-3.0, -0.5, -9.0};
    close_to(solved_error(A, x, b), error, 1e-15);
    close_to(solved_error(A, minus_x, minus_b), error, 1e-15);
    ck_assert(isnan(solved_error(A, nan, b)));
    csr_free(A);
    csr_free(NULL);
}

static void factor_solves_with_both_triangles(void)
{
    const int count[] = {2, 1, 1};
    struct factor *L = csr_factor_alloc(3, count);
    struct csr *A = drawn();
    const double value[] = {2.0, 3.5, sqrt(5.0), sqrt(26.0 - 3.5 * 3.5)};
    const int row[] = {0, 2, 1, 2};
    double x[] = {3.0, 0.5, 9.0}, b[] = {3.0, 0.5, 9.0};
    for (int j = 0, p = 0; j < 3; j++)
        for (int k = 0; k < count[j]; k++, p++) {
            ck_assert_int_eq(L->end[j], p);
            L->row[p] = row[p], L->value[p] = value[p];
            L->end[j]++;
        }
    ck_assert_int_eq(L->start[3], 4);
    csr_factor_solve(L, x);
    ck_assert_double_le(csr_residual(A, x, b), 4 * DBL_EPSILON);
    csr_factor_free(L);
    csr_factor_free(NULL);
    csr_free(A);
}

/* Any order gives the same matrix, and it is K. */
static void matrix_is_K_in_any_order(void)
{
    for (int n = 2; n <= 9; n++) {
        struct system *s = system_alloc(n);
        const struct mesh *mesh = s->scene->mesh;
        struct sparse *o = sparse_alloc(mesh->n + 1, mesh->rows + 1,
                                        mesh->n_triangle, mesh->triangle,
                                        s->scene->held, 3);
        const int unknowns = 2 * s->n_vertex;
        int *place = calloc((size_t)s->n_vertex, sizeof *place);
        double *x = calloc(5 * (size_t)s->scene->n_dof, sizeof *x);
        double *y = x + unknowns, *z = y + unknowns, *u = z + unknowns;
        double largest = 0.0;
        for (int v = 0; v < s->n_vertex; v++)
            place[v] = o->place[s->vertex[v]];
        ck_assert_int_eq(s->n_vertex, (n - 1) * (n + 1));
        fill(s->scene->n_dof, u); /* of all vertices */
        system_store(s, n % 2 ? SPARSE : BANDED);
        ck_assert_int_eq(s->scene->body->K->storage, n % 2 ? SPARSE : BANDED);
        struct csr *A[2] = {system_matrix(s, NULL), system_matrix(s, place)};
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < unknowns; i++) {
                const int *column = &A[k]->index[A[k]->start[i]];
                for (int p = 1; p < A[k]->start[i + 1] - A[k]->start[i]; p++)
                    ck_assert_int_lt(column[p - 1], column[p]);
            }
            for (int v = 0; v < s->n_vertex; v++)
                for (int d = 0; d < 2; d++)
                    x[2 * (k ? place[v] : v) + d] = u[2 * s->vertex[v] + d];
            csr_multiply(A[k], x, y);
            system_back(s, k ? place : NULL, y, k ? z : u + s->scene->n_dof);
        }
        /* K x by the body */
        double *some = calloc(2 * (size_t)unknowns, sizeof *some);
        body_gather(s->scene->body, u, some);
        matrix_multiply(s->scene->body->K, some, some + unknowns);
        for (int v = 0; v < s->n_vertex; v++)
            for (int d = 0; d < 2; d++) {
                const double want =
                    some[unknowns +
                         s->scene->body->equation[2 * s->vertex[v] + d]];
                largest = fmax(largest, fabs(want));
                close_to(z[2 * v + d], want, 1e-13 * largest);
                close_to(u[s->scene->n_dof + 2 * v + d], want, 1e-13 * largest);
            }
        free(some);
        free(x);
        free(place);
        for (int k = 0; k < 2; k++) csr_free(A[k]);
        sparse_free(o);
        system_free(s);
    }
}

/* K du = b is what a step begins with that starts at rest from u: after its
 * first iteration it is where this increment leads. */
static void system_is_that_of_a_step(void)
{
    const int n = 6;
    struct system *s = system_alloc(n);
    struct scene *t = s->scene;
    struct step_control control = step_method("notes");
    double du[98], b[70], next[98], one[98];
    for (int r = 0; r < t->n_dof; r++) {
        const double *X = &t->mesh->X[r / 2 * 2];
        du[r] = -s->b[r];
        one[r] = t->u[r];
        close_to(t->u[r], r % 2 ? -0.025 * (1.0 - X[0] * X[0]) * X[1]
                                : 0.05 * X[0], 1e-16);
        ck_assert(t->v[r] == 0.0);
    }
    system_right_side(s, NULL, b);
    for (int v = 0; v < s->n_vertex; v++)
        ck_assert(b[2 * v + 1] == s->b[2 * s->vertex[v] + 1]);
    ck_assert_int_eq(body_increment(t->body, t->body->K, du, next), OK);
    control.max_iterations = 1;
    const struct incremental Phi = {t->set.dt, t->u, NULL};
    step_solve(t->body, &control, Phi, one);
    for (int r = 0; r < t->n_dof; r++)
        close_to(one[r], t->u[r] + next[r], 1e-14);
    ck_assert_double_ge(body_max_free(t->body, next), 1e-3);
    system_free(s);
    system_free(NULL);
}

/* Half of it: F = diag(1/2, 1) everywhere; in either storage. */
static void a_pressed_body_has_the_K_of_its_place(void)
{
    for (int k = 0; k < 2; k++) {
        struct system *s = system_alloc(5);
        struct scene *t = s->scene;
        double u[72], q[72], before[40];
        system_store(s, k ? SPARSE : BANDED);
        for (int r = 0; r < 40; r++) before[r] = s->b[r];
        for (int r = 0; r < t->n_dof; r++)
            u[r] = r % 2 ? 0.0 : -0.5 * t->mesh->X[r];
        system_press(s, 0.5);
        struct csr *K = system_matrix(s, NULL);
        const struct incremental Phi = {t->set.dt, u, NULL};
        ck_assert_int_eq(body_assemble(t->body, Phi, u, EXACT, q), OK);
        struct csr *want = system_matrix(s, NULL);
        for (int e = 0; e < K->start[K->n]; e++)
            ck_assert(K->value[e] == want->value[e]);
        for (int r = 0; r < 40; r++) ck_assert(s->b[r] == before[r]);
        csr_free(K);
        csr_free(want);
        system_free(s);
    }
}

UNIT_MAIN("system",
    LAW(rows_multiply),
    LAW(factor_solves_with_both_triangles),
    LAW(matrix_is_K_in_any_order),
    LAW(system_is_that_of_a_step),
    LAW(a_pressed_body_has_the_K_of_its_place))
