/*
 * wound.c - one scene all the way: what is the least that shows a wound to 5 %
 * in 33 ms?
 *
 * A section through fat, 80 mm wide and 32 mm high, is held below by bone.  A
 * cut, 1 mm wide and 16 mm deep, goes in from above in its middle.  On either
 * side of it a retractor pulls the skin aside and upwards along 8 mm.  What
 * counts is how wide the cut is open above.
 *
 * The mesh is a rectangle of mesh.h, bent around the cut: its first row of
 * vertices is the side of the cut, its last one the sides and the bone, its
 * first and last columns the skin.  r = 1 has ten cells by four.
 *
 * Tables: net (the picture), law (laws at rest), mesh (elements and meshes at
 * rest), time (at rest or steps, for a slow hand and a quick one), fails (the
 * largest load in one frame that a step survives).
 */
#include "base/clock.h"
#include "../robustness/reason.h"
#include "../study/study.h"
#include "base/table.h"
#include "linear/sparse.h"
#include "motion/integrate.h"
#include "plane/quadratic.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double HALF = 40e-3, HEIGHT = 32e-3; /* (m) */
static const double WIDTH = 1e-3, DEEP = 16e-3;   /* of the cut (m) */
static const double HOOK = 8e-3;                  /* of skin, pulled (m) */
static const double E = 3000.0, NU = 0.45, RHO = 1000.0; /* of fat */
static const double PULL = 600.0, UP = 0.5; /* (N/m^2); upwards, of it */
static const double GRADE = 1.5; /* of the rows, towards the cut */
enum { FRAMES = 20, RATE = 30 }; /* pictures; of them in a second */

struct wound {
    struct mesh *mesh;
    struct body *body;
    int *held;
    double *pull, *f, *g; /* load at PULL, now (N); 0 */
    double *u, *v, *v_before;
};

/* Vertex (i, j) at X, with s from 0 at the cut to 1 outside. */
static void place(int r, int i, double s, double X[2])
{
    const int right = i <= 5 * r, c = right ? i : 10 * r - i;
    const double in[2] = {c <= 4 * r ? 0.5 * WIDTH
                                     : 0.5 * WIDTH * (5 * r - c) / r,
                          HEIGHT - DEEP * fmin(1.0, c / (4.0 * r))};
    const double out[2] = {c <= 2 * r ? HALF : HALF * (5 * r - c) / (3.0 * r),
                           HEIGHT * fmax(0.0, 1.0 - c / (2.0 * r))};
    for (int k = 0; k < 2; k++) X[k] = in[k] + s * (out[k] - in[k]);
    if (!right) X[0] = -X[0];
}

/* The traction of a retractor on the edge whose nodes a, a + next, ... are
 * `order` apart: the rectangle rule, 1000 times. */
static void pull_edge(struct wound *w, int a, int next, int order)
{
    const double *X = w->mesh->X, x0 = X[2 * a];
    const double x1 = X[2 * (a + order * next)];
    for (int k = 0; k < 1000; k++) {
        const double t = (k + 0.5) / 1000.0, x = x0 + t * (x1 - x0);
        const double linear[3] = {1.0 - t, t, 0.0};
        const double quadratic[3] = {(1.0 - t) * (1.0 - 2.0 * t),
                                     4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)};
        const double *N = order == 1 ? linear : quadratic;
        const double force = 0.001 * PULL * fabs(x1 - x0);
        if (fabs(x) > 0.5 * WIDTH + HOOK) continue;
        for (int b = 0; b <= order; b++) {
            w->pull[2 * (a + b * next)] += copysign(force, x) * N[b];
            w->pull[2 * (a + b * next) + 1] += UP * force * N[b];
        }
    }
}

/* s of row j is (j / rows)^GRADE. */
static struct wound wound_alloc(enum element element, int r, enum law law)
{
    const int n = 10 * r, rows = 4 * r;
    struct mesh *mesh = mesh_rectangle(n, rows, 1.0, 1.0);
    const size_t vertices = (size_t)mesh->n_vertex;
    const int order = element == QUADRATIC_TRIANGLE ? 2 : 1;
    struct wound w = {.mesh = mesh, .held = allocate(vertices, sizeof(int))};
    double **all[] = {&w.pull, &w.f, &w.g, &w.u, &w.v, &w.v_before};
    for (int k = 0; k < 6; k++)
        *all[k] = allocate(2 * vertices, sizeof(double));
    mesh->graded = 1;
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i <= n; i++) {
            const int a = j * (n + 1) + i;
            place(r, i, pow((double)j / rows, GRADE), &mesh->X[2 * a]);
            w.held[a] = j == rows && i >= 2 * r && i <= 8 * r;
        }
    if (order == 2) quadratic_straighten(mesh);
    for (int j = 0; j < rows; j += order)
        for (int i = 0; i <= n; i += n)
            pull_edge(&w, j * (n + 1) + i, n + 1, order);
    w.body = body_alloc_of(element, mesh, material_make(law, E, NU), RHO,
                           LUMPED, w.held);
    return w;
}

static void wound_free(struct wound w)
{
    body_free(w.body);
    mesh_free(w.mesh);
    free(w.held);
    free(w.pull);
    free(w.f);
    free(w.g);
    free(w.u);
    free(w.v);
    free(w.v_before);
}

/* How wide it is open above, beyond WIDTH (m). */
static double opening(const struct wound *w, const double u[])
{
    return u[0] - u[2 * w->mesh->n];
}

static void load(struct wound *w, double part)
{
    for (int k = 0; k < 2 * w->mesh->n_vertex; k++) w->f[k] = part * w->pull[k];
}

/* The opening in equilibrium, by four loads. */
static double rest(struct wound *w)
{
    const struct step_control newton = step_method("search");
    for (int k = 1; k <= 4; k++) {
        load(w, 0.25 * k);
        const struct step_report report =
            step_solve(w->body, &newton, at_rest(w->f), w->u);
        if (report.status != OK) die("no rest: %s", status_name(report.status));
    }
    if (step_certify(w->body, at_rest(w->f), w->u) != OK) die("not stable");
    return opening(w, w->u);
}

/* ... of linear elasticity: Newton's first increment. */
static double linear(struct wound *w)
{
    struct matrix *K = body_matrix(w->body);
    load(w, -1.0);
    if (body_stiffness(w->body, w->u, EXACT, K) != OK ||
        body_increment(w->body, K, w->f, w->u) != OK)
        die("no increment");
    matrix_free(K);
    return opening(w, w->u);
}

/* Percent. */
static double off(double value, double truth)
{
    return 100.0 * (value / truth - 1.0);
}

/* What the laws differ by, on one mesh. */
static void laws(void)
{
    double at[3], cubic, line;
    for (int k = 0; k < 3; k++) {
        struct wound w =
            wound_alloc(QUADRATIC_TRIANGLE, 8, k == 1 ? CUBIC : LOG);
        at[k] = k == 2 ? linear(&w) : rest(&w);
        wound_free(w);
    }
    cubic = off(at[1], at[0]);
    line = off(at[2], at[0]);
    table_begin_note("law", "law opening off", "r = 8: m, %%");
    table_row("log", cell_rounded(5, at[0]), MISSING);
    table_row("cubic", cell_rounded(5, at[1]), cell_rounded(2, cubic));
    table_row("linear", cell_rounded(5, at[2]), cell_rounded(3, line));
    table_end();
    claim(fabs(cubic) < 0.1 && line > 5.0, "the cubic law opens the wound as "
          "the log law does (%g %%), linear elasticity does not (%g %%)",
          cubic, line);
}

static void meshes(void)
{
    static const int r[] = {1, 2, 3, 4, 6, 7, 8, 16};
    enum { MESHES = sizeof r / sizeof *r };
    double open[2][MESHES], flops[2][MESHES], unknowns[MESHES];
    for (int e = 0; e < 2; e++)
        for (int k = 0; k < MESHES; k++) {
            struct wound w = wound_alloc(e ? QUADRATIC_TRIANGLE
                                           : LINEAR_TRIANGLE, r[k], LOG);
            const struct matrix *K = w.body->K;
            open[e][k] = rest(&w);
            unknowns[k] = K->n;
            flops[e][k] = K->storage == SPARSE
                              ? w.body->pattern->flops
                              : matrix_cost(BANDED, K->n, K->p).flops;
            wound_free(w);
        }
    /* of the quadratic ones, whose error falls by the same factor each time */
    const double *q = open[1];
    const double ratio = (q[6] - q[3]) / (q[7] - q[6]);
    const double truth = q[7] + (q[7] - q[6]) / (ratio - 1.0);
    table_begin_note("mesh", "r unknowns linear quadratic linear_flops "
                     "quadratic_flops", "too small by (%%); flops of a factor");
    for (int k = 0; k < MESHES; k++)
        table_row(r[k], unknowns[k], cell_rounded(3, -off(open[0][k], truth)),
                  cell_rounded(3, -off(q[k], truth)), flops[0][k],
                  flops[1][k]);
    table_end();
    table_begin("truth", "opening");
    table_row(cell_rounded(4, truth));
    table_end();
    claim(-off(q[2], truth) < 4.0 && -off(q[1], truth) > 5.0,
          "r = 3 is the least mesh of quadratic triangles for 5 %% (%g)",
          -off(q[2], truth));
    claim(-off(open[0][4], truth) > 5.0 && -off(open[0][5], truth) < 5.0 &&
          flops[0][5] > 5.0 * flops[1][2],
          "linear ones need r = 7, and more than five times the flops");
}

/* How a frame is made: at rest, or by steps of backward Euler or of BDF2. */
struct way {
    const char *name;
    int steps; /* in a frame; 0: at rest */
    enum method method;
};

/* The step that a method asks for, with all that makes Newton robust. */
static struct step_report robust_step(struct model *model, double d,
                                      const double a[], const double b[],
                                      const double g[], double u[])
{
    const size_t size = (size_t)model->n_dof * sizeof *u;
    double *v = allocate((size_t)model->n_dof, sizeof *v);
    memcpy(u, a, size);
    memcpy(v, b, size);
    const struct step_report report = step_backward_euler(
        model->body, model->context, d, g, model->f, u, v, NULL);
    free(v);
    return report;
}

struct motion {
    double widest;          /* opening at the end of a frame (m) */
    double systems;         /* per frame */
    double seconds[FRAMES]; /* that each took */
};

/* Move the wound while a hand pulls for `rise` seconds. */
static struct motion move(int r, struct way way, double rise)
{
    struct motion motion = {0};
    struct wound w = wound_alloc(QUADRATIC_TRIANGLE, r, CUBIC);
    struct step_control control = step_method("all");
    struct model *model = model_body(w.body);
    struct state now = state_make(model->n_dof);
    const int part = way.steps ? way.steps : 1;
    const double dt = 1.0 / (RATE * part);
    control.chord = 1;
    control.guess = FROM_VELOCITY;
    model->solve = robust_step;
    model->context = &control;
    for (int k = 1; k <= FRAMES * part; k++) {
        load(&w, k * dt < rise ? 0.5 - 0.5 * cos(acos(-1.0) * k * dt / rise)
                               : 1.0);
        const double start = clock_seconds();
        memcpy(model->f, w.f, (size_t)model->n_dof * sizeof *w.f);
        const struct step_report report =
            way.steps ? integrate_step(model, way.method, dt, w.g, &now)
                      : step_solve(w.body, &control, at_rest(w.f), now.u);
        if (report.status != OK)
            die("%s, step %d: %s", way.name, k, status_name(report.status));
        motion.seconds[(k - 1) / part] += clock_seconds() - start;
        motion.systems += (double)report.iterations / FRAMES;
        if (k % part == 0)
            motion.widest = fmax(motion.widest, opening(&w, now.u));
    }
    state_free(&now);
    model_free(model);
    wound_free(w);
    return motion;
}

/* Against BDF2 with 16 steps a frame. */
static void times_of(void)
{
    static const char *const hand[] = {"slow", "quick"};
    enum { WAYS = 8 };
    static const struct way way[WAYS] = {
        {"rest", 0, BACKWARD_EULER}, {"backward", 1, BACKWARD_EULER},
        {"backward", 4, BACKWARD_EULER}, {"backward", 16, BACKWARD_EULER},
        {"bdf2", 1, BDF2}, {"bdf2", 2, BDF2}, {"bdf2", 4, BDF2},
        {"bdf2", 16, BDF2}};
    double error[2][WAYS];
    table_begin_note("time", "hand rise way steps widest error systems",
                     "s, in a frame (0: at rest), m, %%, in a frame");
    for (int h = 0; h < 2; h++) {
        const double rise = h ? 0.1 : 0.5;
        struct motion motion[WAYS];
        for (int c = 0; c < WAYS; c++) motion[c] = move(3, way[c], rise);
        for (int c = 0; c < WAYS; c++) {
            error[h][c] =
                fabs(off(motion[c].widest, motion[WAYS - 1].widest));
            table_row(hand[h], rise, way[c].name, way[c].steps,
                      cell_rounded(4, motion[c].widest),
                      c == WAYS - 1 ? cell_word(MISSING)
                                    : cell_rounded(2, error[h][c]),
                      cell_rounded(2, motion[c].systems));
        }
    }
    table_end();
    claim(error[0][0] < 1.0, "a slow hand needs no motion (%g %%)",
          error[0][0]);
    claim(error[1][0] > 10.0 && error[1][2] > 5.0 && error[1][6] < 2.0,
          "a quick one does, and BDF2 in four steps rather than backward Euler "
          "(%g, %g, %g %%)", error[1][0], error[1][2], error[1][6]);
}

/* The largest load, in powers of 2 from 1/64 to 64, that one step survives from
 * rest, 0: none; and why the next one is lost. */
static void fails(void)
{
    static const char *const method[] = {"notes", "lift+search", "all"};
    double most[2][3];
    table_begin_note("fails", "law method survives reason", "times PULL");
    for (int l = 0; l < 2; l++)
        for (int m = 0; m < 3; m++) {
            const struct step_control control = step_method(method[m]);
            const char *reason = MISSING;
            most[l][m] = 0.0;
            for (double p = 1.0 / 64; p <= 64.0; p *= 2.0) {
                struct wound w = wound_alloc(QUADRATIC_TRIANGLE, 3,
                                             l ? LOG : CUBIC);
                load(&w, p);
                const struct step_report report = step_backward_euler(
                    w.body, &control, 1.0 / RATE, w.g, w.f, w.u, w.v,
                    w.v_before);
                wound_free(w);
                if (report.status != OK) {
                    reason = reason_of(&control, report.status);
                    break;
                }
                most[l][m] = p;
            }
            table_row(l ? "log" : "cubic", method[m], most[l][m], reason);
        }
    table_end();
    claim(most[0][2] == 64.0 && most[1][2] == 64.0 && most[0][1] < 1.0 &&
          most[1][1] < 1.0, "only projection survives the whole pull in one "
          "frame, and 64 times as much");
}

/* The sides of the quadratic triangles of r = 3 but for their diagonals, in
 * halves: at rest, and open (mm). */
static void net(void)
{
    struct wound w = wound_alloc(QUADRATIC_TRIANGLE, 3, CUBIC);
    const int n = w.mesh->n, vertices = w.mesh->n_vertex;
    rest(&w);
    table_begin("net", "when x0 y0 x1 y1");
    for (int open = 0; open < 2; open++)
        for (int a = 0; a < vertices; a++)
            for (int up = 0; up < 2; up++) {
                const int i = a % (n + 1), j = a / (n + 1);
                const int b = a + (up ? n + 1 : 1);
                if ((up ? i : j) % 2 || (up ? b >= vertices : i == n)) continue;
                const double *X = w.mesh->X, *u = w.u, mm = 1000.0;
                table_row(open ? "open" : "rest",
                          cell_rounded(5, mm * (X[2 * a] + open * u[2 * a])),
                          cell_rounded(5, mm * (X[2 * a + 1] +
                                                open * u[2 * a + 1])),
                          cell_rounded(5, mm * (X[2 * b] + open * u[2 * b])),
                          cell_rounded(5, mm * (X[2 * b + 1] +
                                                open * u[2 * b + 1])));
            }
    table_end();
    wound_free(w);
}

int main(void)
{
    gsl_set_error_handler_off();
    net();
    laws();
    meshes();
    times_of();
    fails();
    return table_finish();
}
