/*
 * collision.c - two discs that meet, and nobody has programmed contact.
 *
 * Discs of 0.25 m move at each other by 3 m/s, a little to the side.  As
 * particles (FLIP, quadratic kernel) they share the nodes of one grid; as
 * triangles of the same size they have no vertex in common.  Tables: particles
 * (at three times), triangles (at the start), and outcome: the least distance
 * of particles of different discs; at the end the left disc's velocity, how
 * much kinetic energy is left, and how much of that disc is in the other.
 */
#include "whole_step.h"
#include "base/options.h"
#include "../study/study.h"
#include "base/table.h"
#include "particles/particle_bodies.h"
#include "plane/mesh.h"

#include <math.h>

static const char *const SIDE[] = {"left", "right"};
static const double H = 0.0625; /* (m) of a cell */
static const double RADIUS = 0.25, SPEED = 3.0, START[2] = {0.375, 0.0625};
static const double WHEN[] = {0.02, 0.07, 0.13}; /* s */

/* The left disc, then the right one, which is its image through 0. */
static struct cloud discs(double h, double speed)
{
    const double low[2] = {-1.25, -1.0}, centre[2] = {-START[0], -START[1]};
    const int nodes[2] = {1 + (int)lrint(2.5 / h), 1 + (int)lrint(2.0 / h)};
    struct particles *one = particles_disc(centre, RADIUS, 0.5 * h, 1.0);
    struct cloud c = {grid_alloc(2, low, h, nodes),
                      particles_alloc(2 * one->n)};
    for (int p = 0; p < c.p->n; p++) {
        const int left = p < one->n, q = left ? p : p - one->n;
        c.p->x[2 * p] = left ? one->x[2 * q] : -one->x[2 * q];
        c.p->x[2 * p + 1] = left ? one->x[2 * q + 1] : -one->x[2 * q + 1];
        c.p->v[2 * p] = left ? speed : -speed;
        c.p->mass[p] = one->mass[q];
        c.p->volume[p] = one->volume[q];
    }
    particles_free(one);
    return c;
}

static double nearest(const struct particles *p)
{
    double least = INFINITY;
    for (int a = 0; a < p->n; a += 2) /* in x: the first half of particles */
        for (int b = p->n; b < 2 * p->n; b += 2)
            least = fmin(least, hypot(p->x[a] - p->x[b],
                                      p->x[a + 1] - p->x[b + 1]));
    return least;
}

struct outcome {
    double gap, v, kept;
};

/* Until the last time of WHEN, at another speed as far on its way; implicit
 * steps are ten times as long.  Rows: of explicit ones at SPEED. */
static struct outcome collide(double h, double speed, int implicit)
{
    struct cloud c = discs(h, speed);
    const struct material m = material_notes(CUBIC);
    const double start = particles_moments(c.p).kinetic;
    const double dt = implicit ? 0.1 * h : 0.01 * h;
    const struct particle_step step = {.rate = 1.0 / dt, .transfer = FLIP};
    struct outcome out = {.gap = INFINITY};

    for (int k = 0, when = 0; when < COUNT(WHEN); k++) {
        out.gap = fmin(out.gap, nearest(c.p));
        if ((k + 0.5) * dt * speed > WHEN[when] * SPEED) {
            const int rows = speed == SPEED && !implicit ? c.p->n : 0;
            for (int p = 0; p < rows; p++)
                table_row(h, when, SIDE[2 * p >= c.p->n],
                          cell_rounded(5, c.p->x[2 * p]),
                          cell_rounded(5, c.p->x[2 * p + 1]));
            when++;
        }
        if ((implicit ? particles_step(c.grid, c.p, m, &step).status
                      : particles_step_explicit(c.grid, c.p, m, &step)) != OK)
            die("a particle is lost");
    }
    const struct moments end = particles_moments(c.p);
    claim(fabs(end.momentum[0]) < 1e-12, "momentum: %g", end.momentum[0]);
    for (int p = 0; p < c.p->n; p += 2)
        out.v += c.p->v[p] / (0.5 * c.p->n); /* of the first half */
    out.kept = end.kinetic / start;
    cloud_free(c);
    return out;
}

/* Not on its edge, where round-off would decide. */
static int in_disc(double x, double y, double centre_x, double centre_y)
{
    return hypot(x - centre_x, y - centre_y) < RADIUS - 1e-9;
}

static double middle(double a, double b, double c)
{
    return 0.5 * (fmin(a, fmin(b, c)) + fmax(a, fmax(b, c)));
}

/* Table triangles, of both discs at rest.  None has a vertex in common with the
 * other disc's, hence none a force from it: the discs fly on as they are, and
 * the fraction of the left one is returned that ends in the right one. */
static double print_triangles(void)
{
    const double way = SPEED * WHEN[COUNT(WHEN) - 1];
    struct mesh *mesh = mesh_rectangle(24, 12, 12.0 * H, 6.0 * H);
    double inside = 0.0, left = 0.0;

    table_begin("triangles", "disc x0 y0 x1 y1 x2 y2");
    for (int e = 0; e < mesh->n_triangle; e++) {
        const double *A = &mesh->X[2 * mesh->triangle[3 * e]];
        const double *B = &mesh->X[2 * mesh->triangle[3 * e + 1]];
        const double *C = &mesh->X[2 * mesh->triangle[3 * e + 2]];
        const double x = middle(A[0], B[0], C[0]); /* of its cell */
        const double y = middle(A[1], B[1], C[1]);
        const int is_left = in_disc(x, y, -START[0], -START[1]);
        if (!is_left && !in_disc(x, y, START[0], START[1])) continue;
        table_row(SIDE[!is_left], A[0], A[1], B[0], B[1], C[0], C[1]);
        left += is_left;
        inside += is_left && in_disc(x + way, y, START[0] - way, START[1]);
    }
    table_end();
    mesh_free(mesh);
    return inside / left;
}

int main(void)
{
    table_begin("particles", "h when disc x y");
    const struct outcome coarse = collide(2.0 * H, SPEED, 0);
    const struct outcome fine = collide(H, SPEED, 0);
    table_end();
    const struct outcome fast = collide(H, 2.0 * SPEED, 0);
    const struct outcome longer = collide(H, SPEED, 1);
    const double inside = print_triangles();
    const double cells[] = {0.5 * coarse.gap / H, fine.gap / H};
    table_begin("outcome", "method h gap_per_h v kept inside speed");
    table_row("particles", 2.0 * H, cells[0], coarse.v, coarse.kept, 0.0,
              SPEED);
    table_row("particles", H, cells[1], fine.v, fine.kept, 0.0, SPEED);
    table_row("particles", H, fast.gap / H, fast.v, fast.kept, 0.0,
              2.0 * SPEED);
    table_row("implicit", H, longer.gap / H, longer.v, longer.kept, 0.0, SPEED);
    table_row("mesh", H, MISSING, SPEED, 1.0, inside, SPEED);
    table_end();

    claim(fine.v < -0.5 * SPEED && fine.kept > 0.75, "the discs bounce: the "
          "left one has %g m/s, %g of the energy is left", fine.v, fine.kept);
    claim(fabs(cells[0] - 1.2) < 0.4 && fabs(cells[1] - 1.2) < 0.4, "they meet "
          "about a cell apart, on either grid (%g, %g)", cells[0], cells[1]);
    claim(fast.gap < 0.9 * fine.gap && fast.v < 0.0, "a harder blow goes "
          "deeper (%g cells), and the discs still bounce", fast.gap / H);
    claim(fabs(longer.v + 1.28) < 0.01 && fabs(longer.kept - 0.284) < 1e-3,
          "implicit steps damp (%g m/s, energy %g)", longer.v, longer.kept);
    claim(inside > 0.5, "%g of the left mesh is in the right one", inside);
    return table_finish();
}
