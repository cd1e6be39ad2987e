/*
 * particle_price.h - what an error costs with particles, over what it costs
 * with elements.
 */
#ifndef FIGURES_PARTICLE_PRICE_H
#define FIGURES_PARTICLE_PRICE_H

/* Flops of an error, or NAN: where the curve first comes below it, by lines
 * between the logarithms. */
double particle_price(const double e[], const double flops[], int sizes,
                      double wanted);

/* Table price_sixteen and its claims: for a few errors the flops of the three
 * kernels over those of elements.  Errors and flops of elements and of these
 * kernels, on 4, 8 and 16 cells; an error is INFINITY where a run fails. */
void particle_prices(double e[4][3], double flops[4][3]);

#endif
