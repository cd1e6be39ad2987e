/* rung.c - see rung.h. */
#include "choice/rung.h"

#include "plane/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CAP = 400 }; /* linear systems of one solve */

/* Flops of one pass over the triangles: 60 for F, P and the forces, 40 more for
 * a logarithm, 150 for the tangent; of quadratic ones 400, and 1300. */
static double sweep(const struct ladder_state *s, int tangent)
{
    const double each = s->model.rung == LINEAR_PLANE ? 60.0
                        : s->model.rung == CUBIC_PLANE ? 80.0 : 120.0;
    if (s->body->element == QUADRATIC_TRIANGLE)
        return s->body->n_element * (tangent ? 1700.0 : 400.0);
    return s->mesh->n_triangle * (each + (tangent ? 150.0 : 0.0));
}

/* Move each section as one: u' = N / (E' A), N the force beyond it; and it
 * grows thinner as it would if nothing held it. */
static enum status bar(struct ladder_state *s)
{
    const struct material *m = &s->body->material;
    const double modulus = ladder_modulus(m);
    const double thinner = ladder_narrows(m);
    const int n = s->mesh->n, columns = n + 1;
    const double area = 2.0 / s->scene->slender, h = 2.0 / n;
    double *slope = allocate((size_t)n + 2, sizeof *slope), u = 0.0;

    for (int i = n; i > 0; i--) { /* slope of element i, left of node i */
        slope[i] = slope[i + 1];
        for (int j = 0; j <= s->mesh->rows; j++)
            /* N / (E' height), N all f_x from node i on */
            slope[i] += s->f[2 * (j * columns + i)] / (modulus * area);
    }
    for (int i = 1; i <= n; i++) {
        /* at a node, of the elements on both sides */
        const double mean = 0.5 * (slope[i] + slope[i < n ? i + 1 : n]);
        u += slope[i] * h;
        for (int j = 0; j <= s->mesh->rows; j++) {
            const int a = 2 * (j * columns + i);
            s->u[a] = u;
            s->u[a + 1] = -thinner * mean * s->mesh->X[a + 1]; /* mean: u' */
        }
    }
    s->flops = 5.0 * n;
    s->systems = 1;
    free(slope);
    return OK;
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
    matrix_combine(l->A, d * d, l->K, l->A); /* M + d^2 K */
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
    s->systems++;
    if (s->model.moving) s->flops += 20.0 * s->mesh->n_triangle;
}

static void linear_end(struct linear *l)
{
    matrix_free(l->K);
    matrix_free(l->A);
    free(l->rhs);
    free(l->some);
}

/* Solve backward Euler by Newton's method, from w by d, or for rest (w
 * NULL). */
static enum status newton(struct ladder_state *s, double d, const double w[],
                          double share, double u[])
{
    const struct step_control control = {
        .tolerance = 1e-9, .max_iterations = CAP, .chord = 1,
        .line_search = 1, .projection = ON_DEMAND};
    const struct matrix_cost cost =
        matrix_cost(BANDED, s->body->n_equation, s->body->K->p);
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    double *f = allocate(size, sizeof *f);
    for (size_t r = 0; r < size; r++) f[r] = share * s->f[r];
    const struct incremental Phi = {d, w, f};
    const struct step_report report = step_solve(s->body, &control, Phi, u);
    s->systems += report.iterations;
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

/* A moment of a motion. */
struct moment {
    double work, t;
    double *u, *v;
};

/* The moment a part x of a step 2 d after its beginning, of which the middle
 * and the end are given: v is a straight line there, and u its parabola. */
static void keep(struct moment *m, double x, double d, const double half[],
                 const double u[], const double v[], size_t size)
{
    for (size_t r = 0; r < size; r++) {
        /* half = (u0 + u) / 2, (u - u0) / (2 d) = (v0 + v) / 2 */
        const double u0 = 2.0 * half[r] - u[r], v0 = (u[r] - u0) / d - v[r];
        m->v[r] = v0 + x * (v[r] - v0);
        m->u[r] = u0 + x * d * (v0 + m->v[r]);
    }
}

/* Insert peak[2] among peak[0] and peak[1], the highest first; afterwards
 * peak[2] is scratch. */
static void sort_in(struct moment peak[3])
{
    for (int k = 2; k > 0 && peak[k].work > peak[k - 1].work; k--) {
        const struct moment higher = peak[k];
        peak[k] = peak[k - 1];
        peak[k - 1] = higher;
    }
    peak[2].work = 0.0;
}

/* Set the answer: the state in which f.u was largest, and its rival. */
static void answer(struct ladder_state *s, const struct moment peak[])
{
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    memcpy(s->u, peak[0].u, size * sizeof *s->u);
    memcpy(s->v, peak[0].v, size * sizeof *s->v);
    s->t = peak[0].t;
    if (!(peak[1].work > 0.0)) return;
    s->rival = peak[1].work / peak[0].work;
    for (size_t r = 0; r < size; r++) peak[2].u[r] = peak[1].u[r] - s->u[r];
    s->apart = ladder_size(s, peak[2].u);
}

/* Integrate from rest by the implicit midpoint rule. */
static enum status move(struct ladder_state *s)
{
    const double dt = ladder_step(s), d = 0.5 * dt;
    const size_t size = 2 * (size_t)s->mesh->n_vertex;
    double *u = allocate(size, sizeof *u), *v = allocate(size, sizeof *v);
    double *w = allocate(size, sizeof *w), *half = allocate(size, sizeof *half);
    struct moment peak[3] = {{.work = 0.0}};
    for (int k = 0; k < 3; k++) {
        peak[k].u = allocate(size, sizeof *u);
        peak[k].v = allocate(size, sizeof *v);
    }
    double before = 0.0, power = 0.0;
    struct linear linear;
    enum status status = OK;
    if (s->model.rung == LINEAR_PLANE) status = linear_start(s, d, &linear);
    for (double t = d; status == OK && t < s->scene->end; t += dt) {
        double work = 0.0, power0 = power, x = 1.0;
        for (size_t r = 0; r < size; r++) half[r] = w[r] = u[r] + d * v[r];
        if (s->model.rung == LINEAR_PLANE)
            linear_solve(s, &linear, d, w, share_of(s->scene, t), half);
        else
            status = newton(s, d, w, share_of(s->scene, t), half);
        power = 0.0;
        for (size_t r = 0; r < size; r++) {
            /* first v+ = 2 v* - v, of the old u: v* = (half - u) / d */
            v[r] = 2.0 * (half[r] - u[r]) / d - v[r];
            u[r] = 2.0 * half[r] - u[r];
            work += s->f[r] * u[r];
            power += s->f[r] * v[r];
        }
        if (power0 < 0.0 && power > 0.0) sort_in(peak); /* a new rise begins */
        /* the power f.v goes in a straight line, through 0 at x */
        if (power0 > 0.0 && power < 0.0) x = power0 / (power0 - power);
        /* f.u there: before + 2 d int_0^x f.v */
        const double top =
            before + x * d * (2.0 * power0 + x * (power - power0));
        s->fastest = fmax(s->fastest, ladder_size(s, v));
        before = work;
        if (top > peak[2].work) {
            keep(&peak[2], x, d, half, u, v, size);
            peak[2].work = top;
            peak[2].t = t - d + 2.0 * x * d;
        }
    }
    sort_in(peak);
    answer(s, peak);
    if (s->model.rung == LINEAR_PLANE) linear_end(&linear);
    for (int k = 0; k < 3; k++) {
        free(peak[k].u);
        free(peak[k].v);
    }
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

enum status rung_solve(struct ladder_state *s)
{
    if (s->model.rung == BAR) return bar(s);
    return s->model.moving ? move(s) : rest(s);
}

struct ladder_state *ladder_solve(const struct ladder_scene *scene,
                                  struct ladder_model model)
{
    return ladder_solve_of(LINEAR_TRIANGLE, 1.0, scene, model);
}

struct ladder_state *ladder_solve_of(enum element element, double grade,
                                     const struct ladder_scene *scene,
                                     struct ladder_model model)
{
    struct ladder_state *s = ladder_alloc_of(element, grade, scene, model);
    s->status = rung_solve(s);
    return s;
}
