/*
 * scene.h - the notes' square in its readings: held, moved and pulled.
 *
 * The body (-1, 1)^2, mesh.h, Neo-Hookean.  The notes prescribe "u = sin t" at
 * both ends and leave open in which direction; these are the ways to read it,
 * and three scenes that nothing forces to follow a script.  A lesson, a study,
 * a test and a benchmark that name the same scene compute the same thing.
 *
 *     rigid     ends X1 = -1 and 1 moved by reach (sin t, 0)
 *     both      ... by reach (sin t, sin t)
 *     stretch   ... by reach (X1 sin t, 0)
 *     compress  ... by reach (-X1 sin t, 0)
 *     steady    ... by reach (t sin 1, 0)
 *     gravity   left end held, body force (0, -force)
 *     traction  left end held, traction force (0.8, -0.6) on the right end
 *     spin      free; starts turning by spin, and moving at (0.2, 0.1) m/s
 *
 * Source: J. Teran's lecture notes, Lecture 2, 3.3.1 and 3.3.5.
 */
#ifndef COMMON_SCENE_H
#define COMMON_SCENE_H

#include "plane/step.h"

enum reading {
    RIGID, BOTH, STRETCH, COMPRESS, STEADY, GRAVITY, TRACTION, SPIN
};
#define SCENES "rigid both stretch compress steady gravity traction spin"
const char *scene_name(enum reading reading);

struct scene_setting {
    enum reading reading;
    int n;       /* cells per row */
    int slender; /* the body is (-1, 1) x (-b, b) with b = 1 / slender; 1: the
                  * square.  A divisor of n, for the cells are squares. */
    enum law law;
    enum mass mass;
    enum element element; /* QUADRATIC_TRIANGLE: n and the rows are even */
    double grade; /* exponent of mesh_grade() towards what is held and the free
                   * sides that meet it; 1: the cells are squares */
    double E, nu;   /* (N/m^2), - */
    double rho, dt; /* density (kg/m^2), time step (s) */
    double reach;   /* of the moving ends (m) */
    double force;   /* of gravity (N/m^2), of traction (N/m) */
    double spin;    /* angular velocity at the start (rad/s) */
};

/* The notes' numbers: E = 1000, nu = 0.3, rho = 1, dt = 1/30, reach 1,
 * consistent mass, linear triangles, grade 1; force 50, spin 6. */
struct scene_setting scene_notes(enum reading reading, enum law law, int n);

/* The column of Lecture 3, (-1, 1) x (-0.1, 0.1), both ends moved inwards by e:
 * `compress` at sin t = 1, quasistatic (dt = 1, rho = 0). */
struct scene_setting scene_column(enum law law, int n, double e);

/* A body in motion; the pointers are owned. */
struct scene {
    struct scene_setting set;
    struct mesh *mesh;
    struct body *body;
    int *held;             /* [n_vertex] is u of this vertex prescribed? */
    int n_dof;             /* 2 n_vertex */
    double density[2];     /* body force (N/m^2), constant */
    double traction[2];    /* (N/m), constant on the right end */
    double *f;             /* [n_dof] nodal forces of both (N) */
    double *g;             /* [n_dof] prescribed values, of scene_hold() */
    double *u, *v;         /* [n_dof] state (m), (m/s) */
    double *v_before;      /* [n_dof] velocity of the step before */
    int steps;             /* made so far: t = steps * dt */
};

struct scene *scene_alloc(const struct scene_setting *set);
void scene_free(struct scene *scene);

/* g := the prescribed values at time t (0 where nothing is held). */
void scene_hold(struct scene *scene, double t);

/* u, v, v_before and steps := 0; factors of earlier steps serve no more. */
void scene_rest(struct scene *scene);

/* The guess for a column whose ends have moved on to e inwards: the way there
 * lifted into u [eq:lift-2d], and pushed sideways, `push` in the middle (m). */
void scene_press(struct scene *scene, double e, double push);

/* Return where the column's deflection is, u2 of the vertex at (0, 0) (m); for
 * an even number of cells along and across. */
double *scene_middle(const struct scene *scene);

/* Walk on to e from where the column is, pushed while it is straight (a
 * deflection below 1e-3 m): at most 400 systems of step_method(method), and if
 * that is OK, the status of step_certify(). */
struct step_report scene_walk(struct scene *scene, const char *method, double e,
                              double push);

/* Return Psi(u) (J); INFINITY where it is not defined. */
double scene_energy(const struct scene *scene);

/* The next step of backward Euler of step.h.  u, v and steps stay as they are
 * when the status is not OK. */
struct step_report scene_step(struct scene *scene,
                              const struct step_control *control);

struct scene_measures {
    double kinetic, elastic, external; /* energies (J); external: -f.u */
    double momentum[2], angular;       /* sum M v, sum x cross M v */
    double min_J;
};

/* Return energies and momenta of the state, which the material must allow. */
struct scene_measures scene_measure(const struct scene *scene);

#endif
