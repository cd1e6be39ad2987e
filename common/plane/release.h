/*
 * release.h - a body that is crushed, flat, or inside out is let go: where does
 * it come to rest?
 *
 * Quasistatics without loads: u goes downhill on Psi(u) by Newton's method with
 * the projected K of body_assemble() and a line search [alg:release].  Turning
 * and shifting a free body cost nothing, so K is singular; RELEASE_SHIFT of the
 * modulus on its diagonal makes it positive definite and is felt nowhere else.
 * It is fixed, so a K whose entries are some 1e7 times the modulus hides it in
 * round-off (NOT_SPD).
 *
 * Converged is not stable, and stable is not at rest: a report says both.
 */
#ifndef COMMON_RELEASE_H
#define COMMON_RELEASE_H

#include "plane/body.h"

#define RELEASE_SHIFT 1e-8     /* of 2 mu + lambda, on the diagonal of K */
#define RELEASE_TOLERANCE 1e-9 /* of 2 mu + lambda, for max|q| (m) */
#define RELEASE_ENERGY 1e-6    /* Psi of a body at rest (J/m); round-off */

struct release_report {
    enum status status; /* OK, SADDLE: in balance, but K + shift is not SPD;
                         * INVERTED, NONFINITE, NOT_SPD, STALLED,
                         * MAX_ITERATIONS */
    int iterations;     /* linear systems solved */
    double energy;      /* Psi (J/m), unless INVERTED or NONFINITE */
    double min_J;
    int recovered;      /* OK, every J > 0, and |Psi| <= RELEASE_ENERGY */
};

/* K := K + RELEASE_SHIFT (2 mu + lambda) I. */
void release_shift(struct body *body);

/* Take u to where the body comes to rest, or to the last state reached. */
struct release_report release_solve(struct body *body, int max_iterations,
                                    double u[]);

/*
 * Return how often the triangles round a vertex go round it, the largest
 * number: 1 for an inner vertex at rest, 2 where a body is wound twice about
 * it.  No J sees that: each triangle may be upright.  Less than 1: there is no
 * inner vertex.
 */
double release_winding(const struct body *body, const double u[]);

/* Ways to crush a body: x = F X with F of rank one, upside down, or (nearly)
 * 0; u of every vertex that is not held. */
enum { N_CRUSHED = 5 };
extern const struct crushed {
    const char *name; /* "line", "oblique", "inside_out", "near_point",
                       * "point" */
    mat2 F;
} RELEASE_CRUSHED[N_CRUSHED];
void release_place(const struct body *body, mat2 F, double u[]);

/*
 * Move every vertex that is not held to a place at random in the square (-1,
 * 1)^2: two numbers of splitmix64 per vertex, in the order of the vertices.
 *
 * Source: Steele, Lea & Flood, OOPSLA 2014 (splitmix64).
 */
void release_scramble(const struct body *body, unsigned seed, double u[]);

#endif
