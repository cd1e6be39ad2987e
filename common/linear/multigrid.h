/*
 * multigrid.h - a multigrid V-cycle for the free vertices of system.h.
 *
 * Grids of n, n/2, ... squares per side, as long as that is a whole number and
 * at least 4.  P takes a vector of the coarser grid to the finer one: a vertex
 * has the mean of the coarse vertices around it [eq:prolongation], in which one
 * that is held counts with 0.  The matrix of the coarser grid is P^T K P
 * [eq:galerkin]; it couples a vertex with the eight around it.
 *
 * Source: Trottenberg, Oosterlee & Schueller, Multigrid, sec. 2.3, 7.8.
 */
#ifndef COMMON_MULTIGRID_H
#define COMMON_MULTIGRID_H

#include "linear/csr.h"
#include "linear/matrix.h"

enum { GRIDS = 16, SWEEPS = 2 };

/* Grid 0 is the finest. */
struct multigrid {
    int grids;
    int n[GRIDS];             /* squares per side */
    struct csr *K[GRIDS];     /* K[0] is borrowed, the others are owned */
    double *x[GRIDS];         /* room for three vectors of each grid: x, */
    double *b[GRIDS];         /* a right-hand side, */
    double *r[GRIDS];         /* and a residual */
    struct matrix *coarsest;  /* the factor of K[grids - 1] */
    enum status status;       /* of it; NOT_SPD: neither is K */
};

/* Make levels for a K of system_matrix() in the order of the vertices. */
struct multigrid *multigrid_alloc(const struct csr *K, int n);
void multigrid_free(struct multigrid *m);

/* fine += P coarse; coarse += P^T fine: both components of the (n - 1) (n + 1)
 * free vertices, and of those of n/2. */
void multigrid_prolong(int n, const double coarse[], double fine[]);
void multigrid_restrict(int n, const double fine[], double coarse[]);

/* Return P^T K P, for the K of n squares per side. */
struct csr *multigrid_coarse(const struct csr *K, int n);

/* A sweep of Gauss and Seidel over K x = b: the equations in turn, each solved
 * for its own unknown; backward, the last one first. */
void multigrid_sweep(const struct csr *K, const double b[], int backward,
                     double x[]);

/* z := one V-cycle for K z = r [alg:v-cycle]; a preconditioner of cg.h, whose
 * context is a struct multigrid. */
void multigrid_cycle(const void *multigrid, const double r[], double z[]);

#endif
