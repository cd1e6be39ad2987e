/* strip.c - laws of figures/24_live/strip.h. */
#include "figures/24_live/strip.h"

#include "plane/body.h"
#include "unit.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { N = 10, ROWS = 3 };

static struct strip pulled(int cells, double d)
{
    gsl_set_error_handler_off();
    struct strip s = strip_alloc(N, cells);
    strip_pull(&s, d);
    return s;
}

/* Of 10 cm by 3 cm, each cell once; a vertex of the cut is of one lip, and one
 * below it is of both sides. */
static void the_mesh_is_the_strip(void)
{
    for (int cells = 0; cells < ROWS; cells++) {
        struct strip s = strip_alloc(N, cells);
        const struct mesh *mesh = s.s.mesh;
        double corner[2][2] = {{0.0}};
        ck_assert_int_eq(s.rows, ROWS);
        ck_assert_int_eq(mesh->n_triangle, 2 * N * ROWS);
        ck_assert_int_eq(mesh->n_vertex, (N + 1) * (ROWS + 1) + cells);
        for (int e = 0; e < mesh->n_triangle; e++) {
            double g[6];
            close_to(mesh_gradients(mesh, e, g), 0.5e-4, 1e-15);
        }
        for (int a = 0; a < mesh->n_vertex; a++) {
            const double *X = &mesh->X[2 * a];
            int side[2] = {0}; /* has it triangles left and right of the cut? */
            for (int c = 0; c < 3 * mesh->n_triangle; c++)
                if (mesh->triangle[c] == a)
                    side[mesh->X[2 * mesh->triangle[c / 3 * 3]] +
                         mesh->X[2 * mesh->triangle[c / 3 * 3 + 1]] +
                         mesh->X[2 * mesh->triangle[c / 3 * 3 + 2]] > 0.0] = 1;
            if (fabs(X[0]) < 1e-9)
                ck_assert_int_eq(side[0] + side[1],
                                 X[1] > 0.01501 - 0.01 * cells ? 1 : 2);
            for (int i = 0; i < 2; i++) {
                corner[0][i] = fmin(corner[0][i], X[i]);
                corner[1][i] = fmax(corner[1][i], X[i]);
            }
        }
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 2; i++)
                close_to(corner[k][i], (k ? 0.05 : -0.05) * (i ? 0.3 : 1.0),
                         1e-15);
        strip_free(&s);
    }
}

/* The force is the slope of the energy; the strip pulls at its left end as much
 * as the hand does at the right one, and across nobody pulls in all. */
static void the_force_is_the_slope_of_the_energy(void)
{
    const double d = 0.02, e = 1e-5;
    for (int cells = 0; cells < ROWS; cells += ROWS - 1) {
        struct strip s = pulled(cells, d - e);
        const double before = s.energy;
        strip_pull(&s, d + e);
        const double after = s.energy;
        strip_pull(&s, d);
        ck_assert_double_gt(s.force, 0.01);
        close_to((after - before) / (2.0 * e), s.force, 1e-5 * s.force);
        double left = 0.0, along = 0.0, across = 0.0;
        for (int a = 0; a < s.s.mesh->n_vertex; a++) {
            const double X = s.s.mesh->X[2 * a];
            along += 0.01 * s.q[2 * a];
            across += 0.01 * s.q[2 * a + 1];
            if (X < -0.0499) left += 0.01 * s.q[2 * a];
            if (X > 0.0499)
                ck_assert(s.s.u[2 * a] == d && s.s.u[2 * a + 1] == 0.0);
        }
        close_to(left, -s.force, 1e-7 * s.force);
        close_to(along, 0.0, 1e-7 * s.force);
        close_to(across, 0.0, 1e-7 * s.force);
        strip_free(&s);
    }
}

/* What is cut gives way: less energy, less force, lips apart; and it is where
 * the strip would be that was cut before it was pulled. */
static void a_cut_gives_way(void)
{
    struct strip whole = pulled(0, 0.02);
    double energy = whole.energy, force = whole.force, opening = 0.0;
    for (int cells = 1; cells < ROWS; cells++) {
        struct strip s = strip_alloc(N, cells), late = pulled(cells, 0.02);
        ck_assert_int_gt(strip_cut(&whole, &s), 1);
        ck_assert(s.energy < 0.99 * energy && s.force < 0.99 * force);
        ck_assert_double_gt(s.opening, opening + 1e-4);
        close_to(s.energy, late.energy, 1e-7 * energy);
        close_to(s.opening, late.opening, 1e-7);
        energy = s.energy;
        force = s.force;
        opening = s.opening;
        strip_free(&s);
        strip_free(&late);
    }
    strip_free(&whole);
}

UNIT_MAIN("strip",
    LAW(the_mesh_is_the_strip),
    LAW(the_force_is_the_slope_of_the_energy),
    LAW(a_cut_gives_way))
