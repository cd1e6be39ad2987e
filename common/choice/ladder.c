/* ladder.c - see ladder.h. */
#include "choice/ladder.h"

#include "plane/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CAP = 400 }; /* linear systems of one solve */

const struct ladder_scene ladder_scene[LADDER_SCENES] = {
    {"hanging", 4, 0.3, .weight = {20.0, 0.0}, .finest = 3},
    {"cantilever", 4, 0.3, .weight = {0.0, -2.0}, .finest = 3},
    {"small-twist", 4, 0.3, .couple = -20.0, .finest = 3},
    {"large-twist", 4, 0.3, .couple = -400.0, .finest = 3},
    {"below-buckling", 4, 0.3, .pull = {-9.0, -9e-6}, .finest = 3},
    {"above-buckling", 4, 0.3, .pull = {-20.0, -20e-6}, .finest = 2},
    {"slow-pull", 4, 0.3, .pull = {20.0, 0.0}, .time = RISES, .T = 3.0,
     .dt = 0.015, .end = 3.25, .finest = 1},
    {"fast-pull", 4, 0.3, .pull = {20.0, 0.0}, .time = RISES, .T = 0.1,
     .dt = 0.01, .end = 0.36, .finest = 2},
    {"incompressible", 1, 0.49, .pull = {-30.0, 0.0}, .finest = 3},
    {"slender-column", 8, 0.3, .weight = {-0.1, 0.0}, .finest = 2},
    {"stout-column", 1, 0.3, .weight = {-200.0, 0.0}, .finest = 3},
    {"shaken", 2, 0.3, .weight = {0.0, 10.0}, .time = SWINGS, .T = 0.3,
     .dt = 0.02, .end = 1.9, .finest = 1},
};

const struct ladder_scene ladder_two_loads[LADDER_TWO_LOADS] = {
    {"guyed", 4, 0.3, .weight = {0.0, -1.0}, .pull = {30.0, 0.0}, .finest = 2},
    {"leaning", 4, 0.3, .pull = {-8.0, -0.08}, .finest = 2},
    {"arch", 8, 0.3, .weight = {0.0, -0.4}, .pull = {6.0, 0.0}, .finest = 2},
};

struct ladder_scene ladder_loaded(const struct ladder_scene *of, double load)
{
    struct ladder_scene scene = *of;
    for (int i = 0; i < 2; i++) {
        scene.weight[i] *= load;
        scene.pull[i] *= load;
        scene.push[i] *= load;
    }
    scene.couple *= load;
    return scene;
}

/* E' = E / (1 - nu^2): stretched lengthwise in plane strain, sides free. */
static double bar_modulus(const struct material *m)
{
    return 4.0 * m->mu * (m->mu + m->lambda) / (2.0 * m->mu + m->lambda);
}

double ladder_buckles(const struct ladder_scene *scene)
{
    const struct material m = material_make(CUBIC, 1000.0, scene->nu);
    const double length = 2.0, height = length / scene->slender;
    const double I = pow(height, 3) / 12.0;
    return pow(acos(-1.0), 2) * bar_modulus(&m) * I / (4.0 * length * length);
}

const char *ladder_rung(enum rung rung)
{
    static const char *const word[] = {"bar", "linear", "cubic", "log"};
    return word[rung];
}

const char *ladder_part(enum part part)
{
    static const char *const word[] = {"geometry", "law", "dimension",
                                       "inertia", "mesh", "stress"};
    return word[part];
}

/* The columns of cells on the coarsest mesh, of 4 rows. */
enum { ROWS = 4 };
static int coarsest(const struct ladder_scene *scene)
{
    return (int)fmax(2.0, floor(ROWS * scene->slender + 0.5));
}

struct ladder_model ladder_first(const struct ladder_scene *scene)
{
    const enum rung rung = scene->held == LADDER_ENDS ? LINEAR_PLANE : BAR;
    return (struct ladder_model){rung, 0, 0};
}

/* Cut the cells of the upper half the other way: the mesh is then its own
 * mirror image, and a load along the axis does not bend it. */
static void mirror(struct mesh *mesh)
{
    const int n = mesh->n;
    for (int j = mesh->rows / 2; j < mesh->rows; j++)
        for (int i = 0; i < n; i++) {
            const int low = j * (n + 1) + i, up = low + n + 1;
            const int t[] = {low, low + 1, up, low + 1, up + 1, up};
            memcpy(&mesh->triangle[6 * (j * n + i)], t, sizeof t);
        }
}

/* f := int (weight) N_a + int (pull, couple) N_a on the right end + int (push)
 * N_a on the upper side. */
static void load(struct ladder_state *s)
{
    const struct mesh *mesh = s->mesh;
    const int n = mesh->n;
    for (int e = 0; e < mesh->n_triangle; e++)
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++)
                s->f[2 * mesh->triangle[3 * e + a] + i] +=
                    s->body->area[e] / 3.0 * s->scene->weight[i];
    for (int j = 0; j < mesh->rows; j++) {
        const int a = 2 * (j * (n + 1) + n), b = a + 2 * (n + 1);
        const double Y[2] = {mesh->X[a + 1], mesh->X[b + 1]}, l = Y[1] - Y[0];
        for (int i = 0; i < 2; i++) {
            const double c = i ? 0.0 : s->scene->couple;
            const double t[2] = {s->scene->pull[i] + c * Y[0],
                                 s->scene->pull[i] + c * Y[1]};
            s->f[a + i] += l * (2.0 * t[0] + t[1]) / 6.0;
            s->f[b + i] += l * (t[0] + 2.0 * t[1]) / 6.0;
        }
    }
    const int corner = mesh->rows * (n + 1); /* the upper left one */
    for (int k = 0; k < n; k++)              /* half of an edge to each end */
        for (int a = corner + k; a <= corner + k + 1; a++)
            for (int i = 0; i < 2; i++)
                s->f[2 * a + i] += s->scene->push[i] / n;
}

struct ladder_state *ladder_alloc(const struct ladder_scene *scene,
                                  struct ladder_model model)
{
    struct ladder_state *s = allocate(1, sizeof *s);
    const int n = coarsest(scene) << model.level;
    const enum law law = model.rung == LOG_PLANE ? LOG : CUBIC;
    s->scene = scene;
    s->model = model;
    s->mesh =
        mesh_rectangle(n, ROWS << model.level, 1.0, 1.0 / scene->slender);
    mirror(s->mesh);
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    int *held = allocate((size_t)s->mesh->n_vertex, sizeof *held);
    for (int a = 0; a < s->mesh->n_vertex; a += n + 1) {
        held[a] = 1;
        held[a + n] = scene->held == LADDER_ENDS;
    }
    s->body = body_alloc(s->mesh, material_make(law, 1000.0, scene->nu),
                         model.moving ? 1.0 : 0.0, CONSISTENT, held);
    free(held);
    if (s->body->K->storage != BANDED) body_store(s->body, BANDED);
    s->f = allocate(size, sizeof *s->f);
    s->u = allocate(size, sizeof *s->u);
    load(s);
    return s;
}

void ladder_free(struct ladder_state *s)
{
    if (!s) return;
    body_free(s->body);
    mesh_free(s->mesh);
    free(s->f);
    free(s->u);
    free(s);
}

/* Flops of one pass over the triangles: 60 for F, P and the forces, 40 more for
 * a logarithm, 150 for the tangent. */
static double sweep(const struct ladder_state *s, int tangent)
{
    const double each = s->model.rung == LINEAR_PLANE ? 60.0
                        : s->model.rung == CUBIC_PLANE ? 80.0 : 120.0;
    return s->mesh->n_triangle * (each + (tangent ? 150.0 : 0.0));
}

/* Each section moves as one: u' = N / (E' A), N the force beyond it; and it
 * grows thinner as it would if nothing held it. */
static void solve_bar(struct ladder_state *s)
{
    const struct material *m = &s->body->material;
    const double modulus = bar_modulus(m);
    const double thinner = m->lambda / (2.0 * m->mu + m->lambda);
    const int n = s->mesh->n, columns = n + 1;
    const double area = 2.0 / s->scene->slender, h = 2.0 / n;
    double *slope = allocate((size_t)n + 2, sizeof *slope), u = 0.0;

    for (int i = n; i > 0; i--) { /* slope of element i, left of node i */
        slope[i] = slope[i + 1];
        for (int j = 0; j <= s->mesh->rows; j++)
            slope[i] += s->f[2 * (j * columns + i)] / (modulus * area);
    }
    for (int i = 1; i <= n; i++) {
        const double here = 0.5 * (slope[i] + slope[i < n ? i + 1 : n]);
        u += slope[i] * h;
        for (int j = 0; j <= s->mesh->rows; j++) {
            const int a = 2 * (j * columns + i);
            s->u[a] = u;
            s->u[a + 1] = -thinner * here * s->mesh->X[a + 1];
        }
    }
    s->flops = 5.0 * n;
    free(slope);
}

/* Linear: A u = M w + d^2 share f, A = M + d^2 K factored; M = 0 at rest. */
struct linear {
    struct matrix *K, *A;
    double *rhs, *some;
};

static enum status linear_start(struct ladder_state *s, double d,
                                struct linear *l)
{
    const struct matrix_cost cost =
        matrix_cost(BANDED, s->body->n_equation, s->body->K->p);
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    *l = (struct linear){.K = body_matrix(s->body), .A = body_matrix(s->body)};
    l->rhs = allocate(size, sizeof *l->rhs);
    l->some = allocate(size, sizeof *l->some);
    enum status status = body_stiffness(s->body, s->u, EXACT, l->K);
    if (s->model.moving) body_mass_matrix(s->body, l->A);
    matrix_combine(l->A, d * d, l->K, l->A);
    if (status == OK) status = matrix_factor(l->A);
    s->flops += cost.flops + sweep(s, 1);
    return status;
}

static void linear_solve(struct ladder_state *s, const struct linear *l,
                         double d, const double w[], double share, double u[])
{
    const int size = 2 * s->mesh->n_vertex;
    for (int r = 0; r < size; r++) l->rhs[r] = 0.0;
    if (s->model.moving) body_mass(s->body, w, l->rhs);
    for (int r = 0; r < size; r++) l->rhs[r] += d * d * share * s->f[r];
    body_gather(s->body, l->rhs, l->some);
    matrix_solve(l->A, l->some);
    body_scatter(s->body, l->some, u);
    s->flops += matrix_cost(BANDED, s->body->n_equation, s->body->K->p).solve;
    if (s->model.moving) s->flops += 20.0 * s->mesh->n_triangle;
}

static void linear_end(struct linear *l)
{
    matrix_free(l->K);
    matrix_free(l->A);
    free(l->rhs);
    free(l->some);
}

/* Newton's method for backward Euler from w by d, or for rest (w NULL). */
static enum status newton(struct ladder_state *s, double d, const double w[],
                          double share, double u[])
{
    const struct step_control control = {
        1e-9, CAP, FROM_LAST, 0, 1, 1, ON_DEMAND};
    const struct matrix_cost cost =
        matrix_cost(BANDED, s->body->n_equation, s->body->K->p);
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    double *f = allocate(size, sizeof *f);
    for (size_t r = 0; r < size; r++) f[r] = share * s->f[r];
    const struct incremental Phi = {d, w, f};
    const struct step_report report = step_solve(s->body, &control, Phi, u);
    s->flops += report.factorisations * (cost.flops + sweep(s, 1)) +
                report.iterations * (cost.solve + sweep(s, 0));
    free(f);
    return report.status;
}

static double share_of(const struct ladder_scene *scene, double t)
{
    if (scene->time == SWINGS) return sin(t / scene->T);
    return scene->time == RISES && t < scene->T ? t / scene->T : 1.0;
}

/* Implicit midpoint from rest; u is the state in which f.u was largest. */
static enum status move(struct ladder_state *s)
{
    const double dt = s->scene->dt, d = 0.5 * dt;
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    double *u = allocate(size, sizeof *u), *v = allocate(size, sizeof *v);
    double *w = allocate(size, sizeof *w), *half = allocate(size, sizeof *half);
    double most = 0.0;
    struct linear linear;
    enum status status = OK;
    if (s->model.rung == LINEAR_PLANE) status = linear_start(s, d, &linear);
    for (double t = d; status == OK && t < s->scene->end; t += dt) {
        double work = 0.0;
        for (size_t r = 0; r < size; r++) half[r] = w[r] = u[r] + d * v[r];
        if (s->model.rung == LINEAR_PLANE)
            linear_solve(s, &linear, d, w, share_of(s->scene, t), half);
        else
            status = newton(s, d, w, share_of(s->scene, t), half);
        for (size_t r = 0; r < size; r++) {
            v[r] = 2.0 * (half[r] - u[r]) / d - v[r];
            u[r] = 2.0 * half[r] - u[r];
            work += s->f[r] * u[r];
        }
        if (work > most) {
            most = work;
            memcpy(s->u, u, size * sizeof *u);
        }
    }
    if (s->model.rung == LINEAR_PLANE) linear_end(&linear);
    free(u);
    free(v);
    free(w);
    free(half);
    return status;
}

static enum status rest(struct ladder_state *s)
{
    if (s->model.rung != LINEAR_PLANE) return newton(s, 1.0, NULL, 1.0, s->u);
    struct linear linear;
    const enum status status = linear_start(s, 1.0, &linear);
    if (status == OK) linear_solve(s, &linear, 1.0, NULL, 1.0, s->u);
    linear_end(&linear);
    return status;
}

struct ladder_state *ladder_solve(const struct ladder_scene *scene,
                                  struct ladder_model model)
{
    struct ladder_state *s = ladder_alloc(scene, model);
    if (model.rung == BAR)
        solve_bar(s);
    else
        s->status = model.moving ? move(s) : rest(s);
    return s;
}

struct ladder_model ladder_truth(const struct ladder_scene *scene)
{
    return (struct ladder_model){
        LOG_PLANE, scene->time != STANDS, scene->finest + 1};
}

double *ladder_momentum(const struct ladder_state *s)
{
    struct body heavy = *s->body;
    double *Mu = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *Mu);
    heavy.rho = 1.0;
    body_mass(&heavy, s->u, Mu);
    return Mu;
}

int ladder_stable(const struct ladder_state *s)
{
    return s->model.moving || step_certify(s->body, at_rest(NULL), s->u) == OK;
}

int ladder_add(const struct ladder_scene *scene, enum part part,
               struct ladder_model *model)
{
    const struct ladder_model old = *model;
    if (part == MESH && model->level < scene->finest) model->level++;
    if (part == INERTIA) model->moving = 1;
    if (part == LAW) model->rung = LOG_PLANE;
    if ((part == GEOMETRY || part == STRESS) && model->rung < CUBIC_PLANE)
        model->rung = CUBIC_PLANE;
    if (model->rung == BAR) model->rung = LINEAR_PLANE;
    return model->rung != old.rung || model->moving != old.moving ||
           model->level != old.level;
}

double ladder_error(const struct ladder_state *state,
                    const struct ladder_state *truth)
{
    const int n = coarsest(state->scene), rows = ROWS;
    const int a = state->mesh->n / n, b = truth->mesh->n / n;
    double off = 0.0, size = 0.0;
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i <= n; i++) {
            const double *u =
                &state->u[2 * (a * j * (state->mesh->n + 1) + a * i)];
            const double *v =
                &truth->u[2 * (b * j * (truth->mesh->n + 1) + b * i)];
            off = fmax(off, hypot(u[0] - v[0], u[1] - v[1]));
            size = fmax(size, hypot(v[0], v[1]));
        }
    return off / size;
}
