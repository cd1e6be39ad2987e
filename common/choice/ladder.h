/*
 * ladder.h - twelve scenes, the models that may do for them, and what each of
 * them costs.
 *
 * A scene is a body (-1, 1) x (-1/slender, 1/slender), its left end held or
 * both, with E = 1000 N/m^2 and a density of 1 kg/m^2, and its load: a constant
 * body force, on the right end a constant traction and a bending couple, on the
 * upper side a constant traction. (scene_file.h reads others, and scales them.)
 * The load stands still, rises in a straight line in the time T, or swings as
 * sin(t / T). What is asked for is the displacement at rest under the full load
 * or, where the load moves, at the moment when the load has done most work.
 *
 *     rung     unknowns                     law
 *     BAR      one number per section       linear: u' = N / (E' A)
 *     LINEAR   linear triangles             linear: one system
 *     CUBIC    the same                     cubic Neo-Hookean: Newton's method
 *     LOG      the same                     logarithmic Neo-Hookean
 *
 * each on a mesh that may be halved, at rest or in motion (implicit midpoint),
 * all with the factors of a band, so that their counted work compares.
 */
#ifndef COMMON_LADDER_H
#define COMMON_LADDER_H

#include "plane/body.h"

enum ladder_time { STANDS, RISES, SWINGS };
enum ladder_held { LADDER_LEFT, LADDER_ENDS }; /* the left end, or both */
/* The quantity of ladder_error(): the displacement, at its largest or
 * in the root mean square, or the force in the hand. */
enum ladder_quantity { LADDER_LARGEST, LADDER_RMS, LADDER_HAND };
struct ladder_scene {
    const char *name; /* a word */
    double slender;   /* length over height */
    double nu;
    double weight[2]; /* body force (N/m^2) */
    double pull[2];   /* traction on the right end (N/m) */
    double couple;    /* traction (couple Y, 0) there (N/m^2) */
    double push[2];   /* traction on the upper side (N/m) */
    enum ladder_held held;
    enum ladder_time time;
    double T;         /* (s) */
    double dt;        /* of all models in motion but the truth (s) */
    double end;       /* the motion is followed so long (s) */
    int finest;       /* level of the finest mesh that a model may have */
    enum ladder_quantity quantity;
};
enum { LADDER_SCENES = 12 };
extern const struct ladder_scene ladder_scene[LADDER_SCENES];

/* Three more, loaded along the axis and across at once: a linear answer that
 * turns by a few per cent is wrong by half or more. */
enum { LADDER_TWO_LOADS = 3 };
extern const struct ladder_scene ladder_two_loads[LADDER_TWO_LOADS];

#define LADDER_WORDS                                                         \
    "hanging cantilever small-twist large-twist below-buckling "             \
    "above-buckling slow-pull fast-pull incompressible slender-column "      \
    "stout-column shaken"

/* Return whether there is a hand whose force can be asked for: something is
 * pulled, bent or pushed, and where that moves, nothing has a weight beside
 * it. */
int ladder_has_hand(const struct ladder_scene *scene);

/* A scene, its load multiplied. */
struct ladder_scene ladder_loaded(const struct ladder_scene *scene,
                                  double load);

/* Return E' = E / (1 - nu^2): stretched lengthwise in plane strain, sides free;
 * and lambda / (2 mu + lambda), the part of the stretch by which it narrows. */
double ladder_modulus(const struct material *material);
double ladder_narrows(const struct material *material);

/* Return the force (N) under which a straight column of this length, height and
 * material buckles that is held at one end: pi^2 E' I / (4 length^2). */
double ladder_buckles(const struct ladder_scene *scene);

/* Return the load over that under which the straight body buckles; negative: it
 * is pulled; 0 where both ends are held.  The beam of ladder_buckles() under
 * all that acts along its axis, deflected by w' = a sin(pi s / 2) + b sin(3 pi
 * s / 2), s = x / length: the larger eigenvalue of int (-N) w'^2 over E' I int
 * w''^2 (Timoshenko and Gere, Theory of Elastic Stability, 2.9 and 2.11; a
 * weight is right to four digits), and for the shear 1.2 / (mu height) times
 * the mean of -N in the first of these (2.17). */
double ladder_pressed(const struct ladder_scene *scene);

/* Return whether no part of the load says to which side the body goes. */
int ladder_symmetric(const struct ladder_scene *scene);

enum rung { BAR, LINEAR_PLANE, CUBIC_PLANE, LOG_PLANE };
struct ladder_model {
    enum rung rung;
    int moving;
    int level; /* of the mesh: 4 rows of cells at 0, as square as an even
                * number of columns lets them be, and each level halves them;
                * the estimates of a BAR are made on level 0 */
};

/* The first rung: a BAR, or linear triangles where both ends are held, for
 * which there is no bar here. */
struct ladder_model ladder_first(const struct ladder_scene *scene);

/* Return "bar", "linear", "cubic" or "log". */
const char *ladder_rung(enum rung rung);

/* A scene on a mesh, and its state by a model; the pointers are owned. */
struct ladder_state {
    const struct ladder_scene *scene; /* borrowed */
    struct ladder_model model;
    struct mesh *mesh;
    struct body *body;
    double *f;          /* [2 n_vertex] nodal forces of the full load (N) */
    double *hand;       /* [2 n_vertex] of these, those of pull, couple, push */
    double *u;          /* [2 n_vertex] the displacement asked for (m) */
    double *v;          /* [2 n_vertex] its velocity, 0 at rest (m/s) */
    double t;           /* the moment of it (s) */
    double fastest;     /* the largest |v| of a motion (m/s) */
    double rival; /* the second highest peak of the load's work, over the
                   * highest, and how far apart u is (m); 0: there is none */
    double apart;
    int *across; /* [3 n_triangle] of mesh_across() */
    enum status status; /* OK, or how it was not solved */
    double flops;       /* counted: assembly, factors, solves */
    int systems;        /* linear systems solved, 1 for the sum of a bar */
};

/* Return the scene at rest, u = 0, not solved. */
struct ladder_state *ladder_alloc(const struct ladder_scene *scene,
                                  struct ladder_model model);
void ladder_free(struct ladder_state *state);

/* Return the same on the same vertices with other triangles, quadratic ones, or
 * graded towards what is held and the free sides by mesh_grade(): what the
 * estimates of relax.h say of such a mesh means nothing. */
struct ladder_state *ladder_alloc_of(enum element element, double grade,
                                     const struct ladder_scene *scene,
                                     struct ladder_model model);

/* Return the answer to the lowest eigenvalue: whether K = d2Psi/du2 is
 * positive definite at u.  A model in motion is not asked: true. */
int ladder_stable(const struct ladder_state *state);

/* The parts that a model may leave out. */
enum part { GEOMETRY, LAW, DIMENSION, INERTIA, MESH, STRESS, N_PART };
const char *ladder_part(enum part part);

/* Add to a model what it leaves out: CUBIC_PLANE for the geometry and the
 * stress, LOG_PLANE for the law, motion for the inertia, cells of half the size
 * for the mesh; a bar becomes LINEAR_PLANE with any of them.  false: it has
 * that, or there is no finer mesh, and nothing changes. */
int ladder_add(const struct ladder_scene *scene, enum part part,
               struct ladder_model *model);

/* Return M w, and M u, for the density 1, which the inertia is estimated from;
 * a new array for the caller to free. */
double *ladder_mass(const struct ladder_state *state, const double w[]);
double *ladder_momentum(const struct ladder_state *state);

/* The richest model of a scene, on the mesh after its finest: the truth that
 * the others are measured against.  Its time step, beyond the finest mesh, is
 * half of the others' (s). */
struct ladder_model ladder_truth(const struct ladder_scene *scene);
double ladder_step(const struct ladder_state *state);

/* Return max |u| over the vertices of the coarsest mesh (m), where mesh_grade()
 * has not moved them, and what the error is one of: that, the root mean square
 * over them (m), or |hand.u| (J). */
double ladder_size(const struct ladder_state *state, const double u[]);
double ladder_measure(const struct ladder_state *state, const double u[]);

/* Return the difference of two answers at these vertices, in the quantity that
 * the scene of `truth` asks for: the largest |u - u_truth| or its root mean
 * square (m), or |hand.u - hand.u_truth| (J). */
double ladder_apart(const struct ladder_state *state,
                    const struct ladder_state *truth);

#endif
