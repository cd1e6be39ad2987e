/*
 * readable.h - a time step of body.h as the notes write it down.
 *
 * A loop over the elements asks the material for dP/dF in six directions; all
 * vertices have unknowns, numbered as they come; the rows and columns of the
 * held ones are corrected; GSL's banded Cholesky solves.  The same u as that of
 * step.h, which is measured against it.
 */
#ifndef FIGURES_READABLE_H
#define FIGURES_READABLE_H

#include "plane/step.h"

struct readable {
    struct body *body; /* borrowed; consistent mass, a law defined everywhere */
    double dt;
    int width;  /* half bandwidth and 1: 2 n + 6 */
    double *K;  /* [2 n_vertex * width] A[j+d][j] at K[j * width + d] */
    double *q;  /* [2 n_vertex] */
};

struct readable *readable_alloc(struct body *body, double dt);
void readable_free(struct readable *r);

/* q and K at u, without forces, as body_assemble() but of all unknowns. */
void readable_assemble(struct readable *r, const double w[], const double u[]);

/* du := -K^{-1} q at u, 0 where a vertex is held; false: K is not positive
 * definite. */
typedef int readable_increment(struct readable *r, const double w[],
                               const double u[], double du[]);
readable_increment readable_gsl;

/* A step of backward Euler to the boundary values g: Newton's method from the
 * last u to max|du| <= 1e-10 m, which stops where K is not positive definite
 * [alg:body-newton]. */
struct step_report readable_step(struct readable *r,
                                 readable_increment *increment,
                                 const double g[], double u[], double v[]);

#endif
