/*
 * poisson.h - linear finite elements for -(beta u')' = f on an interval
 * [eq:poisson-strong], from the weak form [eq:poisson-weak]:
 *
 *     A_ij = int beta e_i' e_j' dx,   b_i = int f e_i dx + q_i  [eq:poisson-A]
 *                                                               [eq:poisson-b]
 *
 * with hat functions e_j [eq:hat] on nodes x_0 < x_1 < ... < x_n: n elements,
 * n + 1 nodes; element j joins nodes j - 1 and j and has length
 * h_j = x_j - x_{j-1}.  Everything is dimensionless.
 *
 * Names: bvp_.
 */
#ifndef COMMON_POISSON_H
#define COMMON_POISSON_H

#include "linear/matrix.h"

/* A given function of x: beta, f, an exact solution or its derivative. */
typedef double field(double x);

/* A smooth problem whose integrals no rule has exactly: beta = e^x, and f such
 * that u = sin 2x in (0, 1); and its u'. */
field smooth_beta, smooth_f, smooth_exact, smooth_exact_dx;

/* A constant load f on (0, 1), and given values at 0, inside and at 1. */
extern const struct poisson_held {
    double f, g[3];
} POISSON_HELD;

/* The constants 1 and 0. */
field field_one, field_zero;

/* The lecture's boundary value problem [eq:poisson-bvp]: beta = 1 + x, f =
 * (1+x)^-2 in (0, 1), u(0) = 1, beta u'(1) = -1/2; its solution u = 2 - 1/(1+x)
 * - ln(1+x) and u'. */
field bvp_beta, bvp_f, bvp_exact, bvp_exact_dx;

/*
 * Place the nodes of n elements on (a, b): x[0..n], x[0] = a and x[n] = b
 * exactly.  The element lengths form a geometric sequence with h_n / h_1 =
 * grading > 0; grading 1 gives equal spacing.
 */
void poisson_grid(double a, double b, int n, double grading, double x[]);

/* A quadrature rule on (0, 1): int g = sum_k w_k g(s_k). */
struct quadrature {
    int n;
    double s[3], w[3];
};
extern const struct quadrature MIDPOINT;  /* exact for degree 1 */
extern const struct quadrature TRAPEZOID; /* exact for degree 1 */
extern const struct quadrature GAUSS2;    /* exact for degree 3 */

/*
 * Compute stiffness and load of an element on (x0, x1) [eq:poisson-local]:
 *
 *     K[a][b] = int beta e_a' e_b' dx,  r[a] = int f e_a dx,  a, b = 0, 1.
 */
void poisson_element(double x0, double x1, field *beta, field *f,
                     const struct quadrature *rule, double K[2][2],
                     double r[2]);

/*
 * A (order n + 1, half bandwidth >= 1) and b[0..n] of n elements, without any
 * boundary condition: the natural one, zero flux.  [alg:element-assembly]
 */
void poisson_assemble(int n, const double x[], field *beta, field *f,
                      const struct quadrature *rule, struct matrix *A,
                      double b[]);

/* Integrate f of [eq:poisson-bvp] in closed form: b_i := int f e_i dx. */
void bvp_exact_load(int n, const double x[], double b[]);

/* Errors of u_h = sum_j u[j] e_j, by five-point Gauss on each element. */
struct poisson_error {
    double nodal;  /* max_j |u(x_j) - u_j| */
    double L2;     /* (int (u - u_h)^2 dx)^(1/2) [eq:norm-L2] */
    double energy; /* (int beta (u' - u_h')^2 dx)^(1/2) [eq:norm-energy] */
};
struct poisson_error poisson_errors(int n, const double x[], const double u[],
                                    field *beta, field *exact,
                                    field *exact_dx);

#endif
