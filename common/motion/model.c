/* model.c - see model.h. */
#include "motion/model.h"

#include <math.h>
#include <stdlib.h>

/* A model with the mass matrix M, which it factors. */
static struct model *model_alloc(int n_dof, const struct matrix *M)
{
    struct model *model = allocate(1, sizeof *model);
    model->n_dof = n_dof;
    model->f = allocate((size_t)n_dof, sizeof *model->f);
    model->M_factor = matrix_copy(M);
    const enum status status = matrix_factor(model->M_factor);
    if (status != OK) die("the mass matrix is %s", status_name(status));
    return model;
}

static struct model *linear_model(struct matrix *M, struct matrix *A)
{
    struct model *model = model_alloc(M->n, M);
    model->M = M;
    model->A = A;
    return model;
}

struct model *model_mode(double omega)
{
    struct matrix *M = matrix_alloc(BANDED, 1, 0);
    struct matrix *A = matrix_alloc(BANDED, 1, 0);
    matrix_add(M, 0, 0, 1.0);
    matrix_add(A, 0, 0, omega * omega);
    return linear_model(M, A);
}

struct model *model_bar(int n, enum mass mass)
{
    const struct material material = material_notes(LINEAR);
    const double h = 1.0 / n, k = material_modulus(&material) / h;
    const double same = mass == LUMPED ? h / 2.0 : h / 3.0;
    struct matrix *M = matrix_alloc(BANDED, n, 1);
    struct matrix *A = matrix_alloc(BANDED, n, 1);

    /* A_e = k [1 -1; -1 1], M_e = h/6 [2 1; 1 2] or h/2 [1 0; 0 1]; node 1
     * is row 0 */
    for (int e = 0; e < n; e++)
        for (int a = 0; a < 2; a++)
            for (int b = 0; b < 2; b++) {
                const int i = e - 1 + a, j = e - 1 + b;
                if (i < 0 || j < 0) continue; /* u(0) = 0 */
                matrix_add(A, i, j, a == b ? k : -k);
                matrix_add(M, i, j, a == b ? same : h / 2.0 - same);
            }
    return linear_model(M, A);
}

struct model *model_body(struct body *body)
{
    struct matrix *M = body_matrix(body);
    body_mass_matrix(body, M);
    struct model *model = model_alloc(2 * body->mesh->n_vertex, M);
    model->body = body;
    matrix_free(M);
    return model;
}

void model_free(struct model *model)
{
    if (!model) return;
    matrix_free(model->M);
    matrix_free(model->A);
    matrix_free(model->M_factor);
    matrix_free(model->K);
    free(model->f);
    free(model);
}

void model_mass(const struct model *model, const double v[], double out[])
{
    if (model->body)
        body_mass(model->body, v, out);
    else
        matrix_multiply(model->M, v, out);
}

enum status model_force(const struct model *model, const double u[],
                        double out[])
{
    if (model->body) return body_force(model->body, u, out);
    matrix_multiply(model->A, u, out);
    return OK;
}

void model_accelerate(const struct model *model, double r[])
{
    if (!model->body) {
        matrix_solve(model->M_factor, r);
        return;
    }
    double *some = allocate((size_t)model->M_factor->n, sizeof *some);
    body_gather(model->body, r, some); /* the free rows */
    matrix_solve(model->M_factor, some);
    body_scatter(model->body, some, r);
    free(some);
}

double model_energy(const struct model *model, const double u[],
                    const double v[])
{
    double *out = allocate((size_t)model->n_dof, sizeof *out), energy = 0.0;
    if (model->body) {
        if (body_energy(model->body, u, &energy) != OK) energy = INFINITY;
    } else {
        matrix_multiply(model->A, u, out); /* Psi = u.A u / 2 */
        for (int i = 0; i < model->n_dof; i++) energy += 0.5 * u[i] * out[i];
    }
    model_mass(model, v, out); /* M v */
    for (int i = 0; i < model->n_dof; i++)
        energy += 0.5 * v[i] * out[i] - model->f[i] * u[i];
    free(out);
    return energy;
}

struct step_report model_newton(struct model *model, double dt, double q[])
{
    struct step_report report = {.status = OK, .iterations = 1};
    if (!model->K || model->K_step != dt) {
        matrix_free(model->K);
        model->K = matrix_copy(model->M);
        model->K_step = dt;
        matrix_combine(model->M, dt * dt, model->A, model->K); /* M + dt^2 A */
        report.status = matrix_factor(model->K);
        report.factorisations = 1;
        if (report.status != OK) {
            matrix_free(model->K);
            model->K = NULL;
            return report;
        }
    }
    matrix_solve(model->K, q);
    for (int i = 0; i < model->n_dof; i++) q[i] = -q[i];
    return report;
}
