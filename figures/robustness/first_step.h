/*
 * first_step.h - the first step from rest, and the jumps that it can take.
 */
#ifndef FIGURES_FIRST_STEP_H
#define FIGURES_FIRST_STEP_H

#include "plane/scene.h"

struct scene *first_scene(enum reading reading, enum element element,
                          enum law law, int n);

/* u := 0 at held vertices; elsewhere both components anywhere within reach of
 * 0, by GSL's Mersenne twister. */
void first_scatter(struct scene *s, int seed, double reach);

/* The first step, of length dt, by step_method(method). */
struct step_report first_step(struct scene *s, const char *method, double dt);

/* Does the notes' method converge? */
int first_converges(struct scene *s, double dt);

/* Is K positive definite where the notes' method starts? */
int first_definite(struct scene *s, double dt);

/* The first jump, in steps of 0.002 h, at which `holds` does not; behind the
 * first failure of a method it may converge once more. */
double first_limit(struct scene *s, int (*holds)(struct scene *, double));

/* first[0], first[1]: where first_converges() first fails under the cubic and
 * the log law, in units of h; first[2], first[3]: where first_definite() does.
 */
void first_limits(enum element element, int n, double first[4]);

#endif
