/*
 * particles.h - particles that carry a body, and the grid that moves them: the
 * material point method without its forces.
 *
 *     o - o - o - o     Node a = j nodes[0] + i of the grid lies at
 *     |. .|. .| . |     origin + h (i, j).  A particle p has mass m_p, place
 *     o - o - o - o     x_p, velocity v_p, F_p, and the affine moment B_p.  It
 *     |  .|. .|  .|     has its weight on order + 1 nodes per axis.
 *     o - o - o - o
 *
 * Vectors are flat, component k of particle p at x[2p + k], of node a at
 * v[2a + k].  A bar is a grid with one row of nodes, nodes[1] = 1: the weight
 * along that axis is 1 and its gradient 0, F = diag(F_11, 1), and second
 * components stay as they are, so that one program does for one axis and two.
 *
 *     N_a(x) = N((x_1 - x_a1)/h) N((x_2 - x_a2)/h)             [eq:bspline]
 *     m_a    = sum_p m_p N_a(x_p)                                [eq:p2g]
 *     v_a    = sum_p m_p N_a(x_p) (v_p + C_p (x_a - x_p)) / m_a
 *     D_p    = sum_a N_a (x_a - x_p)(x_a - x_p)^T,  C_p = B_p D_p^{-1}
 *                                                             [eq:apic]
 *
 * Source: Jiang, Schroeder, Selle, Teran & Stomakhin, The affine
 * particle-in-cell method, ACM Trans. Graph. 34(4), 2015.
 *
 * Names: grid_, support_, kernel_, transfer_.
 */
#ifndef COMMON_PARTICLES_H
#define COMMON_PARTICLES_H

#include "base/status.h"
#include "material/tensor.h"

enum transfer { PIC, FLIP, APIC };
#define TRANSFERS "PIC FLIP APIC" /* as words, in this order */
const char *transfer_name(enum transfer transfer);

enum { ORDER_MAX = 3, SUPPORT_MAX = (ORDER_MAX + 1) * (ORDER_MAX + 1) };

/*
 * Return the B-spline of order 1, 2 or 3 (asserted) for nodes at h i: w[q] =
 * N_i(x) and dw[q] = dN_i/dx (1/m) of i = first + q, 0 <= q <= order; returns
 * first. x is finite.  On a node the linear kernel takes the cell to the right.
 */
typedef int kernel_function(int order, double h, double x, double w[],
                            double dw[]);
kernel_function kernel_weights;

/* Return D along one axis at x (m^2) [eq:apic]: f (1 - f) h^2 for order 1, f
 * the place of x in its cell; h^2 / 4 and h^2 / 3, wherever x is, for orders 2
 * and 3. */
double kernel_inertia(int order, double h, double x);

struct grid {
    int order;               /* of the kernel: 1, 2 or 3 */
    kernel_function *kernel; /* kernel_weights(), unless you have another */
    int nodes[2];
    int periodic;        /* along axis 0, with the period nodes[0] h */
    double origin[2], h; /* (m) */
    int n_node;
    double *mass; /* [n_node] m_a (kg); owned, as are the velocities */
    double *v;    /* [2 n_node] v_a after P2G (m/s) */
    double *next; /* [2 n_node] velocities for G2P: those that forces made */
};

/* Make a grid that is not periodic; all masses and velocities 0. */
struct grid *grid_alloc(int order, const double origin[2], double h,
                        const int nodes[2]);
void grid_free(struct grid *grid);

/* Place of node a (m). */
void grid_place(const struct grid *grid, int a, double x[2]);

/* The nodes on which a place x has its weight. */
struct support {
    int n; /* (order + 1)^2, or order + 1 on a bar */
    int node[SUPPORT_MAX];
    double w[SUPPORT_MAX];           /* N_a(x) */
    double gradient[SUPPORT_MAX][2]; /* dN_a/dx_k (1/m) */
    double offset[SUPPORT_MAX][2];   /* x_a - x (m), the short way round */
    double inertia[2];               /* diagonal of D (m^2) */
};

/* NONFINITE: x is not finite.  OUTSIDE: the grid has not all of the nodes. */
enum status grid_support(const struct grid *grid, const double x[2],
                         struct support *s);

/* sum_a w_a u_a, and sum_a u_a (x) grad N_a, for a grid field u. */
void support_value(const struct support *s, const double u[], double value[2]);
mat2 support_gradient(const struct support *s, const double u[]);

struct particles {
    int n;
    double *x, *v;         /* [2n] (m), (m/s); all arrays are owned */
    mat2 *F, *B;           /* [n] -, (m^2/s) */
    double *mass, *volume; /* [n] m_p (kg), V_p^0 (m^2), both constant */
};

/* Make particles with F = I and all other numbers 0. */
struct particles *particles_alloc(int n);
void particles_free(struct particles *p);

/*
 * Put count[0] x count[1] particles at the middles of equal cells of the box
 * from `low` to `high`, row by row, with the volumes of the cells and density
 * rho (kg/m^2).  A bar of unit cross-section: count[1] = 1, from y = -1/2 to
 * 1/2.
 */
struct particles *particles_box(const double low[2], const double high[2],
                                const int count[2], double rho);

/*
 * Transfer particles to the grid [eq:p2g]: mass, v, and next := v.  The affine
 * term is B's; PIC and FLIP have B = 0.  A node without mass gets v = 0.
 * Statuses as grid_support(); the grid is then incomplete.
 */
enum status grid_p2g(struct grid *grid, const struct particles *p);

/*
 * Transfer the grid to particles, with the velocities v^n = grid->v and v^{n+1}
 * = grid->next and all weights at the old x_p [eq:g2p]:
 *
 *     PIC, APIC  v_p := sum_a N_a v_a^{n+1}
 *     FLIP       v_p := v_p + sum_a N_a (v_a^{n+1} - v_a^n)
 *     APIC       B_p := sum_a N_a v_a^{n+1} (x_a - x_p)^T, the others B_p := 0
 *     all        F_p := (I + dt sum_a v_a^{n+1} (x) grad N_a) F_p
 *                x_p := x_p + dt sum_a N_a v_a^{n+1}
 *
 * A step from rest to displaced nodes, x_a + u_a: next = u, dt = 1.
 * Statuses as grid_support(); the particles before that one have moved.
 */
enum status grid_g2p(const struct grid *grid, enum transfer transfer, double dt,
                     struct particles *p);

struct moments {
    double mass, momentum[2];
    double angular; /* about the origin of coordinates; particles have also
                     * m_p (B_21 - B_12) */
    double kinetic; /* sum m |v|^2 / 2, without what is in B */
};
struct moments particles_moments(const struct particles *p);

/* Those of the nodes with the velocities v, grid->v or grid->next. */
struct moments grid_moments(const struct grid *grid, const double v[]);

#endif
