/* work.c - see work.h. */
#include "work.h"

#include "base/clock.h"
#include "plane/triangles.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

/* limit_steps, load_steps: S of work_limit(), dynamic and static; how many load
 * steps matters only for the branch that they follow. */
static const struct {
    const char *name;
    enum reading reading; /* the held vertices */
    int slender, limit_steps, load_steps;
    double end; /* (s) */
} scenes[WORK_SCENES] = {
    {"slow_pull", STRETCH, 1, 16, 4, 1.0},
    {"fast_pull", STRETCH, 1, 32, 4, 0.08},
    {"shake", GRAVITY, 1, 32, 4, 0.4},
    {"swing", STRETCH, 1, 32, 4, 0.03},
    {"buckle", COMPRESS, 8, 64, 16, 2.0},
    {"push", STRETCH, 1, 32, 16, 0.08},
    {"jolted_pull", STRETCH, 1, 32, 4, 1.0},
    {"weight", GRAVITY, 1, 32, 4, 0.15},
};

const char *work_scene_name(enum work_scene scene)
{
    return scenes[scene].name;
}

int work_coarsest(enum work_scene scene)
{
    return scenes[scene].slender == 1 ? 4 : 8;
}

enum element work_limit_element(enum work_scene scene)
{
    return scene == SWING || scene == PUSH ? LINEAR_TRIANGLE
                                           : QUADRATIC_TRIANGLE;
}

/* Rise from 0 to 1 within 0 < s < 1, with a velocity and an acceleration that
 * begin and end with 0. */
static double ramp(double s)
{
    return s <= 0.0 ? 0.0 : s >= 1.0 ? 1.0
                          : s - sin(2.0 * M_PI * s) / (2.0 * M_PI);
}

double work_end(enum work_scene scene) { return scenes[scene].end; }

void work_hold(struct scene *s, enum work_scene scene, double t)
{
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const double X1 = s->mesh->X[2 * a], X2 = s->mesh->X[2 * a + 1];
        const double right = X1 > 0.0 ? 1.0 : 0.0;
        double *value = &s->g[2 * a];
        value[0] = value[1] = 0.0;
        if (!s->held[a]) continue;
        if (scene == JOLTED_PULL) value[0] = 0.5 * X1 * sin(t);
        if (scene == SLOW_PULL) value[0] = 0.42 * X1 * ramp(t);
        if (scene == FAST_PULL) value[0] = 0.6 * right * ramp(t / 0.06);
        if (scene == SHAKE) value[1] = 0.15 * (1.0 - cos(2.0 * M_PI * t / 0.4));
        if (scene == BUCKLE) value[0] = -X1 * (0.1 + 0.1 * X2) * ramp(t / 2.0);
        if (scene == PUSH) value[0] = -0.6 * right * ramp(t / 0.08);
    }
}

void work_pluck(const struct scene *s, double u[])
{
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const double *X = &s->mesh->X[2 * a];
        const double hump =
            gsl_pow_2((1.0 - X[0] * X[0]) * (1.0 - X[1] * X[1]));
        u[2 * a] = 0.1 * hump;
        u[2 * a + 1] = 0.2 * hump;
    }
}

/* ---- one solve ----------------------------------------------------------- */

/* Solve by Newton's method: fast, and then whatever goes downhill. */
static struct step_report nonlinear(struct model *model, double d,
                                    const double a[], const double b[],
                                    const double g[], double u[])
{
    const size_t n = (size_t)model->n_dof;
    const double *tolerance = model->context;
    struct step_control control = {
        .tolerance = *tolerance, .max_iterations = 40, .guess = FROM_VELOCITY,
        .lift = 1, .chord = 1, .line_search = 1, .projection = ON_DEMAND};
    double *v = allocate(n, sizeof *v);
    memcpy(u, a, n * sizeof *u);
    memcpy(v, b, n * sizeof *v);
    struct step_report report = step_backward_euler(
        model->body, &control, d, g, model->f, u, v, NULL);
    if (report.status != OK) {
        const struct step_report first = report;
        control.guess = FROM_LAST; /* a state that exists */
        report = step_backward_euler(model->body, &control, d, g, model->f, u,
                                     v, NULL);
        report.iterations += first.iterations;
        report.factorisations += first.factorisations;
    }
    free(v);
    return report;
}

/* q := A u of all vertices, A the stiffness at rest. */
static void linear_force(const struct body *body, const double u[], double q[])
{
    const struct material law = {LINEAR, body->material.mu,
                                 body->material.lambda};
    memset(q, 0, 2 * (size_t)body->mesh->n_vertex * sizeof *q);
    for (int e = 0; e < body->n_element; e++)
        for (int p = 0; p < body->points; p++) {
            const mat2 P =
                material2_pk1(&law, triangles_deformation(body, u, e, p));
            for (int a = 0; a < body->nodes; a++) {
                const int k = body->nodes * (body->points * e + p) + a;
                const double *g = &body->gradient[2 * k];
                double *force = &q[2 * body->vertex[body->nodes * e + a]];
                for (int i = 0; i < 2; i++)
                    force[i] += body->area[e] *
                             (P.m[i][0] * g[0] + P.m[i][1] * g[1]);
            }
        }
}

/* The same for small displacements: u = w + jump - K^-1 q, once, and factors
 * that are kept for the whole run. */
static struct step_report linear(struct model *model, double d,
                                 const double a[], const double b[],
                                 const double g[], double u[])
{
    const struct body *body = model->body;
    const int n = model->n_dof;
    double *move = allocate((size_t)n, sizeof *move);
    double *q = allocate((size_t)n, sizeof *q);
    double *force = allocate((size_t)n, sizeof *force);
    double *some = allocate((size_t)n, sizeof *some);
    for (int i = 0; i < n; i++) u[i] = a[i] + d * b[i];
    step_boundary(body, g, 1, u);
    for (int i = 0; i < n; i++) move[i] = u[i] - a[i] - d * b[i];
    body_mass(body, move, q);
    linear_force(body, u, force);
    for (int i = 0; i < n; i++) q[i] += d * d * (force[i] - model->f[i]);
    body_gather(body, q, some);
    const struct step_report report = model_newton(model, d, some);
    if (report.status == OK) {
        body_scatter(body, some, q);
        for (int i = 0; i < n; i++) u[i] += q[i];
    }
    free(move);
    free(q);
    free(force);
    free(some);
    return report;
}

/* ---- a run --------------------------------------------------------------- */

struct scene *work_alloc(const struct work_setting *set)
{
    struct scene_setting s = scene_notes(scenes[set->scene].reading,
                                         set->law == LINEAR ? LOG : set->law,
                                         set->n);
    s.mass = LUMPED;
    s.element = set->element;
    s.grade = set->grade > 0.0 ? set->grade : 1.0;
    s.slender = scenes[set->scene].slender;
    if (set->scene != WEIGHT) s.force = 0.0; /* of the held left end */
    struct scene *scene = scene_alloc(&s);
    if (scene->mesh->rows < WORK_BANDED_BELOW) body_store(scene->body, BANDED);
    return scene;
}

/* Return the model that moves; *tolerance has to stay where it is. */
static struct model *model_of(const struct work_setting *set, struct scene *s,
                              const double *tolerance)
{
    struct body *body = s->body;
    struct model *model = model_body(body);
    memcpy(model->f, s->f, (size_t)s->n_dof * sizeof *s->f);
    if (!set->dynamic) body->rho = 0.0;
    model->solve = nonlinear;
    model->context = tolerance;
    if (set->law == LINEAR) {
        model->M = body_matrix(body);
        model->A = body_matrix(body);
        body_mass_matrix(body, model->M);
        body_stiffness(body, s->u, EXACT, model->A);
        model->solve = linear;
    }
    return model;
}

static void steps(const struct work_setting *set, struct scene *s,
                  struct model *model, struct state *now, struct work *work)
{
    const double dt = scenes[set->scene].end / set->steps;
    while (work->status == OK && work->steps < set->steps) {
        work_hold(s, set->scene, (work->steps + 1) * dt);
        if (set->dynamic && set->method == SYMPLECTIC_EULER)
            for (int r = 0; r < s->n_dof; r++)
                if (s->held[r / 2]) now->v[r] = (s->g[r] - now->u[r]) / dt;
        const struct step_report report = integrate_step(
            model, set->dynamic ? set->method : BACKWARD_EULER,
            set->dynamic ? dt : 1.0, s->g, now);
        work->status = report.status;
        work->steps += report.status == OK;
        work->systems += report.iterations;
        work->factorisations += report.factorisations;
        for (int r = 0; r < s->n_dof; r++)
            if (!(fabs(now->u[r]) < 100.0)) work->status = NONFINITE;
    }
}

void work_share(const struct mesh *mesh, const double u[], struct work *work)
{
    const int along = mesh->n / 4, row = mesh->n + 1;
    const int stride = mesh->rows < along ? mesh->rows : along;
    for (int j = 0; j <= mesh->rows; j += stride)
        for (int i = 0; i <= mesh->n; i += along)
            for (int k = 0; k < 2; k++)
                work->u[work->n_shared++] = u[2 * (j * row + i) + k];
}

struct work work_run(const struct work_setting *set)
{
    struct work work = {.status = OK};
    struct scene *s = work_alloc(set);
    struct model *model = model_of(set, s, &set->tolerance);
    struct state now = state_make(s->n_dof);

    assert(set->n % work_coarsest(set->scene) == 0);
    assert(set->law != LINEAR || set->method != SYMPLECTIC_EULER);
    if (set->scene == SWING && set->dynamic) work_pluck(s, now.u);
    const double start = clock_seconds();
    steps(set, s, model, &now, &work);
    work.seconds = clock_seconds() - start;
    work.flops = work_flops(s->body, work.steps, work.systems,
                            work.factorisations);
    work.min_J = body_min_J(s->body, now.u);
    if (work.status == OK && !(work.min_J > 0.0)) work.status = INVERTED;
    work_share(s->mesh, now.u, &work);
    state_free(&now);
    model_free(model);
    scene_free(s);
    return work;
}

double work_elements(const struct body *body, enum tangent tangent)
{
    const int linear = body->element == LINEAR_TRIANGLE;
    const double residual = linear ? 100.0 : 400.0;
    const double both = linear ? 250.0 : 1700.0;
    return body->n_element * (tangent == NO_TANGENT ? residual : both);
}

double work_flops(const struct body *body, int steps, int systems,
                  int factorisations)
{
    const double both = work_elements(body, EXACT);
    const double residual = work_elements(body, NO_TANGENT);
    const struct matrix_cost cost =
        matrix_cost(BANDED, body->K->n, body->K->p);
    return factorisations * (cost.flops + both) + systems * cost.solve +
           residual * (systems + steps - factorisations);
}

/* ---- differences and limits ---------------------------------------------- */

double work_distance(const struct work *a, const struct work *b)
{
    double sum = 0.0;
    if (a->status != OK || (b && b->status != OK)) return INFINITY;
    for (int i = 0; i < a->n_shared; i++)
        sum = hypot(sum, a->u[i] - (b ? b->u[i] : 0.0));
    return sum / sqrt(0.5 * a->n_shared);
}

void work_correct(struct work *u, double s, const struct work *a,
                  const struct work *b)
{
    if (a->status != OK) u->status = a->status;
    if (b->status != OK) u->status = b->status;
    for (int i = 0; i < u->n_shared; i++) u->u[i] += s * (a->u[i] - b->u[i]);
}

struct work work_limit(const struct work_setting *model, double *floor)
{
    struct work_setting set = *model;
    struct work mesh[3], late[2]; /* N/4, N/2, N; the first two, late */
    const int dynamic = set.dynamic;
    set.method = IMPLICIT_MIDPOINT;
    set.tolerance = 1e-7;
    for (int k = 0; k < 3; k++) {
        set.n = (set.element == LINEAR_TRIANGLE ? 3 << k : 4 << k) *
                work_coarsest(set.scene);
        set.steps = dynamic ? scenes[set.scene].limit_steps
                            : scenes[set.scene].load_steps;
        mesh[k] = work_run(&set);
        set.steps *= 4;
        if (k < 2) late[k] = dynamic ? work_run(&set) : mesh[k];
    }
    const double ratio =
        fmin(fmax(work_distance(&mesh[0], &mesh[1]) /
                      work_distance(&mesh[1], &mesh[2]), 2.0), 4.0);
    struct work limit = mesh[2], before = mesh[1];
    work_correct(&limit, 1.0 / (ratio - 1.0), &mesh[2], &mesh[1]);
    work_correct(&before, 1.0 / (ratio - 1.0), &mesh[1], &mesh[0]);
    *floor = work_distance(&limit, &before) / ratio;
    work_correct(&limit, 16.0 / 15.0, &late[1], &mesh[1]);
    work_correct(&late[1], -1.0, &mesh[1], &mesh[0]); /* and the times' own */
    *floor = hypot(*floor, work_distance(&late[1], &late[0]));
    return limit;
}
