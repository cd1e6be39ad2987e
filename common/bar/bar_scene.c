/* bar_scene.c - see bar_scene.h. */
#include "bar/bar_scene.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

struct bar_scene bar_scene_notes(enum law law, int n)
{
    return (struct bar_scene){.n = n, .material = material_notes(law),
                              .held = {1, 0}};
}

void bar_scene_force(const struct bar_scene *scene, double f_mid[])
{
    for (int e = 1; e <= scene->n; e++) /* at X = (e - 1/2) / n */
        f_mid[e - 1] = scene->shape == UNIFORM
                           ? scene->c
                           : scene->c * cos(M_PI_2 * (e - 0.5) / scene->n);
}

void bar_scene_ends(struct bar_scene *scene, int left, int right,
                    const double end[2])
{
    scene->held[0] = left;
    scene->held[1] = right;
    for (int k = 0; k < 2; k++)
        *(scene->held[k] ? &scene->g[k] : &scene->pull[k]) = end[k];
}

void bar_scene_load(const struct bar_scene *scene, double b[])
{
    const int n = scene->n;
    double *f_mid = allocate((size_t)n, sizeof *f_mid);
    bar_scene_force(scene, f_mid);
    for (int i = 0; i <= n; i++) b[i] = 0.0;
    for (int e = 1; e <= n; e++) { /* int f N_i dX = h f_mid / 2, h = 1/n */
        b[e - 1] += 0.5 / n * f_mid[e - 1];
        b[e] += 0.5 / n * f_mid[e - 1];
    }
    b[0] += scene->pull[0];
    b[n] += scene->pull[1];
    free(f_mid);
}

/* Set F1 = int_0^X f; return F2 = int_0^X F1. */
static double integrals(const struct bar_scene *scene, double X, double *F1)
{
    const double half = sin(0.5 * M_PI_2 * X); /* 1 - cos a = 2 sin^2(a/2) */
    *F1 = scene->c * (scene->shape == UNIFORM ? X : sin(M_PI_2 * X) / M_PI_2);
    return scene->c * (scene->shape == UNIFORM
                           ? 0.5 * X * X
                           : 2.0 * half * half / (M_PI_2 * M_PI_2));
}

/* P = P0 - F1 and u = u0 + (P0 X - F2) / modulus. */
double bar_scene_exact(const struct bar_scene *scene, double X, double *P)
{
    const double modulus = material_modulus(&scene->material);
    double whole, F1, u0 = 0.0;
    const double F2_end = integrals(scene, 1.0, &whole);
    const double F2 = integrals(scene, X, &F1);
    double P0 = scene->pull[1] + whole; /* P(1) = P0 - F1(1) is the pull */

    if (!scene->held[0]) P0 = -scene->pull[0];
    if (scene->held[0]) u0 = scene->g[0];
    if (scene->held[0] && scene->held[1]) /* u(1) = g gives P0, or else u0 */
        P0 = modulus * (scene->g[1] - u0) + F2_end;
    else if (scene->held[1])
        u0 = scene->g[1] - (P0 - F2_end) / modulus;
    *P = P0 - F1;
    return u0 + (P0 * X - F2) / modulus;
}

struct newton_control bar_scene_control(const struct bar_scene *scene)
{
    const double load = fabs(scene->c) + fabs(scene->pull[0]) +
                        fabs(scene->pull[1]);
    const double size = 1.0 + load / material_modulus(&scene->material) +
                        fabs(scene->g[0]) + fabs(scene->g[1]);
    return (struct newton_control){
        .tolerance = size * fmax(1e-12, 8.0 * scene->n * DBL_EPSILON),
        .max_iterations = 100};
}

struct bar_state *bar_state_alloc(const struct bar_scene *scene)
{
    const int n = scene->n;
    const size_t size = (size_t)n + 1;
    struct bar_state *state = allocate(1, sizeof *state);

    state->b = allocate(size, sizeof *state->b);
    state->u = allocate(size, sizeof *state->u);
    state->bar = (struct bar){.n = n, .h = 1.0 / n,
                              .held = {scene->held[0], scene->held[1]},
                              .b = state->b, .material = scene->material};
    bar_scene_load(scene, state->b);
    if (scene->held[0]) state->u[0] = scene->g[0];
    if (scene->held[1]) state->u[n] = scene->g[1];
    return state;
}

struct bar_state *bar_state_by(bar_load *load, const struct bar_scene *scene)
{
    struct bar_state *state = bar_state_alloc(scene);
    double *f_mid = allocate((size_t)scene->n, sizeof *f_mid);
    bar_scene_force(scene, f_mid);
    load(scene->n, state->bar.h, f_mid, scene->pull, state->b);
    free(f_mid);
    return state;
}

void bar_state_free(struct bar_state *state)
{
    if (!state) return;
    free(state->b);
    free(state->u);
    free(state);
}

struct bar_state *bar_scene_solve(const struct bar_scene *scene,
                                  const struct newton_control *control)
{
    const struct newton_control usual = bar_scene_control(scene);
    struct bar_state *state = bar_state_alloc(scene);
    state->report = bar_newton(&state->bar, control ? control : &usual,
                               state->u, NULL);
    return state;
}

double bar_state_reaction(const struct bar_state *state)
{
    const double F = bar_stretch(&state->bar, state->u, 1);
    return -state->b[0] - material1_pk1(&state->bar.material, F); /* q_0 */
}
