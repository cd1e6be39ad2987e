/* trial.c - see trial.h. */
#include "trial.h"

#include "linear/sparse.h"
#include "motion/integrate.h"
#include "plane/quadratic.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

enum { LOAD_STEPS = 8, MOTION_STEPS = 32 };

static const struct {
    const char *name;
    int slender, both; /* both: both ends are held */
    double end;        /* (s); 0: at rest */
} scenes[TRIAL_SCENES] = {
    {"weight", 1, 0, 0.0}, {"pull", 1, 1, 0.0}, {"column", 8, 1, 0.0},
    {"shake", 1, 0, 0.4}, {"swing", 1, 1, 0.03}, {"explicit", 1, 1, 0.03},
    {"push", 1, 1, 0.08},
};

const char *trial_name(enum trial_scene scene) { return scenes[scene].name; }

int trial_coarsest(enum trial_scene scene)
{
    return scenes[scene].slender == 1 ? 4 : 8;
}

/* What one trial works with. */
struct body_at_work {
    enum trial_scene scene;
    struct mesh *mesh;
    struct body *body;
    int *held;
    size_t n_dof;
    double *g, *f; /* where the held vertices are (m); nodal forces (N) */
    struct state now;
};

/* f := the nodal forces of 1 N/m^2 downwards. */
static void weigh(struct body_at_work *w)
{
    const struct body *body = w->body;
    const double density[2] = {0.0, -1.0};
    if (body->element == QUADRATIC_TRIANGLE) {
        quadratic_load(w->mesh, density, w->f);
        return;
    }
    for (int e = 0; e < body->n_element; e++)
        for (int a = 0; a < 3; a++)
            w->f[2 * body->vertex[3 * e + a] + 1] +=
                body->area[e] / 3.0 * density[1];
}

static struct body_at_work make(enum trial_scene scene, enum element element,
                                int n, double m)
{
    const int quadratic = element == QUADRATIC_TRIANGLE;
    const int cells = quadratic ? 2 * n : n, slender = scenes[scene].slender;
    struct body_at_work w = {.scene = scene};
    w.mesh = mesh_rectangle(cells, cells / slender, 1.0, 1.0 / slender);
    w.n_dof = 2 * (size_t)w.mesh->n_vertex;
    w.held = allocate(w.n_dof, sizeof *w.held);
    w.g = allocate(w.n_dof, sizeof *w.g);
    w.f = allocate(w.n_dof, sizeof *w.f);
    for (int j = 0; j <= w.mesh->rows; j++) {
        w.held[j * (cells + 1)] = 1;
        w.held[j * (cells + 1) + cells] = scenes[scene].both;
    }
    mesh_grade(w.mesh, m, MESH_LEFT | MESH_BOTTOM | MESH_TOP |
                              (scenes[scene].both ? MESH_RIGHT : 0));
    if (quadratic) quadratic_straighten(w.mesh);
    w.body = body_alloc_of(element, w.mesh,
                           material_notes(scene == WEIGHT ? CUBIC : LOG),
                           scenes[scene].end > 0.0 ? 1.0 : 0.0, LUMPED,
                           w.held);
    body_store(w.body, SPARSE);
    if (scene == WEIGHT) weigh(&w);
    w.now = state_make((int)w.n_dof);
    return w;
}

static void end(struct body_at_work *w)
{
    state_free(&w->now);
    body_free(w->body);
    mesh_free(w->mesh);
    free(w->held), free(w->g), free(w->f);
}

/* g := the held vertices after the fraction s of the way. */
static void hold(struct body_at_work *w, double s)
{
    for (int a = 0; a < w->mesh->n_vertex; a++) {
        const double *X = &w->mesh->X[2 * a];
        double *at = &w->g[2 * a];
        if (!w->held[a]) continue;
        if (w->scene == PULL) at[0] = 0.42 * s * X[0];
        if (w->scene == COLUMN) at[0] = -X[0] * (0.1 + 0.1 * X[1]) * s;
        if (w->scene == PUSH && X[0] > 0.0)
            at[0] = -0.6 * (s - sin(2.0 * M_PI * s) / (2.0 * M_PI));
        if (w->scene == SHAKE) at[1] = 0.15 * (1.0 - cos(2.0 * M_PI * s));
    }
}

/* Small displacements: one system. */
static void hang(struct body_at_work *w, struct trial *trial)
{
    double *q = allocate(w->n_dof, sizeof *q);
    trial->systems = 1;
    trial->status =
        body_assemble(w->body, at_rest(w->f), w->now.u, EXACT, q);
    if (trial->status == OK)
        trial->status = body_increment(w->body, w->body->K, q, w->now.u);
    free(q);
}

static void load(struct body_at_work *w, struct trial *trial)
{
    const struct step_control control = step_method("all");
    for (int k = 1; k <= LOAD_STEPS && trial->status == OK; k++) {
        hold(w, (double)k / LOAD_STEPS);
        step_boundary(w->body, w->g, 1, w->now.u);
        const struct step_report report =
            step_solve(w->body, &control, at_rest(NULL), w->now.u);
        trial->status = report.status;
        trial->systems += report.iterations;
    }
}

/* u := a hump in the middle, which neither loads nor moves the boundary. */
static void pluck(struct body_at_work *w)
{
    for (int a = 0; a < w->mesh->n_vertex; a++) {
        const double *X = &w->mesh->X[2 * a];
        const double hump =
            gsl_pow_2((1.0 - X[0] * X[0]) * (1.0 - X[1] * X[1]));
        w->now.u[2 * a] = 0.1 * hump;
        w->now.u[2 * a + 1] = 0.2 * hump;
    }
}

/* v half a step before u: leapfrog is then symplectic Euler. */
static void half_a_step_back(const struct model *model, double dt,
                             struct state *now)
{
    double *r = allocate((size_t)now->n, sizeof *r);
    if (model_force(model, now->u, r) != OK) die("the hump inverts");
    model_accelerate(model, r);
    for (int k = 0; k < now->n; k++) now->v[k] = 0.5 * dt * r[k];
    free(r);
}

/* What goes downhill from a state that exists: that of a body is not lost
 * because a guess was bad. */
static struct step_report downhill(struct model *model, double d,
                                   const double a[], const double b[],
                                   const double g[], double u[])
{
    double *v = allocate((size_t)model->n_dof, sizeof *v);
    memcpy(u, a, (size_t)model->n_dof * sizeof *u);
    memcpy(v, b, (size_t)model->n_dof * sizeof *v);
    const struct step_report report = step_backward_euler(
        model->body, &ROBUST, d, g, model->f, u, v, NULL);
    free(v);
    return report;
}

static void move(struct body_at_work *w, struct trial *trial)
{
    struct model *model = model_body(w->body);
    const double last = scenes[w->scene].end;
    int steps = MOTION_STEPS;
    if (w->scene == PUSH) model->solve = downhill;
    if (w->scene == SWING || w->scene == EXPLICIT) pluck(w);
    if (w->scene == EXPLICIT) {
        steps = (int)ceil(last / (0.75 * 2.0 / model_frequency(model)));
        half_a_step_back(model, last / steps, &w->now);
    }
    while (trial->status == OK && trial->steps < steps) {
        hold(w, (trial->steps + 1.0) / steps);
        const struct step_report report = integrate_step(
            model, w->scene == EXPLICIT ? SYMPLECTIC_EULER : IMPLICIT_MIDPOINT,
            last / steps, w->g, &w->now);
        trial->status = report.status;
        trial->systems += report.iterations;
        trial->steps += report.status == OK;
        trial->min_J = fmin(trial->min_J, body_min_J(w->body, w->now.u));
        if (!(trial->min_J > 0.0)) trial->status = INVERTED;
    }
    model_free(model);
}

struct trial trial_of(enum trial_scene scene, enum element element, int n,
                      double m)
{
    struct trial trial = {.status = OK, .min_J = 1.0};
    struct body_at_work w = make(scene, element, n, m);
    const int quadratic = element == QUADRATIC_TRIANGLE;
    const int along = w.mesh->n / 4;
    const int across = w.mesh->rows < along ? w.mesh->rows : along;
    const struct sparse *K = w.body->pattern;

    if (scene == WEIGHT) hang(&w, &trial);
    else if (scenes[scene].end > 0.0) move(&w, &trial);
    else load(&w, &trial);
    trial.unknowns = w.body->n_equation;
    trial.flops = K->flops + K->solve +
                  w.body->n_element * (quadratic ? 1700.0 : 250.0);
    if (scene == EXPLICIT)
        trial.flops = (double)trial.steps * w.body->n_element *
                      (quadratic ? 400.0 : 100.0);
    for (int j = 0; j <= w.mesh->rows; j += across)
        for (int i = 0; i <= w.mesh->n; i += along)
            for (int k = 0; k < 2; k++)
                trial.u[trial.n_shared++] =
                    w.now.u[2 * (j * (w.mesh->n + 1) + i) + k];
    end(&w);
    return trial;
}

double trial_longest_step(enum element element, int n, double m)
{
    struct body_at_work w = make(EXPLICIT, element, n, m);
    struct model *model = model_body(w.body);
    const double longest = 2.0 / model_frequency(model);
    model_free(model);
    end(&w);
    return longest;
}

double trial_apart(const struct trial *a, const struct trial *b)
{
    double apart = 0.0, size = 0.0;
    if (a->status != OK || b->status != OK) return INFINITY;
    for (int r = 0; r < b->n_shared; r++) {
        apart += (a->u[r] - b->u[r]) * (a->u[r] - b->u[r]);
        size += b->u[r] * b->u[r];
    }
    return sqrt(apart / size);
}
