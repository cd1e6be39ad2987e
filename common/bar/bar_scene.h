/*
 * bar_scene.h - bars: what holds them, what pulls, and what they weigh.
 *
 *     0 < X < 1, n equal elements, unit cross-section, a material of
 *     material.h; each end is held (u = g) or free (force pull), and a body
 *     force acts in between:
 *
 *         held |o-----o-----o--- ... ---o--> pull      f = c, or
 *              0                        1              f = c cos(pi X / 2)
 *
 * A lesson, a study, a test and a benchmark that name the same scene compute
 * the same thing.  The notes' bar is held on the left and free on the right;
 * their example moves its left end, u(0, t) = sin t.  Under a body force c > 0
 * it hangs, under c < 0 it stands.
 *
 * Source: J. Teran's lecture notes, Lecture 2, 2.1 to 2.5; Problem Session III.
 */
#ifndef COMMON_BAR_SCENE_H
#define COMMON_BAR_SCENE_H

#include "bar/bar.h"

enum shape { UNIFORM, COSINE };

struct bar_scene {
    int n; /* elements */
    struct material material;
    int held[2];     /* is u given at X = 0, at X = 1? */
    enum shape shape;
    double c;        /* size of the body force (N/m) */
    double g[2];     /* displacement of a held end (m) */
    double pull[2];  /* force on a free end (N), positive to the right */
};

/* The notes' bar with their E and nu, at rest and without a load. */
struct bar_scene bar_scene_notes(enum law law, int n);

/* Hold the left end, the right one; end[k] is u of an end that is held (m), the
 * force on one that is not (N). */
void bar_scene_ends(struct bar_scene *scene, int left, int right,
                    const double end[2]);

/* Set f_mid[e - 1] = f at the middle of element e = 1..n. */
void bar_scene_force(const struct bar_scene *scene, double f_mid[]);

/* Set b_i = int f N_i dX by the midpoint rule, and the forces on the ends;
 * b[0..n] [eq:bar-b]. */
void bar_scene_load(const struct bar_scene *scene, double b[]);

/*
 * Return the exact solution under the linear law, at any X: u(X), and P(X) in
 * *P [eq:bar-linear].  With no end held the loads must balance; u is then the
 * one with u(0) = 0.
 */
double bar_scene_exact(const struct bar_scene *scene, double X, double *P);

/*
 * Allow full steps, at most 100 of them, with indefinite tangents solved as
 * they are.  The tolerance is 1e-12, or what round-off allows: q has the
 * rounding of F in it, eps |u| / h, and |u| grows with the load.
 */
struct newton_control bar_scene_control(const struct bar_scene *scene);

/* A bar and its nodal values. */
struct bar_state {
    struct bar bar;
    double *b, *u; /* [n+1] loads (N), displacements (m); owned */
    struct newton_report report; /* of bar_scene_solve() */
};

/* Return the bar at rest, its held ends where they have jumped to. */
struct bar_state *bar_state_alloc(const struct bar_scene *scene);
void bar_state_free(struct bar_state *state);

/* The same, its loads b by another function than bar_scene_load(). */
typedef void bar_load(int n, double h, const double f_mid[],
                      const double pull[2], double b[]);
struct bar_state *bar_state_by(bar_load *load, const struct bar_scene *scene);

/* Solve the same by bar_newton() with `control`, or with bar_scene_control()
 * where control is NULL. */
struct bar_state *bar_scene_solve(const struct bar_scene *scene,
                                  const struct newton_control *control);

/* Return the force that holds the left end, or pulls it. */
double bar_state_reaction(const struct bar_state *state);

#endif
