/* scene.c - see scene.h. */
#include "plane/scene.h"

#include "plane/quadratic.h"

#include <assert.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *scene_name(enum reading reading)
{
    static const char *const name[] = {"rigid",  "both",    "stretch",
                                       "compress", "steady", "gravity",
                                       "traction", "spin"};
    return name[reading];
}

struct scene_setting scene_notes(enum reading reading, enum law law, int n)
{
    return (struct scene_setting){.reading = reading, .n = n, .law = law,
                                  .mass = CONSISTENT, .E = 1000.0, .nu = 0.3,
                                  .rho = 1.0, .dt = 1.0 / 30.0, .reach = 1.0,
                                  .force = 50.0, .spin = 6.0, .slender = 1,
                                  .element = LINEAR_TRIANGLE, .grade = 1.0};
}

struct scene_setting scene_column(enum law law, int n, double e)
{
    struct scene_setting set = scene_notes(COMPRESS, law, n);
    set.slender = 10;
    set.rho = 0.0;
    set.dt = 1.0;
    set.reach = e;
    return set;
}

/* Add int density N_a of linear triangles: a third of the force of each. */
static void linear_load(struct scene *scene)
{
    const struct mesh *mesh = scene->mesh;
    for (int e = 0; e < mesh->n_triangle; e++) {
        double unused[6];
        const double area = mesh_gradients(mesh, e, unused);
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++)
                scene->f[2 * mesh->triangle[3 * e + a] + i] +=
                    area / 3.0 * scene->density[i];
    }
}

/* Set f_a = int density N_a + int over the right end of traction N_a: of the
 * force of an edge half at each end, of a quadratic one 1/6, 4/6 and 1/6. */
static void nodal_forces(struct scene *scene)
{
    static const double part[2][3] = {{0.5, 0.5}, {1.0 / 6, 4.0 / 6, 1.0 / 6}};
    const struct mesh *mesh = scene->mesh;
    const int quadratic = scene->set.element == QUADRATIC_TRIANGLE;
    const int n = mesh->n, cells = quadratic ? 2 : 1; /* along an edge */
    if (quadratic)
        quadratic_load(mesh, scene->density, scene->f);
    else
        linear_load(scene);
    for (int j = 0; j < mesh->rows; j += cells) {
        const int low = j * (n + 1) + n, up = low + cells * (n + 1);
        const double length = mesh->X[2 * up + 1] - mesh->X[2 * low + 1];
        for (int k = 0; k <= cells; k++)
            for (int i = 0; i < 2; i++)
                scene->f[2 * (low + k * (n + 1)) + i] +=
                    length * part[quadratic][k] * scene->traction[i];
    }
}

/* Return the mesh of a setting. */
static struct mesh *make_mesh(const struct scene_setting *set)
{
    struct mesh *mesh = mesh_rectangle(set->n, set->n / set->slender, 1.0,
                                       1.0 / set->slender);
    assert(set->n % set->slender == 0 && set->grade >= 1.0);
    assert(set->element == LINEAR_TRIANGLE ||
           set->n / set->slender % 2 == 0);
    const int ends = set->reading < GRAVITY ? MESH_LEFT | MESH_RIGHT
                                            : MESH_LEFT;
    if (set->grade > 1.0 && set->reading != SPIN)
        mesh_grade(mesh, set->grade, ends | MESH_BOTTOM | MESH_TOP);
    if (set->element == QUADRATIC_TRIANGLE) quadratic_straighten(mesh);
    return mesh;
}

struct scene *scene_alloc(const struct scene_setting *set)
{
    struct scene *scene = allocate(1, sizeof *scene);
    struct mesh *mesh = make_mesh(set);
    const size_t n_dof = 2 * (size_t)mesh->n_vertex;
    const int n = set->n;

    *scene = (struct scene){.set = *set, .mesh = mesh, .n_dof = (int)n_dof};
    scene->held = allocate((size_t)mesh->n_vertex, sizeof *scene->held);
    scene->f = allocate(n_dof, sizeof *scene->f);
    scene->g = allocate(n_dof, sizeof *scene->g);
    scene->u = allocate(n_dof, sizeof *scene->u);
    scene->v = allocate(n_dof, sizeof *scene->v);
    scene->v_before = allocate(n_dof, sizeof *scene->v_before);
    for (int a = 0; a < mesh->n_vertex; a++) {
        const double *X = &mesh->X[2 * a];
        const int left = a % (n + 1) == 0, right = a % (n + 1) == n;
        scene->held[a] = set->reading != SPIN &&
                         (left || (right && set->reading < GRAVITY));
        if (set->reading != SPIN) continue;
        scene->v[2 * a] = 0.2 - set->spin * X[1];
        scene->v[2 * a + 1] = 0.1 + set->spin * X[0];
    }
    if (set->reading == GRAVITY) scene->density[1] = -set->force;
    if (set->reading == TRACTION) {
        scene->traction[0] = 0.8 * set->force;
        scene->traction[1] = -0.6 * set->force;
    }
    nodal_forces(scene);
    scene->body = body_alloc_of(set->element, mesh,
                                material_make(set->law, set->E, set->nu),
                                set->rho, set->mass, scene->held);
    return scene;
}

void scene_free(struct scene *scene)
{
    if (!scene) return;
    body_free(scene->body);
    mesh_free(scene->mesh);
    free(scene->held);
    free(scene->f);
    free(scene->g);
    free(scene->u);
    free(scene->v);
    free(scene->v_before);
    free(scene);
}

void scene_hold(struct scene *scene, double t)
{
    const enum reading reading = scene->set.reading;
    const double s = scene->set.reach * sin(t);
    for (int a = 0; a < scene->mesh->n_vertex; a++) {
        const double X1 = scene->mesh->X[2 * a];
        double *g = &scene->g[2 * a];
        g[0] = g[1] = 0.0;
        if (!scene->held[a]) continue;
        if (reading == RIGID || reading == BOTH) g[0] = s;
        if (reading == BOTH) g[1] = s;
        if (reading == STRETCH) g[0] = X1 * s;
        if (reading == COMPRESS) g[0] = -X1 * s;
        if (reading == STEADY) g[0] = scene->set.reach * t * sin(1.0);
    }
}

void scene_rest(struct scene *scene)
{
    const size_t size = (size_t)scene->n_dof * sizeof *scene->u;
    memset(scene->u, 0, size);
    memset(scene->v, 0, size);
    memset(scene->v_before, 0, size);
    scene->steps = 0;
    scene->body->kept.usable = 0;
}

void scene_press(struct scene *scene, double e, double push)
{
    scene->set.reach = e;
    scene_hold(scene, M_PI_2); /* sin t = 1 */
    step_boundary(scene->body, scene->g, 1, scene->u);
    for (int y = 1; y < scene->n_dof; y += 2)
        if (!scene->held[y / 2])
            scene->u[y] +=
                0.5 * push * (1.0 + cos(M_PI * scene->mesh->X[y - 1]));
}

double *scene_middle(const struct scene *scene)
{
    return &scene->u[(scene->mesh->rows + 1) * (scene->mesh->n + 1)];
}

struct step_report scene_walk(struct scene *scene, const char *method, double e,
                              double push)
{
    struct step_control control = step_method(method);
    control.max_iterations = 400;
    scene_press(scene, e, fabs(*scene_middle(scene)) < 1e-3 ? push : 0.0);
    struct step_report report =
        step_solve(scene->body, &control, at_rest(NULL), scene->u);
    if (report.status == OK)
        report.status = step_certify(scene->body, at_rest(NULL), scene->u);
    return report;
}

double scene_energy(const struct scene *scene)
{
    double energy;
    return body_energy(scene->body, scene->u, &energy) == OK ? energy
                                                             : INFINITY;
}

struct step_report scene_step(struct scene *scene,
                              const struct step_control *control)
{
    const double dt = scene->set.dt;
    scene_hold(scene, (scene->steps + 1) * dt);
    const struct step_report report =
        step_backward_euler(scene->body, control, dt, scene->g, scene->f,
                            scene->u, scene->v, scene->v_before);
    scene->steps += report.status == OK;
    return report;
}

struct scene_measures scene_measure(const struct scene *scene)
{
    const double *X = scene->mesh->X, *u = scene->u, *v = scene->v;
    double *p = allocate((size_t)scene->n_dof, sizeof *p);
    struct scene_measures m = {.min_J = body_min_J(scene->body, u)};

    body_energy(scene->body, u, &m.elastic);
    body_mass(scene->body, v, p);
    for (int r = 0; r < scene->n_dof; r++) {
        m.kinetic += 0.5 * v[r] * p[r];
        m.external -= scene->f[r] * u[r];
        m.momentum[r % 2] += p[r];
        m.angular += r % 2 ? (X[r - 1] + u[r - 1]) * p[r]
                           : -(X[r + 1] + u[r + 1]) * p[r];
    }
    free(p);
    return m;
}
