/*
 * conjugate.h - conjugate gradients for K x = b, with a preconditioner
 * [alg:cg].
 *
 * K is never factored: an iteration takes one product K p and one z = B r.  On
 * its way CG meets p.Kp, the curvature of 1/2 x.Kx - b.x along p; where it is
 * not positive, K is not positive definite, and CG stops and says so.
 *
 * Source: Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., sec. 9.2.
 */
#ifndef FIGURES_CONJUGATE_H
#define FIGURES_CONJUGATE_H

#include "linear/cg.h"

struct cg_report {
    enum status status; /* OK; NOT_SPD: p.Kp or r.z is not positive; NONFINITE;
                         * MAX_ITERATIONS */
    int iterations;     /* products K p whose step was taken */
    double residual;    /* |b - K x| / |b|, as the iteration carries it along */
};

/* x := K^-1 b from x = 0, until |r| <= tolerance |b|, Euclidean norms; whatever
 * the status is, x is the last iterate. */
struct cg_report cg_solve(const struct csr *K, preconditioner *precondition,
                          const void *context, double tolerance, int cap,
                          const double b[], double x[]);

#endif
