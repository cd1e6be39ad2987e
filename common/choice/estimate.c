/* estimate.c - see estimate.h. */
#include "choice/estimate.h"

#include <math.h>
#include <stdlib.h>

double estimate_geometry(const struct ladder_state *s)
{
    double forgotten = 0.0, largest = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        const mat2 H = mat2_subtract(F, mat2_identity()); /* grad u */
        const mat2 HtH = mat2_multiply(mat2_transpose(H), H);
        forgotten = fmax(forgotten, 0.5 * mat2_norm(HtH));
        largest = fmax(largest, mat2_norm(H));
    }
    return largest > 0.0 ? forgotten / largest : 0.0;
}

double estimate_law(const struct ladder_state *s)
{
    struct material cubic = s->body->material, logarithm = cubic;
    double J[2] = {1.0, 1.0}, worst = 0.0; /* J: least, largest */
    cubic.law = CUBIC;
    logarithm.law = LOG;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const double det = mat2_det(body_deformation(s->body, s->u, e));
        J[0] = fmin(J[0], det);
        J[1] = fmax(J[1], det);
    }
    if (!(J[0] > 0.0 && J[1] <= RELAX_SERIES)) return 1.0;
    for (int k = 0; k < 2; k++) {
        const double P = material1_pk1(&logarithm, J[k]);
        const double off = material1_pk1(&cubic, J[k]) - P;
        if (J[k] != 1.0) worst = fmax(worst, fabs(off / P)); /* P(1) = 0 */
    }
    return fmin(1.0, worst);
}

double estimate_dimension(const struct ladder_state *s)
{
    const double length = 2.0, height = length / s->scene->slender;
    const double lateral = ladder_narrows(&s->body->material);
    double N = 0.0, moment = 0.0;
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const double *X = &s->mesh->X[2 * a], *f = &s->f[2 * a];
        N += f[0];
        /* about the middle of the held end, (-1, 0) */
        moment += (X[0] + 1.0) * f[1] - X[1] * f[0];
    }
    const double buckles = ladder_buckles(s->scene);
    /* times E': u = N length / height, w = M length^2 / (2 I) */
    const double along = fabs(N) * length / height;
    double sideways = 6.0 * fabs(moment) * pow(length, 2) / pow(height, 3);
    if (N <= -buckles) return 1.0; /* P = -N */
    sideways /= 1.0 + N / buckles;
    const double missed = lateral * lateral * height / (2.0 * length);
    if (!(sideways + along > 0.0)) return 0.0;
    return (sideways + missed * along) / (sideways + along);
}

double estimate_frequency(const struct ladder_state *s)
{
    double *Mu = ladder_momentum(s), work = 0.0, mass = 0.0;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) {
        work += s->f[r] * s->u[r];
        mass += s->u[r] * Mu[r];
    }
    free(Mu);
    return work > 0.0 && mass > 0.0 ? sqrt(work / mass) : 0.0;
}

double estimate_inertia(const struct ladder_state *s)
{
    return fmin(1.0, 1.0 / (estimate_frequency(s) * s->scene->T));
}

double estimate_strain(const struct ladder_state *s)
{
    double largest = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        const mat2 C = mat2_multiply(mat2_transpose(F), F);
        const mat2 twice = mat2_subtract(C, mat2_identity()); /* 2 G */
        largest = fmax(largest, 0.5 * mat2_norm(twice));
    }
    return largest;
}

/* Return whether the axis of the body is moved aside, by more than a tenth of
 * |u|. */
static int leans(const struct ladder_state *s)
{
    double sum = 0.0;
    for (int a = 0; a < s->mesh->n_vertex; a++) sum += s->u[2 * a + 1];
    return fabs(sum / s->mesh->n_vertex) > 0.1 * ladder_size(s, s->u);
}

/* Ask quadratic triangles on the finest mesh about the body at rest. */
static enum doubt doubt_of_finest(const struct ladder_state *s)
{
    struct ladder_scene scene = *s->scene;
    const enum rung rung = s->model.rung == LOG_PLANE ? LOG_PLANE : CUBIC_PLANE;
    scene.time = STANDS;
    struct ladder_state *fine = ladder_solve_of(
        QUADRATIC_TRIANGLE, 1.0, &scene,
        (struct ladder_model){rung, 0, scene.finest});
    enum doubt doubt = NO_DOUBT;
    if (fine->status != OK || !ladder_stable(fine)) doubt = GIVES_WAY;
    else if (ladder_symmetric(&scene) && leans(fine)) doubt = BUCKLES;
    else if (!s->model.moving && ladder_error(s, fine) > 0.5)
        doubt = TOO_STIFF;
    ladder_free(fine);
    return doubt;
}

enum doubt estimate_doubt(const struct ladder_state *s)
{
    const struct ladder_scene *scene = s->scene;
    const int symmetric = ladder_symmetric(scene);
    const double pressed = ladder_pressed(scene);
    if (!(estimate_strain(s) <= ESTIMATE_STRAIN)) return TORN;
    if (s->model.moving &&
        estimate_frequency(s) * ladder_step(s) > ESTIMATE_ANGLE)
        return LONG_STEPS;
    if (pressed >= 1.0 && scene->slender >= ESTIMATE_BEAM &&
        (symmetric || s->model.rung <= LINEAR_PLANE))
        return BUCKLES;
    if (s->model.rung != BAR) { /* in motion, too: no part can be told */
        struct matrix *K = s->model.moving ? relax_factors(s) : NULL;
        const int sure = s->model.moving ? K != NULL : ladder_stable(s);
        matrix_free(K);
        if (!sure) return GIVES_WAY;
    }
    return pressed > 0.5 && (symmetric || !s->model.moving)
               ? doubt_of_finest(s) : NO_DOUBT;
}

void estimate_mesh(const struct ladder_state *s,
                   const struct relax_field *field, double g[])
{
    const struct mesh *mesh = s->mesh;
    const double *area = s->body->area;
    double *mean = allocate((size_t)mesh->n_vertex, sizeof *mean);
    double *around = allocate((size_t)mesh->n_vertex, sizeof *around);
    for (int r = 0; r < 3 * mesh->n_triangle; r++) {
        mean[mesh->triangle[r]] += area[r / 3] * field->p[r / 3];
        around[mesh->triangle[r]] += area[r / 3]; /* p there: mean / around */
    }
    for (int e = 0; e < mesh->n_triangle; e++) {
        mat2 off = mat2_scale(field->p[e], mat2_identity()); /* p_e I */
        for (int k = 0; k < 3; k++) {
            const int a = mesh->triangle[3 * e + k], b = s->across[3 * e + k];
            /* share jump = (P_e - mean over the edge, by area) / 3 */
            const double share = area[b] / (area[e] + area[b]) / 3.0;
            const mat2 jump = mat2_subtract(field->P[e], field->P[b]);
            const double p = mean[a] / (3.0 * around[a]);
            off = mat2_add(off, mat2_scale(share, jump));
            off = mat2_subtract(off, mat2_scale(p, mat2_identity()));
        }
        relax_push(s, e, off, g);
    }
    free(mean);
    free(around);
}

void estimate_stress(const struct ladder_state *s,
                     const struct relax_field *field, double g[])
{
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 T = mat2_multiply(field->H[e], relax_stress(s, e));
        relax_push(s, e, mat2_scale(-1.0, T), g);
    }
}

void estimate_parts(const struct ladder_state *s, double part[N_PART])
{
    part[GEOMETRY] = estimate_geometry(s);
    part[LAW] = estimate_law(s);
    part[DIMENSION] = estimate_dimension(s);
    part[INERTIA] = estimate_inertia(s);
    relax_parts(s, estimate_mesh, estimate_stress, part);
}

int estimate_verdict(struct ladder_model model, enum ladder_time time, int sure,
                     double tolerance, double part[N_PART], double *estimate,
                     enum part *add)
{
    if (model.rung != BAR) part[DIMENSION] = 0.0;
    if (model.rung > LINEAR_PLANE) part[GEOMETRY] = 0.0;
    if (model.rung != LINEAR_PLANE) part[STRESS] = 0.0;
    if (model.rung != CUBIC_PLANE) part[LAW] = 0.0;
    if (model.moving || time == STANDS) part[INERTIA] = 0.0;
    if (model.rung == BAR) part[MESH] = 0.0;
    *estimate = 0.0;
    *add = GEOMETRY;
    for (int k = 0; k < N_PART; k++) {
        *estimate = hypot(*estimate, part[k]);
        if (part[k] > part[*add]) *add = (enum part)k;
    }
    if (!sure && model.rung <= LINEAR_PLANE) *add = GEOMETRY;
    return sure && *estimate <= tolerance;
}
