/*
 * particle_scene.h - particles and motions that lessons and studies share.
 *
 *     seven   particles with irregular data, for identities to round-off
 *     disc    of a square lattice, to be turned
 *     bar     stretched, under one stress
 *     shake   of the nodes, for forces
 *     wave    v = cos kx along a bar; what a transfer leaves of it is a filter
 *
 * APIC knows a motion's gradient from B.  Where a motion is set, a grid stands
 * for "APIC, with the B that this grid gives"; NULL is for PIC and FLIP, B = 0.
 *
 * Names: cloud_, grid_, transfer_.
 */
#ifndef COMMON_PARTICLE_SCENE_H
#define COMMON_PARTICLE_SCENE_H

#include "particles/particles.h"

/* Return seven particles in 0.8 < x < 1.6, 0.75 < y < 1.55, with irregular v,
 * m, F, V0, and C = B D^{-1} unless grid is NULL; all must be inside it
 * (asserted). */
struct particles *particles_seven(const struct grid *grid);

/* Return the particles of a square lattice, at (i + 1/2, j + 1/2) spacing, that
 * are within the radius of the centre. */
struct particles *particles_disc(const double centre[2], double radius,
                                 double spacing, double rho);

/* u := an irregular displacement of every node within +-size/2 per axis (m),
 * which depends on size and on where the node is, in cells from 0. */
void grid_shake(const struct grid *grid, double size, double u[]);

/* v_p := v + omega x (x_p - centre), B_p = omega x D_p.  Statuses as
 * grid_support(); v and B are then incomplete. */
enum status particles_turn(struct particles *p, const struct grid *grid,
                           const double v[2], double omega,
                           const double centre[2]);

/* next := grid->v + v + omega x x_a at all nodes: a rigid kick. */
void grid_kick(struct grid *grid, const double v[2], double omega);

/* v_p := (cos kx, 0), B_p by its slope; statuses as particles_turn(). */
enum status particles_wave(struct particles *p, const struct grid *grid,
                           double k);

/* Return the part of cos kx in the first component of v: sum v cos / sum
 * cos^2. */
double particles_wave_part(const struct particles *p, double k);

/*
 * Particles with their first motion and a grid with room for them: the seven
 * (11 nodes each way, h = 0.385 m); a disc of radius 0.3 m that turns about 0
 * by 1 rad/s, four particles per cell of 1 / cells; the wave cos kx on a
 * periodic bar of unit cells, ppc particles in each.  With B for APIC.
 */
struct cloud {
    struct grid *grid; /* owned, both */
    struct particles *p;
};
struct cloud cloud_seven(int order, enum transfer transfer);
struct cloud cloud_disc(int order, int cells, enum transfer transfer);
struct cloud cloud_wave(int order, int cells, int ppc, double k,
                        enum transfer transfer);
/*
 * A bar of length 1 and density 1 with ppc particles in each cell of 1 / cells,
 * which has been stretched already: x = F X + shift h, F_p = F.  The grid goes
 * from -2 h to 2 h or more beyond the bar and has the masses of P2G.
 */
struct cloud cloud_bar(int order, int cells, int ppc, double F, double shift);
void cloud_free(struct cloud cloud);

/* The largest |f_a| and |f_a| / m_a along a bar's axis, at nodes that are two
 * cells or more away from both of its ends. */
struct inner {
    double force, acceleration;
};
struct inner cloud_bar_inner(struct cloud bar, const double f[]);

/*
 * Return the factor that one transfer leaves of the wave in the limit of many
 * particles per cell [eq:pic-filter]: with z = k h and S = (sin(z/2) /
 * (z/2))^(order + 1), S^2 for PIC, 1 for FLIP, S (S - z S'(z)) for APIC.
 */
double transfer_factor(int order, enum transfer transfer, double z);

#endif
