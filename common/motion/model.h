/*
 * model.h - what moves: a single mode, a linear bar, or the body of body.h.
 *
 *     M u'' = f - dPsi/du(u)
 *
 *     mode   u'' = -omega^2 u: one number, unit mass
 *     bar    linear elements on 0 < X < 1 with u(0) = 0: nodes 1..n, E = 1000,
 *            nu = 0.3, density 1                                    [eq:mass]
 *     body   body.h; u of some vertices is prescribed
 *
 * Mode and bar are linear: Psi(u) = u.A u / 2.  Vectors have n_dof entries; of
 * a body they go over all its vertices, the prescribed ones as well.
 */
#ifndef COMMON_MODEL_H
#define COMMON_MODEL_H

#include "plane/step.h"

struct model;
typedef struct step_report model_solver(struct model *model, double d,
                                        const double a[], const double b[],
                                        const double g[], double u[]);

struct model {
    int n_dof;
    struct body *body;       /* borrowed; NULL: the model is linear */
    struct matrix *M, *A;    /* mass and stiffness of a linear model; owned */
    struct matrix *M_factor; /* Cholesky factors of the mass of free unknowns */
    struct matrix *K;        /* linear: factors of M + K_step^2 A, or NULL */
    double K_step;
    double *f;               /* nodal forces (N), 0 unless set; owned */
    model_solver *solve;     /* NULL: that of integrate_solve() */
    const void *context;     /* what solve needs; borrowed */
};

struct model *model_mode(double omega);
struct model *model_bar(int n, enum mass mass);
struct model *model_body(struct body *body);
void model_free(struct model *model);

/* out := M v */
void model_mass(const struct model *model, const double v[], double out[]);

/* out := dPsi/du, without f; statuses as body_energy(), out is then
 * incomplete. */
enum status model_force(const struct model *model, const double u[],
                        double out[]);

/* r := M^-1 r of what is free, and 0 at what is prescribed: the acceleration
 * that the forces r cause. */
void model_accelerate(const struct model *model, double r[]);

/* Return v.M v / 2 + Psi(u) - f.u; infinite where Psi is not defined. */
double model_energy(const struct model *model, const double u[],
                    const double v[]);

/* q := -(M + dt^2 A)^-1 q, Newton's step for a linear model, which is exact.
 * The factors are kept as long as dt stays the same.  NOT_SPD: A is not what
 * it should be; q stays as it was. */
struct step_report model_newton(struct model *model, double dt, double q[]);

#endif
