/* ladder.c - see ladder.h. */
#include "choice/ladder.h"

#include "plane/quadratic.h"
#include "plane/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

int ladder_has_hand(const struct ladder_scene *s)
{
    const int weighs = s->weight[0] != 0.0 || s->weight[1] != 0.0;
    const int pulls = s->pull[0] != 0.0 || s->pull[1] != 0.0 ||
                      s->couple != 0.0 || s->push[0] != 0.0 ||
                      s->push[1] != 0.0;
    return pulls && (s->time == STANDS || !weighs);
}

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

double ladder_modulus(const struct material *m)
{
    return 4.0 * m->mu * (m->mu + m->lambda) / (2.0 * m->mu + m->lambda);
}

double ladder_narrows(const struct material *m)
{
    return m->lambda / (2.0 * m->mu + m->lambda);
}

double ladder_buckles(const struct ladder_scene *scene)
{
    const struct material m = material_make(CUBIC, 1000.0, scene->nu);
    const double length = 2.0, height = length / scene->slender;
    const double I = pow(height, 3) / 12.0;
    return pow(acos(-1.0) / length, 2) * ladder_modulus(&m) * I / 4.0;
}

double ladder_pressed(const struct ladder_scene *scene)
{
    const struct material m = material_make(CUBIC, 1000.0, scene->nu);
    const double length = 2.0, height = length / scene->slender;
    const double pi2 = pow(acos(-1.0), 2), buckles = ladder_buckles(scene);
    /* -N = end + along (1 - s) */
    const double end = -scene->pull[0] * height;
    const double along =
        -(scene->weight[0] * height + scene->push[0]) * length;
    /* the 2 x 2 matrix of int (-N) w'^2 over E' I int w''^2 in a and 3 b,
     * as int 2 (1 - s) sin^2(pi s / 2) = 1/2 - 2 / pi^2 */
    const double first = (end + along * (0.5 - 2.0 / pi2)) / buckles;
    const double third = (end + along * (0.5 - 2.0 / (9.0 * pi2))) /
                         (9.0 * buckles);
    const double both = along * 2.0 / (3.0 * pi2 * buckles);
    /* its larger eigenvalue */
    const double largest = 0.5 * (first + third) +
                        hypot(0.5 * (first - third), both);
    if (scene->held == LADDER_ENDS) return 0.0;
    if (!(largest > 0.0 && first > 0.0)) return first;
    /* first * buckles: the mean of -N, weighted by w'^2 for b = 0 */
    return largest + first * buckles * 1.2 / (m.mu * height);
}

int ladder_symmetric(const struct ladder_scene *scene)
{
    return scene->weight[1] == 0.0 && scene->pull[1] == 0.0 &&
           scene->couple == 0.0 && scene->push[0] == 0.0 &&
           scene->push[1] == 0.0;
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

/* The columns of cells on the coarsest mesh, of 4 rows: as many as make them
 * about square, and even, for a quadratic triangle is made of two by two. */
enum { ROWS = 4 };
static int coarsest(const struct ladder_scene *scene)
{
    const double pairs = floor(0.5 * ROWS * scene->slender + 0.5);
    return 2 * (int)fmax(1.0, pairs);
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

/* hand := int (pull, couple) N_a on the right end + int (push) N_a on the upper
 * side, f := hand + int (weight) N_a. */
static void load(struct ladder_state *s)
{
    const struct mesh *mesh = s->mesh;
    const int n = mesh->n;
    for (int e = 0; e < mesh->n_triangle; e++)
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < 2; i++)
                s->f[2 * mesh->triangle[3 * e + a] + i] +=
                    s->body->area[e] / 3.0 * s->scene->weight[i]; /* int N_a */
    double *hand = s->hand;
    for (int j = 0; j < mesh->rows; j++) {
        const int a = 2 * (j * (n + 1) + n), b = a + 2 * (n + 1);
        const double Y[2] = {mesh->X[a + 1], mesh->X[b + 1]}, l = Y[1] - Y[0];
        for (int i = 0; i < 2; i++) {
            const double c = i ? 0.0 : s->scene->couple; /* along x */
            const double t[2] = {s->scene->pull[i] + c * Y[0],
                                 s->scene->pull[i] + c * Y[1]};
            /* int N_a t and int N_b t on the edge, t linear in Y */
            hand[a + i] += l * (2.0 * t[0] + t[1]) / 6.0;
            hand[b + i] += l * (t[0] + 2.0 * t[1]) / 6.0;
        }
    }
    const int corner = mesh->rows * (n + 1); /* the upper left one */
    for (int k = 0; k < n; k++)              /* half of an edge to each end */
        for (int a = corner + k; a <= corner + k + 1; a++)
            for (int i = 0; i < 2; i++)
                hand[2 * a + i] +=
                    s->scene->push[i] *
                    (mesh->X[2 * (corner + k + 1)] -
                     mesh->X[2 * (corner + k)]) / 2.0;
    for (int r = 0; r < 2 * mesh->n_vertex; r++) s->f[r] += hand[r];
}

/* The same for quadratic triangles, two cells of the mesh to an edge: of what
 * is linear on it a sixth of the value at each end, two thirds in the middle.
 */
static void load_quadratic(struct ladder_state *s)
{
    const struct mesh *mesh = s->mesh;
    const int n = mesh->n, corner = mesh->rows * (n + 1);
    static const double share[] = {1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0};
    quadratic_load(mesh, s->scene->weight, s->f);
    for (int j = 0; j < mesh->rows; j += 2)
        for (int k = 0; k < 3; k++) {
            const int low = j * (n + 1) + n, a = low + k * (n + 1);
            const double l = mesh->X[2 * (low + 2 * (n + 1)) + 1] -
                             mesh->X[2 * low + 1];
            const double turns = s->scene->couple * mesh->X[2 * a + 1];
            s->hand[2 * a] += l * share[k] * (s->scene->pull[0] + turns);
            s->hand[2 * a + 1] += l * share[k] * s->scene->pull[1];
        }
    for (int i = corner; i < corner + n; i += 2)
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 2; c++)
                s->hand[2 * (i + k) + c] +=
                    share[k] * s->scene->push[c] *
                    (mesh->X[2 * (i + 2)] - mesh->X[2 * i]);
    for (int r = 0; r < 2 * mesh->n_vertex; r++) s->f[r] += s->hand[r];
}

struct ladder_state *ladder_alloc(const struct ladder_scene *scene,
                                  struct ladder_model model)
{
    return ladder_alloc_of(LINEAR_TRIANGLE, 1.0, scene, model);
}

struct ladder_state *ladder_alloc_of(enum element element, double grade,
                                     const struct ladder_scene *scene,
                                     struct ladder_model model)
{
    struct ladder_state *s = allocate(1, sizeof *s);
    const int n = coarsest(scene) << model.level;
    const enum law law = model.rung == LOG_PLANE ? LOG : CUBIC;
    s->scene = scene;
    s->model = model;
    s->mesh =
        mesh_rectangle(n, ROWS << model.level, 1.0, 1.0 / scene->slender);
    if (grade > 1.0) /* towards what is held and the free sides */
        mesh_grade(s->mesh, grade, MESH_LEFT | MESH_BOTTOM | MESH_TOP |
                   (scene->held == LADDER_ENDS ? MESH_RIGHT : 0));
    if (element == LINEAR_TRIANGLE) mirror(s->mesh);
    else quadratic_straighten(s->mesh);
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    int *held = allocate((size_t)s->mesh->n_vertex, sizeof *held);
    for (int a = 0; a < s->mesh->n_vertex; a += n + 1) {
        held[a] = 1;
        held[a + n] = scene->held == LADDER_ENDS;
    }
    s->body = body_alloc_of(element, s->mesh,
                            material_make(law, 1000.0, scene->nu),
                            model.moving ? 1.0 : 0.0, CONSISTENT, held);
    free(held);
    if (s->body->K->storage != BANDED) body_store(s->body, BANDED);
    s->f = allocate(size, sizeof *s->f);
    s->hand = allocate(size, sizeof *s->hand);
    s->u = allocate(size, sizeof *s->u);
    s->v = allocate(size, sizeof *s->v);
    s->across = mesh_across(s->mesh);
    if (element == LINEAR_TRIANGLE) load(s);
    else load_quadratic(s);
    return s;
}

void ladder_free(struct ladder_state *s)
{
    if (!s) return;
    body_free(s->body);
    mesh_free(s->mesh);
    free(s->f);
    free(s->hand);
    free(s->u);
    free(s->v);
    free(s->across);
    free(s);
}

struct ladder_model ladder_truth(const struct ladder_scene *scene)
{
    return (struct ladder_model){
        LOG_PLANE, scene->time != STANDS, scene->finest + 1};
}

double ladder_step(const struct ladder_state *s)
{
    return s->model.level > s->scene->finest ? 0.5 * s->scene->dt
                                             : s->scene->dt;
}

double *ladder_mass(const struct ladder_state *s, const double w[])
{
    struct body heavy = *s->body;
    double *Mw = allocate(2 * (size_t)s->mesh->n_vertex, sizeof *Mw);
    /* a body at rest has rho = 0 */
    heavy.rho = 1.0;
    body_mass(&heavy, w, Mw);
    return Mw;
}

double *ladder_momentum(const struct ladder_state *s)
{
    return ladder_mass(s, s->u);
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

/* Return the state's vertex that is vertex (i, j) of the coarsest mesh. */
static int common(const struct ladder_state *s, int i, int j)
{
    const int fine = s->mesh->n / coarsest(s->scene);
    return fine * (j * (s->mesh->n + 1) + i);
}

/* Return whether that is where it was before mesh_grade(). */
static int stays(const struct ladder_state *s, int i)
{
    const double X = -1.0 + 2.0 * i / coarsest(s->scene);
    return fabs(s->mesh->X[2 * common(s, i, 0)] - X) < 1e-9;
}

/* Return the largest |u - v| at these vertices, or the root mean square; v
 * NULL: 0, else that of `other`. */
static double apart(const struct ladder_state *s, const double u[],
                    const struct ladder_state *other, const double v[],
                    enum ladder_quantity quantity)
{
    const int n = coarsest(s->scene);
    double largest = 0.0, squares = 0.0;
    int count = 0;
    for (int j = 0; j <= ROWS; j++)
        for (int i = 0; i <= n; i++) {
            if (!stays(s, i) || (v && !stays(other, i))) continue;
            const double *a = &u[2 * common(s, i, j)];
            const double *b = v ? &v[2 * common(other, i, j)] : NULL;
            const double off = b ? hypot(a[0] - b[0], a[1] - b[1])
                                 : hypot(a[0], a[1]);
            largest = fmax(largest, off);
            squares += off * off;
            count++;
        }
    return quantity == LADDER_RMS ? sqrt(squares / count) : largest;
}

static double work_of_hand(const struct ladder_state *s, const double u[])
{
    double work = 0.0;
    for (int r = 0; r < 2 * s->mesh->n_vertex; r++) work += s->hand[r] * u[r];
    return work;
}

double ladder_size(const struct ladder_state *s, const double u[])
{
    return apart(s, u, NULL, NULL, LADDER_LARGEST);
}

double ladder_measure(const struct ladder_state *s, const double u[])
{
    const enum ladder_quantity quantity = s->scene->quantity;
    return quantity == LADDER_HAND ? fabs(work_of_hand(s, u))
                                   : apart(s, u, NULL, NULL, quantity);
}

double ladder_apart(const struct ladder_state *s,
                    const struct ladder_state *truth)
{
    const enum ladder_quantity quantity = truth->scene->quantity;
    return quantity == LADDER_HAND
               ? fabs(work_of_hand(s, s->u) - work_of_hand(truth, truth->u))
               : apart(s, s->u, truth, truth->u, quantity);
}
