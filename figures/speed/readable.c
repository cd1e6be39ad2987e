/* readable.c - see readable.h. */
#include "readable.h"

#include <assert.h>
#include <gsl/gsl_linalg.h>
#include <stdlib.h>
#include <string.h>

struct readable *readable_alloc(struct body *body, double dt)
{
    struct readable *r = allocate(1, sizeof *r);
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    const int width = 2 * body->mesh->n + 6;
    assert(body->mass == CONSISTENT && body->material.law == CUBIC);
    *r = (struct readable){body, dt, width,
                           allocate(n_dof * (size_t)width, sizeof(double)),
                           allocate(n_dof, sizeof(double))};
    return r;
}

void readable_free(struct readable *r)
{
    free(r->K);
    free(r->q);
    free(r);
}

/* K_ij += value, of the lower triangle. */
static void add(struct readable *r, int i, int j, double value)
{
    if (i >= j) r->K[(size_t)j * (size_t)r->width + (size_t)(i - j)] += value;
}

/* q and K of element e [eq:body-q] [eq:body-tangent]: every column of K is the
 * change of force when one unknown moves. */
static void add_element(struct readable *r, int e, const double w[],
                        const double u[])
{
    const struct body *body = r->body;
    const int *node = &body->mesh->triangle[3 * e];
    double G[6];
    const double area = mesh_gradients(body->mesh, e, G);
    const double dt2 = r->dt * r->dt;
    mat2 F = mat2_identity();
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < 2; i++)
            for (int J = 0; J < 2; J++)
                F.m[i][J] += u[2 * node[a] + i] * G[2 * a + J];
    const mat2 P = material2_pk1(&body->material, F);
    for (int b = 0; b < 3; b++)
        for (int k = 0; k < 2; k++) {
            const int column = 2 * node[b] + k;
            mat2 dF = {{{0.0, 0.0}, {0.0, 0.0}}};
            dF.m[k][0] = G[2 * b];
            dF.m[k][1] = G[2 * b + 1];
            const mat2 dP = material2_dpk1(&body->material, F, dF);
            r->q[column] += dt2 * area * (P.m[k][0] * G[2 * b] +
                                          P.m[k][1] * G[2 * b + 1]);
            for (int a = 0; a < 3; a++) {
                const double mass = body->rho * area / (a == b ? 6.0 : 12.0);
                r->q[2 * node[a] + k] += mass * (u[column] - w[column]);
                for (int i = 0; i < 2; i++)
                    add(r, 2 * node[a] + i, column,
                        dt2 * area * (dP.m[i][0] * G[2 * a] +
                                      dP.m[i][1] * G[2 * a + 1]) +
                            (i == k ? mass : 0.0));
            }
        }
}

void readable_assemble(struct readable *r, const double w[], const double u[])
{
    const size_t n_dof = 2 * (size_t)r->body->mesh->n_vertex;
    memset(r->K, 0, n_dof * (size_t)r->width * sizeof *r->K);
    memset(r->q, 0, n_dof * sizeof *r->q);
    for (int e = 0; e < r->body->mesh->n_triangle; e++)
        add_element(r, e, w, u);
}

/* Held unknowns: row and column of the identity, q = 0. */
static void correct(struct readable *r)
{
    const size_t n_dof = 2 * (size_t)r->body->mesh->n_vertex;
    const size_t width = (size_t)r->width;
    for (size_t i = 0; i < n_dof; i++) {
        if (r->body->equation[i] >= 0) continue;
        for (size_t d = 1; d < width; d++) {
            r->K[i * width + d] = 0.0;
            if (d <= i) r->K[(i - d) * width + d] = 0.0;
        }
        r->K[i * width] = 1.0;
        r->q[i] = 0.0;
    }
}

int readable_gsl(struct readable *r, const double w[], const double u[],
                 double du[])
{
    const size_t n_dof = 2 * (size_t)r->body->mesh->n_vertex;
    gsl_matrix_view K = gsl_matrix_view_array(r->K, n_dof, (size_t)r->width);
    gsl_vector_view x = gsl_vector_view_array(du, n_dof);
    readable_assemble(r, w, u);
    correct(r);
    for (size_t i = 0; i < n_dof; i++) du[i] = -r->q[i];
    gsl_error_handler_t *old = gsl_set_error_handler_off();
    const int failed = gsl_linalg_cholesky_band_decomp(&K.matrix) ||
                       gsl_linalg_cholesky_band_svx(&K.matrix, &x.vector);
    gsl_set_error_handler(old);
    return !failed;
}

struct step_report readable_step(struct readable *r,
                                 readable_increment *increment,
                                 const double g[], double u[], double v[])
{
    const size_t n_dof = 2 * (size_t)r->body->mesh->n_vertex;
    double *w = allocate(n_dof, sizeof *w);
    double *next = allocate(n_dof, sizeof *next);
    double *du = allocate(n_dof, sizeof *du);
    struct step_report report = {.status = MAX_ITERATIONS};
    for (size_t i = 0; i < n_dof; i++) {
        w[i] = u[i] + r->dt * v[i];
        next[i] = r->body->equation[i] < 0 ? g[i] : u[i];
    }
    while (report.status == MAX_ITERATIONS && report.iterations < 40) {
        report.status = increment(r, w, next, du) ? MAX_ITERATIONS : NOT_SPD;
        if (report.status == NOT_SPD) break;
        report.increment = 0.0;
        for (size_t i = 0; i < n_dof; i++) {
            next[i] += du[i];
            if (!(fabs(du[i]) <= report.increment))
                report.increment = fabs(du[i]);
        }
        report.iterations++;
        if (report.increment <= 1e-10) report.status = OK;
    }
    report.factorisations = report.iterations;
    if (report.status == OK)
        for (size_t i = 0; i < n_dof; i++) {
            v[i] = (next[i] - u[i]) / r->dt;
            u[i] = next[i];
        }
    free(w);
    free(next);
    free(du);
    return report;
}
