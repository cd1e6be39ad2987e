/*
 * circuit.h - the work of a field once round a polygon: 0 for every polygon if
 * and only if the field is a gradient.
 */
#ifndef COMMON_CIRCUIT_H
#define COMMON_CIRCUIT_H

/* A field in the plane: out := its two components at x. */
typedef void circuit_field(const double x[2], void *context, double out[2]);

/* Return the integral of field . dx once round the n corners (x, y), by Gauss's
 * rule with 24 points per edge: to round-off where the field is smooth. */
double circuit_work(circuit_field *field, void *context, int n,
                    const double corner[]);

#endif
