/*
 * bar.h - one-dimensional quasistatics: a bar of linear elements and Newton.
 *
 * Nodes X_i = i h, i = 0..n, displacements u_i, F_e = 1 + (u_e - u_{e-1}) / h.
 *
 *     E(u)  = h sum_e psi(F_e) - sum_i b_i u_i                 [eq:bar-energy]
 *     q_i   = dE/du_i = P(F_i) - P(F_{i+1}) - b_i                   [eq:bar-q]
 *     K     = dq/du = sum_e P'(F_e)/h * | 1 -1 |              [eq:bar-tangent]
 *                                       |-1  1 |
 *
 * Unit cross-section; b holds body force and end loads (N).
 */
#ifndef COMMON_BAR_H
#define COMMON_BAR_H

#include "material/material.h"
#include "linear/matrix.h"

struct bar {
    int n;           /* elements */
    double h;        /* element length (m) */
    int held[2];     /* is u prescribed at node 0, at node n? */
    const double *b; /* [n+1] nodal loads; borrowed */
    struct material material;
};

/* Return F_e of element e = 1..n. */
double bar_stretch(const struct bar *bar, const double u[], int e);

/* Return the smallest of them. */
double bar_min_stretch(const struct bar *bar, const double u[]);

/* Return max |v_i| over the free nodes; INFINITY where one is not finite. */
double bar_max_free(const struct bar *bar, const double v[]);

/* INVERTED: some F_e is where the material is not defined; the outputs are
 * then incomplete.  NONFINITE: a NaN or an infinity came out. */
enum status bar_energy(const struct bar *bar, const double u[],
                       double *energy);
enum status bar_residual(const struct bar *bar, const double u[], double q[]);
enum status bar_tangent(const struct bar *bar, const double u[],
                        struct matrix *K);

struct newton_control {
    double tolerance;   /* of max|q_free| / (2 mu + lambda) and of max|du|/(nh),
                         * both at once */
    int max_iterations; /* cap */
    int line_search;    /* halve the step until the energy decreases */
    int definite;       /* stop, NOT_SPD, where K is not positive definite;
                         * else it is solved as it is */
};

/* One line of the history: the state before step k, and the step. */
struct newton_step {
    double residual;  /* max over free nodes of |q| */
    double increment; /* max |du|; 0 in the last line, where none was made */
    double energy;
    double min_F;
    double length; /* accepted fraction of the step */
};

struct newton_report {
    enum status status; /* OK, INVERTED, NONFINITE, NOT_SPD, STALLED,
                         * MAX_ITERATIONS */
    int iterations;     /* linear systems solved */
    double residual, increment; /* the last ones computed */
};

/*
 * Solve by Newton's method [alg:newton] from u, whose prescribed ends already
 * have their values.  It stops on the residual and on the increment together:
 * on either alone it stops at states that are not solutions.
 *
 * u        in/out  start, solution; the last state reached when not OK
 * history  out     max_iterations + 1 lines, or NULL; report.iterations + 1
 *                  of them are set; a number that a state does not have,
 *                  because it is INVERTED or NONFINITE, is NAN
 *
 * INVERTED   an element left the domain of the material (without line search)
 * NOT_SPD    K is singular, or not positive definite with control->definite or
 *            control->line_search; that system does not count as solved
 * STALLED    no step length decreases the energy, or the increment is at
 *            round-off while the residual is not
 */
struct newton_report bar_newton(const struct bar *bar,
                                const struct newton_control *control,
                                double u[], struct newton_step history[]);

#endif
