/*
 * swing.h - a large swing of the square, and the norm in which it is measured.
 */
#ifndef FIGURES_SWING_H
#define FIGURES_SWING_H

#include "motion/integrate.h"

/* Return, at rest, a large smooth swing of the square, 0 at both ends and at
 * what is prescribed: u = size (0.4 sin(pi X1), cos(pi X1 / 2)). */
struct state swing_start(const struct body *body, double size);

/* Return (v.M v)^(1/2) */
double swing_norm(const struct model *model, const double v[]);

/* Three frames (0.1 s) from a swing of SWING, 0.3 m, by so many steps in each;
 * g: the ends stay where they are. */
extern const double SWING;
enum { SWING_FRAMES = 3 };
struct swing_run {
    struct step_report total; /* status, and the sums of all steps */
    int steps;                /* made: fewer than due when not OK */
    double seconds, energy;   /* energy: over that of the start */
    struct state end;
};
struct swing_run swing_run(struct model *model, const double g[],
                           enum method method, int per_frame);

/* u := where it ends by the midpoint rule with per_frame and twice as many
 * steps, by Richardson's extrapolation (4 u_2 - u_1) / 3; error O(dt^4). */
void swing_limit(struct model *model, const double g[], int per_frame,
                 double u[]);

/* The norm of u - w, over that of the start; u is overwritten. */
double swing_distance(const struct model *model, double u[], const double w[]);

#endif
