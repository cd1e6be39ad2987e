/*
 * free_bar.h - a bar of particles that nothing holds: it rings, or its last
 * particle has just reached a node; and the fastest frequency of its nodes.
 */
#ifndef FIGURES_FREE_BAR_H
#define FIGURES_FREE_BAR_H

#include "particles/particle_bodies.h"

/* In its first mode, v = a cos(pi X), from x = 0.5003 on, two particles per
 * cell.  B is set for APIC. */
struct cloud free_bar_ringing(int order, int cells, double a,
                              enum transfer transfer);

/* Of length 1, 8 cells, two particles per cell, the last one eps h beyond the
 * place from which it reaches a further node: 9 h, or 9.5 h if order is 2. */
struct cloud free_bar_outlying(int order, double eps);

/* Return the largest frequency omega of the nodes with mass (1/s), lumped, at u
 * = 0 [eq:critical-step]; NAN where the tangent is not defined. */
double free_bar_frequency(const struct particle_body *body);

#endif
