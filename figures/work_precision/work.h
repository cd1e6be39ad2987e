/*
 * work.h - scenes of the square, all knobs of the course, and what a setting
 * of them costs.
 *
 *     slow pull    both ends apart, 0.42 m each within 1 s
 *     fast pull    right end 0.6 m away within 0.06 s; at 0.08 s
 *     shake        left end 0.3 m up and down again in 0.4 s; the rest free
 *     swing        a hump in the middle is let go, both ends held; at 0.03 s
 *     buckle       a column, 8 times as long as wide, its ends 0.1 m inwards
 *                  each within 2 s, and turned a little
 *     push         right end 0.6 m inwards within 0.08 s, in the middle of it
 *                  with 0.4 of the speed of sound
 *     jolted pull  the ends apart by 0.5 sin t, for 1 s: a pull that begins
 *                  with a jolt; not one of the six
 *     weight       left end held, its weight of 50 N/m^2 let go; at 0.15 s;
 *                  not one of the six either
 *
 * The notes' material and density; lumped mass, so that the explicit method
 * takes part.  A setting is one choice of every knob.  The answer is u at the
 * end at the vertices that all meshes share, and settings are compared by
 * them [eq:error-parts].
 */
#ifndef FIGURES_WORK_H
#define FIGURES_WORK_H

#include "motion/integrate.h"
#include "plane/scene.h"

enum work_scene {
    SLOW_PULL, FAST_PULL, SHAKE, SWING, BUCKLE, PUSH, JOLTED_PULL, WEIGHT,
    WORK_SCENES
};
const char *work_scene_name(enum work_scene scene); /* "slow_pull", ... */
double work_end(enum work_scene scene);             /* (s) */

/* The elements whose limit is known best; a squeezed corner of quadratic ones
 * is inverted on fine meshes, and waves with kinks are no better with them. */
enum element work_limit_element(enum work_scene scene);

/* Return the cells per row of the coarsest mesh; others have a multiple. */
int work_coarsest(enum work_scene scene);

struct work_setting {
    enum work_scene scene;
    enum law law;       /* LINEAR: small displacements, one system per step */
    int dynamic;        /* 0: static, method is then not looked at */
    int n;              /* cells per row */
    int steps;          /* of equal length; static: load steps */
    enum method method; /* SYMPLECTIC_EULER: not with LINEAR (asserted) */
    double tolerance;   /* of Newton's method (m), see step.h */
    enum element element; /* QUADRATIC_TRIANGLE: n counts half of its edges */
    double grade;         /* as in scene.h; 0 is 1, too */
};

enum { WORK_SHARED = 25 };
struct work {
    enum status status;  /* of the last step; not OK: no u, no error */
    int steps, systems;  /* steps made, linear systems solved in them */
    int factorisations;
    double flops;        /* counted, see work_flops() */
    double seconds;      /* of the steps alone */
    double min_J;        /* at the end, of triangles */
    int n_shared;        /* entries of u below */
    double u[2 * WORK_SHARED]; /* at the shared vertices (m) */
};

/* Run from rest to the end of the scene.  NONFINITE also where the explicit
 * method has left the scene: some |u| > 100 m. */
struct work work_run(const struct work_setting *set);

/* Make the parts of a run: the body of a setting at rest, freed by
 * scene_free(); s->g := where the held vertices are at time t; u := the hump
 * that SWING begins with, which neither loads nor moves the boundary; and, as
 * the answer, u at the vertices that all meshes of the scene share. */
struct scene *work_alloc(const struct work_setting *set);
void work_hold(struct scene *s, enum work_scene scene, double t);
void work_pluck(const struct scene *s, double u[]);
void work_share(const struct mesh *mesh, const double u[], struct work *work);

/* Return the flops of all elements: 250 for one with its tangent, 100 without
 * [eq:roofline], 1700 and 400 for a quadratic one. */
double work_elements(const struct body *body, enum tangent tangent);

enum { WORK_BANDED_BELOW = 36 };

/*
 * Return the flops of what was solved: a factorisation and the two triangular
 * solves as matrix_cost() has them, and the elements.  Per step one residual
 * more than systems is looked at.  Of a banded K, as work_run() has it of all
 * elements with less than WORK_BANDED_BELOW rows of cells.
 */
double work_flops(const struct body *body, int steps, int systems,
                  int factorisations);

/* Return the root mean square of |a - b| over the shared vertices (m); of |a|
 * for b NULL.  INFINITY if one of the runs is not OK. */
double work_distance(const struct work *a, const struct work *b);

/* u := u + s (a - b) at the shared vertices: what a chain of corrections is
 * made of.  A status that is not OK is taken over. */
void work_correct(struct work *u, double s, const struct work *a,
                  const struct work *b);

/*
 * The limit n, steps -> infinity of a setting's model, its law, static or
 * dynamic, by its elements.  With N = 12 times the coarsest mesh, of quadratic
 * triangles 16 times, S its steps,
 *
 *     u_N,S + (u_N,S - u_N/2,S) / (2^p - 1) + 16/15 (u_N/2,4S - u_N/2,S)
 *
 * by the midpoint rule, p the order that N/4, N/2, N show, between 1 and 2.
 * *floor is what is not known of it (m): 2^-p of what the extrapolation from
 * N/4 and N/2 differs, and what the correction in time is different on N/4.
 */
struct work work_limit(const struct work_setting *model, double *floor);

#endif
