/*
 * cg.h - conjugate gradients for K x = b, with a preconditioner [alg:cg].
 *
 * K is never factored: an iteration takes one product K p and one z = B r, B
 * being symmetric positive definite and like the inverse of K.  On its way CG
 * meets p.Kp, the curvature of 1/2 x.Kx - b.x along p; where that is not
 * positive, K is not positive definite, and CG stops and says so.
 *
 * Source: Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., sec. 9.2
 *         (CG), 10.3 (incomplete factorisation).
 */
#ifndef COMMON_CG_H
#define COMMON_CG_H

#include "linear/csr.h"

/* z := B r. */
typedef void preconditioner(const void *context, const double r[], double z[]);

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

/* Precondition with the inverse of the diagonal of the csr matrix that is the
 * context [eq:jacobi]. */
void cg_jacobi(const void *csr, const double r[], double z[]);

/* ... (L L^T)^-1, the context being the factor that cg_factor() gives:
 * L L^T = K where K has entries, and L has no others [eq:incomplete].  NULL:
 * there is no such L, a pivot is not positive. */
void cg_incomplete(const void *factor, const double r[], double z[]);
struct factor *cg_factor(const struct csr *K);

#endif
