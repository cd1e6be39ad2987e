/*
 * live.h - the square in somebody's hand: thirty frames per second, and none
 * may be lost.
 *
 * The square of mesh.h, its left side held, the notes' material; linear
 * triangles with their consistent mass, or quadratic ones on the same vertices.
 * A hand takes all vertices that are near it, or the right side, and carries
 * them wherever it goes.
 *
 *     while there is input
 *         live_input(live, pointer);        keys; the hand grabs or lets go
 *         live_hand(live->hand, pointer, hand);
 *         live_carry(live, hand);           the held values at its end: live->g
 *         live_frame(live);                 u and v advance by a frame
 *
 * A frame is a budget of FRAME_SYSTEMS linear systems [alg:live-frame]:
 *
 *     fast      from the elastic lift of the state [eq:elastic-lift], factors
 *               kept, FAST_SYSTEMS at most
 *     downhill  backward Euler from the *last* state: the projected lift, the
 *               hand going 1, 1/2, 1/4, 1/8 of its way until live_start()
 *               takes it, at last 0; line search, projection on demand,
 *               with what is left of the budget.  What has not converged by
 *               then is accepted, because Phi has fallen.  v = 0 after a frame
 *               that is unfinished, or in which the hand was held back.
 *
 * Trouble lasts: after a frame downhill with more than CALM_SYSTEMS the next
 * one begins downhill.
 */
#ifndef COMMON_LIVE_H
#define COMMON_LIVE_H

#include "motion/integrate.h"
#include "motion/pointer.h"

enum grab { PATCH, SIDE };                 /* the hand takes one or the other */
enum start { ELASTIC, ROWS, LAST_STATE };  /* `fast` starts from live_lift(),
                                            * step_boundary(), the last state */

enum { FRAME_SYSTEMS = 8, FAST_SYSTEMS = 6, CALM_SYSTEMS = 3, LIVE_TRIES = 4 };
enum { ALONE_SYSTEMS = 40 }; /* at most, of `fast` without a second rung */

/* Newton's tolerance (m): a fiftieth of a pixel of the window. */
#define LIVE_TOLERANCE 1e-4

/* The hand goes this far in a frame at most (m), stays this near to 0 (m), and
 * takes vertices this near to it (m). */
#define LIVE_REACH 0.25
#define LIVE_FAR 10.0
#define LIVE_RADIUS 0.3

/* Farther than this nothing goes in a frame (m): sound goes 1.2 m. */
#define LIVE_LEAP 1.0

struct live_setting {
    int n; /* squares per side */
    enum law law;
    enum method method; /* BACKWARD_EULER or IMPLICIT_MIDPOINT */
    enum grab grab;
    enum start start;
    int fallback; /* 0: fast alone; the frame is lost when it fails */
    enum element element; /* QUADRATIC_TRIANGLE: n is made even */
};

struct live {
    struct live_setting set;
    double dt; /* 1/30 s */
    struct mesh *mesh;
    struct body *body; /* with the vertices that are held now */
    int n_dof;
    struct state now;
    int trouble;     /* does the next frame begin downhill? */
    int holding;     /* does the hand hold anything? */
    double hand[2];  /* where it is (m) */
    double *grip;    /* [n_dof] the held vertices, from the hand (m) */
    double *g;       /* [n_dof] prescribed values at the end of the frame */
};

struct live *live_alloc(const struct live_setting *set);
void live_free(struct live *live);

/* The frame's key; grabbing, letting go and another element make a new body.
 * The state is kept, but for a reset and another mesh.  body_store(live->body,
 * PLAIN) holds for the bodies that follow: a script then has the same frames,
 * to the last digit, on every machine. */
void live_input(struct live *live, const struct pointer *pointer);

/* to := where a hand at `from` is after a frame, on its way to the pointer
 * [eq:live-hand]. */
void live_hand(const double from[2], const struct pointer *pointer,
               double to[2]);

/* live->g := the held values with the hand at `to`. */
void live_carry(struct live *live, const double to[2]);

struct live_report {
    const char *first;  /* how `fast` ended; "untried" in trouble */
    enum status status; /* of the last rung; MAX_ITERATIONS: unfinished */
    const char *rung;   /* "fast", "downhill", "lost" */
    int systems;        /* linear systems solved, all together */
    double part;        /* of its way that the hand went */
};

/*
 * u := u0 with the held values g, and what that does to the rest
 * [eq:elastic-lift], the first iteration of Newton's method, in which the jump
 * enters linearly:
 *
 *     K du = -(q(u0) + K_fh (g - u0)),   u = u0 + du, and g where it is held
 *
 * q and K of Phi at u0, K projected or exact.  OK, or the status of an assembly
 * or of the factorisation, or NONFINITE: K is so nearly singular that something
 * would move by more than LIVE_LEAP, and u is that lift.  Otherwise, if not OK,
 * u is of no use.
 */
enum status live_lift(struct body *body, struct incremental Phi,
                      const double u0[], const double g[],
                      enum tangent tangent, double u[]);

/*
 * Ask whether u, lifted to the held values g, is a start for the second rung.
 * OK; or the status of step_potential() at u; or STALLED, where Phi is larger
 * than with the free vertices left where they are.  (Where K is nearly singular
 * a lift can be finite, defined and worse than none; on fine meshes frames
 * without end follow from one.)
 */
enum status live_start(const struct live *live, struct incremental Phi,
                       const double g[], const double u[]);

/*
 * The second rung [alg:downhill]: u, v := the end of the frame, or 0 for v
 * where it is unfinished or the hand was held back.  Of the report it sets
 * `part` and adds to `systems`, up to FRAME_SYSTEMS, of which the last is not
 * for a lift; the status is that of step_solve() with LIVE_DOWNHILL.
 */
enum status live_downhill(struct live *live, double u[], double v[],
                          struct live_report *report);
extern const struct step_control LIVE_DOWNHILL;

/* Make one frame; hand, u and v advance [alg:live-frame]. */
struct live_report live_frame(struct live *live, const double to[2]);

/* The same with a lift and a second rung of one's own. */
typedef enum status live_lifter(struct body *body, struct incremental Phi,
                                const double u0[], const double g[],
                                enum tangent tangent, double u[]);
typedef enum status live_rung(struct live *live, double u[], double v[],
                              struct live_report *report);
struct live_report live_frame_by(struct live *live, live_lifter *lift,
                                 live_rung *downhill, const double to[2]);

/* Count the vertices inside the body round which the angles of their triangles
 * do not add up to 2 pi: it is wound twice there, or inside out [eq:winding].
 * knot[a] := is vertex a one?  NULL: do not say.  The triangles are those of
 * the mesh: a quadratic one is four of them, with straight sides between its
 * six nodes. */
int live_knots(const struct mesh *mesh, const double u[], int knot[]);

/* Return v.M v / 2 + Psi(u) */
double live_energy(const struct live *live);

#endif
