/*
 * lanes.h - the element loop of triangles.h for many triangles at once.
 *
 * V linear triangles, vec.h, stand side by side in the lanes of a register, and
 * one instruction computes the same number of all of them.  Each lane does what
 * triangles.c does, operation by operation, and what it adds to q and K is
 * added in the order of the triangles: all digits are the same, whatever V is.
 *
 * lanes_assemble() and lanes_energy() begin with triangle *next, the first of a
 * group of V, and *next is then the first that they have not taken: of a group
 * that is not whole, or that they leave to triangles.c.
 */
#ifndef COMMON_LANES_H
#define COMMON_LANES_H

#include "plane/body.h"

/* Return gradients and areas of the triangles, by groups.  The caller frees. */
double *lanes_alloc(const struct body *body);

/* Return where the group of triangle e ends. */
int lanes_end(const struct body *body, int e);

/* Assemble as triangles_assemble(), for linear triangles (asserted); PROJECTED
 * leaves a group in which there may be something to clamp [eq:projection]. */
enum status lanes_assemble(const struct body *body, struct incremental Phi,
                           const double u[], enum tangent tangent, double q[],
                           int *next);

/* *energy += that of linear triangles (asserted), the cubic law's; it leaves
 * those of any other. */
enum status lanes_energy(const struct body *body, const double u[],
                         double *energy, int *next);

#endif
