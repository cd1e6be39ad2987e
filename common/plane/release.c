/* release.c - see release.h. */
#include "plane/release.h"

#include "plane/step.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

double release_winding(const struct body *body, const double u[])
{
    const struct mesh *mesh = body->mesh;
    double *angle = allocate((size_t)mesh->n_vertex, sizeof *angle), wind = 0.0;
    mesh_angles(mesh, u, angle);
    for (int a = 0; a < mesh->n_vertex; a++)
        wind = fmax(wind, angle[a] / (2.0 * M_PI));
    free(angle);
    return wind;
}

const struct crushed RELEASE_CRUSHED[N_CRUSHED] = {
    {"line", {{{1.0, 0.0}, {0.0, 0.0}}}},
    {"oblique", {{{0.36, 0.48}, {0.48, 0.64}}}},
    {"inside_out", {{{1.0, 0.0}, {0.0, -1.0}}}},
    {"near_point", {{{1e-3, 2e-3}, {-1e-3, 5e-4}}}},
    {"point", {{{0.0, 0.0}, {0.0, 0.0}}}}};

void release_place(const struct body *body, mat2 F, double u[])
{
    for (int a = 0; a < body->mesh->n_vertex; a++) {
        const double *X = &body->mesh->X[2 * a]; /* u = F X - X */
        for (int i = 0; i < 2; i++)
            if (body->equation[2 * a + i] >= 0)
                u[2 * a + i] = F.m[i][0] * X[0] + F.m[i][1] * X[1] - X[i];
    }
}

void release_shift(struct body *body)
{
    const double modulus = material_modulus(&body->material);
    for (int r = 0; r < body->n_equation; r++)
        matrix_add(body->K, r, r, RELEASE_SHIFT * modulus);
}

/* Make one iteration; *done: the forces are small, and u is as it was. */
static enum status descend(struct body *body, double q[], double du[],
                           double u[], int *done)
{
    enum status status = body_assemble(body, at_rest(NULL), u, PROJECTED, q);
    if (status != OK) return status;
    *done = body_max_free(body, q) <=
            RELEASE_TOLERANCE * material_modulus(&body->material);
    if (*done) return OK;
    release_shift(body); /* (K + shift) du = -q */
    status = body_increment(body, body->K, q, du);
    return status == OK ? step_search(body, at_rest(NULL), q, du, u) : status;
}

struct release_report release_solve(struct body *body, int max_iterations,
                                    double u[])
{
    const size_t n_dof = 2 * (size_t)body->mesh->n_vertex;
    double *q = allocate(n_dof, sizeof *q), *du = allocate(n_dof, sizeof *du);
    struct release_report report = {0};
    int done = 0;
    for (;;) {
        report.status = descend(body, q, du, u, &done);
        if (report.status != OK || done) break;
        report.iterations++;
        report.status = MAX_ITERATIONS;
        if (report.iterations == max_iterations) break;
    }
    if (report.status == OK) {
        body_stiffness(body, u, EXACT, body->K);
        release_shift(body);
        if (matrix_factor(body->K) != OK) report.status = SADDLE;
    }
    report.min_J = body_min_J(body, u);
    body_energy(body, u, &report.energy);
    report.recovered = report.status == OK && report.min_J > 0.0 &&
                       fabs(report.energy) <= RELEASE_ENERGY;
    free(q);
    free(du);
    return report;
}

/* Return a number in [-1, 1) from the state of the generator, 64 bits. */
static double draw(unsigned long long *state)
{
    unsigned long long z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return 2.0 * (double)(z >> 11) * 0x1p-53 - 1.0; /* 53 bits: a double */
}

void release_scramble(const struct body *body, unsigned seed, double u[])
{
    unsigned long long state = seed;
    for (int a = 0; a < body->mesh->n_vertex; a++) {
        if (body->equation[2 * a] < 0) continue;
        for (int i = 0; i < 2; i++) /* u = x - X */
            u[2 * a + i] = draw(&state) - body->mesh->X[2 * a + i];
    }
}
