/*
 * relax.h - what forces that a model of ladder.h has left out would move.
 *
 * A model K u = f that leaves out forces which are linear in the displacement,
 * D u, should have solved K v = f + D v.  So its answer lacks e = v - u,
 *
 *     (K - D) e = D u                                         [eq:left-forces]
 *
 * and factors of K are there.  K^-1 (K - D) has all but a few eigenvalues near
 * 1, so two steps of conjugate gradients with K as the preconditioner [alg:cg]
 * are nearly exact: two solves.  A part of the estimate is |e| / |u + e|, in
 * the norm that the error has, ladder_size().
 *
 * K is that of rest: of a nonlinear model d2Psi/du2 at u, and e is then the
 * first step of Newton's method; else the linear one.
 *
 * Names: relax_, ladder_.
 */
#ifndef COMMON_RELAX_H
#define COMMON_RELAX_H

#include "choice/ladder.h"

/* A displacement w on the triangles: its gradient H, and the stress P + p I
 * that it brings (N/m^2), dP/dF : H in general and for w = u the stress that u
 * has. p = nu tr(stress), of the linear law lambda tr(strain), is kept apart,
 * for in this part of the stress linear triangles lock. */
struct relax_field {
    const mat2 *H, *P; /* [n_triangle]; borrowed */
    const double *p;   /* [n_triangle] */
};

/* Return P of the model's law at u in triangle e (N/m^2); of a BAR the linear
 * one. */
mat2 relax_stress(const struct ladder_state *state, int e);

/* g_a += int T grad N_a for the three vertices of triangle e (N), T constant.
 */
void relax_push(const struct ladder_state *state, int e, mat2 T, double g[]);

/* Return the factors of K, for the caller to free; NULL: K is not positive
 * definite, or u has no K or no stress, as LOG has none where J <= 0. */
struct matrix *relax_factors(const struct ladder_state *state);

/* g += D w, the nodal forces left out of a displacement (N); g: [2 n_vertex].
 */
typedef void relax_forces(const struct ladder_state *state,
                          const struct relax_field *of, double g[]);

/*
 * e := of (K - D) e = D u, D by `forces`, by so many steps of conjugate
 * gradients from 0; after one of them it is d / (1 - t), d = K^-1 D u, t =
 * d.D d / d.K d.  false: the energy p.(K - D) p of a direction is not > 0, so
 * that the body gives way, or the forces are not finite; e is of no use.
 */
int relax_follow(const struct ladder_state *state,
                 const struct matrix *factors, relax_forces *forces, int steps,
                 double e[]);

/*
 * Return |e| / |u + e| after two steps, |.| of ladder_measure(); 0 for u = 0, 1
 * where relax_follow() is false or there are no factors (NULL).
 *
 * Of the force in the hand it is |hand.e| / hand.z [eq:left-hand], where
 * (K - D) z = hand, by three steps: K and D are symmetric, so hand.e is z.D u,
 * and one more solve is all that it takes.  In motion |hand.e| is over
 * |hand.(u + e)|.
 */
double relax_part(const struct ladder_state *state,
                  const struct matrix *factors, relax_forces *forces);

/*
 * The same of forces that are not linear in u, by one step of Newton's method.
 * What the stress of the cubic law less that of the logarithm would move; 1
 * where a J <= 0 or beyond RELAX_SERIES: r of the cubic law has the first terms
 * of the series of ln J in J - 1, which has no sum there, so that both may be
 * near each other by chance, and the cubic law has a second state.  And what
 * the squares of H would, after the stress has turned with the body: at
 * w = u + e the cubic law leaves N(w) - D w of the forces N(w) =
 * int (P_linear - P_cubic) grad N.  *together is what
 * both would, D u and these, which often move a body to opposite sides.
 */
#define RELAX_SERIES 2.0
double relax_law(const struct ladder_state *state,
                 const struct matrix *factors);
double relax_geometry(const struct ladder_state *state,
                      const struct matrix *factors, relax_forces *stress,
                      double *together);

/*
 * Return the part for which a bar has no unknowns, where the moment differs
 * from section to section: as estimate_dimension() with the deflection of a
 * beam, at its largest and with shear, over 1 - p, p of ladder_pressed(); 1
 * from p = 1 on.
 * Of the force in the hand, with m and n of the hand alone, int m M / I, s^2 /
 * 2 |n N| and int n w'^2 / 2, by which a bend w shortens the axis, over int m^2
 * / I and n^2 / height, by which it moves its own side [eq:left-hand].
 */
double relax_dimension(const struct ladder_state *state);

/*
 * Return ladder_apart() over ladder_measure() of the truth.  Of the force in
 * the hand: a hand that moves its sides as far as the model says, along its
 * forces and in their mean, must pull harder or less by |hand.(u - u_truth)| /
 * hand.K^-1 hand, K of the truth, to first order [eq:left-hand]; in motion,
 * where a force brings all of the work, over |hand.u_truth|.
 */
double ladder_error(const struct ladder_state *state,
                    const struct ladder_state *truth);

/*
 * Return the part of the mesh: relax_part() of its forces, and in motion what
 * these and the time step have made it late by, and the rival where it may be
 * the higher one: where its work is less by at most half of that part.  They
 * stiffen the motion by |K^-1 D v| over |v|, which makes the frequency too high
 * by half of that, and the midpoint rule makes it (omega dt)^2 / 12 too low;
 * after the time t the displacement is off by the angle of it, at most 2, times
 * the amplitude |v| / omega [eq:left-phase].  Two peaks that are alike have one
 * force in the hand, for which no rival counts.
 */
double relax_mesh(const struct ladder_state *state,
                  const struct matrix *factors, relax_forces *mesh);

/*
 * part[MESH] and part[STRESS], K factored for both; of a plane model at rest
 * part[INERTIA] becomes the part that swings [eq:left-slowest], if that is
 * more.  A strain or a stress that is wrong in one corner may hardly move the
 * body: of the cubic law part[LAW] becomes relax_law(), and of the linear one
 * part[GEOMETRY] relax_geometry(), where that is less, or for the force in the
 * hand, which feels by how much a turn shortens a body.  Then let h be the root
 * of the squares of GEOMETRY and STRESS: both are multiplied so that it becomes
 * that of `together` and 2 h^2, if that is less [eq:left-together].  Of a bar
 * part[DIMENSION] becomes relax_dimension(), for the force in the hand
 * part[GEOMETRY] grows by hand.u over hand.K^-1 hand, the others become 0. A
 * coarse mesh may be so stiff that it hides how near the load is to buckling: a
 * body that is pressed has a STRESS of at least the share ladder_pressed() of
 * what bends, and of 1 from its buckling load on, but for the force in the
 * hand.  GEOMETRY, LAW, DIMENSION and INERTIA are read.
 */
void relax_parts(const struct ladder_state *state, relax_forces *mesh,
                 relax_forces *stress, double part[N_PART]);

#endif
