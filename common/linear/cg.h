/*
 * cg.h - two preconditioners for conjugate gradients: z = B r, B being
 * symmetric positive definite and like the inverse of K [alg:cg].
 *
 * Source: Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., sec. 10.3
 *         (incomplete factorisation).
 */
#ifndef COMMON_CG_H
#define COMMON_CG_H

#include "linear/csr.h"

/* z := B r. */
typedef void preconditioner(const void *context, const double r[], double z[]);

/* Precondition with the inverse of the diagonal of the csr matrix that is the
 * context [eq:jacobi]. */
void cg_jacobi(const void *csr, const double r[], double z[]);

/* ... (L L^T)^-1, the context being the factor that cg_factor() gives:
 * L L^T = K where K has entries, and L has no others [eq:incomplete].  NULL:
 * there is no such L, a pivot is not positive. */
void cg_incomplete(const void *factor, const double r[], double z[]);
struct factor *cg_factor(const struct csr *K);

#endif
