/* strip.c - laws of figures/24_live/strip.h. */
#include "figures/24_live/strip.h"

#include "plane/body.h"
#include "unit.h"

#include <gsl/gsl_errno.h>
#include <math.h>

enum { N = 10, ROWS = 3 };

static struct strip pulled(int tip, double d)
{
    gsl_set_error_handler_off();
    struct strip s = strip_alloc(N, tip);
    strip_pull(&s, d);
    return s;
}

/* Of 10 cm by 3 cm, each cell once; right of the cut the lip is the first
 * vertex up to the tip and the second one above. */
static void the_mesh_is_the_strip(void)
{
    for (int tip = 0; tip <= ROWS; tip++) {
        struct strip s = strip_alloc(N, tip);
        double corner[2][2] = {{0.0}};
        ck_assert_int_eq(s.rows, ROWS);
        ck_assert_int_eq(s.mesh->n_triangle, 2 * N * ROWS);
        for (int e = 0; e < s.mesh->n_triangle; e++) {
            const int *t = &s.mesh->triangle[3 * e];
            double g[6], middle = 0.0;
            close_to(fabs(mesh_gradients(s.mesh, e, g)), 0.5e-4, 1e-15);
            for (int a = 0; a < 3; a++) {
                const double *X = &s.mesh->X[2 * t[a]];
                middle += X[0];
                for (int i = 0; i < 2; i++) {
                    corner[0][i] = fmin(corner[0][i], X[i]);
                    corner[1][i] = fmax(corner[1][i], X[i]);
                }
            }
            for (int a = 0; a < 3; a++) {
                const int column = t[a] % (N + 2), row = t[a] / (N + 2);
                const int first = column == N / 2, second = column == N / 2 + 1;
                ck_assert(middle > 0.0 || !second);
                ck_assert(middle < 0.0 || !(first || second) ||
                          first == (row <= tip));
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
    for (int tip = 0; tip <= ROWS; tip += ROWS) {
        struct strip s = pulled(tip, d - e);
        const double before = s.energy;
        strip_pull(&s, d + e);
        const double after = s.energy;
        strip_pull(&s, d);
        ck_assert_double_gt(s.force, 0.01);
        close_to((after - before) / (2.0 * e), s.force, 1e-5 * s.force);
        double left = 0.0, along = 0.0, across = 0.0;
        for (int a = 0; a < s.mesh->n_vertex; a++) {
            along += 0.01 * s.q[2 * a];
            across += 0.01 * s.q[2 * a + 1];
            if (a % (N + 2) == 0) left += 0.01 * s.q[2 * a];
            if (a % (N + 2) == N + 1)
                ck_assert(s.u[2 * a] == d && s.u[2 * a + 1] == 0.0);
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
    struct strip whole = pulled(ROWS, 0.02);
    double energy = whole.energy, force = whole.force, opening = 0.0;
    for (int tip = ROWS - 1; tip >= 0; tip--) {
        struct strip s = strip_alloc(N, tip), late = pulled(tip, 0.02);
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

#define LAW(name) {#name, name}
static const struct unit_law laws[] = {
    LAW(the_mesh_is_the_strip),
    LAW(the_force_is_the_slope_of_the_energy),
    LAW(a_cut_gives_way),
};
UNIT_MAIN("strip", laws)
