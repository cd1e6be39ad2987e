/*
 * piece.h - what one process has of the square: vertices, triangles, elements.
 *
 *     o---o---o---o    x  its own vertices: their rows of q and of K are its
 *     | / | / | / |    o  one layer of its neighbours' (ghosts): their
 *     o---x---x---x       displacements are sent to it; so it has all triangles
 *     | / | / | / |       of its own vertices, and no entry of K is ever sent
 *     o---x---x---x
 */
#ifndef MANY_PIECE_H
#define MANY_PIECE_H

#include "elements.h"
#include "plane/scene.h"

#include <math.h>
#include <petscdmda.h>

/* A vector over the vertices of one process, with ghosts, in our memory. */
struct local {
    double *at;
    Vec vec;
};

/* What one process has. */
struct piece {
    struct scene_setting set;
    DM grid;
    int wide, high;    /* processes per row, per column */
    DMDALocalInfo box; /* own vertices: xs, xm, ys, ym; with ghosts: gxs ... */
    struct mesh *mesh; /* with ghosts; numbered row by row, as by DMDA */
    struct body *body; /* with its element matrices one by one */
    size_t entries;    /* of these */
    double *value;     /* [entries] for MatSetValuesCOO */
    struct local u, w, q, diagonal; /* diagonal is that of K */
    Vec across, some;               /* (X1, 0); of use for a moment */
    double end;                     /* where the right end is to be (m) */
    double largest;                 /* max K_ii */
    double increment;               /* the last max|du| (m) */
    int levels;                     /* of the multigrid */
};

static inline double X1(const struct piece *p, int a)
{
    return -1.0 + 2.0 * (p->box.gxs + a % p->box.gxm) / p->set.n;
}

static inline int prescribed(const struct piece *p, int a)
{
    return fabs(X1(p, a)) == 1.0;
}

static inline int own(const struct piece *p, int a)
{
    const int i = p->box.gxs + a % p->box.gxm - p->box.xs;
    const int j = p->box.gys + a / p->box.gxm - p->box.ys;
    return 0 <= i && i < p->box.xm && 0 <= j && j < p->box.ym;
}

static inline PetscErrorCode piece_make(struct piece *p)
{
    const int n = p->set.n;
    PetscCall(DMDACreate2d(PETSC_COMM_WORLD, DM_BOUNDARY_NONE, DM_BOUNDARY_NONE,
                           DMDA_STENCIL_BOX, n + 1, n + 1, PETSC_DECIDE,
                           PETSC_DECIDE, 2, 1, NULL, NULL, &p->grid));
    PetscCall(DMSetUp(p->grid));
    PetscCall(DMDASetUniformCoordinates(p->grid, -1, 1, -1, 1, 0, 0));
    PetscCall(DMDAGetLocalInfo(p->grid, &p->box));
    const int columns = p->box.gxm - 1, rows = p->box.gym - 1;
    p->mesh = mesh_rectangle(columns, rows, (double)columns / n,
                             (double)rows / n);
    p->body = elements_alloc(
        p->mesh, material_make(p->set.law, p->set.E, p->set.nu), p->set.rho,
        p->set.mass);
    p->entries = (size_t)p->mesh->n_triangle * ELEMENT_ENTRIES;
    p->value = allocate(p->entries, sizeof *p->value);
    struct local *const all[] = {&p->u, &p->w, &p->q, &p->diagonal};
    for (int k = 0; k < 4; k++) {
        const int size = 2 * p->mesh->n_vertex;
        all[k]->at = allocate((size_t)size, sizeof *all[k]->at);
        PetscCall(VecCreateSeqWithArray(PETSC_COMM_SELF, 2, size, all[k]->at,
                                        &all[k]->vec));
    }
    PetscCall(DMCreateGlobalVector(p->grid, &p->some));
    PetscCall(VecDuplicate(p->some, &p->across));
    for (int a = 0; a < p->mesh->n_vertex; a++) p->u.at[2 * a] = X1(p, a);
    PetscCall(DMLocalToGlobal(p->grid, p->u.vec, INSERT_VALUES, p->across));
    /* Coarser, as long as every process has a vertex of the grid. */
    PetscCall(DMDAGetInfo(p->grid, 0, 0, 0, 0, &p->wide, &p->high, 0, 0, 0, 0,
                          0, 0, 0));
    const int least = (int)fmax(8.0, fmax(p->wide, p->high));
    p->levels = 1;
    for (int m = n; m % 2 == 0 && m / 2 >= least; m /= 2) p->levels++;
    return 0;
}

#endif
