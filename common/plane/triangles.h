/*
 * triangles.h - what body.h adds up over its triangles.
 *
 * Written once for linear triangles, with one point each, and for the quadratic
 * ones of quadratic.h, with three; the compiler makes two of it.  Everything
 * that is no triangle's, is body.h's.
 */
#ifndef COMMON_TRIANGLES_H
#define COMMON_TRIANGLES_H

#include "plane/body.h"

/* Return F at point p of triangle e. */
mat2 triangles_deformation(const struct body *body, const double u[], int e,
                           int p);

/* Compute Psi(u) [eq:body-energy]; statuses as body_energy(). */
enum status triangles_energy(const struct body *body, const double u[],
                             double *energy);

/* q += dt^2 dPsi/du and, unless NO_TANGENT, body->K += its derivative
 * [eq:element-force] [eq:element-tangent]; of linear triangles with their mass,
 * and many at once, lanes.h.  Statuses as body_energy(). */
enum status triangles_assemble(const struct body *body, struct incremental Phi,
                               const double u[], enum tangent tangent,
                               double q[]);

/* The same, digit by digit, one triangle after the other: the readable program,
 * by which the fast one is judged. */
enum status triangles_one_by_one(const struct body *body,
                                 struct incremental Phi, const double u[],
                                 enum tangent tangent, double q[]);

#endif
